// Fills a closed surface with tetrahedra of a given size, and writes it with the boundary of a twisted copy as target.
#include "write_case.h"

#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/make_mesh_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<K::Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_3<Surface_mesh, K>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

double diagonal(const CGAL::Bbox_3& box)
{
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

// Turns space about the vertical axis through the middle of the box, by half a turn over the diagonal of the box.
std::array<double, 3> twist(const std::array<double, 3>& p, const CGAL::Bbox_3& box)
{
  const double angle = CGAL_PI * (p[1] - box.ymin()) / diagonal(box);
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = p[0] - (box.xmin() + box.xmax()) / 2, z = p[2] - (box.zmin() + box.zmax()) / 2;
  return {c * x + s * z, p[1], c * z - s * x};
}

// Edges have about the given length; the boundary is a manifold.
C3t3 make_mesh(const Surface_mesh& surface, const double size)
{
  const Domain domain(surface);
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = size,
                                           params::facet_distance = size / 8, params::cell_radius_edge_ratio = 3,
                                           params::cell_size = size);
  return CGAL::make_mesh_3<C3t3>(domain, criteria, params::manifold());
}

void write_model(const std::string& filename, const double relative_size, const std::string& name)
{
  Surface_mesh surface;
  if(!CGAL::IO::read_polygon_mesh(filename, surface) || !CGAL::is_closed(surface))
    throw std::runtime_error(filename + ": there is no closed surface in this file");
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  const C3t3 c3t3 = make_mesh(surface, relative_size * diagonal(box));

  VMP::Tetrahedron_soup_3 soup;
  std::vector<Vertex_handle> vertices;
  VMP::mesh_complex_3_to_tetrahedron_soup(c3t3, soup, vertices);
  std::cout << soup.cells.size() << " cells" << std::endl;
  write_case(name, "twist", soup, [&](std::size_t v) { return c3t3.in_dimension(vertices[v]) < 3; },
             [&](const std::array<double, 3>& p) { return twist(p, box); });
}

int main(int argc, char* argv[])
{
  const double relative_size = (argc == 4) ? std::atof(argv[2]) : 0;
  if(!(relative_size > 0))
  {
    std::cerr << "Usage: mesh_model SURFACE.off SIZE NAME\n"
                 "Writes NAME.mesh, with cells of SIZE times the diagonal of the model, and its target NAME_twist.txt."
              << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    write_model(argv[1], relative_size, argv[3]);
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
