// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_NEIGHBORHOOD_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_NEIGHBORHOOD_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/patches_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The part of a mesh that its patches see. With one process, that is the whole mesh. Otherwise it is the cells around chosen
// ones, gathered from all processes as a mesh of a single one; all have the same, in the order of its numbers.
class Neighborhood_3
{
public:
  // The free vertices of chosen cells, and of rings around them, are free. Where a process might have no memory for so
  // many cells, none is gathered, and nothing patched.
  Neighborhood_3(const Numbered_mesh_3& whole, const Matrix3Xd& image, const Cell_condition_3& is_chosen,
                 const int number_of_rings)
    : m_whole(whole), m_image(image)
  {
    if(!m_whole.is_whole())
      gather(free_vertices_around(whole, image, is_chosen, number_of_rings));
  }

  const Numbered_mesh_3& mesh() const { return m_whole.is_whole() ? m_whole : m_mesh; }
  const Matrix3Xd& positions() const { return m_whole.is_whole() ? m_image : m_positions; }

  // The image of the whole mesh with these positions of the free vertices.
  Matrix3Xd in_whole(const Matrix3Xd& positions) const
  {
    if(m_whole.is_whole())
      return positions;
    Matrix3Xd result = m_image;
    for(const auto& [v, index] : m_indices)
      result.col(v) = positions.col(index);
    return result;
  }

  // Returns the positions that `find()` returns in the first process, for all processes with the patch.
  template <typename Find>
  Matrix3Xd agreed_positions(const Find& find) const
  {
    const std::vector<double> x = m_whole.communicator->of_first_process([&]
    {
      const Matrix3Xd positions = find();
      return std::vector<double>(positions.data(), positions.data() + positions.size());
    });
    return Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, x.size() / 3);
  }

private:
  void gather(const std::vector<bool>& is_free)
  {
    constexpr double maximum_number_of_cells = 1e6; // some 200 bytes each
    std::vector<std::array<double, 5> > own_cells;    // numbers of the cell and its vertices
    std::vector<std::array<double, 8> > own_vertices; // is it fixed, its number, source, image
    std::vector<bool> is_seen(is_free);
    for(std::size_t c = 0; c < m_whole.number_of_own_cells(); ++c)
    {
      const std::array<int, 4>& cell = m_whole.cells[c];
      if(std::none_of(cell.begin(), cell.end(), [&](const int v) { return is_free[v]; }))
        continue;
      own_cells.push_back({ static_cast<double>(m_whole.user_number(c)) });
      for(int i = 0; i < 4; ++i)
      {
        own_cells.back()[i + 1] = m_whole.vertex_numbers[cell[i]];
        is_seen[cell[i]] = true;
      }
    }
    if(m_whole.communicator->sum(static_cast<double>(own_cells.size())) > maximum_number_of_cells)
      return;
    for(int v = 0; v < m_whole.number_of_vertices(); ++v)
      if(is_seen[v])
      {
        const Vector_3 p = m_whole.source.col(v), q = m_image.col(v);
        own_vertices.push_back({ is_free[v] ? 0. : 1., m_whole.vertex_numbers[v], p[0], p[1], p[2], q[0], q[1], q[2] });
      }

    const std::set<std::array<double, 8> > vertices = m_whole.communicator->gather(own_vertices);
    std::map<double, int> indices;
    m_mesh.base_point = m_whole.base_point;
    m_mesh.source.resize(3, vertices.size());
    m_positions.resize(3, vertices.size());
    for(const auto& [is_fixed, number, x, y, z, u, v, w] : vertices)
    {
      const int index = static_cast<int>(indices.size());
      indices.emplace(number, index);
      m_mesh.source.col(index) = Vector_3(x, y, z);
      m_positions.col(index) = Vector_3(u, v, w);
      m_mesh.number_of_free_vertices += is_fixed == 0;
    }
    for(const auto& [number, a, b, c, d] : m_whole.communicator->gather(own_cells))
      m_mesh.cells.push_back({ indices[a], indices[b], indices[c], indices[d] });
    for(int v = 0; v < m_whole.number_of_free_vertices; ++v)
      if(is_free[v])
        m_indices.emplace_back(v, indices[m_whole.vertex_numbers[v]]);
  }

  const Numbered_mesh_3& m_whole;
  Matrix3Xd m_image;
  Numbered_mesh_3 m_mesh;
  Matrix3Xd m_positions;
  std::vector<std::pair<int, int> > m_indices; // of the free vertices that this process knows, in both meshes
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_NEIGHBORHOOD_3_H
