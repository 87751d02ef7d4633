// Reads meshes by other libraries. On a damaged file, these may crash, use all memory, or never finish.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_IN_OWN_PROCESS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_IN_OWN_PROCESS_H

#include "Progress_line.h"
#include "Soup_bytes.h"

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#ifdef __linux__
#  include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

// Child of this process. The destructor kills it; on Linux, it does not outlive this process either.
class Child_process
{
public:
  Child_process() : m_id(fork())
  {
    if(m_id < 0)
      throw std::runtime_error(std::string("no process can be made to read files: ") + std::strerror(errno));
#ifdef __linux__
    if(is_this_one())
      prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  }

  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  ~Child_process()
  {
    if(m_id <= 0)
      return;
    kill(m_id, SIGKILL);
    status();
  }

  bool is_this_one() const { return m_id == 0; }

  // Waits until the child ends.
  int status()
  {
    int result = 0;
    while(waitpid(m_id, &result, 0) < 0 && errno == EINTR) {}
    m_id = -1;
    return result;
  }

private:
  pid_t m_id;
};

// How a child ends: these are exit codes.
enum Reading_result { MESH_READ, FILE_REFUSED, OUT_OF_MEMORY };

// Processor time for a file, a guess: Gmsh 4.8 reads a megabyte in 0.2 s.
inline rlim_t seconds_to_read(const std::size_t size_of_file) { return 60 + 10 * static_cast<rlim_t>(size_of_file >> 20); }

// Processor time to fill a body with tetrahedra, a guess: Gmsh 4.8 makes a million of them in a minute or two.
constexpr rlim_t seconds_to_mesh = 600;

// Limits the memory and the processor time of this process. The limits are guesses: the memory of Gmsh 4.8 is 13 times the
// size of a file.
inline void limit_resources(const std::size_t size_of_file, const rlim_t seconds)
{
  const auto limit = [](const auto resource, const rlim_t value)
  {
    rlimit limits = {};
    getrlimit(resource, &limits);
    limits.rlim_cur = (std::min)(limits.rlim_cur, value);
    setrlimit(resource, &limits);
  };
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds);
  rlim_t pages; // that this process has already
  if(std::ifstream("/proc/self/statm") >> pages)
    limit(RLIMIT_AS, pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t(4) << 30) + 100 * size_of_file);
}

// Writes the bytes of a mesh, or a sentence, to a pipe, and ends this process. Output of the library is discarded. The parent
// handles interruptions.
template <typename Read>
[[noreturn]] void read_and_exit(const Read& read, const int pipe)
{
  for(const int request : { SIGINT, SIGTERM, SIGHUP })
    signal(request, SIG_IGN);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  Reading_result result = MESH_READ;
  std::string bytes;
  try
  {
    VMP::Tetrahedron_soup_3 soup;
    read(soup);
    bytes = Soup_bytes(soup).bytes();
  }
  catch(const std::bad_alloc&)
  {
    result = OUT_OF_MEMORY;
  }
  catch(const std::length_error&) // of a vector
  {
    result = OUT_OF_MEMORY;
  }
  catch(const std::exception& error)
  {
    result = FILE_REFUSED;
    bytes = error.what();
    std::replace_if(bytes.begin(), bytes.end(), [](const unsigned char c) { return c < ' ' || c == 127; }, '?');
  }
  for(std::string_view rest = bytes; !rest.empty();)
  {
    const ssize_t size = write(pipe, rest.data(), rest.size());
    if(size < 0 && errno != EINTR)
      break; // the parent has ended
    rest.remove_prefix(static_cast<std::size_t>((std::max)(size, ssize_t(0))));
  }
  _exit(result);
}

// Names the largest integer of a text file if it exceeds the size of the file.
inline std::string note_of_large_number(const std::string& filename, const std::size_t size_of_file)
{
  unsigned long long largest = 0, number;
  std::ifstream is(filename);
  for(std::string word; is >> word;)
    if(const auto end = std::from_chars(word.data(), word.data() + word.size(), number);
       end.ec == std::errc() && end.ptr == word.data() + word.size())
      largest = (std::max)(largest, number);
  return largest > size_of_file ? "; the file contains the number " + std::to_string(largest) : "";
}

// Returns what comes from a pipe until it is closed, and throws an interruption if the time is over before.
inline std::string bytes_of_pipe(const int pipe, const Progress_line& progress, const Interruption& interruption)
{
  constexpr int milliseconds = 50; // a guess; between two questions whether to go on
  constexpr std::size_t chunk = 1 << 16;
  std::string bytes;
  while(progress.goes_on())
  {
    pollfd state = { pipe, POLLIN, 0 };
    if(poll(&state, 1, milliseconds) <= 0)
      continue;
    const std::size_t begin = bytes.size();
    bytes.resize(begin + chunk);
    const ssize_t size = read(pipe, &bytes[begin], chunk);
    bytes.resize(begin + static_cast<std::size_t>((std::max)(size, ssize_t(0))));
    if(size == 0)
      return bytes;
  }
  throw interruption;
}

// A library did not finish in time. Another attempt would take as long.
struct Out_of_time : VMP::Input_error
{
  using VMP::Input_error::Input_error;
};

// Returns the mesh that `read(mesh)` reads from a file by a library, in a process of its own. Where the library also makes the
// mesh, it has more time.
template <typename Read>
VMP::Tetrahedron_soup_3
read_in_own_process(const std::string& filename, const std::string& library, const Progress_line& progress, const Read& read,
                    const bool makes_mesh = false)
{
  std::error_code no_file;
  std::size_t size = std::filesystem::file_size(filename, no_file);
  size = no_file ? 0 : size;
  const rlim_t seconds = seconds_to_read(size) + (makes_mesh ? seconds_to_mesh : 0);
  std::array<int, 2> ends;
  if(pipe(ends.data()) != 0)
    throw std::runtime_error(std::string("no pipe can be made to read files: ") + std::strerror(errno));
  Child_process child;
  if(child.is_this_one())
  {
    close(ends[0]); // to fail at writing if the parent has ended
    limit_resources(size, seconds);
    read_and_exit(read, ends[1]);
  }
  close(ends[1]);
  const std::string advice = makes_mesh ? "Larger cells (--cells) need less time" : "The file may be damaged";
  Interruption interruption;
  if(makes_mesh)
    interruption.sentence = library + " has made no mesh yet. " + advice + ".";
  std::string bytes = bytes_of_pipe(ends[0], progress, interruption);
  close(ends[0]);
  const int status = child.status();
  if(WIFEXITED(status) && WEXITSTATUS(status) == MESH_READ)
    return Soup_bytes(std::move(bytes)).restored();
  if(WIFEXITED(status) && WEXITSTATUS(status) == FILE_REFUSED && !bytes.empty())
    throw VMP::Input_error(bytes);
  if(WIFEXITED(status) && WEXITSTATUS(status) == OUT_OF_MEMORY)
    throw VMP::Input_error(library + " ran out of memory on a file of " + std::to_string(size) + " bytes"
                           + note_of_large_number(filename, size));
  if(WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    throw Out_of_time(library + " did not finish within " + std::to_string(seconds) + " s of processor time. " + advice);
  throw VMP::Input_error(library + " crashed"
                         + (WIFSIGNALED(status) ? std::string(" (") + strsignal(WTERMSIG(status)) + ")" : std::string())
                         + "; the file may be damaged"
                         + (makes_mesh ? ". Save it anew in a CAD program, or save its surface as *.stl" : ""));
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_IN_OWN_PROCESS_H
