// Conditions of vertices: at their targets, in planes, on lines, free.
#include "catch.h"
#include "cube_complex.h"
#include "cube_mesh.h"
#include "fuzz_inputs.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Any_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/conditions_of_patches.h>
#include <CGAL/Volume_mesh_parameterization/measure_forces.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>

#include <CGAL/property_map.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

namespace { namespace of_conditions {

using Condition = VMP::Vertex_condition_3;
using Eigen::Vector3d;
using Point = std::array<double, 3>;

constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();

Vector3d vector(const Point& p) { return Vector3d(p[0], p[1], p[2]); }
Point point(const Vector3d& p) { return { p[0], p[1], p[2] }; }

// A mesh, with a condition and a target of each vertex.
struct Problem
{
  VMP::Tetrahedron_soup_3 soup;
  std::vector<Condition> conditions;
  std::vector<Point> targets, images;
  VMP::Any_energy_3 energy = VMP::Symmetric_Dirichlet_energy_3();
  double reference_scale = 1;
  bool use_volume_weights = false;

  explicit Problem(VMP::Tetrahedron_soup_3 mesh)
    : soup(std::move(mesh)), conditions(soup.points.size()), targets(soup.points.size(), Point{ nan_, nan_, nan_ })
  {
    soup.cell_references.assign(soup.cells.size(), 1);
    VMP::orient_tetrahedron_soup(soup);
  }

  template <typename Predicate, typename Map>
  void set(const Predicate& is_chosen, const Condition& condition, const Map& target)
  {
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      if(is_chosen(vector(soup.points[v])))
      {
        conditions[v] = condition;
        targets[v] = point(target(vector(soup.points[v])));
      }
  }

  template <typename Visitor = VMP::Default_visitor>
  VMP::Parameterization_result run(const bool may_refine = false, const Visitor& visitor = Visitor())
  {
    const auto conditions_of_old = [&](const std::size_t v) { return v < conditions.size() ? conditions[v] : Condition(); };
    images.clear();
    const auto np = params::energy(energy)
      .vertex_condition_map(boost::make_function_property_map<std::size_t>(conditions_of_old)).energy_tolerance(0)
      .reference_scale(reference_scale).use_volume_weights(use_volume_weights).visitor(visitor);
    if(may_refine)
      return CGAL::stretch_minimizing_volume_parameterization(soup, targets, images,
                                                              np.refinement_mode(VMP::Refinement_mode::HELPFUL));
    return CGAL::stretch_minimizing_volume_parameterization(
      const_cast<const VMP::Tetrahedron_soup_3&>(soup), targets, images, np);
  }

  bool has_positive_cells() const
  {
    using K = CGAL::Exact_predicates_inexact_constructions_kernel;
    const auto image = [&](const std::size_t v) { return K::Point_3(images[v][0], images[v][1], images[v][2]); };
    for(const auto& [a, b, c, d] : soup.cells)
      if(CGAL::orientation(image(a), image(b), image(c), image(d)) != CGAL::POSITIVE)
        return false;
    return true;
  }

  // To the bit in directions of axes, otherwise within rounding.
  bool meets_conditions() const
  {
    for(std::size_t v = 0; v < conditions.size(); ++v)
    {
      const Vector3d d = vector(images[v]) - vector(targets[v]), n = vector(conditions[v].direction());
      const bool is_along_axis = (n.array() != 0).count() == 1;
      const double rounding = is_along_axis ? 0 : 1e-13 * (1 + vector(images[v]).norm() + vector(targets[v]).norm());
      switch(conditions[v].kind())
      {
        case Condition::FREE: break;
        case Condition::AT_TARGET:
          if(images[v] != targets[v])
            return false;
          break;
        case Condition::IN_PLANE:
          for(int i = 0; i < 3; ++i)
            if(is_along_axis && n[i] != 0 && images[v][i] != targets[v][i])
              return false;
          if(!is_along_axis && std::abs(n.normalized().dot(d)) > rounding)
            return false;
          break;
        case Condition::ON_LINE:
          for(int i = 0; i < 3; ++i)
            if(is_along_axis && n[i] == 0 && images[v][i] != targets[v][i])
              return false;
          if(!is_along_axis && n.normalized().cross(d).norm() > rounding)
            return false;
          break;
        default: return false; // none slides here
      }
    }
    return true;
  }

  double largest_distance(const std::vector<Point>& expected) const
  {
    double result = 0;
    for(std::size_t v = 0; v < images.size(); ++v)
      result = (std::max)(result, (vector(images[v]) - vector(expected[v])).norm());
    return result;
  }
};

// The box [0, n]^3 with its bottom, a horizontal plane in the middle, or its top.
Problem box(const int n, const double jitter = 0.1) { return Problem(source_soup(cube_mesh(n, jitter))); }

const auto at_bottom = [](const Vector3d& p) { return p[2] == 0; };
const auto as_it_is = [](const Vector3d& p) { return p; };

TEST_CASE("A body with handles follows a rigid motion and a similarity of these")
{
  for(const double scale : { 1., 1e-3 })
  {
    Problem problem = box(4);
    const Eigen::Matrix3d A = scale * Eigen::AngleAxisd(2.5, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const auto moved = [&](const Vector3d& p) -> Vector3d { return A * p + Vector3d(7, 8, 9); };
    problem.set([](const Vector3d& p) { return p[2] == 0 || p[2] == 4; }, Condition::at_target(), moved);
    problem.reference_scale = VMP::found_reference_scale;
    const VMP::Parameterization_result result = problem.run();
    REQUIRE(result.status == VMP::OK);
    CHECK(result.energy == Approx(6));
    CHECK(result.reference_scale == Approx(scale));
    CHECK(problem.meets_conditions());
    std::vector<Point> expected;
    for(const Point& p : problem.soup.points)
      expected.push_back(point(moved(vector(p))));
    CHECK(problem.largest_distance(expected) < 1e-6 * scale);
  }
}

TEST_CASE("One handle, or none, leaves the body as it is")
{
  for(const bool has_handle : { false, true })
  {
    Problem problem = box(3);
    problem.set([&](const Vector3d& p) { return has_handle && p == Vector3d(3, 3, 3); }, Condition::at_target(),
                [](const Vector3d& p) -> Vector3d { return p + Vector3d(10, 0, 0); });
    REQUIRE(problem.run().status == VMP::OK);
    std::vector<Point> expected = problem.soup.points;
    for(Point& p : expected)
      p[0] += has_handle ? 10 : 0;
    CHECK(problem.largest_distance(expected) < 1e-6);
  }
}

TEST_CASE("Handles stretch a bar without a change of its scale")
{
  Problem problem = box(4, 0);
  problem.set([](const Vector3d& p) { return p[2] == 0 || p[2] == 4; }, Condition::at_target(),
              [](const Vector3d& p) { return Vector3d(p[0], p[1], 1.5 * p[2]); });
  const VMP::Parameterization_result result = problem.run();
  REQUIRE(result.status == VMP::OK);
  CHECK(problem.has_positive_cells());
  CHECK(problem.meets_conditions());
  CHECK(result.energy == Approx(4 + 2.25 + 1 / 2.25)); // the energy is a sum over directions: no other one changes
  for(std::size_t v = 0; v < problem.images.size(); ++v)
  {
    const Point& p = problem.soup.points[v];
    CHECK((vector(problem.images[v]) - Vector3d(p[0], p[1], 1.5 * p[2])).norm() < 1e-5);
  }
}

// Compressible, with the logarithm of the determinant.
struct Neo_Hookean_energy_3
{
  static constexpr double mu = 1, lambda = 1.5;

  template <typename T> using Vector = Eigen::Matrix<T, 3, 1>;
  template <typename T> using Matrix = Eigen::Matrix<T, 3, 3>;

  template <typename T>
  static T log_determinant(const Vector<T>& s)
  {
    using std::log;
    return log(s[0] * s[1] * s[2]);
  }

  template <typename T>
  T value(const Vector<T>& s) const
  {
    const T l = log_determinant(s);
    return T(mu / 2) * (s.squaredNorm() - T(3)) - T(mu) * l + T(lambda / 2) * l * l;
  }

  template <typename T>
  Vector<T> gradient(const Vector<T>& s) const
  {
    const T l = log_determinant(s);
    return T(mu) * s + (T(lambda) * l - T(mu)) * s.cwiseInverse();
  }

  template <typename T>
  Matrix<T> hessian(const Vector<T>& s) const
  {
    const T l = log_determinant(s);
    const Vector<T> inverse = s.cwiseInverse();
    Matrix<T> result = T(lambda) * inverse * inverse.transpose();
    for(int i = 0; i < 3; ++i)
      result(i, i) += T(mu) - (T(lambda) * l - T(mu)) * inverse[i] * inverse[i];
    return result;
  }
};

// Returns the lateral stretch of a bar that is stretched along one axis, and free of forces along the others.
double lateral_stretch(const double stretch)
{
  using Energy = Neo_Hookean_energy_3;
  double low = 0.1, high = 2;
  while(high - low > 1e-15)
  {
    const double a = (low + high) / 2;
    (Energy::mu * (a * a - 1) + Energy::lambda * std::log(stretch * a * a) > 0 ? high : low) = a;
  }
  return low;
}

TEST_CASE("A body of rubber between two planes has its own size as reference, and neither turns nor drifts")
{
  for(const double stretch : { 1.5, 0.7 })
  {
    Problem problem = box(3);
    for(Point& p : problem.soup.points)
      p[0] *= 2;
    problem.energy = Neo_Hookean_energy_3();
    problem.use_volume_weights = true;
    problem.set([](const Vector3d& p) { return p[0] == 0 || p[0] == 6; }, Condition::in_plane(1, 0, 0),
                [&](const Vector3d& p) { return Vector3d(stretch * p[0], nan_, nan_); });
    const VMP::Parameterization_result result = problem.run();
    CAPTURE(result.message);
    REQUIRE(result.status == VMP::OK);
    CHECK(result.reference_scale == 1);
    CHECK(result.message.find("3 motions") != std::string::npos);
    CHECK(problem.meets_conditions());
    const double lateral = lateral_stretch(stretch);
    double force = 0;
    const auto forces = VMP::measure_forces(problem.soup.points, problem.soup.cells, problem.images, Neo_Hookean_energy_3());
    for(std::size_t v = 0; v < forces.size(); ++v)
      if(problem.soup.points[v][0] == 6)
        force += forces[v][0];
      else if(problem.soup.points[v][0] != 0)
        CHECK(vector(forces[v]).norm() < 1e-5);
    CHECK(force == Approx(9 * (stretch - 1 / stretch + 1.5 * std::log(stretch * lateral * lateral) / stretch)).epsilon(1e-6));
    CHECK((stretch != 1.5 || std::abs(lateral - 0.88) < 1e-3));
    for(std::size_t v = 0; v < problem.images.size(); ++v)
    {
      Vector3d mean = Vector3d::Zero();
      for(const Point& p : problem.soup.points)
        mean += vector(p) / static_cast<double>(problem.soup.points.size());
      const Vector3d d = vector(problem.soup.points[v]) - mean;
      const Vector3d expected(stretch * problem.soup.points[v][0], mean[1] + lateral * d[1], mean[2] + lateral * d[2]);
      CHECK((vector(problem.images[v]) - expected).norm() < 1e-6);
    }
  }
}

TEST_CASE("Simple shear leaves two sides without forces, and has a force by closed form on the upper side")
{
  Problem problem = box(3);
  problem.energy = Neo_Hookean_energy_3();
  problem.use_volume_weights = true;
  const auto sheared = [](const Vector3d& p) { return Vector3d(p[0] + 0.5 * p[1], p[1], p[2]); };
  problem.set([](const Vector3d& p) { return p[0] == 0 || p[0] == 3 || p[1] == 0 || p[1] == 3; }, Condition::at_target(), sheared);
  const VMP::Parameterization_result result = problem.run();
  CAPTURE(result.message);
  REQUIRE(result.status == VMP::OK);
  double force = 0;
  const auto forces = VMP::measure_forces(problem.soup.points, problem.soup.cells, problem.images, Neo_Hookean_energy_3());
  for(std::size_t v = 0; v < forces.size(); ++v)
  {
    const Vector3d p = vector(problem.soup.points[v]);
    CHECK((vector(problem.images[v]) - sheared(p)).norm() < 3 * 1e-6); // a millionth of the edges of the box
    force += p[1] == 3 ? forces[v][0] : 0;
    CHECK(std::abs(forces[v][2]) < 1e-5);
  }
  CHECK(force == Approx(9 * Neo_Hookean_energy_3::mu * 0.5).epsilon(1e-6));
}

TEST_CASE("Of all scales that an energy leaves open, that of the source is taken")
{
  Problem problem = box(3);
  problem.energy = VMP::MIPS_energy_3();
  problem.set([](const Vector3d& p) { return p == Vector3d(0, 0, 0); }, Condition::at_target(), as_it_is);
  const VMP::Parameterization_result result = problem.run();
  REQUIRE(result.status == VMP::OK);
  CHECK(problem.largest_distance(problem.soup.points) < 1e-6);
}

// A bar whose ends stay and turn by 120 degrees. Without stages, its map is crumpled.
Problem bent_bar()
{
  VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(8, 0));
  for(auto c = soup.cells.size(); c-- > 0;)
    if(std::any_of(soup.cells[c].begin(), soup.cells[c].end(), [&](const std::size_t v)
                   { return soup.points[v][1] > 2 || soup.points[v][2] > 2; }))
      soup.cells.erase(soup.cells.begin() + static_cast<std::ptrdiff_t>(c));
  for(Point& p : soup.points)
    p[0] *= 1.5;
  Problem problem(soup);
  const double angle = 2 * CGAL_PI / 3, radius = 12 / angle;
  const auto is_in_bar = [](const Vector3d& p) { return p[1] <= 2 && p[2] <= 2; };
  problem.set([&](const Vector3d& p) { return is_in_bar(p) && p[0] == 0; }, Condition::at_target(), as_it_is);
  problem.set([&](const Vector3d& p) { return is_in_bar(p) && p[0] == 12; }, Condition::at_target(), [&](const Vector3d& p)
  {
    const double r = radius - (p[1] - 1);
    return Vector3d(r * std::sin(angle), 1 + radius - r * std::cos(angle), p[2]);
  });
  return problem;
}

TEST_CASE("A bar is bent by 120 degrees in one call without a crumple")
{
  Problem problem = bent_bar();
  const VMP::Parameterization_result result = problem.run();
  REQUIRE(result.status == VMP::OK);
  CHECK(problem.meets_conditions());
  CHECK(result.distortion.angle_max < 3);
  CHECK(!result.boundary_crosses_itself);
}

TEST_CASE("Stages do not change when the first map without inverted cells was found")
{
  struct Minimization : VMP::Default_visitor
  {
    double begin = std::numeric_limits<double>::infinity(); // of the first step

    bool after_step(const VMP::Parameterization_step& step)
    {
      if(step.phase == VMP::Phase::MINIMIZATION)
        begin = (std::min)(begin, step.seconds);
      return true;
    }
  } minimization;
  Problem problem = bent_bar();
  const VMP::Parameterization_result result = problem.run(false, std::ref(minimization));
  REQUIRE(result.status == VMP::OK);
  CHECK(result.seconds_to_flip_free <= minimization.begin);
}

// The mean of the symmetric Dirichlet energy over the cells; infinite if one is inverted.
double symmetric_dirichlet_energy(const VMP::Tetrahedron_soup_3& soup, const std::vector<Point>& images)
{
  double result = 0;
  for(const auto& [a, b, c, d] : soup.cells)
  {
    const auto edges = [&, a = a, b = b, c = c, d = d](const std::vector<Point>& points)
    {
      const Vector3d p = vector(points[a]);
      Eigen::Matrix3d result;
      result << vector(points[b]) - p, vector(points[c]) - p, vector(points[d]) - p;
      return result;
    };
    const Eigen::Matrix3d J = edges(images) * edges(soup.points).inverse();
    result += J.determinant() > 0 ? J.squaredNorm() + J.inverse().squaredNorm() : std::numeric_limits<double>::infinity();
  }
  return result / static_cast<double>(soup.cells.size());
}

// The cube [0, 4]^3, of which the points are moved, without cells that have a vertex where there is none.
template <typename Map>
VMP::Tetrahedron_soup_3 moved_cube(const Map& map)
{
  VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(4, 0));
  for(Point& p : soup.points)
    p = point(map(vector(p)));
  const auto is_missing = [&](const std::size_t v) { return std::isnan(soup.points[v][0]); };
  const auto is_open = [&](const std::array<std::size_t, 4>& cell) { return std::any_of(cell.begin(), cell.end(), is_missing); };
  soup.cells.erase(std::remove_if(soup.cells.begin(), soup.cells.end(), is_open), soup.cells.end());
  soup.cell_references.resize(soup.cells.size());
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(is_missing(v))
      soup.points[v] = { 0, 0, 0 };
  return soup;
}

// Six bodies with handles, and a map of the whole body that one can write down and that moves the handles as the test does. The
// map that is found may have no more energy, but for half a turn, which may be to either side: its map has a kink.
TEST_CASE("Bodies follow their handles with less energy than maps by formulas")
{
  using Predicate = std::function<bool(const Vector3d&)>;
  using Map = std::function<Vector3d(const Vector3d&)>;
  struct Body { const char* name; VMP::Tetrahedron_soup_3 soup; Predicate is_handle; Map map; double factor = 1; };
  const auto bar = moved_cube([](const Vector3d& p) { return Vector3d(3 * p[0], p[1] - 2, p[2] - 2); });
  const auto at_ends_of_bar = [](const Vector3d& p) { return p[0] == 0 || p[0] == 12; };
  const auto ball = moved_cube([](const Vector3d& p) -> Vector3d
  {
    const Vector3d q = p - Vector3d(2, 2, 2);
    return q == Vector3d(0, 0, 0) ? q : Vector3d(q * (q.cwiseAbs().maxCoeff() / q.norm()));
  });
  const auto plate = moved_cube([](const Vector3d& p) { return Vector3d(p[0], p[1], 0.1 * p[2]); });
  const auto corner = moved_cube([](const Vector3d& p) { return p[0] > 2 && p[1] > 2 ? Vector3d(nan_, nan_, nan_) : p; });
  const auto cube = moved_cube([](const Vector3d& p) { return p; });
  const std::vector<Body> bodies = {
    { "bar, bent by a right angle", bar, at_ends_of_bar, [](const Vector3d& p)
      {
        const double angle = p[0] / 12 * CGAL_PI / 2, radius = 24 / CGAL_PI - p[1];
        return Vector3d(radius * std::sin(angle), -radius * std::cos(angle), p[2]);
      } },
    { "bar, twisted by half a turn", bar, at_ends_of_bar, [](const Vector3d& p) -> Vector3d
      { return Eigen::AngleAxisd(p[0] / 12 * CGAL_PI, Vector3d::UnitX()) * p; }, 1.5 },
    { "ball with two poles pulled", ball, [](const Vector3d& p) { return std::abs(p[2]) > 1.5; }, [](const Vector3d& p)
      { return Vector3d(p[0], p[1], p[2] + std::clamp(p[2] / 1.5, -1., 1.)); } },
    { "plate with a corner lifted", plate, [](const Vector3d& p) { return p[0] == 0 || (p[0] == 4 && p[1] == 4); },
      [](const Vector3d& p) { return Vector3d(p[0], p[1], p[2] + p[0] * p[0] * p[1] / 32); } },
    { "two arms, opened", corner, [](const Vector3d& p) { return p[0] == 4 || p[1] == 4; }, [](const Vector3d& p) -> Vector3d
      {
        const double angle = std::clamp((p[1] - p[0]) / 2, -1., 1.) * CGAL_PI / 12;
        return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * p;
      } },
    { "cube with a face scaled", cube, [](const Vector3d& p) { return p[2] <= 1 || p[2] == 4; }, [](const Vector3d& p)
      {
        const double scale = 1 + (std::max)(0., p[2] - 1) / 3;
        return Vector3d(scale * p[0], scale * p[1], p[2]);
      } } };
  for(const Body& body : bodies)
  {
    CAPTURE(body.name);
    Problem problem(body.soup);
    problem.set(body.is_handle, Condition::at_target(), body.map);
    const VMP::Parameterization_result result = problem.run();
    REQUIRE(result.status == VMP::OK);
    CHECK(problem.meets_conditions());
    CHECK(problem.has_positive_cells());
    std::vector<Point> by_formula;
    for(const Point& p : problem.soup.points)
      by_formula.push_back(point(body.map(vector(p))));
    const double bound = symmetric_dirichlet_energy(problem.soup, by_formula);
    CHECK(std::isfinite(bound));
    CHECK(symmetric_dirichlet_energy(problem.soup, problem.images) < body.factor * bound);
  }
}

TEST_CASE("Two planes prescribe one coordinate to the bit, and the scale")
{
  for(const double sign : { 1., -1. }) // of the height; the body is turned over where it is negative
  {
    Problem problem = box(4);
    problem.set([](const Vector3d& p) { return p[2] == 0 || p[2] == 4; }, Condition::in_plane(0, 0, 1),
                [&](const Vector3d& p) { return Vector3d(nan_, nan_, sign * 0.1 * p[2] / 4); });
    problem.reference_scale = VMP::found_reference_scale;
    const VMP::Parameterization_result result = problem.run();
    REQUIRE(result.status == VMP::OK);
    CHECK(result.number_of_sliding_vertices == 50);
    CHECK(result.energy == Approx(6));
    CHECK(problem.has_positive_cells());
    for(std::size_t v = 0; v < problem.soup.points.size(); ++v)
    {
      const Point& p = problem.soup.points[v];
      CHECK(problem.images[v][2] == Approx(sign * 0.1 * p[2] / 4).margin(1e-9));
      if(problem.conditions[v].kind() == Condition::IN_PLANE)
        CHECK(problem.images[v][2] == problem.targets[v][2]);
    }
  }
}

TEST_CASE("A shell becomes flat between two planes, and its scale is that of its thickness")
{
  // a cup of radius 2 and thickness 0.4, with its rim at 0.9 of a right angle
  const auto radius = [](const Vector3d& p) { return 1.6 + 0.1 * p[2]; };
  const VMP::Tetrahedron_soup_3 cup = moved_cube([&](const Vector3d& p) -> Vector3d
  {
    const Eigen::Vector2d q(p[0] - 2, p[1] - 2);
    const double angle = 0.45 * CGAL_PI * q.cwiseAbs().maxCoeff() / 2;
    const Eigen::Vector2d side = q.norm() > 0 ? Eigen::Vector2d(std::sin(angle) * q.normalized()) : q;
    return radius(p) * Vector3d(side[0], side[1], std::cos(angle));
  });
  for(const double depth : { 1., 100. })
  {
    Problem problem(cup);
    problem.set([](const Vector3d& p) { return std::abs(p.norm() - 1.6) < 1e-9; }, Condition::in_plane(0, 0, 1),
                [](const Vector3d&) { return Vector3d(nan_, nan_, 0); });
    problem.set([](const Vector3d& p) { return std::abs(p.norm() - 2) < 1e-9; }, Condition::in_plane(0, 0, 1),
                [&](const Vector3d&) { return Vector3d(nan_, nan_, depth); });
    problem.reference_scale = VMP::found_reference_scale;
    const VMP::Parameterization_result result = problem.run();
    REQUIRE(result.status == VMP::OK);
    CHECK(problem.meets_conditions());
    CHECK(problem.has_positive_cells());
    CHECK(result.energy < 9); // 6 that of a similarity
  }
}

TEST_CASE("Lines and oblique planes are met")
{
  const Eigen::Matrix3d A = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Vector3d x = A.col(0), z = A.col(2);
  Problem problem = box(4);
  problem.set(at_bottom, Condition::in_plane(z[0], z[1], z[2]), [&](const Vector3d& p) -> Vector3d { return A * p; });
  problem.set([](const Vector3d& p) { return p[2] == 4 && p[1] == 0; }, Condition::on_line(x[0], x[1], x[2]),
              [&](const Vector3d& p) -> Vector3d { return A * Vector3d(p[0], p[1], 6); });
  const VMP::Parameterization_result result = problem.run();
  REQUIRE(result.status == VMP::OK);
  CHECK(problem.has_positive_cells());
  CHECK(problem.meets_conditions());
  CHECK(result.boundary_residual == 0);
}

TEST_CASE("A half with its plane of symmetry has half of the map of the whole")
{
  // the half, and behind the plane x = 0 its image in it
  VMP::Tetrahedron_soup_3 half = source_soup(cube_mesh(3, 0.1)), whole = half;
  std::map<std::size_t, std::size_t> mirrored;
  for(std::size_t v = 0; v < half.points.size(); ++v)
    if(half.points[v][0] == 0)
      mirrored[v] = v;
    else
    {
      mirrored[v] = whole.points.size();
      whole.points.push_back({ -half.points[v][0], half.points[v][1], half.points[v][2] });
    }
  for(const auto& [a, b, c, d] : half.cells)
    whole.cells.push_back({ mirrored[a], mirrored[c], mirrored[b], mirrored[d] });
  whole.cell_references.resize(whole.cells.size(), 1);

  const auto is_handle = [](const Vector3d& p) { return p[2] == 0 || (p[2] == 3 && std::abs(p[0]) >= 2); };
  const auto lifted = [](const Vector3d& p) { return Vector3d(p[0], p[1], p[2] == 0 ? 0 : 4); };
  Problem of_whole(whole), of_half(half);
  of_whole.set(is_handle, Condition::at_target(), lifted);
  of_half.set([](const Vector3d& p) { return p[0] == 0; }, Condition::in_plane(1, 0, 0), as_it_is);
  of_half.set(is_handle, Condition::at_target(), lifted);
  REQUIRE(of_whole.run().status == VMP::OK);
  REQUIRE(of_half.run().status == VMP::OK);
  of_whole.images.resize(half.points.size());
  CHECK(of_half.meets_conditions());
  CHECK(of_half.largest_distance(of_whole.images) < 1e-4);
}

TEST_CASE("A vertex inside may be in a plane, too")
{
  Problem problem = box(4, 0);
  problem.set([](const Vector3d& p) { return p.minCoeff() == 0 || p.maxCoeff() == 4; }, Condition::at_target(), as_it_is);
  problem.set([](const Vector3d& p) { return p == Vector3d(2, 2, 2); }, Condition::in_plane(0, 0, 1),
              [](const Vector3d& p) -> Vector3d { return p + Vector3d(0, 0, 0.5); });
  problem.energy = VMP::Stretch_energy_3(); // the boundary fixes the volume
  const VMP::Parameterization_result result = problem.run();
  REQUIRE(result.status == VMP::OK);
  CHECK(problem.has_positive_cells());
  CHECK(problem.meets_conditions());
}

TEST_CASE("Energies without a minimum are refused where a part of the boundary is free")
{
  const auto status_of = [](const VMP::Any_energy_3& energy)
  {
    Problem problem = box(2);
    problem.energy = energy;
    problem.set(at_bottom, Condition::at_target(), as_it_is);
    const VMP::Parameterization_result result = problem.run();
    if(result.status == VMP::ERROR_ENERGY_WITHOUT_MINIMUM)
      CHECK(result.message.find("Symmetric_Dirichlet_energy_3") != std::string::npos);
    return result.status;
  };
  for(const VMP::Any_energy_3& energy : std::vector<VMP::Any_energy_3>{ VMP::Stretch_energy_3(), VMP::Dirichlet_energy_3(),
        VMP::LSCM_energy_3(), VMP::Barrier_energy_3<VMP::Stretch_energy_3>() })
    CHECK(status_of(energy) == VMP::ERROR_ENERGY_WITHOUT_MINIMUM);
  for(const VMP::Any_energy_3& energy : std::vector<VMP::Any_energy_3>{ VMP::Symmetric_Dirichlet_energy_3(), VMP::ARAP_energy_3(),
        VMP::LPM_energy_3(), VMP::MIPS_energy_3(), VMP::Barrier_energy_3<VMP::Dirichlet_energy_3>() })
    CHECK(status_of(energy) != VMP::ERROR_ENERGY_WITHOUT_MINIMUM);
}

TEST_CASE("A forgotten coordinate is told, with its vertex, and one that is free is not missed")
{
  Problem problem = box(2, 0);
  problem.set(at_bottom, Condition::in_plane(0, 0, 1), [](const Vector3d&) { return Vector3d(nan_, nan_, 0); });
  CHECK(problem.run().status == VMP::OK);
  problem.set([](const Vector3d& p) { return p == Vector3d(1, 1, 0); }, Condition::in_plane(0, 0, 1),
              [](const Vector3d&) { return Vector3d(0, 0, nan_); });
  const VMP::Parameterization_result result = problem.run();
  CHECK(result.status == VMP::ERROR_MISSING_BOUNDARY_TARGET);
  CHECK(result.message.find("(1, 1, 0)") != std::string::npos);
  CHECK_THROWS_AS(Condition::in_plane(0, 0, 0), CGAL::Precondition_exception);
  CHECK_THROWS_AS(Condition::on_line(nan_, 0, 1), CGAL::Precondition_exception);
}

TEST_CASE("Cells and edges that conditions keep in one plane are told, and refined")
{
  Problem flat(fan(1, false));
  flat.set([](const Vector3d&) { return true; }, Condition::in_plane(0, 0, 1),
           [](const Vector3d& p) { return Vector3d(p[0], p[1], 0); });
  const VMP::Parameterization_result result = flat.run();
  CHECK(result.status != VMP::OK);
  CHECK(result.message.find("in one plane") != std::string::npos);

  Problem problem(fan(5, true)); // of which one cell has the edge between the poles, which is inside, and two facets
  for(std::size_t v = 0; v < 4; ++v)
  {
    problem.conditions[v] = Condition::in_plane(0, 0, 1);
    problem.targets[v] = { nan_, nan_, 0 };
  }
  CHECK(problem.run().message.find("refinement_mode") != std::string::npos);
  const VMP::Parameterization_result refined = problem.run(true);
  REQUIRE(refined.status == VMP::OK);
  CHECK(refined.number_of_added_vertices > 0);
  CHECK(problem.has_positive_cells());
}

TEST_CASE("A free boundary that crosses itself is told")
{
  // a bar along x whose ends are put into each other
  VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(6, 0));
  for(auto c = soup.cells.size(); c-- > 0;)
    for(const std::size_t v : soup.cells[c])
      if(soup.points[v][1] > 1 || soup.points[v][2] > 1)
      {
        soup.cells.erase(soup.cells.begin() + static_cast<std::ptrdiff_t>(c));
        break;
      }
  soup.cell_references.resize(soup.cells.size());
  for(const double end : { 1., 2 * CGAL_PI })
  {
    Problem problem(soup);
    problem.set([](const Vector3d& p) { return p[1] <= 1 && p[2] <= 1; }, Condition::at_target(), [&](const Vector3d& p)
    {
      const double angle = 1.1 * end * p[0] / 6, radius = 6 - p[1];
      return Vector3d(radius * std::sin(angle), -radius * std::cos(angle), p[2]);
    });
    problem.set([](const Vector3d& p) { return p[0] == 6 && p[1] == 1; }, Condition(), as_it_is);
    const VMP::Parameterization_result result = problem.run();
    REQUIRE(result.has_valid_map);
    CHECK(result.boundary_crosses_itself == (end > 3));
    CHECK((result.message.find("not one to one") != std::string::npos) == result.boundary_crosses_itself);
  }
}

// The cube [0, 2]^3 with its faces as patches: x = 0, x = 2, y = 0, ... have the references 1, 2, 3, ...
VMP::Tetrahedron_soup_3 cube_with_patches()
{
  VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(2));
  for(const std::array<std::size_t, 4>& cell : soup.cells)
    for(int i = 0; i < 4; ++i)
      for(int side = 0; side < 6; ++side)
      {
        const std::array<std::size_t, 3> facet = { cell[(i + 1) % 4], cell[(i + 2) % 4], cell[(i + 3) % 4] };
        const auto is_on_side = [&](const std::size_t v) { return soup.points[v][side / 2] == 2 * (side % 2); };
        if(std::all_of(facet.begin(), facet.end(), is_on_side))
        {
          soup.facets.push_back(facet);
          soup.facet_references.push_back(side + 1);
        }
      }
  soup.group_names[{ 2, 5 }] = "bottom";
  return soup;
}

TEST_CASE("Vertices have the conditions of all of their patches")
{
  using Patch = VMP::Patch_condition_3;
  const VMP::Tetrahedron_soup_3 soup = cube_with_patches();
  const auto found = VMP::conditions_of_patches(soup, std::map<int, Patch>{
    { 1, Patch::coordinate(0, 0.1) }, { 3, Patch::in_plane(0, -2, 0, 0.4) }, { 5, Patch::coordinate(2, 0.3) } });
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    const Point& p = soup.points[v];
    const int planes = (p[0] == 0) + (p[1] == 0) + (p[2] == 0);
    const Condition& condition = found.conditions[v];
    const Point& target = found.targets[v];
    CHECK(condition.kind() == (planes == 0 ? Condition::FREE : planes == 1 ? Condition::IN_PLANE
                               : planes == 2 ? Condition::ON_LINE : Condition::AT_TARGET));
    for(int i = 0; i < 3 && planes > 0; ++i)
      if(p[i] == 0)
        CHECK(target[i] == (i == 0 ? 0.1 : i == 1 ? -0.2 : 0.3));
    if(planes == 1)
      for(int i = 0; i < 3; ++i)
        CHECK((condition.direction()[i] != 0) == (p[i] == 0));
    if(planes == 2)
      for(int i = 0; i < 3; ++i)
        CHECK((condition.direction()[i] != 0) == (p[i] != 0));
  }

  const auto in_place = VMP::conditions_of_patches(
    soup, std::map<int, Patch>{ { 6, Patch::in_place() }, { 1, Patch::coordinate(0, 0) } });
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(soup.points[v][2] == 2)
      CHECK((in_place.conditions[v].kind() == Condition::AT_TARGET && in_place.targets[v] == soup.points[v]));
}

TEST_CASE("Patches that contradict each other are refused with a vertex, and so are patches that are not there")
{
  using Patch = VMP::Patch_condition_3;
  const VMP::Tetrahedron_soup_3 soup = cube_with_patches();
  const auto message_of = [&](const auto& conditions) -> std::string
  {
    try { VMP::conditions_of_patches(soup, conditions); }
    catch(const VMP::Input_error& error) { return error.what(); }
    return "";
  };
  using By_reference = std::map<int, Patch>;
  using By_name = std::map<std::string, Patch>;
  const std::string contradiction
    = message_of(By_reference{ { 1, Patch::coordinate(2, 0) }, { 3, Patch::coordinate(2, 1) } });
  CHECK(contradiction.find("patches 1 and 3 contradict each other at the vertex at (0, 0, ") != std::string::npos);
  CHECK(message_of(By_reference{ { 1, Patch::in_plane(0, 1, 1, 0) }, { 3, Patch::in_plane(0, 1, 1 + 1e-10, 0) } })
          .find("nearly parallel") != std::string::npos);
  CHECK(message_of(By_reference{ { 1, Patch::in_plane(0, 1, 1, 0) }, { 3, Patch::in_plane(0, 2, 2, 0) } }).empty());
  CHECK(message_of(By_reference{ { 7, Patch::in_place() } }).find("7") != std::string::npos);
  CHECK(message_of(By_name{ { "bottom", Patch::in_place() } }).empty());
  CHECK(message_of(By_name{ { "top", Patch::in_place() } }).find("'top'") != std::string::npos);
  CHECK_THROWS_AS(Patch::coordinate(3, 0), CGAL::Precondition_exception);
}

TEST_CASE("Patches of a complex have the conditions of a soup")
{
  using Patch = VMP::Patch_condition_3;
  const std::map<int, Patch> patches = { { 5, Patch::coordinate(2, 0) }, { 6, Patch::coordinate(2, 3) } };
  const VMP::Tetrahedron_soup_3 soup = cube_with_patches();
  Cube_complex<>::C3t3 c3t3;
  std::vector<Cube_complex<>::Vertex_handle> vertices;
  std::vector<Cube_complex<>::Cell_handle> cells;
  VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
  const auto of_soup = VMP::conditions_of_patches(soup, patches);
  const auto of_complex = VMP::conditions_of_patches(c3t3, patches);
  for(std::size_t v = 0; v < vertices.size(); ++v)
  {
    const auto found = of_complex.conditions.find(vertices[v]);
    REQUIRE((found != of_complex.conditions.end()) == (of_soup.conditions[v].kind() != Condition::FREE));
    if(found != of_complex.conditions.end())
    {
      CHECK(found->second.kind() == of_soup.conditions[v].kind());
      CHECK(found->second.direction() == of_soup.conditions[v].direction());
    }
  }

  std::unordered_map<Cube_complex<>::Vertex_handle, Cube_complex<>::Point_3> images;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, VMP::make_vertex_point_map(images),
    params::boundary_map(VMP::make_vertex_point_map(of_complex.targets))
           .vertex_condition_map(VMP::make_vertex_condition_map(std::as_const(of_complex.conditions)))
           .energy(VMP::Symmetric_Dirichlet_energy_3()).reference_scale(VMP::found_reference_scale));
  REQUIRE(result.status == VMP::OK);
  CHECK(result.energy == Approx(6));
  for(std::size_t v = 0; v < vertices.size(); ++v)
    CHECK(images.at(vertices[v]).z() == Approx(1.5 * soup.points[v][2]).margin(1e-9));
}

// The cube [0, 2]^3 as a complex. Its sides keep their places as constant containers say, in which the vertex inside is missing.
TEST_CASE("Containers of the maps of vertices may be constant and lack vertices")
{
  Cube_complex<> complex(cube_mesh(2, 0));
  using Vertex_handle = Cube_complex<>::Vertex_handle;
  const auto& targets = std::as_const(complex.target);
  REQUIRE(targets.size() == 26);
  std::unordered_map<Vertex_handle, Condition> conditions;
  for(const auto& entry : targets)
    conditions.emplace(entry.first, Condition::at_target());
  using Vertices = const std::unordered_set<Vertex_handle>;
  Vertices none;
  const auto np = params::boundary_map(VMP::make_vertex_point_map(targets)).energy(VMP::Symmetric_Dirichlet_energy_3())
                  .initial_map(VMP::make_vertex_point_map(targets));
  const auto images_with = [&](const auto& np)
  {
    complex.uvw.clear();
    CHECK(CGAL::stretch_minimizing_volume_parameterization(std::as_const(complex.c3t3), complex.uvw_map(), np).status == VMP::OK);
    return complex.uvw;
  };
  const auto images = images_with(np.vertex_condition_map(VMP::make_vertex_condition_map(std::as_const(conditions))));
  CHECK(images.size() == 27);
  CHECK(images == images_with(np.vertex_is_constrained_map(CGAL::Boolean_property_map<Vertices>(none))));
  const Vertex_handle inside = std::find_if(images.begin(), images.end(), [&](const auto& image)
                                            { return targets.count(image.first) == 0; })->first;
  CHECK(get(VMP::make_vertex_condition_map(std::as_const(conditions)), inside).kind() == Condition::free().kind());
  put(VMP::make_vertex_condition_map(conditions), inside, Condition::at_target());
  CHECK(conditions.size() == 27);
}

TEST_CASE("Normals may be as long and as short as numbers can be")
{
  constexpr double largest = (std::numeric_limits<double>::max)(), smallest = std::numeric_limits<double>::denorm_min();
  for(const double length : { largest, smallest })
  {
    Problem problem = box(2);
    problem.set(at_bottom, Condition::in_plane(length, length, 0),
                [](const Vector3d& p) -> Vector3d { return p + Vector3d(1, 1, 0); });
    REQUIRE(problem.run().status == VMP::OK);
    for(std::size_t v = 0; v < problem.images.size(); ++v)
      if(problem.conditions[v].kind() == Condition::IN_PLANE)
        CHECK(problem.images[v][0] + problem.images[v][1] == Approx(problem.targets[v][0] + problem.targets[v][1]).epsilon(1e-14));
  }
}

} } // namespace

// The Hessian is singular at the minimum, and the gradient nothing but rounding.
TEST_CASE("A motion of the body that the conditions leave open is no failure of the solver")
{
  using namespace of_conditions;
  const Vector3d low(0, 0, 0), high(3, 3, 3), side(3, 0, 3);
  const auto is_at = [](const Vector3d& q) { return [=](const Vector3d& p) { return p == q; }; };
  const auto scaled_by = [](const double factor) { return [=](const Vector3d& p) -> Vector3d { return factor * p; }; };
  for(const double factor : { 1., 1.125, 0.8 })
  {
    std::vector<Problem> problems(7, Problem(source_soup(cube_mesh(3))));
    for(std::size_t i = 0; i < 5; ++i)
      problems[i].set(is_at(low), Condition::at_target(), scaled_by(factor)); // the body turns around a vertex
    problems[1].set(is_at(high), Condition::in_plane(0, 0, 1), scaled_by(factor));
    problems[2].set(is_at(side), Condition::in_plane(0, 1, 0), scaled_by(factor));
    problems[3].set(is_at(high), Condition::on_line(0, 0, 1), scaled_by(factor));
    problems[4].set(is_at(high), Condition::at_target(), scaled_by(factor)); // around a line
    problems[5].set(is_at(low), Condition::in_plane(0, 0, 1), scaled_by(factor)); // and moves in a plane
    problems[6].set([](const Vector3d& p) { return p[2] == 0; }, Condition::in_plane(0, 0, 1), scaled_by(factor));
    for(std::size_t i = 0; i < problems.size(); ++i)
    {
      CAPTURE(factor, i);
      const VMP::Parameterization_result result = problems[i].run();
      CAPTURE(result.message);
      CHECK(result.status == VMP::OK);
      CHECK(problems[i].has_positive_cells());
      CHECK(problems[i].meets_conditions());
      if(factor == 1 || i != 4) // a rigid motion meets the conditions
        CHECK(result.distortion.angle_max == Approx(2).margin(1e-4));
    }
  }
}
