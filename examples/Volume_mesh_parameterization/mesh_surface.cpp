#include "mesh_surface.h"

#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace params = CGAL::parameters;

bool read_closed_surface(const std::string& filename, Surface_mesh& surface)
{
  return CGAL::IO::read_polygon_mesh(filename, surface) && CGAL::is_closed(surface)
      && CGAL::Polygon_mesh_processing::triangulate_faces(surface);
}

// The elephant has three handles, where the trunk and the ears touch the body. A wrap that does not enter gaps below
// 1/20 of the diagonal closes them, so that the boundary is a topological sphere.
C3t3 mesh_elephant(const std::string& filename)
{
  Surface_mesh surface;
  if(!read_closed_surface(filename, surface))
    throw std::runtime_error("There is no closed surface in " + filename);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  const Surface_mesh wrap = close_gaps(surface, diagonal / 20, diagonal / 600);

  const double size = diagonal / 40;
  const Domain domain(wrap);
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = size,
                                           params::facet_distance = size / 8, params::cell_radius_edge_ratio = 3,
                                           params::cell_size = size);
  // a perturbation could make the boundary non-manifold again
  return CGAL::make_mesh_3<C3t3>(domain, criteria, params::manifold(), params::no_perturb(), params::no_exude());
}

C3t3 mesh_mechanical_part(const Surface_mesh& surface, const double relative_size)
{
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
