// Polycubes of voxels: their topology, the charts that are drawn on the surface, and edges that are split for them.
#include "Visitor_that_ends.h"
#include "bricks.h"
#include "ring_of_prisms.h"

#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/map_to_voxels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Refinement_3.h>
#include <CGAL/Volume_mesh_parameterization/repair_tetrahedron_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

double volume_of(const VMP::Tetrahedron_soup_3& soup)
{
  const auto vector = [&](const std::size_t v) { return VMP::internal::to_vector(soup.points[v]); };
  double result = 0;
  for(const auto& [a, b, c, d] : soup.cells)
  {
    const double volume = (vector(b) - vector(a)).cross(vector(c) - vector(a)).dot(vector(d) - vector(a)) / 6;
    CHECK(volume > 0);
    result += volume;
  }
  return result;
}

// The boundary of a soup in its own units, with its sharp edges.
PM::internal::Unit_surface_3 surface_mesh_of(const VMP::Tetrahedron_soup_3& soup)
{
  const VMP::internal::Numbered_surface_3 surface = VMP::internal::surface_of(VMP::internal::body_of(soup));
  PM::internal::Unit_surface_3 result;
  REQUIRE(VMP::internal::build_boundary_mesh_3(surface, result.mesh) == VMP::OK);
  result.is_sharp = VMP::internal::are_among(result.mesh, surface.sharp_edges);
  return result;
}

// Voxels of the solid bricks, two voxels along each side of a brick.
template <typename IsSolid>
PM::internal::Voxels_3 voxels_of(const Brick& size, const IsSolid& is_solid)
{
  const VMP::Tetrahedron_soup_3 soup = bricks(size, is_solid, in_place);
  return PM::internal::voxels_of_surface_3(surface_mesh_of(soup).mesh, 0.5, {0, 0, 0}, 0.5);
}

// Splits edges of a body and maps its boundary to a polycube. Checks both.
void check_refined(const VMP::Tetrahedron_soup_3& given, const double spacing)
{
  VMP::internal::Body_3 body = VMP::internal::body_of(given);
  std::vector<VMP::internal::Mapped_boundary_3> boundaries;
  REQUIRE(Polycube(spacing).find_boundaries(body, true, VMP::internal::Budget(), boundaries) == VMP::OK);
  REQUIRE(boundaries.size() == 1); // there is no other
  const auto inserted = VMP::internal::split_any_edges_3(body, boundaries[0].splits);
  REQUIRE(inserted);
  VMP::Tetrahedron_soup_3 soup = given;
  VMP::internal::insert_points(body, *inserted, soup);
  const std::vector<std::array<double, 3> > targets = boundaries[0].targets;
  REQUIRE(soup.points.size() > given.points.size());
  REQUIRE(targets.size() == soup.points.size());
  CHECK(std::equal(given.points.begin(), given.points.end(), soup.points.begin()));
  CHECK(volume_of(soup) == Approx(volume_of(given)));
  CHECK(soup.cell_references == std::vector<int>(soup.cells.size(), 1));

  const VMP::internal::Numbered_surface_3 surface = VMP::internal::surface_of(body);
  double volume = 0;
  for(const auto& [a, b, c] : surface.facets)
  {
    const auto image = [&](const std::size_t v)
    {
      const auto& [x, y, z] = targets[surface.vertices[v]];
      return Point_3(x, y, z);
    };
    const std::array<Point_3, 3> t = {image(a), image(b), image(c)};
    const std::size_t d = direction(t);
    REQUIRE(d < 6);
    if(spacing > 0)
      CHECK(std::remainder(t[0][static_cast<int>(d / 2)], spacing) == 0);
    volume += CGAL::determinant(t[0] - CGAL::ORIGIN, t[1] - CGAL::ORIGIN, t[2] - CGAL::ORIGIN) / 6;
  }
  CHECK(volume > 0);
}

} // namespace

TEST_CASE("a ring whose labels have no polycube is refined for one of voxels")
{
  const VMP::Tetrahedron_soup_3 ring = ring_of_prisms();
  std::vector<std::array<double, 3> > targets;
  REQUIRE(Polycube().parameterize(ring, targets) == VMP::ERROR_NO_POLYCUBE);
  check_refined(ring, GENERATE(0., 0.25));
}

TEST_CASE("of several bodies, each is refined that has no polycube otherwise")
{
  VMP::Tetrahedron_soup_3 bodies = ring_of_prisms();
  const auto add = [&](const VMP::Tetrahedron_soup_3& body, const double distance)
  {
    const std::size_t n = bodies.points.size();
    for(const auto& [x, y, z] : body.points)
      bodies.points.push_back({x + distance, y, z});
    for(const auto& [a, b, c, d] : body.cells)
      bodies.cells.push_back({a + n, b + n, c + n, d + n});
    bodies.cell_references.resize(bodies.cells.size(), 1);
  };
  add(bricks({1, 1, 1}, is_box, in_place), 10);
  add(ring_of_prisms(), 20);
  check_refined(bodies, 0);
}

TEST_CASE("a body with several handles may have no polycube unless edges are split")
{
  using PM::internal::Vector_3;
  VMP::Tetrahedron_soup_3 rings = ring_of_prisms(); // two rings that share a quadrangle, each a mirror image of the other one
  const auto at = [&](const std::size_t v) { return VMP::internal::to_vector(rings.points[v]); };
  const std::size_t number_of_points = rings.points.size(), number_of_cells = rings.cells.size();
  const Vector_3 origin = at(0), normal = (at(1) - origin).cross(at(3) - origin).normalized();
  std::vector<std::size_t> mirrored;
  for(std::size_t v = 0; v < number_of_points; ++v)
  {
    const double height = normal.dot(at(v) - origin);
    const bool is_shared = std::abs(height) < 1e-9;
    CHECK(is_shared == (v == 0 || v == 1 || v == 3 || v == 4));
    mirrored.push_back(is_shared ? v : rings.points.size());
    if(!is_shared)
      rings.points.push_back(VMP::internal::coordinates(Vector_3(at(v) - 2 * height * normal)));
  }
  for(std::size_t c = 0; c < number_of_cells; ++c)
  {
    const auto [i, j, k, l] = rings.cells[c];
    rings.cells.push_back({mirrored[j], mirrored[i], mirrored[k], mirrored[l]});
    rings.cell_references.push_back(1);
  }
  std::vector<std::array<double, 3> > targets;
  CHECK(Polycube().parameterize(rings, targets) == VMP::ERROR_NO_POLYCUBE);
  CHECK(std::string(VMP::get_error_message(VMP::ERROR_NO_POLYCUBE)).find("Refinement_mode::BOUNDARY") != std::string::npos);
}

TEST_CASE("a search for polycubes of voxels can be ended anywhere, with nothing written")
{
  const VMP::internal::Body_3 ring = VMP::internal::body_of(ring_of_prisms());
  std::vector<VMP::internal::Mapped_boundary_3> boundaries;
  check_interruption([&](const auto& np)
  {
    VMP::internal::Limits limits(np);
    return Polycube().find_boundaries(ring, true, limits.budget(), boundaries);
  }, boundaries);
}

TEST_CASE("voxels have the topology of their body")
{
  using namespace PM::internal;
  const auto is_plate = [](const int x, const int y, int) { return x % 2 == 0 || y != 1; };
  const int holes = GENERATE(0, 1, 2, 3);
  Voxels_3 voxels = voxels_of({2 * holes + 1, 3, 1}, is_plate);
  CHECK(std::count(voxels.is_inside.begin(), voxels.is_inside.end(), true) == 8 * (3 * (2 * holes + 1) - holes));
  CHECK(characteristic_of_voxels_3(voxels, {0, 0, 0}, voxels.size) == 2 - 2 * holes);
  const std::vector<bool> is_inside = voxels.is_inside;
  CHECK(make_surface_of_characteristic(voxels, 0.5, 2 - 2 * holes));
  CHECK(voxels.is_inside == is_inside);
  CHECK(!make_surface_of_characteristic(voxels, 0.5, 4 - 2 * holes));
}

TEST_CASE("voxels that touch along an edge or at a corner are joined or parted")
{
  using namespace PM::internal;
  const int z = GENERATE(0, 1); // of the second brick
  Voxels_3 voxels = voxels_of({2, 2, 2}, is_box);
  for(std::size_t i = 0; i < voxels.parts.size(); ++i)
  {
    const Eigen::Vector3i brick = (voxels.voxel(i).array() - 3) / 2; // behind three free layers
    voxels.is_inside[i] = voxels.is_inside[i] && (brick == Eigen::Vector3i(0, 0, 0) || brick == Eigen::Vector3i(1, 1, z));
    voxels.parts[i] = voxels.is_inside[i];
  }
  REQUIRE(std::count(voxels.is_inside.begin(), voxels.is_inside.end(), true) == 2 * 8);
  CHECK(!characteristic_of_voxels_3(voxels, {0, 0, 0}, voxels.size));
  CHECK(make_manifold(voxels, 0.5));
  CHECK(characteristic_of_voxels_3(voxels, {0, 0, 0}, voxels.size).value_or(0) > 0);
}

TEST_CASE("a cut between two parts of a border is no border of the voxels")
{
  using namespace PM::internal;
  // a block with a notch in front, above: its top and its front meet on both sides of the notch
  const Voxels_3 voxels = voxels_of({3, 2, 2}, [](const int x, const int y, const int z) { return x != 1 || y != 0 || z != 1; });
  const Voxel_faces_3 faces(voxels);
  std::vector<std::size_t> face_of_piece = faces.faces;
  CHECK(are_neighbors_those_of_charts(Charts_of_voxels_3(voxels), faces, face_of_piece));
  CHECK(are_corners_those_of_charts(Charts_of_voxels_3(voxels), faces, face_of_piece));
  // on the left, the side, the front, the wall of the notch and the top now meet at one point, each with the same neighbors
  const auto give = [&](const int x, const int y, const std::size_t direction)
  {
    const std::size_t voxel = voxels.index(Eigen::Vector3i(3 + x, 3 + y, 6)); // behind three free layers
    const auto piece = std::find(faces.faces.begin(), faces.faces.end(), 6 * voxel + 4) - faces.faces.begin();
    face_of_piece.at(static_cast<std::size_t>(piece)) = 6 * voxel + direction;
  };
  give(0, 1, 1);
  give(0, 0, 3);
  give(1, 0, 0);
  CHECK(are_neighbors_those_of_charts(Charts_of_voxels_3(voxels), faces, face_of_piece));
  CHECK(!are_corners_those_of_charts(Charts_of_voxels_3(voxels), faces, face_of_piece));
}

TEST_CASE("edges of a surface are split where short ones are asked for, with no sharp angles")
{
  using namespace PM::internal;
  Unit_surface_3 cube = surface_mesh_of(bricks({1, 1, 1}, is_box, in_place));
  const Boundary_mesh_3 before = cube.mesh;
  const auto length = [](const PM::internal::Vector_3& p) { return p.x() < 0.2 ? 0.1 : 10.; };
  split_long_edges_3(length, cube);
  CHECK(cube.mesh.number_of_faces() < 3000); // more with short edges everywhere
  CHECK(CGAL::is_closed(cube.mesh));
  double area = 0;
  for(const auto h : cube.mesh.halfedges())
  {
    const auto [p, q, r] = std::array<PM::internal::Vector_3, 3>{ to_vector(cube.mesh.point(cube.mesh.source(h))),
      to_vector(cube.mesh.point(cube.mesh.target(h))), to_vector(cube.mesh.point(cube.mesh.target(cube.mesh.next(h)))) };
    CHECK((q - p).norm() <= length((p + q) / 2));
    CHECK((q - p).normalized().dot((r - p).normalized()) < std::cos(0.4)); // half of a right angle by bisection, and less
    area += (q - p).cross(r - p).norm() / 6;
  }
  CHECK(area == Approx(6));

  // the splits make the same points, one after the other
  REQUIRE(before.number_of_vertices() + cube.splits.size() == cube.mesh.number_of_vertices());
  std::vector<PM::internal::Vector_3> points = points_of(before);
  for(const auto& [v, w] : cube.splits)
    points.push_back((points[v] + points[w]) / 2);
  CHECK(points == points_of(cube.mesh));
}

TEST_CASE("sharp edges stay sharp while a surface is split, and are free borders of charts")
{
  using namespace PM::internal;
  Unit_surface_3 split = surface_mesh_of(bricks({3, 2, 2}, is_box, in_place)); // 28 sharp edges of the box
  const auto parents = split_edges_3({split.mesh.edges().begin(), split.mesh.edges().end()}, split);
  REQUIRE(parents.size() == split.mesh.number_of_faces());
  const std::size_t number_of_parents = parents.size() / 4;
  for(std::size_t f = 0; f < number_of_parents; ++f)
    CHECK(std::count(parents.begin(), parents.end(), f) == 4);
  split_long_edges_3([](const PM::internal::Vector_3&) { return 0.3; }, split);
  REQUIRE(split.is_sharp.size() == split.mesh.number_of_edges());
  double length = 0;
  for(const auto e : split.mesh.edges())
    length += split.is_sharp[e] * edge_vector(split.mesh, split.mesh.halfedge(e)).norm();
  CHECK(length == Approx(28));
  CHECK(std::count(split.is_sharp.begin(), split.is_sharp.end(), true) == 4 * 28);

  const Label_functional_3 functional(split.mesh, split.is_sharp);
  const Label_functional_3 blunt(split.mesh, std::vector<bool>(split.mesh.number_of_edges(), false));
  for(const auto e : split.mesh.edges())
  {
    const auto h = split.mesh.halfedge(e);
    CHECK((functional.length(h) == 0) == split.is_sharp[e]);
    CHECK(blunt.length(h) == functional.length(h)); // by the angle
  }
  // marked edges count, whatever the angle is
  const auto h = *std::find_if(split.mesh.halfedges().begin(), split.mesh.halfedges().end(),
                               [&](const auto h) { return functional.length(h) > 0; });
  std::vector<bool> marked(split.mesh.number_of_edges(), false);
  marked[split.mesh.edge(h)] = true;
  CHECK(Label_functional_3(split.mesh, marked).length(h) == 0);
}

TEST_CASE("borders of charts are drawn on a surface as those of the voxels")
{
  using namespace PM::internal;
  Unit_surface_3 given = surface_mesh_of(bricks(size, is_ring, bend));
  set_points(given.mesh, unit_points(given.mesh));
  Voxels_3 voxels = voxels_of_surface_3(given.mesh, 0.1, {0, 0, 0}, 0.5);
  REQUIRE(make_surface_of_characteristic(voxels, 0.5, 0));
  Unit_surface_3 fine = given;
  split_long_edges_3([](const PM::internal::Vector_3&) { return 0.05; }, fine);
  const Polycube_of_voxels_3 polycube = polycube_of_voxels_3(voxels, fine, Budget());
  CHECK(polycube.charts.labels().size() >= 10); // of a ring along the axes
  CHECK(polycube.charts.labels().size() <= 12);
  Lengths_at_chains_3 lengths(polycube);
  constexpr double least = 0.05;
  if(GENERATE(false, true))
  {
    REQUIRE(lengths.halve({ 0 }, least)); // near one chain only
    for(const auto& chain : polycube.charts.chains())
      for(const auto v : polycube.charts.vertices(chain))
      {
        const PM::internal::Vector_3 p = polycube.faces.point(v);
        CHECK(lengths(p) == Approx(lengths.nearest_chain(p) == 0 ? 0.1 : 0.2));
      }
    while(lengths.halve({}, least))
    {}
    CHECK(lengths(polycube.faces.point(polycube.charts.vertices(polycube.charts.chains()[1])[0])) == Approx(least));
  }
  Drawn_polycube_3 drawn = draw_polycube_3(polycube, given, lengths, Budget());
  REQUIRE(drawn.chart_of_facet.size() == drawn.surface.mesh.number_of_faces());
  for(const bool has_splits : {false, true})
  {
    if(has_splits)
      split_between_borders(drawn);
    std::vector<std::size_t> labels;
    for(const std::size_t c : drawn.chart_of_facet)
      labels.push_back(polycube.charts.labels()[c]);
    const Polycube_charts_3 charts(drawn.surface.mesh, labels);
    CHECK(charts.number_of_charts() == polycube.charts.labels().size());
    CHECK(charts.number_of_defects() == 0);
  }
}
