// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_LENGTH_OF_EDGES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_LENGTH_OF_EDGES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Placement_of_voxel_faces_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Length of edges with which chains between charts of placed faces of voxels can be drawn on a surface: short ones at the
// chains, and elsewhere as long as they are far from these.
class Length_of_edges_3
{
public:
  // Takes the length at the chains.
  Length_of_edges_3(const Voxel_faces_3& faces, const std::vector<std::size_t>& chart_of_face, const double length)
    : m_points(faces.points), m_lengths(m_points.size(), length), m_least(length / 4), m_nearest(0) // two halvings; a guess
  {
    std::vector<std::size_t> chart_of_point(m_points.size(), none);
    std::set<std::size_t> on_chains;
    for(std::size_t i = 0; i < chart_of_face.size(); ++i)
      for(const std::size_t p : faces.corners[i])
      {
        if(chart_of_point[p] != none && chart_of_point[p] != chart_of_face[i])
          on_chains.insert(p);
        chart_of_point[p] = chart_of_face[i];
      }
    m_on_chains.assign(on_chains.begin(), on_chains.end());
    for(const std::size_t p : m_on_chains)
      m_nearest.add(m_points[p], Eigen::Vector3d::Zero());
  }

  // Halves the lengths at some points of chains. Returns whether there was one that has not been halved too often.
  bool halve(const std::set<std::size_t>& points)
  {
    bool has_changed = false;
    for(const std::size_t p : points)
      if(m_lengths[p] > m_least)
      {
        m_lengths[p] /= 2;
        has_changed = true;
      }
    return has_changed;
  }

  double operator()(const Eigen::Vector3d& p) const
  {
    const std::size_t nearest = m_on_chains[m_nearest.nearest(p, Eigen::Vector3d::Zero())];
    return (std::max)(m_lengths[nearest], (m_points[nearest] - p).norm());
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  const std::vector<Eigen::Vector3d>& m_points;
  std::vector<double> m_lengths; // at the points
  double m_least;
  std::vector<std::size_t> m_on_chains; // points
  Nearest_with_normal_3 m_nearest;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_LENGTH_OF_EDGES_3_H
