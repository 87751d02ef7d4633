// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CELL_PACKS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CELL_PACKS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Pack.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Several cells side by side, with all that an evaluation needs of them. A cell that only fills up
// the last pack repeats another one with weight 0.
struct Cell_pack_3
{
  using Indices = std::array<int, Pack::size>;

  std::array<Indices, 4> vertices;                // sorted, which changes the orientation, but not J
  std::array<std::array<Indices, 4>, 4> blocks;   // positions in the matrix for a <= b, -1 if a vertex is not free
  Matrix_3<Pack> inverse_source;                // X^{-1}, times the factor that gives both meshes one volume
  Pack weight;
};

// The pattern of the Hessian: the pairs of free vertices that share a cell, or one of the groups.
template <typename NT>
void set_pattern(const Numbered_mesh_3& mesh, const std::vector<std::vector<int> >& groups,
                 Block_sparse_matrix_3<NT>& matrix)
{
  const int n = mesh.number_of_free_vertices;
  std::vector<int> row_begin(n + 1, 0);
  const auto for_each_pair_of = [&](const auto& vertices, const auto& f)
  {
    for(const int v : vertices)
      for(const int w : vertices)
        if(mesh.is_free(v) && mesh.is_free(w))
          f(v, w);
  };
  const auto for_each_pair = [&](const auto& f)
  {
    for(const std::array<int, 4>& cell : mesh.cells)
      for_each_pair_of(cell, f);
    for(const std::vector<int>& group : groups)
      for_each_pair_of(group, f);
  };

  for_each_pair([&](const int v, int) { ++row_begin[v + 1]; });
  for(int v = 0; v < n; ++v)
    row_begin[v + 1] += row_begin[v];
  std::vector<int> columns(row_begin[n]);
  std::vector<int> next(row_begin.begin(), row_begin.end() - 1);
  for_each_pair([&](const int v, const int w) { columns[next[v]++] = w; });

  // sort each row and remove what occurs more than once
  auto end = columns.begin();
  for(int v = 0; v < n; ++v)
  {
    const auto first = columns.begin() + row_begin[v];
    const auto last = columns.begin() + row_begin[v + 1];
    std::sort(first, last);
    row_begin[v] = static_cast<int>(end - columns.begin());
    end = std::move(first, std::unique(first, last), end);
  }
  row_begin[n] = static_cast<int>(end - columns.begin());
  columns.erase(end, columns.end());
  columns.shrink_to_fit();
  matrix.set_pattern(std::move(row_begin), std::move(columns));
}

// The packs, in chunks that are the units of parallel work, and the chunks in an order of rounds:
// the chunks of a round share no free vertex, so they may add to the same matrix at the same time,
// and each vertex receives its contributions in the same order whatever the number of threads.
class Cell_packs_3
{
public:
  template <typename NT>
  Cell_packs_3(const Numbered_mesh_3& mesh, const std::vector<Eigen::Matrix3d>& inverse_sources,
               const std::vector<double>& weights, const Block_sparse_matrix_3<NT>& matrix)
  {
    std::vector<int> cells;
    for(std::size_t c = 0; c < mesh.cells.size(); ++c)
      if(std::any_of(mesh.cells[c].begin(), mesh.cells[c].end(), [&](int v) { return mesh.is_free(v); }))
        cells.push_back(static_cast<int>(c));

    m_packs.resize((cells.size() + Pack::size - 1) / Pack::size);
    for(std::size_t p = 0; p < m_packs.size(); ++p)
      fill(m_packs[p], p * Pack::size, cells, mesh, inverse_sources, weights, matrix);
    distribute_to_rounds(mesh);
  }

  std::size_t number_of_packs() const { return m_packs.size(); }
  const Cell_pack_3& operator[](const std::size_t i) const { return m_packs[i]; }

  std::size_t number_of_chunks() const { return (m_packs.size() + packs_per_chunk - 1) / packs_per_chunk; }
  std::size_t chunk_begin(const std::size_t chunk) const { return chunk * packs_per_chunk; }
  std::size_t chunk_end(const std::size_t chunk) const
  { return (std::min)(m_packs.size(), (chunk + 1) * packs_per_chunk); }

  // Round r consists of the chunks chunk_of_round(i) for i in [round_begin(r), round_begin(r + 1)).
  std::size_t number_of_rounds() const { return m_round_begin.size() - 1; }
  std::size_t round_begin(const std::size_t round) const { return m_round_begin[round]; }
  std::size_t chunk_of_round(const std::size_t i) const { return m_chunks[i]; }

private:
  static constexpr std::size_t packs_per_chunk = 512 / Pack::size;

  template <typename NT>
  static void fill(Cell_pack_3& pack, const std::size_t first, const std::vector<int>& cells,
                   const Numbered_mesh_3& mesh, const std::vector<Eigen::Matrix3d>& inverse_sources,
                   const std::vector<double>& weights, const Block_sparse_matrix_3<NT>& matrix)
  {
    double inverse[9][Pack::size], weight[Pack::size];
    for(int lane = 0; lane < Pack::size; ++lane)
    {
      const bool is_padding = first + lane >= cells.size();
      const int c = is_padding ? cells.back() : cells[first + lane];
      weight[lane] = is_padding ? 0 : weights[c];
      std::array<int, 4> cell = mesh.cells[c];
      const Eigen::Matrix3d inverse_source = sort_vertices(cell, inverse_sources[c]);
      for(int i = 0; i < 9; ++i)
        inverse[i][lane] = inverse_source(i);
      for(int a = 0; a < 4; ++a)
      {
        pack.vertices[a][lane] = cell[a];
        for(int b = a; b < 4; ++b)
          pack.blocks[a][b][lane] = !is_padding && mesh.is_free(cell[b]) ? matrix.position(cell[a], cell[b]) : -1;
      }
    }
    for(int i = 0; i < 9; ++i)
      pack.inverse_source(i) = Pack::load(inverse[i]);
    pack.weight = Pack::load(weight);
  }

  // Sorts the vertices of a cell, and returns X^{-1} for the new order: its rows belong to the last
  // three vertices, and that of the first one is minus their sum.
  static Eigen::Matrix3d sort_vertices(std::array<int, 4>& cell, const Eigen::Matrix3d& inverse_source)
  {
    Eigen::Matrix<double, 4, 3> rows;
    rows << -inverse_source.colwise().sum(), inverse_source;
    std::array<int, 4> order = { 0, 1, 2, 3 };
    std::sort(order.begin(), order.end(), [&](const int i, const int j) { return cell[i] < cell[j]; });
    const std::array<int, 4> unsorted = cell;
    Eigen::Matrix3d result;
    for(int i = 0; i < 4; ++i)
    {
      cell[i] = unsorted[order[i]];
      if(i > 0)
        result.row(i - 1) = rows.row(order[i]);
    }
    return result;
  }

  void distribute_to_rounds(const Numbered_mesh_3& mesh)
  {
    std::vector<std::size_t> last_round(mesh.number_of_free_vertices, 0); // in which the vertex was taken
    std::vector<std::size_t> waiting(number_of_chunks());
    for(std::size_t i = 0; i < waiting.size(); ++i)
      waiting[i] = i;

    m_round_begin.push_back(0);
    for(std::size_t round = 1; !waiting.empty(); ++round)
    {
      std::vector<std::size_t> postponed;
      for(const std::size_t chunk : waiting)
      {
        if(for_each_free_vertex(chunk, mesh, [&](int v) { return last_round[v] != round; }))
        {
          for_each_free_vertex(chunk, mesh, [&](int v) { last_round[v] = round; return true; });
          m_chunks.push_back(chunk);
        }
        else
          postponed.push_back(chunk);
      }
      m_round_begin.push_back(m_chunks.size());
      waiting.swap(postponed);
    }
  }

  // Stops and returns false as soon as f does.
  template <typename Function>
  bool for_each_free_vertex(const std::size_t chunk, const Numbered_mesh_3& mesh, const Function& f) const
  {
    for(std::size_t p = chunk_begin(chunk); p < chunk_end(chunk); ++p)
      for(const Cell_pack_3::Indices& indices : m_packs[p].vertices)
        for(const int v : indices)
          if(mesh.is_free(v) && !f(v))
            return false;
    return true;
  }

  std::vector<Cell_pack_3> m_packs;
  std::vector<std::size_t> m_chunks;
  std::vector<std::size_t> m_round_begin;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CELL_PACKS_3_H
