// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_READ_TEXT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_READ_TEXT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Input_error.h>

#include <cstddef>
#include <fstream>
#include <istream>
#include <string>

namespace CGAL::Volume_mesh_parameterization::internal {

// the rest of a stream as one string
inline std::string read_text(std::istream& is)
{
  std::string text;
  std::size_t size = 0;
  do
  {
    text.resize(2 * size + (1 << 16));
    is.read(&text[size], static_cast<std::streamsize>(text.size() - size));
    size += static_cast<std::size_t>(is.gcount());
  }
  while(is);
  text.resize(size);

  if(is.bad())
    throw Input_error("the file cannot be read");
  return text;
}

// Opens the file for `read(stream)` and puts its name in front of the sentence of a failure.
template <typename Read>
void read_file(const std::string& filename, const Read& read)
{
  try
  {
    std::ifstream is(filename, std::ios::binary);
    if(!is)
      throw Input_error("the file cannot be opened");
    read(is);
  }
  catch(const Input_error& error)
  {
    throw Input_error(filename + ": " + error.what());
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FILES_READ_TEXT_H
