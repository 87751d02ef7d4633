// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_BOX_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_BOX_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/Box_boundary_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/Cube_edge_router_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Radial_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/map_patch_to_polygon_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a triangulated topological sphere, of which an image on the unit sphere is known, onto the boundary of a box:
// twelve paths on the surface become the edges of the box, and the patches between them its faces.
// Lengths on the sphere guide the paths and the first map of the patches, since they are tame where
// the surface has long thin parts. The last step lowers the distortion of the map from the surface itself.
class Box_map_3
{
public:
  Box_map_3(const Boundary_mesh_3& mesh, const std::vector<Eigen::Vector3d>& sphere_images,
            const Eigen::Vector3d& half_lengths, const Budget& budget)
    : m_budget(budget), m_mesh(mesh), m_rings(mesh), m_points(unit_points(mesh)), m_sphere(sphere_images),
      m_images(sphere_images.size(), Eigen::Vector3d::Zero()), m_domain(sphere_images.size(), half_lengths)
  {
    set_points(m_mesh, m_sphere);
  }

  Error_code run(const std::array<int, 8>& corners)
  {
    Cube_edge_router_3 router(m_rings, m_sphere, corners, m_budget);
    if(!router.run())
      return Cube_edge_router_3(m_rings, m_sphere, mirrored(corners), m_budget).run() ? ERROR_MIRRORED_CORNERS
                                                                                      : ERROR_BOUNDARY_TOO_COARSE;
    place_corners(corners);
    for(std::size_t i = 0; i < 12; ++i)
      place_path(router.edge(i), router.path(i));
    if(!map_patches(router))
      return ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
    relax();
    return is_radially_bijective_3(m_mesh, m_images) ? OK : ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
  }

  const std::vector<Eigen::Vector3d>& images() const { return m_images; }

private:
  static std::array<int, 8> mirrored(std::array<int, 8> corners)
  {
    for(std::size_t k = 0; k < 8; k += 2)
      std::swap(corners[k], corners[k + 1]);
    return corners;
  }

  void place_corners(const std::array<int, 8>& corners)
  {
    for(int k = 0; k < 8; ++k)
    {
      for(int axis = 0; axis < 3; ++axis)
        m_domain.sides(corners[k])[axis] = side_of_corner(k, axis);
      m_images[corners[k]] = m_domain.on_sides(corners[k], Eigen::Vector3d::Zero());
    }
  }

  // Spaces the vertices of a path on the edge by their distances on the sphere.
  void place_path(const Cube_edge_3& edge, const std::vector<int>& path)
  {
    std::vector<double> length(1, 0.);
    for(std::size_t i = 1; i < path.size(); ++i)
      length.push_back(length.back() + (m_sphere[path[i]] - m_sphere[path[i - 1]]).norm());
    for(std::size_t i = 1; i + 1 < path.size(); ++i)
    {
      for(int axis = 0; axis < 3; ++axis)
        m_domain.sides(path[i])[axis] = (axis == edge.axis) ? 0 : side_of_corner(edge.corner, axis);
      Eigen::Vector3d image = Eigen::Vector3d::Zero();
      image[edge.axis] = (2 * length[i] / length.back() - 1) * m_domain.half_lengths()[edge.axis];
      m_images[path[i]] = m_domain.on_sides(path[i], image);
    }
  }

  bool map_patches(const Cube_edge_router_3& router)
  {
    std::vector<std::size_t> patch_of_face(m_mesh.number_of_faces());
    const std::size_t number_of_patches = find_patches(router, patch_of_face);
    for(std::size_t patch = 0; patch < number_of_patches; ++patch)
      if(m_budget.is_exhausted() || !map_patch(extract_patch(m_mesh, patch_of_face, patch)))
        return false;
    return true;
  }

  std::size_t find_patches(const Cube_edge_router_3& router, std::vector<std::size_t>& patch_of_face)
  {
    auto is_on_path = m_mesh.add_property_map<Boundary_mesh_3::Edge_index, bool>("e:is_on_path", false).first;
    for(std::size_t i = 0; i < 12; ++i)
      for(std::size_t k = 1; k < router.path(i).size(); ++k)
      {
        const Boundary_mesh_3::Vertex_index v(router.path(i)[k - 1]), w(router.path(i)[k]);
        is_on_path[m_mesh.edge(m_mesh.halfedge(v, w))] = true;
      }
    return Polygon_mesh_processing::connected_components(
      m_mesh, boost::make_iterator_property_map(patch_of_face.begin(), get(boost::face_index, m_mesh)),
      parameters::edge_is_constrained_map(is_on_path));
  }

  bool map_patch(const Surface_patch_3& patch)
  {
    const Box_boundary_3::Sides sides = common_sides(patch.vertices);
    if(std::count(sides.begin(), sides.end(), 0) != 2)
      return false;
    for(const int v : patch.vertices)
      if(!m_domain.is_placed(v))
      {
        m_domain.sides(v) = sides;
        m_images[v] = m_domain.on_sides(v, m_images[v]);
      }
    const int axis = (sides[0] != 0) ? 0 : (sides[1] != 0) ? 1 : 2;
    return map_patch_to_polygon_3(patch, (axis + 1) % 3, (axis + 2) % 3, m_images);
  }

  // Those of a face of the box, for the vertices on the border of a patch.
  Box_boundary_3::Sides common_sides(const std::vector<int>& vertices) const
  {
    std::array<bool, 3> is_common = {true, true, true};
    Box_boundary_3::Sides result = {};
    for(const int v : vertices)
      if(m_domain.is_placed(v))
        for(int axis = 0; axis < 3; ++axis)
        {
          const int side = m_domain.sides(v)[axis];
          is_common[axis] = is_common[axis] && side != 0 && result[axis] * side >= 0;
          result[axis] = is_common[axis] ? side : 0;
        }
    return result;
  }

  void relax()
  {
    Radial_map_3<Box_boundary_3> map(m_rings, m_points, m_images, m_domain, m_budget);
    map.fit_area_scale();
    for(int sweep = 0; sweep < 100; ++sweep)
      if(map.relax() < 1e-4)
        break;
  }

  const Budget& m_budget;
  Boundary_mesh_3 m_mesh; // with the images on the sphere as points
  const Vertex_rings_3 m_rings;
  const std::vector<Eigen::Vector3d> m_points;
  const std::vector<Eigen::Vector3d>& m_sphere;
  std::vector<Eigen::Vector3d> m_images;
  Box_boundary_3 m_domain;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_BOX_MAP_3_H
