// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_BINARY_SCANNER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_BINARY_SCANNER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/MEDIT_reader.h>

#include <cstdint>
#include <cstring>
#include <functional>

namespace CGAL::Volume_mesh_parameterization::internal {

#ifdef CGAL_LITTLE_ENDIAN
constexpr bool is_little_endian_machine = true;
#else
constexpr bool is_little_endian_machine = false;
#endif

// Numbers in a row of bytes, in the order of bytes of this machine or in the other one.
class Binary_scanner
{
public:
  Binary_scanner(const std::string_view bytes, const bool is_swapped) : m_bytes(bytes), m_is_swapped(is_swapped) {}

  std::size_t position() const { return m_position; }
  std::size_t rest() const { return m_bytes.size() - m_position; }
  void go_to(const std::size_t position) { m_position = position; }

  template <typename Number>
  Number next()
  {
    std::array<char, sizeof(Number)> bytes;
    if(rest() < bytes.size())
      throw Input_error("the file ends too early, after " + std::to_string(m_bytes.size()) + " bytes");
    std::copy_n(m_bytes.begin() + m_position, bytes.size(), bytes.begin());
    m_position += bytes.size();
    if(m_is_swapped)
      std::reverse(bytes.begin(), bytes.end());
    Number result;
    std::memcpy(&result, bytes.data(), sizeof(result));
    return result;
  }

private:
  std::string_view m_bytes;
  bool m_is_swapped;
  std::size_t m_position = 0;
};

// Numbers of a file, checked.
inline double checked_coordinate(const double x)
{
  if(!std::isfinite(x))
    throw Input_error("a coordinate is not finite");
  return x;
}

inline std::size_t checked_vertex(const std::int64_t v, const std::int64_t first, const std::size_t number_of_points)
{
  if(v < first || static_cast<std::uint64_t>(v - first) >= number_of_points)
    throw Input_error("vertex " + std::to_string(v) + " does not exist, there are " + std::to_string(number_of_points)
                      + ", counted from " + std::to_string(first));
  return static_cast<std::size_t>(v - first);
}

inline int checked_reference(const std::int64_t reference)
{
  if(reference != static_cast<int>(reference))
    throw Input_error("the reference " + std::to_string(reference) + " is too large");
  return static_cast<int>(reference);
}

// Reads a binary MEDIT file (.meshb), of the layout of libMeshb: the number 1, by which the order of bytes is known, the version,
// and sections of a keyword, the position of the next one, and a number of elements. By the version, these have 8 bytes:
// from 2 on coordinates, from 3 on positions, and in 4 all integers but keywords.
class Binary_MEDIT_reader
{
public:
  Binary_MEDIT_reader(const std::string_view bytes, const Budget& budget)
    : m_scanner(bytes, first_number(bytes) != 1), m_budget(budget)
  {}

  static bool is_binary(const std::string_view bytes)
  { return first_number(bytes) == 1 || first_number(bytes) == std::int32_t(1) << 24; }

  Tetrahedron_soup_3 read()
  {
    m_scanner.next<std::int32_t>();
    m_version = m_scanner.next<std::int32_t>();
    if(m_version < 1 || m_version > 4)
      throw Input_error("the version of the format is " + std::to_string(m_version) + " instead of 1 to 4");
    Tetrahedron_soup_3 soup;
    while(m_scanner.rest() > 0 && read_section(soup))
      go_on(m_budget);
    split_polyhedra(soup);
    check_vertices(std::array{ soup.corners }, soup.points.size());
    check_vertices(soup.edges, soup.points.size());
    check_vertices(soup.facets, soup.points.size());
    check_vertices(soup.cells, soup.points.size());
    require_tetrahedra(soup.cells.size(), soup.facets.size());
    if(m_has_second_order)
      remove_nodes_of_higher_order(soup);
    return soup;
  }

private:
  enum Keyword { DIMENSION = 3, VERTICES = 4, EDGES = 5, TRIANGLES = 6, QUADRILATERALS = 7, TETRAHEDRA = 8, PRISMS = 9,
                 HEXAHEDRA = 10, CORNERS = 13, TRIANGLES_P2 = 24, EDGES_P2 = 25, TETRAHEDRA_P2 = 30, PYRAMIDS = 49, END = 54 };

  static std::int32_t first_number(const std::string_view bytes)
  { return bytes.size() < 4 ? 0 : Binary_scanner(bytes, false).next<std::int32_t>(); }

  std::int64_t next_integer(const int first_version_of_8_bytes = 4)
  { return m_version >= first_version_of_8_bytes ? m_scanner.next<std::int64_t>() : m_scanner.next<std::int32_t>(); }

  double next_coordinate()
  { return checked_coordinate(m_version == 1 ? static_cast<double>(m_scanner.next<float>()) : m_scanner.next<double>()); }

  // False if this was the last one.
  bool read_section(Tetrahedron_soup_3& soup)
  {
    const std::int32_t keyword = m_scanner.next<std::int32_t>();
    if(keyword == END)
      return false;
    const std::int64_t end = next_integer(3);
    const std::size_t end_of_file = m_scanner.position() + m_scanner.rest();
    if(end != 0 && (end <= static_cast<std::int64_t>(m_scanner.position())
                    || static_cast<std::uint64_t>(end) > end_of_file))
      throw Input_error("the section " + std::to_string(keyword) + " ends at byte " + std::to_string(end) + " of "
                        + std::to_string(end_of_file));
    switch(keyword)
    {
      case DIMENSION:
        if(m_scanner.next<std::int32_t>() != 3)
          throw Input_error("the dimension is not 3");
        break;
      case VERTICES:
        read_elements(3 * (m_version == 1 ? 4 : 8) + size_of_integer(), [&]
        {
          const double x = next_coordinate(), y = next_coordinate(), z = next_coordinate();
          soup.points.push_back({ x, y, z });
          next_integer();
        });
        break;
      case CORNERS: read_elements(size_of_integer(), [&] { soup.corners.push_back(next_vertex()); }); break;
      case EDGES: read_simplices(2, soup.edges, soup.edge_references); break;
      case TRIANGLES: read_simplices(3, soup.facets, soup.facet_references); break;
      case TETRAHEDRA: read_simplices(4, soup.cells, soup.cell_references); break;
      case EDGES_P2: read_simplices(3, soup.edges, soup.edge_references); break;
      case TRIANGLES_P2: read_simplices(6, soup.facets, soup.facet_references); break;
      case TETRAHEDRA_P2: read_simplices(10, soup.cells, soup.cell_references); break;
      case QUADRILATERALS: read_polytopes(4, m_quadrilaterals); break;
      case PYRAMIDS: read_polytopes(5, m_polyhedra); break;
      case PRISMS: read_polytopes(6, m_polyhedra); break;
      case HEXAHEDRA: read_polytopes(8, m_polyhedra);
    }
    if(end != 0)
      m_scanner.go_to(static_cast<std::size_t>(end));
    return end != 0;
  }

  template <typename Simplices>
  static void check_vertices(const Simplices& simplices, const std::size_t number_of_points)
  {
    for(const auto& simplex : simplices)
      for(const std::size_t v : simplex)
        checked_vertex(static_cast<std::int64_t>(v) + 1, 1, number_of_points);
  }

  // Returns a vertex, which may come later in the file.
  std::size_t next_vertex() { return checked_vertex(next_integer(), 1, (std::numeric_limits<std::int64_t>::max)()); }

  std::size_t size_of_integer() const { return m_version == 4 ? 8 : 4; }

  void read_elements(const std::size_t size_of_element, const std::function<void()>& read)
  {
    const std::int64_t number = next_integer();
    if(number < 0 || static_cast<std::uint64_t>(number) > m_scanner.rest() / size_of_element)
      throw Input_error("the file ends too early, it has not " + std::to_string(number) + " elements of a section");
    for(std::int64_t i = 0; i < number; ++i)
    {
      if(i % 4096 == 0)
        go_on(m_budget);
      read();
    }
  }

  // Reads the first vertices of each element, which are its corners.
  template <std::size_t N>
  void read_simplices(const std::size_t number_of_vertices, std::vector<std::array<std::size_t, N> >& simplices,
                      std::vector<int>& references)
  {
    m_has_second_order = m_has_second_order || number_of_vertices > N;
    read_elements((number_of_vertices + 1) * size_of_integer(), [&]
    {
      simplices.emplace_back();
      for(std::size_t& v : simplices.back())
        v = next_vertex();
      for(std::size_t i = N; i < number_of_vertices; ++i)
        next_integer();
      references.push_back(checked_reference(next_integer()));
    });
  }

  using Polytopes = std::vector<std::pair<std::vector<std::size_t>, int> >; // vertices and a reference of each

  void read_polytopes(const std::size_t number_of_vertices, Polytopes& polytopes)
  {
    read_elements((number_of_vertices + 1) * size_of_integer(), [&]
    {
      polytopes.emplace_back(std::vector<std::size_t>(number_of_vertices), 0);
      for(std::size_t& v : polytopes.back().first)
        v = next_vertex();
      polytopes.back().second = checked_reference(next_integer());
    });
  }

  // Makes tetrahedra of hexahedra, prisms and pyramids, and triangles of their quadrilaterals.
  void split_polyhedra(Tetrahedron_soup_3& soup) const
  {
    if(m_polyhedra.empty())
      return;
    for(const auto& [vertices, reference] : m_polyhedra)
    {
      for_each_tetrahedron(vertices, [&](const std::array<std::size_t, 4>& cell) { soup.cells.push_back(cell); });
      soup.cell_references.resize(soup.cells.size(), reference);
    }
    for(const auto& [vertices, reference] : m_quadrilaterals)
    {
      for_each_triangle(vertices, [&](const std::array<std::size_t, 3>& facet) { soup.facets.push_back(facet); });
      soup.facet_references.resize(soup.facets.size(), reference);
    }
    soup.notes.push_back(note_of_split_cells(m_polyhedra.size()));
  }

  Binary_scanner m_scanner;
  Polytopes m_polyhedra, m_quadrilaterals;
  const Budget& m_budget;
  std::int32_t m_version = 0;
  bool m_has_second_order = false;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_BINARY_SCANNER_H
