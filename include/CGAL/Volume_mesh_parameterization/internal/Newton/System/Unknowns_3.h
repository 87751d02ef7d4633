// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_UNKNOWNS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_UNKNOWNS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>

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

  // The vertices whose projector is not zero, with the directions onto which it projects: space, a plane or a line.
  explicit Unknowns_3(const std::vector<Eigen::Matrix3d>& projectors)
    : Unknowns_3(static_cast<int>(projectors.size()), [&](const int v) { return !projectors[v].isZero(0); })
  {
    for(const int v : m_vertices)
      m_projectors.push_back(projectors[v]);
  }

  // These without some vertices.
  template <typename Predicate>
  Unknowns_3 without(const Predicate& is_known) const
  {
    Unknowns_3 result(number_of_vertices(), [&](const int v) { return contains(v) && !is_known(v); });
    if(!m_projectors.empty())
      for(const int v : result.m_vertices)
        result.m_projectors.push_back(m_projectors[row(v)]);
    return result;
  }

  int size() const { return static_cast<int>(m_vertices.size()); }
  int number_of_vertices() const { return static_cast<int>(m_rows.size()); }
  bool contains(const int v) const { return m_rows[v] >= 0; }
  int row(const int v) const { return m_rows[v]; } // -1 if the vertex is not unknown
  int vertex(const int row) const { return m_vertices[row]; }

  // Puts the columns of the rows to their vertices; adding the result to positions leaves the others as they are.
  Eigen::Matrix3Xd to_vertices(const Eigen::Matrix3Xd& columns) const
  {
    // adding 0. would turn -0. into 0.
    Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Constant(3, number_of_vertices(), -0.);
    for(int row = 0; row < size(); ++row)
      result.col(vertex(row)) = columns.col(row);
    return result;
  }

  // Newton steps stay in the directions P if P H P d = -P g is solved in place of H d = -g.
  void project(Eigen::Matrix3Xd& columns) const
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
      const Eigen::Matrix3d& P = m_projectors[row];
      for(int k = hessian.row_begin(row); k < hessian.row_end(row); ++k)
      {
        const int column = hessian.column(k);
        const Eigen::Matrix3d H = hessian.block(k).template cast<double>();
        Eigen::Matrix3d projected = P * H * m_projectors[column];
        if(row == column)
          projected += H.norm() * (Eigen::Matrix3d::Identity() - P);
        hessian.block(k) = projected.template cast<NT>();
      }
    }
  }

private:
  std::vector<int> m_rows;                   // of each vertex
  std::vector<int> m_vertices;               // of each row
  std::vector<Eigen::Matrix3d> m_projectors; // of each row; none if all directions are free
};

inline Unknowns_3 free_vertices(const Numbered_mesh_3& mesh)
{
  return Unknowns_3(mesh.number_of_vertices(), [&](const int v) { return mesh.is_free(v); });
}

inline Unknowns_3 all_vertices(const Numbered_mesh_3& mesh)
{
  return Unknowns_3(mesh.number_of_vertices(), [](int) { return true; });
}

// Which cells and groups are at each unknown vertex, in compressed rows; groups are numbered behind the cells.
class Incidences_of_rows_3
{
public:
  using Groups = std::vector<std::vector<int> >; // of vertices

  Incidences_of_rows_3(const Numbered_mesh_3& mesh, const Unknowns_3& unknowns, const Groups& groups)
    : m_mesh(mesh), m_unknowns(unknowns), m_groups(groups), m_begin(unknowns.size() + 1, 0)
  {
    for_each_incidence([&](const int row, int) { ++m_begin[row + 1]; });
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    m_items.resize(m_begin.back());
    std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
    for_each_incidence([&](const int row, const int item) { m_items[next[row]++] = item; });
  }

  // Appends the rows that share a cell or a group with this one, itself included, in ascending order.
  void append_neighbors(const int row, std::vector<int>& columns) const
  {
    const std::size_t first = columns.size();
    for(std::size_t i = m_begin[row]; i < m_begin[row + 1]; ++i)
      for_each_row_of(m_items[i], [&](const int neighbor) { columns.push_back(neighbor); });
    std::sort(columns.begin() + first, columns.end());
    columns.erase(std::unique(columns.begin() + first, columns.end()), columns.end());
  }

private:
  template <typename Function>
  void for_each_row_of(const int item, const Function& f) const
  {
    const int number_of_cells = static_cast<int>(m_mesh.cells.size());
    const auto for_each = [&](const auto& vertices)
    {
      for(const int v : vertices)
        if(m_unknowns.contains(v))
          f(m_unknowns.row(v));
    };
    if(item < number_of_cells)
      for_each(m_mesh.cells[item]);
    else
      for_each(m_groups[item - number_of_cells]);
  }

  template <typename Function>
  void for_each_incidence(const Function& f) const
  {
    const int number_of_items = static_cast<int>(m_mesh.cells.size() + m_groups.size());
    for(int item = 0; item < number_of_items; ++item)
      for_each_row_of(item, [&](const int row) { f(row, item); });
  }

  const Numbered_mesh_3& m_mesh;
  const Unknowns_3& m_unknowns;
  const Groups& m_groups;
  std::vector<std::size_t> m_begin;
  std::vector<int> m_items;
};

// The pattern of the Hessian: the pairs of unknown vertices that share a cell, or one of the groups.
inline Sparsity_pattern_3 sparsity_pattern_3(const Numbered_mesh_3& mesh, const Unknowns_3& unknowns,
                                             const Incidences_of_rows_3::Groups& groups = {},
                                             const bool is_parallel = false)
{
  constexpr int rows_per_part = 4096;
  const int n = unknowns.size();
  const Incidences_of_rows_3 incidences(mesh, unknowns, groups);
  Sparsity_pattern_3 result;
  result.row_begin.assign(n + 1, 0);
  std::vector<std::vector<int> > parts((n + rows_per_part - 1) / rows_per_part);
  for_each_index(is_parallel, 0, parts.size(), [&](const std::size_t part)
  {
    const int first = static_cast<int>(part) * rows_per_part;
    for(int row = first; row < (std::min)(n, first + rows_per_part); ++row)
    {
      const std::size_t size = parts[part].size();
      incidences.append_neighbors(row, parts[part]);
      result.row_begin[row + 1] = static_cast<int>(parts[part].size() - size);
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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_UNKNOWNS_3_H
