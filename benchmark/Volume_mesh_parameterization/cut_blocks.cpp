// Cuts thin blocks out of a tetrahedral mesh, with about half of their vertices on the boundary and slivers there, and maps
// the boundary of each to a box.
#include "write_case.h"

#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Input_error.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
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
using Facet = std::array<std::size_t, 3>;

Eigen::Vector3d point(const Soup& soup, const std::size_t v) { return Eigen::Vector3d(soup.points[v].data()); }

Eigen::Vector3d center(const Soup& soup, const std::array<std::size_t, 4>& cell)
{
  return (point(soup, cell[0]) + point(soup, cell[1]) + point(soup, cell[2]) + point(soup, cell[3])) / 4;
}

double mean_edge_length(const Soup& soup)
{
  double sum = 0;
  for(const auto& cell : soup.cells)
    sum += (point(soup, cell[1]) - point(soup, cell[0])).norm();
  return sum / static_cast<double>(soup.cells.size());
}

// The cells whose center is in the box, as far as they hang together by facets with one of them.
Soup block_around(const Soup& soup, const std::size_t first, const Eigen::Vector3d& half_sides)
{
  const Eigen::Vector3d middle = center(soup, soup.cells[first]);
  std::map<Facet, std::vector<std::size_t> > cells_of_facet;
  const auto facets = [&](const std::size_t c)
  {
    std::array<Facet, 4> result;
    for(std::size_t i = 0; i < 4; ++i)
    {
      for(std::size_t k = 0; k < 3; ++k)
        result[i][k] = soup.cells[c][(i + k + 1) % 4];
      std::sort(result[i].begin(), result[i].end());
    }
    return result;
  };
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    if(((center(soup, soup.cells[c]) - middle).cwiseAbs().array() <= half_sides.array()).all())
      for(const Facet& facet : facets(c))
        cells_of_facet[facet].push_back(c);

  std::vector<bool> is_found(soup.cells.size(), false);
  std::vector<std::size_t> found = { first };
  is_found[first] = true;
  for(std::size_t i = 0; i < found.size(); ++i)
    for(const Facet& facet : facets(found[i]))
      for(const std::size_t c : cells_of_facet[facet])
        if(!is_found[c])
        {
          is_found[c] = true;
          found.push_back(c);
        }

  Soup block;
  std::unordered_map<std::size_t, std::size_t> number;
  for(const std::size_t c : found)
  {
    block.cells.push_back(soup.cells[c]);
    block.cell_references.push_back(1);
    for(std::size_t& v : block.cells.back())
    {
      const auto [place, is_new] = number.emplace(v, block.points.size());
      if(is_new)
        block.points.push_back(soup.points[v]);
      v = place->second;
    }
  }
  return block;
}

// Four to seven edges thick, and ten to thirty wide.
Eigen::Vector3d random_half_sides(const double edge, std::mt19937& engine)
{
  std::uniform_real_distribution<double> thin(2, 3.5), wide(5, 15);
  std::array<double, 3> sides = { thin(engine), wide(engine), wide(engine) };
  std::shuffle(sides.begin(), sides.end(), engine);
  return edge * Eigen::Vector3d(sides.data());
}

// Is the boundary a sphere that can be mapped to the box?
bool write_block(const Soup& block, const Eigen::Vector3d& sides, const std::string& name)
{
  C3t3 c3t3;
  std::vector<Vertex_handle> vertices;
  std::vector<C3t3::Cell_handle> cells;
  VMP::tetrahedron_soup_to_mesh_complex_3(block, c3t3, vertices, cells);
  VMP::make_parameterizable(c3t3); // cells with all vertices on the boundary would become flat in the faces of the box
  std::unordered_map<Vertex_handle, Point_3> targets;
  const VMP::Cube_boundary_parameterizer_3 parameterizer(sides[0], sides[1], sides[2]);
  if(parameterizer.parameterize(c3t3, boost::make_assoc_property_map(targets)) != VMP::OK)
    return false;
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
                 "Writes NAME1.mesh, NAME1_box.txt, ... for NUMBER thin blocks with 500 to 20,000 vertices." << std::endl;
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
      const Eigen::Vector3d half_sides = random_half_sides(edge, engine);
      const Soup block = block_around(soup, engine() % soup.cells.size(), half_sides);
      if(block.points.size() < 500 || block.points.size() > 20000)
        continue;
      number += write_block(block, 2 * half_sides, argv[4] + std::to_string(number + 1));
    }
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
