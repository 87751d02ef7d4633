// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTU_READER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTU_READER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Binary.h>

#include <map>

namespace CGAL::Volume_mesh_parameterization::internal {

// Decodes base64 until there are so many bytes. What is padded may be followed by more, as a header by its data.
inline std::string decoded_base64(const std::string_view text, const std::size_t number_of_bytes, const Budget& budget)
{
  std::string result;
  unsigned int bits = 0;
  int number_of_bits = 0;
  for(std::size_t i = 0; i < text.size() && result.size() < number_of_bytes; ++i)
  {
    if(i % (1 << 16) == 0)
      go_on(budget);
    const char c = text[i];
    const int digit = 'A' <= c && c <= 'Z' ? c - 'A' : 'a' <= c && c <= 'z' ? c - 'a' + 26 : '0' <= c && c <= '9' ? c - '0' + 52
      : c == '+' ? 62 : c == '/' ? 63 : -1;
    if(c == '=')
      number_of_bits = 0;
    if(digit < 0)
      continue; // blanks, too
    bits = bits << 6 | static_cast<unsigned int>(digit);
    number_of_bits += 6;
    if(number_of_bits >= 8)
    {
      number_of_bits -= 8;
      result += static_cast<char>(bits >> number_of_bits & 255);
    }
  }
  return result;
}

// Reads an `UnstructuredGrid` of VTK's XML files (VTK User's Guide, "VTK XML Formats") in one piece: arrays as text, or
// binary without compression, in their place or appended. Tags are read one after the other, without a tree.
class VTU_reader
{
public:
  VTU_reader(const std::string_view text, const Budget& budget) : m_text(text), m_budget(budget) {}

  static bool is_VTU(const std::string_view text)
  { return text.substr(0, 5) == "<?xml" || text.substr(0, 8) == "<VTKFile"; }

  Tetrahedron_soup_3 read()
  {
    find_arrays();
    const std::vector<double> coordinates = numbers<double>("Points", 3);
    const std::vector<std::int64_t> connectivity = numbers<std::int64_t>("Cells/connectivity"),
      ends = numbers<std::int64_t>("Cells/offsets"), types = numbers<std::int64_t>("Cells/types");
    std::vector<std::int64_t> references(types.size(), 0);
    for(const char* name : { "CellData/gmsh:physical", "CellData/medit:ref", "CellData/reference" })
      if(m_arrays.count(name) != 0)
        references = numbers<std::int64_t>(name);
    if(ends.size() != types.size() || references.size() != types.size())
      throw Input_error("the arrays of the cells are not equally long");

    Tetrahedron_soup_3 soup;
    for(std::size_t i = 0; i + 3 <= coordinates.size(); i += 3)
      soup.points.push_back({ checked_coordinate(coordinates[i]), checked_coordinate(coordinates[i + 1]),
                              checked_coordinate(coordinates[i + 2]) });
    std::int64_t begin = 0;
    for(std::size_t c = 0; c < types.size(); begin = ends[c++])
    {
      if(ends[c] < begin || static_cast<std::uint64_t>(ends[c]) > connectivity.size())
        throw Input_error("the offset " + std::to_string(ends[c]) + " of cell " + std::to_string(c)
                          + " (counted from 0) is wrong");
      const auto vertices = connectivity.begin() + begin;
      constexpr std::int64_t triangle = 5, last_of_surfaces = 9, tetrahedron = 10;
      if(types[c] == tetrahedron && ends[c] - begin == 4)
        add(vertices, references[c], soup.points.size(), soup.cells, soup.cell_references);
      else if(types[c] == triangle && ends[c] - begin == 3)
        add(vertices, references[c], soup.points.size(), soup.facets, soup.facet_references);
      else if(types[c] < 1 || types[c] > last_of_surfaces)
        throw Input_error("the mesh is not tetrahedral, it has a cell of VTK's type " + std::to_string(types[c]));
    }
    if(soup.cells.empty())
      throw Input_error("the mesh is not tetrahedral, there is no tetrahedron in the file");
    return soup;
  }

private:
  struct Array
  {
    std::string_view tag, content;
  };

  // The value of an attribute, or what stands for it.
  static std::string attribute(const std::string_view tag, const std::string& name, const std::string& otherwise = "")
  {
    for(const char quote : { '"', '\'' })
    {
      const std::string begin = name + "=" + quote;
      for(std::size_t i = tag.find(begin); i != tag.npos; i = tag.find(begin, i + 1))
        if(i > 0 && std::strchr(" \t\r\n", tag[i - 1]) != nullptr)
          return std::string(tag.substr(i + begin.size(), tag.find(quote, i + begin.size()) - i - begin.size()));
    }
    return otherwise;
  }

  static bool begins(const std::string_view tag, const std::string_view name)
  { return tag.substr(0, name.size()) == name && (tag.size() == name.size() || std::strchr(" \t\r\n/", tag[name.size()])); }

  void find_arrays()
  {
    std::string section;
    std::size_t number_of_pieces = 0;
    for(std::size_t begin = m_text.find('<'), end; begin != m_text.npos; begin = m_text.find('<', end))
    {
      go_on(m_budget);
      if((end = m_text.find('>', begin)) == m_text.npos)
        throw Input_error("the file ends within a tag");
      const std::string_view tag = m_text.substr(begin + 1, end - begin - 1);
      if(begins(tag, "VTKFile"))
        m_header = tag;
      else if(begins(tag, "Piece") && ++number_of_pieces > 1)
        throw Input_error("the mesh has several pieces; merge them into one");
      else if(begins(tag, "Points") || begins(tag, "Cells") || begins(tag, "CellData") || begins(tag, "PointData"))
        section = std::string(tag.substr(0, tag.find_first_of(" \t\r\n/")));
      else if(begins(tag, "DataArray"))
        m_arrays[section == "Points" ? section : section + "/" + attribute(tag, "Name")]
          = { tag, m_text.substr(end + 1, m_text.find('<', end) - end - 1) };
      else if(begins(tag, "AppendedData"))
      {
        m_appended = m_text.substr((std::min)(m_text.find('_', end), m_text.size() - 1) + 1);
        m_is_appended_raw = attribute(tag, "encoding") == "raw";
        break;
      }
    }
    if(attribute(m_header, "type") != "UnstructuredGrid")
      throw Input_error("this is not a VTK XML file of the type UnstructuredGrid");
    if(const std::string compressor = attribute(m_header, "compressor"); !compressor.empty())
      throw Input_error("the file is compressed by " + compressor + "; write it without compression: meshio decompress FILE");
  }

  template <typename Number>
  std::vector<Number> numbers(const std::string& name, const std::size_t multiple_of = 1) const
  {
    const auto found = m_arrays.find(name);
    if(found == m_arrays.end())
      throw Input_error("there is no array " + name);
    const auto& [tag, content] = found->second;
    const std::string format = attribute(tag, "format", "ascii"), type = attribute(tag, "type");
    std::vector<Number> result;
    if(format == "ascii")
      for(Text_scanner scanner(content, m_budget); !scanner.rest().empty(); )
        result.push_back(scanner.next_number<Number>("a number of an array"));
    else
    {
      using Reader = std::vector<Number> (VTU_reader::*)(std::string_view, std::string_view, const std::string&) const;
      static const std::map<std::string, Reader> readers = {
        { "Float32", &VTU_reader::values<Number, float> }, { "Float64", &VTU_reader::values<Number, double> },
        { "Int8", &VTU_reader::values<Number, std::int8_t> }, { "UInt8", &VTU_reader::values<Number, std::uint8_t> },
        { "Int32", &VTU_reader::values<Number, std::int32_t> }, { "UInt32", &VTU_reader::values<Number, std::uint32_t> },
        { "Int64", &VTU_reader::values<Number, std::int64_t> }, { "UInt64", &VTU_reader::values<Number, std::int64_t> } };
      const auto reader = readers.find(type);
      if(reader == readers.end())
        throw Input_error("the array " + name + " has the type '" + type + "'");
      result = (this->*reader->second)(tag, content, format);
    }
    if(result.size() % multiple_of != 0)
      throw Input_error("the array " + name + " is not complete");
    return result;
  }

  // Of an array that begins with its number of bytes.
  template <typename Number, typename Stored>
  std::vector<Number> values(const std::string_view tag, const std::string_view content, const std::string& format) const
  {
    std::string_view data = content;
    if(format == "appended")
    {
      std::size_t offset = 0;
      const std::string digits = attribute(tag, "offset");
      std::from_chars(digits.data(), digits.data() + digits.size(), offset);
      if(offset > m_appended.size())
        throw Input_error("the file ends too early, before the offset " + digits);
      data = m_appended.substr(offset);
    }
    const bool is_raw = format == "appended" && m_is_appended_raw;
    const bool is_swapped = (attribute(m_header, "byte_order") == "BigEndian") == is_little_endian_machine;
    const bool is_long = attribute(m_header, "header_type", "UInt32") == "UInt64";
    const std::size_t size_of_header = is_long ? 8 : 4;

    std::string bytes = is_raw ? "" : decoded_base64(data, size_of_header, m_budget);
    Binary_scanner header(is_raw ? data : bytes, is_swapped);
    const std::uint64_t size = is_long ? header.next<std::uint64_t>() : header.next<std::uint32_t>();
    if(size > data.size())
      throw Input_error("the file ends too early, it has not the " + std::to_string(size) + " bytes of an array");
    if(!is_raw)
      bytes = decoded_base64(data, size_of_header + size, m_budget);
    Binary_scanner scanner(is_raw ? data : bytes, is_swapped);
    scanner.go_to(size_of_header);
    if constexpr(std::is_integral<Number>::value && !std::is_integral<Stored>::value)
      throw Input_error("an array of integers has the type of others");
    std::vector<Number> result;
    for(std::uint64_t i = 0; i < size / sizeof(Stored); ++i)
    {
      if(i % (1 << 16) == 0)
        go_on(m_budget);
      result.push_back(static_cast<Number>(scanner.next<Stored>()));
    }
    return result;
  }

  template <std::size_t N, typename Iterator>
  static void add(const Iterator vertices, const std::int64_t reference, const std::size_t number_of_points,
                  std::vector<std::array<std::size_t, N> >& simplices, std::vector<int>& references)
  {
    simplices.emplace_back();
    for(std::size_t i = 0; i < N; ++i)
      simplices.back()[i] = checked_vertex(vertices[i], 0, number_of_points);
    references.push_back(checked_reference(reference));
  }

  std::string_view m_text, m_header, m_appended;
  const Budget& m_budget;
  bool m_is_appended_raw = false;
  std::map<std::string, Array> m_arrays;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTU_READER_H
