#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

// A file that appears under its name when it is complete, and never if `commit()` is not reached. One is written at a
// time. A pipe or a terminal gets all when it is complete.
class Output_file
{
public:
  explicit Output_file(const std::string& name)
    : m_path(path(name)), m_is_stream(is_stream(name))
  {
    if(m_is_stream)
      return;
    if(std::filesystem::exists(m_path) && !std::filesystem::is_regular_file(m_path))
      throw std::runtime_error(name + ": this is neither a regular file nor a pipe");
    m_temporary = m_path.string() + "." + std::to_string(getpid()) + ".tmp";
    unfinished = m_temporary.c_str();
    m_stream.open(m_temporary, std::ios::binary);
    if(!m_stream)
      throw std::runtime_error(name + ": the file cannot be written");
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    std::error_code ignored;
    if(!m_is_stream)
      std::filesystem::remove(m_temporary, ignored);
    unfinished = nullptr;
  }

  // Is it a pipe, a terminal, or an open file of this program, whatever this is? None of them can be replaced.
  static bool is_stream(const std::string& name)
  {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(name, ignored);
    for(const std::string folder : { "/dev/std", "/dev/fd/", "/proc/self/fd/" })
      if(name.compare(0, folder.size(), folder) == 0)
        return true;
    return std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status);
  }

  // The place of a file behind symbolic links, also if nothing is there yet: the link stays.
  static std::filesystem::path path(const std::string& name)
  {
    namespace fs = std::filesystem;
    if(is_stream(name))
      return name;
    fs::path result = fs::absolute(name);
    for(int number = 0; fs::is_symlink(result); ++number)
    {
      if(number == 40) // as many as Linux follows
        throw std::runtime_error(name + ": there are too many symbolic links");
      result = result.parent_path() / fs::read_symlink(result);
    }
    return fs::weakly_canonical(result);
  }

  // For handlers of signals, before they end the program.
  static void remove_unfinished()
  {
    if(unfinished != nullptr)
      unlink(unfinished);
  }

  std::ostream& stream() { return m_is_stream ? static_cast<std::ostream&>(m_text) : m_stream; }

  void commit()
  {
    if(m_is_stream)
    {
      write_text();
      return;
    }
    m_stream.close();
    if(!m_stream)
      throw std::runtime_error(m_path.string() + ": the file cannot be written completely");
    std::filesystem::rename(m_temporary, m_path);
  }

private:
  void write_text() const
  {
    // where the standard output is a file, it goes on there
    const int descriptor = m_path == "/dev/stdout" ? dup(STDOUT_FILENO) : open(m_path.c_str(), O_WRONLY | O_APPEND);
    const std::string text = m_text.str();
    std::size_t begin = 0;
    for(ssize_t size = 0; descriptor >= 0 && begin < text.size() && size >= 0; begin += static_cast<std::size_t>(size))
      if((size = write(descriptor, text.data() + begin, text.size() - begin)) < 0)
        break;
    if(descriptor < 0 || begin < text.size() || close(descriptor) != 0)
      throw std::runtime_error(m_path.string() + ": this cannot be written completely");
  }

  static inline std::atomic<const char*> unfinished = nullptr; // without a lock, as in a handler it must be

  std::filesystem::path m_path;
  bool m_is_stream;
  std::string m_temporary;
  std::ofstream m_stream;
  std::ostringstream m_text; // for streams
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H
