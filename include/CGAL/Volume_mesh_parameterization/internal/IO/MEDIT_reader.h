// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_MEDIT_READER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_MEDIT_READER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/require_tetrahedra.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <functional>
#include <optional>

namespace CGAL::Volume_mesh_parameterization::internal {

inline std::array<double, 3> next_point(Text_scanner& scanner)
{
  std::array<double, 3> point;
  for(double& x : point)
    x = scanner.next_number<double>("a finite coordinate");
  return point;
}

// Reads an ASCII MEDIT file, or the lines of it that this process has. A first pass only finds the keywords that have a
// meaning here, so that their order is free. A section goes on until the next keyword, in whichever slice that is. Sections
// with the same keyword are joined.
class MEDIT_reader
{
public:
  enum class Content { MESH, MESH_OR_SURFACE };

  explicit MEDIT_reader(const Text_scanner& text) : MEDIT_reader(single_process(), text, false) {}

  // Takes the slice of a file that this process has. Each element must have a line of its own, and no slice may end behind a
  // keyword that a number belongs to.
  MEDIT_reader(const Communicator_3& communicator, const Text_scanner& slice) : MEDIT_reader(communicator, slice, true) {}

  // Does a number belong to this word?
  static bool is_before_number(const std::string_view word) { return keyword(word) < END; }

  // Reads the elements of the file that are in this slice.
  Tetrahedron_soup_3 read(const Content content = Content::MESH) const
  {
    Tetrahedron_soup_3 soup;
    read_section(VERTICES, [&](Text_scanner& scanner)
    {
      soup.points.push_back(next_point(scanner));
      next_reference(scanner);
    });
    soup.points.shrink_to_fit();
    const std::size_t number_of_points = total_of_processes(soup.points.size());
    read_section(CORNERS, [&](Text_scanner& scanner) { soup.corners.push_back(next_vertex(scanner, number_of_points)); });
    read_simplices(EDGES, number_of_points, 2, soup.edges, soup.edge_references);
    read_simplices(TRIANGLES, number_of_points, 3, soup.facets, soup.facet_references);
    read_simplices(TETRAHEDRA, number_of_points, 4, soup.cells, soup.cell_references);
    const std::size_t number_of_simplices = soup.edges.size() + soup.facets.size() + soup.cells.size();
    read_simplices(EDGES_P2, number_of_points, 3, soup.edges, soup.edge_references);
    read_simplices(TRIANGLES_P2, number_of_points, 6, soup.facets, soup.facet_references);
    read_simplices(TETRAHEDRA_P2, number_of_points, 10, soup.cells, soup.cell_references);
    const std::size_t number_of_second_order
      = total_of_processes(soup.edges.size() + soup.facets.size() + soup.cells.size() - number_of_simplices);
    read_polyhedra(number_of_points, soup);
    if(content == Content::MESH)
      require_tetrahedra(total_of_processes(soup.cells.size()), total_of_processes(soup.facets.size()));
    if(number_of_second_order > 0 && m_is_slice)
      throw Input_error("the mesh has cells of second order, which several processes do not read");
    if(number_of_second_order > 0)
      remove_nodes_of_higher_order(soup);
    return soup;
  }

private:
  MEDIT_reader(const Communicator_3& communicator, const Text_scanner& text, const bool is_slice)
    : m_communicator(communicator), m_is_slice(is_slice)
  {
    if(communicator.rank() == 0 && Text_scanner(text).next_word() != m_keywords[VERSION])
      text.fail("this is not an ASCII MEDIT file, because it does not begin with 'MeshVersionFormatted'");
    find_sections(text);
    share_sections(text);
  }

  enum { VERSION, DIMENSION, VERTICES, CORNERS, EDGES, TRIANGLES, TETRAHEDRA, EDGES_P2, TRIANGLES_P2, TETRAHEDRA_P2,
         QUADRILATERALS, HEXAHEDRA, HEXAEDRA, PRISMS, PENTAHEDRA, PYRAMIDS, END, OTHER, NONE };
  static constexpr std::array<std::string_view, OTHER> m_keywords
    = { "MeshVersionFormatted", "Dimension", "Vertices", "Corners", "Edges", "Triangles", "Tetrahedra", "EdgesP2",
        "TrianglesP2", "TetrahedraP2", "Quadrilaterals", "Hexahedra", "Hexaedra", "Prisms", "Pentahedra", "Pyramids", "End" };

  // The sections with a keyword.
  struct Sections
  {
    double count = 0;                 // of elements, by the numbers in this slice
    std::vector<Text_scanner> begins; // of what this slice has of them
  };

  // The next keyword does, or the end of the text. An infinite coordinate, or one that is no number, gets its own message.
  static bool ends_section(const std::string_view text)
  {
    std::string begin(text.substr(0, 3));
    for(char& c : begin)
      c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return begin.empty() || ('a' <= begin[0] && begin[0] <= 'z' && begin != "nan" && begin != "inf");
  }

  static std::size_t keyword(const std::string_view word)
  { return static_cast<std::size_t>(std::find(m_keywords.begin(), m_keywords.end(), word) - m_keywords.begin()); }

  std::size_t total_of_processes(const std::size_t x) const
  { return static_cast<std::size_t>(m_communicator.sum(static_cast<double>(x))); }

  void find_sections(Text_scanner scanner)
  {
    for(std::string_view word = scanner.next_word(); !word.empty(); word = scanner.next_word())
    {
      if(!ends_section(word))
        continue;
      m_last = keyword(word);
      if(m_last == END)
        scanner.expect_end("the keyword 'End'");
      if(m_last >= END)
        continue;
      const std::size_t count
        = scanner.next_number<std::size_t>(m_last < VERTICES ? "a version or dimension" : "a number of elements");
      if(m_last == VERSION && (count < 1 || count > 4)) // which differ in the binary format alone
        scanner.fail("the version of the format is " + std::to_string(count) + " instead of 1 to 4");
      if(m_last == DIMENSION && count != 3)
        scanner.fail("the dimension is not 3");
      if(m_last > QUADRILATERALS && count != 0 && m_is_slice)
        scanner.fail(sentence_on_other_cells(std::string(word)));
      m_sections[m_last].count += static_cast<double>(count);
      m_sections[m_last].begins.push_back(scanner);
    }
  }

  // Finds in which section of the slices before the text of this one begins.
  void share_sections(Text_scanner text)
  {
    const std::vector<double> all = m_communicator.concatenated({ static_cast<double>(m_last) });
    const std::size_t rank = static_cast<std::size_t>(m_communicator.rank());
    m_is_last = rank + 1 == all.size();
    std::size_t open = NONE;
    for(std::size_t i = 0; i < rank; ++i)
      if(const auto keyword = static_cast<std::size_t>(all[i]); keyword != NONE)
        open = keyword;
    if(open == END)
      text.expect_end("the keyword 'End'");
    if(open < END)
      m_sections[open].begins.insert(m_sections[open].begins.begin(), text);
  }

  // Calls `read_element(scanner)` for each element that this slice has of the sections with a keyword.
  void read_section(const std::size_t k, const std::function<void(Text_scanner&)>& read_element) const
  {
    std::size_t number = 0;
    std::optional<Text_scanner> scanner;
    for(const Text_scanner& begin : m_sections[k].begins)
      for(scanner = begin; !ends_section(scanner->rest()); ++number)
      {
        if(!m_is_slice)
        {
          read_element(*scanner);
          continue;
        }
        Text_scanner line = scanner->next_line();
        read_element(line);
        line.expect_end("the element, which must have a line of its own");
      }

    const double total = m_communicator.sum(static_cast<double>(number)), expected = m_communicator.sum(m_sections[k].count);
    if(!scanner || total == expected)
      return;
    const std::string_view word = scanner->next_word();
    if(!word.empty() || m_is_last) // otherwise the section goes on in the next slice
      scanner->fail((word.empty() ? "the end of the file" : Text_scanner::quote(word)) + " follows "
                    + std::to_string(static_cast<std::size_t>(total)) + " instead of "
                    + std::to_string(static_cast<std::size_t>(expected)) + " elements of the section '"
                    + std::string(m_keywords[k]) + "'");
  }

  // Reads the first vertices of each element, which are its corners.
  template <std::size_t N>
  void read_simplices(const std::size_t k, const std::size_t number_of_points, const std::size_t number_of_vertices,
                      std::vector<std::array<std::size_t, N> >& simplices, std::vector<int>& references) const
  {
    read_section(k, [&](Text_scanner& scanner)
    {
      std::array<std::size_t, N> simplex;
      for(std::size_t& v : simplex)
        v = next_vertex(scanner, number_of_points);
      for(std::size_t i = N; i < number_of_vertices; ++i)
        next_vertex(scanner, number_of_points);
      simplices.push_back(simplex);
      references.push_back(next_reference(scanner));
    });
    simplices.shrink_to_fit(); // they stay as long as the map is computed
    references.shrink_to_fit();
  }

  // Reads hexahedra, prisms and pyramids as tetrahedra, and their quadrilaterals as triangles, with the same references.
  void read_polyhedra(const std::size_t number_of_points, Tetrahedron_soup_3& soup) const
  {
    std::size_t number_of_polyhedra = 0;
    const auto read = [&](const std::size_t k, const std::size_t number_of_vertices, const auto& add)
    {
      read_section(k, [&](Text_scanner& scanner)
      {
        std::vector<std::size_t> vertices(number_of_vertices);
        for(std::size_t& v : vertices)
          v = next_vertex(scanner, number_of_points);
        add(vertices, next_reference(scanner));
      });
    };
    for(const auto& [k, number_of_vertices] : { std::pair(HEXAHEDRA, 8), { HEXAEDRA, 8 }, { PRISMS, 6 }, { PENTAHEDRA, 6 },
                                                { PYRAMIDS, 5 } })
      read(k, number_of_vertices, [&](const std::vector<std::size_t>& vertices, const int reference)
      {
        ++number_of_polyhedra;
        for_each_tetrahedron(vertices, [&](const std::array<std::size_t, 4>& cell)
        {
          soup.cells.push_back(cell);
          soup.cell_references.push_back(reference);
        });
      });
    if(number_of_polyhedra == 0)
      return;
    read(QUADRILATERALS, 4, [&](const std::vector<std::size_t>& vertices, const int reference)
    {
      for_each_triangle(vertices, [&](const std::array<std::size_t, 3>& facet)
      {
        soup.facets.push_back(facet);
        soup.facet_references.push_back(reference);
      });
    });
    soup.notes.push_back(note_of_split_cells(number_of_polyhedra));
  }

  static std::size_t next_vertex(Text_scanner& scanner, const std::size_t number_of_points)
  {
    const long long v = scanner.next_number<long long>("the number of a vertex");
    if(v < 1 || static_cast<unsigned long long>(v) > number_of_points)
      scanner.fail("vertex " + std::to_string(v) + " does not exist, the vertices are numbered from 1 to "
                   + std::to_string(number_of_points));
    return static_cast<std::size_t>(v - 1);
  }

  static int next_reference(Text_scanner& scanner) { return scanner.next_number<int>("an integral reference"); }

  const Communicator_3& m_communicator;
  bool m_is_slice, m_is_last;
  std::array<Sections, END> m_sections;
  std::size_t m_last = NONE; // keyword of this slice
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_MEDIT_READER_H
