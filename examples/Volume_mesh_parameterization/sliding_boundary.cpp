// Maps a blob to the cube twice: with a fixed boundary, and with one that slides in the faces of the cube.
#include "mesh_body.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <unordered_map>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

// Negative inside of three balls that melt into each other.
double blob(const Point_3& p)
{
  double sum = 0;
  for(const Point_3& center : {Point_3(-0.6, 0, 0), Point_3(0.5, 0.3, 0), Point_3(0.3, -0.4, 0.6)})
    sum += std::exp(-4 * CGAL::squared_distance(p, center));
  return 0.4 - sum;
}

// Maps the complex to the cube and writes the map to a file; false if something fails.
bool parameterize(C3t3& c3t3, const bool do_slide, const std::string& filename)
{
  std::unordered_map<C3t3::Vertex_handle, Point_3> uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, uvw_map,
    params::boundary_parameterizer(VMP::Cube_boundary_parameterizer_3())
           .do_slide_boundary(do_slide));

  std::cout << result.message << "\n"
            << result.number_of_sliding_vertices << " of " << result.number_of_boundary_vertices
            << " vertices of the boundary slide\n"
            << "energy " << result.energy << "\n"
            << "distortion of angles:  mean " << result.distortion.angle_mean
            << ", max " << result.distortion.angle_max << "\n"
            << "distortion of volumes: mean " << result.distortion_at_source_volume.volume_mean
            << ", max " << result.distortion_at_source_volume.volume_max
            << " (of the map scaled to the volume of the source)\n" << std::endl;
  if(result.status != VMP::OK)
    return false;

  return VMP::IO::write_VTU(filename, c3t3, uvw_map);
}

int main()
{
  Domain domain = Domain::create_implicit_mesh_domain(blob, K::Sphere_3(CGAL::ORIGIN, 4.));
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = 0.1,
                                           params::facet_distance = 0.01, params::cell_radius_edge_ratio = 3,
                                           params::cell_size = 0.12);
  C3t3 c3t3 = mesh_body(domain, criteria);

  const bool is_fixed_done = parameterize(c3t3, false, "fixed_boundary.vtu");
  const bool is_sliding_done = parameterize(c3t3, true, "sliding_boundary.vtu");
  return is_fixed_done && is_sliding_done ? EXIT_SUCCESS : EXIT_FAILURE;
}
