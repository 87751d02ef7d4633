// The bound for the distortion of angles, and the weights of cells.
#include "catch.h"
#include "cube_mesh.h"
#include "fixed_boundary.h"

#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::Matrix3d;
using CGAL::Volume_mesh_parameterization::internal::Matrix3Xd;
using Eigen::Vector3d;
using Default_solver = VMP::Conjugate_gradient_solver_traits_3<>;
using Stretch = VMP::internal::Cell_energy_of<VMP::Stretch_energy_3>;
using VMP::internal::Numbered_mesh_3;
using VMP::internal::edge_matrix;

namespace {

struct Bounded_map
{
  VMP::Parameterization_result result;
  Matrix3Xd positions;
};

// The map with fixed boundary and, if it is finite, the bound.
Bounded_map parameterize(const Numbered_mesh_3& mesh, const double bound = std::numeric_limits<double>::infinity(),
                 const bool is_least = false)
{
  const Stretch energy{VMP::Stretch_energy_3()};
  Default_solver traits;
  VMP::internal::Linear_solver_of<Default_solver> solver(traits);
  VMP::internal::Map_options_3 options;
  options.mode = VMP::Boundary_mode::FIXED;
  options.improve = VMP::internal::slide_and_bound_angles_3;
  options.maximum_angle_distortion = bound;
  options.minimize_maximum_angle_distortion = is_least;
  VMP::internal::Progress_3 progress(VMP::internal::Budget(), 1000);
  const VMP::internal::Input_check_3 check = check_input_3(mesh);
  const VMP::internal::Map_problem_3 problem = { options, energy, solver, progress };
  const VMP::internal::Found_map_3 found = find_map_3(mesh, check, problem);
  return {make_result_3(mesh, check, found, problem), found.map.positions};
}

// The mean over the cells, with both meshes scaled to one volume.
double mean_energy(const Numbered_mesh_3& mesh, const Matrix3Xd& image)
{
  const double to_source_volume
    = std::cbrt(VMP::internal::volume(mesh, mesh.source) / VMP::internal::volume(mesh, image));
  return mean_energy_3(mesh, singular_values_of_cells_3(mesh, image), Stretch{VMP::Stretch_energy_3()},
                       to_source_volume);
}

Vector3d singular_values(const Numbered_mesh_3& mesh, const Matrix3Xd& image, const std::array<int, 4>& cell)
{
  const Matrix3d J = edge_matrix(image, cell) * edge_matrix(mesh.source, cell).inverse();
  return Eigen::JacobiSVD<Matrix3d, Eigen::NoQRPreconditioner>(J).singularValues();
}

double largest_angle_distortion(const Numbered_mesh_3& mesh, const Matrix3Xd& image)
{
  double result = 0;
  for(const std::array<int, 4>& cell : mesh.cells)
  {
    const Vector3d s = singular_values(mesh, image, cell);
    result = (std::max)(result, s[0] / s[2] + s[2] / s[0]);
  }
  return result;
}

// Returns a twisted cube without the cells in its corners, whose vertices are all on the boundary.
Numbered_mesh_3 twisted_cube_with_inner_corners()
{
  return mapped_cube(6, 0.1, [](const Vector3d& p) -> Vector3d
  {
    const Vector3d center = Vector3d::Constant(3.);
    return center + Eigen::AngleAxisd(0.5 * p[2] / 6, Vector3d::UnitZ()) * (p - center).cwiseProduct(Vector3d(1, 1, 4));
  });
}

} // namespace

TEST_CASE("A bound below the largest distortion of angles is met, with the boundary unchanged")
{
  const Numbered_mesh_3 mesh = twisted_cube_with_inner_corners();
  const Bounded_map free = parameterize(mesh);
  REQUIRE(free.result.status == VMP::OK);
  const double unavoidable = VMP::internal::unavoidable_angle_distortion_3(mesh);
  const double reached = largest_angle_distortion(mesh, free.positions);
  REQUIRE(unavoidable < reached);

  const double bound = 0.3 * unavoidable + 0.7 * reached;
  const Bounded_map bounded = parameterize(mesh, bound);
  CHECK(bounded.result.status == VMP::OK);
  CHECK(largest_angle_distortion(mesh, bounded.positions) < bound);
  CHECK(largest_angle_distortion(mesh, bounded.positions) > 0.9 * bound); // no stricter than asked for
  CHECK(bounded.result.number_of_inverted_cells == 0);
  CHECK(bounded.result.boundary_residual == 0);
  CHECK(bounded.result.energy > free.result.energy);
}

// Steps under the barrier that begin at a map with a stricter bound lead to the minimum that is reached from outside.
TEST_CASE("No step exceeds the bound once it is met, and the energy is minimized below it")
{
  const Numbered_mesh_3 mesh = twisted_cube_with_inner_corners();
  const double unavoidable = VMP::internal::unavoidable_angle_distortion_3(mesh);
  const double reached = largest_angle_distortion(mesh, parameterize(mesh).positions);
  const double bound = 0.2 * unavoidable + 0.8 * reached;
  const Bounded_map from_outside = parameterize(mesh, bound);
  const Bounded_map stricter = parameterize(mesh, 0.5 * unavoidable + 0.5 * reached);
  REQUIRE(stricter.result.status == VMP::OK);

  using Energy = VMP::Bounded_angle_energy_3<VMP::Stretch_energy_3>;
  Default_solver solver;
  fixed_boundary::Problem<Energy, Default_solver> problem(mesh, Energy(bound, VMP::Stretch_energy_3(), 0), solver);
  VMP::internal::Progress_3 progress(VMP::internal::Budget(), 1000);
  const VMP::internal::Newton_result_3 below = minimize_energy_3(
    problem.system, problem.energy, stricter.positions, progress, VMP::internal::Negative_curvature(),
    [&](const VMP::internal::Newton_iterate_3& iterate) -> std::optional<VMP::Error_code>
    {
      CHECK(largest_angle_distortion(mesh, iterate.positions()) < bound);
      return std::nullopt;
    });
  CHECK(below.status == VMP::OK);
  const double energy_below = mean_energy(mesh, below.positions);
  CHECK(energy_below < stricter.result.energy);
  CHECK(energy_below == Approx(from_outside.result.energy).epsilon(1e-6));
}

TEST_CASE("The least bound is between one that is missed and the distortion reached")
{
  const Numbered_mesh_3 mesh = twisted_cube_with_inner_corners();
  const double infinity = std::numeric_limits<double>::infinity();
  const Bounded_map least = parameterize(mesh, infinity, true);
  const double reached = largest_angle_distortion(mesh, least.positions);
  CHECK(least.result.status == VMP::OK);
  CHECK(least.result.number_of_inverted_cells == 0);
  CHECK(least.result.boundary_residual == 0);
  CHECK(least.result.unavoidable_angle_distortion == VMP::internal::unavoidable_angle_distortion_3(mesh));
  CHECK(least.result.missed_angle_distortion >= least.result.unavoidable_angle_distortion);
  CHECK(least.result.missed_angle_distortion < reached);
  CHECK(reached <= 1.02 * least.result.missed_angle_distortion);
  CHECK(reached < 0.95 * largest_angle_distortion(mesh, parameterize(mesh).positions));
}

TEST_CASE("The least bound of an affine map is what it is")
{
  // its only inner vertex may move, but no cell can have less than the facets on the boundary
  const Numbered_mesh_3 mesh = mapped_cube(2, 0, [](const Vector3d& p) { return Vector3d(5 * p[0], p[1], p[2]); });
  const Bounded_map map = parameterize(mesh, std::numeric_limits<double>::infinity(), true);
  CHECK(map.result.unavoidable_angle_distortion == Approx(5 + 1. / 5));
  CHECK(map.result.missed_angle_distortion <= largest_angle_distortion(mesh, map.positions));
}

TEST_CASE("A bound that is met anyway changes nothing")
{
  const Numbered_mesh_3 mesh = twisted_cube_with_inner_corners();
  CHECK(parameterize(mesh, 1e6).positions == parameterize(mesh).positions);
}

TEST_CASE("A bound below what the boundary forces is reported, with a valid map")
{
  const Numbered_mesh_3 mesh = twisted_cube_with_inner_corners();
  const Bounded_map map = parameterize(mesh, 2.5);
  CHECK(map.result.status == VMP::ERROR_ANGLE_BOUND_NOT_REACHED);
  CHECK(map.result.has_valid_map);
  CHECK(map.result.message.find("The prescribed vertices alone force") != std::string::npos);
}

TEST_CASE("The unavoidable distortion of angles is that of the worst prescribed facet")
{
  // one interior vertex; the facets in the planes z = 0 and z = 2 are stretched by 5 in one direction
  const Numbered_mesh_3 mesh = mapped_cube(2, 0, [](const Vector3d& p) { return Vector3d(5 * p[0], p[1], p[2]); });
  CHECK(VMP::internal::unavoidable_angle_distortion_3(mesh) == Approx(5 + 1. / 5));
}

TEST_CASE("Volume weights minimize the mean over the volume")
{
  Numbered_mesh_3 mesh = twisted_cube(4, 0);
  mesh.source.row(0) = mesh.source.row(0).array().square(); // cells of different sizes
  const auto mean_stretch = [&](const Matrix3Xd& image)
  {
    double sum = 0, total = 0;
    for(const std::array<int, 4>& cell : mesh.cells)
    {
      const double volume = edge_matrix(mesh.source, cell).determinant();
      sum += volume * singular_values(mesh, image, cell).cwiseInverse().squaredNorm();
      total += volume;
    }
    return sum / total;
  };

  const Bounded_map uniform = parameterize(mesh);
  mesh.has_volume_weights = true;
  const Bounded_map weighted = parameterize(mesh);
  REQUIRE(weighted.result.status == VMP::OK);
  CHECK(mean_stretch(weighted.positions) < 0.999 * mean_stretch(uniform.positions));
}
