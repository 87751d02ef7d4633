// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_BINARY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_BINARY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <CGAL/config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

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

// Numbers that a file may tell, as they are needed.
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

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_BINARY_H
