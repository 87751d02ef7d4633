// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_MEDIT_SLICE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_MEDIT_SLICE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Input_error.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The lines of a file that begin in the range of bytes of this process.
struct Text_slice
{
  Text_slice(const MPI_communicator_3& communicator, const std::string& filename)
  {
    std::ifstream is(filename, std::ios::binary | std::ios::ate);
    if(!is)
      throw Input_error("the file cannot be opened");
    const std::size_t size = static_cast<std::size_t>(is.tellg()), n = communicator.size(), rank = communicator.rank();
    const auto begin_of = [&](const std::size_t i) { return size / n * i + (std::min)(i, size % n); };
    const std::size_t end = begin_of(rank + 1);
    const std::size_t begin = rank == 0 ? 0 : (std::max)(begin_of(rank), std::size_t(1)) - 1; // a line may end there
    text.resize(end - begin);
    is.seekg(static_cast<std::streamoff>(begin));
    is.read(text.data(), static_cast<std::streamsize>(text.size()));
    if(!is)
      throw Input_error("the file cannot be read");
    std::string rest;
    if(!text.empty() && text.back() != '\n' && std::getline(is, rest))
      text += rest + '\n';
    if(rank > 0) // the line that began before belongs to the process before
      text.erase(0, text.find('\n') == std::string::npos ? text.size() : text.find('\n') + 1);
    first_line = 1 + communicator.begins(std::count(text.begin(), text.end(), '\n'))[rank];
  }

  std::string text;
  std::size_t first_line;
};

inline std::array<double, 3> next_point(Text_scanner& scanner)
{
  std::array<double, 3> point;
  for(double& x : point)
    x = scanner.next_number<double>("a finite coordinate");
  return point;
}

// What this process reads of an ASCII MEDIT file with one vertex or cell a line.
class MEDIT_slice
{
public:
  std::vector<std::array<double, 3> > points;
  std::vector<std::array<std::size_t, 4> > cells;
  std::vector<int> cell_references;
  std::size_t first_point; // its index in the file

  MEDIT_slice(const MPI_communicator_3& communicator, const std::string& filename)
  {
    const Text_slice slice(communicator, filename);
    Text_scanner scanner(slice.text, slice.first_line), ahead(scanner);
    if(communicator.rank() == 0 && Text_scanner(scanner).next_word() != "MeshVersionFormatted")
      scanner.fail("this is not an ASCII MEDIT file, it does not begin with 'MeshVersionFormatted'");
    Place place = place_before(communicator, scanner);
    for(std::string_view word = ahead.next_word(); !word.empty(); word = (ahead = scanner).next_word())
    {
      const bool is_count = place.is_before_count && !is_keyword(word);
      place.pass(word);
      m_number_of_keywords[place.section] += is_keyword(word);
      if(is_count)
        m_counts[place.section] = static_cast<double>(scanner.next_number<std::size_t>("a number of elements"));
      else if(is_keyword(word) || (place.section != VERTICES && place.section != TETRAHEDRA))
        scanner = ahead;
      else
        read_element(place.section == VERTICES, scanner);
    }
    check(communicator);
  }

private:
  static constexpr std::array<std::string_view, 8> m_keywords // others are skipped
    = { "", "Vertices", "Tetrahedra", "Hexahedra", "Hexaedra", "Prisms", "Pentahedra", "Pyramids" };
  enum Section { OTHER, VERTICES, TETRAHEDRA };

  static bool is_keyword(const std::string_view word)
  {
    return ('A' <= word[0] && word[0] <= 'Z') || ('a' <= word[0] && word[0] <= 'z');
  }

  // Between two words of the file.
  struct Place
  {
    std::size_t section = OTHER;
    bool is_before_count = false; // of the elements of the section

    void pass(const std::string_view word)
    {
      is_before_count = false;
      if(!is_keyword(word))
        return;
      const auto found = std::find(m_keywords.begin(), m_keywords.end(), word);
      section = static_cast<std::size_t>(found - m_keywords.begin()) % m_keywords.size();
      is_before_count = section != OTHER;
    }
  };

  // Where the slices of the processes before this one end.
  static Place place_before(const MPI_communicator_3& communicator, Text_scanner scanner)
  {
    constexpr std::size_t none = m_keywords.size();
    Place end = { none };
    for(std::string_view word = scanner.next_word(); !word.empty(); word = scanner.next_word())
      end.pass(word);
    const std::vector<double> sections = communicator.gathered(static_cast<double>(end.section));
    const std::vector<double> are_before_count = communicator.gathered(end.is_before_count);
    Place result;
    for(int i = 0; i < communicator.rank(); ++i)
      if(sections[i] != none)
        result = { static_cast<std::size_t>(sections[i]), are_before_count[i] == 1 };
    return result;
  }

  void read_element(const bool is_vertex, Text_scanner& scanner)
  {
    if(is_vertex)
    {
      points.push_back(next_point(scanner));
      scanner.next_number<int>("an integral reference");
    }
    else
    {
      cells.emplace_back();
      for(std::size_t& v : cells.back())
        v = scanner.next_number<std::size_t>("the number of a vertex") - 1;
      cell_references.push_back(scanner.next_number<int>("an integral reference"));
    }
    if(scanner.has_word_on_line())
      scanner.fail("the line does not end after the vertex or cell");
  }

  // What only all processes together can tell.
  void check(const MPI_communicator_3& communicator)
  {
    const std::vector<std::size_t> begins = communicator.begins(points.size());
    first_point = begins[communicator.rank()];
    const std::array<std::size_t, 3> numbers = { 0, begins.back(), communicator.begins(cells.size()).back() };
    for(std::size_t section = VERTICES; section < m_keywords.size(); ++section)
    {
      const std::string name = std::string(m_keywords[section]);
      const double count = communicator.sum(m_counts[section]);
      if(communicator.sum(m_number_of_keywords[section]) > 1)
        throw Input_error("there is a second section '" + name + "'");
      if(section >= numbers.size() && count > 0)
        throw Input_error("the mesh is not tetrahedral, it has " + name);
      if(section < numbers.size() && static_cast<double>(numbers[section]) != count)
        throw Input_error("the section '" + name + "' has " + std::to_string(numbers[section])
                          + " elements, not as many as it says");
    }
    if(numbers[TETRAHEDRA] == 0)
      throw Input_error("the mesh is not tetrahedral, there is no tetrahedron in the file");
    for(const std::array<std::size_t, 4>& cell : cells)
      for(const std::size_t v : cell)
        if(v >= numbers[VERTICES])
          throw Input_error("vertex " + std::to_string(v + 1) + " of a cell does not exist, the vertices are numbered "
                            "from 1 to " + std::to_string(numbers[VERTICES]));
  }

  std::array<double, m_keywords.size()> m_counts = {}, m_number_of_keywords = {};
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_MEDIT_SLICE_H
