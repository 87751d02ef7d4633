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

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/hexahedron_corners_3.h>

#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Edge of a hexahedron on an edge of the domain, with the quadrangles on both sides.
struct Edge_of_domain_3
{
  std::array<std::size_t, 2> vertices, facets;
  bool is_manifold; // whether no more quadrangles have the edge
};

inline std::vector<Edge_of_domain_3> edges_of_domain_3(const Hexahedron_soup_3& domain)
{
  std::vector<Edge_of_domain_3> result;
  for_each_group(4 * domain.facets.size(), [&](const std::size_t i)
  {
    const std::array<std::size_t, 4>& facet = domain.facets[i / 4];
    return std::make_pair(sorted(std::array<std::size_t, 2>{ facet[i % 4], facet[(i + 1) % 4] }), i / 4);
  },
  [&](const auto begin, const auto end)
  {
    for(auto it = begin + 1; it != end; ++it)
      if(domain.facet_patches[begin->second] != domain.facet_patches[it->second])
        result.push_back({ begin->first, { begin->second, it->second }, end - begin == 2 });
  });
  return result;
}

// Returns the axis that a quadrangle of the boundary of the domain is orthogonal to.
inline std::size_t axis_of_facet(const std::vector<std::array<double, 3> >& points, const std::array<std::size_t, 4>& facet)
{
  std::size_t axis = 0;
  const auto is_in_plane = [&](const std::size_t v) { return points[v][axis] == points[facet[0]][axis]; };
  while(!std::all_of(facet.begin(), facet.end(), is_in_plane))
    ++axis;
  return axis;
}

// Faces of the domain, by their numbers in `facet_patches`, that a layer of hexahedra is put along.
using Layer_3 = std::set<std::size_t>;

inline Layer_3 layer_along_boundary(const Hexahedron_soup_3& domain)
{
  return Layer_3(domain.facet_patches.begin(), domain.facet_patches.end());
}

// Chooses layers of hexahedra such that no corner of a hexahedron on the boundary needs to be almost straight. Where two
// quadrangles are nearly in one plane at a convex edge of the domain, a layer covers both sides. The layer ends at other
// convex edges, on the faces behind, which then have two quadrangles where a corner of one would be straight. At a vertex, a
// layer ends only if it covers one part of the faces there, and there is a direction for its depth. (After Cherchi, Alliez,
// Scateni, Lyon, Bommes: Selective padding for polycube-based hexahedral meshing, 2019, who minimize a distortion.)
class Layer_choice_3
{
public:
  // Takes the hexahedra of the body, with their images in the domain.
  explicit Layer_choice_3(const Hexahedron_soup_3& mesh)
    : m_mesh(mesh), m_edges(edges_of_domain_3(mesh)), m_patches(layer_along_boundary(mesh)), m_sets(m_patches.size() + 1)
  {
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      if(needs_layer(m_edges[e]) || !m_edges[e].is_manifold || is_concave(m_edges[e]))
        m_sets.unite(patch(e, 0), patch(e, 1));
  }

  std::vector<Layer_3> layers()
  {
    std::set<std::size_t> sets;
    do
    {
      sets.clear();
      for(std::size_t e = 0; e < m_edges.size(); ++e)
        if(needs_layer(m_edges[e]))
          sets.insert(m_sets.find(patch(e, 0)));
    }
    while(std::any_of(sets.begin(), sets.end(), [this](const std::size_t set) { return grow(layer_of(set)); }));
    std::vector<Layer_3> result;
    for(const std::size_t set : sets)
      result.push_back(layer_of(set));
    return result;
  }

private:
  std::size_t patch(const std::size_t e, const std::size_t side) const
  {
    return m_mesh.facet_patches[m_edges[e].facets[side]];
  }

  static Eigen::Vector3d point(const std::vector<std::array<double, 3> >& points, const std::size_t v)
  {
    return to_vector(points[v]);
  }

  static Eigen::Vector3d normal(const std::vector<std::array<double, 3> >& points, const std::array<std::size_t, 4>& f)
  {
    return area_vector(points, f).stableNormalized();
  }

  bool is_concave(const Edge_of_domain_3& edge) const
  {
    const std::array<std::size_t, 4>&f = m_mesh.facets[edge.facets[0]], &g = m_mesh.facets[edge.facets[1]];
    const auto& images = m_mesh.images;
    return normal(images, f).dot(point(images, g[0]) + point(images, g[2]) - 2 * point(images, f[0])) > 0;
  }

  bool needs_layer(const Edge_of_domain_3& edge) const
  {
    constexpr double cosine_of_smooth_edge = 0.7; // a guess; 45 degrees between normals
    const Eigen::Vector3d n = normal(m_mesh.points, m_mesh.facets[edge.facets[0]]);
    return !is_concave(edge) && n.dot(normal(m_mesh.points, m_mesh.facets[edge.facets[1]])) > cosine_of_smooth_edge;
  }

  Layer_3 layer_of(const std::size_t set)
  {
    Layer_3 result;
    for(const std::size_t p : m_patches)
      if(m_sets.find(p) == set)
        result.insert(p);
    return result;
  }

  // Adds faces to a layer at vertices where it cannot end. Returns whether there was such a vertex.
  bool grow(const Layer_3& layer)
  {
    constexpr std::size_t none = 0; // faces are numbered from 1
    std::vector<int> number_of_ends(m_mesh.points.size(), 0);
    std::vector<std::array<bool, 3> > is_held(m_mesh.points.size());
    std::vector<std::size_t> covered(m_mesh.points.size(), none);
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      for(const std::size_t v : m_mesh.facets[f])
        if(layer.count(m_mesh.facet_patches[f]) > 0)
          covered[v] = m_mesh.facet_patches[f];
        else
          is_held[v][axis_of_facet(m_mesh.images, m_mesh.facets[f])] = true;
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      for(const std::size_t v : m_edges[e].vertices)
        number_of_ends[v] += layer.count(patch(e, 0)) != layer.count(patch(e, 1));
    bool has_changed = false;
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      for(const std::size_t v : m_mesh.facets[f])
        if(layer.count(m_mesh.facet_patches[f]) == 0 && covered[v] != none
           && (number_of_ends[v] != 2 || is_held[v] == std::array<bool, 3>{ true, true, true }))
        {
          m_sets.unite(m_mesh.facet_patches[f], covered[v]);
          has_changed = true;
        }
    return has_changed;
  }

  const Hexahedron_soup_3& m_mesh;
  const std::vector<Edge_of_domain_3> m_edges;
  const Layer_3 m_patches; // all faces, numbered from 1
  Disjoint_sets m_sets; // faces that belong to one layer
};

// Returns the points of the copies of vertices that the hexahedra under a layer get. Copies remain in the planes of the facets at
// a vertex that have no layer.
inline std::vector<Eigen::Vector3d> inner_points_3(const Hexahedron_soup_3& domain, const Layer_3& layer)
{
  constexpr double depth = 0.5; // a guess; part of the way to the mean center of the hexahedra around the vertex
  std::vector<Eigen::Vector3d> result(domain.points.size(), Eigen::Vector3d::Zero());
  std::vector<int> number(domain.points.size(), 0);
  for(const std::array<std::size_t, 8>& cell : domain.cells)
  {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for(const std::size_t v : cell)
      center += to_vector(domain.points[v]) / 8;
    for(const std::size_t v : cell)
    {
      result[v] += center;
      ++number[v];
    }
  }
  for(std::size_t v = 0; v < result.size(); ++v)
    result[v] = (1 - depth) * to_vector(domain.points[v]) + depth * result[v] / number[v];
  for(std::size_t f = 0; f < domain.facets.size(); ++f)
    for(const std::size_t v : domain.facets[f])
      if(const std::size_t axis = axis_of_facet(domain.points, domain.facets[f]); layer.count(domain.facet_patches[f]) == 0)
        result[v][axis] = domain.points[v][axis];
  return result;
}

// Adds a layer: each vertex of the covered faces stays, and the hexahedra around the vertex get a copy further inside; a
// hexahedron is put between each quadrangle and its copy. Where the layer ends, its sides are on the boundary, too; their
// quadrangles follow all others in the arrays.
inline Hexahedron_soup_3 padded(const Hexahedron_soup_3& mesh, const Layer_3& layer)
{
  const auto is_padded = [&](const std::size_t f) { return layer.count(mesh.facet_patches[f]) > 0; };
  Hexahedron_soup_3 result = mesh;
  const std::vector<Eigen::Vector3d> inner_points = inner_points_3(mesh, layer);
  std::vector<std::size_t> inner(mesh.points.size());
  std::vector<bool> is_covered(mesh.points.size(), false);
  for(std::size_t f = 0; f < mesh.facets.size(); ++f)
    for(const std::size_t v : mesh.facets[f])
      is_covered[v] = is_covered[v] || is_padded(f);
  for(std::size_t v = 0; v < inner.size(); ++v)
  {
    inner[v] = is_covered[v] ? result.points.size() : v;
    if(is_covered[v])
      result.points.push_back(coordinates(inner_points[v]));
  }
  for(std::array<std::size_t, 8>& cell : result.cells)
    for(std::size_t& v : cell)
      v = inner[v];
  std::map<std::array<std::size_t, 2>, std::size_t> blocks; // by block and face
  const std::size_t number_of_blocks = *std::max_element(mesh.cell_blocks.begin(), mesh.cell_blocks.end());
  for(std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    const auto& [a, b, c, d] = mesh.facets[f];
    if(!is_padded(f))
    {
      result.facets[f] = { inner[a], inner[b], inner[c], inner[d] };
      continue;
    }
    const std::size_t below = mesh.facet_cells[f];
    const auto& axes = axes_of_quadrangle[side_of_facet(mesh, f)];
    const auto& index = mesh.cell_indices[below];
    result.facet_cells[f] = result.cells.size();
    result.cells.push_back({ inner[a], inner[b], inner[c], inner[d], a, b, c, d });
    result.cell_blocks.push_back(blocks.emplace(std::array<std::size_t, 2>{ mesh.cell_blocks[below], mesh.facet_patches[f] },
                                                number_of_blocks + blocks.size() + 1).first->second);
    result.cell_indices.push_back({ index[axes[0]], index[axes[1]], 0 });
    result.cell_references.push_back(mesh.cell_references[below]);
  }
  for(const Edge_of_domain_3& edge : edges_of_domain_3(mesh))
    for(const std::size_t side : { 0, 1 })
      if(const std::size_t f = edge.facets[side], g = edge.facets[1 - side]; is_padded(f) && !is_padded(g))
      {
        const std::array<std::size_t, 4>& facet = mesh.facets[f];
        std::size_t i = 0;
        while(sorted(std::array<std::size_t, 2>{ facet[i], facet[(i + 1) % 4] }) != edge.vertices)
          ++i;
        result.facets.push_back(vertices_of(result, { result.facet_cells[f], 2 + i }));
        result.facet_cells.push_back(result.facet_cells[f]);
        result.facet_patches.push_back(mesh.facet_patches[g]);
      }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_LAYER_CHOICE_3_H
