// One of the energies, chosen by its name at run time; so the computation is compiled once for all of them.
#ifndef NAMED_ENERGY_3_H
#define NAMED_ENERGY_3_H

#include "find_name.h"

#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>

#include <Eigen/Dense>

#include <string>
#include <variant>

class Named_energy_3
{
public:
  // Energies that have no barrier receive one.
  explicit Named_energy_3(const std::string& name) : m_energy(find(name)) {}

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
  template <typename Energy>
  using Barrier = CGAL::Volume_mesh_parameterization::Barrier_energy_3<Energy>;

  using Stretch = CGAL::Volume_mesh_parameterization::Stretch_energy_3;
  using Dirichlet = Barrier<CGAL::Volume_mesh_parameterization::Dirichlet_energy_3>;
  using ARAP = Barrier<CGAL::Volume_mesh_parameterization::ARAP_energy_3>;
  using LSCM = Barrier<CGAL::Volume_mesh_parameterization::LSCM_energy_3>;
  using LPM = Barrier<CGAL::Volume_mesh_parameterization::LPM_energy_3>;
  using MIPS = CGAL::Volume_mesh_parameterization::MIPS_energy_3;
  using Symmetric_Dirichlet = CGAL::Volume_mesh_parameterization::Symmetric_Dirichlet_energy_3;
  using Energy = std::variant<Stretch, Dirichlet, ARAP, LSCM, LPM, MIPS, Symmetric_Dirichlet>;

  static Energy find(const std::string& name)
  {
    return find_name<Energy>("energy", name, {
      {"stretch", Stretch()}, {"symmetric_dirichlet", Symmetric_Dirichlet()}, {"mips", MIPS()}, {"arap", ARAP()},
      {"dirichlet", Dirichlet()}, {"lscm", LSCM()}, {"lpm", LPM()}});
  }

  Energy m_energy;
};

#endif // NAMED_ENERGY_3_H
