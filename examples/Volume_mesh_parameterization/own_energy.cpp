// Stretches and shears a block of rubber with an energy of one's own, and compares the results with closed forms.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/measure_forces.h>

#include <CGAL/property_map.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

// A compressible Neo-Hookean solid: a symmetric function of the singular values s, with its derivatives, for one cell (T is
// double) or several at once.
struct Neo_Hookean_energy_3
{
  double mu = 1, lambda = 1.5;

  template <typename T> using Vector = Eigen::Matrix<T, 3, 1>;
  template <typename T> using Matrix = Eigen::Matrix<T, 3, 3>;

  template <typename T>
  T log_of_volume(const Vector<T>& s) const
  {
    using std::log;
    return log(s[0] * s[1] * s[2]);
  }

  template <typename T>
  T value(const Vector<T>& s) const
  {
    const T l = log_of_volume(s);
    return T(mu / 2) * (s.squaredNorm() - T(3)) - T(mu) * l + T(lambda / 2) * l * l;
  }

  template <typename T>
  Vector<T> gradient(const Vector<T>& s) const
  { return T(mu) * s + (T(lambda) * log_of_volume(s) - T(mu)) * s.cwiseInverse(); }

  template <typename T>
  Matrix<T> hessian(const Vector<T>& s) const
  {
    const Vector<T> inverse = s.cwiseInverse();
    Matrix<T> result = T(lambda) * inverse * inverse.transpose();
    for(int i = 0; i < 3; ++i)
      result(i, i) += T(mu) - (T(lambda) * log_of_volume(s) - T(mu)) * inverse[i] * inverse[i];
    return result;
  }
};

using Point = std::array<double, 3>;

// Moves vertices of the cube [-1, 1]^3 to targets, in planes or at points, and computes the images of the others, and the forces.
struct Deformed_cube
{
  Neo_Hookean_energy_3 energy;
  VMP::Tetrahedron_soup_3 cube;
  std::vector<Point> images, forces;

  template <typename ConditionOf, typename TargetOf>
  bool deform(const ConditionOf& condition_of, const TargetOf& target_of)
  {
    VMP::IO::read_MEDIT("data/cube.mesh", cube);
    std::vector<VMP::Vertex_condition_3> conditions;
    std::vector<Point> targets;
    for(const Point& p : cube.points)
    {
      conditions.push_back(condition_of(p));
      targets.push_back(target_of(p));
    }
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
      cube.points, cube.cells, targets, images,
      params::vertex_condition_map(CGAL::make_property_map(conditions)).energy(energy).use_volume_weights(true)
             .energy_tolerance(0));
    std::cout << result.message << std::endl;
    if(result.has_valid_map)
      forces = VMP::measure_forces(cube.points, cube.cells, images, energy);
    return result.has_valid_map;
  }

  // Returns the force along the axis x on the side on which a coordinate is 1.
  double force_on_side(const std::size_t axis) const
  {
    double result = 0;
    for(std::size_t v = 0; v < cube.points.size(); ++v)
      result += cube.points[v][axis] == 1 ? forces[v][0] : 0;
    return result;
  }
};

// Pulls two opposite sides apart, which remain in planes.
bool is_uniaxial_stretch_right()
{
  constexpr double stretch = 1.5;
  Deformed_cube block;
  if(!block.deform([](const Point& p)
                   { return std::abs(p[0]) == 1 ? VMP::Vertex_condition_3::in_plane(1, 0, 0) : VMP::Vertex_condition_3::free(); },
                   [](const Point& p) { return Point{ stretch * p[0], p[1], p[2] }; }))
    return false;
  double width = 0;
  for(const Point& p : block.images)
    width = (std::max)(width, p[1]);
  // no stress across: mu (w^2 - 1) + lambda log(stretch w^2) = 0
  const auto& [mu, lambda] = block.energy;
  double expected = 1;
  for(int step = 0; step < 20; ++step)
    expected -= (mu * (expected * expected - 1) + lambda * std::log(stretch * expected * expected))
                / (2 * mu * expected + 2 * lambda / expected);
  const double force = block.force_on_side(0);
  const double expected_force = 4 * block.energy.gradient(Eigen::Vector3d(stretch, expected, expected))[0];
  std::cout << "lateral stretch " << width << ", in closed form " << expected << "\n"
            << "force " << force << ", in closed form " << expected_force << std::endl;
  return std::abs(width - expected) < 1e-6 && std::abs(force - expected_force) < 1e-6;
}

// Moves all sides but two, which are free, by simple shear. No force acts on the latter, and mu times the shear on the upper side.
bool is_simple_shear_right()
{
  constexpr double shear = 0.5;
  const auto sheared = [](const Point& p) { return Point{ p[0] + shear * p[1], p[1], p[2] }; };
  Deformed_cube block;
  if(!block.deform([](const Point& p)
                   { return (std::max)(std::abs(p[0]), std::abs(p[1])) == 1 ? VMP::Vertex_condition_3::at_target()
                                                                           : VMP::Vertex_condition_3::free(); }, sheared))
    return false;
  double error = 0;
  for(std::size_t v = 0; v < block.images.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k)
      error = (std::max)(error, std::abs(block.images[v][k] - sheared(block.cube.points[v])[k]));
  const double force = block.force_on_side(1), expected_force = 4 * block.energy.mu * shear;
  std::cout << "distance from simple shear " << error << "\n"
            << "force " << force << ", in closed form " << expected_force << std::endl;
  return error < 1e-6 && std::abs(force - expected_force) < 1e-6;
}

int main() { return is_uniaxial_stretch_right() && is_simple_shear_right() ? EXIT_SUCCESS : EXIT_FAILURE; }
