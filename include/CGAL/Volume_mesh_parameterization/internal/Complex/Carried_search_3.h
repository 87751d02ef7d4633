// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_CARRIED_SEARCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_CARRIED_SEARCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Inserted_vertex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Numbered_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Engine/engine.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Map_search_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/plan_refinement_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// What is carried over a refinement of a complex, from one search to the next. A search that goes on has the images of all
// vertices.
template <typename C3t3>
class Carried_search_3
{
public:
  using Vertex_handle = typename C3t3::Vertex_handle;

  Carried_search_3() = default;

  // New vertices are midpoints in the image, too.
  Carried_search_3(const Numbered_complex_3<C3t3>& complex, const Eigen::Matrix3Xd& image,
                   const std::vector<Inserted_vertex_3<Vertex_handle> >& inserted, const Refinement_plan_3& plan)
    : m_approach(plan.approach), m_untangling(plan.untangling)
  {
    if(!m_approach.goes_on && !m_untangling.goes_on)
      return;
    for(std::size_t v = 0; v < complex.vertices().size(); ++v)
      m_images[complex.vertices()[v]] = image.col(v);
    for(const Inserted_vertex_3<Vertex_handle>& i : inserted)
      m_images[i.vertex] = (m_images.at(i.simplex[0]) + m_images.at(i.simplex[1])) / 2;
  }

  const Blocked_approach_3& blocked() const { return m_approach; }

  // Which edges to split after a search that was stuck or blocked.
  Refinement_plan_3 plan(const Numbered_mesh_3& mesh, const Found_map_3& found) const
  {
    return found.is_stuck ? plan_splits_3(mesh, found, m_untangling)
                          : plan_refinement_3(mesh, found, m_approach, m_untangling);
  }

  // Where the next search untangles. After it has given up to split cells that are left inverted, the soft boundary follows.
  Untangling_start_3 untangling_start(const Numbered_complex_3<C3t3>& complex, const bool may_split) const
  {
    Untangling_start_3 result;
    if(may_split && !m_untangling.has_given_up)
      result.most_inverted_cells_to_split = most_exceptions(complex.mesh().number_of_all_cells());
    if(m_untangling.goes_on)
      result.positions = positions(complex);
    return result;
  }

  // Where the next search approaches the boundary, in the order of the refined complex. If rounding at a new vertex has
  // spoilt the images, the approach does not go on.
  Approach_start_3 approach_start(const Numbered_complex_3<C3t3>& complex, const std::size_t patience)
  {
    Approach_start_3 result;
    result.patience = patience;
    if(!m_approach.goes_on)
      return result;
    const Eigen::Matrix3Xd images = positions(complex);
    m_approach.goes_on = engine::is_valid(complex.mesh(), images);
    if(m_approach.goes_on)
    {
      result.positions = images;
      result.number_of_raises = m_approach.number_of_raises;
    }
    return result;
  }

private:
  Eigen::Matrix3Xd positions(const Numbered_complex_3<C3t3>& complex) const
  {
    Eigen::Matrix3Xd result(3, complex.vertices().size());
    for(std::size_t v = 0; v < complex.vertices().size(); ++v)
      result.col(v) = m_images.at(complex.vertices()[v]);
    return result;
  }

  Blocked_approach_3 m_approach;
  Stuck_untangling_3 m_untangling;
  std::unordered_map<Vertex_handle, Eigen::Vector3d> m_images;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_CARRIED_SEARCH_3_H
