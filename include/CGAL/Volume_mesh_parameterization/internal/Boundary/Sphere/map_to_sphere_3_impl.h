// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Radial_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_sphere_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

namespace CGAL::Volume_mesh_parameterization::internal {

struct Unit_sphere_3
{
  static constexpr double curvature = 1; // the curvature of the unit sphere

  Small_matrix<3, 2> tangents(const Vector_3& image) const
  {
    Small_matrix<3, 2> result;
    result.col(0) = Eigen::Vector3d(image).unitOrthogonal();
    result.col(1) = Eigen::Vector3d(image.cross(result.col(0)));
    return result;
  }

  Vector_3 move(const Vector_3& image, const Vector_3& step) const { return (image + step).normalized(); }

  double height(const Vector_3&, const Vector_3&, const Vector_3&) const { return 1; }
  double area() const { return 4 * CGAL_PI; }
};

// Maps a triangulated topological sphere onto the unit sphere, one to one, by the method of Praun and Hoppe, Spherical
// parametrization and remeshing (2003): the surface is coarsened to a tetrahedron, which is easy to map; then the vertices
// come back, each inside the kernel of its ring, and the map is relaxed level by level.
template <typename Domain = Unit_sphere_3> // compiled only where it is used
class Spherical_map_3
{
public:
  Spherical_map_3(const std::vector<Vector_3>& points, const Vertex_rings_3& rings, const Budget& budget)
    : m_points(points), m_rings(rings), m_budget(budget), m_images(points.size(), Vector_3::Zero()),
      m_map(m_rings, m_points, m_images, m_domain, budget)
  {}

  // Returns whether each vertex is mapped, which can fail only by the limits of floating-point numbers or of time.
  bool run()
  {
    const std::vector<std::vector<Removed_vertex> > levels = coarsen_surface_3(m_rings, m_points, m_budget);
    if(m_budget.is_exhausted())
      return false;
    map_tetrahedron();
    for(auto level = levels.rbegin(); level != levels.rend(); ++level)
    {
      for(auto removed = level->rbegin(); removed != level->rend(); ++removed)
        if(m_budget.is_exhausted() || !insert(*removed))
          return false;
      m_map.relax(8, 1e-2);
    }
    m_map.relax(100, 1e-4);
    return true;
  }

  const std::vector<Vector_3>& images() const { return m_images; }

private:
  void map_tetrahedron()
  {
    int v = 0;
    while(m_rings[v].empty())
      ++v;
    m_images[v] = Vector_3(1, 1, 1).normalized();
    m_images[m_rings[v][0]] = Vector_3(1, -1, -1).normalized();
    m_images[m_rings[v][1]] = Vector_3(-1, 1, -1).normalized();
    m_images[m_rings[v][2]] = Vector_3(-1, -1, 1).normalized();
    m_map.relax(20, 1e-3);
  }

  // Inserts a vertex near the one that it was collapsed onto: this one sees the whole ring, and so do close points inside.
  bool insert(const Removed_vertex& removed)
  {
    m_rings.insert(removed);
    const Vector_3 origin = m_images[removed.ring.front()];
    const Vector_3 inwards = (origin.cross(m_images[removed.ring[1]]).normalized()
                                   + m_images[removed.ring.back()].cross(origin).normalized()).normalized();
    double smallest = (std::numeric_limits<double>::infinity)();
    Vector_3 best = origin;
    for(double step = 1; step > 1e-15; step /= 2)
    {
      m_images[removed.vertex] = (origin + step * inwards).normalized();
      if(!m_map.is_admissible(removed.vertex, m_images[removed.vertex]))
        continue;
      const double distortion = m_map.distortion_around(removed.vertex);
      if(distortion >= smallest)
        break;
      smallest = distortion;
      best = m_images[removed.vertex];
    }
    m_images[removed.vertex] = best;
    if(!m_map.is_admissible(removed.vertex, best))
      return false;
    m_map.relax(removed.vertex);
    for(const int w : removed.ring)
      m_map.relax(w);
    m_map.relax(removed.vertex);
    return true;
  }

  const std::vector<Vector_3>& m_points;
  Vertex_rings_3 m_rings;
  const Budget& m_budget;
  std::vector<Vector_3> m_images;
  Unit_sphere_3 m_domain;
  Radial_map_3<Domain> m_map;
};

template <typename Mesh>
Error_code map_mesh_to_sphere_3(const Mesh& mesh, std::vector<Vector_3>& images, const Budget& budget)
{
  const Error_code status = check_sphere(mesh);
  if(status != OK)
    return status;

  const std::vector<Vector_3> points = unit_points(mesh);
  Spherical_map_3<> map(points, Vertex_rings_3(mesh), budget);
  if(!map.run())
    return ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
  images = map.images();
  return is_radially_bijective_3(mesh, images) ? OK : ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
}

// Turns the sphere such that its points come as close as possible to the landmarks, in the sense of least squares: Kabsch,
// A solution for the best rotation to relate two sets of vectors (1976).
template <typename Points>
void turn_to_landmarks_3(const Points& landmarks, std::vector<Vector_3>& images)
{
  Matrix_3 covariance = Matrix_3::Zero();
  for(const auto& [v, point] : landmarks)
    covariance += Matrix_3::outer_product(point, images[v]);
  const Matrix_3 rotation = rotation_and_stretch_3(covariance).rotation;
  for(Vector_3& image : images)
    image = (rotation * image).normalized();
}

template <typename Surface>
Error_code map_to_sphere_3(const Surface& surface, const Landmarks_3& landmarks, std::vector<Vector_3>& images,
                           const Budget& budget)
{
  std::vector<std::pair<int, Vector_3> > on_surface;
  for(const auto& [v, point] : landmarks)
  {
    const auto found = std::find(surface.vertices.begin(), surface.vertices.end(), v);
    if(found == surface.vertices.end() || !point.allFinite())
      return ERROR_INVALID_LANDMARK;
    on_surface.emplace_back(static_cast<int>(found - surface.vertices.begin()), point);
  }
  Boundary_mesh_3 mesh;
  Error_code status = build_boundary_mesh_3(surface, mesh);
  if(status == OK)
    status = map_mesh_to_sphere_3(mesh, images, budget);
  if(status != OK || landmarks.empty())
    return status;
  turn_to_landmarks_3(on_surface, images);
  return is_radially_bijective_3(mesh, images) ? OK : ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_IMPL_H
