// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_HARMONIC_EXTENSION_2_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_HARMONIC_EXTENSION_2_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/sparse_systems.h>

#include <Eigen/LU>

#include <memory>

namespace CGAL::Volume_mesh_parameterization::internal {

// Triangles of a chart, each laid into the plane for itself.
struct Chart_triangles_2
{
  struct Triangle
  {
    std::array<int, 3> vertices;
    Small_matrix<2, 2> to_rest; // the Jacobian is the edges of the image times this matrix
    double area;

    // Returns the gradients of the functions that are 1 at a vertex and 0 at the others, as rows.
    Small_matrix<3, 2> gradients() const
    {
      Small_matrix<3, 2> difference;
      difference << -1, -1, 1, 0, 0, 1;
      return difference * to_rest;
    }
  };

  std::vector<Boundary_mesh_3::Vertex_index> vertices; // of the mesh
  std::vector<Triangle> triangles;

  Chart_triangles_2(const Boundary_mesh_3& mesh, const std::vector<Boundary_mesh_3::Face_index>& faces)
  {
    std::vector<int> number(mesh.number_of_vertices(), -1);
    for(const auto f : faces)
      add_triangle(mesh, f, number);
  }

private:
  void add_triangle(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Face_index f, std::vector<int>& number)
  {
    Triangle t;
    const auto v = vertices_of_face(mesh, f);
    for(int i = 0; i < 3; ++i)
    {
      if(number[v[i]] < 0)
      {
        number[v[i]] = static_cast<int>(vertices.size());
        vertices.push_back(v[i]);
      }
      t.vertices[i] = number[v[i]];
    }
    const Facet_edges_3 X = edges_of_face(mesh, f);
    const Vector_3 a = X[0], b = X[1];
    Small_matrix<2, 2> rest;
    rest << a.norm(), a.dot(b) / a.norm(), 0, a.cross(b).norm() / a.norm();
    t.to_rest = rest.inverse();
    t.area = rest.determinant() / 2;
    triangles.push_back(t);
  }
};

// Extends values at some vertices of a chart to the others, such that the sum over triangles of area |gradient|^2 is the least.
class Harmonic_extension_2
{
public:
  Harmonic_extension_2(const Chart_triangles_2& chart, const std::vector<bool>& is_held)
    : m_chart(chart)
  {
    for(const bool is : is_held)
      m_number.push_back(is ? -1 : m_size++);
    if(m_size == 0)
      return;
    std::vector<Sparse_entry> entries;
    for_each_pair([&](const int row, const int column, const double x)
    {
      if(m_number[column] >= 0)
        entries.push_back({ m_number[row], m_number[column], x });
    });
    m_solver = make_symmetric_sparse_solver();
    m_solver->factorize(m_size, entries);
  }

  void apply(VectorXd& values) const
  {
    if(m_size == 0)
      return;
    VectorXd right = VectorXd::Zero(m_size);
    for_each_pair([&](const int row, const int column, const double x)
    {
      if(m_number[column] < 0)
        right[m_number[row]] -= x * values[column];
    });
    const VectorXd solution = m_solver->solve(right);
    for(std::size_t i = 0; i < m_number.size(); ++i)
      if(m_number[i] >= 0)
        values[i] = solution[m_number[i]];
  }

private:
  // Calls `visit(row, column, x)` for the parts of the matrix that each triangle has, whose vertex of the row is not held.
  template <typename Visit>
  void for_each_pair(const Visit& visit) const
  {
    for(const Chart_triangles_2::Triangle& t : m_chart.triangles)
    {
      const Small_matrix<3, 2> gradients = t.gradients();
      const Small_matrix<3, 3> K = t.area * gradients * gradients.transpose();
      for(int i = 0; i < 3; ++i)
        for(int k = 0; k < 3 && m_number[t.vertices[i]] >= 0; ++k)
          visit(t.vertices[i], t.vertices[k], K(i, k));
    }
  }

  const Chart_triangles_2& m_chart;
  std::vector<int> m_number; // of the unknown of a vertex, or -1 if it is held
  int m_size = 0;
  std::unique_ptr<Symmetric_sparse_solver> m_solver;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_HARMONIC_EXTENSION_2_H
