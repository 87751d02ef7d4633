// Maps a cube onto a dented one with the Dirichlet energy, whose minimum is the harmonic map. Cells would collapse
// below the dent, so a barrier is added.
#include "Dented_cube.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>

int main()
{
  Dented_cube cube;
  const VMP::Barrier_energy_3<VMP::Dirichlet_energy_3> energy;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.c3t3, cube.uvw_map(), params::boundary_map(cube.boundary_map()).energy(energy));
  return print(result);
}
