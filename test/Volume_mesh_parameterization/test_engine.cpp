// The engine on plain arrays: sums over the cells, step lengths, untangling and minimization.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/spatial_order_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Fixed_boundary_engine_3.h>
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
#  include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#endif

#include <CGAL/tags.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using VMP::internal::Numbered_mesh_3;

namespace {

template <typename Tag = CGAL::Sequential_tag>
using Solver = VMP::Conjugate_gradient_solver_traits_3<Tag>;

Matrix3Xd noise(const Eigen::Index size, const double amplitude, const unsigned int seed = 0)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> distribution(-amplitude, amplitude);
  return Matrix3Xd::NullaryExpr(3, size, [&]() { return distribution(engine); });
}

template <typename Energy>
double psi(const Energy& energy, const Numbered_mesh_3& mesh, const Matrix3Xd& u, const std::array<int, 4>& cell,
           const double scale = 1)
{
  const Matrix3d J = scale * VMP::internal::edge_matrix(u, cell)
                   * VMP::internal::edge_matrix(mesh.source, cell).inverse();
  Vector3d s = Eigen::JacobiSVD<Matrix3d>(J).singularValues();
  s[2] = std::copysign(s[2], J.determinant());
  return energy.value(s);
}

// The mean over the cells with a free vertex, as the engine has it: both meshes scaled to one volume.
template <typename Energy>
double mean_energy(const Energy& energy, const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  const double scale = std::cbrt(VMP::internal::volume(mesh.source, mesh.cells)
                                 / VMP::internal::volume(mesh.target, mesh.cells));
  double sum = 0;
  for(const std::array<int, 4>& cell : mesh.cells)
    if(*std::min_element(cell.begin(), cell.end()) < mesh.number_of_free_vertices)
      sum += psi(energy, mesh, u, cell, scale);
  return sum / static_cast<double>(mesh.cells.size());
}

std::size_t number_of_inverted_cells(const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  return VMP::internal::inverted_cells(mesh, u).number;
}

bool has_same_bits(const Matrix3Xd& a, const Matrix3Xd& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool has_target_boundary(const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
  return has_same_bits(u.rightCols(n), mesh.target.rightCols(n));
}

template <typename Solver, typename Energy>
auto make_engine(const Numbered_mesh_3& mesh, const Energy& energy, Solver& solver)
{
  return VMP::internal::Fixed_boundary_engine_3<Energy, Solver, CGAL::Sequential_tag>(mesh, energy, solver);
}

struct Outcome
{
  Matrix3Xd positions;
  VMP::Error_code status;
  double energy;
};

template <typename Tag, typename Energy, typename Solver>
Outcome run(const Numbered_mesh_3& mesh, const Energy& energy, Solver solver)
{
  VMP::internal::Fixed_boundary_engine_3<Energy, Solver, Tag> engine(mesh, energy, solver);
  engine.start();
  while(engine.is_running() && engine.last_step().iteration < 1000)
    engine.step();
  return {engine.positions(), engine.status(), engine.last_step().energy};
}

template <typename Energy = VMP::Stretch_energy_3>
Outcome run(const Numbered_mesh_3& mesh, const Energy& energy = Energy())
{
  return run<CGAL::Sequential_tag>(mesh, energy, Solver<>());
}

// The parts of the engine on a mesh with X^{-1} as it is.
struct Parts
{
  VMP::Block_sparse_matrix_3<double> hessian;
  std::vector<double> weights;
  VMP::internal::Cell_packs_3 packs;

  explicit Parts(const Numbered_mesh_3& mesh)
    : hessian(pattern(mesh)), weights(make_weights(mesh)), packs(mesh, inverse_sources(mesh), weights, hessian)
  {}

  static VMP::Block_sparse_matrix_3<double> pattern(const Numbered_mesh_3& mesh)
  {
    VMP::Block_sparse_matrix_3<double> matrix;
    VMP::internal::set_pattern(mesh, {}, matrix);
    return matrix;
  }

  static std::vector<double> make_weights(const Numbered_mesh_3& mesh)
  {
    std::vector<double> weights(mesh.cells.size());
    std::iota(weights.begin(), weights.end(), 1.);
    return weights;
  }

  static std::vector<Matrix3d> inverse_sources(const Numbered_mesh_3& mesh)
  {
    std::vector<Matrix3d> result;
    for(const std::array<int, 4>& cell : mesh.cells)
      result.push_back(VMP::internal::edge_matrix(mesh.source, cell).inverse());
    return result;
  }
};

} // namespace

TEST_CASE("The sum over the cells has the value and the derivatives it should")
{
  const Numbered_mesh_3 mesh = cube_mesh(3, 0.1);
  const Matrix3Xd u = mesh.source + noise(mesh.number_of_vertices(), 0.1);
  const VMP::Stretch_energy_3 energy;
  Parts parts(mesh);
  const VMP::internal::Energy_sum_3<CGAL::Sequential_tag> sum(parts.packs);

  double expected = 0;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    if(*std::min_element(mesh.cells[c].begin(), mesh.cells[c].end()) < mesh.number_of_free_vertices)
      expected += parts.weights[c] * psi(energy, mesh, u, mesh.cells[c]);
  const VMP::internal::Energy_evaluation evaluation = sum.evaluate(energy, u);
  CHECK(evaluation.energy == Approx(expected).epsilon(1e-12));
  CHECK(evaluation.is_flip_free());

  const auto assembled_gradient = [&](const Matrix3Xd& v)
  {
    Matrix3Xd gradient;
    sum.assemble(energy, v, 1., gradient, parts.hessian);
    return gradient;
  };
  const double h = 1e-5;
  const Matrix3Xd gradient = assembled_gradient(u);
  const VMP::Block_sparse_matrix_3<double> hessian = parts.hessian;
  for(int i = 0; i < 3 * mesh.number_of_free_vertices; ++i)
  {
    Matrix3Xd forward = u, backward = u;
    forward(i) += h;
    backward(i) -= h;
    const double difference = (sum.evaluate(energy, forward).energy - sum.evaluate(energy, backward).energy) / (2 * h);
    CHECK(gradient(i) == Approx(difference).margin(1e-7 * gradient.norm()));

    const Matrix3Xd differences = (assembled_gradient(forward) - assembled_gradient(backward)) / (2 * h);
    Matrix3Xd column = Matrix3Xd::Zero(3, mesh.number_of_free_vertices);
    for(int k = hessian.row_begin(i / 3); k < hessian.row_end(i / 3); ++k)
      column.col(hessian.column(k)) = hessian.block(k).row(i % 3).transpose();
    CHECK((column - differences).norm() <= 1e-6 * column.norm());
  }
}

TEST_CASE("Inverted cells are counted")
{
  const Numbered_mesh_3 mesh = cube_mesh(4);
  const Parts parts(mesh);
  const VMP::internal::Energy_sum_3<CGAL::Sequential_tag> sum(parts.packs);
  Matrix3Xd u = mesh.source;
  CHECK(sum.evaluate(VMP::Dirichlet_energy_3(), u).number_of_inverted_cells == 0);
  u.col(0) += Vector3d(0, 0, 1.5);
  const std::size_t expected = number_of_inverted_cells(mesh, u);
  CHECK(expected > 0);
  CHECK(sum.evaluate(VMP::Dirichlet_energy_3(), u).number_of_inverted_cells == expected);
  CHECK(sum.evaluate(VMP::Dirichlet_energy_3(), u).smallest_determinant == Approx(-0.5));
}

TEST_CASE("The largest step is the first root of a determinant")
{
  const Numbered_mesh_3 mesh = cube_mesh(3);
  const Parts parts(mesh);
  for(const double amplitude : {0.01, 0.3, 1., 3., 100.})
    for(const unsigned int seed : {1, 2, 3})
    {
      Matrix3Xd d = noise(mesh.number_of_vertices(), amplitude, seed);
      d.rightCols(mesh.number_of_vertices() - mesh.number_of_free_vertices).setZero();

      double root = 1; // the first of many samples with an inverted cell
      constexpr int samples = 20000;
      for(int i = samples; i > 0; --i)
        for(const std::array<int, 4>& cell : mesh.cells)
          if(!(VMP::internal::edge_matrix(mesh.source + (double(i) / samples) * d, cell).determinant() > 0))
          {
            root = double(i) / samples;
            break;
          }

      const double step = VMP::internal::largest_step_3<CGAL::Sequential_tag>(parts.packs, mesh.source, d);
      INFO("amplitude " << amplitude << ", first root about " << root);
      CHECK(step <= root);
      CHECK(step >= root - 1. / 1024 - 1. / samples);
    }
}

TEST_CASE("The identity and affine maps are recovered on cells of equal volume")
{
  Matrix3d A;
  A << 2, 0.3, 0.1, -0.4, 1, 0.2, 0.5, -0.1, 0.7;
  const Vector3d b(10, -20, 30);
  for(const int n : {2, 3, 4, 6})
    for(const Matrix3d& linear : {Matrix3d(Matrix3d::Identity()), A, Matrix3d(1e-5 * A), Matrix3d(1e5 * A)})
    {
      const auto affine = [&](const Vector3d& p) -> Vector3d { return linear * p + linear.norm() * b; };
      const Numbered_mesh_3 mesh = mapped_cube(n, 0, affine);
      const Outcome outcome = run(mesh);
      CHECK(outcome.status == VMP::OK);
      const Matrix3Xd expected = (linear * mesh.source).colwise() + linear.norm() * b;
      CHECK((outcome.positions - expected).colwise().norm().maxCoeff() <= 1e-6 * linear.norm());
      CHECK(has_target_boundary(mesh, outcome.positions));
    }
}

TEST_CASE("The minimizer returns to the identity from a perturbed start")
{
  Numbered_mesh_3 mesh = cube_mesh(5);
  Solver<> solver;
  using Newton = VMP::internal::Newton_method_3<CGAL::Sequential_tag, Solver<> >;
  Newton newton(mesh, Parts::inverse_sources(mesh), std::vector<double>(mesh.cells.size(), 1.), solver);
  const VMP::Stretch_energy_3 energy;
  Matrix3Xd u = mesh.source;
  u.leftCols(mesh.number_of_free_vertices) += noise(mesh.number_of_free_vertices, 0.2);
  REQUIRE(number_of_inverted_cells(mesh, u) == 0);

  VMP::internal::Minimizer_3<Newton, VMP::Stretch_energy_3, CGAL::Sequential_tag> minimizer(newton, u, energy);
  VMP::internal::Step_status status = VMP::internal::Step_status::CONTINUE;
  for(int i = 0; i < 50 && status == VMP::internal::Step_status::CONTINUE; ++i)
    status = minimizer.step();
  CHECK(status == VMP::internal::Step_status::DONE);
  CHECK((u - mesh.source).cwiseAbs().maxCoeff() <= 1e-5);
}

TEMPLATE_TEST_CASE("The energy never rises, and no cell is ever inverted", "",
                   VMP::Stretch_energy_3, VMP::Dirichlet_energy_3)
{
  const TestType energy;
  for(const Numbered_mesh_3& mesh : {twisted_cube(5, 0.15), ring(6)})
  {
    Solver<> solver;
    auto engine = make_engine(mesh, energy, solver);
    engine.start();
    double previous = std::numeric_limits<double>::infinity();
    while(engine.is_running())
    {
      const bool was_flip_free = engine.is_flip_free();
      engine.step();
      if(!was_flip_free)
        continue;
      CHECK(engine.last_step().energy <= previous);
      CHECK(engine.last_step().number_of_inverted_cells == 0);
      CHECK(number_of_inverted_cells(mesh, engine.positions()) == 0);
      previous = engine.last_step().energy;
    }
    if(TestType::has_barrier)
      CHECK(engine.status() == VMP::OK);
    CHECK(previous == Approx(mean_energy(energy, mesh, engine.positions())).epsilon(1e-9));
    CHECK(has_target_boundary(mesh, engine.positions()));
  }
}

TEST_CASE("The result is a minimum")
{
  const Numbered_mesh_3 mesh = twisted_cube(4, 0.15);
  const VMP::Stretch_energy_3 energy;
  const Outcome outcome = run(mesh);
  REQUIRE(outcome.status == VMP::OK);
  for(const double amplitude : {0.001, 0.01, 0.05})
    for(unsigned int seed = 0; seed < 5; ++seed)
    {
      Matrix3Xd u = outcome.positions;
      u.leftCols(mesh.number_of_free_vertices) += noise(mesh.number_of_free_vertices, amplitude, seed);
      CHECK(mean_energy(energy, mesh, u) > outcome.energy);
    }
}

TEST_CASE("A map with inverted cells is untangled")
{
  const Numbered_mesh_3 mesh = ring(8);
  Solver<> solver;
  auto engine = make_engine(mesh, VMP::Stretch_energy_3(), solver);
  engine.start();
  CHECK(engine.number_of_inverted_cells_at_start() > 100);
  CHECK(engine.number_of_inverted_cells_at_start() == number_of_inverted_cells(mesh, engine.positions()));
  REQUIRE(!engine.is_flip_free());
  while(engine.is_running() && !engine.is_flip_free())
  {
    engine.step();
    CHECK(engine.last_step().phase == VMP::Phase::UNTANGLING);
    CHECK(has_target_boundary(mesh, engine.positions()));
  }
  CHECK(engine.is_flip_free());
  CHECK(number_of_inverted_cells(mesh, engine.positions()) == 0);
}

TEST_CASE("Untangling ends without success where there is no map")
{
  Numbered_mesh_3 mesh = cube_mesh(2); // a corner is drawn beyond the opposite one
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(mesh.source.col(v).isZero())
      mesh.target.col(v).setConstant(3);
  const Outcome outcome = run(mesh);
  CHECK(outcome.status == VMP::ERROR_NOT_FLIP_FREE);
  CHECK(number_of_inverted_cells(mesh, outcome.positions) > 0);
}

TEST_CASE("Without free vertices the map is the target")
{
  const Numbered_mesh_3 mesh = twisted_cube(1);
  REQUIRE(mesh.number_of_free_vertices == 0);
  const Outcome outcome = run(mesh);
  CHECK(outcome.status == VMP::OK);
  CHECK(has_same_bits(outcome.positions, mesh.target));
}

TEST_CASE("A negative zero among the targets stays one")
{
  const Numbered_mesh_3 mesh = mapped_cube(3, 0, [](const Vector3d& p) { return Vector3d(-p[0], -p[1], p[2]); });
  CHECK(has_target_boundary(mesh, run(mesh).positions));
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("Parallel and sequential results have the same bits")
{
  for(const Numbered_mesh_3& mesh : {twisted_cube(10, 0.1), ring(10)})
  {
    const VMP::Stretch_energy_3 energy;
    const Outcome sequential = run(mesh);
    const Outcome parallel = run<CGAL::Parallel_tag>(mesh, energy, Solver<CGAL::Parallel_tag>());
    CHECK(sequential.status == VMP::OK);
    CHECK(has_same_bits(sequential.positions, parallel.positions));
    CHECK(sequential.energy == parallel.energy);
  }
}
#endif

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
TEST_CASE("Both solvers lead to the same minimum")
{
  const VMP::Stretch_energy_3 energy;
  for(const Numbered_mesh_3& mesh : {twisted_cube(6, 0.1), ring(6)})
  {
    const Outcome iterative = run(mesh);
    const Outcome direct = run<CGAL::Sequential_tag>(mesh, energy, VMP::CHOLMOD_solver_traits_3());
    CHECK(direct.status == VMP::OK);
    CHECK(direct.energy == Approx(iterative.energy).epsilon(1e-6));
    CHECK((direct.positions - iterative.positions).cwiseAbs().maxCoeff() <= 1e-3);
  }
}
#endif

TEST_CASE("The spatial order keeps free vertices in front and the mesh as it is")
{
  const Numbered_mesh_3 mesh = twisted_cube(4, 0.1);
  const std::vector<std::size_t> order = VMP::internal::spatial_order_3(mesh);
  std::vector<std::size_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for(std::size_t i = 0; i < sorted.size(); ++i)
    REQUIRE(sorted[i] == i);

  const Numbered_mesh_3 ordered = VMP::internal::reordered(mesh, order);
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    CHECK(ordered.is_free(static_cast<int>(i)) == mesh.is_free(static_cast<int>(order[i])));
    CHECK(ordered.source.col(i) == mesh.source.col(order[i]));
    CHECK(ordered.target.col(i) == mesh.target.col(order[i]));
  }
  const auto cells = [](const Numbered_mesh_3& m, const auto& name)
  {
    std::vector<std::array<int, 4> > result = m.cells;
    for(std::array<int, 4>& cell : result)
      for(int& v : cell)
        v = name(v);
    std::sort(result.begin(), result.end());
    return result;
  };
  CHECK(cells(ordered, [&](const int v) { return static_cast<int>(order[v]); })
        == cells(mesh, [](const int v) { return v; }));
}
