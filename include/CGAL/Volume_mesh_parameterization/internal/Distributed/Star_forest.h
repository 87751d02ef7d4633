// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_STAR_FOREST_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_STAR_FOREST_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>

#include <petscsf.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The vertices of cells, sorted. Each cell is a range of indices.
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

// The index of an element of a sorted array.
inline std::size_t place(const std::vector<PetscInt>& sorted, const PetscInt v)
{
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin());
}

// Each process holds a slice of an array, those of the ranks one behind the other, and has a list of indices of the whole.
class Star_forest
{
public:
  Star_forest(const MPI_communicator_3& communicator, const std::size_t size_of_slice,
              const std::vector<PetscInt>& indices)
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

  // The elements with these indices.
  template <typename T>
  std::vector<T> get(const std::vector<T>& slice) const
  {
    std::vector<T> result(m_size);
    m_communicator.synchronize();
    const Unit unit(sizeof(T));
    check(PetscSFBcastBegin(m_sf, unit.type, slice.data(), result.data(), MPI_REPLACE));
    check(PetscSFBcastEnd(m_sf, unit.type, slice.data(), result.data(), MPI_REPLACE));
    return result;
  }

  // Writes the elements with these indices, which no other process may write.
  template <typename T>
  void put(const std::vector<T>& elements, std::vector<T>& slice) const
  {
    m_communicator.synchronize();
    const Unit unit(sizeof(T));
    check(PetscSFReduceBegin(m_sf, unit.type, elements.data(), slice.data(), MPI_REPLACE));
    check(PetscSFReduceEnd(m_sf, unit.type, elements.data(), slice.data(), MPI_REPLACE));
  }

private:
  struct Unit
  {
    explicit Unit(const std::size_t size)
    {
      MPI_Type_contiguous(static_cast<int>(size), MPI_BYTE, &type);
      MPI_Type_commit(&type);
    }
    ~Unit() { MPI_Type_free(&type); }
    MPI_Datatype type;
  };

  void check(const PetscErrorCode error) const { PetscCallAbort(m_communicator.get(), error); }

  const MPI_communicator_3& m_communicator;
  std::size_t m_size;
  PetscSF m_sf;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_STAR_FOREST_H
