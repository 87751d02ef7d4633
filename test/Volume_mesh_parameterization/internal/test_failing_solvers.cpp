// Linear solvers that fail, and what the result says about it.
#include "catch.h"
#include "cube_complex.h"
#include "cube_mesh.h"
#include "fixed_boundary.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>

#include <Eigen/Dense>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Complex = Cube_complex<>;
using Eigen::Vector3d;
using VMP::Linear_solver_status;
using VMP::Parameterization_result;
using VMP::internal::Numbered_mesh_3;

namespace {

// Always fails, either while it factorizes or while it solves.
class Failing_solver
{
public:
  using NT = double;
  using Matrix = VMP::Block_sparse_matrix_3<NT>;

  Failing_solver(const Linear_solver_status status, const bool does_factorize)
    : m_status(status), m_does_factorize(does_factorize)
  {}

  void analyze_pattern(const Matrix&) {}
  Linear_solver_status factorize(const Matrix&) { return m_does_factorize ? Linear_solver_status::SUCCESS : m_status; }
  Linear_solver_status solve(const Eigen::VectorXd&, Eigen::VectorXd&, double) { return m_status; }

private:
  Linear_solver_status m_status;
  bool m_does_factorize;
};

// Solves, but calls each solution truncated.
class Truncating_solver
{
public:
  using NT = double;
  using Matrix = VMP::Block_sparse_matrix_3<NT>;

  std::size_t number_of_truncations = 0;

  void analyze_pattern(const Matrix& A) { m_solver.analyze_pattern(A); }
  Linear_solver_status factorize(const Matrix& A) { return m_solver.factorize(A); }

  Linear_solver_status solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, const double tolerance)
  {
    const Linear_solver_status status = m_solver.solve(b, x, tolerance);
    if(status != Linear_solver_status::SUCCESS)
      return status;
    ++number_of_truncations;
    return Linear_solver_status::TRUNCATED;
  }

private:
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double> m_solver;
};

// Returns the solution of the first systems only, and then a multiple of it that does not descend, all as a success.
class Ascending_solver
{
public:
  using NT = double;
  using Matrix = VMP::Block_sparse_matrix_3<NT>;

  Ascending_solver(const int number_of_solutions, const double factor)
    : m_number_of_solutions(number_of_solutions), m_factor(factor)
  {}

  void analyze_pattern(const Matrix& A) { m_solver.analyze_pattern(A); }
  Linear_solver_status factorize(const Matrix& A) { return m_solver.factorize(A); }

  Linear_solver_status solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, const double tolerance)
  {
    const Linear_solver_status status = m_solver.solve(b, x, tolerance);
    if(--m_number_of_solutions < 0)
      x *= m_factor;
    return status;
  }

private:
  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double> m_solver;
  int m_number_of_solutions;
  double m_factor;
};

template <typename Solver>
Parameterization_result parameterize(Complex& complex, Solver& solver, const VMP::Boundary_mode mode,
                                     const bool do_slide)
{
  return CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(complex.c3t3), complex.uvw_map(),
    params::boundary_map(complex.boundary_map())
           .solver_traits(std::ref(solver))
           .boundary_mode(mode)
           .do_slide_boundary(do_slide));
}

// The sentence about this status.
std::string sentence(const Linear_solver_status status)
{
  VMP::internal::Newton_direction_3 direction;
  direction.status = status;
  return VMP::internal::describe_failure(direction);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The only free vertex has the image 0, which inverts no cell, before anything is solved.
Numbered_mesh_3 centered_cube()
{
  return mapped_cube(2, 0, [](const Vector3d& p) -> Vector3d { return p - Vector3d::Ones(); });
}

} // namespace

TEST_CASE("A solver that always fails is reported, also if the boundary may slide")
{
  const bool does_factorize = GENERATE(false, true), do_slide = GENERATE(false, true);
  const bool is_centered = GENERATE(false, true);
  Complex complex(is_centered ? centered_cube() : twisted_cube(3));
  Failing_solver solver(Linear_solver_status::FAILED, does_factorize);
  const Parameterization_result result = parameterize(complex, solver, VMP::Boundary_mode::FIXED, do_slide);
  INFO(result.message);
  CHECK(result.status == VMP::ERROR_LINEAR_SOLVER_FAILED);
  CHECK(contains(result.message, VMP::get_error_message(VMP::ERROR_LINEAR_SOLVER_FAILED)));
  CHECK(contains(result.message, sentence(Linear_solver_status::FAILED)));
  CHECK(result.has_valid_map == is_centered);
  CHECK(complex.uvw.empty() == !is_centered);
}

// Otherwise, the place where it comes to a halt would pass for a minimum.
TEST_CASE("A direction that does not descend is a failure of the solver")
{
  const double factor = GENERATE(0., -1.);
  Complex complex(twisted_cube(4));
  Ascending_solver solver(3, factor);
  const Parameterization_result result = parameterize(complex, solver, VMP::Boundary_mode::FIXED, false);
  INFO(result.message);
  CHECK(result.status == VMP::ERROR_LINEAR_SOLVER_FAILED);
  CHECK(contains(result.message, sentence(Linear_solver_status::NOT_POSITIVE_DEFINITE)));
}

// Otherwise, a stage that goes on from there would believe that all is well.
TEST_CASE("A start that inverts no cell does not hide that the solver has failed")
{
  const bool does_factorize = GENERATE(false, true);
  const Numbered_mesh_3 mesh = centered_cube();
  Failing_solver solver(Linear_solver_status::FAILED, does_factorize);
  fixed_boundary::Problem<VMP::Stretch_energy_3, Failing_solver> problem(mesh, VMP::Stretch_energy_3(), solver);
  VMP::internal::Progress_3 progress(VMP::internal::Budget(), 1000);
  VMP::internal::Map_options_3 options;
  options.mode = VMP::Boundary_mode::FIXED;
  const VMP::internal::Found_map_3 found = find_map_3(mesh, {}, { options, problem.energy, problem.solver, progress });
  CHECK(found.map.is_solution());
  CHECK(found.status == VMP::ERROR_LINEAR_SOLVER_FAILED);
  CHECK(found.reason == sentence(Linear_solver_status::FAILED));
}

TEST_CASE("Each failure of a solver has its sentence")
{
  const bool do_slide = GENERATE(false, true);
  for(const Linear_solver_status status : { Linear_solver_status::FAILED, Linear_solver_status::OUT_OF_MEMORY,
                                            Linear_solver_status::NOT_POSITIVE_DEFINITE })
  {
    Complex complex(twisted_cube(3));
    Failing_solver solver(status, false);
    const Parameterization_result result = parameterize(complex, solver, VMP::Boundary_mode::FIXED, do_slide);
    INFO(result.message);
    CHECK(result.status == VMP::ERROR_LINEAR_SOLVER_FAILED);
    CHECK(contains(result.message, sentence(status)));
    CHECK(contains(result.message, "memory") == (status == Linear_solver_status::OUT_OF_MEMORY));
  }
}

TEST_CASE("A solver that fails is no success with soft boundary either")
{
  const VMP::Boundary_mode mode = GENERATE(VMP::Boundary_mode::AUTO, VMP::Boundary_mode::SOFT);
  Complex complex(twisted_cube(3));
  Failing_solver solver(Linear_solver_status::OUT_OF_MEMORY, false);
  const Parameterization_result result = parameterize(complex, solver, mode, false);
  INFO(result.message);
  CHECK(result.status != VMP::OK);
  CHECK(contains(result.message, "memory"));
}

TEST_CASE("Truncated solutions of positive semi-definite systems lead to a map")
{
  const bool do_slide = GENERATE(false, true);
  for(const Numbered_mesh_3& mesh : { twisted_cube(4, 0.1), ring(5) })
  {
    Complex complex(mesh);
    Truncating_solver solver;
    const Parameterization_result result = parameterize(complex, solver, VMP::Boundary_mode::FIXED, do_slide);
    INFO(result.message);
    CHECK(result.status == VMP::OK);
    CHECK(result.has_valid_map);
    CHECK(solver.number_of_truncations > 1);

    Complex expected(mesh);
    VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double> usual;
    const double precision = do_slide ? 1e-3 : 1e-5; // on the folds of the wall of the ring, there are many minima
    CHECK(result.energy
          == Approx(parameterize(expected, usual, VMP::Boundary_mode::FIXED, do_slide).energy).epsilon(precision));
  }
}
