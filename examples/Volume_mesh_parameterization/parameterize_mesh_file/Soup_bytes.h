// A mesh as bytes, for another process of the same program.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_SOUP_BYTES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_SOUP_BYTES_H

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

// Appends values to bytes, or restores them from bytes in the same order.
class Soup_bytes
{
public:
  explicit Soup_bytes(VMP::Tetrahedron_soup_3& soup) : m_does_restore(false) { add_all(soup); }
  explicit Soup_bytes(std::string bytes) : m_does_restore(true), m_bytes(std::move(bytes)) {}

  const std::string& bytes() const { return m_bytes; }

  VMP::Tetrahedron_soup_3 restored()
  {
    VMP::Tetrahedron_soup_3 soup;
    add_all(soup);
    return soup;
  }

private:
  void add_all(VMP::Tetrahedron_soup_3& soup)
  {
    add(soup.points);
    add(soup.cells);
    add(soup.cell_references);
    add(soup.facets);
    add(soup.facet_references);
    add(soup.edges);
    add(soup.edge_references);
    add(soup.corners);
    for(auto* const data : { &soup.point_data, &soup.cell_data, &soup.facet_data, &soup.edge_data })
      add(*data);
    add(soup.notes);
    std::vector<std::array<int, 2> > groups;
    std::vector<std::string> names;
    for(const auto& [group, name] : soup.group_names)
    {
      groups.push_back({ group.first, group.second });
      names.push_back(name);
    }
    add(groups);
    add(names);
    for(std::size_t i = 0; i < groups.size(); ++i)
      soup.group_names[{ groups[i][0], groups[i][1] }] = names[i];
  }

  void add(VMP::Data_array_3& array)
  {
    add(array.name);
    copy(&array.number_of_components, 1);
    copy(&array.has_integers, 1);
    add(array.values);
  }

  // Adds a vector or a string.
  template <typename Array>
  void add(Array& values)
  {
    using Value = typename Array::value_type;
    std::size_t size = values.size();
    copy(&size, 1);
    if(m_does_restore && size > m_bytes.size())
      fail();
    values.resize(size);
    if constexpr(std::is_trivially_copyable_v<Value>)
      copy(values.data(), size);
    else
      for(Value& value : values)
        add(value);
  }

  template <typename Value>
  void copy(Value* const values, const std::size_t number)
  {
    const std::size_t size = number * sizeof(Value);
    if(!m_does_restore)
      m_bytes.append(reinterpret_cast<const char*>(values), size);
    else if(size > m_bytes.size() - m_position)
      fail();
    else if(size > 0)
      std::memcpy(values, &m_bytes[m_position], size);
    m_position += size;
  }

  [[noreturn]] static void fail()
  { throw VMP::Input_error("the process that reads it returns no mesh"); }

  bool m_does_restore;
  std::string m_bytes;
  std::size_t m_position = 0;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_SOUP_BYTES_H
