// Maps a cube onto a dented one, and brings the distortion of angles of every cell below a bound.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>

#include <array>
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

  const double bound = 8; // the stretch energy alone reaches 8.6
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.points, cube.cells, targets, images, CGAL::parameters::maximum_angle_distortion(bound));

  std::cout << result.message << "\n"
            << "distortion of angles: mean " << result.distortion.angle_mean
            << ", max " << result.distortion.angle_max << std::endl;
  return result.status == VMP::OK && result.distortion.angle_max < bound ? EXIT_SUCCESS : EXIT_FAILURE;
}
