#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_BOUNDED_DISTORTION_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_BOUNDED_DISTORTION_MAP_3_H

#include "Jacobian_system_3.h"

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>

#include <Eigen/Dense>

#include <cstddef>

// The triple nearest to s_0 >= s_1 >= |s_2| such that s_0 <= K s_2 and the order is kept.
inline Eigen::Vector3d nearest_bounded(const Eigen::Vector3d& s, const double K)
{
  if(s[0] <= K * s[2])
    return s;
  // on the plane s_0 = K s_2; where that violates the order, s_1 is equal to one of the others
  double smallest = (K * s[0] + s[2]) / (K * K + 1);
  double middle = s[1];
  if(middle > K * smallest)
  {
    smallest = (K * (s[0] + s[1]) + s[2]) / (2 * K * K + 1);
    middle = K * smallest;
  }
  else if(middle < smallest)
  {
    smallest = (K * s[0] + s[1] + s[2]) / (K * K + 2);
    middle = smallest;
  }
  return Eigen::Vector3d(K * smallest, middle, smallest);
}

// A map with fixed boundary, near the harmonic one, in whose cells the ratio of the largest to the
// smallest singular value is at most K: Aigerman and Lipman, Injective and Bounded Distortion Mappings
// in 3D (TOG 2013), computed as in Kovalsky et al., Large-Scale Bounded Distortion Mappings (TOG 2015).
// The Jacobians are projected on the set that the bound describes, then on the Jacobians of maps, by
// turns. Each linear step is confined to the plane that touches the set at the last projection.
class Bounded_distortion_map_3
{
public:
  Bounded_distortion_map_3(const Jacobian_system_3::Mesh& mesh, const double K)
    : m_K(K), m_system(mesh), m_u(m_system.fit(Eigen::Matrix3Xd::Zero(3, 3 * mesh.cells.size())))
  {
    project();
  }

  const Eigen::Matrix3Xd& positions() const { return m_u; }
  std::size_t number_of_violating_cells() const { return m_number_of_violating_cells; }
  double distance() const { return (m_jacobians - m_projection).norm(); }
  bool is_running() const { return m_number_of_violating_cells > 0; }

  void step()
  {
    const Eigen::Matrix3Xd normal = m_jacobians - m_projection;
    const Eigen::Matrix3Xd nearest = m_system.fit(m_projection);
    const Eigen::Matrix3Xd along = m_system.fit_displacement(normal);
    const double distance = inner_product(normal, m_system.jacobians(nearest) - m_projection);
    const double slope = inner_product(normal, m_system.jacobians(along));
    m_u = slope > 0 ? Eigen::Matrix3Xd(nearest - distance / slope * along) : nearest;
    project();
  }

private:
  // The set is approached from outside: what is aimed at lies a little inside.
  static constexpr double safety = 0.99;

  static double inner_product(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b)
  {
    return a.cwiseProduct(b).sum();
  }

  void project()
  {
    using Matrix = Eigen::Map<const Eigen::Matrix3d>;
    m_jacobians = m_system.jacobians(m_u);
    m_projection.resize(3, m_jacobians.cols());
    m_number_of_violating_cells = 0;
    for(Eigen::Index column = 0; column < m_jacobians.cols(); column += 3)
    {
      const auto J = CGAL::Volume_mesh_parameterization::internal::decomposed(m_jacobians.middleCols<3>(column));
      const Eigen::Vector3d nearest = nearest_bounded(Eigen::Vector3d(J.s.x), safety * m_K);
      m_projection.middleCols<3>(column) = Matrix(J.R.data()) * nearest.asDiagonal() * Matrix(J.Q.data()).transpose();
      m_number_of_violating_cells += !(J.s[0] <= m_K * J.s[2]);
    }
  }

  double m_K;
  Jacobian_system_3 m_system;
  Eigen::Matrix3Xd m_u;
  Eigen::Matrix3Xd m_jacobians, m_projection;
  std::size_t m_number_of_violating_cells = 0;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_BOUNDED_DISTORTION_MAP_3_H
