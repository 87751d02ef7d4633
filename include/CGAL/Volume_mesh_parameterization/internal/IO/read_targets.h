// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_TARGETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_TARGETS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/MEDIT_reader.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/VTK_references.h>

namespace CGAL::Volume_mesh_parameterization::internal {

struct Target_of_vertex
{
  std::size_t vertex, line;
  std::array<double, 3> point;
};

// Reads lines `vertex_index x y z`.
inline std::vector<Target_of_vertex> read_targets(Text_scanner scanner, const std::size_t number_of_vertices)
{
  std::vector<Target_of_vertex> targets;
  while(!scanner.rest().empty())
  {
    Text_scanner line = scanner.next_line();
    const long long v = line.next_number<long long>("the index of a vertex");
    if(v < 0 || static_cast<unsigned long long>(v) >= number_of_vertices)
      line.fail("vertex " + std::to_string(v) + " does not exist, the mesh has " + std::to_string(number_of_vertices)
                + " vertices, counted from 0");
    targets.push_back({ static_cast<std::size_t>(v), line.line(), next_point(line) });
    line.expect_end("the three coordinates of vertex " + std::to_string(v));
  }
  return targets;
}

// The points of `number` vertices from the first one on; those without a target have coordinates that are not numbers.
inline std::vector<std::array<double, 3> > points_of_vertices(const std::vector<Target_of_vertex>& targets,
                                                              const std::size_t first, const std::size_t number)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, 3> > points(number, {none, none, none});
  for(const Target_of_vertex& target : targets)
  {
    std::array<double, 3>& point = points[target.vertex - first];
    if(!std::isnan(point[0]))
      Text_scanner::fail(target.line, "vertex " + std::to_string(target.vertex) + " has a second line");
    point = target.point;
  }
  return points;
}

// Returns the fields of a line of a table, without blanks and quotes around them.
inline std::vector<std::string> fields_of_line(const std::string_view line, const char separator)
{
  std::vector<std::string> result;
  for(std::size_t begin = 0, end; begin <= line.size(); begin = end + 1)
  {
    end = (std::min)(line.find(separator, begin), line.size());
    const std::string_view field = line.substr(begin, end - begin), around = " \t\r\"";
    const std::size_t first = (std::min)(field.find_first_not_of(around), field.size());
    result.emplace_back(field.substr(first, field.find_last_not_of(around) + 1 - first));
  }
  return result;
}

// The columns of a table: the index of a vertex, or none if each vertex has a row, and its three coordinates.
struct Columns_of_targets
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t index = none;
  std::array<std::size_t, 3> coordinates = { none, none, none };
};

// Finds the columns by the names in the first line.
inline Columns_of_targets columns_of_header(const std::vector<std::string>& header)
{
  std::vector<std::string> names;
  for(const std::string& name : header)
    names.push_back(letters_of_name(name));
  const auto column = [&](const std::string& name)
  {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? Columns_of_targets::none : static_cast<std::size_t>(std::distance(names.begin(), found));
  };
  Columns_of_targets result;
  // a selection has numbers of its own, and those of the mesh that it is from
  for(const char* name : { "vtkoriginalpointids", "pointid", "pointids", "vertexindex", "vertexid", "vertex", "nodeid", "node",
                           "index", "id" })
    if(result.index == Columns_of_targets::none)
      result.index = column(name);
  for(const auto& coordinates : { std::array{ "points0", "points1", "points2" }, std::array{ "pointsx", "pointsy", "pointsz" },
                                  std::array{ "x", "y", "z" } })
  {
    result.coordinates = { column(coordinates[0]), column(coordinates[1]), column(coordinates[2]) };
    if(std::count(result.coordinates.begin(), result.coordinates.end(), Columns_of_targets::none) == 0)
      return result;
  }
  throw Input_error("line 1: there are no columns 'Points:0', 'Points:1' and 'Points:2', or 'x', 'y' and 'z'");
}

// Reads the number that is all of a field.
template <typename Number>
Number number_of_field(const std::vector<std::string>& fields, const std::size_t column, const char* const what,
                      const std::size_t line, const Budget& budget)
{
  const std::string field = column < fields.size() ? fields[column] : "";
  const std::string what_where = what + (" (column " + std::to_string(column + 1) + ")");
  if(field.find_first_of("# \t") != field.npos)
    Text_scanner::fail(line, Text_scanner::quote(field) + " is not " + what_where);
  return Text_scanner(field, budget, line).next_number<Number>(what_where.c_str());
}

// Returns the character between the fields of a line: a comma, or else a semicolon, or else a tab.
inline char separator_of_fields(const std::string_view line)
{
  if(line.find(',') != line.npos)
    return ',';
  return line.find(';') != line.npos ? ';' : '\t';
}

// Reads a table. Without a line of names, its columns are the index of a vertex and three coordinates, or the coordinates alone.
inline std::vector<std::array<double, 3> > targets_of_CSV(const std::string_view text, const std::size_t number_of_vertices,
                                                          const Budget& budget)
{
  const std::string_view first_line = text.substr(0, text.find('\n'));
  const char separator = separator_of_fields(first_line);
  const std::vector<std::string> header = fields_of_line(first_line, separator);
  const bool has_names = header[0].find_first_of("+-.0123456789") != 0;
  const Columns_of_targets without_index = { Columns_of_targets::none, { 0, 1, 2 } }, with_index = { 0, { 1, 2, 3 } };
  const Columns_of_targets columns = has_names ? columns_of_header(header) : header.size() == 3 ? without_index : with_index;
  if(!has_names && header.size() > 4 && !header[4].empty())
    Text_scanner::fail(1, "there are " + std::to_string(header.size()) + " columns. Without a line of names, there must be an "
                          "index and three coordinates, or the coordinates alone");
  std::vector<Target_of_vertex> targets;
  std::size_t number = 0;
  for(std::size_t begin = 0, end; begin < text.size(); begin = end + 1)
  {
    go_on(budget);
    end = (std::min)(text.find('\n', begin), text.size());
    const std::vector<std::string> fields = fields_of_line(text.substr(begin, end - begin), separator);
    if((++number == 1 && has_names) || (fields.size() == 1 && fields[0].empty()))
      continue;
    for(std::size_t column = header.size(); column < fields.size(); ++column)
      if(!fields[column].empty())
        Text_scanner::fail(number, Text_scanner::quote(fields[column]) + " is in column " + std::to_string(column + 1)
                                   + ", but the first line has " + std::to_string(header.size()) + " columns");
    const auto coordinate = [&](const std::size_t i)
    { return number_of_field<double>(fields, columns.coordinates[i], "a finite coordinate", number, budget); };
    const std::size_t v = columns.index == Columns_of_targets::none ? targets.size()
      : number_of_field<std::size_t>(fields, columns.index, "the index of a vertex", number, budget);
    if(v >= number_of_vertices)
      Text_scanner::fail(number, "vertex " + std::to_string(v) + " does not exist, the mesh has "
                                 + std::to_string(number_of_vertices) + " vertices, counted from 0");
    targets.push_back({ v, number, { coordinate(0), coordinate(1), coordinate(2) } });
  }
  if(columns.index == Columns_of_targets::none && targets.size() != number_of_vertices)
    throw Input_error(
      "there is no column with the indices of vertices, such as 'Point ID', but there are " + std::to_string(targets.size())
      + " rows for " + std::to_string(number_of_vertices) + " vertices");
  return points_of_vertices(targets, 0, number_of_vertices);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_TARGETS_H
