// A boundary parameterizer splits edges of the boundary, inside of the call that maps the body.
#include "catch.h"
#include "complex_checks.h"
#include "cube_complex.h"
#include "ring_of_prisms.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;
namespace internal = VMP::internal;
namespace params = CGAL::parameters;

using Ring_complex = Cube_complex<>;
using C3t3 = Ring_complex::C3t3;
using Point = std::array<double, 3>;
using VMP::Parameterization_result;
using VMP::Refinement_mode;
using VMP::Tetrahedron_soup_3;

namespace {

const auto polycube = params::boundary_parameterizer(PM::Polycube_boundary_parameterizer_3());

// A boundary parameterizer that finds no polycube.
struct Without_polycube
{
  template <typename PointRange, typename CellRange, typename TargetRange,
            typename NamedParameters = params::Default_named_parameters>
  VMP::Error_code parameterize(const PointRange&, const CellRange&, TargetRange&,
                               const NamedParameters& = params::default_values()) const
  { return VMP::ERROR_NO_POLYCUBE; }
};

// Records how attempts end, and on which clock they run.
struct Told_attempts
{
  enum Quality { NONE, VALID, SUCCESSFUL };

  struct Mapped
  {
    std::string name;
    Quality quality;

    bool meets_boundary() const { return quality == SUCCESSFUL; }
    bool has_valid_map() const { return quality != NONE; }
  };

  std::map<std::string, Quality> qualities;
  std::vector<internal::Mapped_boundary_3> boundaries;
  std::size_t end = 4;               // the number of attempts after which the time is over
  std::vector<std::string> log = {}; // the attempts, within how many hundredths of the time that is left
  double part_of_time = 1;

  void limit_to_part_of_time(const double part) { part_of_time = part; }
  bool is_interrupted() const { return log.size() >= end; }

  std::string best()
  {
    return internal::best_boundary_attempt_3(boundaries, *this, [this](const auto& attempt, const auto& boundary, bool)
    {
      CHECK(attempt.is_refined == !boundary.splits.empty());
      const std::string name = !attempt.is_refined ? "given" : attempt.do_split_inside ? "splits and edges" : "splits";
      log.push_back(name + (attempt.is_held ? " held " : " ") + std::to_string(std::lround(100 * part_of_time)));
      return Mapped{ name, qualities[name] };
    }).name;
  }
};

// A ring whose cells have two references, with their facets on the boundary, and an edge that is one of the features.
Tetrahedron_soup_3 ring_with_references()
{
  Tetrahedron_soup_3 ring = ring_of_prisms();
  for(std::size_t c = 0; c < ring.cells.size(); ++c)
  {
    double y = 0;
    for(const std::size_t v : ring.cells[c])
      y += ring.points[v][1];
    ring.cell_references[c] = y > 0 ? 2 : 1;
  }
  for(const std::array<std::size_t, 3>& facet : internal::body_of(ring).boundary)
  {
    ring.facets.push_back(facet);
    ring.facet_references.push_back(ring.points[facet[0]][0] > 0 ? 4 : 3);
  }
  ring.edges = { { 0, 3 }, { 3, 6 }, { 6, 9 }, { 9, 12 } }; // along the ring
  ring.edge_references = { 5, 5, 6, 6 };
  return ring;
}

// Returns the direction in which the image of a facet looks.
std::size_t label_of_image(const Ring_complex::Cell_handle c, const int i, const Ring_complex& complex)
{
  const auto image = [&](const int k) { return internal::to_vector(complex.uvw.at(c->vertex(k))); };
  const internal::Vector_3 p = image((i + 1) % 4);
  internal::Vector_3 normal = (image((i + 2) % 4) - p).cross(image((i + 3) % 4) - p);
  if(normal.dot(image(i) - p) > 0)
    normal = -normal; // away from the cell
  const int axis = normal.cwiseAbs().largest_index();
  return 2 * static_cast<std::size_t>(axis) + (normal[axis] < 0);
}

double length(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

std::map<int, double> lengths_of_edges(const Tetrahedron_soup_3& soup)
{
  std::map<int, double> result;
  for(std::size_t e = 0; e < soup.edges.size(); ++e)
    result[soup.edge_references[e]] += length(soup.points[soup.edges[e][0]], soup.points[soup.edges[e][1]]);
  return result;
}

std::map<int, double> areas_of_facets(const Tetrahedron_soup_3& soup)
{
  std::map<int, double> result;
  for(std::size_t f = 0; f < soup.facets.size(); ++f)
  {
    const auto point = [&](const std::size_t i) { return internal::exact_point(soup.points[soup.facets[f][i]]); };
    result[soup.facet_references[f]] += std::sqrt(CGAL::squared_area(point(0), point(1), point(2)));
  }
  return result;
}

void check_same(const std::map<int, double>& a, const std::map<int, double>& b)
{
  REQUIRE(a.size() == b.size());
  for(const auto& [reference, value] : a)
    CHECK(b.at(reference) == Approx(value).epsilon(1e-12));
}

} // namespace

TEST_CASE("A split boundary is mapped as it is, then with edges split at it, and last the boundary as given")
{
  using Log = std::vector<std::string>;
  const internal::Mapped_boundary_3 split = { { { 0, 1 } }, {} }, given;
  const Log all = { "splits held 33", "splits and edges 75", "given 100" };
  const auto first = [&](const std::size_t n) { return Log(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n)); };
  const auto good = Told_attempts::SUCCESSFUL, valid = Told_attempts::VALID;
  const auto check = [&](const std::map<std::string, Told_attempts::Quality>& qualities, const std::string& best, const Log& log)
  {
    Told_attempts attempts = { qualities, { split, given } };
    CHECK(attempts.best() == best);
    CHECK(attempts.log == log);
    CHECK(attempts.part_of_time == 1);
  };
  check({ { "splits", good } }, "splits", first(1));
  check({ { "splits and edges", good } }, "splits and edges", first(2));
  check({ { "splits", valid }, { "splits and edges", good } }, "splits and edges", first(2));
  check({ { "splits", valid }, { "given", good } }, "given", all);
  // takes the first valid one of those that fail
  check({ { "splits", valid }, { "splits and edges", valid }, { "given", valid } }, "splits", all);
  check({ { "splits and edges", valid }, { "given", valid } }, "splits and edges", all);
  check({}, "given", all);
  // gives the last attempt all of the time
  Told_attempts splits_alone = { {}, { split } }, given_alone = { {}, { given } };
  CHECK(splits_alone.best() == "splits and edges");
  CHECK(splits_alone.log == Log{ "splits held 33", "splits and edges 100" });
  CHECK(given_alone.best() == "given");
  CHECK(given_alone.log == Log{ "given 100" });
  for(const std::size_t n : { 1, 2 }) // at the end of the time
  {
    Told_attempts attempts = { {}, { split, given }, n };
    CHECK(attempts.best() == (n == 1 ? "splits" : "splits and edges"));
    CHECK(attempts.log == first(n));
  }
}

TEST_CASE("A part of a budget ends with the whole, and not the other way round")
{
  bool may_continue = true;
  std::size_t number_of_steps = 0;
  const internal::Budget whole(1e9, [&] { return may_continue; },
                               [&](const VMP::Parameterization_step&) { return ++number_of_steps < 2; });
  const internal::Budget none = whole.part(0), half = whole.part(0.5);
  while(!none.is_exhausted()) {}
  CHECK(!half.is_exhausted());
  CHECK(!whole.is_exhausted());
  SECTION("by the user between steps")
  {
    may_continue = false;
    CHECK(half.is_exhausted());
    CHECK(whole.is_exhausted());
  }
  SECTION("by the user after a step")
  {
    CHECK(half.may_begin_round(VMP::Phase::BOUNDARY, ""));
    CHECK(!half.may_begin_round(VMP::Phase::BOUNDARY, ""));
    CHECK(number_of_steps == 2);
    CHECK(whole.is_exhausted());
  }
}

TEST_CASE("Without a polycube, splits of edges are advised unless they were permitted")
{
  const bool may_split = GENERATE(false, true);
  Tetrahedron_soup_3 ring = ring_of_prisms();
  std::vector<Point> uvw;
  const Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    ring, uvw, params::boundary_parameterizer(Without_polycube())
                      .refinement_mode(may_split ? Refinement_mode::BOUNDARY : Refinement_mode::HELPFUL));
  CHECK(result.status == VMP::ERROR_NO_POLYCUBE);
  CHECK((result.message.find("Permit splits") == std::string::npos) == may_split);
}

TEST_CASE("The boundary of arrays is refined only if this is asked for, on the edges that are split")
{
  const Tetrahedron_soup_3 ring = ring_with_references();
  Tetrahedron_soup_3 soup = ring;
  std::vector<Point> uvw;
  CHECK(CGAL::stretch_minimizing_volume_parameterization(soup, uvw, polycube).status == VMP::ERROR_NO_POLYCUBE);
  CHECK(CGAL::stretch_minimizing_volume_parameterization(
    soup, uvw, polycube.refinement_mode(Refinement_mode::NONE)).status == VMP::ERROR_NO_POLYCUBE);
  CHECK(soup.points == ring.points);

  const Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    soup, uvw, polycube.refinement_mode(Refinement_mode::BOUNDARY));
  REQUIRE(result.status == VMP::OK);
  CHECK(result.boundary_residual == 0);
  CHECK(uvw.size() == soup.points.size());
  CHECK(soup.points.size() == ring.points.size() + result.number_of_added_vertices);
  CHECK(result.number_of_added_boundary_vertices > 0);
  CHECK(result.number_of_boundary_vertices == ring.points.size() + result.number_of_added_boundary_vertices);
  CHECK(std::equal(ring.points.begin(), ring.points.end(), soup.points.begin()));
  check_same(areas_of_facets(ring), areas_of_facets(soup));
  check_same(lengths_of_edges(ring), lengths_of_edges(soup));
  CHECK(soup.edges.size() > ring.edges.size());
  CHECK(soup.facets.size() == internal::body_of(soup).boundary.size());
}

TEST_CASE("The boundary of a complex is refined as that of arrays, with patches, features and the cells outside")
{
  Tetrahedron_soup_3 soup = ring_with_references();
  Ring_complex complex(internal::Numbered_mesh_3(), soup);
  const auto outside = [&] // cells outside of the body
  {
    return complex.c3t3.triangulation().tds().number_of_cells() - complex.c3t3.number_of_cells_in_complex();
  };
  const std::size_t number_of_cells_outside = outside();
  std::map<int, double> areas, lengths;
  const std::size_t n = soup.points.size();

  std::vector<Point> expected;
  PM::Polycube_result result_of_polycube;
  const PM::Polycube_boundary_parameterizer_3 polycube(0, PM::Polycube_axes::FOUND, &result_of_polycube);
  const auto np = params::boundary_parameterizer(polycube).refinement_mode(Refinement_mode::BOUNDARY);
  const Parameterization_result of_arrays = CGAL::stretch_minimizing_volume_parameterization(soup, expected, np);
  const Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(complex.c3t3, complex.uvw_map(), np);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.number_of_added_vertices == of_arrays.number_of_added_vertices);
  CHECK(result.number_of_added_boundary_vertices == of_arrays.number_of_added_boundary_vertices);
  CHECK(result.energy == of_arrays.energy);
  CHECK(complex.uvw.size() == expected.size());
  for(std::size_t v = 0; v < n; ++v)
    CHECK(internal::coordinates(complex.uvw.at(complex.vertices[v])) == expected[v]);

  const C3t3& c3t3 = complex.c3t3;
  CHECK(is_consistent(c3t3.triangulation()));
  CHECK(has_positive_cells(c3t3));
  CHECK(has_positive_cells(c3t3, [&](const C3t3::Vertex_handle v) { return complex.uvw.at(v); }));
  CHECK(outside() > number_of_cells_outside);
  CHECK(c3t3.number_of_cells_in_complex() == soup.cells.size());

  std::set<Point> images(expected.begin(), expected.end());
  std::size_t number_on_patches = 0, number_on_curves = 0;
  const std::set<C3t3::Vertex_handle> given(complex.vertices.begin(), complex.vertices.end());
  for(const C3t3::Vertex_handle v : boundary_vertices(c3t3))
  {
    CHECK(images.count(internal::coordinates(complex.uvw.at(v))) == 1);
    if(given.count(v) > 0)
      continue;
    const int dimension = c3t3.in_dimension(v);
    CHECK((dimension == 1 || dimension == 2));
    (dimension == 1 ? number_on_curves : number_on_patches) += 1;
  }
  CHECK(number_on_curves == soup.edges.size() - 4);
  CHECK(number_on_curves + number_on_patches == result.number_of_added_boundary_vertices);

  std::size_t number_of_boundary_facets = 0;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
  {
    const auto area = std::sqrt(c3t3.triangulation().triangle(*f).squared_area());
    const bool is_on_boundary = c3t3.is_in_complex(f->first) != c3t3.is_in_complex(f->first->neighbor(f->second));
    if(is_on_boundary)
      areas[static_cast<int>(c3t3.surface_patch_index(*f))] += area;
    number_of_boundary_facets += is_on_boundary;
  }
  CHECK(number_of_boundary_facets == soup.facets.size());
  for(auto e = c3t3.edges_in_complex_begin(); e != c3t3.edges_in_complex_end(); ++e)
    lengths[static_cast<int>(c3t3.curve_index(*e))]
      += std::sqrt(c3t3.triangulation().segment(e->first, e->second, e->third).squared_length());
  check_same(areas_of_facets(soup), areas);
  check_same(lengths_of_edges(soup), lengths);

  REQUIRE(result_of_polycube.labels.size() == c3t3.number_of_cells_in_complex());
  auto labels = result_of_polycube.labels.begin();
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c, ++labels)
    for(int i = 0; i < 4; ++i)
      CHECK((*labels)[i] == (c3t3.is_in_complex(c->neighbor(i)) ? PM::Polycube_result::no_label : label_of_image(c, i, complex)));
}
