// No file may be read and written, or written twice.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_ROLES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_ROLES_H

#include <CGAL/Volume_mesh_parameterization/IO/Output_file.h>

#include <sys/stat.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

using CGAL::Volume_mesh_parameterization::IO::Output_file;

// Returns whether two names stand for one file. A file that is not there yet has only its name.
inline bool is_same_file(const std::string& a, const std::string& b)
{
  struct stat s, t;
  const bool is_a_there = stat(a.c_str(), &s) == 0, is_b_there = stat(b.c_str(), &t) == 0;
  if(is_a_there && is_b_there)
    return s.st_dev == t.st_dev && s.st_ino == t.st_ino;
  const auto path = [](const std::string& name)
  {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(Output_file::path(name)), ignored);
  };
  return is_a_there == is_b_there && path(a) == path(b);
}

// Returns whether a name is one of a socket or a terminal, which have a way in and a way out.
inline bool has_two_ways(const std::string& name)
{
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(name, ignored);
  return std::filesystem::is_socket(status) || std::filesystem::is_character_file(status);
}

// Refuses names of one file in two roles. Names are not empty, as empty ones stand for no file.
inline void check_roles(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs)
{
  for(std::size_t i = 0; i < inputs.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(Output_file::is_stream(inputs[i]) && Output_file::is_stream(inputs[j]) && is_same_file(inputs[i], inputs[j]))
        throw std::runtime_error(inputs[i] + ": this input has two roles, but can be read only once");

  for(std::size_t i = 0; i < outputs.size(); ++i)
  {
    const std::string& name = outputs[i];
    if(is_same_file(name, "/dev/null"))
      continue;
    bool is_used = false;
    for(const std::string& input : inputs)
      is_used = is_used || (is_same_file(input, name) && !has_two_ways(name));
    for(std::size_t j = 0; j < i; ++j)
      is_used = is_used || is_same_file(outputs[j], name);
    if(is_used)
      throw std::runtime_error(name + ": this file has two roles and would be overwritten");
    Output_file can_be_written(name);
  }
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_ROLES_H
