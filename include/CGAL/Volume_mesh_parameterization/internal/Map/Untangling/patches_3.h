// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_PATCHES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_PATCHES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <iterator>
#include <map>
#include <set>
#include <unordered_set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Some free vertices of a mesh, which may move, and all cells around them.
struct Patch_3
{
  std::set<int> moving;
  std::vector<std::size_t> cells;
};

// So many inverted cells of a mesh are exceptions, which patches can mend.
inline std::size_t most_exceptions(const double number_of_cells)
{ return static_cast<std::size_t>((std::max)(100., number_of_cells / 100)); }

// The free vertices of those cells for which `is_chosen` is true, which may be with another process.
template <typename Condition>
std::vector<bool> free_vertices_of(const Numbered_mesh_3& mesh, const Condition& is_chosen)
{
  std::vector<bool> result(mesh.number_of_vertices());
  for(const std::array<int, 4>& cell : mesh.cells)
    if(is_chosen(cell))
      for(const int v : cell)
        if(mesh.is_free(v))
          result[v] = true;
  if(mesh.is_whole())
    return result;
  std::vector<double> numbers;
  for(int v = 0; v < mesh.number_of_free_vertices; ++v)
    if(result[v])
      numbers.push_back(mesh.vertex_numbers[v]);
  numbers = mesh.communicator->concatenated(numbers);
  const std::unordered_set<double> all(numbers.begin(), numbers.end());
  for(int v = 0; v < mesh.number_of_free_vertices; ++v)
    result[v] = all.count(mesh.vertex_numbers[v]) > 0;
  return result;
}

// Those of rings of cells around them, too.
template <typename Condition>
std::vector<bool> free_vertices_around(const Numbered_mesh_3& mesh, const Matrix3Xd& positions,
                                       const Condition& is_chosen, const int number_of_rings)
{
  std::vector<bool> result = free_vertices_of(mesh, [&](const auto& cell) { return is_chosen(positions, cell); });
  for(int ring = 1; ring < number_of_rings; ++ring)
    result = free_vertices_of(mesh, [&](const auto& cell)
    { return std::any_of(cell.begin(), cell.end(), [&](const int v) { return bool(result[v]); }); });
  return result;
}

// The cells for which `is_chosen` is true with rings of cells around them, whose free vertices move: one patch for each
// connected part.
template <typename Condition>
std::vector<Patch_3> patches_3(const Numbered_mesh_3& mesh, const Matrix3Xd& positions, const Condition& is_chosen,
                               const int number_of_rings)
{
  const std::vector<bool> is_moving = free_vertices_around(mesh, positions, is_chosen, number_of_rings);
  const auto moves = [&](const int v) { return bool(is_moving[v]); };

  Disjoint_sets components(mesh.number_of_free_vertices);
  std::vector<std::pair<std::size_t, int> > cells; // with one of their moving vertices
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    const std::array<int, 4>& cell = mesh.cells[c];
    const auto first = std::find_if(cell.begin(), cell.end(), moves);
    if(first == cell.end())
      continue;
    cells.emplace_back(c, *first);
    for(auto v = first + 1; v != cell.end(); ++v)
      if(moves(*v))
        components.unite(*first, *v);
  }
  std::map<std::size_t, Patch_3> patches;
  for(const auto& [c, v] : cells)
  {
    Patch_3& patch = patches[components.find(v)];
    patch.cells.push_back(c);
    std::copy_if(mesh.cells[c].begin(), mesh.cells[c].end(), std::inserter(patch.moving, patch.moving.end()), moves);
  }
  std::vector<Patch_3> result;
  for(auto& [component, patch] : patches)
    result.push_back(std::move(patch));
  return result;
}

// A patch as a mesh of its own, in which the vertices that do not move are prescribed where they are.
struct Patch_mesh_3
{
  Numbered_mesh_3 mesh;
  std::vector<int> vertices; // their numbers in the mesh of the patch
  Matrix3Xd positions;

  Patch_mesh_3(const Numbered_mesh_3& whole, const Matrix3Xd& image, const Patch_3& patch)
    : vertices(patch.moving.begin(), patch.moving.end())
  {
    mesh.number_of_free_vertices = static_cast<int>(vertices.size());
    std::map<int, int> number;
    for(const int v : vertices)
      number.emplace(v, static_cast<int>(number.size()));
    for(const std::size_t c : patch.cells)
    {
      mesh.cells.push_back(whole.cells[c]);
      for(int& v : mesh.cells.back())
      {
        const auto inserted = number.emplace(v, static_cast<int>(number.size()));
        if(inserted.second)
          vertices.push_back(v);
        v = inserted.first->second;
      }
    }
    positions.resize(3, vertices.size());
    mesh.source.resize(3, vertices.size());
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      mesh.source.col(i) = whole.source.col(vertices[i]);
      positions.col(i) = image.col(vertices[i]);
    }
    mesh.target = positions;
    mesh.base_point = whole.base_point;
    mesh.target.leftCols(mesh.number_of_free_vertices).colwise() = mesh.base_point;
  }

  // Puts the images of the vertices that move back to the whole mesh.
  void write(Matrix3Xd& image) const
  {
    for(int i = 0; i < mesh.number_of_free_vertices; ++i)
      image.col(vertices[i]) = positions.col(i);
  }
};

// The rows of all processes, sorted, each once.
template <std::size_t n>
std::set<std::array<double, n> > rows_of_all(const Communicator_3& communicator,
                                             const std::vector<std::array<double, n> >& rows)
{
  std::vector<double> numbers;
  for(const std::array<double, n>& row : rows)
    numbers.insert(numbers.end(), row.begin(), row.end());
  numbers = communicator.concatenated(numbers);
  std::set<std::array<double, n> > result;
  for(std::size_t i = 0; i < numbers.size(); i += n)
  {
    std::array<double, n> row;
    std::copy_n(numbers.begin() + i, n, row.begin());
    result.insert(row);
  }
  return result;
}

// What patches of a mesh see of it. With one process, that is the whole mesh. Otherwise it is the cells around chosen
// ones, gathered from all processes as a mesh of a single one; all have the same, in the order of its numbers.
class Neighborhood_3
{
public:
  // The free vertices of chosen cells, and of rings around them, are free. Where a process might have no memory for so
  // many cells, none is gathered, and nothing patched.
  template <typename Condition>
  Neighborhood_3(const Numbered_mesh_3& whole, const Matrix3Xd& image, const Condition& is_chosen,
                 const int number_of_rings)
    : m_whole(whole), m_image(image), m_communicator(*whole.communicator)
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
    for(const auto& [v, place] : m_places)
      result.col(v) = positions.col(place);
    return result;
  }

  // What the first process finds, with its rounding: that of others may differ, if their processors do.
  template <typename Find>
  Matrix3Xd found_by_first(const Find& find) const
  {
    const Matrix3Xd found = m_communicator.rank() == 0 ? find() : Matrix3Xd(3, 0);
    const std::vector<double> x = m_communicator.concatenated({ found.data(), found.data() + found.size() });
    return Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, x.size() / 3);
  }

private:
  void gather(const std::vector<bool>& is_free)
  {
    constexpr double most_cells = 1e6; // some 200 bytes each
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
    if(m_communicator.sum(static_cast<double>(own_cells.size())) > most_cells)
      return;
    for(int v = 0; v < m_whole.number_of_vertices(); ++v)
      if(is_seen[v])
      {
        const Eigen::Vector3d p = m_whole.source.col(v), q = m_image.col(v);
        own_vertices.push_back({ is_free[v] ? 0. : 1., m_whole.vertex_numbers[v], p[0], p[1], p[2], q[0], q[1], q[2] });
      }

    const std::set<std::array<double, 8> > vertices = rows_of_all(m_communicator, own_vertices);
    std::map<double, int> places;
    m_mesh.base_point = m_whole.base_point;
    m_mesh.source.resize(3, vertices.size());
    m_positions.resize(3, vertices.size());
    for(const auto& [is_fixed, number, x, y, z, u, v, w] : vertices)
    {
      const int place = static_cast<int>(places.size());
      places.emplace(number, place);
      m_mesh.source.col(place) << x, y, z;
      m_positions.col(place) << u, v, w;
      m_mesh.number_of_free_vertices += is_fixed == 0;
    }
    for(const auto& [number, a, b, c, d] : rows_of_all(m_communicator, own_cells))
      m_mesh.cells.push_back({ places[a], places[b], places[c], places[d] });
    for(int v = 0; v < m_whole.number_of_free_vertices; ++v)
      if(is_free[v])
        m_places.emplace_back(v, places[m_whole.vertex_numbers[v]]);
  }

  const Numbered_mesh_3& m_whole;
  Matrix3Xd m_image;
  const Communicator_3& m_communicator;
  Numbered_mesh_3 m_mesh;
  Matrix3Xd m_positions;
  std::vector<std::pair<int, int> > m_places; // of the free vertices that this process knows, in both meshes
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_PATCHES_3_H
