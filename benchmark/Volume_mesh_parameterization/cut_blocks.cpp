// Cuts blocks with wavy faces out of a tetrahedral mesh, with most of their vertices on the boundary and slivers there, and
// maps the boundary of each to a box.
#include "write_case.h"

#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <unordered_map>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;

namespace VMP = CGAL::Volume_mesh_parameterization;

using Soup = VMP::Tetrahedron_soup_3;
using Cell = std::array<std::size_t, 4>;
using Facet = std::array<std::size_t, 3>;
using Edge = std::array<std::size_t, 2>;

Eigen::Vector3d point(const Soup& soup, const std::size_t v) { return Eigen::Vector3d(soup.points[v].data()); }

double mean_edge_length(const Soup& soup)
{
  double sum = 0;
  for(const Cell& cell : soup.cells)
    sum += (point(soup, cell[1]) - point(soup, cell[0])).norm();
  return sum / static_cast<double>(soup.cells.size());
}

// Returns the edges in ascending order, so that the cells around a facet cut its edges in one order.
std::array<Edge, 6> edges_of_cell(Cell cell)
{
  std::sort(cell.begin(), cell.end());
  const auto& [a, b, c, d] = cell;
  return {{ { a, b }, { a, c }, { a, d }, { b, c }, { b, d }, { c, d } }};
}

std::array<Facet, 4> facets_of_cell(Cell cell)
{
  std::sort(cell.begin(), cell.end());
  const auto& [a, b, c, d] = cell;
  return {{ { a, b, c }, { a, b, d }, { a, c, d }, { b, c, d } }};
}

void split_edge(std::vector<Cell>& cells, const Edge& edge, const std::size_t middle)
{
  for(std::size_t i = cells.size(); i-- > 0; )
  {
    const auto first = std::find(cells[i].begin(), cells[i].end(), edge[0]);
    const auto second = std::find(cells[i].begin(), cells[i].end(), edge[1]);
    if(first == cells[i].end() || second == cells[i].end())
      continue;
    Cell half = cells[i];
    half[first - cells[i].begin()] = middle;
    *second = middle;
    cells.push_back(half);
  }
}

// Cells are cut in two where the function is zero, as close to a vertex as that may be: this makes slivers.
template <typename Function>
Soup part_where_positive(const Soup& soup, const Function& function)
{
  Soup part;
  part.points = soup.points;
  std::vector<double> values(soup.points.size());
  for(std::size_t v = 0; v < values.size(); ++v)
    values[v] = function(point(soup, v));
  std::map<Edge, std::size_t> zeros;
  const auto zero_of_edge = [&](const Edge& edge)
  {
    const auto [entry, is_new] = zeros.emplace(edge, part.points.size());
    if(is_new)
    {
      const auto [a, b] = edge;
      const double ratio = values[a] / (values[a] - values[b]);
      const Eigen::Vector3d zero = (1 - ratio) * point(soup, a) + ratio * point(soup, b);
      part.points.push_back({ zero[0], zero[1], zero[2] });
      values.push_back(0);
    }
    return entry->second;
  };
  for(const Cell& cell : soup.cells)
  {
    std::vector<Cell> pieces = { cell };
    for(const Edge& edge : edges_of_cell(cell))
      if(values[edge[0]] * values[edge[1]] < 0)
        split_edge(pieces, edge, zero_of_edge(edge));
    for(const Cell& piece : pieces)
      if(std::all_of(piece.begin(), piece.end(), [&](const std::size_t v) { return values[v] >= 0; }))
        part.cells.push_back(piece);
  }
  return part;
}

// The largest of the parts that hang together by facets, its vertices numbered anew.
Soup largest_component(const Soup& soup)
{
  std::map<Facet, std::vector<std::size_t> > cells_of_facet;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    for(const Facet& facet : facets_of_cell(soup.cells[c]))
      cells_of_facet[facet].push_back(c);
  std::vector<bool> is_found(soup.cells.size(), false);
  std::vector<std::size_t> largest;
  for(std::size_t first = 0; first < soup.cells.size(); ++first)
  {
    std::vector<std::size_t> found;
    const auto find = [&](const std::size_t c)
    {
      if(!is_found[c])
        found.push_back(c);
      is_found[c] = true;
    };
    find(first);
    for(std::size_t i = 0; i < found.size(); ++i)
      for(const Facet& facet : facets_of_cell(soup.cells[found[i]]))
        for(const std::size_t c : cells_of_facet[facet])
          find(c);
    if(found.size() > largest.size())
      largest = found;
  }

  Soup component;
  std::unordered_map<std::size_t, std::size_t> number;
  for(const std::size_t c : largest)
  {
    component.cells.push_back(soup.cells[c]);
    component.cell_references.push_back(1);
    for(std::size_t& v : component.cells.back())
    {
      const auto [entry, is_new] = number.emplace(v, component.points.size());
      if(is_new)
        component.points.push_back(soup.points[v]);
      v = entry->second;
    }
  }
  return component;
}

// A box in random direction with wavy faces, six to ten edges thick, and twelve to thirty wide.
class Wavy_box
{
public:
  Wavy_box(const Eigen::Vector3d& middle, const double edge, std::mt19937& engine)
    : m_middle(middle)
  {
    std::uniform_real_distribution<double> thin(3, 5), wide(6, 15), angle(0, 6.28), height(0, 0.4);
    m_half_sides = edge * Eigen::Vector3d(thin(engine), wide(engine), wide(engine));
    for(int i = 0; i < 3; ++i)
    {
      m_axes = Eigen::AngleAxisd(angle(engine), Eigen::Vector3d::Unit(i)) * m_axes;
      m_phases[i] = angle(engine);
    }
    m_height = height(engine) * m_half_sides[1];
  }
  Eigen::Vector3d sides() const { return 2 * m_half_sides; }
  Soup part_of(Soup soup) const
  {
    for(int face = 0; face < 6; ++face)
      soup = part_where_positive(soup, [&](const Eigen::Vector3d& p) { return depth(face, p); });
    return largest_component(soup);
  }

private:
  // below a face; along the wide sides there is one wave
  double depth(const int face, const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d q = m_axes * (p - m_middle);
    const int i = face / 2;
    const int k = i == 1 ? 2 : 1;
    const double wave = m_height * std::sin(3 * q[k] / m_half_sides[k] + m_phases[i]);
    return m_half_sides[i] - (face % 2 == 0 ? q[i] - wave : wave - q[i]);
  }

  Eigen::Vector3d m_middle, m_half_sides;
  Eigen::Matrix3d m_axes = Eigen::Matrix3d::Identity();
  std::array<double, 3> m_phases;
  double m_height;
};

// Returns whether the boundary is a sphere that can be mapped to the box.
bool write_block(const Soup& block, const Eigen::Vector3d& sides, const std::string& name)
{
  C3t3 c3t3;
  std::vector<Vertex_handle> vertices;
  std::vector<C3t3::Cell_handle> cells;
  VMP::tetrahedron_soup_to_mesh_complex_3(block, c3t3, vertices, cells);
  std::unordered_map<Vertex_handle, Point_3> targets;
  const VMP::Cube_boundary_parameterizer_3 parameterizer(sides[0], sides[1], sides[2]);
  if(parameterizer.parameterize(c3t3, boost::make_assoc_property_map(targets)) != VMP::OK)
    return false;
  // only what no map can have: other edges between vertices of the boundary stay, and make the case hard
  VMP::make_parameterizable(c3t3, CGAL::parameters::boundary_map(boost::make_assoc_property_map(targets)));
  Soup refined;
  VMP::mesh_complex_3_to_tetrahedron_soup(c3t3, refined, vertices);
  write_mesh(name, refined);
  write_targets(name, "box", vertices.size(), [&](std::size_t v) { return targets.count(vertices[v]) != 0; },
                [&](std::size_t v) { return VMP::internal::coordinates(targets.at(vertices[v])); });
  std::cout << name << ": " << vertices.size() << " vertices, " << targets.size() << " on the boundary" << std::endl;
  return true;
}

int main(int argc, char* argv[])
{
  if(argc != 5)
  {
    std::cerr << "Usage: cut_blocks SOURCE.mesh NUMBER SEED NAME\n"
                 "Writes NAME1.mesh, NAME1_box.txt, ... for NUMBER blocks with 500 to 20,000 vertices." << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    Soup soup;
    VMP::IO::read_MEDIT(argv[1], soup);
    const double edge = mean_edge_length(soup);
    std::mt19937 engine(static_cast<unsigned>(std::atoi(argv[3])));
    int number = 0;
    for(int i = 0; number < std::atoi(argv[2]) && i < 1000; ++i)
    {
      const Wavy_box box(point(soup, engine() % soup.points.size()), edge, engine);
      const Soup block = box.part_of(soup);
      if(block.points.size() < 500 || block.points.size() > 20000)
        continue;
      number += write_block(block, box.sides(), argv[4] + std::to_string(number + 1));
    }
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
