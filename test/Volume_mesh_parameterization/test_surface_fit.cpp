// Boundaries mapped to surfaces with other triangles.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Surface_fit_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/measure_surface_fit.h>

#include <CGAL/exceptions.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

namespace { namespace of_fits {

using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Fit = VMP::Surface_fit_boundary_parameterizer_3;

struct Surface
{
  Points points;
  std::vector<std::array<std::size_t, 3> > triangles;
};

// The cube [-1, 1]^3 of 6 n^3 cells.
VMP::Tetrahedron_soup_3 cube(const int n)
{
  VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(n));
  for(Point& p : soup.points)
    for(double& x : p)
      x = 2 * x / n - 1;
  return soup;
}

// Latitudes and longitudes of an ellipsoid with the radii 3, 2 and 1: triangles that no cube has.
Surface ellipsoid(const int latitudes, const int longitudes)
{
  Surface result;
  result.points = { { 0, 0, -1 }, { 0, 0, 1 } };
  const auto index = [&](const int i, const int j) { return std::size_t(2 + (i - 1) * longitudes + j % longitudes); };
  for(int i = 1; i < latitudes; ++i)
    for(int j = 0; j < longitudes; ++j)
    {
      const double theta = CGAL_PI * i / latitudes, phi = 2 * CGAL_PI * (j + i / 2.) / longitudes;
      result.points.push_back({ 3 * std::sin(theta) * std::cos(phi), 2 * std::sin(theta) * std::sin(phi), -std::cos(theta) });
    }
  for(int j = 0; j < longitudes; ++j)
  {
    result.triangles.push_back({ 0, index(1, j + 1), index(1, j) });
    result.triangles.push_back({ 1, index(latitudes - 1, j), index(latitudes - 1, j + 1) });
    for(int i = 1; i + 1 < latitudes; ++i)
    {
      result.triangles.push_back({ index(i, j), index(i, j + 1), index(i + 1, j) });
      result.triangles.push_back({ index(i + 1, j), index(i, j + 1), index(i + 1, j + 1) });
    }
  }
  return result;
}

// Six arms, bent around the axis z, that are the thinner the larger the exponent is.
Surface star(const double exponent, const double radius_of_core)
{
  Surface result = ellipsoid(10, 14);
  for(Point& p : result.points)
  {
    const double x = p[0] / 3, y = p[1] / 2, z = p[2];
    const double arm = std::pow((std::max)({ std::abs(x), std::abs(y), std::abs(z) }), exponent);
    const double radius = radius_of_core + arm, c = radius * std::cos(3 * arm), s = radius * std::sin(3 * arm);
    p = { 1.6 * (c * x - s * y), 1.25 * (s * x + c * y), radius * z };
  }
  return result;
}

// An L of three cubes, with vertices at its corners only.
Surface angle_bracket()
{
  const std::array<std::array<double, 2>, 6> corners = {{ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } }};
  Surface result;
  for(const double z : { 0., 1. })
    for(const auto& [x, y] : corners)
      result.points.push_back({ x, y, z });
  for(const auto& [a, b, c] : std::vector<std::array<std::size_t, 3> >{ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 } })
  {
    result.triangles.push_back({ a, c, b });
    result.triangles.push_back({ a + 6, b + 6, c + 6 });
  }
  for(std::size_t i = 0; i < 6; ++i)
  {
    const std::size_t j = (i + 1) % 6;
    result.triangles.push_back({ i, j, j + 6 });
    result.triangles.push_back({ i, j + 6, i + 6 });
  }
  return result;
}

// A torus of a grid.
Surface torus(const int n)
{
  Surface result;
  const auto index = [&](const int i, const int j) { return std::size_t((i % n) * n + j % n); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      const double u = 2 * CGAL_PI * i / n, v = 2 * CGAL_PI * j / n, r = 3 + std::cos(v);
      result.points.push_back({ r * std::cos(u), r * std::sin(u), std::sin(v) });
      result.triangles.push_back({ index(i, j), index(i + 1, j), index(i, j + 1) });
      result.triangles.push_back({ index(i + 1, j), index(i + 1, j + 1), index(i, j + 1) });
    }
  return result;
}

double distance(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

} // namespace of_fits

using namespace of_fits;

TEST_CASE("A cube is fitted to an ellipsoid, slides on it, and keeps all vertices of the boundary there")
{
  const Surface target = ellipsoid(12, 17);
  VMP::Tetrahedron_soup_3 mesh = cube(5);
  Points uvw;
  const VMP::Parameterization_result fitted = CGAL::stretch_minimizing_volume_parameterization(
    mesh, uvw, params::boundary_parameterizer(Fit(target.points, target.triangles)));
  REQUIRE(fitted.status == VMP::OK);
  CHECK(fitted.boundary_residual == 0);
  const auto check = [&](const Points& images)
  {
    const VMP::Surface_fit_3 fit = VMP::measure_surface_fit(images, mesh.cells, target.points, target.triangles);
    CHECK(fit.largest_distance_to_surface < 1e-14);
    CHECK(fit.largest_distance_from_surface > 0.01);
    CHECK(fit.largest_distance_from_surface < 0.5);
    CHECK(fit.number_of_turned_facets == 0);
    CHECK(fit.number_of_intersections == 0);
  };
  check(uvw);

  const VMP::Triangulated_surface_3 surface(target.points, target.triangles);
  std::vector<VMP::Vertex_condition_3> conditions(mesh.points.size());
  for(const std::size_t v : VMP::boundary_vertices(mesh.points, mesh.cells))
    conditions[v] = VMP::Vertex_condition_3::on_surface(surface);
  Points slid;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    mesh, uvw, slid, params::refinement_mode(VMP::Refinement_mode::NONE)
      .vertex_condition_map(CGAL::make_property_map(conditions)).initial_map(CGAL::make_property_map(uvw)));
  REQUIRE(result.has_valid_map);
  CHECK(result.energy < 0.99 * fitted.energy);
  check(slid);
}

TEST_CASE("Principal axes, or landmarks instead, turn a body onto its target")
{
  const Surface target = ellipsoid(24, 34);
  VMP::Tetrahedron_soup_3 mesh = cube(6);
  for(Point& p : mesh.points) // the longest axis is z, and no other one is as long as that
    p = { p[0], 2 * p[1], 3 * p[2] };
  const auto image_of = [&](const Fit& fit, const Point& p)
  {
    Points targets;
    REQUIRE(fit.parameterize(mesh.points, mesh.cells, targets) == VMP::OK);
    std::size_t nearest = 0;
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
      if(distance(mesh.points[v], p) < distance(mesh.points[nearest], p))
        nearest = v;
    return targets[nearest];
  };
  const Point end = image_of(Fit(target.points, target.triangles), { 0, 0, 3 });
  CHECK(std::abs(end[0]) > 2.7);

  const Fit turned(target.points, target.triangles, { { { 0, 0, 3 }, { 0, 0, 9 } }, { { 0, 2, 0 }, { 9, 0, 0 } },
                                                      { { 1, 0, 0 }, { 0, -9, 0 } } });
  CHECK(distance(image_of(turned, { 0, 0, 3 }), { 0, 0, 1 }) < 0.5);
  CHECK(distance(image_of(turned, { 0, 2, 0 }), { 3, 0, 0 }) < 0.5);
}

TEST_CASE("Landmarks that fit come to their points, and others are measured")
{
  const Surface target = ellipsoid(24, 34);
  VMP::Tetrahedron_soup_3 mesh = cube(6);
  const auto residual = [&](const std::vector<std::pair<Point, Point> >& pairs)
  {
    Points uvw;
    if(Fit(target.points, target.triangles, pairs).parameterize(mesh.points, mesh.cells, uvw) != VMP::OK)
      return std::numeric_limits<double>::infinity();
    std::vector<std::pair<std::size_t, Point> > landmarks;
    for(const auto& [p, goal] : pairs)
      landmarks.emplace_back(std::find(mesh.points.begin(), mesh.points.end(), p) - mesh.points.begin(), goal);
    return VMP::measure_surface_fit(uvw, mesh.cells, target.points, target.triangles, landmarks).largest_distance_of_landmarks;
  };
  const double c = std::cos(0.3), s = std::sin(0.3);
  const std::vector<std::pair<Point, Point> > turned = { { { 1, 0, 0 }, { 3, 0, 0 } }, { { -1, 0, 0 }, { -3, 0, 0 } },
    { { 0, 1, 0 }, { 3 * s, 2 * c, 0 } }, { { 0, 0, 1 }, { 0, 2 * s, c } } };
  CHECK(residual(turned) < 0.3);
  auto exchanged = turned;
  std::swap(exchanged[0].second, exchanged[2].second);
  CHECK(residual(exchanged) > residual(turned) + 0.2);
}

TEST_CASE("Sharp edges and corners of the target are met by those of the body")
{
  const Surface target = { { { -2, -1, -1 }, { 2, -1, -1 }, { 2, 1, -1 }, { -2, 1, -1 }, { -2, -1, 1 }, { 2, -1, 1 }, { 2, 1, 1 },
                             { -2, 1, 1 } },
                           { { 0, 2, 1 }, { 0, 3, 2 }, { 4, 5, 6 }, { 4, 6, 7 }, { 0, 1, 5 }, { 0, 5, 4 },
                             { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 }, { 3, 0, 4 }, { 3, 4, 7 } } };
  VMP::Tetrahedron_soup_3 mesh = cube(4);
  std::vector<std::array<std::size_t, 2> > marked; // the edges of the cube, and a ring where x is 0
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    for(std::size_t w = 0; w < v; ++w)
      if(const Point &p = mesh.points[v], &q = mesh.points[w]; distance(p, q) == 0.5)
      {
        int number_of_faces = 0;
        for(std::size_t i = 0; i < 3; ++i)
          number_of_faces += p[i] == q[i] && std::abs(p[i]) == 1;
        if(number_of_faces == 2 || (number_of_faces == 1 && p[0] == 0 && q[0] == 0))
          marked.push_back({ v, w });
      }
  for(Point& p : mesh.points)
    p[0] *= 2.2;
  const auto check_corners = [](const Points& images)
  {
    for(const double x : { -2., 2. })
      for(const double y : { -1., 1. })
        for(const double z : { -1., 1. })
          CHECK(std::any_of(images.begin(), images.end(), [&](const Point& p) { return distance(p, { x, y, z }) < 1e-12; }));
  };
  Points uvw;
  REQUIRE(Fit(target.points, target.triangles).parameterize(mesh.points, mesh.cells, uvw) == VMP::OK);
  check_corners(uvw);
  const VMP::Surface_fit_3 fit = VMP::measure_surface_fit(uvw, mesh.cells, target.points, target.triangles);
  CHECK(fit.largest_distance_to_surface < 1e-12);
  CHECK(fit.largest_distance_from_surface < 0.005); // the error of the measure, a thousandth of the diagonal

  mesh.edges = marked;
  mesh.edge_references.assign(marked.size(), 1);
  REQUIRE(CGAL::stretch_minimizing_volume_parameterization(
            mesh, uvw, params::boundary_parameterizer(Fit(target.points, target.triangles))).status == VMP::OK);
  check_corners(uvw);
}

TEST_CASE("All edges of a hexagonal prism are sharp, however it is turned")
{
  std::vector<std::array<std::size_t, 3> > facets;
  for(std::size_t i = 0; i < 6; ++i)
  {
    const std::size_t j = (i + 1) % 6;
    facets.push_back({ i, j, i + 6 });
    facets.push_back({ j, j + 6, i + 6 });
    if(0 < i && i < 5)
    {
      facets.push_back({ 0, j, i });
      facets.push_back({ 6, i + 6, j + 6 });
    }
  }
  for(const double turn : { 0., 0.1, 0.2, 0.3, 0.4, 0.5 })
  {
    CAPTURE(turn);
    const auto position = [&](const std::size_t v)
    {
      const double angle = turn + static_cast<double>(v % 6) * std::acos(0.5);
      return VMP::internal::Vector_3(std::cos(angle), std::sin(angle), v < 6 ? 0 : 1);
    };
    CHECK(VMP::internal::sharp_edges_3(facets, {}, position).size() == 18);
  }
}

TEST_CASE("Curved sharp edges are split where those of the target have vertices")
{
  // a cylinder of a cube, whose squares become circles, and a prism
  VMP::Tetrahedron_soup_3 mesh = cube(4);
  for(Point& p : mesh.points)
    if(const double norm = std::hypot(p[0], p[1]); norm > 0)
    {
      const double factor = (std::max)(std::abs(p[0]), std::abs(p[1])) / norm;
      p = { factor * p[0], factor * p[1], p[2] };
    }
  constexpr std::size_t n = 11;
  Surface prism;
  for(const double z : { -1., 1. })
    for(std::size_t i = 0; i < n; ++i)
    {
      const double angle = 2 * CGAL_PI * static_cast<double>(i) / n;
      prism.points.push_back({ std::cos(angle), std::sin(angle), z });
    }
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = (i + 1) % n;
    prism.triangles.push_back({ i, j, n + j });
    prism.triangles.push_back({ i, n + j, n + i });
    if(i > 0 && j > 0)
    {
      prism.triangles.push_back({ 0, j, i });
      prism.triangles.push_back({ n, n + i, n + j });
    }
  }
  Points uvw;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    mesh, uvw, params::boundary_parameterizer(Fit(prism.points, prism.triangles, {}, 0.01))
                      .refinement_mode(VMP::Refinement_mode::BOUNDARY));
  CAPTURE(result.message);
  REQUIRE(result.status == VMP::OK);
  for(const Point& q : prism.points)
    CHECK(std::any_of(uvw.begin(), uvw.end(), [&](const Point& p) { return distance(p, q) < 0.05; }));
  const VMP::Surface_fit_3 fit = VMP::measure_surface_fit(uvw, mesh.cells, prism.points, prism.triangles);
  CHECK(fit.largest_distance_to_surface < 1e-12);
  CHECK(fit.largest_distance_from_surface < 0.02); // points of the surface that are no vertices may be twice as far
}

TEST_CASE("A fit needs two spheres and finite landmarks")
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Surface sphere = ellipsoid(4, 5), ring = torus(6);
  const VMP::Tetrahedron_soup_3 mesh = cube(2);
  Points targets;
  const auto parameterize = [&](const Fit& fit) { return fit.parameterize(mesh.points, mesh.cells, targets); };
  CHECK(parameterize(Fit(ring.points, ring.triangles)) == VMP::ERROR_TARGET_NOT_A_SPHERE);
  auto open = sphere.triangles;
  open.pop_back();
  CHECK(parameterize(Fit(sphere.points, open)) == VMP::ERROR_TARGET_NOT_A_SPHERE);
  CHECK(parameterize(Fit({}, {})) == VMP::ERROR_TARGET_NOT_A_SPHERE);
  CHECK(parameterize(Fit(sphere.points, sphere.triangles, { { { 0, 0, nan }, { 0, 0, 1 } } })) == VMP::ERROR_INVALID_LANDMARK);
  CHECK(parameterize(Fit(sphere.points, sphere.triangles, { { { 0, 0, 1 }, { 0, nan, 1 } } })) == VMP::ERROR_INVALID_LANDMARK);
  CHECK(targets.empty());
  CHECK_THROWS_AS(Fit({}, { { 0, 1, 2 } }), CGAL::Precondition_exception);
}

TEST_CASE("A fit keeps its digits at any size, and ends where it is interrupted")
{
  const Surface target = ellipsoid(8, 11);
  const VMP::Tetrahedron_soup_3 mesh = cube(3);
  Points targets, of_scaled;
  REQUIRE(Fit(target.points, target.triangles).parameterize(mesh.points, mesh.cells, targets) == VMP::OK);
  const double factor = std::exp2(-600.);
  Points scaled = target.points;
  for(Point& p : scaled)
    for(double& x : p)
      x *= factor;
  REQUIRE(Fit(scaled, target.triangles).parameterize(mesh.points, mesh.cells, of_scaled) == VMP::OK);
  for(std::size_t v = 0; v < targets.size(); ++v)
    if(!std::isnan(targets[v][0]))
      CHECK(of_scaled[v][0] == factor * targets[v][0]);
  CHECK(Fit(target.points, target.triangles).parameterize(mesh.points, mesh.cells, targets, params::maximum_running_time(0.))
        == VMP::ERROR_INTERRUPTED);
}

TEST_CASE("Limbs that few facets cover are reached by more vertices")
{
  const Surface target = star(8, 0.05);
  VMP::Tetrahedron_soup_3 mesh = cube(2);
  Points targets;
  REQUIRE(Fit(target.points, target.triangles).parameterize(mesh.points, mesh.cells, targets) == VMP::OK);
  for(std::size_t v = 0; v < targets.size(); ++v)
    if(!std::isnan(targets[v][0]))
      mesh.points[v] = targets[v];
  const VMP::Surface_fit_3 fit = VMP::measure_surface_fit(mesh.points, mesh.cells, target.points, target.triangles);
  CHECK(fit.largest_distance_to_surface < 1e-14);
  CHECK(fit.number_of_turned_facets == 0);
  CHECK(fit.number_of_intersections == 0);
}

TEST_CASE("Edges of a coarse boundary are split until it is as close to its target as the tolerance")
{
  const Surface target = ellipsoid(12, 17);
  const VMP::Tetrahedron_soup_3 coarse = cube(2);
  const auto fitted = [&](const double tolerance, VMP::Tetrahedron_soup_3& mesh, Points& uvw)
  {
    mesh = coarse;
    return CGAL::stretch_minimizing_volume_parameterization(
      mesh, uvw, params::boundary_parameterizer(Fit(target.points, target.triangles, {}, tolerance))
                        .refinement_mode(VMP::Refinement_mode::BOUNDARY));
  };
  const auto measured = [&](const VMP::Tetrahedron_soup_3& mesh, const Points& uvw)
  { return VMP::measure_surface_fit(uvw, mesh.cells, target.points, target.triangles); };
  VMP::Tetrahedron_soup_3 given, refined, other;
  Points of_given, of_refined, of_other;
  REQUIRE(fitted(std::numeric_limits<double>::infinity(), given, of_given).status == VMP::OK);
  const VMP::Parameterization_result result = fitted(0.1, refined, of_refined);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.boundary_residual == 0);
  CHECK(result.number_of_added_boundary_vertices > 0);
  CHECK(refined.points.size() == coarse.points.size() + result.number_of_added_vertices);
  CHECK(measured(given, of_given).largest_distance_from_surface > 0.3);
  const VMP::Surface_fit_3 fit = measured(refined, of_refined);
  CHECK(fit.largest_distance_from_surface < 0.11); // measured up to 0.0075
  CHECK(fit.largest_distance_to_surface < 1e-14);
  CHECK(fit.number_of_turned_facets == 0);
  CHECK(fit.number_of_intersections == 0);

  CHECK(fitted(9, other, of_other).number_of_added_boundary_vertices == 0);
  CHECK(of_other == of_given);
  of_other.clear();
  const VMP::Parameterization_result impossible = fitted(1e-9, other, of_other);
  CHECK(impossible.status == VMP::ERROR_FIT_TOLERANCE_NOT_REACHED);
  CHECK(impossible.message.find("larger") != std::string::npos);
  CHECK(other.points == coarse.points);
  CHECK(of_other.empty());
  CHECK_THROWS_AS(fitted(0, other, of_other), CGAL::Precondition_exception);
}

TEST_CASE("Edges of a target between its vertices are as close to the boundary as the tolerance")
{
  const Surface target = angle_bracket();
  VMP::Tetrahedron_soup_3 mesh = cube(6);
  Points uvw;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    mesh, uvw, params::boundary_parameterizer(Fit(target.points, target.triangles, {}, 0.1))
                      .refinement_mode(VMP::Refinement_mode::BOUNDARY));
  REQUIRE(result.status == VMP::OK);
  const VMP::Surface_fit_3 fit = VMP::measure_surface_fit(uvw, mesh.cells, target.points, target.triangles);
  CHECK(fit.largest_distance_from_surface < 0.11);
  CHECK(fit.number_of_turned_facets == 0);
}

TEST_CASE("A boundary is refused on a surface that intersects itself")
{
  Surface target = ellipsoid(6, 8);
  target.points[1] = { 0, 0, -5 }; // the upper pole, drawn through the bottom
  const VMP::Tetrahedron_soup_3 mesh = cube(2);
  Points targets;
  const Fit fit(target.points, target.triangles, { { { 0, 0, 1 }, { 0, 0, -5 } } }); // one turn only
  CHECK(fit.parameterize(mesh.points, mesh.cells, targets) == VMP::ERROR_BOUNDARY_NOT_FITTED);
  CHECK(targets.empty());
}

TEST_CASE("A fit is measured in both directions")
{
  const VMP::Tetrahedron_soup_3 mesh = cube(2);
  Surface box; // the boundary of [-1, 1]^2 x [-1, 4]
  const VMP::Tetrahedron_soup_3 coarse = cube(1);
  for(const Point& p : coarse.points)
    box.points.push_back({ p[0], p[1], p[2] > 0 ? 4. : -1. });
  box.triangles = VMP::internal::boundary_facets_3(coarse.cells);
  const VMP::Surface_fit_3 fit = VMP::measure_surface_fit(mesh.points, mesh.cells, box.points, box.triangles);
  CHECK(std::abs(fit.largest_distance_to_surface - 1) < 1e-14); // of the middle of the upper side
  CHECK(std::abs(fit.largest_distance_from_surface - 3) < 0.01);
  CHECK(fit.number_of_intersections == 0);

  for(Point& p : box.points)
    p[2] = p[2] > 0 ? 1.001 : -1; // a distance below a thousandth of the diagonal
  const double small = VMP::measure_surface_fit(mesh.points, mesh.cells, box.points, box.triangles).largest_distance_from_surface;
  CHECK(small > 0.00099);
  CHECK(small < 0.001 + 1e-3 * 3.4651); // the diagonal

  Points turned = mesh.points; // inside out
  for(Point& p : turned)
    p[0] = -p[0];
  CHECK(VMP::measure_surface_fit(turned, mesh.cells, box.points, box.triangles).number_of_turned_facets > 30);
}

} // namespace
