// Targets of the boundary of a mesh in a file: a text, a table, a mesh, or a surface.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGETS_OF_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGETS_OF_FILE_H

#include "CSV_targets.h"
#include "Progress_line.h"
#include "match_surface.h"
#include "read_source.h"

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// A surface as a file has it.
struct Polygons
{
  Points points;
  std::vector<std::vector<std::size_t> > polygons;
};

inline Polygons polygons_of_file(const std::string& filename)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  Polygons result;
  if(!CGAL::IO::read_polygon_soup(filename, points, result.polygons))
    throw CGAL::Volume_mesh_parameterization::Input_error("the surface cannot be read");
  for(const auto& p : points)
    result.points.push_back({ p.x(), p.y(), p.z() });
  return result;
}

// Reads the polygons of an XML file of VTK of the type PolyData, in one piece.
inline Polygons polygons_of_VTP(const std::string& text, const CGAL::Volume_mesh_parameterization::internal::Budget& budget)
{
  namespace internal = CGAL::Volume_mesh_parameterization::internal;
  const internal::VTK_arrays arrays(text, budget, "PolyData");
  Polygons result;
  const std::vector<double> coordinates = arrays.numbers<double>("Points", 3);
  for(std::size_t i = 0; i < coordinates.size(); i += 3)
    result.points.push_back({ coordinates[i], coordinates[i + 1], coordinates[i + 2] });
  const auto vertices = arrays.numbers<std::int64_t>("Polys/connectivity");
  std::size_t begin = 0;
  for(const std::int64_t end : arrays.numbers<std::int64_t>("Polys/offsets"))
  {
    result.polygons.emplace_back();
    for(; begin < vertices.size() && static_cast<std::int64_t>(begin) < end; ++begin)
      result.polygons.back().push_back(static_cast<std::size_t>(vertices[begin]));
  }
  return result;
}

inline Triangles triangles_of(const Polygons& surface)
{
  Triangles result;
  for(const std::vector<std::size_t>& polygon : surface.polygons)
  {
    if(polygon.size() != 3)
      throw CGAL::Volume_mesh_parameterization::Input_error("the surface has a face with " + std::to_string(polygon.size())
                                                            + " vertices");
    result.emplace_back();
    for(std::size_t i = 0; i < 3; ++i)
      result.back()[i] = CGAL::Volume_mesh_parameterization::internal::checked_vertex(
        static_cast<std::int64_t>(polygon[i]), 0, surface.points.size());
  }
  return result;
}

// Calls `read(text, budget)` with the content of a file, and returns its result.
template <typename Read>
auto read_text_file(const std::string& filename, Progress_line& progress, const Read& read)
{
  namespace internal = CGAL::Volume_mesh_parameterization::internal;
  std::decay_t<decltype(read(std::string(), internal::Budget()))> result;
  if(!internal::read_within_limits(CGAL::parameters::visitor(std::ref(progress)), filename, [&](const internal::Budget& budget)
     { result = read(internal::read_file(filename, budget), budget); }))
    throw Interruption();
  return result;
}

// Reads a file *.mesh, which may be a surface if it is MEDIT's as text.
inline Read_targets targets_of_MEDIT_file(const std::string& filename,
                                          const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& mesh,
                                          Progress_line& progress)
{
  namespace internal = CGAL::Volume_mesh_parameterization::internal;
  return read_text_file(filename, progress, [&](const std::string& text, const internal::Budget& budget)
  {
    const bool is_text = !internal::Binary_MEDIT_reader::is_binary(text) && !internal::VTK_arrays::is_VTU(text);
    auto target = is_text
      ? internal::MEDIT_reader(internal::single_process(), internal::Text_scanner(text, budget), false).read(true)
      : internal::read_soup(text, budget);
    return target.cells.empty() ? targets_of_surface(target.points, target.facets, mesh, progress)
                                : Read_targets{ internal::targets_of_mesh(std::move(target), mesh) };
  });
}

// Reads the target of each point of the mesh; not numbers for points without one.
inline Read_targets targets_of_file(const std::string& filename,
                                    const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& mesh, Progress_line& progress)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  const std::string extension = extension_of(filename);
  if(format_of(filename) == Mesh_format::GMSH || format_of(filename) == Mesh_format::VTK)
  {
    VMP::Tetrahedron_soup_3 target = read_mesh(filename, progress);
    return { naming(filename, [&] { return VMP::internal::targets_of_mesh(std::move(target), mesh); }) };
  }
  if(extension == ".csv")
    return { read_text_file(filename, progress, [&](const std::string& text, const VMP::internal::Budget& budget)
                            { return targets_of_CSV(text, mesh.points.size(), budget); }) };
  if(extension == ".vtp")
    return read_text_file(filename, progress, [&](const std::string& text, const VMP::internal::Budget& budget)
    {
      const Polygons surface = polygons_of_VTP(text, budget);
      return targets_of_surface(surface.points, triangles_of(surface), mesh, progress);
    });
  if(format_of(filename) == Mesh_format::SURFACE)
    return naming(filename, [&]
    {
      const Polygons surface = polygons_of_file(filename);
      return targets_of_surface(surface.points, triangles_of(surface), mesh, progress);
    });
  if(extension == ".mesh")
    return targets_of_MEDIT_file(filename, mesh, progress);
  Read_targets targets;
  if(!VMP::IO::read_boundary_targets(filename, mesh, targets.points, CGAL::parameters::visitor(std::ref(progress))))
    throw Interruption();
  return targets;
}

// The library names a boundary vertex without a target by its place; with a file, it has a number.
inline void name_missing_target(const std::string& filename,
                                const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& mesh, const Points& targets)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  for(const std::size_t v : VMP::boundary_vertices(mesh.points, mesh.cells))
    if(std::isnan(targets[v][0]))
      throw VMP::Input_error(filename + ": vertex " + std::to_string(v)
                             + " (counted from 0) is on the boundary of the source, but has no target; --others stay keeps "
                             "the place of such vertices, --others slide lets them move in planes of the boundary");
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGETS_OF_FILE_H
