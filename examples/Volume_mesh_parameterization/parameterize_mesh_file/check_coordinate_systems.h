// Checks Nastran files: Gmsh and meshio ignore the coordinate systems of points.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_COORDINATE_SYSTEMS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_COORDINATE_SYSTEMS_H

#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <cstddef>
#include <fstream>
#include <string>

// The third field of a line: between commas, or of 8 columns, or of 16 behind a name that ends with a star.
inline std::string third_Nastran_field(const std::string& line)
{
  if(const std::size_t comma = line.find(','); comma != line.npos)
  {
    const std::size_t begin = line.find(',', comma + 1);
    return begin == line.npos ? "" : line.substr(begin + 1, line.find(',', begin + 1) - begin - 1);
  }
  const std::size_t width = line.find('*') < 8 ? 16 : 8, begin = 8 + width;
  return line.size() < begin ? "" : line.substr(begin, width);
}

// Throws if a point, or by GRDSET all of them, are in another coordinate system than the basic one.
inline void check_coordinate_systems(const std::string& filename)
{
  std::ifstream is(filename);
  std::string line;
  for(std::size_t number = 1; std::getline(is, line); ++number)
    if(line.compare(0, 4, "GRID") == 0 || line.compare(0, 6, "GRDSET") == 0)
    {
      std::string system = third_Nastran_field(line);
      system.erase(0, system.find_first_not_of(" 0"));
      system.erase(system.find_last_not_of(" \r") + 1);
      if(!system.empty())
        throw CGAL::Volume_mesh_parameterization::Input_error(
          "line " + std::to_string(number) + ": the coordinate system (CP) is '" + system
          + "', but only the basic one (0 or blank) is supported: write the points in basic coordinates");
    }
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_COORDINATE_SYSTEMS_H
