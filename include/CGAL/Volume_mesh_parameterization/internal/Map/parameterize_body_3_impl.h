// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/alignment_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_input_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Simplex_removal_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/find_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Facet_matching_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/make_result_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/plan_refinement_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/round_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/slide_and_bound_angles_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/split_bridges_3.h>

#include <iomanip>
#include <iostream>

namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void print(const Parameterization_step& step)
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

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void print(const Derivative_errors_3& errors)
{
  const auto is_wrong = [](const double error) { return error >= Derivative_errors_3::bound && std::isfinite(error); };
  if(is_wrong(errors.symmetry))
    std::cout << "The energy is not symmetric: its value changes by " << errors.symmetry
              << " of its size if singular values are exchanged." << std::endl;
  if(is_wrong(errors.gradient))
    std::cout << "The gradient of the energy is wrong: it differs from finite differences by " << errors.gradient
              << " of their size." << std::endl;
  if(is_wrong(errors.hessian))
    std::cout << "The Hessian of the energy is wrong: it differs from finite differences of the gradient by " << errors.hessian
              << " of their size." << std::endl;
}

// Gives points that slide in the boundary and have no target the planes, edges and patches of the source.
inline Prescription_3 with_conditions_of_source(const Body_3& body, Prescription_3 prescription)
{
  std::vector<bool> slides(body.points.size());
  for(std::size_t p = 0; p < slides.size(); ++p)
    slides[p] = slides_in_boundary(prescription.conditions[p]) && std::isnan(prescription.targets[p][0]);
  if(std::find(slides.begin(), slides.end(), true) == slides.end())
    return prescription;
  Numbered_body_3 numbered(body, prescription.prescribed_points(), body.points);
  Numbered_mesh_3& mesh = numbered.mesh;
  if(!mesh.source.allFinite())
    return prescription; // the check of the input names the place
  const auto point = [&](const std::size_t i) { return numbered.points[mesh.number_of_free_vertices + i]; };
  for(int i = 0; i < mesh.number_of_prescribed_vertices(); ++i)
    mesh.sliding_conditions.push_back(slides[point(i)] ? Vertex_condition_3::in_boundary() : Vertex_condition_3::at_target());
  const Conditions_3 conditions = Sliding_boundary_3(mesh).conditions();
  for(std::size_t i = 0; i < conditions.size(); ++i)
    if(const std::size_t p = point(i); slides[p])
    {
      prescription.conditions[p] = conditions[i];
      prescription.targets[p] = body.image_type.rounded_point(body.points[p]);
    }
  prescription.slides_in_source = slides;
  return prescription;
}

// Returns the condition of a vertex until vertices slide. Before it slides on a surface or curve of the source, it keeps to the
// tangent plane or the tangent where it starts, which becomes its target.
inline Vertex_condition_3 first_condition_3(const Vertex_condition_3& condition, const bool slides_in_source,
                                            const Vector_3& start, Vector_3& target)
{
  if(!slides_in_source || !condition.is_sliding())
    return does_slide_later(condition) ? Vertex_condition_3::at_target() : condition;
  const auto [point, d] = put_on_surface_3(condition, start);
  target = point;
  return condition.dimension() == 1 ? Vertex_condition_3::on_line(d[0], d[1], d[2])
                                    : Vertex_condition_3::in_plane(d[0], d[1], d[2]);
}

// Sets what the prescribed vertices of a body may do, and aligns the source to what is prescribed if a part of the boundary is
// free. Targets in free directions become those of the aligned source. A body that slides in the boundary of the source starts as
// it is.
inline void set_conditions_3(Numbered_body_3& numbered, const Body_3& body, const Prescription_3& prescription)
{
  Numbered_mesh_3& mesh = numbered.mesh;
  const auto slides_in_source = [&](const std::size_t p)
  { return !prescription.slides_in_source.empty() && prescription.slides_in_source[p]; };
  for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
  {
    const Vertex_condition_3& condition = prescription.conditions[numbered.points[v]];
    mesh.sliding_conditions.push_back(condition);
    const std::size_t p = numbered.points[v];
    const bool has_start = !prescription.initial.empty() && !std::isnan(prescription.initial[p][0]);
    const Vector_3 start = has_start ? to_vector(prescription.initial[p]) : mesh.target.col(v);
    mesh.conditions.push_back(first_condition_3(condition, slides_in_source(p), start, mesh.target.col(v)));
  }
  if(std::none_of(mesh.sliding_conditions.begin(), mesh.sliding_conditions.end(), does_slide_later))
    mesh.sliding_conditions.clear();
  if(std::all_of(mesh.conditions.begin(), mesh.conditions.end(), is_at_target_first))
    mesh.conditions.clear();
  if(!mesh.source.allFinite() || !mesh.target.rightCols(mesh.number_of_prescribed_vertices()).allFinite())
    return; // the check of the input names the place
  bool is_free = false;
  for(const std::array<std::size_t, 3>& facet : body.boundary)
    for(const std::size_t p : facet)
      if(!mesh.is_fixed(numbered.vertices[p]))
      {
        mesh.is_boundary_fixed = false;
        is_free = is_free || !slides_in_source(p);
      }
  if(is_free)
  {
    mesh.alignment = alignment_3(mesh);
    set_targets(mesh, snapped(mesh, moved(*mesh.alignment, mesh.source)));
  }
  else if(!mesh.is_boundary_fixed)
    mesh.initial = mesh.source;
}

// A body with a free boundary has its own size as reference unless the user asks for another one.
inline void set_reference_scale_3(Numbered_mesh_3& mesh, const std::optional<double>& wanted)
{
  if(wanted && *wanted != found_reference_scale)
    mesh.reference_scale = wanted;
  else if(!mesh.is_boundary_fixed)
    mesh.reference_scale = wanted && mesh.alignment ? mesh.alignment->scale : 1;
}

// Numbers a body, with all that is prescribed in these numbers.
inline Numbered_body_3 numbered_body_3(const Body_3& body, const Prescription_3& prescription, const Map_options_3& options)
{
  Numbered_body_3 result(body, prescription.prescribed_points(), prescription.targets,
                         options.use_volume_weights, options.is_parallel);
  Numbered_mesh_3& mesh = result.mesh;
  set_conditions_3(result, body, prescription);
  set_reference_scale_3(mesh, options.reference_scale);
  if(options.use_regular_references)
    set_regular_cell(mesh);
  if(!prescription.initial.empty())
    mesh.initial = result.columns(prescription.initial);
  for(const Linear_constraint_3<std::size_t>& constraint : prescription.constraints)
  {
    mesh.constraints.push_back({ {}, constraint.value });
    for(const auto& term : constraint.terms)
      mesh.constraints.back().terms.push_back({ result.vertices[term.vertex], term.coefficient });
  }
  return result;
}

// Refuses an energy that falls without end as a body with free boundary grows or shrinks. Evaluates it for similar cells of many
// sizes, nearly regular: the lowest value must not be at the first or last size.
inline Input_check_3 check_energy_3(const Cell_energy_3& energy)
{
  std::vector<Vector_3> s;
  for(int k = -20; k <= 20; ++k)
    s.push_back(std::exp2(k) * Vector_3(1.1, 1, 0.9));
  const std::vector<double> psi = energies_of_cells_3(s, energy, 1);
  const double lowest_inside = *std::min_element(psi.begin() + 1, psi.end() - 1);
  const bool grows = psi.back() < lowest_inside, shrinks = psi.front() < lowest_inside;
  if(!grows && !shrinks)
    return {};
  return failed_check(ERROR_ENERGY_WITHOUT_MINIMUM, get_error_message(ERROR_ENERGY_WITHOUT_MINIMUM),
                      " The energy falls as the body ",
                      grows ? "grows" : "shrinks", ". Symmetric_Dirichlet_energy_3 has a minimum.");
}

// A body with its numbers, and the check of these.
struct Checked_body_3
{
  Numbered_body_3 numbered;
  Input_check_3 check;

  Checked_body_3(const Body_3& body, const Prescription_3& prescription, const Map_problem_3& problem, const Budget& budget)
    : numbered(numbered_body_3(body, prescription, problem.options)), check(check_input_3(numbered.mesh, budget))
  {
    if(check.status == OK && numbered.mesh.alignment)
      check = check_energy_3(problem.energy);
    problem.progress.end_numbering();
  }
};

// Calls the stages that are allowed, one after the other.
inline Found_map_3 find_map_of_body_3(const Checked_body_3& body, const Map_problem_3& problem, const Search_start_3& start)
{
  const Numbered_mesh_3& mesh = body.numbered.mesh;
  if(problem.options.verbose)
    std::cout << mesh.cells.size() << " cells, " << mesh.number_of_vertices() << " vertices, "
              << mesh.number_of_free_vertices << " of them free; linear solver " << problem.solver.name() << std::endl;
  return find_map_3(mesh, body.check, problem, start);
}

inline std::size_t number_of_marks(const std::vector<bool>& is_marked)
{ return static_cast<std::size_t>(std::count(is_marked.begin(), is_marked.end(), true)); }

// Returns the map if the time was over before the numbering, which takes about as long as a step: none.
inline Body_map_3 interrupted_map(const Body_3& body, const Progress_3& progress)
{
  Parameterization_result result
    = refused_result(failed_check(ERROR_INTERRUPTED, get_error_message(ERROR_INTERRUPTED)), progress);
  result.number_of_vertices = number_of_marks(used_points(body.cells, body.points.size()));
  result.number_of_cells = body.cells.size();
  result.number_of_boundary_vertices = number_of_marks(used_points(body.boundary, body.points.size()));
  return { result, {}, {} };
}

// The map of a search, if there was one. Rounds the images of the points to what the user stores.
inline Body_map_3 map_of_search(const Body_3& body, const Checked_body_3& checked, const Map_problem_3& problem,
                                std::optional<Found_map_3>&& found)
{
  Body_map_3 map;
  Parameterization_result& result = map.result;
  std::vector<std::array<double, 3> >& images = map.images;
  const auto& [numbered, check] = checked;
  if(found)
    round_map_3(numbered.mesh, body.image_type, problem, *found);
  result = found ? make_result_3(numbered.mesh, check, *found, problem) : refused_result(check, problem.progress);
  if(result.has_valid_map)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    images.assign(numbered.vertices.size(), { nan, nan, nan });
    for(std::size_t v = 0; v < numbered.points.size(); ++v)
      images[numbered.points[v]] = coordinates(found->map.positions.col(v));
    result.boundary_distortion
      = facet_distortion_3(body.boundary, [&](const std::size_t p) { return to_vector(body.points[p]); },
                           [&](const std::size_t p) { return to_vector(images[p]); });
  }
  result.number_of_vertices = numbered.points.size();
  result.number_of_cells = numbered.mesh.cells.size();
  result.number_of_boundary_vertices = number_of_marks(used_points(body.boundary, body.points.size()));
  return map;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Body_map_3 parameterize_body_3(Body_3 body, const Prescription_3& prescription, const Map_problem_3& problem)
{
  if(problem.progress.is_interrupted())
    return interrupted_map(body, problem.progress);
  const Checked_body_3 checked(body, with_conditions_of_source(body, prescription), problem, problem.progress.budget());
  body.cells = std::vector<std::array<std::size_t, 4> >(); // gives their memory back: only numbered ones are needed now
  Search_start_3 start;
  start.patience = 2; // where nothing can be refined, larger weights get a chance
  std::optional<Found_map_3> found;
  if(checked.check.allows(problem.options.mode))
    found = find_map_of_body_3(checked, problem, start);
  return map_of_search(body, checked, problem, std::move(found));
}

// Splits edges of vertices.
inline std::vector<Insertion_3> split_edges_of_vertices_3(Body_3& body, const std::vector<std::size_t>& points_of_vertices,
                                                          const std::vector<std::array<int, 2> >& edges,
                                                          const bool is_longest_first)
{
  std::vector<std::array<std::size_t, 2> > edges_of_points;
  for(const auto& [v, w] : edges)
    edges_of_points.push_back({ points_of_vertices[v], points_of_vertices[w] });
  return split_edges_3(body, edges_of_points, is_longest_first);
}

// Refines a body where the targets make cells degenerate, and bridges if this helps. Then searches, and refines where the search
// was blocked, in turn. If splits have added a tenth of the points, they do not help; a small body may need more: a guess. After a
// limit of time, nothing is refined.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Body_map_3 refine_and_parameterize_body_3(Body_3& body, Prescription_3 prescription, const Map_problem_3& problem,
                                          std::vector<Insertion_3> insertions)
{
  if(problem.progress.is_interrupted())
  {
    Body_map_3 map = interrupted_map(body, problem.progress);
    map.insertions = std::move(insertions);
    return map;
  }
  const Budget& budget = problem.progress.budget();
  prescription = with_conditions_of_source(body, std::move(prescription));
  Checked_body_3 checked(body, prescription, problem, budget);
  const auto take = [&](const std::vector<Insertion_3>& made)
  {
    insertions.insert(insertions.end(), made.begin(), made.end());
    prescription.extend_to(body.points.size());
    checked = Checked_body_3(body, prescription, problem, Budget()); // there may be a map to be returned
  };
  if(checked.check.allows_soft_boundary() && checked.check.is_refinable)
    if(const auto made = remove_degenerate_simplices(body, prescription, budget); !made.empty())
      take(made);
  if(problem.options.refinement != Refinement_mode::NEEDED && problem.options.mode != Boundary_mode::SOFT
     && checked.check.allows_soft_boundary() && checked.check.is_refinable)
    if(const auto made = split_bridges_3(body, checked.numbered, prescription, problem); !made.empty())
      take(made);

  std::size_t number_of_splits = 0;
  std::optional<Found_map_3> found;
  for(Search_start_3 start; checked.check.allows(problem.options.mode); )
  {
    const std::size_t limit = (std::max)(checked.numbered.points.size() / 10, std::size_t(5000));
    start.may_split = checked.check.is_refinable && number_of_splits <= limit;
    start.patience = start.may_split ? 1 : 2;
    found = find_map_of_body_3(checked, problem, start);
    if(!start.may_split || !found->is_blocked())
      break;
    const Refinement_plan_3 plan = plan_refinement_3(checked.numbered.mesh, *found, start);
    const std::vector<Insertion_3> splits = split_edges_of_vertices_3(body, checked.numbered.points, plan.edges,
                                                                      !found->splits.are_all);
    if(splits.empty() && !found->is_stuck())
      break;
    number_of_splits += splits.size();
    const std::vector<std::size_t> points_before = std::move(checked.numbered.points);
    take(splits);
    start = renumbered_start_3(plan, points_before, splits, checked.numbered);
    found.reset();
  }
  if(!found && checked.check.status == ERROR_PRESCRIBED_CELL_INVERTED && checked.check.is_refinable && budget.is_exhausted())
    checked.check.status = ERROR_INTERRUPTED;
  checked.check.is_refinable = false; // by more than what has been refined
  Body_map_3 map = map_of_search(body, checked, problem, std::move(found));
  map.result.number_of_added_vertices = insertions.size();
  map.insertions = std::move(insertions);
  return map;
}

// Measures the distortion with all points prescribed, so that the map is their target.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Distortion_3 distortion_of_body_3(const Body_3& body, const std::vector<std::array<double, 3> >& images)
{
  check_cells(body.cells, body.points.size());
  require(images.size() == body.points.size(), "images must have an element for each point.");
  const Numbered_mesh_3 mesh = Numbered_body_3(body, std::vector<bool>(body.points.size(), true), images).mesh;
  return measure_distortion_3(mesh, singular_values_of_cells_3(mesh, mesh.target));
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_IMPL_H
