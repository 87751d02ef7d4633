// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_DISTRIBUTED_MESH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_DISTRIBUTED_MESH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Distributed/Distributed_tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/partition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Facet_matching_3.h>

#include <petscsystypes.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Part of a mesh that a process computes on: the vertices that the process owns, and all cells around them.
class Distributed_mesh_3
{
public:
  using Point = std::array<double, 3>;

  // Reads the targets of vertices on the boundary, and of those for whose index `is_constrained` is true.
  template <typename IsConstrained>
  Distributed_mesh_3(const MPI_communicator_3& communicator, const Distributed_tetrahedron_soup_3& soup,
                     const std::vector<Point>& targets, const IsConstrained& is_constrained, const bool has_volume_weights,
                     const bool is_parallel = false)
    : m_communicator(communicator), m_size_of_slice(soup.points.size())
  {
    const std::vector<Global_cell_3> slice = cells_of_slice(soup);
    const std::vector<int> owner_in_slice = partition_3(communicator, slice, m_size_of_slice, communicator.size());
    const std::vector<Global_cell_3> global_cells = cells_around_own_vertices(slice, owner_in_slice);
    // hereafter, vertices are indices in this sorted array of the vertices of all cells of this process
    const std::vector<PetscInt> vertices = sorted_vertices(global_cells);
    const auto [cells, numbers] = renumbered(global_cells, vertices);
    const Star_forest all(communicator, m_size_of_slice, vertices);
    const std::vector<int> owner = all.get(owner_in_slice);
    // true for the own vertices only: the other cell of a facet may be with another process
    const std::vector<bool> is_on_boundary = used_points(
      facets_of_sides(cells.cells, Facet_matching_3(cells.cells, false, {}, numbers).sides_on_boundary()), cells.points.size());
    std::vector<PetscInt> own;
    std::vector<std::size_t> indices_of_own;
    std::vector<char> is_own_prescribed, is_prescribed_in_slice(m_size_of_slice, 0);
    double number_of_own_boundary_vertices = 0;
    for(std::size_t v = 0; v < vertices.size(); ++v)
      if(owner[v] == communicator.rank())
      {
        own.push_back(vertices[v]);
        indices_of_own.push_back(v);
        is_own_prescribed.push_back(is_on_boundary[v] || is_constrained(static_cast<std::size_t>(vertices[v])));
        number_of_own_boundary_vertices += is_on_boundary[v];
      }
    m_own = std::make_unique<Star_forest>(communicator, m_size_of_slice, own);
    m_own->put(is_own_prescribed, is_prescribed_in_slice);
    const std::vector<int> mesh_numbers = number(cells, numbers, all.get(soup.points), all.get(targets), owner,
                                                 all.get(is_prescribed_in_slice), is_parallel);
    m_mesh.has_volume_weights = has_volume_weights;
    for(const std::size_t v : indices_of_own)
      m_own_numbers.push_back(mesh_numbers[v]);
    m_mesh.vertex_numbers.resize(mesh_numbers.size());
    for(std::size_t v = 0; v < mesh_numbers.size(); ++v)
      m_mesh.vertex_numbers[mesh_numbers[v]] = vertices[v];
    set_rows(all, mesh_numbers);

    m_number_of_vertices = communicator.begins(own.size()).back();
    m_number_of_boundary_vertices = static_cast<std::size_t>(communicator.sum(number_of_own_boundary_vertices));
  }

  const Numbered_mesh_3& mesh() const { return m_mesh; }
  std::size_t number_of_vertices() const { return m_number_of_vertices; } // vertices of cells, of all processes
  std::size_t number_of_boundary_vertices() const { return m_number_of_boundary_vertices; }

  // Returns the row of each free vertex in the systems of all processes; the rows of own vertices are consecutive.
  const std::vector<PetscInt>& global_rows() const { return m_rows; }
  int number_of_own_rows() const { return m_mesh.number_of_free_vertices - m_mesh.number_of_copied_vertices; }

  // Writes the images of the points of the slice; points without a cell get coordinates that are not numbers.
  void write(const Matrix3Xd& positions, std::vector<Point>& images) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Point> own(m_own_numbers.size()), slice(m_size_of_slice, {nan, nan, nan});
    for(std::size_t i = 0; i < own.size(); ++i)
      own[i] = coordinates(positions.col(m_own_numbers[i]));
    m_own->put(own, slice);
    images.swap(slice);
  }

private:
  std::vector<Global_cell_3> cells_of_slice(const Distributed_tetrahedron_soup_3& soup) const
  {
    const std::size_t number_of_points = m_communicator.begins(soup.points.size()).back();
    std::size_t number = m_communicator.begins(soup.cells.size())[m_communicator.rank()];
    if(number_of_points >= (std::numeric_limits<PetscInt>::max)() / 3)
      throw Input_error("the mesh is too large for the indices of this PETSc; take one with 64-bit indices");
    std::vector<Global_cell_3> result;
    result.reserve(soup.cells.size());
    for(const std::array<std::size_t, 4>& cell : soup.cells)
    {
      check_simplex(cell, number_of_points, "cell ", number);
      result.push_back({ {}, number++ });
      std::copy(cell.begin(), cell.end(), result.back().vertices.begin());
    }
    return result;
  }

  std::vector<Global_cell_3> cells_around_own_vertices(const std::vector<Global_cell_3>& slice,
                                                       const std::vector<int>& owner_in_slice) const
  {
    const std::vector<PetscInt> vertices = sorted_vertices(slice);
    const std::vector<int> owner = Star_forest(m_communicator, m_size_of_slice, vertices).get(owner_in_slice);
    return cells_of_owners(m_communicator, slice, [&](const PetscInt v) { return owner[index_in(vertices, v)]; });
  }

  // Returns cells with the indices of their vertices in `vertices`, and the numbers of the cells.
  static std::pair<Tetrahedron_soup_3, std::vector<std::size_t> >
  renumbered(const std::vector<Global_cell_3>& cells, const std::vector<PetscInt>& vertices)
  {
    std::pair<Tetrahedron_soup_3, std::vector<std::size_t> > result;
    result.first.points.resize(vertices.size());
    for(const Global_cell_3& cell : cells)
    {
      std::array<std::size_t, 4>& indices = result.first.cells.emplace_back();
      std::transform(cell.begin(), cell.end(), indices.begin(), [&](const PetscInt v) { return index_in(vertices, v); });
      result.second.push_back(cell.number);
    }
    return result;
  }

  // Numbers the vertices: own free vertices in a spatial order, then copies of free ones, then prescribed ones. Returns the
  // number of each vertex in the mesh.
  std::vector<int> number(const Tetrahedron_soup_3& soup, const std::vector<std::size_t>& numbers,
                          const std::vector<Point>& points, const std::vector<Point>& targets,
                          const std::vector<int>& owner, const std::vector<char>& is_prescribed, const bool is_parallel)
  {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto end_of_free
      = std::stable_partition(order.begin(), order.end(), [&](const std::size_t v) { return is_prescribed[v] == 0; });
    const std::vector<int> positions = inverse_order(order);
    std::vector<bool> is_not_own_free;
    Matrix3Xd source(3, order.size());
    for(const std::size_t v : order)
    {
      source.col(is_not_own_free.size()) = Eigen::Map<const Eigen::Vector3d>(points[v].data());
      is_not_own_free.push_back(is_prescribed[v] || owner[v] != m_communicator.rank());
    }
    std::vector<std::array<int, 4> > cells;
    std::vector<bool> is_copy; // the owner of the first vertex of a cell owns the cell
    for(const std::array<std::size_t, 4>& c : soup.cells)
    {
      cells.push_back({ positions[c[0]], positions[c[1]], positions[c[2]], positions[c[3]] });
      is_copy.push_back(owner[*std::min_element(c.begin(), c.end())] != m_communicator.rank());
    }
    std::vector<std::size_t> last_order;
    std::tie(m_mesh, last_order) = ordered_mesh_3(cells, source, is_not_own_free, is_parallel);
    m_mesh.communicator = &m_communicator;
    const int number_of_free_vertices = static_cast<int>(end_of_free - order.begin());
    m_mesh.number_of_copied_vertices = number_of_free_vertices - m_mesh.number_of_free_vertices;
    m_mesh.number_of_free_vertices = number_of_free_vertices;
    move_copies_to_end(is_copy, numbers);
    if(static_cast<double>(inverted_cells(m_mesh, m_mesh.source).number) == m_mesh.global_number_of_cells())
      for(std::array<int, 4>& cell : m_mesh.cells) // the cells of many files are all negative
        std::swap(cell[0], cell[1]);

    std::vector<int> result(order.size());
    Matrix3Xd images(3, m_mesh.number_of_vertices());
    for(int i = 0; i < m_mesh.number_of_vertices(); ++i)
    {
      const std::size_t v = order[last_order[i]];
      result[v] = i;
      if(!m_mesh.is_free(i))
        images.col(i) = Eigen::Map<const Eigen::Vector3d>(targets[v].data());
    }
    set_targets(m_mesh, std::move(images));
    return result;
  }

  // Moves own cells to the front. Numbers for messages are those of the whole mesh.
  void move_copies_to_end(const std::vector<bool>& is_copy, const std::vector<std::size_t>& numbers)
  {
    std::vector<std::array<int, 4> > cells;
    std::vector<std::size_t> user_numbers;
    for(const bool copies : { false, true })
      for(std::size_t c = 0; c < m_mesh.cells.size(); ++c)
        if(is_copy[m_mesh.user_numbers[c]] == copies)
        {
          cells.push_back(m_mesh.cells[c]);
          user_numbers.push_back(numbers[m_mesh.user_numbers[c]]);
          m_mesh.number_of_copied_cells += copies;
        }
    m_mesh.cells.swap(cells);
    m_mesh.user_numbers.swap(user_numbers);
  }

  // Sets the rows: each owner sends those of its vertices to all.
  void set_rows(const Star_forest& all, const std::vector<int>& mesh_numbers)
  {
    const std::size_t first = m_communicator.begins(number_of_own_rows())[m_communicator.rank()];
    std::vector<PetscInt> of_own, of_slice(m_size_of_slice, -1);
    for(const int i : m_own_numbers)
      of_own.push_back(static_cast<PetscInt>(first) + i); // or anything, if the vertex is not free
    m_own->put(of_own, of_slice);
    const std::vector<PetscInt> rows = all.get(of_slice);
    m_rows.resize(m_mesh.number_of_free_vertices);
    for(std::size_t v = 0; v < mesh_numbers.size(); ++v)
      if(m_mesh.is_free(mesh_numbers[v]))
        m_rows[mesh_numbers[v]] = rows[v];
  }

  const MPI_communicator_3& m_communicator;
  std::size_t m_size_of_slice;
  std::unique_ptr<Star_forest> m_own; // slices and the vertices that this process owns, in the order of their indices
  std::vector<int> m_own_numbers;     // numbers of own vertices in the numbered mesh
  Numbered_mesh_3 m_mesh;
  std::vector<PetscInt> m_rows;
  std::size_t m_number_of_vertices, m_number_of_boundary_vertices;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_DISTRIBUTED_MESH_3_H
