// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_ROUND_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_ROUND_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/diagnose_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Coordinate_type.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the distance of neighboring numbers of a narrow type at the largest coordinate of a point.
inline double spacing(const Coordinate_type& type, const Vector_3& p)
{ return std::ldexp(type.epsilon, std::ilogb((std::max)(p.cwiseAbs().maxCoeff(), (std::numeric_limits<double>::min)()))); }

// Moves free vertices of a small mesh by up to two spacings of a narrow type in each coordinate. Each move lowers the number of
// cells around the vertex that are not positive, or raises their smallest volume. Therefore, no state is repeated.
class Rounding_search_3
{
public:
  Rounding_search_3(const Numbered_mesh_3& mesh, const Coordinate_type& type, Matrix3Xd& positions)
    : m_mesh(mesh), m_type(type), m_positions(positions), m_cells_of_vertices(mesh.number_of_free_vertices)
  {
    for(const std::array<int, 4>& cell : mesh.cells)
      for(const int v : cell)
        if(mesh.is_free(v))
          m_cells_of_vertices[v].push_back(cell);
  }

  void run(const Budget& budget)
  {
    constexpr int maximum_number_of_rounds = 100; // a guess
    bool has_moved = true;
    for(int round = 0; round < maximum_number_of_rounds && has_moved && !budget.is_exhausted()
                       && inverted_cells(m_mesh, m_positions).number > 0; ++round)
    {
      has_moved = false;
      for(int v = 0; v < m_mesh.number_of_free_vertices; ++v)
        if(improve(v))
          has_moved = true;
    }
  }

private:
  // The number of cells around a vertex that are not positive, and minus their smallest volume.
  std::pair<std::size_t, double> defect(const int v) const
  {
    std::pair<std::size_t, double> result(0, -std::numeric_limits<double>::infinity());
    for(const std::array<int, 4>& cell : m_cells_of_vertices[v])
    {
      result.first += is_positive(m_positions, cell) ? 0 : 1;
      result.second = (std::max)(result.second, -edge_matrix(m_positions, cell).determinant());
    }
    return result;
  }

  // Moves a vertex to the best place nearby, and returns whether that is another one.
  bool improve(const int v)
  {
    const Vector_3 old = m_positions.col(v);
    const double step = spacing(m_type, old);
    Vector_3 best = old;
    std::pair<std::size_t, double> smallest = defect(v);
    for(int x = -2; x <= 2; ++x)
      for(int y = -2; y <= 2; ++y)
        for(int z = -2; z <= 2; ++z)
        {
          m_positions.col(v) = (old + step * Vector_3(x, y, z)).unaryExpr(m_type.rounded);
          if(const auto found = defect(v); found < smallest)
          {
            smallest = found;
            best = m_positions.col(v);
          }
        }
    m_positions.col(v) = best;
    return best != old;
  }

  const Numbered_mesh_3& m_mesh;
  const Coordinate_type& m_type;
  Matrix3Xd& m_positions;
  std::vector<std::vector<std::array<int, 4> > > m_cells_of_vertices;
};

// Returns the positions in numbers of a narrow type. Where rounding inverts few cells, free vertices near them move.
inline Matrix3Xd rounded_positions_3(const Numbered_mesh_3& mesh, const Coordinate_type& type, const Matrix3Xd& positions,
                                     const Budget& budget)
{
  Matrix3Xd result = positions.unaryExpr(type.rounded);
  const auto is_inverted = [](const Matrix3Xd& image, const std::array<int, 4>& cell) { return !is_positive(image, cell); };
  if(inverted_cells(mesh, result).number <= maximum_number_of_exceptions(mesh.global_number_of_cells()))
    for(const int number_of_rings : { 1, 2, 4 }) // guesses
      for(const Patch_3& patch : patches_3(mesh, result, is_inverted, number_of_rings))
      {
        Patch_mesh_3 part(mesh, result, patch);
        Rounding_search_3(part.mesh, type, part.positions).run(budget);
        part.write(result);
      }
  return result;
}

// Rounds a map to the type in which the user stores images, and checks it again: the written map is the checked one. Targets have
// been rounded before the search.
inline void round_map_3(const Numbered_mesh_3& mesh, const Coordinate_type& type, const Map_problem_3& problem,
                        Found_map_3& found)
{
  if(!type.is_narrow() || !found.map.is_valid())
    return;
  const double rounding = 4 * spacing(type, mesh.target.cwiseAbs().rowwise().maxCoeff()); // of sliding vertices and planes
  Map_3 map = evaluated_map(mesh, rounded_positions_3(mesh, type, found.map.positions, problem.progress.budget()),
                            found.conditions.empty() ? mesh.conditions : found.conditions, rounding);
  map.meets_boundary = map.meets_boundary && found.map.meets_boundary;
  found.map = std::move(map);
  if(!found.map.is_valid())
  {
    found.status = ERROR_INVERTED_BY_ROUNDING;
    const int v = mesh.cells[found.map.inverted_cells.front()][0];
    found.reason = describe_inverted_cells(found.map.inverted_cells, mesh, "After rounding, these cells are inverted or flat: ")
                   + " One of them has the vertex of the source at " + describe(mesh.source.col(v))
                   + sentence(". Numbers at its image have a spacing of ", spacing(type, found.map.positions.col(v)), ".");
  }
  else if(const double bound = problem.options.maximum_angle_distortion; found.status == OK && std::isfinite(bound))
    if(const double largest = largest_angle_distortion_3(mesh, found.map.positions); !(largest < bound))
    {
      found.status = ERROR_ANGLE_BOUND_NOT_REACHED;
      found.reason = sentence("Rounding the images to their type raises the largest distortion of angles to ", largest, ".");
    }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_ROUND_MAP_3_H
