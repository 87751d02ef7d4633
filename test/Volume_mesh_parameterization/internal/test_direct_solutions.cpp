// Systems at which conjugate gradients stop at their limit of iterations, and which are factorized then.
#include "catch.h"
#include "cube_complex.h"
#include "cube_mesh.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;
namespace internal = CGAL::Volume_mesh_parameterization::internal;

using Precise_solver = VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double>;
using VMP::Linear_solver_status;

namespace {

// Answers the right-hand side, and blames negative curvature that it met after many iterations.
struct Truncating_iterations
{
  using NT = double;
  using Matrix = VMP::Block_sparse_matrix_3<NT>;

  void analyze_pattern(const Matrix&) {}
  Linear_solver_status factorize(const Matrix&) { return Linear_solver_status::SUCCESS; }
  int number_of_iterations() const { return 1000; }

  Linear_solver_status solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, double)
  {
    x = b;
    return Linear_solver_status::TRUNCATED;
  }
};

// Answers the first right-hand side, and finds all other matrices indefinite.
struct Rounding_iterations
{
  using NT = double;
  using Matrix = VMP::Block_sparse_matrix_3<NT>;

  bool has_answered = false;

  void analyze_pattern(const Matrix&) {}
  Linear_solver_status factorize(const Matrix&) { return Linear_solver_status::SUCCESS; }
  int number_of_iterations() const { return 1; }

  Linear_solver_status solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, double)
  {
    x = b;
    return std::exchange(has_answered, true) ? Linear_solver_status::NOT_POSITIVE_DEFINITE : Linear_solver_status::SUCCESS;
  }
};

// Harmonic systems of a cube of n^3 cubes, whose (n - 1)^3 vertices inside are unknown.
template <typename Solver = Precise_solver>
class Cube_systems
{
public:
  explicit Cube_systems(const int n, const Solver& traits)
    : m_mesh(twisted_cube(n, 0.1)), m_traits(traits), m_solver(m_traits), m_system(m_mesh, free_vertices(m_mesh), m_solver)
  {}

  internal::Newton_direction_3 direction() { return m_system.direction(m_energy, positions(), 0., 1e-10); }
  internal::Newton_direction_3 next_direction()
  { return m_system.next_direction(m_energy, positions(), 1e-10, internal::Budget()); }

  const internal::Linear_solver_3& solver() const { return m_solver; }

private:
  internal::Matrix3Xd positions() const { return m_system.scale() * m_mesh.target; }

  internal::Cell_energy_of<VMP::Dirichlet_energy_3> m_energy{VMP::Dirichlet_energy_3()};
  internal::Numbered_mesh_3 m_mesh;
  Solver m_traits;
  internal::Linear_solver_of<Solver> m_solver;
  internal::Newton_system_3 m_system;
};

} // namespace

TEST_CASE("A system with few unknowns is factorized where conjugate gradients are cut")
{
  Cube_systems exact(3, Precise_solver()), cut(3, Precise_solver(5));
  const internal::Newton_direction_3 expected = exact.direction(), direction = cut.direction();
  REQUIRE(expected.status == Linear_solver_status::SUCCESS);
  CHECK(exact.solver().number_of_replaced_solutions == 0);

  CHECK(direction.status == Linear_solver_status::SUCCESS);
  CHECK((direction.vectors - expected.vectors).norm() <= 1e-8 * expected.vectors.norm());
  CHECK(cut.solver().number_of_cut_solutions() == 0); // the one is replaced
  CHECK(cut.solver().number_of_replaced_solutions == 1);
}

TEST_CASE("The matrix of a convex energy is factorized where iterations meet negative curvature, which is rounding")
{
  Cube_systems exact(3, Precise_solver());
  Cube_systems truncated(3, Truncating_iterations());
  CHECK(truncated.direction().status == Linear_solver_status::TRUNCATED);
  const internal::Newton_direction_3 expected = exact.direction(), direction = truncated.next_direction();
  CHECK(direction.status == Linear_solver_status::SUCCESS);
  CHECK((direction.vectors - expected.vectors).norm() <= 1e-8 * expected.vectors.norm());
}

TEST_CASE("A semi-definite matrix is factorized where iterations, which have solved others, find it indefinite by rounding")
{
  Cube_systems exact(3, Precise_solver());
  Cube_systems rounded(3, Rounding_iterations());
  REQUIRE(rounded.direction().status == Linear_solver_status::SUCCESS);
  const internal::Newton_direction_3 expected = exact.direction(), direction = rounded.direction();
  CHECK(direction.status == Linear_solver_status::SUCCESS);
  CHECK((direction.vectors - expected.vectors).norm() <= 1e-8 * expected.vectors.norm());
}

TEST_CASE("An indefinite matrix is not factorized where that takes longer than all iterations of a solver")
{
  Cube_systems rounded(24, Rounding_iterations()); // a factorization takes minutes
  REQUIRE(rounded.direction().status == Linear_solver_status::SUCCESS);
  CHECK(rounded.direction().status == Linear_solver_status::NOT_POSITIVE_DEFINITE);
}

TEST_CASE("Conjugate gradients are cut where a factorization takes more multiplications")
{
  Cube_systems systems(8, Precise_solver(2));
  CHECK(systems.direction().status == Linear_solver_status::ITERATION_LIMIT);
  CHECK(systems.solver().number_of_replaced_solutions == 0);
  CHECK(systems.solver().number_of_cut_solutions() == 1);
}

TEST_CASE("After a cut, more and more systems are factorized at once, and then iterations are tried again")
{
  Cube_systems systems(3, Precise_solver(5));
  std::vector<std::size_t> iterations;
  for(std::size_t before = 0; iterations.size() < 12; before = systems.solver().number_of_iterations())
  {
    CHECK(systems.direction().status == Linear_solver_status::SUCCESS);
    iterations.push_back(systems.solver().number_of_iterations() - before);
  }
  CHECK(iterations == std::vector<std::size_t>{ 5, 5, 0, 0, 5, 0, 0, 0, 0, 0, 0, 5 });
}

TEST_CASE("A map by a solver that is cut is a minimum where its systems are factorized, and no message complains")
{
  const auto parameterize = [](Precise_solver solver)
  {
    Cube_complex<> complex(twisted_cube(3, 0.1));
    return CGAL::stretch_minimizing_volume_parameterization(
      std::as_const(complex.c3t3), complex.uvw_map(),
      params::boundary_map(complex.boundary_map()).boundary_mode(VMP::Boundary_mode::FIXED).solver_traits(std::ref(solver)));
  };
  const VMP::Parameterization_result expected = parameterize(Precise_solver()), result = parameterize(Precise_solver(5));
  REQUIRE(expected.status == VMP::OK);
  CHECK(result.status == VMP::OK);
  CHECK(result.message.find("limit of iterations") == std::string::npos);
  CHECK(result.energy == Approx(expected.energy).epsilon(1e-6));
}
