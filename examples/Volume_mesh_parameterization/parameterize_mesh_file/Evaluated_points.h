// The options --evaluate and --evaluate-inverse of parameterize_mesh_file: points that a map carries, in a table.
#ifndef EVALUATED_POINTS_H
#define EVALUATED_POINTS_H

#include "Progress_line.h"

#include <CGAL/Volume_mesh_parameterization/IO/Output_file.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

class Evaluated_points
{
public:
  using Points = std::vector<std::array<double, 3> >;

  // The values of an option: a file with points, and the name of the table; none if it is not given.
  Evaluated_points(const std::vector<std::string>& words, const bool is_inverse) : m_is_inverse(is_inverse)
  {
    if(words.empty())
      return;
    if(words.size() != 2)
      throw std::runtime_error(std::string(is_inverse ? "--evaluate-inverse" : "--evaluate") + " needs the names of two files");
    m_input = words[0];
    m_name = words[1];
  }

  const std::string& input() const { return m_input; } // empty if there is none
  const std::string& name() const { return m_name; }

  // Reads lines of three coordinates, between blanks or commas. A first line that does not begin with a number has names.
  Points read() const
  {
    std::ifstream is(m_input);
    if(!is)
      throw VMP::Input_error(m_input + ": the file cannot be opened");
    Points result;
    std::string line;
    for(std::size_t number = 1; std::getline(is, line); ++number)
    {
      line.erase((std::min)(line.find('#'), line.size()));
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream words(line);
      words.imbue(std::locale::classic());
      std::array<double, 3> p;
      std::string rest;
      if((words >> std::ws).eof())
        continue;
      if(words >> p[0] >> p[1] >> p[2] && !(words >> rest))
        result.push_back(p);
      else if(number > 1 || line.find_first_of("0123456789") == line.find_first_not_of(" \t+-."))
        throw VMP::Input_error(m_input + ": line " + std::to_string(number) + " does not have three coordinates");
    }
    return result;
  }

  // Writes a line for each point: the nearest point of the source, its image, the distance of the given point from that of them
  // on its side, the cell with its reference, and the data of the mesh there. Integers of points are those of the nearest vertex.
  void write(const Points& points, const VMP::Tetrahedron_soup_3& source, const Points& uvw, Progress_line& progress) const
  {
    const VMP::Volume_map_3 map(source.points, source.cells, uvw);
    VMP::IO::Output_file file(m_name);
    std::ostream& os = file.stream();
    os.imbue(std::locale::classic());
    os << std::setprecision(17) << "x,y,z,u,v,w,distance,cell,reference";
    for(const auto* arrays : { &source.point_data, &source.cell_data })
      for(const VMP::Data_array_3& array : *arrays)
        for(std::size_t i = 0; i < array.number_of_components; ++i)
          os << ",\"" << array.name << (array.number_of_components == 1 ? "" : ":" + std::to_string(i)) << '"';
    os << "\n";
    const auto locations = m_is_inverse ? map.nearest_preimages(points) : map.nearest_images(points);
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      if(!locations[i])
        throw VMP::Input_error(m_input + ": point " + std::to_string(i) + " (counted from 0) is too far from the mesh");
      const auto& [other, cell, weights] = *locations[i];
      const auto mean = [&, &c = source.cells[cell], &b = weights](const auto& value)
      { return b[0] * value(c[0]) + b[1] * value(c[1]) + b[2] * value(c[2]) + b[3] * value(c[3]); };
      double square = 0;
      for(const Points* const side : { &source.points, &uvw })
        for(std::size_t k = 0; k < 3; ++k)
        {
          const double x = mean([&](const std::size_t v) { return (*side)[v][k]; });
          os << x << ",";
          if((side == &uvw) == m_is_inverse)
            square += (x - points[i][k]) * (x - points[i][k]);
        }
      os << std::sqrt(square) << "," << cell << "," << source.cell_references[cell];
      const std::size_t heaviest = static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
      for(const VMP::Data_array_3& array : source.point_data)
        for(std::size_t k = 0; k < array.number_of_components; ++k)
        {
          const auto value = [&](const std::size_t v) { return array.values[v * array.number_of_components + k]; };
          os << "," << (array.has_integers ? value(source.cells[cell][heaviest]) : mean(value));
        }
      for(const VMP::Data_array_3& array : source.cell_data)
        for(std::size_t k = 0; k < array.number_of_components; ++k)
          os << "," << array.values[cell * array.number_of_components + k];
      os << "\n";
    }
    file.commit(CGAL::parameters::visitor(std::ref(progress)));
  }

private:
  std::string m_input, m_name;
  bool m_is_inverse;
};

#endif // EVALUATED_POINTS_H
