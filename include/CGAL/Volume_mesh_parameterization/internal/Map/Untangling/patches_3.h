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

#include <functional>
#include <iterator>
#include <map>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Some vertices of a mesh that may move, and all cells around them.
struct Patch_3
{
  std::set<int> moving;
  std::vector<std::size_t> cells;
};

// Returns how many inverted cells of a mesh are exceptions, which patches can mend: a guess.
inline std::size_t maximum_number_of_exceptions(const double number_of_cells)
{ return static_cast<std::size_t>((std::max)(100., number_of_cells / 100)); }

// The vertices that may move of those cells for which `is_chosen` is true.
template <typename Condition>
std::vector<bool> free_vertices_of(const Numbered_mesh_3& mesh, const Condition& is_chosen)
{
  std::vector<bool> result(mesh.number_of_vertices());
  for(const std::array<int, 4>& cell : mesh.cells)
    if(is_chosen(cell))
      for(const int v : cell)
        if(!mesh.is_fixed(v))
          result[v] = true;
  return marked_by_any(mesh, std::move(result));
}

// Whether a cell is chosen where its vertices are at some positions.
using Cell_condition_3 = std::function<bool(const Matrix3Xd& positions, const std::array<int, 4>& cell)>;

// The free vertices of chosen cells and of rings of cells around them.
inline std::vector<bool> free_vertices_around(const Numbered_mesh_3& mesh, const Matrix3Xd& positions,
                                              const Cell_condition_3& is_chosen, const int number_of_rings)
{
  std::vector<bool> result = free_vertices_of(mesh, [&](const auto& cell) { return is_chosen(positions, cell); });
  for(int ring = 1; ring < number_of_rings; ++ring)
    result = free_vertices_of(mesh, [&](const auto& cell)
    { return std::any_of(cell.begin(), cell.end(), [&](const int v) { return bool(result[v]); }); });
  return result;
}

// The cells for which `is_chosen` is true with rings of cells around them, whose free vertices move: one patch for each
// connected part.
inline std::vector<Patch_3> patches_3(const Numbered_mesh_3& mesh, const Matrix3Xd& positions, const Cell_condition_3& is_chosen,
                                      const int number_of_rings)
{
  const std::vector<bool> is_moving = free_vertices_around(mesh, positions, is_chosen, number_of_rings);
  const auto moves = [&](const int v) { return bool(is_moving[v]); };

  Disjoint_sets components(mesh.number_of_vertices());
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
  std::vector<int> vertices; // their numbers in the whole mesh; those that move come first
  int number_of_moving_vertices;
  Matrix3Xd positions;

  Patch_mesh_3(const Numbered_mesh_3& whole, const Matrix3Xd& image, const Patch_3& patch)
    : vertices(patch.moving.begin(), patch.moving.end())
  {
    number_of_moving_vertices = static_cast<int>(vertices.size());
    const auto first_prescribed = std::lower_bound(vertices.begin(), vertices.end(), whole.number_of_free_vertices);
    const int number_of_free_vertices = static_cast<int>(first_prescribed - vertices.begin());
    std::map<int, int> number;
    for(const int v : vertices)
      number.emplace(v, static_cast<int>(number.size()));
    std::vector<std::array<int, 4> > cells;
    for(const std::size_t c : patch.cells)
    {
      cells.push_back(whole.cells[c]);
      for(int& v : cells.back())
      {
        const auto inserted = number.emplace(v, static_cast<int>(number.size()));
        if(inserted.second)
          vertices.push_back(v);
        v = inserted.first->second;
      }
    }
    positions.resize(3, vertices.size());
    Matrix3Xd source(3, vertices.size());
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      source.col(i) = whole.source.col(vertices[i]);
      positions.col(i) = image.col(vertices[i]);
    }
    mesh = Numbered_mesh_3(std::move(source), std::move(cells), number_of_free_vertices);
    mesh.set_targets(positions, whole.base_point);
    mesh.regular_cell = whole.regular_cell;
    mesh.alignment = whole.alignment;
    mesh.reference_scale = whole.reference_scale;
    if(number_of_free_vertices < number_of_moving_vertices)
      for(int i = number_of_free_vertices; i < mesh.number_of_vertices(); ++i)
        mesh.conditions.push_back(i < number_of_moving_vertices ? whole.condition(vertices[i])
                                                                : Vertex_condition_3::at_target());
  }

  // Puts the images of the vertices that move back to the whole mesh.
  void write(Matrix3Xd& image) const
  {
    for(int i = 0; i < number_of_moving_vertices; ++i)
      image.col(vertices[i]) = positions.col(i);
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_PATCHES_3_H
