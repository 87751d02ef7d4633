// An energy of the user that chooses between formulas, and what a visitor sees of it.
#include "catch.h"
#include "complex_checks.h"
#include "cube_complex.h"
#include "cube_mesh.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Any_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/select.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Complex = Cube_complex<>;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using VMP::Parameterization_result;
using VMP::internal::Numbered_mesh_3;

namespace {

// 1 / s_1^2 + 1 / s_2^2 + 1 / s_3^2, plus the squares of what singular values are above a length and, with a factor, of
// what they are below it. All three functions that take the place of branches are used.
class Own_energy
{
public:
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  {
    T sum(0);
    for(int i = 0; i < 3; ++i)
      sum += T(1) / (s[i] * s[i]) + square(above(s[i])) + T(factor) * square(below(s[i]));
    return sum;
  }

  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  {
    Eigen::Matrix<T, 3, 1> g;
    for(int i = 0; i < 3; ++i)
      g[i] = T(-2) / (s[i] * s[i] * s[i]) + T(2) * above(s[i]) + T(2 * factor) * below(s[i]);
    return g;
  }

  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    using VMP::select;
    Eigen::Matrix<T, 3, 3> H = Eigen::Matrix<T, 3, 3>::Constant(T(0));
    for(int i = 0; i < 3; ++i)
      H(i, i) = T(6) / (s[i] * s[i] * s[i] * s[i]) + select(s[i] > T(length), T(2), T(2 * factor));
    return H;
  }

  static constexpr double length = 1.1, factor = 3;

private:
  template <typename T>
  static T square(const T& x) { return x * x; }

  template <typename T>
  static T above(const T& s)
  {
    using VMP::maximum;
    return maximum(s - T(length), T(0));
  }

  template <typename T>
  static T below(const T& s)
  {
    using VMP::minimum;
    return minimum(s - T(length), T(0));
  }
};

// Returns the energy with branches, which only plain numbers can have.
double own_value(const Vector3d& s)
{
  double sum = 0;
  for(const double x : s)
  {
    const double difference = x - Own_energy::length;
    sum += 1 / (x * x) + (difference > 0 ? 1 : Own_energy::factor) * difference * difference;
  }
  return sum;
}

Vector3d singular_values(const Complex& complex, const std::array<int, 4>& cell, const double scale)
{
  Matrix3d U;
  const auto image = [&](const int v)
  {
    const auto& p = complex.uvw.at(complex.vertices[v]);
    return Vector3d(p.x(), p.y(), p.z());
  };
  for(int i = 0; i < 3; ++i)
    U.col(i) = image(cell[i + 1]) - image(cell[0]);
  const Matrix3d J = scale * U * VMP::internal::edge_matrix(complex.mesh.source, cell).inverse();
  return Eigen::JacobiSVD<Matrix3d, Eigen::NoQRPreconditioner>(J).singularValues();
}

// The mean over the cells, with both meshes scaled to one volume.
template <typename Function>
double mean(const Complex& complex, const Function& psi)
{
  const Numbered_mesh_3& mesh = complex.mesh;
  const double scale = std::cbrt(VMP::internal::volume(mesh, mesh.source)
                                 / VMP::internal::volume(mesh, mesh.target));
  double sum = 0;
  for(const std::array<int, 4>& cell : mesh.cells)
    sum += psi(singular_values(complex, cell, scale));
  return sum / static_cast<double>(mesh.cells.size());
}

// Keeps all steps.
struct Recorder
{
  std::vector<VMP::Parameterization_step> steps = {};

  bool after_step(const VMP::Parameterization_step& step)
  {
    steps.push_back(step);
    return true;
  }
};

template <typename Energy>
Parameterization_result parameterize(Complex& complex, const Energy& energy, Recorder& recorder)
{
  complex.uvw.clear();
  return CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(complex.c3t3), complex.uvw_map(),
    params::boundary_map(complex.boundary_map()).energy(energy).visitor(std::ref(recorder)));
}

} // namespace

TEST_CASE("Minimum, maximum and selection of numbers")
{
  CHECK(VMP::minimum(1., 2.) == 1);
  CHECK(VMP::minimum(2., 1.) == 1);
  CHECK(VMP::maximum(1., 2.) == 2);
  CHECK(VMP::maximum(2., 1.) == 2);
  CHECK(VMP::select(true, 1., 2.) == 1);
  CHECK(VMP::select(false, 1., 2.) == 2);
}

TEST_CASE("An energy whose type is chosen at run time leads to the same map, bit by bit")
{
  Complex complex(twisted_cube(4, 0.1)), other(complex.mesh);
  Recorder recorder;
  const Parameterization_result expected = parameterize(complex, Own_energy(), recorder);
  const Parameterization_result result = parameterize(other, VMP::Any_energy_3(Own_energy()), recorder);
  CHECK(result.status == VMP::OK);
  CHECK(result.energy == expected.energy);
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    CHECK(other.uvw.at(other.vertices[v]) == complex.uvw.at(complex.vertices[v]));
}

TEST_CASE("An energy of the user that chooses between formulas is minimized")
{
  for(const Numbered_mesh_3& mesh : { twisted_cube(4, 0.1), ring(5) })
  {
    Complex complex(mesh);
    Recorder recorder;
    const Parameterization_result result = parameterize(complex, Own_energy(), recorder);
    INFO(result.message);
    CHECK(result.status == VMP::OK);
    CHECK(has_positive_cells(complex.c3t3, [&](const auto v) { return complex.uvw.at(v); }));
    CHECK(result.energy == Approx(mean(complex, own_value)).epsilon(1e-10));

    // cells are on both sides of the branch
    std::size_t number_above = 0, number_below = 0;
    for(const std::array<int, 4>& cell : mesh.cells)
      for(const double s : singular_values(complex, cell, 1))
        ++(s > Own_energy::length ? number_above : number_below);
    CHECK(number_above > 0);
    CHECK(number_below > 0);

    // no other energy has this minimum
    Complex other(mesh);
    parameterize(other, VMP::Stretch_energy_3(), recorder);
    CHECK(mean(other, own_value) > result.energy * (1 + 1e-6));
  }
}

TEST_CASE("The last step that a visitor sees has the energy of the result")
{
  const auto check = [](const Numbered_mesh_3& mesh, const auto& energy)
  {
    const auto is_prescribed = [&](const std::array<int, 4>& cell)
    {
      return std::none_of(cell.begin(), cell.end(), [&](const int v) { return mesh.is_free(v); });
    };
    REQUIRE(std::count_if(mesh.cells.begin(), mesh.cells.end(), is_prescribed) > 10);
    Complex complex(mesh);
    Recorder recorder;
    const Parameterization_result result = parameterize(complex, energy, recorder);
    REQUIRE(result.status == VMP::OK);
    REQUIRE(!recorder.steps.empty());
    CHECK(recorder.steps.back().phase == VMP::Phase::MINIMIZATION);
    CHECK(recorder.steps.back().energy == Approx(result.energy).epsilon(1e-10));
  };
  check(twisted_cube(4), VMP::Stretch_energy_3());
  check(twisted_cube(4, 0.1), Own_energy());
  check(ring(5), VMP::Stretch_energy_3());
  check(mapped_cube(4, 0.1, [](const Vector3d& p) -> Vector3d { return 1000 * p; }), VMP::Stretch_energy_3());
}

namespace {

struct Wrong_gradient_energy : VMP::Stretch_energy_3
{
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const { return T(2) * VMP::Stretch_energy_3::gradient(s); }
};

} // namespace

TEST_CASE("With verbose, wrong derivatives of an energy are told, and correct ones are not")
{
  const auto printed = [](const auto& energy)
  {
    std::ostringstream output;
    std::streambuf* const buffer = std::cout.rdbuf(output.rdbuf());
    Complex complex(twisted_cube(2));
    CGAL::stretch_minimizing_volume_parameterization(complex.c3t3, complex.uvw_map(),
      params::boundary_map(complex.boundary_map()).energy(energy).verbose(true).number_of_iterations(1));
    std::cout.rdbuf(buffer);
    return output.str();
  };
  const std::string sentences = printed(Wrong_gradient_energy());
  CHECK(sentences.find("The gradient of the energy is wrong") != std::string::npos);
  CHECK(sentences.find("The Hessian of the energy is wrong") != std::string::npos); // of half of the gradient
  CHECK(printed(Own_energy()).find("energy is") == std::string::npos);
}

// A sign that is wrong leads uphill.
struct Wrong_sign_energy : VMP::Stretch_energy_3
{
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const { return -VMP::Stretch_energy_3::gradient(s); }
};

TEST_CASE("A minimization that no step continues names the function that checks derivatives")
{
  Complex complex(twisted_cube(3));
  const auto message = [&](const auto& energy)
  {
    return CGAL::stretch_minimizing_volume_parameterization(complex.c3t3, complex.uvw_map(),
      params::boundary_map(complex.boundary_map()).energy(energy)).message;
  };
  CHECK(message(Wrong_sign_energy()).find("check_derivatives()") != std::string::npos);
  CHECK(message(VMP::Stretch_energy_3()).find("check_derivatives()") == std::string::npos);
}
