// Each distortion energy: its formula in terms of the matrix J, its derivatives, its symmetries.
#include "catch.h"

#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Any_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Lp_stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Power_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/check_derivatives.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

using Stretch = VMP::Stretch_energy_3;
using Dirichlet = VMP::Dirichlet_energy_3;
using ARAP = VMP::ARAP_energy_3;
using LSCM = VMP::LSCM_energy_3;
using LPM = VMP::LPM_energy_3;
using MIPS = VMP::MIPS_energy_3;
using Symmetric_Dirichlet = VMP::Symmetric_Dirichlet_energy_3;
using Lp_stretch = VMP::Lp_stretch_energy_3;
template <typename E> using Barrier = VMP::Barrier_energy_3<E>;
template <typename E> using Power = VMP::Power_energy_3<E>;
template <typename E> using Bounded_angle = VMP::Bounded_angle_energy_3<E>;

struct Cubed_MIPS : Power<MIPS> { Cubed_MIPS() : Power<MIPS>(3) {} };
struct Bounded_stretch : Bounded_angle<Stretch> { Bounded_stretch() : Bounded_angle<Stretch>(4) {} };
struct Bounded_Dirichlet : Bounded_angle<Dirichlet> { Bounded_Dirichlet() : Bounded_angle<Dirichlet>(2.5) {} };
struct Any_LSCM : VMP::Any_energy_3 { Any_LSCM() : VMP::Any_energy_3(Barrier<LSCM>()) {} };

using Energies = std::tuple<Stretch, Dirichlet, ARAP, LSCM, LPM, MIPS, Symmetric_Dirichlet, Lp_stretch,
                            Barrier<ARAP>, Barrier<LSCM>, Power<Stretch>, Cubed_MIPS, Bounded_stretch,
                            Bounded_Dirichlet, Any_LSCM, Barrier<Any_LSCM> >;

// The stretch with wrong derivatives, or with a term that is not symmetric.
struct Scaled_stretch : Stretch
{
  double gradient_factor, hessian_factor, skew;

  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const { return Stretch::value(s) + T(skew) * s[0]; }

  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  { return gradient_factor * Stretch::gradient(s) + skew * Eigen::Matrix<T, 3, 1>::UnitX(); }

  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const { return hessian_factor * Stretch::hessian(s); }
};

// distinct, equal, nearly equal, tiny
const std::vector<Vector3d> samples = {
  {3, 2, 1}, {0.5, 0.3, 0.2}, {1, 1, 1}, {2, 2, 0.7}, {2, 0.7, 0.7}, {1.1, 1, 0.9}, {1 + 1e-7, 1, 1}, {1, 0.5, 0.05},
  {1, 1, 1e-6}, {1, 1e-6, 1e-6}, {1e-6, 1e-6, 1e-6}, {1e3, 1, 1e-3}
};

template <typename Energy>
double value(const Energy& energy, const Vector3d& s) { return energy.value(s); }

template <typename Energy>
bool is_infinite_for_flat_cells(const Energy& energy) { return value(energy, Vector3d(1, 1, 1e-9)) > 1e6; }

// A matrix with the singular values s; the rotations are of no special kind.
Matrix3d matrix(const Vector3d& s)
{
  const Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Matrix3d Q = Eigen::AngleAxisd(2.1, Vector3d(-3, 1, 1).normalized()).toRotationMatrix();
  return R * s.asDiagonal() * Q.transpose();
}

double norm_of_square(const Matrix3d& J) { return (J.transpose() * J).squaredNorm(); }

// The derivatives by central differences; the steps are relative to the singular values.
template <typename Energy>
void check_derivatives(const Energy& energy, const Vector3d& s)
{
  const Vector3d g = energy.gradient(s);
  const Matrix3d H = energy.hessian(s);
  const double step = 1e-5;
  const double size = std::abs(value(energy, s)) + g.cwiseProduct(s).lpNorm<Eigen::Infinity>()
                    + (s.asDiagonal() * H * s.asDiagonal()).lpNorm<Eigen::Infinity>();
  for(int i = 0; i < 3; ++i)
  {
    const Vector3d h = step * s[i] * Vector3d::Unit(i);
    const double slope = (value(energy, s + h) - value(energy, s - h)) / (2 * step);
    CHECK(std::abs(slope - g[i] * s[i]) < 1e-7 * size);
    const Vector3d curvature = (energy.gradient(Vector3d(s + h)) - energy.gradient(Vector3d(s - h))) / (2 * step);
    CHECK((curvature - H.col(i) * s[i]).cwiseProduct(s).norm() < 1e-6 * size);
  }
}

} // namespace

TEST_CASE("The energies of the paper are what its equations say", "[energies]")
{
  for(const Vector3d& s : {Vector3d(3, 2, 1), Vector3d(0.5, 0.4, 0.3), Vector3d(2, 1, -0.5)})
  {
    const Matrix3d J = matrix(s);
    const double n2 = J.squaredNorm();
    const double n4 = norm_of_square(J);
    const double D = J.determinant();
    CHECK(Stretch().value(s) == Approx((n2 * n2 - n4) / (2 * D * D)));
    CHECK(Dirichlet().value(s) == Approx(n2));
    CHECK(LSCM().value(s) == Approx(3 * n4 - n2 * n2));
    CHECK(LPM().value(s) == Approx(n4 - 2 * n2 + 3));
  }
}

TEST_CASE("ARAP is the squared distance to the nearest rotation", "[energies]")
{
  for(const Vector3d& s : {Vector3d(3, 2, 1), Vector3d(2, 1, -0.5)})
  {
    const Matrix3d J = matrix(s);
    CHECK(ARAP().value(s) == Approx((J - Eigen::Affine3d(J).rotation()).squaredNorm()));
  }
}

TEST_CASE("The other energies in terms of the matrix and its inverse", "[energies]")
{
  const Vector3d s(3, 2, 0.5);
  const Matrix3d J = matrix(s);
  const Matrix3d inverse = J.inverse();
  const double product = J.squaredNorm() * inverse.squaredNorm();
  CHECK(MIPS().value(s) == Approx((product - 1) / 8));
  CHECK(Symmetric_Dirichlet().value(s) == Approx(J.squaredNorm() + inverse.squaredNorm()));
  CHECK(Lp_stretch(2).value(s) == Approx(inverse.squaredNorm()));
  CHECK(Lp_stretch(4).value(s) == Approx(std::sqrt(norm_of_square(inverse))));
  CHECK(Lp_stretch(1e4).value(s) == Approx(4).epsilon(1e-3)); // the square of the spectral norm of the inverse
  CHECK(Power<Stretch>(3).value(s) == Approx(std::pow(inverse.squaredNorm(), 3)));
}

TEST_CASE("The barrier vanishes from lambda on and grows like beta lambda / (3 D)", "[energies]")
{
  const Barrier<Dirichlet> energy(Dirichlet(), 0.1, 0.5);
  const auto barrier = [&](const double D)
  { return value(energy, Vector3d(1, 1, D)) - value(Dirichlet(), Vector3d(1, 1, D)); };
  CHECK(barrier(0.5) == 0);
  CHECK(barrier(7) == 0);
  CHECK(barrier(0.25) == Approx(0.1 / 7)); // g(1/2) = 7/8
  CHECK(barrier(1e-7) == Approx(0.1 * 0.5 / 3e-7).epsilon(1e-5));
  CHECK(energy.gradient(Vector3d(1, 1, 0.5)) == Vector3d(2, 2, 1));
}

TEMPLATE_LIST_TEST_CASE("Gradient and Hessian are the derivatives", "[energies]", Energies)
{
  const TestType energy{};
  for(const Vector3d& s : samples)
  {
    CAPTURE(s.transpose());
    check_derivatives(energy, s);
    if(!is_infinite_for_flat_cells(energy))
      check_derivatives(energy, Vector3d(s[0], s[1], -0.3 * s[2]));
  }
}

TEMPLATE_LIST_TEST_CASE("The check of derivatives finds none wrong", "[energies]", Energies)
{
  const VMP::Derivative_errors_3 errors = VMP::check_derivatives(TestType());
  CHECK(errors.are_small());
  CHECK((std::max)({ errors.symmetry, errors.gradient, errors.hessian }) < 1e-6);
}

TEST_CASE("The check of derivatives finds wrong factors and signs, and functions that are not symmetric", "[energies]")
{
  const auto errors = [](const double gradient_factor, const double hessian_factor, const double skew)
  {
    return VMP::check_derivatives(Scaled_stretch{ {}, gradient_factor, hessian_factor, skew });
  };
  CHECK(errors(1, 1, 0).are_small());
  CHECK(errors(1.1, 1.1, 0).gradient == Approx(0.1).epsilon(0.01));
  CHECK(errors(1.1, 1.1, 0).hessian < 1e-6);
  CHECK(errors(1, -1, 0).hessian == Approx(2).epsilon(0.01));
  CHECK(errors(1, -1, 0).gradient < 1e-6);
  CHECK(errors(1, 1, 0.1).symmetry > 0.01);
  CHECK(errors(1, 1, 0.1).gradient < 1e-6);
  CHECK(!errors(std::nan(""), 1, 0).are_small());
}

TEMPLATE_LIST_TEST_CASE("The order of the singular values does not matter", "[energies]", Energies)
{
  const TestType energy{};
  const Vector3d s(1.7, 0.9, 0.4);
  const Vector3d g = energy.gradient(s);
  const Matrix3d H = energy.hessian(s);
  Eigen::Vector3i order(0, 1, 2);
  while(std::next_permutation(order.data(), order.data() + 3))
  {
    Eigen::PermutationMatrix<3> P(order);
    const Vector3d permuted = P * s;
    CHECK(value(energy, permuted) == Approx(value(energy, s)));
    CHECK(energy.gradient(permuted).isApprox(P * g));
    CHECK(energy.hessian(permuted).isApprox(P * H * P.transpose()));
  }
}

// Not so ARAP, which measures the distance to rotations.
TEMPLATE_TEST_CASE("Two changed signs do not matter", "[energies]", Stretch, Dirichlet, LSCM, LPM, MIPS,
                   Symmetric_Dirichlet, Lp_stretch, Barrier<LSCM>, Power<Stretch>)
{
  const TestType energy{};
  const Vector3d s(1.7, 0.9, 0.4);
  for(int i = 0; i < 3; ++i)
  {
    const Matrix3d S = Vector3d(i == 0 ? 1 : -1, i == 1 ? 1 : -1, i == 2 ? 1 : -1).asDiagonal();
    const Vector3d changed = S * s;
    CHECK(value(energy, changed) == Approx(value(energy, s)));
    CHECK(energy.gradient(changed).isApprox(S * energy.gradient(s)));
    CHECK(energy.hessian(changed).isApprox(S * energy.hessian(s) * S));
  }
}

TEST_CASE("Homogeneous energies", "[energies]")
{
  const auto check = [](const auto& energy, const int degree)
  {
    const Vector3d s(1.7, 0.9, 0.4);
    CHECK(value(energy, 3 * s) == Approx(std::pow(3, degree) * value(energy, s)));
    CHECK(energy.gradient(s).dot(s) == Approx(degree * value(energy, s)).margin(1e-12)); // Euler
  };
  check(Stretch(), -2);
  check(Lp_stretch(2), -2);
  check(Lp_stretch(40), -2);
  check(Dirichlet(), 2);
  check(LSCM(), 4);
  check(MIPS(), 0);
  check(Power<Stretch>(3), -6);
}

TEST_CASE("Minima, and where they are attained", "[energies]")
{
  const auto is_minimum = [](const auto& energy, const Vector3d& s, const double minimum)
  {
    CHECK(value(energy, s) == Approx(minimum).margin(1e-15));
    for(const Vector3d& other : samples)
      CHECK(value(energy, other) >= minimum - 1e-12);
  };
  const Vector3d isometry = Vector3d::Ones();
  is_minimum(ARAP(), isometry, 0);
  is_minimum(LPM(), isometry, 0);
  is_minimum(Symmetric_Dirichlet(), isometry, 6);
  is_minimum(Power<Symmetric_Dirichlet>(2), isometry, 36);
  is_minimum(LSCM(), 5 * isometry, 0);
  is_minimum(MIPS(), 5 * isometry, 1);
  CHECK(value(Stretch(), isometry) == 3);
  CHECK(value(Lp_stretch(6), isometry) == Approx(std::cbrt(3)));
}

TEST_CASE("Nothing overflows or vanishes in the Lp stretch for large p", "[energies]")
{
  const Lp_stretch energy(1000);
  const Vector3d s(10, 1e-2, 1e-3);
  CHECK(value(energy, s) == Approx(1e6));
  CHECK(energy.gradient(s).isApprox(Vector3d(0, 0, -2e9)));
  check_derivatives(Lp_stretch(50), Vector3d(1, 1.01, 1.02));
}

TEMPLATE_TEST_CASE("A barrier rises without bound while a cell becomes flat", "[energies]", Stretch, MIPS,
                   Symmetric_Dirichlet, Lp_stretch, Barrier<ARAP>, Barrier<LSCM>, Power<Stretch>, Bounded_Dirichlet)
{
  const TestType energy{};
  CHECK(is_infinite_for_flat_cells(energy));
  double last = value(energy, Vector3d(1, 1, 1e-4));
  for(double s = 1e-5; s > 1e-9; s /= 10)
  {
    const double next = value(energy, Vector3d(1, 1, s));
    CHECK(next > 5 * last);
    last = next;
  }
}

TEST_CASE("The angle bound is exact, whatever the singular value in the middle", "[energies]")
{
  for(const double K : {2.1, 10., 300.})
  {
    const Bounded_angle<Stretch> energy(K, Stretch(), 0);
    const double ratio = (K + std::sqrt(K * K - 4)) / 2; // ratio + 1 / ratio = K
    for(const double largest : {ratio * (1 - 1e-9), ratio * (1 + 1e-9)})
      for(const double middle : {1., std::sqrt(largest), largest})
        CHECK(std::isfinite(value(energy, Vector3d(largest, middle, 1))) == (largest < ratio));
  }
}

TEST_CASE("The barrier against the distortion of angles", "[energies]")
{
  const auto ratio = [](const double k) { return (k + std::sqrt(k * k - 4)) / 2; };
  const auto spline = [](const double x) { return 1 / (1 - std::pow(1 - x, 3)) - 1; };
  const double K = 20, relaxation = 0.1, step = 1e-3;
  // two pairs of singular values have the distortion k, the third pair has 2
  const auto barrier = [&](const double k, const double epsilon)
  {
    const Vector3d s(ratio(k), 1, 1);
    return value(Bounded_angle<MIPS>(K, MIPS(), epsilon), s) - value(MIPS(), s);
  };
  CHECK(barrier(K / 2, 0) == 0);
  CHECK(barrier(0.75 * K, 0) == Approx(2 * spline(0.5)));
  CHECK(barrier(0.94 * K, relaxation) == barrier(0.94 * K, 0));
  // its relaxation is the Taylor polynomial
  const double before = spline(relaxation - step), here = spline(relaxation), behind = spline(relaxation + step);
  const double first = (behind - before) / (2 * step), second = (behind - 2 * here + before) / (step * step);
  const double distance = 2 + relaxation;
  CHECK(barrier(2 * K, relaxation)
        == Approx(2 * (here - distance * first + distance * distance / 2 * second)).epsilon(1e-3));
}

TEST_CASE("Copies of an energy chosen at run time keep the one that they hold", "[energies]")
{
  const Vector3d s(1.7, 0.9, 0.4);
  const Barrier<ARAP> strong(ARAP(), 5, 2);
  VMP::Any_energy_3 any = strong;
  const VMP::Any_energy_3 copy = any;
  any = Lp_stretch(8);
  CHECK(any.value(s) == Approx(value(Lp_stretch(8), s)));
  CHECK(copy.value(s) == Approx(value(strong, s)));
}

// Bounds are in k = r + 1/r, r the ratio of the largest to the smallest singular value.
TEST_CASE("MIPS bounds the ratio of singular values from both sides, sharply", "[energies]")
{
  for(const double ratio : {1., 1.5, 4., 20., 1000.})
  {
    const double k = ratio + 1 / ratio;
    const double lowest = k * (k + 2) / 8;
    const double highest = k * k / 4;
    for(int i = 0; i <= 10; ++i)
    {
      const double psi = value(MIPS(), Vector3d(ratio, std::pow(ratio, 0.1 * i), 1));
      CHECK(psi >= lowest * (1 - 1e-14));
      CHECK(psi <= highest * (1 + 1e-14));
    }
    CHECK(value(MIPS(), Vector3d(ratio, std::sqrt(ratio), 1)) == Approx(lowest));
    CHECK(value(MIPS(), Vector3d(ratio, ratio, 1)) == Approx(highest));
    CHECK(value(MIPS(), Vector3d(ratio, 1, 1)) == Approx(highest));
  }
}

TEMPLATE_TEST_CASE("Norms of a matrix and of its inverse give what singular values give", "[energies]",
                   Stretch, Dirichlet, MIPS, Symmetric_Dirichlet)
{
  for(const Vector3d& s : samples)
  {
    const Matrix3d J = matrix(s);
    CHECK(TestType().value_of_norms(s.squaredNorm(), s.cwiseInverse().squaredNorm(), s.prod()) == Approx(value(TestType(), s)));
    if(s[0] < 100 * s[2])
      CHECK(TestType().value_of_norms(J.squaredNorm(), J.inverse().squaredNorm(), J.determinant())
            == Approx(value(TestType(), s)));
  }
}

// Any_energy_3 evaluates several cells at a time, with vector instructions.
TEMPLATE_LIST_TEST_CASE("Packs of cells give what single cells give", "[energies]", Energies)
{
  const TestType energy{};
  const VMP::Any_energy_3 packed = energy;
  // An entry that is a small difference of large numbers is only as exact as these.
  const auto check = [](const auto& pack, const auto& single)
  {
    CHECK(single.allFinite());
    CHECK((pack - single).cwiseAbs().maxCoeff() <= 1e-12 * (1 + single.cwiseAbs().maxCoeff()));
  };
  for(const Vector3d& s : samples)
  {
    CAPTURE(s.transpose());
    CHECK(packed.value(s) == Approx(value(energy, s)).epsilon(1e-12).margin(1e-12));
    check(packed.gradient(s), Vector3d(energy.gradient(s)));
    check(packed.hessian(s), Matrix3d(energy.hessian(s)));
  }
}
