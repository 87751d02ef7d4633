// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_EMBEDDED_BOUNDARY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_EMBEDDED_BOUNDARY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Self_intersection_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Unknowns_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The facets of a boundary that slides on surfaces. Each keeps the side of its surface that it shows at the start, also a wrong
// one. None may intersect another one unless some do at the start.
class Embedded_boundary_3
{
public:
  using Facet = std::array<int, 3>;

  Embedded_boundary_3(const Numbered_mesh_3& mesh, const Unknowns_3& unknowns, const Matrix3Xd& positions)
    : m_unknowns(unknowns), m_facets(boundary_facets_3(mesh.cells, mesh.is_parallel)),
      m_does_intersect(!Self_intersection_3(positions, m_facets).find(Budget(), 1).empty())
  {
    Matrix3Xd on_surfaces = positions;
    const Matrix3Xd normals = m_unknowns.put_on_surfaces(on_surfaces, 1, mesh.is_parallel);
    for(const Facet& facet : m_facets)
      m_signs.push_back(is_turned(facet, 1, positions, normals) ? -1 : 1);
  }

  // Returns the facets that show another side of their surfaces, with these normals, than at the start, or begin to intersect each
  // other. The search may end when there are enough of them.
  std::vector<Facet> spoilt_facets(const Matrix3Xd& positions, const Matrix3Xd& normals,
                                   const std::size_t enough = (std::numeric_limits<std::size_t>::max)()) const
  {
    std::vector<Facet> result;
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      if(is_turned(m_facets[f], m_signs[f], positions, normals))
        result.push_back(m_facets[f]);
    if(!m_does_intersect && result.size() < enough)
      for(const auto& [f, g] : Self_intersection_3(positions, m_facets).find(Budget(), enough))
        result.insert(result.end(), { m_facets[f], m_facets[g] });
    return result;
  }

private:
  // Is a facet turned over, if the normals of surfaces are multiplied by a sign?
  bool is_turned(const Facet& facet, const double sign, const Matrix3Xd& positions, const Matrix3Xd& normals) const
  {
    const auto of_vertices = [&](const auto& f) { return Matrix_3(f(facet[0]), f(facet[1]), f(facet[2])); };
    const auto normal = [&](const int v, const auto& f) { return m_unknowns.is_on_surface(v) ? sign * f(v) : Vector_3::Zero(); };
    const auto column_of = [](const Matrix3Xd& columns) { return [&](const int v) { return Vector_3(columns.col(v)); }; };
    return is_turned_3(of_vertices(column_of(positions)), of_vertices([&](const int v) { return normal(v, column_of(normals)); }),
                       [&](const Vector_3& center)
    {
      const auto at_center = [&](const int v) { return m_unknowns.put_on_surface(v, center).second; };
      return of_vertices([&](const int v) { return normal(v, at_center); });
    });
  }

  const Unknowns_3& m_unknowns;
  std::vector<Facet> m_facets;
  bool m_does_intersect; // at the start
  std::vector<double> m_signs; // -1 for facets that are turned at the start, 1 for all others
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_EMBEDDED_BOUNDARY_3_H
