#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H

#include "Progress_line.h"

#include <CGAL/Volume_mesh_parameterization/internal/IO/Whole_file.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/open_file.h>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

// Tells whether a name is one of a pipe, a device, or any open file of this program: none of them can be replaced.
inline bool is_stream(const std::string& name)
{
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(name, ignored);
  return CGAL::Volume_mesh_parameterization::internal::descriptor_of_name(name) >= 0 || std::filesystem::is_fifo(status)
      || std::filesystem::is_character_file(status);
}

// Exception that is thrown if nobody reads the output, and the time is over.
struct Unread_output : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Pipe, device, or open file of this program that gets a text.
class Output_stream
{
public:
  Output_stream(const std::string& name, const Progress_line& progress) : m_name(name), m_progress(progress)
  {
    while((m_descriptor = CGAL::Volume_mesh_parameterization::internal::open_file(name, O_WRONLY | O_APPEND)) < 0
          && errno == ENXIO) // a pipe that nobody reads yet
      wait();
    if(m_descriptor < 0)
      fail();
  }

  Output_stream(const Output_stream&) = delete;
  Output_stream& operator=(const Output_stream&) = delete;
  ~Output_stream() { close(m_descriptor); }

  void write(std::string_view text)
  {
    constexpr std::size_t chunk = 4096; // a pipe that can be written takes as much without waiting (PIPE_BUF)
    while(!text.empty())
    {
      pollfd state = { m_descriptor, POLLOUT, 0 };
      const bool is_ready = poll(&state, 1, 0) > 0;
      const ssize_t size = is_ready ? ::write(m_descriptor, text.data(), (std::min)(chunk, text.size())) : 0;
      if(size < 0 && errno != EINTR && errno != EAGAIN)
        fail();
      if(size <= 0)
      {
        wait();
        continue;
      }
      text.remove_prefix(static_cast<std::size_t>(size));
      m_seconds_of_waiting = 0;
    }
  }

private:
  // A little, as long as the program may; later, a reader has a second (a guess) for what is valid.
  void wait()
  {
    constexpr int milliseconds = 20;
    m_seconds_of_waiting += 1e-3 * milliseconds;
    if(!m_progress.goes_on() && m_seconds_of_waiting > 1)
      throw Unread_output(m_name + ": nobody reads this");
    poll(nullptr, 0, milliseconds);
  }

  [[noreturn]] void fail() const
  { throw std::runtime_error(m_name + ": this cannot be written completely: " + std::strerror(errno)); }

  std::string m_name;
  const Progress_line& m_progress;
  int m_descriptor;
  double m_seconds_of_waiting = 0;
};

// Gets all when it is complete, or nothing if `commit()` is not reached: a regular file, or a stream.
class Output_file
{
public:
  explicit Output_file(const std::string& name) : m_name(name)
  {
    if(!is_stream(name))
      m_file.emplace(name);
  }

  std::ostream& stream() { return m_file ? m_file->stream() : m_text; }

  void commit(const Progress_line& progress)
  {
    if(m_file)
      m_file->commit();
    else
      Output_stream(m_name, progress).write(m_text.str());
  }

private:
  std::string m_name;
  std::optional<CGAL::Volume_mesh_parameterization::internal::Whole_file> m_file;
  std::ostringstream m_text; // for streams
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H
