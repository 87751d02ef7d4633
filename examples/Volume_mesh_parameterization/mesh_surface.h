// Tetrahedral meshes of bodies that closed surfaces enclose.
#ifndef MESH_SURFACE_H
#define MESH_SURFACE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<K, Surface_mesh>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr, Domain::Corner_index, Domain::Curve_index>;

// Reads a surface and splits its faces into triangles. Returns false if there is none in the file, or it is not closed.
inline bool read_closed_surface(const std::string& filename, Surface_mesh& surface)
{
  return CGAL::IO::read_polygon_mesh(filename, surface) && CGAL::is_closed(surface)
      && CGAL::Polygon_mesh_processing::triangulate_faces(surface);
}

// Keeps the sharp edges of the surface; the size of the cells is relative to the bounding box.
inline C3t3 mesh_mechanical_part(const Surface_mesh& surface, const double relative_size = 0.05)
{
  namespace params = CGAL::parameters;
  Domain domain(surface);
  domain.detect_features(40); // dihedral angles that deviate from a flat one by more degrees are sharp edges
  const CGAL::Bbox_3 box = domain.bbox();
  const double size = relative_size * (std::max)({ box.x_span(), box.y_span(), box.z_span() });
  const CGAL::Mesh_criteria_3<Tr> criteria(params::edge_size = size, params::facet_angle = 25,
                                           params::facet_size = size, params::facet_distance = 0.1 * size,
                                           params::facet_topology = CGAL::MANIFOLD,
                                           params::cell_radius_edge_ratio = 3, params::cell_size = size);
  // limits of time, as by default, would give another mesh in each run
  return CGAL::make_mesh_3<C3t3>(domain, criteria, params::perturb(params::time_limit = 0),
                                 params::exude(params::time_limit = 0));
}

#endif // MESH_SURFACE_H
