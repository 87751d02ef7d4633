// The block matrix and its pattern, and the solvers of Newton systems against dense algebra.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Eigen_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Unknowns_3.h>
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
#  include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#endif

#include <CGAL/tags.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::MatrixXd;
using Eigen::VectorXd;
using VMP::Linear_solver_status;

namespace {

using Solvers = std::tuple<VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double>,
                           VMP::Conjugate_gradient_solver_traits_3<CGAL::Parallel_if_available_tag, double>,
                           VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, float>,
                           VMP::Eigen_solver_traits_3<>,
                           VMP::Eigen_solver_traits_3<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> > >
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
                           , VMP::CHOLMOD_solver_traits_3
#endif
                           >;

template <typename NT>
VMP::Block_sparse_matrix_3<NT> pattern(const VMP::internal::Numbered_mesh_3& mesh)
{
  auto [row_begin, columns] = VMP::internal::sparsity_pattern_3(mesh, VMP::internal::free_vertices(mesh));
  VMP::Block_sparse_matrix_3<NT> A;
  A.set_pattern(std::move(row_begin), std::move(columns));
  return A;
}

// Random symmetric entries in [-1, 1], plus `diagonal` on the diagonal.
template <typename NT>
void fill(VMP::Block_sparse_matrix_3<NT>& A, const double diagonal, const unsigned int seed = 0)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<NT> distribution(-1, 1);
  for(int row = 0; row < A.size(); ++row)
    for(int k = A.row_begin(row); k < A.row_end(row); ++k)
      if(A.column(k) >= row)
      {
        Eigen::Matrix<NT, 3, 3> block;
        for(NT& x : block.reshaped())
          x = distribution(engine);
        if(A.column(k) == row)
          block = ((block + block.transpose()) / 2 + NT(diagonal) * block.Identity()).eval();
        A.block(k) = block;
        A.block(A.position(A.column(k), row)) = block.transpose();
      }
}

template <typename NT>
MatrixXd dense(const VMP::Block_sparse_matrix_3<NT>& A)
{
  MatrixXd D = MatrixXd::Zero(3 * A.size(), 3 * A.size());
  for(int row = 0; row < A.size(); ++row)
    for(int k = A.row_begin(row); k < A.row_end(row); ++k)
      D.block<3, 3>(3 * row, 3 * A.column(k)) = A.block(k).template cast<double>();
  return D;
}

template <typename NT>
VectorXd product(const VMP::Block_sparse_matrix_3<NT>& A, const VectorXd& x)
{
  VectorXd result = VectorXd::Zero(3 * A.size());
  for(int row = 0; row < A.size(); ++row)
    for(int k = A.row_begin(row); k < A.row_end(row); ++k)
      result.segment<3>(3 * row) += A.block(k).template cast<double>() * x.segment<3>(3 * A.column(k));
  return result;
}

VectorXd random_vector(const Eigen::Index size)
{
  std::mt19937 engine;
  std::normal_distribution<double> distribution;
  return VectorXd::NullaryExpr(size, [&]() { return distribution(engine); });
}

// Above the sum of the absolute values of a row: each vertex has at most 14 neighbors.
constexpr double dominant_diagonal = 50;

} // namespace

TEST_CASE("The pattern holds the pairs of free vertices that share a cell")
{
  const VMP::internal::Numbered_mesh_3 mesh = cube_mesh(4);
  std::set<std::pair<int, int> > expected;
  for(const std::array<int, 4>& cell : mesh.cells)
    for(const int v : cell)
      for(const int w : cell)
        if(mesh.is_free(v) && mesh.is_free(w))
          expected.emplace(v, w);

  const auto A = pattern<double>(mesh);
  REQUIRE(A.size() == 27);
  std::vector<std::pair<int, int> > actual;
  for(int row = 0; row < A.size(); ++row)
    for(int k = A.row_begin(row); k < A.row_end(row); ++k)
    {
      actual.emplace_back(row, A.column(k));
      CHECK(A.position(row, A.column(k)) == k);
    }
  CHECK(actual == std::vector<std::pair<int, int> >(expected.begin(), expected.end()));
}

TEST_CASE("The pattern has the pairs of a group, too, and rows for unknown vertices only")
{
  const VMP::internal::Numbered_mesh_3 mesh = cube_mesh(4);
  const auto is_unknown = [](const int v) { return v % 2 == 0; };
  const VMP::internal::Unknowns_3 unknowns(mesh.number_of_vertices(), is_unknown);
  REQUIRE(unknowns.size() == 63);
  const int last = mesh.number_of_vertices() - 1; // shares no cell with the first vertex
  std::set<std::pair<int, int> > expected;
  for(const std::array<int, 4>& cell : mesh.cells)
    for(const int v : cell)
      for(const int w : cell)
        if(is_unknown(v) && is_unknown(w))
          expected.emplace(v / 2, w / 2);
  REQUIRE(expected.emplace(0, unknowns.row(last)).second);
  REQUIRE(expected.emplace(unknowns.row(last), 0).second);

  const VMP::internal::Sparsity_pattern_3 pattern
    = VMP::internal::sparsity_pattern_3(mesh, unknowns, {{0, 1, last}}); // 1 is not unknown
  REQUIRE(pattern.row_begin.size() == 64);
  std::vector<std::pair<int, int> > actual;
  for(int row = 0; row < unknowns.size(); ++row)
    for(int k = pattern.row_begin[row]; k < pattern.row_begin[row + 1]; ++k)
    {
      actual.emplace_back(row, pattern.columns[k]);
      CHECK(pattern.position(row, pattern.columns[k]) == k);
    }
  CHECK(actual == std::vector<std::pair<int, int> >(expected.begin(), expected.end()));
}

TEMPLATE_TEST_CASE("Products of a row agree with the dense matrix", "", float, double)
{
  auto A = pattern<TestType>(cube_mesh(4));
  fill(A, 0);
  const Eigen::Matrix<TestType, Eigen::Dynamic, 1> x = random_vector(3 * A.size()).template cast<TestType>();
  const VectorXd expected = dense(A) * x.template cast<double>();
  const double tolerance = 100 * std::numeric_limits<TestType>::epsilon();
  for(int row = 0; row < A.size(); ++row)
    CHECK((A.multiply_row(row, x.data()).template cast<double>() - expected.segment<3>(3 * row)).norm() <= tolerance);
}

TEST_CASE("Scaling the diagonal changes the diagonal blocks only")
{
  auto A = pattern<double>(cube_mesh(3));
  fill(A, 1);
  MatrixXd expected = dense(A);
  for(int v = 0; v < A.size(); ++v)
    expected.block<3, 3>(3 * v, 3 * v) *= 1.25;
  A.scale_diagonal(0.25);
  CHECK((dense(A) - expected).norm() == 0);
  for(int row = 0; row < A.size(); ++row)
    A.set_zero(row);
  CHECK(dense(A).norm() == 0);
}

TEMPLATE_LIST_TEST_CASE("A system without unknowns is solved", "", Solvers)
{
  const auto A = pattern<typename TestType::NT>(cube_mesh(1));
  REQUIRE(A.size() == 0);
  TestType solver;
  solver.analyze_pattern(A);
  CHECK(solver.factorize(A) == Linear_solver_status::SUCCESS);
  VectorXd x;
  CHECK(solver.solve(VectorXd(0), x, 1e-2) == Linear_solver_status::SUCCESS);
  CHECK(x.size() == 0);
}

TEMPLATE_LIST_TEST_CASE("A positive definite system is solved, also with new values", "", Solvers)
{
  using NT = typename TestType::NT;
  const double tolerance = 100 * std::numeric_limits<NT>::epsilon();
  for(const int n : {2, 5, 9}) // 1, 64 and 512 free vertices
  {
    auto A = pattern<NT>(cube_mesh(n));
    const VectorXd b = random_vector(3 * A.size());
    TestType solver;
    solver.analyze_pattern(A);
    for(const unsigned int seed : {1, 2})
    {
      fill(A, dominant_diagonal, seed);
      REQUIRE(solver.factorize(A) == Linear_solver_status::SUCCESS);
      VectorXd x;
      REQUIRE(solver.solve(b, x, tolerance) == Linear_solver_status::SUCCESS);
      CHECK((product(A, x) - b).norm() <= 2 * tolerance * b.norm());
    }
  }
}

TEMPLATE_LIST_TEST_CASE("The solution is that of a dense factorization", "", Solvers)
{
  using NT = typename TestType::NT;
  auto A = pattern<NT>(cube_mesh(4));
  fill(A, 8); // positive definite, but not dominated by the diagonal
  const Eigen::LLT<MatrixXd> llt(dense(A));
  REQUIRE(llt.info() == Eigen::Success);
  const VectorXd b = random_vector(3 * A.size());

  TestType solver;
  solver.analyze_pattern(A);
  REQUIRE(solver.factorize(A) == Linear_solver_status::SUCCESS);
  VectorXd x;
  REQUIRE(solver.solve(b, x, 100 * std::numeric_limits<NT>::epsilon()) == Linear_solver_status::SUCCESS);
  CHECK((x - llt.solve(b)).norm() <= 1e4 * std::numeric_limits<NT>::epsilon() * x.norm());
}

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
TEST_CASE("The entries of a lower triangle are counted before any are written, beyond what an int holds")
{
  using VMP::internal::number_of_entries_of_lower_triangle;
  const auto A = pattern<double>(cube_mesh(4));
  std::size_t number = 0;
  for(int row = 0; row < A.size(); ++row)
    for(int k = A.row_begin(row); k < A.row_end(row); ++k)
      number += A.column(k) > row ? 9 : A.column(k) == row ? 6 : 0;
  CHECK(number_of_entries_of_lower_triangle(A.size(), A.row_end(A.size() - 1)) == number);
  CHECK(number_of_entries_of_lower_triangle(100000000, 1500000000) == 6900000000);
}
#endif

TEMPLATE_LIST_TEST_CASE("An indefinite matrix is reported, and the solver stays usable", "", Solvers)
{
  auto A = pattern<typename TestType::NT>(cube_mesh(5));
  TestType solver;
  solver.analyze_pattern(A);
  const VectorXd b = random_vector(3 * A.size());

  for(const double diagonal : {-dominant_diagonal, 1., 3.}) // negative definite to slightly indefinite
  {
    fill(A, diagonal);
    REQUIRE(Eigen::LLT<MatrixXd>(dense(A)).info() != Eigen::Success);
    Linear_solver_status status = solver.factorize(A);
    VectorXd x;
    if(status == Linear_solver_status::SUCCESS)
      status = solver.solve(b, x, 1e-6);
    INFO("diagonal " << diagonal);
    CHECK((status == Linear_solver_status::NOT_POSITIVE_DEFINITE || status == Linear_solver_status::TRUNCATED));
    if(status == Linear_solver_status::TRUNCATED)
      CHECK(b.dot(x) > 0); // a direction of descent of the quadratic function with gradient -b at 0
  }

  fill(A, dominant_diagonal);
  CHECK(solver.factorize(A) == Linear_solver_status::SUCCESS);
  VectorXd x;
  CHECK(solver.solve(b, x, 1e-4) == Linear_solver_status::SUCCESS);
  CHECK((dense(A) * x - b).norm() <= 2e-4 * b.norm());
}

TEST_CASE("Conjugate gradients truncate at negative curvature after some iterations")
{
  auto A = pattern<double>(cube_mesh(5));
  fill(A, dominant_diagonal);
  A.block(A.position(17, 17)).diagonal()[0] = -1;
  const VectorXd b = random_vector(3 * A.size());
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double> solver;
  solver.analyze_pattern(A);
  REQUIRE(solver.factorize(A) == Linear_solver_status::SUCCESS);
  VectorXd x;
  CHECK(solver.solve(b, x, 1e-10) == Linear_solver_status::TRUNCATED);
  CHECK(solver.number_of_iterations() > 0);
  CHECK(b.dot(x) > 0);
}

TEST_CASE("Conjugate gradients do not stand still where a block is singular up to rounding")
{
  VMP::internal::Numbered_mesh_3 mesh = cube_mesh(2); // one free vertex
  VMP::Block_sparse_matrix_3<float> A = pattern<float>(mesh);
  REQUIRE(A.size() == 1);
  std::mt19937 engine(0);
  std::uniform_real_distribution<double> distribution(-1, 1);
  const auto random_vector = [&]() -> Eigen::Vector3d
  {
    return Eigen::Vector3d::NullaryExpr([&]() { return distribution(engine); });
  };
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, float> solver;
  solver.analyze_pattern(A);
  int number_of_successes = 0;
  for(int i = 0; i < 10000; ++i)
  {
    const Eigen::Vector3d n = random_vector(), b = random_vector(), m = random_vector();
    A.block(0) = (1e10 * n * n.transpose() + 10 * m * m.transpose()).cast<float>();
    REQUIRE(solver.factorize(A) == Linear_solver_status::SUCCESS);
    VectorXd x;
    if(solver.solve(b, x, 1e-2) == Linear_solver_status::SUCCESS)
    {
      ++number_of_successes;
      CHECK(!x.isZero(0));
    }
  }
  CHECK(number_of_successes > 100);
}

TEST_CASE("Conjugate gradients stop early for a large tolerance, and at the limit")
{
  auto A = pattern<double>(cube_mesh(5));
  fill(A, 9);
  const VectorXd b = random_vector(3 * A.size());
  const auto iterations = [&](const int limit, const double tolerance, const Linear_solver_status expected)
  {
    VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double> solver(limit);
    solver.analyze_pattern(A);
    solver.factorize(A);
    VectorXd x;
    CHECK(solver.solve(b, x, tolerance) == expected);
    CHECK(b.dot(x) > 0);
    return solver.number_of_iterations();
  };
  const int precise = iterations(2000, 1e-10, Linear_solver_status::SUCCESS);
  CHECK(iterations(2000, 1e-2, Linear_solver_status::SUCCESS) < precise);
  CHECK(precise < 100);
  CHECK(iterations(3, 1e-10, Linear_solver_status::ITERATION_LIMIT) == 3);
}

TEST_CASE("Beyond thirty thousand rows, conjugate gradients need fewer iterations, and the same bits with threads")
{
  // the Laplacian of a grid of n^3 points, which are in the order of their cells in halves of halves: without a correction
  // of what is smooth, iterations grow as n
  const auto laplacian = [](const int n)
  {
    std::map<int, std::array<int, 3> > points; // by the bits of their coordinates, in turns
    const auto key_of = [](const std::array<int, 3>& p)
    {
      int result = 0;
      for(int bit = 0; bit < 5; ++bit)
        for(int i = 0; i < 3; ++i)
          result |= (p[i] >> bit & 1) << (3 * bit + i);
      return result;
    };
    for(int x = 0; x < n; ++x)
      for(int y = 0; y < n; ++y)
        for(int z = 0; z < n; ++z)
          points[key_of({x, y, z})] = {x, y, z};
    std::map<int, int> rows;
    for(const auto& [key, p] : points)
      rows.emplace(key, static_cast<int>(rows.size()));
    std::vector<int> row_begin(1, 0), columns;
    for(const auto& [key, p] : points)
    {
      columns.push_back(rows[key]);
      for(int i = 0; i < 3; ++i)
        for(const int step : {-1, 1})
        {
          std::array<int, 3> q = p;
          q[i] += step;
          if(q[i] >= 0 && q[i] < n)
            columns.push_back(rows[key_of(q)]);
        }
      std::sort(columns.begin() + row_begin.back(), columns.end());
      row_begin.push_back(static_cast<int>(columns.size()));
    }
    VMP::Block_sparse_matrix_3<float> A;
    A.set_pattern(row_begin, columns);
    for(int row = 0; row < A.size(); ++row)
      for(int k = A.row_begin(row); k < A.row_end(row); ++k)
        A.block(k) = Eigen::Matrix3f::Identity() * (A.column(k) == row ? 6 : -1);
    return A;
  };
  constexpr double tolerance = 1e-4;
  const auto small = laplacian(31), large = laplacian(32);
  REQUIRE(small.size() < 30000);
  REQUIRE(large.size() > 30000);
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, float> solver;
  VectorXd x;
  const auto iterations = [&](const auto& A)
  {
    solver.analyze_pattern(A);
    REQUIRE(solver.factorize(A) == Linear_solver_status::SUCCESS);
    REQUIRE(solver.solve(VectorXd::Ones(3 * A.size()), x, tolerance) == Linear_solver_status::SUCCESS);
    return solver.number_of_iterations();
  };
  const int without = iterations(small);
  CHECK(iterations(large) < 0.8 * without);

  const Eigen::VectorXf y = x.cast<float>();
  VectorXd residual(x.size());
  for(int row = 0; row < large.size(); ++row)
    residual.segment<3>(3 * row) = large.multiply_row(row, y.data()).cast<double>().array() - 1;
  CHECK(residual.norm() < 1e-2 * std::sqrt(static_cast<double>(x.size())));

  VMP::Conjugate_gradient_solver_traits_3<CGAL::Parallel_if_available_tag, float> parallel;
  VectorXd z;
  parallel.analyze_pattern(large);
  REQUIRE(parallel.factorize(large) == Linear_solver_status::SUCCESS);
  REQUIRE(parallel.solve(VectorXd::Ones(x.size()), z, tolerance) == Linear_solver_status::SUCCESS);
  CHECK(z == x);
}

TEMPLATE_LIST_TEST_CASE("The solution for zero is zero", "", Solvers)
{
  auto A = pattern<typename TestType::NT>(cube_mesh(3));
  fill(A, dominant_diagonal);
  TestType solver;
  solver.analyze_pattern(A);
  solver.factorize(A);
  VectorXd x;
  CHECK(solver.solve(VectorXd::Zero(3 * A.size()), x, 1e-2) == Linear_solver_status::SUCCESS);
  CHECK(x == VectorXd::Zero(3 * A.size()));
}

TEMPLATE_LIST_TEST_CASE("A copy of a solver works by itself", "", Solvers)
{
  auto A = pattern<typename TestType::NT>(cube_mesh(4));
  fill(A, dominant_diagonal);
  const VectorXd b = random_vector(3 * A.size());
  TestType original;
  original.analyze_pattern(A);
  original.factorize(A);

  TestType copy(original);
  copy.analyze_pattern(A);
  REQUIRE(copy.factorize(A) == Linear_solver_status::SUCCESS);
  VectorXd x, y;
  REQUIRE(original.solve(b, x, 1e-5) == Linear_solver_status::SUCCESS);
  REQUIRE(copy.solve(b, y, 1e-5) == Linear_solver_status::SUCCESS);
  CHECK(x == y);
}

TEST_CASE("An iterative solver of Eigen gets the tolerance, and tells that its iterations did not suffice")
{
  auto A = pattern<double>(cube_mesh(5));
  fill(A, 8);
  const VectorXd b = random_vector(3 * A.size());
  VMP::Eigen_solver_traits_3<Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> > solver;
  solver.analyze_pattern(A);
  REQUIRE(solver.factorize(A) == Linear_solver_status::SUCCESS);
  VectorXd x;
  REQUIRE(solver.solve(b, x, 0.5) == Linear_solver_status::SUCCESS);
  const auto few = solver.solver().iterations();
  REQUIRE(solver.solve(b, x, 1e-10) == Linear_solver_status::SUCCESS);
  CHECK(solver.solver().iterations() > few);
  CHECK((dense(A) * x - b).norm() <= 1e-9 * b.norm());

  solver.solver().setMaxIterations(2);
  CHECK(solver.solve(b, x, 1e-10) == Linear_solver_status::ITERATION_LIMIT);
  CHECK(b.dot(x) > 0);
}
