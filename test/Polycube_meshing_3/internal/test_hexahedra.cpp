// Hexahedra: a grid of boxes pulled back from a domain whose facets are orthogonal to the axes.
#include "catch.h"
#include "array_of_vtu_file.h"
#include "hexahedra_of_bodies.h"

#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_with_domain_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Box_grid_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Subdomain_separation_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Hexahedra_improvement_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using PM::internal::Corners_to_improve;
using Coordinates_3 = VMP::internal::Vector_3;

namespace {

// Most of a ring, whose inner side is short.
Vector3d bent(const Vector3d& p)
{
  const double angle = 1.2 * p[0], radius = 1 + p[1];
  return Vector3d(radius * std::sin(angle), radius * std::cos(angle), p[2]);
}

// The cube [0, 8]^3 to a ball of radius 4: each sphere in the maximum norm becomes one in the Euclidean norm.
Vector3d rounded(const Vector3d& p)
{
  const Vector3d q = p - Vector3d::Constant(4);
  return q.isZero() ? q : Vector3d(q * (q.lpNorm<Eigen::Infinity>() / q.norm()));
}

// The cube [0, 4]^3 to a cylinder of radius 2: each square around the axis becomes a circle.
Vector3d rounded_around_z(const Vector3d& p)
{
  const Vector3d q(p[0] - 2, p[1] - 2, 0);
  return q.isZero() ? p : Vector3d(q * (q.lpNorm<Eigen::Infinity>() / q.norm()) + Vector3d(2, 2, p[2]));
}

// A disc with a thinner one on it: two cylinders with sharp circles, one of them concave.
Body disc_with_stem()
{
  Body body(4, 0, rounded_around_z);
  auto& cells = body.soup.cells;
  cells.erase(std::remove_if(cells.begin(), cells.end(), [&](const std::array<std::size_t, 4>& cell)
              { const Vector3d p = body.center_of_image(cell) - Vector3d::Constant(2);
                return p[2] > 0 && p.head<2>().lpNorm<Eigen::Infinity>() > 1; }), cells.end());
  return body;
}

Body l_shaped_bar()
{
  Body bar(4, 0, bent);
  auto& cells = bar.soup.cells;
  cells.erase(std::remove_if(cells.begin(), cells.end(), [&](const std::array<std::size_t, 4>& cell)
              { const Vector3d p = bar.center_of_image(cell); return p[1] > 2 && p[2] > 2; }), cells.end());
  return bar;
}

std::vector<int> boundary_quadrangles_of_cells(const Hexahedron_soup_3& mesh)
{
  std::map<std::set<std::size_t>, std::vector<std::size_t> > cells;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    for(const auto& q : PM::internal::quadrangles_of_hexahedron)
      cells[{ mesh.cells[c][q[0]], mesh.cells[c][q[1]], mesh.cells[c][q[2]], mesh.cells[c][q[3]] }].push_back(c);
  std::vector<int> result(mesh.cells.size(), 0);
  for(const auto& entry : cells)
    if(entry.second.size() == 1)
      ++result[entry.second[0]];
  return result;
}

} // namespace

TEST_CASE("A box of tetrahedra becomes cubes")
{
  const Body box(3, 0.2, same);
  Hexahedron_soup_3 mesh;
  for(const int n : {1, 2})
  {
    const Hexahedral_mesh_result result = box.mesh(1. / n, mesh);
    REQUIRE(result.status == VMP::OK);
    CHECK(result.number_of_cells == static_cast<std::size_t>(27 * n * n * n));
    CHECK(mesh.cells.size() == result.number_of_cells);
    CHECK(mesh.points.size() == static_cast<std::size_t>((3 * n + 1) * (3 * n + 1) * (3 * n + 1)));
    CHECK(result.number_of_vertices - result.number_of_boundary_vertices
          == static_cast<std::size_t>((3 * n - 1) * (3 * n - 1) * (3 * n - 1)));
    CHECK_FALSE(result.has_padding);
    CHECK(result.minimum_scaled_jacobian == Approx(1));
    CHECK(result.mean_scaled_jacobian == Approx(1));
    CHECK(smallest_determinant(mesh) == Approx(1. / (n * n * n)));
    CHECK(enclosed_volume(mesh) == Approx(27));
  }
}

TEST_CASE("The grid has the planes of the domain, whatever the spacing")
{
  Body box(2, 0, same);
  for(std::array<double, 3>& q : box.images) // boxes of 1.5 x 0.7 x 1
    q = { 0.75 * q[0], 0.35 * q[1], 0.5 * q[2] };
  Hexahedron_soup_3 mesh;
  REQUIRE(box.mesh(0.5, mesh).status == VMP::OK);
  CHECK(mesh.cells.size() == 3 * 1 * 2);
  REQUIRE(box.mesh(100, mesh).status == VMP::OK);
  CHECK(mesh.cells.size() == 1);
  CHECK(smallest_determinant(mesh) == Approx(8));
}

TEST_CASE("A bent bar with an L-shaped section becomes hexahedra")
{
  const Body bar = l_shaped_bar();
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = bar.mesh(1, mesh);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.number_of_cells == 4 * 12);
  CHECK(result.minimum_scaled_jacobian > 0.5);
  CHECK(smallest_determinant(mesh) > 0);
  check_boundary(mesh, bar);

  // the edge inside the L, where y = z = 2 in the domain, is an edge of the hexahedra
  for(int x = 0; x <= 4; ++x)
  {
    const Vector3d corner = bent(Vector3d(x, 2, 2));
    CHECK(std::any_of(mesh.points.begin(), mesh.points.end(), [&](const std::array<double, 3>& p)
                      { return (vector(p) - corner).norm() < 1e-12; }));
  }
}

TEST_CASE("A ball gets a layer along its boundary")
{
  const Body ball(8, 0, rounded);
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = ball.mesh(1, mesh);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.has_padding); // otherwise hexahedra along the edges of the cube would have flat corners
  CHECK(result.number_of_cells == 512 + 384);
  CHECK(result.number_of_boundary_vertices == 386);
  CHECK(result.minimum_scaled_jacobian > 0.3);
  CHECK(smallest_determinant(mesh) > 0);
  const std::vector<int> numbers = boundary_quadrangles_of_cells(mesh);
  CHECK(*std::max_element(numbers.begin(), numbers.end()) == 1);
  check_boundary(mesh, ball);
}

TEST_CASE("Cylinders get a layer along their walls alone, which ends on the faces around them")
{
  const std::size_t disc = 8 * 8 * 4, stem = 4 * 4 * 4, wall = 32 * 4, wall_of_stem = 16 * 4, top_of_disc = 8 * 8 - 4 * 4;
  const Body bodies[] = { Body(4, 0, rounded_around_z), disc_with_stem() };
  // The circle where the stem begins is concave: its wall has a layer together with the top of the disc.
  const std::size_t numbers[] = { 8 * 8 * 8 + 2 * wall, disc + stem + wall + wall_of_stem + top_of_disc + 32 };
  for(int i = 0; i < 2; ++i)
  {
    Hexahedron_soup_3 mesh;
    const Hexahedral_mesh_result result = bodies[i].mesh(0.5, mesh);
    REQUIRE(result.status == VMP::OK);
    CHECK(result.has_padding);
    CHECK(result.number_of_cells == numbers[i]);
    CHECK(result.minimum_scaled_jacobian > 0.4); // a quadrangle alone in a straight corner of a circle makes less than 0.2
    CHECK(smallest_determinant(mesh) > 0);
    check_boundary(mesh, bodies[i]);
  }
}

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

// A box whose faces the map has turned inside.
Body turned_box()
{
  Body box(6, 0, same);
  for(std::array<double, 3>& q : box.images)
  {
    const double x = q[0] - 3, y = q[1] - 3, part = (1 - x * x / 9) * (1 - y * y / 9); // 0 on the sides
    const double angle = 1.3 * part;
    q[0] = 3 + std::cos(angle) * x - std::sin(angle) * y;
    q[1] = 3 + std::sin(angle) * x + std::cos(angle) * y;
  }
  return box;
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

namespace {

// A roof: the top of the cube [0, 8]^3 falls by 15 degrees on both sides of a ridge at y = 3, between planes of a grid.
Vector3d roof(const Vector3d& p) { return Vector3d(p[0], p[1], p[2] * (1 - std::tan(CGAL_PI / 12) * std::abs(p[1] - 3) / 8)); }

// The largest distance of points on the ridge to edges of quadrangles.
double distance_of_ridge(const Hexahedron_soup_3& mesh)
{
  double farthest = 0;
  for(int i = 0; i <= 80; ++i)
  {
    double least = std::numeric_limits<double>::infinity();
    for(const auto& f : mesh.facets)
      for(std::size_t k = 0; k < 4; ++k)
      {
        const auto point
          = [&](const std::size_t v) { return K::Point_3(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]); };
        const K::Segment_3 edge(point(f[k]), point(f[(k + 1) % 4]));
        least = (std::min)(least, CGAL::squared_distance(K::Point_3(i / 10., 3, 8), edge));
      }
    farthest = (std::max)(farthest, std::sqrt(least));
  }
  return farthest;
}

// The complex of a soup, mapped to its polycube.
struct Complex_on_polycube
{
  double spacing;
  Cube_complex<>::C3t3 c3t3;
  Cube_complex<>::Point_map uvw;

  Complex_on_polycube(const Tetrahedron_soup_3& soup, const double spacing)
    : spacing(spacing)
  {
    std::vector<Cube_complex<>::Vertex_handle> vertices;
    std::vector<Cube_complex<>::Cell_handle> cells;
    VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
    REQUIRE(CGAL::stretch_minimizing_volume_parameterization(
              c3t3, VMP::make_vertex_point_map(uvw),
              CGAL::parameters::boundary_parameterizer(PM::Polycube_boundary_parameterizer_3(spacing))
                               .do_slide_boundary(true)).status == VMP::OK);
  }

  Hexahedral_mesh_result mesh(Hexahedron_soup_3& hexahedra)
  { return PM::make_hexahedral_mesh_3(c3t3, VMP::make_vertex_point_map(uvw), spacing, hexahedra); }
};

} // namespace

TEST_CASE("Edges of hexahedra follow a blunt ridge that a complex has as a feature")
{
  constexpr double spacing = 2;
  for(const bool has_features : { true, false })
  {
    Body body(8, 0, roof);
    std::map<std::array<double, 3>, std::size_t> vertex_at;
    for(std::size_t v = 0; v < body.images.size(); ++v)
      vertex_at[body.images[v]] = v;
    for(double x = 0; x < 8 && has_features; ++x)
    {
      body.soup.edges.push_back({ vertex_at.at({ x, 3, 8 }), vertex_at.at({ x + 1, 3, 8 }) });
      body.soup.edge_references.push_back(7);
    }
    Complex_on_polycube complex(body.soup, spacing);
    CHECK(complex.c3t3.number_of_edges_in_complex() == (has_features ? 8 : 0));
    Hexahedron_soup_3 mesh;
    REQUIRE(complex.mesh(mesh).status == VMP::OK);
    CHECK((distance_of_ridge(mesh) < 0.1 * spacing) == has_features);
  }
}

TEST_CASE("Marked corners on a ridge, in a face and on an edge of a complex are vertices of its hexahedra")
{
  constexpr double spacing = 2;
  Body body(8, 0, roof);
  std::map<std::array<double, 3>, std::size_t> vertex_at;
  for(std::size_t v = 0; v < body.images.size(); ++v)
    vertex_at[body.images[v]] = v;
  const auto mark_edges = [&](const std::array<double, 3>& p, const std::array<double, 3>& way)
  {
    for(double i = 0; i < 8; ++i)
      body.soup.edges.push_back({ vertex_at.at({ p[0] + i * way[0], p[1] + i * way[1], p[2] + i * way[2] }),
                                  vertex_at.at({ p[0] + (i + 1) * way[0], p[1] + (i + 1) * way[1], p[2] + (i + 1) * way[2] }) });
  };
  mark_edges({ 0, 3, 8 }, { 1, 0, 0 });
  mark_edges({ 0, 0, 0 }, { 0, 1, 0 });
  body.soup.edge_references.assign(body.soup.edges.size(), 7);
  Points corners; // all as far from planes of the grid as can be, in the directions in which vertices may move
  for(const std::array<double, 3>& p : { std::array<double, 3>{ 3, 3, 8 }, { 5, 5, 0 }, { 0, 5, 0 }, { 8, 3, 5 } })
    corners.push_back(body.soup.points[vertex_at.at(p)]);
  for(const bool is_marked : { false, true })
  {
    body.soup.corners.clear();
    for(const std::array<double, 3>& p : corners)
      if(is_marked)
        body.soup.corners.push_back(static_cast<std::size_t>(std::find(body.soup.points.begin(), body.soup.points.end(), p)
                                                             - body.soup.points.begin()));
    Hexahedron_soup_3 mesh;
    const Hexahedral_mesh_result result = Complex_on_polycube(body.soup, spacing).mesh(mesh);
    REQUIRE(result.status == VMP::OK);
    CHECK(result.minimum_scaled_jacobian > 0.4);
    CHECK(result.corners_given_up.empty());
    CHECK(distance_of_ridge(mesh) < 0.1 * spacing);
    for(const std::array<double, 3>& corner : corners)
    {
      double least = std::numeric_limits<double>::infinity();
      for(const std::array<double, 3>& p : mesh.points)
        least = (std::min)(least, (vector(p) - vector(corner)).norm());
      CHECK((least < 1e-9) == is_marked);
      CHECK((least > 0.1 * spacing) == !is_marked);
    }
  }
}

TEST_CASE("Of marked corners nearer to each other than hexahedra are wide, those without a vertex are told")
{
  Body box(8, 0, same);
  for(std::size_t v = 0; v < box.images.size(); ++v)
    if(const auto& [x, y, z] = box.images[v]; (3 <= x && x <= 5 && y == 0 && z == 0) || (x == 4 && y == 4 && z == 4))
      box.soup.corners.push_back(v);
  REQUIRE(box.soup.corners.size() == 4); // one inside, which is no corner of the surface
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(box.soup, box.images, 4, mesh);
  CHECK(result.status == VMP::OK);
  const std::set<std::array<double, 3> > given_up(result.corners_given_up.begin(), result.corners_given_up.end());
  CHECK(given_up == std::set<std::array<double, 3> >{ { 3, 0, 0 }, { 5, 0, 0 } });
  CHECK(result.message.find("Of 3 marked corners, 2 have no vertex, among them the one at (") != std::string::npos);
}

TEST_CASE("The patches of hexahedra of a box have its areas, centers and normals")
{
  Body box(4, 0, [](const Vector3d& p) -> Vector3d { return p.cwiseProduct(Vector3d(1, 2, 3)); });
  for(const auto& facet : VMP::internal::boundary_facets_3(box.soup.cells))
  {
    box.soup.facets.push_back(facet);
    const bool is_top = std::all_of(facet.begin(), facet.end(), [&](const std::size_t v) { return box.images[v][2] == 4; });
    box.soup.facet_references.push_back(is_top ? 9 : 2);
  }
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(box.soup, box.images, 1, mesh);
  REQUIRE(result.patches.size() == 2);
  const PM::Hexahedral_mesh_patch& others = result.patches[0], & top = result.patches[1];
  CHECK(others.reference == 2);
  CHECK(others.number_of_quadrangles == 5 * 16);
  CHECK(std::abs(others.area - (2 * 4 * 12 + 2 * 8 * 12 + 4 * 8)) < 1e-9);
  CHECK(vector(others.normal).isApprox(Vector3d(0, 0, -1)));
  CHECK(top.reference == 9);
  CHECK(top.number_of_quadrangles == 16);
  CHECK(std::abs(top.area - 4 * 8) < 1e-9);
  CHECK(vector(top.center).isApprox(Vector3d(2, 4, 12)));
  CHECK(vector(top.normal).isApprox(Vector3d(0, 0, 1)));
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
  PM::internal::Hexahedra_improvement_3(sliding.hexahedra, false, sliding.budget, best).run(false);
  CHECK(smallest_determinant(best.mesh) > 0);
  for(const std::array<std::size_t, 4>& quadrangle : best.mesh.facets)
    for(const std::size_t v : quadrangle)
      CHECK((best.mesh.points[v] - Coordinates_3(3, 3, 3)).cwiseAbs().maxCoeff() == Approx(3));
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

TEST_CASE("Hexahedra do not depend on the number of threads")
{
#ifdef CGAL_LINKED_WITH_TBB
  const Body ball(8, 0, rounded);
  Hexahedron_soup_3 sequential, parallel;
  REQUIRE(ball.mesh(2, sequential).status == VMP::OK);
  REQUIRE(ball.mesh<CGAL::Parallel_tag>(2, parallel).status == VMP::OK);
  CHECK(sequential.points == parallel.points);
  CHECK(sequential.cells == parallel.cells);
#endif
}

namespace {

// Ends a computation when it is asked for the n-th time.
struct Impatient_visitor
{
  std::size_t n, number_of_questions = 0;

  bool after_step(const VMP::Parameterization_step&) { return true; }
  bool goes_on() { return ++number_of_questions != n; }
};

} // namespace

TEST_CASE("Whenever the search for hexahedra is ended, there are none, or valid ones")
{
  for(const Body& body : { Body(8, 0, rounded), turned_box() })
  {
    const auto mesh_until = [&](Impatient_visitor& visitor, Hexahedron_soup_3& mesh)
    {
      return body.mesh(1, mesh, CGAL::parameters::visitor(std::ref(visitor)));
    };
    Impatient_visitor patient = { 0 };
    Hexahedron_soup_3 whole;
    const Hexahedral_mesh_result best = mesh_until(patient, whole);
    REQUIRE(best.status == VMP::OK);
    CHECK_FALSE(best.is_interrupted);
    REQUIRE(patient.number_of_questions > 30);

    bool is_valid = false;
    for(std::size_t n = 1; n <= patient.number_of_questions; n += 1 + n / 5)
    {
      CAPTURE(n);
      Impatient_visitor visitor = { n };
      Hexahedron_soup_3 mesh;
      const Hexahedral_mesh_result result = mesh_until(visitor, mesh);
      CHECK(visitor.number_of_questions == n); // then it is at its end
      CHECK(result.is_interrupted);
      CHECK(result.status == VMP::ERROR_INTERRUPTED);
      CHECK_FALSE(result.message.empty());
      if(result.has_valid_mesh)
      {
        CHECK(smallest_determinant(mesh) > 0);
        CHECK(result.number_of_cells == mesh.cells.size());
        is_valid = true;
      }
      else
      {
        CHECK(mesh.cells.empty());
        CHECK_FALSE(is_valid); // a mesh that is valid once is not lost
      }
    }
    CHECK(is_valid);
  }
}

TEST_CASE("Without time there are no hexahedra")
{
  Cube_complex<> complex(cube_mesh(2, 0));
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    complex.uvw.emplace(complex.vertices[v], complex.vertices[v]->point());
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(complex.c3t3, complex.uvw_map(), 1, mesh,
                                                             CGAL::parameters::maximum_running_time(0.));
  CHECK(result.status == VMP::ERROR_INTERRUPTED);
  CHECK(mesh.cells.empty());
  CHECK(PM::make_hexahedral_mesh_3(complex.c3t3, complex.uvw_map(), 1, mesh).number_of_cells == 8);
}

TEST_CASE("A grid that memory has no room for is refused with a spacing that would do")
{
  const Body box(2, 0, same);
  Hexahedron_soup_3 mesh;
  const auto refused = [&](const double spacing)
  {
    const Hexahedral_mesh_result result = box.mesh(spacing, mesh);
    CHECK(result.status == VMP::ERROR_SIZE_OUT_OF_RANGE);
    return result.message;
  };
  CHECK(refused(2. / 1000).find("1e+09 boxes and may need 4000 GB of memory") != std::string::npos);
  for(const double spacing : {2. / 300, 1e-9, std::numeric_limits<double>::denorm_min()})
  {
    const std::string message = refused(spacing);
    const std::size_t begin = message.find("a spacing of ");
    REQUIRE(begin != std::string::npos);
    const double boxes = std::pow(std::round(2 / std::stod(message.substr(begin + 13))), 3);
    CHECK(boxes <= 1e7);
    CHECK(boxes > 5e6);
  }

  // cubes in a row along the diagonal, whose faces alone are in too many planes
  Body steps(1, 0, same);
  for(int i = 1; i < 250; ++i)
    for(const std::array<double, 3>& p : Points(steps.images.begin(), steps.images.begin() + 8))
    {
      steps.images.push_back({ p[0] + 2 * i, p[1] + 2 * i, p[2] + 2 * i });
      steps.soup.points.push_back(steps.images.back());
    }
  for(std::size_t c = 0; c < 6 * 249; ++c)
  {
    steps.soup.cells.push_back(steps.soup.cells[c]);
    for(std::size_t& v : steps.soup.cells.back())
      v += 8;
  }
  const Hexahedral_mesh_result result = steps.mesh(1e9, mesh);
  CHECK(result.status == VMP::ERROR_SIZE_OUT_OF_RANGE);
  CHECK(result.message.find("of the domain make 1.24251e+08 boxes") != std::string::npos); // 499^3
}

TEST_CASE("What is no box or polycube is named, and nothing is written")
{
  Body box(2, 0, same);
  Hexahedron_soup_3 mesh;
  mesh.points.push_back({ 7, 7, 7 });
  const auto status = [&](const double spacing)
  {
    const Hexahedral_mesh_result result = box.mesh(spacing, mesh);
    CHECK_FALSE(result.message.empty());
    CHECK(mesh.points.size() == 1);
    return result.status;
  };
  CHECK(status(1e-9) == VMP::ERROR_SIZE_OUT_OF_RANGE);
  CHECK_THROWS_AS(status(0), CGAL::Precondition_exception);
  CHECK_THROWS_AS(status(-1), CGAL::Precondition_exception);
  CHECK_THROWS_AS(status(std::numeric_limits<double>::quiet_NaN()), CGAL::Precondition_exception);
  CHECK_THROWS_AS(status(std::numeric_limits<double>::infinity()), CGAL::Precondition_exception);

  const Points images = box.images;
  box.images.back()[0] = std::nextafter(box.images.back()[0], -1.); // on the boundary
  CHECK(status(1) == VMP::ERROR_DOMAIN_NOT_AXIS_PARALLEL);
  box.images.back()[0] = std::numeric_limits<double>::infinity();
  CHECK(status(1) == VMP::ERROR_NON_FINITE_COORDINATE);
  box.images.assign(images.size(), { 0, 0, 0 });
  CHECK(status(1) == VMP::ERROR_INVERTED_TARGET_BOUNDARY);
  box.soup.cells.clear();
  CHECK(status(1) == VMP::ERROR_EMPTY_COMPLEX);

  // the boundary of the body turned inside out: corners on it cannot become positive
  Body mirrored(2, 0, [](const Vector3d& p) { return Vector3d(-p[0], p[1], p[2]); });
  CHECK(mirrored.mesh(1, mesh).status == VMP::ERROR_INVERTED_HEXAHEDRON);
}

TEST_CASE("A body or an image of a size for which numbers have no room is refused, and one that is a point")
{
  Hexahedron_soup_3 mesh;
  const double size = GENERATE(1e-90, 1e110, 1e-160);
  const auto scaled = [&](const Vector3d& p) -> Vector3d { return size * p; };
  const Hexahedral_mesh_result of_body = Body(2, 0, scaled).mesh(1, mesh);
  CHECK(of_body.status == VMP::ERROR_SIZE_OUT_OF_RANGE);
  CHECK(of_body.message.find("bounding box of the source") != std::string::npos);
  Body image(2, 0, same);
  for(std::array<double, 3>& p : image.images)
    p = { size * p[0], size * p[1], size * p[2] };
  const Hexahedral_mesh_result of_image = image.mesh(size, mesh);
  CHECK(of_image.status == VMP::ERROR_SIZE_OUT_OF_RANGE);
  CHECK(of_image.message.find("bounding box of the images") != std::string::npos);
  CHECK(Body(2, 0, [](const Vector3d&) { return Vector3d(1, 2, 3); }).mesh(1, mesh).status
        == VMP::ERROR_INVERTED_SOURCE_CELL);
  CHECK(mesh.points.empty());
}

TEST_CASE("A soup whose arrays do not fit together has no hexahedra")
{
  Body box(1, 0, same);
  Hexahedron_soup_3 mesh;
  box.soup.cell_references.resize(1);
  CHECK_THROWS_AS(PM::make_hexahedral_mesh_3(box.soup, box.images, 1, mesh), VMP::Input_error);
  box.soup.cells[0][0] = box.soup.points.size();
  CHECK_THROWS_AS(box.mesh(1, mesh), VMP::Input_error);
  CHECK(mesh.points.empty());
}

TEST_CASE("Hexahedra are written for VTK and MEDIT")
{
  const Body box(1, 0, same);
  Hexahedron_soup_3 mesh;
  REQUIRE(box.mesh(1, mesh).status == VMP::OK);
  std::ostringstream medit, vtu;
  PM::IO::write_MEDIT(medit, mesh);
  CHECK(medit.str().find("Vertices\n8\n0 0 0 0\n") != std::string::npos);
  CHECK(medit.str().find("Hexahedra\n1\n1 2 3 4 5 6 7 8 0\nQuadrilaterals\n6\n1 ") != std::string::npos);
  PM::IO::write_VTU(vtu, mesh);
  const std::string text = vtu.str();
  CHECK(text.find("NumberOfPoints=\"8\" NumberOfCells=\"7\"") != std::string::npos);
  const auto connectivity = array_of<std::int32_t>(text, "connectivity", "Int32");
  CHECK(std::vector<std::int32_t>(connectivity.begin(), connectivity.begin() + 8)
        == std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(array_of<std::uint8_t>(text, "types", "UInt8") == std::vector<std::uint8_t>{12, 9, 9, 9, 9, 9, 9});
  CHECK(array_of<std::int64_t>(text, "offsets", "Int64") == std::vector<std::int64_t>{8, 12, 16, 20, 24, 28, 32});
  CHECK(array_of(text, "scaled_jacobian")[0] == Approx(1));
  CHECK(array_of(text, "uvw")[3 * 6 + 1] == 1);
  CHECK(array_of<std::int32_t>(text, "face", "Int32") == std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6});
}

namespace {

using Block_position = std::array<std::size_t, 4>; // a block, and the indices of a cell in it

std::map<Block_position, std::size_t> cells_by_position(const Hexahedron_soup_3& mesh)
{
  std::map<Block_position, std::size_t> result;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    const auto [i, j, k] = mesh.cell_indices[c];
    CHECK(result.emplace(Block_position{ mesh.cell_blocks[c], i, j, k }, c).second);
  }
  return result;
}

} // namespace

TEST_CASE("Hexahedra of a block are a regular grid")
{
  for(const Body& body : { l_shaped_bar(), Body(8, 0, rounded) })
  {
    Hexahedron_soup_3 mesh;
    const bool has_padding = body.mesh(1, mesh).has_padding;
    REQUIRE(mesh.cell_blocks.size() == mesh.cells.size());
    REQUIRE(mesh.cell_indices.size() == mesh.cells.size());
    const std::map<Block_position, std::size_t> cells = cells_by_position(mesh);
    std::map<std::size_t, std::array<std::size_t, 3> > sizes;
    std::map<std::size_t, std::size_t> numbers;
    std::size_t number_of_neighbors = 0;
    for(const auto& [position, c] : cells)
    {
      ++numbers[position[0]];
      for(std::size_t axis = 0; axis < 3; ++axis)
      {
        sizes[position[0]][axis] = (std::max)(sizes[position[0]][axis], position[axis + 1] + 1);
        Block_position behind = position;
        ++behind[axis + 1];
        const auto neighbor = cells.find(behind);
        if(neighbor == cells.end())
          continue;
        ++number_of_neighbors;
        constexpr std::size_t back[3][4] = { {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7} };
        constexpr std::size_t front[3][4] = { {0, 3, 7, 4}, {1, 0, 4, 5}, {0, 1, 2, 3} };
        for(std::size_t i = 0; i < 4; ++i)
          CHECK(mesh.cells[c][back[axis][i]] == mesh.cells[neighbor->second][front[axis][i]]);
      }
    }
    for(const auto& [block, size] : sizes)
      CHECK(numbers[block] == size[0] * size[1] * size[2]);
    CHECK(numbers.size() == (has_padding ? 1 + 6 : 3)); // a cube and its layers, or an L
    CHECK(numbers.begin()->first == 1);
    CHECK(number_of_neighbors == (has_padding ? 3 * 7 * 64 + 6 * 2 * 7 * 8 : 3 * (3 * 4 + 2 * 8)));
  }
}

TEST_CASE("Quadrangles of the boundary are closed, seen from outside, and tell their face of the domain")
{
  for(const Body& body : { l_shaped_bar(), Body(8, 0, rounded), disc_with_stem() })
  {
    Hexahedron_soup_3 mesh;
    const bool has_padding = body.mesh(1, mesh).has_padding;
    const std::vector<int> numbers = boundary_quadrangles_of_cells(mesh);
    CHECK(mesh.facets.size() == static_cast<std::size_t>(std::accumulate(numbers.begin(), numbers.end(), 0)));
    REQUIRE(mesh.facet_cells.size() == mesh.facets.size());
    REQUIRE(mesh.polycube_faces.size() == mesh.facets.size());
    std::map<std::array<std::size_t, 2>, int> edges;
    std::map<std::size_t, std::set<std::size_t> > vertices_of_face;
    for(std::size_t f = 0; f < mesh.facets.size(); ++f)
    {
      const auto& cell = mesh.cells[mesh.facet_cells[f]];
      for(std::size_t i = 0; i < 4; ++i)
      {
        const std::size_t v = mesh.facets[f][i], w = mesh.facets[f][(i + 1) % 4];
        CHECK(std::count(cell.begin(), cell.end(), v) == 1);
        ++edges[{ v, w }];
        --edges[{ w, v }];
        vertices_of_face[mesh.polycube_faces[f]].insert(v);
      }
    }
    for(const auto& edge : edges)
      CHECK(edge.second == 0);
    CHECK(enclosed_volume(mesh) > 0);

    const bool is_ball = mesh.cells.size() == 512 + 384;
    CHECK(vertices_of_face.size() == (is_ball ? 6 : has_padding ? 11 : 8));
    CHECK(vertices_of_face.begin()->first == 1);
    for(const auto& [face, vertices] : vertices_of_face)
    {
      std::array<std::set<double>, 3> planes;
      for(const std::size_t v : vertices)
        for(std::size_t axis = 0; axis < 3; ++axis)
          planes[axis].insert(mesh.images[v][axis]);
      const std::size_t fewest = (std::min)({ planes[0].size(), planes[1].size(), planes[2].size() });
      CHECK((fewest == 1 || has_padding)); // vertices of the ball leave the edges of the cube
    }
    const VMP::Volume_map_3 map(body.soup.points, body.soup.cells, body.images);
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      const auto point = map.nearest_preimage({ mesh.images[v][0], mesh.images[v][1], mesh.images[v][2] })->point;
      CHECK((Vector3d(point.x(), point.y(), point.z()) - vector(mesh.points[v])).norm() < 1e-12);
    }
  }
}

TEST_CASE("Hexahedra know the subdomain that their centers are mapped to")
{
  const auto cube = cube_mesh(2, 0);
  Tetrahedron_soup_3 soup = source_soup(cube);
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    double x = 0;
    for(const std::size_t v : soup.cells[c])
      x += soup.points[v][0] / 4;
    soup.cell_references[c] = x < 1 ? 7 : 5;
  }
  Cube_complex<> complex(cube, soup);
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    complex.uvw.emplace(complex.vertices[v], complex.vertices[v]->point());
  Hexahedron_soup_3 mesh;
  REQUIRE(PM::make_hexahedral_mesh_3(complex.c3t3, complex.uvw_map(), 1, mesh).status == VMP::OK);
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    CHECK(mesh.cell_references[c] == (mesh.points[mesh.cells[c][0]][0] < 0.5 ? 7 : 5));
  std::ostringstream medit;
  PM::IO::write_MEDIT(medit, mesh);
  CHECK(medit.str().find(" 7\n", medit.str().find("Hexahedra")) != std::string::npos);
}

TEST_CASE("Quadrangles have the references of the facets that they lie on, of a soup and of a complex, in all files")
{
  const auto cube = cube_mesh(4, 0);
  Tetrahedron_soup_3 soup = source_soup(cube);
  soup.facets = VMP::internal::boundary_facets_3(soup.cells);
  soup.facet_references.clear();
  const auto reference = [](const Vector3d& center) // not those of the faces of the cube
  { return center[0] < 1e-9 ? 3 : center[2] > 4 - 1e-9 && center[1] < 2 ? 11 : center[2] > 4 - 1e-9 ? 12 : 0; };
  for(const auto& f : soup.facets)
  {
    const Vector3d sum = vector(soup.points[f[0]]) + vector(soup.points[f[1]]) + vector(soup.points[f[2]]);
    soup.facet_references.push_back(reference(sum / 3));
  }
  Hexahedron_soup_3 mesh, of_complex;
  REQUIRE(PM::make_hexahedral_mesh_3(soup, soup.points, 1, mesh).status == VMP::OK);
  REQUIRE(mesh.facets.size() == 96);
  for(std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    const Vector3d sum = vector(mesh.points[mesh.facets[f][0]]) + vector(mesh.points[mesh.facets[f][2]]);
    CHECK(mesh.facet_references[f] == reference(sum / 2));
  }
  CHECK(std::count(mesh.facet_references.begin(), mesh.facet_references.end(), 11) == 8);

  Cube_complex<> complex(cube, soup);
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    complex.uvw.emplace(complex.vertices[v], complex.vertices[v]->point());
  REQUIRE(PM::make_hexahedral_mesh_3(complex.c3t3, complex.uvw_map(), 1, of_complex).status == VMP::OK);
  std::vector<int> references = mesh.facet_references;
  std::replace(references.begin(), references.end(), 0, 1); // the boundary of a complex has no facet without a patch
  CHECK(of_complex.facet_references == references);

  std::ostringstream vtu, inp, medit;
  PM::IO::write_VTU(vtu, mesh);
  const auto surfaces = array_of<std::int32_t>(vtu.str(), "surface", "Int32");
  CHECK(std::vector<int>(surfaces.begin() + 64, surfaces.end()) == mesh.facet_references);
  PM::IO::write_INP(inp, mesh);
  for(const auto& [name, number] : { std::pair("SURFACE_3", 16), std::pair("SURFACE_11", 8), std::pair("SURFACE_12", 8) })
  {
    const std::size_t begin = inp.str().find(std::string("*SURFACE, TYPE=ELEMENT, NAME=") + name + "\n");
    REQUIRE(begin != std::string::npos);
    const std::string section = inp.str().substr(begin + 1, inp.str().find('*', begin + 1) - begin - 1);
    CHECK(std::count(section.begin(), section.end(), '\n') == number + 1);
    CHECK(inp.str().find(std::string("*NSET, NSET=") + name + "\n") != std::string::npos);
  }
  CHECK(inp.str().find("SURFACE_0") == std::string::npos);
  PM::IO::write_MEDIT(medit, mesh);
  CHECK(medit.str().find(" 12\n", medit.str().find("Quadrilaterals")) != std::string::npos);
}

TEST_CASE("Valid hexahedra with a scaled Jacobian below the bound have a status of their own")
{
  const Body sheared(2, 0, [](const Vector3d& p) -> Vector3d { return { p[0] + 3 * p[1], p[1], p[2] }; });
  Hexahedron_soup_3 mesh;
  const double least = sheared.mesh(1, mesh).minimum_scaled_jacobian;
  REQUIRE(least > 0.01);
  REQUIRE(least < 0.9);
  CHECK(sheared.mesh(1, mesh).status == VMP::OK);
  CHECK(sheared.mesh(1, mesh, CGAL::parameters::minimum_scaled_jacobian(0.99 * least)).status == VMP::OK);
  const Hexahedron_soup_3 expected = mesh;
  mesh = Hexahedron_soup_3();
  const Hexahedral_mesh_result result = sheared.mesh(1, mesh, CGAL::parameters::minimum_scaled_jacobian(1.01 * least));
  CHECK(result.status == VMP::ERROR_POOR_HEXAHEDRON);
  CHECK(result.has_valid_mesh);
  CHECK(mesh.points == expected.points);
  CHECK(result.message.find("has a vertex at (") != std::string::npos);
  // The map is affine: a smaller spacing helps nothing. Squares of the extreme singular values have the sum 11, product 1.
  CHECK(result.message.find("spacing") == std::string::npos);
  CHECK(result.message.find("distorts angles by a factor of 11 at the worst one") != std::string::npos);
  CHECK_THROWS_AS(sheared.mesh(1, mesh, CGAL::parameters::minimum_scaled_jacobian(1.5)), CGAL::Precondition_exception);
}

namespace {

// Returns the sections of an input file of Abaqus: for each line that begins with an asterisk, the words behind, separated by
// commas.
std::map<std::string, std::vector<std::string> > sections_of_inp(const std::string& text)
{
  std::map<std::string, std::vector<std::string> > result;
  std::istringstream lines(text);
  std::string line, keyword, word;
  while(std::getline(lines, line))
  {
    if(line[0] == '*')
    {
      keyword = line;
      CHECK(result.emplace(keyword, std::vector<std::string>()).second);
      continue;
    }
    CHECK(std::count(line.begin(), line.end(), ',') <= 16);
    std::istringstream words(line);
    while(std::getline(words >> std::ws, word, ','))
    {
      CHECK(word.size() <= 20);
      result[keyword].push_back(word);
    }
  }
  return result;
}

} // namespace

TEST_CASE("Hexahedra are written for Abaqus, with faces in its numbering, and numbers of at most 20 characters")
{
  Hexahedron_soup_3 mesh;
  REQUIRE(l_shaped_bar().mesh(1, mesh).status == VMP::OK);
  for(std::array<double, 3>& p : mesh.points)
    p = { p[0] * 1e-5, p[1] * -1e-120, p[2] * 100. / 3 };
  mesh.cell_references.back() = 9;
  std::ostringstream out;
  PM::IO::write_INP(out, mesh);
  const auto sections = sections_of_inp(out.str());
  const std::string name = "hexahedra_of_a_type.inp";
  for(const std::string type : { "C3D8", "C3D8I", "C3D8R" })
  {
    CHECK(PM::IO::write_INP(name, mesh, type));
    std::ifstream file(name);
    auto sections_of_type = sections_of_inp(std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()));
    CHECK(sections_of_type.size() == sections.size());
    CHECK(sections_of_type.count("*ELEMENT, TYPE=" + type + ", ELSET=EALL") == 1);
  }
  std::remove(name.c_str());
  CHECK_THROWS_AS(PM::IO::write_INP(name, mesh, "C3D4"), CGAL::Precondition_exception);
  CHECK_FALSE(std::ifstream(name));
  CHECK_FALSE(PM::IO::write_INP("no/such/folder.inp", mesh));

  // groups are sets, too, each by a name of its own that these programs take
  Hexahedron_soup_3 marked = mesh;
  marked.facet_references.front() = 5;
  std::ostringstream with_groups;
  PM::IO::write_INP(with_groups, marked, "C3D8",
                     { { { 2, 5 }, "2nd face" }, { { 3, 0 }, "STEEL_1" }, { { 3, 9 }, "Steel 1" }, { { 3, 77 }, "of no cell" } });
  auto named = sections_of_inp(with_groups.str());
  CHECK(named.at("*ELSET, ELSET=STEEL_1") == sections.at("*ELSET, ELSET=SUBDOMAIN_0"));
  CHECK(named.at("*ELSET, ELSET=Steel_1_2") == sections.at("*ELSET, ELSET=SUBDOMAIN_9"));
  CHECK(named.at("*NSET, NSET=GROUP_2nd_face") == named.at("*NSET, NSET=SURFACE_5"));
  CHECK(named.at("*SURFACE, TYPE=ELEMENT, NAME=GROUP_2nd_face") == named.at("*SURFACE, TYPE=ELEMENT, NAME=SURFACE_5"));
  CHECK(named.size() == sections.size() + 6); // these, and two of SURFACE_5

  // names that are possible stay, those of the package give way, and equal names are one group
  marked.facet_references[1] = 6;
  marked.facet_references[2] = 7;
  const std::map<std::pair<int, int>, std::string> groups = { { { 2, 5 }, "FACE_1" }, { { 2, 6 }, "a b" }, { { 2, 7 }, "FACE_1" },
    { { 2, 8 }, "a-b" }, { { 2, 9 }, "a_b" }, { { 2, 10 }, "Gr\u00f6\u00dfe" }, { { 2, 11 }, "" }, { { 2, 12 }, "nall" },
    { { 2, 13 }, "A_B" }, { { 2, 14 }, std::string(90, 'x') }, { { 2, 15 }, std::string(91, 'x') }, { { 3, 0 }, "a_b" } };
  CHECK(PM::IO::names_in_INP(groups) == std::map<std::pair<int, int>, std::string>{
    { { 2, 5 }, "FACE_1" }, { { 2, 6 }, "a_b_2" }, { { 2, 7 }, "FACE_1" }, { { 2, 8 }, "a_b_3" }, { { 2, 9 }, "a_b" },
    { { 2, 10 }, "Gr__e" }, { { 2, 11 }, "GROUP_" }, { { 2, 12 }, "nall_2" }, { { 2, 13 }, "A_B_4" },
    { { 2, 14 }, std::string(80, 'x') }, { { 2, 15 }, std::string(70, 'x') + "_2" }, { { 3, 0 }, "a_b" } });
  std::ostringstream with_faces;
  PM::IO::write_INP(with_faces, marked, "C3D8", groups);
  named = sections_of_inp(with_faces.str());
  std::vector<std::string> both = named.at("*SURFACE, TYPE=ELEMENT, NAME=SURFACE_5");
  const std::vector<std::string>& other = named.at("*SURFACE, TYPE=ELEMENT, NAME=SURFACE_7");
  both.insert(both.end(), other.begin(), other.end());
  CHECK(named.at("*SURFACE, TYPE=ELEMENT, NAME=FACE_1") == both); // not the face of the polycube
  CHECK(named.at("*SURFACE, TYPE=ELEMENT, NAME=a_b_2") == named.at("*SURFACE, TYPE=ELEMENT, NAME=SURFACE_6"));
  CHECK(named.at("*ELSET, ELSET=a_b") == sections.at("*ELSET, ELSET=SUBDOMAIN_0"));
  std::ostringstream vtu;
  PM::IO::write_VTU(vtu, marked, groups);
  CHECK(vtu.str().find("Name=\"a b\"") != std::string::npos);

  const std::vector<std::string>& nodes = sections.at("*NODE, NSET=NALL");
  REQUIRE(nodes.size() == 4 * mesh.points.size());
  for(std::size_t i = 0; i < nodes.size(); ++i)
    if(i % 4 == 0)
      CHECK(std::stoul(nodes[i]) == i / 4 + 1);
    else
      CHECK(std::stod(nodes[i]) == Approx(mesh.points[i / 4][i % 4 - 1]).epsilon(1e-12));
  const std::vector<std::string>& elements = sections.at("*ELEMENT, TYPE=C3D8, ELSET=EALL");
  REQUIRE(elements.size() == 9 * mesh.cells.size());
  for(std::size_t i = 0; i < elements.size(); ++i)
    CHECK(std::stoul(elements[i]) == 1 + (i % 9 == 0 ? i / 9 : mesh.cells[i / 9][i % 9 - 1]));
  CHECK(sections.at("*ELSET, ELSET=SUBDOMAIN_0").size() == mesh.cells.size() - 1);
  CHECK(sections.at("*ELSET, ELSET=SUBDOMAIN_9") == std::vector<std::string>{ std::to_string(mesh.cells.size()) });

  // the nodes of faces of elements, from the manual of CalculiX
  constexpr std::size_t nodes_of_face[6][4]
    = { {1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1} };
  std::size_t number_of_facets = 0;
  for(std::size_t number = 1; number <= 8; ++number)
  {
    const std::string name = "FACE_" + std::to_string(number);
    const std::vector<std::string>& surface = sections.at("*SURFACE, TYPE=ELEMENT, NAME=" + name);
    std::set<std::string> nodes_of_surface;
    std::set<std::set<std::size_t> > faces, expected;
    for(std::size_t i = 0; i < surface.size(); i += 2)
    {
      std::set<std::size_t> face;
      for(const std::size_t node : nodes_of_face[std::stoul(surface[i + 1].substr(1)) - 1])
        face.insert(mesh.cells[std::stoul(surface[i]) - 1][node - 1]);
      for(const std::size_t v : face)
        nodes_of_surface.insert(std::to_string(v + 1));
      faces.insert(face);
    }
    for(std::size_t f = 0; f < mesh.facets.size(); ++f)
      if(mesh.polycube_faces[f] == number)
        expected.emplace(mesh.facets[f].begin(), mesh.facets[f].end());
    CHECK(faces == expected);
    number_of_facets += faces.size();
    const std::vector<std::string>& set = sections.at("*NSET, NSET=" + name);
    CHECK(std::set<std::string>(set.begin(), set.end()) == nodes_of_surface);
    CHECK(set.size() == nodes_of_surface.size());
  }
  CHECK(number_of_facets == mesh.facets.size());
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
    CHECK(surface.without_rounding({ 0.3, 0.4, z })[2] == (std::abs(z - height) < 1e-12 ? height : z));
}

// Edges of one hexahedron are nearly as long as the body, and its boundary is never farther away.
TEST_CASE("Hexahedra that are too few for the shape of the body are incomplete")
{
  const Body ball(8, 0, rounded);
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result coarse = ball.mesh(8, mesh);
  CAPTURE(coarse.message);
  CHECK(coarse.status == VMP::ERROR_INCOMPLETE_HEXAHEDRA);
  CHECK(coarse.boundary_distance > 1.6); // as for the largest cube in the ball
  CHECK(coarse.message.find("The spacing is 8 in a domain with the sides (8, 8, 8).") != std::string::npos);
  CHECK(ball.mesh(4, mesh).status == VMP::OK);
}

// The top of a cube is a ridge along the diagonal, which follows no axis: four curves meet at both of its ends.
TEST_CASE("Hexahedra keep the corners, curves and patches of a body, also those that follow no axis")
{
  const Body body(6, 0, [](const Vector3d& p) -> Vector3d
                  { return { p[0], p[1], p[2] * (1 - 0.08 * std::abs(p[0] - p[1])) }; });
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = body.mesh(1, mesh);
  CAPTURE(result.message, result.minimum_scaled_jacobian);
  REQUIRE(result.status == VMP::OK);
  check_boundary(mesh, body);
  const PM::Hexahedral_mesh_features& features = result.features;
  CHECK(features.number_of_corners == 8);
  CHECK(features.number_of_curves == 13);
  CHECK(features.number_of_patches == 7);
  CHECK(features.number_of_corners_kept == 8);
  CHECK(features.number_of_curves_kept == 13);
  CHECK(features.number_of_patches_kept == 7);
  CHECK(result.minimum_scaled_jacobian > 0.1);
  CHECK(enclosed_volume(mesh) == Approx(36 * 6 - 36 * 6 * 0.08 * 2).epsilon(1e-9)); // the mean of |x - y| is 2
}

TEST_CASE("The message and the result name a feature without room in the hexahedra")
{
  const Body body(8, 0, [](const Vector3d& p) -> Vector3d
                  { return { p[0], p[1], p[2] + (p[0] == 4 && p[1] == 4 && p[2] == 8 ? 2. : 0.) }; }); // a small pyramid
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = body.mesh(8, mesh);
  CAPTURE(result.message);
  REQUIRE(result.has_valid_mesh);
  CHECK(result.features.number_of_corners_kept < result.features.number_of_corners);
  REQUIRE(!result.features.curves_given_up.empty());
  CHECK(result.message.find(" curves and ") != std::string::npos);
}
