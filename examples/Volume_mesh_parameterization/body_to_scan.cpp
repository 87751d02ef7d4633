// Fits a cube to a scan with a head and four feet, whose triangles are others, by five landmarks. Then the boundary slides on it.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Surface_fit_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/measure_surface_fit.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

int main()
{
  VMP::Tetrahedron_soup_3 cube; // [-1, 1]^3
  VMP::IO::read_MEDIT("data/cube.mesh", cube);
  std::vector<CGAL::Simple_cartesian<double>::Point_3> scan;
  std::vector<std::array<std::size_t, 3> > triangles;
  CGAL::IO::read_OFF("data/scan.off", scan, triangles);
  std::vector<std::array<double, 3> > points, fitted, slid;
  for(const auto& p : scan)
    points.push_back({ p.x(), p.y(), p.z() });

  const VMP::Surface_fit_boundary_parameterizer_3 fit(points, triangles, {
    { { 0, 0, 1 }, { 0.9, 0, 1.2 } }, // the head, then the feet
    { { 1, 1, -1 }, { 0.9, 0.72, -0.96 } }, { { 1, -1, -1 }, { 0.9, -0.72, -0.96 } },
    { { -1, 1, -1 }, { -0.9, 0.72, -0.96 } }, { { -1, -1, -1 }, { -0.9, -0.72, -0.96 } } });
  const VMP::Parameterization_result start = CGAL::stretch_minimizing_volume_parameterization(
    cube, fitted, params::boundary_parameterizer(fit));
  std::cout << start.message << std::endl;
  if(!start.has_valid_map)
    return EXIT_FAILURE;

  const VMP::Triangulated_surface_3 surface(points, triangles);
  std::vector<VMP::Vertex_condition_3> conditions(cube.points.size());
  for(const std::size_t v : VMP::boundary_vertices(cube.points, cube.cells))
    conditions[v] = VMP::Vertex_condition_3::on_surface(surface);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.points, cube.cells, fitted, slid,
    params::vertex_condition_map(CGAL::make_property_map(conditions)).initial_map(CGAL::make_property_map(fitted)));
  const VMP::Surface_fit_3 measured = VMP::measure_surface_fit(slid, cube.cells, points, triangles);
  std::cout << result.message << " Facets turned over: " << measured.number_of_turned_facets << std::endl;
  return VMP::IO::write_VTU("body_to_scan.vtu", cube, slid) ? EXIT_SUCCESS : EXIT_FAILURE;
}
