// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_RADIAL_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_RADIAL_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Radial_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/is_radially_bijective_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Vertex_rings_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// A map of a surface onto a surface around the origin, which sees the image of each triangle from inside.
//
// A `Domain` tells where the image of a vertex may move:
//   Eigen::Matrix<double, 3, 2> tangents(int v, const Eigen::Vector3d& image) const;   // columns may be zero
//   Eigen::Vector3d move(const Eigen::Vector3d& image, const Eigen::Vector3d& tangential_step) const;
//   static constexpr double curvature;
//   double height(int a, int b, int c) const;   // the distance of the tangent plane at these vertices from the origin
//   double area() const;
template <typename Domain>
class Radial_map_3
{
public:
  using Points = std::vector<Eigen::Vector3d>;

  Radial_map_3(const Vertex_rings_3& rings, const Points& points, Points& images, const Domain& domain,
               const Budget& budget)
    : m_rings(rings), m_points(points), m_images(images), m_domain(domain), m_budget(budget)
  {}

  // Scales the surface, as coarse as it is, to the area of the domain.
  void fit_area_scale()
  {
    double area = 0;
    for(int v = 0; v < m_rings.number_of_vertices(); ++v)
      for_each_triangle(v, [&](const int b, const int c)
      {
        area += (m_points[b] - m_points[v]).cross(m_points[c] - m_points[v]).norm() / 6; // a third for each vertex
      });
    m_area_scale = m_domain.area() / area;
  }

  // Would all triangles around v be seen positive with this image of v?
  bool is_admissible(const int v, const Eigen::Vector3d& image) const
  {
    const std::vector<int>& ring = m_rings[v];
    for(std::size_t i = 0; i < ring.size(); ++i)
      if(radial_orientation(image, m_images[ring[i]], m_images[ring[(i + 1) % ring.size()]]) != POSITIVE)
        return false;
    return true;
  }

  // Moves the image of v along a Newton step for the distortion of its triangles.
  // Returns by how much the distortion falls.
  double relax(const int v)
  {
    collect_triangles(v);
    const Eigen::Vector3d image = m_images[v];
    const double before = distortion(image);
    const Eigen::Vector3d step = newton_step(v, image);
    for(double length = 1; length > 1e-4; length /= 2)
    {
      const Eigen::Vector3d candidate = m_domain.move(image, length * step);
      const double after = distortion(candidate);
      if(after < before && is_admissible(v, candidate))
      {
        m_images[v] = candidate;
        return before - after;
      }
    }
    return 0;
  }

  // Relaxes each vertex once. Returns by how much the mean distortion falls, which is 4 for an isometry.
  double relax()
  {
    double decrease = 0;
    for(int v = 0; v < m_rings.number_of_vertices() && !m_budget.is_exhausted(); ++v)
      if(!m_rings[v].empty())
        decrease += relax(v);
    return decrease / m_domain.area();
  }

  double distortion_around(const int v)
  {
    collect_triangles(v);
    return distortion(m_images[v]);
  }

private:
  template <typename Function>
  void for_each_triangle(const int v, const Function& function) const
  {
    const std::vector<int>& ring = m_rings[v];
    for(std::size_t i = 0; i < ring.size(); ++i)
      function(ring[i], ring[(i + 1) % ring.size()]);
  }

  void collect_triangles(const int v)
  {
    m_triangles.clear();
    for_each_triangle(v, [&](const int b, const int c)
    {
      m_triangles.emplace_back(m_points[v], m_points[b], m_points[c], m_area_scale * m_domain.height(v, b, c),
                               m_images[b], m_images[c]);
    });
  }

  double distortion(const Eigen::Vector3d& image) const
  {
    double sum = 0;
    for(const Radial_distortion_3& triangle : m_triangles)
      sum += triangle.value(image);
    return sum;
  }

  // The absolute values of the eigenvalues of the Hessian make it a direction of descent.
  Eigen::Vector3d newton_step(const int v, const Eigen::Vector3d& image) const
  {
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    for(const Radial_distortion_3& triangle : m_triangles)
      triangle.add_derivatives(image, gradient, hessian);

    const Eigen::Matrix<double, 3, 2> tangents = m_domain.tangents(v, image);
    Eigen::Matrix2d tangential = tangents.transpose() * hessian * tangents;
    tangential -= Domain::curvature * image.dot(gradient) * Eigen::Matrix2d::Identity();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(tangential);
    const double smallest = 1e-8 * eigen.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::Vector2d slope = eigen.eigenvectors().transpose() * (tangents.transpose() * gradient);
    Eigen::Vector2d step;
    for(int i = 0; i < 2; ++i)
      step[i] = (slope[i] == 0) ? 0 : -slope[i] / (std::max)(std::abs(eigen.eigenvalues()[i]), smallest);
    return tangents * (eigen.eigenvectors() * step);
  }

  const Vertex_rings_3& m_rings;
  const Points& m_points;
  Points& m_images;
  const Domain& m_domain;
  const Budget& m_budget;
  double m_area_scale = 1;
  std::vector<Radial_distortion_3> m_triangles; // around the vertex in work
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_RADIAL_MAP_3_H
