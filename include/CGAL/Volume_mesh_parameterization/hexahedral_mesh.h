// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRAL_MESH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRAL_MESH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedral_mesh_result.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Parallel/for_each_index.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/Box_grid_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/Pulled_back_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/check_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/judge_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/pad_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/smooth_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Input_check_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/require.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

constexpr double sufficient_scaled_jacobian = 0.3;
constexpr double poor_scaled_jacobian = 0.1; // to raise the worst corners further costs the others too much

inline bool is_better(const Hexahedral_mesh_result& a, const Hexahedral_mesh_result& b)
{
  return a.number_of_inverted_corners != b.number_of_inverted_corners
         ? a.number_of_inverted_corners < b.number_of_inverted_corners
         : a.minimal_scaled_jacobian > b.minimal_scaled_jacobian;
}

// Improves hexahedra until they suffice, and keeps the best ones: first with the vertices on the boundary fixed, then
// all at once, as long as that helps, and then, if corners are poor, one after the other around these.
template <typename ConcurrencyTag>
Hexahedral_mesh_result improve_in_rounds(Pulled_back_hexahedra_3<ConcurrencyTag>& hexahedra,
                                         const bool has_padding, Hexahedron_soup_3& best)
{
  constexpr int maximal_number_of_rounds = 16, patience = 4;
  constexpr double gain = 0.2; // a target far above the worst corners would not serve them most
  hexahedra.improve_inside();
  best = hexahedra.mesh();
  Hexahedral_mesh_result result = judged(best, has_padding);
  const auto keep_if_better = [&]
  {
    const Hexahedral_mesh_result next = judged(hexahedra.mesh(), has_padding);
    if(!is_better(next, result))
      return false;
    result = next;
    best = hexahedra.mesh();
    return true;
  };
  bool is_sliding = true;
  for(int round = 0, in_vain = 0; round < maximal_number_of_rounds && in_vain < patience; ++round)
  {
    if(result.minimal_scaled_jacobian >= sufficient_scaled_jacobian)
      break;
    is_sliding = is_sliding && hexahedra.slide();
    if(!is_sliding)
    {
      if(result.minimal_scaled_jacobian >= poor_scaled_jacobian)
        break;
      smooth_hexahedra_3(hexahedra, (std::max)(0., result.minimal_scaled_jacobian) + gain);
    }
    bool is_better_now = keep_if_better();
    hexahedra.improve_inside();
    is_better_now = keep_if_better() || is_better_now;
    in_vain = is_better_now || is_sliding ? 0 : in_vain + 1;
    is_sliding = is_sliding && is_better_now;
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

makes hexahedra of a tetrahedral mesh that has been mapped to a box or a polycube: the preimage of a grid.

The grid has the planes of all boundary facets of the domain, and between two neighbors of them planes at equal
distances near the spacing. For a polycube of `Polycube_boundary_parameterizer_3` with the same spacing all boxes are cubes. The
boxes inside the domain are pulled back. So the vertices on the boundary lie on the boundary of the body, and on its
edges and corners that are mapped to those of the domain. Those inside are moved then: each corner of a
hexahedron is taken for a tetrahedron, which is first untangled \cgalCite{cgal:gkkrs-ffm-21} and then made
similar to the corner of a cube by minimizing `MIPS_energy_3`. As long as the minimal scaled Jacobian is below 0.3,

- those on the boundary move as well, a few times, in the tangent planes of the boundary and along the edges that are
  mapped to those of the domain, and are put back onto it through the map,
- then, where that leaves less than 0.1, vertices move one after the other such that the worst corners around them become
  better, which makes others worse; those on the boundary move in the faces and along the edges of the domain,
- a second mesh is made, with a layer of hexahedra along the boundary of which each has only one quadrangle on it: where
  an edge of the domain is mapped to a smooth part of the boundary, hexahedra without it are flat, or almost so.

The best of these meshes is returned: that with the fewest inverted corners, or, among these, with the largest minimal
scaled Jacobian. That all corners are positive is checked with exact predicates on the coordinates written.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are `Sequential_tag`,
        `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.

\param points the points of the tetrahedral mesh
\param cells four indices of points each, such that all cells are positive
\param images the image of each point under a map that inverts no cell, as
       `CGAL::stretch_minimizing_volume_parameterization()` writes it
\param spacing the distance of planes of the grid, in the units of the images
\param mesh receives the hexahedra if the status is `OK`, and is left alone otherwise

\return the status with its place, and the scaled Jacobians: `OK`, `ERROR_EMPTY_COMPLEX`, `ERROR_NON_FINITE_COORDINATE`,
        `ERROR_SIZE_OUT_OF_RANGE` if the grid has more than 10^9 boxes, `ERROR_DOMAIN_NOT_AXIS_PARALLEL`,
        `ERROR_INVERTED_TARGET_BOUNDARY` if the domain has no box, or `ERROR_INVERTED_HEXAHEDRON` if a corner is not
        positive

\pre The spacing is positive, and there are as many images as points; otherwise `CGAL::Precondition_exception` is
     thrown, in every build.

The search takes time O((m + n) log n) for n tetrahedra and m boxes of the box around the domain. A Newton step takes
time linear in the number of hexahedra, plus the solution of a linear system.

\sa `Volume_map_3`
\sa `Polycube_boundary_parameterizer_3`
\sa `IO::write_VTU()`
\sa `IO::write_MEDIT()`
*/
template <typename ConcurrencyTag = Sequential_tag>
Hexahedral_mesh_result hexahedral_mesh(const std::vector<std::array<double, 3> >& points,
                                       const std::vector<std::array<std::size_t, 4> >& cells,
                                       const std::vector<std::array<double, 3> >& images,
                                       const double spacing,
                                       Hexahedron_soup_3& mesh)
{
  using Point_3 = Volume_map_3::Point_3;
  internal::require(spacing > 0, "The spacing of a grid is positive.");
  internal::require(images.size() == points.size(), "There are as many images as points.");
  const internal::Input_check_3 check = internal::check_map_3(points, cells, images);
  if(check.status != OK)
    return internal::refused_result(check);
  const internal::Box_grid_3 grid(cells, images, spacing);
  if(grid.check().status != OK)
    return internal::refused_result(grid.check());

  const Volume_map_3 map(points, cells, images);
  const Hexahedron_soup_3 boxes = grid.boxes([&](const std::vector<Point_3>& centers)
  {
    return map.preimages<ConcurrencyTag>(centers);
  });
  if(boxes.cells.empty())
    return internal::refused_result(internal::failed_check(ERROR_INVERTED_TARGET_BOUNDARY,
                                                           get_error_message(ERROR_INVERTED_TARGET_BOUNDARY)));

  Conjugate_gradient_solver_traits_3<ConcurrencyTag> solver;
  internal::Linear_solver_of<Conjugate_gradient_solver_traits_3<ConcurrencyTag> > linear_solver(solver);
  Hexahedron_soup_3 found;
  Hexahedral_mesh_result result;
  for(const bool has_padding : {false, true})
    if(!(result.minimal_scaled_jacobian >= internal::sufficient_scaled_jacobian))
    {
      internal::Pulled_back_hexahedra_3<ConcurrencyTag> hexahedra(
        map, points, cells, images, has_padding ? internal::padded(boxes) : boxes, spacing, linear_solver);
      Hexahedron_soup_3 candidate;
      const Hexahedral_mesh_result of_candidate = internal::improve_in_rounds(hexahedra, has_padding, candidate);
      if(!has_padding || internal::is_better(of_candidate, result))
      {
        result = of_candidate;
        found = std::move(candidate);
      }
    }
  if(result.status == OK)
    mesh = std::move(found);
  return result;
}

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

makes hexahedra of a complex in the same way.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3` whose type `Subdomain_index` is an integer type
\tparam VertexUVWMap a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
        `C3t3::Triangulation::Geom_traits::Point_3` as value type

\param c3t3 the complex
\param uvw_map the image of each vertex of a cell
\param spacing as above
\param mesh as above

\return the same as for arrays
*/
template <typename ConcurrencyTag = Sequential_tag, typename C3t3, typename VertexUVWMap>
Hexahedral_mesh_result hexahedral_mesh(const C3t3& c3t3, const VertexUVWMap uvw_map, const double spacing,
                                       Hexahedron_soup_3& mesh)
{
  Tetrahedron_soup_3 soup;
  std::vector<typename C3t3::Triangulation::Vertex_handle> vertices;
  mesh_complex_3_to_tetrahedron_soup(c3t3, soup, vertices);
  return hexahedral_mesh<ConcurrencyTag>(soup.points, soup.cells, internal::points_of(vertices, uvw_map), spacing, mesh);
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRAL_MESH_H
