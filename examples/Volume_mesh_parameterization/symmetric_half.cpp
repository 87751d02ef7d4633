// Maps one half of a symmetric body. Vertices of the plane of symmetry move in it; the bottom stays, and the top is a handle.
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
  VMP::Tetrahedron_soup_3 half; // the cube [-1, 1]^3, which has its other half behind the plane x = -1
  VMP::IO::read_MEDIT("data/cube.mesh", half);
  std::vector<std::array<double, 3> > targets(half.points), images;
  std::vector<VMP::Vertex_condition_3> conditions(half.points.size());
  for(std::size_t v = 0; v < half.points.size(); ++v)
  {
    const auto& [x, y, z] = half.points[v];
    if(x == -1)
      conditions[v] = VMP::Vertex_condition_3::in_plane(1, 0, 0);
    if(z == -1 || (z == 1 && x >= 0))
      conditions[v] = VMP::Vertex_condition_3::at_target();
    if(z == 1 && x >= 0)
      targets[v] = { x, y, 2 };
  }

  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    half.points, half.cells, targets, images,
    params::vertex_condition_map(CGAL::make_property_map(conditions)).energy(VMP::Symmetric_Dirichlet_energy_3()));
  std::cout << result.message << " Vertices in the plane: " << result.number_of_sliding_vertices << ", inverted cells: "
            << result.number_of_inverted_cells << std::endl;
  return result.has_valid_map && VMP::IO::write_VTU("symmetric_half.vtu", half, images) ? EXIT_SUCCESS : EXIT_FAILURE;
}
