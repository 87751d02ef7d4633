// The engine on plain arrays: sums over the cells, step lengths, untangling and minimization.
#include "catch.h"
#include "cube_mesh.h"
#include "fixed_boundary.h"

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/find_splits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/minimize_map_3.h>
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
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::Matrix3d;
using CGAL::Volume_mesh_parameterization::internal::Matrix3Xd;
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
  Vector3d s = Eigen::JacobiSVD<Matrix3d, Eigen::NoQRPreconditioner>(J).singularValues();
  s[2] = std::copysign(s[2], J.determinant());
  return energy.value(s);
}

// The mean over the cells as a stage reports it: both meshes scaled to one volume.
template <typename Energy>
double mean_energy(const Energy& energy, const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  const double scale = std::cbrt(VMP::internal::volume(mesh, mesh.source)
                                 / VMP::internal::volume(mesh, mesh.target));
  double sum = 0;
  for(const std::array<int, 4>& cell : mesh.cells)
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

using fixed_boundary::Outcome;

template <typename Energy, typename Solver>
Outcome run(const Numbered_mesh_3& mesh, const Energy& energy, Solver solver)
{
  return fixed_boundary::run(mesh, energy, solver);
}

template <typename Energy = VMP::Stretch_energy_3>
Outcome run(const Numbered_mesh_3& mesh, const Energy& energy = Energy())
{
  return run(mesh, energy, Solver<>());
}

// Many steps, and no end.
VMP::internal::Progress_3 patient_progress() { return VMP::internal::Progress_3(VMP::internal::Budget(), 1000); }

std::vector<Matrix3d> inverse_sources(const Numbered_mesh_3& mesh)
{
  std::vector<Matrix3d> result;
  for(const std::array<int, 4>& cell : mesh.cells)
    result.push_back(VMP::internal::edge_matrix(mesh.source, cell).inverse());
  return result;
}

// The parts of the engine on a mesh with X^{-1} as it is.
struct Parts
{
  VMP::internal::Unknowns_3 unknowns;
  VMP::internal::Sparsity_pattern_3 pattern;
  VMP::internal::Scaled_cells_3 scaled;
  VMP::internal::Cell_packs_3 packs;
  VMP::Block_sparse_matrix_3<double> hessian;

  explicit Parts(const Numbered_mesh_3& mesh)
    : unknowns(free_vertices(mesh)), pattern(sparsity_pattern_3(mesh, unknowns)),
      scaled{1, inverse_sources(mesh), make_weights(mesh)}, packs(mesh, scaled, unknowns, pattern)
  {
    hessian.set_pattern(pattern.row_begin, pattern.columns);
  }

  static std::vector<double> make_weights(const Numbered_mesh_3& mesh)
  {
    std::vector<double> weights(mesh.cells.size());
    std::iota(weights.begin(), weights.end(), 1.);
    return weights;
  }

  template <typename Energy>
  VMP::internal::Energy_evaluation evaluate(const Energy& energy, const Matrix3Xd& u) const
  {
    return evaluate_energy(packs, VMP::internal::Cell_energy_of<Energy>(energy), u);
  }
};

} // namespace

TEMPLATE_TEST_CASE("The sum over the cells has the value and the derivatives it should", "",
                   VMP::Stretch_energy_3, VMP::Dirichlet_energy_3)
{
  const Numbered_mesh_3 mesh = cube_mesh(3, 0.1);
  const Matrix3Xd u = mesh.source + noise(mesh.number_of_vertices(), 0.1);
  const TestType energy;
  Parts parts(mesh);

  double expected = 0;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    if(*std::min_element(mesh.cells[c].begin(), mesh.cells[c].end()) < mesh.number_of_free_vertices)
      expected += parts.scaled.weights[c] * psi(energy, mesh, u, mesh.cells[c]);
  const VMP::internal::Energy_evaluation evaluation = parts.evaluate(energy, u);
  CHECK(evaluation.energy == Approx(expected).epsilon(1e-12));
  CHECK(evaluation.is_flip_free());

  const VMP::internal::Cell_energy_of<TestType> cell_energy(energy);
  const auto assembled_gradient = [&](const Matrix3Xd& v)
  {
    Matrix3Xd gradient;
    assemble_energy(parts.packs, cell_energy, v, 1., gradient, parts.hessian);
    return gradient;
  };
  const double h = 1e-5;
  const Matrix3Xd gradient = assembled_gradient(u);
  Matrix3Xd gradient_alone = Matrix3Xd::Zero(3, mesh.number_of_free_vertices);
  add_energy_gradient(parts.packs, cell_energy, u, gradient_alone);
  CHECK((gradient_alone - gradient).norm() <= 1e-12 * gradient.norm());
  const VMP::Block_sparse_matrix_3<double> hessian = parts.hessian;
  for(int i = 0; i < 3 * mesh.number_of_free_vertices; ++i)
  {
    Matrix3Xd forward = u, backward = u;
    forward(i) += h;
    backward(i) -= h;
    const double difference
      = (parts.evaluate(energy, forward).energy - parts.evaluate(energy, backward).energy) / (2 * h);
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
  Matrix3Xd u = mesh.source;
  CHECK(parts.evaluate(VMP::Dirichlet_energy_3(), u).number_of_inverted_cells == 0);
  u.col(0) += Vector3d(0, 0, 1.5);
  const std::size_t expected = number_of_inverted_cells(mesh, u);
  CHECK(expected > 0);
  CHECK(parts.evaluate(VMP::Dirichlet_energy_3(), u).number_of_inverted_cells == expected);
  CHECK(parts.evaluate(VMP::Dirichlet_energy_3(), u).smallest_determinant == Approx(-0.5));
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
      for(const std::array<int, 4>& cell : mesh.cells)
      {
        const Matrix3d X = VMP::internal::edge_matrix(mesh.source, cell), D = VMP::internal::edge_matrix(d, cell);
        const double c = (X.inverse() * D).cwiseAbs().rowwise().sum().maxCoeff(); // no root is below 1 / c
        for(int i = static_cast<int>(samples / (std::max)(1., c)); i < root * samples; ++i)
          if(!((X + (double(i) / samples) * D).determinant() > 0))
            root = double(i) / samples;
      }

      const double step = VMP::internal::largest_step_3(parts.packs, mesh.source, d);
      INFO("amplitude " << amplitude << ", first root about " << root);
      CHECK(step <= root);
      CHECK(step >= root - 1. / 1024 - 1. / samples);
    }
}

TEST_CASE("A step is not doubled where a cell is turned over on the way")
{
  // half a turn of two vertices about the other two, on lines that just miss the axis
  Numbered_mesh_3 mesh;
  mesh.source.resize(3, 4);
  mesh.source << 1, 0, 0, 0,
                 0, 1, 0, 0,
                 0, 0, 0, 1;
  mesh.target = mesh.source;
  mesh.cells = { {2, 3, 0, 1} };
  mesh.number_of_free_vertices = 2;
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  const VMP::internal::Scaled_cells_3 scaled{1, inverse_sources(mesh), {1.}};
  const VMP::internal::Newton_system_3 system(mesh, scaled, free_vertices(mesh), linear_solver);
  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);

  const auto length_after = [&](const Vector3d& c, const Vector3d& d)
  {
    VMP::internal::Newton_iterate_3 iterate{ 1, mesh.source };
    iterate.direction.vectors = Matrix3Xd::Zero(3, 4);
    iterate.direction.vectors.leftCols(2) << c, d;
    const Matrix3Xd step = 0.4 * iterate.direction.vectors, u = mesh.source + step, doubled = u + step;
    REQUIRE(system.evaluate(energy, u).is_flip_free());
    REQUIRE(system.evaluate(energy, doubled).is_flip_free());
    REQUIRE(system.evaluate(energy, doubled).energy < system.evaluate(energy, u).energy);
    return extrapolated(system, energy, iterate, {0.4, u, system.evaluate(energy, u)}).length;
  };
  CHECK(length_after(Vector3d(-2, 0.1, 0), Vector3d(0.1, -2, 0)) == 0.4);  // the determinant is negative halfway
  CHECK(length_after(Vector3d(-2, 0.1, 0), Vector3d(-0.1, -2, 0)) > 0.4);  // and here it is not
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
  const Numbered_mesh_3 mesh = cube_mesh(5);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  const VMP::internal::Scaled_cells_3 scaled{1, inverse_sources(mesh), std::vector<double>(mesh.cells.size(), 1.)};
  VMP::internal::Newton_system_3 system(mesh, scaled, free_vertices(mesh), linear_solver);
  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);
  Matrix3Xd u = mesh.source;
  u.leftCols(mesh.number_of_free_vertices) += noise(mesh.number_of_free_vertices, 0.2);
  REQUIRE(number_of_inverted_cells(mesh, u) == 0);

  VMP::internal::Progress_3 progress(VMP::internal::Budget(), 50);
  const VMP::internal::Newton_result_3 result = minimize_energy_3(system, energy, u, progress);
  CHECK(result.status == VMP::OK);
  CHECK((result.positions - mesh.source).cwiseAbs().maxCoeff() <= 1e-5);
}

TEMPLATE_TEST_CASE("The energy never rises, and no cell is ever inverted", "",
                   VMP::Stretch_energy_3, VMP::Dirichlet_energy_3)
{
  const TestType energy;
  for(const Numbered_mesh_3& mesh : {twisted_cube(5, 0.15), ring(6)})
  {
    Solver<> solver;
    const Outcome whole = fixed_boundary::run(mesh, energy, solver);
    double previous = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < whole.steps.size(); ++i)
    {
      if(whole.steps[i].phase == VMP::Phase::UNTANGLING)
        continue;
      CHECK(whole.steps[i].energy <= previous);
      CHECK(whole.steps[i].number_of_inverted_cells == 0);
      previous = whole.steps[i].energy;
      if(i % 4 != 0)
        continue;
      const Outcome part = fixed_boundary::run(mesh, energy, solver, i + 1); // ends after this step
      CHECK(part.energy == whole.steps[i].energy);
      CHECK(number_of_inverted_cells(mesh, part.positions) == 0);
    }
    if(energy.value(Vector3d(1, 1, 1e-9)) > 1e6) // a barrier against flat cells
      CHECK(whole.status == VMP::OK);
    CHECK(previous == Approx(mean_energy(energy, mesh, whole.positions)).epsilon(1e-9));
    CHECK(has_target_boundary(mesh, whole.positions));
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

namespace {

struct Counting_solver : Solver<>
{
  int number_of_factorizations = 0;

  VMP::Linear_solver_status factorize(const Matrix& A)
  {
    ++number_of_factorizations;
    return Solver<>::factorize(A);
  }
};

// Computes the harmonic map by linear finite elements, each with the same weight, and a dense factorization.
Matrix3Xd harmonic_map(const Numbered_mesh_3& mesh)
{
  const int n = mesh.number_of_vertices(), free = mesh.number_of_free_vertices;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for(const std::array<int, 4>& cell : mesh.cells)
  {
    Eigen::Matrix<double, 3, 4> gradients; // gradients of the barycentric coordinates
    gradients.rightCols(3) = VMP::internal::edge_matrix(mesh.source, cell).inverse().transpose();
    gradients.col(0) = -gradients.rightCols(3).rowwise().sum();
    const Eigen::Matrix4d products = gradients.transpose() * gradients;
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4; ++j)
        stiffness(cell[i], cell[j]) += products(i, j);
  }
  Matrix3Xd result = mesh.target;
  const Eigen::MatrixXd right = -stiffness.topRightCorner(free, n - free) * mesh.target.rightCols(n - free).transpose();
  result.leftCols(free) = stiffness.topLeftCorner(free, free).ldlt().solve(right).transpose();
  return result;
}

} // namespace

TEST_CASE("The harmonic map is that of a dense solution, by one matrix and steps that are not exact")
{
  for(const Numbered_mesh_3& mesh : { ring(6), twisted_cube(4, 0.2) })
  {
    Counting_solver solver;
    fixed_boundary::Problem<VMP::Stretch_energy_3, Counting_solver> problem(mesh, VMP::Stretch_energy_3(), solver);
    const Matrix3Xd map = fixed_boundary::harmonic_start(mesh, problem.system);
    CHECK((map - harmonic_map(mesh)).norm() < 1e-6 * mesh.target.norm());
    CHECK(solver.number_of_factorizations == 1);
    CHECK(problem.solver.number_of_iterations() > std::size_t(solver.number_of_iterations()));
  }
}

TEST_CASE("Copies of a budget are one: what one of them was told, all know")
{
  int number_of_questions = 0;
  const VMP::internal::Budget budget((std::numeric_limits<double>::infinity)(), [&] { return ++number_of_questions != 3; });
  VMP::internal::Progress_3 progress(budget, 10);
  CHECK(!budget.is_exhausted());
  CHECK(progress.may_continue());
  CHECK(!progress.may_continue());
  CHECK(budget.is_exhausted());
  CHECK(number_of_questions == 3);
}

TEST_CASE("A map with inverted cells is untangled")
{
  const Numbered_mesh_3 mesh = ring(8);
  Solver<> solver;
  fixed_boundary::Problem<VMP::Stretch_energy_3, Solver<> > problem(mesh, VMP::Stretch_energy_3(), solver);
  const Matrix3Xd start = fixed_boundary::harmonic_start(mesh, problem.system);
  CHECK(number_of_inverted_cells(mesh, start) > 100);
  for(const std::size_t limit : { 1, 1000 })
  {
    std::size_t last_number = number_of_inverted_cells(mesh, start), number_of_steps = 0;
    VMP::internal::Progress_3 progress(VMP::internal::Budget(), limit, [&](const VMP::Parameterization_step& step)
    {
      CHECK(last_number > 0);
      CHECK(step.phase == VMP::Phase::UNTANGLING);
      CHECK(step.kind == VMP::Step_kind::NEWTON);
      CHECK(step.decrement > 0);
      last_number = step.number_of_inverted_cells;
      ++number_of_steps;
      return true;
    });
    const VMP::internal::Newton_result_3 result
      = minimize_untangling_energy_3(problem.system, start, fixed_boundary::theta, progress);
    CHECK(has_target_boundary(mesh, result.positions));
    CHECK(result.status == (limit == 1000 ? VMP::OK : VMP::ERROR_NOT_FLIP_FREE));
    CHECK((number_of_inverted_cells(mesh, result.positions) == 0) == (limit == 1000));
    CHECK((number_of_steps == limit) == (limit < 1000));
  }
}

namespace {

// The free vertices that are nearest to the middle, and farthest from it.
std::array<Eigen::Index, 2> middle_and_corner(const Numbered_mesh_3& mesh)
{
  const Matrix3Xd inside = mesh.source.leftCols(mesh.number_of_free_vertices);
  const Eigen::RowVectorXd distances = (inside.colwise() - inside.rowwise().mean()).colwise().norm();
  std::array<Eigen::Index, 2> result;
  distances.minCoeff(&result[0]);
  distances.maxCoeff(&result[1]);
  return result;
}

} // namespace

TEST_CASE("A patch puts back a vertex that was drawn out of its ring, and moves no other vertex but its neighbors")
{
  const Numbered_mesh_3 mesh = cube_mesh(8);
  const auto [v, far] = middle_and_corner(mesh);
  Matrix3Xd start = mesh.source;
  start.col(v) += Vector3d(1.7, 0.3, 0.2);
  const std::size_t inverted = number_of_inverted_cells(mesh, start);
  REQUIRE(inverted > 0);

  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  std::size_t number_of_steps = 0;
  VMP::internal::Progress_3 progress(VMP::internal::Budget(), 1000, [&](const VMP::Parameterization_step& step)
  {
    CHECK(step.kind == VMP::Step_kind::PATCH);
    CHECK(step.number_of_inverted_cells <= inverted);
    ++number_of_steps;
    return true;
  });
  const VMP::internal::Newton_result_3 result = untangle_patches_3(mesh, linear_solver, start, progress);
  CHECK(number_of_steps > 0);
  CHECK(result.status == VMP::OK);
  CHECK(number_of_inverted_cells(mesh, result.positions) == 0);
  CHECK(result.positions.col(far) == start.col(far));
  CHECK(has_target_boundary(mesh, result.positions));
}

TEST_CASE("Patches leave a map without inverted cells as it is, and end where there is none")
{
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  Numbered_mesh_3 mesh = cube_mesh(3);
  VMP::internal::Progress_3 progress = patient_progress();
  const VMP::internal::Newton_result_3 done = untangle_patches_3(mesh, linear_solver, mesh.source, progress);
  CHECK(done.status == VMP::OK);
  CHECK(progress.number_of_steps() == 0);
  CHECK(done.positions == mesh.source);

  // two neighbors within a face of the boundary change their places
  const auto vertex_at = [&](const Vector3d& p)
  {
    Eigen::Index v = 0;
    (mesh.source.colwise() - p).colwise().norm().minCoeff(&v);
    return v;
  };
  mesh.target.col(vertex_at({ 1, 1, 0 })).swap(mesh.target.col(vertex_at({ 2, 1, 0 })));
  const Matrix3Xd start = snapped(mesh, mesh.source);
  const VMP::internal::Newton_result_3 stuck = untangle_patches_3(mesh, linear_solver, start, progress);
  CHECK(stuck.status == VMP::ERROR_NOT_FLIP_FREE);
  CHECK(number_of_inverted_cells(mesh, stuck.positions) > 0);
  CHECK(number_of_inverted_cells(mesh, stuck.positions) <= number_of_inverted_cells(mesh, start));
}

namespace {

// All cells of a prism over an octagon meet in a vertex in its middle. Its target is a prism over a U, where no point sees
// the inner walls of both arms, so that this vertex has no place.
Numbered_mesh_3 prism_to_U()
{
  constexpr int n = 8;
  constexpr double U[n][2] = { {0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2} };
  constexpr int triangles[n - 2][3] = { {0, 1, 4}, {0, 4, 5}, {1, 2, 4}, {2, 3, 4}, {0, 5, 7}, {5, 6, 7} };
  Numbered_mesh_3 mesh;
  mesh.number_of_free_vertices = 1;
  mesh.source.setZero(3, 1 + 2 * n);
  mesh.target.setZero(3, 1 + 2 * n);
  for(int i = 0; i < n; ++i)
    for(int z = 0; z < 2; ++z)
    {
      const double angle = (2 * i + 1) * 3.14159265358979 / n;
      mesh.source.col(1 + i + n * z) << std::cos(angle), std::sin(angle), z - 0.5;
      mesh.target.col(1 + i + n * z) << U[i][0], U[i][1], z;
    }
  const auto add_cell = [&](const int a, const int b, const int c) { mesh.cells.push_back({ 0, 1 + a, 1 + b, 1 + c }); };
  for(const auto& [a, b, c] : triangles)
  {
    add_cell(a, b, c);
    add_cell(n + a, n + c, n + b);
  }
  for(int i = 0; i < n; ++i)
  {
    const int j = (i + 1) % n;
    add_cell(i, n + j, j);
    add_cell(i, n + i, n + j);
  }
  for(std::array<int, 4>& cell : mesh.cells) // seen from outside so far
    std::swap(cell[2], cell[3]);
  return mesh;
}

} // namespace

TEST_CASE("Of many items only those are kept that are needed, with few questions")
{
  for(const std::vector<int>& needed : { std::vector<int>{ 3, 17, 64 }, std::vector<int>{ 99 }, std::vector<int>{ 0, 1 } })
  {
    std::vector<int> items(100);
    std::iota(items.begin(), items.end(), 0);
    int number_of_questions = 0;
    const std::vector<int> found = VMP::internal::minimal_subset(items, [&](const std::vector<int>& some)
    {
      REQUIRE(!some.empty());
      ++number_of_questions;
      return std::includes(some.begin(), some.end(), needed.begin(), needed.end());
    });
    CHECK(found == needed);
    CHECK(number_of_questions < 60);
  }
  const auto never = [](const std::vector<int>&) { return false; };
  CHECK(VMP::internal::minimal_subset(std::vector<int>{ 5 }, never).size() == 1);
  CHECK(VMP::internal::minimal_subset(std::vector<int>{ 1, 2, 3 }, never).size() == 3);
}

TEST_CASE("Cells around split edges are halved")
{
  Numbered_mesh_3 mesh = cube_mesh(3);
  const std::size_t number_of_cells = mesh.cells.size();
  const int number_of_free_vertices = mesh.number_of_free_vertices;
  const std::array<int, 4> cell = mesh.cells[100];
  const std::vector<std::array<int, 2> > edges = { { cell[0], cell[1] }, { cell[2], cell[3] }, { cell[3], cell[0] } };
  Matrix3Xd image = 2 * mesh.source;
  const double volume = VMP::internal::volume(mesh, mesh.source);
  split_patch_edges_3(mesh, image, edges);
  CHECK(mesh.number_of_free_vertices == number_of_free_vertices + 3);
  CHECK(image == 2 * mesh.source);
  CHECK(mesh.cells.size() >= number_of_cells + 3);
  CHECK(number_of_inverted_cells(mesh, mesh.source) == 0);
  CHECK(VMP::internal::volume(mesh, mesh.source) == Approx(volume));
  for(int i = 0; i < 3; ++i)
    CHECK(std::any_of(mesh.cells.begin(), mesh.cells.end(), [&](const std::array<int, 4>& c)
                      { return std::find(c.begin(), c.end(), number_of_free_vertices + i) != c.end(); }));
}

TEST_CASE("Further attempts are in vain where few cells are left and a proof tells that they cannot be mended")
{
  using namespace VMP::internal;
  Solver<> solver;
  Linear_solver_of<Solver<> > linear_solver(solver);
  Progress_3 progress = patient_progress();
  Untangling_attempt_3 attempt = untangling_attempts[0];
  Numbered_mesh_3 mesh = prism_to_U();
  Matrix3Xd start = mesh.target;
  start.col(0) = Vector3d(1.5, 0.5, 0.5);
  {
    Newton_system_3 system(mesh, free_vertices(mesh), linear_solver);
    Untangling_search_3 search(system, evaluated_map(mesh, start), progress);
    search.untangle(attempt, start);
    REQUIRE(search.is_unsolved());
    attempt.few_cells = search.best().map.number_of_inverted_cells;
    CHECK(search.is_in_vain(attempt));
    --attempt.few_cells;
    CHECK(!search.is_in_vain(attempt));
  }
  mesh.target = mesh.source; // there is a map, wherever the search is
  start = mesh.target;
  start.col(0) = Vector3d(5, 0, 0);
  REQUIRE(number_of_inverted_cells(mesh, start) > 0);
  Newton_system_3 system(mesh, free_vertices(mesh), linear_solver);
  attempt.few_cells = mesh.cells.size();
  CHECK(!Untangling_search_3(system, evaluated_map(mesh, start), progress).is_in_vain(attempt));
}

TEST_CASE("Where a vertex has no place, some of the edges at it are split, and then all vertices have one")
{
  Numbered_mesh_3 mesh = prism_to_U();
  REQUIRE(number_of_inverted_cells(mesh, mesh.source) == 0);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  Matrix3Xd image = mesh.target;
  image.col(0) = Vector3d(1.5, 0.5, 0.5);
  image = untangled_patch_3(mesh, linear_solver, image, VMP::internal::Budget());
  REQUIRE(number_of_inverted_cells(mesh, image) > 0);

  VMP::internal::Progress_3 progress = patient_progress();
  const std::vector<std::array<int, 2> > edges = find_splits_3(mesh, linear_solver, evaluated_map(mesh, image), progress);
  CHECK(edges.size() >= 2); // an arm needs a vertex at its inner wall for its upper and one for its lower half
  CHECK(edges.size() <= 8); // there are 16
  split_patch_edges_3(mesh, image, edges);
  image = untangled_patch_3(mesh, linear_solver, image, VMP::internal::Budget());
  CHECK(number_of_inverted_cells(mesh, image) == 0);
  CHECK(has_target_boundary(mesh, image));
}

TEST_CASE("An edge between prescribed vertices is split where it leaves the target, although no free vertex is at it")
{
  // An octahedron around its axis, the edge of vertices 1 and 2; its lower half is filled from the vertex 0. Its lowest
  // vertex goes up above the axis.
  Numbered_mesh_3 mesh;
  mesh.number_of_free_vertices = 1;
  mesh.source.resize(3, 7);
  mesh.source << 0, -1, 1, 0, 0, 0, 0,
                 0, 0, 0, -1, 1, 0, 0,
                 -0.5, 0, 0, 0, 0, 1, -1;
  mesh.target = mesh.source;
  mesh.target.col(0).setZero();
  mesh.target(2, 6) = 0.3;
  mesh.cells = { { 1, 2, 4, 5 }, { 1, 3, 2, 5 }, { 1, 4, 2, 0 }, { 1, 2, 3, 0 },
                 { 1, 4, 0, 6 }, { 4, 2, 0, 6 }, { 2, 3, 0, 6 }, { 3, 1, 0, 6 } };
  REQUIRE(number_of_inverted_cells(mesh, mesh.source) == 0);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  Matrix3Xd image = mesh.target;
  image(2, 0) = 0.6;
  image = untangled_patch_3(mesh, linear_solver, image, VMP::internal::Budget());
  REQUIRE(number_of_inverted_cells(mesh, image) > 0);

  VMP::internal::Progress_3 progress = patient_progress();
  const std::vector<std::array<int, 2> > edges = find_splits_3(mesh, linear_solver, evaluated_map(mesh, image), progress);
  CHECK(std::count(edges.begin(), edges.end(), std::array<int, 2>{ 1, 2 }) == 1);
  CHECK(edges.size() <= 3);
  split_patch_edges_3(mesh, image, edges);
  image = untangled_patch_3(mesh, linear_solver, image, VMP::internal::Budget());
  CHECK(number_of_inverted_cells(mesh, image) == 0);
  CHECK(has_target_boundary(mesh, image));
}

TEST_CASE("Flat cells become thicker, and only the vertices of flat cells move")
{
  const Numbered_mesh_3 mesh = cube_mesh(8);
  const auto [v, far] = middle_and_corner(mesh);
  const auto smallest_volume = [&](const Matrix3Xd& positions)
  {
    double result = std::numeric_limits<double>::infinity();
    for(const std::array<int, 4>& cell : mesh.cells)
      result = (std::min)(result, VMP::internal::edge_matrix(positions, cell).determinant() / 6);
    return result;
  };
  const auto moved = [&, v = v](const double t)
  {
    Matrix3Xd positions = mesh.source;
    positions.col(v) += t * Vector3d(1, 0.3, 0.2);
    return positions;
  };
  double inside_ring = 0, outside = 2; // as far as its ring allows
  for(int i = 0; i < 50; ++i)
  {
    const double t = (inside_ring + outside) / 2;
    (smallest_volume(moved(t)) > 0 ? inside_ring : outside) = t;
  }
  const Matrix3Xd start = moved(0.999 * inside_ring);
  REQUIRE(number_of_inverted_cells(mesh, start) == 0);
  REQUIRE(smallest_volume(start) < 0.01 * smallest_volume(mesh.source));

  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  const Matrix3Xd relaxed = relaxed_flat_cells_3(mesh, linear_solver, start, VMP::internal::Budget());
  CHECK(linear_solver.number_of_iterations() > 0);
  CHECK(number_of_inverted_cells(mesh, relaxed) == 0);
  CHECK(smallest_volume(relaxed) > 10 * smallest_volume(start));
  CHECK(relaxed.col(far) == start.col(far));
  CHECK(has_target_boundary(mesh, relaxed));

  // without flat cells
  CHECK(relaxed_flat_cells_3(mesh, linear_solver, mesh.source, VMP::internal::Budget()) == mesh.source);
}

TEST_CASE("Untangling with regular cells does not depend on slivers of the source")
{
  // one problem, with slivers of the source at each vertex in turn
  Numbered_mesh_3 mesh = ring(6);
  const auto untangled = [&]()
  {
    Solver<> solver;
    fixed_boundary::Problem<VMP::Stretch_energy_3, Solver<> > problem(mesh, VMP::Stretch_energy_3(), solver);
    VMP::internal::Progress_3 progress = patient_progress();
    const VMP::internal::Newton_result_3 result = minimize_untangling_energy_3(
      problem.system, mesh.target, 0.5, progress, 0, 1e-2, VMP::internal::Reference_cells::REGULAR);
    CHECK(result.status == VMP::OK);
    return result.positions;
  };
  const Matrix3Xd positions = untangled();
  mesh.source.row(2) *= 0.01;
  CHECK((untangled() - positions).cwiseAbs().maxCoeff() == 0);
}

TEST_CASE("The reference cells of a system can be exchanged")
{
  const Numbered_mesh_3 mesh = twisted_cube(3, 0.15);
  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  const VMP::internal::Scaled_cells_3 source = cells_scaled_to_target(mesh), regular = regular_cells_scaled_to_target(mesh);
  CHECK(source.unit == regular.unit);
  VMP::internal::Newton_system_3 exchanged(mesh, source, free_vertices(mesh), linear_solver);
  exchanged.set_references(VMP::internal::Reference_cells::REGULAR);
  const VMP::internal::Newton_system_3 system(mesh, regular, free_vertices(mesh), linear_solver);
  const Matrix3Xd u = source.unit * mesh.source;
  CHECK(exchanged.evaluate(energy, u).energy == system.evaluate(energy, u).energy);
  exchanged.set_references(VMP::internal::Reference_cells::SOURCE);
  CHECK(exchanged.evaluate(energy, u).energy != system.evaluate(energy, u).energy);
  // all edges of a regular cell are equally long, and all cells together fill the target
  const Eigen::Matrix3d edges = regular.inverse_sources[0].inverse();
  for(int i = 0; i < 3; ++i)
  {
    CHECK(edges.col(i).norm() == Approx(edges.col(0).norm()));
    CHECK((edges.col(i) - edges.col((i + 1) % 3)).norm() == Approx(edges.col(0).norm()));
  }
  CHECK(edges.determinant() / 6 * mesh.cells.size()
        == Approx(std::pow(regular.unit, 3) * VMP::internal::volume(mesh, mesh.target)));
}

TEST_CASE("A system of some of the unknowns is a part of that of all")
{
  const Numbered_mesh_3 mesh = cube_mesh(5, 0.15);
  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double> solver;
  VMP::internal::Linear_solver_of linear_solver(solver);
  const VMP::internal::Newton_system_3 whole(mesh, free_vertices(mesh), linear_solver);
  VMP::internal::Newton_system_3 part(whole, whole.unknowns().without([](const int v) { return v % 3 == 0; }), linear_solver);
  const auto& some = part.unknowns();
  REQUIRE(some.size() > 20);
  Matrix3Xd u = whole.unit() * mesh.source;
  u.leftCols(mesh.number_of_free_vertices) += noise(mesh.number_of_free_vertices, 0.02);
  REQUIRE(whole.evaluate(energy, u).is_flip_free());

  // the gradient of the whole, by the unknowns of the part
  const auto gradient = [&](const Matrix3Xd& positions)
  {
    const Matrix3Xd of_all = whole.gradient(energy, positions);
    Eigen::VectorXd result(3 * some.size());
    for(int row = 0; row < some.size(); ++row)
      result.segment<3>(3 * row) = of_all.col(whole.unknowns().row(some.vertex(row)));
    return result;
  };
  const Matrix3Xd own = part.gradient(energy, u);
  CHECK((Eigen::Map<const Eigen::VectorXd>(own.data(), own.size()) - gradient(u)).norm() < 1e-12 * own.norm());

  // its Newton direction, by differences of that gradient
  constexpr double h = 1e-6;
  Eigen::MatrixXd H(3 * some.size(), 3 * some.size());
  for(int k = 0; k < H.cols(); ++k)
  {
    Matrix3Xd above = u, below = u;
    above(k % 3, some.vertex(k / 3)) += h;
    below(k % 3, some.vertex(k / 3)) -= h;
    H.col(k) = (gradient(above) - gradient(below)) / (2 * h);
  }
  const Eigen::VectorXd expected = H.fullPivLu().solve(-gradient(u));
  const auto direction = part.direction(energy, u, 1, 1e-10);
  REQUIRE(direction.status == VMP::Linear_solver_status::SUCCESS);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(some.contains(v))
      CHECK((direction.vectors.col(v) - expected.segment<3>(3 * some.row(v))).norm() < 1e-5 * expected.norm());
    else
      CHECK(direction.vectors.col(v).isZero(0));
  CHECK(direction.slopes.sum() == Approx(direction.slope));
  CHECK(direction.slope == Approx(gradient(u).dot(expected)).epsilon(1e-5));
}

TEST_CASE("A cell that is nearly flat takes steps of a few vertices, and hardly any of all")
{
  const Numbered_mesh_3 mesh = cube_mesh(10);
  const auto [v, far] = middle_and_corner(mesh);
  // the free vertex v moves until it is 1e-9 away from the plane of a facet opposite to it
  const auto flat_cell = std::find_if(mesh.cells.begin(), mesh.cells.end(), [v = v](const std::array<int, 4>& cell)
  { return std::count(cell.begin(), cell.end(), v) > 0; });
  Vector3d center = Vector3d::Zero();
  for(const int w : *flat_cell)
    if(w != v)
      center += mesh.source.col(w) / 3;
  Matrix3Xd start = mesh.source;
  start.col(v) = center + 1e-9 * (mesh.source.col(v) - center);
  REQUIRE(number_of_inverted_cells(mesh, start) == 0);

  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);
  Solver<> solver;
  VMP::internal::Linear_solver_of linear_solver(solver);
  VMP::internal::Newton_system_3 system(mesh, free_vertices(mesh), linear_solver);
  VMP::internal::Progress_3 progress = patient_progress();
  const auto result = minimize_energy_3(system, energy, start, progress);
  CHECK(result.status == VMP::OK);
  CHECK((result.positions - mesh.source).colwise().norm().maxCoeff() < 1e-5);
  CHECK(progress.number_of_steps() < 20); // the height of the cell grows by a factor in each step, and of all vertices 34 are needed
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
  for(Numbered_mesh_3 mesh : {twisted_cube(10, 0.1), ring(10)})
  {
    const VMP::Stretch_energy_3 energy;
    const Outcome sequential = run(mesh);
    mesh.is_parallel = true;
    const Outcome parallel = run(mesh, energy, Solver<CGAL::Parallel_tag>());
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
    const Outcome direct = run(mesh, energy, VMP::CHOLMOD_solver_traits_3());
    CHECK(direct.status == VMP::OK);
    CHECK(direct.energy == Approx(iterative.energy).epsilon(1e-6));
    CHECK((direct.positions - iterative.positions).cwiseAbs().maxCoeff() <= 1e-3);
  }
}
#endif

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("Threads put items into the rows that one thread does, in order")
{
  constexpr std::size_t number_of_rows = 9001, number_of_items = 200003;
  const auto for_each_row_of = [](const std::size_t i, const auto& f) // two rows at most, and none of the last one
  {
    f(i * i % (number_of_rows - 1));
    if(i % 3 == 0)
      f(i % 17);
  };
  std::vector<std::vector<std::size_t> > expected(number_of_rows);
  for(std::size_t i = 0; i < number_of_items; ++i)
    for_each_row_of(i, [&](const std::size_t row) { expected[row].push_back(i); });
  for(const bool is_parallel : { false, true })
  {
    const VMP::internal::Compressed_rows<std::size_t> rows(number_of_rows, number_of_items, for_each_row_of, is_parallel);
    for(std::size_t row = 0; row < number_of_rows; ++row)
      REQUIRE(std::vector<std::size_t>(rows.items.data() + rows.begin[row], rows.items.data() + rows.begin[row + 1])
              == expected[row]);
  }
}

TEST_CASE("Threads find the facets, and the first of several mistakes, that one thread does")
{
  const Numbered_mesh_3 mesh = cube_mesh(24);
  const auto facets = VMP::internal::boundary_facets_3(mesh.cells);
  CHECK(facets.size() == 2 * 6 * 24 * 24);
  CHECK(VMP::internal::boundary_facets_3(mesh.cells, true) == facets);

  VMP::Tetrahedron_soup_3 soup;
  for(const std::array<int, 4>& cell : mesh.cells)
    soup.cells.push_back({ std::size_t(cell[0]), std::size_t(cell[1]), std::size_t(cell[2]), std::size_t(cell[3]) });
  soup.points.resize(mesh.number_of_vertices());
  for(std::size_t c = 5; c < soup.cells.size(); c += 500) // inverted cells overlap their neighbors
    std::swap(soup.cells[c][0], soup.cells[c][1]);
  const auto mistake = [&](const bool is_parallel) -> std::string
  {
    try
    {
      VMP::internal::Facet_matching_3(soup, {}, is_parallel);
    }
    catch(const VMP::Input_error& error)
    {
      return error.what();
    }
    return "";
  };
  CHECK(!mistake(false).empty());
  for(int i = 0; i < 10; ++i)
    CHECK(mistake(true) == mistake(false));
}
#endif

TEST_CASE("The spatial order keeps free vertices in front and the mesh as it is")
{
  const Numbered_mesh_3 mesh = twisted_cube(4, 0.1);
  std::vector<bool> is_prescribed;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    is_prescribed.push_back(!mesh.is_free(v));
  const std::vector<std::size_t> order = VMP::internal::spatial_order_3(mesh.source, is_prescribed);
#ifdef CGAL_LINKED_WITH_TBB
  CHECK(VMP::internal::spatial_order_3(mesh.source, is_prescribed, true) == order);
#endif
  std::vector<std::size_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  REQUIRE(sorted.size() == is_prescribed.size());
  for(std::size_t i = 0; i < sorted.size(); ++i)
    REQUIRE(sorted[i] == i);

  const auto [ordered, order_of_mesh] = VMP::internal::ordered_mesh_3(mesh.cells, mesh.source, is_prescribed);
  CHECK(order_of_mesh == order);
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    CHECK(ordered.is_free(static_cast<int>(i)) == mesh.is_free(static_cast<int>(order[i])));
    CHECK(ordered.source.col(i) == mesh.source.col(order[i]));
  }
  // each cell is named by its place among the cells of the user
  REQUIRE(ordered.cells.size() == mesh.cells.size());
  std::vector<bool> is_found(mesh.cells.size(), false);
  for(std::size_t c = 0; c < ordered.cells.size(); ++c)
  {
    std::array<int, 4> cell = ordered.cells[c];
    for(int& v : cell)
      v = static_cast<int>(order[v]);
    CHECK(cell == mesh.cells[ordered.user_number(c)]);
    CHECK(!is_found[ordered.user_number(c)]);
    is_found[ordered.user_number(c)] = true;
  }
}

TEST_CASE("Vertices that are prescribed keep their place among each other")
{
  const Numbered_mesh_3 mesh = twisted_cube(3, 0.1);
  std::vector<bool> is_prescribed(mesh.number_of_vertices());
  std::vector<std::size_t> prescribed;
  for(std::size_t v = 0; v < is_prescribed.size(); ++v)
    if((is_prescribed[v] = v % 3 != 1))
      prescribed.push_back(v);
  const std::vector<std::size_t> order = VMP::internal::spatial_order_3(mesh.source, is_prescribed);
  CHECK(std::vector<std::size_t>(order.end() - prescribed.size(), order.end()) == prescribed);
}

namespace {

// A step that has led to this energy, where the squared decrement was that.
VMP::internal::Newton_iterate_3 iterate_of(const double energy, const double squared_decrement)
{
  VMP::internal::Newton_iterate_3 result;
  result.evaluation.energy = energy;
  result.direction.slope = -squared_decrement;
  return result;
}

} // namespace

TEST_CASE("A minimization stagnates where neither the energy nor the decrement falls")
{
  const Numbered_mesh_3 mesh = cube_mesh(2);
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy{VMP::Stretch_energy_3()};
  const auto is_noticed = [&](const double energy_rate, const double decrement_rate)
  {
    VMP::internal::Gain_3 gain(mesh, energy, 1e-3);
    bool result = false;
    for(int i = 0; i < 100; ++i)
      result = gain.is_stagnating(iterate_of(1000 * std::pow(energy_rate, i), std::pow(decrement_rate, i))) || result;
    return result;
  };
  CHECK(is_noticed(0.99995, 1));
  CHECK(is_noticed(0.99995, 0.9));
  CHECK(!is_noticed(0.99995, 0.6)); // near a minimum
  CHECK(!is_noticed(0.9995, 1));
}

TEST_CASE("A search crawls where a few cells hold most of the energy, and it falls for them alone")
{
  // In ten steps, the first cell becomes higher by a tenth, and all of the mesh by the rate.
  const Numbered_mesh_3 mesh = cube_mesh(6);
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy{VMP::Stretch_energy_3()};
  const auto first_notice = [&](const double first_height, const double rate, const bool is_stagnating)
  {
    VMP::internal::Gain_3 gain(mesh, energy, 1e-3);
    for(int step = 1; step <= 300; ++step)
    {
      const double rounds = static_cast<double>(step) / 10;
      Matrix3Xd image = mesh.source;
      const Vector3d a = image.col(mesh.cells[0][0]), b = image.col(mesh.cells[0][1]);
      const Vector3d normal = (image.col(mesh.cells[0][2]) - b).cross(image.col(mesh.cells[0][3]) - b).normalized();
      image.col(mesh.cells[0][0]) -= (1 - first_height * std::pow(1.1, rounds)) * normal.dot(a - b) * normal;
      image.row(2) *= 0.1 * std::pow(rate, rounds);
      const double falling = is_stagnating ? 1 : std::pow(0.999, step);
      VMP::internal::Newton_iterate_3 iterate = iterate_of(2 * VMP::internal::Gain_3::large_energy * falling, 1);
      iterate.u = image;
      if(const std::optional<VMP::Error_code> status = gain.status_of_end(iterate))
        return status == VMP::OK ? -step : step; // negative if nothing is gained for any cell
    }
    return 0;
  };
  CHECK(first_notice(1e-5, 1, false) == 105);
  CHECK(first_notice(1e-5, 0.99, false) == 105); // the others become worse
  CHECK(first_notice(1e-5, 1.01, false) == 0);   // or better
  CHECK(first_notice(1e-5, 1.01, true) == 10);   // the first five steps have nothing to be compared with
  CHECK(first_notice(0.05, 1, true) == -10);     // no cell holds most of the energy
  CHECK(first_notice(0.05, 1, false) == 0);
}

TEST_CASE("A cell that the boundary makes flat does not keep the other vertices from their minimum")
{
  // a facet of the boundary becomes flat, and its cell holds all of the energy, wherever its free vertex is
  Numbered_mesh_3 mesh = cube_mesh(5, 0.15);
  const Matrix3Xd grid = cube_mesh(5).source;
  const auto vertex_at = [&](const Vector3d& p)
  {
    Eigen::Index v = 0;
    (grid.colwise() - p).colwise().norm().minCoeff(&v);
    return static_cast<int>(v);
  };
  const int moved = vertex_at({ 1, 1, 0 });
  mesh.target.col(moved) = Vector3d(1, 1e-5, 0);
  Matrix3Xd start = grid;
  start.col(moved) = mesh.target.col(moved);
  REQUIRE(number_of_inverted_cells(mesh, start) == 0);

  const VMP::Stretch_energy_3 stretch;
  Solver<> solver;
  fixed_boundary::Problem<VMP::Stretch_energy_3, Solver<> > problem(mesh, stretch, solver);
  const auto far_from_minimum = [&](const Matrix3Xd& u, const int v) // the gradient of its cells by a free vertex
  {
    Vector3d gradient = Vector3d::Zero();
    for(const std::array<int, 4>& cell : mesh.cells)
      if(std::find(cell.begin(), cell.end(), v) != cell.end())
        for(int i = 0; i < 3; ++i)
        {
          constexpr double h = 1e-6;
          Matrix3Xd right = u, left = u;
          right(i, v) += h;
          left(i, v) -= h;
          gradient[i] += (psi(stretch, mesh, right, cell) - psi(stretch, mesh, left, cell)) / (2 * h);
        }
    return gradient.norm();
  };
  const int far = vertex_at({ 4, 4, 4 }), center = vertex_at({ 3, 2, 3 });
  REQUIRE(far_from_minimum(start, far) > 0.5);

  VMP::internal::Found_map_3 found;
  found.map = evaluated_map(mesh, start);
  found.status = VMP::OK;
  VMP::internal::Progress_3 progress = patient_progress();
  VMP::internal::Map_options_3 options;
  options.energy_tolerance = 0; // to the minimum
  found = minimize_map_3(problem.system, { options, problem.energy, problem.solver, progress }, found);
  CHECK(found.map.is_solution());
  CHECK(far_from_minimum(found.map.positions, far) < 0.05);
  CHECK(far_from_minimum(found.map.positions, center) < 0.05);

  progress.begin_stage();
  const Matrix3Xd whole = minimize_energy_3(problem.system, problem.energy, start, progress).positions;
  CHECK(far_from_minimum(whole, far) > 0.05);

  const VMP::internal::Dominant_cells_3 dominant = dominant_cells_3(mesh, problem.energy, found.map.positions);
  CHECK(dominant.part_of_energy > 0.99);
  REQUIRE(!dominant.cells.empty());
  CHECK(dominant.cells.size() < 10);
  for(const std::size_t c : dominant.cells)
    CHECK(std::find(mesh.cells[c].begin(), mesh.cells[c].end(), moved) != mesh.cells[c].end());
  CHECK(dominant_cells_3(mesh, problem.energy, mesh.source).cells.empty());
}

TEST_CASE("The energy of a step counts the cells without a free vertex")
{
  const Numbered_mesh_3 mesh = twisted_cube(4);
  const auto is_prescribed = [&](const std::array<int, 4>& cell)
  {
    return std::none_of(cell.begin(), cell.end(), [&](const int v) { return mesh.is_free(v); });
  };
  REQUIRE(std::count_if(mesh.cells.begin(), mesh.cells.end(), is_prescribed) > 10);
  const VMP::Stretch_energy_3 energy;
  const Outcome outcome = run(mesh);
  REQUIRE(outcome.status == VMP::OK);
  CHECK(outcome.energy == Approx(mean_energy(energy, mesh, outcome.positions)).epsilon(1e-10));
  const double factor = std::cbrt(VMP::internal::volume(mesh, mesh.source)
                                  / VMP::internal::volume(mesh, outcome.positions));
  const double energy_of_result
    = VMP::internal::mean_energy_3(mesh, VMP::internal::singular_values_of_cells_3(mesh, outcome.positions),
                                   VMP::internal::Cell_energy_of<VMP::Stretch_energy_3>(energy), factor);
  CHECK(outcome.energy == Approx(energy_of_result).epsilon(1e-10));
}
