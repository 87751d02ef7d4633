// Maps a cube onto a dented one with a soft boundary: no cell is inverted on the way, and the boundary approaches its
// targets. Linear equations keep the vertices of a plane of symmetry in that plane.
#include "Dented_cube.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>

int main()
{
  Dented_cube cube;
  std::vector<VMP::Linear_constraint_3<Vertex_handle> > constraints;
  for(const Vertex_handle v : cube.c3t3.triangulation().finite_vertex_handles())
    if(v->point().x() == 0)
      constraints.push_back({{{v, Eigen::Vector3d(1, 0, 0)}}, 0.}); // 1 x + 0 y + 0 z = 0

  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.c3t3, cube.uvw_map(),
    params::boundary_map(cube.boundary_map())
           .boundary_mode(VMP::Boundary_mode::SOFT)
           .positional_constraints(constraints));
  std::cout << "boundary residual " << result.boundary_residual << std::endl;
  return print(result);
}
