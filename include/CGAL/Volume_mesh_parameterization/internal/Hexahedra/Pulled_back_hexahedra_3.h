// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PULLED_BACK_HEXAHEDRA_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PULLED_BACK_HEXAHEDRA_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/to_vector.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/hexahedron_corners_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/improve_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Hexahedra in a domain whose boundary facets are orthogonal to the axes, pulled back to the body. Vertices on the
// boundary keep the coordinates of the planes in which they lie, so they stay on the boundary of the body, and those on
// edges of the domain on the lines that are mapped there.
template <typename ConcurrencyTag>
class Pulled_back_hexahedra_3
{
public:
  // The spacing is that of the domain.
  Pulled_back_hexahedra_3(const Volume_map_3& map, const std::vector<std::array<double, 3> >& points,
                          const std::vector<std::array<std::size_t, 4> >& cells,
                          const std::vector<std::array<double, 3> >& images, const Hexahedron_soup_3& domain,
                          const double spacing, Linear_solver_3& solver)
    : m_map(map), m_points(points), m_cells(cells), m_images(images), m_domain(domain), m_mesh(domain),
      m_spacing(spacing), m_quadrangles(domain.points.size()),
      m_cell_of_vertex(domain.points.size()), m_is_inside(domain.points.size(), Eigen::Matrix3d::Identity()),
      m_moves_along(domain.points.size(), { true, true, true }), m_solver(solver)
  {
    for(const Quadrangle& quadrangle : boundary_quadrangles_3(domain))
    {
      const std::size_t axis = normal_axis(quadrangle);
      for(const std::size_t v : quadrangle)
      {
        m_quadrangles[v].push_back({ quadrangle, axis, turn(quadrangle, 0, axis) > 0 });
        m_moves_along[v][axis] = false;
        m_is_inside[v].setZero();
      }
    }
    pull_back();
  }

  const Hexahedron_soup_3& mesh() const { return m_mesh; }
  bool is_on_boundary(const std::size_t v) const { return m_is_inside[v].isZero(0); }
  double spacing() const { return m_spacing; }

  // Moves the vertices inside.
  void improve_inside() { improve_hexahedra_3(m_mesh, m_is_inside, m_solver, is_parallel<ConcurrencyTag>()); }

  // Moves all vertices, those on the boundary in the directions of their facet or line, and pulls these back again. The
  // step is shortened until the quadrangles of the boundary are convex. Returns whether there was one.
  bool slide()
  {
    std::vector<Eigen::Matrix3d> projectors;
    for(std::size_t v = 0; v < m_mesh.points.size(); ++v)
      projectors.push_back(is_on_boundary(v) ? projector(v) : m_is_inside[v]);
    Hexahedron_soup_3 moved = m_mesh;
    improve_hexahedra_3(moved, projectors, m_solver, is_parallel<ConcurrencyTag>());

    const Hexahedron_soup_3 mesh = m_mesh, domain = m_domain;
    const std::vector<std::size_t> cell_of_vertex = m_cell_of_vertex;
    for(const double part : {1., 0.5, 0.25, 0.125})
    {
      for(std::size_t v = 0; v < m_mesh.points.size(); ++v)
      {
        const Eigen::Vector3d p = (1 - part) * to_vector(mesh.points[v]) + part * to_vector(moved.points[v]);
        if(is_on_boundary(v))
          put_on_boundary(v, p);
        else
          m_mesh.points[v] = { p[0], p[1], p[2] };
      }
      std::size_t v = 0;
      while(v < m_mesh.points.size() && has_convex_quadrangles(v))
        ++v;
      if(v == m_mesh.points.size())
        return true;
      m_mesh = mesh;
      m_domain = domain;
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

  Place place(const std::size_t v) const { return { m_domain.points[v], m_mesh.points[v], m_cell_of_vertex[v] }; }

  void put(const std::size_t v, const Place& place)
  {
    m_domain.points[v] = place.image;
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
      (is_on_boundary(v) ? m_domain : m_mesh).points[v][axis] += offset[axis];
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
      return to_vector(m_domain.points[quadrangle[k % 4]]) - to_vector(m_domain.points[quadrangle[i]]);
    };
    return edge_to(i + 1).cross(edge_to(i + 3))[axis];
  }

  std::size_t normal_axis(const Quadrangle& quadrangle) const
  {
    std::size_t axis = 0;
    const auto has_coordinate_of_first = [&](const std::size_t v)
    {
      return m_domain.points[v][axis] == m_domain.points[quadrangle[0]][axis];
    };
    while(!std::all_of(quadrangle.begin(), quadrangle.end(), has_coordinate_of_first))
      ++axis;
    return axis;
  }

  void pull_back()
  {
    std::vector<Volume_map_3::Point_3> points;
    for(std::size_t v = 0; v < m_domain.points.size(); ++v)
      points.push_back(image_of(v));
    const auto locations = m_map.template preimages<ConcurrencyTag>(points);
    for(std::size_t v = 0; v < points.size(); ++v)
      take(v, locations[v] ? *locations[v] : *m_map.nearest_preimage(points[v])); // padding may leave the domain
  }

  Volume_map_3::Point_3 image_of(const std::size_t v) const
  {
    const std::array<double, 3>& q = m_domain.points[v];
    return Volume_map_3::Point_3(q[0], q[1], q[2]);
  }

  void take(const std::size_t v, const Volume_map_3::Location& location)
  {
    m_mesh.points[v] = { location.point.x(), location.point.y(), location.point.z() };
    m_cell_of_vertex[v] = location.cell;
  }

  // Onto the preimages of the axes along which the vertex moves.
  Eigen::Matrix3d projector(const std::size_t v) const
  {
    const std::array<std::size_t, 4>& cell = m_cells[m_cell_of_vertex[v]];
    Eigen::Matrix3d source, image;
    for(int i = 0; i < 3; ++i)
    {
      source.col(i) = to_vector(m_points[cell[i + 1]]) - to_vector(m_points[cell[0]]);
      image.col(i) = to_vector(m_images[cell[i + 1]]) - to_vector(m_images[cell[0]]);
    }
    const Eigen::Matrix3d inverse_differential = source * image.inverse();
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

  // Near the point, in the same planes of the domain as before.
  void put_on_boundary(const std::size_t v, const Eigen::Vector3d& p)
  {
    const auto image = m_map.nearest_image(Volume_map_3::Point_3(p[0], p[1], p[2]));
    if(!image) // not finite
      return;
    std::array<double, 3> q = m_domain.points[v];
    for(std::size_t axis = 0; axis < 3; ++axis)
      if(m_moves_along[v][axis])
        q[axis] = image->point[static_cast<int>(axis)];
    if(const auto location = m_map.preimage(Volume_map_3::Point_3(q[0], q[1], q[2])))
    {
      m_domain.points[v] = q;
      take(v, *location);
    }
  }

  const Volume_map_3& m_map;
  const std::vector<std::array<double, 3> >& m_points;
  const std::vector<std::array<std::size_t, 4> >& m_cells;
  const std::vector<std::array<double, 3> >& m_images;
  Hexahedron_soup_3 m_domain, m_mesh;
  double m_spacing;
  std::vector<std::vector<Boundary_quadrangle> > m_quadrangles; // around each vertex
  std::vector<std::size_t> m_cell_of_vertex; // of the tetrahedral mesh
  std::vector<Eigen::Matrix3d> m_is_inside;  // 1 for the vertices inside, and 0 for the others
  std::vector<std::array<bool, 3> > m_moves_along; // each axis of the domain
  Linear_solver_3& m_solver;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PULLED_BACK_HEXAHEDRA_3_H
