// Any of the energies, so that what takes one is compiled once for all of them.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_ANY_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_ANY_ENERGY_3_H

#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Lp_stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Power_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <variant>

namespace CGAL::Volume_mesh_parameterization {

class Any_energy_3
{
  using Energy = std::variant<
    Stretch_energy_3, Dirichlet_energy_3, ARAP_energy_3, LSCM_energy_3, LPM_energy_3, MIPS_energy_3,
    Symmetric_Dirichlet_energy_3, Lp_stretch_energy_3, Barrier_energy_3<ARAP_energy_3>,
    Power_energy_3<MIPS_energy_3>, Bounded_angle_energy_3<Stretch_energy_3> >;

public:
  static constexpr std::size_t number_of_energies = std::variant_size_v<Energy>;

  explicit Any_energy_3(const std::size_t index)
  {
    static const std::array<Energy, number_of_energies> all = {
      Stretch_energy_3(), Dirichlet_energy_3(), ARAP_energy_3(), LSCM_energy_3(), LPM_energy_3(), MIPS_energy_3(),
      Symmetric_Dirichlet_energy_3(), Lp_stretch_energy_3(), Barrier_energy_3<ARAP_energy_3>(),
      Power_energy_3<MIPS_energy_3>(), Bounded_angle_energy_3<Stretch_energy_3>(3) };
    m_energy = all[index];
  }

  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  {
    return std::visit([&](const auto& energy) -> T { return energy.value(s); }, m_energy);
  }

  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  {
    return std::visit([&](const auto& energy) -> Eigen::Matrix<T, 3, 1> { return energy.gradient(s); }, m_energy);
  }

  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    return std::visit([&](const auto& energy) -> Eigen::Matrix<T, 3, 3> { return energy.hessian(s); }, m_energy);
  }

private:
  Energy m_energy;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_ANY_ENERGY_3_H
