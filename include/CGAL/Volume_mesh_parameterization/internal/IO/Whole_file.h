// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_WHOLE_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_WHOLE_FILE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <random>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <system_error>
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

// Follows symbolic links to the file, which need not be there yet.
inline std::string path_behind_links(const std::string& name)
{
  std::filesystem::path path = name;
  std::error_code ignored;
  for(int number = 0; std::filesystem::is_symlink(path, ignored); ++number)
  {
    if(number == 40) // as many as Linux follows
      throw std::runtime_error(name + ": there are too many symbolic links");
    path = path.parent_path() / std::filesystem::read_symlink(path);
  }
  return path.string();
}

// A file that appears under its name when it is complete, and never if `commit()` is not reached. Until then, it has a name
// of its own in the same folder, which nobody can foresee, and which was free. Symbolic links stay, and so does the mode of what
// is replaced. Files are destroyed in reverse order.
class Whole_file : private std::streambuf
{
public:
  explicit Whole_file(const std::string& name) : m_name(name), m_path(path_behind_links(name)), m_stream(this)
  {
    struct stat status = {};
    const bool is_there = stat(m_path.c_str(), &status) == 0;
    if(!is_there && errno != ENOENT)
      fail("the file cannot be written");
    if(is_there && !S_ISREG(status.st_mode))
      throw std::runtime_error(name + ": this is neither a regular file nor a pipe");
    std::random_device random;
    do
    {
      m_temporary = m_path.substr(0, m_path.rfind('/') + 1) + "." + std::to_string(random()) + std::to_string(random()) + ".tmp";
      m_next = last;
      last = this; // before there is the file, for handlers of signals
      m_descriptor = open(m_temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                          is_there ? status.st_mode & 0777 : 0666);
      if(m_descriptor < 0)
        last = m_next;
    } while(m_descriptor < 0 && errno == EEXIST);
    if(m_descriptor < 0)
      fail("the file cannot be written");
    if(is_there)
      fchmod(m_descriptor, status.st_mode & 0777); // what the user's mask has taken
    setp(m_buffer.data(), m_buffer.data() + m_buffer.size());
  }

  Whole_file(const Whole_file&) = delete;
  Whole_file& operator=(const Whole_file&) = delete;

  ~Whole_file()
  {
    close();
    unlink(m_temporary.c_str()); // nothing, if it has its name
    last = m_next;
  }

  std::ostream& stream() { return m_stream; }

  // Ends the writing. `commit()` can hardly fail then.
  void complete()
  {
    errno = 0;
    if(!m_stream.flush() || !close())
      fail("the file cannot be written completely");
  }

  void commit()
  {
    complete();
    if(std::rename(m_temporary.c_str(), m_path.c_str()) != 0)
      fail("the file cannot be written");
  }

  // For handlers of signals, before they end the program.
  static void remove_unfinished()
  {
    for(const Whole_file* file = last; file != nullptr; file = file->m_next)
      unlink(file->m_temporary.c_str());
  }

private:
  int_type overflow(const int_type c) override
  {
    if(sync() != 0)
      return traits_type::eof();
    return traits_type::eq_int_type(c, traits_type::eof()) ? traits_type::not_eof(c) : sputc(traits_type::to_char_type(c));
  }

  int sync() override
  {
    for(const char* begin = pbase(); begin != pptr();)
    {
      const ssize_t size = ::write(m_descriptor, begin, static_cast<std::size_t>(pptr() - begin));
      if(size < 0 && errno != EINTR)
      {
        m_error = errno;
        return -1;
      }
      begin += size < 0 ? 0 : size;
    }
    setp(m_buffer.data(), m_buffer.data() + m_buffer.size());
    return 0;
  }

  bool close()
  {
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    return descriptor < 0 || ::close(descriptor) == 0;
  }

  [[noreturn]] void fail(const char* sentence) const
  {
    const int error = m_error != 0 ? m_error : errno;
    throw std::runtime_error(m_name + ": " + sentence + (error == 0 ? "" : std::string(": ") + std::strerror(error)));
  }

  static inline std::atomic<const Whole_file*> last = nullptr; // without a lock, as in a handler it must be

  std::string m_name, m_path, m_temporary;
  int m_descriptor = -1, m_error = 0;
  std::array<char, 1 << 16> m_buffer;
  std::ostream m_stream;
  const Whole_file* m_next = nullptr;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_WHOLE_FILE_H
