// Targets of vertices: of those on the boundary, and perhaps of others.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGET_POINTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGET_POINTS_H

#include "Command_line.h"
#include "Named_choices.h"
#include "Progress_line.h"
#include "mend_source.h"

#include <CGAL/Volume_mesh_parameterization/IO/vertex_conditions.h>
#include <CGAL/Volume_mesh_parameterization/Vertex_condition_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
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

// Conditions of vertices, and the targets to which these refer.
struct Target_points
{
  Points points; // not numbers for a vertex without a target
  // Unless the boundary is free, its vertices without a condition slide, or are at their targets.
  std::vector<VMP::Vertex_condition_3> conditions;
  bool is_boundary_free = false;
  std::vector<std::size_t> inside = {}; // vertices inside that are to meet their targets
};

using Condition = VMP::Vertex_condition_3;

inline bool has_target(const Points& points, const std::size_t v) { return !std::isnan(points[v][0]); }

// Adds the points of the source to displacements.
inline void displace(const Points& points, Points& displacements)
{
  for(std::size_t v = 0; v < points.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
      displacements[v][i] += points[v][i];
}

// Vertices whose cells have several references, as those between two materials.
inline std::vector<char> vertices_of_interfaces(const VMP::Tetrahedron_soup_3& soup)
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
inline bool has_all_targets(const VMP::Tetrahedron_soup_3& soup, const Points& targets)
{
  return std::all_of(soup.cells.begin(), soup.cells.end(), [&](const auto& cell)
  { return std::all_of(cell.begin(), cell.end(), [&](const std::size_t v) { return has_target(targets, v); }); });
}

// Returns the vertices that meet their targets if they are inside.
inline std::vector<char> vertices_to_meet(const VMP::Tetrahedron_soup_3& soup, const Points& targets,
                                          const bool are_interfaces_alone)
{
  if(are_interfaces_alone)
    return vertices_of_interfaces(soup);
  std::vector<char> result(soup.points.size(), false);
  for(const auto& cell : soup.cells)
    for(const std::size_t v : cell)
      result[v] = has_target(targets, v);
  return result;
}

// Finds what vertices on the boundary may do if no line is about them. There, vertices need not be met.
inline void complete_boundary(const VMP::Tetrahedron_soup_3& soup, const Options& options,
                              Target_points& target, std::vector<char>& is_met)
{
  const Others others = named_others(options.others);
  for(const std::size_t v : VMP::boundary_vertices(soup.points, soup.cells))
  {
    is_met[v] = false;
    const bool is_given = has_target(target.points, v), stays = others == Others::MISSING || others == Others::STAY;
    const bool moves = options.do_slide ? others != (is_given ? Others::SLIDE : Others::MISSING) : !is_given && !stays;
    target.conditions[v] = moves ? Condition::free() : Condition::at_target();
    if(!is_given && others == Others::STAY)
      target.points[v] = soup.points[v];
  }
}

// Finds what vertices may do by TARGET and the options. Of a copy of the mesh, vertices at interfaces are met if one of them has
// moved inside: otherwise only the boundary of the copy was moved.
inline Target_points target_points(const Source& source, Points points, const Options& options)
{
  const VMP::Tetrahedron_soup_3& soup = source.soup;
  const Others others = named_others(options.others);
  Target_points result = { std::move(points), std::vector<Condition>(soup.points.size()),
                           !options.conditions.empty() || others == Others::FREE };
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
  if(are_interfaces_alone && !result.is_boundary_free && others != Others::SLIDE && !has_moved())
    return result; // without the boundary, for which facets are matched
  complete_boundary(soup, options, result, is_met);
  if(inside == Inside::FREE || (are_interfaces_alone && !has_moved()))
    return result;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(is_met[v])
    {
      result.conditions[v] = Condition::at_target();
      result.inside.push_back(v);
    }
  return result;
}

// Replaces the conditions of vertices for which a file has lines. Returns false if the time is over.
inline bool read_conditions(const Source& source, const Options& options, Progress_line& progress, Target_points& target)
{
  const auto vertices_of_index = [&](const std::size_t index) { return source.vertices_of(index); };
  const auto kinds_of_conditions = [&]
  {
    std::vector<int> result;
    for(const Condition& condition : target.conditions)
      result.push_back(condition.kind());
    return result;
  };
  const std::vector<int> kinds = kinds_of_conditions();
  if(!VMP::IO::read_vertex_conditions(options.conditions, source.soup, vertices_of_index, target.conditions, target.points,
                                      CGAL::parameters::visitor(std::ref(progress))))
    return false;
  if(kinds == kinds_of_conditions() && !options.is_quiet)
    std::cerr << "note: " << options.conditions << ": no line changes the condition of a vertex" << std::endl;
  const auto is_freed = [&](const std::size_t v) { return target.conditions[v].kind() != Condition::AT_TARGET; };
  target.inside.erase(std::remove_if(target.inside.begin(), target.inside.end(), is_freed), target.inside.end());
  return true;
}

// Keeps the boundary where it is, and inside interfaces and the vertices of triangles.
inline Target_points targets_to_improve(const VMP::Tetrahedron_soup_3& soup)
{
  Target_points result = { soup.points, std::vector<Condition>(soup.points.size()) };
  const std::vector<char> is_at_interface = vertices_of_interfaces(soup);
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(is_at_interface[v])
      result.conditions[v] = Condition::at_target();
  for(const auto& facet : soup.facets)
    for(const std::size_t v : facet)
      result.conditions[v] = Condition::at_target();
  for(const std::size_t v : VMP::boundary_vertices(soup.points, soup.cells))
    result.conditions[v] = Condition::free(); // it may slide
  return result;
}

// The library names a boundary vertex without a target by its place; with a file, it has a number.
inline void name_missing_target(const Options& options, const VMP::Tetrahedron_soup_3& mesh, const Target_points& target)
{
  for(const std::size_t v : VMP::boundary_vertices(mesh.points, mesh.cells))
    if(!has_target(target.points, v) && !(target.is_boundary_free && target.conditions[v].kind() == Condition::FREE))
      throw VMP::Input_error((options.target.empty() ? options.conditions : options.target) + ": vertex " + std::to_string(v)
        + " (counted from 0) is on the boundary of the source, but has no target"
        + (options.conditions.empty() ? "" : " and no condition")
        + ". --others stay keeps the positions of such vertices; --others "
        + (options.conditions.empty() ? "slide lets them slide in planes of the boundary" : "free lets them move"));
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

// Counts the vertices of a free boundary that have each condition, in the order of its kinds.
inline std::array<std::size_t, 6> numbers_of_conditions(const VMP::Tetrahedron_soup_3& soup, const Target_points& target)
{
  std::array<std::size_t, 6> result = {};
  if(!target.is_boundary_free)
    return result;
  for(const std::size_t v : VMP::boundary_vertices(soup.points, soup.cells))
    if(v < target.conditions.size()) // not one of refinement
      ++result[target.conditions[v].kind()];
  return result;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGET_POINTS_H
