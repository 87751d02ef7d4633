// Meshes a mechanical part with its sharp edges and maps it onto its polycube.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Polycube_boundary_parameterizer_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/make_mesh_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <unordered_map>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<K, Surface_mesh>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr, Domain::Corner_index, Domain::Curve_index>;
using Point_map = std::unordered_map<C3t3::Vertex_handle, Point_3>;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

C3t3 mesh(const Surface_mesh& surface)
{
  Domain domain(surface);
  domain.detect_features(40); // dihedral angles that deviate from a flat one by more degrees are sharp edges
  const CGAL::Bbox_3 box = domain.bbox();
  const double size = 0.05 * (std::max)({ box.x_span(), box.y_span(), box.z_span() });
  const CGAL::Mesh_criteria_3<Tr> criteria(params::edge_size = size, params::facet_angle = 25,
                                           params::facet_size = size, params::facet_distance = 0.1 * size,
                                           params::facet_topology = CGAL::MANIFOLD,
                                           params::cell_radius_edge_ratio = 3, params::cell_size = size);
  return CGAL::make_mesh_3<C3t3>(domain, criteria);
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  const std::string output_filename = (argc > 2) ? argv[2] : "polycube.vtu";

  Surface_mesh surface;
  if(!CGAL::IO::read_polygon_mesh(filename, surface))
  {
    std::cerr << "Cannot read the surface " << filename << std::endl;
    return EXIT_FAILURE;
  }
  C3t3 c3t3 = mesh(surface);

  Point_map target;
  const auto target_map = boost::make_assoc_property_map(target);
  const VMP::Error_code status = VMP::Polycube_boundary_parameterizer_3().parameterize(c3t3, target_map);
  if(status != VMP::OK)
  {
    std::cerr << VMP::get_error_message(status) << std::endl;
    return EXIT_FAILURE;
  }

  Point_map uvw;
  const auto uvw_map = boost::make_assoc_property_map(uvw);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, uvw_map, params::boundary_map(target_map).do_refine(true).do_slide_boundary(true));
  std::cout << result.message << "\n"
            << result.number_of_cells << " cells, " << result.number_of_added_vertices << " vertices added\n"
            << "distortion of angles:  mean " << result.distortion.angle_mean
            << ", max " << result.distortion.angle_max << "\n"
            << "distortion of volumes: mean " << result.distortion_at_source_volume.volume_mean
            << ", max " << result.distortion_at_source_volume.volume_max << std::endl;
  if(result.status != VMP::OK)
    return EXIT_FAILURE;

  std::ofstream out(output_filename);
  VMP::IO::write_VTU(out, c3t3, uvw_map);
  out.close();
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
