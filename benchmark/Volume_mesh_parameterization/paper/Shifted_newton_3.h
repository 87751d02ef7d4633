#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_SHIFTED_NEWTON_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_SHIFTED_NEWTON_3_H

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Cell_packs_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <vector>

// Newton's method of Schueller et al., Locally Injective Mappings (CGF 2013), for the sum of an energy over
// the cells plus w |u - target|^2 over the prescribed vertices. Where the full Hessian is not
// positive definite, a multiple mu of the identity is added. The step is halved until the energy
// decreases and no cell is inverted.
template <typename Energy>
class Shifted_newton_3
{
public:
  using Mesh = CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3;
  using Positions = Eigen::Matrix3Xd;

  // Source and target of the mesh have the same volume; `start` inverts no cell.
  Shifted_newton_3(const Mesh& mesh, const Energy& energy, const Positions& start)
    : m_first_prescribed(mesh.number_of_free_vertices),
      m_target(constrained(mesh.target)),
      m_energy(energy),
      m_packs(make_packs(mesh, m_hessian)),
      m_u(start)
  {
    m_solver.analyze_pattern(m_hessian);
  }

  const Positions& positions() const { return m_u; }
  const Positions& target() const { return m_target; }
  Positions constrained_positions() const { return constrained(m_u); }
  double energy() const { return evaluate(m_u).energy; } // without the constraints
  double distance() const { return (constrained(m_u) - target()).norm(); }
  double shift() const { return m_shift; }
  double step_length() const { return m_step_length; }
  bool is_running() const { return m_is_running; }

  // `target_of_step(mu)` is where the prescribed vertices are drawn in this step.
  template <typename TargetOfStep>
  void step(const double weight, const TargetOfStep& target_of_step)
  {
    CGAL::Volume_mesh_parameterization::internal::Matrix3Xd gradient;
    assemble_energy(m_packs, m_energy, m_u, 1., gradient, m_hessian);
    for(int v = m_first_prescribed; v < m_hessian.size(); ++v)
      m_hessian.block(m_hessian.position(v, v)).diagonal().array() += 2 * weight;
    m_is_running = factorize();
    if(!m_is_running)
      return;

    const Positions target = target_of_step(m_shift);
    gradient.rightCols(target.cols()) += 2 * weight * (constrained(m_u) - target);
    Eigen::VectorXd solution;
    m_solver.solve(-Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size()), solution, 0);
    m_is_running = search(Eigen::Map<const Positions>(solution.data(), 3, gradient.cols()), weight, target);
  }

private:
  using Matrix = CGAL::Volume_mesh_parameterization::Block_sparse_matrix_3<double>;
  using Packs = CGAL::Volume_mesh_parameterization::internal::Cell_packs_3;

  // The prescribed vertices move as well; all cells count alike.
  static Packs make_packs(const Mesh& mesh, Matrix& hessian)
  {
    const auto unknowns = all_vertices(mesh);
    const auto pattern = sparsity_pattern_3(mesh, unknowns);
    hessian.set_pattern(pattern.row_begin, pattern.columns);
    const std::vector<double> weights(mesh.cells.size(), 1.);
    return Packs(mesh, { 1, scaled_inverse_sources(mesh, 1), weights }, unknowns, pattern);
  }

  auto evaluate(const Positions& u) const { return evaluate_energy(m_packs, m_energy, u); }

  Positions constrained(const Positions& u) const { return u.rightCols(u.cols() - m_first_prescribed); }

  double value(const Positions& u, const double weight, const Positions& target) const
  {
    const auto evaluation = evaluate(u);
    if(!evaluation.is_flip_free())
      return std::numeric_limits<double>::infinity();
    return evaluation.energy + weight * (constrained(u) - target).squaredNorm();
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

  // The first length is that of the last step, doubled.
  bool search(const Positions& direction, const double weight, const Positions& target)
  {
    constexpr double smallest_length = 1e-15;
    const double current = value(m_u, weight, target);
    m_step_length = (std::min)(1., 2 * m_step_length);
    while(!(value(m_u + m_step_length * direction, weight, target) < current))
    {
      m_step_length /= 2;
      if(m_step_length < smallest_length)
        return false;
    }
    m_u += m_step_length * direction;
    return true;
  }

  int m_first_prescribed;
  Positions m_target; // targets of the prescribed vertices
  CGAL::Volume_mesh_parameterization::internal::Cell_energy_of<Energy> m_energy;
  Matrix m_hessian;
  Packs m_packs;
  CGAL::Volume_mesh_parameterization::CHOLMOD_solver_traits_3 m_solver;
  Positions m_u;
  double m_shift = 0, m_step_length = 1;
  bool m_is_running = true;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_SHIFTED_NEWTON_3_H
