// Fits a cube to a scan with a head and four feet, whose triangles are others, by five landmarks. Then the boundary slides on it.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Surface_fit_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/measure_surface_fit.h>

#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Point = std::array<double, 3>;
using Limbs = std::vector<std::pair<Point, Point> >; // points of the cube, each with the end of a limb of the scan

// A sphere with a bump at each limb, as a grid of latitudes and longitudes with poles at both ends.
void make_scan(const Limbs& limbs, std::vector<Point>& points, std::vector<std::array<std::size_t, 3> >& triangles)
{
  constexpr std::size_t m = 12, n = 17;
  for(std::size_t i = 0; i <= m; ++i)
    for(std::size_t j = 0; j < (i == 0 || i == m ? 1 : n); ++j)
    {
      const double theta = CGAL_PI * double(i) / m, phi = 2 * CGAL_PI * double(j) / n;
      const Point d = { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) };
      double radius = 1;
      for(const auto& [p, end] : limbs) // at a distance of 1.5
        radius += 0.5 * std::exp(-6 * (1 - (d[0] * end[0] + d[1] * end[1] + d[2] * end[2]) / 1.5));
      points.push_back({ radius * d[0], radius * d[1], radius * d[2] });
    }
  const auto index = [&](const std::size_t i, const std::size_t j) { return i == 0 ? 0 : 1 + (i - 1) * n + (i < m ? j % n : 0); };
  for(std::size_t i = 0; i < m; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      if(i + 1 < m)
        triangles.push_back({ index(i, j), index(i + 1, j), index(i + 1, j + 1) });
      if(i > 0)
        triangles.push_back({ index(i, j), index(i + 1, j + 1), index(i, j + 1) });
    }
}

int main()
{
  VMP::Tetrahedron_soup_3 cube; // [-1, 1]^3
  VMP::IO::read_MEDIT("data/cube.mesh", cube);
  const Limbs limbs = { { { 0, 0, 1 }, { 0.9, 0, 1.2 } }, { { 1, 1, -1 }, { 0.9, 0.72, -0.96 } },
    { { 1, -1, -1 }, { 0.9, -0.72, -0.96 } }, { { -1, 1, -1 }, { -0.9, 0.72, -0.96 } },
    { { -1, -1, -1 }, { -0.9, -0.72, -0.96 } } };
  std::vector<Point> points, fitted, slid;
  std::vector<std::array<std::size_t, 3> > triangles;
  make_scan(limbs, points, triangles);

  const VMP::Surface_fit_boundary_parameterizer_3 fit(points, triangles, limbs);
  const VMP::Parameterization_result start = CGAL::stretch_minimizing_volume_parameterization(
    cube, fitted, params::boundary_parameterizer(fit).refinement_mode(VMP::Refinement_mode::HELPFUL));
  std::cout << start.message << " Energy " << start.energy << std::endl;
  if(!start.has_valid_map)
    return EXIT_FAILURE;

  const VMP::Triangulated_surface_3 surface(points, triangles);
  std::vector<VMP::Vertex_condition_3> conditions(cube.points.size());
  for(const std::size_t v : VMP::boundary_vertices(cube.points, cube.cells))
    conditions[v] = VMP::Vertex_condition_3::on_surface(surface);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.points, cube.cells, fitted, slid,
    params::vertex_condition_map(CGAL::make_property_map(conditions)).initial_map(CGAL::make_property_map(fitted)));
  std::cout << result.message << " Energy " << result.energy << std::endl;
  if(!result.has_valid_map)
    return EXIT_FAILURE;
  const VMP::Surface_fit_3 measured = VMP::measure_surface_fit(slid, cube.cells, points, triangles);
  std::cout << "distances: " << measured.largest_distance_to_surface << " to the scan, "
            << measured.largest_distance_from_surface << " from it; facets turned over: " << measured.number_of_turned_facets
            << std::endl;
  return VMP::IO::write_VTU("body_to_scan.vtu", cube, slid) ? EXIT_SUCCESS : EXIT_FAILURE;
}
