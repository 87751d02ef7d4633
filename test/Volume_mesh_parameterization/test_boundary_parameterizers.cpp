// Boundaries mapped to the ball, the cube and the box: one to one by exact predicates, and what cannot be mapped.
#include "Visitor_that_ends.h"
#include "catch.h"

#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Vertex_map.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/exceptions.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Vector_3 = K::Vector_3;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;
using Cell_handle = C3t3::Cell_handle;
using Soup = VMP::Tetrahedron_soup_3;
using Point_map = std::unordered_map<Vertex_handle, Point_3>;
using Ball = VMP::Ball_boundary_parameterizer_3;
using Cube = VMP::Cube_boundary_parameterizer_3;

namespace {

// nx * ny * nz bricks of six cells each, moved by f. With `is_closed` the last layer along z is the first one.
template <typename Function>
Soup bricks(const int nx, const int ny, const int nz, const Function& f, const bool is_closed = false)
{
  const int layers = is_closed ? nz : nz + 1;
  const auto index = [&](const std::array<int, 3>& p) -> std::size_t
  {
    return ((p[2] % layers) * (ny + 1) + p[1]) * (nx + 1) + p[0];
  };
  Soup soup;
  for(int z = 0; z < layers; ++z)
    for(int y = 0; y <= ny; ++y)
      for(int x = 0; x <= nx; ++x)
        soup.points.push_back(f(x, y, z));
  for(int brick = 0; brick < nx * ny * nz; ++brick)
    for(int a = 0; a < 3; ++a)
      for(const int turn : {1, 2})
      {
        std::array<int, 3> p = {brick % nx, brick / nx % ny, brick / nx / ny};
        std::array<std::size_t, 4> cell;
        for(int i = 0; i < 4; ++i)
        {
          cell[i] = index(p);
          ++p[(a + i * turn) % 3];
        }
        if(turn == 2)
          std::swap(cell[1], cell[2]);
        soup.cells.push_back(cell);
        soup.cell_references.push_back(1);
      }
  return soup;
}

std::array<double, 3> stay(const double x, const double y, const double z)
{
  return {x, y, z};
}

// A rod bent along most of a circle.
Soup bent_rod()
{
  return bricks(2, 2, 60, [](const int x, const int y, const int z) -> std::array<double, 3>
  {
    const double radius = 13 + x, angle = 0.1 * z;
    return {radius * std::cos(angle), radius * std::sin(angle), -double(y)};
  });
}

// Any cells with the points 0, 1, 2, ... in general position.
Soup cells_on_moment_curve(const std::vector<std::array<std::size_t, 4> >& cells)
{
  Soup soup;
  for(const std::array<std::size_t, 4>& cell : cells)
  {
    soup.cells.push_back(cell);
    soup.cell_references.push_back(1);
    for(const std::size_t v : cell)
      while(soup.points.size() <= v)
      {
        const double t = double(soup.points.size());
        soup.points.push_back({t, t * t, t * t * t});
      }
  }
  return soup;
}

struct Complex
{
  C3t3 c3t3;
  std::vector<Vertex_handle> vertices;
  std::vector<Cell_handle> cells;
  Point_map image;

  explicit Complex(const Soup& soup)
  {
    VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
  }

  Complex(const Complex&) = delete;

  template <typename Parameterizer>
  VMP::Error_code parameterize(const Parameterizer& parameterizer)
  {
    image.clear();
    return parameterizer.parameterize(c3t3, VMP::make_vertex_point_map(image));
  }

  // The images of the boundary facets, oriented such that the cell is behind.
  std::vector<std::array<Point_3, 3> > image_triangles() const
  {
    std::vector<std::array<Point_3, 3> > result;
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(!c3t3.is_in_complex(c->neighbor(i)))
        {
          std::array<Point_3, 3> triangle;
          for(int k = 0; k < 3; ++k)
            triangle[k] = image.at(c->vertex((i + 1 + k) % 4));
          if(i % 2 == 1)
            std::swap(triangle[0], triangle[1]);
          result.push_back(triangle);
        }
    return result;
  }
};

Vector_3 vector(const Point_3& p)
{
  return p - CGAL::ORIGIN;
}

// Returns how often the triangles cover the sphere around the origin, by the formula of van Oosterom and Strackee.
double covering(const std::vector<std::array<Point_3, 3> >& triangles)
{
  double angle = 0;
  for(const std::array<Point_3, 3>& t : triangles)
  {
    const Vector_3 a = vector(t[0]), b = vector(t[1]), c = vector(t[2]);
    const double la = std::sqrt(a * a), lb = std::sqrt(b * b), lc = std::sqrt(c * c);
    angle += 2 * std::atan2(CGAL::determinant(a, b, c), la * lb * lc + a * b * lc + b * c * la + c * a * lb);
  }
  return angle / (4 * CGAL_PI);
}

bool are_all_positive(const std::vector<std::array<Point_3, 3> >& triangles)
{
  return std::all_of(triangles.begin(), triangles.end(), [](const std::array<Point_3, 3>& t)
  {
    return CGAL::orientation(Point_3(0, 0, 0), t[0], t[1], t[2]) == CGAL::POSITIVE;
  });
}

void check_ball(const Complex& complex)
{
  for(const auto& entry : complex.image)
    CHECK(std::abs(std::sqrt(vector(entry.second).squared_length()) - 1) < 1e-15);
  const auto triangles = complex.image_triangles();
  CHECK(are_all_positive(triangles));
  CHECK(covering(triangles) == Approx(1));
}

// Triangles that the origin sees once, each in one face of the box, cover it exactly.
void check_box(const Complex& complex, const std::array<double, 3>& lengths = {1, 1, 1})
{
  const auto triangles = complex.image_triangles();
  CHECK(are_all_positive(triangles));
  CHECK(covering(triangles) == Approx(1));
  for(const std::array<Point_3, 3>& t : triangles)
  {
    bool is_in_face = false;
    for(int axis = 0; axis < 3; ++axis)
      is_in_face = is_in_face || (std::abs(t[0][axis]) == lengths[axis] / 2
                                  && t[1][axis] == t[0][axis] && t[2][axis] == t[0][axis]);
    CHECK(is_in_face);
  }
}

} // namespace

TEST_CASE("a tetrahedron becomes a regular one in the sphere")
{
  Complex complex(cells_on_moment_curve({{0, 1, 2, 3}}));
  REQUIRE(complex.parameterize(Ball()) == VMP::OK);
  CHECK(complex.image.size() == 4);
  check_ball(complex);

  Complex regular(Soup{{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}, {{0, 1, 2, 3}}, {1}, {}, {}});
  REQUIRE(regular.parameterize(Ball()) == VMP::OK);
  for(int v = 1; v < 4; ++v)
    CHECK(CGAL::squared_distance(regular.image.at(regular.vertices[0]), regular.image.at(regular.vertices[v]))
          == Approx(8. / 3));
  CHECK(regular.parameterize(Cube()) == VMP::ERROR_BOUNDARY_TOO_COARSE);
  CHECK(regular.image.empty());
}

TEST_CASE("only vertices of the boundary get an image")
{
  Complex complex(bricks(3, 3, 3, stay));
  for(int run = 0; run < 2; ++run)
  {
    REQUIRE((run == 0 ? complex.parameterize(Ball()) : complex.parameterize(Cube())) == VMP::OK);
    CHECK(complex.image.size() == 56);
  }
}

TEST_CASE("a ball is turned to its landmarks")
{
  Complex complex(bricks(3, 2, 4, stay));
  REQUIRE(complex.parameterize(Ball()) == VMP::OK);
  const Point_map free = complex.image;
  std::vector<std::pair<Vertex_handle, Point_3> > landmarks;
  const auto parameterize = [&]
  { return Ball().parameterize(complex.c3t3, landmarks, VMP::make_vertex_point_map(complex.image)); };
  const auto sum_of_squares = [&](const auto& image)
  {
    double sum = 0;
    for(const auto& [v, p] : landmarks)
      sum += CGAL::squared_distance(image(v), p);
    return sum;
  };
  const auto image = [&](const Vertex_handle v) { return complex.image.at(v); };

  // by 1 radian about the y-axis
  const CGAL::Aff_transformation_3<K> turn(std::cos(1), 0, std::sin(1), 0, 1, 0, -std::sin(1), 0, std::cos(1));
  for(const auto& [v, p] : free)
    if(landmarks.size() < 3)
      landmarks.emplace_back(v, turn(p));
  REQUIRE(parameterize() == VMP::OK);
  check_ball(complex);
  for(const auto& [v, p] : free)
    CHECK(CGAL::squared_distance(image(v), turn(p)) < 1e-24);

  // elsewhere, no further turn brings them closer
  landmarks[0].second = Point_3(1, 0, 0);
  landmarks[1].second = Point_3(0, 1, 0);
  landmarks[2].second = Point_3(0, 0.6, -0.8);
  REQUIRE(parameterize() == VMP::OK);
  check_ball(complex);
  const double least = sum_of_squares(image), c = std::cos(0.01), s = std::sin(0.01);
  for(const double sine : {s, -s})
    for(const auto& further : { CGAL::Aff_transformation_3<K>(1, 0, 0, 0, c, sine, 0, -sine, c),
                                CGAL::Aff_transformation_3<K>(c, 0, sine, 0, 1, 0, -sine, 0, c),
                                CGAL::Aff_transformation_3<K>(c, sine, 0, -sine, c, 0, 0, 0, 1) })
      CHECK(sum_of_squares([&](const Vertex_handle v) { return further(image(v)); }) > least);

  complex.image.clear();
  const Vertex_handle inside = *std::find_if(complex.vertices.begin(), complex.vertices.end(), [](const Vertex_handle v)
  { return v->point() == Point_3(1, 1, 1); });
  landmarks.emplace_back(inside, Point_3(1, 0, 0));
  CHECK(parameterize() == VMP::ERROR_INVALID_LANDMARK);
  landmarks.back() = { landmarks.front().first, Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0) };
  CHECK(parameterize() == VMP::ERROR_INVALID_LANDMARK);
  CHECK(complex.image.empty());
}

TEST_CASE("a cube is mapped to the ball with moderate distortion")
{
  Complex complex(bricks(6, 6, 6, stay));
  REQUIRE(complex.parameterize(Ball()) == VMP::OK);
  check_ball(complex);

  double smallest = 1, largest = 0; // areas relative to the mean
  const auto triangles = complex.image_triangles();
  for(const std::array<Point_3, 3>& t : triangles)
  {
    const double ratio = std::sqrt(CGAL::squared_area(t[0], t[1], t[2])) * double(triangles.size()) / (4 * CGAL_PI);
    smallest = (std::min)(smallest, ratio);
    largest = (std::max)(largest, ratio);
  }
  CHECK(smallest > 0.4); // the central projection has 0.46 and 1.76
  CHECK(largest < 1.3);
}

TEST_CASE("a cube and a box are mapped to themselves")
{
  const auto lengths = GENERATE(std::array<int, 3>{4, 4, 4}, std::array<int, 3>{3, 4, 6});
  const Point_3 center(lengths[0] / 2., lengths[1] / 2., lengths[2] / 2.);
  Complex complex(bricks(lengths[0], lengths[1], lengths[2], stay));
  REQUIRE(complex.parameterize(Cube(lengths[0], lengths[1], lengths[2])) == VMP::OK);
  check_box(complex, {double(lengths[0]), double(lengths[1]), double(lengths[2])});
  for(const auto& entry : complex.image)
    CHECK(std::sqrt((entry.first->point() - center - vector(entry.second)).squared_length()) < 0.1);
}

TEST_CASE("the corners can be chosen")
{
  Complex complex(bricks(4, 4, 4, stay));
  std::array<Vertex_handle, 8> corners;
  for(std::size_t k = 0; k < 8; ++k) // x, y, z of the source become y, z, x
  {
    const Point_3 corner((k >> 1 & 1) * 4., (k >> 2 & 1) * 4., (k & 1) * 4.);
    corners[k] = *std::find_if(complex.vertices.begin(), complex.vertices.end(), [&](const Vertex_handle v)
    {
      return v->point() == corner;
    });
  }
  REQUIRE(Cube().parameterize(complex.c3t3, corners, VMP::make_vertex_point_map(complex.image)) == VMP::OK);
  check_box(complex);
  for(const auto& entry : complex.image)
  {
    const Point_3 p = entry.first->point();
    const Point_3 expected(p.z() / 4 - 0.5, p.x() / 4 - 0.5, p.y() / 4 - 0.5);
    CHECK(CGAL::squared_distance(entry.second, expected) < 0.001);
  }
}

TEST_CASE("wrong corners have a diagnosis of their own")
{
  Complex complex(bricks(4, 4, 4, stay));
  std::array<Vertex_handle, 8> corners;
  for(std::size_t k = 0; k < 8; ++k) // mirrored
    corners[k ^ 1] = *std::find_if(complex.vertices.begin(), complex.vertices.end(), [&](const Vertex_handle v)
    {
      return v->point() == Point_3((k & 1) * 4., (k >> 1 & 1) * 4., (k >> 2 & 1) * 4.);
    });
  const auto status = [&]
  {
    const VMP::Error_code result
      = Cube().parameterize(complex.c3t3, corners, VMP::make_vertex_point_map(complex.image));
    CHECK(complex.image.empty());
    return result;
  };
  CHECK(status() == VMP::ERROR_MIRRORED_CORNERS);
  corners[3] = corners[4];
  CHECK(status() == VMP::ERROR_INVALID_CORNERS);
  corners[3] = *std::find_if(complex.vertices.begin(), complex.vertices.end(), [&](const Vertex_handle v)
  {
    return v->point() == Point_3(2, 2, 2);
  });
  CHECK(status() == VMP::ERROR_INVALID_CORNERS);
  CHECK_THROWS_AS(Cube(1, -1, 1), CGAL::Precondition_exception);
  CHECK_THROWS_AS(Cube(1, 1, std::numeric_limits<double>::infinity()), CGAL::Precondition_exception);
}

TEST_CASE("arbitrary corners end with a map or with a status")
{
  Complex complex(bricks(8, 8, 8, stay));
  REQUIRE(complex.parameterize(Ball()) == VMP::OK);
  std::vector<Vertex_handle> boundary;
  for(const Vertex_handle v : complex.vertices)
    if(complex.image.count(v) != 0)
      boundary.push_back(v);

  int number_of_maps = 0;
  CGAL::Random random(1);
  for(int run = 0; run < 10; ++run)
  {
    std::array<Vertex_handle, 8> corners;
    for(std::size_t k = 0; k < 8; ++k)
      corners[k] = boundary[k * (boundary.size() / 8) + random.get_int(0, static_cast<int>(boundary.size() / 8))];
    complex.image.clear();
    const VMP::Error_code status
      = Cube().parameterize(complex.c3t3, corners, VMP::make_vertex_point_map(complex.image));
    if(status == VMP::OK)
    {
      ++number_of_maps;
      check_box(complex);
      for(int k = 0; k < 8; ++k)
        CHECK(complex.image.at(corners[k]) == Point_3((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5));
    }
    else
    {
      CHECK((status == VMP::ERROR_BOUNDARY_TOO_COARSE || status == VMP::ERROR_MIRRORED_CORNERS));
      CHECK(complex.image.empty());
    }
  }
  CHECK(number_of_maps >= 5);
}

TEST_CASE("a bent rod is mapped to the ball, the cube and a long box")
{
  Complex complex(bent_rod());
  REQUIRE(complex.parameterize(Ball()) == VMP::OK);
  check_ball(complex);
  REQUIRE(complex.parameterize(Cube()) == VMP::OK);
  check_box(complex);
  REQUIRE(complex.parameterize(Cube(1, 1, 30)) == VMP::OK);
  check_box(complex, {1, 1, 30});
}

TEST_CASE("the size of the source does not matter")
{
  const double scale = GENERATE(1e-150, 1e150);
  Complex complex(bricks(2, 2, 2, [&](const int x, const int y, const int z) -> std::array<double, 3>
  {
    return {scale * x, scale * y, scale * z};
  }));
  REQUIRE(complex.parameterize(Ball()) == VMP::OK);
  check_ball(complex);
  REQUIRE(complex.parameterize(Cube()) == VMP::OK);
  check_box(complex);
}

TEST_CASE("boundaries that are no topological sphere are named")
{
  const auto status = [](const Soup& soup)
  {
    Complex complex(soup);
    const VMP::Error_code result = complex.parameterize(Ball());
    CHECK(complex.parameterize(Cube()) == result);
    CHECK(complex.image.empty());
    return result;
  };

  const Soup torus = bricks(2, 2, 12, [](const int x, const int y, const int z) -> std::array<double, 3>
  {
    return {(5 + x) * std::cos(CGAL_PI / 6 * z), (5 + x) * std::sin(CGAL_PI / 6 * z), -double(y)};
  }, true);
  CHECK(status(torus) == VMP::ERROR_BOUNDARY_NOT_OF_GENUS_ZERO);

  CHECK(status(cells_on_moment_curve({{0, 1, 2, 3}, {4, 5, 6, 7}})) == VMP::ERROR_SEVERAL_BOUNDARY_COMPONENTS);
  Soup hollow = bricks(3, 3, 3, stay);
  hollow.cells.erase(hollow.cells.begin() + 13 * 6, hollow.cells.begin() + 14 * 6);
  hollow.cell_references.resize(hollow.cells.size());
  CHECK(status(hollow) == VMP::ERROR_SEVERAL_BOUNDARY_COMPONENTS);

  CHECK(status(cells_on_moment_curve({{0, 1, 2, 3}, {3, 4, 5, 6}})) == VMP::ERROR_NON_MANIFOLD_BOUNDARY);
  CHECK(status(cells_on_moment_curve({{0, 1, 2, 3}, {2, 3, 4, 5}})) == VMP::ERROR_NON_MANIFOLD_BOUNDARY);
  const Complex edge(cells_on_moment_curve({{0, 1, 2, 3}, {2, 3, 4, 5}}));
  const std::vector<Vertex_handle> non_manifold = VMP::non_manifold_boundary_vertices(edge.c3t3);
  CHECK(std::unordered_set<Vertex_handle>(non_manifold.begin(), non_manifold.end())
        == std::unordered_set<Vertex_handle>{edge.vertices[2], edge.vertices[3]});

  Complex broken(bricks(2, 2, 2, stay));
  broken.vertices.front()->set_point(Point_3((std::numeric_limits<double>::infinity)(), 0, 0));
  CHECK(broken.parameterize(Ball()) == VMP::ERROR_NON_FINITE_COORDINATE);
  CHECK(broken.parameterize(Cube()) == VMP::ERROR_NON_FINITE_COORDINATE);

  const C3t3 empty;
  Point_map image;
  CHECK(Ball().parameterize(empty, VMP::make_vertex_point_map(image)) == VMP::ERROR_EMPTY_COMPLEX);
}

TEST_CASE("maps to the ball and to the cube can be ended anywhere, with nothing written")
{
  Complex complex(bent_rod());
  const auto target = VMP::make_vertex_point_map(complex.image);
  check_interruption([&](const auto& np) { return Ball().parameterize(complex.c3t3, target, np); }, complex.image);
  check_interruption([&](const auto& np) { return Cube(1, 1, 30).parameterize(complex.c3t3, target, np); }, complex.image);

  std::array<Vertex_handle, 8> corners;
  for(std::size_t k = 0; k < 8; ++k)
    corners[k] = complex.vertices[(k & 1) * 2 + (k >> 1 & 1) * 6 + (k >> 2 & 1) * 540];
  check_interruption([&](const auto& np) { return Cube().parameterize(complex.c3t3, corners, target, np); },
                     complex.image);
}

TEST_CASE("all loops that move the vertices of a map to the ball ask whether to go on")
{
  Complex complex(bent_rod());
  Visitor_that_ends visitor;
  REQUIRE(Ball().parameterize(complex.c3t3, VMP::make_vertex_point_map(complex.image),
                              CGAL::parameters::visitor(std::ref(visitor))) == VMP::OK);
  // to coarsen and to insert asks once for each vertex, and a sweep over all of them for each once more
  CHECK(visitor.number_of_questions > 3 * complex.image.size());
}
