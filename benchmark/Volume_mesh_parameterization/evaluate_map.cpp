// Evaluates a map at random points: round trips, points outside, and points a second, against point location by a
// Delaunay triangulation of the same vertices in the same run.
//
//     evaluate_map [SOURCE.mesh TARGET.mesh [NUMBER_OF_POINTS]]
//
// Both meshes have the same cells. Without arguments, a grid of 1.3 million cells is mapped onto a twisted one.
#include "jittered_grid.h"

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_3<K, CGAL::Fast_location>;
using Point_3 = K::Point_3;

namespace {

Tetrahedron_soup_3 read(const std::string& filename)
{
  Tetrahedron_soup_3 soup;
  VMP::IO::read_MEDIT(filename, soup);
  return soup;
}

Tetrahedron_soup_3 twisted(Tetrahedron_soup_3 soup)
{
  for(std::array<double, 3>& p : soup.points)
    p = {p[0] * std::cos(p[2]) - p[1] * std::sin(p[2]), p[0] * std::sin(p[2]) + p[1] * std::cos(p[2]), p[2]};
  return soup;
}

// Returns points in random cells, up to rounding; every fourth is on a facet, and every fourth is a vertex.
std::vector<Point_3> random_points(const Tetrahedron_soup_3& soup, const std::size_t n)
{
  std::mt19937_64 random;
  std::exponential_distribution<double> exponential;
  std::vector<Point_3> points;
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::array<std::size_t, 4>& cell = soup.cells[random() % soup.cells.size()];
    std::array<double, 4> weights;
    for(double& weight : weights)
      weight = exponential(random);
    if(i % 4 == 2)
      weights[0] = 0;
    if(i % 4 == 3)
      weights = {1, 0, 0, 0};
    const double sum = weights[0] + weights[1] + weights[2] + weights[3];
    std::array<double, 3> p = {0, 0, 0};
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t j = 0; j < 4; ++j)
        p[k] += weights[j] / sum * soup.points[cell[j]][k];
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

// Above each facet of the boundary, a billionth of the diagonal away, and as many well outside of the bounding box.
std::vector<Point_3> points_outside(const Tetrahedron_soup_3& soup, const CGAL::Bbox_3& box, const double diagonal)
{
  const auto point = [&](const std::size_t v) { return Eigen::Map<const Eigen::Vector3d>(soup.points[v].data()); };
  const Eigen::Vector3d center = Eigen::Vector3d(box.xmin() + box.xmax(), box.ymin() + box.ymax(),
                                                 box.zmin() + box.zmax()) / 2;
  const auto normal_of = [&](const std::size_t a, const std::size_t b, const std::size_t c) -> Eigen::Vector3d
  {
    return (point(b) - point(a)).cross(point(c) - point(a)).stableNormalized();
  };
  const auto& [i, j, k, l] = soup.cells[0]; // the cells of some files are all inverted
  const double side = normal_of(i, j, k).dot(point(l) - point(i)) > 0 ? 1 : -1;
  std::vector<Point_3> result;
  for(const auto& [a, b, c] : VMP::internal::boundary_facets_3(soup.cells))
  {
    const Eigen::Vector3d normal = side * normal_of(a, b, c);
    const Eigen::Vector3d above = (point(a) + point(b) + point(c)) / 3 + 1e-9 * diagonal * normal;
    const Eigen::Vector3d away = center + diagonal * normal;
    result.emplace_back(above[0], above[1], above[2]);
    result.emplace_back(away[0], away[1], away[2]);
  }
  return result;
}

// Calls f and prints how many points a second it has done.
template <typename Function>
void time(const std::string& name, const std::size_t n, const Function& f)
{
  CGAL::Real_timer timer;
  timer.start();
  f();
  std::cout << name << ": " << timer.time() << " s, " << static_cast<double>(n) / timer.time() << " a second\n";
}

// The largest error of the way there and back, over the diagonal and the distortion of the way back. Images must not
// overlap: otherwise the way back may be another one.
void measure_round_trips(const VMP::Volume_map_3& map, const std::vector<Point_3>& points, const double diagonal)
{
  std::size_t outside = 0, not_found_back = 0;
  double maximum = 0;
  for(const Point_3& p : points)
  {
    const auto there = map.image(p);
    outside += !there;
    const auto from = there ? there : map.nearest_image(p);
    not_found_back += !map.preimage(from->point);
    const auto back = map.nearest_preimage(from->point);
    const Eigen::Matrix3d differential = map.differential(back->point).value_or(Eigen::Matrix3d::Identity());
    const double stretch = (std::max)(1., 1 / Eigen::JacobiSVD<Eigen::Matrix3d>(differential).singularValues()[2]);
    maximum = (std::max)(maximum, std::sqrt(CGAL::squared_distance(p, back->point)) / (diagonal * stretch));
  }
  std::cout << points.size() << " round trips: largest relative error " << maximum << "; rounding put " << outside
            << " of the points and " << not_found_back << " of their images outside\n";
}

void measure_points_outside(const VMP::Volume_map_3& map, const std::vector<Point_3>& points)
{
  std::cout << std::count_if(points.begin(), points.end(), [&](const Point_3& p) { return map.image(p).has_value(); })
            << " of " << points.size() << " points outside, half of them just above the boundary, are found\n";
}

} // namespace

int main(const int argc, char* argv[])
try
{
  const Tetrahedron_soup_3 source = argc > 2 ? read(argv[1]) : Jittered_grid(60).soup();
  const Tetrahedron_soup_3 target = argc > 2 ? read(argv[2]) : twisted(source);
  const std::size_t n = argc > 3 ? std::stoul(argv[3]) : 100000;
  const std::vector<Point_3> points = random_points(source, n);
  std::cout << source.cells.size() << " cells\n";

  CGAL::Real_timer timer;
  timer.start();
  const VMP::Volume_map_3 map(source.points, source.cells, target.points);
  std::cout << "both trees: " << timer.time() << " s\n";
  std::vector<Point_3> vertices;
  for(const std::array<double, 3>& p : source.points)
    vertices.emplace_back(p[0], p[1], p[2]);
  timer.reset();
  const Delaunay delaunay(vertices.begin(), vertices.end());
  std::cout << "Delaunay triangulation: " << timer.time() << " s\n";

  time("image", n, [&] { map.images(points); });
  time("image, parallel", n, [&] { map.images<CGAL::Parallel_if_available_tag>(points); });
  time("Delaunay locate", n, [&] { for(const Point_3& p : points) delaunay.locate(p); });
  const CGAL::Bbox_3 box = CGAL::bbox_3(vertices.begin(), vertices.end());
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  measure_round_trips(map, points, diagonal);
  measure_points_outside(map, points_outside(source, box, diagonal));
  return EXIT_SUCCESS;
}
catch(const std::exception& error)
{
  std::cerr << error.what() << std::endl;
  return EXIT_FAILURE;
}
