// Meshes a mechanical part with its sharp edges and maps it onto its polycube.
#include "mesh_surface.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <unordered_map>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/joint.off");
  const std::string output_filename = (argc > 2) ? argv[2] : "polycube.vtu";

  Surface_mesh surface;
  if(!read_closed_surface(filename, surface))
  {
    std::cerr << "Cannot read a closed surface from " << filename << std::endl;
    return EXIT_FAILURE;
  }
  C3t3 c3t3 = mesh_mechanical_part(surface);

  std::unordered_map<C3t3::Vertex_handle, Point_3> uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, uvw_map, CGAL::parameters::boundary_parameterizer(PM::Polycube_boundary_parameterizer_3())
                                    .refinement_mode(VMP::Refinement_mode::BOUNDARY)); // edges of the boundary may be split
  std::cout << result.message << "\n"
            << result.number_of_cells << " cells, " << result.number_of_added_vertices << " vertices added\n"
            << "distortion of angles:  mean " << result.distortion.angle_mean
            << ", max " << result.distortion.angle_max << "\n"
            << "distortion of volumes: mean " << result.distortion_at_source_volume.volume_mean
            << ", max " << result.distortion_at_source_volume.volume_max
            << " (of the map scaled to the volume of the source)" << std::endl;
  if(result.status != VMP::OK)
    return EXIT_FAILURE;

  return VMP::IO::write_VTU(output_filename, c3t3, uvw_map) ? EXIT_SUCCESS : EXIT_FAILURE;
}
