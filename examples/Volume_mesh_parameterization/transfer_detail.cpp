// Carries the bumps of a body to another one, through the unit ball: the boundary is displaced, and the inside follows.
#include "mesh_body.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <unordered_map>
#include <vector>

using Images = std::unordered_map<Vertex_handle, Point_3>;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

template <typename Function>
C3t3 mesh(const Function& function, const double size)
{
  const Domain domain = Domain::create_implicit_mesh_domain(function, K::Sphere_3(CGAL::ORIGIN, 9.));
  return mesh_body(domain, CGAL::Mesh_criteria_3<Tr>(params::facet_angle = 25, params::facet_size = size,
                     params::facet_distance = size / 8, params::cell_radius_edge_ratio = 2, params::cell_size = 2 * size));
}

int main(int argc, char* argv[])
{
  const double size = (argc > 1) ? std::atof(argv[1]) : 0.08; // of the cells of the boundary
  const auto height = [](const Point_3& p) { return std::sqrt(CGAL::squared_distance(p, Point_3(0, 0, 0))) - 1; };
  const auto bumpy_ball = [&](const Point_3& p)
  { return height(p) - 0.2 * std::sin(5 * p.x()) * std::sin(5 * p.y()) * std::sin(5 * p.z()); };
  const auto banana = [](const Point_3& p)
  { const double y = p.y() - 0.2 * p.x() * p.x(); return 0.25 * p.x() * p.x() + y * y + p.z() * p.z() - 1; };
  const auto gradient = [](const Point_3& p)
  { const double y = p.y() - 0.2 * p.x() * p.x(); return K::Vector_3((0.5 - 0.8 * y) * p.x(), 2 * y, 2 * p.z()); };

  C3t3 source = mesh(bumpy_ball, size), target = mesh(banana, size);
  Images source_in_ball, target_in_ball, displaced, carried;
  const auto source_map = VMP::make_vertex_point_map(source_in_ball);
  if(!CGAL::stretch_minimizing_volume_parameterization(source, source_map).has_valid_map
     || !CGAL::stretch_minimizing_volume_parameterization(target, VMP::make_vertex_point_map(target_in_ball)).has_valid_map)
    return EXIT_FAILURE;

  // the height of the bump at the same point of the ball, along the normal
  const VMP::Volume_map_3 source_to_ball(source, source_map);
  const std::vector<Vertex_handle> boundary = VMP::boundary_vertices(target);
  for(const Vertex_handle v : boundary)
  {
    const Point_3 p = v->point().point();
    const K::Vector_3 normal = gradient(p) / std::sqrt(gradient(p).squared_length());
    displaced[v] = p + height(source_to_ball.nearest_preimage(target_in_ball.at(v))->point) * normal;
  }
  const auto carried_map = VMP::make_vertex_point_map(carried);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    target, carried_map, params::boundary_map(VMP::make_vertex_point_map(displaced))
                                 .refinement_mode(VMP::Refinement_mode::HELPFUL));
  std::cout << result.message << " Distortion of volumes: at most " << result.distortion.volume_max << std::endl;
  return result.status == VMP::OK && VMP::IO::write_VTU("bumpy_ball.vtu", source, source_map)
      && VMP::IO::write_VTU("transferred_detail.vtu", target, carried_map) ? EXIT_SUCCESS : EXIT_FAILURE;
}
