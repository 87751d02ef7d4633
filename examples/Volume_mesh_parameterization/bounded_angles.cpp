// Maps a cube onto a dented one, and brings the distortion of angles of every cell below a bound.
#include "Dented_cube.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>

int main()
{
  Dented_cube cube;
  const double bound = 8; // the stretch energy alone reaches 8.6
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.c3t3, cube.uvw_map(),
    params::boundary_map(cube.boundary_map()).maximal_angle_distortion(bound));
  print(result);
  return result.distortion.angle_max < bound ? EXIT_SUCCESS : EXIT_FAILURE;
}
