// Boundary vertices that slide in planes and along edges of the target.
#include "catch.h"
#include "complex_checks.h"
#include "cube_complex.h"
#include "cube_mesh.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Sliding_boundary_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Complex = Cube_complex<>;
using Eigen::Matrix3d;
using CGAL::Volume_mesh_parameterization::internal::Matrix3Xd;
using Eigen::Vector3d;
using VMP::Parameterization_result;
using VMP::internal::Numbered_mesh_3;
using VMP::internal::Sliding_boundary_3;

namespace {

constexpr int n = 4;
constexpr std::size_t number_of_boundary_vertices = 98, number_of_corners = 8;

// Moves the points of the cube [0, n]^3, but leaves each face, each edge and each corner in place.
Vector3d stir(const Vector3d& p)
{
  Vector3d q;
  for(int i = 0; i < 3; ++i)
    q[i] = p[i] + 0.1 * p[i] * (n - p[i]) * std::sin(1 + p[(i + 1) % 3] + 2 * p[(i + 2) % 3]);
  return q;
}

// A box that is no cube, with sides that binary numbers do not hold.
const Vector3d sides(0.2, 0.1, 0.05), origin(-0.7, 1. / 3, 0);
Vector3d box(const Vector3d& p) { return sides.cwiseProduct(p) + origin; }

const Matrix3d oblique = Eigen::AngleAxisd(1, Vector3d(1, 2, 3).normalized()).toRotationMatrix();

template <typename Function>
Numbered_mesh_3 stirred_cube(const Function& f, const double jitter = 0)
{
  return mapped_cube(n, jitter, [&](const Vector3d& p) -> Vector3d { return f(stir(p)); });
}

struct Options
{
  bool do_slide = true;
  VMP::Boundary_mode mode = VMP::Boundary_mode::AUTO;
  Complex::Vertex_handle constrained_vertex = nullptr;
};

Parameterization_result slide(Complex& complex, const Options& options = Options())
{
  const auto is_constrained = [&](const Complex::Vertex_handle v) { return v == options.constrained_vertex; };
  return CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(complex.c3t3), complex.uvw_map(),
    params::boundary_map(complex.boundary_map())
           .vertex_is_constrained_map(boost::make_function_property_map<Complex::Vertex_handle>(is_constrained))
           .boundary_mode(options.mode)
           .do_slide_boundary(options.do_slide));
}

Matrix3Xd image(const Complex& complex)
{
  Matrix3Xd result(3, complex.mesh.number_of_vertices());
  for(Eigen::Index v = 0; v < result.cols(); ++v)
    for(int i = 0; i < 3; ++i)
      result(i, v) = complex.uvw.at(complex.vertices[v])[i];
  return result;
}

using Condition = VMP::Vertex_condition_3;

Sliding_boundary_3 sliding_boundary(Numbered_mesh_3& mesh)
{
  mesh.sliding_conditions.assign(mesh.number_of_prescribed_vertices(), Condition::in_boundary());
  return Sliding_boundary_3(mesh);
}

std::size_t number_of_sliding_vertices(Numbered_mesh_3 mesh) { return sliding_boundary(mesh).number_of_sliding_vertices(); }

std::size_t number_of_vertices_on_surfaces(Numbered_mesh_3 mesh)
{
  const std::vector<Condition> conditions = sliding_boundary(mesh).conditions();
  return static_cast<std::size_t>(std::count_if(conditions.begin(), conditions.end(),
                                                [](const Condition& condition) { return condition.is_sliding(); }));
}

// The mean of 1/s_1^2 + 1/s_2^2 + 1/s_3^2, which is |J^{-1}|^2, with both meshes scaled to one volume.
double mean_stretch(const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  double sum = 0, source = 0, target = 0;
  for(const std::array<int, 4>& cell : mesh.cells)
  {
    const Matrix3d X = VMP::internal::edge_matrix(mesh.source, cell), U = VMP::internal::edge_matrix(u, cell);
    sum += (X * U.inverse()).squaredNorm();
    source += X.determinant();
    target += U.determinant();
  }
  return sum / static_cast<double>(mesh.cells.size()) * std::pow(target / source, 2. / 3);
}

} // namespace

TEST_CASE("A stirred boundary slides back to the affine map")
{
  const auto turned_box = [](const Vector3d& p) -> Vector3d { return oblique * box(p); };
  const auto check = [](const auto& f, const VMP::Boundary_mode mode)
  {
    Complex complex(stirred_cube(f));
    const Parameterization_result result = slide(complex, {true, mode});
    CHECK(result.status == VMP::OK);
    CHECK(result.boundary_residual == 0);
    CHECK(result.number_of_sliding_vertices == number_of_boundary_vertices - number_of_corners);
    CHECK(result.energy == Approx(0.25 + 1 + 4)); // the energy of a box with sides 2, 1 and 1/2
    const Matrix3Xd u = image(complex);
    for(int v = 0; v < complex.mesh.number_of_vertices(); ++v)
      CHECK((u.col(v) - f(complex.mesh.source.col(v))).norm() < 1e-4);
  };
  check(box, VMP::Boundary_mode::FIXED);
  check(box, VMP::Boundary_mode::SOFT);
  check(turned_box, VMP::Boundary_mode::FIXED);
}

TEST_CASE("Vertices keep their planes bit by bit, and their order along edges")
{
  Numbered_mesh_3 mesh = stirred_cube(box, 0.15);
  for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
    if(mesh.target(2, v) == 0)
      mesh.target(2, v) = -0.;
  Complex complex(mesh);
  REQUIRE(slide(complex).status == VMP::OK);
  CHECK(has_positive_cells(complex.c3t3, [&](const auto v) { return complex.uvw.at(v); }));

  const Matrix3Xd u = image(complex);
  double largest_move = 0;
  for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
  {
    largest_move = (std::max)(largest_move, (u.col(v) - mesh.target.col(v)).norm());
    for(int i = 0; i < 3; ++i)
    {
      const double x = mesh.source(i, v);
      if(x == 0 || x == n)
        CHECK((u(i, v) == mesh.target(i, v) && std::signbit(u(i, v)) == std::signbit(mesh.target(i, v))));
      else
        CHECK((box(Vector3d::Zero())[i] < u(i, v) && u(i, v) < box(Vector3d::Constant(n))[i]));
    }
    for(int w = mesh.number_of_free_vertices; w < mesh.number_of_vertices(); ++w)
      for(int i = 0; i < 3; ++i)
        if(mesh.source.col(w) - mesh.source.col(v) == Vector3d(Vector3d::Unit(i))
           && std::fmod(mesh.source((i + 1) % 3, v), n) == 0 && std::fmod(mesh.source((i + 2) % 3, v), n) == 0)
          CHECK(u(i, v) < u(i, w));
  }
  CHECK(largest_move > 0.01);
}

TEST_CASE("The result is a minimum among all maps that slide")
{
  Complex complex(stirred_cube(box, 0.15));
  const Parameterization_result fixed = slide(complex, {false});
  CHECK(fixed.number_of_sliding_vertices == 0);
  const Parameterization_result result = slide(complex);
  CHECK(result.energy < 0.99 * fixed.energy);

  const Numbered_mesh_3& mesh = complex.mesh;
  const Matrix3Xd u = image(complex);
  const double energy = mean_stretch(mesh, u);
  CHECK(energy == Approx(result.energy));
  std::mt19937 engine;
  std::uniform_real_distribution<double> noise(-1, 1);
  for(int k = 0; k < 50; ++k)
  {
    Matrix3Xd direction = Matrix3Xd::NullaryExpr(3, u.cols(), [&]() { return 1e-4 * noise(engine); });
    for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
      for(int i = 0; i < 3; ++i)
        if(mesh.source(i, v) == 0 || mesh.source(i, v) == n)
          direction(i, v) = 0;
    CHECK(mean_stretch(mesh, u + direction) > energy);
  }
}

TEST_CASE("Constrained vertices of the boundary stay")
{
  Complex complex(stirred_cube(box));
  const auto constrained = std::find_if(complex.target.begin(), complex.target.end(), [](const auto& entry)
                                        { return entry.first->point() == Complex::Point_3(0, 1, 2); });
  REQUIRE(constrained != complex.target.end());
  const Parameterization_result result = slide(complex, {true, VMP::Boundary_mode::AUTO, constrained->first});
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_sliding_vertices == number_of_boundary_vertices - number_of_corners - 1);
  CHECK(result.energy > 5.2502);
  CHECK(has_same_bits(constrained->second, complex.uvw.at(constrained->first)));
}

TEST_CASE("Vertices slide by their conditions, too, also beside others that are in planes")
{
  const auto map = [](Complex& complex, const std::function<Condition(const Complex::Point_3&)>& condition)
  {
    std::unordered_map<Complex::Vertex_handle, Condition> conditions;
    for(const auto& entry : complex.target)
      conditions.emplace(entry.first, condition(entry.first->point()));
    return CGAL::stretch_minimizing_volume_parameterization(
      std::as_const(complex.c3t3), complex.uvw_map(),
      params::boundary_map(complex.boundary_map()).energy(VMP::Symmetric_Dirichlet_energy_3())
             .vertex_condition_map(VMP::make_vertex_condition_map(std::as_const(conditions))));
  };
  const auto turned_box = [](const Vector3d& p) -> Vector3d { return oblique * (box(p) + Vector3d(0.7, 0, 0)); };
  Complex fixed(stirred_cube(turned_box)), sliding(stirred_cube(turned_box)), by_option(stirred_cube(turned_box));
  const double energy = map(fixed, [](const auto&) { return Condition::at_target(); }).energy;
  const Parameterization_result result = map(sliding, [](const auto&) { return Condition::in_boundary(); });
  CHECK(result.energy < 0.99 * energy);
  CHECK(result.number_of_sliding_vertices == number_of_boundary_vertices - number_of_corners);
  CHECK(result.energy == CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(by_option.c3t3), by_option.uvw_map(),
    params::boundary_map(by_option.boundary_map()).energy(VMP::Symmetric_Dirichlet_energy_3())
           .do_slide_boundary(true)).energy);
  CHECK(image(sliding) == image(by_option));

  // the top keeps its height, and vertices of the walls next to it stay
  Complex mixed(stirred_cube(box));
  REQUIRE(map(mixed, [](const auto& p) { return p.z() == n ? Condition::in_plane(0, 0, 1) : Condition::in_boundary(); }).status
          == VMP::OK);
  CHECK(has_positive_cells(mixed.c3t3, [&](const auto v) { return mixed.uvw.at(v); }));
  const Matrix3Xd u = image(mixed);
  double largest_move = 0;
  for(int v = mixed.mesh.number_of_free_vertices; v < mixed.mesh.number_of_vertices(); ++v)
  {
    const Vector3d p = mixed.mesh.source.col(v), q = mixed.mesh.target.col(v);
    for(int i = 0; i < 3; ++i)
      if((p[i] == 0 || p[i] == n) && (p[2] < n || i == 2))
        CHECK(u(i, v) == q[i]);
    if(p[2] == n - 1)
      CHECK(u.col(v) == q);
    largest_move = (std::max)(largest_move, p[2] < n ? (u.col(v) - q).norm() : 0);
  }
  CHECK(largest_move > 1e-3);
}

TEST_CASE("Vertices of curved regions slide on the triangles of the target, and on the curves between patches")
{
  // a ball has only such vertices, and a twisted cube has two planar regions
  const auto ball = [](const Vector3d& p) -> Vector3d { return (p - Vector3d::Constant(n / 2.)).normalized(); };
  CHECK(number_of_sliding_vertices(mapped_cube(n, 0, ball)) == number_of_boundary_vertices);
  CHECK(number_of_vertices_on_surfaces(mapped_cube(n, 0, ball)) == number_of_boundary_vertices);
  const std::size_t number = number_of_vertices_on_surfaces(twisted_cube(n)), number_in_planes = 2 * (n - 1) * (n - 1);
  CHECK(number >= number_of_boundary_vertices - number_in_planes - 3 * number_of_corners);
  CHECK(number <= number_of_boundary_vertices - number_in_planes - number_of_corners);

  Complex complex(twisted_cube(n)), fixed(twisted_cube(n));
  const Parameterization_result result = slide(complex);
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_sliding_vertices == number + number_in_planes);
  CHECK(result.energy < slide(fixed, {false}).energy);
  std::vector<std::array<double, 3> > points;
  std::vector<std::array<std::size_t, 3> > triangles;
  for(Eigen::Index v = 0; v < complex.mesh.target.cols(); ++v)
    points.push_back(VMP::internal::coordinates(complex.mesh.target.col(v)));
  for(const auto& [u, v, w] : VMP::internal::boundary_facets_3(complex.mesh.cells))
    triangles.push_back({ std::size_t(u), std::size_t(v), std::size_t(w) });
  const VMP::Triangulated_surface_3 surface(points, triangles);
  const Matrix3Xd u = image(complex);
  for(int v = complex.mesh.number_of_free_vertices; v < complex.mesh.number_of_vertices(); ++v)
  {
    const std::array<double, 3> p = VMP::internal::coordinates(u.col(v)), q = surface.nearest_point(p).point;
    CHECK(Vector3d(q[0] - p[0], q[1] - p[1], q[2] - p[2]).norm() < 1e-13);
  }
}

TEST_CASE("Vertices of curved patches slide from the minimum with fixed boundary, those of planar ones at once")
{
  struct Visitor
  {
    std::vector<std::string> attempts = {};
    std::vector<double> energies = {}; // at the end of each attempt

    bool after_step(const VMP::Parameterization_step& step)
    {
      if(attempts.empty() || attempts.back() != step.attempt)
      {
        attempts.push_back(step.attempt);
        energies.push_back(0);
      }
      energies.back() = step.energy;
      return true;
    }
  };
  const auto visitor_of = [](const Numbered_mesh_3& mesh)
  {
    Complex complex(mesh);
    Visitor visitor;
    CHECK(CGAL::stretch_minimizing_volume_parameterization(
      std::as_const(complex.c3t3), complex.uvw_map(),
      params::boundary_map(complex.boundary_map()).visitor(std::ref(visitor)).do_slide_boundary(true)).status == VMP::OK);
    return visitor;
  };
  Complex fixed(twisted_cube(n));
  const Visitor curved = visitor_of(fixed.mesh);
  REQUIRE(curved.attempts.size() >= 2);
  CHECK(curved.attempts.back() == "sliding boundary");
  CHECK(curved.energies[curved.energies.size() - 2] == Approx(slide(fixed, {false}).energy).epsilon(1e-9));
  const std::vector<std::string> planar = visitor_of(stirred_cube(box)).attempts;
  CHECK(std::count(planar.begin(), planar.end(), "minimization") == 0);
}

TEST_CASE("Curved walls that intersect each other are told if vertices slide on them")
{
  const auto map_to_ring = [](const double angle)
  {
    constexpr int length = 7;
    Complex complex(mapped_cube(length, 0, [&](const Vector3d& p) -> Vector3d
    {
      const double r = 2 + p[1] / length, phi = (angle * p[0] + 0.3 * p[2]) / length; // a twist bends all faces but two
      return Vector3d(r * std::sin(phi), r * std::cos(phi), p[2] / length);
    }));
    return slide(complex);
  };
  const Parameterization_result open = map_to_ring(5), overlapping = map_to_ring(6.5);
  CHECK(open.has_valid_map);
  CHECK(!open.boundary_crosses_itself);
  CHECK(overlapping.has_valid_map);
  CHECK(overlapping.boundary_crosses_itself);
  CHECK(overlapping.message.find("the map is not one to one") != std::string::npos);
}

TEST_CASE("Planes are recognized in spite of rounding, but not of bumps")
{
  const auto rounded_cube = [](const double unit)
  {
    return mapped_cube(n, 0, [&](const Vector3d& p) -> Vector3d
    {
      return (oblique * p / unit).array().round() * unit;
    });
  };
  CHECK(number_of_sliding_vertices(rounded_cube(1e-15)) == number_of_boundary_vertices - number_of_corners);
  CHECK(number_of_sliding_vertices(rounded_cube(1e-7)) == number_of_boundary_vertices - number_of_corners);
  CHECK(number_of_vertices_on_surfaces(rounded_cube(1e-7)) == 0);
  CHECK(number_of_vertices_on_surfaces(rounded_cube(1e-5)) == number_of_boundary_vertices - number_of_corners);
}

TEST_CASE("The normals of planes along the axes have no rounding error")
{
  for(int k = 1; k <= 100; ++k)
  {
    const Numbered_mesh_3 mesh = mapped_cube(2, 0, [&](const Vector3d& p) -> Vector3d { return p / k + origin; });
    const auto facets = VMP::internal::boundary_facets_3(mesh.cells);
    const VMP::internal::Planar_regions_3 regions(mesh.target, facets, 0);
    for(std::size_t f = 0; f < facets.size(); ++f)
      CHECK(Vector3d(regions.normal(regions.region(f))).cwiseAbs().sum() == 1);
  }
}

TEST_CASE("A vertex outside its plane or a facet turned over is found")
{
  Numbered_mesh_3 mesh = cube_mesh(n);
  const Sliding_boundary_3 boundary = sliding_boundary(mesh);
  const auto vertex_at = [&](const Vector3d& p)
  {
    Eigen::Index v;
    (mesh.source.colwise() - p).colwise().norm().minCoeff(&v);
    return v;
  };
  const Eigen::Index in_face = vertex_at(Vector3d(0, 2, 2)), on_edge = vertex_at(Vector3d(0, 0, 2));
  const auto residual = [&](const Matrix3Xd& u) { return evaluated_map(mesh, u, boundary.conditions()).distance_to_boundary; };
  CHECK(residual(mesh.target) == 0);
  CHECK(boundary.has_same_orientations(mesh.target));

  Matrix3Xd u = mesh.target;
  u.col(in_face) += Vector3d(0, 0.1, 0.2);
  u.col(on_edge) += Vector3d(0, 0, 0.3);
  CHECK(residual(u) == 0);
  CHECK(boundary.has_same_orientations(u));
  u(0, in_face) = 1e-300;
  CHECK(residual(u) > 0);
  u(1, on_edge) = 0.25;
  CHECK(residual(u) == 0.25);
  u = snapped(mesh, u, boundary.conditions());
  CHECK(u.col(in_face) == Vector3d(0, 2.1, 2.2));
  CHECK(u.col(on_edge) == Vector3d(0, 0, 2.3));

  u(2, on_edge) = 3.5; // beyond the next vertex of the edge
  CHECK(residual(u) == 0);
  CHECK(!boundary.has_same_orientations(u));
}
