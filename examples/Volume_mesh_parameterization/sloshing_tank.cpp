// Moves the mesh of the liquid in a round tank in 20 steps: the wall slides on its cylinder, the floor in its plane, and the top
// on a wave.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Implicit_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/conditions_of_patches.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Point = std::array<double, 3>;

struct Cylinder
{
  double value(const Point& p) const { return p[0] * p[0] + p[1] * p[1] - 1; }
  Point gradient(const Point& p) const { return { 2 * p[0], 2 * p[1], 0 }; }
};

struct Wave
{
  double height;
  double value(const Point& p) const { return p[2] - 1 - height * std::sin(p[0]); }
  Point gradient(const Point& p) const { return { -height * std::cos(p[0]), 0, 1 }; }
};

int main()
{
  VMP::Tetrahedron_soup_3 tank; // the cube [-1, 1]^3
  VMP::IO::read_MEDIT("data/cube.mesh", tank);
  enum { WALL, FLOOR, TOP };
  for(const auto& [a, b, c, d] : tank.cells)
    for(const std::array<std::size_t, 3>& facet : { std::array<std::size_t, 3>{ a, b, c }, { a, b, d }, { a, c, d }, { b, c, d } })
      for(int side = 0; side < 6; ++side) // the planes x, y, z = -1 and 1
        if(std::all_of(facet.begin(), facet.end(), [&](const auto v) { return tank.points[v][side / 2] == 2 * (side % 2) - 1; }))
        {
          tank.facets.push_back(facet);
          tank.facet_references.push_back(side == 4 ? FLOOR : side == 5 ? TOP : WALL);
        }
  for(auto& [x, y, z] : tank.points) // the square becomes a disc
  {
    const double factor_of_x = std::sqrt(1 - y * y / 2);
    y *= std::sqrt(1 - x * x / 2);
    x *= factor_of_x;
  }

  VMP::Tetrahedron_soup_3 moved = tank;
  for(int step = 1; step <= 20; ++step)
  {
    const auto prescribed = VMP::conditions_of_patches(moved, {
      { WALL, VMP::Patch_condition_3::on_surface(VMP::Implicit_surface_3(Cylinder())) },
      { FLOOR, VMP::Patch_condition_3::coordinate(2, -1) },
      { TOP, VMP::Patch_condition_3::on_surface(VMP::Implicit_surface_3(Wave{ 0.5 * std::sin(0.3 * step) })) } });
    std::vector<Point> images;
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
      tank.points, tank.cells, prescribed.targets, images,
      params::vertex_condition_map(CGAL::make_property_map(prescribed.conditions))
             .initial_map(CGAL::make_property_map(moved.points)).energy(VMP::Symmetric_Dirichlet_energy_3()));
    if(result.status != VMP::OK)
    {
      std::cerr << result.message << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << "step " << step << ": " << result.number_of_sliding_vertices << " vertices slide, " << result.number_of_iterations
              << " Newton steps, energy " << result.energy << ", inverted cells: " << result.number_of_inverted_cells << std::endl;
    moved.points = images;
  }
  return VMP::IO::write_VTU("sloshing_tank.vtu", tank, moved.points) ? EXIT_SUCCESS : EXIT_FAILURE;
}
