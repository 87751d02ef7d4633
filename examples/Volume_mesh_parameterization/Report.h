// What the program tells of its result: on the console, as its exit status, and in a JSON file.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_REPORT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_REPORT_H

#include "Command_line.h"
#include "JSON_object.h"
#include "Output_file.h"

#include <CGAL/Volume_mesh_parameterization/Distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>

#include <sys/resource.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

enum Exit_code { SUCCESS = 0, BOUNDARY_MISSED = 1, BAD_INPUT = 2, NOT_FLIP_FREE = 3 };

// How a run of the program ended.
struct Outcome
{
  Exit_code exit_code;
  std::string status_code; // the name of the result's status, or of what was thrown
  CGAL::Volume_mesh_parameterization::Parameterization_result result;
  std::string remark = {};     // for the console
};

inline const char* error_code_name(const CGAL::Volume_mesh_parameterization::Error_code code)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  switch(code)
  {
    case VMP::OK: return "OK";
    case VMP::ERROR_NOT_CONVERGED: return "ERROR_NOT_CONVERGED";
    case VMP::ERROR_INTERRUPTED: return "ERROR_INTERRUPTED";
    case VMP::ERROR_ANGLE_BOUND_NOT_REACHED: return "ERROR_ANGLE_BOUND_NOT_REACHED";
    case VMP::ERROR_BOUNDARY_NOT_REACHED: return "ERROR_BOUNDARY_NOT_REACHED";
    case VMP::ERROR_NOT_FLIP_FREE: return "ERROR_NOT_FLIP_FREE";
    case VMP::ERROR_LINEAR_SOLVER_FAILED: return "ERROR_LINEAR_SOLVER_FAILED";
    case VMP::ERROR_EMPTY_COMPLEX: return "ERROR_EMPTY_COMPLEX";
    case VMP::ERROR_NON_FINITE_COORDINATE: return "ERROR_NON_FINITE_COORDINATE";
    case VMP::ERROR_SIZE_OUT_OF_RANGE: return "ERROR_SIZE_OUT_OF_RANGE";
    case VMP::ERROR_INVERTED_SOURCE_CELL: return "ERROR_INVERTED_SOURCE_CELL";
    case VMP::ERROR_MISSING_BOUNDARY_TARGET: return "ERROR_MISSING_BOUNDARY_TARGET";
    case VMP::ERROR_INVERTED_TARGET_BOUNDARY: return "ERROR_INVERTED_TARGET_BOUNDARY";
    case VMP::ERROR_PRESCRIBED_CELL_INVERTED: return "ERROR_PRESCRIBED_CELL_INVERTED";
    case VMP::ERROR_NON_MANIFOLD_BOUNDARY: return "ERROR_NON_MANIFOLD_BOUNDARY";
    case VMP::ERROR_SEVERAL_BOUNDARY_COMPONENTS: return "ERROR_SEVERAL_BOUNDARY_COMPONENTS";
    case VMP::ERROR_BOUNDARY_NOT_OF_GENUS_ZERO: return "ERROR_BOUNDARY_NOT_OF_GENUS_ZERO";
    case VMP::ERROR_BOUNDARY_TOO_COARSE: return "ERROR_BOUNDARY_TOO_COARSE";
    case VMP::ERROR_BOUNDARY_MAP_NOT_BIJECTIVE: return "ERROR_BOUNDARY_MAP_NOT_BIJECTIVE";
    case VMP::ERROR_OTHER_CONNECTIVITY: return "ERROR_OTHER_CONNECTIVITY";
    case VMP::ERROR_NO_POLYCUBE: return "ERROR_NO_POLYCUBE";
    case VMP::ERROR_INVALID_CORNERS: return "ERROR_INVALID_CORNERS";
    case VMP::ERROR_MIRRORED_CORNERS: return "ERROR_MIRRORED_CORNERS";
    case VMP::ERROR_SPACING_TOO_COARSE: return "ERROR_SPACING_TOO_COARSE";
    case VMP::ERROR_DOMAIN_NOT_AXIS_PARALLEL: return "ERROR_DOMAIN_NOT_AXIS_PARALLEL";
    case VMP::ERROR_INVERTED_HEXAHEDRON: return "ERROR_INVERTED_HEXAHEDRON";
  }
  return "";
}

inline void print(const CGAL::Volume_mesh_parameterization::Parameterization_result& result)
{
  const CGAL::Volume_mesh_parameterization::Distortion_3& d = result.distortion_at_source_volume;
  std::cout << result.number_of_cells << " cells, " << result.number_of_vertices << " vertices, "
            << result.number_of_boundary_vertices << " on the boundary\n"
            << result.number_of_iterations << " iterations in " << result.seconds_total << " s, "
            << result.number_of_inverted_cells << " inverted cells, energy " << result.energy << "\n"
            << "distortion of angles:  mean " << d.angle_mean << ", max " << d.angle_max << "\n"
            << "distortion of volumes: mean " << d.volume_mean << ", max " << d.volume_max
            << " (of the map scaled to the volume of the source)\n";
}

inline std::size_t peak_memory_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * static_cast<std::size_t>(usage.ru_maxrss);
}

inline JSON_object json(const CGAL::Volume_mesh_parameterization::Distortion_3& d)
{
  return JSON_object().add("angle_mean", d.angle_mean).add("angle_max", d.angle_max)
                      .add("volume_mean", d.volume_mean).add("volume_max", d.volume_max);
}

inline JSON_object json(const std::vector<CGAL::Volume_mesh_parameterization::Parameterization_step>& steps)
{
  std::vector<double> energy, inverted_cells, seconds;
  for(const CGAL::Volume_mesh_parameterization::Parameterization_step& step : steps)
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
                      .add("boundary", options.boundary).add("refine", options.do_refine)
                      .add("slide", options.do_slide).add("energy", options.energy)
                      .add("volume_weights", options.use_volume_weights)
                      .add("max_angle_distortion", options.maximal_angle_distortion)
                      .add("solver", options.solver)
                      .add("threads", static_cast<std::size_t>(options.number_of_threads))
                      .add("max_iterations", static_cast<std::size_t>(options.number_of_iterations))
                      .add("time_limit", options.time_limit);
}

// Of bad input there is nothing to tell but the message and the options.
inline void write_report(const Options& options, const Outcome& outcome,
                         const std::vector<CGAL::Volume_mesh_parameterization::Parameterization_step>& steps)
{
  const CGAL::Volume_mesh_parameterization::Parameterization_result& result = outcome.result;
  JSON_object report;
  report.add("status", result.message)
        .add("status_code", outcome.status_code)
        .add("has_valid_map", result.has_valid_map)
        .add("version", VOLUME_MESH_PARAMETERIZATION_VERSION)
        .add("options", json(options));
  if(outcome.exit_code != BAD_INPUT)
    report.add("vertices", result.number_of_vertices)
          .add("cells", result.number_of_cells)
          .add("boundary_vertices", result.number_of_boundary_vertices)
          .add("added_vertices", result.number_of_added_vertices)
          .add("sliding_vertices", result.number_of_sliding_vertices)
          .add("inverted_cells", result.number_of_inverted_cells)
          .add("boundary_residual", result.boundary_residual)
          .add("iterations", result.number_of_iterations)
          .add("untangling_iterations", result.number_of_untangling_iterations)
          .add("seconds_total", result.seconds_total)
          .add("seconds_to_flip_free", result.seconds_to_flip_free)
          .add("seconds_numbering", result.seconds_numbering)
          .add("seconds_start", result.seconds_start)
          .add("seconds_untangling", result.seconds_untangling)
          .add("seconds_minimization", result.seconds_minimization)
          .add("seconds_check", result.seconds_check)
          .add("energy_value", result.energy)
          .add("steps", json(steps))
          .add("distortion", json(result.distortion))
          .add("distortion_at_source_volume", json(result.distortion_at_source_volume))
          .add("peak_memory_bytes", peak_memory_bytes());

  Output_file file(options.report);
  file.stream() << report.text() << "\n";
  file.commit();
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_REPORT_H
