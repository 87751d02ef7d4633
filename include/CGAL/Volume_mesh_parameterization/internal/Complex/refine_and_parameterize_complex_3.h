// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_REFINE_AND_PARAMETERIZE_COMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_REFINE_AND_PARAMETERIZE_COMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Complex/Numbered_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/parameterize_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Simplex_removal_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/plan_refinement_3.h>

#include <CGAL/iterator.h>

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
      result.most_inverted_cells_to_split = most_exceptions(complex.mesh().global_number_of_cells());
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
    m_approach.goes_on = inverted_cells(complex.mesh(), images).number == 0;
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

// Inserts vertices into the simplices that the boundary map makes degenerate whatever the map is; returns their number.
template <typename C3t3, typename VertexIsConstrainedMap, typename BoundaryMap>
std::size_t remove_degenerate_simplices(C3t3& c3t3, const VertexIsConstrainedMap is_constrained, const BoundaryMap target,
                                        const Budget& budget)
{
  const Boundary_facets<C3t3> boundary(c3t3);
  const Degenerate_simplices_3<typename C3t3::Vertex_handle, BoundaryMap> is_bad(c3t3, boundary, is_constrained, target);
  return Simplex_removal_3(c3t3, is_bad).run(Emptyset_iterator(), budget);
}

// From a complex to the images of its vertices: refines the complex where the boundary map makes cells degenerate, and
// then where a search was blocked, and searches again. More new vertices than a tenth would mean that this does not help;
// a small complex may need many in proportion. What limits of time leave undone is refined no more.
template <typename C3t3, typename Problem, typename VertexUVWMap>
Parameterization_result refine_and_parameterize_complex_3(C3t3& c3t3, const Problem& problem, VertexUVWMap uvw_map)
{
  const Budget& budget = problem.progress.budget();
  std::size_t number_of_removals = 0, number_of_splits = 0;
  Carried_search_3<C3t3> carried;
  for(bool is_first = true; ; is_first = false)
  {
    const Checked_complex_3<Numbered_complex_3<C3t3> > complex(c3t3, problem);
    if(is_first && complex.check.allows_soft_boundary() && complex.check.is_refinable)
    {
      number_of_removals = remove_degenerate_simplices(c3t3, problem.is_constrained, problem.target, budget);
      if(number_of_removals > 0)
        continue;
    }
    const std::size_t limit = (std::max)(complex.numbered.vertices().size() / 10, std::size_t(1000));
    const bool may_split = complex.check.is_refinable && number_of_splits <= limit;

    std::optional<Found_map_3> found;
    if(complex.allows(problem.options.mode))
    {
      found = find_map_of_complex_3(complex, problem, carried.untangling_start(complex.numbered, may_split),
                                    carried.approach_start(complex.numbered, may_split ? 1 : 2));
      if(found->is_blocked() && may_split && budget.is_exhausted())
        found->status = ERROR_INTERRUPTED;
      else if(found->is_blocked() && may_split)
      {
        const Refinement_plan_3 plan = carried.plan(complex.numbered.mesh(), *found);
        std::vector<std::array<typename C3t3::Vertex_handle, 2> > edges;
        for(const auto& [v, w] : plan.edges)
          edges.push_back({ complex.numbered.vertices()[v], complex.numbered.vertices()[w] });
        const auto inserted = split_edges_3(c3t3, edges);
        number_of_splits += inserted.size();
        carried = Carried_search_3<C3t3>(complex.numbered, found->map.positions, inserted, plan);
        if(!inserted.empty() || found->is_stuck)
          continue;
      }
    }
    Parameterization_result result = written_result(complex, problem, found, uvw_map);
    if(!found && result.status == ERROR_PRESCRIBED_CELL_INVERTED && complex.check.is_refinable && budget.is_exhausted())
      result.status = ERROR_INTERRUPTED;
    result.number_of_added_vertices = number_of_removals + number_of_splits;
    return result;
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_REFINE_AND_PARAMETERIZE_COMPLEX_3_H
