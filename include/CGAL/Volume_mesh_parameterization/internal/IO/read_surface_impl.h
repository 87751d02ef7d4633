// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_SURFACE_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_SURFACE_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Binary_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Triangulated_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/VTK_arrays.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/read_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <memory_resource>
#include <new>
#include <sstream>
#include <stdexcept>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns whether the triangles of a polygon at its first vertex turn alike, and none is flat. They cover the polygon then.
inline bool is_fan(const Points& polygon)
{
  const Vector_3 origin = to_vector(polygon[0]);
  std::vector<Vector_3> normals;
  Vector_3 sum(0, 0, 0);
  for(std::size_t i = 2; i < polygon.size(); ++i)
  {
    normals.push_back((to_vector(polygon[i - 1]) - origin).cross(to_vector(polygon[i]) - origin));
    sum = sum + normals.back();
  }
  constexpr double tiny = 1e-9; // a guess; the least part of the area
  const double bound = tiny * sum.squaredNorm();
  return std::all_of(normals.begin(), normals.end(), [&](const Vector_3& normal) { return normal.dot(sum) > bound; });
}

// Returns triangles of a polygon in its plane, whose vertices are those of its points; none if the polygon crosses itself.
inline Triangles triangles_of_polygon(const Points& polygon)
{
  using Mesh = Surface_mesh<Exact_predicates_inexact_constructions_kernel::Point_3>;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for(const auto& [x, y, z] : polygon)
    vertices.push_back(mesh.add_vertex({ x, y, z }));
  Triangles result;
  if(!Polygon_mesh_processing::triangulate_face(mesh.add_face(vertices), mesh))
    return result;
  for(const auto face : mesh.faces())
  {
    result.emplace_back();
    auto corner = result.back().begin();
    for(const auto v : vertices_around_face(mesh.halfedge(face), mesh))
      *corner++ = static_cast<std::size_t>(v);
  }
  return result;
}

// Returns a surface as a soup without cells.
template <typename Polygons>
Tetrahedron_soup_3 surface_of_polygons(Points points, const Polygons& polygons)
{
  Tetrahedron_soup_3 result;
  result.points = std::move(points);
  for(const auto& polygon : polygons)
  {
    Points points_of_polygon;
    for(const std::size_t v : polygon)
      points_of_polygon.push_back(result.points[checked_vertex(static_cast<std::int64_t>(v), 0, result.points.size())]);
    Triangles triangles;
    if(polygon.size() > 3 && !is_fan(points_of_polygon))
      triangles = triangles_of_polygon(points_of_polygon);
    if(triangles.empty())
      for(std::size_t i = 2; i < polygon.size(); ++i)
        triangles.push_back({ 0, i - 1, i });
    for(const auto& [i, j, k] : triangles)
      result.facets.push_back({ polygon[i], polygon[j], polygon[k] });
  }
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
  explicit Memory_for_file(const std::size_t size_of_file) : m_bytes_left(1000000 + 100 * size_of_file) {}

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

  std::size_t m_bytes_left;
};

// Returns a text as CGAL's readers expect it: lines of OBJ are not continued, and solids of STL end with one word.
inline std::string text_for_CGAL(std::string text, const std::string& filename)
{
  const auto replace = [&](const std::string& before, const std::string& after)
  {
    for(std::size_t i = text.find(before); i != text.npos; i = text.find(before, i + after.size()))
      text.replace(i, before.size(), after);
  };
  if(has_extension(filename, { ".obj" }))
    for(const char* const end_of_line : { "\\\n", "\\\r\n" })
      replace(end_of_line, " ");
  if(has_extension(filename, { ".stl" }) && text.rfind("solid", 0) == 0)
    replace("end solid", "endsolid ");
  return text;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Tetrahedron_soup_3 read_surface(const std::string& filename, const Budget& budget)
{
  std::string text = read_file(filename, budget);
  if(has_extension(filename, { ".vtp" }))
    return read_VTP(text, budget);
  Memory_for_file memory(text.size());
  std::istringstream is(text_for_CGAL(std::move(text), filename));
  std::pmr::vector<Simple_cartesian<double>::Point_3> points_of_file(&memory);
  std::pmr::vector<std::pmr::vector<std::size_t> > polygons(&memory);
  const auto is_read = [&]()
  {
    try
    {
      return has_extension(filename, { ".off" }) ? CGAL::IO::read_OFF(is, points_of_file, polygons)
        : has_extension(filename, { ".obj" }) ? CGAL::IO::read_OBJ(is, points_of_file, polygons)
        : has_extension(filename, { ".ply" }) ? CGAL::IO::read_PLY(is, points_of_file, polygons)
                                              : CGAL::IO::read_STL(is, points_of_file, polygons);
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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_SURFACE_IMPL_H
