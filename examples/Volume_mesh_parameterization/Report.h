// What parameterize_mesh_file and parameterize_mesh_file_mpi tell: exit codes, progress and report.
#ifndef REPORT_H
#define REPORT_H

#include "JSON_object.h"

#include <CGAL/Volume_mesh_parameterization/Distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>

#include <sys/resource.h>

#include <cstddef>
#include <iostream>

using Result = CGAL::Volume_mesh_parameterization::Parameterization_result;

enum Exit_code { SUCCESS = 0, BOUNDARY_MISSED = 1, BAD_INPUT = 2, NOT_FLIP_FREE = 3 };

// Keeps one line of a terminal up to date.
struct Progress
{
  bool after_step(const CGAL::Volume_mesh_parameterization::Parameterization_step& step) const
  {
    if(is_shown)
      std::cerr << clear_line << "iteration " << step.iteration << ", " << step.number_of_inverted_cells
                << " inverted cells, energy " << step.energy << ", " << step.seconds << " s" << std::flush;
    return true;
  }

  void finish() const
  {
    if(is_shown)
      std::cerr << clear_line << std::flush;
  }

  static constexpr const char* clear_line = "\r\033[K";
  bool is_shown;
};

inline Exit_code exit_code(const Result& result)
{
  if(result.has_valid_map)
    return (result.boundary_residual == 0) ? SUCCESS : BOUNDARY_MISSED;
  switch(result.status)
  {
    case CGAL::Volume_mesh_parameterization::ERROR_NOT_FLIP_FREE:
    case CGAL::Volume_mesh_parameterization::ERROR_INTERRUPTED:
    case CGAL::Volume_mesh_parameterization::ERROR_LINEAR_SOLVER_FAILED: return NOT_FLIP_FREE;
    default: return BAD_INPUT;
  }
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

// Of bad input there is nothing to tell but the message.
inline JSON_object json(const Result& result, const Exit_code code)
{
  JSON_object report;
  report.add("status", result.message);
  if(code != BAD_INPUT)
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
          .add("distortion", json(result.distortion))
          .add("distortion_at_source_volume", json(result.distortion_at_source_volume));
  return report;
}

inline void print(const Result& result)
{
  const CGAL::Volume_mesh_parameterization::Distortion_3& d = result.distortion;
  std::cout << result.number_of_cells << " cells, " << result.number_of_vertices << " vertices, "
            << result.number_of_boundary_vertices << " on the boundary\n"
            << result.number_of_iterations << " iterations in " << result.seconds_total << " s, "
            << result.number_of_inverted_cells << " inverted cells, energy " << result.energy << "\n"
            << "distortion of angles:  mean " << d.angle_mean << ", max " << d.angle_max << "\n"
            << "distortion of volumes: mean " << d.volume_mean << ", max " << d.volume_max << "\n";
}

#endif // REPORT_H
