// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_PADDING_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_PADDING_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>

#include <limits>
#include <map>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the first axis that a quadrangle is orthogonal to, as on the boundary of the domain; 3 if there is none, as in a body.
inline int axis_of_facet(const std::vector<Vector_3>& points, const std::array<std::size_t, 4>& facet)
{
  int axis = 0;
  const auto is_in_plane = [&](const std::size_t v) { return points[v][axis] == points[facet[0]][axis]; };
  while(axis < 3 && !std::all_of(facet.begin(), facet.end(), is_in_plane))
    ++axis;
  return axis;
}

// Hexahedra of a domain with layers along some of their quadrangles, in each part of the hexahedra as if it were a body of its
// own. The vertices of these quadrangles stay, and the hexahedra of the part around a vertex get a copy of it further inside,
// which remains in the planes of the other quadrangles of the boundary there. A hexahedron is put between each quadrangle and its
// copy. Where a layer ends, its sides are on the boundary, too; their quadrangles follow all others in the arrays.
class Padding_3
{
public:
  using Quadrangles = std::vector<Quadrangle_of_hexahedron>;

  // Takes the quadrangles that get a layer, as sides of the hexahedra under it, and the part of each hexahedron.
  Padding_3(const Hexahedra_3& domain, const Quadrangles& covered, const std::vector<int>& parts)
    : m_domain(domain), m_covered(covered), m_parts(parts), m_result(domain)
  {
    std::map<Quadrangle_of_hexahedron, std::size_t> numbers;
    for(std::size_t i = 0; i < covered.size(); ++i)
      numbers[covered[i]] = domain.cells.size() + i;
    for(std::size_t f = 0; f < domain.facets.size(); ++f)
    {
      const auto found = numbers.find({ domain.facet_cells[f], side_of_facet(domain, f) });
      m_cell_over_facet.push_back(found == numbers.end() ? none : found->second);
    }
    make_copies();
    move_under_layers();
    add_hexahedra();
    add_ends();
  }

  // Returns the hexahedra: those of the domain, and one for each covered quadrangle.
  const Hexahedra_3& result() const { return m_result; }

private:
  using Vertex_in_part = std::pair<std::size_t, int>;
  using Edge_in_part = std::pair<std::array<std::size_t, 2>, int>;

  bool is_covered(const std::size_t f) const { return m_cell_over_facet[f] != none; }

  // Returns the vertex that the hexahedra of a part have in place of v: its copy, or v itself if it has none.
  std::size_t inner_vertex(const std::size_t v, const int part) const
  {
    const auto found = m_copies.find({ v, part });
    return found == m_copies.end() ? v : found->second;
  }

  // Returns the i-th edge of a quadrangle of a hexahedron, with the part of the latter.
  Edge_in_part edge_in_part(const std::array<std::size_t, 4>& quadrangle, const std::size_t i, const std::size_t cell) const
  { return { edge_of_quadrangle(quadrangle, i), m_parts[cell] }; }

  // Adds the copies of vertices of covered quadrangles, further inside but in the planes of other quadrangles of the boundary.
  void make_copies()
  {
    constexpr double depth = 0.5; // a guess; part of the way to the mean center of the hexahedra around the vertex
    std::map<Vertex_in_part, std::pair<Vector_3, int> > centers; // their sum and number
    for(const Quadrangle_of_hexahedron& q : m_covered)
      for(const std::size_t v : vertices_of(m_domain, q))
        centers.try_emplace({ v, m_parts[q.cell] }, Vector_3::Zero(), 0);
    for(std::size_t c = 0; c < m_domain.cells.size(); ++c)
    {
      const Vector_3 center = center_of(m_domain.points, m_domain.cells[c]);
      for(const std::size_t v : m_domain.cells[c])
        if(const auto found = centers.find({ v, m_parts[c] }); found != centers.end())
        {
          found->second.first += center;
          ++found->second.second;
        }
    }
    for(const auto& [vertex, sum_and_number] : centers)
    {
      const auto& [sum, number] = sum_and_number;
      m_copies.emplace(vertex, m_result.points.size());
      m_result.points.push_back((1 - depth) * m_domain.points[vertex.first] + depth * sum / number);
    }
    for(std::size_t f = 0; f < m_domain.facets.size(); ++f)
      for(const std::size_t v : m_domain.facets[f])
        if(const auto found = m_copies.find({ v, m_parts[m_domain.facet_cells[f]] }); found != m_copies.end() && !is_covered(f))
        {
          if(const int axis = axis_of_facet(m_domain.points, m_domain.facets[f]); axis < 3)
            m_result.points[found->second][axis] = m_domain.points[v][axis];
        }
  }

  // Gives the cells of the domain the inner vertices, and covered facets the cells of the layers.
  void move_under_layers()
  {
    for(std::size_t c = 0; c < m_domain.cells.size(); ++c)
      for(std::size_t& v : m_result.cells[c])
        v = inner_vertex(v, m_parts[c]);
    for(std::size_t f = 0; f < m_domain.facets.size(); ++f)
      if(is_covered(f))
        m_result.facet_cells[f] = m_cell_over_facet[f];
      else
        for(std::size_t& v : m_result.facets[f])
          v = inner_vertex(v, m_parts[m_domain.facet_cells[f]]);
  }

  // Puts a hexahedron between each covered quadrangle and its copy. New hexahedra are of one block if those under them are of one
  // block, and have the same side and the same index across this side.
  void add_hexahedra()
  {
    const std::size_t last_block = *std::max_element(m_domain.cell_blocks.begin(), m_domain.cell_blocks.end());
    std::map<std::array<std::size_t, 3>, std::size_t> blocks; // new ones, by old block, side, and index across the side
    for(const Quadrangle_of_hexahedron& q : m_covered)
    {
      const auto& [a, b, c, d] = vertices_of(m_domain, q);
      const auto copy = [this, part = m_parts[q.cell]](const std::size_t v) { return inner_vertex(v, part); };
      const auto& [u, v] = axes_of_quadrangle[q.side];
      const std::array<std::size_t, 3>& index = m_domain.cell_indices[q.cell];
      const std::array<std::size_t, 3> key = { m_domain.cell_blocks[q.cell], q.side, index[3 - u - v] };
      add_cell({ copy(a), copy(b), copy(c), copy(d), a, b, c, d },
               blocks.emplace(key, last_block + 1 + blocks.size()).first->second, { index[u], index[v], 0 },
               m_domain.cell_references[q.cell], m_result);
    }
  }

  // Adds the sides of layers where these end: a side over an edge of one covered quadrangle alone is in the face of the domain
  // that has the edge, too. Side 2 + i of a hexahedron of a layer is over edge i of its quadrangle.
  void add_ends()
  {
    std::map<Edge_in_part, std::size_t> faces; // that are not covered
    std::map<Edge_in_part, std::vector<Quadrangle_of_hexahedron> > sides; // of hexahedra of layers
    for(std::size_t f = 0; f < m_domain.facets.size(); ++f)
      for(std::size_t i = 0; i < 4 && !is_covered(f); ++i)
        faces[edge_in_part(m_domain.facets[f], i, m_domain.facet_cells[f])] = m_domain.polycube_faces[f];
    for(std::size_t k = 0; k < m_covered.size(); ++k)
      for(std::size_t i = 0; i < 4; ++i)
        sides[edge_in_part(vertices_of(m_domain, m_covered[k]), i, m_covered[k].cell)]
          .push_back({ m_domain.cells.size() + k, 2 + i });
    for(const auto& [edge, at_edge] : sides)
      if(at_edge.size() == 1)
        add_facet(at_edge[0], faces.at(edge), m_result);
  }

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  const Hexahedra_3& m_domain;
  const Quadrangles& m_covered;
  const std::vector<int>& m_parts;
  Hexahedra_3 m_result;
  std::vector<std::size_t> m_cell_over_facet; // of the result; `none` if a facet is not covered
  std::map<Vertex_in_part, std::size_t> m_copies;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_PADDING_3_H
