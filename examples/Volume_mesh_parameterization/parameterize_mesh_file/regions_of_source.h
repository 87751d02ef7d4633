// The option --regions: cell data as the subdomains of the source. Notes list data that could be subdomains, but are not used.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_REGIONS_OF_SOURCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_REGIONS_OF_SOURCE_H

#include "Mesh_format.h"

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

// Returns whether each cell has one integer. Some programs write integers as floating-point numbers.
inline bool has_one_integer(const VMP::Data_array_3& array)
{
  const auto is_integer = [](const double x) { return std::floor(x) == x && std::abs(x) <= (std::numeric_limits<int>::max)(); };
  return array.number_of_components == 1 && std::all_of(array.values.begin(), array.values.end(), is_integer);
}

// Makes cell data the references of the cells. Names of groups of cells belong to other references, and are removed.
inline void take_regions(const std::string& name, VMP::Tetrahedron_soup_3& soup)
{
  const auto found = std::find_if(soup.cell_data.begin(), soup.cell_data.end(), [&](const auto& array)
  { return array.name == name; });
  if(found == soup.cell_data.end())
  {
    std::string names;
    for(const VMP::Data_array_3& array : soup.cell_data)
      names += (names.empty() ? "" : ", ") + array.name;
    throw VMP::Input_error("there are no cell data '" + name + "' for --regions; " + (names.empty() ? "there are none at all"
                                                                                                    : "there are " + names));
  }
  if(!has_one_integer(*found))
    throw VMP::Input_error("the cell data '" + name + "' for --regions are not one integer for each cell");
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    soup.cell_references[c] = static_cast<int>(found->values[c]);
  soup.group_names.erase(soup.group_names.lower_bound({ 3, (std::numeric_limits<int>::min)() }), soup.group_names.end());
}

// Returns how many different values there are.
template <typename Value>
std::size_t number_of_values(std::vector<Value> values)
{
  std::sort(values.begin(), values.end());
  return static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin());
}

// Returns notes on cell data that divide the subdomains further, by integers with few values.
inline std::vector<std::string> notes_of_unused_regions(const VMP::Tetrahedron_soup_3& soup)
{
  std::vector<std::string> result;
  const std::size_t number_of_references = number_of_values(soup.cell_references);
  for(const VMP::Data_array_3& array : soup.cell_data)
  {
    if(!has_one_integer(array))
      continue;
    const std::size_t number = number_of_values(array.values);
    if(2 * number > soup.cells.size()) // as many numbers of cells as cells, for example
      continue;
    std::vector<std::pair<int, double> > parts;
    for(std::size_t c = 0; c < soup.cells.size(); ++c)
      parts.push_back({ soup.cell_references[c], array.values[c] });
    if(number_of_values(std::move(parts)) > number_of_references)
      result.push_back("the cell data '" + array.name + "' are integers with " + std::to_string(number)
                       + " values and are not used. If they are regions or materials, use --regions " + shell_quoted(array.name));
  }
  return result;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_REGIONS_OF_SOURCE_H
