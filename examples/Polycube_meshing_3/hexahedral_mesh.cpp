// Makes hexahedra of a surface in a file: a mechanical part is mapped onto a polycube, and a grid pulled back.
#include "mesh_surface.h"

#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <unordered_map>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/joint.off");
  const std::string output_filename = (argc > 2) ? argv[2] : "hexahedra.vtu";
  const double number = (argc > 3) ? std::atof(argv[3]) : 20; // number of hexahedra along the longest side

  Surface_mesh surface;
  if(!read_closed_surface(filename, surface) || !(number > 0))
  {
    std::cerr << "Usage: hexahedral_mesh SURFACE [OUTPUT.vtu|OUTPUT.inp [NUMBER]]" << std::endl;
    return EXIT_FAILURE;
  }
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  const double spacing = (std::max)({ box.x_span(), box.y_span(), box.z_span() }) / number;
  C3t3 c3t3 = mesh_mechanical_part(surface);

  // onto a polycube whose faces fit the grid
  std::unordered_map<C3t3::Vertex_handle, Point_3> uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  const VMP::Parameterization_result map = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, uvw_map,
    CGAL::parameters::boundary_parameterizer(PM::Polycube_boundary_parameterizer_3(spacing))
                     .refinement_mode(VMP::Refinement_mode::BOUNDARY));
  if(map.status != VMP::OK)
  {
    std::cerr << map.message << std::endl;
    return EXIT_FAILURE;
  }

  // and back
  PM::Hexahedron_soup_3 hexahedra;
  const PM::Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(c3t3, uvw_map, spacing, hexahedra);
  std::cout << result.message << "\n"
            << result.number_of_cells << " hexahedra, " << result.number_of_vertices << " vertices\n"
            << "scaled Jacobian: minimal " << result.minimum_scaled_jacobian
            << ", mean " << result.mean_scaled_jacobian << std::endl;
  if(result.status != PM::OK)
    return EXIT_FAILURE;

  const bool is_written = (std::filesystem::path(output_filename).extension() == ".inp")
                        ? PM::IO::write_INP(output_filename, hexahedra)
                        : PM::IO::write_VTU(output_filename, hexahedra);
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
