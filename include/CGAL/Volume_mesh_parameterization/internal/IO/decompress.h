// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_DECOMPRESS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_DECOMPRESS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_ZLIB
#  include <zlib.h>
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_LZMA
#  include <lzma.h>
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_LZ4
#  include <lz4.h>
#endif

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the `size` bytes from which one of VTK's compressors has made a block.
inline std::string decompress(const std::string& compressor, const std::string_view block, const std::size_t size)
{
  constexpr std::size_t largest = 1 << 30, largest_ratio = 1 << 14; // guesses: lz4 counts by int, lzma makes 1/7000 of zeros
  if(size > largest || block.size() > largest || size / largest_ratio > block.size())
    throw Input_error("a compressed block has the impossible size " + std::to_string(size));
  std::string result(size, '\0');
  std::size_t number_of_bytes = (std::numeric_limits<std::size_t>::max)();
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_ZLIB
  if(compressor == "vtkZLibDataCompressor")
  {
    uLongf end = static_cast<uLongf>(size);
    const int status = uncompress(reinterpret_cast<Bytef*>(result.data()), &end, reinterpret_cast<const Bytef*>(block.data()),
                                  static_cast<uLong>(block.size()));
    number_of_bytes = status == Z_OK ? static_cast<std::size_t>(end) : 0;
  }
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_LZMA
  if(compressor == "vtkLZMADataCompressor")
  {
    std::uint64_t memory = largest;
    std::size_t begin = 0, end = 0;
    const lzma_ret status = lzma_stream_buffer_decode(
      &memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(block.data()), &begin, block.size(),
      reinterpret_cast<std::uint8_t*>(result.data()), &end, size);
    number_of_bytes = status == LZMA_OK ? end : 0;
  }
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_LZ4
  if(compressor == "vtkLZ4DataCompressor")
    number_of_bytes = static_cast<std::size_t>((std::max)(0, LZ4_decompress_safe(
      block.data(), result.data(), static_cast<int>(block.size()), static_cast<int>(size))));
#endif
  if(number_of_bytes > size)
    throw Input_error("the file is compressed by " + compressor + ", which is not compiled in; write it without compression");
  if(number_of_bytes < size)
    throw Input_error("a compressed block is damaged");
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_DECOMPRESS_H
