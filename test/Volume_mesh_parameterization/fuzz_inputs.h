// Random meshes, targets and texts, good and bad; the same for the same seed everywhere.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FUZZ_INPUTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FUZZ_INPUTS_H

#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

// The distributions of the standard library differ from one to the next.
class Random
{
public:
  explicit Random(const std::uint64_t seed) : m_engine(seed) {}

  std::size_t below(const std::size_t n) { return m_engine() % n; }
  bool one_in(const std::size_t n) { return below(n) == 0; }
  double real(const double bound) { return bound * (std::ldexp(static_cast<double>(m_engine() >> 11), -52) - 1); }
  Eigen::Vector3d vector(const double bound) { return Eigen::Vector3d{real(bound), real(bound), real(bound)}; }

  template <typename T>
  T pick(const std::initializer_list<T> values) { return values.begin()[below(values.size())]; }

  double extreme_number()
  {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    return pick({nan, infinity, -infinity, 1e308, -1e300, 1e200, 1e155, 1e100, 1e16, 0., -0., 1e-16, 1e-160, 1e-300, 5e-324});
  }

private:
  std::mt19937_64 m_engine;
};

// Tetrahedra around the edge between two poles.
inline CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 fan(const std::size_t size, const bool is_closed)
{
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 soup;
  soup.points = {{0, 0, -1}, {0, 0, 1}};
  const std::size_t n = is_closed ? size : size + 1;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 6.28 * static_cast<double>(i) / static_cast<double>(is_closed ? n : n + 1);
    soup.points.push_back({std::cos(angle), std::sin(angle), 0});
  }
  for(std::size_t i = 0; i < size; ++i)
    soup.cells.push_back({0, 1, 2 + (i + 1) % n, 2 + i});
  return soup;
}

// Tetrahedra around a vertex: a closed fan with its axis cut in two.
inline CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 star(const std::size_t size)
{
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 soup = fan(size, true);
  const std::size_t center = soup.points.size();
  soup.points.push_back({0, 0, 0});
  for(std::size_t c = 0; c < size; ++c)
  {
    soup.cells.push_back(soup.cells[c]);
    soup.cells[c][0] = center;
    soup.cells.back()[1] = center;
  }
  return soup;
}

inline void append_copy(CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
{
  const std::size_t number_of_points = soup.points.size(), number_of_cells = soup.cells.size();
  for(std::size_t v = 0; v < number_of_points; ++v)
    soup.points.push_back({soup.points[v][0] + 10, soup.points[v][1], soup.points[v][2]});
  for(std::size_t c = 0; c < number_of_cells; ++c)
  {
    soup.cells.push_back(soup.cells[c]);
    for(std::size_t& v : soup.cells.back())
      v += number_of_points;
  }
}

// Removes cells chosen at random, which leaves holes, edges and vertices that are not manifold, several
// components, and points without a cell.
inline void remove_cells(CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup, Random& random)
{
  const std::size_t n = random.pick({2, 4, 20});
  for(std::size_t c = soup.cells.size(); c-- > 1;)
    if(random.one_in(n))
      soup.cells.erase(soup.cells.begin() + static_cast<std::ptrdiff_t>(c));
}

inline void move_points(CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup, Random& random)
{
  const double jitter = random.pick({0., 0.01, 0.1, 0.15});
  const double scale = random.one_in(5) ? std::pow(10, random.real(random.pick({6, 100, 307}))) : 1;
  Eigen::Vector3d scales = Eigen::Vector3d::Constant(scale);
  if(random.one_in(5))
    scales[static_cast<Eigen::Index>(random.below(3))] *= random.pick({1e-2, 1e-5, 1e-10, 1e-16});
  for(std::array<double, 3>& p : soup.points)
  {
    const Eigen::Vector3d noise = random.vector(jitter);
    for(int i = 0; i < 3; ++i)
      p[i] = scales[i] * (p[i] + noise[i]);
  }
}

inline CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 random_soup(Random& random)
{
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 soup;
  const std::size_t n = random.below(8);
  switch(random.below(5))
  {
    case 0: soup = fan(n + 1, false); break;
    case 1: soup = fan(n + 3, true); break;
    case 2: soup = star(n + 3); break;
    default: soup = source_soup(cube_mesh(static_cast<int>(n % 4) + 1));
  }
  if(random.one_in(4))
    remove_cells(soup, random);
  if(random.one_in(6))
    append_copy(soup);
  if(random.one_in(6))
    soup.points.push_back({7, 7, 7});
  move_points(soup, random);

  const std::size_t number_of_subdomains = random.pick({1, 1, 3});
  soup.cell_references.clear();
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    soup.cell_references.push_back(static_cast<int>(random.below(number_of_subdomains)));
  if(random.one_in(4))
  {
    const std::array<std::size_t, 4>& cell = soup.cells[random.below(soup.cells.size())];
    soup.facets.push_back({cell[0], cell[1], cell[2]});
    soup.facet_references.push_back(5);
  }
  return soup;
}

inline Eigen::Matrix3d random_matrix(Random& random)
{
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  if(random.one_in(3))
    return A;
  if(random.one_in(2))
    for(int i = 0; i < 3; ++i)
      A.col(i) += random.vector(random.pick({0.3, 2.}));
  if(random.one_in(5))
    for(int i = 0; i < 3; ++i)
      A.row(i) *= random.pick({0., 1., 1., 1e-8, -1.});
  if(random.one_in(5))
    A *= std::pow(10, random.real(random.pick({10, 200})));
  return A;
}

// The images of points: an affine map, perhaps followed by a twist, by noise and by single faults.
inline std::vector<Eigen::Vector3d> random_targets(std::vector<Eigen::Vector3d> points, Random& random)
{
  const Eigen::Matrix3d A = random_matrix(random);
  const double twist = random.one_in(4) ? random.real(5) : 0;
  const double noise = random.one_in(3) ? random.pick({1e-12, 1e-3, 0.1, 1., 1e6}) : 0;
  double size = 0, image_size = 0; // may be infinite or not a number
  for(const Eigen::Vector3d& p : points)
  {
    size = (std::max)(size, p.norm());
    image_size = (std::max)(image_size, (A * p).norm());
  }
  for(Eigen::Vector3d& p : points)
    p = A * Eigen::Vector3d(Eigen::AngleAxisd(twist * p[2] / size, Eigen::Vector3d::UnitZ()) * p)
        + random.vector(noise) * (noise > 0 ? image_size : 0);

  if(random.one_in(5))
    for(std::size_t faults = 1 + random.below(4); faults > 0; --faults)
    {
      Eigen::Vector3d& p = points[random.below(points.size())];
      Eigen::Vector3d& q = points[random.below(points.size())];
      switch(random.below(4))
      {
        case 0: p = q; break;
        case 1: p.swap(q); break;
        case 2: p.setConstant(random.extreme_number()); break;
        default: p[0] = random.extreme_number();
      }
    }
  return points;
}

// Changes some bytes of a text, by itself or with words that such files contain.
inline void mutate(std::string& text, Random& random)
{
  for(std::size_t mutations = random.below(6); mutations > 0; --mutations)
  {
    const std::size_t at = random.below(text.size() + 1), length = random.below(random.pick({2, 20, 1000}));
    switch(random.below(5))
    {
      case 0: text.insert(at, 1, static_cast<char>(random.below(256))); break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(at, text.substr(random.below(text.size() + 1), length)); break;
      case 3: text.resize(at); break;
      default:
        text.replace(at, random.below(3), random.pick({"0", "-1", "99999999999", "4294967297", "nan", "inf", "1e999",
                                                      "1e-320", "\n", " ", "#", "Tetrahedra\n", "Vertices 3\n", "End",
                                                      "Hexahedra 1"}));
    }
  }
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FUZZ_INPUTS_H
