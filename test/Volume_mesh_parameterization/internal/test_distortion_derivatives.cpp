// Packs of cells, signed singular values, and the derivatives of each energy that are built on them.
#include "catch.h"

#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Lp_stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Untangling_energy_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <tuple>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace arithmetic = VMP::internal::arithmetic_of_unit;

using Eigen::Matrix3d;
using Eigen::Vector3d;
using VMP::internal::Pack;
using Vector_12 = Eigen::Matrix<double, 12, 1>;
using Matrix_12 = Eigen::Matrix<double, 12, 12>;
using Matrix_9 = Eigen::Matrix<double, 9, 9>;

namespace {

// how much of negative curvature the Hessian keeps
constexpr double full = 1;
constexpr double positive_semidefinite = 0;

struct Untangling_energy : VMP::internal::Untangling_energy_3
{
  Untangling_energy() : Untangling_energy_3(0.1, 0.01) {}
};

struct Sharp_untangling_energy : VMP::internal::Untangling_energy_3
{
  Sharp_untangling_energy() : Untangling_energy_3(1e-2, 0.5) {}
};

using Energies = std::tuple<VMP::Stretch_energy_3,
                            VMP::Dirichlet_energy_3,
                            VMP::ARAP_energy_3,
                            VMP::LSCM_energy_3,
                            VMP::LPM_energy_3,
                            VMP::MIPS_energy_3,
                            VMP::Symmetric_Dirichlet_energy_3,
                            VMP::Lp_stretch_energy_3,
                            VMP::Barrier_energy_3<VMP::ARAP_energy_3>,
                            Untangling_energy,
                            Sharp_untangling_energy>;

// An energy for one cell and for a pack of them, whatever its type: what is built on the energies is compiled once.
class Erased_energy
{
  template <typename T>
  struct Functions
  {
    using Vector = Eigen::Matrix<T, 3, 1>;

    template <typename Energy>
    explicit Functions(const Energy& energy)
      : gradient([energy](const Vector& s) -> Vector { return energy.gradient(s); }),
        hessian([energy](const Vector& s) -> Eigen::Matrix<T, 3, 3> { return energy.hessian(s); })
    {}

    std::function<Vector(const Vector&)> gradient;
    std::function<Eigen::Matrix<T, 3, 3>(const Vector&)> hessian;
  };

public:
  template <typename Energy>
  explicit Erased_energy(const Energy& energy)
    : m_value([energy](const Vector3d& s) { return energy.value(s); }), m_cell(energy), m_pack(energy)
  {}

  double value(const Vector3d& s) const { return m_value(s); }
  Vector3d gradient(const Vector3d& s) const { return m_cell.gradient(s); }
  Matrix3d hessian(const Vector3d& s) const { return m_cell.hessian(s); }
  auto gradient(const Eigen::Matrix<Pack, 3, 1>& s) const { return m_pack.gradient(s); }
  auto hessian(const Eigen::Matrix<Pack, 3, 1>& s) const { return m_pack.hessian(s); }

private:
  std::function<double(const Vector3d&)> m_value;
  Functions<double> m_cell;
  Functions<Pack> m_pack;
};

class Random
{
public:
  Matrix3d matrix()
  {
    Matrix3d M;
    for(double& x : M.reshaped())
      x = m_distribution(m_engine);
    return M;
  }

  Matrix3d rotation() { return Eigen::Affine3d(matrix()).rotation(); }

  // far from singular
  Matrix3d source() { return 2 * Matrix3d::Identity() + 0.5 * matrix(); }

private:
  std::mt19937 m_engine;
  std::uniform_real_distribution<double> m_distribution{-1, 1};
};

// singular values s_0 >= s_1 >= |s_2|: distinct, equal, nearly equal, opposite, small, none
const std::vector<Vector3d> samples = {
  {3, 2, 1}, {3, 2, -1}, {1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1 + 1e-5, 1, 0.5}, {1 + 1e-7, 1, 0.5},
  {2, 1, -1}, {2, 1, -1 + 1e-7}, {1, 1, -1}, {1, 0.1, 0.05}, {1, 0.5, -0.02}, {2, 1, 0}, {2, 0, 0}, {0, 0, 0}
};

template <typename T>
arithmetic::Vector_3<T> from_eigen(const Eigen::Matrix<T, 3, 1>& v)
{
  return { v[0], v[1], v[2] };
}

template <typename T>
arithmetic::Matrix_3<T> from_eigen(const Eigen::Matrix<T, 3, 3>& A)
{
  arithmetic::Matrix_3<T> result;
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i)
      result(i, j) = A(i, j);
  return result;
}

template <typename T>
Eigen::Matrix<T, 3, 1> to_eigen(const arithmetic::Vector_3<T>& v)
{
  return Eigen::Matrix<T, 3, 1>(v[0], v[1], v[2]);
}

template <typename T>
Eigen::Matrix<T, 3, 3> to_eigen(const arithmetic::Matrix_3<T>& A)
{
  Eigen::Matrix<T, 3, 3> result;
  for(int j = 0; j < 3; ++j)
    result.col(j) = to_eigen(A.column(j));
  return result;
}

void check_decomposition(const Matrix3d& J)
{
  arithmetic::Signed_singular_values_3<double> decomposition;
  decompose(from_eigen(J), decomposition);
  const Matrix3d R = to_eigen(decomposition.R), Q = to_eigen(decomposition.Q);
  const Vector3d s = to_eigen(decomposition.s);
  const double tolerance = 4e-14 * J.norm();
  CHECK((R * s.asDiagonal() * Q.transpose() - J).norm() <= tolerance);
  CHECK(s[0] >= s[1] - tolerance);
  CHECK(s[1] >= std::abs(s[2]) - tolerance);
  for(const Matrix3d& rotation : {R, Q})
  {
    CHECK((rotation.transpose() * rotation - Matrix3d::Identity()).norm() <= 1e-14);
    CHECK(rotation.determinant() > 0);
  }
}

// Returns whether psi is finite, and without the kink that s_i = -s_j makes if psi_i + psi_j does not vanish there.
bool is_smooth(const Erased_energy& energy, const Vector3d& s)
{
  const Vector3d g = energy.gradient(s);
  if(!std::isfinite(energy.value(s)) || !g.allFinite())
    return false;
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < i; ++j)
      if(std::abs(s[i] + s[j]) < 1e-4 && std::abs(g[i] + g[j]) > 1e-2)
        return false;
  return true;
}

// psi as a function of the four vertices, one after the other, of a cell
double value(const Erased_energy& energy, const Matrix3d& inverse_source, const Vector_12& u)
{
  Matrix3d U;
  for(int i = 0; i < 3; ++i)
    U.col(i) = u.segment<3>(3 * i + 3) - u.head<3>();
  return energy.value(VMP::internal::signed_singular_values_3(U * inverse_source));
}

// The derivatives of a cell with Jacobian J, or of a pack of cells.
template <typename T>
arithmetic::Cell_derivatives_3<T>
cell_derivatives(const Erased_energy& energy, const Eigen::Matrix<T, 3, 3>& J, const Eigen::Matrix<T, 3, 3>& inverse_source,
                 const T& weight, const double negative_curvature)
{
  arithmetic::Signed_singular_values_3<T> decomposition;
  decompose(from_eigen(J), decomposition);
  const auto& [R, Q, s] = decomposition;
  const Eigen::Matrix<T, 3, 1> g = energy.gradient(to_eigen(s));
  const Eigen::Matrix<T, 3, 3> H = energy.hessian(to_eigen(s));
  arithmetic::Cell_derivatives_3<T> cell;
  cell_derivatives_3(distortion_derivatives_3(s, from_eigen(g), from_eigen(H), negative_curvature),
                     R, product(from_eigen(inverse_source), Q), weight, cell);
  return cell;
}

arithmetic::Cell_derivatives_3<double>
cell_derivatives(const Erased_energy& energy, const Matrix3d& inverse_source, const Vector_12& u,
                 const double negative_curvature)
{
  Matrix3d U;
  for(int i = 0; i < 3; ++i)
    U.col(i) = u.segment<3>(3 * i + 3) - u.head<3>();
  return cell_derivatives<double>(energy, U * inverse_source, inverse_source, 1., negative_curvature);
}

Vector_12 gradient(const Erased_energy& energy, const Matrix3d& inverse_source, const Vector_12& u)
{
  const auto cell = cell_derivatives(energy, inverse_source, u, full);
  Vector_12 g;
  for(int a = 0; a < 4; ++a)
    g.segment<3>(3 * a) = to_eigen(cell.gradient[a]);
  return g;
}

Matrix_12 hessian(const Erased_energy& energy, const Matrix3d& inverse_source, const Vector_12& u,
                  const double negative_curvature)
{
  const auto cell = cell_derivatives(energy, inverse_source, u, negative_curvature);
  Matrix_12 H;
  for(int a = 0; a < 4; ++a)
    for(int b = a; b < 4; ++b)
    {
      const Matrix3d block = to_eigen(cell.hessian[a][b]);
      H.block<3, 3>(3 * a, 3 * b) = block;
      H.block<3, 3>(3 * b, 3 * a) = block.transpose();
    }
  return H;
}

// The images of the vertices under x -> J x, moved away from the origin.
Vector_12 image(const Matrix3d& J, const Matrix3d& source)
{
  Vector_12 u;
  u.head<3>() = Vector3d(0.3, -0.2, 0.1);
  for(int i = 0; i < 3; ++i)
    u.segment<3>(3 * i + 3) = u.head<3>() + J * source.col(i);
  return u;
}

// The derivative at 0 by central differences of fourth order, with steps of length 1.
template <typename Function>
auto difference(const Function& f)
{
  return ((8 * (f(1) - f(-1)) - (f(2) - f(-2))) / 12).eval();
}

// Compares with differences along the unit vectors times `steps`: the gradient with those of the
// energy, and the Hessian with those of the gradient.
void check_against_differences(const Erased_energy& energy, const Matrix3d& source,
                               const Vector_12& u, const Vector_12& steps)
{
  const Matrix3d inverse = source.inverse();
  const auto scaled_gradient = [&](const Vector_12& v) -> Vector_12
  {
    return steps.cwiseProduct(gradient(energy, inverse, v));
  };
  Vector_12 differences;
  Matrix_12 second_differences;
  for(int i = 0; i < 12; ++i)
  {
    const auto at = [&](const int k) -> Vector_12 { return u + k * steps[i] * Vector_12::Unit(i); };
    differences.segment<1>(i)
      = difference([&](const int k) { return Eigen::Matrix<double, 1, 1>(value(energy, inverse, at(k))); });
    second_differences.col(i) = difference([&](const int k) { return scaled_gradient(at(k)); });
  }
  const Vector_12 g = scaled_gradient(u);
  const Matrix_12 H = steps.asDiagonal() * hessian(energy, inverse, u, full) * steps.asDiagonal();
  const double rounding = 1e-14 * std::abs(value(energy, inverse, u)) + 1e-8 * H.norm();
  CHECK((g - differences).norm() <= 1e-6 * g.norm() + rounding);
  CHECK((H - second_differences).norm() <= 2e-6 * H.norm());
}

} // namespace

TEST_CASE("Minimum, maximum and selection of packs act in each cell, and as for numbers where one is none")
{
  const double nan = std::nan("");
  const std::vector<double> values = { -2, 0, 1, nan, 1e300 };
  for(std::size_t first = 0; first < values.size(); ++first)
  {
    double a[Pack::size], b[Pack::size], least[Pack::size], largest[Pack::size], selected[Pack::size];
    for(std::size_t i = 0; i < Pack::size; ++i)
    {
      a[i] = values[(first + i) % values.size()];
      b[i] = values[(first + 2 * i + 1) % values.size()];
    }
    const Pack x = Pack::load(a), y = Pack::load(b);
    minimum(x, y).store(least);
    maximum(x, y).store(largest);
    select(x < y, Pack(5), x).store(selected);
    const auto is_same = [](const double p, const double q) { return p == q || (std::isnan(p) && std::isnan(q)); };
    for(std::size_t i = 0; i < Pack::size; ++i)
    {
      INFO(a[i] << ", " << b[i]);
      CHECK(is_same(least[i], VMP::minimum(a[i], b[i])));
      CHECK(is_same(largest[i], VMP::maximum(a[i], b[i])));
      CHECK(is_same(selected[i], VMP::select(a[i] < b[i], 5., a[i])));
    }
  }
}

TEST_CASE("Signed singular values decompose a matrix")
{
  Random random;
  for(const double scale : {1., 1e-30, 1e30})
    for(const Vector3d& expected : samples)
    {
      INFO(scale << " times " << expected.transpose());
      const Matrix3d J = scale * random.rotation() * expected.asDiagonal() * random.rotation().transpose();
      check_decomposition(J);
      const Vector3d s = VMP::internal::signed_singular_values_3(J);
      CHECK((s - scale * expected).norm() <= 4e-14 * scale * expected[0]);
    }
}

TEST_CASE("Signed singular values decompose a shear along the axes")
{
  for(const double shear : {0.5, -0.1, 1e-3, -1e-5})
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
      {
        INFO(shear << " in row " << i << " and column " << j);
        Matrix3d J = Matrix3d::Identity();
        J(i, j) += shear;
        check_decomposition(J);
      }
}

TEST_CASE("Signed singular values are those of Eigen up to the sign")
{
  Random random;
  for(int i = 0; i < 100; ++i)
  {
    const Matrix3d J = random.matrix();
    const Vector3d s = VMP::internal::signed_singular_values_3(J);
    const Vector3d expected = Eigen::JacobiSVD<Matrix3d, Eigen::NoQRPreconditioner>(J).singularValues();
    CHECK((s.cwiseAbs() - expected).norm() <= 1e-14);
    CHECK((s[2] > 0) == (J.determinant() > 0));
  }
}

TEST_CASE("Tiny singular values have a small relative error")
{
  Random random;
  for(const double sign : {1., -1.})
  {
    const Vector3d expected(1, 1e-6, sign * 1e-12);
    const Matrix3d J = random.rotation() * expected.asDiagonal();
    for(const Matrix3d& permuted : {J, Matrix3d(J * Eigen::PermutationMatrix<3>(Eigen::Vector3i(1, 2, 0)))})
    {
      const Vector3d s = VMP::internal::signed_singular_values_3(permuted);
      CHECK((s - expected).cwiseQuotient(expected).norm() <= 1e-12);
    }
  }
}

TEST_CASE("Norms and determinant have the relative error of the smallest singular value")
{
  Random random;
  for(const Vector3d& s : { Vector3d(1, 1, 1), Vector3d(2, 1, -0.1), Vector3d(1, 1, 1e-6), Vector3d(1, 1e-6, 1e-6) })
    for(int i = 0; i < 20; ++i)
    {
      INFO(s.transpose());
      const Matrix3d J = random.rotation() * s.asDiagonal() * random.rotation().transpose();
      arithmetic::Matrix_3<double> matrix;
      std::copy_n(J.data(), 9, &matrix(0, 0));
      const arithmetic::Vector_3<double> norms = norms_3(matrix);
      CHECK(norms[0] == Approx(s.squaredNorm()).epsilon(1e-14));
      CHECK(norms[1] == Approx(s.cwiseInverse().squaredNorm()).epsilon(1e-8));
      CHECK(norms[2] == Approx(s.prod()).epsilon(1e-8));
    }
  const Vector3d vector = random.rotation().col(0); // a cell without an edge is flat, not less
  for(int k = 0; k < 3; ++k)
  {
    arithmetic::Matrix_3<double> matrix = arithmetic::Matrix_3<double>::identity();
    matrix.column(k) = { 0., 0., 0. };
    matrix.column((k + 1) % 3) = { vector[0], vector[1], vector[2] };
    CHECK(norms_3(matrix)[2] == 0);
    CHECK(std::isinf(norms_3(matrix)[1]));
  }
}

void check_differences(const Erased_energy& energy)
{
  Random random;
  for(const Vector3d& s : samples)
    if(is_smooth(energy, s) && !energy.hessian(s).isZero()) // the error is relative to the Hessian
    {
      INFO(s.transpose());
      const Matrix3d J = random.rotation() * s.asDiagonal() * random.rotation().transpose();
      const Matrix3d source = random.source();
      check_against_differences(energy, source, image(J, source), Vector_12::Constant(5e-5));
    }
}

TEMPLATE_LIST_TEST_CASE("Gradient and Hessian agree with finite differences", "", Energies)
{
  check_differences(Erased_energy(TestType()));
}

void check_differences_at_tiny_values(const Erased_energy& energy)
{
  for(const Vector3d& s : {Vector3d(1, 1, 1e-12), Vector3d(1, 1e-6, 1e-12), Vector3d(1e-12, 1e-12, 1e-12),
                           Vector3d(1, 1, -1e-12)})
  {
    INFO(s.transpose());
    Vector_12 u = Vector_12::Zero(), steps = Vector_12::Constant(1e-4 * s.cwiseAbs().minCoeff());
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        steps[3 * i + j + 3] = 1e-4 * (std::min)(std::abs(s[i]), std::abs(s[j]));
    for(int i = 0; i < 3; ++i)
      u[4 * i + 3] = s[i];
    check_against_differences(energy, Matrix3d::Identity(), u, steps);
  }
}

TEMPLATE_LIST_TEST_CASE("Gradient and Hessian agree with finite differences at tiny singular values", "", Energies)
{
  check_differences_at_tiny_values(Erased_energy(TestType()));
}

void check_nearest_semidefinite_hessian(const Erased_energy& energy)
{
  Random random;
  for(const Vector3d& s : samples)
    if(is_smooth(energy, s))
    {
      INFO(s.transpose());
      const Matrix3d J = random.rotation() * s.asDiagonal() * random.rotation().transpose();
      const Matrix3d I = Matrix3d::Identity();
      const Matrix_9 H_full = hessian(energy, I, image(J, I), full).bottomRightCorner<9, 9>();
      const Matrix_9 H = hessian(energy, I, image(J, I), positive_semidefinite)
                           .bottomRightCorner<9, 9>();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(H_full);
      const Matrix_9 expected = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal()
                              * eigen.eigenvectors().transpose();
      CHECK((H - expected).norm() <= 1e-8 * H_full.norm());

      const Matrix3d source = random.source();
      const Matrix_12 of_cell
        = hessian(energy, source.inverse(), image(J, source), positive_semidefinite);
      CHECK((of_cell - of_cell.transpose()).norm() <= 1e-14 * of_cell.norm());
      CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(of_cell).eigenvalues()[0] >= -1e-12 * of_cell.norm());
    }
}

TEMPLATE_LIST_TEST_CASE("The positive semi-definite Hessian is the nearest one", "", Energies)
{
  check_nearest_semidefinite_hessian(Erased_energy(TestType()));
}

void check_packs(const Erased_energy& energy)
{
  Random random;
  std::vector<Vector3d> smooth;
  for(const Vector3d& s : samples)
    if(is_smooth(energy, s) && is_smooth(energy, 0.9 * s))
      smooth.push_back(s);

  for(const double negative_curvature : {full, positive_semidefinite})
    for(std::size_t first = 0; first < smooth.size(); ++first)
    {
      std::array<Matrix3d, Pack::size> J, inverse_source;
      Eigen::Matrix<Pack, 3, 3> packed_J, packed_inverse_source;
      for(int lane = 0; lane < Pack::size; ++lane)
      {
        const Vector3d& s = smooth[(first + lane) % smooth.size()];
        J[lane] = random.rotation() * s.asDiagonal() * random.rotation().transpose();
        inverse_source[lane] = random.source().inverse();
      }
      const auto pack = [](const std::array<Matrix3d, Pack::size>& matrices, const int i)
      {
        double values[Pack::size];
        for(int lane = 0; lane < Pack::size; ++lane)
          values[lane] = matrices[lane](i);
        return Pack::load(values);
      };
      for(int i = 0; i < 9; ++i)
      {
        packed_J(i) = pack(J, i);
        packed_inverse_source(i) = pack(inverse_source, i);
      }
      const auto packed = cell_derivatives<Pack>(energy, packed_J, packed_inverse_source, Pack(2), negative_curvature);

      const auto lane_of = [](const auto& packs, const int lane)
      {
        const auto matrix = to_eigen(packs);
        Eigen::MatrixXd result(matrix.rows(), matrix.cols());
        for(Eigen::Index i = 0; i < matrix.size(); ++i)
        {
          double values[Pack::size];
          matrix(i).store(values);
          result(i) = values[lane];
        }
        return result;
      };
      for(int lane = 0; lane < Pack::size; ++lane)
      {
        INFO(smooth[(first + lane) % smooth.size()].transpose());
        const auto single = cell_derivatives<double>(energy, J[lane], inverse_source[lane], 2., negative_curvature);
        for(int a = 0; a < 4; ++a)
        {
          const Vector3d g = to_eigen(single.gradient[a]);
          const double size = to_eigen(single.hessian[a][a]).norm();
          CHECK((lane_of(packed.gradient[a], lane) - g).norm() <= 1e-8 * g.norm() + 1e-14 * size);
          for(int b = a; b < 4; ++b)
            CHECK((lane_of(packed.hessian[a][b], lane) - to_eigen(single.hessian[a][b])).norm() <= 1e-8 * size);
        }
      }
    }
}

TEMPLATE_LIST_TEST_CASE("A pack of cells gets the derivatives of each cell", "", Energies)
{
  check_packs(Erased_energy(TestType()));
}
