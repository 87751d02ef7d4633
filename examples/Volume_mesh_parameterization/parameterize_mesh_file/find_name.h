#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_FIND_NAME_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_FIND_NAME_H

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Names of an option with their values.
template <typename Value>
using Name_table = std::vector<std::pair<std::string, Value> >;

// Returns the value of a name. If the name is not in the table, the exception lists the names there; `kind` is what they name.
template <typename Value>
Value find_name(const std::string& kind, const std::string& name, const Name_table<Value>& table)
{
  std::string names;
  for(const auto& [known, value] : table)
  {
    if(known == name)
      return value;
    names += (names.empty() ? "" : ", ") + known;
  }
  throw std::runtime_error("there is no " + kind + " '" + name + "'; choose among: " + names);
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_FIND_NAME_H
