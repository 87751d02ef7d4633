// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_MAKE_HEXAHEDRAL_MESH_3_H
#define CGAL_POLYCUBE_MESHING_3_MAKE_HEXAHEDRAL_MESH_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/Hexahedron_soup_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/find_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Mapped_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/check_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Polycube_meshing_3 {

namespace internal {

// Gives a soup that was made of the complex the facets of surface patches, and their references: integers, or numbers from 1.
template <typename C3t3>
void mark_facets(const C3t3& c3t3, Tetrahedron_soup_3& soup)
{
  using Patch = typename C3t3::Surface_patch_index;
  std::vector<Patch> patches;
  std::vector<std::size_t> sides;
  std::size_t c = 0;
  for(auto cell = c3t3.cells_in_complex_begin(); cell != c3t3.cells_in_complex_end(); ++cell, ++c)
    for(int i = 0; i < 4; ++i)
      if(c3t3.is_in_complex(cell, i)) // from both sides on interfaces
      {
        sides.push_back(4 * c + static_cast<std::size_t>(i));
        patches.push_back(c3t3.surface_patch_index(cell, i));
      }
  soup.facets = facets_of_sides(soup.cells, sides);
  if constexpr(std::is_integral<Patch>::value)
    soup.facet_references.assign(patches.begin(), patches.end());
  else
  {
    std::vector<Patch> different = patches;
    std::sort(different.begin(), different.end());
    different.erase(std::unique(different.begin(), different.end()), different.end());
    for(const Patch& patch : patches)
      soup.facet_references.push_back(
        static_cast<int>(std::lower_bound(different.begin(), different.end(), patch) - different.begin()) + 1);
  }
}

// Checks the parameters, finds hexahedra, and writes them to the mesh if they are valid.
template <typename ConcurrencyTag, typename NamedParameters>
Hexahedral_mesh_result hexahedral_mesh_of_map(const Mapped_soup_3& map, const double spacing, Hexahedron_soup_3& mesh,
                                              const NamedParameters& np)
{
  check_named_parameters<internal_np::minimum_scaled_jacobian_t, internal_np::do_keep_interfaces_t>(np);
  require(spacing > 0 && std::isfinite(spacing), "spacing must be positive and finite.");
  const double bound = parameter_or(np, internal_np::minimum_scaled_jacobian, usable_scaled_jacobian);
  require(bound <= 1, "minimum_scaled_jacobian must be at most 1.");
  Limits<NamedParameters> limits(np);
  Conjugate_gradient_solver_traits_3<ConcurrencyTag> solver;
  Linear_solver_of<Conjugate_gradient_solver_traits_3<ConcurrencyTag> > linear_solver(solver);
  Found_hexahedra_3 found = find_hexahedra_3({ map, spacing, linear_solver, is_parallel<ConcurrencyTag>(), bound,
                                               parameter_or(np, internal_np::do_keep_interfaces, true) }, limits.budget());
  if(found.result.has_valid_mesh)
    mesh = std::move(found.mesh);
  return found.result;
}

} // namespace internal

/*!
\ingroup PkgPolycubeMeshing3Hexahedra

makes hexahedra of a tetrahedral mesh that is mapped to a box or a polycube.

A grid with planes normal to the axes divides the domain into boxes. Each planar part of the boundary of the domain lies on a
plane of the grid. Images of sharp edges also add planes, unless a plane would be too close to another one. The distances of the
other planes are close to the spacing. If the polycube comes from `Polycube_boundary_parameterizer_3` with the same spacing, all
boxes are cubes. The inverse of the map carries the boxes to the body. The function then moves the vertices and returns the best
mesh that it finds.

If the mesh is written, it has these properties:

- The Jacobian determinant of the trilinear map of each hexahedron is positive everywhere. Exact arithmetic on the returned
  coordinates decides this. A determinant whose minimum is below 1e-12 of its maximum may count as not positive. So may one that
  is nearly 0 on a whole surface inside.
- Vertices on the boundary of the domain lie on the boundary of the body, up to rounding. If facets of the body are normal to an
  axis, vertices in their plane have its coordinate exactly.
- An edge or a corner of the domain may be the image of a sharp edge or a corner of the body. Then its vertices lie on this sharp
  edge or corner. If hexahedra would be inverted or nearly flat, vertices may leave them.
- Marked corners of the soup, or 0-dimensional features of the complex, become vertices. Otherwise,
  `Hexahedral_mesh_result::corners_given_up` lists them.
- Each quadrangle on the boundary or on an interface lies on marked facets of the soup, or on a surface patch of the complex. The
  quadrangle has the reference of these.

Sharp edges are the marked edges of the soup, or the 1-dimensional features of the complex. If none of them is on the boundary,
edges with 60 degrees or more between the normals on both sides are sharp.

<b>Quality</b>. First, vertices are moved by an energy that untangles the corners of hexahedra \cgalCite{cgal:gkkrs-ffm-21},
and makes them similar to corners of boxes. Vertices at the worst corners also move one after the other. This ends when neither
the least scaled Jacobian nor the mean gains. Vertices on the boundary slide on it. If an edge of the domain is mapped to a
smooth part of the boundary, a layer of hexahedra is inserted along the adjacent faces. (See Cherchi, Alliez, Scateni, Lyon and
Bommes, Selective padding for polycube-based hexahedral meshing, 2019.) If the hexahedra remain poor, the function also tries
other layers. Fewer inverted hexahedra come first in the comparison of meshes. Then the minimal and the mean scaled Jacobian
and the distance of the boundaries count.

<b>Interfaces</b>. Quadrangles between subdomains follow the interfaces, with their borders, sharp edges and corners. Layers of
hexahedra are inserted if a hexahedron has two quadrangles in a smooth part of an interface. If hexahedra would become nearly
flat, vertices leave sharp edges and borders. If hexahedra stay inverted, their vertices leave the interface. In the end, each
interface moves along its normals so that subdomains keep their volumes. If hexahedra or distances of interfaces are poor,
staircases are tried, too, as with `do_keep_interfaces(false)`. They are not taken if a subdomain loses much more of its volume.
The result contains the volumes of the subdomains and the distance of the interfaces. If this distance exceeds a tenth of the
edges there, the message names the place.

<b>Features</b>. The sharp edges of the boundary are cut into curves, which end at corners, and bound patches. If the hexahedra
lose some of them, the function looks for vertices of the boundary for all corners, and for disjoint paths of edges for all
curves. Edges of the boundary between subdomains have paths, too. Corners that are joined by a curve shorter than a tenth of an
edge share a vertex. Curves that leave a corner with less than 11 degrees between them share their first edge, or with less
than 7 degrees, if fewer curves are given up then. Paths compete for vertices by prices that grow. If this does not end, or a
path leaves its patch on the wrong side, curves are given up one by one. A layer of hexahedra is inserted along the boundary,
and removed again where each hexahedron under it has 50 to 130 degrees of the angle between patches. Sheets are inserted around
patches in which a quadrangle would have two edges on a smooth curve. If a curve has more bends than its path has edges, sheets
of hexahedra across the path are cut in two. So are sheets where curves were given up because others left no room, if fewer
curves are given up then. These add at most half of the hexahedra. Vertices stay at bends. All others move along curves, in
patches and on interfaces. If a scaled Jacobian would be below 0.01, or a hexahedron inverted inside, its vertices leave
curves. If this is not enough, all of the layer stays, and then the shortest curve near each such hexahedron is given up, in
five attempts altogether. The mesh is taken if it is valid, no scaled Jacobian is below `minimum_scaled_jacobian`, its boundary
is at most half an edge off that of the body, or no farther than before, and it keeps more features and no marked corner less.
Interfaces must be within a tenth of an edge, or no farther than before. This is tried with the first valid hexahedra of one
subdomain, and if it fails, or there are several, with the best ones. If both fail, the mesh remains as it was.
`Hexahedral_mesh_result::features` lists what is kept and what is not, and the message names a place. The mesh has the edges
along curves and the corners that are kept.

<b>Validity</b>. The 27 Bernstein coefficients of the determinant bound its sign. If they leave the sign open, the hexahedron is
subdivided (Johnen, Weill and Remacle, Robust and efficient validation of the linear hexahedral element, 2017).

<b>Complexity</b>. The grid takes time O((m + n) log n) for n tetrahedra and m boxes in the bounding box of the domain. A Newton
step takes time linear in the number of hexahedra, plus the solution of a sparse linear system.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are `Sequential_tag`,
        `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points of the tetrahedral mesh, a random access range as in
       `CGAL::stretch_minimizing_volume_parameterization()`
\param cells the cells, each with four indices of points; each cell has a positive orientation
\param images the image of each point, by a map that inverts no cell, for instance of
       `CGAL::stretch_minimizing_volume_parameterization()`
\param spacing the distance of the planes of the grid, in the units of the images
\param mesh receives the hexahedra if none of them is inverted, and does not change otherwise
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

<b>Common</b>

\cgalNamedParamsBegin
  \cgalParamNBegin{do_keep_interfaces}
    \cgalParamDescription{whether hexahedra follow the interfaces between subdomains; if not, interfaces are staircases}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{a limit for the running time in seconds, after which the best mesh found so far is returned}
    \cgalParamType{`double`}
    \cgalParamDefault{no limit}
    \cgalParamExtra{A Newton step is finished first. Results that depend on the limit are not reproducible.}
    \cgalParamPrecondition{The value is a number, and not negative.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an object that is called in each round (`Step_kind::ROUND`), and may end the computation}
    \cgalParamType{a model of `ParameterizationVisitor_3`, passed by `std::ref()` if it keeps a state of interest}
    \cgalParamDefault{`Volume_mesh_parameterization::Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

<b>For experts</b>

\cgalNamedParamsBegin
  \cgalParamNBegin{minimum_scaled_jacobian}
    \cgalParamDescription{the bound of the scaled Jacobian below which the status is `ERROR_POOR_HEXAHEDRON`}
    \cgalParamType{`double`}
    \cgalParamDefault{0.01}
    \cgalParamExtra{The hexahedra do not depend on this bound.}
    \cgalParamPrecondition{The value is at most 1.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the status with its place, the scaled Jacobians, volumes and distances. The status is one of the following.
- `OK`: the mesh is valid.
- `ERROR_POOR_HEXAHEDRON`: the mesh is valid and written, but a scaled Jacobian is below the bound.
- `ERROR_INCOMPLETE_HEXAHEDRA`: the mesh is valid and written, but deviates from the body. The boundaries are farther apart than
  half an edge of a hexahedron or a tenth of the diagonal of the body. Or an interface that hexahedra follow is farther away than
  half an edge. Or a subdomain of several has no hexahedron, or hexahedra follow its interfaces and its volume differs by more
  than 2 %.
- `ERROR_INVERTED_HEXAHEDRON`: the Jacobian determinant of a hexahedron is not positive everywhere.
- `ERROR_INTERRUPTED`: the computation was ended early. If `Hexahedral_mesh_result::has_valid_mesh` is set, the mesh is written.
  With the other values for a valid mesh, `Hexahedral_mesh_result::is_interrupted` tells whether it was ended early.
- `ERROR_EMPTY_COMPLEX`: there is no cell.
- `ERROR_NON_FINITE_COORDINATE`: a coordinate is infinite or not a number.
- `ERROR_SIZE_OUT_OF_RANGE`: the diagonal of the mesh or of its image is not between 1e-70 and 1e70, or the grid has more than
  10<sup>7</sup> boxes. Each box inside the domain takes about 4 kB of memory.
- `ERROR_INVERTED_SOURCE_CELL`: all points coincide.
- `ERROR_DOMAIN_NOT_AXIS_PARALLEL`: a facet on the boundary of the domain is not normal to an axis.
- `ERROR_INVERTED_TARGET_BOUNDARY`: no box is inside the domain.

\exception Input_error if a cell has an index that does not exist, or if a reference is missing; the message names the place.

\pre The spacing is finite and positive, and there are as many images as points. Otherwise, `CGAL::Precondition_exception` is
     thrown in every build.

\sa `Volume_map_3`
\sa `Polycube_boundary_parameterizer_3`
\sa `IO::write_VTU()`
\sa `IO::write_MEDIT()`
\sa `IO::write_INP()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename CellRange, typename ImageRange,
          typename NamedParameters = parameters::Default_named_parameters>
Hexahedral_mesh_result make_hexahedral_mesh_3(const PointRange& points, const CellRange& cells, const ImageRange& images,
                                       const double spacing,
                                       Hexahedron_soup_3& mesh,
                                       const NamedParameters& np = parameters::default_values())
{
  return internal::hexahedral_mesh_of_map<ConcurrencyTag>(
    internal::Mapped_soup_3(internal::soup_of(points, cells), internal::coordinates_of(images)), spacing, mesh, np);
}

/*!
\ingroup PkgPolycubeMeshing3Hexahedra

makes hexahedra of a soup, with its references. All else is as for arrays.
*/
template <typename ConcurrencyTag = Sequential_tag, typename ImageRange,
          typename NamedParameters = parameters::Default_named_parameters>
Hexahedral_mesh_result make_hexahedral_mesh_3(const Volume_mesh_parameterization::Tetrahedron_soup_3& soup,
                                              const ImageRange& images, const double spacing, Hexahedron_soup_3& mesh,
                                              const NamedParameters& np = parameters::default_values())
{
  return internal::hexahedral_mesh_of_map<ConcurrencyTag>(
    internal::Mapped_soup_3(soup, internal::coordinates_of(images)), spacing, mesh, np);
}

/*!
\ingroup PkgPolycubeMeshing3Hexahedra

makes hexahedra of a complex. The reference of a hexahedron is the index of its subdomain. If the indices of surface patches are
integers, they are the references of quadrangles. Otherwise, patches are numbered from 1 in ascending order. If arrays are given in
place of a complex, all references are 0.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3` whose type `Subdomain_index` is an integer type
\tparam VertexUVWMap a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
        `C3t3::Triangulation::Geom_traits::Point_3` as value type
\tparam NamedParameters as above

\param c3t3 the complex
\param uvw_map the image of each vertex of a cell
\param spacing as above
\param mesh as above
\param np as above

\return the same as for arrays
*/
template <typename ConcurrencyTag = Sequential_tag, typename C3t3, typename VertexUVWMap,
          typename NamedParameters = parameters::Default_named_parameters>
Hexahedral_mesh_result make_hexahedral_mesh_3(const C3t3& c3t3, const VertexUVWMap uvw_map, const double spacing,
                                       Hexahedron_soup_3& mesh,
                                       const NamedParameters& np = parameters::default_values())
{
  internal::Mapped_soup_3 map(c3t3, uvw_map);
  internal::mark_facets(c3t3, map);
  return internal::hexahedral_mesh_of_map<ConcurrencyTag>(map, spacing, mesh, np);
}

} // namespace CGAL::Polycube_meshing_3

#endif // CGAL_POLYCUBE_MESHING_3_MAKE_HEXAHEDRAL_MESH_3_H
