// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTK_ARRAYS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTK_ARRAYS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Binary_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/decompress.h>

#include <map>

namespace CGAL::Volume_mesh_parameterization::internal {

// Decodes the first bytes of a text in base64. Padding does not end the text, as a header may be followed by its data.
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

// The arrays of a VTK XML file of a type (VTK User's Guide, "VTK XML Formats") in one piece, by the name
// of their section and their own, as `CellData/reference`: as text, or binary, compressed or not, in their place or
// appended. Tags are read one after the other, without a tree.
class VTK_arrays
{
public:
  VTK_arrays(const std::string_view text, const Budget& budget, const std::string& type = "UnstructuredGrid")
    : m_text(text), m_budget(budget)
  { find_arrays(type); }

  static bool is_VTU(const std::string_view text)
  { return text.substr(0, 5) == "<?xml" || text.substr(0, 8) == "<VTKFile"; }

  bool has(const std::string& name) const { return m_arrays.count(name) != 0; }

  // The names of the arrays of a section.
  std::vector<std::string> names(const std::string& section) const
  {
    std::vector<std::string> result;
    for(const auto& [name, array] : m_arrays)
      if(begins(name, section))
        result.push_back(name.substr(section.size() + 1));
    return result;
  }

  bool has_integers(const std::string& name) const
  { return attribute(m_arrays.at(name).tag, "type").find("Int") != std::string::npos; }

  std::size_t number_of_components(const std::string& name) const
  {
    return (std::max)(number(m_arrays.at(name).tag, "NumberOfComponents", "1"), std::size_t(1));
  }

  // Throws unless the piece has as many points, or cells, as it says.
  void check_number(const char* what, const std::size_t number_of_elements) const
  {
    const std::size_t stated = number(m_piece, what, std::to_string(number_of_elements));
    if(stated != number_of_elements)
      throw Input_error(std::string(what) + " is " + std::to_string(stated) + ", but the arrays have "
                        + std::to_string(number_of_elements));
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
      using Reader = std::vector<Number> (VTK_arrays::*)(const std::string&) const;
      static const std::map<std::string, Reader> readers = {
        { "Float32", &VTK_arrays::values<Number, float> }, { "Float64", &VTK_arrays::values<Number, double> },
        { "Int8", &VTK_arrays::values<Number, std::int8_t> }, { "UInt8", &VTK_arrays::values<Number, std::uint8_t> },
        { "Int16", &VTK_arrays::values<Number, std::int16_t> }, { "UInt16", &VTK_arrays::values<Number, std::uint16_t> },
        { "Int32", &VTK_arrays::values<Number, std::int32_t> }, { "UInt32", &VTK_arrays::values<Number, std::uint32_t> },
        { "Int64", &VTK_arrays::values<Number, std::int64_t> }, { "UInt64", &VTK_arrays::values<Number, std::int64_t> } };
      const auto reader = readers.find(type);
      if(reader == readers.end())
        throw Input_error("the array " + name + " has the type '" + type + "'");
      result = (this->*reader->second)(bytes(tag, content, format));
    }
    if(result.size() % multiple_of != 0)
      throw Input_error("the array " + name + " is not complete");
    return result;
  }

private:
  struct Array
  {
    std::string_view tag, content;
  };

  // Unlike std::strchr(), does not find the character 0.
  static bool is_one_of(const char c, const std::string_view characters) { return characters.find(c) != characters.npos; }

  // Returns the value of an attribute, or `otherwise` if the tag has none.
  static std::string attribute(const std::string_view tag, const std::string& name, const std::string& otherwise = "")
  {
    for(const char quote : { '"', '\'' })
    {
      const std::string begin = name + "=" + quote;
      for(std::size_t i = tag.find(begin); i != tag.npos; i = tag.find(begin, i + 1))
        if(i > 0 && is_one_of(tag[i - 1], " \t\r\n"))
          return std::string(tag.substr(i + begin.size(), tag.find(quote, i + begin.size()) - i - begin.size()));
    }
    return otherwise;
  }

  static std::size_t number(const std::string_view tag, const std::string& name, const std::string& otherwise = "")
  {
    const std::string digits = attribute(tag, name, otherwise);
    std::size_t result = 0;
    const std::from_chars_result end = std::from_chars(digits.data(), digits.data() + digits.size(), result);
    if(end.ec != std::errc() || end.ptr != digits.data() + digits.size())
      throw Input_error("the attribute " + name + " is " + Text_scanner::quote(digits) + " instead of a number");
    return result;
  }

  static std::string without_entities(std::string text)
  {
    const std::pair<const char*, const char*> entities[]
      = { { "&lt;", "<" }, { "&gt;", ">" }, { "&quot;", "\"" }, { "&apos;", "'" }, { "&amp;", "&" } };
    for(const auto& [entity, character] : entities)
      for(std::size_t i = text.find(entity); i != text.npos; i = text.find(entity, i + 1))
        text.replace(i, std::strlen(entity), character);
    return text;
  }

  static bool begins(const std::string_view tag, const std::string_view name)
  {
    return tag.substr(0, name.size()) == name && (tag.size() == name.size() || is_one_of(tag[name.size()], " \t\r\n/"));
  }

  static bool is_section(const std::string_view tag)
  {
    const char* const sections[]
      = { "Points", "Cells", "CellData", "PointData", "FieldData", "Verts", "Lines", "Strips", "Polys" };
    return std::any_of(std::begin(sections), std::end(sections), [&](const char* const name) { return begins(tag, name); });
  }

  // A value of an attribute may have the sign that ends a tag.
  std::size_t end_of_tag(const std::size_t begin) const
  {
    const std::string_view name = m_text.substr(begin + 1, 1);
    std::size_t end = begin;
    do
    {
      end = m_text.find_first_of(name == "!" || name == "?" ? ">" : ">\"'", end + 1);
      if(end == m_text.npos || m_text[end] == '>')
        return end;
      end = m_text.find(m_text[end], end + 1);
    }
    while(end != m_text.npos);
    return end;
  }

  void find_arrays(const std::string& type)
  {
    std::string section;
    std::size_t number_of_pieces = 0;
    for(std::size_t begin = m_text.find('<'), end; begin != m_text.npos; begin = m_text.find('<', end))
    {
      go_on(m_budget);
      if((end = end_of_tag(begin)) == m_text.npos)
        throw Input_error("the file ends within a tag");
      const std::string_view tag = m_text.substr(begin + 1, end - begin - 1);
      if(begins(tag, "VTKFile"))
        m_header = tag;
      else if(begins(tag, "Piece"))
      {
        ++number_of_pieces;
        m_piece = tag;
      }
      else if(is_section(tag))
        section = std::string(tag.substr(0, tag.find_first_of(" \t\r\n/")));
      else if(begins(tag, "DataArray"))
        m_arrays[section == "Points" ? section : section + "/" + without_entities(attribute(tag, "Name"))]
          = { tag, m_text.substr(end + 1, m_text.find('<', end) - end - 1) };
      else if(begins(tag, "AppendedData"))
      {
        m_appended = m_text.substr((std::min)(m_text.find('_', end), m_text.size() - 1) + 1);
        m_is_appended_raw = attribute(tag, "encoding") == "raw";
        break;
      }
    }
    if(attribute(m_header, "type") != type)
      throw Input_error("this is not a VTK XML file of the type " + type);
    if(number_of_pieces > 1)
      throw Input_error("the mesh has several pieces: save it in ParaView as one piece, and use --merge-points");
  }

  // The bytes of an array, without their number or, if they are compressed, the sizes of blocks in front of them.
  std::string bytes(const std::string_view tag, const std::string_view content, const std::string& format) const
  {
    std::string_view data = content;
    if(format == "appended")
    {
      const std::size_t offset = number(tag, "offset");
      if(offset > m_appended.size())
        throw Input_error("the file ends too early, before the offset " + std::to_string(offset));
      data = m_appended.substr(offset);
    }
    const auto decoded = [&](const std::size_t n) // bytes from the first one on
    {
      return format == "appended" && m_is_appended_raw ? std::string(data.substr(0, n)) : decoded_base64(data, n, m_budget);
    };
    const bool is_long = attribute(m_header, "header_type", "UInt32") == "UInt64";
    const std::size_t size_of_number = is_long ? 8 : 4;
    const auto sizes = [&](const std::size_t n) // the first n numbers
    {
      if(n > data.size())
        throw Input_error("the file ends too early, it has not the " + std::to_string(n) + " sizes of an array");
      const std::string header = decoded(n * size_of_number);
      Binary_scanner scanner(header, is_swapped());
      std::vector<std::size_t> result;
      for(std::size_t i = 0; i < n; ++i)
        result.push_back(is_long ? scanner.next<std::uint64_t>() : scanner.next<std::uint32_t>());
      return result;
    };
    const auto without_header = [&](const std::size_t number_of_sizes, const std::size_t size)
    {
      if(size > data.size())
        throw Input_error("the file ends too early, it has not the " + std::to_string(size) + " bytes of an array");
      return decoded(number_of_sizes * size_of_number + size).substr(number_of_sizes * size_of_number);
    };

    const std::string compressor = attribute(m_header, "compressor");
    const std::size_t first = sizes(1)[0];
    if(compressor.empty())
      return without_header(1, first);
    // the number of blocks, the size of one, that of the last one if this is smaller, and how large each is compressed
    const std::vector<std::size_t> header = sizes((std::min)(first, data.size()) + 3);
    std::size_t size = 0;
    for(std::size_t i = 3; i < header.size() && size <= data.size(); ++i)
      size += (std::min)(header[i], data.size() + 1);
    const std::string blocks = without_header(header.size(), size);
    std::string result;
    for(std::size_t i = 3, begin = 0; i < header.size(); begin += header[i++])
    {
      go_on(m_budget);
      if(begin > blocks.size())
        throw Input_error("the file ends too early, within a compressed array");
      const bool is_smaller = i + 1 == header.size() && header[2] > 0;
      result += decompress(compressor, std::string_view(blocks).substr(begin, header[i]), header[is_smaller ? 2 : 1]);
    }
    return result;
  }

  bool is_swapped() const { return (attribute(m_header, "byte_order") == "BigEndian") == is_little_endian_machine; }

  template <typename Number, typename Stored>
  std::vector<Number> values(const std::string& bytes) const
  {
    if constexpr(std::is_integral<Number>::value && !std::is_integral<Stored>::value)
      throw Input_error("an array of integers has the type of others");
    Binary_scanner scanner(bytes, is_swapped());
    std::vector<Number> result;
    for(std::size_t i = 0; i < bytes.size() / sizeof(Stored); ++i)
    {
      if(i % (1 << 16) == 0)
        go_on(m_budget);
      result.push_back(static_cast<Number>(scanner.next<Stored>()));
    }
    return result;
  }

  std::string_view m_text, m_header, m_piece, m_appended;
  const Budget& m_budget;
  bool m_is_appended_raw = false;
  std::map<std::string, Array> m_arrays;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTK_ARRAYS_H
