// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CHECK_INPUT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CHECK_INPUT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/projector_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

inline Input_check_3 check_coordinates(const Numbered_mesh_3& mesh)
{
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const Vector_3 point = mesh.source.col(v);
    if(!point.allFinite())
      return failed_check(ERROR_NON_FINITE_COORDINATE, "A vertex of the source has the coordinates ", describe(point), ".");
    if(mesh.initial.cols() > 0 && mesh.initial.col(v).hasInf())
      return failed_check(ERROR_NON_FINITE_COORDINATE, "The initial image of the vertex at ", describe(point),
                          " is ", describe(mesh.initial.col(v)), ".");
    if(v < mesh.number_of_free_vertices) // its target, the base point, is no number either where one of the others is none
      continue;
    const Vector_3 target = mesh.target.col(v);
    if(target.hasNaN())
      return failed_check(ERROR_MISSING_BOUNDARY_TARGET, "The boundary vertex at ", describe(point), " has no target.");
    if(!target.allFinite())
      return failed_check(ERROR_NON_FINITE_COORDINATE, "The target of the boundary vertex at ", describe(point),
                          " is ", describe(target), ".");
  }
  return {};
}

// Refuses surfaces that cannot take their vertices at the start.
inline Input_check_3 check_surfaces(const Numbered_mesh_3& mesh)
{
  constexpr double rounding = 1e-9; // a guess; relative to the coordinates. The end is checked more strictly
  for(std::size_t i = 0; i < mesh.sliding_conditions.size(); ++i)
  {
    const int v = mesh.number_of_free_vertices + static_cast<int>(i);
    if(!mesh.sliding_conditions[i].is_sliding() || mesh.target.col(v).hasNaN())
      continue;
    const Vector_3 p = mesh.target.col(v), q = put_on_surface_3(mesh.sliding_conditions[i], p).first;
    if(!(length_3(q - p) <= rounding * mesh.target.cwiseAbs().maxCoeff()))
      return failed_check(ERROR_MISSING_BOUNDARY_TARGET, "The vertex of the source at ", describe(mesh.source.col(v)),
                          " cannot be put on its surface or curve. It comes to ", describe(p), " first, and to ", describe(q),
                          " from there. ", fault_of_surface);
  }
  return {};
}

// Refuses prescribed points so far from the origin that rounding makes all cells flat, where a part of the boundary is free.
inline Input_check_3 check_distance_from_origin(const Numbered_mesh_3& mesh)
{
  if(!mesh.alignment)
    return {};
  const double coordinate = moved(*mesh.alignment, mesh.source).cwiseAbs().maxCoeff();
  const double size = mesh.alignment->scale * length_3(bounding_box(*mesh.communicator, mesh.source).diagonal());
  if(!(size > 0 && size <= std::numeric_limits<double>::epsilon() * coordinate))
    return {};
  return failed_check(ERROR_SIZE_OUT_OF_RANGE, "The prescribed points are at coordinates of up to ", coordinate,
                      ", where rounding is larger than the image of the body.");
}

inline Input_check_3 check_sizes(const Numbered_mesh_3& mesh)
{
  const Matrix3Xd initial = mesh.initial.unaryExpr([](const double x) { return std::isnan(x) ? 0. : x; });
  const std::pair<Box_3, const char*> boxes[]
    = { { bounding_box(*mesh.communicator, mesh.source), "source" }, { target_box(mesh), "prescribed points" },
        { bounding_box(*mesh.communicator, initial), "initial images" } };
  for(const auto& [box, name] : boxes)
    if(const Input_check_3 check = check_size(box, name); check.status != OK)
      return check;
  return {};
}

inline Input_check_3 check_source_cells(const Numbered_mesh_3& mesh)
{
  const Found_cells inverted = inverted_cells(mesh, mesh.source);
  const double number_of_cells = mesh.global_number_of_cells();
  if(!inverted.first || mesh.regular_cell)
    return {};
  return failed_check(ERROR_INVERTED_SOURCE_CELL,
                      counted(inverted.number, "cell of the source has", "cells of the source have"),
                      " no positive volume. The first one is cell ", mesh.user_number(*inverted.first),
                      " with volume ", edge_matrix(mesh.source, mesh.cells[*inverted.first]).determinant() / 6,
                      static_cast<double>(inverted.number) == number_of_cells ? ". Exchange two vertices of each cell." : ".");
}

// The inverse of the edge matrix of a cell is needed, and it must not invert the cell by rounding.
inline bool has_positive_inverse(const Matrix_3& edges)
{
  const Matrix_3 inverse = edges.inverse();
  return edges.determinant() > 0 && inverse.allFinite() && inverse.determinant() > 0;
}

inline Input_check_3 check_source_determinants(const Numbered_mesh_3& mesh)
{
  const Found_cells flat_cells = find_cells(mesh, [&](const std::array<int, 4>& cell)
  { return !has_positive_inverse(source_edges(mesh, cell)); });
  return !flat_cells.first ? Input_check_3()
    : failed_check(ERROR_INVERTED_SOURCE_CELL, "Cell ", mesh.user_number(*flat_cells.first),
                   " of the source is so flat that its volume is positive in exact arithmetic only.");
}

// Each connected component of the target must have a positive volume, which depends on its boundary only. Where processes
// share the mesh, none knows the components, and they count as one.
inline Input_check_3 check_target_volume(const Numbered_mesh_3& mesh)
{
  if(!mesh.is_boundary_fixed) // the volume is not prescribed, and follows from that of the source
    return reference_volume(mesh) > 0 ? Input_check_3()
      : failed_check(ERROR_INVERTED_TARGET_BOUNDARY, "A part of the boundary may move, and the source has no positive volume.");
  Disjoint_sets components(mesh.number_of_vertices());
  std::vector<double> volumes(mesh.number_of_vertices(), volume(mesh, mesh.target));
  if(mesh.is_whole())
  {
    for(const std::array<int, 4>& cell : mesh.cells)
      for(int i = 1; i < 4; ++i)
        components.unite(cell[0], cell[i]);
    const std::vector<double> volumes_of_cells = values_of_cells(mesh, mesh.cells.size(), [&](const std::array<int, 4>& cell)
    { return edge_matrix(mesh.target, cell).determinant() / 6; });
    std::fill(volumes.begin(), volumes.end(), 0.);
    for(std::size_t c = 0; c < mesh.cells.size(); ++c)
      volumes[components.find(mesh.cells[c][0])] += volumes_of_cells[c];
  }
  const double flat_volume = 1e-12 * std::pow(target_diagonal(mesh), 3);
  for(const std::array<int, 4>& cell : mesh.cells)
    if(const double volume = volumes[components.find(cell[0])]; !(volume > 0))
      return failed_check(ERROR_INVERTED_TARGET_BOUNDARY, "The target boundary encloses the volume ", volume,
                          ", which must be positive: it is ", volume >= -flat_volume ? "flat." : "turned inside out.");
  return {};
}

// Three prescribed vertices on a line make each of their cells flat.
inline bool is_flat_facet(const Numbered_mesh_3& mesh, const std::array<int, 3>& facet)
{
  const auto point = [&](const int i) { return exact_point(mesh.target.col(facet[i])); };
  return std::all_of(facet.begin(), facet.end(), [&](const int v) { return mesh.is_fixed(v); })
         && CGAL::collinear(point(0), point(1), point(2));
}

inline bool has_flat_facet(const Numbered_mesh_3& mesh, const std::array<int, 4>& cell)
{
  const auto& [v, w, x, y] = cell;
  return is_flat_facet(mesh, { v, w, x }) || is_flat_facet(mesh, { v, w, y })
      || is_flat_facet(mesh, { v, x, y }) || is_flat_facet(mesh, { w, x, y });
}

// Refinement splits facets inside the body, but none of the boundary.
inline Input_check_3 check_prescribed_facets(const Numbered_mesh_3& mesh)
{
  const Found_cells flat_cells = find_cells(mesh, [&](const std::array<int, 4>& cell) { return has_flat_facet(mesh, cell); });
  if(!flat_cells.first)
    return {};
  Input_check_3 result
    = failed_check(ERROR_PRESCRIBED_CELL_INVERTED, counted(flat_cells.number, "cell has", "cells have"), " a facet whose three "
                   "vertices are prescribed on a line. The first one is cell ", mesh.user_number(*flat_cells.first), ".");
  if(!mesh.is_whole())
    return result; // which facets are on the boundary is known to all processes together only
  for(const std::array<int, 3>& facet : boundary_facets_3(mesh.cells, mesh.is_parallel))
    if(is_flat_facet(mesh, facet))
    {
      result.is_refinable = false;
      result.message += " No refinement helps: the facet with the vertices at " + describe(mesh.source.col(facet[0]))
                        + ", " + describe(mesh.source.col(facet[1])) + " and " + describe(mesh.source.col(facet[2]))
                        + " is on the boundary. Move one of its targets off the line.";
      break;
    }
  return result;
}

inline Input_check_3 check_prescribed_cells(const Numbered_mesh_3& mesh)
{
  const Found_cells inverted = find_cells(mesh, [&](const std::array<int, 4>& cell)
  {
    return std::all_of(cell.begin(), cell.end(), [&](const int v) { return mesh.is_fixed(v); })
           && !is_positive(mesh.target, cell);
  });
  if(!inverted.first)
    return {};
  return failed_check(ERROR_PRESCRIBED_CELL_INVERTED, counted(inverted.number, "cell has", "cells have"),
                      " four prescribed vertices and no positive volume in the target. The first one is cell ",
                      mesh.user_number(*inverted.first), ".");
}

// Four vertices in one plane make their cell flat, wherever they are there.
inline Input_check_3 check_planes(const Numbered_mesh_3& mesh)
{
  const Found_cells flat = find_cells(mesh, [&](const std::array<int, 4>& cell)
  {
    return !mesh.conditions.empty()
           && are_kept_in_one_plane(cell, [&](const int v) { return mesh.projector(v); },
                                    [&](const int v) { return Vector_3(mesh.target.col(v)); });
  });
  if(!flat.first)
    return {};
  return failed_check(ERROR_PRESCRIBED_CELL_INVERTED, "The conditions keep all vertices of ",
                      counted(flat.number, "cell", "cells"), " in one plane. The first one is cell ",
                      mesh.user_number(*flat.first), ", with a vertex at ", describe(mesh.source.col(mesh.cells[*flat.first][0])),
                      ". Allow refinement (", way_to_refine, "), or free one of its vertices.");
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Input_check_3 check_input_3(const Numbered_mesh_3& mesh, const Budget& budget)
{
  require_operations_as_written();
  if(mesh.global_number_of_cells() == 0)
    return failed_check(ERROR_EMPTY_COMPLEX, get_error_message(ERROR_EMPTY_COMPLEX));
  for(const auto check : { check_surfaces, check_coordinates, check_distance_from_origin, check_sizes, check_source_cells,
                           check_source_determinants, check_target_volume, check_prescribed_facets, check_prescribed_cells,
                           check_planes })
  {
    const Input_check_3 result = check(mesh);
    const auto [code, message] = mesh.communicator->first_failure(result.status, result.message);
    if(code != OK)
      return { static_cast<Error_code>(code), message, result.is_refinable };
    if(!mesh.communicator->all(!budget.is_exhausted()))
      return failed_check(ERROR_INTERRUPTED, get_error_message(ERROR_INTERRUPTED));
  }
  return {};
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CHECK_INPUT_3_H
