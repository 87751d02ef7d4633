// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_EXPANSION_CORE_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_EXPANSION_CORE_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// A map of a mesh to a star-shaped domain in which some free vertices, the core, have the same image, a point that sees all of the
// boundary. Cells with one vertex in the core or none are open; others are flat. The open cells fill the domain. Vertices leave
// the core one by one, as in Nigolian et al., Expansion Cones: A Progressive Volumetric Mapping Framework (TOG 2023).
class Core_map_3
{
public:
  struct Side // of a cell, opposite to its vertex
  {
    int cell;
    int vertex;
  };

  Core_map_3(const Numbered_mesh_3& mesh, const Vector_3& center)
    : m_mesh(mesh), m_cells(mesh.cells), m_center(center), m_size(mesh.number_of_free_vertices),
      m_positions(mesh.number_of_vertices(), center), m_is_in_core(m_positions.size(), false), m_sides(m_positions.size())
  {
    for(int v = m_size; v < mesh.number_of_vertices(); ++v)
      m_positions[v] = mesh.target.col(v);
    std::fill_n(m_is_in_core.begin(), m_size, true);
    for(std::size_t c = 0; c < m_cells.size(); ++c)
      for(int i = 0; i < 4; ++i)
        m_sides[m_cells[c][i]].push_back({ static_cast<int>(c), i });
  }

  int size() const { return m_size; } // of the core
  int number_of_vertices() const { return static_cast<int>(m_positions.size()); } // those of the mesh, and others after them
  const Vector_3& position(const int v) const { return m_positions[v]; }
  void set_position(const int v, const Vector_3& p) { m_positions[v] = p; }
  bool is_in_core(const int v) const { return m_is_in_core[v]; }
  bool is_new(const int v) const { return v >= m_mesh.number_of_vertices(); }
  bool is_prescribed(const int v) const { return !m_mesh.is_free(v) && !is_new(v); }
  bool moves(const int v) const { return !is_prescribed(v) && !is_in_core(v); }
  const std::vector<Side>& sides(const int v) const { return m_sides[v]; }
  std::array<int, 3> facet(const Side& side) const { return facet_of_cell(m_cells[side.cell], side.vertex); }

  template <typename Simplex>
  int number_in_core(const Simplex& simplex) const
  { return static_cast<int>(std::count_if(simplex.begin(), simplex.end(), [&](const int v) { return is_in_core(v); })); }
  bool is_open(const int c) const { return number_in_core(m_cells[c]) <= 1; }

  std::size_t number_of_flat_cells() const
  {
    return static_cast<std::size_t>(std::count_if(m_cells.begin(), m_cells.end(),
                                                  [&](const auto& cell) { return number_in_core(cell) > 1; }));
  }

  Matrix_3 edges_from(const Vector_3& p, const std::array<int, 3>& facet) const
  { return { position(facet[0]) - p, position(facet[1]) - p, position(facet[2]) - p }; }
  Matrix_3 edges_of_cell(const int c) const { return edges_from(m_positions[m_cells[c][0]], facet_of_cell(m_cells[c], 0)); }
  double volume(const int c) const { return edges_of_cell(c).determinant(); } // six times

  // Returns whether a cell is positive, and no flatter than rounding allows.
  bool is_positive(const int c) const
  {
    constexpr double flat = 1e-8; // a guess
    const Matrix_3 edges = edges_of_cell(c);
    return edges.determinant() > flat * edges.col(0).norm() * edges.col(1).norm() * edges.col(2).norm();
  }

  bool are_cells_positive(const int v) const
  {
    return std::all_of(sides(v).begin(), sides(v).end(),
                       [&](const Side& side) { return !is_open(side.cell) || is_positive(side.cell); });
  }

  std::vector<int> neighbors(const int v) const
  {
    std::vector<int> result;
    for(const Side& side : sides(v))
      for(const int w : facet(side))
        result.push_back(w);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Returns the mean distance from the center of the neighbors of a vertex that are outside of the core.
  double distance_of_neighbors(const int v) const
  {
    double sum = 0;
    int number = 0;
    for(const int w : neighbors(v))
      if(!is_in_core(w))
      {
        sum += (position(w) - m_center).norm();
        ++number;
      }
    return number == 0 ? 1 : sum / number;
  }

  // Returns whether the core stays contractible without a vertex: its neighbors in the core are, as a part of the sphere of all
  // its neighbors, that is, they are connected, and their Euler characteristic is 1.
  bool is_contractible_without(const int v) const
  {
    std::vector<int> vertices;
    std::set<std::array<int, 2> > edges;
    int characteristic = 0;
    for(const Side& side : sides(v))
    {
      std::vector<int> in_core;
      for(const int w : facet(side))
        if(is_in_core(w))
          in_core.push_back(w);
      std::sort(in_core.begin(), in_core.end());
      vertices.insert(vertices.end(), in_core.begin(), in_core.end());
      for(std::size_t i = 0; i < in_core.size(); ++i)
        for(std::size_t j = i + 1; j < in_core.size(); ++j)
          edges.insert({ in_core[i], in_core[j] });
      characteristic += in_core.size() == 3;
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    characteristic += static_cast<int>(vertices.size()) - static_cast<int>(edges.size());
    if(characteristic != 1)
      return false;
    const auto index = [&](const int w) { return std::lower_bound(vertices.begin(), vertices.end(), w) - vertices.begin(); };
    Disjoint_sets components(vertices.size());
    for(const auto& [a, b] : edges)
      components.unite(index(a), index(b));
    for(std::size_t i = 1; i < vertices.size(); ++i)
      if(components.find(i) != components.find(0))
        return false;
    return true;
  }

  // Returns whether the core stays contractible without a vertex, and the open facets around it are a disk: its rim, the edges of
  // cells with one other vertex in the core, passes each vertex once.
  bool may_leave(const int v) const
  {
    std::vector<int> rim; // the first vertex of each edge
    for(const Side& side : sides(v))
      if(const std::array<int, 3> f = facet(side); number_in_core(f) == 1)
        rim.push_back(edge_of_rim(f)[0]);
    std::sort(rim.begin(), rim.end());
    return std::adjacent_find(rim.begin(), rim.end()) == rim.end() && is_contractible_without(v);
  }

  // A point to which a vertex may leave, and how much room there is: 0 if there is none.
  struct Way_out
  {
    double room = 0;
    Vector_3 point = {};
  };

  // Looks for a point that sees the open facets of a vertex from inside, and the triangles of the center with their rim from
  // outside: its direction is the nearest point of the convex hull of the normals of these (Gilbert's method).
  Way_out way_out(const int v) const
  {
    constexpr int maximum_number_of_steps = 300; // guesses
    constexpr double precision = 1e-3;
    std::vector<std::array<int, 3> > facets;
    std::vector<Vector_3> normals;
    for(const Side& side : sides(v))
    {
      const std::array<int, 3> f = facet(side);
      const int number = number_in_core(f);
      if(number == 0)
        facets.push_back(f);
      if(number == 1)
      {
        const auto [a, b] = edge_of_rim(f);
        normals.push_back((position(b) - m_center).normalized().cross((position(a) - m_center).normalized()).normalized());
      }
    }
    if(facets.empty() || normals.empty())
      return {};
    Way_out best;
    Vector_3 direction, nearest = std::accumulate(normals.begin(), normals.end(), Vector_3(0, 0, 0)) / double(normals.size());
    for(int step = 0; step < maximum_number_of_steps && nearest.norm() > 0; ++step)
    {
      const auto farthest = std::min_element(normals.begin(), normals.end(), [&](const Vector_3& m, const Vector_3& n)
                                             { return m.dot(nearest) < n.dot(nearest); });
      const double distance = nearest.norm(), lowest = farthest->dot(nearest) / distance;
      if(lowest > best.room)
      {
        best.room = lowest;
        direction = nearest / distance;
      }
      if(distance - lowest < precision * distance)
        break;
      const Vector_3 difference = *farthest - nearest;
      nearest += (std::clamp)(-nearest.dot(difference) / difference.squaredNorm(), 0., 1.) * difference;
    }
    if(best.room == 0)
      return {};
    double way = std::numeric_limits<double>::infinity(), sum = 0;
    for(const std::array<int, 3>& f : facets)
    {
      const Matrix_3 edges = edges_from(m_center, f);
      const Vector_3 normal = (edges.col(1) - edges.col(0)).cross(edges.col(2) - edges.col(0));
      if(const double speed = normal.dot(direction); speed > 0)
        way = (std::min)(way, normal.dot(edges.col(0)) / speed);
      sum += edges.col(0).norm() + edges.col(1).norm() + edges.col(2).norm();
    }
    best.room = (std::min)(best.room, way / sum * 3 * double(facets.size()));
    best.point = m_center + 0.5 * way * direction;
    return best;
  }

  // Lets a vertex leave the core, or takes it back.
  void leave(const int v, const Vector_3& p)
  {
    m_is_in_core[v] = false;
    --m_size;
    set_position(v, p);
  }

  void take_back(const int v)
  {
    m_is_in_core[v] = true;
    ++m_size;
    set_position(v, m_center);
  }

  // Splits the edge from a vertex of the core to another one. The new vertex is in the core.
  void split(const int v, const int a)
  {
    const int w = number_of_vertices();
    m_splits.push_back({ v, a });
    m_positions.push_back(m_center);
    m_is_in_core.push_back(true);
    ++m_size;
    std::vector<Side> sides_of_new;
    for(const Side& side : std::vector<Side>(sides(v)))
    {
      const std::array<int, 4> cell = m_cells[side.cell];
      const int k = static_cast<int>(std::find(cell.begin(), cell.end(), a) - cell.begin());
      if(k == 4)
        continue;
      const int other = static_cast<int>(m_cells.size());
      m_cells.push_back(cell);
      m_cells.back()[side.vertex] = w; // keeps a
      m_cells[side.cell][k] = w;       // keeps v
      sides_of_new.push_back({ other, side.vertex });
      sides_of_new.push_back({ side.cell, k });
      for(int i = 0; i < 4; ++i)
        if(i == k)
          std::find_if(m_sides[a].begin(), m_sides[a].end(), [&](const Side& s) { return s.cell == side.cell; })->cell = other;
        else if(i != side.vertex)
          m_sides[cell[i]].push_back({ other, i });
    }
    m_sides.push_back(std::move(sides_of_new));
  }

  const std::vector<std::array<int, 2> >& splits() const { return m_splits; } // of edges, by one new vertex after the other

  // The images of the vertices of the mesh, and those of the new ones.
  Matrix3Xd positions() const
  {
    Matrix3Xd result(3, m_mesh.number_of_vertices());
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      result.col(v) = m_positions[v];
    return result;
  }
  std::vector<Vector_3> new_positions() const { return { m_positions.begin() + m_mesh.number_of_vertices(), m_positions.end() }; }

  // The open cells as a mesh, in which the core is one vertex, and the images of its vertices.
  struct Contracted_mesh
  {
    Numbered_mesh_3 mesh;
    std::vector<int> vertices; // of each vertex here
    Matrix3Xd positions;
  };

  Contracted_mesh contracted_mesh() const
  {
    Contracted_mesh result;
    result.vertices.assign(m_positions.size(), 0); // the core comes first, and the prescribed vertices last
    int number = 1, number_of_free_vertices = 1;
    for(const bool are_prescribed : { false, true })
    {
      for(int v = 0; v < number_of_vertices(); ++v)
        if(!is_in_core(v) && is_prescribed(v) == are_prescribed)
          result.vertices[v] = number++;
      number_of_free_vertices = are_prescribed ? number_of_free_vertices : number;
    }
    result.positions.resize(3, number);
    for(int v = 0; v < number_of_vertices(); ++v)
      result.positions.col(result.vertices[v]) = m_positions[v];
    std::vector<std::array<int, 4> > cells;
    for(std::size_t c = 0; c < m_cells.size(); ++c)
      if(is_open(static_cast<int>(c)))
      {
        cells.push_back(m_cells[c]);
        for(int& v : cells.back())
          v = result.vertices[v];
      }
    result.mesh = Numbered_mesh_3(result.positions, std::move(cells), number_of_free_vertices);
    result.mesh.set_targets(result.positions, m_mesh.base_point);
    result.mesh.is_parallel = m_mesh.is_parallel;
    set_regular_cell(result.mesh);
    return result;
  }

  // Takes other images of the contracted mesh.
  void take(const Contracted_mesh& contracted)
  {
    for(int v = 0; v < number_of_vertices(); ++v)
      if(!is_prescribed(v))
        m_positions[v] = contracted.positions.col(contracted.vertices[v]);
    m_center = contracted.positions.col(0);
  }

private:
  // Returns the edge opposite to the only vertex of a facet in the core.
  std::array<int, 2> edge_of_rim(const std::array<int, 3>& f) const
  {
    const int k = is_in_core(f[0]) ? 0 : is_in_core(f[1]) ? 1 : 2;
    return { f[(k + 1) % 3], f[(k + 2) % 3] };
  }

  const Numbered_mesh_3& m_mesh;
  std::vector<std::array<int, 4> > m_cells;
  Vector_3 m_center;
  int m_size;
  std::vector<Vector_3> m_positions;
  std::vector<bool> m_is_in_core;
  std::vector<std::vector<Side> > m_sides;
  std::vector<std::array<int, 2> > m_splits;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_EXPANSION_CORE_MAP_3_H
