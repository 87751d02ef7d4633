// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_LABEL_FUNCTIONAL_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_LABEL_FUNCTIONAL_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_charts_3.h>

#include <algorithm>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Terms of the functional that labels of faces lower, as Livesu et al., PolyCut: monotone graph-cuts for polycube
// base-complex construction (2013):
//   sum over faces f of area(f) (1 - n(f) . direction(label(f)))
//   + smoothing sum over edges between faces f, g of different labels of length max(0, n(f) . n(g))^2.
// Sharp edges are free.
class Label_functional_3
{
public:
  using Face = Boundary_mesh_3::Face_index;

  // Takes a surface of diameter about 1, such that lengths and areas compare, and whether each of its edges is sharp.
  Label_functional_3(const Boundary_mesh_3& mesh, const std::vector<bool>& is_sharp) : m_mesh(mesh), m_is_sharp(is_sharp)
  {
    for(const Face f : mesh.faces())
    {
      const Facet_edges_3 X = edges_of_face(mesh, f);
      m_area_vectors.push_back(X[0].cross(X[1]) / 2);
    }
  }

  // Returns the term of a face.
  double cost(const Face f, const std::size_t label) const
  { return m_area_vectors[f].norm() - m_area_vectors[f].dot(vector_of_direction(label)); }

  // Returns the term of an edge between faces of different labels, without the smoothing.
  double length(const Boundary_mesh_3::Halfedge_index h) const
  {
    const Vector_3 &a = m_area_vectors[m_mesh.face(h)], &b = m_area_vectors[m_mesh.face(m_mesh.opposite(h))];
    const double cosine = (std::max)(0., a.normalized().dot(b.normalized()));
    return (m_is_sharp[m_mesh.edge(h)] ? 0 : cosine * cosine) * edge_vector(m_mesh, h).norm();
  }

private:
  const Boundary_mesh_3& m_mesh;
  const std::vector<bool> m_is_sharp;
  std::vector<Vector_3> m_area_vectors; // normal times area
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_LABEL_FUNCTIONAL_3_H
