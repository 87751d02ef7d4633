// Hexahedra that move: without inverted corners, on the surface of the body and near all of it.
#include "hexahedra_of_bodies.h"

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_with_domain_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Box_grid_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Subdomain_separation_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Hexahedra_improvement_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

using PM::internal::Corners_to_improve;
using Coordinates_3 = VMP::internal::Vector_3;

namespace {

// A grid of boxes, pulled back, or hexahedra of it that have been moved, with what improves them.
struct Sliding_hexahedra
{
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag> solver;
  VMP::internal::Linear_solver_of<decltype(solver)> linear_solver;
  VMP::internal::Budget budget;
  PM::internal::Body_surface_3 surface;
  PM::internal::Body_interfaces_3 interfaces;
  PM::internal::Placed_hexahedra_3 placed;
  Hexahedra_3 start;
  PM::internal::Sliding_hexahedra_3 hexahedra;

  explicit Sliding_hexahedra(const Body& body, const double spacing = 1) : Sliding_hexahedra(body, boxes(body, spacing)) {}

  Sliding_hexahedra(const Body& body, const Hexahedra_3& start)
    : linear_solver(solver), surface(PM::internal::Mapped_soup_3(body.soup, body.images)), interfaces(body.soup, surface),
      placed(PM::internal::placed_hexahedra_3(start, {}, interfaces)), start(placed.mesh),
      hexahedra(placed, linear_solver, false, budget)
  {}

  static Hexahedra_3 boxes(const Body& body, const double spacing)
  {
    const PM::internal::Mapped_soup_3 soup(body.soup, body.images);
    const PM::internal::Body_with_domain_3 mapped(soup, false);
    const PM::internal::Box_grid_3 grid(soup.cells, mapped.images, {}, spacing);
    const VMP::internal::Budget budget;
    return PM::internal::pulled_back(mapped, grid.boxes([&](const std::vector<Coordinates_3>& centers)
                                              { return PM::internal::preimages_3(mapped, centers, budget); }), budget);
  }

  std::ptrdiff_t number(const PM::internal::Freedom_3 freedom) const
  {
    return std::count_if(placed.positions.begin(), placed.positions.end(),
                         [&](const PM::internal::Position_3& position) { return position.freedom == freedom; });
  }
};

// Moves the vertices on the boundary by up to one unit along each axis.
void tangle_boundary(Hexahedra_3& mesh, const unsigned seed)
{
  const std::vector<bool> is_outer = PM::internal::is_on_boundary(mesh);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> noise(-1, 1);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    for(int axis = 0; axis < 3 && is_outer[v]; ++axis)
      mesh.points[v][axis] += noise(engine);
}

// Turns the top of the cube [0, 4]^3 by 180 degrees. The corners of a single hexahedron have the scaled Jacobian 0.58 then.
void twist_cube(Hexahedra_3& mesh)
{
  for(Coordinates_3& p : mesh.points)
    if(p[2] == 4)
      p = { 4 - p[0], 4 - p[1], 4 };
}

} // namespace

TEST_CASE("Tangled hexahedra are untangled, and their boundary stays")
{
  const Body box(5, 0, same);
  Hexahedra_3 mesh = Sliding_hexahedra::boxes(box, 1);
  const std::vector<bool> is_outer = PM::internal::is_on_boundary(mesh);
  std::mt19937 engine;
  std::uniform_real_distribution<double> noise(-1, 1);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    for(int axis = 0; axis < 3; ++axis)
      mesh.points[v][axis] += is_outer[v] ? 0 : noise(engine);
  const std::vector<Coordinates_3> before = mesh.points;
  REQUIRE(smallest_determinant(mesh) < 0);
  REQUIRE(PM::internal::evaluated_hexahedra(mesh, false).status == VMP::ERROR_INVERTED_HEXAHEDRON);

  Sliding_hexahedra sliding(box, mesh);
  for(int i = 0; i < 4; ++i)
    sliding.hexahedra.improve(30, false, Corners_to_improve::ALL);
  mesh = sliding.hexahedra.mesh();
  const Hexahedral_mesh_result result = PM::internal::evaluated_hexahedra(mesh, false);
  CHECK(result.status == VMP::OK);
  CHECK(result.minimum_scaled_jacobian > 0.9); // the cubes are the minimum
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    if(is_outer[v])
      CHECK(mesh.points[v] == before[v]);
}

TEST_CASE("The edges of a box whose vertices crowd at one side become the edges of a cube")
{
  const Body body(4, 0, [](const Vector3d& p) -> Vector3d { return { p[0], p[1] * p[1] / 4, p[2] }; });
  Points targets(body.soup.points.size());
  REQUIRE(VMP::Cube_boundary_parameterizer_3().parameterize(body.soup.points, body.soup.cells, targets) == VMP::OK);
  for(std::size_t v = 0; v < targets.size(); ++v)
  {
    const Vector3d p = vector(body.soup.points[v]);
    if((p.array() * (4 - p.array()) == 0).count() >= 2)
      CHECK((vector(targets[v]).array().abs() == 0.5).count() >= 2);
  }
}

TEST_CASE("Vertices slide where the map has turned the faces of a box")
{
  const Body box = turned_box();
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = box.mesh(1, mesh);
  REQUIRE(result.status == VMP::OK);
  CHECK_FALSE(result.has_padding);
  CHECK(result.minimum_scaled_jacobian > 0.5);
  check_boundary(mesh, box);
  CHECK(enclosed_volume(mesh) == Approx(216)); // the edges of the box are edges of hexahedra
}

TEST_CASE("Vertices move one after the other on a curved boundary until corners suffice")
{
  const Body ball(8, 0, rounded);
  Sliding_hexahedra sliding(ball);
  // two faces of the cube are on the sphere
  REQUIRE(PM::internal::evaluated_hexahedra(sliding.start, false).minimum_scaled_jacobian < 0.11);
  sliding.hexahedra.smooth(0.3, 0.03);
  CHECK(PM::internal::evaluated_hexahedra(sliding.hexahedra.mesh(), false).minimum_scaled_jacobian > 0.2);
  const std::vector<K::Triangle_3> facets = ball.boundary_facets();
  for(std::size_t v = 0; v < sliding.start.points.size(); ++v)
    if(sliding.placed.positions[v].freedom != PM::internal::Freedom_3::SPACE)
      CHECK(distance(VMP::internal::coordinates(sliding.hexahedra.mesh().points[v]), facets) < 1e-13);
}

TEST_CASE("Tangled vertices on a sphere are untangled at once, although steps along tangents leave it")
{
  const Body ball(8, 0, rounded);
  Hexahedra_3 mesh = Sliding_hexahedra::boxes(ball, 1);
  const std::vector<bool> is_outer = PM::internal::is_on_boundary(mesh);
  tangle_boundary(mesh, std::mt19937::default_seed);
  Sliding_hexahedra sliding(ball, mesh);
  REQUIRE(PM::internal::evaluated_hexahedra(sliding.start, false).number_of_inverted_corners > 100);
  sliding.hexahedra.improve(1, true, Corners_to_improve::ALL);
  CHECK(PM::internal::evaluated_hexahedra(sliding.hexahedra.mesh(), false).number_of_inverted_corners == 0);
  const std::vector<K::Triangle_3> facets = ball.boundary_facets();
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    if(is_outer[v])
      CHECK(distance(VMP::internal::coordinates(sliding.hexahedra.mesh().points[v]), facets) < 1e-13);
}

TEST_CASE("Vertices are held by sharp edges of the body, and leave edges of the domain where the body is smooth")
{
  using PM::internal::Freedom_3;
  const Sliding_hexahedra box(Body(4, 0, same)), ball(Body(8, 0, rounded));
  CHECK(box.number(Freedom_3::SPACE) == 27);
  CHECK(box.number(Freedom_3::SURFACE) == 6 * 9);
  CHECK(box.number(Freedom_3::LINE) == 12 * 3);
  CHECK(box.number(Freedom_3::NONE) == 8);
  CHECK(ball.number(Freedom_3::SPACE) == 343);
  CHECK(ball.number(Freedom_3::SURFACE) == 386);
  const Sliding_hexahedra cylinder(Body(4, 0, rounded_around_z)); // whose circles have corners of the cube
  CHECK(cylinder.number(Freedom_3::LINE) == 2 * 16);
  CHECK(cylinder.number(Freedom_3::NONE) == 0);

  CHECK(box.surface.nearest(Vector3d(0.5, 0.7, -1), Freedom_3::SURFACE) == Vector3d(0.5, 0.7, 0));
  CHECK(box.surface.nearest(Vector3d(0.5, 0.1, -1), Freedom_3::LINE) == Vector3d(0.5, 0, 0));
  CHECK(box.surface.nearest(Vector3d(0.5, 0.1, 1), Freedom_3::SPACE) == Vector3d(0.5, 0.1, 1));
  const auto projected = [&](const double y, const Freedom_3 freedom) -> Vector3d
  {
    return box.surface.projector(Coordinates_3(0.5, y, 0), freedom) * Coordinates_3(1, 2, 3);
  };
  CHECK(projected(0.7, Freedom_3::SURFACE).isApprox(Vector3d(1, 2, 0)));
  CHECK(projected(0, Freedom_3::LINE).isApprox(Vector3d(1, 0, 0)));
  CHECK(projected(0.7, Freedom_3::NONE) == Vector3d(0, 0, 0));
}

TEST_CASE("Vertices on sharp edges of a bent bar stay on them while others move")
{
  const Body bar = l_shaped_bar();
  Hexahedron_soup_3 mesh;
  REQUIRE(bar.mesh(0.5, mesh).status == VMP::OK);
  const auto distance_to_segment = [](const Vector3d& p, const Vector3d& a, const Vector3d& b)
  {
    const double t = (p - a).dot(b - a) / (b - a).squaredNorm();
    return (a + (std::min)(1., (std::max)(0., t)) * (b - a) - p).norm();
  };
  int number = 0;
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    for(const auto& [y, z] : { std::array<double, 2>{0, 0}, {4, 0}, {0, 4}, {2, 2}, {2, 4}, {4, 2} })
      if(mesh.images[v][1] == y && mesh.images[v][2] == z)
      {
        double distance = std::numeric_limits<double>::infinity();
        for(int x = 0; x < 4; ++x)
          distance = (std::min)(distance, distance_to_segment(vector(mesh.points[v]), bent(Vector3d(x, y, z)),
                                                              bent(Vector3d(x + 1, y, z))));
        CHECK(distance < 1e-13);
        ++number;
      }
  CHECK(number == 6 * 9);
}

TEST_CASE("Vertices leave sharp edges where corners would stay inverted on them")
{
  // beside a corner of a cube, the vertex of an edge is where that of the corner should be, and has no way around it
  const Body cube(6, 0, same);
  Hexahedra_3 mesh = Sliding_hexahedra::boxes(cube, 1);
  const auto vertex_at = [&](const Coordinates_3& p)
  {
    return std::min_element(mesh.points.begin(), mesh.points.end(), [&](const Coordinates_3& q, const Coordinates_3& r)
    { return (q - p).norm() < (r - p).norm(); });
  };
  std::iter_swap(vertex_at({ 0, 0, 0 }), vertex_at({ 1, 0, 0 }));
  Sliding_hexahedra sliding(cube, mesh);
  PM::internal::Best_hexahedra_3 best;
  PM::internal::Hexahedra_improvement_3(sliding.hexahedra, false, sliding.budget, best).run();
  CHECK(smallest_determinant(best.mesh) > 0);
  for(const std::array<std::size_t, 4>& quadrangle : best.mesh.facets)
    for(const std::size_t v : quadrangle)
      CHECK((best.mesh.points[v] - Coordinates_3(3, 3, 3)).cwiseAbs().maxCoeff() == Approx(3));
}

TEST_CASE("Vertices leave an interface where corners would stay inverted on it")
{
  Sliding_hexahedra cube(Body(4, 0, same));
  PM::internal::Placed_hexahedra_3 placed = cube.placed; // whose middle is to stay on a side
  for(std::size_t v = 0; v < placed.positions.size(); ++v)
    if((placed.mesh.points[v] - Coordinates_3(2, 2, 2)).norm() < 1e-9)
    {
      placed.mesh.points[v] = Coordinates_3(4, 2, 2);
      placed.positions[v] = { placed.mesh.points[v], &cube.surface, PM::internal::Freedom_3::SURFACE, false };
    }
  PM::internal::Sliding_hexahedra_3 hexahedra(placed, cube.linear_solver, false, cube.budget);
  PM::internal::Best_hexahedra_3 best;
  PM::internal::Hexahedra_improvement_3(hexahedra, false, cube.budget, best).run();
  CHECK(smallest_determinant(best.mesh) > 0);
}

TEST_CASE("The worst corners are not improved if many corners are inverted, which the map is to blame for")
{
  using PM::internal::Freedom_3;
  const bool are_many = GENERATE(false, true);
  const Sliding_hexahedra cube(Body(4, 0, same));
  PM::internal::Placed_hexahedra_3 placed = cube.placed; // whose boundary stays mirrored, or with a vertex beyond another one
  for(std::size_t v = 0; v < placed.positions.size(); ++v)
  {
    if(placed.positions[v].freedom != Freedom_3::SPACE)
      placed.positions[v].freedom = Freedom_3::NONE;
    Coordinates_3& p = placed.mesh.points[v];
    if(are_many)
      p[0] = 4 - p[0];
    else if((p - Coordinates_3(2, 2, 4)).norm() < 1e-9)
      p[0] = 3.2;
  }
  std::map<std::string, std::size_t> rounds;
  const VMP::internal::Budget budget(1e9, [] { return true; },
                                     [&](const VMP::Parameterization_step& step) { return ++rounds[step.attempt] > 0; });
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag> solver;
  VMP::internal::Linear_solver_of<decltype(solver)> linear_solver(solver);
  PM::internal::Sliding_hexahedra_3 hexahedra(placed, linear_solver, false, budget);
  PM::internal::Best_hexahedra_3 best;
  PM::internal::Hexahedra_improvement_3(hexahedra, false, budget, best, std::nullopt).run();
  CHECK(best.result.number_of_inverted_corners > 0);
  CHECK((rounds["worst corners"] == 0) == are_many);
  CHECK(rounds["corners"] < 5); // the first ones untangle some corners
}

TEST_CASE("Vertices of a hexahedron that is inverted inside alone leave their lines")
{
  Sliding_hexahedra cube(Body(4, 0, same), 4);
  REQUIRE(cube.number(PM::internal::Freedom_3::NONE) == 8);
  CHECK(!cube.hexahedra.leave_lines_and_interfaces(0));
  PM::internal::Placed_hexahedra_3 placed = cube.placed;
  twist_cube(placed.mesh);
  REQUIRE(PM::internal::evaluated_hexahedra(placed.mesh, false).number_of_inverted_corners == 0);
  PM::internal::Sliding_hexahedra_3 twisted(placed, cube.linear_solver, false, cube.budget);
  CHECK(twisted.leave_lines_and_interfaces(0));
}

TEST_CASE("A hexahedron that is inverted inside alone is untwisted, although its corners suffice")
{
  Sliding_hexahedra cube(Body(4, 0, same), 4);
  PM::internal::Placed_hexahedra_3 placed = cube.placed;
  twist_cube(placed.mesh);
  PM::internal::Sliding_hexahedra_3 twisted(placed, cube.linear_solver, false, cube.budget);
  PM::internal::Best_hexahedra_3 best;
  PM::internal::Hexahedra_improvement_3(twisted, false, cube.budget, best).run();
  CHECK(best.result.has_valid_mesh);
}

// In a grid of eight distorted boxes, the vertex inside moves.
TEST_CASE("Moves of single vertices invert no hexahedron for better corners of others")
{
  const Sliding_hexahedra box(Body(2, 0, same));
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag> solver;
  VMP::internal::Linear_solver_of<decltype(solver)> linear_solver(solver);
  int number_of_grids = 0;
  for(unsigned seed = 0; seed < 700; ++seed)
  {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> noise(-0.4, 0.4);
    PM::internal::Placed_hexahedra_3 placed = box.placed;
    for(std::size_t v = 0; v < placed.positions.size(); ++v)
    {
      if(placed.positions[v].freedom != PM::internal::Freedom_3::SPACE)
        placed.positions[v].freedom = PM::internal::Freedom_3::NONE;
      for(int axis = 0; axis < 3; ++axis)
        placed.mesh.points[v][axis] += noise(engine);
    }
    if(!PM::internal::evaluated_hexahedra(placed.mesh, false).has_valid_mesh)
      continue;
    ++number_of_grids;
    PM::internal::Sliding_hexahedra_3 grid(placed, linear_solver, false, box.budget);
    grid.smooth(1, 0);
    CAPTURE(seed);
    CHECK(PM::internal::evaluated_hexahedra(grid.mesh(), false).has_valid_mesh);
  }
  CHECK(number_of_grids > 100);
}

// Leaves one of 10,648 corners to moves of single vertices at first.
TEST_CASE("All vertices move for the last inverted corner if it is the only one from the beginning")
{
  const Body ball(11, 0, rounded);
  const Hexahedra_3 start = Sliding_hexahedra::boxes(ball, 1);
  int number_of_valid_balls = 0;
  for(const unsigned seed : { 7u, 9u })
  {
    Hexahedra_3 mesh = start;
    tangle_boundary(mesh, seed);
    Sliding_hexahedra sliding(ball, mesh);
    for(int i = 0; i < 3; ++i)
      sliding.hexahedra.improve(1, true, Corners_to_improve::ALL);
    number_of_valid_balls += PM::internal::evaluated_hexahedra(sliding.hexahedra.mesh(), false).number_of_inverted_corners == 0;
  }
  CHECK(number_of_valid_balls > 0);
}

TEST_CASE("Vertices that leave the surface come back to it, to its edges and its corners, without inverted corners")
{
  using PM::internal::Freedom_3;
  for(const Body& body : { Body(6, 0, same), Body(8, 0, rounded) })
  {
    Hexahedra_3 mesh = Sliding_hexahedra(body, 2).start;
    const Sliding_hexahedra straight(body, mesh);
    std::mt19937 engine;
    std::uniform_real_distribution<double> noise(-1.2, 1.2);
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      Vector3d p = mesh.points[v];
      if(straight.placed.positions[v].freedom != Freedom_3::NONE)
        p += Vector3d(noise(engine), noise(engine), noise(engine));
      mesh.points[v] = straight.surface.nearest(p, straight.placed.positions[v].freedom);
    }
    REQUIRE(PM::internal::evaluated_hexahedra(mesh, false).number_of_inverted_corners > 0);

    VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag> solver;
    VMP::internal::Linear_solver_of<decltype(solver)> linear_solver(solver);
    const VMP::internal::Budget budget;
    PM::internal::Placed_hexahedra_3 placed = straight.placed;
    placed.mesh = mesh;
    PM::internal::Sliding_hexahedra_3 tangled(placed, linear_solver, false, budget);
    tangled.leave_and_return();
    CHECK(PM::internal::evaluated_hexahedra(tangled.mesh(), false).number_of_inverted_corners == 0);
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      const Vector3d p = tangled.mesh().points[v];
      CHECK((straight.surface.nearest(p, straight.placed.positions[v].freedom) - p).norm() < 1e-12);
      if(straight.placed.positions[v].freedom == Freedom_3::NONE)
        CHECK(tangled.mesh().points[v] == mesh.points[v]);
    }
  }
}

TEST_CASE("Quadrangles slide towards a tip of the body that none of their vertices is at")
{
  const Body egg(8, 0, [](const Vector3d& p) -> Vector3d { return rounded(p).cwiseProduct(Vector3d(1, 1, 3)); });
  const std::array<double, 3> tip = { 0, 0, 12 };
  REQUIRE(distance(tip, egg.boundary_facets()) == 0);
  Sliding_hexahedra sliding(egg, 8 / 3.); // the tip is mapped to the middle of a quadrangle
  const double before = distance(tip, boundary_facets(sliding.start));
  REQUIRE(before > 1);
  for(int round = 0; round < 5; ++round)
    sliding.hexahedra.improve(3, true, Corners_to_improve::ALL);
  CHECK(distance(tip, boundary_facets(sliding.hexahedra.mesh())) < 0.95 * before); // for their corners alone they would leave it
}

TEST_CASE("Vertices slide to where corners are best, however far that is from where they were at first")
{
  const Body block(8, 0, [](const Vector3d& p) -> Vector3d // top and bottom are shifted against each other in their middles
  { return p + Vector3d(0.00125 * p[0] * (8 - p[0]) * p[1] * (8 - p[1]) * (p[2] - 4), 0, 0); });
  Sliding_hexahedra sliding(block, 2);
  for(int round = 0; round < 20; ++round)
    sliding.hexahedra.improve(3, true, Corners_to_improve::ALL);
  const std::vector<double> quality = PM::internal::scaled_jacobians(sliding.hexahedra.mesh());
  CHECK(*std::min_element(quality.begin(), quality.end()) > 0.999); // if they were drawn to there, 0.987
}

TEST_CASE("Worst angles are improved whatever lengths edges have, and thin layers stay thin")
{
  const Body block(8, 0, same);
  Hexahedra_3 mesh = Sliding_hexahedra(block, 2).start;
  std::size_t number_moved = 0;
  for(Coordinates_3& p : mesh.points)
  {
    const bool is_in_middle = p == Vector3d(4, 4, 4);
    p[0] = p[0] == 2 ? 0.4 : p[0]; // a rectilinear grid with a thin layer
    if(is_in_middle)
    {
      p = Vector3d(3.4, 4.9, 4.7);
      ++number_moved;
    }
  }
  REQUIRE(number_moved == 1);
  const auto least = [](const Sliding_hexahedra& sliding)
  {
    const std::vector<double> quality = PM::internal::scaled_jacobians(sliding.hexahedra.mesh());
    return *std::min_element(quality.begin(), quality.end());
  };
  const auto thickest = [&](const Sliding_hexahedra& sliding)
  {
    double result = 0;
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
      if(mesh.points[v][0] == 0.4)
        result = (std::max)(result, sliding.hexahedra.mesh().points[v][0]);
    return result;
  };
  Sliding_hexahedra for_angles(block, mesh), for_poor(block, mesh);
  REQUIRE(least(for_angles) < 0.9);
  for(int round = 0; round < 5; ++round)
  {
    for_angles.hexahedra.improve(10, true, Corners_to_improve::WORST_ANGLES);
    for_poor.hexahedra.improve(10, true, Corners_to_improve::POOR);
  }
  CHECK(least(for_angles) > 0.99);
  CHECK(thickest(for_angles) < 0.45);
  CHECK(thickest(for_poor) > 0.6); // equal lengths count there, too
}

TEST_CASE("Quadrangles that span a waist of the body, and their edges, come nearer to its surface")
{
  const Body body(8, 0, [](const Vector3d& p) -> Vector3d // the waist is in the middle of quadrangles
  {
    const double width = 1 - 0.5 * (std::max)(0., 1 - std::abs(p[0] - 4) / 3);
    return Vector3d(p[0], (p[1] - 4) * width, (p[2] - 4) * width);
  });
  const std::vector<K::Triangle_3> facets = body.boundary_facets();
  const auto farthest = [&](const Hexahedra_3& mesh)
  {
    double result = 0;
    for(const K::Triangle_3& facet : boundary_facets(mesh))
      for(const int i : { 0, 1, 2 })
      {
        const K::Point_3 middle = CGAL::midpoint(facet[i], facet[i + 1]);
        result = (std::max)(result, distance({ middle.x(), middle.y(), middle.z() }, facets));
      }
    return result;
  };
  Sliding_hexahedra sliding(body, 8 / 3.);
  const double before = farthest(sliding.start);
  REQUIRE(before > 0.9);
  for(int round = 0; round < 5; ++round)
    sliding.hexahedra.improve(3, true, Corners_to_improve::ALL);
  CHECK(farthest(sliding.hexahedra.mesh()) < 0.45 * before); // without this pull, 0.55
  CHECK(smallest_determinant(sliding.hexahedra.mesh()) > 0);
}

TEST_CASE("The distance of boundaries is that of tips, of vertices and of middles of quadrangles, and counts in units of edges")
{
  for(const Vector3d& factors : { Vector3d(1, 1, 3), Vector3d(1, 1, 0.5) })
  {
    const Body egg(8, 0, [&](const Vector3d& p) -> Vector3d { return rounded(p).cwiseProduct(factors); });
    Sliding_hexahedra sliding(egg, 8 / 3.);
    const std::vector<K::Triangle_3> facets = egg.boundary_facets(), halves = boundary_facets(sliding.start);
    double farthest = 0;
    for(const K::Triangle_3& facet : facets)
      for(const int i : { 0, 1, 2 })
        farthest = (std::max)(farthest, distance({ facet[i].x(), facet[i].y(), facet[i].z() }, halves));
    for(const K::Triangle_3& facet : halves)
      for(const int i : { 0, 1, 2 })
      {
        const K::Point_3 middle = CGAL::midpoint(facet[i], facet[i + 1]);
        farthest = (std::max)(farthest, distance({ middle.x(), middle.y(), middle.z() }, facets));
      }
    CHECK(PM::internal::boundary_distance_3(sliding.surface, sliding.start).distance == Approx(farthest));
  }
  const Body box(2, 0, same);
  Sliding_hexahedra sliding(box, 1);
  const auto dent = std::find(sliding.start.points.begin(), sliding.start.points.end(), Vector3d(1, 1, 2));
  REQUIRE(dent != sliding.start.points.end());
  (*dent)[2] -= 0.3; // only the vertex itself is that far from the body
  CHECK(PM::internal::boundary_distance_3(sliding.surface, sliding.start).distance == Approx(0.3));
  Hexahedral_mesh_result near, far;
  near.minimum_scaled_jacobian = far.minimum_scaled_jacobian = 0.2;
  near.mean_scaled_jacobian = 0.9;
  far.mean_scaled_jacobian = 0.95;
  near.boundary_distance = 0.5;
  far.boundary_distance = 1.5;
  CHECK(PM::internal::is_better(near, far, 1));
  CHECK(PM::internal::is_better(far, near, 10)); // both suffice
  near.minimum_scaled_jacobian = 0.02;
  CHECK(PM::internal::is_better(near, far, 2)); // the other one is an error
  near.minimum_scaled_jacobian = 0.005;
  CHECK(PM::internal::is_better(far, near, 2)); // but no solver takes this one
}

TEST_CASE("Hexahedra are drawn to tips that are far away once their corners suffice")
{
  const Body egg(8, 0, [](const Vector3d& p) -> Vector3d { return rounded(p).cwiseProduct(Vector3d(1, 1, 5)); });
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = egg.mesh(8 / 3., mesh);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.boundary_distance < 0.65 * 8 / 3); // if they are not, 0.82
  CHECK(1.0001 * result.boundary_distance > distance({ 0, 0, 20 }, boundary_facets(mesh)));
}

TEST_CASE("A better worst hexahedron does not make up for a mean that loses more")
{
  const auto result = [](const std::size_t number_of_inverted_corners, const double minimum, const double mean)
  {
    Hexahedral_mesh_result r;
    r.number_of_inverted_corners = number_of_inverted_corners;
    r.minimum_scaled_jacobian = minimum;
    r.mean_scaled_jacobian = mean;
    r.boundary_distance = 0;
    return r;
  };
  const auto is_better = [](const Hexahedral_mesh_result& a, const Hexahedral_mesh_result& b)
  {
    return PM::internal::is_better(a, b, 1) && !PM::internal::is_better(b, a, 1);
  };
  CHECK(is_better(result(0, 0.09, 0.97), result(0, 0.10, 0.93)));
  CHECK(is_better(result(0, 0.20, 0.92), result(0, 0.10, 0.93)));
  CHECK(is_better(result(0, 0.50, 0.93), result(0, 0.60, 0.92))); // both suffice
  CHECK(is_better(result(0, 0.05, 0.70), result(0, 0.01, 0.90))); // a bad one
  CHECK(is_better(result(0, 0.01, 0.70), result(1, -0.01, 0.95)));
}

TEST_CASE("Improvement keeps positive corners, the boundary covered, and never makes the worst hexahedron worse")
{
  for(const Body& body : { Body(8, 0, rounded), turned_box(), l_shaped_bar() })
  {
    Sliding_hexahedra sliding(body);
    for(int round = 0; round < 3; ++round)
    {
      const bool was_valid = smallest_determinant(sliding.hexahedra.mesh()) > 0;
      sliding.hexahedra.improve(4, true, static_cast<Corners_to_improve>(round)); // all three kinds
      CHECK((smallest_determinant(sliding.hexahedra.mesh()) > 0 || !was_valid));
    }

    Hexahedron_soup_3 mesh;
    const Hexahedral_mesh_result before = PM::internal::evaluated_hexahedra(sliding.start, false), after = body.mesh(1, mesh);
    CHECK(after.number_of_inverted_corners <= before.number_of_inverted_corners);
    CHECK(after.minimum_scaled_jacobian >= (std::min)(0.3, before.minimum_scaled_jacobian));

    const std::vector<K::Triangle_3> facets = body.boundary_facets(), quadrangles = boundary_facets(mesh);
    for(const std::array<double, 3>& p : body.soup.points)
      if(distance(p, facets) == 0)
        CHECK(distance(p, quadrangles) < 0.5); // half of the spacing
  }
}

TEST_CASE("Subdomains that touch at an edge or a vertex are joined or parted until surfaces between them are manifolds")
{
  const Body cube(3, 0, same);
  Hexahedra_3 boxes = Sliding_hexahedra::boxes(cube, 1);
  const auto set = [&](const std::set<std::array<int, 3> >& others)
  {
    boxes.cell_references.clear();
    for(const auto& cell : boxes.cells)
    {
      const Vector3d p = boxes.points[cell[0]];
      const std::array<int, 3> index = { static_cast<int>(p[0]), static_cast<int>(p[1]), static_cast<int>(p[2]) };
      boxes.cell_references.push_back(others.count(index) > 0 ? 2 : 1);
    }
  };
  const auto quadrangles_at_edges = [&]
  {
    std::map<std::set<std::size_t>, int> result;
    for(const PM::internal::Interface_quadrangle_3& q : PM::internal::interface_quadrangles_3(boxes))
      for(std::size_t i = 0; i < 4; ++i)
        ++result[{ q.vertices[i], q.vertices[(i + 1) % 4] }];
    return result;
  };
  using Set = std::set<std::array<int, 3> >;
  for(const Set& others : { Set{ {0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {2, 1, 1} },
                            Set{ {1, 1, 1}, {2, 2, 2}, {1, 1, 2}, {0, 0, 0}, {0, 1, 0} } })
  {
    set(others);
    PM::internal::Subdomain_separation_3(boxes).run(VMP::internal::Budget());
    for(const auto& [edge, number] : quadrangles_at_edges())
      CHECK(number <= 2);
    CHECK(std::count(boxes.cell_references.begin(), boxes.cell_references.end(), 2) >= 3);
  }
  set({ {1, 1, 1}, {2, 1, 1} }); // already a manifold
  const std::vector<int> before = boxes.cell_references;
  PM::internal::Subdomain_separation_3(boxes).run(VMP::internal::Budget());
  CHECK(boxes.cell_references == before);
}

TEST_CASE("what the boundary of hexahedra does not cover")
{
  // Two walls, x = 0 and x = 10; one point is a quarter in front of the first, two are 3 and 2 in front of the second.
  std::vector<Coordinates_3> positions = { { 0, 0, 0 }, { 0, 4, 0 }, { 0, 0, 4 }, { 10, 0, 0 }, { 10, 4, 0 }, { 10, 0, 4 } };
  const auto move_second_wall = [&](const Coordinates_3& way)
  { std::for_each(positions.begin() + 3, positions.end(), [&](Coordinates_3& p) { p += way; }); };
  const std::vector<Coordinates_3> points = { { 0.25, 1, 1 }, { 7, 1, 1 }, { 12, 1, 1 } };
  const PM::internal::Body_surface_3 surface(points, { { 0, 1, 2 } }, {});
  const PM::internal::Covered_surface_3 covered = { &surface, { { 0, 1, 2 }, { 3, 4, 5 } }, 0 };
  std::vector<PM::internal::Cover_of_vertex_3> covers(6);
  PM::internal::add_covers_3(covered, positions, 100, covers);
  REQUIRE(covers.size() == 6);
  CHECK(covers[1].points == std::vector<Coordinates_3>{ points[0] });
  CHECK(covers[5].points == std::vector<Coordinates_3>{ points[1], points[2] });
  CHECK(PM::internal::uncovered(positions, covers[0], 0.5) == 0);
  CHECK(PM::internal::uncovered(positions, covers[3], 0.5) == 2.5 * 2.5 + 1.5 * 1.5);

  // The whole wall comes nearer to one point, and goes away from the other; distances beside a triangle are to its edges.
  move_second_wall({ 1, 0, 0 });
  CHECK(PM::internal::uncovered(positions, covers[3], 0.5) == 3.5 * 3.5 + 0.5 * 0.5);
  move_second_wall({ -1, 5, 0 });
  CHECK(std::abs(PM::internal::uncovered(positions, covers[3], 0.5)
                 - (std::pow(std::hypot(4, 3) - 0.5, 2) + std::pow(std::hypot(4, 2) - 0.5, 2))) < 1e-12);
}

TEST_CASE("the middle of an edge across a valley is far")
{
  // Two slopes that meet in the line y = z = 0, two triangles that lead from one crest to the other over it, and a third one.
  const std::vector<Coordinates_3> points
    = { { -9, -2, 2 }, { 9, -2, 2 }, { -9, 0, 0 }, { 9, 0, 0 }, { -9, 2, 2 }, { 9, 2, 2 } };
  const PM::internal::Body_surface_3 surface(points, { { 0, 2, 1 }, { 1, 2, 3 }, { 2, 4, 3 }, { 3, 4, 5 } }, {});
  const std::vector<Coordinates_3> positions = { { 0, -1, 1 }, { 0, 1, 1 }, { 4, 1, 1 }, { 4, -1, 1 }, { 4, 2, 2 } };
  const PM::internal::Covered_surface_3 covered = { &surface, { { 0, 1, 2 }, { 0, 2, 3 }, { 2, 1, 4 } }, 0 };
  std::vector<PM::internal::Cover_of_vertex_3> covers(5);
  const double distance = std::sqrt(0.5); // of a middle at z = 1 from the slopes
  PM::internal::add_covers_3(covered, positions, 0.7, covers);
  for(const auto& cover : covers)
    for(const auto& [of, edge] : cover.far_edges)
      CHECK((of == &surface && positions[edge[0]][1] == -positions[edge[1]][1]));
  CHECK(covers[0].far_edges.size() == 3); // 0-1, and 0-2 of two triangles
  CHECK(covers[1].far_edges.size() == 1);
  CHECK(covers[2].far_edges.size() == 3);
  CHECK(covers[4].far_edges.empty());
  covers[1].points.clear();
  CHECK(PM::internal::uncovered(positions, covers[1], 0.5) == Approx(std::pow(distance - 0.5, 2)));

  PM::internal::add_covers_3(covered, positions, 0.71, covers = std::vector<PM::internal::Cover_of_vertex_3>(5));
  CHECK(covers[0].far_edges.empty());
}

TEST_CASE("rounding does not make corners of edges that vanish good")
{
  VMP::internal::Matrix_3 edges = VMP::internal::Matrix_3::Identity();
  edges.col(0) = { 1e-14, 0, 0 };
  CHECK(PM::internal::scaled_jacobian(edges) == Approx(1));
  CHECK(PM::internal::scaled_jacobian(edges, 0.01) == Approx(1e-12));
  edges.col(0) = { 0.1, 0, 0 };
  CHECK(PM::internal::scaled_jacobian(edges, 0.01) == Approx(1));
  edges.col(0) = Coordinates_3::Zero();
  CHECK(PM::internal::scaled_jacobian(edges) == 0);
}

// Points nearest to the facets have rounding errors, which a comparison of coordinates would miss.
TEST_CASE("Vertices in a plane of the body normal to an axis have its coordinate")
{
  const Body body(4, 0.1, [](const Vector3d& p) -> Vector3d // a cylinder between two planes, with a third plane
  {
    const Vector3d q = rounded_around_z(p) - Vector3d(2, 2, 0);
    return { q[0] / 3 + 0.1, (q[1] < 0 ? q[1] : q[1] / 7) / 3, p[2] / 3 + 0.1 };
  });
  Hexahedron_soup_3 mesh;
  REQUIRE(body.mesh(0.7, mesh).status == VMP::OK);
  std::size_t numbers[2] = { 0, 0 };
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    for(const double z : { 0., 4. })
      if(mesh.images[v][2] == z)
      {
        CHECK(mesh.points[v][2] == z / 3 + 0.1);
        ++numbers[z == 4];
      }
  CHECK(numbers[0] >= 49);
  CHECK(numbers[1] >= 49); // paths of the rims differ

  const double height = 0.1;
  const PM::internal::Body_surface_3 surface({ { 0, 0, height }, { 1, 0, height }, { 0, 1, height } }, { { 0, 1, 2 } }, {});
  for(const double z : { std::nextafter(height, 0.), std::nextafter(height, 1.), height - 1e-9 })
    CHECK(surface.put_on_planes({ 0.3, 0.4, z })[2] == (std::abs(z - height) < 1e-12 ? height : z));
}
