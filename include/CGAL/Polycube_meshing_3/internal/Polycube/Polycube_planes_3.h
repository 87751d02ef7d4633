// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_PLANES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_PLANES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_charts_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <array>
#include <map>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Planes of a polycube, each with the charts that are mapped to faces in it: those of an axis that meet in a corner are. The
// number of a plane is that of one of its charts.
class Polycube_planes_3
{
public:
  Polycube_planes_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts)
    : m_plane(charts.number_of_charts()), m_areas(m_plane.size(), 0)
  {
    Disjoint_sets sets(m_plane.size());
    for(const auto v : charts.corners())
    {
      const auto around = CGAL::halfedges_around_target(v, mesh);
      std::array<std::size_t, 3>& first = m_at_corner[v];
      for(const auto h : around)
        first[charts.axis(charts.chart(h))] = charts.chart(h);
      for(const auto h : around)
        sets.unite(charts.chart(h), first[charts.axis(charts.chart(h))]);
    }
    for(std::size_t c = 0; c < m_plane.size(); ++c)
      m_plane[c] = sets.find(c);
    for(auto& [v, planes] : m_at_corner)
      for(std::size_t& plane : planes)
        plane = m_plane[plane];
    for(const auto f : mesh.faces())
      m_areas[m_plane[charts.chart_of_face()[f]]] += area_of_face(mesh, f);
  }

  std::size_t operator[](const std::size_t chart) const { return m_plane[chart]; }
  std::size_t size() const { return m_plane.size(); }

  // Returns the areas of the charts of each plane.
  const std::vector<double>& areas() const { return m_areas; }

  // Returns the planes at a corner, by axis.
  const std::array<std::size_t, 3>& at(const Polycube_charts_3::Vertex corner) const { return m_at_corner.at(corner); }

private:
  std::vector<std::size_t> m_plane; // by chart
  std::vector<double> m_areas;
  std::map<Polycube_charts_3::Vertex, std::array<std::size_t, 3> > m_at_corner;
};

// Returns the mean coordinate of the charts of each plane along their axis.
inline std::vector<double> mean_coordinates_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                                              const Polycube_planes_3& planes)
{
  std::vector<double> result(planes.size(), 0);
  for(const auto f : mesh.faces())
  {
    const auto [a, b, c] = vertices_of_face(mesh, f);
    const std::size_t chart = charts.chart_of_face()[f];
    const int axis = charts.axis(chart);
    result[planes[chart]] += area_of_face(mesh, f) * (mesh.point(a)[axis] + mesh.point(b)[axis] + mesh.point(c)[axis]) / 3;
  }
  for(std::size_t g = 0; g < planes.size(); ++g)
    result[g] /= planes[g] == g ? planes.areas()[g] : 1;
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_PLANES_3_H
