// The map of a mesh to the targets of its vertices, or to a domain.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MAPPED_TO_TARGETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MAPPED_TO_TARGETS_H

#include "Command_line.h"
#include "Hexahedra_file.h"
#include "Named_choices.h"
#include "Progress_line.h"
#include "Report.h"
#include "Target_points.h"
#include "boundary_targets_of.h"
#include "notes_on_hexahedra.h"
#include "read_source.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>

#include <CGAL/Bbox_3.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

namespace params = CGAL::parameters;

using Result = VMP::Parameterization_result;

// Mesh with targets of its vertices, and the map to them.
struct Mapped_mesh
{
  VMP::Tetrahedron_soup_3 mesh;
  Target_points target; // none on a domain
  Points initial;       // images to start from, or none
  PM::Polycube_result polycube = {};
  VMP::Tetrahedron_soup_3 surface = {}; // that the mesh is fitted to; has no facets for other targets
  std::optional<VMP::Surface_fit_3> surface_fit = {}; // of a map that has slid there
  Points uvw = {};
  Result result = {};
};

// Returns a property map of the vertices that are at their targets. There are none on a domain.
inline auto is_at_target_map(const Target_points& target)
{
  return boost::make_function_property_map<std::size_t>([&](const std::size_t v)
  { return v < target.conditions.size() && target.conditions[v].kind() == Condition::AT_TARGET; });
}

// Splits all bridges. The new vertices have no targets.
inline std::size_t split_bridges(Mapped_mesh& mapped, Progress_line& progress)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::size_t result = VMP::make_parameterizable(
    mapped.mesh, params::visitor(std::ref(progress)).vertex_is_constrained_map(is_at_target_map(mapped.target)));
  const std::size_t n = mapped.mesh.points.size();
  mapped.target.points.resize(n, { nan, nan, nan });
  mapped.target.conditions.resize(n);
  if(!mapped.initial.empty())
    mapped.initial.resize(n, { nan, nan, nan });
  return result;
}

// Returns the condition of a point on sharp edges of a surface: it slides along a curve, or stays where curves meet.
inline std::optional<VMP::Vertex_condition_3> condition_on_features(const VMP::Triangulated_surface_3& surface,
                                                                    const std::array<double, 3>& p)
{
  constexpr double rounding = 1e-13; // relative to the coordinates
  std::optional<VMP::Vertex_condition_3> result;
  for(std::size_t i = 0; i < surface.number_of_curves(); ++i)
  {
    const auto [q, direction] = surface.curve(i).nearest_point(p);
    if(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]) <= rounding * std::hypot(p[0], p[1], p[2]))
      result = result ? VMP::Vertex_condition_3::at_target() : VMP::Vertex_condition_3::on_curve(surface.curve(i));
  }
  return result;
}

// Lets the boundary of a map slide on the surface that it has been fitted to. The source remains as it is. The
// report needs the measure of the result, which is not taken if facets are turned over or intersect each other.
template <typename NamedParameters>
Result slid_on_surface(Mapped_mesh& mapped, const Result& fitted, const Landmarks& landmarks, const NamedParameters& np)
{
  const VMP::Triangulated_surface_3 surface(mapped.surface.points, mapped.surface.facets);
  const VMP::Any_surface_3 whole = surface;
  std::vector<VMP::Vertex_condition_3> conditions(mapped.mesh.points.size());
  for(const std::size_t v : VMP::boundary_vertices(mapped.mesh.points, mapped.mesh.cells))
    conditions[v] = condition_on_features(surface, mapped.uvw[v]).value_or(VMP::Vertex_condition_3::on_surface(whole));
  Points uvw;
  Result result = CGAL::stretch_minimizing_volume_parameterization<Concurrency_tag>(
    mapped.mesh, mapped.uvw, uvw, np.refinement_mode(VMP::Refinement_mode::NONE)
      .vertex_condition_map(CGAL::make_property_map(conditions)).initial_map(CGAL::make_property_map(mapped.uvw)));
  if(!result.has_valid_map || result.boundary_residual > 0)
    return fitted;
  const VMP::Surface_fit_3 fit = VMP::measure_surface_fit(uvw, mapped.mesh.cells, mapped.surface.points, mapped.surface.facets,
                                                           landmarks);
  if(fit.number_of_turned_facets > 0 || fit.number_of_intersections > 0)
  {
    result = fitted;
    result.message += " The boundary does not slide, because facets would be turned over or intersect each other.";
    return result;
  }
  mapped.uvw = std::move(uvw);
  mapped.surface_fit = fit;
  result.number_of_added_vertices = fitted.number_of_added_vertices;
  result.number_of_added_boundary_vertices = fitted.number_of_added_boundary_vertices;
  result.seconds_boundary = fitted.seconds_boundary;
  result.seconds_total += fitted.seconds_total;
  return result;
}

inline Result parameterize(Mapped_mesh& mapped, const Options& options, const Landmarks& landmarks, Progress_line& progress)
{
  const Refinement refinement = named_refinement(options.refinement);
  return std::visit([&](const auto& solver)
  {
    const auto np
      = params::boundary_mode(named_boundary_mode(options.boundary))
        .refinement_mode(refinement.mode)
        .energy(named_energy(options.energy))
        .use_regular_references(options.do_improve)
        .use_volume_weights(options.use_volume_weights)
        .energy_tolerance(options.energy_tolerance)
        .reference_scale(named_reference_scale(options.reference_scale, mapped.target.is_boundary_free))
        .maximum_angle_distortion(options.minimize_maximum_angle_distortion ? VMP::least_angle_distortion
                                                                            : options.maximum_angle_distortion)
        .solver_traits(solver)
        .number_of_iterations(static_cast<std::size_t>(options.number_of_iterations))
        .maximum_running_time(progress.seconds_left())
        .visitor(std::ref(progress));
    const auto map_to = [&](const auto& np)
    {
      return CGAL::stretch_minimizing_volume_parameterization<Concurrency_tag>(mapped.mesh, mapped.target.points, mapped.uvw, np);
    };
    const auto map = [&](const auto& np)
    {
      if(mapped.target.is_boundary_free)
        return map_to(np.vertex_condition_map(CGAL::make_property_map(mapped.target.conditions)));
      const bool is_fit = is_surface_domain(options.domain);
      const auto sliding = np.do_slide_boundary((options.do_slide && !is_fit) || named_others(options.others) == Others::SLIDE);
      if(options.domain.empty())
        return map_to(sliding.vertex_is_constrained_map(is_at_target_map(mapped.target)));
      const Polycube polycube(Hexahedra_file(options.hexahedra).spacing(), named_polycube_axes(options.polycube_axes),
                              &mapped.polycube);
      const Result result = std::visit([&](const auto& boundary)
      {
        return CGAL::stretch_minimizing_volume_parameterization<Concurrency_tag>(mapped.mesh, mapped.uvw,
                                                                                 sliding.boundary_parameterizer(boundary));
      }, is_fit ? surface_fit(mapped.surface, landmarks, mapped.mesh.points, options.tolerance)
                : named_boundary_parameterizer(options.domain, polycube, landmarks));
      return is_fit && options.do_slide && result.has_valid_map ? slid_on_surface(mapped, result, landmarks, np) : result;
    };
    return mapped.initial.empty() ? map(np) : map(np.initial_map(CGAL::make_property_map(mapped.initial)));
  }, named_solver(options.solver));
}

// Advises on a target without positive volume: a mirror image of a body encloses a large negative one, displacements hardly any.
inline std::string advice_for_inverted_target(const Mapped_mesh& mapped)
{
  constexpr double small_part = 0.01; // a guess
  Points images = mapped.mesh.points;
  for(std::size_t v = 0; v < mapped.target.points.size(); ++v) // refinement adds others
    if(has_target(mapped.target.points, v))
      images[v] = mapped.target.points[v];
  return volume(mapped.mesh, images) < -small_part * volume(mapped.mesh, mapped.mesh.points)
    ? " TARGET is a mirror image of SOURCE. Reverse the sign of one coordinate in one of them."
    : " If TARGET contains displacements, use --displacements.";
}

// Advises on a body whose boundary has no map that can be used, or whose map does not meet it.
inline std::string advice_for_body(const Options& options, const VMP::Error_code status)
{
  const bool may_have_voids = !options.do_fill_voids && extension_of(options.source) != ".geo";
  switch(status)
  {
    case VMP::ERROR_NON_MANIFOLD_BOUNDARY:
      return " Cells of another size (--cells) may not touch there.";
    case VMP::ERROR_SEVERAL_BOUNDARY_COMPONENTS:
      return std::string(" If it is a void, ") + (may_have_voids ? "--fill-voids fills it." : "fill it in a CAD program.")
        + (options.domain == "polycube" ? " --cells with half of its size helps, too, if cells are larger." : "");
    case VMP::ERROR_NOT_FLIP_FREE:
    case VMP::ERROR_BOUNDARY_NOT_REACHED:
      return std::string(" Cells of another size (--cells) may have a map")
        + (may_have_voids ? ", and so may the body without the voids inside, if it has some: --fill-voids fills them." : ".");
    default:
      return "";
  }
}

// Says in the words of the program why a map is not as it was asked for.
inline void complete_message(const Mapped_mesh& mapped, const Options& options, Result& result)
{
  const bool is_boundary_mapped = options.domain.empty() || result.number_of_cells > 0;
  if(!is_boundary_mapped && result.status != VMP::ERROR_INTERRUPTED)
    result.message = message_of_domain(options.domain, result.status, result.message, mapped.mesh)
      + (result.status == VMP::ERROR_BOUNDARY_TOO_COARSE ? advice_to_refine(options.source) : "");
  if(!options.domain.empty()) // the boundary is prescribed by the program
  {
    boost::replace_all(result.message, " Prescribe a boundary nearer to the source there.", "");
    boost::replace_all(result.message, ", or prescribe a boundary nearer to the source there.", ".");
    if(is_body_name(options.source))
      result.message += advice_for_body(options, result.status);
  }
  result.message = with_names_of_options(result.message);
  if(options.do_improve) // which has no targets
    boost::replace_all(result.message, "Move one of its targets off the line.",
                       options.do_leave_out_flat_cells
                         ? "Flip an edge of this facet, or move one of the vertices off the line; or mesh the body anew."
                         : "--leave-out-flat-cells leaves out flat cells at the boundary that it does not need.");
  if(result.status == VMP::ERROR_INVERTED_TARGET_BOUNDARY && !options.are_displacements && !options.target.empty())
    result.message += advice_for_inverted_target(mapped);
  if(result.status == VMP::ERROR_INVERTED_SOURCE_CELL)
    result.message += " " + advice_to_improve + ".";
  if(result.status == VMP::ERROR_PRESCRIBED_CELL_INVERTED
     && named_refinement(options.refinement).mode == VMP::Refinement_mode::NONE
     && result.message.find("No refinement helps") == std::string::npos)
    result.message += " --refine splits such cells.";
  if((result.status == VMP::ERROR_NOT_FLIP_FREE || result.status == VMP::ERROR_BOUNDARY_NOT_REACHED)
     && named_others(options.others) == Others::STAY)
    result.message += " --others slide lets vertices without a target move in the walls of the source, and --conditions FILE says "
                      "what each part of the boundary may do.";
  if(!result.has_valid_map && !mapped.target.inside.empty() && result.status != VMP::ERROR_INTERRUPTED)
    result.message += " Interior vertices have targets, too; --inside free ignores them.";
  if(result.status == VMP::ERROR_INTERRUPTED)
    result.message = std::string(Progress_line::reason())
      + (result.has_valid_map ? std::isfinite(options.tolerance)
           ? " The map is valid, but may be farther from its target than --tolerance, or the energy is not minimal yet."
           : " The map is valid, but the energy is not minimal yet."
         : is_boundary_mapped ? " There is no map without inverted cells yet." : " There is no map yet.");
}

// Says how many sharp edges a polycube gives up, and where the longest line of them is; nothing if there are none.
inline std::string note_of_features_given_up(const PM::Polycube_result& polycube)
{
  if(polycube.features_given_up.empty())
    return "";
  const std::size_t lines = polycube.features_given_up.size();
  const auto& longest = polycube.features_given_up.front();
  const auto& [x, y, z] = longest[longest.size() / 2];
  std::ostringstream result;
  result << polycube.number_of_edges_given_up() << " of " << polycube.number_of_sharp_edges
         << " sharp edges follow no axis of the polycube, in " << counted(lines, "line", "lines")
         << ". The longest line goes through (" << x << ", " << y << ", " << z << ")";
  return result.str();
}

// Returns notes on landmarks, and on parts of a surface, if they are far from the boundary compared with the size of the surface.
inline std::array<std::string, 2> notes_on_fit(const VMP::Tetrahedron_soup_3& surface, const VMP::Surface_fit_3& fit)
{
  constexpr double large_part = 0.05; // a guess
  CGAL::Bbox_3 box;
  for(const auto& [x, y, z] : surface.points)
    box += CGAL::Bbox_3(x, y, z, x, y, z);
  const auto note = [&](const std::string& what, const double distance, const std::string& advice)
  {
    const double part = distance / std::hypot(box.x_span(), box.y_span(), box.z_span());
    std::ostringstream result;
    if(part > large_part)
      result << what << distance << ", " << part << " times the diagonal of the surface. " << advice;
    return result.str();
  };
  return { note("A landmark is away from its point by ", fit.largest_distance_of_landmarks,
                "Its points may be exchanged with others. Check the file, or add landmarks"),
           note("A part of the surface is away from the boundary by ", fit.largest_distance_from_surface,
                "The boundary has no vertices there. --tolerance DISTANCE and --refine add some") };
}

inline Mapped_mesh mapped_to_targets(Mapped_mesh mapped, const Options& options, const Landmarks& landmarks,
                                     Progress_line& progress)
{
  naming(options.source, [&] { check_spacing(options, mapped.mesh); });
  const bool splits_all_bridges = named_refinement(options.refinement).splits_all_bridges;
  const std::size_t number_of_splits = splits_all_bridges ? split_bridges(mapped, progress) : 0;
  progress.begin(options.domain.empty() ? "numbering cells and vertices, solving for a start"
                                        : "mapping the boundary to " + options.domain);
  if(is_surface_domain(options.domain))
  {
    mapped.surface = read_closed_surface(options.domain, options.joining_distance, progress);
    for(const std::string& note : mapped.surface.notes)
      if(!options.is_quiet)
        std::cerr << "note: " << options.domain << ": " << note << std::endl;
  }
  Result& result = mapped.result;
  result = naming(options.source, [&] { return parameterize(mapped, options, landmarks, progress); });
  result.number_of_added_vertices += number_of_splits;
  // vertices without a cell keep their points, or take the prescribed ones
  for(std::size_t v = 0; v < mapped.uvw.size(); ++v)
    if(std::isnan(mapped.uvw[v][0]))
      mapped.uvw[v] = v < mapped.target.points.size() && has_target(mapped.target.points, v) ? mapped.target.points[v]
                                                                                             : mapped.mesh.points[v];
  complete_message(mapped, options, result);
  if(const std::string note = note_of_features_given_up(mapped.polycube); !note.empty() && !options.is_quiet)
  {
    progress.show("");
    std::cerr << "note: " << options.source << ": " << note << std::endl;
  }
  return mapped;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MAPPED_TO_TARGETS_H
