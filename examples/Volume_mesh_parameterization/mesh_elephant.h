// A tetrahedral mesh of a body whose gaps are closed.
#ifndef MESH_ELEPHANT_H
#define MESH_ELEPHANT_H

#include "mesh_surface.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/alpha_wrap_3.h>

#include <cmath>
#include <stdexcept>
#include <string>

// The elephant has three handles, where the trunk and the ears touch the body. A wrap that does not enter gaps below
// 1/20 of the diagonal closes them, so that the boundary is a topological sphere.
inline C3t3 mesh_elephant(const std::string& filename)
{
  namespace params = CGAL::parameters;
  Surface_mesh surface, wrap;
  if(!read_closed_surface(filename, surface))
    throw std::runtime_error("There is no closed surface in " + filename);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  CGAL::alpha_wrap_3(surface, diagonal / 20, diagonal / 600, wrap);

  const double size = diagonal / 40;
  const Domain domain(wrap);
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = size,
                                           params::facet_distance = size / 8, params::cell_radius_edge_ratio = 3,
                                           params::cell_size = size);
  // a perturbation could make the boundary non-manifold again
  return CGAL::make_mesh_3<C3t3>(domain, criteria, params::manifold(), params::no_perturb(), params::no_exude());
}

#endif // MESH_ELEPHANT_H
