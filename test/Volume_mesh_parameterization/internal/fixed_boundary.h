// The stages with fixed boundary, one after the other: untangling from the harmonic map, then minimization.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FIXED_BOUNDARY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FIXED_BOUNDARY_H

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace fixed_boundary {

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace internal = VMP::internal;

// Problem that the stages have in common.
template <typename Energy, typename Solver>
struct Problem
{
  internal::Cell_energy_of<Energy> energy;
  internal::Linear_solver_of<Solver> solver;
  internal::Newton_system_3 system;

  Problem(const internal::Numbered_mesh_3& mesh, const Energy& psi, Solver& traits)
    : energy(psi), solver(traits), system(mesh, free_vertices(mesh), solver)
  {}

  Problem(const Problem&) = delete; // the system refers to the other members
};

// The images from which untangling starts.
inline internal::Matrix3Xd harmonic_start(const internal::Numbered_mesh_3& mesh, internal::Newton_system_3& system)
{
  internal::Matrix3Xd positions = mesh.target;
  internal::Progress_3 progress(internal::Budget(), 1);
  harmonic_map_3(system, positions, progress);
  return snapped(mesh, positions);
}

constexpr double theta = 0.01;

struct Outcome
{
  internal::Matrix3Xd positions;
  VMP::Error_code status;
  double energy;
  std::vector<VMP::Parameterization_step> steps; // steps of both stages
};

// Ends after this number of steps.
template <typename Energy, typename Solver>
Outcome run(const internal::Numbered_mesh_3& mesh, const Energy& energy, Solver& solver, const std::size_t number_of_steps = 1000)
{
  Problem<Energy, Solver> problem(mesh, energy, solver);
  std::vector<VMP::Parameterization_step> steps;
  internal::Progress_3 progress(internal::Budget(), number_of_steps, [&](const VMP::Parameterization_step& step)
  {
    steps.push_back(step);
    return true;
  });
  internal::Newton_result_3 result
    = minimize_untangling_energy_3(problem.system, harmonic_start(mesh, problem.system), theta, progress);
  if(result.status == VMP::OK)
    result = minimize_energy_3(problem.system, problem.energy, result.positions, progress);
  return { snapped(mesh, result.positions), result.status, result.energy, steps };
}

} // namespace fixed_boundary

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FIXED_BOUNDARY_H
