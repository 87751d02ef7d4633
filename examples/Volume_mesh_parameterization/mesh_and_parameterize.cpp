// Fills a closed surface with tetrahedra and maps them onto the twisted surface.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/make_mesh_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <unordered_map>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_3<Surface_mesh, K>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

// Turns space about the y-axis, by an angle that grows with the height.
Point_3 twist(const Point_3& p)
{
  const double angle = 4 * p.y();
  const double c = std::cos(angle), s = std::sin(angle);
  return Point_3(c * p.x() + s * p.z(), p.y(), c * p.z() - s * p.x());
}

void print(const VMP::Parameterization_result& result)
{
  const VMP::Distortion_3& d = result.distortion_at_source_volume;
  std::cout << result.message << "\n"
            << result.number_of_cells << " cells, " << result.number_of_inverted_cells_at_start
            << " of them inverted by the harmonic map, " << result.number_of_inverted_cells << " by the result\n"
            << result.number_of_iterations << " iterations, " << result.seconds_total << " s\n\n"
            << "distortion of the map scaled to the volume of the source (none: 2)\n"
            << "                          mean       max\n" << std::fixed << std::setprecision(4)
            << "of angles           " << std::setw(10) << d.angle_mean << std::setw(10) << d.angle_max << "\n"
            << "of volumes          " << std::setw(10) << d.volume_mean << std::setw(10) << d.volume_max << std::endl;
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const std::string output_filename = (argc > 2) ? argv[2] : "twisted.vtu";

  Surface_mesh surface;
  if(!CGAL::IO::read_polygon_mesh(filename, surface))
  {
    std::cerr << "Cannot read the surface " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Domain domain(surface);
  CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = 0.02,
                                     params::facet_distance = 0.001, params::cell_radius_edge_ratio = 3,
                                     params::cell_size = 0.03);
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria);

  const auto point = c3t3.triangulation().geom_traits().construct_point_3_object();
  const auto target = [&point](Vertex_handle v) { return twist(point(v->point())); };
  std::unordered_map<Vertex_handle, Point_3> uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, uvw_map, params::boundary_map(boost::make_function_property_map<Vertex_handle>(target)));
  print(result);
  if(result.status != VMP::OK)
    return EXIT_FAILURE;

  std::ofstream out(output_filename, std::ios::binary);
  VMP::IO::write_VTU(out, c3t3, uvw_map);
  out.close();
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
