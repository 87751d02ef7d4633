// Fits an elephant to the surface of a bull, which has other triangles, by five landmarks. Then the boundary slides on it.
#include "mesh_elephant.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Surface_fit_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/measure_surface_fit.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Points = std::vector<std::array<double, 3> >;

int main()
{
  Surface_mesh bull;
  if(!read_closed_surface(CGAL::data_file_path("meshes/bull.off"), bull))
    return EXIT_FAILURE;
  Points points;
  std::vector<std::array<std::size_t, 3> > triangles;
  for(const auto v : bull.vertices())
    points.push_back({ bull.point(v).x(), bull.point(v).y(), bull.point(v).z() });
  for(const auto f : bull.faces())
  {
    const auto h = bull.halfedge(f);
    triangles.push_back({ bull.source(h), bull.target(h), bull.target(bull.next(h)) });
  }
  // Nose, front feet and hind feet, the left ones first, need not be exactly on the surfaces.
  const VMP::Surface_fit_boundary_parameterizer_3 fit(points, triangles, {
    { { 0.18, 0.5, 0.09 }, { -0.4, 0.05, 0.35 } }, { { 0.35, -0.3, -0.28 }, { -0.46, -0.32, -0.09 } },
    { { 0.1, -0.48, -0.03 }, { -0.31, -0.28, -0.39 } }, { { -0.36, -0.42, -0.21 }, { 0.38, -0.31, 0.13 } },
    { { -0.15, -0.5, -0.04 }, { 0.25, -0.27, -0.24 } } });

  VMP::Tetrahedron_soup_3 elephant;
  std::vector<C3t3::Vertex_handle> vertices;
  VMP::mesh_complex_3_to_tetrahedron_soup(mesh_elephant(CGAL::data_file_path("meshes/elephant.off")), elephant, vertices);
  Points fitted, slid;
  const VMP::Parameterization_result start = CGAL::stretch_minimizing_volume_parameterization(
    elephant, fitted, params::boundary_parameterizer(fit).refinement_mode(VMP::Refinement_mode::BOUNDARY));
  std::cout << start.message << " Energy " << start.energy << std::endl;
  if(!start.has_valid_map)
    return EXIT_FAILURE;

  const VMP::Triangulated_surface_3 surface(points, triangles);
  std::vector<VMP::Vertex_condition_3> conditions(fitted.size());
  for(const std::size_t v : VMP::boundary_vertices(elephant.points, elephant.cells))
    conditions[v] = VMP::Vertex_condition_3::on_surface(surface);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    elephant, fitted, slid, params::refinement_mode(VMP::Refinement_mode::NONE)
      .vertex_condition_map(CGAL::make_property_map(conditions)).initial_map(CGAL::make_property_map(fitted)));
  std::cout << result.message << " Energy " << result.energy << std::endl;

  const VMP::Surface_fit_3 measured = VMP::measure_surface_fit(slid, elephant.cells, points, triangles);
  std::cout << "largest distance of vertices to the bull: " << measured.largest_distance_to_surface
            << ", of the bull to the boundary: " << measured.largest_distance_from_surface
            << ", facets turned over: " << measured.number_of_turned_facets << std::endl;
  return result.has_valid_map && VMP::IO::write_VTU("body_to_scan.vtu", elephant, slid) ? EXIT_SUCCESS : EXIT_FAILURE;
}
