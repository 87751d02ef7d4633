// Maps a cube of twelve cells onto itself; its centre must stay.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstdlib>
#include <iostream>
#include <unordered_map>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr, int, int>;
using Vertex_handle = C3t3::Vertex_handle;

namespace VMP = CGAL::Volume_mesh_parameterization;

int number_of_iterations(); // of the other translation unit

int main()
{
  VMP::Tetrahedron_soup_3 soup;
  for(int i = 0; i < 8; ++i)
    soup.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  soup.points.push_back({0.5, 0.5, 0.5});
  soup.cells = {{0, 3, 1, 8}, {0, 2, 3, 8}, {4, 5, 7, 8}, {4, 7, 6, 8}, {0, 1, 5, 8}, {0, 5, 4, 8},
                {2, 7, 3, 8}, {2, 6, 7, 8}, {0, 6, 2, 8}, {0, 4, 6, 8}, {1, 3, 7, 8}, {1, 7, 5, 8}};
  soup.cell_references.assign(soup.cells.size(), 1);

  C3t3 c3t3;
  std::vector<Vertex_handle> vertices;
  std::vector<C3t3::Cell_handle> cells;
  VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);

  std::unordered_map<Vertex_handle, K::Point_3> uvw;
  const auto position = [](Vertex_handle v) { return K::Point_3(v->point().x(), v->point().y(), v->point().z()); };
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, boost::make_assoc_property_map(uvw),
    CGAL::parameters::number_of_iterations(number_of_iterations())
                     .boundary_map(boost::make_function_property_map<Vertex_handle>(position)));

  std::cout << result.message << std::endl;
  const bool centre_stays = CGAL::squared_distance(uvw[vertices[8]], K::Point_3(0.5, 0.5, 0.5)) < 1e-20;
  return (result.status == VMP::OK && centre_stays) ? EXIT_SUCCESS : EXIT_FAILURE;
}
