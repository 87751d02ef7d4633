// Maps a cube onto a dented one with the third power of the MIPS energy: the worst cells count more.
#include "Dented_cube.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Power_energy_3.h>

int main()
{
  Dented_cube cube;
  const VMP::Power_energy_3<VMP::MIPS_energy_3> energy(3);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.c3t3, cube.uvw_map(), params::boundary_map(cube.boundary_map()).energy(energy));
  return print(result);
}
