// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_OUTPUT_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_OUTPUT_FILE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Whole_file.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <poll.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string_view>

namespace CGAL::Volume_mesh_parameterization::IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// The exception of an `Output_file` whose stream nobody reads until the limits of time end.
class Unread_output : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// A file that gets all of its content, or none. A regular file keeps its old content until `commit()` replaces it. A stream (a
/// pipe, a device, or an open file of this program such as `/dev/stdout`) gets the content by `commit()`. The writers of files of
/// this package use it.
///
/// All functions throw `std::runtime_error`, with the name of the file and the reason, if the file cannot be written.
class Output_file
{
public:
  /// begins a file, whose folder must exist.
  explicit Output_file(const std::string& name) : m_name(name)
  {
    if(!is_stream(name))
      m_file.emplace(name);
  }

  /// returns the stream for the content.
  std::ostream& stream() { return m_file ? m_file->stream() : m_text; }

  /// replaces the file, or writes to the stream. If the named parameters `visitor` or `maximum_running_time` end the waiting for a
  /// reader of a stream, `Unread_output` is thrown.
  template <typename NamedParameters = parameters::Default_named_parameters>
  void commit(const NamedParameters& np = parameters::default_values())
  {
    internal::check_named_parameters(np);
    internal::Limits<NamedParameters> limits(np);
    if(m_file)
      m_file->commit();
    else
      write(limits.budget());
  }

  /// returns whether a name is one of a stream, which cannot be replaced.
  static bool is_stream(const std::string& name)
  {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(name, ignored);
    return internal::descriptor_of_name(name) >= 0 || std::filesystem::is_fifo(status)
        || std::filesystem::is_character_file(status);
  }

  /// follows symbolic links to the replaced file. This file need not exist.
  static std::string path(const std::string& name) { return internal::path_behind_links(name); }

  /// removes the temporary files of all objects. A handler of signals may call it before it ends the program.
  static void remove_unfinished() { internal::Whole_file::remove_unfinished(); }

private:
  void write(const internal::Budget& budget) const
  {
    struct Stream
    {
      int descriptor;
      ~Stream() { close(descriptor); }
    } stream = { -1 };
    double seconds_of_waiting = 0;
    // later than its limits, a reader has a second (a guess) for what is valid
    const auto wait = [&]
    {
      constexpr int milliseconds = 20;
      seconds_of_waiting += 1e-3 * milliseconds;
      if(budget.is_exhausted() && seconds_of_waiting > 1)
        throw Unread_output(m_name + ": nobody reads this");
      poll(nullptr, 0, milliseconds);
    };
    const auto require = [&](const bool condition)
    {
      if(!condition)
        throw std::runtime_error(m_name + ": this cannot be written completely: " + std::strerror(errno));
    };
    while((stream.descriptor = internal::open_file(m_name, O_WRONLY | O_APPEND)) < 0 && errno == ENXIO)
      wait(); // for the first reader of a pipe
    require(stream.descriptor >= 0);
    constexpr std::size_t chunk = 4096; // a pipe that can be written takes as much without waiting (PIPE_BUF)
    const std::string content = m_text.str();
    for(std::string_view text = content; !text.empty(); )
    {
      pollfd state = { stream.descriptor, POLLOUT, 0 };
      const bool is_ready = poll(&state, 1, 0) > 0;
      const ssize_t size = is_ready ? ::write(stream.descriptor, text.data(), (std::min)(chunk, text.size())) : 0;
      require(size >= 0 || errno == EINTR || errno == EAGAIN);
      if(size <= 0)
      {
        wait();
        continue;
      }
      text.remove_prefix(static_cast<std::size_t>(size));
      seconds_of_waiting = 0;
    }
  }

  std::string m_name;
  std::optional<internal::Whole_file> m_file;
  std::ostringstream m_text; // for streams
};

} // namespace CGAL::Volume_mesh_parameterization::IO

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_OUTPUT_FILE_H
