// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_POSITIONS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_POSITIONS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_with_domain_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Interface_quadrangles_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Matches vertices and corners, each of them once at most, the nearest pair first. Takes the distance (or cost), vertex and corner
// of all pairs. Returns the corner of each vertex that has one.
template <typename Corner>
std::map<std::size_t, Corner> matched_corners(std::vector<std::tuple<double, std::size_t, Corner> > pairs)
{
  std::sort(pairs.begin(), pairs.end());
  std::map<std::size_t, Corner> result;
  std::set<Corner> taken;
  for(const auto& [distance, v, corner] : pairs)
    if(result.count(v) == 0 && taken.insert(corner).second)
      result.emplace(v, corner);
  return result;
}

// Where a vertex is, and where it may move: on the boundary of the body, on interfaces, or, with the freedom SPACE, inside.
struct Position_3
{
  Vector_3 point;
  const Body_surface_3* surface;
  Freedom_3 freedom = Freedom_3::SPACE;
  bool is_on_boundary = false;

  // Returns the point nearest to p among those where the vertex may be.
  Vector_3 nearest(const Vector_3& p) const { return surface->nearest(p, freedom); }

  // Returns this point with the normal or direction there, for a vertex on a surface or a line, as a model of SlidingSurface_3.
  Surface_point_3 nearest_point(const std::array<double, 3>& p) const
  { return surface->nearest_with_direction(to_vector(p), freedom); }

  // Returns the condition by which Newton's method lets the vertex slide or stay.
  Vertex_condition_3 condition() const
  {
    return freedom == Freedom_3::SPACE ? Vertex_condition_3::free()
         : freedom == Freedom_3::SURFACE ? Vertex_condition_3::on_surface(*this)
         : freedom == Freedom_3::LINE ? Vertex_condition_3::on_curve(*this) : Vertex_condition_3::at_target();
  }
};

using Triangle_3 = std::array<std::size_t, 3>; // vertices of a half of a quadrangle

// Surface, and two triangles of each quadrangle of hexahedra that covers it. Triangles farther from it than the tolerance,
// relative to the mean edge, are pulled.
struct Covered_surface_3
{
  const Body_surface_3* surface;
  std::vector<Triangle_3> triangles = {};
  double tolerance = 0;

  void add(const std::array<std::size_t, 4>& quadrangle)
  {
    const auto& [a, b, c, d] = quadrangle;
    triangles.insert(triangles.end(), { { a, b, c }, { a, c, d } });
  }
};

constexpr double tolerance_of_boundary = 0.2, tolerance_of_interface = 0.05; // of covered surfaces; guesses

// Hexahedra, the positions of their vertices, and the surfaces that they cover: first the boundary, then patches of interfaces.
struct Placed_hexahedra_3
{
  Hexahedra_3 mesh;
  std::vector<Position_3> positions;
  std::vector<Covered_surface_3> covered;
};

// Finds the positions of vertices by the patches that meet there.
class Search_for_positions_3
{
public:
  Search_for_positions_3(const Hexahedra_3& mesh, const std::vector<Interface_quadrangle_3>& quadrangles,
                         Body_interfaces_3& interfaces)
    : m_mesh(mesh), m_interfaces(interfaces), m_patches(mesh.points.size()), m_widths(mesh.points.size(), 0)
  {
    for(const std::array<std::size_t, 4>& facet : mesh.facets)
      for(const std::size_t v : facet)
        m_patches[v].insert(0);
    for(const Interface_quadrangle_3& q : quadrangles)
      for(const std::size_t v : q.vertices)
        if(q.patch != 0)
        {
          m_patches[v].insert(q.patch);
          m_widths[v] = (std::max)(m_widths[v], std::sqrt(area_vector(mesh.points, q.vertices).norm()));
        }
  }

  std::vector<Position_3> run()
  {
    std::vector<Position_3> result;
    for(std::size_t v = 0; v < m_patches.size(); ++v)
      result.push_back(position(v));
    for(const auto& [v, corner] : matched_corners(squared_distances_from_corners(result)))
    {
      result[v].freedom = Freedom_3::NONE;
      result[v].point = m_interfaces.corners(corner.first)[corner.second];
    }
    return result;
  }

private:
  using Corner = std::pair<Patches_3, std::size_t>; // number of a corner where these patches meet

  // Longest ways on the boundary to a line and to a corner, relative to the width of a quadrangle: guesses.
  static constexpr double largest_move = 1.5, largest_move_to_corner = 4;

  bool is_on_boundary(const std::size_t v) const { return m_patches[v].count(0) > 0; }
  bool is_on_interface(const std::size_t v) const { return m_patches[v].size() > is_on_boundary(v); }

  // Returns a position on the patches that meet at a vertex, on a line if there is one. A vertex on the boundary leaves
  // interfaces that do not end near it: a line of the same patches elsewhere would take the vertex away.
  Position_3 position(const std::size_t v)
  {
    const Vector_3& p = m_mesh.points[v];
    if(is_on_interface(v))
    {
      const Body_surface_3& surface = m_interfaces.surface(m_patches[v]);
      const Freedom_3 freedom = m_patches[v].size() > 1 && surface.has_lines() ? Freedom_3::LINE : Freedom_3::SURFACE;
      const Vector_3 nearest = surface.nearest(p, freedom);
      if(!is_on_boundary(v) || (surface.has_lines() && (nearest - p).norm() <= largest_move * m_widths[v]))
        return { nearest, &surface, freedom, is_on_boundary(v) };
    }
    return is_on_boundary(v) ? position_on_boundary(p) : Position_3{ p, &m_interfaces.boundary() };
  }

  // Returns a position on the boundary: p itself, or if rounding kept p off it, as in thin cells of the map, the nearest point.
  Position_3 position_on_boundary(const Vector_3& p) const
  {
    const Body_surface_3& boundary = m_interfaces.boundary();
    const Vector_3 nearest = boundary.nearest(p, Freedom_3::SURFACE), q = boundary.are_equal(p, nearest) ? p : nearest;
    return { q, &boundary, boundary.freedom(q), true };
  }

  // Returns the squared distances of vertices from the corners where their patches meet. A vertex on a line has corners only if
  // the line crosses a line of the boundary there. A vertex on the boundary has only corners near it.
  std::vector<std::tuple<double, std::size_t, Corner> > squared_distances_from_corners(const std::vector<Position_3>& positions)
  {
    std::vector<std::tuple<double, std::size_t, Corner> > result;
    for(std::size_t v = 0; v < positions.size(); ++v)
    {
      const Patches_3& patches = m_patches[v];
      if(positions[v].surface == &m_interfaces.boundary() || patches.size() < 2)
        continue;
      const bool crosses_line = is_on_boundary(v) && m_interfaces.boundary().freedom(m_mesh.points[v]) != Freedom_3::SURFACE;
      if(crosses_line || !m_interfaces.has_line(patches))
        for(std::size_t c = 0; c < m_interfaces.corners(patches).size(); ++c)
          if(const double squared_distance = (m_mesh.points[v] - m_interfaces.corners(patches)[c]).squaredNorm();
             !is_on_boundary(v) || squared_distance <= std::pow(largest_move_to_corner * m_widths[v], 2))
            result.emplace_back(squared_distance, v, Corner(patches, c));
    }
    return result;
  }

  const Hexahedra_3& m_mesh;
  Body_interfaces_3& m_interfaces;
  std::vector<Patches_3> m_patches; // of each vertex
  std::vector<double> m_widths;     // of quadrangles of interfaces, at each vertex
};

// Returns hexahedra with their vertices moved to their positions: on the boundary, on a patch, or on a line or in a corner where
// the patches of the vertex meet. Takes the quadrangles of interfaces with their patches; without them, interfaces do not matter.
inline Placed_hexahedra_3 placed_hexahedra_3(const Hexahedra_3& mesh, const std::vector<Interface_quadrangle_3>& quadrangles,
                                             Body_interfaces_3& interfaces)
{
  Placed_hexahedra_3 result = { mesh, Search_for_positions_3(mesh, quadrangles, interfaces).run(),
                                { { &interfaces.boundary(), {}, tolerance_of_boundary } } };
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    result.mesh.points[v] = result.positions[v].point;
  for(const std::array<std::size_t, 4>& q : mesh.facets)
    result.covered.front().add(q);
  std::map<std::size_t, Covered_surface_3> patches;
  for(const Interface_quadrangle_3& q : quadrangles)
    if(q.patch != 0)
      patches.try_emplace(q.patch, Covered_surface_3{ &interfaces.surface({ q.patch }), {}, tolerance_of_interface })
        .first->second.add(q.vertices);
  for(const auto& [patch, covered] : patches)
    result.covered.push_back(covered);
  return result;
}

// Moves a vertex of the boundary to each marked corner: that with the nearest image, on a line if the corner is on a line. If no
// such image is within the spacing, the corner is given up. Vertices on interfaces stay.
inline void move_to_corners_3(const Body_with_domain_3& body, const double spacing, Placed_hexahedra_3& hexahedra)
{
  const Hexahedra_3& mesh = hexahedra.mesh;
  std::vector<std::tuple<double, std::size_t, std::size_t> > pairs; // distance of images, vertex, corner
  for(const std::size_t corner : body.surface.corners())
  {
    const Vector_3& p = body.points[corner];
    const bool is_on_line = body.surface.is_on_line(p);
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      const Position_3& position = hexahedra.positions[v];
      const Vector_3 offset = mesh.images[v] - body.images[corner];
      const bool is_in_same_planes // as vertices on the other side of a thin body are not
        = (offset[0] == 0) + (offset[1] == 0) + (offset[2] == 0) >= (is_on_line ? 2 : 1);
      if(position.is_on_boundary && body.surface.are_equal(mesh.points[v], p))
        pairs.emplace_back(0, v, corner);
      else if(position.surface == &body.surface && position.freedom == (is_on_line ? Freedom_3::LINE : Freedom_3::SURFACE)
              && is_in_same_planes && offset.norm() <= spacing)
        pairs.emplace_back(offset.norm(), v, corner);
    }
  }
  for(const auto& [v, corner] : matched_corners(std::move(pairs)))
  {
    hexahedra.mesh.points[v] = body.points[corner];
    hexahedra.positions[v].freedom = Freedom_3::NONE;
  }
}

// Returns the marked corners of the boundary that are not vertices of the hexahedra.
inline std::vector<std::array<double, 3> > corners_given_up_3(const Body_with_domain_3& body, const Hexahedra_3& mesh)
{
  std::vector<std::array<double, 3> > result;
  for(const std::size_t corner : body.surface.corners())
    if(std::none_of(mesh.points.begin(), mesh.points.end(), [&](const Vector_3& p)
                    { return body.surface.are_equal(p, body.points[corner]); }))
      result.push_back(body.soup.points[corner]);
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_POSITIONS_3_H
