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

#include <optional>
#include <set>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

// A line of a file of conditions, and the vertices it is about.
class Line_of_conditions
{
public:
  Line_of_conditions(Text_scanner line, const Tetrahedron_soup_3& soup, const Budget& budget)
  {
    read_vertices(line, soup);
    read_condition(line, budget);
  }

  const std::set<std::size_t>& vertices() const { return m_vertices; }

  // Adds what the line asks for to the place of a vertex.
  void add_to(Common_position_3& position) const
  {
    for(int i = 0; i < 3 && m_kind == "fixed"; ++i)
      position.add_plane(Eigen::Vector3d::Unit(i), position.start()[i]);
    if(m_kind == "plane")
      position.add_plane(m_normal, m_offset ? *m_offset : m_normal.dot(position.start()));
  }

private:
  void read_vertices(Text_scanner& line, const Tetrahedron_soup_3& soup)
  {
    const std::string key(line.next_word());
    if(key == "vertex")
    {
      const std::size_t v = line.next_number<std::size_t>("the index of a vertex");
      if(v >= soup.points.size())
        line.fail("there is no vertex " + std::to_string(v) + " (counted from 0)");
      m_vertices.insert(v);
      return;
    }
    std::optional<int> reference;
    for(const auto& [dimension_and_reference, name] : soup.group_names)
      if(dimension_and_reference.first == 2 && name == key)
        reference = dimension_and_reference.second;
    int number;
    if(const auto end = key.data() + key.size(); !reference && std::from_chars(key.data(), end, number).ptr == end)
      reference = number;
    for(std::size_t f = 0; f < soup.facets.size() && reference; ++f)
      if(soup.facet_references[f] == *reference)
        m_vertices.insert(soup.facets[f].begin(), soup.facets[f].end());
    if(m_vertices.empty())
      line.fail("no triangle of the mesh has the reference or the name " + Text_scanner::quote(key));
  }

  void read_condition(Text_scanner& line, const Budget& budget)
  {
    m_kind = line.next_word();
    const bool is_coordinate = m_kind.size() > 2 && m_kind[1] == '=' && m_kind[0] >= 'x' && m_kind[0] <= 'z';
    if(is_coordinate)
    {
      m_normal = Eigen::Vector3d::Unit(m_kind[0] - 'x');
      m_offset = Text_scanner(std::string_view(m_kind).substr(2), budget, line.line()).next_number<double>("a coordinate");
      m_kind = "plane";
    }
    else if(m_kind == "plane")
    {
      for(int i = 0; i < 3; ++i)
        m_normal[i] = line.next_number<double>("a coordinate of the normal");
      if(m_normal.isZero(0))
        line.fail("the normal of a plane is zero");
      m_normal = unit_vector_3(m_normal);
    }
    else if(m_kind != "fixed" && m_kind != "free")
      line.fail(Text_scanner::quote(m_kind) + " is not a condition: fixed, free, plane with a normal, or x=1");
    line.expect_end("the condition");
  }

  std::set<std::size_t> m_vertices;
  std::string m_kind;
  Eigen::Vector3d m_normal = Eigen::Vector3d::Zero();
  std::optional<double> m_offset; // of the plane; through the target if there is none
};

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads the conditions of vertices of a mesh from a file of lines. A line begins with the reference or the name of marked facets,
/// or with `vertex` and an index that starts at 0. The condition follows: `fixed`, `free`, `plane` with the three coordinates of a
/// normal, or `x=1`, `y=1`, `z=1` with any number. A vertex of several lines has all of their conditions. The rest of a line
/// behind `#` is skipped.
///
/// \param filename the name of the file
/// \param soup the mesh
/// \param conditions gets the condition of each vertex of a line; other elements stay, and new ones are those of free vertices
/// \param targets gets a point that meets the conditions, for each vertex of a line. The search starts from the previous target
///        or, if this is not a number, from the point of the mesh. It has an element for each vertex.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; nothing has changed then.
///
/// \exception Input_error names the file and the wrong line, or the vertex with contradictory conditions. Nothing has changed
///            then.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_vertex_conditions(const std::string& filename, const Tetrahedron_soup_3& soup,
                            std::vector<Vertex_condition_3>& conditions, std::vector<std::array<double, 3> >& targets,
                            const NamedParameters& np = parameters::default_values())
{
  internal::require(targets.size() == soup.points.size(), "targets must have an element for each point.");
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  {
    const std::string text = internal::read_file(filename, budget);
    internal::Text_scanner scanner(text, budget);
    std::map<std::size_t, internal::Common_position_3> positions;
    while(!scanner.rest().empty())
    {
      const internal::Line_of_conditions line(scanner.next_line(), soup, budget);
      for(const std::size_t v : line.vertices())
      {
        const Eigen::Vector3d point = internal::to_vector(std::isnan(targets[v][0]) ? soup.points[v] : targets[v]);
        line.add_to(positions.emplace(v, internal::Common_position_3(point)).first->second);
      }
    }
    conditions.resize(soup.points.size());
    for(const auto& [v, position] : positions)
    {
      conditions[v] = position.condition();
      targets[v] = internal::coordinates(position.point());
    }
  });
}

} // namespace IO

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VERTEX_CONDITIONS_H
