// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_LAYER_REMOVAL_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_LAYER_REMOVAL_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/Feature_embedding_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Removes the layer along the boundary where the hexahedra under it fit the dihedral angles of the body. The layer stays under
// quadrangles with another angle at an edge. It ends at curves under which one hexahedron has the quadrangles on both sides.
class Layer_removal_3
{
public:
  // Takes the complex of the body, paths for its arcs, hexahedra with a layer along the boundary, and the regions whose layer
  // stays. Regions beside these keep their layer, too.
  Layer_removal_3(const Body_complex_3& complex, const Feature_embedding_3& embedding, const Hexahedra_3& mesh,
                  const std::set<std::size_t>& kept_regions)
    : m_complex(complex), m_embedding(embedding), m_graph(embedding.graph()), m_mesh(mesh),
      m_arc_of_edge(m_graph.number_of_edges(), none), m_inner(mesh.points.size(), none)
  {
    for(std::size_t a = 0; a < complex.arcs().size(); ++a)
      for(const std::size_t e : embedding.path(a))
        m_arc_of_edge[e] = m_arc_of_edge[m_graph.opposite(e)] = a;
    const std::set<std::size_t> kept_facets = find_inner_vertices();
    find_layers(kept_regions, kept_facets);
    while(keep_more_layers())
      ;
    make_result();
  }

  const Hexahedra_3& result() const { return m_result; }

  // Returns the old quadrangle of each new one. At the end of a layer, it is the one on the other side of the curve.
  const std::vector<std::size_t>& facets() const { return m_facets; }

  // Returns the new number of a vertex of the boundary, or that of the one under it where the layer is gone.
  std::size_t vertex(const std::size_t v) const { return m_numbers[is_kept(v) ? v : m_inner[v]]; }

  // Returns the new vertices of a path. It is longer where it goes on along the end of a layer.
  std::vector<std::size_t> path(const std::vector<std::size_t>& vertices) const
  {
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      if(i > 0)
      {
        const std::size_t e = m_graph.edge(vertices[i - 1], vertices[i]);
        if(!is_kept_left_of(e) && !is_kept_left_of(m_graph.opposite(e)))
          for(const std::size_t v : { vertices[i - 1], vertices[i] })
            if(is_kept(v))
              result.push_back(m_numbers[m_inner[v]]);
      }
      result.push_back(vertex(vertices[i]));
    }
    return result;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Returns whether the layer under a quadrangle stays, or under the one on the left of an edge.
  bool is_kept_facet(const std::size_t f) const { return m_is_kept[m_layers[f]]; }
  bool is_kept_left_of(const std::size_t e) const { return is_kept_facet(m_graph.left(e)); }

  // Returns whether a vertex has a quadrangle whose layer stays.
  bool is_kept(const std::size_t v) const
  {
    for(std::size_t e = m_graph.first(v); e < m_graph.first(v + 1); ++e)
      if(is_kept_left_of(e))
        return true;
    return false;
  }

  // Returns the quadrangle on the other side of the layer.
  Quadrangle_of_hexahedron under(const std::size_t f) const
  {
    constexpr std::array<std::size_t, 6> opposite_sides = { 1, 0, 4, 5, 2, 3 }; // of quadrangles_of_hexahedron
    return { m_mesh.facet_cells[f], opposite_sides[side_of_facet(m_mesh, f)] };
  }

  // Finds the vertex under each vertex of the boundary, across the layer. Returns quadrangles for which it is not the same as for
  // an earlier quadrangle: their layer cannot go.
  std::set<std::size_t> find_inner_vertices()
  {
    std::set<std::size_t> result;
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
    {
      const std::array<std::size_t, 4> bottom = vertices_of(m_mesh, under(f));
      const std::array<std::size_t, 8>& cell = m_mesh.cells[m_mesh.facet_cells[f]];
      for(const std::size_t v : m_mesh.facets[f])
        for(const std::array<std::size_t, 4>& corner : corners_of_hexahedron)
          for(std::size_t i = 1; i < 4 && cell[corner[0]] == v; ++i)
            if(const std::size_t w = cell[corner[i]]; std::find(bottom.begin(), bottom.end(), w) != bottom.end())
            {
              if(m_inner[v] != none && m_inner[v] != w)
                result.insert(f);
              m_inner[v] = w;
            }
    }
    return result;
  }

  // Returns whether so many hexahedra can share an angle, which is in degrees.
  static bool is_divisible(const double angle, const std::size_t number)
  {
    constexpr double largest_deviation = 40; // a guess; in degrees
    return number > 0 && std::abs(angle / static_cast<double>(number) - 90) <= largest_deviation;
  }

  // Returns the angle of the body at an edge of the boundary, in degrees: 180 if the edge is in no path.
  double dihedral_angle(const std::size_t e) const
  {
    constexpr double part_of_line = 0.01; // a guess
    const std::size_t a = m_arc_of_edge[e];
    if(a == none)
      return 180;
    const Polyline_3& line = m_complex.line(a);
    const double length = line.nearest((m_mesh.points[m_graph.source(e)] + m_mesh.points[m_graph.target(e)]) / 2).second,
                 step = part_of_line * line.length();
    const Vector_3 p = line.point(length),
                   along = line.point((std::min)(length + step, line.length())) - line.point((std::max)(length - step, 0.));
    const auto& [left, right] = m_complex.arcs()[a].patches;
    const Vector_3 n = m_complex.surface(left).normal(p), m = m_complex.surface(right).normal(p);
    return 180 - 180 / CGAL_PI * std::atan2(along.stableNormalized().dot(n.cross(m)), n.dot(m));
  }

  // Joins quadrangles that keep or lose their layer together. Keeps the layer of given regions and quadrangles, and where
  // hexahedra under it do not fit the angle at an edge.
  void find_layers(const std::set<std::size_t>& kept_regions, const std::set<std::size_t>& kept_facets)
  {
    const auto is_kept_in_any_case = [&](const std::size_t f)
    { return kept_facets.count(f) > 0 || kept_regions.count(m_embedding.region(f)) > 0; };
    std::vector<bool> is_in_layer(m_mesh.cells.size(), false);
    for(const std::size_t c : m_mesh.facet_cells)
      is_in_layer[c] = true;
    std::map<std::array<std::size_t, 2>, std::size_t> numbers; // of hexahedra under the layer at each edge
    for(std::size_t c = 0; c < m_mesh.cells.size(); ++c)
      for(const std::array<std::size_t, 4>& corner : corners_of_hexahedron)
        for(std::size_t i = 1; i < 4 && !is_in_layer[c]; ++i)
          if(corner[0] < corner[i])
            ++numbers[sorted(std::array<std::size_t, 2>{ m_mesh.cells[c][corner[0]], m_mesh.cells[c][corner[i]] })];
    Disjoint_sets sets(m_mesh.facets.size());
    std::set<std::size_t> kept;
    for(std::size_t e = 0; e < m_graph.number_of_edges(); ++e)
    {
      const std::size_t f = m_graph.left(e), g = m_graph.left(m_graph.opposite(e));
      const std::size_t number
        = numbers[sorted(std::array<std::size_t, 2>{ m_inner[m_graph.source(e)], m_inner[m_graph.target(e)] })];
      const bool is_good = is_divisible(dihedral_angle(e), number);
      if(number != 1 || !is_good || is_kept_in_any_case(f) || is_kept_in_any_case(g))
        sets.unite(f, g);
      if(!is_good || is_kept_in_any_case(f))
        kept.insert(f);
    }
    m_layers = sets.numbers();
    m_is_kept.assign(m_layers.size(), false);
    for(const std::size_t f : kept)
      m_is_kept[m_layers[f]] = true;
  }

  // Keeps all layers at vertices where they cannot end: an end has two edges, at most one curve that goes on along it, and an
  // angle that its hexahedra can share. Returns whether there was such a vertex.
  bool keep_more_layers()
  {
    bool has_changed = false;
    for(std::size_t v = 0; v < m_mesh.points.size(); ++v)
    {
      if(m_graph.degree(v) == 0)
        continue;
      std::size_t number_of_ends = 0, number_kept = 0, number_of_curves = 0;
      double angle = 180;
      for(std::size_t e = m_graph.first(v); e < m_graph.first(v + 1); ++e)
      {
        const bool left = is_kept_left_of(e), right = is_kept_left_of(m_graph.opposite(e));
        number_kept += left;
        number_of_ends += left != right;
        if(!left && !right && m_arc_of_edge[e] != none)
        {
          ++number_of_curves;
          angle = dihedral_angle(e);
        }
      }
      if(number_of_ends == 0 || (number_of_ends == 2 && number_of_curves <= 1 && is_divisible(angle, number_kept)))
        continue;
      has_changed = true;
      for(std::size_t e = m_graph.first(v); e < m_graph.first(v + 1); ++e)
        m_is_kept[m_layers[m_graph.left(e)]] = true;
    }
    return has_changed;
  }

  // Sets the result, the new numbers of its vertices, and the old quadrangles of its boundary.
  void make_result()
  {
    std::map<std::array<std::size_t, 4>, std::size_t> old_facets; // of quadrangles under layers that go, and at ends of others
    std::vector<bool> is_removed(m_mesh.cells.size(), false);
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      if(!is_kept_facet(f))
      {
        is_removed[m_mesh.facet_cells[f]] = true;
        old_facets[sorted(vertices_of(m_mesh, under(f)))] = f;
      }
    for(std::size_t e = 0; e < m_graph.number_of_edges(); ++e)
      if(!is_kept_left_of(e) && is_kept_left_of(m_graph.opposite(e)))
      {
        const std::size_t v = m_graph.source(e), w = m_graph.target(e);
        old_facets[sorted(std::array<std::size_t, 4>{ v, w, m_inner[v], m_inner[w] })] = m_graph.left(e);
      }
    std::vector<std::size_t> numbers_of_cells;
    for(std::size_t c = 0; c < m_mesh.cells.size(); ++c)
    {
      numbers_of_cells.push_back(m_result.cells.size());
      if(!is_removed[c])
        add_cell(m_mesh.cells[c], m_mesh.cell_blocks[c], m_mesh.cell_indices[c], m_mesh.cell_references[c], m_result);
    }
    const std::vector<bool> is_used = used_points(m_result.cells, m_mesh.points.size());
    for(std::size_t v = 0; v < is_used.size(); ++v)
    {
      m_numbers.push_back(m_result.points.size());
      if(is_used[v])
        m_result.points.push_back(m_mesh.points[v]);
    }
    for(std::array<std::size_t, 8>& cell : m_result.cells)
      for(std::size_t& v : cell)
        v = m_numbers[v];
    const auto add = [&](const Quadrangle_of_hexahedron& quadrangle, const std::size_t old_facet)
    {
      add_facet({ numbers_of_cells[quadrangle.cell], quadrangle.side }, m_mesh.polycube_faces[old_facet], m_result);
      m_facets.push_back(old_facet);
    };
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      if(is_kept_facet(f))
        add({ m_mesh.facet_cells[f], side_of_facet(m_mesh, f) }, f);
    for_each_quadrangle(m_mesh, [&](const auto begin, const auto end)
    {
      const auto found = old_facets.find(begin->first);
      if(found == old_facets.end())
        return;
      for(auto it = begin; it != end; ++it)
        if(!is_removed[it->second.cell])
          add(it->second, found->second);
    });
  }

  const Body_complex_3& m_complex;
  const Feature_embedding_3& m_embedding;
  const Boundary_graph_3& m_graph;
  const Hexahedra_3& m_mesh;
  std::vector<std::size_t> m_arc_of_edge, m_inner; // the latter under each vertex of the boundary
  std::vector<std::size_t> m_layers;               // of quadrangles: those that stay or go together
  std::vector<bool> m_is_kept;                     // of layers
  Hexahedra_3 m_result;
  std::vector<std::size_t> m_numbers, m_facets;    // new vertices, old quadrangles
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_LAYER_REMOVAL_3_H
