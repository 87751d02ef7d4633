// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_COMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_COMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Engine/engine.h>

#include <iomanip>
#include <iostream>

namespace CGAL::Volume_mesh_parameterization::internal {

// Says what is going to be solved, and by which linear solver.
inline void print(const Numbered_mesh_3& mesh, const Linear_solver_3& solver)
{
  std::cout << mesh.cells.size() << " cells, " << mesh.number_of_vertices() << " vertices, "
            << mesh.number_of_free_vertices << " of them free; linear solver " << solver.name() << std::endl;
}

inline void print(const Parameterization_step& step)
{
  std::cout << std::setw(5) << step.iteration
            << (step.phase == Phase::UNTANGLING ? " untangling  " : " minimization")
            << "  energy " << std::setw(12) << step.energy
            << "  inverted " << std::setw(6) << step.number_of_inverted_cells
            << "  gradient " << std::setw(11) << step.gradient_norm
            << "  decrement " << std::setw(11) << step.decrement
            << "  step " << std::setw(9) << step.step_length
            << "  seconds " << step.seconds << "  " << step.attempt << std::endl;
}

// What is asked for, and with what means: the engine's options, and what depends on the type of the complex.
template <typename Vertex, typename VertexIsConstrainedMap, typename BoundaryMap>
struct Complex_problem_3
{
  VertexIsConstrainedMap is_constrained;
  BoundaryMap target;
  std::function<Eigen::Vector3d(const Vertex&)> initial; // image of a vertex to start from; empty if there are none
  std::vector<Linear_constraint_3<Vertex> > constraints;
  Map_options_3 options;
  bool use_volume_weights;
  bool verbose;
  const Cell_energy_3& energy;
  Linear_solver_3& solver;
  Progress_3& progress;
};

// A complex or a soup with its numbers, and what the check of these has found.
template <typename Numbered>
struct Checked_complex_3
{
  Numbered numbered;
  Input_check_3 check;

  template <typename Mesh, typename Problem>
  Checked_complex_3(const Mesh& mesh, const Problem& problem)
    : numbered(mesh, problem.is_constrained, problem.target, problem.use_volume_weights)
  {
    if(problem.initial)
      numbered.set_initial(problem.initial);
    check = engine::check_input(numbered.mesh());
    problem.progress.end_numbering();
  }

  bool allows(const Boundary_mode mode) const
  {
    return check.allows_fixed_boundary() || (check.allows_soft_boundary() && mode != Boundary_mode::FIXED);
  }
};

// The stages that are allowed, one after the other.
template <typename Numbered, typename Problem>
Found_map_3 find_map_of_complex_3(const Checked_complex_3<Numbered>& complex, const Problem& problem,
                                  const Untangling_start_3& untangling, const Approach_start_3& approach)
{
  const Numbered& numbered = complex.numbered;
  if(problem.verbose)
    print(numbered.mesh(), problem.solver);
  Map_options_3 options = problem.options;
  options.untangling = untangling;
  options.approach = approach;
  options.constraints = numbered.constraints(problem.constraints);
  if(options.do_slide)
    for(const auto v : numbered.vertices())
      options.is_held.push_back(get(problem.is_constrained, v));
  return engine::find_map(numbered.mesh(), complex.check, problem.energy, problem.solver, options, problem.progress);
}

template <typename Numbered>
void add_counts(const Numbered& numbered, Parameterization_result& result)
{
  result.number_of_vertices = numbered.vertices().size();
  result.number_of_cells = numbered.mesh().cells.size();
  result.number_of_boundary_vertices = numbered.number_of_boundary_vertices();
}

// The result where the check does not allow a search, without counts.
inline Parameterization_result refused_result(const Input_check_3& check, const Progress_3& progress)
{
  Parameterization_result result;
  result.status = check.status;
  result.message = check.message;
  result.seconds_numbering = result.seconds_total = progress.seconds();
  return result;
}

template <typename Numbered, typename Problem>
Parameterization_result refused_result(const Checked_complex_3<Numbered>& complex, const Problem& problem)
{
  Parameterization_result result = refused_result(complex.check, problem.progress);
  add_counts(complex.numbered, result);
  return result;
}

// The result of a search; writes the images of the vertices if they are a map.
template <typename Numbered, typename Problem, typename Images>
Parameterization_result written_result(const Checked_complex_3<Numbered>& complex, const Problem& problem,
                                       const Found_map_3& found, Images& images)
{
  Parameterization_result result
    = engine::make_result(complex.numbered.mesh(), complex.check, found, problem.energy, problem.solver, problem.progress);
  add_counts(complex.numbered, result);
  if(result.has_valid_map)
    complex.numbered.write(found.map.positions, images);
  return result;
}

// From a complex to the images of its vertices.
template <typename Numbered, typename Mesh, typename Problem, typename Images>
Parameterization_result parameterize_complex_3(const Mesh& mesh, const Problem& problem, Images& images)
{
  const Checked_complex_3<Numbered> complex(mesh, problem);
  if(!complex.allows(problem.options.mode))
    return refused_result(complex, problem);
  Approach_start_3 approach;
  approach.patience = 2; // where nothing can be refined, larger weights get a chance
  return written_result(complex, problem, find_map_of_complex_3(complex, problem, Untangling_start_3(), approach), images);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_COMPLEX_3_H
