// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_SURFACES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_SURFACES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/repair_surface.h>

namespace CGAL::Volume_mesh_parameterization::IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a surface in a format of \cgal or VTK (`.off`, `.stl`, `.obj`, `.ply` or `.vtp`), as it is. Faces with more vertices are
/// split into triangles: at their first vertex, if these triangles cover the face.
///
/// \param filename the name of the file
/// \param surface gets the points, and the triangles as facets
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; `surface` is then unchanged.
///
/// \exception Input_error names the fault; \c surface is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_surface(const std::string& filename, Tetrahedron_soup_3& surface,
                  const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  { surface = internal::read_surface(filename, budget); });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a surface that is to enclose a body, likewise, and repairs it. Points with the same coordinates are joined, and points at
/// gaps within a distance if that closes the surface. Triangles without area are flipped away, and triangles that are turned over
/// are turned. Points without triangles are removed. Notes of the soup list repairs. A surface without such faults keeps its
/// triangles.
///
/// \param filename the name of the file
/// \param surface gets the points, and the triangles as facets
/// \param joining_distance the distance; 0 stands for 1e-9, 1e-7 or 1e-5 of the diagonal of the bounding box
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; `surface` is then unchanged.
///
/// \exception Input_error names the fault, or an edge at which the surface stays open; \c surface is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_closed_surface(const std::string& filename, Tetrahedron_soup_3& surface, const double joining_distance = 0,
                         const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  { surface = internal::read_closed_surface(filename, joining_distance, budget); });
}

} // namespace CGAL::Volume_mesh_parameterization::IO

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_SURFACES_H
