#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_SHELL_QUOTED_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_SHELL_QUOTED_H

#include <boost/algorithm/string/replace.hpp>

#include <string>

// Returns a word as a shell wants it in a command, in quotes if it has other characters than those of plain names.
inline std::string shell_quoted(const std::string& word)
{
  const char* const plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./+:,=@%";
  if(!word.empty() && word.find_first_not_of(plain) == std::string::npos)
    return word;
  return "'" + boost::replace_all_copy(word, "'", "'\\''") + "'";
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_SHELL_QUOTED_H
