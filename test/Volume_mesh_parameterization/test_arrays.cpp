// Arrays give the results of a complex, bit for bit.
#include "catch.h"
#include "cube_complex.h"
#include "cube_mesh.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Surface_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Complex = Cube_complex<>;
using Point_3 = Complex::Point_3;
using Vertex_handle = Complex::Vertex_handle;
using Points = std::vector<std::array<double, 3> >;
using Int_cells = std::vector<std::array<int, 4> >; // not the type that the package has inside

namespace {

Int_cells cells_of(const VMP::Tetrahedron_soup_3& soup)
{
  Int_cells result;
  for(const auto& [i, j, k, l] : soup.cells)
    result.push_back({ static_cast<int>(i), static_cast<int>(j), static_cast<int>(k), static_cast<int>(l) });
  return result;
}

// The images in a map, in the order of the arrays; not numbers where there is none.
Points in_order(const std::vector<Vertex_handle>& vertices, const Complex::Point_map& map)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Points result;
  for(const Vertex_handle v : vertices)
  {
    const auto found = map.find(v);
    result.push_back(found == map.end() ? std::array<double, 3>{ nan, nan, nan }
                                        : std::array<double, 3>{ found->second.x(), found->second.y(), found->second.z() });
  }
  return result;
}

bool has_same_bits(const Points& a, const Points& b)
{
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const auto& p, const auto& q)
  {
    return std::equal(p.begin(), p.end(), q.begin(), [](const double x, const double y)
    {
      return std::isnan(x) ? std::isnan(y) : x == y && std::signbit(x) == std::signbit(y);
    });
  });
}

// A cube, as a complex and as arrays, whose points inside and cells are in no order of space.
struct Both
{
  Complex complex;
  VMP::Tetrahedron_soup_3 soup;
  Int_cells cells;

  explicit Both(const VMP::internal::Numbered_mesh_3& mesh)
    : complex(mesh), soup(source_soup(mesh)), cells(cells_of(soup))
  {}

  // Returns whether both ways have the same targets. The complex has them in `complex.target`.
  bool has_same_targets(const VMP::Error_code of_complex, const Points& targets)
  {
    return of_complex == VMP::OK && has_same_bits(in_order(complex.vertices, complex.target), targets);
  }
};

// A complex with the functions that the concepts MeshComplex_3InTriangulation_3 and MeshComplexWithFeatures_3InTriangulation_3
// demand, among those that have the same name in both versions of CGAL's model.
class Complex_archetype : private Complex::C3t3
{
  using Model = Complex::C3t3;

public:
  using typename Model::Cell_handle, typename Model::Corner_index, typename Model::Curve_index, typename Model::Edge,
    typename Model::Facet, typename Model::Index, typename Model::Subdomain_index, typename Model::Surface_patch_index,
    typename Model::Triangulation, typename Model::Vertex_handle;
  using Model::cells_in_complex_begin, Model::cells_in_complex_end, Model::corner_index, Model::edges_in_complex_begin,
    Model::edges_in_complex_end, Model::facets_in_complex_begin, Model::facets_in_complex_end, Model::in_dimension,
    Model::index, Model::set_dimension, Model::set_index, Model::subdomain_index, Model::surface_patch_index,
    Model::triangulation, Model::vertices_in_complex_begin, Model::vertices_in_complex_end;

  // Some functions of these names are private.
  template <typename... Arguments>
  void add_to_complex(const Arguments&... arguments) { Model::add_to_complex(arguments...); }
  template <typename... Arguments>
  void remove_from_complex(const Arguments&... arguments) { Model::remove_from_complex(arguments...); }
  template <typename... Arguments>
  bool is_in_complex(const Arguments&... arguments) const { return Model::is_in_complex(arguments...); }
  template <typename... Arguments>
  Curve_index curve_index(const Arguments&... arguments) const { return Model::curve_index(arguments...); }

  Model& model() { return *this; }
};

// A bar of which all cells share one point, the last one, bent by the targets: no point sees all of its surface.
struct Bent_fan
{
  Points points, targets;
  Int_cells cells;

  Bent_fan()
  {
    constexpr int length = 6;
    for(int z = 0; z <= length; ++z)
      for(const auto& [x, y] : { std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1} })
      {
        points.push_back({ double(x), double(y), double(z) });
        const double angle = z * 3.14159265 / length;
        targets.push_back({ (1 + x) * std::cos(angle), double(y), (1 + x) * std::sin(angle) });
      }
    const int last = static_cast<int>(points.size());
    points.push_back({ 0.5, 0.5, length / 2. });
    targets.push_back(targets[0]); // is not read
    const auto add_quadrangle = [&](const int a, const int b, const int c, const int d)
    {
      cells.push_back({ last, a, b, c });
      cells.push_back({ last, a, c, d });
    };
    add_quadrangle(3, 2, 1, 0);
    add_quadrangle(4 * length, 4 * length + 1, 4 * length + 2, 4 * length + 3);
    for(int z = 0; z < length; ++z)
      for(int i = 0; i < 4; ++i)
        add_quadrangle(4 * z + i, 4 * z + (i + 1) % 4, 4 * z + 4 + (i + 1) % 4, 4 * z + 4 + i);
  }
};

// A boundary parameterizer of the user: a third of the size, each coordinate by another factor.
struct Shrinking_parameterizer
{
  template <typename PointRange, typename CellRange, typename TargetRange,
            typename NamedParameters = params::Default_named_parameters>
  VMP::Error_code parameterize(const PointRange& points, const CellRange&, TargetRange& targets,
                               const NamedParameters& np = params::default_values()) const
  {
    if constexpr(!params::is_default_parameter<NamedParameters, CGAL::internal_np::visitor_t>::value)
      if(!params::get_parameter(np, CGAL::internal_np::visitor).goes_on())
        return VMP::ERROR_INTERRUPTED;
    targets.clear();
    for(const auto& p : points)
      targets.push_back({ p[0] / 2, p[1] / 3, p[2] / 4 });
    return VMP::OK;
  }
};

// Does so for complexes only.
struct Shrinking_parameterizer_of_complexes
{
  template <typename C3t3, typename VertexPointMap, typename NamedParameters = params::Default_named_parameters>
  VMP::Error_code parameterize(const C3t3& c3t3, VertexPointMap target,
                               const NamedParameters& = params::default_values()) const
  {
    for(const Vertex_handle v : VMP::boundary_vertices(c3t3))
      put(target, v, Point_3(v->point().x() / 2, v->point().y() / 3, v->point().z() / 4));
    return VMP::OK;
  }
};

} // namespace

TEST_CASE("Each boundary parameterizer finds the same targets")
{
  Both body(cube_mesh(4, 0.15));
  const auto check = [&](const auto& parameterizer)
  {
    Points targets;
    body.complex.target.clear();
    const VMP::Error_code status = parameterizer.parameterize(body.complex.c3t3, body.complex.boundary_map());
    REQUIRE(parameterizer.parameterize(body.soup.points, body.cells, targets) == VMP::OK);
    CHECK(body.has_same_targets(status, targets));
    CHECK(std::count_if(targets.begin(), targets.end(), [](const auto& p) { return std::isnan(p[0]); }) == 27);
  };
  check(VMP::Ball_boundary_parameterizer_3());
  check(VMP::Cube_boundary_parameterizer_3(1, 2, 3));
  check(PM::Polycube_boundary_parameterizer_3());
  check(PM::Polycube_boundary_parameterizer_3(0.5));
}

TEST_CASE("Corners, labels and surfaces are given by arrays, too")
{
  Both body(cube_mesh(2));
  Points targets;
  SECTION("the corners of a box")
  {
    std::array<std::size_t, 8> corners;
    std::array<Vertex_handle, 8> corner_vertices;
    for(std::size_t k = 0; k < 8; ++k)
    {
      const std::array<double, 3> corner = { k & 1 ? 2. : 0., k & 2 ? 2. : 0., k & 4 ? 2. : 0. };
      corners[k] = std::find(body.soup.points.begin(), body.soup.points.end(), corner) - body.soup.points.begin();
      corner_vertices[k] = body.complex.vertices[corners[k]];
    }
    const VMP::Cube_boundary_parameterizer_3 cube;
    const VMP::Error_code status = cube.parameterize(body.complex.c3t3, corner_vertices, body.complex.boundary_map());
    REQUIRE(cube.parameterize(body.soup.points, body.cells, corners, targets) == VMP::OK);
    CHECK(body.has_same_targets(status, targets));
    CHECK(targets[corners[5]] == std::array<double, 3>{ 0.5, -0.5, 0.5 });

    const Points before = targets;
    corners[3] = corners[5];
    CHECK(cube.parameterize(body.soup.points, body.cells, corners, targets) == VMP::ERROR_INVALID_CORNERS);
    CHECK(has_same_bits(targets, before));
  }
  SECTION("the landmarks of a ball")
  {
    const std::size_t v = std::find(body.soup.points.begin(), body.soup.points.end(), std::array<double, 3>{ 2, 1, 1 })
                   - body.soup.points.begin();
    const VMP::Ball_boundary_parameterizer_3 ball;
    const std::vector<std::pair<Vertex_handle, Point_3> > of_complex
      = { { body.complex.vertices[v], Point_3(0, 0, 1) } };
    const std::vector<std::pair<std::size_t, std::array<double, 3> > > of_arrays = { { v, { 0, 0, 1 } } };
    const VMP::Error_code status = ball.parameterize(body.complex.c3t3, of_complex, body.complex.boundary_map());
    REQUIRE(ball.parameterize(body.soup.points, body.cells, of_arrays, targets) == VMP::OK);
    CHECK(body.has_same_targets(status, targets));
  }
  SECTION("the labels of a polycube")
  {
    std::vector<std::array<int, 4> > labels(body.cells.size());
    std::map<Complex::C3t3::Facet, std::size_t> labels_of_facets;
    for(std::size_t c = 0; c < body.cells.size(); ++c)
      for(int i = 0; i < 4; ++i)
        for(int axis = 0; axis < 3; ++axis)
          for(const int end : { 0, 2 })
          {
            bool is_there = true;
            for(int j = 1; j < 4; ++j)
              is_there = is_there && body.soup.points[body.cells[c][(i + j) % 4]][axis] == end;
            if(is_there)
            {
              labels[c][i] = 2 * axis + (end == 0);
              labels_of_facets[{ body.complex.cells[c], i }] = labels[c][i];
            }
          }
    const PM::Polycube_boundary_parameterizer_3 polycube;
    const VMP::Error_code status = polycube.parameterize(
      body.complex.c3t3, boost::make_assoc_property_map(labels_of_facets), body.complex.boundary_map());
    REQUIRE(polycube.parameterize(body.soup.points, body.cells, labels, targets) == VMP::OK);
    CHECK(body.has_same_targets(status, targets));
    labels.pop_back();
    CHECK_THROWS_AS(polycube.parameterize(body.soup.points, body.cells, labels, targets), CGAL::Precondition_exception);
  }
  SECTION("a surface with the same connectivity")
  {
    CGAL::Surface_mesh<Point_3> boundary, target;
    const VMP::internal::Numbered_surface_3 surface
      = VMP::internal::surface_of(VMP::internal::body_of(body.soup.points, body.cells));
    for(const VMP::internal::Vector_3& p : surface.points)
    {
      boundary.add_vertex(Point_3(p[0], p[1], p[2]));
      target.add_vertex(Point_3(2 * p[0], p[1] + p[2], p[2]));
    }
    using Index = CGAL::Surface_mesh<Point_3>::Vertex_index;
    for(auto* mesh : { &boundary, &target })
      for(const auto& [i, j, k] : surface.facets)
        mesh->add_face(Index(i), Index(j), Index(k));
    const VMP::Surface_boundary_parameterizer_3 parameterizer(boundary, target);
    const VMP::Error_code status = parameterizer.parameterize(body.complex.c3t3, body.complex.boundary_map());
    REQUIRE(parameterizer.parameterize(body.soup.points, body.cells, targets) == VMP::OK);
    CHECK(body.has_same_targets(status, targets));
  }
}

TEST_CASE("A map is the same in each type of ranges, with its distortion and all that is made of it")
{
  Both body(cube_mesh(4, 0.15));
  body.complex.target.clear();
  Points targets, images;
  const PM::Polycube_boundary_parameterizer_3 polycube(0.5);
  REQUIRE(polycube.parameterize(body.complex.c3t3, body.complex.boundary_map()) == VMP::OK);
  REQUIRE(polycube.parameterize(body.soup.points, body.cells, targets) == VMP::OK);

  const auto np = params::energy_tolerance(0.01);
  const VMP::Parameterization_result of_complex = CGAL::stretch_minimizing_volume_parameterization(
    body.complex.c3t3, body.complex.uvw_map(), np.boundary_map(body.complex.boundary_map()));
  const VMP::Parameterization_result of_arrays
    = CGAL::stretch_minimizing_volume_parameterization(body.soup.points, body.cells, targets, images, np);
  REQUIRE(of_arrays.status == VMP::OK);
  CHECK(of_arrays.energy == of_complex.energy);
  CHECK(of_arrays.number_of_boundary_vertices == 98);
  CHECK(has_same_bits(images, in_order(body.complex.vertices, body.complex.uvw)));

  std::vector<Eigen::Vector3d> images_of_eigen;
  std::vector<Point_3> points_of_cgal;
  for(const std::array<double, 3>& p : body.soup.points)
    points_of_cgal.emplace_back(p[0], p[1], p[2]);
  CGAL::stretch_minimizing_volume_parameterization(points_of_cgal, body.soup.cells, targets, images_of_eigen, np);
  REQUIRE(images_of_eigen.size() == images.size());
  for(std::size_t v = 0; v < images.size(); ++v)
    CHECK(images_of_eigen[v] == Eigen::Vector3d(images[v].data()));

  const VMP::Distortion_3 distortion = VMP::measure_distortion(points_of_cgal, body.cells, images_of_eigen);
  CHECK(distortion.angle_max == VMP::measure_distortion(body.complex.c3t3, body.complex.uvw_map()).angle_max);
  CHECK(distortion.volume_mean == VMP::measure_distortion(body.complex.c3t3, body.complex.uvw_map()).volume_mean);
  CHECK(distortion.angle_max == Approx(of_arrays.distortion.angle_max));

  const VMP::Volume_map_3 map(points_of_cgal, body.cells, images_of_eigen),
    map_of_complex(body.complex.c3t3, body.complex.uvw_map());
  for(const Point_3& p : { Point_3(1, 1.5, 0.25), Point_3(3.3, 2.9, 0.1), Point_3(0, 0, 0) })
  {
    CHECK(map.image(p)->point == map_of_complex.image(p)->point);
    CHECK(map.image(p)->cell == map_of_complex.image(p)->cell);
  }

  PM::Hexahedron_soup_3 hexahedra, hexahedra_of_complex;
  REQUIRE(PM::make_hexahedral_mesh_3(points_of_cgal, body.cells, images, 0.5, hexahedra).status == VMP::OK);
  REQUIRE(PM::make_hexahedral_mesh_3(body.complex.c3t3, body.complex.uvw_map(), 0.5, hexahedra_of_complex).status == VMP::OK);
  CHECK(has_same_bits(hexahedra.points, hexahedra_of_complex.points));
  CHECK(hexahedra.cells == hexahedra_of_complex.cells);
}

TEST_CASE("A boundary parameterizer is an argument, and leads to the map of its targets")
{
  const auto check = [](const auto& parameterizer, const auto& np)
  {
    Both body(cube_mesh(4, 0.15));
    Points targets, expected, images;
    REQUIRE(parameterizer.parameterize(body.soup.points, body.cells, targets) == VMP::OK);
    const auto of_targets = CGAL::stretch_minimizing_volume_parameterization(
      body.soup.points, body.cells, targets, expected, params::refinement_mode(VMP::Refinement_mode::HELPFUL));
    REQUIRE(of_targets.status == VMP::OK);

    const VMP::Tetrahedron_soup_3 constant = body.soup;
    auto result = CGAL::stretch_minimizing_volume_parameterization(body.complex.c3t3, body.complex.uvw_map(), np);
    CHECK(result.energy == of_targets.energy);
    CHECK(result.boundary_distortion == of_targets.boundary_distortion);
    CHECK(result.seconds_boundary > 0);
    Points points = constant.points;
    Int_cells cells = cells_of(constant);
    CGAL::stretch_minimizing_volume_parameterization(points, cells, images, np);
    CHECK(has_same_bits(images, expected));
    CHECK(points.size() == expected.size());
    CGAL::stretch_minimizing_volume_parameterization(body.soup, images, np);
    CHECK(has_same_bits(images, expected));
    result = CGAL::stretch_minimizing_volume_parameterization(constant, images, np); // not refined
    CHECK(result.number_of_added_vertices == 0);
    CHECK(images.size() == constant.points.size());
  };
  check(VMP::Ball_boundary_parameterizer_3(), params::verbose(false));
  check(VMP::Cube_boundary_parameterizer_3(2, 1, 1), params::boundary_parameterizer(VMP::Cube_boundary_parameterizer_3(2, 1, 1)));
  check(Shrinking_parameterizer(), params::boundary_parameterizer(Shrinking_parameterizer()));
}

TEST_CASE("A boundary parameterizer may be for complexes only")
{
  Both body(cube_mesh(4, 0.15));
  Points expected;
  REQUIRE(CGAL::stretch_minimizing_volume_parameterization(
    body.soup, expected, params::boundary_parameterizer(Shrinking_parameterizer())).status == VMP::OK);
  REQUIRE(CGAL::stretch_minimizing_volume_parameterization(body.complex.c3t3, body.complex.uvw_map(),
    params::boundary_parameterizer(Shrinking_parameterizer_of_complexes())).status == VMP::OK);
  REQUIRE(expected.size() >= body.complex.vertices.size());
  expected.resize(body.complex.vertices.size()); // without those that refinement adds
  CHECK(has_same_bits(in_order(body.complex.vertices, body.complex.uvw), expected));
}

TEST_CASE("A boundary parameterizer that fails, or is interrupted, tells it in the result")
{
  Points images;
  const auto parameterize = [&](const Points& points, const Int_cells& cells, const auto& np)
  { return CGAL::stretch_minimizing_volume_parameterization(points, cells, images, np); };
  // two cells that share an edge
  const Points points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } };
  const auto pinched = parameterize(points, { { 0, 2, 3, 1 }, { 0, 4, 5, 1 } }, params::verbose(false));
  CHECK(pinched.status == VMP::ERROR_NON_MANIFOLD_BOUNDARY);
  CHECK(pinched.message.find("2 vertices") != std::string::npos);
  CHECK(!pinched.has_valid_map);

  const Bent_fan fan;
  const auto late = parameterize(fan.points, fan.cells, params::maximum_running_time(0).boundary_parameterizer(
    Shrinking_parameterizer()));
  CHECK(late.status == VMP::ERROR_INTERRUPTED);
  CHECK(images.empty());
}

TEST_CASE("The same points are inserted into arrays as into a complex")
{
  Both body(cube_mesh(3, 0.1));
  std::vector<VMP::Inserted_vertex_3<Vertex_handle> > of_complex;
  std::vector<VMP::Inserted_vertex_3<std::size_t> > of_arrays;
  Points points = body.soup.points;
  const std::size_t number_of_cells = body.cells.size();
  REQUIRE(VMP::make_parameterizable(body.complex.c3t3, params::output_iterator(std::back_inserter(of_complex))) > 0);
  REQUIRE(VMP::make_parameterizable(points, body.cells, params::output_iterator(std::back_inserter(of_arrays)))
          == of_complex.size());
  REQUIRE(points.size() == body.soup.points.size() + of_arrays.size());
  for(std::size_t i = 0; i < of_arrays.size(); ++i)
  {
    body.complex.vertices.push_back(of_complex[i].vertex);
    CHECK(of_arrays[i].vertex == body.soup.points.size() + i);
    const Point_3& p = of_complex[i].vertex->point();
    CHECK(points[of_arrays[i].vertex] == std::array<double, 3>{ p.x(), p.y(), p.z() });
    REQUIRE(of_arrays[i].simplex.size() == of_complex[i].simplex.size());
    for(std::size_t k = 0; k < of_arrays[i].simplex.size(); ++k)
      CHECK(body.complex.vertices[of_arrays[i].simplex[k]] == of_complex[i].simplex[k]);
  }
  CHECK(body.cells.size() == body.complex.c3t3.number_of_cells_in_complex());
  CHECK(body.cells.size() > number_of_cells);
  const auto& vertices = body.complex.vertices;
  for(const std::array<int, 4>& cell : body.cells)
  {
    Complex::Cell_handle c;
    CHECK(body.complex.c3t3.triangulation().is_cell(vertices[cell[0]], vertices[cell[1]], vertices[cell[2]],
                                                    vertices[cell[3]], c));
  }

  // targets: the identity makes only edges and facets within the sides of the cube degenerate
  Both with_targets(cube_mesh(3));
  VMP::Tetrahedron_soup_3 soup = with_targets.soup;
  const std::size_t number = VMP::make_parameterizable(
    with_targets.complex.c3t3, params::boundary_map(with_targets.complex.boundary_map()));
  const Points targets = soup.points;
  CHECK(VMP::make_parameterizable(soup, params::boundary_map(CGAL::make_property_map(targets))) == number);
  CHECK(soup.cells.size() == with_targets.complex.c3t3.number_of_cells_in_complex());
  CHECK(soup.cell_references == std::vector<int>(soup.cells.size(), 1));
}

TEST_CASE("Refinement during the search is the same, and appends to the arrays")
{
  const Bent_fan fan;
  Points points = fan.points, images;
  Int_cells cells = fan.cells;
  CHECK(CGAL::stretch_minimizing_volume_parameterization(fan.points, fan.cells, fan.targets, images).status != VMP::OK);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    points, cells, fan.targets, images, params::refinement_mode(VMP::Refinement_mode::HELPFUL));
  REQUIRE(result.status == VMP::OK);
  REQUIRE(result.number_of_added_vertices > 0);
  REQUIRE(points.size() == fan.points.size() + result.number_of_added_vertices);
  CHECK(std::equal(fan.points.begin(), fan.points.end(), points.begin()));
  CHECK(images.size() == points.size());
  CHECK(cells.size() == result.number_of_cells);
  CHECK(VMP::measure_distortion(points, cells, images).angle_max == Approx(result.distortion.angle_max));

  VMP::Tetrahedron_soup_3 soup = VMP::internal::soup_of(fan.points, fan.cells);
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    soup.cell_references[c] = static_cast<int>(c);
  soup.edges = { { 0, 4 } };
  soup.edge_references = { 1 };
  Complex_archetype c3t3;
  std::vector<Vertex_handle> vertices;
  VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3.model(), vertices);
  Complex::Point_map target, uvw;
  for(std::size_t v = 0; v + 1 < vertices.size(); ++v)
    target[vertices[v]] = Point_3(fan.targets[v][0], fan.targets[v][1], fan.targets[v][2]);
  const VMP::Parameterization_result of_complex = CGAL::stretch_minimizing_volume_parameterization(
    c3t3, VMP::make_vertex_point_map(uvw), params::boundary_map(VMP::make_vertex_point_map(target))
                                              .refinement_mode(VMP::Refinement_mode::HELPFUL));
  REQUIRE(of_complex.status == VMP::OK);
  CHECK(of_complex.energy == result.energy);
  CHECK(c3t3.model().number_of_edges_in_complex() == 1);
  CHECK(static_cast<std::size_t>(std::distance(c3t3.facets_in_complex_begin(), c3t3.facets_in_complex_end()))
        == c3t3.model().number_of_facets_in_complex());
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    CHECK(c3t3.surface_patch_index(c3t3.triangulation().mirror_facet(*f)) == c3t3.surface_patch_index(*f));
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    for(int i = 0; i < 4; ++i) // between the cells of the fan, which are subdomains, and on the boundary
      CHECK(c3t3.is_in_complex(c, i) == (c3t3.subdomain_index(c) != c3t3.subdomain_index(c->neighbor(i))));
  std::map<std::array<double, 3>, Point_3> image_of_point;
  for(const auto& [v, image] : uvw)
    image_of_point[{ v->point().x(), v->point().y(), v->point().z() }] = image;
  REQUIRE(image_of_point.size() == points.size());
  for(std::size_t v = 0; v < points.size(); ++v)
    CHECK(image_of_point.at(points[v]) == Point_3(images[v][0], images[v][1], images[v][2]));

  // A soup keeps its references: the volume of all parts of a cell is that of the cell.
  std::map<int, double> volume_of;
  const auto volume = [](const VMP::Tetrahedron_soup_3& s, const std::size_t c)
  {
    const auto p = [&](const int i) { return Eigen::Vector3d(s.points[s.cells[c][i]].data()); };
    return (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)) / 6;
  };
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    volume_of[soup.cell_references[c]] = volume(soup, c);
  Points images_of_soup;
  REQUIRE(CGAL::stretch_minimizing_volume_parameterization(soup, fan.targets, images_of_soup,
                                                           params::refinement_mode(VMP::Refinement_mode::HELPFUL)).status
          == VMP::OK);
  CHECK(has_same_bits(images_of_soup, images));
  CHECK(soup.points == points);
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    volume_of.at(soup.cell_references[c]) -= volume(soup, c);
  for(const auto& [reference, rest] : volume_of)
    CHECK(std::abs(rest) < 1e-12);
}

TEST_CASE("Bad arrays are refused, and change nothing")
{
  const Bent_fan fan;
  Points targets, images = fan.targets;
  Int_cells cells = fan.cells;
  cells[0][1] = 1000;
  CHECK_THROWS_AS(VMP::Ball_boundary_parameterizer_3().parameterize(fan.points, cells, targets), VMP::Input_error);
  CHECK_THROWS_AS(VMP::measure_distortion(fan.points, cells, fan.targets), VMP::Input_error);
  Points points = fan.points;
  CHECK_THROWS_AS(VMP::make_parameterizable(points, cells), VMP::Input_error);
  CHECK_THROWS_AS(CGAL::stretch_minimizing_volume_parameterization(fan.points, cells, fan.targets, images),
                  VMP::Input_error);
  CHECK_THROWS_AS(CGAL::stretch_minimizing_volume_parameterization(fan.points, fan.cells, Points(), images),
                  CGAL::Precondition_exception);
  CHECK(images == fan.targets);

  VMP::Tetrahedron_soup_3 apart; // single cells, more than one thread gets at a time
  for(std::size_t i = 0; i < 4000; ++i)
  {
    const double x = 2. * static_cast<double>(i);
    apart.points.insert(apart.points.end(), { {x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1} });
    apart.cells.push_back({ 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3 });
  }
  apart.cells.insert(apart.cells.end(), { apart.cells[3000], apart.cells[2000] });
  apart.cell_references.resize(apart.cells.size());
  const auto first_fault = Catch::Matchers::Contains("cell 2000 and cell 4001 overlap");
  CHECK_THROWS_WITH(CGAL::stretch_minimizing_volume_parameterization(apart, apart.points, images), first_fault);
  CHECK_THROWS_WITH(CGAL::stretch_minimizing_volume_parameterization<CGAL::Parallel_if_available_tag>(
                      apart, apart.points, images), first_fault);
  CHECK(VMP::Ball_boundary_parameterizer_3().parameterize(Points(), Int_cells(), targets) == VMP::ERROR_EMPTY_COMPLEX);
  CHECK(VMP::boundary_vertices(fan.points, fan.cells).size() == 28);
  CHECK(VMP::non_manifold_boundary_vertices(fan.points, fan.cells).empty());
}

TEST_CASE("Matrices of Eigen, with a row for each point and cell, are mapped as other arrays are")
{
  const Bent_fan fan;
  Eigen::MatrixXd V(fan.points.size(), 3), T(fan.targets.size(), 3);
  Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor> C(fan.cells.size(), 4);
  for(std::size_t v = 0; v < fan.points.size(); ++v)
  {
    V.row(v) = Eigen::RowVector3d(fan.points[v].data());
    T.row(v) = Eigen::RowVector3d(fan.targets[v].data());
  }
  for(std::size_t c = 0; c < fan.cells.size(); ++c)
    C.row(c) = Eigen::RowVector4i(fan.cells[c].data());
  const auto rows = [](const Eigen::MatrixXd& M)
  {
    Points result;
    for(Eigen::Index v = 0; v < M.rows(); ++v)
      result.push_back({ M(v, 0), M(v, 1), M(v, 2) });
    return result;
  };

  Points points = fan.points, images;
  Int_cells cells = fan.cells;
  Eigen::MatrixXd U;
  const auto np = params::refinement_mode(VMP::Refinement_mode::HELPFUL).number_of_iterations(20);
  const auto of_arrays = CGAL::stretch_minimizing_volume_parameterization(points, cells, fan.targets, images, np);
  const auto of_matrices = CGAL::stretch_minimizing_volume_parameterization(V, C, T, U, np);
  REQUIRE(of_arrays.number_of_added_vertices > 0);
  CHECK(of_matrices.energy == of_arrays.energy);
  CHECK(has_same_bits(rows(U), images));
  CHECK(has_same_bits(rows(V), points));
  REQUIRE(C.rows() == static_cast<Eigen::Index>(cells.size()));
  for(std::size_t c = 0; c < cells.size(); ++c)
    CHECK(C.row(c) == Eigen::RowVector4i(cells[c].data()));

  Points targets;
  Eigen::MatrixXd targets_of_matrices;
  REQUIRE(VMP::Ball_boundary_parameterizer_3().parameterize(points, cells, targets) == VMP::OK);
  REQUIRE(VMP::Ball_boundary_parameterizer_3().parameterize(V, C, targets_of_matrices) == VMP::OK);
  CHECK(has_same_bits(rows(targets_of_matrices), targets));
  CHECK(VMP::measure_distortion(V, C, U).angle_max == VMP::measure_distortion(points, cells, images).angle_max);
  CHECK(VMP::Volume_map_3(V, C, U).image(Point_3(0.5, 0.4, 3))->point
        == VMP::Volume_map_3(points, cells, images).image(Point_3(0.5, 0.4, 3))->point);

  const Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(5, 4);
  CHECK_THROWS_AS(VMP::boundary_vertices(wide, C), CGAL::Precondition_exception);
  CHECK_THROWS_AS(VMP::boundary_vertices(V, wide.leftCols(3)), CGAL::Precondition_exception);
}

TEST_CASE("The quality of cells has closed forms, and that of the image is part of the result")
{
  const Points regular = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
  const VMP::Cell_quality_3 best = VMP::measure_quality(regular, Int_cells{ { 0, 2, 1, 3 } });
  CHECK(best.minimum_dihedral_angle == Approx(70.528779365509));
  CHECK(best.maximum_dihedral_angle == Approx(70.528779365509));
  CHECK(best.minimum_scaled_jacobian == Approx(1));
  CHECK(best.maximum_aspect_ratio == Approx(1));

  const Points corner = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const VMP::Cell_quality_3 quality = VMP::measure_quality(corner, Int_cells{ { 0, 1, 2, 3 } });
  CHECK(quality.minimum_dihedral_angle == Approx(54.735610317245));
  CHECK(quality.maximum_dihedral_angle == Approx(90));
  CHECK(quality.minimum_scaled_jacobian == Approx(std::sqrt(0.5)));
  const double radius = 0.5 / (1.5 + std::sqrt(3.) / 2);
  CHECK(quality.maximum_aspect_ratio == Approx(std::sqrt(2.) / (2 * std::sqrt(6.) * radius)));
  CHECK(VMP::measure_quality(corner, Int_cells{ { 0, 2, 1, 3 } }).minimum_scaled_jacobian == Approx(-std::sqrt(2.)));
  CHECK(std::isnan(VMP::measure_quality(corner, Int_cells()).maximum_aspect_ratio));

  const Bent_fan fan;
  Points images;
  const auto result = CGAL::stretch_minimizing_volume_parameterization(
    fan.points, fan.cells, fan.points, images, params::number_of_iterations(0));
  const VMP::Cell_quality_3 of_image = VMP::measure_quality(images, fan.cells);
  CHECK(result.quality.minimum_scaled_jacobian == Approx(of_image.minimum_scaled_jacobian));
  CHECK(result.quality.minimum_dihedral_angle == Approx(of_image.minimum_dihedral_angle));
  CHECK(result.quality.maximum_dihedral_angle == Approx(of_image.maximum_dihedral_angle));
  CHECK(result.quality.maximum_aspect_ratio == Approx(of_image.maximum_aspect_ratio));
}
