// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_MEDIT_READER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_MEDIT_READER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/Text_scanner.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Reads the text of an ASCII MEDIT file. A first pass only finds the keywords, so that their order is free.
class MEDIT_reader
{
public:
  explicit MEDIT_reader(std::string_view text)
  {
    find_sections(text);
  }

  Tetrahedron_soup_3 read() const
  {
    check_kind();

    Tetrahedron_soup_3 soup;
    read_points(soup.points);
    read_simplices("Triangles", soup.points.size(), soup.facets, soup.facet_references);
    read_simplices("Tetrahedra", soup.points.size(), soup.cells, soup.cell_references);
    if(soup.cells.empty())
      throw Input_error("the mesh is not tetrahedral, there is no tetrahedron in the file");
    return soup;
  }

private:
  void find_sections(std::string_view text)
  {
    Text_scanner scanner(text);
    if(scanner.next_word() != "MeshVersionFormatted")
      scanner.fail("this is not an ASCII MEDIT file, it does not begin with 'MeshVersionFormatted'");

    const int version = scanner.next_number<int>("the version of the format");
    if(version != 1 && version != 2)
      scanner.fail("the version of the format is " + std::to_string(version) + " instead of 1 or 2");

    for(std::string_view word = scanner.next_word(); !word.empty(); word = scanner.next_word())
    {
      if(word == "End")
        check_end(scanner);
      else if(is_read(word) && !m_sections.emplace(word, scanner).second)
        scanner.fail("a second section " + Text_scanner::quote(word));
    }
  }

  static bool is_read(std::string_view word)
  {
    return word == "Dimension" || word == "Vertices" || word == "Triangles" || word == "Tetrahedra"
      || is_unsupported(word);
  }

  static bool is_unsupported(std::string_view word)
  {
    return word == "Hexahedra" || word == "Hexaedra" || word == "Prisms" || word == "Pentahedra" || word == "Pyramids";
  }

  static bool is_keyword(std::string_view word)
  {
    return ('A' <= word[0] && word[0] <= 'Z') || ('a' <= word[0] && word[0] <= 'z');
  }

  static void check_end(Text_scanner& scanner)
  {
    const std::string_view word = scanner.next_word();
    if(!word.empty())
      scanner.fail(Text_scanner::quote(word) + " after the keyword 'End'");
  }

  void check_kind() const
  {
    const auto dimension = m_sections.find("Dimension");
    if(dimension != m_sections.end())
    {
      Text_scanner scanner(dimension->second);
      if(scanner.next_number<int>("the dimension") != 3)
        scanner.fail("the dimension is not 3");
    }

    for(const auto& [keyword, begin] : m_sections)
    {
      Text_scanner scanner(begin);
      if(is_unsupported(keyword) && next_count(scanner) != 0)
        scanner.fail("the mesh is not tetrahedral, it has " + std::string(keyword));
    }
  }

  static std::size_t next_count(Text_scanner& scanner)
  {
    return scanner.next_number<std::size_t>("a number of elements");
  }

  // Calls `read_element(scanner)` for each element of a section, which may be missing.
  template <typename ReadElement>
  void read_section(const char* keyword, const ReadElement& read_element) const
  {
    const auto section = m_sections.find(keyword);
    if(section == m_sections.end())
      return;

    Text_scanner scanner(section->second);
    const std::size_t count = next_count(scanner);
    for(std::size_t i = 0; i < count; ++i)
      read_element(scanner);

    const std::string_view word = scanner.next_word();
    if(!word.empty() && !is_keyword(word))
      scanner.fail(Text_scanner::quote(word) + " follows the last of the " + std::to_string(count)
                   + " elements of the section '" + keyword + "'");
  }

  void read_points(std::vector<std::array<double, 3> >& points) const
  {
    read_section("Vertices", [&](Text_scanner& scanner)
    {
      std::array<double, 3> point;
      for(double& x : point)
        x = scanner.next_number<double>("a finite coordinate");
      next_reference(scanner);
      points.push_back(point);
    });
  }

  template <std::size_t N>
  void read_simplices(const char* keyword,
                      std::size_t number_of_points,
                      std::vector<std::array<std::size_t, N> >& simplices,
                      std::vector<int>& references) const
  {
    read_section(keyword, [&](Text_scanner& scanner)
    {
      std::array<std::size_t, N> simplex;
      for(std::size_t& v : simplex)
        v = next_vertex(scanner, number_of_points);
      simplices.push_back(simplex);
      references.push_back(next_reference(scanner));
    });
  }

  static std::size_t next_vertex(Text_scanner& scanner, std::size_t number_of_points)
  {
    const long long v = scanner.next_number<long long>("the number of a vertex");
    if(v < 1 || static_cast<unsigned long long>(v) > number_of_points)
      scanner.fail("vertex " + std::to_string(v) + " does not exist, the vertices are numbered from 1 to "
                   + std::to_string(number_of_points));
    return static_cast<std::size_t>(v - 1);
  }

  static int next_reference(Text_scanner& scanner)
  {
    return scanner.next_number<int>("an integral reference");
  }

  std::map<std::string_view, Text_scanner> m_sections;   // each begins behind its keyword
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_MEDIT_READER_H
