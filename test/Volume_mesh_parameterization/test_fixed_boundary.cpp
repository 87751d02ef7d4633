// The search with fixed boundary through the public function: what it adopts, how often it asks the linear solver, and when
// it believes to be at the minimum.
#include "catch.h"
#include "cube_complex.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <utility>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Eigen::Vector3d;
using VMP::Parameterization_result;
using VMP::internal::Numbered_mesh_3;

namespace {

using Complex = Cube_complex<>;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A cube whose vertices inside are moved so much that some cells nearly vanish. Some seeds invert cells.
Numbered_mesh_3 jittered_cube(const int n, const double amplitude, const unsigned int seed)
{
  Numbered_mesh_3 mesh = cube_mesh(n);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> noise(-amplitude, amplitude);
  for(int v = 0; v < mesh.number_of_free_vertices; ++v)
    mesh.source.col(v) += Vector3d(noise(engine), noise(engine), noise(engine));
  return mesh;
}

bool is_positive(const Numbered_mesh_3& mesh)
{
  for(const auto& cell : mesh.cells)
    if(!(VMP::internal::edge_matrix(mesh.source, cell).determinant() > 0))
      return false;
  return true;
}

template <typename NamedParameters>
Parameterization_result parameterize_fixed(Complex& complex, const NamedParameters& np)
{
  return CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(complex.c3t3), complex.uvw_map(),
    np.boundary_map(complex.boundary_map()).boundary_mode(VMP::Boundary_mode::FIXED));
}

struct Counting_solver : VMP::Conjugate_gradient_solver_traits_3<>
{
  int number_of_analyses = 0;

  void analyze_pattern(const Matrix& A)
  {
    ++number_of_analyses;
    VMP::Conjugate_gradient_solver_traits_3<>::analyze_pattern(A);
  }
};

// Another energy times a factor, which changes no minimum.
template <typename Energy>
struct Scaled_energy
{
  double factor;
  Energy energy = Energy();

  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const { return T(factor) * energy.value(s); }

  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const { return T(factor) * energy.gradient(s); }

  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const { return T(factor) * energy.hessian(s); }
};

} // namespace

TEST_CASE("A harmonic map with respect to regular cells is adopted where the other one inverts cells")
{
  int number_of_maps = 0;
  for(unsigned int seed = 0; seed < 20; ++seed)
  {
    const Numbered_mesh_3 mesh = jittered_cube(6, 0.26, seed);
    if(!is_positive(mesh))
      continue;
    Complex complex(mesh);
    const Parameterization_result result = parameterize_fixed(complex, params::number_of_iterations(30));
    CHECK(result.status == VMP::OK);
    if(result.number_of_inverted_cells_at_start == 0)
      continue;
    ++number_of_maps;
    CHECK(result.number_of_untangling_iterations == 0);
    CHECK(result.untangling_method == "harmonic extension");
  }
  CHECK(number_of_maps > 2);
}

TEST_CASE("The pattern of the systems is analyzed once where no patch is in between")
{
  Complex complex(twisted_cube(4, 0.1));
  Counting_solver solver;
  const Parameterization_result result = parameterize_fixed(complex, params::solver_traits(std::ref(solver)));
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_untangling_iterations == 0);
  CHECK(solver.number_of_analyses == 1);
}

TEST_CASE("A minimum is not believed by a solver that was cut, and the message says so")
{
  const Numbered_mesh_3 mesh = twisted_cube(8, 0.15);
  Complex exact(mesh), complex(mesh);
  const Parameterization_result expected = parameterize_fixed(exact, params::number_of_iterations(100));
  REQUIRE(expected.status == VMP::OK);
  CHECK(!contains(expected.message, "limit of iterations"));

  VMP::Conjugate_gradient_solver_traits_3<> solver(2);
  const Parameterization_result result
    = parameterize_fixed(complex, params::solver_traits(std::ref(solver)).number_of_iterations(5));
  INFO(result.message);
  CHECK(contains(result.message, "limit of iterations"));
  CHECK(result.energy > (1 + 1e-6) * expected.energy);
  CHECK(result.status == VMP::ERROR_NOT_CONVERGED);
}

TEMPLATE_TEST_CASE("The minimum does not depend on a factor of the energy", "", VMP::Stretch_energy_3, VMP::ARAP_energy_3)
{
  for(const Numbered_mesh_3& mesh : { twisted_cube(4, 0.1), cube_mesh(4, 0.15) }) // for the latter ARAP has the minimum 0
  {
    Complex expected(mesh);
    const Parameterization_result usual = parameterize_fixed(expected, params::energy(TestType()));
    for(const double factor : { 1e-9, 1e9 })
    {
      Complex complex(mesh);
      const Parameterization_result result = parameterize_fixed(complex, params::energy(Scaled_energy<TestType>{ factor }));
      CHECK(result.status == usual.status);
      CHECK(result.number_of_iterations == usual.number_of_iterations);
      for(const auto& [v, p] : complex.uvw)
        CHECK(CGAL::squared_distance(p, expected.uvw.at(expected.vertices[std::distance(
          complex.vertices.begin(), std::find(complex.vertices.begin(), complex.vertices.end(), v))])) < 1e-8);
    }
  }
}
