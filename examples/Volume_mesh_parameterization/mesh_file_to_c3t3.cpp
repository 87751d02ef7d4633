// Reads a tetrahedral mesh and target points of its boundary from files, and writes the map to a file.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <unordered_map>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Point_map = std::unordered_map<C3t3::Vertex_handle, Point_3>;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

int main(int argc, char* argv[])
{
  const std::string source = (argc > 2) ? argv[1] : "data/cube.mesh";
  const std::string target = (argc > 2) ? argv[2] : "data/cube_to_ball.txt";

  VMP::Tetrahedron_soup_3 soup;
  std::vector<std::array<double, 3> > targets;
  C3t3 c3t3;
  std::vector<C3t3::Vertex_handle> vertices;   // in the order of the file
  try
  {
    VMP::IO::read_MEDIT(source, soup);
    VMP::IO::read_boundary_targets(target, soup, targets);
    VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices);
  }
  catch(const VMP::Input_error& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  Point_map boundary, uvw;
  for(std::size_t v = 0; v < vertices.size(); ++v)
    if(vertices[v] != C3t3::Vertex_handle()) // otherwise it has no cell
      boundary[vertices[v]] = Point_3(targets[v][0], targets[v][1], targets[v][2]);

  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, VMP::make_vertex_point_map(uvw),
    params::boundary_map(VMP::make_vertex_point_map(boundary)));
  std::cout << result.number_of_cells << " cells, " << result.number_of_inverted_cells << " of them inverted\n"
            << result.message << std::endl;
  if(result.status != VMP::OK)
    return EXIT_FAILURE;

  return VMP::IO::write_VTU("map.vtu", c3t3, VMP::make_vertex_point_map(uvw)) ? EXIT_SUCCESS : EXIT_FAILURE;
}
