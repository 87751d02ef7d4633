// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_TEXT_WRITER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_TEXT_WRITER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <charconv>
#include <cstddef>
#include <ios>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Writes text and numbers to a stream, whatever its locale and precision. Floating-point numbers get the fewest digits
// (at most 17) from which reading restores the same bits. A failure is left in the state of the stream.
class Text_writer
{
public:
  explicit Text_writer(std::ostream& os) : m_os(os) {}
  Text_writer(const Text_writer&) = delete;
  Text_writer& operator=(const Text_writer&) = delete;
  ~Text_writer() { flush(); }

  Text_writer& operator<<(const std::string_view text)
  {
    m_buffer += text;
    if(m_buffer.size() >= (1 << 16)) // streams of files have small buffers
      flush();
    return *this;
  }

  template <typename Number, typename = std::enable_if_t<std::is_arithmetic_v<Number> > >
  Text_writer& operator<<(const Number number)
  {
    char digits[32];
    const std::to_chars_result result = std::to_chars(digits, digits + sizeof(digits), number);
    return *this << std::string_view(digits, static_cast<std::size_t>(result.ptr - digits));
  }

private:
  void flush()
  {
    m_os.write(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
    m_buffer.clear();
  }

  std::ostream& m_os;
  std::string m_buffer;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_TEXT_WRITER_H
