// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_SLIDING_HEXAHEDRA_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_SLIDING_HEXAHEDRA_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/improve_corners_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/smooth_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Bounds of the least scaled Jacobian, all guesses: the first one ends the search, below the second one other layers are
// tried, and corners below the third one are almost flat, which steps avoid.
constexpr double sufficient_scaled_jacobian = 0.3, poor_scaled_jacobian = 0.2, flat_scaled_jacobian = 0.1;

// Hexahedra of a body whose vertices move inside, on its boundary and along its lines.
class Sliding_hexahedra_3
{
public:
  Sliding_hexahedra_3(const Hexahedron_soup_3& mesh, const std::vector<Freedom_3>& freedom, const Body_surface_3& surface,
                      Linear_solver_3& solver, const bool is_parallel, const Budget& budget)
    : m_mesh(mesh), m_surface(surface), m_solver(solver), m_budget(budget)
  {
    Matrix3Xd points(3, mesh.points.size());
    std::vector<bool> is_fixed;
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      points.col(v) = to_vector(mesh.points[v]);
      is_fixed.push_back(freedom[v] == Freedom_3::NONE);
    }
    std::vector<std::array<int, 4> > corners;
    for_each_corner(mesh, [&](const std::array<std::size_t, 4>& corner)
    {
      corners.emplace_back();
      std::copy(corner.begin(), corner.end(), corners.back().begin());
    });
    std::tie(m_numbered, m_order) = ordered_mesh_3(corners, points, is_fixed, is_parallel);
    m_numbered.target = m_numbered.source;
    for(const std::size_t v : m_order)
      m_freedom.push_back(freedom[v]);
    const std::vector<int> index = inverse_order(m_order);
    for(const std::array<std::size_t, 4>& quadrangle : mesh.facets)
      for(const std::size_t k : { 1, 2 })
        m_boundary.push_back({ index[quadrangle[0]], index[quadrangle[k]], index[quadrangle[k + 1]] });
  }

  const Hexahedron_soup_3& mesh() const { return m_mesh; }

  // Makes steps of Newton's method for all vertices at once, or, unless `do_slide`, for those inside. Vertices on the boundary
  // move in its tangent planes, or along lines, are put back, and are pulled to cover the boundary; once all corners are
  // positive, also to approach it, which hinders untangling. Hexahedra whose corners are all positive keep them so.
  void improve(const std::size_t number_of_steps, const bool do_slide, const int exponent)
  {
    Corner_goals_3 goals = { {}, {}, 1, {}, pull, exponent, number_of_steps };
    for(std::size_t i = 0; i < m_order.size(); ++i)
    {
      const bool stays = !do_slide && m_freedom[i] != Freedom_3::SPACE;
      goals.projectors.push_back(m_surface.projector(m_numbered.target.col(i), stays ? Freedom_3::NONE : m_freedom[i]));
    }
    set_edges(goals);
    const bool is_valid = inverted_cells(m_numbered, m_numbered.target).number == 0;
    if(do_slide)
    {
      hold_boundary(goals);
      cover_boundary(goals);
      if(is_valid)
        approach_surface(goals);
    }
    put_back(improve_corners_3(m_numbered, goals, m_solver, m_budget), is_valid);
    write_points();
  }

  // Lets vertices leave the surface, where corners are untangled easily, and draws the vertices back by a weight that grows,
  // while corners stay positive (the penalty method; Nocedal and Wright, Numerical Optimization, section 17.1).
  void leave_and_return()
  {
    constexpr double first_weight = 100, last_weight = 1e10, growth = 3; // guesses
    constexpr std::size_t number_of_steps = 20;                          // a guess
    for(double weight = first_weight; weight <= last_weight && m_budget.may_begin_round(Phase::HEXAHEDRA, "return to the surface"); weight *= growth)
    {
      Corner_goals_3 goals = { std::vector<Eigen::Matrix3d>(m_order.size(), Eigen::Matrix3d::Identity()), {}, 1, {}, pull, 1,
                               number_of_steps };
      set_edges(goals);
      hold_boundary(goals);
      cover_boundary(goals);
      return_to_surface(std::sqrt(weight / pull), goals);
      m_numbered.target = improve_corners_3(m_numbered, goals, m_solver, m_budget);
      write_points();
    }
    for(std::size_t i = 0; i < m_order.size(); ++i)
      m_numbered.target.col(i) = nearest(i);
    write_points();
  }

  // Moves the vertices of corners whose scaled Jacobian is below the target, one after the other.
  void smooth(const double target)
  {
    smooth_hexahedra_3(m_numbered.cells, m_freedom, m_surface,
                       covers_of_vertices_3(m_surface.vertices(), m_boundary, m_numbered.target), target, m_budget,
                       m_numbered.target);
    write_points();
  }

  // Lets vertices of inverted corners leave the lines, on which corners perhaps cannot become positive. Returns whether any
  // vertex was on a line.
  bool leave_lines()
  {
    bool is_on_line = false;
    for(const std::array<int, 4>& corner : m_numbered.cells)
      if(!is_positive(m_numbered.target, corner))
        for(const int v : corner)
          if(m_freedom[v] == Freedom_3::LINE || m_freedom[v] == Freedom_3::NONE)
          {
            m_freedom[v] = Freedom_3::SURFACE;
            is_on_line = true;
          }
    return is_on_line;
  }

private:
  static constexpr double pull = 5; // a guess; weight of covering the boundary: hardly makes corners worse

  // Sets the goal for edges: the mean length of the edges of a hexahedron along each axis, or a bound for short ones.
  void set_edges(Corner_goals_3& goals) const
  {
    constexpr double shortest = 0.5; // a guess; relative to the mean edge
    std::vector<Eigen::Vector3d> edges(m_mesh.cells.size(), Eigen::Vector3d::Zero());
    const auto length = [&](const std::size_t corner, const std::size_t i) -> double&
    {
      const std::array<std::size_t, 4>& vertices = corners_of_hexahedron[m_numbered.user_number(corner) % 8];
      return edges[m_numbered.user_number(corner) / 8][axis_of_edge(vertices[0], vertices[i + 1])];
    };
    for(std::size_t c = 0; c < m_numbered.cells.size(); ++c)
      for(std::size_t i = 0; i < 3; ++i)
        length(c, i) += edge_matrix(m_numbered.target, m_numbered.cells[c]).col(i).norm() / 8;
    goals.mean_edge = 0;
    for(const Eigen::Vector3d& lengths : edges)
      goals.mean_edge += lengths.mean() / static_cast<double>(edges.size());
    goals.edges.resize(m_numbered.cells.size());
    for(std::size_t c = 0; c < m_numbered.cells.size(); ++c)
      for(std::size_t i = 0; i < 3; ++i)
        goals.edges[c][i] = (std::max)(length(c, i), shortest * goals.mean_edge);
  }

  // Pulls sliding vertices to their first positions.
  void hold_boundary(Corner_goals_3& goals) const
  {
    for(std::size_t i = 0; i < m_order.size(); ++i)
      if(m_freedom[i] == Freedom_3::SURFACE || m_freedom[i] == Freedom_3::LINE)
        for(int axis = 0; axis < 3; ++axis)
          goals.constraints.push_back({ { { static_cast<int>(i), Eigen::Vector3d::Unit(axis) } },
                                        m_numbered.source(axis, i) });
  }

  // Returns the point nearest to a vertex among those where it may be: the first position of one that may not move.
  Eigen::Vector3d nearest(const std::size_t i) const
  {
    return m_surface.nearest(m_freedom[i] == Freedom_3::NONE ? m_numbered.source.col(i) : m_numbered.target.col(i),
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
        = factor * (Eigen::Matrix3d::Identity() - (1 - part_along) * m_surface.projector(p, m_freedom[i]));
      for(int axis = 0; axis < 3; ++axis)
        goals.constraints.push_back({ { { static_cast<int>(i), way.col(axis) } }, way.col(axis).dot(p) });
    }
  }

  // Pulls a point of a triangle to a far point on the body's surface, along the way between both only, so that the triangle
  // may slide across the way (as in the registration of surfaces by Chen and Medioni, Object modelling by registration of
  // multiple range images, 1992).
  void pull_point(const Eigen::Vector3d& q, const std::array<int, 3>& triangle, const Eigen::Vector3d& p,
                  Corner_goals_3& goals) const
  {
    constexpr double smallest_distance = 0.2, longest_pull = 1; // guesses; relative to the mean edge
    const double factor = std::sqrt(200.);                      // a guess; scales the residual
    const double distance = (p - q).norm();
    if(distance < smallest_distance * goals.mean_edge)
      return;
    const auto& [a, b, c] = triangle;
    Small_matrix<3, 2> sides;
    sides << m_numbered.target.col(b) - m_numbered.target.col(a), m_numbered.target.col(c) - m_numbered.target.col(a);
    const Small_matrix<2, 2> products = sides.transpose() * sides;
    if(!(products.determinant() > 0))
      return;
    const Small_matrix<2, 2> inverse = products.inverse();
    const Small_matrix<2, 1> st = inverse * (sides.transpose() * (q - m_numbered.target.col(a)));
    const Eigen::Vector3d way = factor * (p - q) / distance;
    goals.constraints.push_back({ { { a, (1 - st.sum()) * way }, { b, st[0] * way }, { c, st[1] * way } },
                                  way.dot(q) + factor * (std::min)(distance, longest_pull * goals.mean_edge) });
  }

  // Pulls quadrangles to the vertices of the body's surface.
  void cover_boundary(Corner_goals_3& goals) const
  {
    for_each_nearest(m_surface.vertices(), m_boundary, m_numbered.target,
                     [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::array<int, 3>& triangle)
                     { pull_point(q, triangle, p, goals); });
  }

  // Pulls the middles of quadrangles and of their edges to the body's surface: a quadrangle that spans a valley has its middle
  // far away.
  void approach_surface(Corner_goals_3& goals) const
  {
    for(const std::array<int, 3>& triangle : m_boundary)
      for(const auto& [a, b] : { std::make_pair(0, 1), std::make_pair(1, 2), std::make_pair(2, 0) })
      {
        const Eigen::Vector3d q = (m_numbered.target.col(triangle[a]) + m_numbered.target.col(triangle[b])) / 2;
        pull_point(q, triangle, m_surface.nearest(q, Freedom_3::SURFACE), goals);
      }
  }

  // Takes positions, put back onto the boundary. Where a corner would be inverted, or so flat that the next steps would serve
  // it alone, its vertices take a part of their way only, and in the end none. While corners are inverted anyway, the next
  // steps are left to mend them.
  void put_back(const Matrix3Xd& moved, const bool was_valid)
  {
    constexpr int number_of_attempts = 5; // a guess
    constexpr double largest_loss = 0.9;  // a guess; part of a scaled Jacobian that a step may lose
    const Matrix3Xd before = m_numbered.target;
    const bool may_shorten = was_valid || inverted_cells(m_numbered, moved).number == 0;
    const auto quality = [&](const Matrix3Xd& positions, const std::size_t c)
    {
      return scaled_jacobian(edge_matrix(positions, m_numbered.cells[c]));
    };
    std::vector<double> least(m_numbered.cells.size(), 0), part(m_order.size(), 1);
    for(std::size_t c = 0; c < least.size() && was_valid; ++c)
      least[c] = (std::min)({ flat_scaled_jacobian, (1 - largest_loss) * quality(before, c), quality(before, c) });
    for(int attempt = 1; ; ++attempt)
    {
      for(std::size_t i = 0; i < m_order.size(); ++i)
        m_numbered.target.col(i) = part[i] == 0 ? Eigen::Vector3d(before.col(i))
          : m_surface.nearest(before.col(i) + part[i] * (moved.col(i) - before.col(i)), m_freedom[i]);
      std::vector<bool> is_at_bad(m_order.size(), false);
      bool is_valid = true;
      for(std::size_t c = 0; c < least.size(); ++c)
        if(!is_positive(m_numbered.target, m_numbered.cells[c]) || quality(m_numbered.target, c) < least[c])
        {
          is_valid = false;
          for(const int v : m_numbered.cells[c])
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
      m_mesh.points[m_order[i]] = coordinates(m_numbered.target.col(i));
  }

  Hexahedron_soup_3 m_mesh;
  const Body_surface_3& m_surface;
  Numbered_mesh_3 m_numbered; // corners as cells; the source has the first positions of vertices, the target the present ones
  std::vector<std::size_t> m_order;
  std::vector<Freedom_3> m_freedom; // freedom of the vertices in `m_order`
  Triangles_of_boundary m_boundary; // two triangles of each quadrangle, by indices in `m_order`
  Linear_solver_3& m_solver;
  const Budget& m_budget;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_SLIDING_HEXAHEDRA_3_H
