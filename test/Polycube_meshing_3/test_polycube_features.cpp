// Sharp edges inside charts become lines in faces of a polycube, or are given up.
#include "bricks.h"

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

TEST_CASE("features in a face become lines but for one that joins two side by side, and one that leaves no room for a facet")
{
  const auto bent = [](const double x, const double y, const double z)
  { return std::array<double, 3>{ x + 0.4 * std::sin(y / 3), y, z }; };
  const auto on_top = [&](const double x, const double y)
  {
    return x == 4 && y == 3 ? bent(3.5, 3, 2) : x == 4 && y == 5 ? bent(4.5, 5, 2) // a line from (3, 2) to (5, 6)
         : x == 6 && y == 4 ? bent(6.35, 3.65, 2) : bent(x, y, 2);                 // near the middle of an edge
  };
  VMP::Tetrahedron_soup_3 soup = bricks({ 8, 8, 2 }, is_box, [&](const double x, const double y, const double z)
                                        { return z == 2 ? on_top(x, y) : bent(x, y, z); });
  const auto vertex = [&](const double x, const double y)
  { return static_cast<std::size_t>(std::find(soup.points.begin(), soup.points.end(), on_top(x, y)) - soup.points.begin()); };
  std::vector<std::vector<std::array<double, 2> > > lines(4);
  for(int y = 0; y <= 8; ++y)
    for(const int i : { 0, 1 })
      lines[i].push_back({ 3. + 2 * i, y * 1. });
  lines[2] = { { 3, 2 }, { 4, 3 }, { 4, 4 }, { 4, 5 }, { 5, 6 } };
  lines[3] = { { 6, 0 }, { 6, 1 }, { 6, 2 }, { 6, 3 }, { 6, 4 }, { 7, 4 } }; // its last three vertices are those of a facet
  for(const auto& line : lines)
    for(std::size_t k = 1; k < line.size(); ++k)
    {
      soup.edges.push_back({ vertex(line[k - 1][0], line[k - 1][1]), vertex(line[k][0], line[k][1]) });
      soup.edge_references.push_back(1);
    }
  std::vector<std::array<double, 3> > targets;
  REQUIRE(Polycube(1).parameterize(soup, targets) == VMP::OK);
  for(const int i : { 0, 1 })
    for(const auto& [x, y] : lines[i])
      CHECK(targets[vertex(x, y)][0] == targets[vertex(x, 0)][0]);
  CHECK(targets[vertex(3, 0)][0] < targets[vertex(5, 0)][0]);
  CHECK(targets[vertex(6, 3)][0] != targets[vertex(7, 4)][0]);
}

TEST_CASE("a feature in a face becomes a line unless it is shorter than the spacing")
{
  const auto waved = [](const double x, const double y, const double z)
  { return std::array<double, 3>{ x, y + 0.3 * std::sin(x), z }; };
  VMP::Tetrahedron_soup_3 soup = bricks({ 8, 8, 2 }, is_box, waved);
  std::vector<std::size_t> feature;
  for(int x = 2; x <= 5; ++x)
  {
    const auto vertex = std::find(soup.points.begin(), soup.points.end(), waved(x, 4, 2));
    feature.push_back(static_cast<std::size_t>(vertex - soup.points.begin()));
  }
  for(std::size_t k = 1; k < feature.size(); ++k)
    soup.edges.push_back({ feature[k - 1], feature[k] });
  soup.edge_references.assign(soup.edges.size(), 1);
  const auto is_line = [&](const double spacing)
  {
    std::vector<std::array<double, 3> > targets;
    REQUIRE(Polycube(spacing).parameterize(soup, targets) == VMP::OK);
    return std::all_of(feature.begin(), feature.end(),
                       [&](const std::size_t v) { return targets[v][1] == targets[feature[0]][1]; });
  };
  CHECK(is_line(1));
  CHECK_FALSE(is_line(4));
}

TEST_CASE("features that are given up are told as polylines, the longest one first")
{
  VMP::Tetrahedron_soup_3 soup = bricks({ 6, 6, 2 }, is_box, in_place);
  const auto vertex = [&](const double x, const double y)
  { return static_cast<std::size_t>(std::find(soup.points.begin(), soup.points.end(), in_place(x, y, 2)) - soup.points.begin()); };
  const auto mark = [&](const std::vector<std::array<double, 2> >& line)
  {
    for(std::size_t k = 1; k < line.size(); ++k)
    {
      soup.edges.push_back({ vertex(line[k - 1][0], line[k - 1][1]), vertex(line[k][0], line[k][1]) });
      soup.edge_references.push_back(1);
    }
  };
  mark({ { 0, 5 }, { 1, 5 }, { 2, 5 } });           // along an axis
  mark({ { 1, 3 }, { 2, 4 } });                     // diagonals, which are edges of bricks
  mark({ { 1, 0 }, { 2, 1 }, { 3, 2 }, { 4, 3 } });
  std::vector<std::array<double, 3> > targets;
  PM::Polycube_result result;
  REQUIRE(Polycube(1, PM::Polycube_axes::FOUND, &result).parameterize(soup, targets) == VMP::OK);
  CHECK(result.number_of_sharp_edges == 6);
  CHECK(result.number_of_edges_given_up() == 4);
  REQUIRE(result.features_given_up.size() == 2);
  PM::Polycube_result::Polyline longest = result.features_given_up[0];
  std::sort(longest.begin(), longest.end());
  CHECK(longest == PM::Polycube_result::Polyline{ { 1, 0, 2 }, { 2, 1, 2 }, { 3, 2, 2 }, { 4, 3, 2 } });
  CHECK(result.features_given_up[1].size() == 2);
}
