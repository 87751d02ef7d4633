// Parts of the maps of a boundary to a ball and to a cube.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Radial_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/matched_features_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/coarsen_surface_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

TEST_CASE("the derivatives of the radial distortion agree with differences")
{
  using VMP::internal::Matrix_3, VMP::internal::Vector_3;
  const Vector_3 p(0, 0, 0), q(1, 0.2, 0), r(0.3, 0.9, 0.4), b(0.8, -0.1, 0.6), c(0.1, 0.7, 0.9);
  const VMP::internal::Radial_distortion_3 distortion(p, q, r, 0.7, b, c);
  const Vector_3 a(-0.1, -0.2, 1.1);
  Vector_3 gradient = Vector_3::Zero();
  Matrix_3 hessian = Matrix_3::Zero();
  distortion.add_derivatives(a, gradient, hessian);

  const double h = 1e-5;
  for(int i = 0; i < 3; ++i)
  {
    const Vector_3 step = h * Vector_3::Unit(i);
    CHECK((distortion.value(a + step) - distortion.value(a - step)) / (2 * h) == Approx(gradient[i]));
    Vector_3 before = Vector_3::Zero(), after = before;
    Matrix_3 unused = hessian;
    distortion.add_derivatives(a - step, before, unused);
    distortion.add_derivatives(a + step, after, unused);
    for(int j = 0; j < 3; ++j)
      CHECK((after[j] - before[j]) / (2 * h) == Approx(hessian(i, j)));
  }

  // an isometry of a triangle of area 0.005 at distance 1
  const VMP::internal::Radial_distortion_3 isometry(p, 0.1 * Vector_3::Unit(0), 0.1 * Vector_3::Unit(1),
                                                    1, Vector_3(0.1, 0, 1), Vector_3(0, 0.1, 1));
  CHECK(isometry.value(Vector_3::Unit(2)) == Approx(4 * 0.005).epsilon(1e-4));
  CHECK(std::isinf(isometry.value(-Vector_3::Unit(2))));
}

TEST_CASE("coarsening to a tetrahedron is undone exactly")
{
  const VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(4));
  const auto surface = VMP::internal::surface_of(VMP::internal::body_of(soup.points, soup.cells));
  VMP::internal::Boundary_mesh_3 mesh;
  REQUIRE(VMP::internal::build_boundary_mesh_3(surface, mesh) == VMP::OK);
  const VMP::internal::Vertex_rings_3 original(mesh);
  VMP::internal::Vertex_rings_3 rings = original;
  const auto levels = VMP::internal::coarsen_surface_3(rings, VMP::internal::unit_points(mesh), VMP::internal::Budget());

  int remaining = 0;
  for(int v = 0; v < rings.number_of_vertices(); ++v)
    if(!rings[v].empty())
    {
      ++remaining;
      CHECK(rings[v].size() == 3);
    }
  CHECK(remaining == 4);

  for(auto level = levels.rbegin(); level != levels.rend(); ++level)
    for(auto removed = level->rbegin(); removed != level->rend(); ++removed)
      rings.insert(*removed);
  for(int v = 0; v < rings.number_of_vertices(); ++v)
  {
    std::vector<int> ring = rings[v];
    std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), original[v].front()), ring.end());
    CHECK(ring == original[v]);
  }
}

TEST_CASE("an edge on a curve is split at a vertex of the curve, but at none that is an end of the edge up to rounding")
{
  const double third = 0.1 + 0.2; // more than 0.3
  const VMP::internal::Feature_curve_3 curve
    = { { 0, 1, 2 }, VMP::internal::Polyline_3({ { 0, 0, 0 }, { third, 0, 0 }, { third, 1, 0 } }) };
  CHECK(curve.farthest_vertex(0.1, 1.2).second == third);
  CHECK(curve.farthest_vertex(0.3, 1.2).second == Approx(0.75));
}
