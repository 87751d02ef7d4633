// What the programs that map CGAL's elephant share.
#ifndef ELEPHANT_H
#define ELEPHANT_H

#include "mesh_surface.h"

#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

// Prints the result, writes the map to a file if it is valid, and returns the exit code of the program.
template <typename VertexUVWMap>
int report(const C3t3& c3t3, const VertexUVWMap uvw_map,
           const CGAL::Volume_mesh_parameterization::Parameterization_result& result, const std::string& filename)
{
  std::cout << result.message << "\n"
            << result.number_of_cells << " cells, " << result.number_of_inverted_cells << " of them inverted\n"
            << "distortion of angles:  mean " << result.distortion.angle_mean
            << ", max " << result.distortion.angle_max << "\n"
            << "distortion of volumes: mean " << result.distortion_at_source_volume.volume_mean
            << ", max " << result.distortion_at_source_volume.volume_max
            << " (of the map scaled to the volume of the source)" << std::endl;
  if(!result.has_valid_map)
    return EXIT_FAILURE;

  std::ofstream out(filename, std::ios::binary);
  CGAL::Volume_mesh_parameterization::IO::write_VTU(out, c3t3, uvw_map);
  out.close();
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif // ELEPHANT_H
