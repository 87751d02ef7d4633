// The stages with fixed boundary, one after the other: untangling from the harmonic map, then minimization.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FIXED_BOUNDARY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FIXED_BOUNDARY_H

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Minimization_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Untangling_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace fixed_boundary {

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace internal = VMP::internal;

// What the stages have in common.
template <typename Energy, typename Solver>
struct Problem
{
  internal::Cell_energy_of<Energy> energy;
  internal::Linear_solver_of<Solver> solver;
  internal::Scaled_cells_3 scaled;
  internal::Newton_system_3 system;

  Problem(const internal::Numbered_mesh_3& mesh, const Energy& psi, Solver& traits, const bool is_parallel = false)
    : energy(psi), solver(traits), scaled(cells_scaled_to_target(mesh)),
      system(mesh, scaled, free_vertices(mesh), solver, is_parallel)
  {}

  Problem(const Problem&) = delete; // the system refers to the other members
};

// The images from which untangling starts.
inline Eigen::Matrix3Xd harmonic_start(const internal::Numbered_mesh_3& mesh, internal::Newton_system_3& system)
{
  Eigen::Matrix3Xd u = system.unit() * mesh.target;
  harmonic_map_3(system, u);
  return snapped(mesh, u / system.unit());
}

constexpr double theta = 0.01;

template <typename Energy, typename Solver>
class Search
{
public:
  Search(const internal::Numbered_mesh_3& mesh, const Energy& energy, Solver& solver, const bool is_parallel = false)
    : m_problem(mesh, energy, solver, is_parallel),
      m_untangling(mesh, m_problem.system, harmonic_start(mesh, m_problem.system), theta)
  {
    minimize_if_untangled();
  }

  void step()
  {
    internal::Stage_3& stage = m_minimization ? static_cast<internal::Stage_3&>(*m_minimization) : m_untangling;
    stage.step();
    ++m_number_of_steps;
    m_last_step = stage.last_step();
    if(!m_minimization)
      minimize_if_untangled();
  }

  bool is_running() const { return stage().is_running(); }
  VMP::Error_code status() const { return stage().status(); }
  Eigen::Matrix3Xd positions() const { return stage().positions(); }
  bool is_flip_free() const { return stage().is_flip_free(); }
  const VMP::Parameterization_step& last_step() const { return m_last_step; }
  std::size_t number_of_steps() const { return m_number_of_steps; } // of both stages

private:
  const internal::Stage_3& stage() const
  {
    return m_minimization ? static_cast<const internal::Stage_3&>(*m_minimization) : m_untangling;
  }

  void minimize_if_untangled()
  {
    if(!m_untangling.is_running() && m_untangling.status() == VMP::OK)
      m_minimization.emplace(m_problem.system, m_problem.energy, m_untangling.positions());
  }

  Problem<Energy, Solver> m_problem;
  internal::Untangling_3 m_untangling;
  std::optional<internal::Minimization_3> m_minimization;
  VMP::Parameterization_step m_last_step;
  std::size_t m_number_of_steps = 0;
};

} // namespace fixed_boundary

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FIXED_BOUNDARY_H
