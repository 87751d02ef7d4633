// Ridges, corners, curves and patches of bodies that hexahedra keep.
#include "hexahedra_of_bodies.h"

#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/Body_complex_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/hexahedra_with_features_3.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

// A roof: the top of the cube [0, 8]^3 falls by 15 degrees on both sides of a ridge at y = 3, between planes of a grid.
Vector3d roof(const Vector3d& p) { return Vector3d(p[0], p[1], p[2] * (1 - std::tan(CGAL_PI / 12) * std::abs(p[1] - 3) / 8)); }

// The largest distance of points on the ridge to edges of quadrangles.
double distance_of_ridge(const Hexahedron_soup_3& mesh)
{
  double farthest = 0;
  for(int i = 0; i <= 80; ++i)
  {
    double least = std::numeric_limits<double>::infinity();
    for(const auto& f : mesh.facets)
      for(std::size_t k = 0; k < 4; ++k)
      {
        const auto point
          = [&](const std::size_t v) { return K::Point_3(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]); };
        const K::Segment_3 edge(point(f[k]), point(f[(k + 1) % 4]));
        least = (std::min)(least, CGAL::squared_distance(K::Point_3(i / 10., 3, 8), edge));
      }
    farthest = (std::max)(farthest, std::sqrt(least));
  }
  return farthest;
}

// The complex of a soup, mapped to its polycube.
struct Complex_on_polycube
{
  double spacing;
  Cube_complex<>::C3t3 c3t3;
  Cube_complex<>::Point_map uvw;

  Complex_on_polycube(const Tetrahedron_soup_3& soup, const double spacing)
    : spacing(spacing)
  {
    std::vector<Cube_complex<>::Vertex_handle> vertices;
    std::vector<Cube_complex<>::Cell_handle> cells;
    VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
    REQUIRE(CGAL::stretch_minimizing_volume_parameterization(
              c3t3, VMP::make_vertex_point_map(uvw),
              CGAL::parameters::boundary_parameterizer(PM::Polycube_boundary_parameterizer_3(spacing))
                               .do_slide_boundary(true)).status == VMP::OK);
  }

  Hexahedral_mesh_result mesh(Hexahedron_soup_3& hexahedra)
  { return PM::make_hexahedral_mesh_3(c3t3, VMP::make_vertex_point_map(uvw), spacing, hexahedra); }
};

Hexahedra_3 hexahedra_of(const Hexahedron_soup_3& soup)
{
  return { VMP::internal::vectors_of(soup.points), {}, soup.cells, soup.cell_blocks, soup.cell_indices, soup.cell_references,
           soup.facets, soup.facet_cells, soup.polycube_faces };
}

// The complex of a body whose marked edges are those of the cube and a diagonal in its top that begins at a point of the domain.
struct Complex_with_diagonal
{
  std::vector<VMP::internal::Vector_3> points;
  PM::internal::Body_complex_3 complex;

  Complex_with_diagonal(Body body, const int n, const Vector3d& first, const double width, const double length_of_needles = 8)
    : points(VMP::internal::vectors_of(body.soup.points)), complex(marked(body, n, first), points, width, length_of_needles)
  {}

  static PM::internal::Mapped_soup_3 marked(Body& body, const int n, const Vector3d& first)
  {
    const auto lies_on = [&](const Vector3d& p, const int axis) { return p[axis] == 0 || p[axis] == n; };
    for(const auto& cell : body.soup.cells)
      for(std::size_t i = 0; i < 4; ++i)
        for(std::size_t j = 0; j < i; ++j)
        {
          const Vector3d p = vector(body.images[cell[i]]), q = vector(body.images[cell[j]]), d = q - p;
          int number_of_sides = 0;
          for(int axis = 0; axis < 3; ++axis)
            number_of_sides += lies_on(p, axis) && p[axis] == q[axis];
          const Vector3d from_first = p - first;
          if(number_of_sides == 2 || (d[0] == d[1] && d[2] == 0 && from_first[0] == from_first[1] && from_first[2] == 0))
            body.soup.edges.push_back({ cell[i], cell[j] });
        }
    return { body.soup, body.images };
  }

  // Returns the number of arcs at a point. Around each corner, the patch after an arc is that before the next one.
  std::size_t number_of_arcs_at(const Vector3d& p) const
  {
    std::size_t result = 0;
    for(const PM::internal::Corner_3& corner : complex.corners())
    {
      const auto patch = [&](const std::size_t i, const bool is_left)
      {
        const PM::internal::End_of_arc_3& end = corner.ends[i % corner.ends.size()];
        return complex.arcs()[end.arc].patches[(end.side == 0) != is_left];
      };
      for(std::size_t i = 0; i < corner.ends.size(); ++i)
      {
        CHECK(patch(i, true) == patch(i + 1, false));
        const PM::internal::End_of_arc_3& end = corner.ends[i];
        const std::vector<std::size_t>& vertices = complex.arcs()[end.arc].vertices;
        CHECK((end.side == 0 ? vertices.front() : vertices.back()) == corner.vertex);
      }
      if((vector(complex.points()[corner.vertex]) - p).norm() < 0.01)
        result += corner.ends.size();
    }
    return result;
  }
};

} // namespace

TEST_CASE("Edges of hexahedra follow a blunt ridge that a complex has as a feature")
{
  constexpr double spacing = 2;
  for(const bool has_features : { true, false })
  {
    Body body(8, 0, roof);
    std::map<std::array<double, 3>, std::size_t> vertex_at;
    for(std::size_t v = 0; v < body.images.size(); ++v)
      vertex_at[body.images[v]] = v;
    for(double x = 0; x < 8 && has_features; ++x)
    {
      body.soup.edges.push_back({ vertex_at.at({ x, 3, 8 }), vertex_at.at({ x + 1, 3, 8 }) });
      body.soup.edge_references.push_back(7);
    }
    Complex_on_polycube complex(body.soup, spacing);
    CHECK(complex.c3t3.number_of_edges_in_complex() == (has_features ? 8 : 0));
    Hexahedron_soup_3 mesh;
    REQUIRE(complex.mesh(mesh).status == VMP::OK);
    CHECK((distance_of_ridge(mesh) < 0.1 * spacing) == has_features);
  }
}

TEST_CASE("Marked corners on a ridge, in a face and on an edge of a complex are vertices of its hexahedra")
{
  constexpr double spacing = 2;
  Body body(8, 0, roof);
  std::map<std::array<double, 3>, std::size_t> vertex_at;
  for(std::size_t v = 0; v < body.images.size(); ++v)
    vertex_at[body.images[v]] = v;
  const auto mark_edges = [&](const std::array<double, 3>& p, const std::array<double, 3>& way)
  {
    for(double i = 0; i < 8; ++i)
      body.soup.edges.push_back({ vertex_at.at({ p[0] + i * way[0], p[1] + i * way[1], p[2] + i * way[2] }),
                                  vertex_at.at({ p[0] + (i + 1) * way[0], p[1] + (i + 1) * way[1], p[2] + (i + 1) * way[2] }) });
  };
  mark_edges({ 0, 3, 8 }, { 1, 0, 0 });
  mark_edges({ 0, 0, 0 }, { 0, 1, 0 });
  body.soup.edge_references.assign(body.soup.edges.size(), 7);
  Points corners; // all as far from planes of the grid as can be, in the directions in which vertices may move
  for(const std::array<double, 3>& p : { std::array<double, 3>{ 3, 3, 8 }, { 5, 5, 0 }, { 0, 5, 0 }, { 8, 3, 5 } })
    corners.push_back(body.soup.points[vertex_at.at(p)]);
  for(const bool is_marked : { false, true })
  {
    body.soup.corners.clear();
    for(const std::array<double, 3>& p : corners)
      if(is_marked)
        body.soup.corners.push_back(static_cast<std::size_t>(std::find(body.soup.points.begin(), body.soup.points.end(), p)
                                                             - body.soup.points.begin()));
    Hexahedron_soup_3 mesh;
    const Hexahedral_mesh_result result = Complex_on_polycube(body.soup, spacing).mesh(mesh);
    REQUIRE(result.status == VMP::OK);
    CHECK(result.minimum_scaled_jacobian > 0.4);
    CHECK(result.corners_given_up.empty());
    CHECK(distance_of_ridge(mesh) < 0.1 * spacing);
    for(const std::array<double, 3>& corner : corners)
    {
      double least = std::numeric_limits<double>::infinity();
      for(const std::array<double, 3>& p : mesh.points)
        least = (std::min)(least, (vector(p) - vector(corner)).norm());
      CHECK((least < 1e-9) == is_marked);
      CHECK((least > 0.1 * spacing) == !is_marked);
    }
  }
}

TEST_CASE("Of marked corners nearer to each other than hexahedra are wide, those without a vertex are told")
{
  Body box(8, 0, same);
  for(std::size_t v = 0; v < box.images.size(); ++v)
    if(const auto& [x, y, z] = box.images[v]; (3 <= x && x <= 5 && y == 0 && z == 0) || (x == 4 && y == 4 && z == 4))
      box.soup.corners.push_back(v);
  REQUIRE(box.soup.corners.size() == 4); // one inside, which is no corner of the surface
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(box.soup, box.images, 4, mesh);
  CHECK(result.status == VMP::OK);
  const std::set<std::array<double, 3> > given_up(result.corners_given_up.begin(), result.corners_given_up.end());
  CHECK(given_up == std::set<std::array<double, 3> >{ { 3, 0, 0 }, { 5, 0, 0 } });
  CHECK(result.message.find("Of 3 marked corners, 2 have no vertex, among them the one at (") != std::string::npos);
}

// A cube whose top is a ridge along the diagonal has a curve and a patch more.
void check_all_features_of_top(const PM::Hexahedral_mesh_features& features)
{
  CHECK(features.number_of_corners == 8);
  CHECK(features.number_of_curves == 13);
  CHECK(features.number_of_patches == 7);
  CHECK(features.number_of_corners_kept == 8);
  CHECK(features.number_of_curves_kept == 13);
  CHECK(features.number_of_patches_kept == 7);
}

// The top of a cube is a ridge along the diagonal, which follows no axis: four curves meet at both of its ends.
TEST_CASE("Hexahedra keep the corners, curves and patches of a body, also those that follow no axis")
{
  const Body body(6, 0, [](const Vector3d& p) -> Vector3d
                  { return { p[0], p[1], p[2] * (1 - 0.08 * std::abs(p[0] - p[1])) }; });
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = body.mesh(1, mesh);
  CAPTURE(result.message, result.minimum_scaled_jacobian);
  REQUIRE(result.status == VMP::OK);
  check_boundary(mesh, body);
  check_all_features_of_top(result.features);
  CHECK(result.minimum_scaled_jacobian > 0.1);
  CHECK(enclosed_volume(mesh) == Approx(36 * 6 - 36 * 6 * 0.08 * 2).epsilon(1e-9)); // the mean of |x - y| is 2

  CHECK(mesh.corners.size() == 8);
  double length = 0;
  for(const auto& [v, w] : mesh.edges)
    length += (vector(mesh.points[v]) - vector(mesh.points[w])).norm();
  const double low = 6 * (1 - 0.08 * 6);
  CHECK(length == Approx(4 * 6 + 2 * 6 + 2 * low + 4 * std::hypot(6, 6 - low) + std::sqrt(72.)));
  mesh.edge_references.assign(mesh.edges.size(), 7);
  std::ostringstream inp, named, medit;
  PM::IO::write_INP(inp, mesh);
  CHECK(inp.str().find("*NSET, NSET=CURVE_7\n") != std::string::npos);
  CHECK(inp.str().find("*NSET, NSET=CORNERS\n") != std::string::npos);
  PM::IO::write_INP(named, mesh, "C3D8", { { { 1, 7 }, "rim" }, { { 2, 7 }, "side" } });
  CHECK(named.str().find("*NSET, NSET=rim\n") != std::string::npos);
  CHECK(named.str().find("*NSET, NSET=side\n") == std::string::npos);
  PM::IO::write_MEDIT(medit, mesh);
  CHECK(medit.str().find("\nEdges\n" + std::to_string(mesh.edges.size()) + "\n") != std::string::npos);
  CHECK(medit.str().find("\nCorners\n8\n") != std::string::npos);
  mesh.corners.push_back(mesh.points.size());
  CHECK_THROWS_AS(PM::IO::write_MEDIT(medit, mesh), VMP::Input_error);
}

// A body with the same top has a lower half of another material, with a plane between both.
TEST_CASE("Hexahedra of two subdomains keep the features of the boundary, their interface and their volumes")
{
  Body body(6, 0, [](const Vector3d& p) -> Vector3d
            { return { p[0], p[1], p[2] - 0.16 * std::abs(p[0] - p[1]) * (std::max)(0., p[2] - 3) }; });
  for(std::size_t c = 0; c < body.soup.cells.size(); ++c)
    body.soup.cell_references[c] = body.center_of_image(body.soup.cells[c])[2] < 3 ? 1 : 2;
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(body.soup, body.images, 1, mesh);
  CAPTURE(result.message, result.minimum_scaled_jacobian);
  REQUIRE(result.status == VMP::OK);
  check_all_features_of_top(result.features);
  CHECK(result.minimum_scaled_jacobian > 0.1);
  CHECK(result.interface_distance < 1e-9);
  REQUIRE(result.volumes.size() == 2);
  for(const PM::Subdomain_volumes& volumes : result.volumes)
    CHECK(volumes.of_hexahedra == Approx(volumes.of_tetrahedra).epsilon(1e-4));
}

// A side of a plate leans over by 86 degrees, and the top has a ridge along the diagonal.
TEST_CASE("Hexahedra keep features of a body with sharp edges, although these make them nearly flat")
{
  const Body body(6, 0, [](const Vector3d& p) -> Vector3d
                  {
                    const double z = p[2] / 24 * (1 - 0.04 * std::abs(p[0] - p[1]));
                    return { p[0] + (6 - p[0]) / 6 * 14 * z, p[1], z };
                  });
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = body.mesh(2, mesh);
  CAPTURE(result.message, result.minimum_scaled_jacobian);
  CHECK(result.status == VMP::OK);
  CHECK(result.features.number_of_corners_kept == 6);
  CHECK(result.features.number_of_curves_kept == 9);
  CHECK(result.features.number_of_patches_kept == 5);
}

// A diagonal of the top makes an angle of 18 degrees with a side. Two hexahedra would have 9 degrees each there. If a plate has a
// second diagonal in its bottom, which begins at the other end of an edge, one hexahedron has both ends. The second ring is put
// around its corner when the first one is there.
TEST_CASE("One hexahedron has the small angle of a patch at a corner")
{
  struct Case
  {
    double height;
    std::vector<Vector3d> first_points; // of diagonals
    std::size_t number_of_corners, number_of_curves, number_of_patches;
  };
  const Case c = GENERATE(Case{ 4, { { 0, 0, 4 } }, 8, 13, 7 }, Case{ 4, { { 1, 0, 4 } }, 10, 15, 7 },
                          Case{ 2, { { 0, 0, 4 }, { 0, 0, 0 } }, 8, 14, 8 });
  Body body(4, 0, [&](const Vector3d& p) -> Vector3d { return { 3 * p[0], p[1], p[2] * c.height / 4 }; });
  for(const Vector3d& first : c.first_points)
    Complex_with_diagonal::marked(body, 4, first);
  body.soup.edge_references.assign(body.soup.edges.size(), 1);
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(body.soup, body.images, 1.3, mesh);
  CAPTURE(result.message, result.minimum_scaled_jacobian);
  REQUIRE(result.status == VMP::OK);
  check_boundary(mesh, body);
  CHECK(result.features.number_of_corners_kept == c.number_of_corners);
  CHECK(result.features.number_of_curves_kept == c.number_of_curves);
  CHECK(result.features.number_of_patches_kept == c.number_of_patches);
  CHECK(result.minimum_scaled_jacobian > std::sin(std::atan(1 / 3.) / 2));
}

// All vertices of the diagonal are those of boxes, but its edges cross quadrangles of these.
TEST_CASE("A curve is not kept by boxes at its vertices alone")
{
  Body body(4, 0, same);
  Complex_with_diagonal::marked(body, 4, Vector3d(0, 0, 4));
  body.soup.edge_references.assign(body.soup.edges.size(), 1);
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(body.soup, body.images, 1, mesh);
  CAPTURE(result.message);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.features.number_of_curves_kept == 13);
  CHECK(std::any_of(mesh.edges.begin(), mesh.edges.end(), [&](const auto& e)
  {
    const Vector3d d = vector(mesh.points[e[1]]) - vector(mesh.points[e[0]]);
    return std::abs(d[0]) > 1e-9 && std::abs(d[0] - d[1]) < 1e-9;
  }));
}

TEST_CASE("A sheet of hexahedra is cut across the whole mesh")
{
  Hexahedron_soup_3 soup;
  REQUIRE(Body(6, 0, [](const Vector3d& p) { return p; }).mesh(2, soup).status == VMP::OK);
  const Hexahedra_3 mesh = hexahedra_of(soup);
  REQUIRE(mesh.cells.size() == 27);
  const PM::internal::Sheets_3 sheets(mesh);
  const auto vertex_at = [&](const VMP::internal::Vector_3& p)
  {
    return static_cast<std::size_t>(std::find_if(mesh.points.begin(), mesh.points.end(), [&](const VMP::internal::Vector_3& q)
                                                 { return (q - p).norm() < 1e-6; }) - mesh.points.begin());
  };
  const std::size_t v = vertex_at({ 2, 2, 0 });
  const std::size_t along_x = sheets.sheet({ v, vertex_at({ 4, 2, 0 }) }), along_y = sheets.sheet({ vertex_at({ 2, 4, 0 }), v });
  CHECK(along_x != along_y);
  CHECK(along_x == sheets.sheet({ vertex_at({ 2, 6, 6 }), vertex_at({ 4, 6, 6 }) }));
  CHECK(along_x != sheets.sheet({ v, vertex_at({ 0, 2, 0 }) }));
  CHECK(sheets.size(along_x) == 9);

  const Hexahedra_3 cut = sheets.cut({ along_x, along_y });
  CHECK(cut.cells.size() == 4 * 4 * 3);
  CHECK(cut.points.size() == 5 * 5 * 4);
  CHECK(cut.facets.size() == 2 * (4 * 4 + 4 * 3 + 4 * 3));
  for(std::size_t f = 0; f < cut.facets.size(); ++f)
    CHECK(PM::internal::side_of_facet(cut, f) < 6);
  CHECK(PM::internal::boundary_quadrangles_3(cut).size() == cut.facets.size());
  std::set<std::array<std::size_t, 3> > indices(cut.cell_indices.begin(), cut.cell_indices.end());
  CHECK(indices.size() == cut.cells.size());
  CHECK(*indices.rbegin() == std::array<std::size_t, 3>{ 3, 3, 2 });
  for(std::size_t c = 0; c < cut.cells.size(); ++c) // the middle sheets are cut
  {
    const auto& [i, j, k] = cut.cell_indices[c];
    constexpr double first[] = { 0, 2, 3, 4 };
    CHECK((cut.points[cut.cells[c][0]] - VMP::internal::Vector_3(first[i], first[j], 2. * static_cast<double>(k))).norm() < 1e-6);
  }
}

// A quarter of a cylinder: its round side belongs to two sides of the boxes, whose common edge is no sharp one.
TEST_CASE("The layer along the boundary stays where hexahedra do not fit the angles of the body, and ends at its curves")
{
  const auto round = [](const Vector3d& p) -> Vector3d
  {
    const double x = p[0] / 6, y = p[1] / 6;
    return { x * std::sqrt(1 - y * y / 2), y * std::sqrt(1 - x * x / 2), p[2] / 6 };
  };
  const Body cube(6, 0, [](const Vector3d& p) { return p; }), body(6, 0, round);
  Hexahedron_soup_3 boxes;
  REQUIRE(PM::make_hexahedral_mesh_3(cube.soup, cube.images, 2, boxes).status == VMP::OK);
  Hexahedra_3 start = hexahedra_of(boxes);
  for(VMP::internal::Vector_3& p : start.points)
    p = round(p);
  const PM::internal::Body_complex_3 complex(PM::internal::Mapped_soup_3(body.soup, body.images),
                                             VMP::internal::vectors_of(body.soup.points));
  REQUIRE(complex.arcs().size() == 9);
  const auto features = PM::internal::embedded_features_3(complex, start, 1 / 3., VMP::internal::Budget());
  REQUIRE(features);
  std::size_t number_on_round_side = 0;
  for(const std::array<std::size_t, 4>& f : features->mesh.facets)
  {
    const VMP::internal::Vector_3 n = PM::internal::area_vector(features->mesh.points, f);
    number_on_round_side += n[0] > 1e-9 && n[1] > 1e-9;
  }
  const PM::internal::Layer_removal_3 removal(complex, features->embedding, features->mesh, {});
  const Hexahedra_3& mesh = removal.result();
  CHECK(mesh.cells.size() == features->mesh.cells.size() - (features->mesh.facets.size() - number_on_round_side));
  CHECK(PM::internal::boundary_quadrangles_3(mesh).size() == mesh.facets.size());
  REQUIRE(removal.facets().size() == mesh.facets.size());
  for(std::size_t f = 0; f < mesh.facets.size(); ++f)
    CHECK(PM::internal::side_of_facet(mesh, f) < 6);

  const auto edges = PM::internal::boundary_edges_3(mesh);
  const PM::internal::Boundary_graph_3& graph = features->embedding.graph();
  std::size_t number_of_longer_paths = 0;
  for(std::size_t a = 0; a < complex.arcs().size(); ++a)
  {
    std::vector<std::size_t> old = { graph.source(features->embedding.path(a).front()) };
    for(const std::size_t e : features->embedding.path(a))
      old.push_back(graph.target(e));
    const std::vector<std::size_t> path = removal.path(old);
    CHECK(path.front() == removal.vertex(old.front()));
    CHECK(path.back() == removal.vertex(old.back()));
    for(std::size_t i = 1; i < path.size(); ++i)
      CHECK(edges.count(VMP::internal::sorted(std::array<std::size_t, 2>{ path[i - 1], path[i] })) == 1);
    number_of_longer_paths += path.size() == old.size() + 1;
  }
  CHECK(number_of_longer_paths == 4); // those from the round side to the axis
}

// A cube of hexahedra with edges of 2, on whose top curves surround rectangles between vertices of a grid with edges of 1.
struct Rectangles_on_cube
{
  Body body = Body(12, 0, [](const Vector3d& p) { return p; });
  Hexahedra_3 hexahedra;
  std::map<std::array<double, 3>, std::size_t> vertex_at;
  std::unique_ptr<PM::internal::Body_complex_3> complex;

  explicit Rectangles_on_cube(const std::vector<std::array<double, 4> >& rectangles) // ranges of x and y
  {
    Hexahedron_soup_3 soup;
    REQUIRE(PM::make_hexahedral_mesh_3(body.soup, body.images, 2, soup).status == VMP::OK);
    hexahedra = hexahedra_of(soup);
    for(std::size_t v = 0; v < body.images.size(); ++v)
      vertex_at[body.images[v]] = v;
    for(const auto& [first_x, last_x, first_y, last_y] : rectangles)
    {
      for(double x = first_x; x < last_x; ++x)
        for(const double y : { first_y, last_y })
          body.soup.edges.push_back({ vertex_at.at({ x, y, 12 }), vertex_at.at({ x + 1, y, 12 }) });
      for(double y = first_y; y < last_y; ++y)
        for(const double x : { first_x, last_x })
          body.soup.edges.push_back({ vertex_at.at({ x, y, 12 }), vertex_at.at({ x, y + 1, 12 }) });
    }
    complex = std::make_unique<PM::internal::Body_complex_3>(PM::internal::Mapped_soup_3(body.soup, body.images),
                                                             VMP::internal::vectors_of(body.soup.points));
  }
};

TEST_CASE("Curves without room are given up as soon as rounds lead to no fewer conflicts, many of them at once")
{
  std::vector<std::array<double, 4> > squares; // a grid of curves, with half the distance of edges of the hexahedra
  for(double x = 1; x < 11; ++x)
    for(double y = 1; y < 11; ++y)
      squares.push_back({ x, x + 1, y, y + 1 });
  const Rectangles_on_cube body(squares);
  std::size_t number_of_rounds = 0;
  const VMP::internal::Budget budget(1e9, [&] { return ++number_of_rounds < 500; });
  PM::internal::Feature_embedding_3(*body.complex, body.hexahedra, 2).run(budget);
  CHECK(number_of_rounds > 45); // not all curves at once
  CHECK(number_of_rounds < 500);
}

// On the top, there are two or three squares one around the other, with a distance of 1; hexahedra have edges of 2.
TEST_CASE("Sheets of hexahedra are cut across curves that have no room beside others, if fewer curves are given up then")
{
  constexpr double spacing = 2;
  std::vector<std::array<double, 4> > squares = { { 5, 7, 5, 7 } };
  for(const double half : { 2., 3. })
  {
    squares.push_back({ 6 - half, 6 + half, 6 - half, 6 + half });
    const Rectangles_on_cube body(squares);
    const VMP::internal::Budget budget;
    const Hexahedra_3 mesh = PM::internal::with_room_for_corners_3(*body.complex, body.hexahedra, spacing);
    PM::internal::Feature_embedding_3 coarse(*body.complex, mesh, spacing);
    REQUIRE(coarse.run(budget));
    REQUIRE(coarse.number_given_up() > 0);
    const auto features = PM::internal::embedded_features_3(*body.complex, body.hexahedra, spacing, budget);
    REQUIRE(features);
    CHECK((features->embedding.number_given_up() == 0) == (half == 2));
    CHECK((features->mesh.cells.size() > mesh.cells.size()) == (half == 2));
  }
}

// The path of one side of the third rectangle has no room but around the second one.
TEST_CASE("A curve is given up if its path, around another patch, leaves its own patch on the wrong side")
{
  const Rectangles_on_cube body({ { 1, 2, 4, 6 }, { 5, 6, 4, 6 }, { 7, 8, 2, 4 } });
  const VMP::internal::Budget budget;
  const Hexahedra_3 mesh = PM::internal::with_room_for_corners_3(*body.complex, body.hexahedra, 2);
  PM::internal::Feature_embedding_3 embedding(*body.complex, mesh, 2);
  REQUIRE(body.complex->arcs().size() == 12);
  REQUIRE(embedding.run(budget));
  CHECK(embedding.number_given_up() == 1);
  for(std::size_t a = 0; a < 12; ++a)
    CHECK(embedding.path(a).size() <= 2);
}

TEST_CASE("There is no embedding if all curves are given up, as in hexahedra of another subdomain")
{
  Rectangles_on_cube body({ { 2, 4, 2, 6 } });
  REQUIRE(PM::internal::Feature_embedding_3(*body.complex, body.hexahedra, 2).run(VMP::internal::Budget()));
  for(int& reference : body.hexahedra.cell_references)
    ++reference;
  CHECK_FALSE(PM::internal::Feature_embedding_3(*body.complex, body.hexahedra, 2).run(VMP::internal::Budget()));
}

TEST_CASE("Beside a hexahedron that stays inverted, the shortest curve near it that is not given up has no room")
{
  const Rectangles_on_cube body({ { 2, 4, 2, 6 }, { 8, 10, 8, 10 } });
  const VMP::internal::Budget budget;
  Hexahedra_3 mesh = body.hexahedra;
  PM::internal::Feature_embedding_3 embedding(*body.complex, mesh, 2);
  REQUIRE(embedding.run(budget));
  const auto curves = [&] { return PM::internal::curves_without_room_3(*body.complex, embedding, mesh, 2); };
  CHECK(curves().empty());
  for(VMP::internal::Vector_3& p : mesh.points)
    if((p - VMP::internal::Vector_3(4, 2, 10)).norm() < 0.1)
      p[2] = 12.5; // above the top
  const std::set<std::size_t> shortest = curves();
  REQUIRE(shortest.size() == 1);
  const auto length = [&](const std::size_t curve)
  {
    double result = 0;
    for(std::size_t a = 0; a < body.complex->arcs().size(); ++a)
      if(body.complex->arcs()[a].curve == curve)
        result += body.complex->line(a).length();
    return result;
  };
  CHECK(length(*shortest.begin()) == Approx(2));
  PM::internal::Feature_embedding_3 others(*body.complex, mesh, 2);
  REQUIRE(others.run(budget, shortest));
  for(std::size_t a = 0; a < body.complex->arcs().size(); ++a)
    CHECK(others.path(a).empty() == (body.complex->arcs()[a].curve == *shortest.begin()));
  const std::set<std::size_t> next = PM::internal::curves_without_room_3(*body.complex, others, mesh, 2);
  CHECK(next.count(*shortest.begin()) == 0);
}

TEST_CASE("Features of hexahedra cost neither their validity nor their distance to the body")
{
  PM::internal::Best_hexahedra_3 others;
  others.edge = 2;
  const auto may_replace = [&](const bool is_valid, const double minimum, const double distance)
  {
    PM::Hexahedral_mesh_result result;
    result.has_valid_mesh = is_valid;
    result.minimum_scaled_jacobian = minimum;
    result.boundary_distance = distance;
    return PM::internal::may_replace(others, result, 0.01);
  };
  CHECK(may_replace(true, 0.02, 0.9));
  CHECK(!may_replace(false, 0.02, 0.9));
  CHECK(!may_replace(true, 0.005, 0.9));
  CHECK(!may_replace(true, 0.7, 1.1));
  others.result.boundary_distance = 1.2; // the features are not to blame
  CHECK(may_replace(true, 0.02, 1.1));
}

TEST_CASE("Bends of a curve keep it within a distance")
{
  std::vector<VMP::internal::Vector_3> quarter, straight;
  for(int i = 0; i <= 100; ++i)
  {
    quarter.push_back({ std::cos(CGAL_PI * i / 200), std::sin(CGAL_PI * i / 200), 0 });
    straight.push_back({ i / 10., 0, 1 });
  }
  CHECK(PM::internal::Polyline_3(straight).bends(1e-9).empty());
  CHECK(PM::internal::Polyline_3(quarter).bends(0.06).size() == 2); // the sagitta of 30 degrees is 0.034, that of 45 is 0.076
  CHECK(PM::internal::Polyline_3(quarter).bends(0.3).empty());
  const std::vector<double> bends = PM::internal::Polyline_3({ { 0, 0, 0 }, { 1, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 } }).bends(0.1);
  CHECK(bends == std::vector<double>{ 3 });
}

TEST_CASE("The message and the result name a feature without room in the hexahedra")
{
  const Body body(8, 0, [](const Vector3d& p) -> Vector3d
                  { return { p[0], p[1], p[2] + (p[0] == 4 && p[1] == 4 && p[2] == 8 ? 2. : 0.) }; }); // a small pyramid
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = body.mesh(8, mesh);
  CAPTURE(result.message);
  REQUIRE(result.has_valid_mesh);
  CHECK(result.features.number_of_corners_kept < result.features.number_of_corners);
  REQUIRE(!result.features.curves_given_up.empty());
  CHECK(result.message.find(" curves and ") != std::string::npos);
  CHECK(result.message.find(" make the spacing smaller, such as 6.") != std::string::npos);
}

// A line across the top, next to the diagonal, ends at a distance of 1 from two corners.
TEST_CASE("Both ends of a short arc are one corner of a complex if that is asked for")
{
  const Body body(8, 0, [](const Vector3d& p) { return p; });
  const Complex_with_diagonal apart(body, 8, { 1, 0, 8 }, 0), joined(body, 8, { 1, 0, 8 }, 1.1);
  CHECK(apart.complex.arcs().size() == 15);
  CHECK(apart.number_of_arcs_at({ 0, 0, 8 }) == 3);
  CHECK(apart.number_of_arcs_at({ 1, 0, 8 }) == 3);
  CHECK(joined.complex.arcs().size() == 13);
  CHECK(joined.number_of_arcs_at({ 0, 0, 8 }) + joined.number_of_arcs_at({ 1, 0, 8 }) == 4);
  CHECK(joined.number_of_arcs_at({ 8, 7, 8 }) + joined.number_of_arcs_at({ 8, 8, 8 }) == 4);
  std::size_t number_of_ends = 0;
  for(const PM::internal::Corner_3& corner : joined.complex.corners())
    number_of_ends += corner.ends.size();
  CHECK(number_of_ends == 26);
}

// Between the diagonal and long edges of the top, there are 5.7 degrees: they are within 0.1 for a length of 1.
TEST_CASE("Sides of a needle share their first part in a complex if that is asked for")
{
  const Body body(8, 0, [](const Vector3d& p) -> Vector3d { return { p[0], p[1] / 10, p[2] }; });
  const Complex_with_diagonal apart(body, 8, { 0, 0, 8 }, 0), shared(body, 8, { 0, 0, 8 }, 0.1);
  CHECK(apart.complex.arcs().size() == 13);
  CHECK(apart.number_of_arcs_at({ 0, 0, 8 }) == 4);
  CHECK(shared.complex.arcs().size() == 15);
  CHECK(shared.number_of_arcs_at({ 0, 0, 8 }) == 3);
  CHECK(shared.number_of_arcs_at({ 8, 0.8, 8 }) == 3);
  std::size_t number_of_new_corners = 0;
  for(const PM::internal::Corner_3& corner : shared.complex.corners())
    if(!corner.is_of_body)
    {
      const auto& p = shared.complex.points()[corner.vertex];
      CHECK((std::min)(p[0], 8 - p[0]) == Approx(1).margin(0.05));
      CHECK(shared.number_of_arcs_at({ p[0], p[1], p[2] }) == 3);
      ++number_of_new_corners;
    }
  CHECK(number_of_new_corners == 2);
  CHECK(Complex_with_diagonal(body, 8, { 0, 0, 8 }, 0.1, 9).complex.arcs().size() == 15);
  CHECK(Complex_with_diagonal(body, 8, { 0, 0, 8 }, 0.1, 11).complex.arcs().size() == 13);
}
