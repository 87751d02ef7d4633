// A tetrahedral mesh of CGAL's elephant, and what is told of a map of it.
#ifndef ELEPHANT_H
#define ELEPHANT_H

#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/make_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_3<Surface_mesh, K>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;

// The elephant has three handles, where the trunk and the ears touch the body. A wrap that does not enter gaps below
// 1/20 of the diagonal closes them, so that the boundary is a topological sphere.
inline C3t3 mesh_elephant(const std::string& filename)
{
  namespace params = CGAL::parameters;

  Surface_mesh surface, wrap;
  if(!CGAL::IO::read_polygon_mesh(filename, surface))
    throw std::runtime_error("There is no surface in " + filename);
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

// Prints the result, writes the map to a file, and returns the exit code of the program.
template <typename VertexUVWMap>
int report(const C3t3& c3t3, const VertexUVWMap uvw_map,
           const CGAL::Volume_mesh_parameterization::Parameterization_result& result, const std::string& filename)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;

  std::cout << result.message << "\n"
            << result.number_of_cells << " cells, " << result.number_of_inverted_cells << " of them inverted\n"
            << "distortion of angles:  mean " << result.distortion.angle_mean
            << ", max " << result.distortion.angle_max << "\n"
            << "distortion of volumes: mean " << result.distortion_at_source_volume.volume_mean
            << ", max " << result.distortion_at_source_volume.volume_max << std::endl;
  if(result.status != VMP::OK)
    return EXIT_FAILURE;

  std::ofstream out(filename);
  VMP::IO::write_VTU(out, c3t3, uvw_map);
  out.close();
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif // ELEPHANT_H
