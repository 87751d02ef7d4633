// A tangled mesh gets positive cells within its own boundary.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace tangled_test {

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Soup = VMP::Tetrahedron_soup_3;
using Points = std::vector<std::array<double, 3> >;

std::size_t number_of_bad_cells(const Soup& soup)
{
  return std::count_if(soup.cells.begin(), soup.cells.end(), [&](const auto& cell)
  {
    const auto point = [&](const int i) { return VMP::internal::exact_point(soup.points[cell[i]]); };
    return CGAL::orientation(point(0), point(1), point(2), point(3)) != CGAL::POSITIVE;
  });
}

template <typename NamedParameters>
VMP::Parameterization_result improve(Soup& soup, const NamedParameters& np)
{
  const Points start = soup.points;
  Points images = soup.points;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    soup, start, images, np.use_regular_references(true).initial_map(CGAL::make_property_map(start)));
  if(result.has_valid_map)
    soup.points = images;
  return result;
}

// Moves the vertices inside.
template <typename Move>
void tangle(Soup& soup, const Move& move)
{
  std::vector<bool> is_inside(soup.points.size(), true);
  for(const std::size_t v : VMP::boundary_vertices(soup.points, soup.cells))
    is_inside[v] = false;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(is_inside[v])
      move(soup.points[v]);
}

// Adds a flat cell below the diagonal of a square on the side z = 0, where two facets were.
void add_flat_cell(Soup& soup)
{
  const auto vertex = [&](const double x, const double y)
  { return std::size_t(std::find(soup.points.begin(), soup.points.end(), std::array<double, 3>{x, y, 0}) - soup.points.begin()); };
  const std::size_t a = vertex(1, 1), b = vertex(2, 1), c = vertex(2, 2), d = vertex(1, 2);
  soup.cells.push_back({a, b, d, c});
  soup.cell_references.push_back(0);
}

} // namespace tangled_test

TEST_CASE("A tangled mesh is untangled within its boundary")
{
  using namespace tangled_test;
  const Soup cube = source_soup(cube_mesh(4));
  Soup soups[3] = { cube, cube, cube };
  tangle(soups[0], [](auto& p) { if(p[0] == 2 && p[1] == 2) p[0] += 1.5; }); // behind the next vertices
  tangle(soups[1], [](auto& p) { p = { 2, 2, 2 }; });                        // all cells inside are flat
  std::mt19937 engine;
  std::uniform_real_distribution<double> noise(-2, 6); // some are outside of the cube
  tangle(soups[2], [&](auto& p) { p = { noise(engine), noise(engine), noise(engine) }; });
  for(Soup& soup : soups)
  {
    const std::size_t number = number_of_bad_cells(soup);
    REQUIRE(number > 0);
    Points images;
    CHECK(CGAL::stretch_minimizing_volume_parameterization(soup, soup.points, images,
                                                           params::refinement_mode(VMP::Refinement_mode::NONE)).status
          == VMP::ERROR_INVERTED_SOURCE_CELL);
    const VMP::Parameterization_result result = improve(soup, params::energy(VMP::MIPS_energy_3()));
    CHECK(result.status == VMP::OK);
    CHECK(result.boundary_residual == 0);
    CHECK(result.number_of_inverted_cells_at_start == number);
    CHECK(number_of_bad_cells(soup) == 0);
    CHECK(result.distortion.angle_max < 10); // the right-angled cells of the cube have 3.3 to 4.1
    for(const std::size_t v : VMP::boundary_vertices(cube.points, cube.cells))
      CHECK(soup.points[v] == cube.points[v]);
  }
}

TEST_CASE("A regular mesh is its own minimum with respect to regular cells")
{
  using namespace tangled_test;
  // the cells around the center of an octahedron are alike, and one vertex is inside
  Soup octahedron;
  octahedron.points = {{0.3, 0.2, -0.1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  for(const std::size_t i : {1, 4})
    for(const std::size_t j : {2, 5})
      for(const std::size_t k : {3, 6})
        octahedron.cells.push_back((i == 1) ^ (j == 2) ^ (k == 3) ? std::array<std::size_t, 4>{0, i, j, k}
                                                                  : std::array<std::size_t, 4>{0, j, i, k});
  octahedron.cell_references.assign(8, 0);
  octahedron.points[0] = {2, 0.5, 0}; // outside
  const VMP::Parameterization_result result = improve(octahedron, params::energy_tolerance(0.));
  CHECK(result.status == VMP::OK);
  for(const double x : octahedron.points[0])
    CHECK(x == Approx(0).margin(1e-6));
}

TEST_CASE("A flat cell on the boundary is split")
{
  using namespace tangled_test;
  Soup soup = source_soup(cube_mesh(3));
  add_flat_cell(soup);
  REQUIRE(number_of_bad_cells(soup) == 1);
  const Points before = soup.points;
  Soup copy = soup;
  VMP::Parameterization_result result = improve(copy, params::energy(VMP::MIPS_energy_3()));
  CHECK(result.status == VMP::ERROR_PRESCRIBED_CELL_INVERTED);
  result = improve(soup, params::energy(VMP::MIPS_energy_3()).refinement_mode(VMP::Refinement_mode::HELPFUL));
  CHECK(result.status == VMP::OK);
  CHECK(number_of_bad_cells(soup) == 0);
  CHECK(soup.points.size() > before.size());
  for(const std::size_t v : VMP::boundary_vertices(soup.points, soup.cells))
  {
    REQUIRE(v < before.size());
    CHECK(soup.points[v] == before[v]);
  }
}

// A vertex is hardly above a facet of the boundary. Numbers of the linear system then differ by up to 1e45.
TEST_CASE("A cell that is flat but for rounding is repaired")
{
  using namespace tangled_test;
  for(const double height : { 1e-9, 1e-12, 1e-15 })
    for(const int n : { 3, 8 })
    {
      CAPTURE(height, n);
      Soup soup = source_soup(cube_mesh(n));
      tangle(soup, [&](auto& p) { if(p == std::array<double, 3>{1, 1, 1}) p = { height, 1. / 3, 2. / 3 }; });
      REQUIRE(number_of_bad_cells(soup) == 0);
      const VMP::Parameterization_result result = improve(soup, params::energy(VMP::MIPS_energy_3()));
      CAPTURE(result.message);
      CHECK(result.status == VMP::OK);
      CHECK(number_of_bad_cells(soup) == 0);
      CHECK(result.distortion.angle_max < 4.2);
    }
}

// Edges inside whose ends stay are no reason to split: the parts would be less regular.
TEST_CASE("Refinement leaves a mesh alone that needs none, and splits cells that stay distorted")
{
  using namespace tangled_test;
  Soup soup = source_soup(cube_mesh(4));
  tangle(soup, [](auto& p) { if(p[0] == 2 && p[1] == 2) p[0] += 1.5; });
  REQUIRE(number_of_bad_cells(soup) > 0);
  Soup refined = soup;
  improve(soup, params::energy(VMP::MIPS_energy_3()));
  const auto refine = [](Soup& mesh)
  {
    return improve(mesh, params::energy(VMP::MIPS_energy_3()).refinement_mode(VMP::Refinement_mode::BOUNDARY));
  };
  CHECK(refine(refined).number_of_added_vertices == 0);
  CHECK(refined.points == soup.points);

  Soup sliver = source_soup(cube_mesh(3));
  add_flat_cell(sliver);
  sliver.points[sliver.cells.back()[3]][2] = 0.05; // the fourth vertex of the cell is now inside of the cube
  REQUIRE(number_of_bad_cells(sliver) == 0);
  Soup split = sliver;
  const VMP::Parameterization_result without = improve(sliver, params::energy(VMP::MIPS_energy_3())), with = refine(split);
  CHECK(with.status == VMP::OK);
  CHECK(with.number_of_added_vertices > 0);
  CHECK(with.number_of_added_vertices < 4); // of one cell, not of all bridges
  CHECK(with.distortion.angle_max < without.distortion.angle_max / 2);
  CHECK(with.energy < without.energy);
}
