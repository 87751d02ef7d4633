// A ring of prisms: three edges lead around it, and a box with a hole has four sides there.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_RING_OF_PRISMS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_RING_OF_PRISMS_H

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>

inline CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 ring_of_prisms()
{
  constexpr std::size_t number = 12;
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 soup;
  for(std::size_t i = 0; i < number; ++i)
    for(std::size_t j = 0; j < 3; ++j)
    {
      const double a = 2 * CGAL_PI * i / number, b = 2 * CGAL_PI * j / 3 + 0.3, radius = 3 + std::cos(b);
      soup.points.push_back({radius * std::cos(a), radius * std::sin(a), std::sin(b)});
    }
  for(std::size_t i = 0; i < number; ++i)
  {
    const auto at = [&](const std::size_t k, const std::size_t j) { return (i + k) % number * 3 + j; };
    soup.cells.push_back({at(0, 0), at(0, 1), at(0, 2), at(1, 0)});
    soup.cells.push_back({at(0, 1), at(1, 1), at(0, 2), at(1, 0)});
    soup.cells.push_back({at(0, 2), at(1, 1), at(1, 2), at(1, 0)});
  }
  soup.cell_references.assign(soup.cells.size(), 1);
  CGAL::Volume_mesh_parameterization::orient_tetrahedron_soup(soup);
  return soup;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_RING_OF_PRISMS_H
