// The boundary of a ball meshed by Mesh_3, whose triangulation has weighted points and cells outside the complex.
#include "catch.h"
#include "mesh_body.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>

#include <CGAL/Timer.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Cell_handle = C3t3::Cell_handle;

namespace {

C3t3 ball_of_radius_3()
{
  const Domain domain = Domain::create_implicit_mesh_domain(
    [](const Point_3& p) { return CGAL::squared_distance(p, Point_3(1, 1, 1)) - 9; },
    K::Sphere_3(Point_3(1, 1, 1), 16));
  return mesh_body(domain, CGAL::Mesh_criteria_3<Tr>(
    params::facet_angle = 25, params::facet_size = 0.7, params::facet_distance = 0.05,
    params::facet_topology = CGAL::MANIFOLD, params::cell_radius_edge_ratio = 3, params::cell_size = 1));
}

} // namespace

TEST_CASE("the boundary of a ball is mapped to the sphere almost isometrically")
{
  const C3t3 c3t3 = ball_of_radius_3();
  const auto point = c3t3.triangulation().geom_traits().construct_point_3_object();
  std::unordered_map<Vertex_handle, Point_3> sphere;
  REQUIRE(VMP::Ball_boundary_parameterizer_3().parameterize(c3t3, boost::make_assoc_property_map(sphere)) == VMP::OK);

  std::size_t number_of_facets = 0;
  for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
  {
    const Cell_handle c = it;
    for(int i = 0; i < 4; ++i)
    {
      if(c3t3.is_in_complex(c->neighbor(i)))
        continue;
      ++number_of_facets;
      const Vertex_handle u = c->vertex((i + 1) % 4), v = c->vertex((i + 2) % 4), w = c->vertex((i + 3) % 4);
      const auto side = (i % 2 == 1) ? CGAL::NEGATIVE : CGAL::POSITIVE;
      const Point_3 origin(0, 0, 0);
      CHECK(CGAL::orientation(origin, sphere.at(u), sphere.at(v), sphere.at(w)) == side);

      const double length = std::sqrt(CGAL::squared_distance(point(u->point()), point(v->point()))) / 3;
      const double image_length = std::sqrt(CGAL::squared_distance(sphere.at(u), sphere.at(v)));
      CHECK(image_length / length == Approx(1).margin(0.1));
    }
  }
  CHECK(number_of_facets > 100);
  CHECK(2 * sphere.size() == number_of_facets + 4);
}

TEST_CASE("limits of time are kept on a bumpy body")
{
  const Domain domain = Domain::create_implicit_mesh_domain([](const Point_3& p)
  {
    const double bumps = std::sin(7 * p.x()) * std::sin(7 * p.y()) * std::sin(7 * p.z());
    return (p - CGAL::ORIGIN).squared_length() - 1 - 0.4 * bumps;
  }, K::Sphere_3(CGAL::ORIGIN, 4));
  const C3t3 c3t3 = mesh_body(domain, CGAL::Mesh_criteria_3<Tr>(
    params::facet_angle = 25, params::facet_size = 0.16, params::facet_distance = 0.04,
    params::facet_topology = CGAL::MANIFOLD, params::cell_radius_edge_ratio = 3, params::cell_size = 0.2));
  std::unordered_map<Vertex_handle, Point_3> image;
  const auto target = boost::make_assoc_property_map(image);
  const auto check = [&](const auto& parameterizer)
  {
    CGAL::Timer timer;
    timer.start();
    CHECK(parameterizer.parameterize(c3t3, target, params::maximum_running_time(0.002)) == VMP::ERROR_INTERRUPTED);
    CHECK(timer.time() < 5);
    CHECK(image.empty());
  };
  check(VMP::Ball_boundary_parameterizer_3());
  check(VMP::Cube_boundary_parameterizer_3());
  check(PM::Polycube_boundary_parameterizer_3());
}
