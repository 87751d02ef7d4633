// Stretches a block of rubber between two planes, with an energy of one's own, and compares the result with its closed form.
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

int main()
{
  constexpr double stretch = 1.5;
  const Neo_Hookean_energy_3 energy;
  VMP::Tetrahedron_soup_3 cube; // [-1, 1]^3
  VMP::IO::read_MEDIT("data/cube.mesh", cube);
  std::vector<std::array<double, 3> > targets(cube.points), images;
  std::vector<VMP::Vertex_condition_3> conditions(cube.points.size());
  for(std::size_t v = 0; v < cube.points.size(); ++v)
    if(std::abs(cube.points[v][0]) == 1)
    {
      conditions[v] = VMP::Vertex_condition_3::in_plane(1, 0, 0);
      targets[v][0] *= stretch;
    }

  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube.points, cube.cells, targets, images,
    params::vertex_condition_map(CGAL::make_property_map(conditions)).energy(energy).use_volume_weights(true).energy_tolerance(0));
  std::cout << result.message << std::endl;
  if(!result.has_valid_map)
    return EXIT_FAILURE;

  double force = 0, width = 0;
  const std::vector<std::array<double, 3> > forces = VMP::measure_forces(cube.points, cube.cells, images, energy);
  for(std::size_t v = 0; v < cube.points.size(); ++v)
  {
    force += cube.points[v][0] == 1 ? forces[v][0] : 0;
    width = (std::max)(width, images[v][1]);
  }
  // no stress across: mu (w^2 - 1) + lambda log(stretch w^2) = 0
  double expected = 1;
  for(int step = 0; step < 20; ++step)
    expected -= (energy.mu * (expected * expected - 1) + energy.lambda * std::log(stretch * expected * expected))
                / (2 * energy.mu * expected + 2 * energy.lambda / expected);
  const double stress = energy.gradient(Eigen::Vector3d(stretch, expected, expected))[0];
  std::cout << "lateral stretch " << width << ", in closed form " << expected << "\n"
            << "force " << force << ", in closed form " << 4 * stress << std::endl;
  return std::abs(width - expected) < 1e-6 && std::abs(force - 4 * stress) < 1e-5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
