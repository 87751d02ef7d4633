// The methods that the paper compares with, as the benchmark computes them.
#include "catch.h"

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD

#include "../../../benchmark/Volume_mesh_parameterization/paper/As_rigid_as_possible_map_3.h"
#include "../../../benchmark/Volume_mesh_parameterization/paper/Bounded_distortion_map_3.h"
#include "../../../benchmark/Volume_mesh_parameterization/paper/Jacobian_system_3.h"
#include "../../../benchmark/Volume_mesh_parameterization/paper/Locally_injective_map_3.h"
#include "../../../benchmark/Volume_mesh_parameterization/paper/Plain_newton_map_3.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Soft_boundary_search_3.h>

#include <CGAL/tags.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::Matrix3d;
using CGAL::Volume_mesh_parameterization::internal::Matrix3Xd;
using Eigen::Vector3d;
using VMP::internal::Numbered_mesh_3;
using VMP::internal::edge_matrix;

namespace {

// Scales source and target such that the mean volume of their cells is 1, as the methods expect.
Numbered_mesh_3 scaled(Numbered_mesh_3 mesh)
{
  const double n = static_cast<double>(mesh.cells.size());
  mesh.source *= std::cbrt(n / VMP::internal::volume(mesh, mesh.source));
  mesh.target *= std::cbrt(n / VMP::internal::volume(mesh, mesh.target)); // depends on its boundary only
  return mesh;
}

Eigen::Index number_of_prescribed(const Numbered_mesh_3& mesh)
{
  return mesh.number_of_vertices() - mesh.number_of_free_vertices;
}

Matrix3d jacobian(const Numbered_mesh_3& mesh, const Matrix3Xd& u, const std::array<int, 4>& cell)
{
  return edge_matrix(u, cell) * edge_matrix(mesh.source, cell).inverse();
}

double smallest_determinant(const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  double result = std::numeric_limits<double>::infinity();
  for(const std::array<int, 4>& cell : mesh.cells)
    result = (std::min)(result, jacobian(mesh, u, cell).determinant());
  return result;
}

// The largest ratio of the singular values of a cell; infinite if one is inverted.
double largest_ratio(const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  double result = 1;
  for(const std::array<int, 4>& cell : mesh.cells)
  {
    const Matrix3d J = jacobian(mesh, u, cell);
    const Vector3d s = Eigen::JacobiSVD<Matrix3d, Eigen::NoQRPreconditioner>(J).singularValues();
    result = (std::max)(result, J.determinant() > 0 ? s[0] / s[2] : std::numeric_limits<double>::infinity());
  }
  return result;
}

// The derivatives of f by the first `number` vertices, by central differences.
template <typename Function>
Matrix3Xd derivatives(const Function& f, Matrix3Xd u, const Eigen::Index number)
{
  constexpr double step = 1e-5;
  Matrix3Xd result(3, number);
  for(Eigen::Index i = 0; i < result.size(); ++i)
  {
    const double coordinate = u(i);
    u(i) = coordinate + step;
    result(i) = f(u);
    u(i) = coordinate - step;
    result(i) = (result(i) - f(u)) / (2 * step);
    u(i) = coordinate;
  }
  return result;
}

// The sum of |J - G|^2 over the cells, which count by their volume.
double squared_distance(const Numbered_mesh_3& mesh, const Matrix3Xd& u, const std::vector<Matrix3d>& G)
{
  const double total = VMP::internal::volume(mesh, mesh.source);
  double sum = 0;
  for(std::size_t t = 0; t < mesh.cells.size(); ++t)
    sum += edge_matrix(mesh.source, mesh.cells[t]).determinant() / 6 / total
         * (jacobian(mesh, u, mesh.cells[t]) - G[t]).squaredNorm();
  return sum;
}

} // namespace

TEST_CASE("The system of Jacobians fits a map to what is prescribed in each cell", "[baselines]")
{
  Numbered_mesh_3 mesh = scaled(twisted_cube(3, 0.1));
  mesh.has_volume_weights = true;
  const Jacobian_system_3 system(mesh);

  std::vector<Matrix3d> G;
  Matrix3Xd weighted(3, 3 * static_cast<Eigen::Index>(mesh.cells.size()));
  for(std::size_t t = 0; t < mesh.cells.size(); ++t)
  {
    G.push_back(Matrix3d::Random());
    weighted.middleCols<3>(3 * static_cast<Eigen::Index>(t)) = std::sqrt(system.weight(t)) * G[t];
  }

  const Matrix3Xd u = system.fit(weighted);
  CHECK(u.rightCols(number_of_prescribed(mesh)) == mesh.target.rightCols(number_of_prescribed(mesh)));
  const auto distance = [&](const Matrix3Xd& positions) { return squared_distance(mesh, positions, G); };
  CHECK((system.jacobians(u) - weighted).squaredNorm() == Approx(distance(u)));
  CHECK(derivatives(distance, u, mesh.number_of_free_vertices).norm() < 1e-8);

  const Matrix3Xd d = system.fit_displacement(weighted);
  CHECK(d.rightCols(number_of_prescribed(mesh)).isZero(0));
  CHECK(derivatives(distance, d, mesh.number_of_free_vertices).norm() < 1e-8);
}

TEST_CASE("ARAP lowers the distance to the nearest rotations, also from inverted cells", "[baselines]")
{
  const Numbered_mesh_3 mesh = scaled(ring(4));
  As_rigid_as_possible_map_3 map(mesh);
  REQUIRE(smallest_determinant(mesh, map.positions()) < 0);
  double last = std::numeric_limits<double>::infinity();
  for(int i = 0; i < 5; ++i)
  {
    double expected = 0;
    for(const std::array<int, 4>& cell : mesh.cells)
    {
      const Matrix3d J = jacobian(mesh, map.positions(), cell);
      expected += (J - Eigen::Affine3d(J).rotation()).squaredNorm() / static_cast<double>(mesh.cells.size());
    }
    map.step();
    CHECK(map.energy() == Approx(expected));
    CHECK(map.energy() < last);
    last = map.energy();
  }
}

// The triples in question form a cone with three extreme rays. A point of a cone is nearest to s if the
// difference is perpendicular to it, and in an obtuse angle with all rays.
TEST_CASE("The projection on bounded singular values is the nearest point", "[baselines]")
{
  std::mt19937 engine;
  std::uniform_real_distribution<double> distribution(-1, 1);
  for(const double K : {1.5, 4., 20.})
    for(int i = 0; i < 1000; ++i)
    {
      Vector3d s(std::abs(distribution(engine)), std::abs(distribution(engine)), distribution(engine));
      std::sort(s.data(), s.data() + 3, [](const double a, const double b) { return std::abs(a) > std::abs(b); });
      s[0] = std::abs(s[0]);
      s[1] = std::abs(s[1]);
      const Vector3d p = nearest_bounded(s, K);
      CHECK(p[0] >= p[1]);
      CHECK(p[1] >= p[2]);
      CHECK(p[0] <= K * p[2] * (1 + 1e-12));
      CHECK(std::abs((s - p).dot(p)) < 1e-12);
      for(const Vector3d& ray : {Vector3d(1, 1, 1), Vector3d(K, 1, 1), Vector3d(K, K, 1)})
        CHECK((s - p).dot(ray) < 1e-12 * K);
    }
}

TEST_CASE("Bounded distortion mapping ends when every cell satisfies the bound", "[baselines]")
{
  Numbered_mesh_3 mesh = scaled(pulled_cube(4, 0, 0.8));
  mesh.has_volume_weights = true;
  for(const double K : {3.5, 2.5})
  {
    Bounded_distortion_map_3 map(mesh, K);
    REQUIRE(largest_ratio(mesh, map.positions()) > K);
    for(int i = 0; i < 1000 && map.is_running(); ++i)
      map.step();
    CHECK(!map.is_running());
    CHECK(largest_ratio(mesh, map.positions()) <= K);
    CHECK(map.positions().rightCols(number_of_prescribed(mesh)) == mesh.target.rightCols(number_of_prescribed(mesh)));
  }
}

TEST_CASE("Locally injective mapping inverts no cell and reaches a twisted boundary", "[baselines]")
{
  const Numbered_mesh_3 mesh = scaled(twisted_cube(3, 0.1));
  Locally_injective_map_3<VMP::Barrier_energy_3<VMP::ARAP_energy_3> > map(mesh);
  const double distance_at_start = map.newton().distance();
  for(int i = 0; i < 200 && map.is_running(); ++i)
  {
    map.step();
    CHECK(smallest_determinant(mesh, map.positions()) > 0);
  }
  CHECK(map.newton().distance() < 1e-6 * distance_at_start);
}

TEST_CASE("Plain Newton needs one step for a quadratic energy", "[baselines]")
{
  const Numbered_mesh_3 mesh = scaled(mapped_cube(3, 0.1, [](const Vector3d& p)
  {
    return Vector3d(p[0] + 0.1 * p[1] * p[1], p[1], 1.3 * p[2]);
  }));
  const double weight = 10;
  const double number_of_cells = static_cast<double>(mesh.cells.size());
  Plain_newton_map_3<VMP::Dirichlet_energy_3> map(mesh, VMP::Dirichlet_energy_3(), weight);
  map.step();
  CHECK(map.last_step().step_length == 1);

  // lengths such that the target has volume 1
  const auto energy = [&](const Matrix3Xd& u)
  {
    double sum = weight * (snapped(mesh, u) - u).squaredNorm() / std::pow(number_of_cells, 2. / 3);
    for(const std::array<int, 4>& cell : mesh.cells)
      sum += jacobian(mesh, u, cell).squaredNorm() / number_of_cells;
    return sum;
  };
  CHECK(derivatives(energy, map.positions(), mesh.number_of_vertices()).norm() < 1e-8);
}

TEST_CASE("Plain Newton and relaxation find the same map where both converge", "[baselines]")
{
  const Numbered_mesh_3 mesh = scaled(twisted_cube(3, 0.1));
  const VMP::Stretch_energy_3 energy;
  const double weight = 100;
  Plain_newton_map_3<VMP::Stretch_energy_3> plain(mesh, energy, weight);
  for(int i = 0; i < 500 && plain.is_running(); ++i)
    plain.step();

  VMP::Soft_boundary_parameters parameters = VMP::single_weight_soft_boundary_parameters(weight);
  parameters.use_full_hessian = true;
  parameters.do_snap = false;
  VMP::CHOLMOD_solver_traits_3 solver;
  VMP::internal::Linear_solver_of<VMP::CHOLMOD_solver_traits_3> linear_solver(solver);
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> cell_energy(energy);
  VMP::internal::Soft_boundary_search_3 relaxing(mesh, cell_energy, linear_solver, parameters);
  while(relaxing.is_running())
    relaxing.step();

  CHECK(!plain.is_running());
  CHECK(plain.residual() > 1e-3); // the weight is low, so that energy and boundary both matter
  CHECK(plain.residual() == Approx(relaxing.residual()).epsilon(1e-3));
  CHECK((plain.positions() - relaxing.positions()).cwiseAbs().maxCoeff() < 1e-2);
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
