// Maps an elephant to a cube whose corners are found automatically, and refines the mesh where the cube needs it.
#include "mesh_elephant.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include <cstdlib>
#include <iostream>
#include <unordered_map>

int main(int argc, char* argv[])
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  C3t3 c3t3 = mesh_elephant((argc > 1) ? argv[1] : CGAL::data_file_path("meshes/elephant.off"));

  std::unordered_map<C3t3::Vertex_handle, Point_3> uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, uvw_map, CGAL::parameters::boundary_parameterizer(VMP::Cube_boundary_parameterizer_3()));

  std::cout << result.message << "\n"
            << result.number_of_cells << " cells, " << result.number_of_inverted_cells << " of them inverted\n"
            << "mean distortions: of angles " << result.distortion.angle_mean
            << ", of volumes " << result.distortion_at_source_volume.volume_mean << std::endl;
  const bool is_written = result.has_valid_map
                       && VMP::IO::write_VTU((argc > 2) ? argv[2] : "elephant_to_cube.vtu", c3t3, uvw_map);
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
