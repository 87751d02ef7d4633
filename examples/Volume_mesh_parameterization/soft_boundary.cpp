// Maps a cube onto a dented one with a soft boundary: no cell is inverted on the way, and the boundary approaches its
// targets. Linear equations keep the vertices of a plane of symmetry in that plane.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

int main()
{
  VMP::Tetrahedron_soup_3 cube; // [-1,1]^3
  VMP::IO::read_MEDIT("data/cube.mesh", cube);

  std::vector<std::array<double, 3> > targets = cube.points, images; // targets of points inside are not used
  for(auto& [x, y, z] : targets)
    if(z == 1)
      z -= 1.4 * (1 - x * x) * (1 - y * y);

  std::vector<VMP::Linear_constraint_3<std::size_t> > constraints;
  for(std::size_t v = 0; v < cube.points.size(); ++v)
    if(cube.points[v][0] == 0)
      constraints.push_back({{{v, Eigen::Vector3d(1, 0, 0)}}, 0.}); // 1 x + 0 y + 0 z = 0

  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.points, cube.cells, targets, images,
    CGAL::parameters::boundary_mode(VMP::Boundary_mode::SOFT)
                     .positional_constraints(constraints));

  std::cout << result.message << "\n"
            << "boundary residual " << result.boundary_residual << ", energy " << result.energy << std::endl;
  return result.status == VMP::OK_WITHIN_TOLERANCE ? EXIT_SUCCESS : EXIT_FAILURE;
}
