// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_VOLUME_PARAMETERIZATION_OF_ARRAYS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_VOLUME_PARAMETERIZATION_OF_ARRAYS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Entry/map_body_3.h>

namespace CGAL {

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes the map of a mesh that is given by arrays, without a complex. Vertices are indices of points, counted from 0.
The result is bit for bit the one for a complex whose cells and vertices come in the same order.

The last array is always the output. With four arrays, the third array prescribes the images of the boundary. With three arrays,
the named parameter `boundary_parameterizer` finds them, by default on the unit sphere.

\tparam PointRange a model of `RandomAccessContainer` with a `value_type` that has three coordinates by `operator[]` and can be
        constructed from `{x, y, z}`. Examples are `std::array<double, 3>`, `Kernel::Point_3` and `Eigen::Vector3d`. Points
        that are written are rounded to the type of their coordinates before the exact checks. A range that is not modified may
        be any random access range with the functions `begin()`, `end()` and `size()`.
\tparam CellRange a model of `RandomAccessContainer` whose `value_type` has four indices by `operator[]`
\tparam TargetRange as `PointRange`
\tparam ImageRange as `PointRange`

\param points the points; new ones are appended if the mesh may be refined (see `refinement_mode`), and may be constant otherwise
\param cells four indices of points each, such that all cells are positive; modified only if the mesh may be refined. A cell
       that is split becomes one of its parts, the other parts are appended.
\param targets the image of each point that is a vertex of the boundary, of a facet of one cell only. The others are not
       read, unless `vertex_is_constrained_map` or `vertex_condition_map` lists them; a coordinate that is not a number stands for
       a missing target.
\param images receives the image of each point, also of the new ones, if the map is valid, and is left alone otherwise.
       Points without a cell receive coordinates that are not numbers. May be the same array as `targets`, or, without
       refinement, as `points`.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of the function for a complex,
       with `std::size_t` for `C3t3::Vertex_handle`, except `boundary_map` and `boundary_parameterizer`

\return the same as for a complex

\exception Volume_mesh_parameterization::Input_error names a cell with an index that does not exist or occurs twice. Or it names
           a facet with more than two cells, or with two cells on the same side.

\pre There are as many targets as points; otherwise `CGAL::Precondition_exception` is thrown, in every build.

\sa `CGAL::Volume_mesh_parameterization::make_parameterizable()`
\sa `CGAL::Volume_mesh_parameterization::Ball_boundary_parameterizer_3`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename PointRange, typename CellRange, typename TargetRange, typename ImageRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = Volume_mesh_parameterization::internal::If_range<PointRange>,
          typename = Volume_mesh_parameterization::internal::If_range<ImageRange> > // other types are for other overloads
Volume_mesh_parameterization::Parameterization_result
stretch_minimizing_volume_parameterization(PointRange&& points, CellRange&& cells, const TargetRange& targets,
                                           ImageRange& images, const NamedParameters& np = parameters::default_values())
{
  namespace VMP = Volume_mesh_parameterization;
  constexpr bool may_refine = VMP::internal::has_refinement_mode<NamedParameters>;
  const VMP::internal::Arrays_3<PointRange, CellRange> source = { points, cells };
  const auto target = VMP::internal::target_of_point<NamedParameters>(targets, VMP::internal::number_of_rows(points));
  return VMP::internal::parameterize_arrays_3<ConcurrencyTag, may_refine>(source, target, images, np);
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes a map of arrays to the boundary that the named parameter `boundary_parameterizer` finds, by default the unit sphere. The
array `images` is an output only: its previous values are no targets. To prescribe targets, pass four arrays. Arrays that are not
constant are refined if this helps, unless `refinement_mode(Refinement_mode::NONE)` is passed.
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename PointRange, typename CellRange, typename ImageRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          typename = Volume_mesh_parameterization::internal::If_range<PointRange>,
          typename = Volume_mesh_parameterization::internal::If_range<ImageRange> > // other types are for other overloads
Volume_mesh_parameterization::Parameterization_result
stretch_minimizing_volume_parameterization(PointRange&& points, CellRange&& cells, ImageRange& images,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace VMP = Volume_mesh_parameterization;
  constexpr bool may_refine = VMP::internal::has_refinement_mode<CGAL_NP_CLASS>
    || (VMP::internal::is_refinable<PointRange> && VMP::internal::is_refinable<CellRange>);
  const VMP::internal::Arrays_3<PointRange, CellRange> source = { points, cells };
  return VMP::internal::parameterize_arrays_3<ConcurrencyTag, may_refine>(source, VMP::internal::targets_to_be_found(np),
                                                                          images, np);
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes the map of a soup. If the soup may be refined, new cells and marked facets have the references of their origins.

\tparam Soup `Volume_mesh_parameterization::Tetrahedron_soup_3`, which may be `const` if it is not refined
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename Soup, typename TargetRange, typename ImageRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = Volume_mesh_parameterization::internal::If_soup<Soup>,
          typename = Volume_mesh_parameterization::internal::If_range<ImageRange> > // other types are for other overloads
Volume_mesh_parameterization::Parameterization_result
stretch_minimizing_volume_parameterization(Soup& soup, const TargetRange& targets, ImageRange& images,
                                           const NamedParameters& np = parameters::default_values())
{
  namespace VMP = Volume_mesh_parameterization;
  constexpr bool may_refine = VMP::internal::has_refinement_mode<NamedParameters>;
  const auto target = VMP::internal::target_of_point<NamedParameters>(targets, soup.points.size());
  return VMP::internal::parameterize_arrays_3<ConcurrencyTag, may_refine>(VMP::internal::Arrays_of_soup_3<Soup>{ soup }, target,
                                                                          images, np);
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes a map of a soup to the boundary that a boundary parameterizer finds, as for arrays. The array `images` is an output only.
*/
template <typename ConcurrencyTag = Sequential_tag, typename Soup, typename ImageRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          typename = Volume_mesh_parameterization::internal::If_soup<Soup>,
          typename = Volume_mesh_parameterization::internal::If_range<ImageRange> > // other types are for other overloads
Volume_mesh_parameterization::Parameterization_result
stretch_minimizing_volume_parameterization(Soup& soup, ImageRange& images,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace VMP = Volume_mesh_parameterization;
  constexpr bool may_refine = VMP::internal::has_refinement_mode<CGAL_NP_CLASS> || !std::is_const<Soup>::value;
  return VMP::internal::parameterize_arrays_3<ConcurrencyTag, may_refine>(VMP::internal::Arrays_of_soup_3<Soup>{ soup },
                                                                          VMP::internal::targets_to_be_found(np), images, np);
}

} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VOLUME_PARAMETERIZATION_OF_ARRAYS_H
