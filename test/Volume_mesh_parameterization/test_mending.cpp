// Faults of a soup are mended: points at one place, cells that are reversed, vertices where a body touches itself.
#include "catch.h"
#include "cube_mesh.h"
#include "cube_complex.h"

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/repair_tetrahedron_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Soup = VMP::Tetrahedron_soup_3;

namespace {

// Two cells with the common facet 0, 1, 2, and a third vertex on each side of it.
Soup two_cells()
{
  Soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.cells = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  soup.cell_references = {1, 2};
  soup.facets = {{2, 1, 0}};
  soup.facet_references = {7};
  return soup;
}

// Tears them apart: the second cell has points of its own.
Soup two_torn_cells()
{
  Soup soup = two_cells();
  soup.points.insert(soup.points.end(), {{0, 1, 0}, {1, 0, 0}, {0, 0, 0}});
  soup.cells[1] = {7, 5, 6, 4};
  soup.facets.push_back({5, 6, 7});
  soup.corners = {5, 3};
  soup.facet_references.push_back(8);
  return soup;
}

} // namespace

TEST_CASE("Points at one place become the first of them")
{
  Soup soup = two_torn_cells();
  CHECK(VMP::boundary_vertices(soup.points, soup.cells).size() == 8);
  CHECK(VMP::merge_coinciding_points(soup) == std::vector<std::size_t>{0, 1, 2, 3, 4, 2, 1, 0});
  CHECK(soup.points.size() == 8); // indices keep their meaning
  CHECK(soup.cells == two_cells().cells);
  CHECK(soup.facets == std::vector<std::array<std::size_t, 3> >{{2, 1, 0}, {2, 1, 0}});
  CHECK(soup.corners == std::vector<std::size_t>{2, 3});
  CHECK(VMP::boundary_vertices(soup.points, soup.cells).size() == 5);

  CHECK(VMP::merge_coinciding_points(soup) == VMP::internal::first_coinciding_points(soup.points)); // nothing changes any more
  CHECK(soup.cells == two_cells().cells);
  // points that are a little apart are joined up to a distance
  Soup gap = two_torn_cells();
  gap.points[5][2] += 1e-6;
  gap.points[6][0] -= 1e-6;
  Soup unchanged = gap;
  CHECK(VMP::merge_coinciding_points(unchanged, 1e-7) == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 0});
  CHECK(VMP::merge_coinciding_points(gap, 1e-5) == std::vector<std::size_t>{0, 1, 2, 3, 4, 2, 1, 0});
  CHECK(gap.cells == two_cells().cells);
  CHECK_THROWS_WITH(VMP::merge_coinciding_points(gap, 5),
                    Catch::Matchers::Contains("of cell 0 (counted from 0). Use a smaller one"));
  CHECK(gap.cells == two_cells().cells);
  CHECK(VMP::internal::first_coinciding_points({{0., 0, 0}, {-0., 0, 0}, {1e-300, 0, 0}}) == std::vector<std::size_t>{0, 0, 2});
}

TEST_CASE("Cells with the same vertices become the first of them, with the references of all")
{
  Soup soup = two_cells();
  soup.cells.insert(soup.cells.end(), { { 1, 0, 2, 3 }, { 3, 2, 1, 0 } });
  soup.cell_references.insert(soup.cell_references.end(), { 9, 5 });
  soup.cell_data = { { "f", 2, false, { 0, 1, 2, 3, 4, 5, 6, 7 } } };
  CHECK(VMP::internal::first_coinciding_cells(soup.cells, false) == std::vector<std::size_t>{ 0, 1, 0, 0 });
  CHECK(VMP::merge_coinciding_cells(soup) == std::vector<std::size_t>{ 0, 1, 0, 0 });
  CHECK(soup.cells == two_cells().cells);
  CHECK(soup.cell_references == std::vector<int>{ 1, 2 });
  REQUIRE(soup.cell_data.size() == 3);
  CHECK(soup.cell_data[0].values == std::vector<double>{ 0, 1, 2, 3 });
  CHECK((soup.cell_data[1].name == "reference_2" && soup.cell_data[1].values == std::vector<double>{ 5, 0 }));
  CHECK((soup.cell_data[2].name == "reference_3" && soup.cell_data[2].values == std::vector<double>{ 9, 0 }));
  REQUIRE(soup.notes.size() == 1);
  CHECK(soup.notes[0].find("2 cells have the vertices of an earlier cell and are left out. For example, cell 2 has those of "
                           "cell 0") == 0);
  VMP::merge_coinciding_cells(soup);
  CHECK((soup.notes.size() == 1 && soup.cell_data.size() == 3));
}

// Two cells below the triangle a b d, whose edge a b has the vertex m, and a flat cell that covers them.
Soup cells_below_flat_one()
{
  Soup soup;
  soup.points = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, 0.5, -1}, {1, 0.5, 1}}; // a, b, d, m, below, above
  soup.cells = {{0, 3, 1, 2}, {0, 2, 3, 4}, {3, 2, 1, 4}};
  soup.cell_references = {1, 2, 3};
  soup.facets = {{0, 1, 2}, {0, 3, 4}};
  soup.facet_references = {4, 5};
  return soup;
}

TEST_CASE("Flat cells are left out where the boundary stays")
{
  Soup soup = cells_below_flat_one();
  CHECK(VMP::remove_flat_boundary_cells(soup) == 1);
  CHECK(soup.cells == std::vector<std::array<std::size_t, 4> >{{0, 2, 3, 4}, {3, 2, 1, 4}});
  CHECK(soup.cell_references == std::vector<int>{2, 3});
  CHECK(soup.facets == std::vector<std::array<std::size_t, 3> >{{0, 3, 4}});
  CHECK(soup.facet_references == std::vector<int>{5});
  REQUIRE(soup.notes.size() == 1);
  CHECK(soup.notes[0].find("1 flat cell at the boundary is left out.") == 0);
  CHECK(VMP::remove_flat_boundary_cells(soup) == 0);
  CHECK(soup.notes.size() == 1);

  Soup slit = cells_below_flat_one();
  slit.cells.push_back({0, 1, 2, 5}); // without the flat cell, both sides of a b d would be on the boundary
  slit.cell_references.push_back(6);
  CHECK(VMP::remove_flat_boundary_cells(slit) == 0);
  CHECK(slit.cells.size() == 4);

  // a square with two triangles on either side, then one whose three triangles have a point inside
  for(const std::array<double, 3> fourth : { std::array<double, 3>{2, 2, 0}, std::array<double, 3>{0.5, 0.25, 0} })
  {
    Soup layers;
    layers.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, fourth, {0.5, 0.5, -1}};
    layers.cells = {{0, 1, 2, 3}, {0, 1, 2, 4}};
    layers.cell_references = {1, 1};
    if(fourth[0] == 2)
    {
      layers.cells.push_back({1, 3, 2, 4});
      layers.cell_references.push_back(1);
    }
    CHECK(VMP::remove_flat_boundary_cells(layers) == 1);
    CHECK(layers.cells.front() == std::array<std::size_t, 4>{0, 1, 2, 4});
  }
}

TEST_CASE("Marks with a vertex twice are left out, and this is noted")
{
  Soup soup = two_cells();
  soup.facets = { {1, 3, 1}, {0, 2, 1} };
  soup.facet_references = { 5, 6 };
  soup.edges = { {0, 1}, {2, 2}, {3, 3} };
  soup.edge_references = { 7, 8, 9 };
  VMP::remove_false_marks(soup);
  CHECK(soup.facets == decltype(soup.facets){ {0, 2, 1} });
  CHECK(soup.facet_references == std::vector<int>{ 6 });
  CHECK(soup.edges == decltype(soup.edges){ {0, 1} });
  CHECK(soup.edge_references == std::vector<int>{ 7 });
  REQUIRE(soup.notes.size() == 2);
  CHECK(soup.notes[0].find("1 marked triangle has a vertex twice and is left out. The first one is at the vertex 1 ") == 0);
  CHECK(soup.notes[1].find("2 marked edges have a vertex twice and are left out. The first one is at the vertex 2 ") == 0);
}

TEST_CASE("A body that touches itself gets a vertex for each fan")
{
  // two cells at an edge, and a third one at a vertex
  Soup soup;
  soup.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 2}, {0, 1, 2}, {0, 0, 2}};
  soup.cells = {{0, 2, 3, 1}, {0, 4, 5, 1}, {1, 6, 7, 8}};
  soup.cell_references = {1, 2, 3};
  soup.facets = {{1, 0, 5}, {0, 1, 2}, {7, 6, 1}};
  soup.facet_references = {4, 5, 6};
  soup.edges = {{1, 0}, {3, 2}, {4, 1}, {8, 1}}; // the first one is in two of the parts
  soup.edge_references = {7, 8, 9, 10};
  soup.edge_data = {{"length", 1, false, {1, 2, 3, 4}}};
  soup.corners = {3, 1};
  CHECK(VMP::non_manifold_boundary_vertices(soup.points, soup.cells).size() == 2);
  const Soup before = soup;
  CHECK(VMP::separate_pinched_vertices(soup) == std::vector<std::size_t>{0, 1, 1});
  CHECK(soup.cells == std::vector<std::array<std::size_t, 4> >{{0, 2, 3, 1}, {9, 4, 5, 10}, {11, 6, 7, 8}});
  CHECK(soup.points[9] == before.points[0]);
  CHECK(soup.points[10] == before.points[1]);
  CHECK(soup.points[11] == before.points[1]);
  for(std::size_t f = 0; f < 3; ++f)
    std::sort(soup.facets[f].begin(), soup.facets[f].end());
  CHECK(soup.facets == std::vector<std::array<std::size_t, 3> >{{5, 9, 10}, {0, 1, 2}, {6, 7, 11}});
  CHECK(soup.edges == std::vector<std::array<std::size_t, 2> >{{1, 0}, {3, 2}, {4, 10}, {8, 11}, {9, 10}});
  CHECK(soup.edge_references == std::vector<int>{7, 8, 9, 10, 7});
  CHECK(soup.corners == std::vector<std::size_t>{3, 1, 10, 11});
  CHECK(soup.edge_data[0].values == std::vector<double>{1, 2, 3, 4, 1});
  CHECK(VMP::non_manifold_boundary_vertices(soup.points, soup.cells).empty());
  CHECK(VMP::separate_pinched_vertices(soup).empty());

  soup = two_cells();
  CHECK(VMP::separate_pinched_vertices(soup).empty());
  CHECK(soup.facets == two_cells().facets);

  using C3t3 = Cube_complex<>::C3t3;
  C3t3 c3t3;
  std::vector<C3t3::Vertex_handle> vertices;
  std::vector<C3t3::Cell_handle> cells;
  VMP::tetrahedron_soup_to_mesh_complex_3(before, c3t3, vertices, cells);
  CHECK(VMP::separate_pinched_vertices(c3t3) == 3);
  CHECK(c3t3.triangulation().number_of_vertices() == 12);
  CHECK(c3t3.number_of_cells_in_complex() == 3);
  CHECK(VMP::separate_pinched_vertices(c3t3) == 0);
}

TEST_CASE("Cells are turned where facets tell that this is right")
{
  Soup soup = two_cells();
  std::swap(soup.cells[1][0], soup.cells[1][1]);
  CHECK(VMP::orient_tetrahedron_soup(soup) == 1);
  CHECK(soup.cells[0] == two_cells().cells[0]);
  CHECK(VMP::boundary_vertices(soup.points, soup.cells).size() == 5);
  CHECK(VMP::orient_tetrahedron_soup(soup) == 0);

  // a vertex that has been moved through the common facet: the second cell lies on the first
  soup = two_cells();
  soup.points[4] = {0.1, 0.1, 0.5};
  const Soup tangled = soup;
  const auto sentence = [&]
  {
    try { VMP::orient_tetrahedron_soup(soup); }
    catch(const VMP::Input_error& error) { return std::string(error.what()); }
    return std::string();
  };
  CHECK(sentence().find("cell 1 (counted from 0) has the negative volume -0.083") == 0);
  CHECK(soup.cells == tangled.cells);

  std::swap(soup.cells[1][0], soup.cells[1][1]); // reversed, beside inverted
  CHECK(VMP::orient_tetrahedron_soup_by_facets(soup) == 1);
  CHECK(VMP::orient_tetrahedron_soup_by_facets(soup) == 0);

  soup = tangled;
  soup.points[4] = {1, 1, 0};
  soup.points[3] = {2, 2, 0};
  CHECK(sentence() == "2 cells have zero volume, among them cells 0 and 1 (counted from 0)");
  soup.points[3] = {0, 0, 1};
  CHECK(sentence() == "cell 1 (counted from 0) has zero volume");
}
