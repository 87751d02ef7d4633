// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VERTEX_CONDITIONS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VERTEX_CONDITIONS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/conditions_of_patches.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/read_surface.h>

#include <optional>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

// Surfaces that lines name, each read once.
class Surfaces_of_files
{
public:
  const Any_surface_3& of_file(const std::string& filename, const Budget& budget)
  {
    if(const auto found = m_surfaces.find(filename); found != m_surfaces.end())
      return found->second;
    try
    {
      const Tetrahedron_soup_3 soup = read_surface(filename, budget);
      return m_surfaces.emplace(filename, Triangulated_surface_3(soup.points, soup.facets)).first->second;
    }
    catch(const Input_error& error)
    {
      throw Input_error(filename + ": " + error.what());
    }
  }

private:
  std::map<std::string, Any_surface_3> m_surfaces;
};

// A line of a file of conditions, and the vertices it is about. `vertices_of(i)` returns the vertices with an index, none if there
// is no such index.
class Line_of_conditions
{
public:
  template <typename VerticesOf>
  Line_of_conditions(Text_scanner line, const Tetrahedron_soup_3& soup, const VerticesOf& vertices_of,
                     Surfaces_of_files& surfaces, const Budget& budget)
    : m_number(line.line())
  {
    read_vertices(line, soup, vertices_of);
    read_condition(line, surfaces, budget);
  }

  const std::set<std::size_t>& vertices() const { return m_vertices; }

  // Adds the facets to a surface, if their vertices are to slide on them.
  void add_to(Own_surface_3<std::size_t>& surface) const
  {
    if(m_condition && m_condition->is_on_own_surface())
      for(const std::array<std::size_t, 3>& facet : m_facets)
        surface.add_facet(facet, m_number);
  }

  // Adds what the line asks for to what is prescribed to a vertex.
  void add_to(Prescribed_position_3& position) const
  {
    if(m_condition)
      m_condition->add_to(position, m_number);
  }

private:
  template <typename VerticesOf>
  void read_vertices(Text_scanner& line, const Tetrahedron_soup_3& soup, const VerticesOf& vertices_of)
  {
    const bool is_quoted = line.is_at_quote();
    const std::string key(is_quoted ? line.next_quoted() : line.next_word());
    if(key == "vertex" && !is_quoted)
    {
      const std::size_t index = line.next_number<std::size_t>("the index of a vertex");
      for(const std::size_t v : vertices_of(index))
        m_vertices.insert(v);
      if(m_vertices.empty())
        line.fail("there is no vertex " + std::to_string(index) + " (counted from 0)");
      return;
    }
    const auto take = [&](const std::set<int>& references)
    {
      for(std::size_t f = 0; f < soup.facets.size(); ++f)
        if(references.count(soup.facet_references[f]) > 0)
        {
          m_facets.push_back(soup.facets[f]);
          m_vertices.insert(soup.facets[f].begin(), soup.facets[f].end());
        }
    };
    int reference;
    if(const auto end = key.data() + key.size(); !is_quoted && std::from_chars(key.data(), end, reference).ptr == end)
      take({ reference });
    if(m_vertices.empty())
      take(references_of_facets(soup, key));
    if(m_vertices.empty())
      line.fail("no triangle of the mesh has the reference or the name " + Text_scanner::quote(key) + ". "
                + names_of_facets(soup));
  }

  // Lists what a line may begin with.
  static std::string names_of_facets(const Tetrahedron_soup_3& soup)
  {
    constexpr std::size_t longest = 20;
    std::vector<std::string> names;
    bool has_blanks = false;
    for(const int reference : std::set<int>(soup.facet_references.begin(), soup.facet_references.end()))
    {
      const auto group = soup.group_names.find({ 2, reference });
      names.push_back(group == soup.group_names.end() ? std::to_string(reference) : Text_scanner::quote(group->second));
      has_blanks = has_blanks || names.back().find(' ') != std::string::npos;
    }
    if(names.empty())
      return "It has no triangles with references; use 'vertex' and an index";
    const std::size_t number_of_others = names.size() - (std::min)(names.size(), longest);
    names.resize(names.size() - number_of_others);
    if(number_of_others > 0)
      names.push_back(std::to_string(number_of_others) + " others");
    const std::string list = listed(names, [](const std::string& name) { return name; });
    return "There are " + list + (has_blanks ? "; names with blanks need quotes" : "");
  }

  void read_condition(Text_scanner& line, Surfaces_of_files& surfaces, const Budget& budget)
  {
    const std::string kind(line.next_word());
    if(kind.size() > 2 && kind[1] == '=' && kind[0] >= 'x' && kind[0] <= 'z')
    {
      Text_scanner value(std::string_view(kind).substr(2), budget, line.line());
      m_condition = Patch_condition_3::coordinate(kind[0] - 'x', value.next_number<double>("a coordinate"));
    }
    else if(kind == "plane")
    {
      std::array<double, 3> normal;
      for(double& x : normal)
        x = line.next_number<double>("a coordinate of the normal");
      if(normal == std::array<double, 3>{})
        line.fail("the normal of a plane is zero");
      m_condition = Patch_condition_3::in_plane_at_start(normal);
    }
    else if(kind == "surface")
    {
      const std::string filename(line.rest().empty() ? "" : line.is_at_quote() ? line.next_quoted() : line.next_word());
      if(filename.empty() && m_facets.empty())
        line.fail("a vertex has no surface of its own; use the file of a surface, or the reference of triangles");
      m_condition = filename.empty() ? Patch_condition_3::on_own_surface()
                                     : Patch_condition_3::on_surface(surfaces.of_file(filename, budget));
    }
    else if(kind == "fixed")
      m_condition = Patch_condition_3::in_place();
    else if(kind != "free")
      line.fail(Text_scanner::quote(kind) + " is not a condition: fixed, free, plane with a normal, x=1, or surface");
    line.expect_end("the condition");
  }

  std::size_t m_number;
  std::set<std::size_t> m_vertices;
  std::vector<std::array<std::size_t, 3> > m_facets;
  std::optional<Patch_condition_3> m_condition; // none if the vertices are free
};

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads the conditions of vertices of a mesh from a file of lines. A line begins with the reference or the name of marked facets,
/// or with `vertex` and an index that starts at 0. A name may stand in quotes, and must if it has blanks, or if it is also a
/// reference of facets. If several groups have a name, the line is about all of them. The condition follows: `fixed`, `free`,
/// `plane` with the three coordinates of a normal, `x=1`, `y=1`, `z=1` with any number, or `surface` with the name of a file of a
/// surface. Without a name, the vertices slide on the facets as they are. A vertex of several lines has all of
/// their conditions; their order does not matter. A coordinate is met to the bit. The rest of a line behind `#` is skipped.
///
/// \param filename the name of the file
/// \param soup the mesh
/// \param vertices_of_index a function that returns the range of the vertices of the mesh for an index in the file, such as the
///        copies of a vertex that was separated. The range is empty if there are none
/// \param conditions gets the condition of each vertex of a line; other elements stay, and new ones are those of free vertices
/// \param targets gets a point that meets the conditions, for each vertex of a line. It is the nearest one to the previous target
///        or, if this is not a number, to the point of the mesh. It has an element for each vertex.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; nothing has changed then.
///
/// \exception Input_error names the file and the wrong line, or lines that contradict each other. Planes must meet within
///            rounding, relative to the diagonal of the mesh, and must not be nearly parallel, with an angle below 1e-9 radians.
///            Nothing has changed then.
template <typename VerticesOfIndex, typename NamedParameters = parameters::Default_named_parameters,
          typename = decltype(std::declval<const VerticesOfIndex&>()(std::size_t()))>
bool read_vertex_conditions(const std::string& filename, const Tetrahedron_soup_3& soup, const VerticesOfIndex& vertices_of_index,
                            std::vector<Vertex_condition_3>& conditions, std::vector<std::array<double, 3> >& targets,
                            const NamedParameters& np = parameters::default_values())
{
  internal::require(targets.size() == soup.points.size(), "targets must have an element for each point.");
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  {
    const std::string text = internal::read_file(filename, budget);
    const double size = internal::diagonal_of_cells(soup);
    internal::Text_scanner scanner(text, budget);
    std::map<std::size_t, internal::Prescribed_position_3> positions;
    internal::Surfaces_of_files surfaces;
    internal::Own_surface_3<std::size_t> own_surface;
    while(!scanner.rest().empty())
    {
      const internal::Line_of_conditions line(scanner.next_line(), soup, vertices_of_index, surfaces, budget);
      line.add_to(own_surface);
      for(const std::size_t v : line.vertices())
        line.add_to(positions.try_emplace(v, std::isnan(targets[v][0]) ? soup.points[v] : targets[v], size).first->second);
    }
    own_surface.add_to([&](const std::size_t v) { return soup.points[v]; },
                       [&](const std::size_t v) -> internal::Prescribed_position_3& { return positions.at(v); });
    std::map<std::size_t, internal::Prescribed_position_3::Solution> solutions;
    for(const auto& [v, position] : positions)
    {
      const auto& solution = solutions.emplace(v, position.solution()).first->second;
      if(!solution.fault.empty())
        throw Input_error(internal::sentence("lines ", internal::listed(solution.sources, [](const std::size_t line)
          { return std::to_string(line); }), " ", solution.fault, " at vertex ", v, " (counted from 0): ", solution.reason));
    }
    conditions.resize(soup.points.size());
    for(const auto& [v, solution] : solutions)
    {
      conditions[v] = solution.condition;
      targets[v] = solution.target;
    }
  });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// does the same where each index in the file is that of the vertex.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_vertex_conditions(const std::string& filename, const Tetrahedron_soup_3& soup,
                            std::vector<Vertex_condition_3>& conditions, std::vector<std::array<double, 3> >& targets,
                            const NamedParameters& np = parameters::default_values())
{
  const auto vertices_of_index = [&](const std::size_t i)
  { return i < soup.points.size() ? std::vector<std::size_t>{ i } : std::vector<std::size_t>(); };
  return read_vertex_conditions(filename, soup, vertices_of_index, conditions, targets, np);
}

} // namespace IO

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VERTEX_CONDITIONS_H
