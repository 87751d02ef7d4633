#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_MAP_PROBLEM_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_MAP_PROBLEM_H

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// A mesh and the images of its boundary vertices, from files, in the arrays of the solver. Both are
// scaled such that the cells have the mean volume 1.
class Map_problem
{
  using Soup = CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3;

public:
  using Mesh = CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3;

  Map_problem(const std::string& source, const std::string& target)
  {
    namespace IO = CGAL::Volume_mesh_parameterization::IO;
    std::vector<std::array<double, 3> > targets;
    IO::read_MEDIT(source, m_soup);
    IO::read_boundary_targets(target, m_soup, targets);
    number_vertices();
    fill_mesh(targets);
    scale();
  }

  const Mesh& mesh() const { return m_mesh; }

  // Reads a map that has been computed for these files.
  Eigen::Matrix3Xd read(const std::string& filename) const
  {
    std::vector<std::array<double, 3> > points;
    CGAL::Volume_mesh_parameterization::IO::read_boundary_targets(filename, m_soup, points);
    Eigen::Matrix3Xd positions(3, m_mesh.number_of_vertices());
    for(std::size_t v = 0; v < m_numbers.size(); ++v)
      positions.col(m_numbers[v]) = m_target_scale * Eigen::Vector3d(points[v].data());
    return positions;
  }

  // Writes the mesh with its vertices at `positions`, in the units of the target.
  void write(const std::string& filename, const Eigen::Matrix3Xd& positions) const
  {
    Soup image = m_soup;
    image.points = in_order_of_file(positions, m_target_scale);
    require_written(CGAL::Volume_mesh_parameterization::IO::write_MEDIT(filename, image), filename);
  }

  // Writes the source with the map and its distortions as data, in the units of the source.
  void write_VTU(const std::string& filename, const Eigen::Matrix3Xd& positions) const
  {
    const auto uvw = in_order_of_file(positions, m_source_scale);
    require_written(CGAL::Volume_mesh_parameterization::IO::write_VTU(filename, m_soup, uvw), filename);
  }

private:
  static void require_written(const bool is_written, const std::string& filename)
  {
    if(!is_written)
      throw std::runtime_error(filename + ": the file cannot be written");
  }

  std::vector<std::array<double, 3> > in_order_of_file(const Eigen::Matrix3Xd& positions, const double scale) const
  {
    std::vector<std::array<double, 3> > points;
    for(const int number : m_numbers)
      points.push_back({ positions(0, number) / scale, positions(1, number) / scale, positions(2, number) / scale });
    return points;
  }

  // The vertices of the facets that belong to one cell only.
  std::vector<bool> find_boundary() const
  {
    std::map<std::array<std::size_t, 3>, int> number_of_cells;
    for(const auto& cell : m_soup.cells)
      for(int i = 0; i < 4; ++i)
      {
        std::array<std::size_t, 3> facet = { cell[(i + 1) % 4], cell[(i + 2) % 4], cell[(i + 3) % 4] };
        std::sort(facet.begin(), facet.end());
        ++number_of_cells[facet];
      }
    std::vector<bool> is_on_boundary(m_soup.points.size(), false);
    for(const auto& [facet, number] : number_of_cells)
      for(const std::size_t v : facet)
        is_on_boundary[v] = is_on_boundary[v] || number == 1;
    return is_on_boundary;
  }

  // The free vertices, those inside, come first.
  void number_vertices()
  {
    const std::vector<bool> is_on_boundary = find_boundary();
    m_mesh.number_of_free_vertices
      = static_cast<int>(std::count(is_on_boundary.begin(), is_on_boundary.end(), false));
    int next_free = 0, next_prescribed = m_mesh.number_of_free_vertices;
    for(const bool is_prescribed : is_on_boundary)
      m_numbers.push_back(is_prescribed ? next_prescribed++ : next_free++);
  }

  void fill_mesh(const std::vector<std::array<double, 3> >& targets)
  {
    const auto n = static_cast<Eigen::Index>(m_numbers.size());
    m_mesh.source.resize(3, n);
    m_mesh.target.setZero(3, n);
    for(std::size_t v = 0; v < m_numbers.size(); ++v)
    {
      const int number = m_numbers[v];
      m_mesh.source.col(number) = Eigen::Vector3d(m_soup.points[v].data());
      if(!m_mesh.is_free(number))
        m_mesh.target.col(number) = Eigen::Vector3d(targets[v].data());
    }
    if(!m_mesh.target.allFinite())
      throw std::runtime_error("a boundary vertex has no target");

    for(const auto& cell : m_soup.cells)
    {
      m_mesh.cells.push_back({ m_numbers[cell[0]], m_numbers[cell[1]], m_numbers[cell[2]], m_numbers[cell[3]] });
      std::array<int, 4>& numbered = m_mesh.cells.back();
      if(CGAL::Volume_mesh_parameterization::internal::edge_matrix(m_mesh.source, numbered).determinant() < 0)
        std::swap(numbered[0], numbered[1]);
    }
  }

  void scale()
  {
    using CGAL::Volume_mesh_parameterization::internal::volume;
    const double n = static_cast<double>(m_mesh.cells.size());
    // the volume of the target depends on its boundary only
    m_target_scale = std::cbrt(n / std::abs(volume(m_mesh, m_mesh.target)));
    m_source_scale = std::cbrt(n / volume(m_mesh, m_mesh.source));
    m_mesh.target *= m_target_scale;
    m_mesh.source *= m_source_scale;
  }

  Soup m_soup;
  std::vector<int> m_numbers; // by the index in the file
  Mesh m_mesh;
  double m_source_scale = 1, m_target_scale = 1;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_MAP_PROBLEM_H
