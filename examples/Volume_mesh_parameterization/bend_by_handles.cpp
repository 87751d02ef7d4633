// Bends a bar by its two ends, which are handles. All other vertices of its boundary are free.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>

#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

int main()
{
  VMP::Tetrahedron_soup_3 bar;
  VMP::IO::read_MEDIT("data/cube.mesh", bar);
  for(std::array<double, 3>& p : bar.points)
    p[0] *= 4; // the bar [-4, 4] x [-1, 1] x [-1, 1]

  std::vector<std::array<double, 3> > targets(bar.points), images;
  std::vector<VMP::Vertex_condition_3> conditions(bar.points.size()); // free
  for(std::size_t v = 0; v < bar.points.size(); ++v)
    if(const auto& [x, y, z] = bar.points[v]; x == -4 || x == 4)
    {
      conditions[v] = VMP::Vertex_condition_3::at_target();
      if(x == 4) // turned upward by a right angle
        targets[v] = { 2 - z, y, 3 };
    }

  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    bar.points, bar.cells, targets, images,
    params::vertex_condition_map(CGAL::make_property_map(conditions)).energy(VMP::Symmetric_Dirichlet_energy_3()));
  std::cout << result.message << " Energy " << result.energy << ", inverted cells: " << result.number_of_inverted_cells
            << std::endl;
  return result.has_valid_map && VMP::IO::write_VTU("bent_bar.vtu", bar, images) ? EXIT_SUCCESS : EXIT_FAILURE;
}
