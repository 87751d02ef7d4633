// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_VTU_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_VTU_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/VTK_arrays.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/VTK_cells_reader.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The data of a section, but for what cannot be read, which is noted.
inline std::vector<Data_array_3> read_VTU_data(const VTK_arrays& arrays, const std::string& section,
                                               const std::size_t number_of_elements, std::vector<std::string>& notes)
{
  std::vector<Data_array_3> result;
  for(const std::string& name : arrays.names(section))
    try
    {
      const std::string path = section + "/" + name;
      const std::size_t n = arrays.number_of_components(path);
      Data_array_3 array = { name, n, arrays.has_integers(path), arrays.numbers<double>(path) };
      if(array.values.size() != n * number_of_elements)
        throw Input_error("its size is wrong");
      result.push_back(std::move(array));
    }
    catch(const Input_error& error)
    {
      notes.push_back("the data '" + name + "' are left out: " + error.what());
    }
  return result;
}

// The names of groups are arrays of two numbers, a reference and the dimension, as meshio writes them.
inline std::map<std::pair<int, int>, std::string> read_VTU_names(const VTK_arrays& arrays)
{
  std::map<std::pair<int, int>, std::string> result;
  for(const std::string& name : arrays.names("FieldData"))
  {
    if(!arrays.has_integers("FieldData/" + name))
      continue;
    const std::vector<std::int64_t> numbers = arrays.numbers<std::int64_t>("FieldData/" + name);
    if(numbers.size() == 2 && numbers[1] >= 1 && numbers[1] <= 3)
      result[{ static_cast<int>(numbers[1]), checked_reference(numbers[0]) }] = name;
  }
  return result;
}

inline Tetrahedron_soup_3 read_VTU(const std::string_view text, const Budget& budget)
{
  const VTK_arrays arrays(text, budget);
  Tetrahedron_soup_3 soup;
  const std::vector<double> coordinates = arrays.numbers<double>("Points", 3);
  for(std::size_t i = 0; i < coordinates.size(); i += 3)
    soup.points.push_back({ checked_coordinate(coordinates[i]), checked_coordinate(coordinates[i + 1]),
                            checked_coordinate(coordinates[i + 2]) });
  const std::vector<std::int64_t> types = arrays.numbers<std::int64_t>("Cells/types");
  arrays.check_number("NumberOfPoints", soup.points.size());
  arrays.check_number("NumberOfCells", types.size());
  soup.point_data = read_VTU_data(arrays, "PointData", soup.points.size(), soup.notes);
  soup.group_names = read_VTU_names(arrays);
  add_VTK_cells(soup, arrays.numbers<std::int64_t>("Cells/connectivity"), arrays.numbers<std::int64_t>("Cells/offsets"), types,
                read_VTU_data(arrays, "CellData", types.size(), soup.notes));
  return soup;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_READ_VTU_H
