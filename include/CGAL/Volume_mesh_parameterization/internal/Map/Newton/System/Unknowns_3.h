// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_UNKNOWNS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_UNKNOWNS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/projector_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Compressed_rows.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Which vertices a stage may move, each with a row of the Newton system, and perhaps in some directions only. That is a
// choice of the stage; which vertices are prescribed is a fact of the problem.
class Unknowns_3
{
public:
  // The vertices for which `is_unknown` is true, in their order.
  template <typename Predicate>
  Unknowns_3(const int number_of_vertices, const Predicate& is_unknown) : m_rows(number_of_vertices, -1)
  {
    for(int v = 0; v < number_of_vertices; ++v)
      if(is_unknown(v))
      {
        m_rows[v] = size();
        m_vertices.push_back(v);
      }
  }

  // The vertices that may leave their targets. Those on surfaces cannot move until normals are set.
  explicit Unknowns_3(const Conditions_3& conditions)
    : Unknowns_3(static_cast<int>(conditions.size()), [&](const int v) { return conditions[v].dimension() > 0; })
  {
    if(are_some_on_surfaces(conditions))
      m_normals = Matrix3Xd::Zero(3, number_of_vertices());
    for(const int v : m_vertices)
    {
      m_conditions.push_back(conditions[v]);
      m_projectors.push_back(projector_3(conditions[v]));
    }
  }

  // Returns the unknowns without the vertices for which `is_known(v)` is true. It keeps their normals: all unknowns take over the
  // normals after a step of some.
  template <typename Predicate>
  Unknowns_3 without(const Predicate& is_known) const
  {
    Unknowns_3 result(number_of_vertices(), [&](const int v) { return contains(v) && !is_known(v); });
    result.m_normals = m_normals;
    for(const int v : result.m_vertices)
    {
      if(!m_projectors.empty())
        result.m_projectors.push_back(m_projectors[row(v)]);
      if(!m_conditions.empty())
        result.m_conditions.push_back(m_conditions[row(v)]);
    }
    return result;
  }

  int size() const { return static_cast<int>(m_vertices.size()); }
  int number_of_vertices() const { return static_cast<int>(m_rows.size()); }
  bool contains(const int v) const { return m_rows[v] >= 0; }
  int row(const int v) const { return m_rows[v]; } // -1 if the vertex is not unknown
  int vertex(const int row) const { return m_vertices[row]; }

  // Puts the columns of the rows to their vertices; adding the result to positions leaves the others as they are.
  Matrix3Xd to_vertices(const Matrix3Xd& columns) const
  {
    // adding 0. would turn -0. into 0.
    Matrix3Xd result = Matrix3Xd::Constant(3, number_of_vertices(), -0.);
    for(int row = 0; row < size(); ++row)
      result.col(vertex(row)) = columns.col(row);
    return result;
  }

  // The positions of the rows.
  std::vector<std::array<double, 3> > points(const Matrix3Xd& positions) const
  {
    std::vector<std::array<double, 3> > result;
    for(const int v : m_vertices)
      result.push_back({ positions(0, v), positions(1, v), positions(2, v) });
    return result;
  }

  // Puts vertices back on their surfaces, of positions that are multiplied by a scale, a power of two, which changes no digits.
  // Returns the unit normals there, and the tangents of curves, in the columns of their vertices.
  Matrix3Xd put_on_surfaces(Matrix3Xd& positions, const double scale, const bool is_parallel) const
  {
    Matrix3Xd result = m_normals;
    for_each_on_surface(is_parallel, [&](const int row)
    {
      const auto [point, normal] = put_on_surface(vertex(row), positions.col(vertex(row)) / scale);
      positions.col(vertex(row)) = scale * point;
      result.col(vertex(row)) = normal;
    });
    return result;
  }

  std::pair<Vector_3, Vector_3> put_on_surface(const int v, const Vector_3& p) const
  { return put_on_surface_3(m_conditions[row(v)], p); }

  const Matrix3Xd& normals() const { return m_normals; }

  // Lets vertices on surfaces move in tangent planes, and those on curves along tangents.
  void set_normals(Matrix3Xd normals)
  {
    m_normals = std::move(normals);
    for_each_on_surface(false, [&](const int row)
    { m_projectors[row] = projector_3(m_conditions[row], m_normals.col(vertex(row))); });
  }

  bool is_on_surface(const int v) const
  { return contains(v) && !m_conditions.empty() && m_conditions[row(v)].is_sliding() && m_conditions[row(v)].dimension() == 2; }

  const Conditions_3& conditions() const { return m_conditions; }

  // Holds vertices on surfaces, until normals are set. Returns whether there are any to be held.
  template <typename Predicate>
  bool hold_if(const Predicate& is_stuck)
  {
    bool result = false;
    for_each_on_surface(false, [&](const int row)
    {
      if(!is_stuck(row))
        return;
      m_projectors[row] = Matrix_3::Zero();
      result = true;
    });
    return result;
  }

  // Let P be the projector of all unknowns onto the directions in which they may move. The solution d of P H P d = -P g is in
  // these directions, for the Hessian H and the gradient g.
  void project(Matrix3Xd& columns) const
  {
    for(std::size_t row = 0; row < m_projectors.size(); ++row)
      columns.col(row) = m_projectors[row] * columns.col(row);
  }

  // P H P, made regular by a multiple of 1 - P that is as large as the block on the diagonal.
  template <typename NT>
  void project(Block_sparse_matrix_3<NT>& hessian) const
  {
    if(m_projectors.empty())
      return;
    for(int row = 0; row < hessian.size(); ++row)
    {
      const Matrix_3& P = m_projectors[row];
      for(int k = hessian.row_begin(row); k < hessian.row_end(row); ++k)
      {
        const int column = hessian.column(k);
        const Matrix_3 H = hessian.block(k).template cast<double>();
        Matrix_3 projected = P * H * m_projectors[column];
        if(row == column)
          projected += H.norm() * (Matrix_3::Identity() - P);
        hessian.block(k) = Eigen::Matrix3d(projected).template cast<NT>();
      }
    }
  }

private:
  template <typename Function>
  void for_each_on_surface(const bool is_parallel, const Function& f) const
  {
    constexpr int rows_per_range = 64; // a guess
    for_each_in_ranges(is_parallel, static_cast<int>(m_conditions.size()), rows_per_range, [&](const int row)
    {
      if(m_conditions[row].is_sliding())
        f(row);
    });
  }

  std::vector<int> m_rows;                   // of each vertex
  std::vector<int> m_vertices;               // of each row
  std::vector<Matrix_3> m_projectors; // of each row; none if all directions are free
  Matrix3Xd m_normals;                // of surfaces, and tangents of curves, at all vertices; none if no vertex is on a surface
  Conditions_3 m_conditions;          // of each row; none if they are not known, and no vertex is on a surface
};

// The free vertices, and those of the others that may leave their targets by conditions.
inline Unknowns_3 free_vertices(const Numbered_mesh_3& mesh, const Conditions_3& conditions)
{
  if(conditions.empty())
    return Unknowns_3(mesh.number_of_vertices(), [&](const int v) { return mesh.is_free(v); });
  Conditions_3 of_all(mesh.number_of_free_vertices);
  of_all.insert(of_all.end(), conditions.begin(), conditions.end());
  return Unknowns_3(of_all);
}

inline Unknowns_3 free_vertices(const Numbered_mesh_3& mesh) { return free_vertices(mesh, mesh.conditions); }

inline Unknowns_3 all_vertices(const Numbered_mesh_3& mesh)
{
  return Unknowns_3(mesh.number_of_vertices(), [](int) { return true; });
}

using Groups_of_vertices = std::vector<std::vector<int> >;

// The pattern of the Hessian: the pairs of unknown vertices that share a cell, or one of the groups.
inline Sparsity_pattern_3 sparsity_pattern_3(const Numbered_mesh_3& mesh, const Unknowns_3& unknowns,
                                             const Groups_of_vertices& groups = {})
{
  constexpr int rows_per_part = 4096; // a guess
  const int n = unknowns.size(), number_of_cells = static_cast<int>(mesh.cells.size());
  const auto for_each_row_of = [&](const int item, const auto& f) // groups come after the cells
  {
    const auto for_each = [&](const auto& vertices)
    {
      for(const int v : vertices)
        if(unknowns.contains(v))
          f(unknowns.row(v));
    };
    item < number_of_cells ? for_each(mesh.cells[item]) : for_each(groups[item - number_of_cells]);
  };
  const Compressed_rows<int> at(n, number_of_cells + static_cast<int>(groups.size()), for_each_row_of, mesh.is_parallel);
  Sparsity_pattern_3 result;
  result.row_begin.assign(n + 1, 0);
  std::vector<std::vector<int> > parts((n + rows_per_part - 1) / rows_per_part);
  for_each_range(mesh.is_parallel, n, rows_per_part, [&](const std::size_t i, const int first, const int last)
  {
    std::vector<int>& columns = parts[i];
    for(int row = first; row < last; ++row)
    {
      const std::size_t size = columns.size();
      for(std::size_t k = at.begin[row]; k < at.begin[row + 1]; ++k)
        for_each_row_of(at.items[k], [&](const int column) { columns.push_back(column); });
      std::sort(columns.begin() + size, columns.end());
      columns.erase(std::unique(columns.begin() + size, columns.end()), columns.end());
      result.row_begin[row + 1] = static_cast<int>(columns.size() - size);
    }
  });
  std::partial_sum(result.row_begin.begin(), result.row_begin.end(), result.row_begin.begin());
  result.columns.reserve(result.row_begin[n]);
  for(std::vector<int>& part : parts)
  {
    result.columns.insert(result.columns.end(), part.begin(), part.end());
    part = std::vector<int>();
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_UNKNOWNS_3_H
