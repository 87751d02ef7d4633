// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_POLYCUBE_BOUNDARY_PARAMETERIZER_3_H
#define CGAL_POLYCUBE_MESHING_3_POLYCUBE_BOUNDARY_PARAMETERIZER_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Polycube_result.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/features_given_up_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_polycube_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_parameterizer_base_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/surface_of_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgPolycubeMeshing3Polycubes

The axes that the faces of a polycube are normal to, relative to the body.
*/
enum class Polycube_axes
{
  FOUND, ///< those to which the normals of the body are closest: the body may lie in any position
  GIVEN  ///< those of the coordinates
};

/*!
\ingroup PkgPolycubeMeshing3Polycubes

maps the boundary of a complex onto the boundary of a polycube: a polyhedron whose faces are normal to the axes.

Each facet of the boundary is labelled with the direction, along an axis, that the normal of its image will have.
Connected facets with the same label form a chart, which is mapped to a face of the polycube; the lines between two
charts are mapped to its edges, and the vertices where three or more charts meet to its corners. The charts
determine the polycube up to the coordinates of its faces. These are first chosen as close as possible to the mean coordinates
of the charts, in the sense of least squares weighted by area, such that no edge is shorter than a
fifth of the line that is mapped to it. Then they are moved such that lengths on the polycube become those on the boundary, as a
limb that leads askew to the axes is longer than its shadow: as the harmonic map of the charts is linear in the coordinates,
the least mean square of the logarithms of its singular values is found by Newton's method. The polycube has at least the
volume of the body, and lies where the complex lies; if it has no map, the first one is taken.

Facets are visited in an order that depends on the distances of their vertices from the center of the boundary alone, so the
numbers of vertices do not decide, unless distances are equal.

The axes fit the body: it is turned about the center of its bounding box, by a rotation with which its unit normals are
nearly closest to the axes, in the mean over the area of their distances from the nearest one. The polycube is that of the
turned body, with faces that are normal to the axes of the coordinates; the rotation is told.
Among up to three rotations that are about as good, the one is taken whose polycube is less distorted. A body that lies well
already, by 0.003 of that mean, is not turned, and one with given labels never is. Minima are found by Weiszfeld's
algorithm from 27 starts, with normals that are summed up before such that there are at most some ten thousand.

Lines are mapped by arc length, and charts by harmonic maps, which may flip triangles. Therefore an energy that is
finite for flipped triangles \cgalCite{cgal:gkkrs-ffm-21} is lowered afterwards, which also lowers the distortion.
The coordinate that is constant on a face has exactly the same bits in all images there. No triangle is flipped or flat, and
the image does not intersect itself, which is checked with exact predicates on the coordinates written.

Sharp edges inside of a chart become lines in the face that are parallel to an axis, if they do not lead too far across it: parts
of curves between their turns, with one value of the coordinate across for all lines that meet and are not side by side. The
order of lines and edges of the polycube stays; where lines would flip triangles, the shortest ones are given up. The result
names all sharp edges that the polycube gives up. Sharp edges are the 1-dimensional features of the complex, or the marked
edges of the soup; if there are none on the boundary, those with more than 60 degrees between the normals on both sides.

With the spacing of a grid, the coordinates of all faces are multiples of it, so that `make_hexahedral_mesh_3()` makes cubes.
All distances along edges become multiples too, rounded up; coordinates are rounded one after the other, while the others
follow such that lengths stay; and no two faces are merged that an edge keeps apart. Unless axes or labels are given, the
polycube is moved by at most half of the spacing along each axis, such that rounding changes its faces least, and where the body
lies does not matter. Coordinates of lines are multiples of the spacing too, or of its half or quarter where these are clearly
nearer, or there is no room. Lines that are shorter than the spacing are not made.

The boundary may have handles, and charts may have holes. The more the boundary differs from a polycube, the more distorted
is the map, and the less certain that labels with a polycube are found.

Unless labels are given, they are close to the normals and change along short lines \cgalCite{cgal:lvsg-pmg-13} : those of
facets, of small regions and of charts are changed as long as that lowers the cost. Lines between charts along sharp edges are
free. Where opposite directions would be
neighbors, another one is put between them. Charts that no polycube can have, and their neighbors, get other
labels, at the lowest cost, until no such chart is left. This is done with more and more weight on short lines; of
the polycubes found, the one is taken to which the boundary is mapped with the least distortion by harmonic maps: the
mean square of the logarithms of the singular values. If its map is not valid, the next one is taken. If there
is none, a topological sphere is mapped to its bounding box, and the boundary of a body with handles to a box with as many
holes, which exists for each body that discs cut into a ball, also a knotted one: meridians around the handles are found
inside the body, and the edges of the box as disjoint lines on its boundary. At least four edges of the mesh must
lead around each handle, and more where it is to be mapped with low distortion.
`CGAL::stretch_minimizing_volume_parameterization()` with `Refinement_mode::BOUNDARY` does without them, and has another choice
there: voxels whose boundary has as many handles are simplified by moving their faces, as long as that
lowers the cost of labels, and the edges of the polycube that they are then become disjoint paths on the boundary. Near
these, edges of the mesh are split to the length of a voxel, and further where a path is blocked. Up to 84 grids are tried,
with 8 to 48 voxels along the body; bodies with finer handles are not found.

`parameterize()` returns `OK`; or, with nothing written, `ERROR_EMPTY_COMPLEX`, `ERROR_NON_FINITE_COORDINATE`,
`ERROR_NON_MANIFOLD_BOUNDARY`, `ERROR_NO_POLYCUBE` if no polycube has the labels, or none was found without labels,
`ERROR_SEVERAL_BOUNDARY_COMPONENTS` if none was found and a body has cavities,
`ERROR_BOUNDARY_TOO_COARSE` if facets between edges of the polycube would be flipped or flat, against which
`Refinement_mode::BOUNDARY` may help,
`ERROR_BOUNDARY_MAP_NOT_BIJECTIVE` if rounding spoilt the map,
`ERROR_SPACING_TOO_COARSE` if there is a polycube, but not with multiples of the spacing, or if the spacing is above 1e60, or
`ERROR_INTERRUPTED`. The
running time is in \f$ O(n \log n + k\, m) \f$ for each of 14 weights and each rotation, with \f$ n \f$ boundary vertices of
bounded degree, and \f$ k \f$ labels that are tried for \f$ m \f$ charts; to this is added the solution of sparse
linear systems for each chart of the polycubes found.

\cgalModels{BoundaryParameterizer_3}

\sa `Polycube_result`
\sa `Cube_boundary_parameterizer_3`
*/
class Polycube_boundary_parameterizer_3
  : public internal::Boundary_parameterizer_base_3<Polycube_boundary_parameterizer_3>
{
  friend internal::Boundary_parameterizer_base_3<Polycube_boundary_parameterizer_3>;

public:
  /// chooses the grid, the axes, and where is told what was found.
  ///
  /// \param spacing the spacing of the grid, in the units of the complex; 0 for faces with any coordinates
  /// \param axes the axes of the polycube
  /// \param result receives, with each polycube that is found, its rotation and the sharp edges that it gives up
  ///
  /// \pre The spacing is finite and not negative; otherwise `CGAL::Precondition_exception` is thrown, in every build.
  explicit Polycube_boundary_parameterizer_3(const double spacing = 0, const Polycube_axes axes = Polycube_axes::FOUND,
                                             Polycube_result* const result = nullptr)
    : m_spacing(spacing), m_axes(axes), m_result(result)
  { internal::require(spacing >= 0 && std::isfinite(spacing), "The spacing of a grid is finite and not negative."); }

  using internal::Boundary_parameterizer_base_3<Polycube_boundary_parameterizer_3>::parameterize;
#ifdef DOXYGEN_RUNNING
  /// writes the image of each vertex of the boundary of a complex, as described in `BoundaryParameterizer_3`.
  template <typename C3t3, typename VertexPointMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const C3t3& c3t3, VertexPointMap target,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const;
  /// writes the image of each point on the boundary of a mesh that is given by arrays, as described there.
  template <typename PointRange, typename CellRange, typename TargetRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const PointRange& points, const CellRange& cells, TargetRange& targets,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const;
#endif

  /// writes the image of each vertex of the boundary of the complex, for given labels.
  ///
  /// \param c3t3 the complex
  /// \param labels the directions of the facets that have a cell of the complex on one side only, as the facets of
  ///        this cell: 0 for +x, 1 for -x, 2 for +y, 3 for -y, 4 for +z, 5 for -z. `boost::make_assoc_property_map()`
  ///        takes a facet that has been forgotten for one with the label 0.
  /// \param target receives the images
  /// \param np optional \ref bgl_namedparameters "Named Parameters": `maximum_running_time` and `visitor`, as described in
  ///        `BoundaryParameterizer_3`
  ///
  /// \tparam FacetLabelMap a model of `ReadablePropertyMap` with `C3t3::Facet` as key type and
  ///         `std::size_t` as value type
  ///
  /// \pre The labels are 0 to 5; otherwise `CGAL::Precondition_exception` is thrown, in every build.
  /// \return the same as without labels
  template <typename C3t3, typename FacetLabelMap, typename VertexPointMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
            typename = typename C3t3::Triangulation, typename = internal::Key_of<VertexPointMap> >
  Error_code parameterize(const C3t3& c3t3, FacetLabelMap labels, VertexPointMap target,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    const internal::Body_of_complex_3<C3t3> body(c3t3);
    std::vector<std::size_t> label_of_facet;
    for(const std::size_t side : body.sides)
      label_of_facet.push_back(get(labels, typename C3t3::Facet(body.cells[side / 4], static_cast<int>(side % 4))));
    return this->parameterize_complex(body, target, np, label_of_facet);
  }

  /// writes the image of each point on the boundary of a mesh that is given by arrays, for given labels, as for a complex:
  /// `labels[c][i]` is the label of the facet opposite to vertex `i` of cell `c`.
  template <typename PointRange, typename CellRange, typename LabelRange, typename TargetRange,
            typename CGAL_NP_TEMPLATE_PARAMETERS, typename = internal::If_range<LabelRange>,
            typename = internal::If_range<TargetRange> >
  Error_code parameterize(const PointRange& points, const CellRange& cells, const LabelRange& labels, TargetRange& targets,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    const internal::Body_3 body = internal::body_of(points, cells);
    internal::require(internal::number_of_rows(labels) == body.soup.cells.size(), "There are labels for each cell.");
    std::vector<std::size_t> label_of_facet;
    for(const std::size_t side : body.sides)
      label_of_facet.push_back(static_cast<std::size_t>(internal::row(labels, side / 4)[side % 4]));
    return this->parameterize_arrays(body, targets, np, label_of_facet);
  }

#ifndef DOXYGEN_RUNNING
  // Tells of the polycube that a body is mapped to at last.
  void tell(const internal::Body_3& refined_body, const internal::Mapped_boundary_3& boundary) const
  {
    if(m_result == nullptr)
      return;
    const internal::Body_3 body = internal::body_of(refined_body.soup); // with the sides that are on the boundary now
    const internal::Numbered_surface_3 surface = internal::surface_of(body);
    std::vector<Eigen::Vector3d> images;
    for(const std::size_t v : surface.vertices)
      images.push_back(internal::to_vector(boundary.targets[v]));
    *m_result = { boundary.rotation, surface.sharp_edges.size() };
    for(const std::vector<Eigen::Vector3d>& feature : internal::features_given_up_3(surface, images))
    {
      m_result->features_given_up.emplace_back();
      for(const Eigen::Vector3d& p : feature)
        m_result->features_given_up.back().push_back(internal::coordinates(p));
    }
    constexpr std::size_t none = Polycube_result::no_label;
    m_result->labels.assign(body.soup.cells.size(), { none, none, none, none });
    for(std::size_t f = 0; f < surface.facets.size(); ++f)
      m_result->labels[body.sides[f] / 4][body.sides[f] % 4] = label_of_image(surface.facets[f], images);
  }

  // Is told of the order of the cells in a complex that has been refined.
  void tell_order_of_cells(const std::vector<std::size_t>& order) const
  {
    if(m_result == nullptr || m_result->labels.size() != order.size())
      return;
    const std::vector<std::array<std::size_t, 4> > labels = m_result->labels;
    for(std::size_t c = 0; c < order.size(); ++c)
      m_result->labels[c] = labels[order[c]];
  }
#endif

private:
  using Given = std::vector<std::size_t>; // labels

  // Finds images of a boundary as it is given and, if it may be refined, before these those of one with more vertices.
  Error_code find(const internal::Body_3& body, const Given& label_of_facet, const bool may_refine, const internal::Budget& budget,
                  std::vector<internal::Mapped_boundary_3>& boundaries) const
  {
    for(const std::size_t label : label_of_facet)
      internal::require(label < 6, "The labels of a polycube are 0 to 5.");
    const internal::Numbered_surface_3 surface = internal::surface_of(body);
    std::vector<Eigen::Vector3d> images;
    Eigen::Matrix3d rotation;
    internal::Map_of_split_surface_3 of_split;
    const Error_code status = internal::map_to_polycube_3(surface, label_of_facet, m_spacing, m_axes == Polycube_axes::FOUND,
                                                          images, rotation, budget, may_refine ? &of_split : nullptr);
    if(budget.is_exhausted()) // then the status does not matter
      return ERROR_INTERRUPTED;
    if(status != OK)
      return status;
    if(!of_split.images.empty())
      boundaries.push_back(this->mapped_boundary(body, surface, of_split.splits, of_split.images));
    if(!images.empty())
      boundaries.push_back(this->mapped_boundary(body, surface, {}, images));
    for(internal::Mapped_boundary_3& boundary : boundaries)
      for(int i = 0; i < 3; ++i)
        boundary.rotation[i] = internal::coordinates(rotation.row(i));
    return OK;
  }

  // Returns the direction of the normal of a facet's image on a polycube.
  static std::size_t label_of_image(const std::array<std::size_t, 3>& facet, const std::vector<Eigen::Vector3d>& images)
  {
    const Eigen::Vector3d &p = images[facet[0]], &q = images[facet[1]], &r = images[facet[2]];
    std::size_t axis = 0;
    while(axis < 2 && (p[axis] != q[axis] || p[axis] != r[axis]))
      ++axis;
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto point = [&](const Eigen::Vector3d& image) { return internal::Boundary_point_2(image[u], image[v]); };
    return 2 * axis + (CGAL::orientation(point(p), point(q), point(r)) == NEGATIVE);
  }

  double m_spacing;
  Polycube_axes m_axes;
  Polycube_result* m_result;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_POLYCUBE_MESHING_3_POLYCUBE_BOUNDARY_PARAMETERIZER_3_H
