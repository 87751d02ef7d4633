// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_SUBDOMAIN_SEPARATION_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_SUBDOMAIN_SEPARATION_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <limits>
#include <map>
#include <set>

namespace CGAL::Polycube_meshing_3::internal {

// Gives hexahedra to the subdomains of neighbors until the surfaces between subdomains are manifolds. A vertex has a defect if
// quadrangles do not join its hexahedra of a subdomain, or all its other hexahedra together with the outside. No change cuts a
// subdomain apart near the hexahedron. (After Latecki, 3D well-composed pictures, 1997.)
class Subdomain_separation_3
{
public:
  explicit Subdomain_separation_3(Hexahedra_3& mesh)
    : m_mesh(mesh), m_cells_at(mesh.points.size()), m_neighbors(mesh.cells.size())
  {
    for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    {
      m_neighbors[c].fill(none);
      for(const std::size_t v : mesh.cells[c])
        m_cells_at[v].push_back(c);
    }
    for_each_quadrangle(mesh, [&](const auto begin, const auto end)
    {
      if(end - begin != 2)
        return;
      const Quadrangle_of_hexahedron q = begin->second, r = (begin + 1)->second;
      m_neighbors[q.cell][q.side] = r.cell;
      m_neighbors[r.cell][r.side] = q.cell;
    });
  }

  // Changes the references of hexahedra of the mesh, as long as each change leaves fewer defects.
  void run(const Budget& budget)
  {
    for(bool has_changed = true; has_changed && !budget.is_exhausted(); )
    {
      has_changed = false;
      for(std::size_t v = 0; v < m_cells_at.size(); ++v)
        has_changed = (defects(v) > 0 && mend(v)) || has_changed;
    }
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  int& reference(const std::size_t c) { return m_mesh.cell_references[c]; }

  // Returns whether two hexahedra share a quadrangle.
  bool are_neighbors(const std::size_t c, const std::size_t d) const
  { return std::find(m_neighbors[c].begin(), m_neighbors[c].end(), d) != m_neighbors[c].end(); }

  // Returns whether a hexahedron has a quadrangle of the boundary of the mesh at a vertex.
  bool is_at_boundary(const std::size_t c, const std::size_t v) const
  {
    for(std::size_t side = 0; side < 6; ++side)
      if(const auto q = vertices_of(m_mesh, { c, side }); m_neighbors[c][side] == none && std::count(q.begin(), q.end(), v) > 0)
        return true;
    return false;
  }

  // Returns the sets of hexahedra that quadrangles join, by their indices in `cells`. One more set, cells.size(), stands alone.
  Disjoint_sets joined_by_quadrangles(const std::vector<std::size_t>& cells) const
  {
    Disjoint_sets sets(cells.size() + 1);
    for(std::size_t i = 0; i < cells.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(are_neighbors(cells[i], cells[j]))
          sets.unite(i, j);
    return sets;
  }

  // Returns the number of parts of hexahedra that quadrangles join. Hexahedra joined to the outside are one part in any case.
  template <typename Predicate>
  int number_of_parts(const std::vector<std::size_t>& cells, const Predicate& is_joined_to_outside) const
  {
    Disjoint_sets sets = joined_by_quadrangles(cells);
    std::set<std::size_t> parts;
    for(std::size_t i = 0; i < cells.size(); ++i)
      if(is_joined_to_outside(cells[i]))
        sets.unite(i, cells.size());
    for(std::size_t i = 0; i < cells.size(); ++i)
      parts.insert(sets.find(i));
    return static_cast<int>(parts.size());
  }

  // Returns the number of extra components of subdomains and of their complements at a vertex.
  int defects(const std::size_t v)
  {
    const auto is_like_first = [&](const std::size_t c) { return reference(c) == reference(m_cells_at[v][0]); };
    if(std::all_of(m_cells_at[v].begin(), m_cells_at[v].end(), is_like_first))
      return 0;
    std::map<int, std::vector<std::size_t> > subdomains;
    for(const std::size_t c : m_cells_at[v])
      subdomains[reference(c)].push_back(c);
    int result = 0;
    for(const auto& [subdomain, cells] : subdomains)
    {
      std::vector<std::size_t> others;
      for(const std::size_t c : m_cells_at[v])
        if(reference(c) != subdomain)
          others.push_back(c);
      result += number_of_parts(cells, [](std::size_t) { return false; }) - 1;
      result += number_of_parts(others, [&](const std::size_t c) { return is_at_boundary(c, v); }) - 1;
    }
    return result;
  }

  // Returns whether a hexahedron may leave its subdomain. It must have neighbors there, which remain joined without it by the
  // hexahedra of the subdomain around it.
  bool may_leave_subdomain(const std::size_t c)
  {
    std::set<std::size_t> around;
    for(const std::size_t v : m_mesh.cells[c])
      for(const std::size_t d : m_cells_at[v])
        if(d != c && reference(d) == reference(c))
          around.insert(d);
    const std::vector<std::size_t> cells(around.begin(), around.end());
    Disjoint_sets sets = joined_by_quadrangles(cells);
    std::set<std::size_t> parts;
    for(std::size_t i = 0; i < cells.size(); ++i)
      if(are_neighbors(c, cells[i]))
        parts.insert(sets.find(i));
    return parts.size() == 1;
  }

  int defects_around(const std::size_t cell)
  {
    int sum = 0;
    for(const std::size_t v : m_mesh.cells[cell])
      sum += defects(v);
    return sum;
  }

  // Gives a hexahedron at a vertex to the subdomain of a neighbor, such that the most defects vanish, and among such changes the
  // one with the most neighbors there. Returns false if no change removes a defect.
  bool mend(const std::size_t v)
  {
    std::pair<int, std::ptrdiff_t> best = { 1, 0 }; // defects that vanish, at least one, and neighbors in the new subdomain
    std::size_t changed = none;
    int next = 0;
    for(const std::size_t c : m_cells_at[v])
    {
      std::map<int, std::ptrdiff_t> numbers; // of neighbors in each other subdomain
      for(const std::size_t d : m_neighbors[c])
        if(d != none && reference(d) != reference(c))
          ++numbers[reference(d)];
      if(numbers.empty() || !may_leave_subdomain(c))
        continue;
      const int old = reference(c), before = defects_around(c);
      for(const auto& [subdomain, number] : numbers)
      {
        reference(c) = subdomain;
        if(const std::pair<int, std::ptrdiff_t> gain = { before - defects_around(c), number }; gain > best)
        {
          best = gain;
          changed = c;
          next = subdomain;
        }
      }
      reference(c) = old;
    }
    if(changed == none)
      return false;
    reference(changed) = next;
    return true;
  }

  Hexahedra_3& m_mesh;
  std::vector<std::vector<std::size_t> > m_cells_at;        // of each vertex
  std::vector<std::array<std::size_t, 6> > m_neighbors; // of each hexahedron, by its sides; `none` at the boundary
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_SUBDOMAIN_SEPARATION_3_H
