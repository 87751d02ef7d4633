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

#include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_polycube_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_parameterizer_base_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Polycube_meshing_3 {

/*!
\ingroup PkgPolycubeMeshing3Polycubes

The axes that the faces of a polycube are normal to, relative to the body.
*/
enum class Polycube_axes
{
  FOUND, ///< the axes to which the normals of the body are closest: the body may lie in any position
  GIVEN  ///< the axes of the coordinates
};

/*!
\ingroup PkgPolycubeMeshing3Polycubes

The properties of a polycube that `Polycube_boundary_parameterizer_3` finds.
*/
struct Polycube_result
{
  /// a sequence of points of the boundary, of which each is joined to the next one by an edge
  using Polyline = std::vector<std::array<double, 3> >;

  /// the rows of the rotation matrix of the body into the axes of the polycube: the identity for given axes or labels
  std::array<std::array<double, 3>, 3> rotation = {};
  /// number of sharp edges of the boundary
  std::size_t number_of_sharp_edges = 0;
  /// polylines of the sharp edges whose images are not parallel to an axis, in the body as it is given; the longest one is first.
  /// Grids do not follow them.
  std::vector<Polyline> features_given_up = {};
  /// label of the facet opposite to each vertex of each cell, in the axes of the polycube. The labels are 0 for +x, 1 for -x, 2
  /// for +y, 3 for -y, 4 for +z, 5 for -z. Facets inside have `no_label`. `Polycube_boundary_parameterizer_3::parameterize()`
  /// takes these labels. Cells are in the order of the arrays, or of the cells in the complex, after refinement. If the body has
  /// been turned, rotate it before these labels are passed on.
  std::vector<std::array<std::size_t, 4> > labels = {};

  /// a polycube that was found
  struct Candidate
  {
    std::string strategy; ///< that found it: `labels`, `bounding box`, `bodies side by side`, `voxels` or `given labels`
    double cost;          ///< its distortion, what its splits of edges cost, and the part of sharp edges given up
  };

  /// the polycubes that were found, the cheapest one first
  std::vector<Candidate> candidates = {};
  /// the strategy of the polycube that the body is mapped to: that of the first candidate, unless no map to that was found
  std::string strategy = {};

  static constexpr std::size_t no_label = 6; ///< label of a facet that is not on the boundary

  /// returns the number of edges of the polylines.
  std::size_t number_of_edges_given_up() const
  {
    std::size_t result = 0;
    for(const Polyline& polyline : features_given_up)
      result += polyline.size() - 1;
    return result;
  }
};

/*!
\ingroup PkgPolycubeMeshing3Polycubes

maps the boundary of a complex onto the boundary of a polycube, a polyhedron whose faces are normal to the axes.

The boundary may have handles. A written image has these properties:

- No triangle is flipped or flat, and the image does not intersect itself. Exact predicates on the written coordinates check this.
- All vertices of a face have exactly the same constant coordinate.
- If a spacing is given, the coordinates of all faces are multiples of it. `make_hexahedral_mesh_3()` then makes boxes that are
  cubes. No two faces merge if an edge separates them.
- The order of vertices does not change the result, unless vertices have equal distances from the center of the boundary.

<b>Charts</b>. The label of a facet of the boundary is the direction of the normal of its image. Connected facets with the
same label form a chart, which is mapped to a face. Lines between two charts are mapped to edges, and vertices of three or
more charts to corners. Lines are mapped by arc length, and charts by harmonic maps. Then an energy that is finite for flipped
triangles \cgalCite{cgal:gkkrs-ffm-21} is minimized.

<b>Coordinates of faces</b>. The first coordinates are those closest to the mean coordinates of the charts in least squares.
Then Newton's method changes them such that lengths on the polycube approximate lengths on the boundary. If this polycube has
no valid map, the first coordinates are taken. The polycube has at least the volume of the body and lies where the body lies.
With a spacing, it is moved by at most half of the spacing along each axis. If it would touch itself at multiples of the spacing,
the polycube without a spacing is moved there: its planes keep their order, and faces that face each other stay apart.

<b>Axes</b>. With `Polycube_axes::FOUND`, the body is turned such that its normals are nearly closest to the axes. The
polycube is that of the turned body, and the result contains the rotation. A body that is almost aligned is not turned, and
neither is a body with given labels.

<b>Sharp edges</b>. Sharp edges inside a chart become lines in the face that are parallel to an axis, if there is room. If a
line would flip triangles, it is given up. `Polycube_result::features_given_up` lists all sharp edges that the polycube does
not follow. With a spacing, lines lie at multiples of the spacing, its half or its quarter. Lines shorter than the spacing are
not made. Sharp edges are the 1-dimensional features of the complex, or the marked edges of the soup. If none of them is on
the boundary, edges with 60 degrees or more between the normals on both sides are sharp.

<b>Labels</b>. If no labels are given, they are close to the normals and change along short lines \cgalCite{cgal:lvsg-pmg-13}.
Lines along sharp edges cost nothing. Charts that no polycube can have get other labels, at the lowest cost. Of the polycubes
found for several weights, the one whose harmonic maps have the least distortion is taken. Its distortion is the mean square
of the logarithms of the singular values. If its map is not valid, the next polycube is tried. If this polycube is bad, large faces
that are oblique to the axes get their second direction, one after the other.

<b>Choice</b>. If the polycube of the labels costs much, or none is found, a topological sphere is also mapped to its bounding box.
With `Refinement_mode::BOUNDARY`, `CGAL::stretch_minimizing_volume_parameterization()` also tries polycubes of voxels then, and
splits edges of the boundary near edges of such a polycube. The cost is the distortion of the boundary, times the third root of
the factor by which splits multiply its vertices. To this, the part of the length of sharp edges that is given up is added. The
call maps the body to the cheapest polycube. If that fails, it takes the next ones, up to the first one without splits.
`Polycube_result::candidates` lists all of them. A body with handles for which no labels are found needs voxels, and handles finer
than a voxel are not found.

The function `parameterize()` writes images only if it returns `OK`. Otherwise, it returns one of these codes:

- `ERROR_EMPTY_COMPLEX`, `ERROR_NON_FINITE_COORDINATE`, `ERROR_NON_MANIFOLD_BOUNDARY`, `ERROR_INTERRUPTED`.
- `ERROR_NO_POLYCUBE`: no polycube has the given labels, or none was found. Bodies with handles may have one if edges are split.
- `ERROR_SEVERAL_BOUNDARY_COMPONENTS`: none was found, and the body has cavities.
- `ERROR_BOUNDARY_TOO_COARSE`: facets between edges of the polycube would be flipped or flat.
  `Refinement_mode::BOUNDARY` may help.
- `ERROR_BOUNDARY_MAP_NOT_BIJECTIVE`: rounding makes the map invalid.
- `ERROR_SPACING_TOO_COARSE`: there is a polycube, but not with multiples of the spacing, or the spacing is above 1e60.

The time is in \f$ O(n \log n + k\, m) \f$ for each weight and each rotation, with \f$ n \f$ boundary vertices of bounded degree
and \f$ k \f$ labels tried for \f$ m \f$ charts. The solution of sparse linear systems for each chart of the polycubes found is
added to it.

\cgalModels{BoundaryParameterizer_3}

\sa `Polycube_result`
\sa `Cube_boundary_parameterizer_3`
*/
class Polycube_boundary_parameterizer_3
  : public internal::Boundary_parameterizer_base_3<Polycube_boundary_parameterizer_3>
{
  friend internal::Boundary_parameterizer_base_3<Polycube_boundary_parameterizer_3>;

public:
  /// chooses the grid, the axes and the output.
  ///
  /// \param spacing the spacing of the grid, in the units of the complex; 0 for faces with any coordinates
  /// \param axes the axes of the polycube
  /// \param result if it is not null, each call that finds a polycube writes the properties of the polycube there. It must exist
  ///        as long as this object or a copy, as in a named parameter, is called.
  ///
  /// \pre The spacing is finite and not negative; otherwise `CGAL::Precondition_exception` is thrown, in every build.
  explicit Polycube_boundary_parameterizer_3(const double spacing = 0, const Polycube_axes axes = Polycube_axes::FOUND,
                                             Polycube_result* const result = nullptr)
    : m_spacing(spacing), m_axes(axes), m_result(result)
  { internal::require(spacing >= 0 && std::isfinite(spacing), "spacing must be finite and not negative."); }

  using internal::Boundary_parameterizer_base_3<Polycube_boundary_parameterizer_3>::parameterize;

  /// writes the image of each vertex of the boundary of the complex, for given labels.
  ///
  /// \param c3t3 the complex
  /// \param labels the label of each boundary facet, as a facet of its cell in the complex. The labels are 0 for +x, 1 for -x, 2
  ///        for +y, 3 for -y, 4 for +z, 5 for -z. Each facet of the boundary needs one.
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
      label_of_facet.push_back(get(labels, typename C3t3::Facet(body.cells_of_complex[side / 4], static_cast<int>(side % 4))));
    return this->parameterize_complex(body, target, np, label_of_facet);
  }

  /// writes the image of each point on the boundary of a mesh that is given by arrays, for given labels. `labels[c][i]` is the
  /// label of the facet opposite to vertex `i` of cell `c`. Labels of facets inside do not matter. All else is as for a complex.
  template <typename PointRange, typename CellRange, typename LabelRange, typename TargetRange,
            typename CGAL_NP_TEMPLATE_PARAMETERS, typename = internal::If_range<LabelRange>,
            typename = internal::If_range<TargetRange> >
  Error_code parameterize(const PointRange& points, const CellRange& cells, const LabelRange& labels, TargetRange& targets,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    const internal::Body_3 body = internal::body_of(points, cells);
    internal::require(internal::number_of_rows(labels) == body.cells.size(), "labels must have an element for each cell.");
    std::vector<std::size_t> label_of_facet;
    for(const std::size_t side : body.sides)
      label_of_facet.push_back(static_cast<std::size_t>(internal::row(labels, side / 4)[side % 4]));
    return this->parameterize_arrays(body, targets, np, label_of_facet);
  }

#ifndef DOXYGEN_RUNNING
  // Writes the result of the polycube that a body is mapped to at last.
  void store_result(const internal::Body_3& refined_body, const internal::Mapped_boundary_3& boundary) const
  {
    if(m_result == nullptr)
      return;
    const internal::Body_3 body // with the sides that are on the boundary now
      = internal::body_of_arrays(refined_body.points, refined_body.cells, refined_body.edges);
    const internal::Numbered_surface_3 surface = internal::surface_of(body);
    std::vector<internal::Vector_3> images;
    for(const std::size_t v : surface.vertices)
      images.push_back(internal::to_vector(boundary.targets[v]));
    m_result->rotation = boundary.rotation;
    m_result->strategy = boundary.strategy;
    m_result->number_of_sharp_edges = surface.sharp_edges.size();
    m_result->features_given_up.clear();
    for(const std::vector<internal::Vector_3>& feature : internal::features_given_up_3(surface, images))
      m_result->features_given_up.push_back(internal::arrays_of(feature));
    constexpr std::size_t none = Polycube_result::no_label;
    m_result->labels.assign(body.cells.size(), { none, none, none, none });
    for(std::size_t f = 0; f < surface.facets.size(); ++f)
      m_result->labels[body.sides[f] / 4][body.sides[f] % 4] = internal::label_of_image(surface.facets[f], images);
  }

  // Reorders the stored labels as the cells of the refined complex, of which cell c has the number order[c] in the body.
  void reorder_result(const std::vector<std::size_t>& order) const
  {
    if(m_result == nullptr || m_result->labels.size() != order.size())
      return;
    const std::vector<std::array<std::size_t, 4> > labels = m_result->labels;
    for(std::size_t c = 0; c < order.size(); ++c)
      m_result->labels[c] = labels[order[c]];
  }
#endif

private:
  using Given = std::vector<std::size_t>; // labels of the facets of the boundary; none if they are to be found

  // Adds the boundaries that are mapped to polycubes, the cheapest one first, up to the first one without split edges. Edges are
  // split only if the body may be refined. Returns the status of the search.
  Error_code find(const internal::Body_3& body, const Given& label_of_facet, const bool may_refine,
                  const internal::Budget& budget, std::vector<internal::Mapped_boundary_3>& boundaries) const
  {
    for(const std::size_t label : label_of_facet)
      internal::require(label < 6, "labels of facets of the boundary must be 0 to 5.");
    const internal::Numbered_surface_3 surface = internal::surface_of(body);
    const internal::Found_polycubes_3 found
      = internal::map_to_polycube_3({ surface, label_of_facet, m_spacing, m_axes == Polycube_axes::FOUND, may_refine }, budget);
    if(budget.is_exhausted()) // then the status does not matter
      return ERROR_INTERRUPTED;
    if(m_result != nullptr)
    {
      m_result->candidates.clear();
      for(const internal::Polycube_candidate_3& candidate : found.candidates)
        m_result->candidates.push_back({ candidate.strategy, candidate.cost });
    }
    for(const internal::Polycube_candidate_3& candidate : found.candidates)
    {
      boundaries.push_back(this->mapped_boundary(body, surface, candidate.map.splits, candidate.map.images));
      boundaries.back().strategy = candidate.strategy;
      for(int i = 0; i < 3; ++i)
        boundaries.back().rotation[i] = internal::coordinates(candidate.rotation.row(i));
      if(candidate.map.splits.empty())
        break; // the inside of the body may be refined for this boundary; costlier ones are not better
    }
    return found.status;
  }

  double m_spacing;
  Polycube_axes m_axes;
  Polycube_result* m_result;
};

} // namespace CGAL::Polycube_meshing_3

#endif // CGAL_POLYCUBE_MESHING_3_POLYCUBE_BOUNDARY_PARAMETERIZER_3_H
