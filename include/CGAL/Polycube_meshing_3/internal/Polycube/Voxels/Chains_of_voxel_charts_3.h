// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_CHAINS_OF_VOXEL_CHARTS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_CHAINS_OF_VOXEL_CHARTS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxel_faces_3.h>

#include <algorithm>

namespace CGAL::Polycube_meshing_3::internal {

// Chain between two charts of placed faces of voxels, from corner to corner.
struct Chain_of_voxel_charts_3
{
  std::vector<std::size_t> points;          // of the faces
  std::size_t left, right;                  // charts
  std::size_t first_index, last_index;      // which of the chains at its corners it is, counterclockwise
};

// Borders of charts of placed faces of voxels, and the corners where three or more of them meet.
class Chains_of_voxel_charts_3
{
public:
  Chains_of_voxel_charts_3(const Voxel_faces_3& faces, const std::vector<std::size_t>& chart_of_face)
    : m_faces(faces), m_chart_of_face(chart_of_face), m_ends(faces.points.size())
  {
    for(std::size_t i = 0; i < faces.corners.size(); ++i)
      for(std::size_t k = 0; k < 4; ++k)
        m_side[{ faces.corners[i][k], faces.corners[i][(k + 1) % 4] }] = { i, k };
    find_ends();
    for(std::size_t p = 0; p < m_ends.size(); ++p)
      if(m_ends[p].size() > 2)
      {
        m_corners.push_back(p);
        for(std::size_t i = 0; i < m_ends[p].size(); ++i)
          add_chain(p, i);
      }
  }

  const std::vector<std::size_t>& corners() const { return m_corners; }
  const std::vector<Chain_of_voxel_charts_3>& chains() const { return m_chains; }

  // Returns the points next to a corner on the chains that leave it, counterclockwise.
  const std::vector<std::size_t>& ends(const std::size_t corner) const { return m_ends[corner]; }

  double length(const Chain_of_voxel_charts_3& chain) const
  {
    double result = 0;
    for(std::size_t i = 1; i < chain.points.size(); ++i)
      result += (m_faces.points[chain.points[i]] - m_faces.points[chain.points[i - 1]]).norm();
    return result;
  }

private:
  std::size_t chart_on_left(const std::size_t v, const std::size_t w) const { return m_chart_of_face[m_side.at({ v, w }).first]; }

  void find_ends()
  {
    std::vector<bool> is_done(m_ends.size(), false);
    for(const auto& entry : m_side)
    {
      const auto [p, first] = entry.first;
      if(is_done[p])
        continue;
      is_done[p] = true;
      std::size_t v = first;
      do
      {
        if(chart_on_left(p, v) != chart_on_left(v, p))
          m_ends[p].push_back(v);
        const auto [face, k] = m_side.at({ p, v });
        v = m_faces.corners[face][(k + 3) % 4]; // the next one counterclockwise
      }
      while(v != first);
    }
  }

  std::size_t index_of_end(const std::size_t p, const std::size_t end) const
  { return static_cast<std::size_t>(std::find(m_ends[p].begin(), m_ends[p].end(), end) - m_ends[p].begin()); }

  // Follows a chain to its other corner, and adds it in one of its two directions.
  void add_chain(const std::size_t corner, const std::size_t index_at_corner)
  {
    Chain_of_voxel_charts_3 chain;
    chain.points = { corner, m_ends[corner][index_at_corner] };
    while(m_ends[chain.points.back()].size() == 2)
    {
      const std::vector<std::size_t>& ends = m_ends[chain.points.back()];
      chain.points.push_back(ends[0] == chain.points[chain.points.size() - 2] ? ends[1] : ends[0]);
    }
    chain.first_index = index_at_corner;
    chain.last_index = index_of_end(chain.points.back(), chain.points[chain.points.size() - 2]);
    chain.left = chart_on_left(chain.points[0], chain.points[1]);
    chain.right = chart_on_left(chain.points[1], chain.points[0]);
    if(std::make_pair(corner, chain.first_index) < std::make_pair(chain.points.back(), chain.last_index))
      m_chains.push_back(chain);
  }

  const Voxel_faces_3& m_faces;
  const std::vector<std::size_t>& m_chart_of_face;
  std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t> > m_side; // face, corner of an edge
  std::vector<std::vector<std::size_t> > m_ends;
  std::vector<std::size_t> m_corners;
  std::vector<Chain_of_voxel_charts_3> m_chains;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_CHAINS_OF_VOXEL_CHARTS_3_H
