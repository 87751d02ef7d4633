// Refinement of a complex: what must stay as it is, and what must be gone.
#include "catch.h"
#include "mesh_body.h"

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/centroid.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Soup = VMP::Tetrahedron_soup_3;
using Remeshing_C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K> >;
using Mesh_3_C3t3 = C3t3;

namespace {

template <typename C3t3>
using Inserted = std::vector<VMP::Inserted_vertex_3<typename C3t3::Vertex_handle> >;

template <typename C3t3>
Point_3 point(const C3t3& c3t3, const typename C3t3::Vertex_handle v)
{
  return c3t3.triangulation().geom_traits().construct_point_3_object()(c3t3.triangulation().point(v));
}

// The numbers of interior edges, facets and cells all of whose vertices are on the boundary, found by the
// iterators and circulators of the triangulation.
struct Counts
{
  std::size_t edges = 0, facets = 0, cells = 0;
  bool operator==(const Counts& other) const
  {
    return edges == other.edges && facets == other.facets && cells == other.cells;
  }
};

template <typename C3t3>
std::set<typename C3t3::Vertex_handle> boundary_vertices(const C3t3& c3t3)
{
  const auto& tr = c3t3.triangulation();
  std::set<typename C3t3::Vertex_handle> result;
  for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    if(c3t3.is_in_complex(f->first) != c3t3.is_in_complex(tr.mirror_facet(*f).first))
      for(int i = 0; i < 3; ++i)
        result.insert(f->first->vertex(tr.vertex_triple_index(f->second, i)));
  return result;
}

template <typename C3t3>
Counts count_bad(const C3t3& c3t3, const std::set<typename C3t3::Vertex_handle>& boundary)
{
  const auto& tr = c3t3.triangulation();
  const auto is_on_boundary = [&](const typename C3t3::Vertex_handle v) { return boundary.count(v) != 0; };
  Counts counts;
  for(auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
  {
    bool is_bad = is_on_boundary(e->first->vertex(e->second)) && is_on_boundary(e->first->vertex(e->third));
    auto c = tr.incident_cells(*e), end = c;
    do
      is_bad = is_bad && c3t3.is_in_complex(c);
    while(++c != end);
    counts.edges += is_bad;
  }
  for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
  {
    bool is_bad = c3t3.is_in_complex(f->first) && c3t3.is_in_complex(f->first->neighbor(f->second));
    for(int i = 1; i < 4; ++i)
      is_bad = is_bad && is_on_boundary(f->first->vertex((f->second + i) % 4));
    counts.facets += is_bad;
  }
  for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
  {
    bool is_bad = c3t3.is_in_complex(c);
    for(int i = 0; i < 4; ++i)
      is_bad = is_bad && is_on_boundary(c->vertex(i));
    counts.cells += is_bad;
  }
  return counts;
}

template <typename C3t3>
Counts count_bad(const C3t3& c3t3)
{
  return count_bad(c3t3, boundary_vertices(c3t3));
}

// Properties that refinement must keep.
template <typename C3t3>
struct Invariants
{
  using Patch = typename C3t3::Surface_patch_index;

  explicit Invariants(const C3t3& c3t3)
  {
    const auto& tr = c3t3.triangulation();
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      volume[c3t3.subdomain_index(c)] += CGAL::volume(point(c3t3, c->vertex(0)), point(c3t3, c->vertex(1)),
                                                      point(c3t3, c->vertex(2)), point(c3t3, c->vertex(3)));
    for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    {
      std::array<Point_3, 3> p;
      for(int i = 0; i < 3; ++i)
        p[i] = point(c3t3, f->first->vertex((f->second + i + 1) % 4));
      const Patch patch = c3t3.surface_patch_index(*f);
      if(c3t3.is_in_complex(*f))
        area[patch] += std::sqrt(CGAL::squared_area(p[0], p[1], p[2]));
      std::sort(p.begin(), p.end());
      if(c3t3.is_in_complex(f->first) != c3t3.is_in_complex(tr.mirror_facet(*f).first))
        boundary.emplace(p, patch);
    }
  }

  std::map<typename C3t3::Subdomain_index, double> volume;
  std::map<Patch, double> area;
  std::set<std::pair<std::array<Point_3, 3>, Patch> > boundary;
};

template <typename Map>
void check_same_values(const Map& a, const Map& b)
{
  REQUIRE(a.size() == b.size());
  for(const auto& [index, value] : a)
    CHECK(std::abs(b.at(index) - value) <= 1e-12 * value);
}

template <typename C3t3>
void check_valid(const C3t3& c3t3)
{
  const auto& tr = c3t3.triangulation();
  std::size_t number_of_cells = 0, number_of_facets = 0, number_of_bad_cells = 0;
  for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
  {
    number_of_bad_cells += !tr.tds().is_valid(typename C3t3::Cell_handle(c));
    for(int i = 0; i < 4; ++i)
    {
      const auto mirror = tr.mirror_facet(std::make_pair(typename C3t3::Cell_handle(c), i));
      number_of_bad_cells += c3t3.surface_patch_index(c, i) != c3t3.surface_patch_index(mirror);
    }
    if(!c3t3.is_in_complex(c))
      continue;
    ++number_of_cells;
    number_of_bad_cells += CGAL::orientation(point(c3t3, c->vertex(0)), point(c3t3, c->vertex(1)),
                                             point(c3t3, c->vertex(2)), point(c3t3, c->vertex(3))) != CGAL::POSITIVE;
  }
  CHECK(number_of_bad_cells == 0);
  for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    number_of_facets += c3t3.is_in_complex(*f);
  CHECK(c3t3.number_of_cells_in_complex() == number_of_cells);
  CHECK(c3t3.number_of_facets_in_complex() == number_of_facets);
  for(auto v = tr.tds().vertices_begin(); v != tr.tds().vertices_end(); ++v)
    REQUIRE(tr.tds().is_valid(typename C3t3::Vertex_handle(v)));
}

// The dimension and the index of a vertex are those of the face of the complex it lies in; there are no feature edges here.
template <typename C3t3>
void check_dimension_and_index(const C3t3& c3t3, const typename C3t3::Vertex_handle v)
{
  using Index = typename C3t3::Index;
  std::vector<typename C3t3::Facet> facets;
  c3t3.triangulation().finite_incident_facets(v, std::back_inserter(facets));
  facets.erase(std::remove_if(facets.begin(), facets.end(), [&](const auto& f) { return !c3t3.is_in_complex(f); }),
               facets.end());
  REQUIRE(c3t3.in_dimension(v) == (facets.empty() ? 3 : 2));
  const Index index = facets.empty() ? Index(c3t3.subdomain_index(v->cell()))
                                     : Index(c3t3.surface_patch_index(facets.front()));
  REQUIRE((c3t3.index(v) == index));
}

template <typename C3t3>
void check_refined(const C3t3& c3t3, const Invariants<C3t3>& before, const Inserted<C3t3>& inserted)
{
  check_valid(c3t3);
  const Invariants<C3t3> after(c3t3);
  check_same_values(before.volume, after.volume);
  check_same_values(before.area, after.area);
  CHECK(before.boundary == after.boundary);
  for(const auto& insertion : inserted)
  {
    check_dimension_and_index(c3t3, insertion.vertex);
    std::vector<Point_3> points;
    for(const auto v : insertion.simplex)
      points.push_back(point(c3t3, v));
    const Point_3 centroid = CGAL::centroid(points.begin(), points.end(), CGAL::Dimension_tag<0>());
    CHECK(CGAL::squared_distance(centroid, point(c3t3, insertion.vertex)) < 1e-24);
  }
}

// Removes all simplices with all vertices on the boundary.
template <typename C3t3>
Inserted<C3t3> refine_and_check(C3t3& c3t3)
{
  const Invariants<C3t3> before(c3t3);
  Inserted<C3t3> inserted;
  const std::size_t n = VMP::make_parameterizable(c3t3, params::output_iterator(std::back_inserter(inserted)));
  CHECK(n == inserted.size());
  check_refined(c3t3, before, inserted);
  CHECK(count_bad(c3t3) == Counts());
  return inserted;
}

template <typename C3t3>
struct Built
{
  explicit Built(const Soup& soup) { VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells); }

  C3t3 c3t3;
  std::vector<typename C3t3::Vertex_handle> vertices;
  std::vector<typename C3t3::Cell_handle> cells;
};

// A box of nx * ny * nz unit cubes, each cut into six cells around its diagonal; the cubes are subdomains by turns.
Soup box(std::size_t nx, std::size_t ny, std::size_t nz)
{
  Soup soup;
  for(std::size_t i = 0; i <= nx; ++i)
    for(std::size_t j = 0; j <= ny; ++j)
      for(std::size_t k = 0; k <= nz; ++k)
        soup.points.push_back({ double(i), double(j), double(k) });

  const std::array<std::size_t, 3> step = { (ny + 1) * (nz + 1), nz + 1, 1 };
  for(std::size_t i = 0; i < nx; ++i)
    for(std::size_t j = 0; j < ny; ++j)
      for(std::size_t k = 0; k < nz; ++k)
        for(std::size_t a = 0; a < 3; ++a)
        {
          const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
          const std::size_t o = i * step[0] + j * step[1] + k, end = o + step[0] + step[1] + step[2];
          soup.cells.push_back({ o, o + step[a], o + step[a] + step[b], end });
          soup.cells.push_back({ o, o + step[a] + step[c], o + step[a], end });
          soup.cell_references.insert(soup.cell_references.end(), 2, static_cast<int>((i + j + k) % 2 + 1));
        }
  return soup;
}

const Soup two_tetrahedra = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
                              { { 0, 1, 2, 3 }, { 1, 2, 3, 4 } }, { 1, 1 }, {}, {} };

// Some cells around the edge of vertices 0 and 1.
Soup fan(const std::array<double, 3>& a, const std::array<double, 3>& b,
         const std::vector<std::array<double, 3> >& around)
{
  Soup soup;
  soup.points = { a, b };
  soup.points.insert(soup.points.end(), around.begin(), around.end());
  for(std::size_t i = 0; i < around.size(); ++i)
  {
    soup.cells.push_back({ 0, 1, 2 + i, 2 + (i + 1) % around.size() });
    soup.cell_references.push_back(1);
  }
  return soup;
}

Soup five_cells_around_edge()
{
  std::vector<std::array<double, 3> > around;
  for(int i = 0; i < 5; ++i)
    around.push_back({ std::cos(i), std::sin(i), 0. });
  return fan({ 0, 0, -1 }, { 0, 0, 1 }, { around[0], { 0, 1, 0 }, { -1, 1, 0 }, { -1, -1, 0 }, { 1, -1, 0 } });
}

// The lower half of an octahedron around the edge of vertices 0 and 1 is filled from vertex 6 inside, above its lowest 5.
Soup octahedron_with_vertex_below_axis()
{
  Soup soup;
  soup.points = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, -1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { 0, 0, -0.5 } };
  soup.cells = { { 0, 1, 3, 4 }, { 0, 2, 1, 4 }, { 0, 3, 1, 6 }, { 0, 1, 2, 6 },
                 { 0, 3, 6, 5 }, { 3, 1, 6, 5 }, { 1, 2, 6, 5 }, { 2, 0, 6, 5 } };
  soup.cell_references.assign(soup.cells.size(), 1);
  return soup;
}

// Below a tetrahedron another, which is filled from a vertex inside.
Soup tetrahedron_upon_three_around_vertex()
{
  Soup soup;
  soup.points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 4 }, { 1, 1, -4 }, { 1, 1, -1 } };
  soup.cells = { { 0, 1, 2, 3 }, { 0, 2, 1, 5 }, { 0, 1, 4, 5 }, { 1, 2, 4, 5 }, { 2, 0, 4, 5 } };
  soup.cell_references.assign(soup.cells.size(), 1);
  return soup;
}

// All that is below goes up into the plane.
Point_3 flat_below(const Point_3& p) { return Point_3(p.x(), p.y(), (std::max)(p.z(), 0.)); }

template <typename C3t3, typename Function>
std::size_t refine_for_map(C3t3& c3t3, const Function& map)
{
  const auto target = [&](const typename C3t3::Vertex_handle v) { return map(point(c3t3, v)); };
  return VMP::make_parameterizable(
    c3t3, params::boundary_map(boost::make_function_property_map<typename C3t3::Vertex_handle>(target)));
}

// A flat ellipsoid in two halves.
Mesh_3_C3t3 two_halves()
{
  const auto label = [](const Point_3& p)
  {
    const bool is_inside = p.x() * p.x() + 2 * p.y() * p.y() + 8 * p.z() * p.z() < 1;
    return !is_inside ? 0 : p.x() < 0 ? 1 : 2;
  };
  const Domain domain(label, K::Sphere_3(CGAL::ORIGIN, 4.));
  const CGAL::Mesh_criteria_3<Mesh_3_C3t3::Triangulation> criteria(params::facet_size = 0.2, params::facet_distance = 0.05,
                                                                   params::cell_radius_edge_ratio = 3,
                                                                   params::cell_size = 0.3);
  return mesh_body(domain, criteria);
}

Soup soup_of(const Mesh_3_C3t3& c3t3)
{
  Soup soup;
  std::unordered_map<Mesh_3_C3t3::Vertex_handle, std::size_t> number;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    soup.cells.emplace_back();
    soup.cell_references.push_back(c3t3.subdomain_index(c));
    for(int i = 0; i < 4; ++i)
    {
      const auto inserted = number.emplace(c->vertex(i), number.size());
      soup.cells.back()[i] = inserted.first->second;
      const Point_3 p = point(c3t3, c->vertex(i));
      if(inserted.second)
        soup.points.push_back({ p.x(), p.y(), p.z() });
    }
  }
  return soup;
}

} // namespace

TEST_CASE("a cell without neighbors gets a vertex")
{
  Soup soup = two_tetrahedra;
  soup.cells.pop_back();
  soup.cell_references = { 7 };
  Built<Remeshing_C3t3> built(soup);
  const auto inserted = refine_and_check(built.c3t3);
  REQUIRE(inserted.size() == 1);
  CHECK(inserted[0].simplex.size() == 4);
  CHECK(built.c3t3.number_of_cells_in_complex() == 4);
  CHECK(built.c3t3.number_of_facets_in_complex() == 4);
  CHECK(built.c3t3.triangulation().tds().is_valid());
}

TEST_CASE("a facet none of whose edges is inside gets a vertex")
{
  Soup soup = two_tetrahedra;
  const bool is_interface = GENERATE(false, true);
  soup.cell_references[1] = is_interface ? 2 : 1;
  Built<Remeshing_C3t3> built(soup);
  const auto inserted = refine_and_check(built.c3t3);
  REQUIRE(inserted.size() == 1);
  CHECK(inserted[0].simplex.size() == 3);
  CHECK(built.c3t3.in_dimension(inserted[0].vertex) == (is_interface ? 2 : 3));
  CHECK(built.c3t3.number_of_cells_in_complex() == 6);
  CHECK(built.c3t3.number_of_facets_in_complex() == (is_interface ? 9 : 6));
  CHECK(built.c3t3.triangulation().tds().is_valid());
}

TEST_CASE("one vertex in the common edge removes all cells around it")
{
  Soup soup = five_cells_around_edge();
  const bool has_interface = GENERATE(false, true);
  if(has_interface)
    soup.cell_references = { 1, 1, 2, 2, 2 };
  Built<Remeshing_C3t3> built(soup);
  const std::size_t number_of_facets = built.c3t3.number_of_facets_in_complex();
  const auto inserted = refine_and_check(built.c3t3);
  REQUIRE(inserted.size() == 1);
  CHECK(inserted[0].simplex.size() == 2);
  CHECK(point(built.c3t3, inserted[0].vertex) == Point_3(0, 0, 0));
  CHECK(built.c3t3.in_dimension(inserted[0].vertex) == (has_interface ? 2 : 3));
  CHECK(built.c3t3.number_of_cells_in_complex() == 10);
  CHECK(built.c3t3.number_of_facets_in_complex() == number_of_facets + (has_interface ? 2 : 0));
}

TEST_CASE("the halves of a feature edge are feature edges")
{
  Built<Remeshing_C3t3> built(five_cells_around_edge());
  Remeshing_C3t3& c3t3 = built.c3t3;
  c3t3.add_to_complex(built.vertices[0], built.vertices[1], 5);
  c3t3.add_to_complex(built.vertices[0], built.vertices[2], 6);
  Inserted<Remeshing_C3t3> inserted;
  REQUIRE(VMP::make_parameterizable(c3t3, params::output_iterator(std::back_inserter(inserted))) == 1);
  check_valid(c3t3);
  const auto v = inserted[0].vertex;
  CHECK(c3t3.number_of_edges_in_complex() == 3);
  CHECK(c3t3.curve_index(built.vertices[0], v) == 5);
  CHECK(c3t3.curve_index(v, built.vertices[1]) == 5);
  CHECK(c3t3.curve_index(built.vertices[0], built.vertices[2]) == 6);
  CHECK(c3t3.in_dimension(v) == 1);
  CHECK((c3t3.index(v) == Remeshing_C3t3::Index(5)));
}

TEST_CASE("a grid gets one vertex in each edge between boundary vertices")
{
  const std::size_t n = GENERATE(1, 2, 3);
  Built<Remeshing_C3t3> built(box(2, n, 2));
  const Counts before = count_bad(built.c3t3);
  REQUIRE(before.cells > 0);
  const auto inserted = refine_and_check(built.c3t3);
  CHECK(inserted.size() == before.edges);
  CHECK(built.c3t3.triangulation().tds().is_valid());
  CHECK(VMP::make_parameterizable(built.c3t3) == 0);
}

TEST_CASE("constrained vertices count as vertices of the boundary")
{
  Built<Remeshing_C3t3> built(box(2, 2, 2));
  const auto center = *std::find_if(built.vertices.begin(), built.vertices.end(), [&](const auto v)
  {
    return point(built.c3t3, v) == Point_3(1, 1, 1);
  });
  std::set<Remeshing_C3t3::Vertex_handle> prescribed = boundary_vertices(built.c3t3), constrained = { center };
  REQUIRE(prescribed.insert(center).second);
  VMP::make_parameterizable(built.c3t3, params::vertex_is_constrained_map(
    CGAL::Boolean_property_map<std::set<Remeshing_C3t3::Vertex_handle> >(constrained)));
  check_valid(built.c3t3);
  CHECK(count_bad(built.c3t3, prescribed) == Counts());
}

TEST_CASE("all edges at a vertex where two cubes touch are found")
{
  Soup soup = box(1, 1, 1);
  const Soup copy = soup;
  for(std::size_t v = 0; v < 7; ++v)
    soup.points.push_back({ copy.points[v][0] - 1, copy.points[v][1] - 1, copy.points[v][2] - 1 });
  for(const std::array<std::size_t, 4>& cell : copy.cells)
  {
    soup.cells.emplace_back();
    soup.cell_references.push_back(1);
    std::transform(cell.begin(), cell.end(), soup.cells.back().begin(), [](std::size_t v) { return v == 7 ? 0 : v + 8; });
  }
  Built<Remeshing_C3t3> built(soup);
  CHECK(refine_and_check(built.c3t3).size() == 2);
}

TEST_CASE("with a boundary map only degenerate simplices are removed")
{
  SECTION("nothing is degenerate")
  {
    Built<Remeshing_C3t3> built(box(2, 2, 2));
    CHECK(refine_for_map(built.c3t3, [](const Point_3& p) { return Point_3(2 * p.x() + p.y(), p.y(), p.z()); }) == 0);
    CHECK(built.c3t3.number_of_cells_in_complex() == 48);
  }
  SECTION("all is flat: a vertex in each body diagonal, and one in that of the common square")
  {
    Built<Remeshing_C3t3> built(box(2, 1, 1));
    CHECK(refine_for_map(built.c3t3, [](const Point_3& p) { return Point_3(p.x() + 0.3 * p.z(), p.y() + 0.1 * p.z(), 0); }) == 3);
    check_valid(built.c3t3);
    CHECK(count_bad(built.c3t3) == Counts());
  }
  SECTION("one cell is inverted")
  {
    Built<Remeshing_C3t3> built(two_tetrahedra);
    CHECK(refine_for_map(built.c3t3, [](const Point_3& p) { return p == Point_3(1, 1, 1) ? Point_3(0.1, 0.1, 0.1) : p; }) == 1);
    check_valid(built.c3t3);
  }
  SECTION("a facet is collinear, but its cells have a vertex inside")
  {
    Built<Remeshing_C3t3> built(box(2, 2, 2));
    const auto crease = [](const Point_3& p) { return p == Point_3(0, 1, 1) ? Point_3(0, 0.5, 1) : p; };
    CHECK(refine_for_map(built.c3t3, crease) == 0);
    const auto collapse = [](const Point_3& p) { return p == Point_3(2, 2, 2) ? Point_3(0, 0, 0) : p; };
    CHECK(refine_for_map(built.c3t3, collapse) == 0); // the diagonal consists of two edges
  }
  SECTION("an edge is contracted")
  {
    Built<Remeshing_C3t3> built(five_cells_around_edge());
    CHECK(refine_for_map(built.c3t3, [](const Point_3& p) { return Point_3(p.x(), p.y(), 0); }) == 1);
    check_valid(built.c3t3);
  }
  SECTION("an edge between vertices of a flat side is mapped into it, though no cell becomes flat")
  {
    Built<Remeshing_C3t3> built(octahedron_with_vertex_below_axis());
    Remeshing_C3t3& c3t3 = built.c3t3;
    CHECK(refine_for_map(c3t3, [](const Point_3& p) { return p; }) == 0);
    CHECK(refine_for_map(c3t3, flat_below) == 1);
    check_valid(c3t3);
    CHECK_FALSE(c3t3.triangulation().tds().is_edge(built.vertices[0], built.vertices[1]));
  }
  SECTION("a facet between edges of a flat side is mapped onto it")
  {
    Built<Remeshing_C3t3> built(tetrahedron_upon_three_around_vertex());
    CHECK(refine_for_map(built.c3t3, [](const Point_3& p) { return p; }) == 0);
    CHECK(refine_for_map(built.c3t3, flat_below) == 1);
    check_valid(built.c3t3);
    CHECK(built.c3t3.number_of_cells_in_complex() == 5 + 4);
  }
  SECTION("missing targets degenerate nothing")
  {
    Built<Remeshing_C3t3> built(five_cells_around_edge());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(refine_for_map(built.c3t3, [nan](const Point_3& p) { return Point_3(p.x(), p.y(), nan); }) == 0);
  }
}

TEST_CASE("a limit of time leaves a valid complex, which another call refines further")
{
  Mesh_3_C3t3 c3t3 = two_halves();
  Built<Remeshing_C3t3> built(soup_of(c3t3)), expected(soup_of(c3t3));
  const Counts before = count_bad(built.c3t3);
  const Invariants<Remeshing_C3t3> invariants(built.c3t3);
  CHECK(VMP::make_parameterizable(built.c3t3, params::maximum_running_time(0)) == 0);
  CHECK(count_bad(built.c3t3) == before);

  struct Patient_visitor : VMP::Default_visitor
  {
    std::size_t patience;
    explicit Patient_visitor(const std::size_t patience) : patience(patience) {}
    bool goes_on() { return patience > 0 && patience-- > 0; }
  };
  const auto boundary = boundary_vertices(built.c3t3);
  const auto has_bad_edge = [&](const auto& cell) // or one of the boundary: a question for each such cell comes first
  {
    int number = 0;
    for(int i = 0; i < 4; ++i)
      number += boundary.count(cell.vertex(i)) != 0;
    return number > 1;
  };
  const auto number = std::count_if(built.c3t3.cells_in_complex_begin(), built.c3t3.cells_in_complex_end(), has_bad_edge);
  Patient_visitor visitor(number + before.edges / 2);
  Inserted<Remeshing_C3t3> inserted;
  const std::size_t n = VMP::make_parameterizable(built.c3t3, params::visitor(std::ref(visitor))
                                                                .output_iterator(std::back_inserter(inserted)));
  CHECK(visitor.patience == 0);
  CHECK((0 < n && n < before.edges));
  REQUIRE(inserted.size() == n);
  check_refined(built.c3t3, invariants, inserted);
  CHECK(count_bad(built.c3t3).edges > 0);

  const std::size_t all = VMP::make_parameterizable(expected.c3t3);
  CHECK(n + VMP::make_parameterizable(built.c3t3) == all);
  CHECK(count_bad(built.c3t3) == count_bad(expected.c3t3));
}

TEST_CASE("rounding never makes a cell flat or inverted")
{
  const double one = 1, next = std::nextafter(1., 2.);
  SECTION("another point of the edge than its midpoint is taken")
  {
    Built<Remeshing_C3t3> built(fan({ one, 0, -1 }, { next, 0, 1 }, { { one, 0, 0 }, { 1, -1, 0 }, { 2, 0, 0 }, { 1, 1, 0 } }));
    CHECK(VMP::make_parameterizable(built.c3t3) == 1);
    check_valid(built.c3t3);
    CHECK(count_bad(built.c3t3) == Counts());
  }
  SECTION("no point of the edge is left")
  {
    Built<Remeshing_C3t3> built(fan({ one, 0, -1 }, { next, 0, 1 }, { { one, 0, 0 }, { 1, -1, 0 }, { next, 0, 0 }, { 1, 1, 0 } }));
    VMP::make_parameterizable(built.c3t3);
    CHECK(built.c3t3.triangulation().tds().is_edge(built.vertices[0], built.vertices[1]));
    check_valid(built.c3t3);
  }
}

TEST_CASE("a mesh made by Mesh_3, in both kinds of triangulation")
{
  Mesh_3_C3t3 c3t3 = two_halves();
  Built<Remeshing_C3t3> built(soup_of(c3t3));
  const Counts before = count_bad(c3t3);
  REQUIRE(before.edges > 10);
  REQUIRE(count_bad(built.c3t3) == before);

  const auto identity = [](const Point_3& p) { return p; };
  CHECK(refine_for_map(c3t3, identity) == 0);
  CHECK(refine_for_map(built.c3t3, identity) == 0);

  // The insertions do not depend on the representation.
  const auto inserted = refine_and_check(c3t3);
  CHECK(inserted.size() >= before.edges);
  CHECK(c3t3.triangulation().tds().is_valid());
  CHECK(refine_and_check(built.c3t3).size() == inserted.size());
}
