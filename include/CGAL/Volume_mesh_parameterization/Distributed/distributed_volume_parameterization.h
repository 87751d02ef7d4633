// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_DISTRIBUTED_VOLUME_PARAMETERIZATION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_DISTRIBUTED_VOLUME_PARAMETERIZATION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Distributed/PETSc_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Entry/named_parameters_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>

#include <iostream>

namespace CGAL {

namespace Volume_mesh_parameterization::internal {

// Finds the images of the points of the slices of a mesh.
template <typename IsConstrained>
Parameterization_result parameterize_distributed_mesh_3(const MPI_communicator_3& communicator,
                                                        const Distributed_tetrahedron_soup_3& soup,
                                                        const std::vector<std::array<double, 3> >& targets,
                                                        const IsConstrained& is_constrained, const Map_problem_3& problem,
                                                        std::vector<std::array<double, 3> >& images)
{
  const Distributed_mesh_3 distributed(communicator, soup, targets, is_constrained,
                                       problem.options.use_volume_weights, problem.options.is_parallel);
  const Numbered_mesh_3& mesh = distributed.mesh();
  const Input_check_3 check = check_input_3(mesh, problem.progress.budget());
  problem.progress.end_numbering();
  Parameterization_result result;
  if(check.allows_fixed_boundary())
  {
    PETSc_solver_3 solver(communicator, distributed);
    if(problem.options.verbose)
      std::cout << "process 0 of " << communicator.size() << ": " << mesh.number_of_own_cells() << " cells and "
                << mesh.number_of_copied_cells << " of others, " << distributed.number_of_own_rows()
                << " free vertices and " << mesh.number_of_copied_vertices << " of others; " << solver.name() << std::endl;
    Map_options_3 options = problem.options;
    options.mode = Boundary_mode::FIXED;
    const Map_problem_3 of_processes = { options, problem.energy, solver, problem.progress };
    const Found_map_3 found = find_map_3(mesh, check, of_processes);
    result = make_result_3(mesh, check, found, of_processes);
    if(result.has_valid_map)
      distributed.write(found.map.positions, images);
  }
  else
    result = refused_result(check, problem.progress);
  result.number_of_vertices = distributed.number_of_vertices();
  result.number_of_cells = static_cast<std::size_t>(mesh.global_number_of_cells());
  result.number_of_boundary_vertices = distributed.number_of_boundary_vertices();
  return result;
}

} // namespace Volume_mesh_parameterization::internal

/*!
\ingroup PkgVolumeMeshParameterizationDistributed

computes the same map for a mesh that several processes share, by MPI and PETSc. All processes of the communicator must
call this function, after `PetscInitialize()`, with the same named parameters. PT-Scotch computes a partition of the mesh.
Therefore, points and cells may come in any order. A process may have to do with at most \f$2^{31} - 1\f$ cells.

PETSc solves the Newton systems. The default is conjugate gradients that stop at negative curvature (`KSPSTCG`), with the
inverses of the 3x3 diagonal blocks (`PCPBJACOBI`). PETSc's options database may name others, for instance `-pc_type gamg`. The
map differs from that of one process by rounding and by the tolerance of the solver. Two runs with the same number of processes
give the same bits if PT-Scotch runs without threads. The environment variable `SCOTCH_PTHREAD_NUMBER=1` switches its threads
off. The function makes the attempts of one process with fixed boundary, with one exception. If more than a million cells are
around inverted or flat cells, it does not untangle or relax small patches. Connected components of the target are not looked at
one by one: the volume of all must be positive.

\param soup this process's slice of the mesh
\param targets the image of each point of the slice that is a vertex of the boundary, of a facet of one cell only. The
       others are not read, unless `vertex_is_constrained_map` lists them; a coordinate that is not a number stands for a
       missing target.
\param images receives the image of each point of the slice if the map is valid, and is left alone otherwise. Points
       without a cell receive coordinates that are not numbers. May be the same array as `targets`.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `energy`, `energy_tolerance`,
       `use_volume_weights`, `vertex_is_constrained_map`, `number_of_iterations`, `maximum_running_time`, `visitor` and
       `verbose`. Keys of `vertex_is_constrained_map` are indices of points in the whole mesh. The running time is tested after
       each Newton step. Rank 0 prints. The boundary is fixed; the other parameters of the function for a complex are not
       compiled.

\return the same in all processes, but for times. If a visitor or a clock ends the computation in one process, then in all.

If a process throws an exception, all processes throw it, also if an energy or a visitor throws.
`Volume_mesh_parameterization::Input_error` and `std::bad_alloc` keep their types. Other exceptions become `std::runtime_error`
with the sentence of the first process. Errors within PETSc end all processes by `MPI_Abort()`.

Each process needs memory linear in the number of cells around its own vertices. A Newton step has a number of messages
proportional to the number of iterations of the linear solver.
*/
template <typename NamedParameters = parameters::Default_named_parameters>
Volume_mesh_parameterization::Parameterization_result
stretch_minimizing_volume_parameterization(
  const Volume_mesh_parameterization::Distributed_tetrahedron_soup_3& soup,
  const std::vector<std::array<double, 3> >& targets,
  std::vector<std::array<double, 3> >& images,
  const NamedParameters& np = parameters::default_values())
{
  using parameters::is_default_parameter;
  namespace VMP = Volume_mesh_parameterization;
  using Result = VMP::Parameterization_result;
  static_assert(is_default_parameter<NamedParameters, internal_np::boundary_map_t>::value
                && is_default_parameter<NamedParameters, internal_np::boundary_parameterizer_t>::value,
                "boundary_map must not be passed for arrays: the targets are an argument.");
  static_assert(is_default_parameter<NamedParameters, internal_np::boundary_mode_t>::value
                && is_default_parameter<NamedParameters, internal_np::soft_boundary_parameters_t>::value
                && is_default_parameter<NamedParameters, internal_np::positional_constraints_t>::value
                && is_default_parameter<NamedParameters, internal_np::do_slide_boundary_t>::value
                && is_default_parameter<NamedParameters, internal_np::maximum_angle_distortion_t>::value,
                "boundary_mode and do_slide_boundary must not be passed for a distributed mesh: its boundary is fixed.");
  static_assert(is_default_parameter<NamedParameters, internal_np::vertex_condition_t>::value,
                "vertex_condition_map must not be passed for a distributed mesh: its boundary is at its targets.");
  static_assert(is_default_parameter<NamedParameters, internal_np::refinement_mode_t>::value,
                "refinement_mode must not be passed for a distributed mesh: call make_parameterizable() before.");
  static_assert(is_default_parameter<NamedParameters, internal_np::solver_traits_t>::value,
                "solver_traits must not be passed for a distributed mesh: PETSc's options choose the solver.");

  const VMP::internal::MPI_communicator_3 communicator(soup.communicator);
  const bool is_printing = communicator.rank() == 0 && VMP::internal::parameter_or(np, internal_np::verbose, false);
  return communicator.together([&]() -> Result
  {
    VMP::internal::require(targets.size() == soup.points.size(), "targets must have an element for each point.");
    const auto map = VMP::internal::parameter_or(np, internal_np::vertex_is_constrained,
                                          Static_boolean_property_map<std::size_t, false>());
    const auto of_process = np.verbose(is_printing);
    VMP::internal::Named_problem_3<Sequential_tag, std::remove_const_t<decltype(of_process)> > named(of_process, communicator);
    return VMP::internal::parameterize_distributed_mesh_3(
      communicator, soup, targets, [&](const std::size_t v) { return get(map, v); }, named.problem(), images);
  });
}

} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_DISTRIBUTED_VOLUME_PARAMETERIZATION_H
