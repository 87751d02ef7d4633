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

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/improve_corners_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/pull_to_vertices_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/smooth_hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Interface_positions_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

namespace CGAL::Polycube_meshing_3::internal {

// Corners that vertices move for: all alike, the poor ones first, or the worst ones, whose edges may have any lengths.
enum class Corners_to_improve { ALL, POOR, WORST_ANGLES };

inline int exponent_for(const Corners_to_improve which)
{ return which == Corners_to_improve::ALL ? 1 : which == Corners_to_improve::POOR ? 2 : 4; } // guesses

// Hexahedra of a body whose vertices move inside, on its boundary and along its lines; likewise on its interfaces, whose
// vertices have positions.
class Sliding_hexahedra_3
{
public:
  Sliding_hexahedra_3(const Hexahedra_3& mesh, const std::vector<Freedom_3>& freedom, const Body_surface_3& surface,
                      Linear_solver_3& solver, const bool is_parallel, const Budget& budget,
                      const Interface_positions_3& positions = {})
    : m_mesh(mesh), m_solver(solver), m_budget(budget)
  {
    const std::vector<bool> is_outer = is_on_boundary(mesh);
    std::vector<Freedom_3> freedom_of_vertices = freedom;
    std::vector<const Body_surface_3*> surface_of_vertices(mesh.points.size(), &surface);
    std::vector<bool> is_fixed;
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      if(v < positions.of_vertices.size() && positions.of_vertices[v].surface != nullptr)
      {
        freedom_of_vertices[v] = positions.of_vertices[v].freedom;
        surface_of_vertices[v] = positions.of_vertices[v].surface;
      }
      is_fixed.push_back(freedom_of_vertices[v] == Freedom_3::NONE);
    }
    std::vector<std::array<int, 4> > corners;
    for_each_corner(mesh, [&](const std::array<std::size_t, 4>& corner)
    {
      corners.emplace_back();
      std::copy(corner.begin(), corner.end(), corners.back().begin());
    });
    std::tie(m_numbered, m_order) = ordered_mesh_3(corners, columns_of(mesh.points), is_fixed, is_parallel);
    m_numbered.target = m_numbered.source;
    for(const std::size_t v : m_order)
    {
      m_freedom.push_back(freedom_of_vertices[v]);
      m_surfaces.push_back(surface_of_vertices[v]);
      m_is_on_boundary.push_back(is_outer[v]);
    }
    constexpr double tolerance_of_boundary = 0.2, tolerance_of_interface = 0.05; // guesses
    const std::vector<int> index = inverse_order(m_order);
    for(const std::array<std::size_t, 8>& cell : mesh.cells)
    {
      m_hexahedra.emplace_back();
      std::transform(cell.begin(), cell.end(), m_hexahedra.back().begin(), [&](const std::size_t v) { return index[v]; });
    }
    m_covered.push_back(covered_surface_3(surface, mesh.facets, index, tolerance_of_boundary));
    for(const auto& [interface, quadrangles] : positions.covered)
      m_covered.push_back(covered_surface_3(*interface, quadrangles, index, tolerance_of_interface));
  }

  const Hexahedra_3& mesh() const { return m_mesh; }

  // Returns the largest distance between the boundaries of the body and of the hexahedra.
  double boundary_distance() const { return distance_of_cover_3(m_covered.front(), m_numbered.target).distance; }

  // Makes steps of Newton's method for all vertices at once, or, unless `do_slide`, for those inside. Vertices on the boundary
  // move in its tangent planes, or along lines, are put back, and are pulled to cover the boundary; once all corners are
  // positive, also to approach it, which hinders untangling; more with a larger weight. Vertices that slide are pulled to where
  // they were at first, which helps to untangle corners, or later to where they are, without which steps along a curved surface
  // are too long. If all corners are positive, they remain so, and so do hexahedra that are positive all over.
  void improve(const std::size_t number_of_steps, const bool do_slide, const Corners_to_improve which, const double weight = 1)
  {
    const bool are_for_angles = which == Corners_to_improve::WORST_ANGLES;
    Corner_goals_3 goals = { {}, {}, 1, {}, pull, exponent_for(which), number_of_steps };
    for(std::size_t i = 0; i < m_order.size(); ++i)
    {
      const bool stays = !do_slide && m_freedom[i] != Freedom_3::SPACE;
      goals.projectors.push_back(m_surfaces[i]->projector(m_numbered.target.col(i), stays ? Freedom_3::NONE : m_freedom[i]));
    }
    set_edges(m_numbered, are_for_angles, goals);
    const bool is_valid = inverted_cells(m_numbered, m_numbered.target).number == 0;
    if(do_slide)
    {
      hold_boundary(is_valid ? m_numbered.target : m_numbered.source, are_for_angles ? firm_hold_of_lines : 1, goals);
      for(const Covered_surface_3& covered : m_covered)
      {
        pull_to_vertices_3(covered, m_numbered.target, weight, goals);
        if(is_valid)
          pull_middles_3(covered, m_numbered.target, weight, goals);
      }
    }
    put_back(improve_corners_3(m_numbered, goals, m_solver, m_budget), is_valid, goals.mean_edge);
    write_points();
  }

  // Lets vertices leave the surface, where corners are untangled easily, and draws the vertices back by a weight that grows,
  // while corners stay positive (the penalty method; Nocedal and Wright, Numerical Optimization, section 17.1).
  void leave_and_return()
  {
    constexpr double first_weight = 100, last_weight = 1e10, growth = 3; // guesses
    constexpr std::size_t number_of_steps = 20;                          // a guess
    for(double weight = first_weight;
        weight <= last_weight && m_budget.may_begin_round(Phase::HEXAHEDRA, "return to the surface"); weight *= growth)
    {
      Corner_goals_3 goals = { std::vector<Matrix_3>(m_order.size(), Matrix_3::Identity()), {}, 1, {}, pull, 1,
                               number_of_steps };
      set_edges(m_numbered, false, goals);
      hold_boundary(m_numbered.source, 1, goals);
      for(const Covered_surface_3& covered : m_covered)
        pull_to_vertices_3(covered, m_numbered.target, 1, goals);
      return_to_surface(std::sqrt(weight / pull), goals);
      m_numbered.target = improve_corners_3(m_numbered, goals, m_solver, m_budget);
      write_points();
    }
    for(std::size_t i = 0; i < m_order.size(); ++i)
      m_numbered.target.col(i) = nearest(i);
    write_points();
  }

  // Moves the vertices of corners whose scaled Jacobian is below the target, and those near far points of the surfaces, one after
  // the other. Uncovered points have a price.
  void smooth(const double target, const double price)
  {
    smooth_hexahedra_3(m_numbered.cells, m_hexahedra, m_freedom, m_surfaces, m_covered, target, price, m_budget,
                       m_numbered.target);
    write_points();
  }

  // Lets vertices of corners that are inverted, or whose scaled Jacobian is below a bound, leave the lines, on which corners
  // perhaps cannot become better. Returns whether any vertex was on a line.
  bool leave_lines(const double bound)
  {
    bool is_on_line = false;
    for(const std::array<int, 4>& corner : m_numbered.cells)
      if(!is_positive(m_numbered.target, corner) || scaled_jacobian(edge_matrix(m_numbered.target, corner)) < bound)
        for(const int v : corner)
          if(m_freedom[v] == Freedom_3::LINE || m_freedom[v] == Freedom_3::NONE)
          {
            m_freedom[v] = Freedom_3::SURFACE;
            if(m_is_on_boundary[v]) // also where it leaves an interface there
              m_surfaces[v] = m_covered[0].surface;
            is_on_line = true;
          }
    return is_on_line;
  }

  // Lets vertices of corners whose scaled Jacobian is below a bound leave the interfaces: first their lines, then the surfaces.
  // Vertices on the boundary stay there. Returns whether any vertex was on an interface.
  bool leave_interfaces(const double bound)
  {
    std::vector<bool> is_at_poor(m_order.size(), false);
    for(const std::array<int, 4>& corner : m_numbered.cells)
      if(scaled_jacobian(edge_matrix(m_numbered.target, corner)) < bound)
        for(const int v : corner)
          is_at_poor[v] = true;
    bool is_on_interface = false;
    for(std::size_t i = 0; i < m_order.size(); ++i)
    {
      if(!is_at_poor[i] || m_freedom[i] == Freedom_3::SPACE || m_surfaces[i] == m_covered[0].surface)
        continue;
      is_on_interface = true;
      if(m_is_on_boundary[i])
        m_surfaces[i] = m_covered[0].surface;
      m_freedom[i] = m_freedom[i] == Freedom_3::SURFACE && !m_is_on_boundary[i] ? Freedom_3::SPACE : Freedom_3::SURFACE;
    }
    return is_on_interface;
  }

private:
  static constexpr double pull = 5; // a guess; weight of covering the boundary: hardly makes corners worse
  static constexpr double firm_hold_of_lines = 15; // a guess; relative to other steps, as the worst corners weigh more

  // Pulls sliding vertices to positions: those on lines to the first ones, by a factor more, which keeps curved lines evenly
  // divided, and the others to those given.
  void hold_boundary(const Matrix3Xd& positions, const double factor_of_lines, Corner_goals_3& goals) const
  {
    for(std::size_t i = 0; i < m_order.size(); ++i)
      if(const bool is_on_line = m_freedom[i] == Freedom_3::LINE; is_on_line || m_freedom[i] == Freedom_3::SURFACE)
      {
        const double factor = is_on_line ? factor_of_lines : 1;
        const Eigen::Vector3d p = factor * (is_on_line ? m_numbered.source : positions).col(i);
        for(int axis = 0; axis < 3; ++axis)
          goals.constraints.push_back({ { { static_cast<int>(i), factor * Eigen::Vector3d::Unit(axis) } }, p[axis] });
      }
  }

  // Returns the point nearest to a vertex among those where it may be; for a vertex that may not move, its first position.
  Eigen::Vector3d nearest(const std::size_t i) const
  {
    return m_surfaces[i]->nearest(m_freedom[i] == Freedom_3::NONE ? m_numbered.source.col(i) : m_numbered.target.col(i),
                                  m_freedom[i]);
  }

  // Pulls vertices to the nearest points where they may be, mostly in the directions in which they may not move there.
  void return_to_surface(const double factor, Corner_goals_3& goals) const
  {
    constexpr double part_along = 0.1; // a guess; how much less a vertex is held in the directions in which it may move
    for(std::size_t i = 0; i < m_order.size(); ++i)
    {
      if(m_freedom[i] == Freedom_3::SPACE)
        continue;
      const Eigen::Vector3d p = nearest(i);
      const Eigen::Matrix3d way
        = factor * (Eigen::Matrix3d::Identity() - (1 - part_along) * m_surfaces[i]->projector(p, m_freedom[i]));
      for(int axis = 0; axis < 3; ++axis)
        goals.constraints.push_back({ { { static_cast<int>(i), way.col(axis) } }, way.col(axis).dot(p) });
    }
  }

  bool is_positive_all_over(const Matrix3Xd& positions, const std::size_t h) const
  { return is_positive_hexahedron_3(points_of_hexahedron(positions, m_hexahedra[h])); }

  // Takes positions, put back onto the boundary. If a hexahedron would be inverted, or a corner so flat that the next steps would
  // serve it alone, its vertices take a part of their way only, and in the end none. While corners are inverted anyway, the next
  // steps are left to mend them.
  void put_back(const Matrix3Xd& moved, const bool was_valid, const double mean_edge)
  {
    constexpr int number_of_attempts = 5; // a guess
    constexpr double largest_loss = 0.9;  // a guess; part of a scaled Jacobian that a step may lose
    const Matrix3Xd before = m_numbered.target;
    const bool may_shorten = was_valid || inverted_cells(m_numbered, moved).number == 0;
    const auto quality = [&](const Matrix3Xd& positions, const std::size_t c)
    {
      return scaled_jacobian(edge_matrix(positions, m_numbered.cells[c]), shortest_edge * mean_edge);
    };
    std::vector<double> least(m_numbered.cells.size(), 0), part(m_order.size(), 1);
    for(std::size_t c = 0; c < least.size() && was_valid; ++c)
      least[c] = (std::min)({ flat_scaled_jacobian, (1 - largest_loss) * quality(before, c), quality(before, c) });
    std::vector<bool> was_positive(m_hexahedra.size(), false);
    for(std::size_t h = 0; h < m_hexahedra.size() && was_valid; ++h)
      was_positive[h] = is_positive_all_over(before, h);
    for(int attempt = 1; ; ++attempt)
    {
      for(std::size_t i = 0; i < m_order.size(); ++i)
        m_numbered.target.col(i) = part[i] == 0 ? Eigen::Vector3d(before.col(i))
          : m_surfaces[i]->nearest(before.col(i) + part[i] * (moved.col(i) - before.col(i)), m_freedom[i]);
      std::vector<bool> is_at_bad(m_order.size(), false);
      bool is_valid = true;
      for(std::size_t c = 0; c < least.size(); ++c)
        if(!is_positive(m_numbered.target, m_numbered.cells[c]) || quality(m_numbered.target, c) < least[c])
        {
          is_valid = false;
          for(const int v : m_numbered.cells[c])
            is_at_bad[v] = true;
        }
      for(std::size_t h = 0; h < m_hexahedra.size(); ++h)
        if(was_positive[h] && !is_positive_all_over(m_numbered.target, h))
        {
          is_valid = false;
          for(const int v : m_hexahedra[h])
            is_at_bad[v] = true;
        }
      if(is_valid || !may_shorten || (attempt >= number_of_attempts && !was_valid))
        return;
      for(std::size_t i = 0; i < m_order.size(); ++i)
        if(is_at_bad[i])
          part[i] *= attempt < number_of_attempts ? 0.5 : 0;
    }
  }

  void write_points()
  {
    for(std::size_t i = 0; i < m_order.size(); ++i)
      m_mesh.points[m_order[i]] = m_numbered.target.col(i);
  }

  Hexahedra_3 m_mesh;
  Numbered_mesh_3 m_numbered; // corners as cells; the source has the first positions of vertices, the target the present ones
  std::vector<std::size_t> m_order;
  std::vector<std::array<int, 8> > m_hexahedra; // in the order of the mesh
  std::vector<Freedom_3> m_freedom; // freedom of the vertices in `m_order`
  std::vector<const Body_surface_3*> m_surfaces; // on which they move
  std::vector<bool> m_is_on_boundary;
  std::vector<Covered_surface_3> m_covered; // first the boundary, then the patches of interfaces
  Linear_solver_3& m_solver;
  const Budget& m_budget;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_SLIDING_HEXAHEDRA_3_H
