// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTU_WRITER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTU_WRITER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <cstdint>
#include <ostream>

namespace CGAL::Volume_mesh_parameterization::internal {

// Cells of a type, by the number that VTK gives it.
template <std::size_t n>
struct VTU_cells
{
  const std::vector<std::array<std::size_t, n> >& cells;
  int type;
};

// Text as the value of an attribute.
inline std::string XML_escaped(const std::string& text)
{
  std::string result;
  for(const char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

// Collects an XML file of an unstructured grid in the appended form (VTK User's Guide, "VTK XML Formats"): the XML declares arrays
// by their offsets into the data behind it, where each is its number of bytes and its values, as this machine stores them.
class VTU_writer
{
public:
  // Begins with points, and cells of one or more types.
  template <std::size_t... n>
  VTU_writer(const std::vector<std::array<double, 3> >& points, const VTU_cells<n>&... cells)
    : m_xml("<Piece NumberOfPoints=\"" + std::to_string(points.size()) + "\" NumberOfCells=\""
            + std::to_string((cells.cells.size() + ...)) + "\">\n")
  {
    std::vector<std::size_t> vertices, ends;
    std::vector<int> types;
    const auto add_cells = [&](const auto& all, const int type)
    {
      for(const auto& cell : all)
      {
        vertices.insert(vertices.end(), cell.begin(), cell.end());
        ends.push_back(vertices.size());
        types.push_back(type);
      }
    };
    (add_cells(cells.cells, cells.type), ...);
    begin("Points");
    add_points("Points", points);
    end("Points");
    begin("Cells");
    add<std::int32_t>("connectivity", vertices.size(), [&](const std::size_t i) { return vertices[i]; });
    add<std::int64_t>("offsets", ends.size(), [&](const std::size_t i) { return ends[i]; });
    add<std::uint8_t>("types", types.size(), [&](const std::size_t i) { return types[i]; });
    end("Cells");
  }

  void begin(const std::string& element) { m_xml += "<" + element + ">\n"; }
  void end(const std::string& element) { m_xml += "</" + element + ">\n"; }

  // Adds arrays of a reference and a dimension, as meshio does.
  void add_names(const std::map<std::pair<int, int>, std::string>& names)
  {
    if(names.empty())
      return;
    std::swap(m_head, m_xml);
    begin("FieldData");
    for(const auto& [group, name] : names)
    {
      const int values[] = { group.second, group.first };
      add<std::int32_t>(name, 2, [&](const std::size_t i) { return values[i]; }, 1, " NumberOfTuples=\"2\"");
    }
    end("FieldData");
    std::swap(m_head, m_xml);
  }

  // Adds `value(0)`, ..., `value(n - 1)`, converted to `Number`.
  template <typename Number, typename Value>
  void add(const std::string& name, const std::size_t n, const Value& value, const std::size_t number_of_components = 1,
           const char* attributes = "")
  {
    declare_array(type_name(Number()), name, number_of_components, attributes);
    append(static_cast<std::uint64_t>(n * sizeof(Number)));
    for(std::size_t i = 0; i < n; ++i)
      append(static_cast<Number>(value(i)));
  }

  void add_points(const std::string& name, const std::vector<std::array<double, 3> >& points)
  { add<double>(name, 3 * points.size(), [&](const std::size_t i) { return points[i / 3][i % 3]; }, 3); }

  void write(std::ostream& os) const
  {
    os << m_head << m_xml << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" << m_data
       << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  static const char* type_name(double) { return "Float64"; }
  static const char* type_name(std::uint8_t) { return "UInt8"; }
  static const char* type_name(std::int32_t) { return "Int32"; }
  static const char* type_name(std::int64_t) { return "Int64"; }

  void declare_array(const char* type, const std::string& name, const std::size_t number_of_components, const char* attributes)
  {
    m_xml += std::string("<DataArray type=\"") + type + "\" Name=\"" + XML_escaped(name) + "\"" + attributes;
    if(number_of_components > 1) // one is the default; if it is written, meshio does not convert the array
      m_xml += " NumberOfComponents=\"" + std::to_string(number_of_components) + "\"";
    m_xml += " format=\"appended\" offset=\"" + std::to_string(m_data.size()) + "\"/>\n";
  }

  template <typename Number>
  void append(const Number number) { m_data.append(reinterpret_cast<const char*>(&number), sizeof(number)); }

  std::string m_head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
#ifdef CGAL_LITTLE_ENDIAN
    "LittleEndian"
#else
    "BigEndian"
#endif
    "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  std::string m_xml, m_data;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTU_WRITER_H
