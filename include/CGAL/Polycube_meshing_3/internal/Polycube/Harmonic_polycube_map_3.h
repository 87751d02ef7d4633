// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HARMONIC_POLYCUBE_MAP_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HARMONIC_POLYCUBE_MAP_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_planes_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Harmonic_extension_2.h>

#include <map>
#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Chart with the functions of which its harmonic map is a sum: one for each plane at its corners, times its coordinate.
struct Harmonic_chart_2 : Chart_triangles_2
{
  struct Function
  {
    int plane;       // that has the coordinate
    int row;         // 0 for the first coordinate in the plane, 1 for the second one
    VectorXd values; // at the vertices
  };

  std::vector<Function> functions;
  int plane = 0; // of the face that the chart is mapped to
  int sign = 0;  // of the outward normal of this face along its axis

  using Chart_triangles_2::Chart_triangles_2;

  // Returns the gradients of the functions in a triangle, as rows.
  Dynamic_matrix<double, Eigen::Dynamic, 2> gradients(const Triangle& t) const
  {
    Dynamic_matrix<double, Eigen::Dynamic, 2> result(functions.size(), 2);
    const Small_matrix<3, 2> of_vertices = t.gradients();
    for(std::size_t i = 0; i < functions.size(); ++i)
    {
      const auto value = [&](const int k) { return functions[i].values[t.vertices[k]]; };
      result.row(i) = value(0) * of_vertices.row(0) + value(1) * of_vertices.row(1) + value(2) * of_vertices.row(2);
    }
    return result;
  }

  // Returns the Jacobian of the map in a triangle, from the gradients there.
  template <typename Gradients>
  Small_matrix<2, 2> jacobian(const Gradients& gradients, const VectorXd& coordinates) const
  {
    Small_matrix<2, 2> J = Small_matrix<2, 2>::Zero();
    for(std::size_t i = 0; i < functions.size(); ++i)
      J.row(functions[i].row) += coordinates[functions[i].plane] * gradients.row(i);
    return J;
  }
};

// Harmonic map of a surface to a polycube, chart by chart, as a linear function of the coordinates of the planes.
class Harmonic_polycube_map_3
{
public:
  Harmonic_polycube_map_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts, const Polycube_planes_3& planes)
    : m_mesh(mesh), m_planes(planes)
  {
    std::vector<std::vector<Boundary_mesh_3::Face_index> > faces(charts.number_of_charts());
    for(const auto f : mesh.faces())
      faces[charts.chart_of_face()[f]].push_back(f);
    const Edge_positions positions = positions_on_edges(charts);
    for(std::size_t c = 0; c < faces.size(); ++c)
    {
      m_charts.emplace_back(mesh, faces[c]);
      m_charts.back().plane = static_cast<int>(planes[c]);
      m_charts.back().sign = sign_of_direction(charts.labels()[c]);
      add_functions(charts.plane_axes(c), positions, m_charts.back());
    }
  }

  const std::vector<Harmonic_chart_2>& charts() const { return m_charts; }

  // Returns the volume of the polycube, by Gauss's theorem.
  double volume(const VectorXd& coordinates) const
  {
    double result = 0;
    for(const Harmonic_chart_2& chart : m_charts)
      for(const Chart_triangles_2::Triangle& t : chart.triangles)
        result += coordinates[chart.plane] * chart.sign * t.area
                  * chart.jacobian(chart.gradients(t), coordinates).determinant() / 3;
    return result;
  }

private:
  // Image of a vertex on an edge of the polycube, by axis: between two planes, which are the same across the edge.
  struct Edge_position
  {
    std::array<std::size_t, 3> first, second;  // planes
    std::array<double, 3> part;                // of the way from the first plane to the second one, from 0 to 1
  };
  using Edge_positions = std::map<int, Edge_position>; // by vertex

  // Returns the positions of the vertices of edges, by arc length between the corners.
  Edge_positions positions_on_edges(const Polycube_charts_3& charts) const
  {
    Edge_positions result;
    for(const Polycube_chain_3& chain : charts.chains())
    {
      const std::vector<Polycube_charts_3::Vertex> path = charts.vertices(chain);
      const std::vector<double> length = arc_lengths(m_mesh, path);
      Edge_position position = { m_planes.at(path.front()), m_planes.at(path.back()), {} };
      for(std::size_t i = 0; i < path.size(); ++i)
      {
        position.part[chain.axis] = length[i] / length.back();
        result.emplace(path[i], position); // a corner has the same image in each of its chains
      }
    }
    return result;
  }

  // Adds to a chart, for both of its axes and each plane at its border, the harmonic function that belongs to the coordinate.
  static void add_functions(const std::array<int, 2>& axes, const Edge_positions& positions, Harmonic_chart_2& chart)
  {
    std::vector<bool> is_held;
    for(const auto v : chart.vertices)
      is_held.push_back(positions.count(v) > 0);
    const Harmonic_extension_2 extension(chart, is_held);
    for(const int row : { 0, 1 })
    {
      std::map<std::size_t, VectorXd> values_in_plane;
      const auto add = [&](const std::size_t plane, const std::size_t v, const double part)
      { values_in_plane.emplace(plane, VectorXd::Zero(chart.vertices.size())).first->second[v] += part; };
      for(std::size_t v = 0; v < is_held.size(); ++v)
        if(is_held[v])
        {
          const auto& [first, second, part] = positions.at(chart.vertices[v]);
          add(first[axes[row]], v, 1 - part[axes[row]]);
          add(second[axes[row]], v, part[axes[row]]);
        }
      for(auto& [plane, values] : values_in_plane)
      {
        extension.apply(values);
        chart.functions.push_back({ static_cast<int>(plane), row, std::move(values) });
      }
    }
  }

  const Boundary_mesh_3& m_mesh;
  const Polycube_planes_3& m_planes;
  std::vector<Harmonic_chart_2> m_charts;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HARMONIC_POLYCUBE_MAP_3_H
