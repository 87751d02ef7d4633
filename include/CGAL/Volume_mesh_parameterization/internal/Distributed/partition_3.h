// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PARTITION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PARTITION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>

#include <petscmat.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// A cell with the indices of its vertices and its own in the whole mesh.
struct Global_cell_3
{
  std::array<PetscInt, 4> vertices;
  PetscInt number;
};

// Sends each cell to all processes that own one of its vertices, where `owner_of(c, i)` owns the i-th vertex of cell c.
// Each process receives cells in the order of their numbers.
template <typename OwnerOf>
std::vector<Global_cell_3> cells_of_owners(const MPI_communicator_3& communicator, const std::vector<Global_cell_3>& cells,
                                           const OwnerOf& owner_of)
{
  std::vector<std::vector<Global_cell_3> > to_owners(communicator.size());
  for(std::size_t c = 0; c < cells.size(); ++c)
  {
    std::array<int, 4> owners = { owner_of(c, 0), owner_of(c, 1), owner_of(c, 2), owner_of(c, 3) };
    std::sort(owners.begin(), owners.end());
    const auto end = std::unique(owners.begin(), owners.end());
    for(auto owner = owners.begin(); owner != end; ++owner)
      to_owners[*owner].push_back(cells[c]);
  }
  return communicator.exchanged(to_owners);
}

// The process that is to own each vertex of this slice, such that few edges join vertices of two processes. The cells are
// those around the vertices of the slice, which begins with vertex `first`.
inline std::vector<int> partition_3(const MPI_communicator_3& communicator, const std::vector<Global_cell_3>& cells,
                                    const PetscInt first, const PetscInt size, const PetscInt number_of_vertices)
{
  if(communicator.size() == 1)
    return std::vector<int>(size, 0);
  std::vector<std::pair<PetscInt, PetscInt> > edges;
  for(const Global_cell_3& cell : cells)
    for(const PetscInt v : cell.vertices)
      for(const PetscInt w : cell.vertices)
        if(v != w && first <= v && v < first + size)
          edges.emplace_back(v - first, w);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  setenv("SCOTCH_PTHREAD_NUMBER", "1", 0); // with threads, PT-Scotch finds another partition in each run
  communicator.synchronize();
  const auto check = [&](const PetscErrorCode error) { PetscCallAbort(communicator.get(), error); };
  PetscInt *row_begin, *columns; // which the graph takes over
  check(PetscCalloc1(size + 1, &row_begin));
  check(PetscMalloc1(edges.size(), &columns));
  for(std::size_t i = 0; i < edges.size(); ++i)
  {
    ++row_begin[edges[i].first + 1];
    columns[i] = edges[i].second;
  }
  for(PetscInt v = 0; v < size; ++v)
    row_begin[v + 1] += row_begin[v];
  Mat graph;
  MatPartitioning partitioning;
  IS parts;
  const PetscInt* owners;
  check(MatCreateMPIAdj(communicator.get(), size, number_of_vertices, row_begin, columns, nullptr, &graph));
  check(MatPartitioningCreate(communicator.get(), &partitioning));
  check(MatPartitioningSetAdjacency(partitioning, graph));
  check(MatPartitioningSetType(partitioning, MATPARTITIONINGPTSCOTCH));
  check(MatPartitioningSetFromOptions(partitioning));
  check(MatPartitioningApply(partitioning, &parts));
  check(ISGetIndices(parts, &owners));
  const std::vector<int> result(owners, owners + size);
  check(ISRestoreIndices(parts, &owners));
  check(ISDestroy(&parts));
  check(MatPartitioningDestroy(&partitioning));
  check(MatDestroy(&graph));
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PARTITION_3_H
