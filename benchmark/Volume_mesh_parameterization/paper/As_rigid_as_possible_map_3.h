#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_AS_RIGID_AS_POSSIBLE_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_AS_RIGID_AS_POSSIBLE_MAP_3_H

#include "Jacobian_system_3.h"

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>

#include <Eigen/Dense>

#include <cmath>

// The map with fixed boundary whose Jacobians are nearest to rotations, after Chao et al., A Simple
// Geometric Model for Elastic Deformations (TOG 2010): starts from the harmonic map, and takes the nearest
// rotations and the nearest map by turns. Nothing forbids inverted cells.
class As_rigid_as_possible_map_3
{
public:
  explicit As_rigid_as_possible_map_3(const Jacobian_system_3::Mesh& mesh)
    : m_system(mesh), m_u(m_system.fit(Eigen::Matrix3Xd::Zero(3, 3 * mesh.cells.size())))
  {}

  const Eigen::Matrix3Xd& positions() const { return m_u; }
  double energy() const { return m_energy; }
  bool is_running() const { return m_is_running; }

  void step()
  {
    constexpr double tolerance = 1e-6;
    const Eigen::Matrix3Xd jacobians = m_system.jacobians(m_u);
    const Eigen::Matrix3Xd rotations = nearest_rotations(jacobians);
    const double energy = (jacobians - rotations).squaredNorm();
    m_is_running = !(std::abs(m_energy - energy) < tolerance * energy);
    m_energy = energy;
    m_u = m_system.fit(rotations);
  }

private:
  Eigen::Matrix3Xd nearest_rotations(const Eigen::Matrix3Xd& jacobians) const
  {
    using CGAL::Volume_mesh_parameterization::internal::rotation_and_stretch_3;
    Eigen::Matrix3Xd result(3, jacobians.cols());
    for(Eigen::Index column = 0; column < jacobians.cols(); column += 3)
    {
      const double weight = m_system.weight(static_cast<std::size_t>(column / 3));
      const Eigen::Matrix3d rotation = rotation_and_stretch_3(jacobians.middleCols<3>(column)).rotation;
      result.middleCols<3>(column) = std::sqrt(weight) * rotation;
    }
    return result;
  }

  Jacobian_system_3 m_system;
  Eigen::Matrix3Xd m_u;
  double m_energy = 0;
  bool m_is_running = true;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_AS_RIGID_AS_POSSIBLE_MAP_3_H
