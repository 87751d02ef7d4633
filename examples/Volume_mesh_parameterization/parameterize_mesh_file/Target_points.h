// Targets of vertices: of those on the boundary, and perhaps of others.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGET_POINTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGET_POINTS_H

#include "Command_line.h"
#include "Named_choices.h"
#include "mend_source.h"

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

enum class Others { MISSING, STAY, SLIDE, FREE };

inline Others named_others(const std::string& name)
{
  return find_name<Others>("way for other vertices", name,
                           { {"missing", Others::MISSING}, {"stay", Others::STAY}, {"slide", Others::SLIDE},
                             {"free", Others::FREE} });
}

// Which vertices inside meet their targets.
enum class Inside { AUTO, FREE, MET };

inline Inside named_inside(const std::string& name)
{
  return find_name<Inside>("way for vertices inside", name,
                           { {"auto", Inside::AUTO}, {"free", Inside::FREE}, {"met", Inside::MET} });
}

struct Target_points
{
  Points points;                    // not numbers for a vertex without a target
  std::vector<char> is_constrained; // vertices inside that meet theirs, and those of the boundary that must not slide
  std::vector<std::size_t> inside = {}; // vertices inside that are to meet theirs
  std::vector<CGAL::Volume_mesh_parameterization::Vertex_condition_3> conditions = {}; // in place of these marks, if there are any
};

inline bool has_target(const Points& points, const std::size_t v) { return !std::isnan(points[v][0]); }

// Adds the points of the source to displacements.
inline void displace(const Points& points, Points& displacements)
{
  for(std::size_t v = 0; v < points.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
      displacements[v][i] += points[v][i];
}

// Vertices whose cells have several references, as those between two materials.
inline std::vector<char> vertices_of_interfaces(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> first_cells(soup.points.size(), none);
  std::vector<char> result(soup.points.size(), false);
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    for(const std::size_t v : soup.cells[c])
    {
      if(first_cells[v] == none)
        first_cells[v] = c;
      result[v] = result[v] || soup.cell_references[first_cells[v]] != soup.cell_references[c];
    }
  return result;
}

// Returns whether each vertex of a cell has a target, as in a copy of the mesh.
inline bool has_all_targets(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup, const Points& targets)
{
  return std::all_of(soup.cells.begin(), soup.cells.end(), [&](const auto& cell)
  { return std::all_of(cell.begin(), cell.end(), [&](const std::size_t v) { return has_target(targets, v); }); });
}

// Returns the vertices that meet their targets if they are inside.
inline std::vector<char> vertices_to_meet(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup,
                                          const Points& targets, const bool are_interfaces_alone)
{
  if(are_interfaces_alone)
    return vertices_of_interfaces(soup);
  std::vector<char> result(soup.points.size(), false);
  for(const auto& cell : soup.cells)
    for(const std::size_t v : cell)
      result[v] = has_target(targets, v);
  return result;
}

// Completes the targets on the boundary. There, vertices need not be met.
inline void complete_boundary(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup, const Others others,
                              Target_points& target, std::vector<char>& is_met)
{
  for(const std::size_t v : CGAL::Volume_mesh_parameterization::boundary_vertices(soup.points, soup.cells))
  {
    is_met[v] = false;
    target.is_constrained[v] = others == Others::SLIDE && has_target(target.points, v);
    if((others == Others::STAY || others == Others::SLIDE) && !has_target(target.points, v))
      target.points[v] = soup.points[v];
  }
}

// Completes the targets of a file. Of a copy of the mesh, vertices at interfaces are met if one of them has moved inside:
// otherwise only the boundary of the copy was moved.
inline Target_points target_points(const Source& source, Points points, const Options& options)
{
  const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup = source.soup;
  Target_points result = { std::move(points), std::vector<char>(soup.points.size(), false) };
  if(options.are_displacements)
    displace(soup.points, result.points);
  const Inside inside = named_inside(options.inside);
  const bool are_interfaces_alone = inside == Inside::AUTO && has_all_targets(soup, result.points);
  std::vector<char> is_met = vertices_to_meet(soup, result.points, are_interfaces_alone);
  const auto has_moved = [&]
  {
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      if(is_met[v] && result.points[v] != soup.points[v])
        return true;
    return false;
  };
  const Others others = named_others(options.others);
  if(are_interfaces_alone && others != Others::SLIDE && !has_moved())
    return result; // without the boundary, for which facets are matched
  complete_boundary(soup, others, result, is_met);
  if(inside == Inside::FREE || (are_interfaces_alone && !has_moved()))
    return result;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(is_met[v])
    {
      result.is_constrained[v] = true;
      result.inside.push_back(v);
    }
  return result;
}

// Keeps the boundary where it is, and inside interfaces and the vertices of triangles.
inline Target_points targets_to_improve(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
{
  Target_points result = { soup.points, vertices_of_interfaces(soup) };
  for(const auto& facet : soup.facets)
    for(const std::size_t v : facet)
      result.is_constrained[v] = true;
  for(const std::size_t v : CGAL::Volume_mesh_parameterization::boundary_vertices(soup.points, soup.cells))
    result.is_constrained[v] = false; // it may slide
  return result;
}

// Finds which vertices are at their targets and which are free: a vertex of the boundary is at its target if it has one, and one
// inside if this is asked for.
inline void free_others(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup, Target_points& target)
{
  using Condition = CGAL::Volume_mesh_parameterization::Vertex_condition_3;
  target.conditions.resize(soup.points.size());
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(target.is_constrained[v])
      target.conditions[v] = Condition::at_target();
  for(const std::size_t v : CGAL::Volume_mesh_parameterization::boundary_vertices(soup.points, soup.cells))
    if(has_target(target.points, v))
      target.conditions[v] = Condition::at_target();
}

// Counts the targets inside that a map meets of those it is to meet.
inline std::size_t number_of_met_targets(const Target_points& target, const Points& images)
{
  return static_cast<std::size_t>(std::count_if(target.inside.begin(), target.inside.end(), [&](const std::size_t v)
  { return target.points[v] == images[v]; }));
}

// Counts the targets that a map meets nowhere: those inside that are not asked for, if it meets the boundary.
inline std::size_t number_of_free_targets(const Target_points& target, const Points& images)
{
  std::size_t result = 0;
  for(std::size_t v = 0; v < target.points.size(); ++v)
    result += has_target(target.points, v) && target.points[v] != images[v];
  return result;
}

// Counts the vertices of cells that have each condition, in the order of its kinds.
inline std::array<std::size_t, 4> numbers_of_conditions(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup,
                                                        const Target_points& target)
{
  std::array<std::size_t, 4> result = {};
  for(const std::size_t v : CGAL::Volume_mesh_parameterization::boundary_vertices(soup.points, soup.cells))
    if(v < target.conditions.size()) // not one of refinement
      ++result[target.conditions[v].kind()];
  return result;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGET_POINTS_H
