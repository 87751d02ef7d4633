// Bends a bar by its two ends, which are handles. All other vertices of its boundary are free.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

// Divides the bar [-4, 4] x [-1, 1] x [-1, 1] into boxes, m along the bar and n across, of six cells each.
VMP::Tetrahedron_soup_3 make_bar(const std::size_t m, const std::size_t n)
{
  VMP::Tetrahedron_soup_3 bar;
  const std::size_t y = m + 1, z = y * (n + 1); // from a point to the next one in these directions
  for(std::size_t k = 0; k <= n; ++k)
    for(std::size_t j = 0; j <= n; ++j)
      for(std::size_t i = 0; i <= m; ++i)
      {
        const std::size_t v = bar.points.size();
        bar.points.push_back({ 8. * i / m - 4, 2. * j / n - 1, 2. * k / n - 1 });
        if(i < m && j < n && k < n)
          for(const auto& [a, b] : std::vector<std::array<std::size_t, 2> >{ { 1, 1 + y }, { 1 + y, y }, { y, y + z },
                                                                             { y + z, z }, { z, 1 + z }, { 1 + z, 1 } })
            bar.cells.push_back({ v, v + a, v + b, v + 1 + y + z });
      }
  bar.cell_references.assign(bar.cells.size(), 0);
  return bar;
}

int main()
{
  const VMP::Tetrahedron_soup_3 bar = make_bar(16, 4);

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
