// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_RADIAL_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_RADIAL_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/coarsen_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/eigen_decomposition_2.h>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns POSITIVE if the triangle is counterclockwise as seen from outside, the origin being inside; decided exactly.
inline Orientation radial_orientation(const Vector_3& a, const Vector_3& b, const Vector_3& c)
{
  return CGAL::orientation(Boundary_point_3(0, 0, 0), exact_point(a), exact_point(b), exact_point(c));
}

// Returns whether the central projection of the image onto a sphere is one to one. If all triangles are positive, the
// projection covers the sphere everywhere equally often, and a count in one direction suffices.
inline bool is_radially_bijective_3(const Boundary_mesh_3& mesh, const std::vector<Vector_3>& images)
{
  std::vector<std::array<Vector_3, 3> > triangles;
  for(const auto f : mesh.faces())
  {
    const auto [a, b, c] = vertices_of_face(mesh, f);
    triangles.push_back({ images[a], images[b], images[c] });
  }
  const Vector_3 direction = triangles[0][0] + triangles[0][1] + triangles[0][2];
  const auto is_in_direction = [&](const std::array<Vector_3, 3>& t)
  {
    return radial_orientation(t[0], t[1], direction) != NEGATIVE
           && radial_orientation(t[1], t[2], direction) != NEGATIVE
           && radial_orientation(t[2], t[0], direction) != NEGATIVE;
  };
  const auto is_positive = [](const std::array<Vector_3, 3>& t)
  { return radial_orientation(t[0], t[1], t[2]) == POSITIVE; };
  return std::all_of(triangles.begin(), triangles.end(), is_positive)
         && std::count_if(triangles.begin(), triangles.end(), is_in_direction) == 1;
}

// Distortion of a triangle whose image a, b, c is seen from the origin, as a function of a: f = Q (1 + 1 / D^2), with the
// Dirichlet energy Q of the map of the triangle, and D = det(a, b, c) / (2 weight). If the weight is the area of the source
// times the distance of the image from the origin, D is the ratio of the areas, and f the symmetric Dirichlet energy times
// the area. A triangle whose plane contains the origin has infinite distortion.
class Radial_distortion_3
{
public:
  // Takes the area of the source pqr times `scale` as the weight.
  Radial_distortion_3(const Vector_3& p, const Vector_3& q, const Vector_3& r, const double scale,
                      const Vector_3& b, const Vector_3& c)
    : m_b(b), m_c(c)
  {
    double pq = (q - p).squaredNorm(), qr = (r - q).squaredNorm(), rp = (p - r).squaredNorm();
    const double regular = 1e-6 * (pq + qr + rp); // gives a flat triangle a positive area; the size is a guess
    pq += regular;
    qr += regular;
    rp += regular;
    const double square = 2 * (pq * qr + qr * rp + rp * pq) - (pq * pq + qr * qr + rp * rp); // 16 area^2
    const double area = std::sqrt(square) / 4;
    m_constant = (pq + rp - qr) / (8 * area) * (b - c).squaredNorm();
    m_cotangent_b = (pq + qr - rp) / (4 * area);
    m_cotangent_c = (qr + rp - pq) / (4 * area);
    m_normal = b.cross(c) / (2 * scale * area);
  }

  double value(const Vector_3& a) const
  {
    const double d = a.dot(m_normal);
    return (d > 0) ? dirichlet(a) * (1 + 1 / (d * d)) : (std::numeric_limits<double>::infinity)();
  }

  void add_derivatives(const Vector_3& a, Vector_3& gradient, Matrix_3& hessian) const
  {
    const double d = 1 / a.dot(m_normal);
    const double q = dirichlet(a);
    const Vector_3 q_gradient = m_cotangent_b * (a - m_c) + m_cotangent_c * (a - m_b);
    const Matrix_3 mixed = Matrix_3::outer_product(q_gradient, m_normal);
    gradient += (1 + d * d) * q_gradient - 2 * q * d * d * d * m_normal;
    hessian += (1 + d * d) * (m_cotangent_b + m_cotangent_c) * Matrix_3::Identity()
             - 2 * d * d * d * (mixed + mixed.transpose())
             + Matrix_3::outer_product(6 * q * d * d * d * d * m_normal, m_normal);
  }

private:
  double dirichlet(const Vector_3& a) const
  { return m_constant + ((m_cotangent_b * (a - m_c).squaredNorm()) + m_cotangent_c * (a - m_b).squaredNorm()) / 2; }

  Vector_3 m_b, m_c, m_normal;
  double m_constant, m_cotangent_b, m_cotangent_c;
};

// Map of a surface onto a surface around the origin, such that the image of each triangle is seen from inside.
//
// A `Domain` determines where the image of a vertex may move:
//   Small_matrix<3, 2> tangents(const Vector_3& image) const;   // columns may be zero
//   Vector_3 move(const Vector_3& image, const Vector_3& tangential_step) const;
//   static constexpr double curvature;
//   double height(const Vector_3& a, const Vector_3& b, const Vector_3& c) const;   // the distance
//     from the origin of the tangent plane at these images of vertices
//   double area() const;
template <typename Domain>
class Radial_map_3
{
public:
  using Points = std::vector<Vector_3>;

  Radial_map_3(const Vertex_rings_3& rings, const Points& points, Points& images, const Domain& domain,
               const Budget& budget)
    : m_rings(rings), m_points(points), m_images(images), m_domain(domain), m_budget(budget)
  {}

  // Scales the surface, as coarse as it is, to the area of the domain, and relaxes all vertices, several times.
  void relax(const int number_of_sweeps, const double tolerance)
  {
    fit_area_scale();
    for(int sweep = 0; sweep < number_of_sweeps && m_budget.may_begin_round(Phase::BOUNDARY, "relaxation of a sphere"); ++sweep)
      if(relax_all() < tolerance)
        break;
  }

  // Returns whether all triangles around v are positive, as seen from the origin, with this image of v.
  bool is_admissible(const int v, const Vector_3& image) const
  {
    const std::vector<int>& ring = m_rings[v];
    for(std::size_t i = 0; i < ring.size(); ++i)
      if(radial_orientation(image, m_images[ring[i]], m_images[ring[(i + 1) % ring.size()]]) != POSITIVE)
        return false;
    return true;
  }

  // Moves the image of v along a Newton step for the distortion of its triangles. Returns by how much the distortion falls.
  double relax(const int v)
  {
    collect_triangles(v);
    const Vector_3 image = m_images[v];
    const double before = distortion(image);
    const Vector_3 step = newton_step(image);
    for(double length = 1; length > 1e-4; length /= 2)
    {
      const Vector_3 candidate = m_domain.move(image, length * step);
      const double after = distortion(candidate);
      if(after < before && is_admissible(v, candidate))
      {
        m_images[v] = candidate;
        return before - after;
      }
    }
    return 0;
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

  void fit_area_scale()
  {
    double area = 0;
    for(int v = 0; v < m_rings.number_of_vertices(); ++v)
      for_each_triangle(v, [&](const int b, const int c) // each vertex has a third of a triangle
      { area += (m_points[b] - m_points[v]).cross(m_points[c] - m_points[v]).norm() / 6; });
    m_area_scale = m_domain.area() / area;
  }

  // Relaxes each vertex once. Returns by how much the mean distortion falls, which is 4 for an isometry.
  double relax_all()
  {
    double decrease = 0;
    for(int v = 0; v < m_rings.number_of_vertices(); ++v)
      if(!m_rings[v].empty() && !m_budget.is_exhausted())
        decrease += relax(v);
    return decrease / m_domain.area();
  }

  void collect_triangles(const int v)
  {
    m_triangles.clear();
    for_each_triangle(v, [&](const int b, const int c)
    {
      const double height = m_domain.height(m_images[v], m_images[b], m_images[c]);
      m_triangles.emplace_back(m_points[v], m_points[b], m_points[c], m_area_scale * height, m_images[b], m_images[c]);
    });
  }

  double distortion(const Vector_3& image) const
  {
    double sum = 0;
    for(const Radial_distortion_3& triangle : m_triangles)
      sum += triangle.value(image);
    return sum;
  }

  // Returns a direction of descent: the Hessian has the absolute values of its eigenvalues.
  Vector_3 newton_step(const Vector_3& image) const
  {
    Vector_3 gradient = Vector_3::Zero();
    Matrix_3 hessian = Matrix_3::Zero();
    for(const Radial_distortion_3& triangle : m_triangles)
      triangle.add_derivatives(image, gradient, hessian);

    const Small_matrix<3, 2> tangents = m_domain.tangents(image);
    Small_matrix<2, 2> tangential = tangents.transpose() * Eigen::Matrix3d(hessian) * tangents;
    tangential -= Domain::curvature * image.dot(gradient) * Small_matrix<2, 2>::Identity();
    const auto [eigenvalues, eigenvectors] = eigen_decomposition_2(tangential);
    const double smallest = 1e-8 * eigenvalues.cwiseAbs().maxCoeff();
    const Small_matrix<2, 1> slope = eigenvectors.transpose() * (tangents.transpose() * Eigen::Vector3d(gradient));
    Small_matrix<2, 1> step;
    for(int i = 0; i < 2; ++i)
      step[i] = (slope[i] == 0) ? 0 : -slope[i] / (std::max)(std::abs(eigenvalues[i]), smallest);
    return tangents * (eigenvectors * step);
  }

  const Vertex_rings_3& m_rings;
  const Points& m_points;
  Points& m_images;
  const Domain& m_domain;
  const Budget& m_budget;
  double m_area_scale = 1;
  std::vector<Radial_distortion_3> m_triangles; // triangles around the vertex in work
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_RADIAL_MAP_3_H
