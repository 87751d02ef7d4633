// Report of a result that both programs make: as exit status, on the console and in JSON.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_RESULT_REPORT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_RESULT_REPORT_H

#include "JSON_object.h"

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#include <iostream>
#include <stdexcept>

namespace VMP = CGAL::Volume_mesh_parameterization;

enum Exit_code { SUCCESS = 0, NOT_AS_ASKED = 1, BAD_INPUT = 2, NOT_FLIP_FREE = 3 };

inline Exit_code exit_code(const VMP::Parameterization_result& result)
{
  if(result.has_valid_map)
    return result.boundary_residual == 0 && result.status != VMP::ERROR_ANGLE_BOUND_NOT_REACHED
        && result.status != VMP::ERROR_LINEAR_SOLVER_FAILED ? SUCCESS : NOT_AS_ASKED;
  switch(result.status)
  {
    case VMP::ERROR_NOT_FLIP_FREE:
    case VMP::ERROR_INTERRUPTED:
    case VMP::ERROR_LINEAR_SOLVER_FAILED: return NOT_FLIP_FREE;
    default: return BAD_INPUT;
  }
}

// Throws if the standard output cannot be written, for instance to a device that is full.
inline void flush_standard_output()
{
  if(!std::cout.flush())
    throw std::runtime_error("the standard output cannot be written");
}

inline const char* error_code_name(const VMP::Error_code code)
{
  switch(code)
  {
    case VMP::OK: return "OK";
    case VMP::OK_WITHIN_TOLERANCE: return "OK_WITHIN_TOLERANCE";
    case VMP::ERROR_NOT_CONVERGED: return "ERROR_NOT_CONVERGED";
    case VMP::ERROR_INTERRUPTED: return "ERROR_INTERRUPTED";
    case VMP::ERROR_ANGLE_BOUND_NOT_REACHED: return "ERROR_ANGLE_BOUND_NOT_REACHED";
    case VMP::ERROR_BOUNDARY_NOT_REACHED: return "ERROR_BOUNDARY_NOT_REACHED";
    case VMP::ERROR_NOT_FLIP_FREE: return "ERROR_NOT_FLIP_FREE";
    case VMP::ERROR_INVERTED_BY_ROUNDING: return "ERROR_INVERTED_BY_ROUNDING";
    case VMP::ERROR_LINEAR_SOLVER_FAILED: return "ERROR_LINEAR_SOLVER_FAILED";
    case VMP::ERROR_EMPTY_COMPLEX: return "ERROR_EMPTY_COMPLEX";
    case VMP::ERROR_NON_FINITE_COORDINATE: return "ERROR_NON_FINITE_COORDINATE";
    case VMP::ERROR_SIZE_OUT_OF_RANGE: return "ERROR_SIZE_OUT_OF_RANGE";
    case VMP::ERROR_INVERTED_SOURCE_CELL: return "ERROR_INVERTED_SOURCE_CELL";
    case VMP::ERROR_MISSING_BOUNDARY_TARGET: return "ERROR_MISSING_BOUNDARY_TARGET";
    case VMP::ERROR_INVERTED_TARGET_BOUNDARY: return "ERROR_INVERTED_TARGET_BOUNDARY";
    case VMP::ERROR_PRESCRIBED_CELL_INVERTED: return "ERROR_PRESCRIBED_CELL_INVERTED";
    case VMP::ERROR_ENERGY_WITHOUT_MINIMUM: return "ERROR_ENERGY_WITHOUT_MINIMUM";
    case VMP::ERROR_NON_MANIFOLD_BOUNDARY: return "ERROR_NON_MANIFOLD_BOUNDARY";
    case VMP::ERROR_SEVERAL_BOUNDARY_COMPONENTS: return "ERROR_SEVERAL_BOUNDARY_COMPONENTS";
    case VMP::ERROR_BOUNDARY_NOT_OF_GENUS_ZERO: return "ERROR_BOUNDARY_NOT_OF_GENUS_ZERO";
    case VMP::ERROR_BOUNDARY_TOO_COARSE: return "ERROR_BOUNDARY_TOO_COARSE";
    case VMP::ERROR_BOUNDARY_MAP_NOT_BIJECTIVE: return "ERROR_BOUNDARY_MAP_NOT_BIJECTIVE";
    case VMP::ERROR_OTHER_CONNECTIVITY: return "ERROR_OTHER_CONNECTIVITY";
    case VMP::ERROR_INVALID_CORNERS: return "ERROR_INVALID_CORNERS";
    case VMP::ERROR_MIRRORED_CORNERS: return "ERROR_MIRRORED_CORNERS";
    case VMP::ERROR_INVALID_LANDMARK: return "ERROR_INVALID_LANDMARK";
    case VMP::ERROR_TARGET_NOT_A_SPHERE: return "ERROR_TARGET_NOT_A_SPHERE";
    case VMP::ERROR_BOUNDARY_NOT_FITTED: return "ERROR_BOUNDARY_NOT_FITTED";
    case VMP::ERROR_FIT_TOLERANCE_NOT_REACHED: return "ERROR_FIT_TOLERANCE_NOT_REACHED";
    case VMP::ERROR_NO_POLYCUBE: return "ERROR_NO_POLYCUBE";
    case VMP::ERROR_SPACING_TOO_COARSE: return "ERROR_SPACING_TOO_COARSE";
    case VMP::ERROR_DOMAIN_NOT_AXIS_PARALLEL: return "ERROR_DOMAIN_NOT_AXIS_PARALLEL";
    case VMP::ERROR_INVERTED_HEXAHEDRON: return "ERROR_INVERTED_HEXAHEDRON";
    case VMP::ERROR_POOR_HEXAHEDRON: return "ERROR_POOR_HEXAHEDRON";
    case VMP::ERROR_INCOMPLETE_HEXAHEDRA: return "ERROR_INCOMPLETE_HEXAHEDRA";
  }
  return "";
}

inline void print(const VMP::Parameterization_result& result)
{
  const VMP::Distortion_3& d = result.distortion_at_source_volume;
  std::cout << result.number_of_cells << " cells, " << result.number_of_vertices << " vertices, "
            << result.number_of_boundary_vertices << " on the boundary\n"
            << result.number_of_iterations << " iterations in " << result.seconds_total << " s, "
            << result.number_of_inverted_cells << " inverted cells, energy " << result.energy << " at scale "
            << result.reference_scale << "\n"
            << "distortion of angles:  mean " << d.angle_mean << ", max " << d.angle_max << "\n"
            << "distortion of volumes: mean " << d.volume_mean << ", max " << d.volume_max
            << " (of the map scaled to the volume of the source)\n";
}

inline JSON_object json(const VMP::Distortion_3& d)
{
  return JSON_object().add("angle_mean", d.angle_mean).add("angle_max", d.angle_max)
                      .add("volume_mean", d.volume_mean).add("volume_max", d.volume_max);
}

inline void add(JSON_object& report, const VMP::Parameterization_result& result)
{
  report.add("vertices", result.number_of_vertices)
        .add("cells", result.number_of_cells)
        .add("boundary_vertices", result.number_of_boundary_vertices)
        .add("added_vertices", result.number_of_added_vertices)
        .add("added_boundary_vertices", result.number_of_added_boundary_vertices)
        .add("sliding_vertices", result.number_of_sliding_vertices)
        .add("inverted_cells", result.number_of_inverted_cells)
        .add("boundary_residual", result.boundary_residual)
        .add("iterations", result.number_of_iterations)
        .add("untangling_iterations", result.number_of_untangling_iterations)
        .add("linear_solver_iterations", result.number_of_linear_solver_iterations)
        .add("untangling_method", result.untangling_method)
        .add("seconds_total", result.seconds_total)
        .add("seconds_to_flip_free", result.seconds_to_flip_free)
        .add("seconds_numbering", result.seconds_numbering)
        .add("seconds_start", result.seconds_start)
        .add("seconds_untangling", result.seconds_untangling)
        .add("seconds_minimization", result.seconds_minimization)
        .add("seconds_check", result.seconds_check)
        .add("energy_value", result.energy)
        .add("reference_scale", result.reference_scale)
        .add("distortion", json(result.distortion))
        .add("distortion_at_source_volume", json(result.distortion_at_source_volume))
        .add("boundary_distortion", result.boundary_distortion)
        .add("unavoidable_angle_distortion", result.unavoidable_angle_distortion)
        .add("missed_angle_distortion", result.missed_angle_distortion);
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_RESULT_REPORT_H
