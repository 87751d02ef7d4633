// Maps an elephant to the unit ball: without a boundary map, that is what the function does. It refines the mesh where
// the ball needs it.
#include "mesh_elephant.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <unordered_map>

namespace VMP = CGAL::Volume_mesh_parameterization;

int main(int argc, char* argv[])
try
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const std::string output_filename = (argc > 2) ? argv[2] : "elephant_to_ball.vtu";
  C3t3 c3t3 = mesh_elephant(filename);

  std::unordered_map<C3t3::Vertex_handle, Point_3> uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map);

  std::cout << result.message << "\n"
            << result.number_of_cells << " cells, " << result.number_of_inverted_cells << " of them inverted\n"
            << "distortion of angles:  mean " << result.distortion.angle_mean
            << ", max " << result.distortion.angle_max << "\n"
            << "distortion of volumes: mean " << result.distortion_at_source_volume.volume_mean
            << ", max " << result.distortion_at_source_volume.volume_max
            << " (of the map scaled to the volume of the source)" << std::endl;
  if(!result.has_valid_map)
    return EXIT_FAILURE;

  return VMP::IO::write_VTU(output_filename, c3t3, uvw_map) ? EXIT_SUCCESS : EXIT_FAILURE;
}
catch(const std::exception& error)
{
  std::cerr << error.what() << std::endl;
  return EXIT_FAILURE;
}
