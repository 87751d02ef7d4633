// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PARTITION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PARTITION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>

#include <petscmat.h>
#include <petscsf.h>

#include <array>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the vertices of cells, sorted. Each cell is a range of indices.
template <typename Cells>
std::vector<PetscInt> sorted_vertices(const Cells& cells)
{
  std::vector<PetscInt> result;
  result.reserve(4 * cells.size());
  for(const auto& cell : cells)
    result.insert(result.end(), cell.begin(), cell.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  result.shrink_to_fit();
  return result;
}

// Returns the index of an element of a sorted array.
inline std::size_t index_in(const std::vector<PetscInt>& sorted, const PetscInt v)
{ return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin()); }

// Communication of slices: each process holds a slice of an array, in the order of the ranks, and has a list of indices of the
// whole array.
class Star_forest
{
public:
  Star_forest(const MPI_communicator_3& communicator, const std::size_t size_of_slice, const std::vector<PetscInt>& indices)
    : m_communicator(communicator), m_size(indices.size())
  {
    communicator.synchronize();
    PetscLayout layout;
    check(PetscLayoutCreateFromSizes(communicator.get(), static_cast<PetscInt>(size_of_slice), PETSC_DETERMINE, 1,
                                     &layout));
    check(PetscSFCreate(communicator.get(), &m_sf));
    check(PetscSFSetGraphLayout(m_sf, layout, static_cast<PetscInt>(m_size), nullptr, PETSC_OWN_POINTER, indices.data()));
    check(PetscSFSetUp(m_sf));
    check(PetscLayoutDestroy(&layout));
  }

  Star_forest(const Star_forest&) = delete;
  Star_forest& operator=(const Star_forest&) = delete;
  ~Star_forest() { PetscSFDestroy(&m_sf); }

  // Returns the elements with the indices of this process.
  template <typename T>
  std::vector<T> get(const std::vector<T>& slice) const
  {
    std::vector<T> result(m_size);
    m_communicator.synchronize();
    const Element element(sizeof(T));
    check(PetscSFBcastBegin(m_sf, element.type, slice.data(), result.data(), MPI_REPLACE));
    check(PetscSFBcastEnd(m_sf, element.type, slice.data(), result.data(), MPI_REPLACE));
    return result;
  }

  // Writes the elements with the indices of this process, which no other process may write.
  template <typename T>
  void put(const std::vector<T>& elements, std::vector<T>& slice) const
  {
    m_communicator.synchronize();
    const Element element(sizeof(T));
    check(PetscSFReduceBegin(m_sf, element.type, elements.data(), slice.data(), MPI_REPLACE));
    check(PetscSFReduceEnd(m_sf, element.type, elements.data(), slice.data(), MPI_REPLACE));
  }

private:
  struct Element
  {
    explicit Element(const std::size_t size)
    {
      MPI_Type_contiguous(static_cast<int>(size), MPI_BYTE, &type);
      MPI_Type_commit(&type);
    }
    ~Element() { MPI_Type_free(&type); }
    MPI_Datatype type;
  };

  void check(const PetscErrorCode error) const { PetscCallAbort(m_communicator.get(), error); }

  const MPI_communicator_3& m_communicator;
  std::size_t m_size;
  PetscSF m_sf;
};

// Cell with the indices of its vertices in the whole mesh, and its own number there.
struct Global_cell_3
{
  std::array<PetscInt, 4> vertices;
  std::size_t number;

  auto begin() const { return vertices.begin(); }
  auto end() const { return vertices.end(); }
};

// Sends each cell to all processes that own one of its vertices. Each process receives cells in the order of their numbers.
template <typename OwnerOfVertex>
std::vector<Global_cell_3> cells_of_owners(const MPI_communicator_3& communicator, const std::vector<Global_cell_3>& cells,
                                           const OwnerOfVertex& owner_of)
{
  std::vector<std::vector<Global_cell_3> > to_owners(communicator.size());
  for(const Global_cell_3& cell : cells)
  {
    std::array<int, 4> owners;
    std::transform(cell.begin(), cell.end(), owners.begin(), owner_of);
    std::sort(owners.begin(), owners.end());
    const auto end = std::unique(owners.begin(), owners.end());
    std::for_each(owners.begin(), end, [&](const int owner) { to_owners[owner].push_back(cell); });
  }
  return communicator.exchanged(to_owners);
}

// Returns the part that each vertex of this slice is to belong to, such that few edges of cells, which may be with any process,
// join vertices of two parts.
inline std::vector<int> partition_3(const MPI_communicator_3& communicator, const std::vector<Global_cell_3>& cells,
                                    const std::size_t size_of_slice, const int number_of_parts)
{
  if(number_of_parts == 1)
    return std::vector<int>(size_of_slice, 0);
  std::vector<std::pair<PetscInt, PetscInt> > edges;
  edges.reserve(12 * cells.size());
  for(const Global_cell_3& cell : cells)
    for(const PetscInt v : cell)
      for(const PetscInt w : cell)
        if(v != w)
          edges.emplace_back(v, w);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<PetscInt> rows, columns;
  for(const auto& [v, w] : edges)
  {
    rows.push_back(v);
    columns.push_back(w);
  }

  communicator.synchronize();
  const auto check = [&](const PetscErrorCode error) { PetscCallAbort(communicator.get(), error); };
  const PetscInt n = static_cast<PetscInt>(size_of_slice);
  Mat graph;
  MatPartitioning partitioning;
  IS parts;
  const PetscInt* part;
  check(MatCreate(communicator.get(), &graph));
  check(MatSetSizes(graph, n, n, PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetType(graph, MATAIJ));
  check(MatSetPreallocationCOO(graph, static_cast<PetscCount>(rows.size()), rows.data(), columns.data()));
  check(MatAssemblyBegin(graph, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(graph, MAT_FINAL_ASSEMBLY));
  check(MatPartitioningCreate(communicator.get(), &partitioning));
  check(MatPartitioningSetAdjacency(partitioning, graph));
  check(MatPartitioningSetNParts(partitioning, number_of_parts));
  check(MatPartitioningSetType(partitioning, MATPARTITIONINGPTSCOTCH));
  check(MatPartitioningSetFromOptions(partitioning));
  check(MatPartitioningApply(partitioning, &parts));
  check(ISGetIndices(parts, &part));
  const std::vector<int> result(part, part + size_of_slice);
  check(ISRestoreIndices(parts, &part));
  check(ISDestroy(&parts));
  check(MatPartitioningDestroy(&partitioning));
  check(MatDestroy(&graph));
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PARTITION_3_H
