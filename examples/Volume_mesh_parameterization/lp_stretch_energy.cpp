// Maps a cube onto a dented one with an Lp stretch, which concerns the strongest compression in each cell.
#include "Dented_cube.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Lp_stretch_energy_3.h>

int main()
{
  Dented_cube cube;
  const VMP::Lp_stretch_energy_3 energy(16);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.c3t3, cube.uvw_map(), params::boundary_map(cube.boundary_map()).energy(energy));
  return print(result);
}
