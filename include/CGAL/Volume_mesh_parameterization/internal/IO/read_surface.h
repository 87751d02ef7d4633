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
#include <CGAL/Volume_mesh_parameterization/internal/IO/Binary_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Triangulated_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/VTK_arrays.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Whole_file.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <filesystem>
#include <fstream>
#include <memory_resource>
#include <new>
#include <stdexcept>

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

// Returns a surface as a soup without cells. Faces with more vertices are split into triangles at their first vertex.
template <typename Polygons>
Tetrahedron_soup_3 surface_of_polygons(Points points, const Polygons& polygons)
{
  Tetrahedron_soup_3 result;
  result.points = std::move(points);
  const auto vertex = [&](const std::size_t v)
  { return checked_vertex(static_cast<std::int64_t>(v), 0, result.points.size()); };
  for(const auto& polygon : polygons)
    for(std::size_t i = 2; i < polygon.size(); ++i)
      result.facets.push_back({ vertex(polygon[0]), vertex(polygon[i - 1]), vertex(polygon[i]) });
  result.facet_references.resize(result.facets.size());
  return result;
}

// Reads the polygons of an XML file of VTK of the type PolyData, in one piece.
inline Tetrahedron_soup_3 read_VTP(const std::string& text, const Budget& budget)
{
  const VTK_arrays arrays(text, budget, "PolyData");
  Points points;
  const std::vector<double> coordinates = arrays.numbers<double>("Points", 3);
  for(std::size_t i = 0; i < coordinates.size(); i += 3)
    points.push_back({ coordinates[i], coordinates[i + 1], coordinates[i + 2] });
  const auto vertices = arrays.numbers<std::int64_t>("Polys/connectivity");
  std::vector<std::vector<std::size_t> > polygons;
  std::size_t begin = 0;
  for(const std::int64_t end : arrays.numbers<std::int64_t>("Polys/offsets"))
  {
    polygons.emplace_back();
    for(; begin < vertices.size() && static_cast<std::int64_t>(begin) < end; ++begin)
      polygons.back().push_back(static_cast<std::size_t>(vertices[begin]));
  }
  return surface_of_polygons(std::move(points), polygons);
}

// Memory for what a file contains, which is a small multiple of its size: counts of damaged files ask for more.
class Memory_for_file : public std::pmr::memory_resource
{
public:
  explicit Memory_for_file(const std::string& filename)
    : m_bytes_left(std::filesystem::is_regular_file(filename) ? 1000000 + 100 * std::filesystem::file_size(filename)
                                                              : (std::numeric_limits<std::uintmax_t>::max)())
  {}

private:
  void* do_allocate(const std::size_t bytes, const std::size_t alignment) override
  {
    if(bytes > m_bytes_left)
      throw std::bad_alloc();
    m_bytes_left -= bytes;
    return std::pmr::new_delete_resource()->allocate(bytes, alignment);
  }

  void do_deallocate(void* const p, const std::size_t bytes, const std::size_t alignment) override
  {
    m_bytes_left += bytes;
    std::pmr::new_delete_resource()->deallocate(p, bytes, alignment);
  }

  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

  std::uintmax_t m_bytes_left;
};

// Reads a surface in a format of CGAL or VTK.
inline Tetrahedron_soup_3 read_surface(const std::string& filename, const Budget& budget)
{
  if(has_extension(filename, { ".vtp" }))
    return read_VTP(read_file(filename, budget), budget);
  if(!std::ifstream(filename)) // CGAL would print that
    throw Input_error("the file cannot be opened");
  Memory_for_file memory(filename);
  std::pmr::vector<Simple_cartesian<double>::Point_3> points_of_file(&memory);
  std::pmr::vector<std::pmr::vector<std::size_t> > polygons(&memory);
  const auto is_read = [&]()
  {
    try
    {
      return CGAL::IO::read_polygon_soup(filename, points_of_file, polygons);
    }
    catch(const std::bad_alloc&) {}
    catch(const std::length_error&) {}
    throw Input_error("the surface cannot be read: a number of points, of faces or of their vertices is too large");
  };
  if(!is_read())
    throw Input_error("the surface cannot be read");
  Points points;
  for(const auto& p : points_of_file)
    points.push_back(coordinates(p));
  return surface_of_polygons(std::move(points), polygons);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_SURFACE_H
