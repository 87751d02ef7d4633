// Coordinates of the faces of a polycube: their order, their lengths, and multiples of a spacing.
#include "bricks.h"

#include <CGAL/Polycube_meshing_3/internal/Polycube/Normal_labels_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

TEST_CASE("coordinates are the closest ones to means that keep their order and a gap")
{
  using namespace PM::internal;
  const std::vector<Order_of_coordinates> orders = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}};
  const auto coordinates = ordered_coordinates_3({1, 2, 1, 4}, {0, 6, 1, 40}, orders, {}, 0); // means 0, 3, 1, 10
  REQUIRE(coordinates);
  const std::vector<double> expected = {0, 2, 3, 10}; // (2 (x - 3)^2 + (x + 1 - 1)^2)' = 0 at x = 2
  REQUIRE(coordinates->values.size() == expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i)
    CHECK(coordinates->values[i] == Approx(expected[i]).margin(1e-12));
}

TEST_CASE("values in random orders are those of Hildreth's method, and areas of very different size do not matter")
{
  using namespace PM::internal;
  std::mt19937 random(3);
  const auto number = [&](const double least, const double largest)
  { return std::uniform_real_distribution<double>(least, largest)(random); };
  for(int i = 0; i < 200; ++i)
  {
    const std::size_t n = 2 + random() % 12;
    const double largest_exponent = i % 2 == 0 ? 0.5 : 8; // of weights; Hildreth's method does not end with the latter
    std::vector<double> weights, wanted;
    for(std::size_t k = 0; k < n; ++k)
    {
      weights.push_back(std::pow(10, number(0, largest_exponent)));
      wanted.push_back(number(0, 5));
    }
    std::vector<Order_of_coordinates> orders;
    for(std::size_t k = 0; k < 2 * n; ++k)
    {
      const std::size_t first = random() % n, second = random() % n;
      if(first < second)
        orders.push_back({first, second, number(0, 1)});
    }
    const auto [bases, offsets] = Closest_ordered_values(weights, wanted, orders).run();
    std::vector<double> x = wanted, multipliers(orders.size(), 0);
    for(int sweep = 0; sweep < 20000 && i % 2 == 0; ++sweep)
      for(std::size_t k = 0; k < orders.size(); ++k)
      {
        const auto& [first, second, distance] = orders[k];
        const double compliance = 1 / weights[first] + 1 / weights[second];
        const double step = (std::max)(-multipliers[k], (distance - x[second] + x[first]) / compliance);
        multipliers[k] += step;
        x[first] -= step / weights[first];
        x[second] += step / weights[second];
      }
    double moment = 0, size = 0;
    for(std::size_t k = 0; k < n; ++k)
    {
      if(i % 2 == 0)
        CHECK(bases[k] + offsets[k] == Approx(x[k]).margin(1e-9));
      moment += weights[k] * (bases[k] + offsets[k] - wanted[k]);
      size += weights[k];
    }
    CHECK(std::abs(moment) < 1e-10 * size); // as moving all values by the same distance costs nothing in the least sum
    for(const auto& [first, second, distance] : orders)
      CHECK(bases[second] + offsets[second] - bases[first] - offsets[first] > distance - 1e-11);
  }
}

TEST_CASE("coordinates are one plane apart, whatever the length of the spacing is")
{
  using namespace PM::internal;
  for(const double spacing : { 0.25, 1., 5. })
  {
    const auto coordinates
      = ordered_coordinates_3({1, 1}, {0, 0.1 * spacing}, {{0, 1, spacing}}, {VMP::internal::Vector_3::Zero(), spacing}, 0);
    REQUIRE(coordinates);
    CHECK(coordinates->values[1] - coordinates->values[0] == spacing);
  }
}

TEST_CASE("a polycube has the lengths of the body, not those of its shadow, also in multiples of a spacing")
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.6, Eigen::Vector3d(0.3, 0.2, 1).normalized()).toRotationMatrix();
  const VMP::Tetrahedron_soup_3 soup = bricks({12, 3, 2}, is_box, [&](const double x, const double y, const double z)
  {
    const Eigen::Vector3d p = turn * Eigen::Vector3d(x, y, z);
    return std::array<double, 3>{ p.x(), p.y(), p.z() };
  });
  for(const double spacing : { 0., 0.5 })
  {
    std::vector<std::array<double, 3> > image;
    REQUIRE(Polycube(spacing, PM::Polycube_axes::GIVEN).parameterize(soup.points, soup.cells, image) == VMP::OK);
    Eigen::AlignedBox3d box;
    for(const std::size_t v : VMP::boundary_vertices(soup.points, soup.cells))
      box.extend(Eigen::Vector3d(image[v].data()));
    CHECK((box.sizes() - Eigen::Vector3d(12, 3, 2)).norm() < 1e-3);
  }
}

TEST_CASE("integers are moved by the best shift")
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0, 10);
  for(int i = 0; i < 50; ++i)
  {
    const std::vector<double> x = { number(random), number(random), number(random), number(random) };
    const std::vector<double> weights = { number(random), number(random), number(random), number(random) };
    const auto sum = [&](const double shift)
    {
      double result = 0, weight = 0;
      for(std::size_t k = 0; k < x.size(); ++k)
      {
        weight += weights[k];
        result += weights[k] * std::pow(x[k] - shift - std::round(x[k] - shift), 2);
      }
      return result / weight;
    };
    double least = 1;
    for(int k = 0; k < 1000; ++k)
      least = (std::min)(least, sum(k / 1000.));
    const double shift = PM::internal::closest_shift_of_integers(weights, x);
    CHECK(std::abs(shift) <= 0.5);
    CHECK(sum(shift) < least + 0.01); // a larger extent is worth as much
  }
}

TEST_CASE("no other coordinates of the faces of a polycube have less distortion, and it has no less volume than the body")
{
  using namespace PM::internal;
  const Soup_surface straight(bricks(size, is_stair, in_place)), surface(bricks(size, is_stair, bend));
  Unit_surface_3 unit;
  Boundary_mesh_3& mesh = unit.mesh;
  REQUIRE(build_boundary_mesh_3(surface, mesh) == VMP::OK);
  set_points(mesh, unit_points(mesh));
  unit.box = bounding_box(points_of(mesh));
  std::vector<std::size_t> labels;
  for(const std::array<std::size_t, 3>& facet : straight.facets)
  {
    std::array<Point_3, 3> triangle;
    for(int i = 0; i < 3; ++i)
      triangle[i] = Point_3(straight.points[facet[i]][0], straight.points[facet[i]][1], straight.points[facet[i]][2]);
    labels.push_back(direction(triangle));
  }
  const Budget budget;
  Polycube_map_3 map(unit, labels);
  REQUIRE(map.start_close_to_surface(budget) == VMP::OK);
  const std::optional<Polycube_map_3> best = map.with_lengths_of_surface(budget);
  REQUIRE(best);

  std::vector<double> coordinates(best->charts().number_of_charts());
  double volume = 0;
  for(const auto f : mesh.faces())
  {
    const auto [a, b, c] = vertices_of_face(mesh, f);
    const std::size_t chart = best->charts().chart_of_face()[f];
    coordinates[chart] = best->images()[a][best->charts().axis(chart)];
    volume += best->images()[a].cross(best->images()[b]).dot(best->images()[c]) / 6;
  }
  CHECK(volume > (1 - 1e-9) * CGAL::Polygon_mesh_processing::volume(mesh));
  const Polycube_planes_3 planes(mesh, best->charts());
  for(std::size_t plane = 0; plane < planes.size(); ++plane)
    for(const double step : { -0.02, 0.02 })
    {
      std::vector<double> moved = coordinates;
      for(std::size_t chart = 0; chart < planes.size(); ++chart)
        moved[chart] += planes[chart] == plane ? step : 0;
      Polycube_map_3 other = *best;
      REQUIRE(other.start_at(moved, budget) == VMP::OK);
      CHECK(other.distortion() >= best->distortion());
    }
}

TEST_CASE("a hole of a face of a polycube is inside, even if it is beside the face on average")
{
  using namespace PM::internal;
  Soup_surface surface(bricks({8, 8, 1}, [](const int x, const int y, int) { return x / 2 != 2 || y / 2 != 2; }, in_place));
  Boundary_mesh_3 mesh;
  REQUIRE(build_boundary_mesh_3(surface, mesh) == VMP::OK);
  const Budget budget;
  const Polycube_charts_3 charts(mesh, Normal_labels_3(mesh, std::vector<bool>(mesh.number_of_edges(), false), budget).closest());
  const Plane_grid_3 any;
  const Polycube_planes_3 planes(mesh, charts);
  Polycube_coordinates_3 inside(mesh, charts, planes, any, budget);
  CHECK(inside.run(mean_coordinates_3(mesh, charts, planes)));
  for(PM::internal::Vector_3& p : surface.points)
    if((std::max)(std::abs(p[0] - 5), std::abs(p[1] - 5)) <= 1)
      p[0] += 20;
  set_points(mesh, surface.points);
  Polycube_coordinates_3 beside(mesh, charts, planes, any, budget);
  REQUIRE(beside.run(mean_coordinates_3(mesh, charts, planes)));
  const std::vector<double> coordinates = beside.of_charts();
  for(const auto f : mesh.faces())
  {
    const std::size_t chart = charts.chart_of_face()[f];
    const double x = mesh.point(mesh.source(mesh.halfedge(f))).x();
    if(charts.axis(chart) == 0 && x > 10) // at the hole
      for(const auto g : mesh.faces())
      {
        const std::size_t other = charts.chart_of_face()[g];
        const double y = mesh.point(mesh.source(mesh.halfedge(g))).x();
        if(charts.axis(other) == 0 && y == 0)
          CHECK(coordinates[other] < coordinates[chart]);
        else if(charts.axis(other) == 0 && y == 8)
          CHECK(coordinates[chart] < coordinates[other]);
      }
  }
}

TEST_CASE("polygons are those of a face if one is around all others, which are holes beside each other")
{
  using PM::internal::Boundary_polygon_2;
  const auto square = [](const double x, const double y, const double size)
  { return Boundary_polygon_2{ { x, y }, { x + size, y }, { x + size, y + size }, { x, y + size } }; };
  const auto hole = [&](const double x, const double y, const double size)
  {
    const Boundary_polygon_2 p = square(x, y, size);
    return Boundary_polygon_2(p.rbegin(), p.rend());
  };
  const Boundary_polygon_2 bracket = { { 0, 0 }, { 9, 0 }, { 9, 3 }, { 3, 3 }, { 3, 9 }, { 0, 9 } };
  using PM::internal::are_nested;
  CHECK(are_nested({ bracket }));
  CHECK(are_nested({ hole(1, 1, 1), bracket, hole(4, 1, 1) }));
  CHECK(!are_nested({ bracket, hole(5, 5, 1) }));                // not inside
  CHECK(!are_nested({ bracket, hole(0.5, 0.5, 2), hole(1, 1, 1) })); // inside of each other
  CHECK(!are_nested({ bracket, square(1, 1, 1) }));              // no hole
  CHECK(!are_nested({ bracket, square(5, 5, 1) }));              // two faces
  CHECK(!are_nested({ hole(1, 1, 1) }));                         // only a hole
}

TEST_CASE("a polycube that has a hole beside a face, in a notch of it, is refused")
{
  using namespace PM::internal;
  // a bracket with a hole at its corner
  const auto is_solid = [](const int x, const int y, int) { return (x < 3 || y < 3) && (x != 1 || y != 1); };
  Boundary_mesh_3 mesh;
  REQUIRE(build_boundary_mesh_3(Soup_surface(bricks({9, 9, 3}, is_solid, in_place)), mesh) == VMP::OK);
  const Budget budget;
  const Polycube_charts_3 charts(mesh, Normal_labels_3(mesh, std::vector<bool>(mesh.number_of_edges(), false), budget).closest());
  const Polycube_planes_3 planes(mesh, charts);
  std::vector<double> wanted = mean_coordinates_3(mesh, charts, planes);
  CHECK(Polycube_coordinates_3(mesh, charts, planes, Plane_grid_3(), budget).run(wanted));
  for(double& x : wanted)
    x += x > 0.5 && x < 2.5 ? 5 : 0; // of the walls of the hole, across the two walls of the notch
  CHECK(!Polycube_coordinates_3(mesh, charts, planes, Plane_grid_3(), budget).run(wanted));
}
