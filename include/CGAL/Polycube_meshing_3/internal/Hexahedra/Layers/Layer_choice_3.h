// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_LAYER_CHOICE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_LAYER_CHOICE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Layers/Padding_3.h>

#include <set>

namespace CGAL::Polycube_meshing_3::internal {

// Edge of a hexahedron on an edge of the domain, with two quadrangles of the boundary, of different faces, that have the edge.
struct Edge_of_domain_3
{
  std::array<std::size_t, 2> vertices, facets;
  bool is_manifold; // whether no more quadrangles have the edge
};

// Returns the edges between quadrangles of different faces. If more than two quadrangles have an edge, it comes several times.
inline std::vector<Edge_of_domain_3> edges_of_domain_3(const Hexahedra_3& domain)
{
  std::vector<Edge_of_domain_3> result;
  for_each_group(4 * domain.facets.size(), [&](const std::size_t i)
  {
    const std::array<std::size_t, 4>& facet = domain.facets[i / 4];
    return std::make_pair(edge_of_quadrangle(facet, i % 4), i / 4);
  },
  [&](const auto begin, const auto end)
  {
    for(auto it = begin + 1; it != end; ++it)
      if(domain.polycube_faces[begin->second] != domain.polycube_faces[it->second])
        result.push_back({ begin->first, { begin->second, it->second }, end - begin == 2 });
  });
  return result;
}

// Faces of the domain, by their numbers in `polycube_faces`, that a layer of hexahedra covers.
using Covered_faces_3 = std::set<std::size_t>;

inline Covered_faces_3 all_faces_of_domain(const Hexahedra_3& domain)
{ return Covered_faces_3(domain.polycube_faces.begin(), domain.polycube_faces.end()); }

// Chooses layers of hexahedra such that no corner of a hexahedron on the boundary needs to be almost straight. Where two
// quadrangles are nearly in one plane at a convex edge of the domain, a layer covers both sides. The layer ends at other
// convex edges, on the faces behind, which then have two quadrangles where a corner of one would be straight. At a vertex, a
// layer ends only if it covers one part of the faces there, and there is a direction for its depth. (After Cherchi, Alliez,
// Scateni, Lyon, Bommes: Selective padding for polycube-based hexahedral meshing, 2019, who minimize a distortion.)
class Layer_choice_3
{
public:
  // Takes the hexahedra of the body, with their images in the domain.
  explicit Layer_choice_3(const Hexahedra_3& mesh)
    : m_mesh(mesh), m_edges(edges_of_domain_3(mesh)), m_faces(all_faces_of_domain(mesh)), m_sets(m_faces.size() + 1)
  {
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      if(needs_layer(m_edges[e]) || !m_edges[e].is_manifold || is_concave(m_edges[e]))
        m_sets.unite(face_beside(e, 0), face_beside(e, 1));
  }

  // Returns the layers, each as the faces that it covers; none if no edge needs a layer.
  std::vector<Covered_faces_3> layers()
  {
    std::set<std::size_t> sets;
    do
    {
      sets.clear();
      for(std::size_t e = 0; e < m_edges.size(); ++e)
        if(needs_layer(m_edges[e]))
          sets.insert(m_sets.find(face_beside(e, 0)));
    }
    while(std::any_of(sets.begin(), sets.end(), [this](const std::size_t set) { return extend_layer(faces_in(set)); }));
    std::vector<Covered_faces_3> result;
    for(const std::size_t set : sets)
      result.push_back(faces_in(set));
    return result;
  }

private:
  // Returns the face on side 0 or 1 of an edge of the domain.
  std::size_t face_beside(const std::size_t e, const std::size_t side) const
  { return m_mesh.polycube_faces[m_edges[e].facets[side]]; }

  static Vector_3 normal(const std::vector<Vector_3>& points, const std::array<std::size_t, 4>& f)
  { return area_vector(points, f).stableNormalized(); }

  // Returns whether the domain, not the body, is concave at an edge.
  bool is_concave(const Edge_of_domain_3& edge) const
  {
    const std::array<std::size_t, 4>&f = m_mesh.facets[edge.facets[0]], &g = m_mesh.facets[edge.facets[1]];
    const auto& images = m_mesh.images;
    return normal(images, f).dot(images[g[0]] + images[g[2]] - 2 * images[f[0]]) > 0;
  }

  // Returns whether an edge is convex in the domain, but almost flat in the body.
  bool needs_layer(const Edge_of_domain_3& edge) const
  {
    constexpr double cosine_of_smooth_edge = 0.7; // a guess; 45 degrees between normals
    const Vector_3 n = normal(m_mesh.points, m_mesh.facets[edge.facets[0]]);
    return !is_concave(edge) && n.dot(normal(m_mesh.points, m_mesh.facets[edge.facets[1]])) > cosine_of_smooth_edge;
  }

  Covered_faces_3 faces_in(const std::size_t set)
  {
    Covered_faces_3 result;
    for(const std::size_t face : m_faces)
      if(m_sets.find(face) == set)
        result.insert(face);
    return result;
  }

  // Joins other faces to a layer at vertices where it cannot end. Returns whether there was such a vertex.
  bool extend_layer(const Covered_faces_3& layer)
  {
    constexpr std::size_t none = 0; // faces are numbered from 1
    std::vector<int> number_of_ends(m_mesh.points.size(), 0); // edges at each vertex between a covered face and another one
    std::vector<std::array<bool, 3> > is_held(m_mesh.points.size()); // along each axis, by faces that are not covered
    std::vector<std::size_t> covered_face(m_mesh.points.size(), none); // one at each vertex
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      for(const std::size_t v : m_mesh.facets[f])
        if(layer.count(m_mesh.polycube_faces[f]) > 0)
          covered_face[v] = m_mesh.polycube_faces[f];
        else
          is_held[v][axis_of_facet(m_mesh.images, m_mesh.facets[f])] = true;
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      for(const std::size_t v : m_edges[e].vertices)
        number_of_ends[v] += layer.count(face_beside(e, 0)) != layer.count(face_beside(e, 1));
    bool has_changed = false;
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      for(const std::size_t v : m_mesh.facets[f])
        if(layer.count(m_mesh.polycube_faces[f]) == 0 && covered_face[v] != none
           && (number_of_ends[v] != 2 || is_held[v] == std::array<bool, 3>{ true, true, true }))
        {
          m_sets.unite(m_mesh.polycube_faces[f], covered_face[v]);
          has_changed = true;
        }
    return has_changed;
  }

  const Hexahedra_3& m_mesh;
  const std::vector<Edge_of_domain_3> m_edges;
  const Covered_faces_3 m_faces; // all, numbered from 1
  Disjoint_sets m_sets; // faces that belong to one layer
};

// Returns the quadrangles of the boundary in faces of the domain, as sides of their hexahedra.
inline std::vector<Quadrangle_of_hexahedron> quadrangles_in(const Hexahedra_3& mesh, const Covered_faces_3& faces)
{
  std::vector<Quadrangle_of_hexahedron> result;
  for(std::size_t f = 0; f < mesh.facets.size(); ++f)
    if(faces.count(mesh.polycube_faces[f]) > 0)
      result.push_back({ mesh.facet_cells[f], side_of_facet(mesh, f) });
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_LAYER_CHOICE_3_H
