#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>

// A file that appears under its name when it is complete, and never if `commit()` is not reached. One is written at a
// time.
class Output_file
{
public:
  explicit Output_file(const std::string& name)
    : m_path(path(name)),
      m_temporary(m_path.string() + "." + std::to_string(getpid()) + ".tmp")
  {
    if(std::filesystem::exists(m_path) && !std::filesystem::is_regular_file(m_path))
      throw std::runtime_error(name + ": this is not a regular file");
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
    std::filesystem::remove(m_temporary, ignored);
    unfinished = nullptr;
  }

  // The place of a file behind symbolic links, also if nothing is there yet: the link stays.
  static std::filesystem::path path(const std::string& name)
  {
    namespace fs = std::filesystem;
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

  std::ostream& stream() { return m_stream; }

  void commit()
  {
    m_stream.close();
    if(!m_stream)
      throw std::runtime_error(m_path.string() + ": the file cannot be written completely");
    std::filesystem::rename(m_temporary, m_path);
  }

private:
  static inline std::atomic<const char*> unfinished = nullptr; // without a lock, as in a handler it must be

  std::filesystem::path m_path, m_temporary;
  std::ofstream m_stream;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H
