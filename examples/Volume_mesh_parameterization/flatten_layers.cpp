// Flattens a folded slab: its top goes to z = 1, its bottom to z = 0. The map finds x and y, and z is the depth as a field.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/conditions_of_patches.h>

#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

int main()
{
  VMP::Tetrahedron_soup_3 slab;
  VMP::IO::read_MEDIT("data/cube.mesh", slab);
  // marks the triangles of the bottom by 1, and those of the top by 2
  for(const auto& [a, b, c, d] : slab.cells)
    for(const std::array<std::size_t, 3>& facet : { std::array<std::size_t, 3>{ a, b, c }, { a, b, d }, { a, c, d }, { b, c, d } })
      for(const int side : { 1, 2 })
        if(const double z = 2 * side - 3; slab.points[facet[0]][2] == z && slab.points[facet[1]][2] == z
                                          && slab.points[facet[2]][2] == z)
        {
          slab.facets.push_back(facet);
          slab.facet_references.push_back(side);
        }
  for(auto& [x, y, z] : slab.points)
    z = 0.4 * z + 0.5 * std::sin(2 * x);

  const auto prescribed = VMP::conditions_of_patches(slab, { { 1, VMP::Patch_condition_3::coordinate(2, 0) },
                                                             { 2, VMP::Patch_condition_3::coordinate(2, 1) } });
  std::vector<std::array<double, 3> > images;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    slab.points, slab.cells, prescribed.targets, images,
    params::vertex_condition_map(CGAL::make_property_map(prescribed.conditions)).energy(VMP::Symmetric_Dirichlet_energy_3())
           .reference_scale(VMP::found_reference_scale)); // the thickness is 0.8, and becomes 1
  std::cout << result.message << " Inverted cells: " << result.number_of_inverted_cells << std::endl;
  if(!result.has_valid_map)
    return EXIT_FAILURE;

  VMP::Data_array_3 depth{ "depth" };
  for(const std::array<double, 3>& p : images)
    depth.values.push_back(p[2]);
  slab.point_data.push_back(depth);
  return VMP::IO::write_VTU("flattened_slab.vtu", slab, images) ? EXIT_SUCCESS : EXIT_FAILURE;
}
