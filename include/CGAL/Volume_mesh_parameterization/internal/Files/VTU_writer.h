// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_VTU_WRITER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_VTU_WRITER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/config.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Collects an XML `UnstructuredGrid` in the appended form (VTK User's Guide, "VTK XML Formats"): the XML declares arrays with
// their offsets into the data behind it, where each is its number of bytes and its values, as this machine stores them.
class VTU_writer
{
public:
  VTU_writer(const std::size_t number_of_points, const std::size_t number_of_cells)
    : m_xml("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
#ifdef CGAL_LITTLE_ENDIAN
            "LittleEndian"
#else
            "BigEndian"
#endif
            "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
            + std::to_string(number_of_points) + "\" NumberOfCells=\"" + std::to_string(number_of_cells) + "\">\n")
  {}

  void begin(const std::string& element) { m_xml += "<" + element + ">\n"; }
  void end(const std::string& element) { m_xml += "</" + element + ">\n"; }

  // Adds `value(0)`, ..., `value(n - 1)`, converted to `Number`.
  template <typename Number, typename Value>
  void add(const std::string& name, const std::size_t n, const Value& value, const std::size_t number_of_components = 1)
  {
    m_xml += std::string("<DataArray type=\"") + type_name(Number()) + "\" Name=\"" + name + "\" NumberOfComponents=\""
      + std::to_string(number_of_components) + "\" format=\"appended\" offset=\"" + std::to_string(m_data.size())
      + "\"/>\n";
    append(static_cast<std::uint64_t>(n * sizeof(Number)));
    for(std::size_t i = 0; i < n; ++i)
      append(static_cast<Number>(value(i)));
  }

  void add_points(const std::string& name, const std::vector<std::array<double, 3> >& points)
  {
    add<double>(name, 3 * points.size(), [&](const std::size_t i) { return points[i / 3][i % 3]; }, 3);
  }

  // Cells of one type, by the number that VTK gives it.
  template <std::size_t n>
  void add_cells(const std::vector<std::array<std::size_t, n> >& cells, const int type)
  {
    begin("Cells");
    add<std::int32_t>("connectivity", n * cells.size(), [&](const std::size_t i) { return cells[i / n][i % n]; });
    add<std::int64_t>("offsets", cells.size(), [](const std::size_t i) { return n * (i + 1); });
    add<std::uint8_t>("types", cells.size(), [&](std::size_t) { return type; });
    end("Cells");
  }

  void write(std::ostream& os) const
  {
    os << m_xml << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" << m_data
       << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  static const char* type_name(double) { return "Float64"; }
  static const char* type_name(std::uint8_t) { return "UInt8"; }
  static const char* type_name(std::int32_t) { return "Int32"; }
  static const char* type_name(std::int64_t) { return "Int64"; }

  template <typename Number>
  void append(const Number number)
  {
    m_data.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }

  std::string m_xml, m_data;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_VTU_WRITER_H
