// Conditions of vertices, as --others free and a file tell them.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CONDITIONS_OF_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CONDITIONS_OF_FILE_H

#include "Target_points.h"

#include <CGAL/Volume_mesh_parameterization/conditions_of_patches.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Text.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Whole_file.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// Tells which vertices are at their targets and which are free: a vertex of the boundary is at its target if it has one, and one
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

// A line of a file of conditions, and the vertices it is about.
class Line_of_conditions
{
  using Scanner = CGAL::Volume_mesh_parameterization::internal::Text_scanner;

public:
  Line_of_conditions(Scanner line, const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
  {
    read_vertices(line, soup);
    read_condition(line);
  }

  const std::set<std::size_t>& vertices() const { return m_vertices; }

  // Adds what the line asks for to the place of a vertex.
  void add_to(CGAL::Volume_mesh_parameterization::internal::Common_position_3& position) const
  {
    for(int i = 0; i < 3 && m_kind == "fixed"; ++i)
      position.add_plane(Eigen::Vector3d::Unit(i), position.start()[i]);
    if(m_kind == "plane")
      position.add_plane(m_normal, m_offset ? *m_offset : m_normal.dot(position.start()));
  }

private:
  void read_vertices(Scanner& line, const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
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
      line.fail("no triangle of the mesh has the reference or the name " + Scanner::quote(key));
  }

  void read_condition(Scanner& line)
  {
    m_kind = line.next_word();
    const bool is_coordinate = m_kind.size() > 2 && m_kind[1] == '=' && m_kind[0] >= 'x' && m_kind[0] <= 'z';
    if(is_coordinate)
    {
      const CGAL::Volume_mesh_parameterization::internal::Budget budget;
      m_normal = Eigen::Vector3d::Unit(m_kind[0] - 'x');
      m_offset = Scanner(std::string_view(m_kind).substr(2), budget, line.line()).next_number<double>("a coordinate");
      m_kind = "plane";
    }
    else if(m_kind == "plane")
    {
      for(int i = 0; i < 3; ++i)
        m_normal[i] = line.next_number<double>("a coordinate of the normal");
      if(m_normal.isZero(0))
        line.fail("the normal of a plane is zero");
      m_normal = CGAL::Volume_mesh_parameterization::internal::unit_vector_3(m_normal);
    }
    else if(m_kind != "fixed" && m_kind != "free")
      line.fail(Scanner::quote(m_kind) + " is not a condition: fixed, free, plane with a normal, or x=1");
    line.expect_end("the condition");
  }

  std::set<std::size_t> m_vertices;
  std::string m_kind;
  Eigen::Vector3d m_normal = Eigen::Vector3d::Zero();
  std::optional<double> m_offset; // of the plane; through the target if there is none
};

// Reads the conditions of a file. They refer to the target of a vertex, or to where it is if it has none, and replace what is
// told by targets alone. A vertex of several lines has all of their conditions.
inline void read_conditions(const std::string& filename, const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup,
                            Target_points& target)
{
  namespace internal = CGAL::Volume_mesh_parameterization::internal;
  const internal::Budget budget;
  const std::string text = internal::read_file(filename, budget);
  internal::Text_scanner scanner(text, budget);
  std::map<std::size_t, internal::Common_position_3> positions;
  while(!scanner.rest().empty())
  {
    const Line_of_conditions line(scanner.next_line(), soup);
    for(const std::size_t v : line.vertices())
    {
      const Eigen::Vector3d point = internal::to_vector(has_target(target.points, v) ? target.points[v] : soup.points[v]);
      line.add_to(positions.emplace(v, internal::Common_position_3(point)).first->second);
    }
  }
  for(const auto& [v, position] : positions)
  {
    target.conditions[v] = position.condition();
    target.points[v] = internal::coordinates(position.point());
  }
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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CONDITIONS_OF_FILE_H
