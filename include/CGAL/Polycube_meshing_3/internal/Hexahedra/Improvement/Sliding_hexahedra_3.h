// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_SLIDING_HEXAHEDRA_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_SLIDING_HEXAHEDRA_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/smooth_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Adds a goal that pulls a point of a triangle to a target on the surface if both are farther apart than the tolerance, in mean
// edges. The pull is along the way between both only, so that the triangle may slide across the way (as in the registration of
// surfaces by Chen and Medioni, Object modelling by registration of multiple range images, 1992).
inline void pull_point_3(const Vector_3& point, const Triangle_3& triangle, const Vector_3& target,
                         const std::vector<Vector_3>& positions, const double tolerance, const double weight,
                         Corner_goals_3& goals)
{
  constexpr double longest_pull = 1;             // a guess; relative to the mean edge
  const double factor = std::sqrt(200 * weight); // a guess; scales the residual
  const double distance = (target - point).norm();
  if(distance < tolerance * goals.mean_edge)
    return;
  const int a = static_cast<int>(triangle[0]), b = static_cast<int>(triangle[1]), c = static_cast<int>(triangle[2]);
  const Vector_3 u = positions[b] - positions[a], v = positions[c] - positions[a], w = point - positions[a];
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
  if(!(determinant > 0))
    return;
  const double inverse = 1 / determinant;
  const double s = vv * inverse * u.dot(w) - uv * inverse * v.dot(w);
  const double t = uu * inverse * v.dot(w) - uv * inverse * u.dot(w);
  const Vector_3 way = factor * (target - point) / distance;
  goals.constraints.push_back({ { { a, (1 - (s + t)) * way }, { b, s * way }, { c, t * way } },
                                way.dot(point) + factor * (std::min)(distance, longest_pull * goals.mean_edge) });
}

// Pulls triangles to the vertices of the surface, more with a larger weight.
inline void pull_to_vertices_3(const Covered_surface_3& covered, const std::vector<Vector_3>& positions, const double weight,
                               Corner_goals_3& goals)
{
  for_each_nearest(covered.surface->vertices(), covered.triangles, positions,
                   [&](const Vector_3& p, const Vector_3& q, const Triangle_3& triangle)
                   { pull_point_3(q, triangle, p, positions, covered.tolerance, weight, goals); });
}

// Pulls the middles of quadrangles and of their edges to the surface.
inline void pull_middles_3(const Covered_surface_3& covered, const std::vector<Vector_3>& positions, const double weight,
                           Corner_goals_3& goals)
{
  for_each_middle(covered, positions,
                  [&](const Edge_of_triangle_3&, const Middle_3& middle, const Triangle_3& triangle)
                  { pull_point_3(middle.point, triangle, middle.nearest, positions, covered.tolerance, weight, goals); });
}

// Corners that vertices move for: all alike, the poor ones first, or the worst ones, whose edges may have any lengths.
enum class Corners_to_improve { ALL, POOR, WORST_ANGLES };

// Returns the exponent of the energy, by which the worst corners count more.
inline int exponent_for(const Corners_to_improve which)
{ return which == Corners_to_improve::ALL ? 1 : which == Corners_to_improve::POOR ? 2 : 4; } // guesses

// Hexahedra of a body whose vertices move inside, on its boundary and along its lines, and likewise on its interfaces.
class Sliding_hexahedra_3
{
public:
  Sliding_hexahedra_3(const Placed_hexahedra_3& hexahedra, Linear_solver_3& solver, const bool is_parallel, const Budget& budget)
    : m_mesh(hexahedra.mesh), m_first_points(m_mesh.points), m_positions(hexahedra.positions),
      m_corners(m_mesh, are_fixed(), is_parallel), m_covered(hexahedra.covered), m_solver(solver), m_budget(budget)
  {}

  const Hexahedra_3& mesh() const { return m_mesh; }

  // Returns the largest distance between the boundaries of the body and of the hexahedra.
  double boundary_distance() const { return distance_of_cover_3(m_covered.front(), m_mesh.points).distance; }

  // Makes steps of Newton's method for all vertices at once, or, unless `do_slide`, for those inside. Vertices on the boundary
  // move in its tangent planes or along lines, and are put back onto it. They are pulled to cover the boundary, the more the
  // larger the weight. Middles of edges are pulled only if all corners are positive, as that hinders untangling. Vertices that
  // slide are held where they were at first, which helps to untangle corners. If all corners are positive, those off lines are
  // held where they are: steps along a curved surface would be too long otherwise. Corners and hexahedra that are all positive
  // remain so.
  void improve(const std::size_t number_of_steps, const bool do_slide, const Corners_to_improve which, const double weight = 1)
  {
    const bool are_for_angles = which == Corners_to_improve::WORST_ANGLES;
    Corner_goals_3 goals = { {}, {}, 1, {}, pull, exponent_for(which), number_of_steps };
    for(std::size_t v = 0; v < m_positions.size(); ++v)
    {
      const bool stays = !do_slide && m_positions[v].freedom != Freedom_3::SPACE;
      goals.conditions.push_back(stays ? Vertex_condition_3::at_target() : m_positions[v].condition());
    }
    m_corners.set_edges(m_mesh.points, are_for_angles ? Goals_of_edges::OWN_LENGTHS : Goals_of_edges::MEAN_LENGTHS, goals);
    const bool is_valid = are_positive(m_mesh.points);
    if(do_slide)
    {
      hold_boundary(is_valid ? m_mesh.points : m_first_points, are_for_angles ? firm_hold_of_lines : 1, goals);
      for(const Covered_surface_3& covered : m_covered)
      {
        pull_to_vertices_3(covered, m_mesh.points, weight, goals);
        if(is_valid)
          pull_middles_3(covered, m_mesh.points, weight, goals);
      }
    }
    put_back(m_corners.improved(m_mesh.points, goals, m_solver, m_budget), is_valid, goals.mean_edge);
  }

  // Lets vertices leave the surface, where corners are untangled easily, and draws the vertices back by a weight that grows,
  // while corners stay positive (the penalty method; Nocedal and Wright, Numerical Optimization, section 17.1). If the number of
  // inverted corners does not fall from one weight to the next, a larger one leaves even less room. Returns whether no corner was
  // inverted in the end, before the vertices were put back.
  bool leave_and_return()
  {
    constexpr double first_weight = 100, last_weight = 1e10, growth = 3; // guesses
    constexpr std::size_t number_of_steps = 20;                          // a guess
    std::ptrdiff_t inverted = (std::numeric_limits<std::ptrdiff_t>::max)();
    for(double weight = first_weight;
        weight <= last_weight && m_budget.may_begin_round(Phase::HEXAHEDRA, "return to the surface"); weight *= growth)
    {
      Corner_goals_3 goals = { Conditions_3(m_positions.size()), {}, 1, {}, pull, 1, number_of_steps };
      m_corners.set_edges(m_mesh.points, Goals_of_edges::MEAN_LENGTHS, goals);
      hold_boundary(m_first_points, 1, goals);
      for(const Covered_surface_3& covered : m_covered)
        pull_to_vertices_3(covered, m_mesh.points, 1, goals);
      pull_to_surface(std::sqrt(weight / pull), goals);
      m_mesh.points = m_corners.improved(m_mesh.points, goals, m_solver, m_budget);
      const std::ptrdiff_t before = std::exchange(inverted, number_of_inverted_corners(m_mesh.points));
      if(inverted > 0 && inverted >= before)
        break;
    }
    for(std::size_t v = 0; v < m_positions.size(); ++v)
      m_mesh.points[v] = nearest(v);
    return inverted == 0;
  }

  // Moves the vertices of corners whose scaled Jacobian is below the target, and those near far points of the surfaces, one after
  // the other. The price of uncovered points is that of smooth_hexahedra_3().
  void smooth(const double target, const double price_of_uncovered)
  { smooth_hexahedra_3(m_corners, m_positions, m_covered, target, price_of_uncovered, m_budget, m_mesh); }

  // Lets vertices of corners that are inverted, or whose scaled Jacobian is below a bound, and those of hexahedra that are
  // inverted inside alone, leave the lines, on which they perhaps cannot become better. Inverted ones leave interfaces then.
  // Returns whether any vertex left a line or an interface.
  bool leave_lines_and_interfaces(const double bound)
  {
    bool has_left = false;
    const auto leave = [&](const std::size_t v, const bool may_leave_interface)
    {
      Position_3& position = m_positions[v];
      const bool is_on_line = position.freedom == Freedom_3::LINE || position.freedom == Freedom_3::NONE;
      const bool is_on_interface = position.freedom == Freedom_3::SURFACE && !position.is_on_boundary;
      if(!is_on_line && !(is_on_interface && may_leave_interface))
        return;
      position.freedom = is_on_line ? Freedom_3::SURFACE : Freedom_3::SPACE;
      if(position.is_on_boundary) // also where it leaves an interface there
        position.surface = &boundary();
      has_left = true;
    };
    for(const std::array<std::size_t, 4>& corner : m_corners.corners())
      if(const bool is_inverted = !is_positive_corner(m_mesh.points, corner);
         is_inverted || scaled_jacobian(edge_matrix(m_mesh.points, corner)) < bound)
        for(const std::size_t v : corner)
          leave(v, is_inverted);
    for(const std::array<std::size_t, 8>& hexahedron : m_mesh.cells)
      if(!is_positive_hexahedron(m_mesh.points, hexahedron) && has_positive_corners(hexahedron))
        for(const std::size_t v : hexahedron)
          leave(v, true);
    return has_left;
  }

private:
  static constexpr double pull = 5; // a guess; of a point of the surface, beside 1 for a corner: corners hardly become worse
  static constexpr double firm_hold_of_lines = 15; // a guess; relative to other steps, as the worst corners weigh more

  const Body_surface_3& boundary() const { return *m_covered.front().surface; }

  // Returns for each vertex whether it never moves.
  std::vector<bool> are_fixed() const
  {
    std::vector<bool> result;
    for(const Position_3& position : m_positions)
      result.push_back(position.freedom == Freedom_3::NONE);
    return result;
  }

  std::ptrdiff_t number_of_inverted_corners(const std::vector<Vector_3>& points) const
  {
    return std::count_if(m_corners.corners().begin(), m_corners.corners().end(),
                         [&](const std::array<std::size_t, 4>& corner) { return !is_positive_corner(points, corner); });
  }

  bool has_positive_corners(const std::array<std::size_t, 8>& hexahedron) const
  {
    bool are_all = true;
    for_each_corner(hexahedron, [&](const auto& corner) { are_all = are_all && is_positive_corner(m_mesh.points, corner); });
    return are_all;
  }

  // Returns whether all corners are positive.
  bool are_positive(const std::vector<Vector_3>& points) const { return number_of_inverted_corners(points) == 0; }

  // Pulls sliding vertices to the given points. Vertices on lines are pulled to where they were at first, and by the given factor
  // more: that keeps curved lines evenly divided.
  void hold_boundary(const std::vector<Vector_3>& points, const double factor_of_lines, Corner_goals_3& goals) const
  {
    for(const std::size_t v : m_corners.order())
      if(const bool is_on_line = m_positions[v].freedom == Freedom_3::LINE;
         is_on_line || m_positions[v].freedom == Freedom_3::SURFACE)
      {
        const double factor = is_on_line ? factor_of_lines : 1;
        const Vector_3 p = factor * (is_on_line ? m_first_points : points)[v];
        for(int axis = 0; axis < 3; ++axis)
          goals.constraints.push_back({ { { static_cast<int>(v), factor * Vector_3::Unit(axis) } }, p[axis] });
      }
  }

  // Returns the point nearest to a vertex among those where it may be; for a vertex that may not move, its first position.
  Vector_3 nearest(const std::size_t v) const
  { return m_positions[v].nearest(m_positions[v].freedom == Freedom_3::NONE ? m_first_points[v] : m_mesh.points[v]); }

  // Pulls vertices to the nearest points where they may be, mostly in the directions in which they may not move there.
  void pull_to_surface(const double factor, Corner_goals_3& goals) const
  {
    constexpr double part_along = 0.1; // a guess; how much less a vertex is held in the directions in which it may move
    for(const std::size_t v : m_corners.order())
    {
      const Position_3& position = m_positions[v];
      if(position.freedom == Freedom_3::SPACE)
        continue;
      const Vector_3 p = nearest(v);
      const Matrix_3 way
        = factor * (Matrix_3::Identity() - (1 - part_along) * position.surface->projector(p, position.freedom));
      for(int axis = 0; axis < 3; ++axis)
        goals.constraints.push_back({ { { static_cast<int>(v), way.col(axis) } }, way.col(axis).dot(p) });
    }
  }

  // Moves vertices to new points, put back onto the surface. If a hexahedron would be inverted, or a corner so flat that the next
  // steps would serve it alone, its vertices go a part of their way only, and in the end stay. `was_valid` says whether all
  // corners were positive before. If not, the next steps mend corners that the move or a few attempts leave inverted. Edges much
  // shorter than the mean one count as longer ones.
  void put_back(const std::vector<Vector_3>& moved, const bool was_valid, const double mean_edge)
  {
    constexpr int number_of_attempts = 5; // a guess
    constexpr double largest_loss = 0.9;  // a guess; part of a scaled Jacobian that a step may lose
    const std::vector<Corners_of_hexahedra_3::Corner>& corners = m_corners.corners();
    const std::vector<Vector_3> before = m_mesh.points;
    const bool may_shorten = was_valid || are_positive(moved);
    const auto quality = [&](const std::vector<Vector_3>& points, const std::size_t c)
    { return scaled_jacobian(edge_matrix(points, corners[c]), shortest_edge * mean_edge); };
    std::vector<double> least(corners.size(), 0), part(before.size(), 1);
    for(std::size_t c = 0; c < least.size() && was_valid; ++c)
      least[c] = (std::min)({ flat_scaled_jacobian, (1 - largest_loss) * quality(before, c), quality(before, c) });
    std::vector<bool> was_positive(m_mesh.cells.size(), false);
    for(std::size_t h = 0; h < was_positive.size() && was_valid; ++h)
      was_positive[h] = is_positive_hexahedron(before, m_mesh.cells[h]);
    for(int attempt = 1; ; ++attempt)
    {
      for(std::size_t v = 0; v < before.size(); ++v)
        m_mesh.points[v] = part[v] == 0 ? before[v] : m_positions[v].nearest(before[v] + part[v] * (moved[v] - before[v]));
      std::set<std::size_t> at_bad;
      for(std::size_t c = 0; c < least.size(); ++c)
        if(!is_positive_corner(m_mesh.points, corners[c]) || quality(m_mesh.points, c) < least[c])
          at_bad.insert(corners[c].begin(), corners[c].end());
      for(std::size_t h = 0; h < was_positive.size(); ++h)
        if(was_positive[h] && !is_positive_hexahedron(m_mesh.points, m_mesh.cells[h]))
          at_bad.insert(m_mesh.cells[h].begin(), m_mesh.cells[h].end());
      if(at_bad.empty() || !may_shorten || (attempt >= number_of_attempts && !was_valid))
        return;
      for(const std::size_t v : at_bad)
        part[v] *= attempt < number_of_attempts ? 0.5 : 0;
    }
  }

  Hexahedra_3 m_mesh;
  const std::vector<Vector_3> m_first_points;
  std::vector<Position_3> m_positions; // their points are not kept up to date
  Corners_of_hexahedra_3 m_corners;
  std::vector<Covered_surface_3> m_covered; // first the boundary, then the patches of interfaces
  Linear_solver_3& m_solver;
  const Budget& m_budget;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_SLIDING_HEXAHEDRA_3_H
