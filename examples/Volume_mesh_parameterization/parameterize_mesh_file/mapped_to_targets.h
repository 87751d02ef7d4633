// The map of a mesh to the targets of its vertices, which are found first if they are on a domain.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MAPPED_TO_TARGETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MAPPED_TO_TARGETS_H

#include "Command_line.h"
#include "Hexahedra_file.h"
#include "Named_choices.h"
#include "Progress_line.h"
#include "Report.h"
#include "Target_points.h"
#include "boundary_targets_of.h"
#include "mapped_with_splits.h"
#include "read_source.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Refinement_3.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Result = VMP::Parameterization_result;

// Mesh with targets of its vertices, and the map to them.
struct Mapped_mesh
{
  VMP::Tetrahedron_soup_3 mesh;
  Target_points target;
  Points initial;                       // images to start from, or none
  std::size_t number_of_new_points = 0; // of those that the mesh has got before the map
  VMP::Polycube_result polycube = {};
  double seconds_boundary = 0;
  Points uvw = {};
  Result result = {};

  bool is_success() const { return exit_code(result) == SUCCESS; }
  bool has_valid_map() const { return result.has_valid_map; }
};

// Extends what is told of the vertices of a mesh to those that it has got.
inline void extend_to_new_points(const std::size_t number_of_points, Mapped_mesh& mapped)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::size_t n = mapped.mesh.points.size();
  mapped.number_of_new_points += n - number_of_points;
  mapped.target.points.resize(n, { nan, nan, nan });
  mapped.target.is_constrained.resize(n, false);
  if(!mapped.initial.empty())
    mapped.initial.resize(n, { nan, nan, nan });
}

// Finds the targets on a domain. The boundary may be split for those on a polycube.
inline Mapped_mesh with_targets_on_domain(Mapped_mesh mapped, const Options& options, const bool may_split,
                                          const Landmarks& landmarks, Progress_line& progress)
{
  progress.begin("mapping the boundary to " + options.domain);
  const double begin = progress.seconds();
  const std::size_t number_of_points = mapped.mesh.points.size();
  const Polycube polycube(Hexahedra_file(options.hexahedra).spacing(), named_polycube_axes(options.polycube_axes),
                          &mapped.polycube);
  mapped.target.points = naming(options.source, [&]
  { return targets_on_domain(options.domain, polycube, may_split, landmarks, mapped.mesh, progress); });
  extend_to_new_points(number_of_points, mapped);
  mapped.seconds_boundary = progress.seconds() - begin;
  return mapped;
}

inline Result parameterize(VMP::Tetrahedron_soup_3& mesh, const Target_points& target, const Points& initial,
                           const Options& options, Progress_line& progress, Points& uvw)
{
  const Points& targets = target.points;
  const Refinement refinement = named_refinement(options.refinement);
  Result result = std::visit([&](const auto& solver)
  {
    const auto np
      = params::boundary_mode(named_boundary_mode(options.boundary))
        .do_refine(refinement.do_refine)
        .refinement_mode(refinement.mode)
        .do_slide_boundary(options.do_slide || named_others(options.others) == Others::SLIDE)
        .vertex_is_constrained_map(CGAL::make_property_map(target.is_constrained))
        .energy(named_energy(options.energy))
        .use_regular_references(options.do_improve)
        .use_volume_weights(options.use_volume_weights)
        .energy_tolerance(options.energy_tolerance)
        .maximal_angle_distortion(options.maximal_angle_distortion)
        .minimize_maximal_angle_distortion(options.minimize_maximal_angle_distortion)
        .solver_traits(solver)
        .number_of_iterations(static_cast<std::size_t>(options.number_of_iterations))
        .visitor(std::ref(progress));
    const auto parameterize_from = [&](const auto& np)
    { return CGAL::stretch_minimizing_volume_parameterization<Concurrency_tag>(mesh, targets, uvw, np); };
    return initial.empty() ? parameterize_from(np) : parameterize_from(np.initial_map(CGAL::make_property_map(initial)));
  }, named_solver(options.solver));
  // vertices without a cell keep their points, or take the prescribed ones
  for(std::size_t v = 0; v < uvw.size(); ++v)
    if(std::isnan(uvw[v][0]))
      uvw[v] = std::isnan(targets[v][0]) ? mesh.points[v] : targets[v];
  result.message = with_names_of_options(result.message);
  if(result.status == VMP::ERROR_INVERTED_TARGET_BOUNDARY && !options.are_displacements && !options.target.empty())
    result.message += " If TARGET has displacements, --displacements tells this.";
  if(result.status == VMP::ERROR_INVERTED_SOURCE_CELL)
    result.message += " " + advice_to_improve + ".";
  if(result.status == VMP::ERROR_PRESCRIBED_CELL_INVERTED && !refinement.do_refine
     && result.message.find("No refinement helps") == std::string::npos)
    result.message += " With --refine, such cells are split.";
  if(!result.has_valid_map && !target.inside.empty() && result.status != VMP::ERROR_INTERRUPTED)
    result.message += " Targets of vertices inside are asked for, too; --inside free does without.";
  if(result.status == VMP::ERROR_INTERRUPTED)
    result.message = std::string(progress.reason()) + (result.has_valid_map
      ? " The map is valid, but the energy is not minimal yet." : " There is no map without inverted cells yet.");
  return result;
}

// Finds the map to the targets, after all bridges are split if this is asked for.
inline Mapped_mesh with_map(Mapped_mesh mapped, const Options& options, Progress_line& progress)
{
  if(named_refinement(options.refinement).splits_all_bridges)
  {
    const std::size_t number_of_points = mapped.mesh.points.size();
    VMP::make_parameterizable(
      mapped.mesh,
      params::vertex_is_constrained_map(CGAL::make_property_map(mapped.target.is_constrained)).visitor(std::ref(progress)));
    extend_to_new_points(number_of_points, mapped);
  }
  progress.begin("numbering cells and vertices, solving for a start");
  mapped.result = naming(options.source, [&]
  { return parameterize(mapped.mesh, mapped.target, mapped.initial, options, progress, mapped.uvw); });
  mapped.result.number_of_added_vertices += mapped.number_of_new_points;
  return mapped;
}

// Finds the targets on the polycube of a boundary that is not refined. Nothing if there are none.
inline std::optional<Mapped_mesh> with_targets_without_splits(const Mapped_mesh& given, const Options& options,
                                                              const Landmarks& landmarks, Progress_line& progress)
{
  try { return with_targets_on_domain(given, options, false, landmarks, progress); }
  catch(const Boundary_error&) {}
  catch(const Interruption&) {}
  return std::nullopt;
}

// Gives each vertex of the boundary vertices of its own inside.
inline Mapped_mesh with_edges_split_at_boundary(Mapped_mesh mapped)
{
  const std::size_t number_of_points = mapped.mesh.points.size();
  VMP::internal::Body_3 body = VMP::internal::body_of(std::move(mapped.mesh));
  VMP::internal::split_edges_at_boundary_3(body);
  mapped.mesh = std::move(body.soup);
  extend_to_new_points(number_of_points, mapped);
  return mapped;
}

inline Mapped_mesh mapped_to_domain(Mapped_mesh given, const Options& options, const Landmarks& landmarks, Progress_line& progress)
{
  const bool may_split = options.domain == "polycube" && named_refinement(options.refinement).do_refine;
  if(!may_split)
    return with_map(with_targets_on_domain(std::move(given), options, false, landmarks, progress), options, progress);
  Mapped_mesh with_targets = with_targets_on_domain(given, options, true, landmarks, progress);
  if(with_targets.number_of_new_points == 0)
    return with_map(std::move(with_targets), options, progress);
  Options held = options;
  if(named_boundary_mode(options.boundary) == VMP::Boundary_mode::AUTO)
    held.boundary = "fixed";
  const auto map_held = [&](const Mapped_mesh& mesh) { return with_map(mesh, held, progress); };
  const auto map = [&](const Mapped_mesh& mesh) { return with_map(mesh, options, progress); };
  const auto without_splits = [&] { return with_targets_without_splits(given, options, landmarks, progress); };
  return mapped_with_splits(with_targets, map_held, map, with_edges_split_at_boundary, without_splits, progress);
}

inline Mapped_mesh mapped_to_targets(Mapped_mesh given, const Options& options, const Landmarks& landmarks,
                                     Progress_line& progress)
{
  if(options.domain.empty())
    return with_map(std::move(given), options, progress);
  Mapped_mesh mapped = mapped_to_domain(std::move(given), options, landmarks, progress);
  if(const std::string note = note_of_features_given_up(mapped.polycube); !note.empty() && !options.is_quiet)
  {
    progress.show("");
    std::cerr << "note: " << options.source << ": " << note << std::endl;
  }
  return mapped;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MAPPED_TO_TARGETS_H
