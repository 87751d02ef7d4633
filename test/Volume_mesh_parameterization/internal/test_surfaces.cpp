// Vertices that slide on surfaces: implicit ones, triangulated ones, and curves of both.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Implicit_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/Surface_intersection_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/conditions_of_patches.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Sliding_boundary_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Embedded_boundary_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>

#include <CGAL/property_map.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

namespace { namespace of_surfaces {

using Condition = VMP::Vertex_condition_3;
using Eigen::Vector3d;
using Point = std::array<double, 3>;
using Triangles = std::vector<std::array<std::size_t, 3> >;

Vector3d vector(const Point& p) { return Vector3d(p[0], p[1], p[2]); }
Point point(const Vector3d& p) { return { p[0], p[1], p[2] }; }

struct Sphere
{
  double value(const Point& p) const { return vector(p).squaredNorm() - 1; }
  Point gradient(const Point& p) const { return point(2 * vector(p)); }
};

struct Cylinder
{
  double value(const Point& p) const { return p[0] * p[0] + p[1] * p[1] - 1; }
  Point gradient(const Point& p) const { return { 2 * p[0], 2 * p[1], 0 }; }
};

struct Torus // with the radii 1 and 1/4
{
  double value(const Point& p) const { return std::pow(std::hypot(p[0], p[1]) - 1, 2) + p[2] * p[2] - 0.0625; }
  Point gradient(const Point& p) const
  {
    const double r = std::hypot(p[0], p[1]), factor = 2 * (r - 1) / r;
    return { factor * p[0], factor * p[1], 2 * p[2] };
  }
};

struct Horizontal_plane
{
  double z;
  double value(const Point& p) const { return p[2] - z; }
  Point gradient(const Point&) const { return { 0, 0, 1 }; }
};

Vector3d random_point(std::mt19937& engine)
{
  std::uniform_real_distribution<double> coordinate(-1, 1);
  return { coordinate(engine), coordinate(engine), coordinate(engine) };
}

// The boundary of a body, with its points as they are.
Triangles boundary_of(const VMP::Tetrahedron_soup_3& soup) { return VMP::internal::boundary_facets_3(soup.cells); }

// The cube [-1, 1]^3 of 6 n^3 cells, with points moved by a function.
template <typename Function>
VMP::Tetrahedron_soup_3 body(const int n, const Function& f)
{
  VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(n));
  for(Point& p : soup.points)
    p = point(f(Vector3d(2. / n * vector(p) - Vector3d::Ones())));
  return soup;
}

// The disc of which a square is the image: sides go to circles about the origin.
Vector3d round(const Vector3d& p)
{
  const double x = p[0] * std::sqrt(1 - p[1] * p[1] / 2), y = p[1] * std::sqrt(1 - p[0] * p[0] / 2);
  return Vector3d(x, y, p[2]);
}

// A mesh, with a condition and a target of each vertex.
struct Problem
{
  VMP::Tetrahedron_soup_3 soup;
  std::vector<Condition> conditions;
  std::vector<Point> targets, images = {};

  explicit Problem(VMP::Tetrahedron_soup_3 mesh) : soup(std::move(mesh)), conditions(soup.points.size()), targets(soup.points) {}

  template <typename Tag = CGAL::Sequential_tag, typename NT = double>
  VMP::Parameterization_result run(const double tolerance = 0)
  {
    std::vector<std::array<NT, 3> > mapped;
    const VMP::Tetrahedron_soup_3& constant = soup;
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization<Tag>(
      constant, targets, mapped, params::energy(VMP::Symmetric_Dirichlet_energy_3()).energy_tolerance(tolerance)
        .vertex_condition_map(CGAL::make_property_map(conditions)));
    images.clear();
    for(const auto& p : mapped)
      images.push_back({ double(p[0]), double(p[1]), double(p[2]) });
    return result;
  }
};

// A round tank with its wall on a cylinder, floor and top in planes, and the rims where these meet.
Problem tank(const int n, const double height)
{
  Problem problem(body(n, round));
  const VMP::Any_surface_3 wall = VMP::Implicit_surface_3(Cylinder());
  for(std::size_t v = 0; v < problem.soup.points.size(); ++v)
  {
    const Point& p = problem.soup.points[v];
    const bool is_on_wall = std::abs(std::hypot(p[0], p[1]) - 1) < 1e-9, is_at_end = std::abs(p[2]) == 1;
    const double z = p[2] == 1 ? height : p[2];
    if(is_on_wall)
      problem.conditions[v] = is_at_end ? Condition::on_curve(VMP::Surface_intersection_3(
                                            wall, VMP::Implicit_surface_3(Horizontal_plane{ z })))
                                        : Condition::on_surface(wall);
    else if(is_at_end)
      problem.conditions[v] = Condition::in_plane(0, 0, 1);
    problem.targets[v][2] = z;
  }
  return problem;
}

TEST_CASE("Points are put back on implicit surfaces to the last bits")
{
  std::mt19937 engine;
  for(int i = 0; i < 1000; ++i)
  {
    const Vector3d d = random_point(engine);
    const double angle = std::atan2(d[1], d[0]);
    const Vector3d on_circle(std::cos(angle), std::sin(angle), 0);
    const Vector3d on_sphere = vector(VMP::Implicit_surface_3(Sphere()).nearest_point(point(1.3 * d.normalized())).point);
    CHECK((on_sphere - d.normalized()).norm() < 1e-15);
    const Vector3d on_cylinder = vector(VMP::Implicit_surface_3(Cylinder()).nearest_point(point(0.7 * on_circle + 5 * d)).point);
    CHECK(std::abs(on_cylinder.head<2>().norm() - 1) < 1e-15);
    const Vector3d near_circle = on_circle + 0.3 * d.normalized();
    const Vector3d on_torus = vector(VMP::Implicit_surface_3(Torus()).nearest_point(point(near_circle)).point);
    CHECK(std::abs((on_torus - on_torus.cwiseProduct(Vector3d(1, 1, 0)).normalized()).norm() - 0.25) < 1e-15);
  }
}

TEST_CASE("Points are put back to the nearest point of a triangulated surface")
{
  const VMP::Tetrahedron_soup_3 soup = body(4, round);
  const Triangles triangles = boundary_of(soup);
  const VMP::Triangulated_surface_3 surface(soup.points, triangles);
  CHECK(surface.number_of_patches() == 3);
  CHECK(surface.number_of_curves() == 2);
  Triangles turned = triangles; // files may have triangles of any orientation
  for(std::size_t t = 0; t < turned.size(); t += 3)
    std::swap(turned[t][0], turned[t][1]);
  CHECK(VMP::Triangulated_surface_3(soup.points, turned).number_of_patches() == 3);
  std::vector<Vector3d> samples; // which are no nearer, and a few are hardly farther
  for(const auto& [a, b, c] : triangles)
    for(int k = 0; k <= 10; ++k)
      for(int l = 0; k + l <= 10; ++l)
        samples.push_back((k * vector(soup.points[a]) + l * vector(soup.points[b]) + (10 - k - l) * vector(soup.points[c])) / 10);
  std::mt19937 engine;
  for(int i = 0; i < 200; ++i)
  {
    const Vector3d p = 1.5 * random_point(engine), q = vector(surface.nearest_point(point(p)).point);
    double distance = std::numeric_limits<double>::infinity();
    for(const Vector3d& sample : samples)
      distance = (std::min)(distance, std::hypot(p[0] - sample[0], p[1] - sample[1], p[2] - sample[2]));
    CHECK((q - p).norm() <= distance + 1e-15);
    CHECK((q - p).norm() >= distance - 0.05);
    if(std::abs(q[2]) > 1 - 1e-9 && q.head<2>().norm() < 0.9) // the coordinate of floor and top is exact
      CHECK(std::abs(q[2]) == 1);
  }
  for(int i = 0; i < 1000; ++i) // many are put back to edges, where rounding chooses a triangle
  {
    const VMP::Surface_point_3 near = surface.nearest_point(point(3 * random_point(engine)));
    CHECK(surface.nearest_point(near.point).direction == near.direction);
  }
  CHECK_THROWS_AS(VMP::Triangulated_surface_3(soup.points, { { 0, 1, soup.points.size() } }), VMP::Input_error);
  CHECK_THROWS_AS(VMP::Triangulated_surface_3(soup.points, { { 0, 1, 1 } }), VMP::Input_error);
}

// A sphere whose values have any size, also one whose square is no number.
struct Scaled_sphere
{
  double factor;
  double value(const Point& p) const { return factor * (vector(p).squaredNorm() - 1); }
  Point gradient(const Point& p) const { return { 2 * factor * p[0], 2 * factor * p[1], 2 * factor * p[2] }; }
};

// Its slope at the plane z = 0 is infinite.
struct Cube_root
{
  double value(const Point& p) const { return std::cbrt(p[2]); }
  Point gradient(const Point& p) const { return { 0, 0, 1 / (3 * std::cbrt(p[2] * p[2])) }; }
};

TEST_CASE("Slopes of implicit surfaces may have any size that is finite")
{
  for(const double factor : { 1e-200, 1., 1e154, 1e300 })
  {
    const Vector3d p = vector(VMP::Implicit_surface_3(Scaled_sphere{ factor }).nearest_point({ 0.3, 0.4, 1.2 }).point);
    CHECK(std::abs(p.norm() - 1) < 1e-15);
  }
  Problem problem(body(2, [](const Vector3d& p) -> Vector3d { return p + Vector3d(0, 0, 1.25); }));
  const VMP::Any_surface_3 surface = VMP::Implicit_surface_3(Cube_root());
  for(std::size_t v = 0; v < problem.soup.points.size(); ++v)
    if(problem.soup.points[v][2] == 0.25)
      problem.conditions[v] = Condition::on_surface(surface);
  const VMP::Parameterization_result result = problem.run();
  CHECK(!result.has_valid_map);
  CHECK(result.message.find("Newton's method diverges") != std::string::npos);
}

TEST_CASE("A curve ends at the border of a patch")
{
  // a quarter of the unit square in the plane z = 0, and the plane y = 0.3 + x / 2
  const VMP::Any_surface_3 patch = VMP::Triangulated_surface_3({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
                                                               { { 0, 1, 2 }, { 0, 2, 3 } });
  struct Plane
  {
    double value(const Point& p) const { return p[1] - p[0] / 2 - 0.3; }
    Point gradient(const Point&) const { return { -0.5, 1, 0 }; }
  };
  const VMP::Any_surface_3 plane = VMP::Implicit_surface_3(Plane());
  for(const auto& curve : { VMP::Surface_intersection_3(patch, plane), VMP::Surface_intersection_3(plane, patch) })
  {
    const auto nearest = [&](const Point& p) { return vector(curve.nearest_point(p).point); };
    CHECK((nearest({ 0.5, 0.5, 0.2 }) - Vector3d(0.5, 0.55, 0)).norm() < 0.1);
    CHECK((nearest({ 3, 1.5, 0 }) - Vector3d(1, 0.8, 0)).norm() < 1e-14);
    CHECK((nearest({ -2, 0.1, 0.3 }) - Vector3d(0, 0.3, 0)).norm() < 1e-14);
  }
  // surfaces that do not meet: no point is its own nearest one
  const VMP::Any_surface_3 far_patch = VMP::Triangulated_surface_3({ { 0, 5, 0 }, { 1, 5, 0 }, { 1, 6, 0 } }, { { 0, 1, 2 } });
  for(const auto& curve : { VMP::Surface_intersection_3(far_patch, plane), VMP::Surface_intersection_3(plane, far_patch) })
  {
    Point p = { 0.5, 0.5, 0.2 };
    for(int i = 0; i < 5; ++i)
    {
      const Point q = curve.nearest_point(p).point;
      CHECK((vector(q) - vector(p)).norm() > 0.1);
      p = q;
    }
  }
}

TEST_CASE("A tank whose boundary was stirred slides back on its wall, which is exact")
{
  Problem problem = tank(4, 1);
  for(Point& p : problem.targets)
  {
    const double angle = 0.2 * p[2] * p[0]; // turns parts of the wall by different angles
    p = { std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1], p[2] };
  }
  const VMP::Parameterization_result result = problem.run();
  REQUIRE(result.status == VMP::OK);
  CHECK(result.number_of_inverted_cells == 0);
  CHECK(result.energy < 6.01); // the identity has 6, and the scale of the stirred wall is not quite 1
  for(std::size_t v = 0; v < problem.images.size(); ++v)
  {
    const Vector3d p = vector(problem.images[v]), source = vector(problem.soup.points[v]);
    if(std::abs(source.head<2>().norm() - 1) < 1e-9)
      CHECK(std::abs(p.head<2>().norm() - 1) < 1e-15);
    if(std::abs(source[2]) == 1)
      CHECK(p[2] == source[2]);
  }
}

// The energy of a ball whose boundary stays at the targets.
VMP::Parameterization_result with_fixed_boundary(Problem problem)
{
  for(Condition& condition : problem.conditions)
    if(condition.is_sliding())
      condition = Condition::at_target();
  return problem.run();
}

Problem cube_to_ball(const int n, const VMP::Any_surface_3& surface)
{
  Problem problem(body(n, [](const Vector3d& p) { return p; }));
  for(std::size_t v = 0; v < problem.soup.points.size(); ++v)
    if(const Vector3d p = vector(problem.soup.points[v]); p.cwiseAbs().maxCoeff() == 1)
    {
      problem.conditions[v] = Condition::on_surface(surface);
      problem.targets[v] = surface.nearest_point(point(p.normalized())).point;
    }
  return problem;
}

TEST_CASE("A cube mapped to a ball slides on the sphere, and its energy falls")
{
  Problem problem = cube_to_ball(6, VMP::Implicit_surface_3(Sphere()));
  const VMP::Parameterization_result fixed = with_fixed_boundary(problem), result = problem.run();
  REQUIRE(fixed.status == VMP::OK);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.energy < 0.99 * fixed.energy);
  CHECK(result.number_of_sliding_vertices == 218);
  for(std::size_t v = 0; v < problem.images.size(); ++v)
    if(problem.conditions[v].is_sliding())
      CHECK(std::abs(vector(problem.images[v]).norm() - 1) < 1e-15);
}

TEST_CASE("A cube mapped to a triangulated ball slides on its triangles")
{
  const VMP::Tetrahedron_soup_3 ball = body(10, [](const Vector3d& p) -> Vector3d
  { return p.isZero() ? p : Vector3d(p * (p.cwiseAbs().maxCoeff() / p.norm())); });
  const VMP::Triangulated_surface_3 surface(ball.points, boundary_of(ball));
  REQUIRE(surface.number_of_patches() == 1);
  Problem problem = cube_to_ball(6, surface);
  const VMP::Parameterization_result fixed = with_fixed_boundary(problem), result = problem.run(1e-3);
  REQUIRE(fixed.status == VMP::OK);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.energy < fixed.energy);
  for(std::size_t v = 0; v < problem.images.size(); ++v)
    if(problem.conditions[v].is_sliding())
      CHECK((vector(surface.nearest_point(problem.images[v]).point) - vector(problem.images[v])).norm() < 1e-15);
}

// Marks the boundary of a tank: 1 its wall, 2 its floor, 3 its top.
void mark_boundary(VMP::Tetrahedron_soup_3& soup)
{
  soup.facets = boundary_of(soup);
  for(const auto& [a, b, c] : soup.facets)
  {
    const double lowest = (std::min)({ soup.points[a][2], soup.points[b][2], soup.points[c][2] });
    const double highest = (std::max)({ soup.points[a][2], soup.points[b][2], soup.points[c][2] });
    soup.facet_references.push_back(highest == -1 ? 2 : lowest == 1 ? 3 : 1);
  }
}

TEST_CASE("Conditions of patches let a tank slide on its wall, and on curves to floor and top")
{
  VMP::Tetrahedron_soup_3 soup = body(4, round);
  mark_boundary(soup);
  using Patch = VMP::Patch_condition_3;
  for(const bool is_own : { true, false })
  {
    const auto [conditions, targets] = VMP::conditions_of_patches(soup, std::map<int, Patch>{
      { 1, is_own ? Patch::on_own_surface() : Patch::on_surface(VMP::Implicit_surface_3(Cylinder())) },
      { 2, Patch::coordinate(2, -1) }, { 3, Patch::coordinate(2, 0.75) } });
    std::array<int, 6> numbers = {};
    for(const Condition& condition : conditions)
      ++numbers[condition.kind()];
    CHECK(numbers == std::array<int, 6>{ 27, 18, 0, 0, 48, 32 });
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      if(conditions[v].kind() == Condition::ON_CURVE)
        CHECK(targets[v][2] == (soup.points[v][2] == 1 ? 0.75 : -1));
    Problem problem(soup);
    problem.conditions = conditions;
    problem.targets = targets;
    const VMP::Parameterization_result result = problem.run();
    CHECK(result.status == VMP::OK);
    CHECK(result.number_of_inverted_cells == 0);
    const VMP::Triangulated_surface_3 own(soup.points, soup.facets);
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      if(conditions[v].is_sliding())
      {
        const Vector3d p = vector(problem.images[v]);
        CHECK((is_own ? (vector(own.nearest_point(point(p)).point) - p).norm() : std::abs(p.head<2>().norm() - 1)) < 1e-15);
        if(conditions[v].kind() == Condition::ON_CURVE)
          CHECK(p[2] == targets[v][2]);
      }
  }
  // between two of its own patches, a vertex slides on the curve of edges
  const auto own = VMP::conditions_of_patches(soup, std::map<int, Patch>{ { 1, Patch::on_own_surface() },
                                                                         { 2, Patch::on_own_surface() } });
  CHECK(std::count_if(own.conditions.begin(), own.conditions.end(), [](const Condition& condition)
                      { return condition.kind() == Condition::ON_CURVE; }) == 16);
  CHECK_THROWS_AS(VMP::conditions_of_patches(soup, std::map<int, Patch>{
    { 1, Patch::on_surface(VMP::Implicit_surface_3(Sphere())) }, { 3, Patch::coordinate(2, 2) } }), VMP::Input_error);
}

TEST_CASE("The gradient is that of the energy after vertices are put back on their surface")
{
  VMP::internal::Numbered_mesh_3 mesh = cube_mesh(3, 0.1);
  for(Eigen::Index v = 0; v < mesh.source.cols(); ++v)
    if(const Vector3d p = mesh.source.col(v) * (2. / 3) - Vector3d::Ones(); !p.isZero(1e-9))
      mesh.target.col(v) = p * (p.cwiseAbs().maxCoeff() / p.norm());
  const std::vector<Condition> conditions(mesh.number_of_prescribed_vertices(),
                                          Condition::on_surface(VMP::Implicit_surface_3(Sphere())));
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag> traits;
  VMP::internal::Linear_solver_of solver(traits);
  VMP::internal::Newton_system_3 system(mesh, VMP::internal::free_vertices(mesh, conditions), solver);
  const VMP::Symmetric_Dirichlet_energy_3 energy;
  const VMP::internal::Cell_energy_of<VMP::Symmetric_Dirichlet_energy_3> cell_energy(energy);
  const auto u = VMP::internal::Matrix3Xd(system.scale() * mesh.target);
  REQUIRE(system.evaluate(cell_energy, u).is_flip_free());
  system.move_from(u);
  std::mt19937 engine;
  for(int i = 0; i < 20; ++i)
  {
    VMP::internal::Matrix3Xd d(3, system.unknowns().size());
    for(Eigen::Index row = 0; row < d.cols(); ++row)
      d.col(row) = random_point(engine);
    system.unknowns().project(d);
    const auto step = system.unknowns().to_vertices(d);
    const double h = 1e-5, slope = system.gradient(cell_energy, u).cwiseProduct(d).sum();
    const double difference = (system.evaluate(cell_energy, system.moved(u, h, step).first).energy
                               - system.evaluate(cell_energy, system.moved(u, -h, step).first).energy) / (2 * h);
    CHECK(slope == Approx(difference).epsilon(1e-6));
  }
}

TEST_CASE("Facets are spoilt that turn over against a surface or intersect each other, if none did at the start")
{
  using VMP::internal::Embedded_boundary_3;
  using VMP::internal::Matrix3Xd;
  VMP::internal::Numbered_mesh_3 mesh;
  mesh.cells = { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } };
  Matrix3Xd apart(3, 8);
  apart << -1, 1, -1, 1, 9, 11, 9, 11,
           -1, 1, 1, -1, 9, 11, 11, 9,
           -1, -1, 1, 1, 9, 9, 11, 11;
  Matrix3Xd turned = apart, through = apart;
  turned.leftCols(4) *= -1;
  through.rightCols(4).array() -= 9.5;

  std::vector<Condition> conditions(8); // free
  const VMP::internal::Unknowns_3 free(conditions);
  std::fill_n(conditions.begin(), 4, Condition::on_surface(VMP::Implicit_surface_3(Sphere())));
  const VMP::internal::Unknowns_3 on_sphere(conditions);

  const Matrix3Xd& normals = apart; // of the sphere
  const Embedded_boundary_3 boundary(mesh, on_sphere, apart);
  CHECK(boundary.spoilt_facets(apart, normals).empty());
  CHECK(boundary.spoilt_facets(turned, -normals).size() == 4);
  CHECK(Embedded_boundary_3(mesh, on_sphere, turned).spoilt_facets(turned, -normals).empty());
  CHECK(Embedded_boundary_3(mesh, free, apart).spoilt_facets(turned, -normals).empty());
  CHECK(boundary.spoilt_facets(through, normals).size() > 2);
  CHECK(boundary.spoilt_facets(through, normals, 1).size() == 2); // one pair
  CHECK(Embedded_boundary_3(mesh, free, through).spoilt_facets(through, normals).empty());
}

} } // namespace of_surfaces
