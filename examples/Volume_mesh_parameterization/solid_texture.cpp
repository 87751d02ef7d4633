// Carries a solid texture from the cube to a body: each vertex takes the value of the texture at its image.
#include "mesh_body.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <unordered_map>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

// Rings of wood in the unit cube around the origin, from 0, light, to 1, dark.
double wood(const Point_3& p) { return 0.5 + 0.5 * std::sin(30 * std::hypot(p.y() - 0.1 * std::sin(5 * p.x()), p.z())); }

int main(int argc, char* argv[])
{
  const double size = (argc > 1) ? std::atof(argv[1]) : 0.08; // of the cells
  const auto banana = [](const Point_3& p)
  { return 0.25 * p.x() * p.x() + std::pow(p.y() - 0.2 * p.x() * p.x(), 2) + p.z() * p.z() - 1; };
  C3t3 c3t3 = mesh_body(Domain::create_implicit_mesh_domain(banana, K::Sphere_3(CGAL::ORIGIN, 9.)),
                        CGAL::Mesh_criteria_3<Tr>(params::facet_angle = 25, params::facet_size = size,
                          params::facet_distance = size / 8, params::cell_radius_edge_ratio = 2, params::cell_size = size));
  std::unordered_map<Vertex_handle, Point_3> uvw;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, VMP::make_vertex_point_map(uvw), params::boundary_parameterizer(VMP::Cube_boundary_parameterizer_3()));
  std::cout << result.message << std::endl;
  if(!result.has_valid_map)
    return EXIT_FAILURE;

  VMP::Tetrahedron_soup_3 body;
  std::vector<Vertex_handle> vertices;
  VMP::mesh_complex_3_to_tetrahedron_soup(c3t3, body, vertices);
  std::vector<std::array<double, 3> > images;
  std::vector<double> texture;
  for(const Vertex_handle v : vertices)
  {
    const Point_3& p = uvw.at(v);
    images.push_back({ p.x(), p.y(), p.z() });
    texture.push_back(wood(p));
  }
  body.point_data = { { "field", 1, false, texture } };
  return VMP::IO::write_VTU("solid_texture.vtu", body, images) ? EXIT_SUCCESS : EXIT_FAILURE;
}
