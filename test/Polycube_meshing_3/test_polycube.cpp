// Boundaries mapped to polycubes: those that are one already, bent ones, and bodies without a polycube close to them.
#include "Visitor_that_ends.h"
#include "bricks.h"

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/repair_tetrahedron_soup.h>

#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace {

template <typename IsSolid>
void check_identity(const IsSolid& is_solid, const Brick& size = ::size)
{
  Labelled_complex complex(bricks(size, is_solid, in_place));
  REQUIRE(complex.parameterize() == VMP::OK);
  double largest = 0;
  for(const auto& entry : complex.image)
    largest = (std::max)(largest, CGAL::squared_distance(entry.first->point(), entry.second));
  CHECK(largest < 1e-24);
  for(const Facet& f : complex.boundary())
    CHECK(direction(complex.image_triangle(f)) == direction(complex.source_triangle(f)));
}

template <typename IsSolid>
void check_bent(const IsSolid& is_solid, const std::size_t number_of_coordinates)
{
  const Labelled_complex straight(bricks(size, is_solid, in_place));
  Labelled_complex complex(bricks(size, is_solid, bend));
  copy_labels(straight, complex);
  REQUIRE(complex.parameterize_with_labels() == VMP::OK);
  std::set<std::pair<std::size_t, double> > coordinates;
  double volume = 0;
  for(const Facet& f : complex.boundary())
  {
    const std::array<Point_3, 3> t = complex.image_triangle(f);
    REQUIRE(direction(t) == complex.labels.at(f));
    coordinates.emplace(direction(t) / 2, t[0][static_cast<int>(direction(t) / 2)]);
    volume += CGAL::determinant(t[0] - CGAL::ORIGIN, t[1] - CGAL::ORIGIN, t[2] - CGAL::ORIGIN) / 6;
  }
  CHECK(coordinates.size() == number_of_coordinates);
  double volume_of_source = 0;
  for(const Cell_handle c : complex.cells)
    volume_of_source += complex.c3t3.triangulation().tetrahedron(c).volume();
  CHECK(volume == Approx(volume_of_source).epsilon(0.3));
}

} // namespace

TEST_CASE("polycubes are mapped to themselves")
{
  check_identity(is_box, {1, 1, 1});
  check_identity(is_box);
  check_identity(is_bracket);
  check_identity(is_ring);
  check_identity(is_stair);
}

TEST_CASE("bent polycubes are straightened, with one coordinate for each chart")
{
  check_bent(is_box, 6);
  check_bent(is_bracket, 8);
  check_bent(is_ring, 10);
  check_bent(is_stair, 11);
}

// The coordinates of faces, in units of the spacing; those that are no multiples, bit by bit, are lost.
std::set<std::pair<std::size_t, double> > multiples_of_faces(Labelled_complex& complex, const double spacing)
{
  REQUIRE(complex.parameterize_with_labels(spacing) == VMP::OK);
  std::set<std::pair<std::size_t, double> > result;
  for(const Facet& f : complex.boundary())
  {
    const std::array<Point_3, 3> t = complex.image_triangle(f);
    REQUIRE(direction(t) == complex.labels.at(f));
    const double x = t[0][static_cast<int>(direction(t) / 2)];
    REQUIRE(x == spacing * std::round(x / spacing));
    result.emplace(direction(t) / 2, std::round(x / spacing));
  }
  return result;
}

template <typename IsSolid>
std::set<std::pair<std::size_t, double> > multiples_of_bent(const IsSolid& is_solid, const double spacing)
{
  const Labelled_complex straight(bricks(size, is_solid, in_place));
  Labelled_complex complex(bricks(size, is_solid, bend));
  copy_labels(straight, complex);
  return multiples_of_faces(complex, spacing);
}

TEST_CASE("faces of a polycube get multiples of a spacing")
{
  CHECK(multiples_of_bent(is_stair, 0.1).size() == 11);
  CHECK(multiples_of_bent(is_ring, 0.3).size() == 10);
  CHECK(multiples_of_bent(is_ring, 1).size() == 10);
  CHECK(multiples_of_bent(is_bracket, 1.7).size() == 8);
  CHECK(multiples_of_bent(is_ring, 50).size() == 10); // no edge is lost, although the body is smaller
}

TEST_CASE("faces that face each other stay apart at multiples of any spacing")
{
  // two columns in the middle face each other across a gap of 1
  Labelled_complex complex(bricks({4, 3, 7}, [](const int x, const int y, const int z)
  {
    return x == 0 || z < 2 || z >= 5 || (x == 2 && y == 1 && z != 3);
  }, in_place));
  CHECK(complex.parameterize(1) == VMP::OK);
  CHECK(complex.parameterize() == VMP::OK);
  copy_labels(complex, complex);
  for(const double spacing : { 1., 2., 10. })
    CHECK(multiples_of_faces(complex, spacing).size() == 15); // 5 along x, 4 along y, 6 along z
  CHECK(complex.parameterize(1e200) == VMP::ERROR_SPACING_TOO_COARSE);
  CHECK_THROWS_AS(complex.parameterize(-1), CGAL::Precondition_exception);
}

TEST_CASE("faces of bodies that are moved aside get multiples of the spacing, bit by bit")
{
  // a channel, a box in it that would touch it, and a box beside it
  const double first = GENERATE(0., 0.3, 0.6, 0.9, 1.2, 1.5), spacing = 0.3; // as wide as the channel
  Labelled_complex complex(bricks({14, 10, 7}, [](const int x, const int y, const int z)
  {
    return (x < 7 && y < 3 && (x < 2 || x > 4 || z < 2)) || (x == 3 && y == 1 && (z == 4 || z == 5))
        || (x > 9 && y > 7 && z < 2);
  }, [&](const double x, const double y, const double z)
  { return std::array<double, 3>{ first + 0.1 * x - 0.45, 0.1 * y + 12.7, 0.1 * z + 1. / 3 }; }));
  const auto np = CGAL::parameters::maximum_running_time(1e9);
  REQUIRE(Polycube(spacing).parameterize(complex.c3t3, boost::make_assoc_property_map(complex.image), np) == VMP::OK);
  for(const Facet& f : complex.boundary())
  {
    const std::array<Point_3, 3> t = complex.image_triangle(f);
    REQUIRE(direction(t) < 6);
    const double x = t[0][static_cast<int>(direction(t) / 2)];
    CHECK(x == spacing * std::round(x / spacing));
  }
}

TEST_CASE("bodies side by side have faces in the same planes, bit by bit")
{
  const double scale = GENERATE(0.1, 0.3, 0.7);
  Labelled_complex complex(bricks({7, 5, 6}, [](const int x, const int y, const int z)
  {
    return x < 3 || (x > 3 && y < 3 && z < 4);
  }, [&](const double x, const double y, const double z) { return in_place(scale * x, scale * y, scale * z); }));
  REQUIRE(complex.parameterize() == VMP::OK);
  CHECK(faces_of_image(complex).size() == 10); // two of twelve are in planes of other ones
}

TEST_CASE("a groove far below the spacing keeps its faces")
{
  // two blocks and a plate between them, which is inset by 0.02
  const auto coordinate = [](const double x) { return x < 1 ? 0.02 * x : x > 5 ? 4.02 + 0.02 * (x - 5) : x - 0.98; };
  Labelled_complex complex(bricks({6, 6, 7}, [](const int x, const int y, const int z)
  {
    return z != 3 || (x > 0 && x < 5 && y > 0 && y < 5);
  }, [&](const double x, const double y, const double z) { return in_place(coordinate(x), coordinate(y), z); }));
  for(const double spacing : { 0.5, 0.05, 0. })
  {
    CAPTURE(spacing);
    REQUIRE(complex.parameterize(spacing) == VMP::OK);
    CHECK(faces_of_image(complex).size() == 12);
  }
}

TEST_CASE("a thin plate keeps its faces")
{
  Labelled_complex complex(bricks({6, 6, 2}, is_box,
                                  [](const double x, const double y, const double z) { return in_place(x, y, 0.02 * z); }));
  REQUIRE(complex.parameterize(0.5) == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
}

TEST_CASE("a ramp does not join the faces at its ends")
{
  // a low and a high plane, which a ramp joins beside a trench
  VMP::Tetrahedron_soup_3 soup = bricks({8, 5, 7}, [](const int x, const int y, const int z)
  {
    return z < 1 || x == 7 || (y < 2 && x >= 1) || (y >= 3 && x >= 4);
  }, [](const double x, const double y, const double z)
  {
    return in_place(x, y, z >= 1 && y <= 2 && x >= 1 && x <= 7 ? 1 + (z - 1) * (x - 1) / 6 : z);
  });
  VMP::merge_coinciding_points(soup);
  const auto is_flat = [](std::array<std::size_t, 4> cell)
  {
    std::sort(cell.begin(), cell.end());
    return std::adjacent_find(cell.begin(), cell.end()) != cell.end();
  };
  soup.cells.erase(std::remove_if(soup.cells.begin(), soup.cells.end(), is_flat), soup.cells.end());
  soup.cell_references.resize(soup.cells.size());
  Labelled_complex complex(soup);
  REQUIRE(complex.parameterize() == VMP::OK);
  double volume = 0, volume_of_source = 0;
  for(const Facet& f : complex.boundary())
  {
    const std::array<Point_3, 3> t = complex.image_triangle(f);
    volume += CGAL::determinant(t[0] - CGAL::ORIGIN, t[1] - CGAL::ORIGIN, t[2] - CGAL::ORIGIN) / 6;
  }
  for(const Cell_handle c : complex.cells)
    volume_of_source += complex.c3t3.triangulation().tetrahedron(c).volume();
  CHECK(volume < 2.2 * volume_of_source); // the box with one upper face has 2.8 times the volume
}

namespace {

// Two arms of a fork turn three times around each other, so that no labels of its charts are valid.
VMP::Tetrahedron_soup_3 twisted_fork()
{
  return bricks({4, 3, 16}, [](const int x, int, const int z) { return z < 2 || x == 0 || x == 3; },
    [](const double x, const double y, const double z) -> std::array<double, 3>
  {
    const double angle = 1.4 * (std::max)(0., z - 2), c = std::cos(angle), s = std::sin(angle);
    return {c * (x - 2) - s * (y - 1.5), s * (x - 2) + c * (y - 1.5), z};
  });
}

} // namespace

TEST_CASE("a topological sphere that has no other polycube is mapped to its bounding box")
{
  Labelled_complex complex(twisted_fork());
  CHECK(complex.parameterize() == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
  complex.image.clear();
  CHECK(complex.parameterize(0.5) == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
}

TEST_CASE("of several polycubes, the cheapest one is taken, and the costs of all are told")
{
  // a bar that is twisted by a half turn: the sides of a box follow the bar, but the lines of labels follow more of its edges
  const VMP::Tetrahedron_soup_3 soup = bricks({3, 3, 12}, is_box,
    [](const double x, const double y, const double z) -> std::array<double, 3>
  {
    const double angle = CGAL_PI / 12 * z, c = std::cos(angle), s = std::sin(angle);
    return {c * (x - 1.5) - s * (y - 1.5), s * (x - 1.5) + c * (y - 1.5), z};
  });
  PM::Polycube_result result;
  std::vector<std::array<double, 3> > targets;
  REQUIRE(Polycube(0, PM::Polycube_axes::GIVEN, &result).parameterize(soup, targets) == VMP::OK);
  REQUIRE(result.candidates.size() == 2);
  CHECK(result.candidates[0].strategy == "labels");
  CHECK(result.candidates[1].strategy == "bounding box");
  CHECK(result.candidates[0].cost < result.candidates[1].cost);
  CHECK(result.strategy == "labels");
}

TEST_CASE("the part of sharp edges that a polycube gives up is a part of their length, also where they are split")
{
  VMP::internal::Numbered_surface_3 surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {1, 3, 0}};
  surface.sharp_edges = {{0, 1}, {1, 2}};
  PM::internal::Surface_map_3 map = {VMP::OK, surface.points, 0.25};
  CHECK(PM::internal::part_given_up_3(surface, map) == 0);
  map.images[0] = {0.5, 0.5, 0}; // the edge of length 1 leads along no axis
  CHECK(PM::internal::part_given_up_3(surface, map) == Approx(0.25));
  map.splits = {{2, 1}};
  map.images.push_back({1.5, 1, 0.5}); // neither half of the other edge does
  CHECK(PM::internal::part_given_up_3(surface, map) == Approx(1));
  map.images[3] = {1, 1, 0};
  CHECK(PM::internal::part_given_up_3(surface, map) == Approx(0.25));
}

TEST_CASE("bodies whose polycubes would touch are mapped side by side")
{
  VMP::Tetrahedron_soup_3 soup = twisted_fork();
  const std::size_t number_of_points = soup.points.size(), number_of_cells = soup.cells.size();
  for(std::size_t v = 0; v < number_of_points; ++v) // a second fork, whose bounding box meets that of the first one
    soup.points.push_back({ soup.points[v][0] + 2, soup.points[v][1] + 1, soup.points[v][2] + 0.5 });
  for(std::size_t c = 0; c < number_of_cells; ++c)
  {
    std::array<std::size_t, 4> cell = soup.cells[c];
    for(std::size_t& v : cell)
      v += number_of_points;
    soup.cells.push_back(cell);
    soup.cell_references.push_back(1);
  }
  std::vector<std::array<double, 3> > targets;
  REQUIRE(Polycube().parameterize(soup.points, soup.cells, targets) == VMP::OK);
  double right = -(std::numeric_limits<double>::infinity)(), left = (std::numeric_limits<double>::infinity)();
  for(const std::size_t v : VMP::boundary_vertices(soup.points, soup.cells))
    if(v < number_of_points)
      right = (std::max)(right, targets[v][0]);
    else
      left = (std::min)(left, targets[v][0]);
  CHECK(left > right);
}

TEST_CASE("a body with a cavity and without a polycube is told to have several boundary components")
{
  // a tetrahedron without a smaller one inside
  VMP::Tetrahedron_soup_3 soup;
  for(const double size : {10., 1.})
    for(const std::array<double, 3>& p : {std::array<double, 3>{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
      soup.points.push_back({size * p[0], size * p[1], size * p[2]});
  for(const auto& [a, b, c] : {std::array<std::size_t, 3>{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}})
  {
    soup.cells.push_back({a, b, c, c + 4});
    soup.cells.push_back({a, b, b + 4, c + 4});
    soup.cells.push_back({a, a + 4, b + 4, c + 4});
  }
  soup.cell_references.assign(soup.cells.size(), 1);
  VMP::orient_tetrahedron_soup(soup);
  std::vector<std::array<double, 3> > targets;
  CHECK(Polycube().parameterize(soup, targets) == VMP::ERROR_SEVERAL_BOUNDARY_COMPONENTS);
}

TEST_CASE("labels that are found are told, and lead to the same labels again")
{
  const VMP::Tetrahedron_soup_3 soup = bricks(size, is_ring, in_place);
  PM::Polycube_result result;
  const Polycube polycube(0, PM::Polycube_axes::GIVEN, &result);
  std::vector<std::array<double, 3> > targets;
  REQUIRE(polycube.parameterize(soup, targets) == VMP::OK);
  REQUIRE(result.labels.size() == soup.cells.size());
  std::size_t number = 0;
  std::set<std::size_t> all;
  for(const std::size_t side : VMP::internal::body_of(soup).sides)
  {
    const std::array<std::size_t, 4>& cell = soup.cells[side / 4];
    const auto point = [&](const auto& points, const std::size_t k)
    {
      const auto& [x, y, z] = points[cell[(side % 4 + k) % 4]];
      return Point_3(x, y, z);
    };
    std::array<Point_3, 3> t = {point(targets, 1), point(targets, 2), point(targets, 3)};
    if(CGAL::orientation(point(soup.points, 1), point(soup.points, 2), point(soup.points, 3), point(soup.points, 0))
       == CGAL::POSITIVE)
      std::swap(t[0], t[1]); // counterclockwise seen from outside
    CHECK(result.labels[side / 4][side % 4] == direction(t));
    all.insert(result.labels[side / 4][side % 4]);
    ++number;
  }
  CHECK(all == std::set<std::size_t>{0, 1, 2, 3, 4, 5});
  const auto labels = result.labels;
  for(const auto& of_cell : labels)
    number += std::count(of_cell.begin(), of_cell.end(), PM::Polycube_result::no_label);
  CHECK(number == 4 * labels.size());
  REQUIRE(polycube.parameterize(soup.points, soup.cells, labels, targets) == VMP::OK);
  CHECK(result.labels == labels);
}

TEST_CASE("a facet between two lines of the same edge is named")
{
  Labelled_complex complex(bricks(size, is_box, in_place));
  copy_labels(complex, complex);
  for(const Facet& f : complex.boundary()) // one with two vertices on the edge
  {
    const std::array<Point_3, 3> t = complex.source_triangle(f);
    const Point_3 p = CGAL::centroid(t[0], t[1], t[2]);
    if(complex.labels[f] == 0 && std::abs(p.y() - 2.5) < 0.5 && p.z() > 6.5)
      complex.labels[f] = 4;
  }
  CHECK(complex.parameterize_with_labels() == VMP::ERROR_BOUNDARY_TOO_COARSE);
  CHECK(complex.image.empty());
}

TEST_CASE("a boundary with fewer vertices than a box has corners is too coarse")
{
  Labelled_complex tetrahedron({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { 0, 1, 2, 3 } }, { 1 }, {}, {} });
  CHECK(tetrahedron.parameterize() == VMP::ERROR_BOUNDARY_TOO_COARSE);
  CHECK(tetrahedron.image.empty());
}

TEST_CASE("boundaries without a polycube are named")
{
  Labelled_complex broken(bricks(size, is_box, in_place));
  broken.vertices.front()->set_point(Point_3((std::numeric_limits<double>::infinity)(), 0, 0));
  CHECK(broken.parameterize() == VMP::ERROR_NON_FINITE_COORDINATE);

  Labelled_complex kissing(bricks({2, 2, 1}, [](const int x, const int y, int) { return x == y; }, in_place));
  CHECK(kissing.parameterize() == VMP::ERROR_NON_MANIFOLD_BOUNDARY);

  const C3t3 empty;
  std::unordered_map<Vertex_handle, Point_3> image;
  CHECK(Polycube().parameterize(empty, boost::make_assoc_property_map(image)) == VMP::ERROR_EMPTY_COMPLEX);
}

TEST_CASE("maps to polycubes can be ended anywhere, with nothing written")
{
  Labelled_complex complex(bricks(size, is_stair, bend));
  const auto target = boost::make_assoc_property_map(complex.image);
  check_interruption([&](const auto& np) { return Polycube().parameterize(complex.c3t3, target, np); }, complex.image);
  check_interruption([&](const auto& np) { return Polycube(0.5).parameterize(complex.c3t3, target, np); }, complex.image);

  copy_labels(Labelled_complex(bricks(size, is_stair, in_place)), complex);
  const auto labels = boost::make_assoc_property_map(complex.labels);
  check_interruption([&](const auto& np) { return Polycube().parameterize(complex.c3t3, labels, target, np); },
                     complex.image);
}
