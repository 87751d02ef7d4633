// From points and cells to a ball, a cube and a polycube, to images of any points and to hexahedra: with arrays alone.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

std::vector<std::array<double, 3> > points, targets, images;
std::vector<std::array<int, 4> > cells;

// The unit cube that begins at a point, cut into six cells along the paths from this corner to the opposite one.
void add_cube(const std::array<double, 3>& begin)
{
  for(const std::array<int, 3>& axes : { std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2} })
  {
    const bool is_even = (axes[0] + 1) % 3 == axes[1];
    std::array<int, 4> cell;
    std::array<double, 3> p = begin;
    for(int i = 0; i < 4; ++i)
    {
      const auto found = std::find(points.begin(), points.end(), p);
      cell[i == 0 || i == 3 || is_even ? i : 3 - i] = static_cast<int>(found - points.begin());
      if(found == points.end())
        points.push_back(p);
      if(i < 3)
        ++p[axes[i]];
    }
    cells.push_back(cell);
  }
}

template <typename Parameterizer>
void map_to(const char* domain, const Parameterizer& parameterizer)
{
  const VMP::Error_code status = parameterizer.parameterize(points, cells, targets);
  if(status != VMP::OK)
    throw std::runtime_error(VMP::get_error_message(status));
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    points, cells, targets, images, CGAL::parameters::do_refine(true));
  std::cout << domain << ": " << result.message << " " << result.number_of_added_vertices << " new points, energy "
            << result.energy << std::endl;
  if(result.status != VMP::OK)
    throw std::runtime_error(result.message);
}

int main()
try
{
  for(int x = 0; x < 3; ++x)
    for(int y = 0; y < (x == 1 ? 1 : 3); ++y) // the letter U
      for(int z = 0; z < 2; ++z)
        add_cube({ double(x), double(y), double(z) });

  map_to("ball", VMP::Ball_boundary_parameterizer_3());
  map_to("cube", VMP::Cube_boundary_parameterizer_3());
  map_to("polycube", VMP::Polycube_boundary_parameterizer_3(0.5));

  const VMP::Volume_map_3 map(points, cells, images);
  std::cout << "(1, 1, 0.5) is mapped to " << map.image({ 1, 1, 0.5 })->point << std::endl;

  VMP::Hexahedron_soup_3 hexahedra;
  const VMP::Hexahedral_mesh_result result = VMP::hexahedral_mesh(points, cells, images, 0.5, hexahedra);
  std::cout << result.number_of_cells << " hexahedra, minimal scaled Jacobian " << result.minimal_scaled_jacobian << std::endl;
  return result.status == VMP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
catch(const std::exception& error)
{
  std::cerr << error.what() << std::endl;
  return EXIT_FAILURE;
}
