// Reads arrays of VTU files.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_ARRAY_OF_VTU_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_ARRAY_OF_VTU_FILE_H

#include "catch.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

// The values of type T of an array in a VTU file, whose declaration must have that type.
template <typename T = double>
std::vector<T> array_of(const std::string& file, const std::string& name, const std::string& type = "Float64")
{
  const std::string declaration = "type=\"" + type + "\" Name=\"" + name + "\"", appended = " format=\"appended\" offset=\"";
  const std::size_t declared = file.find(declaration);
  REQUIRE(declared != std::string::npos);
  const std::size_t offset = file.find(appended, declared);
  const std::string between = file.substr(declared + declaration.size(), offset - declared - declaration.size());
  REQUIRE((between.empty() || between == " NumberOfComponents=\"3\"" || between == " NumberOfComponents=\"2\""));
  const std::size_t begin = file.find("encoding=\"raw\">\n_") + 17 + std::stoul(file.substr(offset + appended.size()));
  std::uint64_t number_of_bytes = 0;
  REQUIRE(begin + sizeof(number_of_bytes) <= file.size());
  std::memcpy(&number_of_bytes, file.data() + begin, sizeof(number_of_bytes));
  REQUIRE(number_of_bytes <= file.size() - begin - sizeof(number_of_bytes));
  std::vector<T> values(number_of_bytes / sizeof(T));
  std::memcpy(values.data(), file.data() + begin + sizeof(number_of_bytes), number_of_bytes);
  return values;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_ARRAY_OF_VTU_FILE_H
