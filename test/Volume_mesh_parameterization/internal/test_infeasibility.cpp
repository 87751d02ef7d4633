// Proofs that no map exists, on small complexes for which it is known by construction whether there is one.
#include "catch.h"

#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/diagnose_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/prove_infeasibility_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace internal = CGAL::Volume_mesh_parameterization::internal;

using Mesh = internal::Numbered_mesh_3;
using Proof = internal::Infeasibility_proof_3;
using Point = Eigen::Vector3d;

namespace {

// Free vertices, whose images are 0 and whose places in the source are (v, 0, 0), and prescribed ones.
Mesh mesh(const int number_of_free_vertices, const std::vector<Point>& prescribed,
          const std::vector<std::array<int, 4> >& cells)
{
  Mesh result;
  result.number_of_free_vertices = number_of_free_vertices;
  result.target.setZero(3, number_of_free_vertices + static_cast<int>(prescribed.size()));
  for(std::size_t i = 0; i < prescribed.size(); ++i)
    result.target.col(number_of_free_vertices + static_cast<int>(i)) = prescribed[i];
  result.source = result.target;
  for(int v = 0; v < number_of_free_vertices; ++v)
    result.source(0, v) = v;
  result.cells = cells;
  return result;
}

// The cells around the edge of the free vertices 0 and 1, with prescribed vertices in a ring.
Mesh edge_ring(const std::vector<Point>& ring)
{
  const int n = static_cast<int>(ring.size());
  std::vector<std::array<int, 4> > cells;
  for(int i = 0; i < n; ++i)
    cells.push_back({0, 1, 2 + i, 2 + (i + 1) % n});
  return mesh(2, ring, cells);
}

const std::vector<Point> square = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
const std::vector<Point> bow_tie = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};

// An octahedron around the free vertex 0, with its equator in the plane z = 0.
Mesh octahedron(const double north, const double south)
{
  std::vector<Point> points = square;
  points.emplace_back(0, 0, north);
  points.emplace_back(0, 0, south);
  std::vector<std::array<int, 4> > cells;
  for(int i = 0; i < 4; ++i)
  {
    cells.push_back({0, 1 + i, 1 + (i + 1) % 4, 5});
    cells.push_back({0, 1 + (i + 1) % 4, 1 + i, 6});
  }
  return mesh(1, points, cells);
}

// The cells of the free vertex v with the facets of a tetrahedron at height z, whose vertices are added to the mesh.
void enclose(Mesh& m, const int v, const double z)
{
  const int n = m.number_of_vertices();
  Eigen::Matrix3Xd points(3, n + 4);
  points.leftCols(n) = m.target;
  points.rightCols(4) << 0, 1, 0, 0,
                         0, 0, 1, 0,
                         z, z, z, z + 1;
  m.source = m.target = points;
  for(int i = 0; i < 4; ++i)
  {
    std::array<int, 4> cell = {n, n + 1, n + 2, n + 3};
    cell[i] = v;
    m.cells.push_back(cell);
  }
}

// The proofs found without any knowledge of good positions, all of them checked.
std::vector<Proof> prove(const Mesh& m)
{
  const std::vector<Proof> proofs = internal::prove_infeasibility_3(m, internal::inverted_cells(m, m.target).cells);
  for(const Proof& proof : proofs)
    REQUIRE(internal::is_valid(proof, m));
  return proofs;
}

bool is_positive_everywhere(const Mesh& m, const Eigen::Matrix3Xd& positions)
{
  return internal::inverted_cells(m, positions).number == 0;
}

} // namespace

TEST_CASE("an edge has a place in a convex ring, from either side, but not in a bow tie")
{
  CHECK(prove(edge_ring(square)).empty());
  CHECK(prove(edge_ring({square.rbegin(), square.rend()})).empty());

  const std::vector<Proof> proofs = prove(edge_ring(bow_tie));
  REQUIRE(proofs.size() == 1);
  CHECK(proofs[0].cells.size() >= 3); // any two of its sides leave room for the edge
  CHECK(internal::blamed_vertices(proofs[0], edge_ring(bow_tie)) == std::set<int>{0, 1});
}

TEST_CASE("a ring that goes to and fro leaves no place, by its first two cells alone")
{
  const std::vector<Proof> proofs = prove(edge_ring({{1, 0, 0}, {0, 1, 0.1}, {1, 0, 0}, {0, 1, 0.1}}));
  REQUIRE(proofs.size() == 1);
  CHECK(proofs[0].cells.size() == 2);
}

TEST_CASE("neither scale nor place of the target matters")
{
  for(const double scale : {std::ldexp(1., -40), std::ldexp(1., 40)})
    for(const double shift : {0., 1024.})
    {
      Mesh flat = edge_ring(bow_tie);
      Mesh round = edge_ring(square);
      for(Mesh* m : {&flat, &round})
        m->target.rightCols(4) = scale * (m->target.rightCols(4).array() + shift).matrix();
      CHECK(prove(flat).size() == 1);
      CHECK(prove(round).empty());
    }
}

TEST_CASE("a free vertex has a place in an octahedron unless its poles change sides")
{
  CHECK(prove(octahedron(1, -1)).empty());
  CHECK(prove(octahedron(-1, -2)).empty());  // not convex, but star-shaped

  const Mesh m = octahedron(-2, -1); // the image must be below -2 and above -1
  const std::vector<Proof> proofs = prove(m);
  REQUIRE(proofs.size() == 1);
  CHECK(internal::blamed_vertices(proofs[0], m).count(0) == 1);

  CHECK(prove(octahedron(-1, -1)).size() == 1); // the image must be below and above the same height
}

TEST_CASE("a vertex without a place is not reported again with its edges")
{
  Mesh m = edge_ring(square);
  enclose(m, 0, -3);
  enclose(m, 0, 2);
  const std::vector<Proof> proofs = prove(m);
  REQUIRE(proofs.size() == 1);
  CHECK(internal::blamed_vertices(proofs[0], m) == std::set<int>{0});
}

TEST_CASE("two vertices with a place each, and an edge with a place, may contradict each other")
{
  Mesh upwards = edge_ring(square); // the edge must point upwards through the square
  enclose(upwards, 0, -3);
  enclose(upwards, 1, 2);
  CHECK(prove(upwards).empty());

  Mesh downwards = edge_ring(square);
  enclose(downwards, 0, 2);
  enclose(downwards, 1, -3);
  const std::vector<Proof> proofs = prove(downwards);
  REQUIRE(proofs.size() == 1);
  CHECK(internal::blamed_vertices(proofs[0], downwards) == std::set<int>{0, 1});
}

TEST_CASE("a cell that cannot be positive is a proof of its own")
{
  const std::vector<std::array<int, 4> > cell = {{0, 1, 2, 3}};
  const Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CHECK(prove(mesh(0, {o, x, y, z}, cell)).empty());
  CHECK(prove(mesh(0, {o, y, x, z}, cell)).size() == 1);         // inverted
  CHECK(prove(mesh(0, {o, x, y, x + y}, cell)).size() == 1);     // flat
  CHECK(prove(mesh(1, {o, x, y}, cell)).empty());
  CHECK(prove(mesh(1, {o, 0.1 * x, 0.3 * x}, cell)).size() == 1); // a facet without area
  CHECK(prove(mesh(2, {o, x}, cell)).empty());
  CHECK(prove(mesh(2, {x, x}, cell)).size() == 1);               // an edge without length
  CHECK(prove(mesh(3, {o}, cell)).empty());
}

TEST_CASE("there is no proof against a map that exists")
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&]() { return Point(coordinate(random), coordinate(random), coordinate(random)); };
  for(int run = 0; run < 200; ++run)
  {
    // Cells at two vertices with hidden images, each turned such that it is positive there; many are nearly flat.
    std::vector<Point> points;
    std::vector<std::array<int, 4> > cells;
    for(int i = 0; i < 12; ++i)
    {
      const double height = std::ldexp(1., -2 * (run % 20));
      points.push_back(point().cwiseProduct(Point(1, 1, height)));
      cells.push_back({0, 1, 2 + i, 2 + (i + 1) % 12});
      cells.push_back({i % 2, 2 + i, 2 + (i + 1) % 12, 2 + (i + 5) % 12});
    }
    Mesh m = mesh(2, points, cells);
    Eigen::Matrix3Xd hidden = m.target;
    hidden.col(0) = point();
    hidden.col(1) = point();
    for(std::array<int, 4>& cell : m.cells)
      if(!internal::is_positive(hidden, cell))
        std::swap(cell[2], cell[3]);
    REQUIRE(is_positive_everywhere(m, hidden));
    CHECK(prove(m).empty());
  }
}

TEST_CASE("a random cloud of cells at an edge has no map, and the proof is small")
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for(int run = 0; run < 20; ++run)
  {
    std::vector<Point> ring;
    for(int i = 0; i < 60; ++i) // by Wendel's theorem a map has a chance below 1e-10
      ring.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    const std::vector<Proof> proofs = prove(edge_ring(ring));
    REQUIRE(proofs.size() == 1);
    CHECK(proofs[0].cells.size() <= 7); // Steinitz: in dimension 6, one more vector
  }
}

TEST_CASE("only sets with a cell that is not positive are examined")
{
  const Mesh m = edge_ring(bow_tie);
  CHECK(internal::prove_infeasibility_3(m, internal::inverted_cells(m, m.target).cells).size() == 1);

  const Mesh good = edge_ring(square);
  Eigen::Matrix3Xd positions = good.target;
  positions(2, 1) = 1;
  REQUIRE(is_positive_everywhere(good, positions));
  CHECK(internal::prove_infeasibility_3(good, internal::inverted_cells(good, positions).cells).empty());
}

TEST_CASE("a search that is ended returns the proofs found by then")
{
  std::vector<std::array<int, 4> > cells; // two edges in the same bow tie
  for(int i = 0; i < 4; ++i)
  {
    cells.push_back({0, 1, 4 + i, 4 + (i + 1) % 4});
    cells.push_back({2, 3, 4 + i, 4 + (i + 1) % 4});
  }
  const Mesh m = mesh(4, bow_tie, cells);
  std::size_t number_of_proofs = 0;
  for(int last_question = 0; number_of_proofs < 2; ++last_question)
  {
    REQUIRE(last_question < 1000);
    int number_of_questions = 0;
    const internal::Budget budget(1e9, [&] { return ++number_of_questions < last_question; });
    const std::vector<Proof> proofs = internal::prove_infeasibility_3(m, internal::inverted_cells(m, m.target).cells, budget);
    CHECK(number_of_questions <= (std::max)(1, last_question));
    CHECK((proofs.size() == number_of_proofs || proofs.size() == number_of_proofs + 1));
    for(const Proof& proof : proofs)
      CHECK(internal::is_valid(proof, m));
    number_of_proofs = proofs.size();
  }

  internal::Budget exhausted;
  exhausted.exhaust();
  const std::vector<std::size_t> inverted = internal::inverted_cells(m, m.target).cells;
  CHECK(inverted.size() == 8);
  CHECK(internal::diagnose_3(m, inverted, exhausted).number_of_proofs == 0);
  CHECK(internal::diagnose_3(m, inverted, exhausted).inverted_cells == inverted);
}

TEST_CASE("a sentence about cells that stay inverted names as many as one looks at")
{
  const Mesh m = edge_ring(bow_tie);
  CHECK(internal::describe_inverted_cells({ 0, 1, 2 }, m)
        == "With the boundary at its targets, these cells stay inverted: 0, 1, 2.");
  CHECK(internal::describe_inverted_cells({ 0, 1, 2, 3, 4, 5, 6 }, m)
        == "With the boundary at its targets, these cells stay inverted: 0, 1, 2, 3, 4, and 2 others.");
}

TEST_CASE("a proof of many cells asks the budget for each of them, and between the pivots of the simplex method")
{
  std::vector<Point> ring;
  for(int i = 0; i < 200; ++i)
    ring.emplace_back(i % 7, i % 11, i % 13);
  const Mesh m = edge_ring(ring);
  std::size_t number_of_questions = 0;
  const internal::Budget budget(1e9, [&] { return ++number_of_questions > 0; });
  REQUIRE(internal::prove_infeasibility_3(m, internal::inverted_cells(m, m.target).cells, budget).size() == 1);
  CHECK(number_of_questions > 2.5 * static_cast<double>(m.cells.size())); // a third of them is asked before
}

TEST_CASE("a proof that was tampered with is refused")
{
  const Mesh m = edge_ring(bow_tie);
  const Proof proof = prove(m).at(0);

  Proof changed = proof;
  changed.factors[0] += CGAL::Exact_rational(std::ldexp(1., -200));
  CHECK_FALSE(internal::is_valid(changed, m));

  changed = proof;
  for(auto& factor : changed.factors)
    factor *= 3;
  CHECK(internal::is_valid(changed, m)); // a multiple is as good
  for(auto& factor : changed.factors)
    factor = -factor;
  CHECK_FALSE(internal::is_valid(changed, m));
  for(auto& factor : changed.factors)
    factor = 0;
  CHECK_FALSE(internal::is_valid(changed, m));

  changed = proof;
  changed.cells.pop_back();
  CHECK_FALSE(internal::is_valid(changed, m));
  changed.factors.pop_back();
  CHECK_FALSE(internal::is_valid(changed, m));

  changed = proof;
  changed.cells[0] = m.cells.size();
  CHECK_FALSE(internal::is_valid(changed, m));
  CHECK_FALSE(internal::is_valid(Proof(), m));

  Mesh moved = m;
  for(int i = 0; i < 4; ++i)
    moved.target.col(2 + i) = square[i];
  CHECK_FALSE(internal::is_valid(proof, moved));
}

TEST_CASE("a sum of volumes that is a positive constant proves nothing")
{
  const Mesh m = octahedron(1, -1);
  Proof all;
  for(std::size_t c = 0; c < m.cells.size(); ++c)
  {
    all.cells.push_back(c);
    all.factors.push_back(1);
  }
  CHECK_FALSE(internal::is_valid(all, m));
  CHECK(internal::is_valid(all, octahedron(-1, 1)));  // turned inside out
  CHECK(internal::is_valid(all, octahedron(-1, -1))); // without volume
}

TEST_CASE("the user learns how many sets of cells are to blame and where the first is")
{
  const Mesh m = edge_ring(bow_tie);
  const std::string sentence = internal::describe_infeasibility(prove(m), m);
  CHECK(sentence.find("found: 1. Number of cells of the first set: ") != std::string::npos);
  CHECK(sentence.find("(0, 0, 0), (1, 0, 0)") != std::string::npos);
}

TEST_CASE("two facets intersect if they share more than their common vertices")
{
  const auto intersects = [](const std::vector<Point>& points, const std::vector<std::array<int, 3> >& facets)
  {
    Eigen::Matrix3Xd matrix(3, points.size());
    for(std::size_t v = 0; v < points.size(); ++v)
      matrix.col(v) = points[v];
    const auto found = internal::Self_intersection_3(matrix, facets).find();
    CHECK((found.empty() || found.front().first < found.front().second));
    return !found.empty();
  };
  const std::vector<Point> points = { {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {9, 9, 9}, {3, 3, 0},
                                      {1, 1, 0}, {8, 8, 0} };
  CHECK(intersects(points, {{0, 1, 2}, {3, 4, 5}}));         // no common vertex
  CHECK(!intersects(points, {{0, 1, 2}, {5, 6, 8}}));
  CHECK(intersects(points, {{0, 1, 2}, {0, 3, 4}}));         // one: the edge opposite of it goes through
  CHECK(!intersects(points, {{0, 1, 2}, {0, 4, 5}}));
  CHECK(!intersects(points, {{0, 1, 2}, {1, 6, 8}}));        // coplanar side by side
  CHECK(intersects(points, {{0, 1, 2}, {2, 1, 7}}));         // two: folded back into the plane
  CHECK(!intersects(points, {{0, 1, 2}, {2, 1, 6}}));        // continued in the plane
  CHECK(!intersects(points, {{0, 1, 2}, {2, 1, 4}}));
  CHECK(intersects(points, {{0, 1, 2}, {0, 2, 1}}));         // three
  CHECK(!intersects(points, {{0, 1, 2}, {3, 7, 4}}));        // a triangle without area is no facet
}

TEST_CASE("a search for intersections that is ended claims none")
{
  Eigen::Matrix3Xd points(3, 6);
  points << 0, 4, 0, 1, 1, 9,
            0, 0, 4, 1, 1, 9,
            0, 0, 0, -1, 1, 9;
  const std::vector<std::array<int, 3> > facets = { {0, 1, 2}, {3, 4, 5} };
  internal::Budget budget;
  CHECK(!internal::Self_intersection_3(points, facets).find(budget).empty());
  budget.exhaust();
  CHECK(internal::Self_intersection_3(points, facets).find(budget).empty());
}

TEST_CASE("icosahedra with moved vertices intersect themselves where Polygon_mesh_processing says so")
{
  using Surface_mesh = CGAL::Surface_mesh<internal::Exact_point_3>;
  std::mt19937 random(7);
  int number_of_intersections = 0;
  for(int run = 0; run < 200; ++run)
  {
    Surface_mesh surface;
    CGAL::make_icosahedron(surface, internal::Exact_point_3(0, 0, 0), 1.);
    std::uniform_real_distribution<double> step(-0.01 * run, 0.01 * run);
    Eigen::Matrix3Xd points(3, 12);
    for(const auto v : surface.vertices())
    {
      for(int i = 0; i < 3; ++i)
        points(i, int(v)) = surface.point(v)[i] + step(random);
      surface.point(v) = internal::Exact_point_3(points(0, int(v)), points(1, int(v)), points(2, int(v)));
    }
    std::vector<std::array<int, 3> > facets;
    for(const auto f : surface.faces())
    {
      const auto h = surface.halfedge(f);
      facets.push_back({ int(surface.source(h)), int(surface.target(h)), int(surface.target(surface.next(h))) });
    }
    using Pair = std::pair<Surface_mesh::Face_index, Surface_mesh::Face_index>;
    std::vector<Pair> expected;
    CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(expected));
    for(Pair& pair : expected)
      if(pair.second < pair.first)
        std::swap(pair.first, pair.second);

    const auto found = internal::Self_intersection_3(points, facets).find();
    REQUIRE(found.empty() == expected.empty());
    if(found.empty())
      continue;
    ++number_of_intersections;
    const Pair first = *std::min_element(expected.begin(), expected.end());
    CHECK(found.front().first == std::size_t(first.first));
    CHECK(found.front().second == std::size_t(first.second));
  }
  CHECK(number_of_intersections > 20);
  CHECK(number_of_intersections < 180);
}
