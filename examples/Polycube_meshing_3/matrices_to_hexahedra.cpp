// Maps a ring as libigl has it, points V and tetrahedra T in the rows of matrices, onto its polycube, and makes hexahedra.
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <Eigen/Core>
#include <array>
#include <iostream>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

int main()
{
  Eigen::MatrixXd V(48, 3), U;
  Eigen::MatrixXi T(96, 4);
  for(int v = 0; v < 48; ++v)
    V.row(v) << v % 4, v / 4 % 4, v / 16;
  int t = 0;
  for(const int v : { 0, 1, 2, 4, 6, 8, 9, 10, 16, 17, 18, 20, 22, 24, 25, 26 }) // a ring, of cubes in two layers
    for(const auto& [a, b] : { std::array{ 1, 5 }, { 4, 20 }, { 16, 17 }, { 17, 1 }, { 5, 4 }, { 20, 16 } })
      T.row(t++) << v, v + a, v + b, v + 21; // around the diagonal of the cube
  const auto np = CGAL::parameters::boundary_parameterizer(PM::Polycube_boundary_parameterizer_3(0.5));
  const VMP::Parameterization_result map = CGAL::stretch_minimizing_volume_parameterization(V, T, U,
    np.refinement_mode(VMP::Refinement_mode::BOUNDARY)); // edges of the boundary may be split, and new rows are appended
  PM::Hexahedron_soup_3 hexahedra;
  if(map.status == VMP::OK)
    std::cout << PM::make_hexahedral_mesh_3(V, T, U, 0.5, hexahedra).message << " ";
  std::cout << map.message << " " << V.rows() << " points, " << hexahedra.cells.size() << " hexahedra" << std::endl;
  return hexahedra.cells.empty() ? 1 : 0;
}
