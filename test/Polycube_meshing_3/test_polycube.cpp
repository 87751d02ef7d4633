// Boundaries mapped to polycubes: those that are one already, bent ones, and labels that no polycube has. Boundaries
// mapped to given surfaces.
#include "Visitor_that_ends.h"
#include "catch.h"
#include "ring_of_prisms.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/map_to_voxels_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/repair_labels_3.h>
#include <CGAL/Volume_mesh_parameterization/Surface_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Refinement_3.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/repair_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Vector_3 = K::Vector_3;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;
using Cell_handle = C3t3::Cell_handle;
using Facet = C3t3::Facet;
using Brick = std::array<int, 3>;
using Polycube = PM::Polycube_boundary_parameterizer_3;

namespace {

// The unit bricks in a box for which `is_solid` is true, of six cells each, moved by `move`.
template <typename IsSolid, typename Move>
VMP::Tetrahedron_soup_3 bricks(const Brick& size, const IsSolid& is_solid, const Move& move)
{
  VMP::Tetrahedron_soup_3 soup;
  std::map<Brick, std::size_t> index;
  for(int z = 0; z < size[2]; ++z)
    for(int y = 0; y < size[1]; ++y)
      for(int x = 0; x < size[0]; ++x)
        for(int k = 0; k < 6 && is_solid(x, y, z); ++k)
        {
          Brick p = {x, y, z};
          std::array<std::size_t, 4> cell;
          for(int i = 0; i < 4; ++i)
          {
            const auto inserted = index.emplace(p, soup.points.size());
            if(inserted.second)
              soup.points.push_back(move(p[0], p[1], p[2]));
            cell[i] = inserted.first->second;
            ++p[(k + i * (k < 3 ? 1 : 2)) % 3];
          }
          if(k >= 3)
            std::swap(cell[1], cell[2]);
          soup.cells.push_back(cell);
          soup.cell_references.push_back(1);
        }
  return soup;
}

std::array<double, 3> in_place(const double x, const double y, const double z)
{
  return {x, y, z};
}

std::array<double, 3> bend(const double x, const double y, const double z)
{
  const double angle = 0.08 * z;
  return {x + 0.3 * std::sin(y), std::cos(angle) * y - std::sin(angle) * (z + 6),
          std::sin(angle) * y + std::cos(angle) * (z + 6)};
}

const Brick size = {6, 5, 7};

bool is_box(int, int, int) { return true; }
bool is_bracket(const int x, int, const int z) { return x < 2 || z < 3; }
bool is_ring(const int x, int, const int z) { return x < 2 || x > 3 || z < 2 || z > 4; }
bool is_stair(const int x, const int y, const int z) { return z < 2 || (z < 4 && x < 4 && y < 3) || (x < 2 && y < 3); }

struct Labelled_complex
{
  C3t3 c3t3;
  std::vector<Vertex_handle> vertices;
  std::vector<Cell_handle> cells;
  std::unordered_map<Vertex_handle, Point_3> image;
  std::map<Facet, std::size_t> labels;

  explicit Labelled_complex(const VMP::Tetrahedron_soup_3& soup)
  {
    VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
  }

  Labelled_complex(const Labelled_complex&) = delete;

  VMP::Error_code parameterize(const double spacing = 0)
  {
    image.clear();
    return Polycube(spacing).parameterize(c3t3, boost::make_assoc_property_map(image));
  }

  VMP::Error_code parameterize_with_labels(const double spacing = 0)
  {
    image.clear();
    return Polycube(spacing).parameterize(c3t3, boost::make_assoc_property_map(labels),
                                          boost::make_assoc_property_map(image));
  }

  std::vector<Facet> boundary() const
  {
    std::vector<Facet> result;
    for(const Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        if(!c3t3.is_in_complex(c->neighbor(i)))
          result.emplace_back(c, i);
    return result;
  }

  // Counterclockwise as seen from outside.
  static std::array<Vertex_handle, 3> vertices_of(const Facet& f)
  {
    std::array<Vertex_handle, 3> result;
    for(int k = 0; k < 3; ++k)
      result[k] = f.first->vertex((f.second + 1 + k) % 4);
    if(f.second % 2 == 1)
      std::swap(result[0], result[1]);
    return result;
  }

  template <typename Point>
  static std::array<Point_3, 3> triangle(const Facet& f, const Point& point)
  {
    const std::array<Vertex_handle, 3> v = vertices_of(f);
    return { point(v[0]), point(v[1]), point(v[2]) };
  }

  std::array<Point_3, 3> source_triangle(const Facet& f) const
  {
    return triangle(f, [](const Vertex_handle v) { return v->point(); });
  }

  std::array<Point_3, 3> image_triangle(const Facet& f) const
  {
    return triangle(f, [this](const Vertex_handle v) { return image.at(v); });
  }
};

// The direction to which a triangle normal to an axis turns its front, by exact predicates; 6 if it is not normal
// to an axis or flat.
std::size_t direction(const std::array<Point_3, 3>& t)
{
  for(int axis = 0; axis < 3; ++axis)
    if(t[0][axis] == t[1][axis] && t[0][axis] == t[2][axis])
    {
      std::array<double, 3> above = { t[0].x(), t[0].y(), t[0].z() };
      above[axis] = std::nextafter(above[axis], (std::numeric_limits<double>::infinity)());
      switch(CGAL::orientation(t[0], t[1], t[2], Point_3(above[0], above[1], above[2])))
      {
        case CGAL::POSITIVE: return 2 * axis;
        case CGAL::NEGATIVE: return 2 * axis + 1;
        default: return 6;
      }
    }
  return 6;
}

// Labels a complex like one with the same cells whose facets are normal to the axes.
void copy_labels(const Labelled_complex& straight, Labelled_complex& complex)
{
  const std::vector<Facet> from = straight.boundary(), to = complex.boundary();
  for(std::size_t i = 0; i < from.size(); ++i)
    complex.labels[to[i]] = direction(straight.source_triangle(from[i]));
}

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
template <typename IsSolid>
std::set<std::pair<std::size_t, double> > multiples_of_bent(const IsSolid& is_solid, const double spacing)
{
  const Labelled_complex straight(bricks(size, is_solid, in_place));
  Labelled_complex complex(bricks(size, is_solid, bend));
  copy_labels(straight, complex);
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

TEST_CASE("faces of a polycube get multiples of a spacing")
{
  CHECK(multiples_of_bent(is_stair, 0.1).size() == 11);
  CHECK(multiples_of_bent(is_ring, 0.3).size() == 10);
  CHECK(multiples_of_bent(is_ring, 1).size() == 10);
  CHECK(multiples_of_bent(is_bracket, 1.7).size() == 8);
  CHECK(multiples_of_bent(is_ring, 50).size() == 10); // no edge is lost, although the body is smaller
}

TEST_CASE("a spacing that makes a polycube touch itself is named")
{
  // two columns in the middle face each other across a gap of 1
  Labelled_complex complex(bricks({4, 3, 7}, [](const int x, const int y, const int z)
  {
    return x == 0 || z < 2 || z >= 5 || (x == 2 && y == 1 && z != 3);
  }, in_place));
  CHECK(complex.parameterize(1) == VMP::OK);
  CHECK(complex.parameterize() == VMP::OK);
  copy_labels(complex, complex);
  CHECK(complex.parameterize_with_labels(2) == VMP::ERROR_SPACING_TOO_COARSE);
  CHECK(complex.image.empty());
  CHECK(complex.parameterize_with_labels(1) == VMP::OK); // smaller, as the message says
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

// Returns the faces by direction and coordinate. Each triangle of the image is normal to an axis.
std::set<std::pair<std::size_t, double> > faces_of_image(const Labelled_complex& complex)
{
  std::set<std::pair<std::size_t, double> > faces;
  for(const Facet& f : complex.boundary())
  {
    const std::array<Point_3, 3> t = complex.image_triangle(f);
    REQUIRE(direction(t) < 6);
    faces.emplace(direction(t), t[0][static_cast<int>(direction(t) / 2)]);
  }
  return faces;
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

TEST_CASE("a groove far below the spacing is flattened")
{
  // two blocks and a plate between them, which is inset by 0.02
  const auto coordinate = [](const double x) { return x < 1 ? 0.02 * x : x > 5 ? 4.02 + 0.02 * (x - 5) : x - 0.98; };
  Labelled_complex complex(bricks({6, 6, 7}, [](const int x, const int y, const int z)
  {
    return z != 3 || (x > 0 && x < 5 && y > 0 && y < 5);
  }, [&](const double x, const double y, const double z) { return in_place(coordinate(x), coordinate(y), z); }));
  REQUIRE(complex.parameterize(0.5) == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
  REQUIRE(complex.parameterize(0.05) == VMP::OK); // the groove is deeper than a part of the spacing
  CHECK(faces_of_image(complex).size() == 12);
  REQUIRE(complex.parameterize() == VMP::OK);
  CHECK(faces_of_image(complex).size() == 12);
}

TEST_CASE("a thin plate is no groove")
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
VMP::Tetrahedron_soup_3 fork()
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
  Labelled_complex complex(fork());
  CHECK(complex.parameterize() == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
  complex.image.clear();
  CHECK(complex.parameterize(0.5) == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
}

TEST_CASE("bodies whose polycubes would touch are mapped side by side")
{
  VMP::Tetrahedron_soup_3 soup = fork();
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

} // namespace

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

TEST_CASE("a ring whose labels have no polycube is refined for one of voxels")
{
  const VMP::Tetrahedron_soup_3 ring = ring_of_prisms();
  std::vector<std::array<double, 3> > targets;
  REQUIRE(Polycube().parameterize(ring, targets) == VMP::ERROR_NO_POLYCUBE);
  const double spacing = GENERATE(0., 0.25);
  VMP::internal::Body_3 body = VMP::internal::body_of(ring);
  std::vector<VMP::internal::Mapped_boundary_3> boundaries;
  REQUIRE(Polycube(spacing).find_boundaries(body, true, VMP::internal::Budget(), boundaries) == VMP::OK);
  REQUIRE(boundaries.size() == 1); // there is no other
  const auto inserted = VMP::internal::split_any_edges_3(body, boundaries[0].splits);
  REQUIRE(inserted);
  VMP::Tetrahedron_soup_3 soup = ring;
  VMP::internal::insert_points(body, *inserted, soup);
  targets = boundaries[0].targets;
  REQUIRE(soup.points.size() > ring.points.size());
  REQUIRE(targets.size() == soup.points.size());
  CHECK(std::equal(ring.points.begin(), ring.points.end(), soup.points.begin()));
  CHECK(volume_of(soup) == Approx(volume_of(ring)));
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
  const double length = GENERATE(0.05, 0.2);
  Drawn_polycube_3 drawn = draw_polycube_3(polycube, given, length, Budget());
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

TEST_CASE("coordinates are the closest ones to means that keep their order and a gap")
{
  using namespace PM::internal;
  const std::vector<Order_of_coordinates> orders = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}};
  const auto coordinates = ordered_coordinates_3({1, 2, 1, 4}, {0, 6, 1, 40}, orders, {}, 0); // means 0, 3, 1, 10
  REQUIRE(coordinates);
  const std::vector<double> expected = {0, 2, 3, 10}; // (2 (x - 3)^2 + (x + 1 - 1)^2)' = 0 at x = 2
  REQUIRE(coordinates->values.size() == expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i)
    CHECK(coordinates->values[i] == Approx(expected[i]).margin(1e-12));
}

namespace {

// The boundary of a soup, with points of its own.
struct Soup_surface
{
  std::vector<PM::internal::Vector_3> points;
  std::vector<std::array<std::size_t, 3> > facets;

  explicit Soup_surface(const VMP::Tetrahedron_soup_3& soup)
  {
    std::map<std::size_t, std::size_t> number;
    for(std::array<std::size_t, 3> facet : VMP::internal::boundary_facets_3(soup.cells))
    {
      for(std::size_t& v : facet)
      {
        const auto inserted = number.emplace(v, points.size());
        if(inserted.second)
          points.emplace_back(soup.points[v][0], soup.points[v][1], soup.points[v][2]);
        v = inserted.first->second;
      }
      facets.push_back(facet);
    }
  }

  PM::internal::Vector_3 center(const std::size_t facet) const
  {
    const auto& [a, b, c] = facets[facet];
    return (points[a] + points[b] + points[c]) / 3;
  }
};

} // namespace

TEST_CASE("labels are proposed for a cylinder")
{
  Labelled_complex complex(bricks({8, 8, 6}, is_box, [](const double x, const double y, const double z) -> std::array<double, 3>
  {
    const double u = x - 4, v = y - 4, length = std::hypot(u, v), radius = (std::max)(std::abs(u), std::abs(v));
    return (length == 0) ? in_place(0, 0, z) : in_place(u * radius / length, v * radius / length, z);
  }));
  REQUIRE(complex.parameterize() == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
}

TEST_CASE("where the normals turn around, a face is put between")
{
  // a tent: no facet looks upwards, and the ridge is so sharp that its sides could have opposite labels
  Labelled_complex complex(bricks({12, 10, 6}, is_box, [](const double x, const double y, const double z)
  {
    return in_place(x, y, z * (1 + 4 * (6 - std::abs(x - 6))));
  }));
  REQUIRE(complex.parameterize() == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
}

TEST_CASE("features in a face become lines but for one that joins two side by side, and one that leaves no room for a facet")
{
  const auto bent = [](const double x, const double y, const double z)
  { return std::array<double, 3>{ x + 0.4 * std::sin(y / 3), y, z }; };
  const auto on_top = [&](const double x, const double y)
  {
    return x == 4 && y == 3 ? bent(3.5, 3, 2) : x == 4 && y == 5 ? bent(4.5, 5, 2) // a line from (3, 2) to (5, 6)
         : x == 6 && y == 4 ? bent(6.35, 3.65, 2) : bent(x, y, 2);                 // near the middle of an edge
  };
  VMP::Tetrahedron_soup_3 soup = bricks({ 8, 8, 2 }, is_box, [&](const double x, const double y, const double z)
                                        { return z == 2 ? on_top(x, y) : bent(x, y, z); });
  const auto vertex = [&](const double x, const double y)
  { return static_cast<std::size_t>(std::find(soup.points.begin(), soup.points.end(), on_top(x, y)) - soup.points.begin()); };
  std::vector<std::vector<std::array<double, 2> > > lines(4);
  for(int y = 0; y <= 8; ++y)
    for(const int i : { 0, 1 })
      lines[i].push_back({ 3. + 2 * i, y * 1. });
  lines[2] = { { 3, 2 }, { 4, 3 }, { 4, 4 }, { 4, 5 }, { 5, 6 } };
  lines[3] = { { 6, 0 }, { 6, 1 }, { 6, 2 }, { 6, 3 }, { 6, 4 }, { 7, 4 } }; // its last three vertices are those of a facet
  for(const auto& line : lines)
    for(std::size_t k = 1; k < line.size(); ++k)
    {
      soup.edges.push_back({ vertex(line[k - 1][0], line[k - 1][1]), vertex(line[k][0], line[k][1]) });
      soup.edge_references.push_back(1);
    }
  std::vector<std::array<double, 3> > targets;
  REQUIRE(Polycube(1).parameterize(soup, targets) == VMP::OK);
  for(const int i : { 0, 1 })
    for(const auto& [x, y] : lines[i])
      CHECK(targets[vertex(x, y)][0] == targets[vertex(x, 0)][0]);
  CHECK(targets[vertex(3, 0)][0] < targets[vertex(5, 0)][0]);
  CHECK(targets[vertex(6, 3)][0] != targets[vertex(7, 4)][0]);
}

TEST_CASE("a feature in a face becomes a line unless it is shorter than the spacing")
{
  const auto waved = [](const double x, const double y, const double z)
  { return std::array<double, 3>{ x, y + 0.3 * std::sin(x), z }; };
  VMP::Tetrahedron_soup_3 soup = bricks({ 8, 8, 2 }, is_box, waved);
  std::vector<std::size_t> feature;
  for(int x = 2; x <= 5; ++x)
  {
    const auto vertex = std::find(soup.points.begin(), soup.points.end(), waved(x, 4, 2));
    feature.push_back(static_cast<std::size_t>(vertex - soup.points.begin()));
  }
  for(std::size_t k = 1; k < feature.size(); ++k)
    soup.edges.push_back({ feature[k - 1], feature[k] });
  soup.edge_references.assign(soup.edges.size(), 1);
  const auto is_line = [&](const double spacing)
  {
    std::vector<std::array<double, 3> > targets;
    REQUIRE(Polycube(spacing).parameterize(soup, targets) == VMP::OK);
    return std::all_of(feature.begin(), feature.end(),
                       [&](const std::size_t v) { return targets[v][1] == targets[feature[0]][1]; });
  };
  CHECK(is_line(1));
  CHECK_FALSE(is_line(4));
}

TEST_CASE("features that are given up are told as polylines, the longest one first")
{
  VMP::Tetrahedron_soup_3 soup = bricks({ 6, 6, 2 }, is_box, in_place);
  const auto vertex = [&](const double x, const double y)
  { return static_cast<std::size_t>(std::find(soup.points.begin(), soup.points.end(), in_place(x, y, 2)) - soup.points.begin()); };
  const auto mark = [&](const std::vector<std::array<double, 2> >& line)
  {
    for(std::size_t k = 1; k < line.size(); ++k)
    {
      soup.edges.push_back({ vertex(line[k - 1][0], line[k - 1][1]), vertex(line[k][0], line[k][1]) });
      soup.edge_references.push_back(1);
    }
  };
  mark({ { 0, 5 }, { 1, 5 }, { 2, 5 } });           // along an axis
  mark({ { 1, 3 }, { 2, 4 } });                     // diagonals, which are edges of bricks
  mark({ { 1, 0 }, { 2, 1 }, { 3, 2 }, { 4, 3 } });
  std::vector<std::array<double, 3> > targets;
  PM::Polycube_result result;
  REQUIRE(Polycube(1, PM::Polycube_axes::FOUND, &result).parameterize(soup, targets) == VMP::OK);
  CHECK(result.number_of_sharp_edges == 6);
  CHECK(result.number_of_edges_given_up() == 4);
  REQUIRE(result.features_given_up.size() == 2);
  PM::Polycube_result::Polyline longest = result.features_given_up[0];
  std::sort(longest.begin(), longest.end());
  CHECK(longest == PM::Polycube_result::Polyline{ { 1, 0, 2 }, { 2, 1, 2 }, { 3, 2, 2 }, { 4, 3, 2 } });
  CHECK(result.features_given_up[1].size() == 2);
}

TEST_CASE("a polycube has the lengths of the body, not those of its shadow, also in multiples of a spacing")
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.6, Eigen::Vector3d(0.3, 0.2, 1).normalized()).toRotationMatrix();
  const VMP::Tetrahedron_soup_3 soup = bricks({12, 3, 2}, is_box, [&](const double x, const double y, const double z)
  {
    const Eigen::Vector3d p = turn * Eigen::Vector3d(x, y, z);
    return std::array<double, 3>{ p.x(), p.y(), p.z() };
  });
  for(const double spacing : { 0., 0.5 })
  {
    std::vector<std::array<double, 3> > image;
    REQUIRE(Polycube(spacing, PM::Polycube_axes::GIVEN).parameterize(soup.points, soup.cells, image) == VMP::OK);
    Eigen::AlignedBox3d box;
    for(const std::size_t v : VMP::boundary_vertices(soup.points, soup.cells))
      box.extend(Eigen::Vector3d(image[v].data()));
    CHECK((box.sizes() - Eigen::Vector3d(12, 3, 2)).norm() < 1e-3);
  }
}

TEST_CASE("the size and the place of the source do not matter")
{
  const double scale = GENERATE(1e-150, 1e150);
  Labelled_complex complex(bricks(size, is_bracket, [&](const double x, const double y, const double z)
  {
    return in_place(scale * x, scale * (y + 100), scale * z);
  }));
  REQUIRE(complex.parameterize() == VMP::OK);
  for(const auto& entry : complex.image)
    for(int axis = 0; axis < 3; ++axis)
      CHECK(std::abs(entry.second[axis] - entry.first->point()[axis]) < 1e-12 * scale);
}

// Body of bricks that are moved, then turned, with its image by arrays.
struct Turned_body
{
  VMP::Tetrahedron_soup_3 soup;
  std::vector<std::array<double, 3> > image;
  PM::Polycube_result result; // of the polycube

  template <typename IsSolid, typename Move>
  Turned_body(const IsSolid& is_solid, const Move& move, const Eigen::Matrix3d& turn)
    : soup(bricks(size, is_solid, [&](const double x, const double y, const double z)
      {
        const std::array<double, 3> p = move(x, y, z);
        const Eigen::Vector3d q = turn * Eigen::Vector3d(p[0], p[1], p[2]);
        return std::array<double, 3>{ q.x(), q.y(), q.z() };
      }))
  {}

  VMP::Error_code parameterize(const PM::Polycube_axes axes, const double spacing = 0)
  {
    return Polycube(spacing, axes, &result).parameterize(soup.points, soup.cells, image);
  }

  Eigen::Vector3d point(const std::size_t v) const { return Eigen::Vector3d(soup.points[v].data()); }
  Eigen::Vector3d image_of(const std::size_t v) const { return Eigen::Vector3d(image[v].data()); }

  Eigen::Matrix3d told() const
  {
    Eigen::Matrix3d rotation;
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 3; ++k)
        rotation(i, k) = result.rotation[i][k];
    return rotation;
  }

  double distortion() const
  {
    const auto surface = VMP::internal::surface_of(VMP::internal::body_of(soup.points, soup.cells));
    return VMP::internal::facet_distortion_3(surface.facets,
                                             [&](const std::size_t v) { return point(surface.vertices[v]); },
                                             [&](const std::size_t v) { return image_of(surface.vertices[v]); });
  }
};

// Returns rotations that are far from all symmetries of the cube.
std::vector<Eigen::Matrix3d> turns()
{
  const auto turn = [](const double x, const double y, const double z)
  {
    return (Eigen::AngleAxisd(x, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(y, Eigen::Vector3d::UnitY())
            * Eigen::AngleAxisd(z, Eigen::Vector3d::UnitZ())).toRotationMatrix();
  };
  return { turn(0.4, 0, 0.5), turn(0.9, 0.3, -0.7), turn(-0.2, 2.5, 1.2) };
}

template <typename IsSolid>
void check_turned(const IsSolid& is_solid)
{
  for(const Eigen::Matrix3d& turn : turns())
  {
    Turned_body body(is_solid, in_place, turn);
    REQUIRE(body.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
    Eigen::AlignedBox3d box;
    for(std::size_t v = 0; v < body.soup.points.size(); ++v)
      box.extend(body.point(v));
    double largest = 0;
    for(const std::size_t v : VMP::boundary_vertices(body.soup.points, body.soup.cells))
      largest = (std::max)(largest,
                           (box.center() + body.told() * (body.point(v) - box.center()) - body.image_of(v)).norm());
    CHECK(largest < 1e-5); // the polycube is the body itself, turned as is told
    const Eigen::Matrix3d symmetry = body.told() * turn;
    CHECK((symmetry - symmetry.array().round().matrix()).norm() < 1e-5);
    if(body.parameterize(PM::Polycube_axes::GIVEN) == VMP::OK)
      CHECK(body.told() == Eigen::Matrix3d::Identity());
  }
}

TEST_CASE("a turned polycube is mapped to itself, and by which rotation is told")
{
  check_turned(is_box);
  check_turned(is_bracket);
  check_turned(is_ring);
}

TEST_CASE("a bent body has about the same polycube in each position")
{
  Turned_body as_drawn(is_ring, bend, Eigen::Matrix3d::Identity());
  REQUIRE(as_drawn.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
  for(const Eigen::Matrix3d& turn : turns())
  {
    Turned_body body(is_ring, bend, turn);
    REQUIRE(body.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
    CHECK(body.distortion() == Approx(as_drawn.distortion()).epsilon(0.05));
  }
}

TEST_CASE("a body has the same faces as multiples of a spacing in each position and at each place")
{
  const double spacing = 1.3; // no length of the body is a multiple
  Turned_body as_drawn(is_bracket, in_place, Eigen::Matrix3d::Identity());
  REQUIRE(as_drawn.parameterize(PM::Polycube_axes::FOUND, spacing) == VMP::OK);
  for(const Eigen::Matrix3d& turn : turns())
  {
    Turned_body turned(is_bracket, in_place, turn);
    REQUIRE(turned.parameterize(PM::Polycube_axes::FOUND, spacing) == VMP::OK);
    CHECK(turned.distortion() == Approx(as_drawn.distortion()).epsilon(1e-3));
    Turned_body moved(is_bracket, [&](const double x, const double y, const double z)
                      { return in_place(x + turn(0, 1), y + turn(1, 2), z + turn(2, 0)); }, Eigen::Matrix3d::Identity());
    REQUIRE(moved.parameterize(PM::Polycube_axes::FOUND, spacing) == VMP::OK);
    CHECK(moved.distortion() == Approx(as_drawn.distortion()).epsilon(1e-9));
  }
}

TEST_CASE("lengths are rounded to multiples of the spacing, not the places of faces")
{
  const auto between = [](const double x, const double y, const double z) // from 0.3 to 3.7 along x
  { return std::array<double, 3>{ 0.3 + 3.4 / 6 * x, y, z }; };
  const auto width = [](const Turned_body& body)
  {
    const auto [low, high] = std::minmax_element(body.image.begin(), body.image.end());
    return (*high)[0] - (*low)[0];
  };
  Turned_body body(is_box, between, Eigen::Matrix3d::Identity());
  for(const PM::Polycube_axes axes : { PM::Polycube_axes::GIVEN, PM::Polycube_axes::FOUND })
  {
    REQUIRE(body.parameterize(axes, 1) == VMP::OK);
    CHECK(width(body) == 3);
  }
}

TEST_CASE("integers are moved by the best shift")
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0, 10);
  for(int i = 0; i < 50; ++i)
  {
    const std::vector<double> x = { number(random), number(random), number(random), number(random) };
    const std::vector<double> weights = { number(random), number(random), number(random), number(random) };
    const auto sum = [&](const double shift)
    {
      double result = 0, weight = 0;
      for(std::size_t k = 0; k < x.size(); ++k)
      {
        weight += weights[k];
        result += weights[k] * std::pow(x[k] - shift - std::round(x[k] - shift), 2);
      }
      return result / weight;
    };
    double least = 1;
    for(int k = 0; k < 1000; ++k)
      least = (std::min)(least, sum(k / 1000.));
    const double shift = PM::internal::closest_shift_of_integers(weights, x);
    CHECK(std::abs(shift) <= 0.5);
    CHECK(sum(shift) < least + 0.01); // a larger extent is worth as much
  }
}

TEST_CASE("the order of vertices and cells does not decide about a polycube")
{
  const auto uneven = [](const double x, const double y, const double z) // so that no two vertices are equally far from the center
  { return bend(x + 0.1 * std::sin(7 * y + 3 * z), y + 0.1 * std::sin(5 * z + 2 * x), z + 0.1 * std::sin(4 * x + 6 * y)); };
  Turned_body body(is_stair, uneven, Eigen::Matrix3d::Identity());
  REQUIRE(body.parameterize(PM::Polycube_axes::FOUND, 0.5) == VMP::OK);
  std::mt19937 random(1);
  for(int i = 0; i < 3; ++i)
  {
    Turned_body shuffled = body;
    std::vector<std::size_t> new_index(body.soup.points.size());
    std::iota(new_index.begin(), new_index.end(), 0);
    std::shuffle(new_index.begin(), new_index.end(), random);
    for(std::size_t v = 0; v < new_index.size(); ++v)
      shuffled.soup.points[new_index[v]] = body.soup.points[v];
    for(auto& cell : shuffled.soup.cells)
      for(std::size_t& v : cell)
        v = new_index[v];
    std::shuffle(shuffled.soup.cells.begin(), shuffled.soup.cells.end(), random);
    REQUIRE(shuffled.parameterize(PM::Polycube_axes::FOUND, 0.5) == VMP::OK);
    double largest = 0;
    for(const std::size_t v : VMP::boundary_vertices(body.soup.points, body.soup.cells))
      largest = (std::max)(largest, (shuffled.image_of(new_index[v]) - body.image_of(v)).norm());
    CHECK(largest < 1e-9);
  }
}

TEST_CASE("a body that lies well is not turned, and its polycube is the same, bit by bit")
{
  const auto check = [](const auto& move)
  {
    Turned_body body(is_bracket, move, Eigen::Matrix3d::Identity());
    REQUIRE(body.parameterize(PM::Polycube_axes::GIVEN) == VMP::OK);
    const auto given = body.image;
    REQUIRE(body.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
    CHECK(body.told() == Eigen::Matrix3d::Identity());
    for(const std::size_t v : VMP::boundary_vertices(body.soup.points, body.soup.cells))
      CHECK(body.image[v] == given[v]);
  };
  check(in_place);
  check([](const double x, const double y, const double z) { return in_place(y, z, x); }); // a symmetry of the cube
  check([](const double x, const double y, const double z) { return in_place(x + 1e-4 * y, y - 1e-4 * x, z); });
}

TEST_CASE("given labels keep the axes")
{
  const Labelled_complex straight(bricks(size, is_bracket, in_place));
  Labelled_complex complex(bricks(size, is_bracket, [](const double x, const double y, const double z)
  { return std::array<double, 3>{ 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, z }; }));
  copy_labels(straight, complex);
  REQUIRE(complex.parameterize_with_labels() == VMP::OK);
  for(const Facet& f : complex.boundary())
    REQUIRE(direction(complex.image_triangle(f)) == complex.labels.at(f));
}

TEST_CASE("a ball, which has no directions, has a polycube")
{
  const auto ball = [](const double x, const double y, const double z)
  {
    const Eigen::Vector3d p = Eigen::Vector3d(x, y, z).cwiseQuotient(Eigen::Vector3d(6, 5, 7)) * 2 - Eigen::Vector3d::Ones();
    const Eigen::Vector3d q = p.norm() > 0 ? Eigen::Vector3d(p * p.lpNorm<Eigen::Infinity>() / p.norm()) : p;
    return std::array<double, 3>{ q.x(), q.y(), q.z() };
  };
  for(const Eigen::Matrix3d& turn : turns())
  {
    Turned_body body(is_box, ball, turn);
    REQUIRE(body.parameterize(PM::Polycube_axes::FOUND) == VMP::OK);
    CHECK(body.distortion() < 0.5);
  }
}

TEST_CASE("labels that no polycube has are named")
{
  Labelled_complex complex(bricks(size, is_box, in_place));
  copy_labels(complex, complex);
  CHECK(complex.parameterize_with_labels() == VMP::OK);
  const auto status = [&](const auto& change)
  {
    const std::map<Facet, std::size_t> labels = complex.labels;
    for(auto& entry : complex.labels)
      entry.second = change(entry.first, entry.second);
    const VMP::Error_code result = complex.parameterize_with_labels();
    CHECK(complex.image.empty());
    complex.labels = labels;
    return result;
  };
  const auto one_label = [](const Facet&, std::size_t) -> std::size_t { return 0; };
  CHECK(status(one_label) == VMP::ERROR_NO_POLYCUBE);
  const auto opposite_neighbours = [](const Facet&, const std::size_t label) { return label == 2 ? 1 : label; };
  CHECK(status(opposite_neighbours) == VMP::ERROR_NO_POLYCUBE);
  const auto inside_out = [](const Facet&, const std::size_t label) { return label ^ 1; };
  CHECK(status(inside_out) == VMP::ERROR_NO_POLYCUBE);
  const auto without_top = [](const Facet&, const std::size_t label) -> std::size_t { return label == 4 ? 0 : label; };
  CHECK(status(without_top) == VMP::ERROR_NO_POLYCUBE);
  const auto island = [&](const Facet& f, const std::size_t label) -> std::size_t
  {
    const Point_3 p = CGAL::centroid(complex.source_triangle(f)[0], complex.source_triangle(f)[1],
                                     complex.source_triangle(f)[2]);
    return label == 4 && std::abs(p.x() - 3) < 1 && std::abs(p.y() - 3) < 1 ? 0 : label;
  };
  CHECK(status(island) == VMP::ERROR_NO_POLYCUBE);
}

TEST_CASE("a face of a polycube has no handle, although a cube on it would turn its border by the right angles")
{
  // a frame with a cube on it, all around which there is one label
  Labelled_complex complex(bricks({8, 8, 2}, [](const int x, const int y, const int z)
  {
    return z == 0 ? x / 2 != 2 || y / 2 != 2 : x == 1 && y == 1;
  }, in_place));
  copy_labels(complex, complex);
  CHECK(complex.parameterize_with_labels() == VMP::OK);
  for(auto& [facet, label] : complex.labels)
  {
    const std::array<Point_3, 3> t = complex.source_triangle(facet);
    if(CGAL::centroid(t[0], t[1], t[2]).z() <= 1)
      label = 4;
  }
  CHECK(complex.parameterize_with_labels() == VMP::ERROR_NO_POLYCUBE);
}

TEST_CASE("no other coordinates of the faces of a polycube have less distortion, and it has no less volume than the body")
{
  using namespace PM::internal;
  const Soup_surface straight(bricks(size, is_stair, in_place)), surface(bricks(size, is_stair, bend));
  Unit_surface_3 unit;
  Boundary_mesh_3& mesh = unit.mesh;
  REQUIRE(build_boundary_mesh_3(surface, mesh) == VMP::OK);
  set_points(mesh, unit_points(mesh));
  unit.box = bounding_box(points_of(mesh));
  std::vector<std::size_t> labels;
  for(const std::array<std::size_t, 3>& facet : straight.facets)
  {
    std::array<Point_3, 3> triangle;
    for(int i = 0; i < 3; ++i)
      triangle[i] = Point_3(straight.points[facet[i]][0], straight.points[facet[i]][1], straight.points[facet[i]][2]);
    labels.push_back(direction(triangle));
  }
  const Budget budget;
  Polycube_map_3 map(unit, labels);
  REQUIRE(map.start_close_to_surface(budget) == VMP::OK);
  const std::optional<Polycube_map_3> best = map.with_lengths_of_surface(budget);
  REQUIRE(best);

  std::vector<double> coordinates(best->charts().number_of_charts());
  double volume = 0;
  for(const auto f : mesh.faces())
  {
    const auto [a, b, c] = vertices_of_face(mesh, f);
    const std::size_t chart = best->charts().chart_of_face()[f];
    coordinates[chart] = best->images()[a][best->charts().axis(chart)];
    volume += best->images()[a].cross(best->images()[b]).dot(best->images()[c]) / 6;
  }
  CHECK(volume > (1 - 1e-9) * CGAL::Polygon_mesh_processing::volume(mesh));
  const Polycube_planes_3 planes(mesh, best->charts());
  for(std::size_t plane = 0; plane < planes.size(); ++plane)
    for(const double step : { -0.02, 0.02 })
    {
      std::vector<double> moved = coordinates;
      for(std::size_t chart = 0; chart < planes.size(); ++chart)
        moved[chart] += planes[chart] == plane ? step : 0;
      Polycube_map_3 other = *best;
      REQUIRE(other.start_at(moved, budget) == VMP::OK);
      CHECK(other.distortion() >= best->distortion());
    }
}

TEST_CASE("a hole of a face of a polycube is inside, even if it is beside the face on average")
{
  using namespace PM::internal;
  Soup_surface surface(bricks({8, 8, 1}, [](const int x, const int y, int) { return x / 2 != 2 || y / 2 != 2; }, in_place));
  Boundary_mesh_3 mesh;
  REQUIRE(build_boundary_mesh_3(surface, mesh) == VMP::OK);
  const Budget budget;
  const Polycube_charts_3 charts(mesh, Normal_labels_3(mesh, std::vector<bool>(mesh.number_of_edges(), false), budget).closest());
  const Plane_grid_3 any;
  const Polycube_planes_3 planes(mesh, charts);
  Polycube_coordinates_3 inside(mesh, charts, planes, any, budget);
  CHECK(inside.run(mean_coordinates_3(mesh, charts, planes)));
  for(PM::internal::Vector_3& p : surface.points)
    if((std::max)(std::abs(p[0] - 5), std::abs(p[1] - 5)) <= 1)
      p[0] += 20;
  set_points(mesh, surface.points);
  Polycube_coordinates_3 beside(mesh, charts, planes, any, budget);
  REQUIRE(beside.run(mean_coordinates_3(mesh, charts, planes)));
  const std::vector<double> coordinates = beside.of_charts();
  for(const auto f : mesh.faces())
  {
    const std::size_t chart = charts.chart_of_face()[f];
    const double x = mesh.point(mesh.source(mesh.halfedge(f))).x();
    if(charts.axis(chart) == 0 && x > 10) // at the hole
      for(const auto g : mesh.faces())
      {
        const std::size_t other = charts.chart_of_face()[g];
        const double y = mesh.point(mesh.source(mesh.halfedge(g))).x();
        if(charts.axis(other) == 0 && y == 0)
          CHECK(coordinates[other] < coordinates[chart]);
        else if(charts.axis(other) == 0 && y == 8)
          CHECK(coordinates[chart] < coordinates[other]);
      }
  }
}

TEST_CASE("polygons are those of a face if one is around all others, which are holes beside each other")
{
  using PM::internal::Boundary_polygon_2;
  const auto square = [](const double x, const double y, const double size)
  { return Boundary_polygon_2{ { x, y }, { x + size, y }, { x + size, y + size }, { x, y + size } }; };
  const auto hole = [&](const double x, const double y, const double size)
  {
    const Boundary_polygon_2 p = square(x, y, size);
    return Boundary_polygon_2(p.rbegin(), p.rend());
  };
  const Boundary_polygon_2 bracket = { { 0, 0 }, { 9, 0 }, { 9, 3 }, { 3, 3 }, { 3, 9 }, { 0, 9 } };
  using PM::internal::are_nested;
  CHECK(are_nested({ bracket }));
  CHECK(are_nested({ hole(1, 1, 1), bracket, hole(4, 1, 1) }));
  CHECK(!are_nested({ bracket, hole(5, 5, 1) }));                // not inside
  CHECK(!are_nested({ bracket, hole(0.5, 0.5, 2), hole(1, 1, 1) })); // inside of each other
  CHECK(!are_nested({ bracket, square(1, 1, 1) }));              // no hole
  CHECK(!are_nested({ bracket, square(5, 5, 1) }));              // two faces
  CHECK(!are_nested({ hole(1, 1, 1) }));                         // only a hole
}

TEST_CASE("a polycube that has a hole beside a face, in a notch of it, is refused")
{
  using namespace PM::internal;
  // a bracket with a hole at its corner
  const auto is_solid = [](const int x, const int y, int) { return (x < 3 || y < 3) && (x != 1 || y != 1); };
  Boundary_mesh_3 mesh;
  REQUIRE(build_boundary_mesh_3(Soup_surface(bricks({9, 9, 3}, is_solid, in_place)), mesh) == VMP::OK);
  const Budget budget;
  const Polycube_charts_3 charts(mesh, Normal_labels_3(mesh, std::vector<bool>(mesh.number_of_edges(), false), budget).closest());
  const Polycube_planes_3 planes(mesh, charts);
  std::vector<double> wanted = mean_coordinates_3(mesh, charts, planes);
  CHECK(Polycube_coordinates_3(mesh, charts, planes, Plane_grid_3(), budget).run(wanted));
  for(double& x : wanted)
    x += x > 0.5 && x < 2.5 ? 5 : 0; // of the walls of the hole, across the two walls of the notch
  CHECK(!Polycube_coordinates_3(mesh, charts, planes, Plane_grid_3(), budget).run(wanted));
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

namespace {

using Surface = CGAL::Surface_mesh<Point_3>;

Surface boundary_surface(const Labelled_complex& complex)
{
  Surface result;
  std::map<Vertex_handle, Surface::Vertex_index> index;
  for(const Facet& f : complex.boundary())
    for(const Vertex_handle v : Labelled_complex::vertices_of(f))
      if(index.count(v) == 0)
        index[v] = result.add_vertex(v->point());
  for(const Facet& f : complex.boundary())
  {
    const std::array<Vertex_handle, 3> v = Labelled_complex::vertices_of(f);
    result.add_face(index[v[1]], index[v[2]], index[v[0]]);
  }
  return result;
}

} // namespace

TEST_CASE("the boundary is mapped to a surface with the same connectivity")
{
  Labelled_complex complex(bricks(size, is_ring, bend));
  Surface boundary = boundary_surface(complex), target = boundary;
  for(const auto v : target.vertices())
    target.point(v) = Point_3(boundary.point(v).z(), boundary.point(v).x(), 2 * boundary.point(v).y());
  const auto parameterize = [&]()
  {
    complex.image.clear();
    return VMP::Surface_boundary_parameterizer_3<Surface>(boundary, target)
      .parameterize(complex.c3t3, boost::make_assoc_property_map(complex.image));
  };
  REQUIRE(parameterize() == VMP::OK);
  CHECK(complex.image.size() == boundary.number_of_vertices());
  for(const auto& entry : complex.image)
  {
    const Point_3 p = entry.first->point();
    CHECK(entry.second == Point_3(p.z(), p.x(), 2 * p.y()));
  }

  CGAL::Euler::flip_edge(*target.halfedges().begin(), target);
  CHECK(parameterize() == VMP::ERROR_OTHER_CONNECTIVITY);
  CGAL::Euler::flip_edge(*boundary.halfedges().begin(), boundary);
  CHECK(parameterize() == VMP::ERROR_OTHER_CONNECTIVITY);
  CHECK(complex.image.empty());
  boundary = target = boundary_surface(complex);
  CHECK(parameterize() == VMP::OK);
  boundary.point(*boundary.vertices().begin()) = Point_3(-1, -1, -1);
  CHECK(parameterize() == VMP::ERROR_OTHER_CONNECTIVITY);
}

TEST_CASE("maps to given surfaces can be ended anywhere, with nothing written")
{
  Labelled_complex complex(bricks(size, is_ring, bend));
  const Surface boundary = boundary_surface(complex);
  const VMP::Surface_boundary_parameterizer_3<Surface> parameterizer(boundary, boundary);
  check_interruption([&](const auto& np)
  {
    return parameterizer.parameterize(complex.c3t3, boost::make_assoc_property_map(complex.image), np);
  }, complex.image);
}
