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
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/make_mesh_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstdlib>
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

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Surface_mesh surface;
  if(!CGAL::IO::read_polygon_mesh(filename, surface) || !CGAL::is_closed(surface) || !CGAL::is_triangle_mesh(surface))
  {
    std::cerr << "Cannot read a closed surface of triangles from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const Domain domain(surface);
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = 0.02,
                                           params::facet_distance = 0.001, params::cell_radius_edge_ratio = 3,
                                           params::cell_size = 0.03);
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria);

  // Space is turned about the y-axis, by an angle that grows with the height.
  const auto twist = [point = c3t3.triangulation().geom_traits().construct_point_3_object()](const Vertex_handle v)
  {
    const Point_3 p = point(v->point());
    const double c = std::cos(4 * p.y()), s = std::sin(4 * p.y());
    return Point_3(c * p.x() + s * p.z(), p.y(), c * p.z() - s * p.x());
  };
  std::unordered_map<Vertex_handle, Point_3> uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, uvw_map, params::boundary_map(boost::make_function_property_map<Vertex_handle>(twist)));

  std::cout << result.message << "\n"
            << result.number_of_cells << " cells, " << result.number_of_inverted_cells << " of them inverted\n"
            << "mean distortion of angles: " << result.distortion.angle_mean << std::endl;
  if(result.status != VMP::OK)
    return EXIT_FAILURE;

  return VMP::IO::write_VTU("twisted.vtu", c3t3, uvw_map) ? EXIT_SUCCESS : EXIT_FAILURE;
}
