// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_INTERFACE_LAYERS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_INTERFACE_LAYERS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Interface_positions_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Layers/Layer_choice_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Sides of interfaces that get a layer of hexahedra: of each quadrangle the first side, the second one, both or none.
using Interface_layers_3 = std::vector<std::array<bool, 2> >;

// Chooses layers such that no hexahedron has two quadrangles in one patch, which is smooth: a layer covers all interfaces of
// a subdomain that vertices join.
inline Interface_layers_3 interface_layers_3(const Hexahedron_soup_3& mesh, const std::vector<Interface_quadrangle_3>& quadrangles)
{
  Disjoint_sets sets(2 * quadrangles.size()); // of sides
  std::map<std::pair<std::size_t, int>, std::size_t> side_at;      // by vertex and subdomain
  std::map<std::array<std::size_t, 2>, std::size_t> side_of_cell; // by hexahedron and patch
  std::vector<std::size_t> sides_with_layer;
  for(std::size_t i = 0; i < 2 * quadrangles.size(); ++i)
  {
    const Interface_quadrangle_3& q = quadrangles[i / 2];
    const Quadrangle_of_hexahedron& side = q.sides[i % 2];
    for(const std::size_t v : q.vertices)
      sets.unite(i, side_at.emplace(std::make_pair(v, mesh.cell_references[side.cell]), i).first->second);
    if(!side_of_cell.emplace(std::array<std::size_t, 2>{ side.cell, q.patch }, i).second)
      sides_with_layer.push_back(i);
  }
  std::set<std::size_t> sets_with_layer;
  for(const std::size_t i : sides_with_layer)
    sets_with_layer.insert(sets.find(i));
  Interface_layers_3 result(quadrangles.size());
  for(std::size_t i = 0; i < 2 * quadrangles.size(); ++i)
    result[i / 2][i % 2] = sets_with_layer.count(sets.find(i)) > 0;
  return result;
}

// Adds layers along quadrangles between parts of the hexahedra, as `padded()` does along the boundary, in each part as if it were
// a body of its own: the quadrangles stay, and hexahedra of the part get copies of their vertices further inside, which remain in
// the planes of the boundary.
class Interface_padding_3
{
public:
  Interface_padding_3(const Hexahedron_soup_3& domain, const std::vector<int>& parts,
                      const std::vector<Interface_quadrangle_3>& quadrangles, const Interface_layers_3& layers)
    : m_domain(domain), m_result(domain), m_parts(parts),
      m_first_block(*std::max_element(domain.cell_blocks.begin(), domain.cell_blocks.end()) + 1)
  {
    for(std::size_t i = 0; i < quadrangles.size(); ++i)
      for(const std::size_t k : { 0, 1 })
        if(layers[i][k])
          for(const std::size_t v : quadrangles[i].vertices)
            m_copies.emplace(Vertex_in_part{ v, part(quadrangles[i].sides[k].cell) }, 0);
    make_copies();
    for(std::size_t c = 0; c < domain.cells.size(); ++c)
      for(std::size_t& v : m_result.cells[c])
        v = inner(v, part(c));
    for(std::size_t f = 0; f < domain.facets.size(); ++f)
      for(std::size_t& v : m_result.facets[f])
        v = inner(v, part(domain.facet_cells[f]));
    for(std::size_t i = 0; i < quadrangles.size(); ++i)
      for(const std::size_t k : { 0, 1 })
        if(layers[i][k])
          add_hexahedron(quadrangles[i].sides[k]);
    add_facets();
  }

  const Hexahedron_soup_3& result() const { return m_result; }

  // Returns the parts of the hexahedra of the result.
  const std::vector<int>& parts() const { return m_parts; }

private:
  using Vertex_in_part = std::pair<std::size_t, int>;

  int part(const std::size_t c) const { return m_parts[c]; }

  std::size_t inner(const std::size_t v, const int part) const
  {
    const auto found = m_copies.find({ v, part });
    return found == m_copies.end() ? v : found->second;
  }

  void make_copies()
  {
    constexpr double depth = 0.5; // a guess; part of the way to the mean center of the hexahedra around the vertex
    std::map<Vertex_in_part, std::pair<Eigen::Vector3d, int> > centers; // their sum and number
    for(std::size_t c = 0; c < m_domain.cells.size(); ++c)
    {
      Eigen::Vector3d center = Eigen::Vector3d::Zero();
      for(const std::size_t v : m_domain.cells[c])
        center += to_vector(m_domain.points[v]) / 8;
      for(const std::size_t v : m_domain.cells[c])
        if(m_copies.count({ v, part(c) }) > 0)
        {
          auto& [sum, number] = centers.try_emplace({ v, part(c) }, Eigen::Vector3d::Zero(), 0).first->second;
          sum += center;
          ++number;
        }
    }
    for(auto& [vertex, copy] : m_copies)
    {
      const auto& [sum, number] = centers.at(vertex);
      copy = m_result.points.size();
      const Eigen::Vector3d p = (1 - depth) * to_vector(m_domain.points[vertex.first]) + depth * sum / number;
      m_result.points.push_back(coordinates(p));
    }
    for(std::size_t f = 0; f < m_domain.facets.size(); ++f)
      for(const std::size_t v : m_domain.facets[f])
        if(const auto found = m_copies.find({ v, part(m_domain.facet_cells[f]) }); found != m_copies.end())
        {
          const std::size_t axis = axis_of_facet(m_domain.points, m_domain.facets[f]);
          m_result.points[found->second][axis] = m_domain.points[v][axis];
        }
  }

  // Puts a hexahedron between a quadrangle and its copy. It has the position in its block that the one below has in its own.
  void add_hexahedron(const Quadrangle_of_hexahedron& quadrangle)
  {
    const std::size_t below = quadrangle.cell;
    const auto& [a, b, c, d] = vertices_of(m_domain, quadrangle);
    const auto copy = [&](const std::size_t v) { return inner(v, part(below)); };
    const auto& axes = axes_of_quadrangle[quadrangle.side];
    const std::array<std::size_t, 3>& index = m_domain.cell_indices[below];
    m_result.cells.push_back({ copy(a), copy(b), copy(c), copy(d), a, b, c, d });
    const std::array<std::size_t, 2> block = { m_domain.cell_blocks[below], quadrangle.side };
    m_result.cell_blocks.push_back(m_first_block + m_blocks.emplace(block, m_blocks.size()).first->second);
    m_result.cell_indices.push_back({ index[axes[0]], index[axes[1]], index[3 - axes[0] - axes[1]] });
    m_result.cell_references.push_back(m_domain.cell_references[below]);
    m_parts.push_back(m_parts[below]);
  }

  // Adds the sides of layers that are on the boundary, in the face of the domain where the layer ends.
  void add_facets()
  {
    std::map<std::pair<std::array<std::size_t, 2>, int>, std::size_t> patches; // by edge and part
    std::set<std::array<std::size_t, 4> > old_facets;
    for(std::size_t f = 0; f < m_domain.facets.size(); ++f)
    {
      const std::array<std::size_t, 4>& facet = m_result.facets[f];
      old_facets.insert(sorted(facet));
      for(std::size_t i = 0; i < 4; ++i)
        patches[{ sorted(std::array<std::size_t, 2>{ facet[i], facet[(i + 1) % 4] }), part(m_domain.facet_cells[f]) }]
          = m_domain.facet_patches[f];
    }
    for(const Quadrangle_of_hexahedron& q : boundary_quadrangles_3(m_result))
    {
      const std::array<std::size_t, 4> facet = vertices_of(m_result, q);
      if(old_facets.count(sorted(facet)) > 0)
        continue;
      std::size_t patch = 0;
      for(std::size_t i = 0; i < 4; ++i)
        if(const auto found = patches.find({ sorted(std::array<std::size_t, 2>{ facet[i], facet[(i + 1) % 4] }),
                                             m_parts[q.cell] }); found != patches.end())
          patch = found->second;
      m_result.facets.push_back(facet);
      m_result.facet_cells.push_back(q.cell);
      m_result.facet_patches.push_back(patch);
    }
  }

  const Hexahedron_soup_3& m_domain;
  Hexahedron_soup_3 m_result;
  std::vector<int> m_parts; // of the hexahedra of the result
  std::map<Vertex_in_part, std::size_t> m_copies;
  std::size_t m_first_block;                                  // of layers
  std::map<std::array<std::size_t, 2>, std::size_t> m_blocks; // of layers, by block and side
};

// Returns the patches in which a quadrangle has a straight corner: two of its edges at a vertex that moves along a smooth line.
inline Patches_3 patches_with_straight_corners(const std::vector<Interface_quadrangle_3>& quadrangles,
                                               const Interface_positions_3& positions)
{
  std::map<std::array<std::size_t, 2>, Patches_3> patches_at; // edges
  const auto edge = [](const Interface_quadrangle_3& q, const std::size_t i)
  { return sorted(std::array<std::size_t, 2>{ q.vertices[i % 4], q.vertices[(i + 1) % 4] }); };
  for(const Interface_quadrangle_3& q : quadrangles)
    for(std::size_t i = 0; i < 4; ++i)
      patches_at[edge(q, i)].insert(q.patch);
  Patches_3 result;
  for(const Interface_quadrangle_3& q : quadrangles)
    for(std::size_t i = 0; i < 4; ++i)
      if(q.patch != 0 && patches_at[edge(q, i)].size() > 1 && patches_at[edge(q, i + 1)].size() > 1
         && positions.of_vertices[q.vertices[(i + 1) % 4]].freedom == Freedom_3::LINE)
        result.insert(q.patch);
  return result;
}

// Puts a layer around the hexahedra on both sides of each of these patches, so that in the patch quadrangles have one edge each
// on its lines, and updates the quadrangles of interfaces. Returns the mesh as it is if a hexahedron is at two of the patches.
inline Hexahedron_soup_3 with_enclosed_patches(const Hexahedron_soup_3& mesh, const Patches_3& patches,
                                               std::vector<Interface_quadrangle_3>& quadrangles)
{
  std::vector<int> parts(mesh.cells.size(), 0);
  std::map<std::array<std::size_t, 4>, std::size_t> old_patches;
  for(const Interface_quadrangle_3& q : quadrangles)
  {
    old_patches[sorted(q.vertices)] = q.patch;
    for(const Quadrangle_of_hexahedron& side : q.sides)
      if(int& part = parts[side.cell]; patches.count(q.patch) > 0)
      {
        if(part != 0 && part != static_cast<int>(q.patch))
          return mesh;
        part = static_cast<int>(q.patch);
      }
  }
  const std::vector<Interface_quadrangle_3> around = quadrangles_between_3(mesh, parts);
  Interface_layers_3 layers;
  for(const Interface_quadrangle_3& q : around)
    layers.push_back({ parts[q.sides[0].cell] != 0, parts[q.sides[1].cell] != 0 });
  const Interface_padding_3 padding(mesh, parts, around, layers);
  quadrangles = interface_quadrangles_3(padding.result());
  for(Interface_quadrangle_3& q : quadrangles)
  {
    const int part = padding.parts()[q.sides[0].cell];
    const bool is_in_part = part != 0 && part == padding.parts()[q.sides[1].cell];
    q.patch = is_in_part ? static_cast<std::size_t>(part) : old_patches.at(sorted(q.vertices));
  }
  return padding.result();
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_INTERFACE_LAYERS_3_H
