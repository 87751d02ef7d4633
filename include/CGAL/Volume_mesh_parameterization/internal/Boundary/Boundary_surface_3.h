// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Boundary_facets.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

using Boundary_point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;
using Boundary_mesh_3 = Surface_mesh<Boundary_point_3>;

// The boundary of a complex as a surface mesh oriented outwards, and the way back to the complex.
template <typename C3t3>
class Boundary_surface_3
{
public:
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Facet = typename C3t3::Facet;

  explicit Boundary_surface_3(const C3t3& c3t3)
    : m_facets(c3t3), m_status(build_mesh(c3t3))
  {}

  // The mesh is complete only if the boundary is a manifold.
  Error_code status() const { return m_status; }
  const Boundary_mesh_3& mesh() const { return m_mesh; }

  // The vertex of the complex that has this index in the mesh.
  Vertex_handle vertex(const std::size_t index) const { return m_facets.vertices[index]; }
  std::size_t index(const Vertex_handle v) const { return m_facets.indices.at(v); }
  bool is_on_boundary(const Vertex_handle v) const { return m_facets.indices.count(v) != 0; }

  // The facet of the complex, on the side of its cell, that is this face of the mesh.
  Facet facet(const Boundary_mesh_3::Face_index f) const { return m_facets.facets_of_complex[f]; }

private:
  Error_code build_mesh(const C3t3& c3t3)
  {
    if(m_facets.facets.empty())
      return ERROR_EMPTY_COMPLEX;
    for(const Vertex_handle v : m_facets.vertices)
      if(!is_finite(point(c3t3, v)))
        return ERROR_NON_FINITE_COORDINATE;
    if(!Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(m_facets.facets))
      return ERROR_NON_MANIFOLD_BOUNDARY;

    for(const Vertex_handle v : m_facets.vertices)
      m_mesh.add_vertex(point(c3t3, v));
    for(const std::array<std::size_t, 3>& facet : m_facets.facets)
      m_mesh.add_face(vertex_index(facet[0]), vertex_index(facet[1]), vertex_index(facet[2]));
    return CGAL::is_closed(m_mesh) ? OK : ERROR_NON_MANIFOLD_BOUNDARY;
  }

  static Boundary_point_3 point(const C3t3& c3t3, const Vertex_handle v)
  {
    const auto& tr = c3t3.triangulation();
    const auto p = tr.geom_traits().construct_point_3_object()(tr.point(v)); // of a bare or a weighted point
    return Boundary_point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  static bool is_finite(const Boundary_point_3& p)
  {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  }

  static Boundary_mesh_3::Vertex_index vertex_index(const std::size_t i)
  {
    return Boundary_mesh_3::Vertex_index(static_cast<Boundary_mesh_3::size_type>(i));
  }

  const Boundary_facets<C3t3> m_facets;
  Boundary_mesh_3 m_mesh;
  const Error_code m_status;
};

inline Eigen::Vector3d eigen_point(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Vertex_index v)
{
  return Eigen::Vector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
}

inline Eigen::AlignedBox3d bounding_box(const Boundary_mesh_3& mesh)
{
  Eigen::AlignedBox3d box;
  for(const auto v : mesh.vertices())
    box.extend(eigen_point(mesh, v));
  return box;
}

// The points of the surface, moved and scaled such that the longest side of their bounding box is 1.
inline std::vector<Eigen::Vector3d> unit_points(const Boundary_mesh_3& mesh)
{
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  std::vector<Eigen::Vector3d> points;
  for(const auto v : mesh.vertices())
    points.push_back(eigen_point(mesh, v));
  for(Eigen::Vector3d& point : points)
    point = (point - box.center()) / box.sizes().maxCoeff();
  return points;
}

inline void set_points(Boundary_mesh_3& mesh, const std::vector<Eigen::Vector3d>& points)
{
  for(const auto v : mesh.vertices())
    mesh.point(v) = Boundary_point_3(points[v][0], points[v][1], points[v][2]);
}

// Is the closed surface a topological sphere?
inline Error_code check_sphere(const Boundary_mesh_3& mesh)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  const auto component_map = boost::make_iterator_property_map(component.begin(), get(boost::face_index, mesh));
  if(Polygon_mesh_processing::connected_components(mesh, component_map) > 1)
    return ERROR_SEVERAL_BOUNDARY_COMPONENTS;
  if(mesh.number_of_vertices() + mesh.number_of_faces() != mesh.number_of_edges() + 2)
    return ERROR_BOUNDARY_NOT_OF_GENUS_ZERO;
  return OK;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_SURFACE_3_H
