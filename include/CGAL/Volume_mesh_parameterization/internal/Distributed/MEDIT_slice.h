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
#include <map>
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
    const std::vector<double> lines
      = communicator.gathered(static_cast<double>(std::count(text.begin(), text.end(), '\n')));
    for(std::size_t i = 0; i < rank; ++i)
      first_line += static_cast<std::size_t>(lines[i]);
  }

  std::string text;
  std::size_t first_line = 1;
};

// Reads slices of an ASCII MEDIT file with one element a line.
class MEDIT_slice
{
public:
  MEDIT_slice(const MPI_communicator_3& communicator, const std::string& filename)
    : m_slice(communicator, filename)
  {
    find_segments(communicator.rank() == 0);
    for(Segment& segment : m_segments)
      segment.rank = communicator.rank();
    add_segments_of_others(communicator);
    for(const char* keyword : { "Hexahedra", "Hexaedra", "Prisms", "Pentahedra", "Pyramids" })
      if(number_of_words(keyword) > 1)
        throw Input_error("the mesh is not tetrahedral, it has " + std::string(keyword));
  }

  // The elements of a section of all processes, each of so many words.
  std::size_t number_of_elements(const char* keyword, const std::size_t words) const
  {
    const std::size_t n = number_of_words(keyword);
    return n == 0 ? 0 : (n - 1) / words;
  }

  // Calls `read(scanner)` for each element of this slice, and returns the index of the first one.
  template <typename Read>
  std::size_t for_each_element(const char* keyword, const std::size_t words, const Read& read) const
  {
    const std::size_t number = number_of_elements(keyword, words);
    std::size_t first = number;
    for(const Segment& segment : m_segments)
    {
      if(m_keywords[segment.keyword] != keyword || segment.number_of_words == 0)
        continue;
      Text_scanner scanner(segment.scanner);
      const bool has_count = segment.first_word == 0;
      if(has_count && (scanner.next_number<std::size_t>("a number of elements") != number
                       || number_of_words(keyword) != number * words + 1))
        scanner.fail("the section '" + std::string(keyword) + "' has " + std::to_string(number) + " elements");
      if(!has_count && (segment.first_word - 1) % words != 0)
        scanner.fail("an element does not begin on a line of its own");
      first = (std::min)(first, has_count ? 0 : (segment.first_word - 1) / words);
      for(std::size_t i = has_count; i < segment.number_of_words; i += words)
        read(scanner);
    }
    return first;
  }

private:
  // The words behind a keyword, or what this slice has of them.
  struct Segment
  {
    int rank = 0;
    std::size_t keyword = 0;    // 0: that of the segment before
    std::size_t number_of_words = 0;
    std::size_t first_word = 0; // in the section
    Text_scanner scanner{ std::string_view() };
  };

  void find_segments(const bool is_first)
  {
    Text_scanner scanner(m_slice.text, m_slice.first_line);
    if(is_first && Text_scanner(scanner).next_word() != "MeshVersionFormatted")
      scanner.fail("this is not an ASCII MEDIT file, it does not begin with 'MeshVersionFormatted'");
    m_segments.emplace_back();
    m_segments.back().scanner = scanner;
    for(std::string_view word = scanner.next_word(); !word.empty(); word = scanner.next_word())
      if(('A' <= word[0] && word[0] <= 'Z') || ('a' <= word[0] && word[0] <= 'z'))
      {
        const auto found = std::find(m_keywords.begin(), m_keywords.end(), word);
        m_segments.emplace_back();
        m_segments.back().keyword = found == m_keywords.end() ? 1 : static_cast<std::size_t>(found - m_keywords.begin());
        m_segments.back().scanner = scanner;
      }
      else
        ++m_segments.back().number_of_words;
  }

  void add_segments_of_others(const MPI_communicator_3& communicator)
  {
    std::size_t keyword = 1;
    std::size_t mine = 0;
    const std::vector<std::vector<Segment> > to_all(communicator.size(), m_segments);
    for(const Segment& segment : communicator.exchanged(to_all))
    {
      if(segment.keyword > 1 && m_number_of_words.count(segment.keyword) != 0)
        throw Input_error("there is a second section '" + std::string(m_keywords[segment.keyword]) + "'");
      keyword = segment.keyword == 0 ? keyword : segment.keyword;
      std::size_t& number_of_words = m_number_of_words[keyword];
      if(segment.rank == communicator.rank())
      {
        m_segments[mine].keyword = keyword;
        m_segments[mine++].first_word = number_of_words;
      }
      number_of_words += segment.number_of_words;
    }
  }

  std::size_t number_of_words(const std::string_view keyword) const
  {
    const auto place = std::find(m_keywords.begin(), m_keywords.end(), keyword);
    const auto found = m_number_of_words.find(static_cast<std::size_t>(place - m_keywords.begin()));
    return found == m_number_of_words.end() ? 0 : found->second;
  }

  // the first two stand for the one before and for those that are not read
  static constexpr std::array<std::string_view, 9> m_keywords = { "", "", "Vertices", "Tetrahedra",
    "Hexahedra", "Hexaedra", "Prisms", "Pentahedra", "Pyramids" };

  Text_slice m_slice;
  std::vector<Segment> m_segments;
  std::map<std::size_t, std::size_t> m_number_of_words; // of each section
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_MEDIT_SLICE_H
