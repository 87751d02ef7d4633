// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SIMPLEX_REMOVAL_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SIMPLEX_REMOVAL_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Inserted_vertex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Refinement_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Simplex_3.h>

#include <cstddef>
#include <queue>
#include <tuple>

namespace CGAL::Volume_mesh_parameterization::internal {

// Removes bad interior edges, facets and cells from a complex by the insertion of few vertices.
//
// A vertex inserted into a simplex removes all bad simplices that contain it. IsBad(simplex) is a condition on old
// vertices, which a simplex with a new vertex does not fulfil: no insertion makes anything bad. So the numbers of bad
// simplices around the candidates only fall, and it suffices to update the one at the top of the queue.
template <typename C3t3, typename IsBad>
class Simplex_removal_3
{
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Cell_handle = typename C3t3::Cell_handle;
  using Simplex = Simplex_3<Vertex_handle>;

public:
  Simplex_removal_3(C3t3& c3t3, const IsBad& is_bad) : m_c3t3(c3t3), m_is_bad(is_bad), m_refinement(c3t3) {}

  // Writes an `Inserted_vertex_3` for each insertion and returns their number. If the budget does not suffice to find all
  // bad simplices, nothing is inserted.
  template <typename OutputIterator>
  std::size_t run(OutputIterator out, const Budget& budget)
  {
    for(auto it = m_c3t3.cells_in_complex_begin(); it != m_c3t3.cells_in_complex_end() && !budget.is_exhausted(); ++it)
      collect_candidates(it);

    std::size_t number_of_insertions = 0;
    while(!m_queue.empty() && !budget.is_exhausted())
    {
      Candidate candidate = m_queue.top();
      m_queue.pop();
      const std::size_t number_of_bad = count_bad(candidate.simplex);
      if(number_of_bad == 0)
        continue;
      if(number_of_bad < candidate.number_of_bad)
      {
        candidate.number_of_bad = number_of_bad;
        m_queue.push(candidate);
        continue;
      }
      const Vertex_handle v = m_refinement.insert(candidate.simplex);
      if(v == Vertex_handle())
        continue;
      *out++ = Inserted_vertex_3<Vertex_handle>{ v, { candidate.simplex.begin(), candidate.simplex.end() } };
      ++number_of_insertions;
    }
    return number_of_insertions;
  }

private:
  struct Candidate
  {
    Simplex simplex;
    bool is_bad_edge;
    std::size_t number_of_bad;
    double size;
    std::size_t number;

    // Edges come first, bad ones before others, then those of many bad simplices, then the longest.
    bool operator<(const Candidate& other) const
    {
      return std::make_tuple(other.simplex.size(), is_bad_edge, number_of_bad, size, other.number)
           < std::make_tuple(simplex.size(), other.is_bad_edge, other.number_of_bad, other.size, number);
    }
  };

  void collect_candidates(const Cell_handle c)
  {
    for_each_face(vertices_of_cell(c), [&](const Simplex& simplex)
    {
      if(m_is_bad(simplex) && is_interior(m_c3t3, simplex, c))
        for_each_face(simplex, [&](const Simplex& face) { add_candidate(face, c); });
    });
  }

  void add_candidate(const Simplex& simplex, const Cell_handle c)
  {
    if(!m_refinement.choose(simplex, c) || !is_interior(m_c3t3, simplex, c))
      return;
    const bool is_bad_edge = simplex.size() == 2 && m_is_bad(simplex);
    m_queue.push({ simplex, is_bad_edge, count_bad(simplex), squared_size(m_c3t3.triangulation(), simplex),
                   m_number_of_candidates++ });
  }

  // The number of bad simplices that contain a candidate, counted in each cell around it.
  std::size_t count_bad(const Simplex& simplex) const
  {
    const Cell_handle c = m_refinement.cell(simplex);
    if(c == Cell_handle())
      return 0;
    std::size_t count = 0;
    for(const Cell_handle around : cells_around(m_c3t3.triangulation(), simplex, c))
      for_each_face(vertices_of_cell(around), [&](const Simplex& face)
      {
        if(contains(face, simplex) && m_is_bad(face))
          ++count;
      });
    return count;
  }

  C3t3& m_c3t3;
  const IsBad& m_is_bad;
  Refinement_3<C3t3> m_refinement;
  std::priority_queue<Candidate> m_queue;
  std::size_t m_number_of_candidates = 0;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SIMPLEX_REMOVAL_3_H
