// Volume_map_3: a map evaluated at any points, both ways.
#include "catch.h"
#include "array_of_vtu_file.h"
#include "cube_complex.h"

#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::Matrix3d;
using Eigen::Vector3d;
using VMP::Tetrahedron_soup_3;
using VMP::Volume_map_3;
using Point_3 = Volume_map_3::Point_3;
using Points = std::vector<std::array<double, 3> >;

namespace {

Vector3d vector(const Point_3& p) { return Vector3d(p.x(), p.y(), p.z()); }
Point_3 point(const Vector3d& p) { return Point_3(p[0], p[1], p[2]); }
Vector3d vector(const std::array<double, 3>& p) { return Vector3d(p[0], p[1], p[2]); }

Vector3d bent(const Vector3d& p)
{
  const double angle = p[0] / 3, radius = 2 + p[1] / 3;
  return Vector3d(radius * std::sin(angle), radius * std::cos(angle), 2 * p[2]);
}

// A cube of n^3 unit cubes with six cells each, with its vertices mapped.
struct Mapped_cube
{
  Tetrahedron_soup_3 soup;
  Points images;

  template <typename Function>
  Mapped_cube(const int n, const double jitter, const Function& f) : soup(source_soup(cube_mesh(n, jitter)))
  {
    for(const std::array<double, 3>& p : soup.points)
    {
      const Vector3d q = f(vector(p));
      images.push_back({q[0], q[1], q[2]});
    }
  }

  Volume_map_3 map() const { return Volume_map_3(soup.points, soup.cells, images); }

  // Returns by definition, without a tree, the smallest index of the cells whose closed tetrahedron has the point.
  std::optional<std::size_t> first_cell(const Point_3& p) const
  {
    for(std::size_t c = 0; c < soup.cells.size(); ++c)
    {
      std::array<Point_3, 4> corners;
      for(std::size_t i = 0; i < 4; ++i)
        corners[i] = point(vector(soup.points[soup.cells[c][i]]));
      const std::array<Point_3, 4>& t = corners;
      if(CGAL::orientation(p, t[1], t[2], t[3]) != CGAL::NEGATIVE
         && CGAL::orientation(t[0], p, t[2], t[3]) != CGAL::NEGATIVE
         && CGAL::orientation(t[0], t[1], p, t[3]) != CGAL::NEGATIVE
         && CGAL::orientation(t[0], t[1], t[2], p) != CGAL::NEGATIVE)
        return c;
    }
    return std::nullopt;
  }
};

std::vector<Point_3> random_points(const std::size_t n, const double minimum, const double maximum)
{
  std::mt19937 engine;
  std::uniform_real_distribution<double> coordinate(minimum, maximum);
  std::vector<Point_3> result;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double x = coordinate(engine), y = coordinate(engine), z = coordinate(engine);
    result.emplace_back(x, y, z);
  }
  return result;
}

} // namespace

TEST_CASE("Points of a cube go there and back")
{
  const Mapped_cube cube(3, 0.2, bent);
  const Volume_map_3 map = cube.map();
  for(const Point_3& p : random_points(2000, 0, 3))
  {
    const auto there = map.image(p);
    REQUIRE(there);
    CHECK(there->cell == cube.first_cell(p));
    Vector3d combination = Vector3d::Zero();
    for(std::size_t i = 0; i < 4; ++i)
      combination += there->barycentric_coordinates[i] * vector(cube.soup.points[cube.soup.cells[there->cell][i]]);
    CHECK((combination - vector(p)).norm() < 1e-13);
    const auto back = map.nearest_preimage(there->point);
    REQUIRE(back);
    CHECK((vector(back->point) - vector(p)).norm() < 1e-12);
  }
}

TEST_CASE("Vertices, and points of edges and facets, belong to the first of their cells")
{
  const Mapped_cube cube(2, 0, bent); // without jitter, halves and quarters are exact
  const Volume_map_3 map = cube.map();
  for(int x = 0; x <= 8; ++x)
    for(int y = 0; y <= 8; ++y)
      for(int z = 0; z <= 8; ++z)
      {
        const Point_3 p(x / 4., y / 4., z / 4.);
        const auto there = map.image(p);
        REQUIRE(there);
        CHECK(there->cell == cube.first_cell(p));
        CHECK((vector(map.nearest_preimage(there->point)->point) - vector(p)).norm() < 1e-14);
      }
  for(std::size_t v = 0; v < cube.images.size(); ++v) // vertices are found exactly
  {
    const auto there = map.image(point(vector(cube.soup.points[v])));
    const auto back = map.preimage(point(vector(cube.images[v])));
    REQUIRE(there);
    REQUIRE(back);
    CHECK(vector(there->point) == vector(cube.images[v]));
    CHECK(vector(back->point) == vector(cube.soup.points[v]));
  }
}

TEST_CASE("Points outside are not found, but their nearest points are")
{
  const Mapped_cube cube(2, 0, [](const Vector3d& p) -> Vector3d { return 2 * p; });
  const Volume_map_3 map = cube.map();
  const double next = std::nextafter(2., 3.), tiny = -std::numeric_limits<double>::denorm_min();
  for(const Point_3& p : {Point_3(next, 1, 1), Point_3(1, tiny, 1), Point_3(0.3, 0.7, next), Point_3(3, -1, 5)})
  {
    CHECK(!map.image(p));
    CHECK(!map.differential(p));
    CHECK(!map.preimage(point(2 * vector(p))));
    const Vector3d clamped = vector(p).cwiseMax(0).cwiseMin(2);
    const auto nearest = map.nearest_image(p);
    REQUIRE(nearest);
    CHECK((vector(nearest->point) - 2 * clamped).norm() < 1e-14);
    CHECK((vector(map.nearest_preimage(point(2 * vector(p)))->point) - clamped).norm() < 1e-14);
  }
  for(const Point_3& p : random_points(100, -1, 3))
    CHECK((vector(map.nearest_image(p)->point) - 2 * vector(p).cwiseMax(0).cwiseMin(2)).norm() < 1e-13);
}

TEST_CASE("Degenerate queries and meshes")
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Mapped_cube cube(1, 0, bent);
  for(const double x : {nan, infinity, -infinity})
  {
    CHECK(!cube.map().image(Point_3(0.5, x, 0.5)));
    CHECK(!cube.map().nearest_preimage(Point_3(x, 0, 0)));
  }
  CHECK(!cube.map().nearest_image(Point_3(1e200, 0, 0))); // its squared distance is no number
  const Volume_map_3 empty({}, {}, {});
  CHECK(!empty.image(Point_3(0, 0, 0)));
  CHECK(!empty.nearest_image(Point_3(0, 0, 0)));
  CHECK_THROWS_AS(Volume_map_3(cube.soup.points, {{0, 1, 2, 8}}, cube.images), std::out_of_range);

  // a container of another size, a cell of another map
  Points images = cube.images;
  images.push_back({0, 0, 0});
  for(const Points& others : { images, Points(), Points(cube.images.begin(), cube.images.end() - 1) })
  {
    CHECK_THROWS_AS(Volume_map_3(cube.soup.points, cube.soup.cells, others), CGAL::Precondition_exception);
    const std::vector<double> values(others.size());
    CHECK_THROWS_AS(cube.map().interpolate(Volume_map_3::Location(), values), CGAL::Precondition_exception);
  }
  const Volume_map_3::Location elsewhere{ Point_3(0, 0, 0), cube.soup.cells.size(), { 1, 0, 0, 0 } };
  CHECK_THROWS_AS(cube.map().interpolate(elsewhere, std::vector<double>(cube.images.size())), CGAL::Precondition_exception);
  CHECK_THROWS_AS(cube.map().inverse_differential(cube.soup.cells.size()), CGAL::Precondition_exception);

  // a flat cell, one at infinity, and a good one of negative orientation
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {0, 0, nan}};
  const Volume_map_3 map(points, {{0, 1, 2, 3}, {0, 1, 2, 5}, {0, 2, 1, 4}}, points);
  const auto there = map.image(Point_3(0.25, 0.25, 0));
  REQUIRE(there);
  CHECK(there->cell == 2);
  CHECK(!map.image(Point_3(0.75, 0.75, 0)));
}

TEST_CASE("Barycentric coordinates in a nearly flat cell")
{
  const double height = 1e-20;
  const Points points = {{0.1, 0.1, 0}, {1, 0.2, 0}, {0.3, 1, 0}, {0.4, 0.4, height}};
  const Volume_map_3 map(points, {{0, 1, 2, 3}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const auto there = map.image(Point_3(0.4, 0.4, height / 2));
  REQUIRE(there);
  CHECK(there->point.z() == Approx(0.5).epsilon(1e-12));
  // half of the last corner, half of the point below it, whose coordinates solve a linear system in the plane
  Eigen::Matrix2d edges;
  edges << 0.9, 0.2, 0.1, 0.9;
  const Eigen::Vector2d below = edges.inverse() * Eigen::Vector2d(0.3, 0.3);
  CHECK(there->point.x() == Approx(below[0] / 2).epsilon(1e-12));
  CHECK(there->point.y() == Approx(below[1] / 2).epsilon(1e-12));
}

TEST_CASE("The differential is the limit of differences")
{
  const Volume_map_3 map = Mapped_cube(2, 0.2, bent).map();
  int number = 0;
  for(const Point_3& p : random_points(100, 0.01, 1.99))
  {
    const double h = 1e-5;
    const auto at = map.image(p);
    const auto differential = map.differential(p);
    REQUIRE(differential);
    for(int k = 0; k < 3; ++k)
    {
      const auto moved = map.image(point(vector(p) + h * Vector3d::Unit(k)));
      if(moved->cell != at->cell)
        continue;
      CHECK(((vector(moved->point) - vector(at->point)) / h - differential->col(k)).norm() < 1e-9);
      ++number;
    }
  }
  CHECK(number > 250);
}

TEST_CASE("Ranges, in parallel, are what single points are; a complex is what its soup is")
{
  const Mapped_cube cube(2, 0.1, bent);
  const Volume_map_3 map = cube.map();
  Cube_complex<> complex(cube_mesh(2, 0.1));
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    complex.uvw.emplace(complex.vertices[v], point(vector(cube.images[v])));
  const Volume_map_3 of_complex(complex.c3t3, complex.uvw_map());

  const std::vector<Point_3> points = random_points(1000, -0.5, 2.5);
  const auto images = map.images<CGAL::Parallel_if_available_tag>(points);
  const auto preimages = map.preimages<CGAL::Parallel_if_available_tag>(points);
  const auto differentials = map.differentials(points);
  const auto images_of_complex = of_complex.images(points);
  std::size_t number_outside = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const auto image = map.image(points[i]), preimage = map.preimage(points[i]);
    CHECK(images[i].has_value() == image.has_value());
    CHECK(preimages[i].has_value() == preimage.has_value());
    CHECK(differentials[i].has_value() == image.has_value());
    CHECK(images_of_complex[i].has_value() == image.has_value());
    number_outside += !image;
    if(image)
    {
      CHECK(images[i]->point == image->point);
      CHECK((vector(images_of_complex[i]->point) - vector(image->point)).norm() < 1e-13);
    }
    if(preimage)
      CHECK(preimages[i]->point == preimage->point);
  }
  CHECK(number_outside > 100);
  CHECK(number_outside < 900);
}

TEST_CASE("Data of vertices are interpolated, numbers and vectors, on both sides")
{
  const Mapped_cube cube(3, 0.1, bent);
  const Volume_map_3 map = cube.map();
  std::vector<double> heights;
  std::vector<Vector3d> sources;
  Eigen::MatrixXd images(cube.images.size(), 3);
  for(std::size_t v = 0; v < cube.images.size(); ++v)
  {
    heights.push_back(2 * cube.soup.points[v][2] - cube.soup.points[v][0]); // linear, hence exact
    sources.push_back(vector(cube.soup.points[v]));
    images.row(v) = vector(cube.images[v]);
  }
  const Point_3 p(1.3, 2.2, 0.4);
  const auto location = map.image(p);
  CHECK(map.interpolate(*location, heights) == Approx(2 * 0.4 - 1.3));
  const Eigen::VectorXd column = Eigen::Map<const Eigen::VectorXd>(heights.data(), static_cast<Eigen::Index>(heights.size()));
  const auto height = map.interpolate(*location, column);
  CHECK(std::is_same<decltype(height), const double>::value);
  CHECK(height == map.interpolate(*location, heights));
  const Vector3d source = map.interpolate(*location, sources);
  CHECK((source - vector(p)).norm() < 1e-14);
  const Eigen::RowVectorXd image = map.interpolate(*location, images);
  CHECK((image.transpose() - vector(location->point)).norm() < 1e-14);
  const Vector3d back = map.interpolate(*map.preimage(location->point), sources);
  CHECK((back - vector(p)).norm() < 1e-13);
}

TEST_CASE("Ranges of arrays of coordinates are queries, also for the nearest points")
{
  const Mapped_cube cube(2, 0.1, bent);
  const Volume_map_3 map = cube.map();
  const Points queries = { { 1, 1.5, 0.5 }, { 5, 1, 1 }, { -1, -1, -1 } };
  const auto images = map.images(queries), nearest = map.nearest_images(queries), inverse = map.nearest_preimages(queries);
  for(std::size_t i = 0; i < queries.size(); ++i)
  {
    const Point_3 p = point(vector(queries[i]));
    CHECK(images[i].has_value() == (i == 0));
    CHECK(nearest[i]->point == map.nearest_image(p)->point);
    CHECK(inverse[i]->point == map.nearest_preimage(p)->point);
  }
}
