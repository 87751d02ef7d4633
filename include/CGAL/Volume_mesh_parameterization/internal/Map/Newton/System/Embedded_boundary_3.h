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
    : m_unknowns(unknowns), m_is_parallel(mesh.is_parallel), m_facets(boundary_facets_3(mesh.cells, mesh.is_parallel)),
      m_does_intersect(!Self_intersection_3(positions, m_facets).find(Budget(), 1).empty())
  {
    const Matrix3Xd normals = m_unknowns.normals_of_surfaces(positions, m_is_parallel);
    for(const Facet& facet : m_facets)
      m_signs.push_back(is_turned(facet, 1, positions, normals) ? -1 : 1);
  }

  // Returns the facets that show another side of their surfaces than at the start, or begin to intersect each other. The search
  // may end when there are enough of them.
  std::vector<Facet> spoilt_facets(const Matrix3Xd& positions,
                                   const std::size_t enough = (std::numeric_limits<std::size_t>::max)()) const
  {
    std::vector<Facet> result;
    const Matrix3Xd normals = m_unknowns.normals_of_surfaces(positions, m_is_parallel);
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      if(is_turned(m_facets[f], m_signs[f], positions, normals))
        result.push_back(m_facets[f]);
    if(!m_does_intersect && result.size() < enough)
      for(const auto& [f, g] : Self_intersection_3(positions, m_facets).find(Budget(), enough))
        result.insert(result.end(), { m_facets[f], m_facets[g] });
    return result;
  }

private:
  // Is the normal of a facet, multiplied by a sign, opposite to those of the surfaces at its vertices and next to its center?
  bool is_turned(const Facet& facet, const double sign, const Matrix3Xd& positions, const Matrix3Xd& normals) const
  {
    const auto& [a, b, c] = facet;
    const Vector_3 p = positions.col(a), q = positions.col(b), r = positions.col(c), normal = sign * (q - p).cross(r - p),
                   products = { normal.dot(normals.col(a)), normal.dot(normals.col(b)), normal.dot(normals.col(c)) };
    return products.maxCoeff() <= 0 && products.minCoeff() < 0
           && std::all_of(facet.begin(), facet.end(), [&](const int v)
              { return normal.dot(m_unknowns.normal_of_surface(v, (p + q + r) / 3)) <= 0; });
  }

  const Unknowns_3& m_unknowns;
  bool m_is_parallel;
  std::vector<Facet> m_facets;
  bool m_does_intersect; // at the start
  std::vector<double> m_signs; // -1 for facets that are turned at the start, 1 for all others
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_EMBEDDED_BOUNDARY_3_H
