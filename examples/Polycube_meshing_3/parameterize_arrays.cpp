// Maps points and cells to a ball, a cube and a polycube, carries any points, and makes hexahedra: with arrays alone.
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <array>
#include <iostream>
#include <vector>

int main()
{
  namespace PM = CGAL::Polycube_meshing_3;
  namespace VMP = CGAL::Volume_mesh_parameterization;
  std::vector<std::array<double, 3> > points, images;
  std::vector<std::array<int, 4> > cells;
  for(int v = 0; v < 48; ++v)
    points.push_back({ double(v % 4), double(v / 4 % 4), double(v / 16) });
  for(const int v : { 0, 1, 2, 4, 6, 8, 10, 16, 17, 18, 20, 22, 24, 26 }) // the letter U, of cubes in two layers
    for(const auto& [a, b] : { std::array{ 1, 5 }, { 4, 20 }, { 16, 17 }, { 17, 1 }, { 5, 4 }, { 20, 16 } })
      cells.push_back({ v, v + a, v + b, v + 21 }); // around the diagonal of the cube
  const auto map_to = [&](const auto& boundary_parameterizer)
  {
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
      points, cells, images, CGAL::parameters::boundary_parameterizer(boundary_parameterizer));
    std::cout << result.message << " " << points.size() << " points" << std::endl; // new ones are appended
    return result.status == VMP::OK;
  };
  if(!map_to(VMP::Ball_boundary_parameterizer_3()) || !map_to(VMP::Cube_boundary_parameterizer_3())
     || !map_to(PM::Polycube_boundary_parameterizer_3(0.5)))
    return 1;

  PM::Hexahedron_soup_3 hexahedra;
  const PM::Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(points, cells, images, 0.5, hexahedra);
  std::cout << "(1, 1, 0.5) goes to " << VMP::Volume_map_3(points, cells, images).image({ 1, 1, 0.5 })->point << std::endl
            << hexahedra.cells.size() << " hexahedra, scaled Jacobian from " << result.minimum_scaled_jacobian << std::endl;
  return result.status == VMP::OK ? 0 : 1;
}
