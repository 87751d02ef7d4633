// Matrices whose memory and alignment depend on no flags.
#include <CGAL/Volume_mesh_parameterization/internal/Support/Dynamic_matrix.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/eigen_decomposition_2.h>

#include "catch.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace {

using CGAL::Volume_mesh_parameterization::internal::length_3;
using Columns = CGAL::Volume_mesh_parameterization::internal::Matrix3Xd;

Eigen::Matrix3Xd numbers(const Eigen::Index n)
{ return Eigen::Matrix3Xd::NullaryExpr(3, n, [](const Eigen::Index i, const Eigen::Index k) { return double(10 * k + i); }); }

} // namespace

TEST_CASE("A dynamic matrix takes expressions of itself that have another size")
{
  Columns a = numbers(7);
  a = a.rightCols(3);
  CHECK(a == numbers(7).rightCols(3));
  a = a.rowwise().reverse();
  CHECK(a.cols() == 3);
  const Columns b = a;
  a = Eigen::Matrix3d::Identity() * a;
  CHECK(a == b);
  a = a.leftCols(0);
  CHECK(a.size() == 0);
}

TEST_CASE("A dynamic matrix is copied, moved and exchanged with its numbers")
{
  Columns a = numbers(5), b = a;
  const double* const data = a.data();
  b(0, 0) = -1;
  CHECK(a == numbers(5));
  Columns c = std::move(a);
  CHECK(c.data() == data);
  CHECK(c == numbers(5));
  std::swap(b, c);
  CHECK(b.data() == data);
  CHECK(c(0, 0) == -1);
  c = std::as_const(c);
  CHECK(c(0, 0) == -1);
  c.resize(3, 9);
  CHECK(c.cols() == 9);
  CHECK(reinterpret_cast<std::uintptr_t>(c.data()) % 64 == 0);
}

TEST_CASE("The length of a vector neither overflows nor underflows, and is infinite or no number where an entry is")
{
  constexpr double infinity = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  for(const double scale : { 1e-300, 1., 1e300 })
    CHECK(std::abs(length_3({ 2 * scale, -3 * scale, 6 * scale }) / (7 * scale) - 1) < 1e-15);
  CHECK(length_3({ 0, 0, 0 }) == 0);
  CHECK(length_3({ 1, -infinity, infinity }) == infinity);
  CHECK(std::isnan(length_3({ 0, none, 0 })));
  CHECK(std::isnan(length_3({ 1, 2, none })));
}

TEST_CASE("The product of two matrices has that of each row and column, also if a compiler uses large registers")
{
  using CGAL::Volume_mesh_parameterization::internal::Matrix_3;
  Matrix_3 (* volatile product)(const Matrix_3&, const Matrix_3&) // volatile: not joined with the rest of this function
    = [](const Matrix_3& A, const Matrix_3& B) { return A * B; };
  for(const int n : { 3, 4, 5 })
  {
    const Eigen::Matrix3d A = numbers(n).rightCols(3), B = numbers(n).leftCols(3).transpose(); // of integers: exact
    CHECK(Eigen::Matrix3d(product(A, B)) == A * B);
  }
}

TEST_CASE("The eigenvectors of a symmetric matrix of two rows belong to its eigenvalues, whatever its scale is")
{
  using CGAL::Volume_mesh_parameterization::internal::Small_matrix;
  const double scale = GENERATE(1., 1e-200, 1e200);
  const auto numbers_of_matrix = GENERATE(std::array{ 2., 1., 3. }, std::array{ 1., 0., 5. }, std::array{ 5., 0., 1. },
                                          std::array{ -1., 4., -1. }, std::array{ 2., 0., 2. });
  const auto [a, b, c] = numbers_of_matrix;
  Small_matrix<2, 2> A;
  A << a, b, b, c;
  const auto [values, vectors] = CGAL::Volume_mesh_parameterization::internal::eigen_decomposition_2(scale * A);
  CHECK(values[0] <= values[1]);
  CHECK((vectors.transpose() * vectors).isIdentity(1e-14));
  CHECK((vectors * (values / scale).asDiagonal() * vectors.transpose()).isApprox(A, 1e-14));
}
