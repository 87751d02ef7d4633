// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Whole_file.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns whether a name ends with one of some extensions. Programs for CAD write capitals, too.
inline bool has_extension(const std::string& filename, const std::initializer_list<const char*> extensions)
{
  std::string extension = std::filesystem::path(filename).extension().string();
  for(char& c : extension)
    c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

inline bool is_surface_name(const std::string& filename)
{ return has_extension(filename, { ".off", ".stl", ".ply", ".obj", ".vtp" }); }

// Reads a surface in a format of CGAL or VTK, as it is.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Tetrahedron_soup_3 read_surface(const std::string& filename, const Budget& budget);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/IO/read_surface_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_SURFACE_H
