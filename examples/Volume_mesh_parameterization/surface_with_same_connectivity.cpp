// Meshes a ball, bends its surface, and maps the ball onto what the bent surface encloses.
#include "mesh_body.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Surface_boundary_parameterizer_3.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/facets_in_complex_3_to_triangle_mesh.h>

#include <cstdlib>
#include <iostream>
#include <unordered_map>

using Surface_mesh = CGAL::Surface_mesh<Point_3>;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

int main()
{
  const auto ball = [](const Point_3& p) { return CGAL::squared_distance(p, Point_3(0, 0, 0)) - 1; };
  const Domain domain = Domain::create_implicit_mesh_domain(ball, K::Sphere_3(CGAL::ORIGIN, 2.));
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = 0.2,
                                           params::facet_distance = 0.02, params::cell_radius_edge_ratio = 2,
                                           params::cell_size = 0.2);
  const C3t3 c3t3 = mesh_body(domain, criteria);

  // any program that moves vertices and keeps faces will do, for instance one that fairs or deforms surfaces
  Surface_mesh boundary;
  CGAL::facets_in_complex_3_to_triangle_mesh(c3t3, boundary);
  Surface_mesh bent = boundary;
  for(Point_3& p : bent.points())
    p = Point_3(2 * p.x(), p.y() + p.x() * p.x(), p.z());

  std::unordered_map<C3t3::Vertex_handle, Point_3> uvw;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, VMP::make_vertex_point_map(uvw),
    params::boundary_parameterizer(VMP::Surface_boundary_parameterizer_3<Surface_mesh>(boundary, bent)));
  std::cout << result.message << "\n"
            << result.number_of_boundary_vertices << " boundary vertices, residual " << result.boundary_residual << "\n"
            << "distortion of angles: mean " << result.distortion.angle_mean
            << ", max " << result.distortion.angle_max << std::endl;
  return result.status == VMP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
