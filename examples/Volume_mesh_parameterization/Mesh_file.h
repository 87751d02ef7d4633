// A mesh in the order of its file, and the same mesh as a complex.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MESH_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MESH_FILE_H

#include "Progress_line.h"

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;
using Points = std::vector<std::array<double, 3> >;
using Index_map = std::unordered_map<Vertex_handle, std::size_t>; // to the order of the file

class Mesh_file
{
public:
  Mesh_file(const std::string& filename, Progress_line& progress)
    : m_filename(filename)
  {
    namespace VMP = CGAL::Volume_mesh_parameterization;
    try
    {
      if(VMP::IO::read_MEDIT(filename, soup, CGAL::parameters::visitor(std::ref(progress))) == VMP::ERROR_INTERRUPTED)
        throw Interruption();
    }
    catch(const Input_error& error)
    {
      const std::filesystem::path path(filename);
      if(path.extension() == ".mesh" || !std::filesystem::exists(path))
        throw;
      throw Input_error(error.what() + std::string("; other formats can be converted: meshio convert ") + filename + " "
                        + std::filesystem::path(path).replace_extension(".mesh").string());
    }
  }

  void make_complex()
  {
    std::vector<Vertex_handle> vertices;
    std::vector<C3t3::Cell_handle> cells;
    try
    {
      CGAL::Volume_mesh_parameterization::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
    }
    catch(const Input_error& error)
    {
      throw Input_error(m_filename + ": " + error.what());
    }
    for(std::size_t v = 0; v < vertices.size(); ++v)
      if(vertices[v] != Vertex_handle()) // otherwise it has no cell
        indices.emplace(vertices[v], v);
  }

  // Takes over the vertices that refinement has added, behind those of the file.
  void update_soup(const std::size_t number_of_points)
  {
    CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 refined;
    std::vector<Vertex_handle> vertices;
    CGAL::Volume_mesh_parameterization::mesh_complex_3_to_tetrahedron_soup(c3t3, refined, vertices);
    soup.points.resize(number_of_points);
    for(std::size_t v = 0; v < vertices.size(); ++v)
      soup.points[indices.at(vertices[v])] = refined.points[v];
    for(auto& cell : refined.cells)
      for(std::size_t& v : cell)
        v = indices.at(vertices[v]);
    soup.cells = std::move(refined.cells);
    soup.cell_references = std::move(refined.cell_references);
  }

  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 soup;
  C3t3 c3t3;
  Index_map indices;

private:
  using Input_error = CGAL::Volume_mesh_parameterization::Input_error;

  std::string m_filename;
};

// A property map that finds the point of a vertex by its index in the file. New vertices are appended.
struct Point_map
{
  using key_type = Vertex_handle;
  using value_type = Point_3;
  using reference = Point_3;
  using category = boost::read_write_property_map_tag;

  friend Point_3 get(const Point_map& map, Vertex_handle v)
  {
    const std::array<double, 3>& p = (*map.points)[map.indices->at(v)];
    return Point_3(p[0], p[1], p[2]);
  }

  friend void put(const Point_map& map, Vertex_handle v, const Point_3& p)
  {
    const auto [entry, is_new] = map.indices->emplace(v, map.points->size());
    if(is_new)
      map.points->emplace_back();
    (*map.points)[entry->second] = {p.x(), p.y(), p.z()};
  }

  Index_map* indices;
  Points* points;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MESH_FILE_H
