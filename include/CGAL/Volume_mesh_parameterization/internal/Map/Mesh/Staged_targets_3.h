// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_STAGED_TARGETS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_STAGED_TARGETS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/alignment_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <map>

namespace CGAL::Volume_mesh_parameterization::internal {

// Targets on the way from the aligned source to those that are prescribed. Vertices at their targets that edges connect, or that
// move like one rigid body, are a handle. A handle turns about a fixed axis and moves along it; what is left of its displacements
// grows with both.
class Staged_targets_3
{
public:
  explicit Staged_targets_3(const Numbered_mesh_3& mesh) : m_mesh(mesh), m_start(moved(*mesh.alignment, mesh.source)),
      m_diagonal(bounding_box(*mesh.communicator, m_start).diagonal().norm())
  {
    Disjoint_sets sets(mesh.number_of_vertices());
    for(const std::array<int, 4>& cell : mesh.cells)
      for(const int v : cell)
        for(const int w : cell)
          if(v < w && mesh.is_fixed(v) && mesh.is_fixed(w))
            sets.unite(v, w);
    std::map<std::size_t, std::vector<int> > handles;
    for(const int v : fixed_vertices(mesh))
      handles[sets.find(v)].push_back(v);
    for(auto& [representative, vertices] : handles)
      add(handle(std::move(vertices)));
  }

  // Returns the number of stages that makes turns and moves of handles small.
  int number_of_stages() const
  {
    constexpr double small_angle = CGAL_PI / 12, small_move = 0.25; // guesses; the move by the diagonal of the body
    double result = 1;
    for(const Handle& handle : m_handles)
      result = (std::max)({ result, handle.turn.angle() / small_angle, handle.move.norm() / (small_move * m_diagonal) });
    constexpr double largest = 40; // a guess
    return static_cast<int>(std::ceil((std::min)(result, largest)));
  }

  // Returns the mesh with the targets of a part of the way.
  Numbered_mesh_3 mesh_at(const double part) const
  {
    Numbered_mesh_3 result = m_mesh;
    Matrix3Xd targets = m_mesh.target;
    for(int v = m_mesh.number_of_free_vertices; v < m_mesh.number_of_vertices(); ++v)
      targets.col(v) = m_start.col(v) + part * (m_mesh.target.col(v) - m_start.col(v));
    for(const Handle& handle : m_handles)
      for(const int v : handle.vertices)
      {
        const Eigen::Vector3d x = m_start.col(v) - handle.center, end = m_mesh.target.col(v) - handle.center - handle.move;
        targets.col(v) = handle.center_at(part) + Vector_3(handle.turned(part) * (x + part * (handle.turned(-1) * end - x)));
      }
    result.set_targets(std::move(targets), m_mesh.base_point);
    return result;
  }

private:
  struct Handle
  {
    std::vector<int> vertices;
    Vector_3 center, move;
    Eigen::AngleAxisd turn;
    double deviation; // from a rigid motion, at most

    Eigen::Matrix3d turned(const double part) const
    { return Eigen::AngleAxisd(part * turn.angle(), turn.axis()).toRotationMatrix(); }

    // Returns the center after a part of the way, along the chord of an arc.
    Vector_3 center_at(const double part) const
    {
      const double half = turn.angle() / 2;
      const Eigen::Vector3d axis = turn.axis(), along = axis.dot(Eigen::Vector3d(move)) * axis;
      const Eigen::Vector3d chord = Eigen::AngleAxisd((part - 1) * half, axis) * (Eigen::Vector3d(move) - along);
      return center + Vector_3(part * along + (half > 0 ? std::sin(part * half) / std::sin(half) : part) * chord);
    }
  };

  // Adds a handle, or extends one with which it moves like a rigid body.
  void add(Handle added)
  {
    const double small = 1e-4 * m_diagonal; // a guess
    for(Handle& other : m_handles)
      if(const Vector_3 way = added.center - other.center;
         std::abs((way + added.move - other.move).norm() - way.norm()) < small) // before all vertices are looked at
      {
        std::vector<int> vertices = other.vertices;
        vertices.insert(vertices.end(), added.vertices.begin(), added.vertices.end());
        if(Handle both = handle(std::move(vertices)); both.deviation < small)
        {
          other = std::move(both);
          return;
        }
      }
    m_handles.push_back(std::move(added));
  }

  Handle handle(std::vector<int> vertices) const
  {
    Matrix3Xd start(3, vertices.size()), end(3, vertices.size());
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      start.col(i) = m_start.col(vertices[i]);
      end.col(i) = m_mesh.target.col(vertices[i]);
    }
    const Similarity_3 motion = similarity_of_points_3(start, end, 1., 1e-9); // the least turn, of points on a line
    return { std::move(vertices), motion.source_center, motion.image_center - motion.source_center,
             Eigen::AngleAxisd(Eigen::Matrix3d(motion.rotation)), (moved(motion, start) - end).colwise().norm().maxCoeff() };
  }

  const Numbered_mesh_3& m_mesh;
  Matrix3Xd m_start;
  double m_diagonal;
  std::vector<Handle> m_handles;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_STAGED_TARGETS_3_H
