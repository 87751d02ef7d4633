// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTK_REFERENCES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTK_REFERENCES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// The letters and digits of a name, in lower case: programs write one name in several ways, as su2:tag and su2_tag.
inline std::string letters_of_name(const std::string& name)
{
  std::string result;
  for(const char c : name)
    if(('a' <= c && c <= 'z') || ('0' <= c && c <= '9'))
      result += c;
    else if('A' <= c && c <= 'Z')
      result += static_cast<char>(c - 'A' + 'a');
  return result;
}

// The names of cell data that are references, by their letters, the best ones first.
constexpr const char* names_of_references[] = {
  "reference", "meditref", "gmshphysical", "material", "attribute", "matid", "materialid", "materialids", // this package to GEOS
  "su2tag", "tetgenref", "nastranref", "netgenindex", "avsucdmaterial", "ugridref", "celltags",          // by meshio
  "modelregionid", "regionid", "cellentityids", "elemtag", "elset", "blockid", // SimVascular, VTK, VMTK, openCARP, Neper, 4C
  "region", "regions", "subdomain", "subdomains", "label", "labels", "grainid", "partid", "gmshgeometrical" };

// Returns whether each element has one integer. Some programs write integers as floating-point numbers.
inline bool has_one_integer(const Data_array_3& array)
{
  const auto is_integer = [](const double x)
  { return std::floor(x) == x && std::abs(x) <= static_cast<double>((std::numeric_limits<int>::max)()); };
  return array.number_of_components == 1
      && (array.has_integers || std::all_of(array.values.begin(), array.values.end(), is_integer));
}

// Returns the names of the sets that meshio has joined to the name of an array, by the first of five characters that is in none
// of them: each cell has the index of its set, or -1. Returns no name for another array.
inline std::vector<std::string> joined_sets(const Data_array_3& array)
{
  if(!array.has_integers || array.number_of_components != 1 || array.values.empty())
    return {};
  const auto [smallest, largest] = std::minmax_element(array.values.begin(), array.values.end());
  for(const char separator : { '-', '_', '#', '+', '/' })
  {
    std::vector<std::string> sets(1);
    for(const char c : array.name)
      if(c == separator)
        sets.emplace_back();
      else
        sets.back() += c;
    if(sets.size() == 1)
      return {};
    if(*smallest >= -1 && *largest + 1 == static_cast<double>(sets.size()) && std::count(sets.begin(), sets.end(), "") == 0)
      return sets;
  }
  return {};
}

// References of cells of all dimensions, which are not empty if there are any, and the sets that they number from 1 on.
struct VTK_references
{
  std::vector<double> values;
  std::vector<std::string> sets;
};

// Finds the references among the data of cells: those with a known name, or else sets of meshio.
inline VTK_references references_among(const std::vector<Data_array_3>& data)
{
  for(const char* name : names_of_references)
    for(const Data_array_3& array : data)
      if(letters_of_name(array.name) == name && has_one_integer(array))
        return { array.values, {} };
  for(const Data_array_3& array : data)
    if(std::vector<std::string> sets = joined_sets(array); !sets.empty())
    {
      VTK_references result = { array.values, std::move(sets) };
      for(double& value : result.values)
        ++value;
      return result;
    }
  return {};
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTK_REFERENCES_H
