// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CUBE_BOUNDARY_PARAMETERIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CUBE_BOUNDARY_PARAMETERIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_parameterizer_base_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/map_to_box_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationBoundary

maps the boundary of a complex that is a topological sphere onto the boundary of a cube, or of a box, around the origin.

Eight vertices become the corners of the box. Twelve disjoint paths along edges of the boundary become its edges, and the six
charts between the paths become its faces. A coordinate that is constant on a face or an edge of the box has exactly the same
bits in all images there. No triangle is flipped or flat, which is checked with exact predicates on the coordinates written.

The boundary is first mapped to the sphere as by `Ball_boundary_parameterizer_3`. The paths are shortest paths on the
sphere, found one after the other without touching each other \cgalCite{cgal:pss-cmp-01}. The charts are mapped from the
sphere, first harmonically and then by the untangling energy \cgalCite{cgal:gkkrs-ffm-21}. Finally, sweeps over all vertices
lower the symmetric Dirichlet energy of the map from the boundary, scaled to the area of the box. Vertices move in their face or
along their edge of the box.

If the boundary has sharp edges (normals that differ by 60 degrees or more, or marked edges), a second map is made. Its paths
prefer sharp edges. The map with less distortion is returned.

Unless corners are given, eight vertices are chosen by three criteria. The charts have areas in the ratio of the faces of the
box. The map is turned like the scaling of the bounding box of the boundary to the box. The vertices are close to the corners of
the bounding box.

`parameterize()` returns `OK`. Otherwise, it writes nothing and returns one of these codes: `ERROR_EMPTY_COMPLEX`,
`ERROR_NON_FINITE_COORDINATE`, `ERROR_NON_MANIFOLD_BOUNDARY`, `ERROR_SEVERAL_BOUNDARY_COMPONENTS`,
`ERROR_BOUNDARY_NOT_OF_GENUS_ZERO` or `ERROR_INTERRUPTED`. If no disjoint paths between the corners were found, it returns
`ERROR_BOUNDARY_TOO_COARSE`. If rounding makes the map invalid, it returns `ERROR_BOUNDARY_MAP_NOT_BIJECTIVE`. For \f$ n \f$
boundary vertices of bounded degree, the running time is in \f$ O(n \log n) \f$, plus at most 51 sparse linear systems for each
face.

If a boundary is too coarse, `CGAL::stretch_minimizing_volume_parameterization()` splits edges of it with
`Refinement_mode::BOUNDARY`, those first that are longest on the sphere.

\cgalModels{BoundaryParameterizer_3}

\sa `Ball_boundary_parameterizer_3`
*/
class Cube_boundary_parameterizer_3 : public internal::Boundary_parameterizer_base_3<Cube_boundary_parameterizer_3>
{
  friend internal::Boundary_parameterizer_base_3<Cube_boundary_parameterizer_3>;

public:
  /// chooses the unit cube.
  Cube_boundary_parameterizer_3() : Cube_boundary_parameterizer_3(1, 1, 1) {}

  /// chooses the box with the lengths of its sides, in the unit of the images. The origin is its center.
  /// \pre The lengths are positive and finite.
  Cube_boundary_parameterizer_3(const double x_length, const double y_length, const double z_length)
    : m_half_lengths(x_length / 2, y_length / 2, z_length / 2)
  {
    internal::require(m_half_lengths.allFinite() && m_half_lengths.minCoeff() > 0,
                      "The lengths of a box must be positive and finite.");
  }

  using internal::Boundary_parameterizer_base_3<Cube_boundary_parameterizer_3>::parameterize;

  /// writes the image of each vertex of the boundary of the complex, with the corners of the caller.
  ///
  /// \param c3t3 the complex
  /// \param corners the vertices for the corners of the box. Bit 0 of the index is set if x is positive at the corner, bit 1 for
  ///        y, and bit 2 for z
  /// \param target receives the images
  /// \param np optional \ref bgl_namedparameters "Named Parameters": `maximum_running_time` and `visitor`, as described in
  ///        `BoundaryParameterizer_3`
  ///
  /// \return the codes without corners, and two others. `ERROR_INVALID_CORNERS`: the corners are not different vertices of the
  ///         boundary. `ERROR_MIRRORED_CORNERS`: disjoint paths were found for the mirrored box only
  template <typename C3t3, typename VertexPointMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const C3t3& c3t3, const std::array<typename C3t3::Vertex_handle, 8>& corners,
                          VertexPointMap target, const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    const internal::Body_of_complex_3<C3t3> body(c3t3);
    std::array<std::size_t, 8> points;
    for(std::size_t k = 0; k < 8; ++k)
      points[k] = std::find(body.vertices.begin(), body.vertices.end(), corners[k]) - body.vertices.begin();
    return this->parameterize_complex(body, target, np, points);
  }

  /// writes the image of each point on the boundary of a mesh that is given by arrays, with the corners of the caller.
  template <typename PointRange, typename CellRange, typename TargetRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
            typename = internal::If_range<PointRange> >
  Error_code parameterize(const PointRange& points, const CellRange& cells, const std::array<std::size_t, 8>& corners,
                          TargetRange& targets, const CGAL_NP_CLASS& np = parameters::default_values()) const
  { return this->parameterize_arrays(internal::body_of(points, cells), targets, np, corners); }

private:
  using Given = std::optional<std::array<std::size_t, 8> >; // corners

  // Splits edges of the boundary if it is too coarse, and may be refined.
  Error_code find(const internal::Body_3& body, const Given& corners, const bool may_refine, const internal::Budget& budget,
                  std::vector<internal::Mapped_boundary_3>& boundaries) const
  {
    const internal::Numbered_surface_3 surface = internal::surface_of(body);
    std::optional<std::array<int, 8> > indices;
    if(corners)
      indices.emplace();
    for(std::size_t k = 0; corners && k < 8; ++k)
    {
      const auto found = std::find(surface.vertices.begin(), surface.vertices.end(), (*corners)[k]);
      if(found == surface.vertices.end() || std::count(corners->begin(), corners->end(), *found) > 1)
        return ERROR_INVALID_CORNERS;
      (*indices)[k] = static_cast<int>(found - surface.vertices.begin());
    }
    std::vector<std::array<std::size_t, 2> > splits;
    std::vector<internal::Vector_3> images;
    const Error_code status
      = internal::map_to_box_3(surface, m_half_lengths, indices, images, budget, may_refine ? &splits : nullptr);
    if(budget.is_exhausted()) // then the status does not matter
      return ERROR_INTERRUPTED;
    if(status == OK)
      boundaries.push_back(this->mapped_boundary(body, surface, splits, images));
    return status;
  }

  internal::Vector_3 m_half_lengths;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CUBE_BOUNDARY_PARAMETERIZER_3_H
