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
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

// Marks the facets of the boundary and of interfaces by their surface patches, in a soup that has been made of the complex.
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

template <typename ConcurrencyTag, typename NamedParameters>
Hexahedral_mesh_result hexahedral_mesh_of_map(const Mapped_soup_3& map, const double spacing, Hexahedron_soup_3& mesh,
                                              const NamedParameters& np)
{
  check_named_parameters<internal_np::minimum_scaled_jacobian_t, internal_np::do_keep_interfaces_t>(np);
  require(spacing > 0 && std::isfinite(spacing), "The spacing of a grid is finite and positive.");
  constexpr double poor = 0.01; // a guess; solvers of finite elements want more, but take it
  const double bound = parameter_or(np, internal_np::minimum_scaled_jacobian, poor);
  require(bound <= 1, "A scaled Jacobian is at most 1.");
  Limits<NamedParameters> limits(np);
  Conjugate_gradient_solver_traits_3<ConcurrencyTag> solver;
  Linear_solver_of<Conjugate_gradient_solver_traits_3<ConcurrencyTag> > linear_solver(solver);
  return find_hexahedra_3(map, spacing, linear_solver, is_parallel<ConcurrencyTag>(), limits.budget(), bound,
                          parameter_or(np, internal_np::do_keep_interfaces, true), mesh);
}

} // namespace internal

/*!
\ingroup PkgPolycubeMeshing3Hexahedra

makes hexahedra of a tetrahedral mesh that has been mapped to a box or a polycube: the preimage of a grid.

The grid has the planes of all boundary facets of the domain, those through lines of sharp edges in its faces that are at least
a fifth of the spacing from others, and between two neighboring planes others at equal distances near the spacing. For a
polycube of `Polycube_boundary_parameterizer_3` with the same spacing all boxes are cubes. The boxes inside the domain are
pulled back. So vertices on the boundary of the domain lie on the boundary of the body, and on the edges and corners of the body
that are mapped to edges and corners of the domain. Then vertices move, in a few rounds: each corner of a hexahedron is taken
for a tetrahedron, which is untangled \cgalCite{cgal:gkkrs-ffm-21} and then made similar to the corner of a box by the energy
that untangles, and by its square for the sake of the worst corners. First the vertices inside move, and then all. Vertices on
the boundary move in its tangent planes, and are put back to the nearest points of the boundary after each round; others move
along sharp edges of the body whose images are parallel to an axis, as those on edges of the domain and on lines of a polycube
are. Sharp edges are the marked edges of the soup, or the 1-dimensional features of the complex; if there are none on the
boundary, those with more than 60 degrees between the normals on both sides. The vertex nearest to a marked corner of the soup, or
a 0-dimensional feature of the complex, is moved to it and stays there: along a sharp edge, if the corner is on one, and at most by
the spacing in the domain. A weak pull to their first positions, or, once all corners are positive, of vertices beside the lines to
where they are, keeps steps short, and a strong one draws quadrangles to vertices of the body's boundary that are far from all
quadrangles, so that the boundary remains covered. If the smallest scaled Jacobian is below 0.1 after a round, or below 0.5 after
the last one, vertices move one after the other such that their worst corners become better, and those near points of a boundary
that are far from the other one such that these come nearer. The rounds end when a round raises the mean by less than 0.002. Then
rounds for the worst corners follow as long as they become better: all vertices move by the fourth power of the energy, of boxes
whose edges are as long as those at each corner, so that angles alone count, and then one after the other again. Of corners that
stay below 0.1 the vertices leave the sharp edges and the marked corners, and small parts of the boundary may be left uncovered.
Last, as long as points of both boundaries are farther apart than 0.4 edges and that leads to better hexahedra, quadrangles are
drawn to such points by a pull that is four times as strong each time, and angles alone count there, too.

If normals of quadrangles on both sides of a convex edge of the domain make at most 45 degrees, hexahedra there would be
almost flat: then a layer of hexahedra is put along the faces on both sides, in the manner of Cherchi, Alliez, Scateni, Lyon
and Bommes, Selective padding for polycube-based hexahedral meshing (2019). The layer ends at other convex edges, on the faces
behind: the wall of a cylinder gets a layer, and its ends a ring of quadrangles. If the minimal scaled Jacobian is below 0.2
in the end, the search is made again with one layer along the whole boundary, or, if the layers were this one, without any. If
hexahedra are inverted, or below 0.05, the search with the same layers is made again with vertices that may leave the boundary at
first, where corners are untangled easily: a growing weight draws the vertices back, while Newton steps invert no corner again.

Hexahedra follow the interfaces between subdomains. Each has at first the subdomain that its center is mapped to; some are given
to a neighboring one, such that the surfaces between subdomains are manifolds. The vertices of quadrangles between subdomains
go to the nearest points of the interface: those on the boundary to the line where the interface ends, those between patches
that meet at a sharp edge, with more than 60 degrees between their normals, to the edge, and one to each of its corners;
likewise where more than two subdomains meet. If a hexahedron has two quadrangles in one smooth patch, its subdomain gets a
layer of hexahedra along all interfaces that are joined to this patch. If a quadrangle has two edges in one smooth line between
patches, a further layer encloses the hexahedra on both sides of its patch. Then these vertices slide, too, and in the end those
inside of curved patches move off the interface by a part of the distances of the quadrangles around them, such that both
subdomains keep their volumes. Where the smallest scaled Jacobian would be below 0.02, vertices leave the interface. If hexahedra
remain inverted, or a scaled Jacobian is below 0.05, or interfaces are more than a tenth of the edges away, or not nearer than
those of the grid, then interfaces are tried as staircases, too, as with `do_keep_interfaces(false)`. These are taken if neither
the minimal scaled Jacobian nor the distance of the interfaces gets worse, or if the others are inverted or below 0.05 and these
are better. The result has the volumes of the subdomains
and the distance of the interfaces, and its message tells where this is more than a tenth of the edges.

Quadrangles of the boundary and of interfaces have the references of the marked facets of the soup, or of the surface patches
of the complex, that they lie on.

The best of all meshes is returned: the one with the fewest inverted corners and hexahedra, or, among several, with the largest
sum of the
mean scaled Jacobian and the minimal one, which counts up to 0.5, less 0.3 for each edge by which the boundaries are farther
apart than 0.4 edges, and at most 0.3. Exact arithmetic on the coordinates written checks that all hexahedra are positive all over
them: the Jacobian determinant of the trilinear map of a cube to a hexahedron has 27 Bernstein coefficients, and where these leave
its sign open, the cube is halved (Johnen, Weill and Remacle, Robust and efficient validation of the linear hexahedral element,
2017). A minimum below 1e-12 of the maximum may count as not positive.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are `Sequential_tag`,
        `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points of the tetrahedral mesh, a random access range as
       `CGAL::stretch_minimizing_volume_parameterization()` takes it
\param cells four indices of points each, such that all cells are positive
\param images the image of each point under a map that inverts no cell, as
       `CGAL::stretch_minimizing_volume_parameterization()` writes it
\param spacing the distance of planes of the grid, in the units of the images
\param mesh receives the hexahedra if none is inverted, and is left alone otherwise
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{minimum_scaled_jacobian}
    \cgalParamDescription{the bound below which a scaled Jacobian is answered by `ERROR_POOR_HEXAHEDRON`; the hexahedra are
                          the same for each}
    \cgalParamType{`double`}
    \cgalParamDefault{0.01}
    \cgalParamPrecondition{at most 1}
  \cgalParamNEnd
  \cgalParamNBegin{do_keep_interfaces}
    \cgalParamDescription{whether hexahedra follow the interfaces between subdomains; otherwise these are staircases}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{a limit for the running time in seconds, after which the best mesh so far is returned}
    \cgalParamType{`double`}
    \cgalParamDefault{no limit}
    \cgalParamExtra{A Newton step for all hexahedra that has begun comes to its end. Results that depend on the limit are
                    not reproducible.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{may end the computation, as the limit of time does, and is told of rounds (`Step_kind::ROUND`)}
    \cgalParamType{a model of `ParameterizationVisitor_3`, passed by `std::ref()` if it keeps a state of interest}
    \cgalParamDefault{`Volume_mesh_parameterization::Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the status and where it arises, and the scaled Jacobians: `OK`, also if the computation was ended with a valid
        mesh, as `Hexahedral_mesh_result::is_interrupted` tells; `ERROR_INTERRUPTED` if it was ended
        without one; `ERROR_EMPTY_COMPLEX`; `ERROR_NON_FINITE_COORDINATE`; `ERROR_SIZE_OUT_OF_RANGE` if the diagonal of the
        mesh or of its image is not between 1e-70 and 1e70, or the grid has more than 10^7 boxes, of which each that is
        inside takes 4 kB of memory; `ERROR_INVERTED_SOURCE_CELL` if all points coincide; `ERROR_DOMAIN_NOT_AXIS_PARALLEL`;
        `ERROR_INVERTED_TARGET_BOUNDARY` if the domain has no box; `ERROR_INVERTED_HEXAHEDRON` if a hexahedron is
        not positive all over it; or `ERROR_POOR_HEXAHEDRON`, with the hexahedra, if a scaled Jacobian is below the bound;
        or `ERROR_INCOMPLETE_HEXAHEDRA`, with the hexahedra, if the boundaries are farther apart than edges of hexahedra are long,
        or a subdomain has no hexahedron

\exception Input_error names a cell with an index that does not exist, or tells that a reference is missing.

\pre The spacing is finite and positive, and there are as many images as points; otherwise `CGAL::Precondition_exception` is
     thrown, in every build.

The search takes time O((m + n) log n) for n tetrahedra and m boxes of the box around the domain. A Newton step takes
time linear in the number of hexahedra, plus the solution of a linear system.

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

makes hexahedra of a soup, with its references.
*/
template <typename ConcurrencyTag = Sequential_tag, typename ImageRange,
          typename NamedParameters = parameters::Default_named_parameters>
Hexahedral_mesh_result make_hexahedral_mesh_3(const Tetrahedron_soup_3& soup, const ImageRange& images, const double spacing,
                                       Hexahedron_soup_3& mesh,
                                       const NamedParameters& np = parameters::default_values())
{
  return internal::hexahedral_mesh_of_map<ConcurrencyTag>(
    internal::Mapped_soup_3(soup, internal::coordinates_of(images)), spacing, mesh, np);
}

/*!
\ingroup PkgPolycubeMeshing3Hexahedra

makes hexahedra of a complex. The references of hexahedra are the indices of subdomains, those of quadrangles the indices of
surface patches, if these are integers; otherwise the patches are numbered from 1, in their order. Hexahedra and quadrangles made
of arrays have the reference 0.

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

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_POLYCUBE_MESHING_3_MAKE_HEXAHEDRAL_MESH_3_H
