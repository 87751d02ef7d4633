// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_OPEN_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_OPEN_FILE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <fcntl.h>
#include <unistd.h>

#include <charconv>
#include <string>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// The number of the open file of this program that a name of the system stands for, such as /dev/stdin; else -1.
inline int descriptor_of_name(const std::string& name)
{
  for(const auto& [known, descriptor] : { std::pair("/dev/stdin", 0), std::pair("/dev/stdout", 1), std::pair("/dev/stderr", 2) })
    if(name == known)
      return descriptor;
  for(const std::string folder : { "/dev/fd/", "/proc/self/fd/" })
    if(name.compare(0, folder.size(), folder) == 0)
    {
      int descriptor = -1;
      const std::from_chars_result end = std::from_chars(&name[folder.size()], name.data() + name.size(), descriptor);
      return end.ptr == name.data() + name.size() ? descriptor : -1;
    }
  return -1;
}

// Opens a file, and does not wait for the other end of a pipe. An open file of this program is used where it stands, and may
// be a socket; opened by its name, it would begin anew.
inline int open_file(const std::string& name, const int flags)
{
  const int descriptor = descriptor_of_name(name);
  return descriptor >= 0 ? fcntl(descriptor, F_DUPFD_CLOEXEC, 0) : open(name.c_str(), flags | O_NONBLOCK | O_CLOEXEC);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_OPEN_FILE_H
