// Report of the result of the program: on the console, as its exit status, and in a JSON file.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_REPORT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_REPORT_H

#include "Command_line.h"
#include "Progress_line.h"
#include "Result_report.h"
#include "mend_source.h"

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>
#include <CGAL/Volume_mesh_parameterization/measure_surface_fit.h>

#include <boost/algorithm/string/replace.hpp>

#include <sys/resource.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

// Outcome of a run of the program.
struct Outcome
{
  Exit_code exit_code;
  std::string status_code; // the name of the result's status, or of what was thrown
  VMP::Parameterization_result result;
  std::vector<std::string> files = {};                          // names of files that are written
  double seconds_reading = 0, seconds_boundary = 0, seconds_hexahedra = 0;
  Repairs repairs = {};
  std::size_t number_of_targets_inside = 0, number_of_missed_targets = 0, number_of_free_targets = 0;
  // vertices of the boundary: free, in planes, on lines, at targets, on surfaces, on curves
  std::array<std::size_t, 6> numbers_of_conditions = {};
  VMP::Cell_quality_3 quality_of_source = {};
  std::optional<PM::Polycube_result> polycube = {};
  std::optional<VMP::Surface_fit_3> surface_fit = {};
  // if hexahedra were to be made, and there was a map to make them of
  std::optional<PM::Hexahedral_mesh_result> hexahedra = {};
};

// A sentence of the library with the options of the program in place of the parameters of the function.
inline std::string with_names_of_options(std::string message)
{
  boost::replace_all(message, "refinement_mode(Refinement_mode::HELPFUL), for a mesh that is not constant", "--refine");
  boost::replace_all(message, "refinement_mode(Refinement_mode::BOUNDARY)", "--refine");
  boost::replace_all(message, "Conjugate_gradient_solver_traits_3", "--solver cg");
  boost::replace_all(message, "CHOLMOD_solver_traits_3", "--solver cholmod");
  boost::replace_all(message, "Symmetric_Dirichlet_energy_3", "--energy symmetric_dirichlet");
  boost::replace_all(message, "vertices that slide", "vertices that slide (--slide)");
  return message;
}

inline std::size_t peak_memory_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * static_cast<std::size_t>(usage.ru_maxrss);
}

inline JSON_object json(const std::vector<VMP::Parameterization_step>& steps)
{
  std::vector<double> energy, inverted_cells, seconds;
  for(const VMP::Parameterization_step& step : steps)
  {
    energy.push_back(step.energy);
    inverted_cells.push_back(static_cast<double>(step.number_of_inverted_cells));
    seconds.push_back(step.seconds);
  }
  return JSON_object().add("energy", energy).add("inverted_cells", inverted_cells).add("seconds", seconds);
}

inline JSON_object json(const Options& options)
{
  return JSON_object().add("source", options.source).add("target", options.target).add("to", options.domain)
                      .add("polycube_axes", options.polycube_axes).add("improve", options.do_improve)
                      .add("cell_size", options.cell_size).add("tetrahedra", options.tetrahedra)
                      .add("features", options.features).add("regions", options.regions)
                      .add("landmarks", options.landmarks)
                      .add("tolerance", options.tolerance)
                      .add("merge_points", options.do_merge_points)
                      .add("fill_voids", options.do_fill_voids)
                      .add("leave_out_flat_cells", options.do_leave_out_flat_cells)
                      .add("separate", options.do_separate).add("displacements", options.are_displacements)
                      .add("staircases", options.are_staircases).add("others", options.others).add("inside", options.inside)
                      .add("conditions", options.conditions)
                      .add("initial", options.initial)
                      .add("boundary", options.boundary).add("refine", options.refinement)
                      .add("slide", options.do_slide).add("energy", options.energy)
                      .add("volume_weights", options.use_volume_weights)
                      .add("energy_tolerance", options.energy_tolerance)
                      .add("reference_scale", options.reference_scale)
                      .add("max_angle_distortion", options.maximum_angle_distortion)
                      .add("minimize_max_angle_distortion", options.minimize_maximum_angle_distortion)
                      .add("solver", options.solver)
                      .add("threads", number_of_threads(options))
                      .add("max_iterations", static_cast<std::size_t>(options.number_of_iterations))
                      .add("time_limit", options.time_limit);
}

inline void print(const PM::Hexahedral_mesh_result& result)
{
  std::cout << result.number_of_cells << " hexahedra, scaled Jacobian: minimal " << result.minimum_scaled_jacobian
            << ", mean " << result.mean_scaled_jacobian << "; largest distance of the boundaries " << result.boundary_distance
            << "\n";
  const bool has_subdomains = result.volumes.size() > 1;
  for(const PM::Subdomain_volumes& volumes : result.volumes)
  {
    if(has_subdomains)
      std::cout << "subdomain " << volumes.reference << ": ";
    std::cout << "volume " << volumes.of_tetrahedra << ", of hexahedra " << volumes.of_hexahedra << "\n";
  }
  if(has_subdomains)
    std::cout << "largest distance of interfaces " << result.interface_distance << "\n";
  const std::string success = VMP::get_error_message(VMP::OK);
  if(result.status == VMP::OK && result.message.size() > success.size())
    std::cout << result.message.substr(success.size() + 1) << "\n"; // sentences on interfaces
}

// The table of patches, a list for each column; centers and normals have three numbers for each patch.
inline JSON_object json(const std::vector<PM::Hexahedral_mesh_patch>& patches)
{
  std::vector<double> references, quadrangles, areas, centers, normals;
  for(const auto& patch : patches)
  {
    references.push_back(patch.reference);
    quadrangles.push_back(static_cast<double>(patch.number_of_quadrangles));
    areas.push_back(patch.area);
    centers.insert(centers.end(), patch.center.begin(), patch.center.end());
    normals.insert(normals.end(), patch.normal.begin(), patch.normal.end());
  }
  return JSON_object().add("references", references).add("quadrangles", quadrangles).add("areas", areas)
                      .add("centers", centers).add("normals", normals);
}

inline JSON_object json(const PM::Hexahedral_mesh_features& features)
{
  const auto coordinates = [](const std::vector<std::array<double, 3> >& points)
  {
    std::vector<double> result;
    for(const std::array<double, 3>& p : points)
      result.insert(result.end(), p.begin(), p.end());
    return result;
  };
  return JSON_object().add("corners", features.number_of_corners).add("corners_kept", features.number_of_corners_kept)
                      .add("corners_given_up", coordinates(features.corners_given_up))
                      .add("curves", features.number_of_curves).add("curves_kept", features.number_of_curves_kept)
                      .add("curves_given_up", coordinates(features.curves_given_up))
                      .add("patches", features.number_of_patches).add("patches_kept", features.number_of_patches_kept)
                      .add("patches_given_up", coordinates(features.patches_given_up));
}

inline JSON_object json(const PM::Hexahedral_mesh_result& result)
{
  std::vector<double> subdomains, of_tetrahedra, of_hexahedra;
  for(const PM::Subdomain_volumes& volumes : result.volumes)
  {
    subdomains.push_back(volumes.reference);
    of_tetrahedra.push_back(volumes.of_tetrahedra);
    of_hexahedra.push_back(volumes.of_hexahedra);
  }
  return JSON_object().add("status", result.message).add("status_code", error_code_name(result.status))
                      .add("vertices", result.number_of_vertices)
                      .add("boundary_vertices", result.number_of_boundary_vertices)
                      .add("cells", result.number_of_cells)
                      .add("inverted_corners", result.number_of_inverted_corners)
                      .add("inverted_hexahedra", result.number_of_inverted_hexahedra)
                      .add("padding", result.has_padding)
                      .add("minimum_scaled_jacobian", result.minimum_scaled_jacobian)
                      .add("mean_scaled_jacobian", result.mean_scaled_jacobian)
                      .add("boundary_distance", result.boundary_distance)
                      .add("subdomains", subdomains).add("volumes_of_tetrahedra", of_tetrahedra)
                      .add("volumes_of_hexahedra", of_hexahedra).add("interface_distance", result.interface_distance)
                      .add("patches", json(result.patches)).add("features", json(result.features));
}

inline std::string list(const std::vector<std::string>& names)
{
  std::string result;
  for(std::size_t i = 0; i < names.size(); ++i)
    result += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return result;
}

// Prints what the message of a map adds to success, and which output may lack its source.
inline void print_notes(const Options& options, const VMP::Parameterization_result& result)
{
  const std::string success = VMP::get_error_message(VMP::OK);
  if(result.message.size() > success.size())
    std::cerr << "note: " << options.source << ":" << result.message.substr(success.size()) << std::endl;
  if(result.number_of_added_vertices > 0 && !options.output.empty() && extension_of(options.output) != ".vtu"
     && options.refined_source.empty() && !options.do_improve)
    std::cerr << "note: " << options.output << ": refinement added "
              << counted(result.number_of_added_vertices, "vertex", "vertices")
              << ". --refined-source FILE writes the refined source." << std::endl;
}

// Prints the last lines.
inline void print_end(const Options& options, const Outcome& outcome)
{
  std::cout << "seconds: reading " << outcome.seconds_reading << ", boundary " << outcome.seconds_boundary << ", map "
            << outcome.result.seconds_total << ", hexahedra " << outcome.seconds_hexahedra << "\n";
  std::cout << (!outcome.files.empty() ? "Written: " + list(outcome.files)
                : options.output.empty() ? "No file is written; -o FILE writes the map" : "No file is written") << "\n";
  if(outcome.exit_code == SUCCESS && outcome.result.status == VMP::OK)
    std::cout << "Success\n";
}

// Adds the strategy that found a polycube, the costs of those of all strategies, the rotation of the source into the axes, by
// rows, and which sharp edges it gives up.
inline void add(JSON_object& report, const PM::Polycube_result& polycube)
{
  std::vector<double> rotation, points;
  for(const std::array<double, 3>& row : polycube.rotation)
    rotation.insert(rotation.end(), row.begin(), row.end());
  for(const auto& feature : polycube.features_given_up)
    points.insert(points.end(), feature[feature.size() / 2].begin(), feature[feature.size() / 2].end());
  std::map<std::string, double> least_costs;
  for(const auto& [strategy, cost] : polycube.candidates)
    least_costs.emplace(strategy, cost);
  JSON_object costs;
  for(const auto& [strategy, cost] : least_costs)
    costs.add(strategy.c_str(), cost);
  report.add("polycube_strategy", polycube.strategy)
        .add("polycube_costs", costs)
        .add("polycube_rotation", rotation)
        .add("sharp_edges", polycube.number_of_sharp_edges)
        .add("sharp_edges_given_up", polycube.number_of_edges_given_up())
        .add("features_given_up", points);
}

inline JSON_object json(const VMP::Surface_fit_3& fit)
{
  return JSON_object().add("distance_to_surface", fit.largest_distance_to_surface)
                      .add("distance_from_surface", fit.largest_distance_from_surface)
                      .add("distance_of_landmarks", fit.largest_distance_of_landmarks)
                      .add("turned_facets", fit.number_of_turned_facets).add("intersections", fit.number_of_intersections);
}

inline void print(const VMP::Surface_fit_3& fit)
{
  std::cout << "boundary: vertices are at most " << fit.largest_distance_to_surface << " away from the surface, and the surface "
            << fit.largest_distance_from_surface << " from the boundary; "
            << counted(fit.number_of_turned_facets, "facet is turned over, ", "facets are turned over, ")
            << counted(fit.number_of_intersections, "pair of facets intersects", "pairs of facets intersect") << "\n";
  if(fit.largest_distance_of_landmarks > 0)
    std::cout << "landmarks: at most " << fit.largest_distance_of_landmarks << " away from their points\n";
}

inline JSON_object json(const VMP::Cell_quality_3& quality)
{
  return JSON_object().add("minimum_dihedral_angle", quality.minimum_dihedral_angle)
                      .add("maximum_dihedral_angle", quality.maximum_dihedral_angle)
                      .add("minimum_scaled_jacobian", quality.minimum_scaled_jacobian)
                      .add("maximum_aspect_ratio", quality.maximum_aspect_ratio);
}

inline void print(const char* const when, const VMP::Cell_quality_3& quality)
{
  std::cout << "cells " << when << " the map: dihedral angles " << quality.minimum_dihedral_angle << " to "
            << quality.maximum_dihedral_angle << " degrees, least scaled Jacobian " << quality.minimum_scaled_jacobian << "\n";
}

// Prints the result of a map.
inline void print(const Options& options, const Outcome& outcome)
{
  print(outcome.result);
  if(options.do_improve)
    std::cout << counted(outcome.repairs.number_of_tangled_cells, "cell was", "cells were") << " inverted or flat\n";
  const auto inside = [](const std::size_t number)
  { return counted(number, "target of an interior vertex is", "targets of interior vertices are"); };
  if(outcome.number_of_targets_inside > 0)
    std::cout << inside(outcome.number_of_targets_inside) << " met\n";
  if(outcome.number_of_missed_targets > 0)
    std::cout << inside(outcome.number_of_missed_targets) << " missed\n";
  const auto& [free, in_planes, on_lines, at_targets, on_surfaces, on_curves] = outcome.numbers_of_conditions;
  if(free + in_planes + on_lines + on_surfaces + on_curves > 0)
  {
    std::cout << "boundary vertices: " << at_targets << " at targets, " << in_planes << " in planes, " << on_lines
              << " on lines, " << free << " free";
    if(on_surfaces + on_curves > 0)
      std::cout << ", " << on_surfaces << " on surfaces, " << on_curves << " on curves";
    std::cout << "\n";
    print("before", outcome.quality_of_source);
    print("after", outcome.result.quality);
  }
  if(outcome.result.boundary_crosses_itself)
    std::cout << "the image of the free boundary intersects itself\n";
  if(outcome.number_of_free_targets > 0)
    std::cout << inside(outcome.number_of_free_targets) << " ignored; --inside met prescribes them\n";
  if(outcome.surface_fit)
    print(*outcome.surface_fit);
  if(outcome.hexahedra && outcome.hexahedra->has_valid_mesh)
    print(*outcome.hexahedra);
}

// Without a map, bad input has nothing but its message and the options.
inline void write_report(const Options& options, const Outcome& outcome, Progress_line& progress)
{
  const VMP::Parameterization_result& result = outcome.result;
  JSON_object report;
  report.add("status", result.message)
        .add("status_code", outcome.status_code)
        .add("has_valid_map", result.has_valid_map)
        .add("version", VOLUME_MESH_PARAMETERIZATION_VERSION)
        .add("options", json(options));
  if(outcome.exit_code != BAD_INPUT || result.has_valid_map)
  {
    add(report, result);
    report.add("coinciding_points", outcome.repairs.number_of_coinciding_points)
          .add("merged_points", outcome.repairs.number_of_merged_points)
          .add("turned_cells", outcome.repairs.number_of_turned_cells)
          .add("tangled_cells", outcome.repairs.number_of_tangled_cells)
          .add("separated_vertices", outcome.repairs.number_of_separated_vertices)
          .add("targets_inside", outcome.number_of_targets_inside)
          .add("missed_targets", outcome.number_of_missed_targets)
          .add("free_targets", outcome.number_of_free_targets)
          .add("conditions", std::vector<double>(outcome.numbers_of_conditions.begin(), outcome.numbers_of_conditions.end()))
          .add("boundary_crosses_itself", result.boundary_crosses_itself)
          .add("quality_of_source", json(outcome.quality_of_source))
          .add("quality", json(result.quality))
          .add("seconds_reading", outcome.seconds_reading)
          .add("seconds_boundary", outcome.seconds_boundary)
          .add("seconds_hexahedra", outcome.seconds_hexahedra);
    if(outcome.polycube)
      add(report, *outcome.polycube);
    if(outcome.surface_fit)
      report.add("surface_fit", json(*outcome.surface_fit));
    if(outcome.hexahedra)
      report.add("hexahedra", json(*outcome.hexahedra));
    report.add("steps", json(progress.steps())).add("peak_memory_bytes", peak_memory_bytes());
  }

  VMP::IO::Output_file file(options.report);
  file.stream() << report.text() << "\n";
  file.commit(CGAL::parameters::visitor(std::ref(progress)));
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_REPORT_H
