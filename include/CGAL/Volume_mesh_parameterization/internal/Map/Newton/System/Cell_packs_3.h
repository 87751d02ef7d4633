// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_CELL_PACKS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_CELL_PACKS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Unknowns_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The packs, in chunks that are the units of parallel work, and the chunks in an order of rounds: those of a round share
// no unknown vertex (a coloring), so they may add to the same matrix at the same time, and each vertex receives its
// contributions in the same order whatever the number of threads. Cells that are copies of another process's have packs and
// chunks of their own, behind the others.
class Cell_packs_3
{
public:
  // The cells with the lowest rows come first; those without an unknown vertex are apart. Takes the scaled cells by value, as
  // they need half the memory of the packs, and are to be gone when the caller goes on.
  Cell_packs_3(const Numbered_mesh_3& mesh, Scaled_cells_3 scaled, const Unknowns_3& unknowns,
               const Sparsity_pattern_3& pattern)
    : m_is_parallel(mesh.is_parallel)
  {
    const int n = unknowns.size(), number_of_own_cells = static_cast<int>(mesh.number_of_own_cells());
    const auto row_of = [&](const int c) // own cells without an unknown vertex are behind the others, then come copies
    {
      const auto& [u, v, w, x] = mesh.cells[c];
      const int lowest = (std::min)({ order(unknowns, u), order(unknowns, v), order(unknowns, w), order(unknowns, x), n });
      return c < number_of_own_cells ? lowest : n + 1 + lowest;
    };
    const Compressed_rows<int> cells(2 * std::size_t(n + 1), mesh.cells.size(),
                                     [&](const int c, const auto& f) { f(row_of(c)); }, m_is_parallel);
    const auto append_rows = [&](const std::size_t first, const std::size_t last, std::vector<int>& result)
    {
      result.insert(result.end(), cells.items.data() + cells.begin[first], cells.items.data() + cells.begin[last]);
      append_padding(cells_per_pack, result);
    };
    m_cells.reserve(mesh.cells.size() + cells_per_pack);
    append_rows(0, n, m_cells);
    if(cells.begin[n + 1] != cells.begin[2 * n + 1])
      append_padding(cells_per_pack * packs_per_chunk, m_cells);
    m_number_of_own_packs = m_cells.size() / cells_per_pack;
    append_rows(n + 1, 2 * n + 1, m_cells);
    append_rows(n, n + 1, m_other_cells);
    m_packs = packed(m_cells, mesh, unknowns, pattern);
    m_others = packed(m_other_cells, mesh, unknowns, pattern);
    set_references(mesh, scaled);
    distribute_to_rounds(unknowns.size());
  }

  // Packs those cells of `whole` that an unknown vertex belongs to, with their reference cells and weights; they are few.
  Cell_packs_3(const Cell_packs_3& whole, const Unknowns_3& unknowns, const Sparsity_pattern_3& pattern)
    : m_is_parallel(false)
  {
    std::vector<std::size_t> indices; // in the whole
    for(std::size_t i = 0; i < whole.m_cells.size(); ++i)
    {
      const std::array<int, 4> cell = whole.m_packs[i / cells_per_pack].cell(i % cells_per_pack);
      if(is_padding(whole.m_cells[i])
         || std::none_of(cell.begin(), cell.end(), [&](const int v) { return unknowns.contains(v); }))
        continue;
      indices.push_back(i);
      m_cells.push_back(whole.m_cells[i]);
    }
    append_padding(cells_per_pack, m_cells);
    m_number_of_own_packs = m_cells.size() / cells_per_pack;
    m_packs.resize(m_number_of_own_packs);
    for(std::size_t i = 0; i < m_cells.size(); ++i)
    {
      const std::size_t index = indices[(std::min)(i, indices.size() - 1)], lane = i % cells_per_pack;
      const Cell_pack_3& from = whole.m_packs[index / cells_per_pack];
      Cell_pack_3& pack = m_packs[i / cells_per_pack];
      set_cell(pack, lane, from.cell(index % cells_per_pack), is_padding(m_cells[i]), unknowns, pattern);
      pack.weight[lane] = is_padding(m_cells[i]) ? 0 : from.weight[index % cells_per_pack];
      for(int k = 0; k < 9; ++k)
        pack.inverse_source[k][lane] = from.inverse_source[k][index % cells_per_pack];
    }
    distribute_to_rounds(unknowns.size());
  }

  // Takes these reference cells and weights from now on.
  void set_references(const Numbered_mesh_3& mesh, const Scaled_cells_3& scaled)
  {
    set_references(m_cells, mesh, scaled, m_packs);
    set_references(m_other_cells, mesh, scaled, m_others);
  }

  bool is_parallel() const { return m_is_parallel; } // may threads share the work on them?
  std::size_t number_of_packs() const { return m_packs.size(); }

  std::size_t number_of_chunks() const { return (m_packs.size() + packs_per_chunk - 1) / packs_per_chunk; }
  std::size_t number_of_own_chunks() const { return (m_number_of_own_packs + packs_per_chunk - 1) / packs_per_chunk; }
  const Cell_pack_3* chunk_begin(const std::size_t chunk) const { return m_packs.data() + chunk * packs_per_chunk; }
  const Cell_pack_3* chunk_end(const std::size_t chunk) const
  { return m_packs.data() + (std::min)(m_packs.size(), (chunk + 1) * packs_per_chunk); }

  const Cell_pack_3* others_begin() const { return m_others.data(); }
  const Cell_pack_3* others_end() const { return m_others.data() + m_others.size(); }

  // Round r consists of the chunks chunk_of_round(i) for i in [round_begin(r), round_begin(r + 1)).
  std::size_t number_of_rounds() const { return m_round_begin.size() - 1; }
  std::size_t round_begin(const std::size_t round) const { return m_round_begin[round]; }
  std::size_t chunk_of_round(const std::size_t i) const { return m_chunks[i]; }

private:
  static constexpr int lanes_per_range = 512; // a guess; of packs
  static constexpr std::size_t packs_per_chunk = lanes_per_range / cells_per_pack;

  // The unknown vertices in the order of their rows, and the others behind them.
  static int order(const Unknowns_3& unknowns, const int v)
  { return unknowns.contains(v) ? unknowns.row(v) : unknowns.size() + v; }

  // Packs are filled up with the last cell, which `padding()` describes.
  static int padding(const int c) { return -1 - c; }
  static bool is_padding(const int c) { return c < 0; }
  static int cell_of(const int c) { return is_padding(c) ? padding(c) : c; }

  static void append_padding(const std::size_t multiple, std::vector<int>& result)
  {
    while(result.size() % multiple != 0)
      result.push_back(padding(cell_of(result.back())));
  }

  static std::vector<Cell_pack_3> packed(const std::vector<int>& cells, const Numbered_mesh_3& mesh,
                                         const Unknowns_3& unknowns, const Sparsity_pattern_3& pattern)
  {
    std::vector<Cell_pack_3> packs(cells.size() / cells_per_pack);
    for_each_in_ranges(mesh.is_parallel, cells.size(), lanes_per_range, [&](const std::size_t i)
    {
      std::array<int, 4> cell = mesh.cells[cell_of(cells[i])];
      std::sort(cell.begin(), cell.end(), [&](const int v, const int w) { return order(unknowns, v) < order(unknowns, w); });
      set_cell(packs[i / cells_per_pack], i % cells_per_pack, cell, is_padding(cells[i]), unknowns, pattern);
    });
    return packs;
  }

  // The unknown vertices of the cell are in the order of their rows.
  static void set_cell(Cell_pack_3& pack, const std::size_t lane, const std::array<int, 4>& cell, const bool is_padding,
                       const Unknowns_3& unknowns, const Sparsity_pattern_3& pattern)
  {
    for(int a = 0; a < 4; ++a)
    {
      pack.vertices[a][lane] = cell[a];
      pack.rows[a][lane] = is_padding ? -1 : unknowns.row(cell[a]);
      for(int b = a; b < 4; ++b)
        pack.blocks[Cell_pack_3::index_of_block(a, b)][lane]
          = !is_padding && unknowns.contains(cell[a]) && unknowns.contains(cell[b])
            ? pattern.position(unknowns.row(cell[a]), unknowns.row(cell[b])) : -1;
    }
  }

  static void set_references(const std::vector<int>& cells, const Numbered_mesh_3& mesh, const Scaled_cells_3& scaled,
                             std::vector<Cell_pack_3>& packs)
  {
    for_each_in_ranges(mesh.is_parallel, cells.size(), lanes_per_range, [&](const std::size_t i)
    {
      Cell_pack_3& pack = packs[i / cells_per_pack];
      const int lane = static_cast<int>(i % cells_per_pack);
      const int c = cell_of(cells[i]);
      pack.weight[lane] = is_padding(cells[i]) ? 0 : scaled.weights[c];
      const Matrix_3 inverse_source = for_sorted_vertices(pack.cell(lane), mesh.cells[c], scaled.inverse_sources[c]);
      for(int k = 0; k < 9; ++k)
        pack.inverse_source[k][lane] = inverse_source(k % 3, k / 3);
    });
  }

  // X^{-1} of a cell whose vertices are sorted: its rows belong to the last three vertices, and that of the first one is
  // minus their sum.
  static Matrix_3 for_sorted_vertices(const std::array<int, 4>& sorted, const std::array<int, 4>& cell,
                                             const Matrix_3& inverse_source)
  {
    Matrix_3 result;
    for(int i = 1; i < 4; ++i)
      if(const auto row = std::find(cell.begin(), cell.end(), sorted[i]) - cell.begin() - 1; row >= 0)
        result.set_row(i - 1, inverse_source.row(static_cast<int>(row)));
      else
        result.set_row(i - 1, -(inverse_source.row(0) + (inverse_source.row(1) + inverse_source.row(2))));
    return result;
  }

  void distribute_to_rounds(const int number_of_rows)
  {
    std::vector<std::vector<int> > rows(number_of_chunks());
    for_each_index(m_is_parallel, 0, rows.size(), [&](const std::size_t chunk) { rows[chunk] = rows_of_chunk(chunk); });
    std::vector<std::size_t> last_round(number_of_rows, 0); // in which the row was taken
    std::vector<std::size_t> waiting(number_of_chunks());
    std::iota(waiting.begin(), waiting.end(), std::size_t(0));

    m_round_begin.push_back(0);
    for(std::size_t round = 1; !waiting.empty(); ++round)
    {
      std::vector<std::size_t> postponed;
      for(const std::size_t chunk : waiting)
      {
        const bool is_taken = std::all_of(rows[chunk].begin(), rows[chunk].end(),
                                          [&](const int row) { return last_round[row] != round; });
        for(const int row : rows[chunk])
          if(is_taken)
            last_round[row] = round;
        (is_taken ? m_chunks : postponed).push_back(chunk);
      }
      m_round_begin.push_back(m_chunks.size());
      waiting.swap(postponed);
    }
  }

  // Most repetitions are left out.
  std::vector<int> rows_of_chunk(const std::size_t chunk) const
  {
    std::array<int, 1024> seen;
    seen.fill(-1);
    std::vector<int> result;
    for(const Cell_pack_3* pack = chunk_begin(chunk); pack != chunk_end(chunk); ++pack)
      for(const Cell_pack_3::Indices& rows : pack->rows)
        for(const int row : rows)
          if(row >= 0 && seen[row % seen.size()] != row)
          {
            seen[row % seen.size()] = row;
            result.push_back(row);
          }
    return result;
  }

  bool m_is_parallel;
  std::vector<Cell_pack_3> m_packs, m_others;
  std::vector<int> m_cells, m_other_cells; // in the order of the packs, with the padding
  std::size_t m_number_of_own_packs;
  std::vector<std::size_t> m_chunks;
  std::vector<std::size_t> m_round_begin;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_CELL_PACKS_3_H
