// Numbered meshes: order of vertices and cells, and facets of cells.
#include "catch.h"
#include "map_checks.h"

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Facet_matching_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("Threads find the facets, and the first of several mistakes, that one thread does")
{
  const Numbered_mesh_3 mesh = cube_mesh(24);
  const auto facets = VMP::internal::boundary_facets_3(mesh.cells);
  CHECK(facets.size() == 2 * 6 * 24 * 24);
  CHECK(VMP::internal::boundary_facets_3(mesh.cells, true) == facets);

  VMP::Tetrahedron_soup_3 soup;
  for(const std::array<int, 4>& cell : mesh.cells)
    soup.cells.push_back({ std::size_t(cell[0]), std::size_t(cell[1]), std::size_t(cell[2]), std::size_t(cell[3]) });
  soup.points.resize(mesh.number_of_vertices());
  for(std::size_t c = 5; c < soup.cells.size(); c += 500) // inverted cells overlap their neighbors
    std::swap(soup.cells[c][0], soup.cells[c][1]);
  const auto mistake = [&](const bool is_parallel) -> std::string
  {
    try
    {
      VMP::internal::Facet_matching_3(soup.cells, is_parallel);
    }
    catch(const VMP::Input_error& error)
    {
      return error.what();
    }
    return "";
  };
  CHECK(!mistake(false).empty());
  for(int i = 0; i < 10; ++i)
    CHECK(mistake(true) == mistake(false));
}
#endif

TEST_CASE("The spatial order keeps free vertices in front and the mesh as it is")
{
  const Numbered_mesh_3 mesh = twisted_cube(4, 0.1);
  std::vector<bool> is_prescribed;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    is_prescribed.push_back(!mesh.is_free(v));
  const std::vector<std::size_t> order = VMP::internal::spatial_order_3(mesh.source, is_prescribed);
#ifdef CGAL_LINKED_WITH_TBB
  CHECK(VMP::internal::spatial_order_3(mesh.source, is_prescribed, true) == order);
#endif
  std::vector<std::size_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  REQUIRE(sorted.size() == is_prescribed.size());
  for(std::size_t i = 0; i < sorted.size(); ++i)
    REQUIRE(sorted[i] == i);

  const auto [ordered, order_of_mesh] = VMP::internal::ordered_mesh_3(mesh.cells, mesh.source, is_prescribed);
  CHECK(order_of_mesh == order);
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    CHECK(ordered.is_free(static_cast<int>(i)) == mesh.is_free(static_cast<int>(order[i])));
    CHECK(ordered.source.col(i) == mesh.source.col(order[i]));
  }
  // each cell is named by its place among the cells of the user
  REQUIRE(ordered.cells.size() == mesh.cells.size());
  std::vector<bool> is_found(mesh.cells.size(), false);
  for(std::size_t c = 0; c < ordered.cells.size(); ++c)
  {
    std::array<int, 4> cell = ordered.cells[c];
    for(int& v : cell)
      v = static_cast<int>(order[v]);
    CHECK(cell == mesh.cells[ordered.user_number(c)]);
    CHECK(!is_found[ordered.user_number(c)]);
    is_found[ordered.user_number(c)] = true;
  }
}

TEST_CASE("Vertices that are prescribed keep their place among each other")
{
  const Numbered_mesh_3 mesh = twisted_cube(3, 0.1);
  std::vector<bool> is_prescribed(mesh.number_of_vertices());
  std::vector<std::size_t> prescribed;
  for(std::size_t v = 0; v < is_prescribed.size(); ++v)
    if((is_prescribed[v] = v % 3 != 1))
      prescribed.push_back(v);
  const std::vector<std::size_t> order = VMP::internal::spatial_order_3(mesh.source, is_prescribed);
  CHECK(std::vector<std::size_t>(order.end() - prescribed.size(), order.end()) == prescribed);
}
