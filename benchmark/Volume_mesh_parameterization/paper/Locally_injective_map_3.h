#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_LOCALLY_INJECTIVE_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_LOCALLY_INJECTIVE_MAP_3_H

#include "Shifted_newton_3.h"

#include <Eigen/Dense>

#include <algorithm>

// Locally injective mappings, after Schueller et al. (CGF 2013): an energy with a barrier and soft positional
// constraints, minimized from the undeformed source.
// - Substepping: where mu had to be added to the Hessian, the targets are taken only 1 / (1 + mu^2) of
//   the way from where the vertices are.
// - The weight of the constraints grows such that they cost at least 1000 times the energy.
template <typename Energy>
class Locally_injective_map_3
{
public:
  using Mesh = typename Shifted_newton_3<Energy>::Mesh;
  using Positions = Eigen::Matrix3Xd;

  explicit Locally_injective_map_3(const Mesh& mesh, const Energy& energy = Energy())
    : m_newton(mesh, energy, centered_source(mesh))
  {
    update_weight();
  }

  const Shifted_newton_3<Energy>& newton() const { return m_newton; }
  const Positions& positions() const { return m_newton.positions(); }
  double weight() const { return m_weight; }
  bool is_running() const { return m_newton.is_running(); }

  void step()
  {
    m_newton.step(m_weight, [&](const double shift) -> Positions
    {
      const double part = 1 / (1 + shift * shift);
      return part * m_newton.target() + (1 - part) * m_newton.constrained_positions();
    });
    update_weight();
  }

private:
  // The source as it is, but where the target is.
  static Positions centered_source(const Mesh& mesh)
  {
    const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
    const Eigen::Vector3d shift
      = mesh.target.rightCols(n).rowwise().mean() - mesh.source.rightCols(n).rowwise().mean();
    return mesh.source.colwise() + shift;
  }

  void update_weight()
  {
    constexpr double ratio = 1e3, largest = 1e16;
    const double squared_distance = m_newton.distance() * m_newton.distance();
    m_weight = (std::max)(m_weight,
                          (std::min)(largest, ratio * (std::max)(1., m_newton.energy() / squared_distance)));
  }

  Shifted_newton_3<Energy> m_newton;
  double m_weight = 0;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_LOCALLY_INJECTIVE_MAP_3_H
