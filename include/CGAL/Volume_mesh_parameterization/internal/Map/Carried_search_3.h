// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_CARRIED_SEARCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_CARRIED_SEARCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/plan_refinement_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// What is carried over a refinement, from one search to the next. A search that goes on has the images of all points.
class Carried_search_3
{
public:
  Carried_search_3() = default;

  // New points are midpoints in the image, too.
  Carried_search_3(const Numbered_body_3& body, const Matrix3Xd& image, const std::vector<Insertion_3>& insertions,
                   const Refinement_plan_3& plan)
    : m_approach(plan.approach), m_untangling(plan.untangling)
  {
    if(!m_approach.goes_on && !m_untangling.goes_on)
      return;
    m_images.resize(3, body.vertices.size() + insertions.size());
    for(std::size_t v = 0; v < body.points.size(); ++v)
      m_images.col(body.points[v]) = image.col(v);
    for(const Insertion_3& i : insertions)
      m_images.col(i.point) = (m_images.col(i.simplex[0]) + m_images.col(i.simplex[1])) / 2;
  }

  const Blocked_approach_3& blocked() const { return m_approach; }

  // Which edges to split after a search that was stuck or blocked.
  Refinement_plan_3 plan(const Numbered_mesh_3& mesh, const Found_map_3& found) const
  {
    return found.is_stuck ? plan_splits_3(mesh, found, m_untangling)
                          : plan_refinement_3(mesh, found, m_approach, m_untangling);
  }

  // Where the next search untangles. Once it gives up to split cells that are left inverted, the soft boundary follows.
  Untangling_start_3 untangling_start(const Numbered_body_3& body, const bool may_split) const
  {
    Untangling_start_3 result;
    if(may_split && !m_untangling.has_given_up)
      result.most_inverted_cells_to_split = most_exceptions(body.mesh.global_number_of_cells());
    if(m_untangling.goes_on)
      result.positions = positions(body);
    return result;
  }

  // Where the next search approaches the boundary, in the order of the refined mesh. If rounding at a new point has
  // spoilt the images, the approach does not go on.
  Approach_start_3 approach_start(const Numbered_body_3& body, const std::size_t patience)
  {
    Approach_start_3 result;
    result.patience = patience;
    if(!m_approach.goes_on)
      return result;
    const Matrix3Xd images = positions(body);
    m_approach.goes_on = inverted_cells(body.mesh, images).number == 0;
    if(m_approach.goes_on)
    {
      result.positions = images;
      result.number_of_raises = m_approach.number_of_raises;
    }
    return result;
  }

private:
  Matrix3Xd positions(const Numbered_body_3& body) const
  {
    Matrix3Xd result(3, body.points.size());
    for(std::size_t v = 0; v < body.points.size(); ++v)
      result.col(v) = m_images.col(body.points[v]);
    return result;
  }

  Blocked_approach_3 m_approach;
  Stuck_untangling_3 m_untangling;
  Matrix3Xd m_images; // of the points
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_CARRIED_SEARCH_3_H
