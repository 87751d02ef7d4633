// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_APPROACH_OF_COMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_APPROACH_OF_COMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Inserted_vertex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Numbered_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Engine/engine.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Map_options_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/plan_refinement_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// What is carried over a refinement of a complex, from one attempt to the next: an approach of the boundary that goes on
// has the images of all vertices.
template <typename C3t3>
class Approach_of_complex_3
{
public:
  using Vertex_handle = typename C3t3::Vertex_handle;

  Approach_of_complex_3() = default;

  // New vertices are midpoints in the image, too.
  Approach_of_complex_3(const Numbered_complex_3<C3t3>& complex, const Eigen::Matrix3Xd& image,
                        const std::vector<Inserted_vertex_3<Vertex_handle> >& inserted,
                        const Blocked_approach_3& approach)
    : m_approach(approach)
  {
    if(!approach.goes_on)
      return;
    for(std::size_t v = 0; v < complex.vertices().size(); ++v)
      m_images[complex.vertices()[v]] = image.col(v);
    for(const Inserted_vertex_3<Vertex_handle>& i : inserted)
      m_images[i.vertex] = (m_images.at(i.simplex[0]) + m_images.at(i.simplex[1])) / 2;
  }

  const Blocked_approach_3& blocked() const { return m_approach; }

  // Where the next search starts, in the order of the refined complex. If rounding at a new vertex has spoilt the images,
  // the approach does not go on.
  Approach_start_3 start(const Numbered_complex_3<C3t3>& complex, const std::size_t patience)
  {
    Approach_start_3 result;
    result.patience = patience;
    if(!m_approach.goes_on)
      return result;
    Eigen::Matrix3Xd positions(3, complex.vertices().size());
    for(std::size_t v = 0; v < complex.vertices().size(); ++v)
      positions.col(v) = m_images.at(complex.vertices()[v]);
    m_approach.goes_on = engine::is_valid(complex.mesh(), positions);
    if(m_approach.goes_on)
    {
      result.positions = positions;
      result.number_of_raises = m_approach.number_of_raises;
    }
    return result;
  }

private:
  Blocked_approach_3 m_approach;
  std::unordered_map<Vertex_handle, Eigen::Vector3d> m_images;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_APPROACH_OF_COMPLEX_3_H
