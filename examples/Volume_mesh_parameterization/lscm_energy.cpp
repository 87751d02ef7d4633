// Maps a cube onto a dented one. Minimizes the energy of least squares conformal maps (LSCM). One chooses it to compare
// with other work; for maps that preserve angles, MIPS does not favor small cells. It is finite for flat cells, so it
// gets a barrier. Its weight is 1, as with the default of 0.01 the distortion of angles reaches 466.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>

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

  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.points, cube.cells, targets, images,
    CGAL::parameters::energy(VMP::Barrier_energy_3<VMP::LSCM_energy_3>(VMP::LSCM_energy_3(), 1.)));

  const VMP::Distortion_3& d = result.distortion_at_source_volume;
  std::cout << result.message << "\n"
            << "distortion of angles:  mean " << d.angle_mean << ", max " << d.angle_max << "\n"
            << "distortion of volumes: mean " << d.volume_mean << ", max " << d.volume_max << std::endl;
  return result.status == VMP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
