// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_SOUP_NUMBERED_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_SOUP_NUMBERED_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Facet_matching_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Numbered_vertices_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Soup/check_tetrahedron_soup.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The numbered mesh of a tetrahedron soup, whose vertices are the indices of its points.
class Numbered_soup_3
  : public Numbered_vertices_3<std::size_t>
{
public:
  template <typename VertexIsConstrainedMap, typename BoundaryMap>
  Numbered_soup_3(const Tetrahedron_soup_3& soup, const VertexIsConstrainedMap is_constrained, const BoundaryMap target,
                  const bool has_volume_weights)
    : m_number_of_points(soup.points.size())
  {
    check_simplices(soup);
    std::vector<std::array<int, 4> > cells;
    cells.reserve(soup.cells.size());
    reserve(soup.points.size());
    for(const std::array<std::size_t, 4>& cell : soup.cells)
      cells.push_back({ add_vertex(cell[0]), add_vertex(cell[1]), add_vertex(cell[2]), add_vertex(cell[3]) });

    const Facet_matching_3 matching(soup);
    std::vector<bool> is_on_boundary(vertices().size(), false);
    for(std::size_t facet = 0; facet < 4 * cells.size(); ++facet)
      if(matching.mirror(facet) == Facet_matching_3::none)
        for(std::size_t k = 1; k < 4; ++k)
          is_on_boundary[cells[facet / 4][(facet + k) % 4]] = true;

    set_mesh(cells, [&](const std::size_t v) { return soup.points[v]; }, is_on_boundary, is_constrained, target,
             has_volume_weights);
  }

  void write(const Eigen::Matrix3Xd& image, std::vector<std::array<double, 3> >& images) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    images.assign(m_number_of_points, { nan, nan, nan });
    for(std::size_t v = 0; v < vertices().size(); ++v)
      images[vertices()[v]] = { image(0, v), image(1, v), image(2, v) };
  }

private:
  std::size_t m_number_of_points;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_SOUP_NUMBERED_SOUP_3_H
