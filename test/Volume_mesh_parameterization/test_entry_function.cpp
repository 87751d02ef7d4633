// stretch_minimizing_volume_parameterization(): its named parameters, its property maps, and bad input.
#include "catch.h"
#include "complex_checks.h"
#include "cube_complex.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>

#include <CGAL/exceptions.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <locale>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Eigen::Vector3d;
using VMP::Parameterization_result;
using VMP::internal::Numbered_mesh_3;

using Complex = Cube_complex<>;
using Point_3 = Complex::Point_3;
using Vertex_handle = Complex::Vertex_handle;
using Point_map = Complex::Point_map;
using Solver = VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double>;

namespace {

// Keeps all that is printed to std::cout.
class Captured_output
{
public:
  Captured_output() : m_original(std::cout.rdbuf(m_text.rdbuf())) {}
  ~Captured_output() { std::cout.rdbuf(m_original); }
  Captured_output(const Captured_output&) = delete;

  std::string text() const { return m_text.str(); }

private:
  std::ostringstream m_text;
  std::streambuf* m_original;
};

// Ends the computation after a number of steps; cannot be copied.
struct Counting_visitor
{
  std::size_t limit;
  std::vector<VMP::Parameterization_step> steps = {};

  explicit Counting_visitor(const std::size_t limit = 1000000) : limit(limit) {}
  Counting_visitor(const Counting_visitor&) = delete;

  bool after_step(const VMP::Parameterization_step& step)
  {
    steps.push_back(step);
    return steps.size() < limit;
  }
};

// Property maps with the operations that their concepts demand, and no other.
struct Read_only_map
{
  using key_type = Vertex_handle;
  using value_type = Point_3;
  using reference = const Point_3&;
  using category = boost::readable_property_map_tag;

  const Point_map* points;
  friend reference get(const Read_only_map& map, const key_type& v) { return map.points->at(v); }
};

struct Write_only_map
{
  using key_type = Vertex_handle;
  using value_type = Point_3;
  using reference = void;
  using category = boost::writable_property_map_tag;

  Point_map* points;
  friend void put(const Write_only_map& map, const key_type& v, const value_type& p) { (*map.points)[v] = p; }
};

struct Read_only_set
{
  using key_type = Vertex_handle;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  const std::unordered_set<Vertex_handle>* vertices;
  friend bool get(const Read_only_set& map, const key_type& v) { return map.vertices->count(v) > 0; }
};

Numbered_mesh_3 image_mesh(Complex& complex)
{
  Numbered_mesh_3 image = complex.mesh;
  for(int v = 0; v < image.number_of_vertices(); ++v)
  {
    const Point_3& p = complex.uvw.at(complex.vertices[v]);
    image.target.col(v) = Vector3d(p.x(), p.y(), p.z());
  }
  return image;
}

void check_valid_map(Complex& complex, const Parameterization_result& result)
{
  CHECK(result.has_valid_map);
  CHECK(result.number_of_inverted_cells == 0);
  CHECK(result.boundary_residual == 0);
  REQUIRE(complex.uvw.size() == complex.vertices.size());
  for(const auto& [v, p] : complex.target)
    CHECK(complex.uvw.at(v) == p);
  CHECK(has_positive_cells(complex.c3t3, [&](const auto v) { return complex.uvw.at(v); }));
}

// Calls the function for a fresh copy of the mesh; `np` lacks only the boundary map.
template <typename NamedParameters>
Parameterization_result parameterize(Complex& complex, const NamedParameters& np)
{
  complex.uvw.clear();
  return CGAL::stretch_minimizing_volume_parameterization(std::as_const(complex.c3t3), complex.uvw_map(),
                                                          np.boundary_map(complex.boundary_map()));
}

Parameterization_result parameterize(Complex& complex)
{
  return CGAL::stretch_minimizing_volume_parameterization(std::as_const(complex.c3t3), complex.uvw_map(),
                                                          params::boundary_map(complex.boundary_map()));
}

void check_refusal(Complex& complex, const VMP::Error_code status, const std::vector<std::string>& words,
                   const VMP::Boundary_mode mode = VMP::Boundary_mode::AUTO)
{
  Counting_visitor visitor;
  const Captured_output output;
  const Parameterization_result result
    = parameterize(complex, params::visitor(std::ref(visitor)).boundary_mode(mode));
  CHECK(result.status == status);
  INFO(result.message);
  for(const std::string& word : words)
    CHECK(result.message.find(word) != std::string::npos);
  CHECK(!result.has_valid_map);
  CHECK(complex.uvw.empty());
  CHECK(visitor.steps.empty());
  CHECK(output.text().empty());
}

template <typename T>
std::string to_string(const T& t)
{
  std::ostringstream out;
  out << t;
  return out.str();
}

// The cells that are not positive, of those whose vertices all have a position, in the order of the complex.
struct Negative_cells
{
  std::size_t number = 0, first = 0;
  double volume = 0;

  Negative_cells(const Complex& complex, const Point_map& position)
  {
    std::size_t index = 0;
    for(auto c = complex.c3t3.cells_in_complex_begin(); c != complex.c3t3.cells_in_complex_end(); ++c, ++index)
    {
      std::vector<Point_3> p;
      for(int i = 0; i < 4; ++i)
        if(position.count(c->vertex(i)) > 0)
          p.push_back(position.at(c->vertex(i)));
      if(p.size() < 4 || CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::POSITIVE || number++ > 0)
        continue;
      first = index;
      volume = CGAL::volume(p[0], p[1], p[2], p[3]);
    }
  }
};

} // namespace

TEST_CASE("The result describes the map")
{
  Complex complex(twisted_cube(4, 0.1));
  const Parameterization_result result = parameterize(complex);
  CHECK(result.status == VMP::OK);
  CHECK(result.message == "Success.");
  check_valid_map(complex, result);
  CHECK(result.number_of_vertices == 125);
  CHECK(result.number_of_cells == 384);
  CHECK(result.number_of_boundary_vertices == 98);
  CHECK(result.number_of_added_vertices == 0);
  CHECK(result.number_of_iterations > 0);

  const VMP::Distortion_3& D = result.distortion;
  CHECK(2 < D.angle_mean);
  CHECK(D.angle_mean < D.angle_max);
  CHECK(2 < D.volume_mean);
  CHECK(D.volume_mean < D.volume_max);
  CHECK(result.energy > 3);
  CHECK(result.seconds_total > 0);
  CHECK(result.seconds_to_flip_free <= result.seconds_total);
  CHECK(result.seconds_boundary + result.seconds_numbering + result.seconds_start + result.seconds_untangling
        + result.seconds_minimization + result.seconds_check == Approx(result.seconds_total).margin(1e-2));
}

TEST_CASE("Distortions of a similarity")
{
  Complex complex(mapped_cube(3, 0, [](const Vector3d& p) { return Vector3d(-2 * p[1], 2 * p[0], 2 * p[2]); }));
  const Parameterization_result result = parameterize(complex);
  CHECK(result.status == VMP::OK);
  for(const double angle : {result.distortion.angle_mean, result.distortion.angle_max,
                            result.distortion_at_source_volume.angle_max})
    CHECK(angle == Approx(2));
  CHECK(result.distortion.volume_mean == Approx(8 + 1. / 8));
  CHECK(result.distortion.volume_max == Approx(8 + 1. / 8));
  CHECK(result.distortion_at_source_volume.volume_max == Approx(2));
  CHECK(result.boundary_distortion == Approx(0).margin(1e-12));
  CHECK(result.energy == Approx(3));
}

TEST_CASE("The distortion of the boundary of a stretched cube, by closed form")
{
  // to lengths 4, 1, 1: of areas 1 and 4, two and four faces of the six
  Complex complex(mapped_cube(3, 0, [](const Vector3d& p) { return Vector3d(4 * p[0], p[1], p[2]); }));
  const Parameterization_result result = parameterize(complex);
  REQUIRE(result.has_valid_map);
  const double scale = std::sqrt(6. / 18);
  CHECK(result.boundary_distortion == Approx((2 * std::hypot(std::log(scale), std::log(scale))
                                              + 4 * std::hypot(std::log(4 * scale), std::log(scale))) / 6));
}

TEST_CASE("The distortions of any map are measured: those of the result, and of a stretch by closed form")
{
  Complex complex(twisted_cube(4, 0.1));
  const Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(complex.c3t3), complex.uvw_map(), params::boundary_map(complex.boundary_map()));
  const VMP::Distortion_3 measured = VMP::measure_distortion(complex.c3t3, complex.uvw_map());
  CHECK(measured.angle_mean == Approx(result.distortion.angle_mean).epsilon(1e-12));
  CHECK(measured.angle_max == Approx(result.distortion.angle_max).epsilon(1e-12));
  CHECK(measured.volume_mean == Approx(result.distortion.volume_mean).epsilon(1e-12));
  CHECK(measured.volume_max == Approx(result.distortion.volume_max).epsilon(1e-12));

  for(auto& [v, p] : complex.uvw)
    p = Point_3(2 * v->point().x(), v->point().y(), v->point().z());
  const VMP::Distortion_3 stretched = VMP::measure_distortion(complex.c3t3, complex.uvw_map());
  CHECK(stretched.angle_mean == Approx(2 + 1. / 2));
  CHECK(stretched.angle_max == Approx(2 + 1. / 2));
  CHECK(stretched.volume_mean == Approx(2 + 1. / 2));
  CHECK(stretched.volume_max == Approx(2 + 1. / 2));
}

TEST_CASE("Each named parameter by itself")
{
  Complex complex(ring(5));
  const Parameterization_result plain = parameterize(complex);
  REQUIRE(plain.status == VMP::OK);
  REQUIRE(plain.number_of_inverted_cells_at_start > 0);
  REQUIRE(plain.number_of_untangling_iterations > 0);
  CHECK(plain.number_of_linear_solver_iterations > plain.number_of_iterations);
  CHECK(plain.untangling_method == "regular cells, theta 20");
  check_valid_map(complex, plain);
  const Point_map expected = complex.uvw;

  SECTION("energy")
  {
    const Parameterization_result result = parameterize(complex, params::energy(VMP::Stretch_energy_3()));
    CHECK(result.energy == plain.energy);
    CHECK(complex.uvw == expected);
    parameterize(complex, params::energy(VMP::Dirichlet_energy_3()));
    CHECK(complex.uvw != expected);
  }
  SECTION("solver_traits")
  {
    const Parameterization_result result = parameterize(complex, params::solver_traits(Solver()));
    CHECK(result.status == VMP::OK);
    CHECK(result.energy == Approx(plain.energy).epsilon(1e-6));

    Solver solver;
    parameterize(complex, params::solver_traits(std::ref(solver)));
    CHECK(solver.number_of_iterations() > 0);
  }
  SECTION("number_of_iterations")
  {
    CHECK(parameterize(complex, params::number_of_iterations(1000)).energy == plain.energy);
    const std::size_t few = plain.number_of_untangling_iterations + 1;
    const Parameterization_result result = parameterize(complex, params::number_of_iterations(few));
    CHECK(result.status == VMP::ERROR_NOT_CONVERGED);
    CHECK(result.number_of_iterations == few);
    CHECK(result.energy > plain.energy);
    check_valid_map(complex, result);

    const Parameterization_result one
      = parameterize(complex, params::number_of_iterations(1u).boundary_mode(VMP::Boundary_mode::FIXED));
    CHECK(one.status == VMP::ERROR_NOT_FLIP_FREE);
    CHECK(!one.has_valid_map);
    CHECK(one.number_of_inverted_cells > 0);
    CHECK(complex.uvw.empty());
  }
  SECTION("boundary_mode")
  {
    for(const VMP::Boundary_mode mode : {VMP::Boundary_mode::AUTO, VMP::Boundary_mode::FIXED})
    {
      CHECK(parameterize(complex, params::boundary_mode(mode)).energy == plain.energy);
      CHECK(complex.uvw == expected);
    }
    const Parameterization_result soft = parameterize(complex, params::boundary_mode(VMP::Boundary_mode::SOFT));
    CHECK(soft.has_valid_map);
    CHECK(soft.number_of_untangling_iterations == 0);
    CHECK(soft.untangling_method == "soft boundary");
    CHECK(complex.uvw != expected);
  }
  SECTION("maximum_running_time")
  {
    CHECK(parameterize(complex, params::maximum_running_time(1000)).energy == plain.energy);
    const Parameterization_result result = parameterize(complex, params::maximum_running_time(0.));
    CHECK(result.status == VMP::ERROR_INTERRUPTED);
    CHECK(complex.uvw.empty());
  }
  SECTION("visitor")
  {
    Counting_visitor visitor;
    parameterize(complex, params::visitor(std::ref(visitor)));
    CHECK(complex.uvw == expected);
    REQUIRE(visitor.steps.size() == plain.number_of_iterations);
    std::size_t untangling = 0;
    for(std::size_t i = 0; i < visitor.steps.size(); ++i)
    {
      CHECK(visitor.steps[i].iteration == i + 1);
      untangling += visitor.steps[i].phase == VMP::Phase::UNTANGLING ? 1 : 0;
    }
    CHECK(untangling == plain.number_of_untangling_iterations);
    CHECK(visitor.steps.back().number_of_inverted_cells == 0);
  }
  SECTION("verbose")
  {
    for(const bool verbose : {false, true})
    {
      const Captured_output output;
      parameterize(complex, params::verbose(verbose));
      const std::string text = output.text();
      const std::size_t lines = std::count(text.begin(), text.end(), '\n');
      CHECK(lines == (verbose ? 1 + plain.number_of_iterations : 0));
      CHECK((text.find("Conjugate_gradient_solver_traits_3") != std::string::npos) == verbose);
    }
    CHECK(complex.uvw == expected);
  }
}

// Bends the cube to a part of a ring.
Numbered_mesh_3 bent_cube(const int n, const double total_angle)
{
  return mapped_cube(n, 0.1, [=](const Vector3d& p) -> Vector3d
  {
    const double angle = total_angle * p[0] / n, radius = 0.5 + p[1] / n;
    return Vector3d(radius * std::sin(angle), radius * std::cos(angle), p[2] / n);
  });
}

TEST_CASE("A moving boundary is followed in less than a third of the Newton steps")
{
  Complex complex(bent_cube(6, 4.5));
  REQUIRE(parameterize(complex).status == VMP::OK);
  Point_map before;
  for(const double angle : {4.55, 4.6, 4.65})
  {
    const Numbered_mesh_3 mesh = bent_cube(6, angle);
    for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
      complex.target[complex.vertices[v]] = Point_3(mesh.target(0, v), mesh.target(1, v), mesh.target(2, v));
    Point_map initial = complex.uvw;
    for(const auto& [v, p] : before) // as if all moved on
      initial[v] += initial[v] - p;
    before = complex.uvw;

    const Parameterization_result cold = parameterize(complex);
    const Point_map expected = complex.uvw;
    const Parameterization_result warm
      = parameterize(complex, params::initial_map(VMP::make_vertex_point_map(initial)));
    CHECK(warm.status == VMP::OK);
    check_valid_map(complex, warm);
    CHECK(cold.number_of_inverted_cells_at_start > 0);
    CHECK(warm.number_of_inverted_cells_at_start == 0);
    CHECK((angle == 4.55 ? 2 : 3) * warm.number_of_iterations < cold.number_of_iterations);
    CHECK(warm.energy == Approx(cold.energy).epsilon(1e-7));
    for(const auto& [v, p] : expected)
      CHECK(CGAL::squared_distance(p, complex.uvw.at(v)) < 1e-6);
  }
}

TEST_CASE("Any initial map is completed, untangled, or dropped")
{
  Complex complex(ring(5));
  const Parameterization_result cold = parameterize(complex);
  REQUIRE(cold.status == VMP::OK);
  REQUIRE(cold.number_of_inverted_cells_at_start > 0);
  Point_map initial = complex.uvw;
  const auto from_initial_map = [&]
  {
    const Parameterization_result result
      = parameterize(complex, params::initial_map(VMP::make_vertex_point_map(initial)));
    check_valid_map(complex, result);
    CHECK(result.status == VMP::OK);
    CHECK(result.energy == Approx(cold.energy).epsilon(1e-6));
    return result;
  };
  const Parameterization_result warm = from_initial_map();
  CHECK(warm.number_of_untangling_iterations == 0);
  CHECK(warm.number_of_iterations <= 2);

  SECTION("few images are missing")
  {
    for(const int v : {5, 40, 100}) // inside and on the boundary
      initial.erase(complex.vertices[v]);
    CHECK(from_initial_map().number_of_untangling_iterations < cold.number_of_untangling_iterations);
  }
  SECTION("all images are missing")
  {
    initial.clear();
    CHECK(from_initial_map().number_of_inverted_cells_at_start == cold.number_of_inverted_cells_at_start);
  }
  SECTION("cells are inverted")
  {
    std::swap(initial[complex.vertices[5]], initial[complex.vertices[6]]);
    CHECK(from_initial_map().number_of_inverted_cells_at_start > 0);
  }
  SECTION("vertices inside are thrown together")
  {
    for(int v = 0; v < complex.mesh.number_of_free_vertices; ++v)
      initial[complex.vertices[v]] = Point_3(1e20 * (v % 7), -1e20 * (v % 5), 1e20 * (v % 3));
    from_initial_map();
  }
  SECTION("images are infinite, or too large")
  {
    const Point_map uvw = complex.uvw;
    for(const double x : {std::numeric_limits<double>::infinity(), 1e200})
    {
      initial[complex.vertices[5]] = Point_3(0, x, 0);
      const Parameterization_result result
        = parameterize(complex, params::initial_map(VMP::make_vertex_point_map(initial)));
      CHECK(result.status == (std::isinf(x) ? VMP::ERROR_NON_FINITE_COORDINATE : VMP::ERROR_SIZE_OUT_OF_RANGE));
      CHECK(result.message.find("initial image") != std::string::npos);
      CHECK(complex.uvw.empty());
    }
  }
}

TEST_CASE("A constrained vertex inside goes where the boundary map tells")
{
  Complex complex(cube_mesh(4));
  const std::unordered_set<Vertex_handle> constrained = {complex.vertices[3], complex.vertices[20]};
  for(const Vertex_handle v : constrained)
  {
    const Point_3 p = v->point();
    complex.target[v] = Point_3(p.x() + 0.125, p.y(), p.z());
  }
  const Parameterization_result result
    = parameterize(complex, params::vertex_is_constrained_map(Read_only_set{&constrained}));
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_boundary_vertices == 98);
  check_valid_map(complex, result); // their images as well
}

TEST_CASE("Named parameters combine in any order")
{
  Complex complex(twisted_cube(4, 0.1));
  const std::unordered_set<Vertex_handle> constrained;
  const Read_only_set is_constrained{&constrained};
  Counting_visitor visitor;
  Solver solver;
  const auto call = [&](const auto& np)
  {
    complex.uvw.clear();
    visitor.steps.clear();
    const Captured_output output;
    const Parameterization_result result
      = CGAL::stretch_minimizing_volume_parameterization(complex.c3t3, complex.uvw_map(), np); // not constant
    CHECK(result.status == VMP::OK);
    CHECK(visitor.steps.size() == result.number_of_iterations);
    CHECK(!output.text().empty());
    return complex.uvw;
  };

  const Point_map expected = call(params::boundary_map(complex.boundary_map())
                                         .energy(VMP::Stretch_energy_3())
                                         .solver_traits(std::ref(solver))
                                         .vertex_is_constrained_map(is_constrained)
                                         .number_of_iterations(100)
                                         .maximum_running_time(100)
                                         .boundary_mode(VMP::Boundary_mode::AUTO)
                                         .refinement_mode(VMP::Refinement_mode::NONE)
                                         .visitor(std::ref(visitor))
                                         .verbose(true));
  CHECK(call(params::verbose(true).refinement_mode(VMP::Refinement_mode::NONE).boundary_mode(VMP::Boundary_mode::AUTO)
                    .visitor(std::ref(visitor)).maximum_running_time(100).number_of_iterations(100)
                    .vertex_is_constrained_map(is_constrained).solver_traits(Solver())
                    .energy(VMP::Stretch_energy_3()).boundary_map(complex.boundary_map())) == expected);
  CHECK(call(params::number_of_iterations(100).boundary_map(complex.boundary_map()).verbose(true)
                    .solver_traits(std::ref(solver)).visitor(std::ref(visitor))) == expected);
}

TEST_CASE("Two arguments suffice: the boundary goes to the unit sphere, and the complex is refined if it may be")
{
  constexpr int n_cubes = 7;
  const auto leave_comb = [](Complex& of_cubes)
  {
    for(int cube = 0; cube < n_cubes * n_cubes * n_cubes; ++cube)
      if(cube / (n_cubes * n_cubes) > 0 && cube / n_cubes % n_cubes % 2 == 1)
        for(int i = 0; i < 6; ++i)
          of_cubes.c3t3.remove_from_complex(of_cubes.cells[6 * cube + i]);
  };
  Complex complex(cube_mesh(n_cubes)), other(cube_mesh(n_cubes));
  leave_comb(complex);
  leave_comb(other);
  const std::size_t n = complex.c3t3.triangulation().number_of_vertices();
  const Parameterization_result constant
    = CGAL::stretch_minimizing_volume_parameterization(std::as_const(complex.c3t3), complex.uvw_map());
  CHECK(constant.status == VMP::ERROR_BOUNDARY_NOT_REACHED);
  CHECK(constant.message.find("refinement_mode") != std::string::npos);
  CHECK(constant.message.find("intersects itself") == std::string::npos);
  CHECK(complex.c3t3.triangulation().number_of_vertices() == n);

  const Parameterization_result result
    = CGAL::stretch_minimizing_volume_parameterization(complex.c3t3, complex.uvw_map());
  CHECK(result.status == VMP::OK);
  CHECK(complex.c3t3.triangulation().number_of_vertices() == n + result.number_of_added_vertices);
  for(const Vertex_handle vertex : complex.vertices)
  {
    const Point_3& p = complex.uvw.at(vertex);
    CHECK(p.x() * p.x() + p.y() * p.y() + p.z() * p.z() == Approx(1).epsilon(1e-12));
  }

  // the initial map lacks the vertices which refinement has inserted, fewer than would help, so that the first map is slow
  const auto np = params::refinement_mode(VMP::Refinement_mode::NEEDED);
  const Parameterization_result slow
    = CGAL::stretch_minimizing_volume_parameterization(other.c3t3, other.uvw_map(), np);
  CHECK(slow.status == VMP::OK);
  REQUIRE(slow.number_of_added_vertices > 0);
  CHECK(slow.number_of_added_vertices < result.number_of_added_vertices);
  Point_map initial;
  for(const Vertex_handle vertex : other.vertices)
    initial.emplace(vertex, other.uvw.at(vertex));
  const Parameterization_result again = CGAL::stretch_minimizing_volume_parameterization(
    other.c3t3, other.uvw_map(), np.initial_map(VMP::make_vertex_point_map(initial)));
  CHECK(again.status == VMP::OK);
  CHECK(again.number_of_iterations < slow.number_of_iterations);
}

TEST_CASE("A complex that is no ball is refused unless there is a boundary map")
{
  Complex complex(cube_mesh(4));
  const Vertex_handle middle = complex.vertices[13]; // the middle one of 27 vertices inside
  for(const auto c : complex.cells)
    if(c->has_vertex(middle))
      complex.c3t3.remove_from_complex(c);
  const Parameterization_result result
    = CGAL::stretch_minimizing_volume_parameterization(complex.c3t3, complex.uvw_map());
  CHECK(result.status == VMP::ERROR_SEVERAL_BOUNDARY_COMPONENTS);
  CHECK(!result.has_valid_map);
  CHECK(complex.uvw.empty());
}

TEST_CASE("A tag chooses the threads and not the result")
{
  Complex complex(twisted_cube(6, 0.1));
  parameterize(complex);
  const Point_map expected = complex.uvw;
  complex.uvw.clear();
  CGAL::stretch_minimizing_volume_parameterization<CGAL::Parallel_if_available_tag>(
    std::as_const(complex.c3t3), complex.uvw_map(), params::boundary_map(complex.boundary_map()));
  CHECK(complex.uvw == expected);
}

TEST_CASE("Property maps need no more than their concepts demand")
{
  Complex complex(twisted_cube(3));
  parameterize(complex);
  const Point_map expected = complex.uvw;
  Point_map uvw;
  const auto result = CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(complex.c3t3), Write_only_map{&uvw}, params::boundary_map(Read_only_map{&complex.target}));
  CHECK(result.status == VMP::OK);
  CHECK(uvw == expected);

  const auto target = [&](const Vertex_handle v) -> Point_3 { return complex.target.at(v); };
  CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(complex.c3t3), Write_only_map{&uvw},
    params::boundary_map(boost::make_function_property_map<Vertex_handle>(target)));
  CHECK(uvw == expected);
}

TEST_CASE("A visitor ends the computation")
{
  Complex complex(ring(5));
  const std::size_t untangling = parameterize(complex).number_of_untangling_iterations;

  Counting_visitor early(1);
  const Parameterization_result inverted = parameterize(complex, params::visitor(std::ref(early)));
  CHECK(inverted.status == VMP::ERROR_INTERRUPTED);
  CHECK(!inverted.has_valid_map);
  CHECK(inverted.number_of_iterations == 1);
  CHECK(complex.uvw.empty());

  Counting_visitor late(untangling);
  const Parameterization_result flip_free = parameterize(complex, params::visitor(std::ref(late)));
  CHECK(flip_free.status == VMP::ERROR_INTERRUPTED);
  CHECK(flip_free.number_of_iterations == untangling);
  check_valid_map(complex, flip_free);
}

TEST_CASE("What a visitor throws passes through")
{
  struct Throwing_visitor
  {
    bool after_step(const VMP::Parameterization_step&) { throw 17; }
  };
  Complex complex(twisted_cube(3));
  CHECK_THROWS_AS(parameterize(complex, params::visitor(Throwing_visitor())), int);
  CHECK(complex.uvw.empty());
}

TEST_CASE("An empty complex is refused")
{
  Complex complex(twisted_cube(2));
  for(const auto& c : complex.cells)
    complex.c3t3.remove_from_complex(c);
  check_refusal(complex, VMP::ERROR_EMPTY_COMPLEX, {"no cell"});
}

TEST_CASE("A vertex without a target is refused, and the container stays as it is")
{
  Complex complex(twisted_cube(3));
  complex.target.erase(complex.vertices[50]);
  const Point_map targets = complex.target;
  check_refusal(complex, VMP::ERROR_MISSING_BOUNDARY_TARGET, {"no target"});
  CHECK(complex.target == targets);

  const auto result = CGAL::stretch_minimizing_volume_parameterization(
    complex.c3t3, complex.uvw_map(), params::boundary_map(VMP::make_vertex_point_map(targets))
                                            .refinement_mode(VMP::Refinement_mode::HELPFUL));
  CHECK(result.status == VMP::ERROR_MISSING_BOUNDARY_TARGET);
  CHECK(targets.size() == 55);
}

TEST_CASE("A missing target is refused")
{
  Complex complex(twisted_cube(3));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  complex.target[complex.vertices[50]] = Point_3(1, nan, 0);
  const Vector3d p = complex.mesh.source.col(50);
  check_refusal(complex, VMP::ERROR_MISSING_BOUNDARY_TARGET,
                {"no target", "(" + to_string(p[0]) + ", " + to_string(p[1]) + ", " + to_string(p[2]) + ")"});
}

TEST_CASE("Infinite coordinates are refused")
{
  const double infinity = std::numeric_limits<double>::infinity();
  Complex complex(twisted_cube(3));
  SECTION("of a target")
  {
    complex.target[complex.vertices[60]] = Point_3(infinity, 0, 0);
    check_refusal(complex, VMP::ERROR_NON_FINITE_COORDINATE, {"target", "inf"});
  }
  SECTION("of the source")
  {
    complex.vertices[2]->set_point(Complex::Tr::Point(Point_3(0, -infinity, 0)));
    check_refusal(complex, VMP::ERROR_NON_FINITE_COORDINATE, {"source", "-inf"});
  }
  SECTION("of the source, not a number")
  {
    complex.vertices[2]->set_point(Complex::Tr::Point(Point_3(0, 0, std::nan(""))));
    check_refusal(complex, VMP::ERROR_NON_FINITE_COORDINATE, {"source", "nan"});
  }
}

TEST_CASE("An inverted or flat source cell is refused, with its index and volume")
{
  Complex complex(twisted_cube(3));
  const Vertex_handle moved = complex.vertices[4];
  const double distance = GENERATE(1., 1.75);
  const Point_3 p = moved->point();
  moved->set_point(Complex::Tr::Point(Point_3(p.x() + distance, p.y(), p.z())));
  Point_map source;
  for(const Vertex_handle v : complex.vertices)
    source[v] = v->point();
  const Negative_cells negative(complex, source);
  REQUIRE(negative.number > 0);
  check_refusal(complex, VMP::ERROR_INVERTED_SOURCE_CELL,
                {to_string(negative.number) + " cell", "cell " + to_string(negative.first),
                 "volume " + to_string(negative.volume)});
}

TEST_CASE("A target turned inside out is refused, with its volume")
{
  Complex complex(mapped_cube(3, 0, [](const Vector3d& p) { return Vector3d(p[0], p[1], -p[2]); }));
  check_refusal(complex, VMP::ERROR_INVERTED_TARGET_BOUNDARY, {"-27", "inside out"});
}

TEST_CASE("A flat target is refused, and not called turned")
{
  int number_of_refusals = 0;
  for(const double slope : {0., 0.1, -0.1, 0.7, -0.7}) // rounding makes the volume of a tilted one positive or negative
  {
    const auto tilt = [&](const Vector3d& p) { return Vector3d(p[0], p[1], slope * (p[0] + p[1] / 3)); };
    Complex complex(mapped_cube(3, 0, tilt));
    const Parameterization_result result = parameterize(complex, params::number_of_iterations(0));
    INFO(result.message);
    if(result.status != VMP::ERROR_INVERTED_TARGET_BOUNDARY)
      continue;
    ++number_of_refusals;
    CHECK((result.message.find("volume 0") != std::string::npos) == (slope == 0));
    CHECK(result.message.find("flat") != std::string::npos);
    CHECK(result.message.find("turned") == std::string::npos);
  }
  CHECK(number_of_refusals >= 2);
}

TEST_CASE("Targets in one point are called flat")
{
  for(const Vector3d& point : { Vector3d(0, 0, 0), Vector3d(1, 2, 3), Vector3d(1e6, -0.1, 1e-6) })
  {
    Complex complex(mapped_cube(3, 0, [&](const Vector3d&) { return point; }));
    check_refusal(complex, VMP::ERROR_INVERTED_TARGET_BOUNDARY, {"volume 0,", "flat"});
  }
}

TEST_CASE("Bodies so small or so large that volumes cannot be computed are refused by their size")
{
  const double size = GENERATE(1e-300, 1e-110, 1e-75, 1e75, 1e110, 1e300);
  Complex complex(twisted_cube(3));
  SECTION("source")
  {
    for(const Vertex_handle v : complex.vertices)
      v->set_point(Complex::Tr::Point(CGAL::ORIGIN + size * (v->point() - CGAL::ORIGIN)));
    check_refusal(complex, VMP::ERROR_SIZE_OUT_OF_RANGE, {"source has the diagonal"});
  }
  SECTION("target")
  {
    for(auto& [v, p] : complex.target)
      p = CGAL::ORIGIN + size * (p - CGAL::ORIGIN);
    check_refusal(complex, VMP::ERROR_SIZE_OUT_OF_RANGE, {"prescribed points has the diagonal"});
  }
}

TEST_CASE("A shifted target has the shifted map")
{
  const Vector3d shift = GENERATE(Vector3d(1e6, 2e6, 3e6), Vector3d(-1e8, 0, 1), Vector3d(0.5, 0.25, -16));
  const double rounding = 1e-15 * shift.norm(), convergence = 3e-5; // for cubes of size 1
  const auto map_of = [](Complex& complex, const auto& energy)
  {
    const Parameterization_result result = parameterize(complex, params::energy(energy));
    INFO(result.message);
    CHECK(result.status == VMP::OK);
    return result;
  };
  SECTION("of the identity")
  {
    Complex complex(mapped_cube(4, 0, [&](const Vector3d& p) -> Vector3d { return p + shift; }));
    const Parameterization_result result = map_of(complex, VMP::Stretch_energy_3());
    CHECK(result.energy == Approx(3));
    const Numbered_mesh_3 image = image_mesh(complex);
    CHECK((image.target.colwise() - shift - image.source).cwiseAbs().maxCoeff() <= 10 * rounding + convergence);
  }
  SECTION("of a twisted cube, with an energy that knows the volume")
  {
    Numbered_mesh_3 mesh = twisted_cube(4, 0.1);
    Complex expected(mesh);
    mesh.target.colwise() += shift;
    Complex complex(mesh);
    const VMP::Symmetric_Dirichlet_energy_3 energy;
    const double expected_energy = map_of(expected, energy).energy;
    CHECK(map_of(complex, energy).energy == Approx(expected_energy).epsilon(1e-9 + rounding));
    const Eigen::Matrix3Xd difference = image_mesh(complex).target - image_mesh(expected).target;
    CHECK((difference.colwise() - shift).cwiseAbs().maxCoeff() <= 10 * rounding + convergence);
  }
}

TEST_CASE("A soft boundary with constraints that ends within its tolerance is a success, and nothing is refined")
{
  Complex complex(mapped_cube(4, 0, [](const Vector3d& p) -> Vector3d
  { return p - (p == Vector3d(2, 2, 4) ? 1 : 0) * Vector3d::UnitZ(); }));
  std::vector<VMP::Linear_constraint_3<Vertex_handle> > constraints; // the plane of symmetry keeps its place
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    if(complex.mesh.source(0, v) == 2)
      constraints.push_back({ { { complex.vertices[v], Vector3d::UnitX() } }, 2. });
  VMP::Soft_boundary_parameters parameters;
  const auto run = [&](const VMP::Refinement_mode refinement_mode)
  {
    return CGAL::stretch_minimizing_volume_parameterization(
      complex.c3t3, complex.uvw_map(), params::boundary_map(complex.boundary_map()).boundary_mode(VMP::Boundary_mode::SOFT)
                                              .positional_constraints(constraints).soft_boundary_parameters(parameters)
                                              .refinement_mode(refinement_mode));
  };
  const Parameterization_result result = run(VMP::Refinement_mode::HELPFUL);
  INFO(result.message);
  CHECK(result.status == VMP::OK_WITHIN_TOLERANCE);
  CHECK(result.has_valid_map);
  CHECK(result.number_of_added_vertices == 0);
  CHECK(result.message.find("the tolerance is 1e-06") != std::string::npos);
  CHECK(result.message.find("efine") == std::string::npos);
  double distance = 0;
  for(const auto& [v, p] : complex.target)
    distance = (std::max)(distance, std::sqrt(CGAL::squared_distance(p, complex.uvw.at(v))));
  CHECK(distance > 0);
  CHECK(distance < 1e-6 * 4); // where the target has volume 1, lengths are a fourth

  parameters.residual_tolerance = 1e-20;
  parameters.maximum_number_of_raises = 1;
  CHECK(run(VMP::Refinement_mode::NONE).status == VMP::ERROR_BOUNDARY_NOT_REACHED);
}

TEST_CASE("A boundary that is missed is told with the place, and whether it intersects itself")
{
  // the middle of the upper face is drawn through the lower one
  Complex complex(mapped_cube(4, 0, [](const Vector3d& p) { return p == Vector3d(2, 2, 4) ? Vector3d(2, 2, -1) : p; }));
  const Parameterization_result missed = parameterize(complex);
  INFO(missed.message);
  CHECK(missed.status == VMP::ERROR_BOUNDARY_NOT_REACHED);
  CHECK(missed.boundary_residual > 0);
  for(const char* words : {"(2, 2, 4) is at (", "instead of (2, 2, -1)", "refinement_mode", "intersects itself"})
    CHECK(missed.message.find(words) != std::string::npos);

  const Parameterization_result none = parameterize(complex, params::boundary_mode(VMP::Boundary_mode::FIXED));
  CHECK(none.status == VMP::ERROR_NOT_FLIP_FREE);
  CHECK(none.message.find("intersects itself") != std::string::npos);
  for(const double x : {none.distortion.angle_mean, none.distortion.angle_max, none.distortion.volume_mean,
                        none.distortion.volume_max, none.distortion_at_source_volume.angle_max, none.boundary_residual})
    CHECK(std::isnan(x));
}

TEST_CASE("A boundary that is no manifold is told with a vertex and a remedy")
{
  Complex complex(cube_mesh(2));
  for(int cube = 1; cube < 7; ++cube) // leaves two cubes that share the vertex in the middle
    for(int i = 0; i < 6; ++i)
      complex.c3t3.remove_from_complex(complex.cells[6 * cube + i]);
  const Parameterization_result result
    = CGAL::stretch_minimizing_volume_parameterization(complex.c3t3, complex.uvw_map());
  INFO(result.message);
  CHECK(result.status == VMP::ERROR_NON_MANIFOLD_BOUNDARY);
  for(const char* words : {"a vertex of its own", "1 vertex, the one at (1, 1, 1)"})
    CHECK(result.message.find(words) != std::string::npos);
  const std::vector<Vertex_handle> vertices = VMP::non_manifold_boundary_vertices(complex.c3t3);
  REQUIRE(vertices.size() == 1);
  CHECK(Point_3(1, 1, 1) == vertices[0]->point());
}

TEST_CASE("Messages do not depend on the global locale")
{
  struct Grouping_punctuation : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const auto messages = []
  {
    const auto draw_through = [](const Vector3d& p) -> Vector3d
    {
      return 1234.5 * (p == Vector3d(2, 2, 4) ? Vector3d(2, 2, -1) : p); // the middle of the upper face, below the lower one
    };
    std::vector<std::string> result;

    Complex missed(mapped_cube(4, 0, draw_through));
    result.push_back(parameterize(missed).message);
    result.push_back(parameterize(missed, params::boundary_mode(VMP::Boundary_mode::FIXED)).message);
    missed.target[missed.vertices.back()] = Point_3(1234.5, std::nan(""), 0);
    missed.vertices.back()->set_point(Complex::Tr::Point(Point_3(1234.5, 4, 4)));
    result.push_back(parameterize(missed).message);

    Complex stretched(mapped_cube(3, 0, [](const Vector3d& p) { return Vector3d(12345 * p[0], p[1], p[2]); }));
    result.push_back(parameterize(stretched, params::maximum_angle_distortion(2.5)).message);

    Complex pinched(cube_mesh(2));
    for(int cube = 1; cube < 7; ++cube)
      for(int i = 0; i < 6; ++i)
        pinched.c3t3.remove_from_complex(pinched.cells[6 * cube + i]);
    pinched.vertices.front()->set_point(Complex::Tr::Point(Point_3(1234.5, 1, 1)));
    result.push_back(CGAL::stretch_minimizing_volume_parameterization(pinched.c3t3, pinched.uvw_map()).message);

    VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(1));
    for(std::array<double, 3>& p : soup.points)
      p[0] *= 12345;
    std::swap(soup.cells[0][2], soup.cells[0][3]);
    try
    {
      VMP::tetrahedron_soup_to_mesh_complex_3(soup, pinched.c3t3, pinched.vertices, pinched.cells);
    }
    catch(const VMP::Input_error& error)
    {
      result.push_back(error.what());
    }
    return result;
  };
  const std::vector<std::string> expected = messages();
  const std::locale global = std::locale::global(std::locale(std::locale::classic(), new Grouping_punctuation));
  const std::vector<std::string> found = messages();
  std::locale::global(global);
  REQUIRE(expected.size() == 6);
  CHECK(found == expected);
  CAPTURE(expected);
  CHECK(expected[0].find("-1234.5") != std::string::npos);
  CHECK(expected[2].find("(1234.5, ") != std::string::npos);
}

TEST_CASE("With its least value as bound, the distortion of angles is compared with what the boundary forces")
{
  Complex stretched(mapped_cube(2, 0, [](const Vector3d& p) { return Vector3d(2 * p[0], p[1], p[2]); }));
  CHECK(parameterize(stretched, params::maximum_angle_distortion(3)).unavoidable_angle_distortion == 0);
  const Parameterization_result result = parameterize(stretched, params::maximum_angle_distortion(VMP::least_angle_distortion));
  CHECK(result.status == VMP::OK);
  CHECK(result.unavoidable_angle_distortion == Approx(2.5)); // 2 + 1 / 2
  CHECK(result.distortion.angle_max == Approx(2.5));
}

TEST_CASE("The vertices that need a target")
{
  Complex complex(twisted_cube(4));
  const std::vector<Vertex_handle> vertices = VMP::boundary_vertices(complex.c3t3);
  CHECK(vertices.size() == complex.target.size());
  for(const Vertex_handle v : vertices)
    CHECK(complex.target.count(v) == 1);
  CHECK(VMP::non_manifold_boundary_vertices(complex.c3t3).empty());
}

TEST_CASE("Broken preconditions throw, also in programs compiled with NDEBUG")
{
  Complex complex(twisted_cube(2));
  CHECK_THROWS_AS(parameterize(complex, params::energy_tolerance(-1.)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(parameterize(complex, params::maximum_angle_distortion(1)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(parameterize(complex, params::maximum_angle_distortion(std::nan(""))), CGAL::Precondition_exception);
  CHECK_THROWS_AS(parameterize(complex, params::number_of_iterations(-1)), CGAL::Precondition_exception);
  CHECK(complex.uvw.empty());
  constexpr std::size_t many = (std::numeric_limits<std::size_t>::max)();
  CHECK(parameterize(complex, params::number_of_iterations(many)).status == VMP::OK);
}

TEST_CASE("Arrays are mapped as a complex is")
{
  Complex complex(twisted_cube(4, 0.1));
  REQUIRE(parameterize(complex).status == VMP::OK);

  VMP::Tetrahedron_soup_3 soup = source_soup(complex.mesh);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, 3> > targets(soup.points.size(), {nan, nan, nan}), images(1);
  for(std::size_t v = 0; v < targets.size(); ++v)
    if(complex.target.count(complex.vertices[v]) == 1)
      for(int i = 0; i < 3; ++i)
        targets[v][i] = complex.mesh.target(i, v);
  soup.points.push_back({7, 7, 7}); // without a cell
  targets.push_back({7, 7, 7});
  const auto call = [&](const auto& np)
  {
    return CGAL::stretch_minimizing_volume_parameterization(soup.points, soup.cells, targets, images, np);
  };

  const Parameterization_result result = call(params::verbose(false));
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_vertices == 125);
  CHECK(result.number_of_boundary_vertices == 98);
  REQUIRE(images.size() == 126);
  CHECK(std::isnan(images.back()[0]));
  for(std::size_t v = 0; v < 125; ++v)
    for(int i = 0; i < 3; ++i)
      CHECK(images[v][i] == Approx(complex.uvw.at(complex.vertices[v])[i]).margin(1e-6));

  const std::vector<VMP::Cell_distortion_3> distortions = VMP::cell_distortions(soup.points, soup.cells, images);
  const std::vector<VMP::Cell_distortion_3> of_complex = VMP::cell_distortions(complex.c3t3, complex.uvw_map());
  REQUIRE(of_complex.size() == distortions.size());
  std::map<std::decay_t<decltype(complex.cells[0])>, std::size_t> index; // of a cell in the complex
  for(auto c = complex.c3t3.cells_in_complex_begin(); c != complex.c3t3.cells_in_complex_end(); ++c)
    index.emplace(c, index.size());
  double angle_max = 0;
  for(std::size_t c = 0; c < distortions.size(); ++c)
  {
    angle_max = (std::max)(angle_max, distortions[c].angle);
    const VMP::Cell_distortion_3& distortion = of_complex[index.at(complex.cells[c])];
    CHECK(distortion.angle == Approx(distortions[c].angle).epsilon(1e-5));
    CHECK(distortion.det_J == Approx(distortions[c].det_J).epsilon(1e-5));
  }
  CHECK(angle_max == Approx(result.distortion.angle_max));

  // a free vertex that is prescribed as well
  const std::size_t middle = 3;
  std::vector<std::size_t> is_constrained(126, 0);
  is_constrained[middle] = 1;
  targets[middle] = {images[middle][0] + 0.01, images[middle][1], images[middle][2]};
  const auto is_constrained_map
    = boost::make_iterator_property_map(is_constrained.begin(), boost::identity_property_map());
  CHECK(call(params::vertex_is_constrained_map(is_constrained_map)).status == VMP::OK);
  CHECK(images[middle] == targets[middle]);

  // the images are the start, and are written
  const Parameterization_result again
    = call(params::initial_map(boost::make_iterator_property_map(images.begin(), boost::identity_property_map())));
  CHECK(again.status == VMP::OK);
  CHECK(again.number_of_iterations <= 3);

  // refused problems leave the images alone
  const std::vector<std::array<double, 3> > expected = images;
  targets[124][1] = nan;
  CHECK(call(params::verbose(false)).status == VMP::ERROR_MISSING_BOUNDARY_TARGET);
  for(std::array<std::size_t, 4>& cell : soup.cells)
    std::swap(cell[0], cell[1]);
  targets[124][1] = 0;
  CHECK(call(params::verbose(false)).message.find("Exchange two vertices") != std::string::npos);
  soup.cells[5][1] = 126;
  CHECK_THROWS_AS(call(params::verbose(false)), VMP::Input_error);
  targets.pop_back();
  CHECK_THROWS_AS(call(params::verbose(false)), CGAL::Precondition_exception);
  CHECK(images.size() == expected.size());
  CHECK(images[0] == expected[0]);
}

TEST_CASE("Cells that the boundary map inverts or flattens are refused, with their number and the first one")
{
  // a vertex of an edge is drawn into the cube, or onto the opposite face of a cell
  Complex complex(cube_mesh(3));
  const double depth = GENERATE(1., 1.5);
  for(const auto& [v, p] : complex.target)
    if(p == Point_3(0, 3, 1))
      complex.target[v] = Point_3(depth, 3 - depth, 1);
  const Negative_cells negative(complex, complex.target);
  REQUIRE(negative.number > 0);
  check_refusal(complex, VMP::ERROR_PRESCRIBED_CELL_INVERTED,
                {to_string(negative.number) + " cell", "cell " + to_string(negative.first)}, VMP::Boundary_mode::FIXED);
}

TEST_CASE("A facet of the boundary that the target flattens is named, and nothing is refined in vain")
{
  Complex complex(cube_mesh(3));
  for(auto& [v, p] : complex.target) // onto the line of the two others, (1, 1, 0) and (2, 2, 0)
    if(p == Point_3(2, 1, 0))
      p = Point_3(1.5, 1.5, 0);
  check_refusal(complex, VMP::ERROR_PRESCRIBED_CELL_INVERTED, {"on a line", "No refinement helps", "is on the boundary"},
                VMP::Boundary_mode::FIXED);

  const auto result = CGAL::stretch_minimizing_volume_parameterization(
    complex.c3t3, complex.uvw_map(), params::boundary_map(complex.boundary_map()).refinement_mode(VMP::Refinement_mode::HELPFUL));
  CHECK(result.status == VMP::ERROR_BOUNDARY_NOT_REACHED);
  CHECK(result.has_valid_map);
  CHECK(result.number_of_added_vertices == 0);
  CHECK(result.message.find("No refinement helps") != std::string::npos);
  CHECK(result.message.find("Allow refinement") == std::string::npos);
  CHECK(result.message.find("Prescribe a boundary nearer") != std::string::npos);

  for(auto& [v, p] : complex.target) // off the line
    if(p == Point_3(1.5, 1.5, 0))
      p = Point_3(1.6, 1.5, 0);
  CHECK(parameterize(complex).status == VMP::OK);
}

TEST_CASE("Each status has a sentence")
{
  std::unordered_set<std::string> sentences;
  for(int code = VMP::OK; code <= VMP::ERROR_INCOMPLETE_HEXAHEDRA; ++code)
  {
    const std::string sentence = VMP::get_error_message(static_cast<VMP::Error_code>(code));
    CHECK(sentences.insert(sentence).second);
    CHECK(sentence.find("Unknown") == std::string::npos);
  }
}
