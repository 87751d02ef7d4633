// The energies, the linear solvers, the modes of the boundary and the axes of a polycube, chosen by their names at run time.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_NAMED_CHOICES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_NAMED_CHOICES_H

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Any_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
#  include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#endif

#include <CGAL/tags.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

// Returns the value of a name. If the name is not in the table, the exception lists the names there; `kind` is what they name.
template <typename Value>
Value find_name(const std::string& kind, const std::string& name, const std::vector<std::pair<std::string, Value> >& table)
{
  std::string names;
  for(const auto& [known, value] : table)
  {
    if(known == name)
      return value;
    names += (names.empty() ? "" : ", ") + known;
  }
  throw std::runtime_error("there is no " + kind + " '" + name + "'; choose among: " + names);
}

// Energies that have no barrier receive one.
inline VMP::Any_energy_3 named_energy(const std::string& name)
{
  using namespace VMP;
  return find_name<Any_energy_3>("energy", name, {
    {"stretch", Stretch_energy_3()}, {"symmetric_dirichlet", Symmetric_Dirichlet_energy_3()}, {"mips", MIPS_energy_3()},
    {"arap", Barrier_energy_3<ARAP_energy_3>()}, {"dirichlet", Barrier_energy_3<Dirichlet_energy_3>()},
    {"lscm", Barrier_energy_3<LSCM_energy_3>()}, {"lpm", Barrier_energy_3<LPM_energy_3>()}});
}

// Without a name, a free boundary has the size of the source as reference.
inline double named_reference_scale(const std::string& name, const bool is_boundary_free)
{
  if(name.empty())
    return is_boundary_free ? 1 : VMP::found_reference_scale;
  if(name == "found")
    return VMP::found_reference_scale;
  double result;
  char rest;
  std::istringstream is(name);
  if(!(is >> result) || is >> rest || !(result > 0) || std::isinf(result))
    throw std::runtime_error("--reference-scale needs a positive number, or found, and not '" + name + "'");
  return result;
}

// The number of threads is limited at run time; results do not depend on it.
using Concurrency_tag = CGAL::Parallel_if_available_tag;

using Solver = std::variant<
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
  VMP::CHOLMOD_solver_traits_3,
#endif
  VMP::Conjugate_gradient_solver_traits_3<Concurrency_tag> >;

inline Solver named_solver(const std::string& name)
{
  return find_name<Solver>("solver", name, {
    {"cg", VMP::Conjugate_gradient_solver_traits_3<Concurrency_tag>()},
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
    {"cholmod", VMP::CHOLMOD_solver_traits_3()},
#endif
  });
}

inline VMP::Boundary_mode named_boundary_mode(const std::string& name)
{
  using VMP::Boundary_mode;
  return find_name<Boundary_mode>("boundary mode", name, {
    {"auto", Boundary_mode::AUTO}, {"fixed", Boundary_mode::FIXED}, {"soft", Boundary_mode::SOFT}});
}

inline PM::Polycube_axes named_polycube_axes(const std::string& name)
{
  using PM::Polycube_axes;
  return find_name<Polycube_axes>("way to choose axes", name, {
    {"found", Polycube_axes::FOUND}, {"given", Polycube_axes::GIVEN}});
}

// Where the program may add vertices, by the parameter of the library and by make_parameterizable().
struct Refinement
{
  VMP::Refinement_mode mode;
  bool splits_all_bridges = false;
};

inline Refinement named_refinement(const std::string& name)
{
  using VMP::Refinement_mode;
  return find_name<Refinement>("refinement", name, {
    {"none", {Refinement_mode::NONE}}, {"needed", {Refinement_mode::NEEDED}}, {"helpful", {Refinement_mode::HELPFUL}},
    {"boundary", {Refinement_mode::BOUNDARY}}, {"all", {Refinement_mode::BOUNDARY, true}}});
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_NAMED_CHOICES_H
