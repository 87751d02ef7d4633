// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_DISTRIBUTED_MESH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_DISTRIBUTED_MESH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Distributed/Distributed_tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Input_error.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/Star_forest.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/partition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Engine/engine.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>

#include <Eigen/Core>

#include <petscsf.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The part of a mesh that a process computes on: the vertices that it owns, and all cells around them.
class Distributed_mesh_3
{
public:
  using Point = std::array<double, 3>;

  // The target of a vertex on the boundary, or of one that `is_constrained` tells by its index, is read.
  template <typename IsConstrained>
  Distributed_mesh_3(const MPI_communicator_3& communicator, const Distributed_tetrahedron_soup_3& soup,
                     const std::vector<Point>& targets, const IsConstrained& is_constrained, const bool has_volume_weights)
    : m_communicator(communicator), m_size_of_slice(soup.points.size())
  {
    m_mesh.communicator = &communicator;
    m_mesh.has_volume_weights = has_volume_weights;
    const std::vector<Global_cell_3> slice = global_cells(soup);
    std::vector<PetscInt> vertices = vertices_of(slice);
    const std::vector<int> owner_in_slice = owners(slice);
    {
      const std::vector<int> owner = Star_forest(communicator, m_size_of_slice, vertices).get(owner_in_slice);
      m_cells = cells_of_owners(communicator, slice, [&](const std::size_t c, const std::size_t i)
                                                     { return owner[place(vertices, slice[c].vertices[i])]; });
    }
    vertices = vertices_of(m_cells);
    const Star_forest all(communicator, m_size_of_slice, vertices);
    const std::vector<int> owner = all.get(owner_in_slice);
    std::vector<char> is_prescribed(vertices.size(), 0), in_slice(m_size_of_slice, 0);
    set_boundary(vertices, is_prescribed); // as far as this process can tell: for its own vertices
    std::vector<PetscInt> own;
    std::vector<char> is_own_prescribed;
    double number_of_own_boundary_vertices = 0;
    for(std::size_t v = 0; v < vertices.size(); ++v)
      if(owner[v] == communicator.rank())
      {
        number_of_own_boundary_vertices += is_prescribed[v];
        own.push_back(vertices[v]);
        is_own_prescribed.push_back(is_prescribed[v] || is_constrained(static_cast<std::size_t>(vertices[v])));
      }
    m_own = std::make_unique<Star_forest>(communicator, m_size_of_slice, own);
    m_own->put(is_own_prescribed, in_slice);
    is_prescribed = all.get(in_slice);
    number(vertices, all.get(soup.points), all.get(targets), owner, is_prescribed);
    set_rows(all, vertices, own);

    m_number_of_vertices = static_cast<std::size_t>(communicator.sum(static_cast<double>(own.size())));
    m_number_of_boundary_vertices = static_cast<std::size_t>(communicator.sum(number_of_own_boundary_vertices));
    m_cells = {};
  }

  const Numbered_mesh_3& mesh() const { return m_mesh; }
  std::size_t number_of_vertices() const { return m_number_of_vertices; } // of all processes, and of cells
  std::size_t number_of_boundary_vertices() const { return m_number_of_boundary_vertices; }

  // The row of each free vertex in the systems of all processes; those of this one's own vertices are consecutive.
  const std::vector<PetscInt>& rows() const { return m_rows; }
  int number_of_own_rows() const { return m_mesh.number_of_free_vertices - m_mesh.number_of_copied_vertices; }

  // The images of the points of the slice; those without a cell have coordinates that are not numbers.
  void write(const Eigen::Matrix3Xd& positions, std::vector<Point>& images) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Point> own(m_own_numbers.size()), slice(m_size_of_slice, {nan, nan, nan});
    for(std::size_t i = 0; i < own.size(); ++i)
      Eigen::Map<Eigen::Vector3d>(own[i].data()) = positions.col(m_own_numbers[i]);
    m_own->put(own, slice);
    images.swap(slice);
  }

private:
  static std::size_t place(const std::vector<PetscInt>& sorted, const PetscInt v)
  {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin());
  }

  static std::vector<PetscInt> vertices_of(const std::vector<Global_cell_3>& cells)
  {
    std::vector<PetscInt> result;
    result.reserve(4 * cells.size());
    for(const Global_cell_3& cell : cells)
      result.insert(result.end(), cell.vertices.begin(), cell.vertices.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    result.shrink_to_fit();
    return result;
  }

  // The indices of slices: the first one of each process, and their number.
  std::vector<PetscInt> begins(const std::size_t size) const
  {
    std::vector<PetscInt> result = { 0 };
    double end = 0;
    for(const double n : m_communicator.gathered(static_cast<double>(size)))
    {
      end += n;
      if(!(3 * end < std::numeric_limits<PetscInt>::max()))
        throw Input_error("the mesh is too large for the indices of this PETSc; take one with 64-bit indices");
      result.push_back(static_cast<PetscInt>(end));
    }
    return result;
  }

  std::vector<Global_cell_3> global_cells(const Distributed_tetrahedron_soup_3& soup)
  {
    m_point_begin = begins(soup.points.size());
    PetscInt number = begins(soup.cells.size())[m_communicator.rank()];
    std::vector<Global_cell_3> result;
    result.reserve(soup.cells.size());
    for(const std::array<std::size_t, 4>& cell : soup.cells)
    {
      result.push_back({ {}, number++ });
      const std::string subject = "cell " + std::to_string(result.back().number) + " (counted from 0) has ";
      for(std::size_t i = 0; i < 4; ++i)
      {
        if(cell[i] >= static_cast<std::size_t>(m_point_begin.back()))
          throw Input_error(subject + "a vertex " + std::to_string(cell[i]) + " that does not exist");
        if(std::count(cell.begin(), cell.end(), cell[i]) > 1)
          throw Input_error(subject + "the vertex " + std::to_string(cell[i]) + " twice");
        result.back().vertices[i] = static_cast<PetscInt>(cell[i]);
      }
    }
    return result;
  }

  // Of the vertices of the slice. At first, those that hold a point take care of its vertex.
  std::vector<int> owners(const std::vector<Global_cell_3>& slice) const
  {
    const auto holder = [&](const std::size_t c, const std::size_t i)
    {
      return static_cast<int>(std::upper_bound(m_point_begin.begin(), m_point_begin.end(), slice[c].vertices[i])
                              - m_point_begin.begin()) - 1;
    };
    return partition_3(m_communicator, cells_of_owners(m_communicator, slice, holder),
                       m_point_begin[m_communicator.rank()], static_cast<PetscInt>(m_size_of_slice), m_point_begin.back());
  }

  // A facet with one cell is on the boundary if one of its vertices is this process's own; otherwise the other cell may be
  // with another process.
  void set_boundary(const std::vector<PetscInt>& vertices, std::vector<char>& is_on_boundary) const
  {
    struct Side
    {
      std::array<PetscInt, 3> facet;
      PetscInt cell;
      bool is_odd; // is the facet an odd permutation of how the cell sees it?
    };
    std::vector<Side> sides;
    sides.reserve(4 * m_cells.size());
    for(const Global_cell_3& cell : m_cells)
      for(std::size_t i = 0; i < 4; ++i)
      {
        Side side = { { cell.vertices[(i + 1) % 4], cell.vertices[(i + 2) % 4], cell.vertices[(i + 3) % 4] },
                      cell.number, i % 2 == 1 };
        auto& [a, b, c] = side.facet;
        for(auto [first, second] : { std::pair(&a, &b), std::pair(&b, &c), std::pair(&a, &b) })
          if(*second < *first)
          {
            std::swap(*first, *second);
            side.is_odd = !side.is_odd;
          }
        sides.push_back(side);
      }
    std::sort(sides.begin(), sides.end(),
              [](const Side& s, const Side& t) { return std::tie(s.facet, s.cell) < std::tie(t.facet, t.cell); });
    for(std::size_t i = 0, next; i < sides.size(); i = next)
    {
      for(next = i + 1; next < sides.size() && sides[next].facet == sides[i].facet; ++next) {}
      if(next - i == 1)
        for(const PetscInt v : sides[i].facet)
          is_on_boundary[place(vertices, v)] = 1;
      else if(next - i > 2 || sides[i].is_odd == sides[i + 1].is_odd)
        throw Input_error("cell " + std::to_string(sides[i].cell) + " and cell " + std::to_string(sides[i + 1].cell)
                          + " (counted from 0) share a facet with a third one, or lie on the same side of it");
    }
  }

  // Own free vertices come first, in an order of space, then copies of free ones, then prescribed ones.
  void number(std::vector<PetscInt>& vertices, const std::vector<Point>& points, const std::vector<Point>& targets,
              const std::vector<int>& owner, const std::vector<char>& is_prescribed)
  {
    std::vector<std::size_t> order; // places in `vertices`
    std::vector<bool> is_not_own_free;
    for(const bool prescribed : { false, true })
      for(std::size_t v = 0; v < vertices.size(); ++v)
        if((is_prescribed[v] != 0) == prescribed)
        {
          order.push_back(v);
          is_not_own_free.push_back(prescribed || owner[v] != m_communicator.rank());
        }
    const auto end_of_free = std::count(is_prescribed.begin(), is_prescribed.end(), 0);

    std::vector<int> local(vertices.size());
    Eigen::Matrix3Xd source(3, vertices.size());
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      local[order[i]] = static_cast<int>(i);
      source.col(i) = Eigen::Map<const Eigen::Vector3d>(points[order[i]].data());
    }
    std::vector<std::array<int, 4> > cells;
    std::vector<bool> is_copy; // the owner of its first vertex owns a cell
    for(const Global_cell_3& cell : m_cells)
    {
      cells.emplace_back();
      for(std::size_t i = 0; i < 4; ++i)
        cells.back()[i] = local[place(vertices, cell.vertices[i])];
      const PetscInt first = *std::min_element(cell.vertices.begin(), cell.vertices.end());
      is_copy.push_back(owner[place(vertices, first)] != m_communicator.rank());
    }
    const std::vector<std::size_t> places = engine::set_numbered_mesh(cells, source, is_not_own_free, m_mesh);
    m_mesh.number_of_copied_vertices = static_cast<int>(end_of_free) - m_mesh.number_of_free_vertices;
    m_mesh.number_of_free_vertices = static_cast<int>(end_of_free);
    move_copies_to_end(is_copy);
    if(static_cast<double>(inverted_cells(m_mesh, m_mesh.source).number) == m_mesh.number_of_all_cells())
      for(std::array<int, 4>& cell : m_mesh.cells) // the cells of many files are all negative
        std::swap(cell[0], cell[1]);

    std::vector<PetscInt> renumbered;
    m_mesh.target.setZero(3, m_mesh.number_of_vertices());
    for(std::size_t i = 0; i < places.size(); ++i)
    {
      const std::size_t v = order[places[i]];
      renumbered.push_back(vertices[v]);
      if(is_prescribed[v])
        m_mesh.target.col(i) = Eigen::Map<const Eigen::Vector3d>(targets[v].data());
    }
    vertices.swap(renumbered);
  }

  // Own cells come first; the numbers for messages are those of the whole mesh.
  void move_copies_to_end(const std::vector<bool>& is_copy)
  {
    std::vector<std::array<int, 4> > cells;
    std::vector<std::size_t> numbers;
    for(const bool copies : { false, true })
      for(std::size_t c = 0; c < m_mesh.cells.size(); ++c)
        if(is_copy[m_mesh.user_numbers[c]] == copies)
        {
          cells.push_back(m_mesh.cells[c]);
          numbers.push_back(static_cast<std::size_t>(m_cells[m_mesh.user_numbers[c]].number));
          m_mesh.number_of_copied_cells += copies;
        }
    m_mesh.cells.swap(cells);
    m_mesh.user_numbers.swap(numbers);
  }

  // Each owner tells the rows of its vertices to all; `vertices` is in the order of the mesh, `sorted_own` is not.
  void set_rows(const Star_forest& all, const std::vector<PetscInt>& vertices, const std::vector<PetscInt>& sorted_own)
  {
    const PetscInt first = begins(number_of_own_rows())[m_communicator.rank()];
    std::vector<PetscInt> of_own(sorted_own.size(), -1), of_slice(m_size_of_slice, -1);
    m_own_numbers.assign(sorted_own.size(), 0);
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      const std::size_t k = place(sorted_own, vertices[i]);
      if(k == sorted_own.size() || sorted_own[k] != vertices[i])
        continue;
      m_own_numbers[k] = static_cast<int>(i);
      if(m_mesh.is_free(static_cast<int>(i)))
        of_own[k] = first + static_cast<PetscInt>(i);
    }
    m_own->put(of_own, of_slice);
    const std::vector<PetscInt> sorted_rows = all.get(of_slice);
    std::vector<PetscInt> sorted = vertices;
    std::sort(sorted.begin(), sorted.end());
    for(int i = 0; i < m_mesh.number_of_free_vertices; ++i)
      m_rows.push_back(sorted_rows[place(sorted, vertices[i])]);
  }

  const MPI_communicator_3& m_communicator;
  std::size_t m_size_of_slice;
  std::vector<PetscInt> m_point_begin; // of the slices, and their number
  std::vector<Global_cell_3> m_cells;
  std::unique_ptr<Star_forest> m_own;  // the slices and the vertices that this process owns, in the order of their indices
  std::vector<int> m_own_numbers;      // of those vertices, in the numbered mesh
  Numbered_mesh_3 m_mesh;
  std::vector<PetscInt> m_rows;
  std::size_t m_number_of_vertices, m_number_of_boundary_vertices;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_DISTRIBUTED_MESH_3_H
