// The map with soft boundary: penalty, alignment, engine, relaxation.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Soft_boundary_search_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/plan_refinement_3.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace internal = CGAL::Volume_mesh_parameterization::internal;

using Constraint = VMP::Linear_constraint_3<int>;
using Constraints = std::vector<Constraint>;
using Precise_solver = VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double>;

namespace {

const internal::Cell_energy_of<VMP::Stretch_energy_3> stretch{VMP::Stretch_energy_3()};

struct Solver_of_search
{
  Precise_solver traits;
  internal::Linear_solver_of<Precise_solver> solver{traits};
};

// Soft boundary with a solver of its own.
class Search : private Solver_of_search, public internal::Soft_boundary_search_3
{
public:
  explicit Search(const internal::Numbered_mesh_3& mesh,
                    const VMP::Soft_boundary_parameters& parameters = VMP::Soft_boundary_parameters(),
                    const Constraints& constraints = Constraints(),
                    const internal::Search_start_3& start = internal::Search_start_3())
    : internal::Soft_boundary_search_3(mesh, stretch, solver, parameters, constraints, start)
  {}
};

// Couples the first and the last vertex, which share no cell.
Constraints coupling(const internal::Numbered_mesh_3& mesh)
{
  return {{{{0, {1, 2, 3}}, {mesh.number_of_vertices() - 1, {-1, 0.5, 2}}}, 0.75}};
}

// Answers a direction, exact up to rounding, by a dense factorization.
class Dense_solver
{
public:
  using NT = double;
  using Matrix = VMP::Block_sparse_matrix_3<NT>;

  void analyze_pattern(const Matrix&) {}

  VMP::Linear_solver_status factorize(const Matrix& A)
  {
    m_dense.setZero(3 * A.size(), 3 * A.size());
    for(int row = 0; row < A.size(); ++row)
      for(int k = A.row_begin(row); k < A.row_end(row); ++k)
        m_dense.block<3, 3>(3 * row, 3 * A.column(k)) = A.block(k);
    return VMP::Linear_solver_status::SUCCESS;
  }

  VMP::Linear_solver_status solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, const double)
  {
    x = m_dense.ldlt().solve(b);
    return VMP::Linear_solver_status::SUCCESS;
  }

  const Eigen::MatrixXd& matrix() const { return m_dense; }

private:
  Eigen::MatrixXd m_dense;
};

bool is_flip_free(const internal::Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& positions)
{
  return internal::inverted_cells(mesh, positions).number == 0;
}

// Runs until the end, and checks what holds after each step. Returns whether there was a relaxation.
bool run(Search& search, const internal::Numbered_mesh_3& mesh)
{
  REQUIRE(is_flip_free(mesh, search.positions()));
  bool has_relaxed = false;
  while(search.is_running() && search.last_step().iteration < 500)
  {
    const double energy_before = search.energy(); // energy with the weight that the step uses
    const bool was_relaxing = search.is_relaxing();
    search.step();
    REQUIRE(is_flip_free(mesh, search.positions()));
    // a relaxation is for another target
    if(!was_relaxing && !search.is_relaxing() && search.last_step().step_length > 0)
      REQUIRE(search.last_step().energy <= energy_before);
    has_relaxed |= search.is_relaxing();
  }
  REQUIRE(!search.is_running());
  return has_relaxed;
}

VMP::Soft_boundary_parameters without_snapping()
{
  VMP::Soft_boundary_parameters parameters;
  parameters.do_snap = false;
  return parameters;
}

} // namespace

TEST_CASE("The derivatives of energy plus penalty agree with finite differences")
{
  const internal::Numbered_mesh_3 mesh = cube_mesh(2, 0.1);
  internal::Quadratic_penalty_3 penalty(coupling(mesh), 7);
  const internal::Scaled_cells_3 scaled{1, scaled_inverse_sources(mesh, 1), std::vector<double>(mesh.cells.size(), 1.)};
  Dense_solver solver;
  internal::Linear_solver_of<Dense_solver> linear_solver(solver);
  const bool are_all_unknown = GENERATE(true, false);
  const internal::Unknowns_3 unknowns(mesh.number_of_vertices(), [&](const int v) { return are_all_unknown || v % 3 != 1; });
  internal::Newton_system_3 newton(mesh, scaled, unknowns, linear_solver, &penalty);

  Eigen::Matrix3Xd u = 1.25 * mesh.source;
  const Eigen::Matrix3Xd gradient = newton.gradient(stretch, u);
  CHECK(newton.direction(stretch, u, 1, 1e-2).gradient_norm == Approx(gradient.norm()));

  const double h = 1e-5;
  for(const int row : {0, 1, unknowns.size() - 1})
    for(int i = 0; i < 3; ++i)
    {
      const int v = unknowns.vertex(row);
      const double x = u(i, v);
      u(i, v) = x + h;
      const double energy_after = newton.evaluate(stretch, u).energy;
      const Eigen::Matrix3Xd gradient_after = newton.gradient(stretch, u);
      u(i, v) = x - h;
      const double energy_before = newton.evaluate(stretch, u).energy;
      const Eigen::Matrix3Xd gradient_before = newton.gradient(stretch, u);
      u(i, v) = x;

      CHECK(gradient(i, row) == Approx((energy_after - energy_before) / (2 * h)).margin(1e-6));
      const Eigen::Matrix3Xd column = (gradient_after - gradient_before) / (2 * h);
      const Eigen::Map<const Eigen::VectorXd> expected(column.data(), column.size());
      CHECK((solver.matrix().col(3 * row + i) - expected).norm() < 1e-6 * expected.norm());
    }
}

TEST_CASE("A penalty can hold the current positions")
{
  const internal::Numbered_mesh_3 mesh = cube_mesh(2);
  internal::Quadratic_penalty_3 penalty(coupling(mesh), 2);
  const double residual = penalty.residual(mesh.source);
  REQUIRE(residual > 0);
  CHECK(penalty.value(mesh.source) == Approx(2 * residual * residual));
  penalty.hold(mesh.source);
  CHECK(penalty.value(mesh.source) == 0);
  CHECK(penalty.residual(mesh.source) == residual);
  penalty.release();
  CHECK(penalty.value(mesh.source) == Approx(2 * residual * residual));
}

TEST_CASE("Alignment")
{
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, -2, 0.5).normalized()).matrix();
  const Eigen::Vector3d translation(10, -20, 30);

  SECTION("finds a similarity, also for the vertices inside")
  {
    const auto similarity = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return 3 * rotation * p + translation; };
    const internal::Numbered_mesh_3 mesh = mapped_cube(3, 0.15, similarity);
    const Eigen::Matrix3Xd aligned = internal::similarity_alignment_3(mesh);
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      CHECK((aligned.col(v) - similarity(mesh.source.col(v))).norm() < 1e-12 * translation.norm());
  }

  SECTION("does not reflect")
  {
    const internal::Numbered_mesh_3 mesh
      = mapped_cube(2, 0, [](const Eigen::Vector3d& p) -> Eigen::Vector3d { return -p; });
    CHECK(is_flip_free(mesh, internal::similarity_alignment_3(mesh)));
  }

  SECTION("minimizes the sum of squared distances among the similarities near it")
  {
    const internal::Numbered_mesh_3 mesh = twisted_cube(3);
    const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
    const Eigen::Matrix3Xd aligned = internal::similarity_alignment_3(mesh);
    const auto distance = [&](const Eigen::Matrix3d& A, const Eigen::Vector3d& t)
    {
      return ((A * aligned.rightCols(n)).colwise() + t - mesh.target.rightCols(n)).squaredNorm();
    };
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    const double minimum = distance(identity, zero);
    for(const double h : {-1e-3, 1e-3})
    {
      CHECK(distance((1 + h) * identity, zero) > minimum);
      for(int i = 0; i < 3; ++i)
      {
        CHECK(distance(identity, h * Eigen::Vector3d::Unit(i)) > minimum);
        CHECK(distance(Eigen::AngleAxisd(h, Eigen::Vector3d::Unit(i)).matrix(), zero) > minimum);
      }
    }
  }
}

TEST_CASE("A twisted cube is reached from the aligned source")
{
  const internal::Numbered_mesh_3 mesh = twisted_cube(4, 0.1);
  VMP::Soft_boundary_parameters parameters = without_snapping();

  SECTION("with growing weight") {}
  SECTION("with a single weight")
  {
    parameters = VMP::single_weight_soft_boundary_parameters();
    parameters.do_snap = false;
  }
  SECTION("with full Hessians") { parameters.use_full_hessian = true; }
  SECTION("without relaxation") { parameters.maximum_number_of_relaxations = 0; }
  SECTION("with full Hessians where they are positive definite, without relaxation")
  {
    parameters.use_full_hessian = true;
    parameters.maximum_number_of_relaxations = 0;
  }

  Search search(mesh, parameters);
  run(search, mesh);
  CHECK(search.status() == VMP::OK);
  CHECK(search.residual() <= parameters.residual_tolerance);
  CHECK(is_flip_free(mesh, search.snapped_positions()));
}

TEST_CASE("Relaxation helps where the full Hessian is not positive definite")
{
  const internal::Numbered_mesh_3 mesh = ring(4);
  VMP::Soft_boundary_parameters parameters = without_snapping();
  parameters.use_full_hessian = true;
  Search search(mesh, parameters);
  CHECK(run(search, mesh));
  CHECK(search.status() == VMP::OK);
}

TEST_CASE("The engine ends as soon as the boundary can be snapped")
{
  const internal::Numbered_mesh_3 mesh = twisted_cube(4, 0.1);
  Search search(mesh);
  run(search, mesh);
  REQUIRE(search.can_snap());
  const Eigen::Matrix3Xd snapped = search.snapped_positions();
  CHECK(is_flip_free(mesh, snapped));
  const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
  CHECK(snapped.rightCols(n) == mesh.target.rightCols(n));
  CHECK(snapped.leftCols(mesh.number_of_free_vertices) == search.positions().leftCols(mesh.number_of_free_vertices));
}

TEST_CASE("The result does not depend on units")
{
  internal::Numbered_mesh_3 mesh = twisted_cube(3, 0.1);
  Search search(mesh, without_snapping());
  run(search, mesh);
  const double factor = 1000;
  internal::Numbered_mesh_3 large = mesh;
  large.source *= 7;
  large.target *= factor;
  Search other(large, without_snapping());
  run(other, large);
  CHECK((other.positions() / factor - search.positions()).norm() < 1e-6);
  CHECK(other.last_step().energy == Approx(search.last_step().energy));
}

TEST_CASE("A vertex is held on a plane")
{
  const internal::Numbered_mesh_3 mesh = twisted_cube(4, 0.1);
  Search unconstrained(mesh, without_snapping());
  run(unconstrained, mesh);

  const Eigen::Vector3d normal = Eigen::Vector3d(1, 1, 1).normalized();
  const double value = unconstrained.positions().col(0).dot(normal) + 0.1;
  Search search(mesh, without_snapping(), {{{{0, normal}}, value}});
  run(search, mesh);
  CHECK(search.status() == VMP::OK);
  CHECK(search.positions().col(0).dot(normal) == Approx(value).epsilon(1e-5));
  CHECK(!search.can_snap()); // which would give the constraint up
}

TEST_CASE("The distance of two vertices that share no cell is kept")
{
  const internal::Numbered_mesh_3 mesh = twisted_cube(4, 0.1);
  const int a = 0, b = mesh.number_of_free_vertices - 1;
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  Search search(mesh, without_snapping(), {{{{a, axis}, {b, -axis}}, 0.25}});
  run(search, mesh);
  CHECK(search.status() == VMP::OK);
  CHECK(search.positions()(0, a) - search.positions()(0, b) == Approx(0.25).epsilon(1e-5));
}

// Start at the aligned source, with an end as soon as the search is blocked.
internal::Search_start_3 impatient()
{
  internal::Search_start_3 start;
  start.patience = 1;
  return start;
}

// Two vertices of the boundary change their places.
internal::Numbered_mesh_3 cube_with_exchanged_targets()
{
  internal::Numbered_mesh_3 mesh = cube_mesh(2);
  const int last = mesh.number_of_vertices() - 1;
  std::swap(mesh.target.col(last), mesh.target.col(last - 1));
  return mesh;
}

TEST_CASE("A boundary that cannot be reached is brought near, and said so")
{
  const internal::Numbered_mesh_3 mesh = cube_with_exchanged_targets();
  Search search(mesh);
  run(search, mesh);
  CHECK(search.status() == VMP::ERROR_BOUNDARY_NOT_REACHED);
  CHECK(search.residual() > 1e-6);
  CHECK(!search.can_snap());
}

TEST_CASE("A soft boundary that is blocked ends early, names the cells to blame, and goes on from there")
{
  const internal::Numbered_mesh_3 mesh = cube_with_exchanged_targets();
  const VMP::Soft_boundary_parameters parameters = VMP::approaching_soft_boundary_parameters();
  Search search(mesh, parameters, {}, impatient());
  run(search, mesh);
  CHECK(search.status() == VMP::ERROR_BOUNDARY_NOT_REACHED);
  CHECK(search.number_of_raises() < parameters.maximum_number_of_raises);

  const int last = mesh.number_of_vertices() - 1;
  const std::vector<std::size_t> cells = internal::blocking_cells_3(mesh, search.positions());
  REQUIRE(!cells.empty());
  for(const std::size_t c : cells)
  {
    CHECK(!internal::is_positive(search.snapped_positions(), mesh.cells[c]));
    CHECK(std::any_of(mesh.cells[c].begin(), mesh.cells[c].end(), [&](const int v) { return v >= last - 1; }));
  }

  internal::Search_start_3 start = impatient();
  start.stage = internal::Search_start_3::Stage::SOFT_BOUNDARY;
  start.positions = search.positions();
  start.number_of_raises = search.number_of_raises();
  const Search second(mesh, parameters, {}, start);
  CHECK(second.weight() == search.weight());
  CHECK(second.energy() == Approx(search.last_step().energy));
  CHECK((second.positions() - search.positions()).norm() < 1e-12);
}

TEST_CASE("A soft boundary that can end at the targets does, whatever its patience")
{
  const internal::Numbered_mesh_3 mesh = twisted_cube(4, 0.1);
  Search search(mesh, VMP::approaching_soft_boundary_parameters(), {}, impatient());
  run(search, mesh);
  CHECK(search.status() == VMP::OK);
  CHECK(search.can_snap());
}
