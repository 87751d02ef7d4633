// Fills a closed surface with tetrahedra of a given size, and maps the boundary to a ball, a cube, a polycube or a
// twisted copy.
#include "write_case.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/make_mesh_3.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<K, Surface_mesh>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr, Domain::Corner_index, Domain::Curve_index>;
using Vertex_handle = C3t3::Vertex_handle;
using Targets = std::unordered_map<Vertex_handle, Point_3>;

namespace params = CGAL::parameters;
namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

double diagonal(const CGAL::Bbox_3& box)
{
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

// Edges have about the given length. The sharp edges of the surface are kept if the kind is "sharp", and the boundary
// is a manifold unless the kind is "any". There is no perturbation, which could undo that, and no limit of time, with which
// each run gives another mesh.
C3t3 make_mesh(const Surface_mesh& surface, const double size, const std::string& kind)
{
  if(kind != "smooth" && kind != "sharp" && kind != "any")
    throw std::runtime_error("there is no kind '" + kind + "'");
  Domain domain(surface);
  if(kind == "sharp")
    domain.detect_features(40);
  const CGAL::Mesh_criteria_3<Tr> criteria(params::edge_size = size, params::facet_angle = 25,
                                           params::facet_size = size, params::facet_distance = size / 8,
                                           params::cell_radius_edge_ratio = 3, params::cell_size = size);
  return CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::exude(params::time_limit = 0),
                                 (kind == "any") ? params::non_manifold() : params::manifold());
}

// Turns space about the vertical axis through the middle of the box, by half a turn over the diagonal of the box.
Point_3 twist(const Point_3& p, const CGAL::Bbox_3& box)
{
  const double angle = CGAL_PI * (p.y() - box.ymin()) / diagonal(box);
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = p.x() - (box.xmin() + box.xmax()) / 2, z = p.z() - (box.zmin() + box.zmax()) / 2;
  return Point_3(c * x + s * z, p.y(), c * z - s * x);
}

VMP::Error_code twist_boundary(const C3t3& c3t3, const CGAL::Bbox_3& box, Targets& targets)
{
  const auto point = c3t3.triangulation().geom_traits().construct_point_3_object();
  for(const Vertex_handle v : c3t3.triangulation().finite_vertex_handles())
    if(c3t3.in_dimension(v) < 3)
      targets.emplace(v, twist(point(v->point()), box));
  return VMP::OK;
}

VMP::Error_code map_boundary(const std::string& domain, const C3t3& c3t3, const CGAL::Bbox_3& box, Targets& targets)
{
  const auto target_map = boost::make_assoc_property_map(targets);
  if(domain == "twist") return twist_boundary(c3t3, box, targets);
  if(domain == "ball") return VMP::Ball_boundary_parameterizer_3().parameterize(c3t3, target_map);
  if(domain == "cube") return VMP::Cube_boundary_parameterizer_3().parameterize(c3t3, target_map);
  if(domain == "polycube") return PM::Polycube_boundary_parameterizer_3().parameterize(c3t3, target_map);
  throw std::runtime_error("there is no domain '" + domain + "'");
}

// A vertex has a target if it is on the boundary; there is no file of targets if the boundary cannot be mapped.
void write_model(const std::string& filename, const double relative_size, const std::string& kind,
                 const std::string& name, const std::vector<std::string>& domains)
{
  Surface_mesh surface;
  if(!CGAL::IO::read_polygon_mesh(filename, surface) || !CGAL::is_closed(surface))
    throw std::runtime_error(filename + ": there is no closed surface in this file");
  CGAL::Polygon_mesh_processing::triangulate_faces(surface);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  C3t3 c3t3 = make_mesh(surface, relative_size * diagonal(box), kind);
  // cells with all vertices on the boundary would become flat, or almost so, whatever the map inside is
  VMP::make_parameterizable(c3t3);

  VMP::Tetrahedron_soup_3 soup;
  std::vector<Vertex_handle> vertices;
  VMP::mesh_complex_3_to_tetrahedron_soup(c3t3, soup, vertices);
  write_mesh(name, soup);
  std::cout << soup.cells.size() << " cells" << std::endl;

  for(const std::string& domain : domains)
  {
    Targets targets;
    const VMP::Error_code status = map_boundary(domain, c3t3, box, targets);
    std::cout << domain << ": " << VMP::get_error_message(status) << std::endl;
    if(status == VMP::OK)
      write_targets(name, domain, vertices.size(), [&](std::size_t v) { return targets.count(vertices[v]) != 0; },
                    [&](std::size_t v) { return VMP::internal::coordinates(targets.at(vertices[v])); });
  }
}

int main(int argc, char* argv[])
{
  const double relative_size = (argc > 5) ? std::atof(argv[2]) : 0;
  if(!(relative_size > 0))
  {
    std::cerr << "Usage: mesh_model SURFACE.off SIZE KIND NAME DOMAIN...\n"
                 "Writes NAME.mesh, with cells of SIZE times the diagonal of the model, and for each DOMAIN (twist,\n"
                 "ball, cube or polycube) its target NAME_DOMAIN.txt, or prints why there is none. KIND is smooth,\n"
                 "sharp (the sharp edges of the surface are kept), or any (the boundary need not be a manifold)."
              << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    write_model(argv[1], relative_size, argv[3], argv[4], {argv + 5, argv + argc});
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
