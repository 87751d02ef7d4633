// Bridges are edges, facets and cells inside whose vertices are all prescribed: which of them refinement splits at once.
#include "catch.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Soup = VMP::Tetrahedron_soup_3;

namespace {

// Appends unit cubes, `numbers` of them in each direction from a corner, of six cells each, which share a diagonal.
void append_cubes(Soup& soup, const Point& corner, const std::array<std::size_t, 3>& numbers)
{
  const std::size_t first = soup.points.size();
  const auto index = [&](const std::array<std::size_t, 3>& p)
  { return first + (p[0] * (numbers[1] + 1) + p[1]) * (numbers[2] + 1) + p[2]; };
  for(std::size_t x = 0; x <= numbers[0]; ++x)
    for(std::size_t y = 0; y <= numbers[1]; ++y)
      for(std::size_t z = 0; z <= numbers[2]; ++z)
        soup.points.push_back({ corner[0] + static_cast<double>(x), corner[1] + static_cast<double>(y),
                                corner[2] + static_cast<double>(z) });
  for(std::size_t cube = 0; cube < numbers[0] * numbers[1] * numbers[2]; ++cube)
  {
    std::array<std::size_t, 3> axes = { 0, 1, 2 };
    do
    {
      std::array<std::size_t, 3> p
        = { cube / (numbers[1] * numbers[2]), cube / numbers[2] % numbers[1], cube % numbers[2] };
      std::array<std::size_t, 4> cell = { index(p) };
      for(std::size_t i = 0; i < 3; ++i)
      {
        ++p[axes[i]];
        cell[i + 1] = index(p);
      }
      if((axes[0] < axes[1]) != ((axes[1] < axes[2]) == (axes[0] < axes[2]))) // an odd permutation
        std::swap(cell[2], cell[3]);
      soup.cells.push_back(cell);
    }
    while(std::next_permutation(axes.begin(), axes.end()));
  }
  soup.cell_references.assign(soup.cells.size(), 1);
}

// Two by two cubes: of their 9 edges inside, 4 are diagonals of cubes, 4 of squares, and one is upright.
Soup plate(const Point& corner = { 0, 0, 0 })
{
  Soup soup;
  append_cubes(soup, corner, { 2, 2, 1 });
  return soup;
}
constexpr std::size_t number_of_bridges_of_plate = 9;

// Moves what is at the height z by `factor` times z.
Points sheared(Points points, const double factor)
{
  for(Point& p : points)
    p[0] += factor * p[2];
  return points;
}

struct Outcome
{
  VMP::Parameterization_result result;
  Soup soup;
  Points images;
};

template <typename NamedParameters>
Outcome refine_and_map(Soup soup, const Points& targets, const NamedParameters& np)
{
  Outcome outcome;
  outcome.result = CGAL::stretch_minimizing_volume_parameterization(soup, targets, outcome.images, np);
  outcome.soup = std::move(soup);
  return outcome;
}

Outcome map_as_needed(const Soup& soup, const Points& targets)
{ return refine_and_map(soup, targets, params::refinement_mode(VMP::Refinement_mode::NEEDED)); }

Outcome map_as_helpful(const Soup& soup, const Points& targets)
{ return refine_and_map(soup, targets, params::refinement_mode(VMP::Refinement_mode::HELPFUL)); }

} // namespace

TEST_CASE("Bridges that do no harm stay")
{
  const Points targets = sheared(plate().points, 1); // which is a distortion of angles of 3
  const Outcome helpful = map_as_helpful(plate(), targets);
  REQUIRE(helpful.result.status == VMP::OK);
  CHECK(helpful.result.number_of_added_vertices == 0);
  CHECK(helpful.images == targets);
}

TEST_CASE("Bridges of cells that the targets distort are split, unless only what is needed is allowed")
{
  const Points targets = sheared(plate().points, 5); // which is a distortion of angles of 27
  const Outcome needed = map_as_needed(plate(), targets), helpful = map_as_helpful(plate(), targets);
  REQUIRE(needed.result.status == VMP::OK);
  CHECK(needed.result.number_of_added_vertices == 0);
  REQUIRE(helpful.result.status == VMP::OK);
  CHECK(helpful.result.number_of_added_vertices == number_of_bridges_of_plate);
  CHECK(std::equal(targets.begin(), targets.end(), helpful.images.begin()));

  Soup refined = plate();
  REQUIRE(VMP::make_parameterizable(refined) == number_of_bridges_of_plate);
  CHECK(helpful.soup.points == refined.points);
  CHECK(helpful.soup.cells == refined.cells);
  // this is the default
  CHECK(refine_and_map(plate(), targets, params::refinement_mode(VMP::Refinement_mode::HELPFUL)).images == helpful.images);
}

TEST_CASE("Bridges at a cell that is inverted where the search starts are split, but not where such cells are elsewhere")
{
  Soup block;
  append_cubes(block, { 0, 0, 0 }, { 4, 4, 2 }); // with bridges along its upright sides
  Soup refined = block;
  const std::size_t number_of_bridges = VMP::make_parameterizable(refined);
  REQUIRE(number_of_bridges > 0);
  // pushes a vertex of the top below those in the middle of the block
  const auto dented = [&](const Point& top)
  {
    Points targets = block.points;
    const auto vertex = std::find(targets.begin(), targets.end(), top);
    REQUIRE(vertex != targets.end());
    (*vertex)[2] = 0.4;
    return targets;
  };

  const Outcome at_bridge = map_as_helpful(block, dented({ 1, 1, 2 }));
  REQUIRE(at_bridge.result.status == VMP::OK);
  CHECK(at_bridge.soup.points == refined.points);
  CHECK(at_bridge.result.number_of_added_vertices == number_of_bridges);
  CHECK(map_as_needed(block, dented({ 1, 1, 2 })).result.number_of_added_vertices == 0);

  const Outcome aside = map_as_helpful(block, dented({ 2, 2, 2 }));
  REQUIRE(aside.result.status == VMP::OK);
  CHECK(aside.result.number_of_inverted_cells_at_start > 0);
  CHECK(aside.result.number_of_added_vertices == 0);
  CHECK(aside.images == map_as_needed(block, dented({ 2, 2, 2 })).images);
}
