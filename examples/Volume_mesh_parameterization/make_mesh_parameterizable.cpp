// Maps a flat ellipsoid onto a cube. Cells whose vertices all go to one face of the cube must be split before.
#include "mesh_body.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <unordered_map>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

double ellipsoid(const Point_3& p)
{
  return p.x() * p.x() + 2 * p.y() * p.y() + 8 * p.z() * p.z() - 1;
}

// Takes the ellipsoid to the unit sphere and projects the sphere radially onto the cube [-1,1]^3.
Point_3 to_cube(const Point_3& p)
{
  const double x = p.x(), y = std::sqrt(2.) * p.y(), z = std::sqrt(8.) * p.z();
  const double r = (std::max)({ std::abs(x), std::abs(y), std::abs(z) });
  return Point_3(x / r, y / r, z / r);
}

VMP::Parameterization_result parameterize(const C3t3& c3t3)
{
  const auto point = c3t3.triangulation().geom_traits().construct_point_3_object();
  const auto target = [&point](Vertex_handle v) { return to_cube(point(v->point())); };
  std::unordered_map<Vertex_handle, Point_3> uvw;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, VMP::make_vertex_point_map(uvw),
    params::boundary_map(boost::make_function_property_map<Vertex_handle>(target))
           .boundary_mode(VMP::Boundary_mode::FIXED));
  std::cout << result.number_of_cells << " cells: " << result.message << std::endl;
  return result;
}

int main()
{
  const Domain domain = Domain::create_implicit_mesh_domain(ellipsoid, K::Sphere_3(CGAL::ORIGIN, 4.));
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_size = 0.1, params::facet_distance = 0.01,
                                           params::cell_radius_edge_ratio = 3, params::cell_size = 0.15);
  C3t3 c3t3 = mesh_body(domain, criteria);

  if(parameterize(c3t3).status != VMP::ERROR_PRESCRIBED_CELL_INVERTED)
    return EXIT_FAILURE;
  std::cout << VMP::make_parameterizable(c3t3) << " vertices inserted" << std::endl;
  return (parameterize(c3t3).status == VMP::OK) ? EXIT_SUCCESS : EXIT_FAILURE;
}
