// Targets of vertices: of those on the boundary, and perhaps of others.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGET_POINTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGET_POINTS_H

#include "Command_line.h"
#include "find_name.h"
#include "mend_source.h"

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

enum class Others { MISSING, STAY, SLIDE };

inline Others named_others(const std::string& name)
{
  return find_name<Others>("way for other vertices", name,
                           { {"missing", Others::MISSING}, {"stay", Others::STAY}, {"slide", Others::SLIDE} });
}

struct Target_points
{
  Points points;                    // not numbers for a vertex without a target
  std::vector<char> is_constrained; // vertices inside that have one, and those of the boundary that must not slide
  std::size_t number_inside = 0;    // number of targets inside that are met
};

inline bool has_target(const Points& points, const std::size_t v) { return !std::isnan(points[v][0]); }

// Completes the targets of a file. If all vertices have one, as in a copy of the mesh, targets inside are not asked for.
inline Target_points target_points(const Source& source, Points points, const Options& options)
{
  const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup = source.soup;
  const Others others = named_others(options.others);
  Target_points result = { std::move(points), std::vector<char>(soup.points.size(), false) };
  if(options.are_displacements)
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      for(std::size_t i = 0; i < 3; ++i)
        result.points[v][i] += soup.points[v][i];

  bool are_all_told = true;
  std::vector<char> is_inside(soup.points.size(), false);
  for(const auto& cell : soup.cells)
    for(const std::size_t v : cell)
    {
      is_inside[v] = true;
      are_all_told = are_all_told && has_target(result.points, v);
    }
  if(are_all_told)
    return result;
  for(const std::size_t v : CGAL::Volume_mesh_parameterization::boundary_vertices(soup.points, soup.cells))
  {
    is_inside[v] = false;
    result.is_constrained[v] = others == Others::SLIDE && has_target(result.points, v);
    if(others != Others::MISSING && !has_target(result.points, v))
      result.points[v] = soup.points[v];
  }
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(is_inside[v] && has_target(result.points, v))
    {
      result.is_constrained[v] = true;
      ++result.number_inside;
    }
  return result;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGET_POINTS_H
