// Hexahedra whose Jacobian determinant is positive all over them.
#include "catch.h"

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/is_positive_hexahedron_3.h>

#include <CGAL/Exact_rational.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <type_traits>
#include <utility>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;
using CGAL::Polycube_meshing_3::internal::Hexahedron_points_3;
using CGAL::Polycube_meshing_3::internal::is_positive_hexahedron_3;
using CGAL::Polycube_meshing_3::internal::jacobian_coefficients_3;

namespace {

constexpr int corners[8][3] = { {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1} };

// The box [-1, 1]^2 x [0, 1], with the square at the top mapped by a matrix A: the determinant is 4 det((1 - z) I + z A).
Hexahedron_points_3<double> cube_with_top(const Eigen::Matrix2d& A)
{
  Hexahedron_points_3<double> result;
  for(std::size_t i = 0; i < 8; ++i)
  {
    const Eigen::Vector2d p(2 * corners[i][0] - 1, 2 * corners[i][1] - 1), q = corners[i][2] == 1 ? Eigen::Vector2d(A * p) : p;
    result[i] = { q[0], q[1], double(corners[i][2]) };
  }
  return result;
}

Eigen::Matrix2d matrix(const double a, const double b, const double c, const double d)
{
  Eigen::Matrix2d result;
  result << a, b, c, d;
  return result;
}

// The determinant of the trilinear map, by the derivatives of its shape functions.
double jacobian(const Hexahedron_points_3<double>& points, const std::array<double, 3>& at)
{
  Eigen::Matrix3d derivatives = Eigen::Matrix3d::Zero();
  for(std::size_t i = 0; i < 8; ++i)
    for(int axis = 0; axis < 3; ++axis)
    {
      double factor = 1;
      for(int k = 0; k < 3; ++k)
        factor *= k == axis ? 2 * corners[i][k] - 1 : corners[i][k] == 1 ? at[k] : 1 - at[k];
      derivatives.col(axis) += factor * Eigen::Vector3d(points[i][0], points[i][1], points[i][2]);
    }
  return derivatives.determinant();
}

Hexahedron_points_3<double> random_hexahedron(std::mt19937& engine, const double size)
{
  std::uniform_real_distribution<double> noise(-size, size);
  Hexahedron_points_3<double> result;
  for(std::size_t i = 0; i < 8; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      result[i][k] = corners[i][k] + noise(engine);
  return result;
}

} // namespace

TEST_CASE("Bernstein coefficients are those of the Jacobian determinant, in numbers and in rationals")
{
  std::mt19937 engine;
  std::uniform_real_distribution<double> unit(0, 1);
  const Hexahedron_points_3<double> points = random_hexahedron(engine, 1);
  const auto coefficients = jacobian_coefficients_3(points);
  for(int round = 0; round < 50; ++round)
  {
    const std::array<double, 3> at = { unit(engine), unit(engine), unit(engine) };
    double value = 0;
    for(std::size_t l = 0; l < 27; ++l)
    {
      double factor = 1;
      for(const auto& [i, t] : { std::make_pair(l / 9, at[0]), std::make_pair(l / 3 % 3, at[1]), std::make_pair(l % 3, at[2]) })
        factor *= i == 0 ? (1 - t) * (1 - t) : i == 1 ? 2 * t * (1 - t) : t * t;
      value += factor * coefficients[l];
    }
    CHECK(value == Approx(jacobian(points, at)).margin(1e-12));
  }
  Hexahedron_points_3<CGAL::Exact_rational> exact;
  for(std::size_t i = 0; i < 8; ++i)
    std::copy(points[i].begin(), points[i].end(), exact[i].begin());
  const auto exact_coefficients = jacobian_coefficients_3(exact);
  for(std::size_t l = 0; l < 27; ++l)
    CHECK(CGAL::to_double(exact_coefficients[l]) == Approx(coefficients[l]).margin(1e-12));
}

TEST_CASE("Hexahedra with positive corners are inverted where the determinant is negative or zero inside")
{
  const double smallest = std::ldexp(1., -15);
  CHECK(is_positive_hexahedron_3(cube_with_top(matrix(1, 0, 0, 1))));
  CHECK(is_positive_hexahedron_3(cube_with_top(matrix(-0.6, -0.8, 0.8, -0.6)))); // negative coefficients, minimum 0.8
  CHECK(is_positive_hexahedron_3(cube_with_top(matrix(-1, -smallest, smallest, -1)))); // minimum near 1e-9
  CHECK_FALSE(is_positive_hexahedron_3(cube_with_top(matrix(-3, 0, 0, -1. / 3)))); // negative for z from 1/4 to 3/4
  CHECK_FALSE(is_positive_hexahedron_3(cube_with_top(matrix(-1, 0, 0, -1)))); // zero for z = 1/2
  CHECK_FALSE(is_positive_hexahedron_3(cube_with_top(matrix(-2, 0, 0, -2)))); // zero for z = 1/3, which no halving meets
  CHECK_FALSE(is_positive_hexahedron_3(cube_with_top(matrix(-1 - smallest, 0, 0, -1)))); // down to -1e-9
  CHECK_FALSE(is_positive_hexahedron_3(cube_with_top(matrix(1, 0, 0, 0)))); // flat corners
  CHECK_FALSE(is_positive_hexahedron_3(cube_with_top(matrix(1, 0, 0, -1))));
}

// Halves along the other axes would multiply, to tens of millions of pieces around the plane z = 1/3.
TEST_CASE("A determinant that is nearly zero on a plane normal to an axis is decided")
{
  for(const double d : { 0.3, 1e-4, 1e-7 }) // minima near 0.04, 4e-9 and, for rationals, 4e-15
    CHECK(is_positive_hexahedron_3(cube_with_top(matrix(-2, -d, d, -2))));
}

// Without a bound, the number of pieces grows with the inverse of the minimum: to 1e12.
TEST_CASE("A polynomial that is nearly zero on any surface is given up")
{
  const auto is_positive = [](const double least, const auto& error) // (x + y + z - 0.9)^2 plus its minimum
  {
    using FT = std::decay_t<decltype(error)>;
    PM::internal::Bernstein_coefficients_3<FT> coefficients;
    for(int l = 0; l < 27; ++l)
    {
      const int i[3] = { l / 9, l / 3 % 3, l % 3 }, sum = i[0] + i[1] + i[2];
      coefficients[l] = FT(sum - 1.8) * FT(sum - 1.8) / 4 + FT(least);
      for(const int k : i)
        coefficients[l] -= FT(k == 1 ? 0.25 : 0); // of a square along an axis
    }
    return PM::internal::is_positive_polynomial_3(coefficients, error).value();
  };
  CHECK(is_positive(0.1, 0.));
  CHECK_FALSE(is_positive(1e-12, 0.));
  CHECK_FALSE(is_positive(1e-12, CGAL::Exact_rational(0)));
}

TEST_CASE("Hexahedra that are flat up to rounding are decided in rationals")
{
  for(const double d : { std::ldexp(1., -50), 0., -std::ldexp(1., -50) })
  {
    Hexahedron_points_3<double> points;
    for(std::size_t i = 0; i < 8; ++i)
    {
      const auto& [x, y, z] = corners[i];
      points[i] = { double(x - y), double(x + y), 5 * x + y + d * z }; // the determinant is 2 d
    }
    CHECK(is_positive_hexahedron_3(points) == (d > 0));
  }
}

TEST_CASE("Hexahedra that are not finite, or points, are not positive")
{
  Hexahedron_points_3<double> points = cube_with_top(matrix(1, 0, 0, 1));
  points[6][2] = std::numeric_limits<double>::infinity();
  CHECK_FALSE(is_positive_hexahedron_3(points));
  points[6][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(is_positive_hexahedron_3(points));
  points.fill({ 1, 2, 3 });
  CHECK_FALSE(is_positive_hexahedron_3(points));
}

TEST_CASE("Random hexahedra are positive where all of many values are")
{
  std::mt19937 engine;
  int numbers[2] = { 0, 0 };
  for(int round = 0; round < 200; ++round)
  {
    const Hexahedron_points_3<double> points = random_hexahedron(engine, 0.45);
    double least = std::numeric_limits<double>::infinity();
    for(int i = 0; i < 9 * 9 * 9; ++i)
      least = (std::min)(least, jacobian(points, { i / 81 / 8., i / 9 % 9 / 8., i % 9 / 8. }));
    const bool is_positive = is_positive_hexahedron_3(points);
    ++numbers[is_positive];
    CHECK((least > 0 || !is_positive));
    CHECK((least < 0.03 || is_positive)); // a second derivative below 8 moves a minimum by 8 / 2 / 16^2 along each axis
  }
  CHECK(numbers[0] > 20);
  CHECK(numbers[1] > 20);
}
