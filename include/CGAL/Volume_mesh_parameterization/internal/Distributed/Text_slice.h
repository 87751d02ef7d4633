// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_TEXT_SLICE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_TEXT_SLICE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Input_error.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/MEDIT_reader.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/Text.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ios>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The lines of a file that begin in the range of bytes of this process. So that it does not depend on the number of processes
// what can be read, no slice ends before its first word, or between a keyword of MEDIT and its number: it takes lines from
// the next ones.
class Text_slice
{
public:
  Text_slice(const MPI_communicator_3& communicator, const std::string& filename, const Budget& budget)
    : m_budget(budget)
  {
    std::error_code ignored;
    if(std::filesystem::exists(filename, ignored) && !std::filesystem::is_regular_file(filename, ignored))
      throw Input_error("this is not a regular file, of which several processes can read a part each");
    std::ifstream is(filename, std::ios::binary);
    if(!is)
      throw Input_error("the file cannot be opened");
    const std::size_t size = static_cast<std::size_t>(std::filesystem::file_size(filename));
    const std::size_t n = static_cast<std::size_t>(communicator.size()), rank = static_cast<std::size_t>(communicator.rank());
    const auto cut = [&](const std::size_t i) { return size / n * i + (std::min)(i, size % n); };
    if(rank > 0) // a line may begin there
      is.seekg(static_cast<std::streamoff>(cut(rank)) - 1).ignore((std::numeric_limits<std::streamsize>::max)(), '\n');
    const std::size_t begin = is.good() ? static_cast<std::size_t>(is.tellg()) : size;
    m_text = read_text(is, budget, (std::max)(begin, cut(rank + 1)) - begin);
    std::string line;
    if(!m_text.empty() && m_text.back() != '\n' && std::getline(is, line))
      m_text += line + '\n';
    std::string last = last_word(m_text);
    while((last.empty() || MEDIT_reader::is_before_number(last)) && std::getline(is, line))
    {
      m_text += line + '\n';
      last = last_word(line).empty() ? last : last_word(line);
    }
    const std::vector<double> ends = communicator.gathered(static_cast<double>(begin + m_text.size()));
    const auto taken = std::max_element(ends.begin(), ends.begin() + communicator.rank());
    if(rank > 0 && *taken > static_cast<double>(begin))
      m_text.erase(0, static_cast<std::size_t>(*taken) - begin);
    m_first_line = 1 + communicator.begins(std::count(m_text.begin(), m_text.end(), '\n'))[rank];
  }

  Text_scanner scanner() const { return Text_scanner(m_text, m_budget, m_first_line); }

private:
  std::string last_word(const std::string_view text) const
  {
    Text_scanner scanner(text, m_budget);
    std::string_view last;
    for(std::string_view word = scanner.next_word(); !word.empty(); word = scanner.next_word())
      last = word;
    return std::string(last);
  }

  const Budget& m_budget;
  std::string m_text;
  std::size_t m_first_line;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_TEXT_SLICE_H
