#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_LOCALLY_INJECTIVE_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_LOCALLY_INJECTIVE_MAP_3_H

#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Linear_solver_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_packs_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energy_sum_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Numbered_mesh_3.h>

#include <CGAL/tags.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

// Locally injective mappings, after Schueller et al. (CGF 2013): an energy with the inverse spline
// barrier and soft positional constraints, minimized by Newton's method from the undeformed source.
// - Where the Hessian is not positive definite, a multiple mu of the identity is added.
// - Substepping: then the targets are taken only 1 / (1 + mu^2) of the way from where the vertices are.
// - The weight of the constraints grows such that they cost at least 1000 times the energy.
// - The step is halved until the energy decreases and no cell is inverted.
template <typename Energy>
class Locally_injective_map_3
{
public:
  using Mesh = CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3;
  using Positions = Eigen::Matrix3Xd;

  // The source and the target of the mesh have the same volume.
  explicit Locally_injective_map_3(const Mesh& mesh, const Energy& energy = Energy())
    : m_mesh(with_free_vertices(mesh)),
      m_first_prescribed(mesh.number_of_free_vertices),
      m_energy(energy),
      m_hessian(pattern(m_mesh)),
      m_packs(m_mesh, scaled_inverse_sources(m_mesh, 1), std::vector<double>(mesh.cells.size(), 1.), m_hessian),
      m_energy_sum(m_packs),
      m_u(centered_source(mesh)),
      m_substep_target(target())
  {
    m_solver.analyze_pattern(m_hessian);
    update_weight();
  }

  const Positions& positions() const { return m_u; }
  double energy() const { return m_energy_sum.evaluate(m_energy, m_u).energy; } // without the constraints
  double weight() const { return m_weight; }
  double shift() const { return m_shift; }
  double step_length() const { return m_step_length; }
  bool is_running() const { return m_is_running; }

  void step()
  {
    Positions gradient;
    m_energy_sum.assemble(m_energy, m_u, 1., gradient, m_hessian);
    for(int v = m_first_prescribed; v < m_mesh.number_of_vertices(); ++v)
      m_hessian.block(m_hessian.position(v, v)).diagonal().array() += 2 * m_weight;
    m_is_running = factorize();
    if(!m_is_running)
      return;

    const double part = 1 / (1 + m_shift * m_shift);
    m_substep_target = part * target() + (1 - part) * constrained(m_u);
    gradient.rightCols(m_substep_target.cols()) += 2 * m_weight * (constrained(m_u) - m_substep_target);
    Eigen::VectorXd solution;
    m_solver.solve(-Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size()), solution, 0);
    m_is_running = search(Eigen::Map<const Positions>(solution.data(), 3, gradient.cols()));
    update_weight();
  }

private:
  using Matrix = CGAL::Volume_mesh_parameterization::Block_sparse_matrix_3<double>;
  using Packs = CGAL::Volume_mesh_parameterization::internal::Cell_packs_3;
  using Energy_sum = CGAL::Volume_mesh_parameterization::internal::Energy_sum_3<CGAL::Sequential_tag>;

  static Mesh with_free_vertices(Mesh mesh)
  {
    mesh.number_of_free_vertices = mesh.number_of_vertices();
    return mesh;
  }

  static Matrix pattern(const Mesh& mesh)
  {
    Matrix matrix;
    set_pattern(mesh, {}, matrix);
    return matrix;
  }

  // The source as it is, but where the target is.
  static Positions centered_source(const Mesh& mesh)
  {
    const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
    const Eigen::Vector3d shift
      = mesh.target.rightCols(n).rowwise().mean() - mesh.source.rightCols(n).rowwise().mean();
    return mesh.source.colwise() + shift;
  }

  Positions target() const { return constrained(m_mesh.target); }
  Positions constrained(const Positions& u) const { return u.rightCols(u.cols() - m_first_prescribed); }

  double value(const Positions& u) const
  {
    const auto evaluation = m_energy_sum.evaluate(m_energy, u);
    if(!evaluation.is_flip_free())
      return std::numeric_limits<double>::infinity();
    return evaluation.energy + m_weight * (constrained(u) - m_substep_target).squaredNorm();
  }

  // Adds what is needed to make the Hessian positive definite.
  bool factorize()
  {
    using CGAL::Volume_mesh_parameterization::Linear_solver_status;
    constexpr double smallest = 1e-5, largest = 1e16;
    double added = 0;
    while(m_solver.factorize(m_hessian) != Linear_solver_status::SUCCESS)
    {
      const double shift = added == 0 ? (std::max)(smallest, m_shift / 10) : 10 * added;
      if(shift > largest)
        return false;
      for(int v = 0; v < m_hessian.size(); ++v)
        m_hessian.block(m_hessian.position(v, v)).diagonal().array() += shift - added;
      added = shift;
    }
    m_shift = added;
    return true;
  }

  bool search(const Positions& direction)
  {
    constexpr double smallest_length = 1e-15;
    const double current = value(m_u);
    m_step_length = (std::min)(1., 2 * m_step_length);
    while(!(value(m_u + m_step_length * direction) < current))
    {
      m_step_length /= 2;
      if(m_step_length < smallest_length)
        return false;
    }
    m_u += m_step_length * direction;
    return true;
  }

  void update_weight()
  {
    constexpr double ratio = 1e3, largest = 1e16;
    const double squared_distance = (constrained(m_u) - target()).squaredNorm();
    m_weight = (std::max)(m_weight, (std::min)(largest, ratio * (std::max)(1., energy() / squared_distance)));
  }

  Mesh m_mesh;
  int m_first_prescribed;
  Energy m_energy;
  Matrix m_hessian;
  Packs m_packs;
  Energy_sum m_energy_sum;
  CGAL::Volume_mesh_parameterization::CHOLMOD_solver_traits_3 m_solver;
  Positions m_u, m_substep_target;
  double m_weight = 0, m_shift = 0, m_step_length = 1;
  bool m_is_running = true;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_LOCALLY_INJECTIVE_MAP_3_H
