// Moves the mesh of the liquid in a round tank: the wall slides on its cylinder, the floor in its plane, and the top on a wave.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Implicit_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/conditions_of_patches.h>

#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

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
  VMP::Tetrahedron_soup_3 tank;
  VMP::IO::read_MEDIT("data/tank.mesh", tank); // the facets of wall, floor and top have the references 1, 2 and 3
  VMP::Tetrahedron_soup_3 moved = tank;
  for(int step = 1; step <= 20; ++step)
  {
    const auto prescribed = VMP::conditions_of_patches(moved, {
      { 1, VMP::Patch_condition_3::on_surface(VMP::Implicit_surface_3(Cylinder())) },
      { 2, VMP::Patch_condition_3::coordinate(2, -1) },
      { 3, VMP::Patch_condition_3::on_surface(VMP::Implicit_surface_3(Wave{ 0.5 * std::sin(0.24 * step) })) } });
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
      tank.points, tank.cells, prescribed.targets, moved.points,
      CGAL::parameters::vertex_condition_map(CGAL::make_property_map(prescribed.conditions))
                       .initial_map(CGAL::make_property_map(moved.points))
                       .energy(VMP::Symmetric_Dirichlet_energy_3()));
    std::cout << "step " << step << ": " << result.message << std::endl;
    if(!result.has_valid_map)
      return EXIT_FAILURE;
  }
  return VMP::IO::write_VTU("sloshing_tank.vtu", tank, moved.points) ? EXIT_SUCCESS : EXIT_FAILURE;
}
