// stretch_minimizing_volume_parameterization() on complexes of all kinds, and with other kernels.
#include "catch.h"
#include "cube_complex.h"
#include "mesh_body.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#define main program_of_readme // its name in this program, which has a main() of its own
#include "code_of_readme.h"
#undef main

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Eigen::Vector3d;
using VMP::Parameterization_result;
using VMP::Tetrahedron_soup_3;
using VMP::internal::Numbered_mesh_3;

namespace {

template <typename Complex>
Parameterization_result parameterize(Complex& complex)
{
  return CGAL::stretch_minimizing_volume_parameterization(std::as_const(complex.c3t3), complex.uvw_map(),
                                                          params::boundary_map(complex.boundary_map()));
}

// The mesh and a copy of it beside it, as one mesh without common vertices.
Numbered_mesh_3 doubled(const Numbered_mesh_3& mesh, const Vector3d& translation)
{
  const int n = mesh.number_of_vertices(), free = mesh.number_of_free_vertices;
  const auto number = [&](const int v, const int copy) // free vertices first
  {
    return v < free ? v + copy * free : v + free + copy * (n - free);
  };
  Numbered_mesh_3 result;
  result.source.resize(3, 2 * n);
  result.target.resize(3, 2 * n);
  result.number_of_free_vertices = 2 * free;
  for(const int copy : {0, 1})
  {
    for(int v = 0; v < n; ++v)
    {
      result.source.col(number(v, copy)) = mesh.source.col(v) + copy * translation;
      result.target.col(number(v, copy)) = mesh.target.col(v) + copy * translation;
    }
    for(const std::array<int, 4>& cell : mesh.cells)
      result.cells.push_back({number(cell[0], copy), number(cell[1], copy),
                              number(cell[2], copy), number(cell[3], copy)});
  }
  return result;
}

} // namespace

TEMPLATE_TEST_CASE("Kernels", "", CGAL::Simple_cartesian<double>, CGAL::Exact_predicates_exact_constructions_kernel)
{
  Cube_complex<> expected(twisted_cube(3, 0.1));
  parameterize(expected);

  Cube_complex<TestType> complex(twisted_cube(3, 0.1));
  const Parameterization_result result = parameterize(complex);
  CHECK(result.status == VMP::OK);
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
  {
    const auto& p = complex.uvw.at(complex.vertices[v]);
    const auto& q = expected.uvw.at(expected.vertices[v]);
    CHECK((CGAL::to_double(p.x()) == q.x() && CGAL::to_double(p.y()) == q.y() && CGAL::to_double(p.z()) == q.z()));
  }
}

TEST_CASE("The program of README.md")
{
  CHECK(program_of_readme() == 0);
}

TEST_CASE("The function of README.md")
{
  Cube_complex<> expected(twisted_cube(3, 0.1)), complex(twisted_cube(3, 0.1));
  parameterize(expected);
  const auto target = [&complex](const Cube_complex<>::Vertex_handle v) { return complex.target.at(v); };
  CHECK(parameterize(complex.c3t3, complex.uvw_map(), target));
  REQUIRE(complex.uvw.size() == complex.vertices.size());
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    CHECK(complex.uvw.at(complex.vertices[v]) == expected.uvw.at(expected.vertices[v]));
}

TEST_CASE("Interfaces between subdomains are not prescribed")
{
  Cube_complex<> expected(twisted_cube(4));
  parameterize(expected);

  const Numbered_mesh_3 mesh = twisted_cube(4);
  Tetrahedron_soup_3 soup = source_soup(mesh);
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    soup.cell_references[c] = 1 + static_cast<int>(c / 100);
  Cube_complex<> complex(mesh, soup);
  REQUIRE(complex.c3t3.number_of_facets_in_complex() > expected.c3t3.number_of_facets_in_complex());
  const Parameterization_result result = parameterize(complex);
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_boundary_vertices == 98);
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    CHECK(complex.uvw.at(complex.vertices[v]) == expected.uvw.at(expected.vertices[v]));
}

TEST_CASE("A vertex on the boundary of a part of the triangulation is prescribed, one outside is left alone")
{
  // the complex keeps the cells with x <= 2 of a cube of size 3: its interface to the rest becomes boundary
  Cube_complex<> complex(cube_mesh(3));
  for(const auto& c : complex.cells)
    for(int i = 0; i < 4; ++i)
      if(c->vertex(i)->point().x() > 2 && complex.c3t3.is_in_complex(c))
        complex.c3t3.remove_from_complex(c);
  complex.target.clear();
  for(const auto& v : complex.vertices)
    if(v->point().x() == 0 || v->point().x() == 2 || v->point().y() == 0 || v->point().y() == 3
       || v->point().z() == 0 || v->point().z() == 3)
      complex.target.emplace(v, v->point());

  const Parameterization_result result = parameterize(complex);
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_cells == 108);
  CHECK(result.number_of_vertices == 48);
  CHECK(result.number_of_boundary_vertices == 44);
  CHECK(complex.uvw.size() == 48);
  for(const auto& [v, p] : complex.uvw)
    CHECK(CGAL::squared_distance(p, v->point()) <= 1e-10);
}

TEST_CASE("Points of a soup without cell have no image")
{
  const Numbered_mesh_3 mesh = twisted_cube(3);
  Tetrahedron_soup_3 soup = source_soup(mesh);
  soup.points.push_back({7, 8, 9});
  Cube_complex<> complex(mesh, soup);
  CHECK(parameterize(complex).status == VMP::OK);
  CHECK(complex.uvw.size() == 64);
}

TEST_CASE("Several connected components")
{
  Cube_complex<> single(twisted_cube(3, 0.1));
  const Parameterization_result expected = parameterize(single);

  Cube_complex<> complex(doubled(twisted_cube(3, 0.1), Vector3d(10, 0, 0)));
  const Parameterization_result result = parameterize(complex);
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_cells == 2 * expected.number_of_cells);
  CHECK(result.number_of_boundary_vertices == 2 * expected.number_of_boundary_vertices);
  CHECK(result.energy == Approx(expected.energy).epsilon(1e-6));
  CHECK(result.distortion.angle_max == Approx(expected.distortion.angle_max).epsilon(1e-3));
}

TEST_CASE("One component turned inside out is not hidden by another one")
{
  Numbered_mesh_3 mesh = doubled(cube_mesh(2), Vector3d(10, 0, 0));
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(mesh.source(0, v) < 5)
      mesh.target.col(v) = 3 * mesh.target.col(v);
    else
      mesh.target(2, v) *= -1;
  Cube_complex<> complex(mesh);
  const Parameterization_result result = parameterize(complex);
  CHECK(result.status == VMP::ERROR_INVERTED_TARGET_BOUNDARY);
  CHECK(result.message.find("-8") != std::string::npos);
  CHECK(complex.uvw.empty());
}

TEST_CASE("A single tetrahedron")
{
  Numbered_mesh_3 mesh;
  mesh.source.resize(3, 4);
  mesh.source << 0, 1, 0, 0,
                 0, 0, 1, 0,
                 0, 0, 0, 1;
  mesh.target = 2 * mesh.source;
  mesh.cells = {{0, 1, 2, 3}};
  Cube_complex<> complex(mesh);
  const Parameterization_result result = parameterize(complex);
  CHECK(result.status == VMP::OK);
  CHECK(result.distortion.volume_max == Approx(8 + 1. / 8));
  CHECK(complex.uvw == complex.target);
}

TEST_CASE("A ball meshed by Mesh_3")
{
  const auto ball = [](const Point_3& p) { return CGAL::squared_distance(p, Point_3(CGAL::ORIGIN)) - 1; };
  Domain domain = Domain::create_implicit_mesh_domain(ball, K::Sphere_3(CGAL::ORIGIN, 2.));
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = 0.3,
                                           params::facet_distance = 0.03, params::cell_radius_edge_ratio = 2,
                                           params::cell_size = 0.3);
  C3t3 c3t3 = mesh_body(domain, criteria);
  // its points are weighted; this one is outside the complex
  c3t3.triangulation().insert(Tr::Point(Point_3(1.9, 0, 0)));
  c3t3.rescan_after_load_of_triangulation();

  const auto bend = [](const Vertex_handle v) // preserves volume
  {
    const Point_3 p = v->point().point();
    return Point_3(p.x(), p.y() + 0.5 * p.x() * p.x(), p.z() + 0.5 * p.y());
  };
  std::unordered_map<Vertex_handle, Point_3> uvw;
  const Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(c3t3), boost::make_assoc_property_map(uvw),
    params::boundary_map(boost::make_function_property_map<Vertex_handle>(bend)));
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_cells == c3t3.number_of_cells_in_complex());

  std::unordered_set<Vertex_handle> vertices, boundary;
  double volume = 0, image_volume = 0;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    for(int i = 0; i < 4; ++i)
    {
      vertices.insert(c->vertex(i));
      if(!c3t3.is_in_complex(c->neighbor(i)))
        for(int k = 1; k < 4; ++k)
          boundary.insert(c->vertex((i + k) % 4));
    }
    const auto image = [&](const int i) { return uvw.at(c->vertex(i)); };
    CHECK(CGAL::orientation(image(0), image(1), image(2), image(3)) == CGAL::POSITIVE);
    image_volume += CGAL::volume(image(0), image(1), image(2), image(3));
    volume += c3t3.triangulation().tetrahedron(c).volume();
  }
  CHECK(uvw.size() == vertices.size());
  CHECK(result.number_of_vertices == vertices.size());
  CHECK(result.number_of_boundary_vertices == boundary.size());
  for(const Vertex_handle v : boundary)
    CHECK(uvw.at(v) == bend(v));
  CHECK(image_volume == Approx(volume).epsilon(0.05));
}
