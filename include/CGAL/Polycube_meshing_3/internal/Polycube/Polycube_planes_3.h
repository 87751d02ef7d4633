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

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Planes of a polycube, each with the charts that are mapped to faces in it. Charts of one axis that meet in a corner share one.
class Polycube_planes_3
{
public:
  Polycube_planes_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts)
  {
    Disjoint_sets sets(charts.number_of_charts());
    for(const auto v : charts.corners())
    {
      const auto around = CGAL::halfedges_around_target(v, mesh);
      std::array<std::size_t, 3>& first = m_at_corner[v]; // charts for now, by axis
      for(const auto h : around)
        first[charts.axis(charts.chart(h))] = charts.chart(h);
      for(const auto h : around)
        sets.unite(charts.chart(h), first[charts.axis(charts.chart(h))]);
    }
    m_plane = sets.numbers();
    for(auto& [v, planes] : m_at_corner)
      for(std::size_t& plane : planes)
        plane = m_plane[plane];
    m_axes.resize(1 + *std::max_element(m_plane.begin(), m_plane.end()));
    for(std::size_t c = 0; c < m_plane.size(); ++c)
      m_axes[m_plane[c]] = charts.axis(c);
    m_areas.assign(m_axes.size(), 0);
    for(const auto f : mesh.faces())
      m_areas[m_plane[charts.chart_of_face()[f]]] += area_of_face(mesh, f);
  }

  std::size_t size() const { return m_axes.size(); }

  // Returns the plane of a chart.
  std::size_t operator[](const std::size_t chart) const { return m_plane[chart]; }

  // Returns the axis that a plane is orthogonal to.
  int axis(const std::size_t plane) const { return m_axes[plane]; }

  // Returns for each plane the area of its charts on the surface.
  const std::vector<double>& areas() const { return m_areas; }

  // Returns the planes at a corner, by axis.
  const std::array<std::size_t, 3>& at(const Polycube_charts_3::Vertex corner) const { return m_at_corner.at(corner); }

private:
  std::vector<std::size_t> m_plane; // by chart
  std::vector<int> m_axes;
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
    const std::size_t plane = planes[charts.chart_of_face()[f]];
    const int axis = planes.axis(plane);
    result[plane] += area_of_face(mesh, f) * (mesh.point(a)[axis] + mesh.point(b)[axis] + mesh.point(c)[axis]) / 3;
  }
  for(std::size_t p = 0; p < planes.size(); ++p)
    result[p] /= planes.areas()[p];
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_PLANES_3_H
