// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PULLED_BACK_HEXAHEDRA_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PULLED_BACK_HEXAHEDRA_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Engine/engine.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/hexahedron_corners_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

using Locations_3 = std::vector<std::optional<Volume_map_3::Location> >;

// Moves vertices such that corners become positive and their angles right: each in the directions onto which its
// projector projects, and not at all if that is zero.
inline void improve_hexahedra_3(Hexahedron_soup_3& mesh, const std::vector<Eigen::Matrix3d>& projectors,
                                Linear_solver_3& solver, const bool is_parallel, const Budget& budget)
{
  if(budget.is_exhausted())
    return;
  Eigen::Matrix3Xd points(3, mesh.points.size());
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    points.col(v) = to_vector(mesh.points[v]);
  std::vector<std::array<int, 4> > corners;
  double sum_of_lengths = 0;
  for_each_corner(mesh, [&](const std::array<std::size_t, 4>& corner)
  {
    corners.push_back({ static_cast<int>(corner[0]), static_cast<int>(corner[1]), static_cast<int>(corner[2]),
                        static_cast<int>(corner[3]) });
    sum_of_lengths += edge_matrix(points, corners.back()).colwise().norm().sum();
  });

  std::vector<bool> is_fixed;
  for(const Eigen::Matrix3d& projector : projectors)
    is_fixed.push_back(projector.isZero(0));
  Numbered_mesh_3 numbered;
  const std::vector<std::size_t> order = set_numbered_mesh(corners, points, is_fixed, numbered);
  numbered.target = numbered.source;
  std::vector<Eigen::Matrix3d> ordered;
  for(const std::size_t v : order)
    ordered.push_back(projectors[v]);
  const double mean_length = sum_of_lengths / (3. * static_cast<double>(corners.size()));
  const Map_3 map = improve_corners_3(numbered, ordered, mean_length, solver, is_parallel, budget);
  for(std::size_t i = 0; i < order.size(); ++i)
    mesh.points[order[i]] = { map.positions(0, i), map.positions(1, i), map.positions(2, i) };
}

// Hexahedra in a domain whose boundary facets are orthogonal to the axes, pulled back to the body. Vertices on the
// boundary keep the coordinates of the planes in which they lie, so they stay on the boundary of the body, and those on
// edges of the domain on the lines that are mapped there.
class Pulled_back_hexahedra_3
{
public:
  // With the preimages of the vertices of the domain; the spacing is that of the domain, too.
  Pulled_back_hexahedra_3(const Volume_map_3& map, const Hexahedron_soup_3& domain, const Locations_3& preimages,
                          const double spacing, Linear_solver_3& solver, const bool is_parallel, const Budget& budget)
    : m_map(map), m_mesh(domain), m_spacing(spacing), m_quadrangles(domain.points.size()),
      m_cell_of_vertex(domain.points.size()), m_moves_along(domain.points.size(), { true, true, true }),
      m_solver(solver), m_is_parallel(is_parallel), m_budget(budget)
  {
    m_mesh.images = domain.points;
    for(const Quadrangle& quadrangle : domain.facets)
    {
      const std::size_t axis = normal_axis(quadrangle);
      for(const std::size_t v : quadrangle)
      {
        m_quadrangles[v].push_back({ quadrangle, axis, turn(quadrangle, 0, axis) > 0 });
        m_moves_along[v][axis] = false;
      }
    }
    for(std::size_t v = 0; v < m_mesh.images.size(); ++v)
      take(v, preimages[v] ? *preimages[v] : *m_map.nearest_preimage(image_of(v))); // padding may leave the domain
  }

  const Hexahedron_soup_3& mesh() const { return m_mesh; }
  const Budget& budget() const { return m_budget; }
  bool is_on_boundary(const std::size_t v) const { return !m_quadrangles[v].empty(); }
  double spacing() const { return m_spacing; }

  // Moves the vertices inside.
  void improve_inside() { improve(false, m_mesh); }

  // Moves all vertices, those on the boundary in the directions of their facet or line, and pulls these back again. The
  // step is shortened until the quadrangles of the boundary are convex. Returns whether there was one.
  bool slide()
  {
    Hexahedron_soup_3 moved = m_mesh;
    improve(true, moved);
    const std::vector<std::array<double, 3> > points = m_mesh.points, images = m_mesh.images;
    const std::vector<std::size_t> cell_of_vertex = m_cell_of_vertex;
    for(const double part : {1., 0.5, 0.25, 0.125})
    {
      if(move_towards(moved.points, part))
        return true;
      m_mesh.points = points;
      m_mesh.images = images;
      m_cell_of_vertex = cell_of_vertex;
    }
    return false;
  }

  // A vertex in the domain and in the body, and the cell there.
  struct Place
  {
    std::array<double, 3> image, point;
    std::size_t cell;
  };

  Place place(const std::size_t v) const { return { m_mesh.images[v], m_mesh.points[v], m_cell_of_vertex[v] }; }

  void put(const std::size_t v, const Place& place)
  {
    m_mesh.images[v] = place.image;
    m_mesh.points[v] = place.point;
    m_cell_of_vertex[v] = place.cell;
  }

  // Moves a vertex, in the body, or in the domain if it is on the boundary. Returns false if that does not allow it.
  bool move(const std::size_t v, const std::array<double, 3>& offset)
  {
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      if(is_on_boundary(v) && offset[axis] != 0 && !m_moves_along[v][axis])
        return false;
      (is_on_boundary(v) ? m_mesh.images : m_mesh.points)[v][axis] += offset[axis];
    }
    if(!is_on_boundary(v))
      return true;
    const auto location = has_convex_quadrangles(v) ? m_map.preimage(image_of(v)) : std::nullopt;
    if(location)
      take(v, *location);
    return location.has_value();
  }

private:
  using Quadrangle = std::array<std::size_t, 4>;

  // A quadrangle of the boundary, and how it lies in the domain.
  struct Boundary_quadrangle
  {
    Quadrangle vertices;
    std::size_t axis; // of its normal
    bool turns_left;
  };

  // Are the quadrangles of the boundary around a vertex convex in the domain, and oriented as at first? If all are,
  // they cover it once.
  bool has_convex_quadrangles(const std::size_t v) const
  {
    for(const Boundary_quadrangle& quadrangle : m_quadrangles[v])
      for(std::size_t i = 0; i < 4; ++i)
        if(!((quadrangle.turns_left ? 1 : -1) * turn(quadrangle.vertices, i, quadrangle.axis) > 0))
          return false;
    return true;
  }

  // At a corner of a quadrangle of the domain: the area of the parallelogram there, seen along the axis.
  double turn(const Quadrangle& quadrangle, const std::size_t i, const std::size_t axis) const
  {
    const auto edge_to = [&](const std::size_t k) -> Eigen::Vector3d
    {
      return to_vector(m_mesh.images[quadrangle[k % 4]]) - to_vector(m_mesh.images[quadrangle[i]]);
    };
    return edge_to(i + 1).cross(edge_to(i + 3))[axis];
  }

  std::size_t normal_axis(const Quadrangle& quadrangle) const
  {
    std::size_t axis = 0;
    const auto has_coordinate_of_first = [&](const std::size_t v)
    {
      return m_mesh.images[v][axis] == m_mesh.images[quadrangle[0]][axis];
    };
    while(!std::all_of(quadrangle.begin(), quadrangle.end(), has_coordinate_of_first))
      ++axis;
    return axis;
  }

  Volume_map_3::Point_3 image_of(const std::size_t v) const
  {
    return Volume_map_3::Point_3(m_mesh.images[v][0], m_mesh.images[v][1], m_mesh.images[v][2]);
  }

  void take(const std::size_t v, const Volume_map_3::Location& location)
  {
    m_mesh.points[v] = { location.point.x(), location.point.y(), location.point.z() };
    m_cell_of_vertex[v] = location.cell;
  }

  // Improves a mesh; its vertices on the boundary slide, or stay.
  void improve(const bool do_slide, Hexahedron_soup_3& mesh)
  {
    std::vector<Eigen::Matrix3d> projectors(mesh.points.size(), Eigen::Matrix3d::Identity());
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
      if(is_on_boundary(v))
        projectors[v] = do_slide ? projector(v) : Eigen::Matrix3d(Eigen::Matrix3d::Zero());
    improve_hexahedra_3(mesh, projectors, m_solver, m_is_parallel, m_budget);
  }

  // Onto the preimages of the axes along which the vertex moves.
  Eigen::Matrix3d projector(const std::size_t v) const
  {
    const Eigen::Matrix3d inverse_differential = m_map.inverse_differential(m_cell_of_vertex[v]);
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
    for(int axis = 0; axis < 3; ++axis)
      if(m_moves_along[v][axis])
      {
        const Eigen::Vector3d direction = inverse_differential.col(axis).stableNormalized();
        const Eigen::Vector3d d = (direction - result * direction).stableNormalized();
        result += d * d.transpose();
      }
    return result.allFinite() ? result : Eigen::Matrix3d(Eigen::Matrix3d::Zero()); // of a cell that is almost flat
  }

  // Moves all vertices a part of the way. Is the boundary still covered once? If so, all of them have been moved.
  bool move_towards(const std::vector<std::array<double, 3> >& points, const double part)
  {
    for(std::size_t v = 0; v < points.size(); ++v)
    {
      const Eigen::Vector3d p = (1 - part) * to_vector(m_mesh.points[v]) + part * to_vector(points[v]);
      if(!is_on_boundary(v))
        m_mesh.points[v] = { p[0], p[1], p[2] };
      else if(m_budget.is_exhausted())
        return false;
      else
        put_on_boundary(v, p);
    }
    std::size_t v = 0;
    while(v < points.size() && has_convex_quadrangles(v))
      ++v;
    return v == points.size();
  }

  void put_on_boundary(const std::size_t v, const Eigen::Vector3d& p)
  {
    const auto image = m_map.nearest_image(Volume_map_3::Point_3(p[0], p[1], p[2]));
    if(!image) // not finite
      return;
    std::array<double, 3> q = m_mesh.images[v];
    for(std::size_t axis = 0; axis < 3; ++axis)
      if(m_moves_along[v][axis])
        q[axis] = image->point[static_cast<int>(axis)];
    if(const auto location = m_map.preimage(Volume_map_3::Point_3(q[0], q[1], q[2])))
    {
      m_mesh.images[v] = q;
      take(v, *location);
    }
  }

  const Volume_map_3& m_map;
  Hexahedron_soup_3 m_mesh; // with the images of its boundary
  double m_spacing;
  std::vector<std::vector<Boundary_quadrangle> > m_quadrangles; // around each vertex
  std::vector<std::size_t> m_cell_of_vertex; // of the tetrahedral mesh
  std::vector<std::array<bool, 3> > m_moves_along; // each axis of the domain
  Linear_solver_3& m_solver;
  bool m_is_parallel;
  const Budget& m_budget;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PULLED_BACK_HEXAHEDRA_3_H
