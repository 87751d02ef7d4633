// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_NUMBERED_MESH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_NUMBERED_MESH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/projector_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Dynamic_matrix.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <optional>

namespace CGAL::Volume_mesh_parameterization::internal {

// A rotation and a scale about a center, which is moved to another one.
struct Similarity_3
{
  double scale = 1;
  Matrix_3 rotation = Matrix_3::Identity();
  Vector_3 source_center = Vector_3::Zero(), image_center = Vector_3::Zero();

  Vector_3 operator()(const Vector_3& p) const { return (scale * rotation) * (p - source_center) + image_center; }
};

inline Matrix3Xd moved(const Similarity_3& similarity, const Matrix3Xd& points)
{
  Matrix3Xd result(3, points.cols());
  for(Eigen::Index v = 0; v < result.cols(); ++v)
    result.col(v) = similarity(points.col(v));
  return result;
}

// A tetrahedral mesh as plain arrays, and where its prescribed vertices go, in the units of the user. The free vertices
// come first: 0, ..., number_of_free_vertices - 1. Where several processes share a mesh, each has a part: the cells around
// its own vertices. Its last cells and its last free vertices are copies of those that other processes own.
struct Numbered_mesh_3
{
  Matrix3Xd source;               // one column a vertex
  Matrix3Xd target;               // the image; prescribed for the vertices that are not free
  Matrix3Xd initial;              // images to start from, NaN where there is none; no column if there are none
  Conditions_3 conditions;        // of prescribed vertices, until some slide; none if all are at their targets
  Conditions_3 sliding_conditions; // of prescribed vertices from then on; none if none slides
  std::optional<Similarity_3> alignment;   // moves the source to what is prescribed; none if the whole boundary is
  bool is_boundary_fixed = true;           // are all vertices of the boundary at their targets until some slide?
  std::optional<double> reference_scale;   // of the source, with the least energy of its cells; none gives it the target's volume
  std::vector<std::array<int, 2> > marked_edges; // features of the body, if it brings any
  std::vector<Linear_constraint_3<int> > constraints; // of the images, besides the targets
  std::vector<std::array<int, 4> > cells; // positively oriented in the source
  int number_of_free_vertices = 0;
  Vector_3 base_point = Vector_3::Zero(); // the target of free vertices, near those of the others
  std::optional<Matrix_3> regular_cell; // edges of the cell that stands for each in the source, which may be tangled then
  bool has_volume_weights = false;       // do cells count by their volume in the source, or all alike?
  std::vector<std::size_t> user_numbers; // of the cells, for messages; the same as here if there are none
  const Communicator_3* communicator = &single_process();
  bool is_parallel = false;              // may threads share the work on it?
  std::size_t number_of_copied_cells = 0;
  int number_of_copied_vertices = 0;     // free ones
  std::vector<double> vertex_numbers;    // in the mesh of all processes; none if this process is alone

  Numbered_mesh_3() = default;

  // Takes vertices whose free ones come first.
  Numbered_mesh_3(Matrix3Xd points, std::vector<std::array<int, 4> > cells_of_points, const int number_of_free_points)
    : source(std::move(points)), cells(std::move(cells_of_points)), number_of_free_vertices(number_of_free_points)
  {}

  // Sets the images of prescribed vertices; free ones get the base point.
  void set_targets(Matrix3Xd images, const Vector_3& point)
  {
    target = std::move(images);
    base_point = point;
    for(int v = 0; v < number_of_free_vertices; ++v)
      target.col(v) = base_point;
  }

  int number_of_vertices() const { return static_cast<int>(source.cols()); }
  int number_of_prescribed_vertices() const { return number_of_vertices() - number_of_free_vertices; }
  std::size_t number_of_own_cells() const { return cells.size() - number_of_copied_cells; }
  bool is_whole() const { return communicator->is_alone(); } // what needs all cells asks for it
  double global_number_of_cells() const { return communicator->sum(static_cast<double>(number_of_own_cells())); }
  bool is_free(const int v) const { return v < number_of_free_vertices; }

  // The condition of a vertex before some slide.
  Vertex_condition_3 condition(const int v) const
  {
    return is_free(v) ? Vertex_condition_3::free()
         : conditions.empty() ? Vertex_condition_3::at_target() : conditions[v - number_of_free_vertices];
  }
  bool is_fixed(const int v) const { return condition(v).dimension() == 0; }
  Matrix_3 projector(const int v) const { return projector_3(condition(v)); }
  std::size_t user_number(const std::size_t cell) const { return user_numbers.empty() ? cell : user_numbers[cell]; }
};

// Marks the free vertices that a process marks.
inline std::vector<bool> marked_by_any(const Numbered_mesh_3& mesh, std::vector<bool> is_marked)
{
  if(mesh.is_whole())
    return is_marked;
  std::vector<std::array<double, 1> > numbers;
  for(int v = 0; v < mesh.number_of_free_vertices; ++v)
    if(is_marked[v])
      numbers.push_back({ mesh.vertex_numbers[v] });
  const std::set<std::array<double, 1> > all = mesh.communicator->gather(numbers);
  for(int v = 0; v < mesh.number_of_free_vertices; ++v)
    is_marked[v] = all.count({ mesh.vertex_numbers[v] }) > 0;
  return is_marked;
}

// The bounding box of points of all processes.
inline Box_3 bounding_box(const Communicator_3& communicator, const Matrix3Xd& points, const int first = 0)
{
  Box_3 box;
  for(int v = first; v < points.cols(); ++v)
    box.extend(points.col(v));
  for(int i = 0; i < 3; ++i)
  {
    box.smallest[i] = communicator.minimum(box.smallest[i]);
    box.largest[i] = communicator.maximum(box.largest[i]);
  }
  return box;
}

// The box of all targets, and of the source near them where they leave a part of the boundary free.
inline Box_3 target_box(const Numbered_mesh_3& mesh)
{
  Box_3 box = bounding_box(*mesh.communicator, mesh.target, mesh.number_of_free_vertices);
  if(mesh.alignment)
  {
    const Box_3 other = bounding_box(*mesh.communicator, moved(*mesh.alignment, mesh.source));
    box.extend(other.smallest);
    box.extend(other.largest);
  }
  return box;
}

inline double target_diagonal(const Numbered_mesh_3& mesh) { return target_box(mesh).diagonal().norm(); }

// Sets the targets, with the free vertices at the point of the bounding box of the others that is nearest to the origin. The
// volume of the target depends on its boundary only, but with free vertices far from it would be the difference of large
// numbers.
inline void set_targets(Numbered_mesh_3& mesh, Matrix3Xd targets)
{
  mesh.target = std::move(targets);
  const Box_3 box = target_box(mesh);
  mesh.set_targets(std::move(mesh.target), Vector_3::Zero().cwiseMax(box.smallest).cwiseMin(box.largest));
}

// The edge matrix of a cell: the columns are the edges from its first vertex to the other three.
template <typename Positions>
Matrix_3 edge_matrix(const Positions& positions, const std::array<int, 4>& cell)
{
  Matrix_3 edges;
  for(int i = 0; i < 3; ++i)
    edges.col(i) = positions.col(cell[i + 1]) - positions.col(cell[0]);
  return edges;
}

// Returns whether a cell is positively oriented, by exact predicates on the coordinates as they are.
inline bool is_positive(const Matrix3Xd& positions, const std::array<int, 4>& cell)
{
  const auto point = [&](const int i) { return exact_point(positions.col(cell[i])); };
  return is_positive_cell({ point(0), point(1), point(2), point(3) });
}

// f(cell) of the first n cells.
template <typename Function>
auto values_of_cells(const Numbered_mesh_3& mesh, const std::size_t n, const Function& f)
{
  return values_of_indices(mesh.is_parallel, n, [&](const std::size_t c) { return f(mesh.cells[c]); });
}

template <typename Positions>
double volume(const Numbered_mesh_3& mesh, const Positions& positions)
{
  const std::vector<double> volumes = values_of_cells(mesh, mesh.number_of_own_cells(), [&](const std::array<int, 4>& cell)
  { return edge_matrix(positions, cell).determinant() / 6; });
  return mesh.communicator->sum(std::accumulate(volumes.begin(), volumes.end(), 0.));
}

// The volume of the source at the scale of reference, or else that of the target, which depends on its boundary only.
inline double reference_volume(const Numbered_mesh_3& mesh)
{
  return mesh.reference_scale ? std::pow(*mesh.reference_scale, 3) * volume(mesh, mesh.source) : volume(mesh, mesh.target);
}

// Edges of a regular cell with the volume 1/3.
inline Matrix_3 regular_edges()
{
  return { { 0, 1, 1 }, { 1, 0, 1 }, { 1, 1, 0 } };
}

// Replaces the cells of the source by regular ones, whose volume is the mean of the reference volume.
inline void set_regular_cell(Numbered_mesh_3& mesh)
{ mesh.regular_cell = regular_edges() * std::cbrt(3 * reference_volume(mesh) / mesh.global_number_of_cells()); }

// Edges of a cell that its image is compared with, and the volume of all these cells.
inline Matrix_3 source_edges(const Numbered_mesh_3& mesh, const std::array<int, 4>& cell)
{ return mesh.regular_cell ? *mesh.regular_cell : edge_matrix(mesh.source, cell); }

inline double source_volume(const Numbered_mesh_3& mesh)
{
  return mesh.regular_cell ? mesh.regular_cell->determinant() / 6 * mesh.global_number_of_cells()
                           : volume(mesh, mesh.source);
}

// How much each cell counts; the sum is 1.
inline std::vector<double> cell_weights(const Numbered_mesh_3& mesh)
{
  std::vector<double> result(mesh.cells.size(), 1. / mesh.global_number_of_cells());
  if(mesh.has_volume_weights)
  {
    const double total = source_volume(mesh);
    for(std::size_t c = 0; c < mesh.cells.size(); ++c)
      result[c] = source_edges(mesh, mesh.cells[c]).determinant() / 6 / total;
  }
  return result;
}

// Cells with some property: their number in all processes, those of this process, and the first one in the order of the user, if
// this process has it.
struct Found_cells
{
  std::size_t number = 0;
  std::vector<std::size_t> cells;
  std::optional<std::size_t> first;
};

template <typename Condition>
Found_cells find_cells(const Numbered_mesh_3& mesh, const Condition& condition)
{
  const std::vector<char> is_found = values_of_cells(mesh, mesh.number_of_own_cells(),
    [&](const std::array<int, 4>& cell) { return static_cast<char>(condition(cell)); });
  Found_cells result;
  double first = std::numeric_limits<double>::infinity();
  for(std::size_t c = 0; c < is_found.size(); ++c)
    if(is_found[c])
    {
      result.cells.push_back(c);
      if(const double number = static_cast<double>(mesh.user_number(c)); number < first)
      {
        first = number;
        result.first = c;
      }
    }
  if(mesh.communicator->minimum(first) != first)
    result.first.reset();
  result.number = static_cast<std::size_t>(mesh.communicator->sum(static_cast<double>(result.cells.size())));
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_NUMBERED_MESH_3_H
