// The kernels for the longer instructions of this processor give what those for any processor give. CMake compiles this
// file for any processor: compiled for one that has all instructions, there is only one set of kernels.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_kernels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Cell_packs_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace internal = VMP::internal;

using CGAL::Volume_mesh_parameterization::internal::Matrix3Xd;
using internal::Cell_energy_3;
using internal::Cell_kernels_3;
using internal::Numbered_mesh_3;

namespace {

struct Named_kernels
{
  std::string name;
  const Cell_kernels_3& kernels;
};

// All but those for the instructions of this unit.
std::vector<Named_kernels> longer_instructions()
{
  std::vector<Named_kernels> result;
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_CHOOSES_INSTRUCTIONS
  if(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    result.push_back({ "avx2", internal::avx2::cell_kernels });
  if(__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    result.push_back({ "avx512", internal::avx512::cell_kernels });
#endif
  return result;
}

const Cell_kernels_3& kernels_of_unit() { return internal::arithmetic_of_unit::cell_kernels; }

Matrix3Xd noise(const Eigen::Index size, const double amplitude, const unsigned int seed)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> distribution(-amplitude, amplitude);
  return Matrix3Xd::NullaryExpr(3, size, [&]() { return distribution(engine); });
}

// A mesh in packs, the last one of which is not full, and images of its vertices.
struct Problem
{
  Numbered_mesh_3 mesh;
  internal::Unknowns_3 unknowns;
  internal::Sparsity_pattern_3 pattern;
  internal::Cell_packs_3 packs;

  Problem()
    : mesh(cube_mesh(5, 0.15)), unknowns(free_vertices(mesh)), pattern(sparsity_pattern_3(mesh, unknowns)),
      packs(mesh, cells_scaled_to_target(mesh), unknowns, pattern)
  {}

  // Calls f for the packs with and without unknown vertices.
  template <typename Function>
  void for_each_range(const Function& f) const
  {
    for(std::size_t chunk = 0; chunk < packs.number_of_chunks(); ++chunk)
      f(packs.chunk_begin(chunk), packs.chunk_end(chunk));
    f(packs.others_begin(), packs.others_end());
  }
};

// All that the kernels compute.
struct Sums
{
  internal::Energy_evaluation evaluation;
  Matrix3Xd gradient, gradient_with_hessian, gradient_with_floats;
  Eigen::VectorXd hessian;
  Eigen::VectorXf hessian_in_floats;
};

Sums sums(const Cell_kernels_3& kernels, const Problem& problem, const Cell_energy_3& energy, const Matrix3Xd& u,
          const double negative_curvature)
{
  Sums result;
  result.gradient = Matrix3Xd::Zero(3, problem.unknowns.size());
  result.gradient_with_hessian = result.gradient_with_floats = result.gradient;
  const Eigen::Index number_of_entries = 9 * static_cast<Eigen::Index>(problem.pattern.columns.size());
  result.hessian = Eigen::VectorXd::Zero(number_of_entries);
  result.hessian_in_floats = Eigen::VectorXf::Zero(number_of_entries);
  problem.for_each_range([&](const Cell_kernels_3::Range first, const Cell_kernels_3::Range last)
  {
    kernels.evaluate(first, last, u.data(), energy, result.evaluation);
    kernels.add_gradient(first, last, u.data(), energy, result.gradient.data());
    kernels.add_derivatives.second(first, last, u.data(), energy, negative_curvature,
                                   result.gradient_with_hessian.data(), result.hessian.data());
    kernels.add_derivatives.first(first, last, u.data(), energy, negative_curvature,
                                  result.gradient_with_floats.data(), result.hessian_in_floats.data());
  });
  return result;
}

template <typename Matrix>
bool is_near(const Matrix& a, const Matrix& b, const double tolerance)
{
  return b.norm() > 0 && (a - b).norm() <= tolerance * b.norm();
}

void check_same_sums(const Problem& problem, const Cell_energy_3& energy, const Matrix3Xd& u)
{
  constexpr double tolerance = 1e-10, tolerance_of_floats = 1e-6;
  for(const double negative_curvature : { 0., 0.25, 1. })
  {
    const Sums expected = sums(kernels_of_unit(), problem, energy, u, negative_curvature);
    CHECK(is_near(expected.gradient_with_hessian, expected.gradient, tolerance));
    for(const auto& [name, kernels] : longer_instructions())
    {
      INFO(name << ", " << negative_curvature << " of negative curvature");
      const Sums actual = sums(kernels, problem, energy, u, negative_curvature);
      CHECK(actual.evaluation.energy == Approx(expected.evaluation.energy).epsilon(tolerance));
      CHECK(actual.evaluation.number_of_inverted_cells == expected.evaluation.number_of_inverted_cells);
      CHECK(actual.evaluation.smallest_determinant
            == Approx(expected.evaluation.smallest_determinant).epsilon(tolerance));
      CHECK(is_near(actual.gradient, expected.gradient, tolerance));
      CHECK(is_near(actual.gradient_with_hessian, expected.gradient, tolerance));
      CHECK(is_near(actual.gradient_with_floats, expected.gradient, tolerance));
      CHECK(is_near(actual.hessian, expected.hessian, tolerance));
      CHECK(is_near(actual.hessian_in_floats, expected.hessian_in_floats, tolerance_of_floats));
    }
  }
}

template <typename Energy>
void check_same_sums(const Problem& problem, const Energy& energy, const Matrix3Xd& u)
{
  check_same_sums(problem, static_cast<const Cell_energy_3&>(internal::Cell_energy_of<Energy>(energy)), u);
}

} // namespace

TEST_CASE("The engine takes the kernels with the longest instructions")
{
  const std::vector<Named_kernels> longer = longer_instructions();
  CHECK(&internal::cell_kernels_3() == (longer.empty() ? &kernels_of_unit() : &longer.back().kernels));
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__AVX2__)
  CHECK(longer.empty() == !__builtin_cpu_supports("avx2")); // so that the other tests compare something
#endif
}

TEST_CASE("Kernels agree on values and derivatives where no cell is inverted")
{
  const Problem problem;
  const Matrix3Xd u = problem.mesh.source + noise(problem.mesh.number_of_vertices(), 0.1, 1);
  check_same_sums(problem, VMP::Stretch_energy_3(), u);
  check_same_sums(problem, VMP::MIPS_energy_3(), u);
}

TEST_CASE("Kernels agree on values and derivatives where cells are inverted")
{
  const Problem problem;
  const Matrix3Xd u = problem.mesh.source + noise(problem.mesh.number_of_vertices(), 0.8, 2);
  internal::Energy_evaluation evaluation;
  problem.for_each_range([&](const Cell_kernels_3::Range first, const Cell_kernels_3::Range last)
  {
    kernels_of_unit().evaluate(first, last, u.data(), internal::Cell_energy_of<VMP::LPM_energy_3>(VMP::LPM_energy_3()),
                               evaluation);
  });
  REQUIRE(evaluation.number_of_inverted_cells > 10);
  check_same_sums(problem, VMP::LPM_energy_3(), u);
  check_same_sums(problem, internal::Untangling_energy_3(0.1, 0.01), u);
}

TEST_CASE("Kernels agree on the largest step")
{
  const Problem problem;
  const Matrix3Xd& u = problem.mesh.source;
  for(const double amplitude : { 0.01, 0.3, 1., 10. })
    for(const unsigned int seed : { 1, 2, 3 })
    {
      const Matrix3Xd d = noise(u.cols(), amplitude, seed);
      problem.for_each_range([&](const Cell_kernels_3::Range first, const Cell_kernels_3::Range last)
      {
        const double expected = kernels_of_unit().largest_step(first, last, u.data(), d.data());
        CHECK((expected == 1 || amplitude > 0.01));
        CHECK((expected < 1 || amplitude < 1));
        for(const auto& [name, kernels] : longer_instructions())
        {
          INFO(name << ", amplitude " << amplitude);
          CHECK(kernels.largest_step(first, last, u.data(), d.data()) == Approx(expected).epsilon(1e-10));
        }
      });
    }
}

TEST_CASE("Kernels agree that a cell with coordinates that are no numbers is inverted, and allows no step")
{
  const Problem problem;
  Matrix3Xd u = problem.mesh.source;
  const Matrix3Xd d = Matrix3Xd::Zero(3, u.cols());
  u(1, 0) = std::nan("");
  const internal::Cell_energy_of<VMP::LPM_energy_3> energy{ VMP::LPM_energy_3() };
  const auto check = [&](const Cell_kernels_3& kernels)
  {
    internal::Energy_evaluation evaluation;
    double step = 1;
    problem.for_each_range([&](const Cell_kernels_3::Range first, const Cell_kernels_3::Range last)
    {
      kernels.evaluate(first, last, u.data(), energy, evaluation);
      step = (std::min)(step, kernels.largest_step(first, last, u.data(), d.data()));
    });
    CHECK(evaluation.number_of_inverted_cells > 0);
    CHECK(step == 0);
    return evaluation.number_of_inverted_cells;
  };
  const std::size_t expected = check(kernels_of_unit());
  for(const auto& [name, kernels] : longer_instructions())
  {
    INFO(name);
    CHECK(check(kernels) == expected);
  }
}
