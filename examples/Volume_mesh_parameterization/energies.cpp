// Maps a cube onto a dented one with one energy after the other. Cells would collapse below the dent where an energy is
// finite for flat cells, so these get a barrier.
#include "Dented_cube.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Lp_stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Power_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>

#include <algorithm>

template <typename Energy>
bool map_cube(const char* const name, const Energy& energy)
{
  Dented_cube cube;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.c3t3, cube.uvw_map(), params::boundary_map(cube.boundary_map()).energy(energy));
  std::cout << name << ": ";
  return print(result) == EXIT_SUCCESS;
}

int main()
{
  using VMP::Barrier_energy_3;
  const bool is_mapped[] = {
    map_cube("stretch", VMP::Stretch_energy_3()),
    map_cube("Lp stretch", VMP::Lp_stretch_energy_3(16)),
    map_cube("symmetric Dirichlet", VMP::Symmetric_Dirichlet_energy_3()),
    map_cube("MIPS", VMP::MIPS_energy_3()),
    map_cube("MIPS to the third power", VMP::Power_energy_3<VMP::MIPS_energy_3>(3)), // the worst cells count more
    map_cube("Dirichlet", Barrier_energy_3<VMP::Dirichlet_energy_3>()),
    map_cube("as rigid as possible", Barrier_energy_3<VMP::ARAP_energy_3>()),
    map_cube("length preserving", Barrier_energy_3<VMP::LPM_energy_3>()),
    map_cube("least squares conformal", Barrier_energy_3<VMP::LSCM_energy_3>(VMP::LSCM_energy_3(), 1.)) // above the default
  };
  return std::count(std::begin(is_mapped), std::end(is_mapped), false) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
