// Files beside a mesh: targets by a surface, conditions of vertices, features; and files that are written as a whole.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/Output_file.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/IO/surfaces.h>
#include <CGAL/Volume_mesh_parameterization/IO/vertex_conditions.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

namespace { namespace of_reading {

using Soup = VMP::Tetrahedron_soup_3;
using Points = std::vector<std::array<double, 3> >;
using Exact_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Soup cube_soup(const int n) { return source_soup(cube_mesh(n)); }

// The boundary of a mesh of 27 vertices with these in another order, moved by a vector.
Soup moved_surface(const Soup& soup, const std::array<double, 3>& d)
{
  Soup result;
  result.points.resize(27);
  const auto index = [](const std::size_t v) { return 5 * v % 27; };
  for(std::size_t v = 0; v < 27; ++v)
    for(std::size_t i = 0; i < 3; ++i)
      result.points[index(v)][i] = soup.points[v][i] + d[i];
  for(const auto& facet : VMP::internal::boundary_facets_3(soup.cells))
  {
    result.facets.emplace_back();
    for(std::size_t i = 0; i < 3; ++i)
      result.facets.back()[i] = index(facet[i]);
  }
  result.facet_references.resize(result.facets.size());
  return result;
}

std::string content_of(const std::string& name)
{
  std::ifstream is(name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
}

// Calls `read(name)` with a file of this content. Returns the sentence of its exception, or none.
template <typename Read>
std::string message_of(const std::string& content, const Read& read)
{
  const std::string name = "file_of_test_reading.txt";
  std::ofstream(name) << content;
  std::string result;
  try { read(name); }
  catch(const VMP::Input_error& error) { result = error.what(); }
  std::remove(name.c_str());
  return result;
}


TEST_CASE("Facets of a surface tell its vertices, by the way with the least displacement, which is noted")
{
  const Soup soup = cube_soup(2);
  Points targets;
  std::vector<std::string> notes;
  const auto np = params::output_iterator(std::back_inserter(notes));
  const Soup surface = moved_surface(soup, { 0.25, 0.125, 0 });
  REQUIRE(VMP::IO::boundary_targets_of_mesh(surface, soup, targets, np));
  for(const std::size_t v : VMP::boundary_vertices(soup.points, soup.cells))
    CHECK(targets[v] == std::array{ soup.points[v][0] + 0.25, soup.points[v][1] + 0.125, soup.points[v][2] });
  CHECK(std::count_if(targets.begin(), targets.end(), [](const auto& p) { return std::isnan(p[0]); }) == 1);
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].find("in several ways. The match with the least displacement is used") != std::string::npos);

  Soup mesh = soup; // with the same cells, in another order
  std::reverse(mesh.cells.begin(), mesh.cells.end());
  mesh.points[0][0] = 7;
  REQUIRE(VMP::IO::boundary_targets_of_mesh(mesh, soup, targets, np));
  CHECK(targets == mesh.points);
  CHECK(notes.size() == 1);
  CHECK_FALSE(VMP::IO::boundary_targets_of_mesh(surface, soup, targets, params::maximum_running_time(0)));
  CHECK(targets == mesh.points);
  mesh.facets = { { 0, 1, 99 } };
  mesh.facet_references = { 0 };
  CHECK_THROWS_AS(VMP::IO::boundary_targets_of_mesh(mesh, soup, targets), VMP::Input_error);
}

TEST_CASE("Conditions of vertices are read from lines, and a vertex of several lines has all of them")
{
  Soup soup = cube_soup(1);
  soup.facets = { { 0, 1, 2 } };
  soup.facet_references = { 5 };
  soup.group_names = { { { 2, 5 }, "wall" } };
  std::vector<VMP::Vertex_condition_3> conditions;
  Points targets(8, { nan, nan, nan });
  targets[7] = { 4, 5, 6 };
  const auto read = [&](const std::string& name) { VMP::IO::read_vertex_conditions(name, soup, conditions, targets); };
  CHECK(message_of("wall plane 0 0 2\n5 y=3 # the other way\nvertex 7 fixed\nvertex 0 x=-1\nvertex 4 free\n", read) == "");
  REQUIRE(conditions.size() == 8);
  const VMP::Vertex_condition_3::Kind kinds[] = { VMP::Vertex_condition_3::AT_TARGET, VMP::Vertex_condition_3::ON_LINE,
    VMP::Vertex_condition_3::ON_LINE, VMP::Vertex_condition_3::FREE, VMP::Vertex_condition_3::FREE,
    VMP::Vertex_condition_3::FREE, VMP::Vertex_condition_3::FREE, VMP::Vertex_condition_3::AT_TARGET };
  for(std::size_t v = 0; v < 8; ++v)
    CHECK(conditions[v].kind() == kinds[v]);
  CHECK(targets[0] == std::array<double, 3>{ -1, 3, soup.points[0][2] });
  CHECK(targets[1] == std::array<double, 3>{ soup.points[1][0], 3, soup.points[1][2] });
  CHECK(targets[7] == std::array<double, 3>{ 4, 5, 6 });

  CHECK(message_of("vertex 3 fixed\nvertex 0 x=2\nvertex 0 x=3\n", read).find(
          ": lines 2 and 3 contradict each other at vertex 0 (counted from 0): no point meets all of them") != std::string::npos);
  CHECK(conditions[3].kind() == VMP::Vertex_condition_3::FREE);
  CHECK(message_of("vertex 8 fixed\n", read).find(": line 1: there is no vertex 8") != std::string::npos);
  CHECK(message_of("vertex 1 fixed\nfloor free\n", read).find(": line 2: no triangle") != std::string::npos);
}

TEST_CASE("Vertices of a line slide on their triangles, or on the surface of a file")
{
  Soup soup = cube_soup(1);
  soup.facets = { { 0, 1, 2 }, { 1, 3, 2 } };
  soup.facet_references = { 5, 5 };
  std::ofstream("surface.off") << "OFF 4 2 0\n9 -9 -9\n9 9 -9\n9 9 9\n9 -9 9\n3 0 1 2\n3 0 2 3\n";
  std::vector<VMP::Vertex_condition_3> conditions;
  Points targets(8, { nan, nan, nan });
  const auto read = [&](const std::string& name) { VMP::IO::read_vertex_conditions(name, soup, conditions, targets); };
  CHECK(message_of("5 surface\nvertex 7 surface surface.off # of a plane\nvertex 6 surface 'surface.off'\nvertex 6 z=0.25\n", read)
        == "");
  REQUIRE(conditions.size() == 8);
  for(std::size_t v = 0; v < 4; ++v)
  {
    CHECK(conditions[v].kind() == VMP::Vertex_condition_3::ON_SURFACE);
    CHECK(targets[v] == soup.points[v]);
  }
  CHECK(conditions[7].kind() == VMP::Vertex_condition_3::ON_SURFACE);
  CHECK(targets[7][0] == 9);
  CHECK(std::hypot(targets[7][1] - soup.points[7][1], targets[7][2] - soup.points[7][2]) < 1e-12);
  CHECK(conditions[6].kind() == VMP::Vertex_condition_3::ON_CURVE);
  CHECK((std::abs(targets[6][0] - 9) < 1e-12 && targets[6][2] == 0.25));

  CHECK(message_of("vertex 1 surface\n", read).find("a vertex has no surface of its own") != std::string::npos);
  CHECK(message_of("5 surface none.off\n", read).find("none.off: the file cannot be opened") != std::string::npos);
  CHECK(message_of("5 surface surface.off x\n", read).find("'x' follows the condition") != std::string::npos);
  CHECK(message_of("5 surface surface.off\nvertex 0 x=1\n5 x=8\n", read).find("contradict each other") != std::string::npos);
}

TEST_CASE("Names of groups may be those of several, look like numbers, and have blanks in quotes")
{
  Soup soup = cube_soup(1);
  soup.facets = { { 0, 1, 2 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 6, 7 } };
  soup.facet_references = { 1, 2, 3, 4 };
  soup.group_names = { { { 2, 2 }, "1" }, { { 2, 3 }, "top wall" }, { { 2, 4 }, "top wall" }, { { 3, 1 }, "floor" } };
  const auto fixed_vertices = [&](const std::string& text)
  {
    std::vector<VMP::Vertex_condition_3> conditions;
    Points targets(8, { nan, nan, nan });
    const auto read = [&](const std::string& name) { VMP::IO::read_vertex_conditions(name, soup, conditions, targets); };
    CHECK(message_of(text, read) == "");
    std::vector<std::size_t> result;
    for(std::size_t v = 0; v < conditions.size(); ++v)
      if(conditions[v].kind() == VMP::Vertex_condition_3::AT_TARGET)
        result.push_back(v);
    return result;
  };
  CHECK(fixed_vertices("1 fixed\n") == std::vector<std::size_t>{ 0, 1, 2 });
  CHECK(fixed_vertices("\"1\" fixed\n") == std::vector<std::size_t>{ 1, 2, 3 });
  CHECK(fixed_vertices("'top wall' fixed # both\r\n") == std::vector<std::size_t>{ 4, 5, 6, 7 });
  CHECK(VMP::conditions_of_patches(soup, { { std::string("top wall"), VMP::Patch_condition_3::in_place() } }).conditions[7].kind()
        == VMP::Vertex_condition_3::AT_TARGET);

  std::vector<VMP::Vertex_condition_3> conditions;
  Points targets(8, { nan, nan, nan });
  const auto read = [&](const std::string& name) { VMP::IO::read_vertex_conditions(name, soup, conditions, targets); };
  CHECK(message_of("top wall fixed\n", read).find(": line 1: no triangle of the mesh has the reference or the name 'top'. "
    "There are 1, '1', 'top wall' and 'top wall'; names with blanks need quotes") != std::string::npos);
  CHECK(message_of("\nfloor fixed\n", read).find(": line 2: no triangle") != std::string::npos);
  CHECK(message_of("'top wall fixed\n1 fixed'\n", read).find(": line 1: the quote before 'top wall fixed' is not closed")
        != std::string::npos);
}

TEST_CASE("Planes of a vertex are met whatever their order, or refused with their lines")
{
  Soup soup = source_soup(cube_mesh(2, 0));
  for(auto& p : soup.points)
    p[0] += 1e9;
  std::vector<VMP::Vertex_condition_3> conditions;
  Points targets;
  const auto read = [&](const std::string& name) { VMP::IO::read_vertex_conditions(name, soup, conditions, targets); };
  const auto message = [&](const std::string& text)
  {
    conditions.clear();
    targets.assign(soup.points.size(), { nan, nan, nan });
    return message_of(text, read);
  };
  // relative to the body, whatever its place is
  CHECK(message("vertex 0 x=1000000000\nvertex 0 x=1000000001.5").find("lines 1 and 2 contradict") != std::string::npos);
  REQUIRE(soup.points[0][0] == 1e9 + 1);
  CHECK(message("vertex 0 x=1000000001\nvertex 0 plane 2 0 0\nvertex 0 x=1.000000001e9") == "");
  CHECK(message("vertex 0 plane 1.7e308 1.7e308 1.7e308\nvertex 1 plane 5e-324 5e-324 0\n") == "");
  CHECK(conditions[0].direction() == std::array<double, 3>{ 1, 1, 1 });
  CHECK(conditions[1].direction() == std::array<double, 3>{ 1, 1, 0 });

  targets.clear();
  std::vector<std::string> lines = { "vertex 0 plane 1 2 3\n", "vertex 0 plane 3 -1 0.1\n", "vertex 0 x=0.1\n" };
  Points found;
  do
  {
    CHECK(message(lines[0] + lines[1] + lines[2]) == "");
    found.push_back(targets[0]);
  }
  while(std::next_permutation(lines.begin(), lines.end()));
  CHECK(found == Points(6, found[0]));
  CHECK(found[0][0] == 0.1);
  CHECK(message("vertex 0 plane 1 0 0\nvertex 0 plane 1 1e-8 0\n") == "");
  CHECK(conditions[0].direction() == std::array<double, 3>{ 0, 0, 1 });
  CHECK(message("vertex 3 free\nvertex 0 plane 1 0 0\nvertex 0 plane 1 1e-10 0\n").find(
          "lines 2 and 3 have nearly parallel planes") != std::string::npos);
  CHECK(message("vertex 0 y=0\nvertex 0 x=2\nvertex 0 plane 1 1 0\nvertex 1 x=1").find("lines 1, 2 and 3 contradict")
        != std::string::npos);
}

TEST_CASE("Sharp edges are those of an angle, or those that are marked, for example by a file")
{
  Soup soup = cube_soup(2);
  const auto sharp_edges = [&] { return VMP::sharp_boundary_edges(soup.points, soup.cells, soup.edges); };
  CHECK(sharp_edges().size() == 24);
  for(const auto& [v, w] : sharp_edges()) // on two faces of the cube
  {
    std::size_t number_of_faces = 0;
    for(std::size_t i = 0; i < 3; ++i)
      number_of_faces += soup.points[v][i] == soup.points[w][i] && std::fmod(soup.points[v][i], 2) == 0;
    CHECK(number_of_faces == 2);
  }
  const auto [v, w] = sharp_edges()[5];
  const auto read = [&](const std::string& name) { VMP::IO::read_features(name, soup); };
  CHECK(message_of("1\n" + std::to_string(w) + " " + std::to_string(v) + "\n", read) == "");
  CHECK(soup.edges == std::vector<std::array<std::size_t, 2> >{ { w, v } });
  CHECK(soup.edge_references == std::vector<int>{ 1 });
  CHECK(sharp_edges() == std::vector<std::array<std::size_t, 2> >{ { v, w } });
  CHECK(message_of("3 27\n", read).find(": line 1: there is no edge between the vertices 3 and 27") != std::string::npos);
  CHECK(soup.edges.size() == 1);
}

TEST_CASE("A file gets all of its content at once, or stays as it was")
{
  const std::string folder = "folder_of_test_reading", name = folder + "/file.txt";
  std::filesystem::create_directory(folder);
  const auto number_of_files = [&] { return std::distance(std::filesystem::directory_iterator(folder), {}); };
  {
    VMP::IO::Output_file file(name);
    file.stream() << "first";
    CHECK(content_of(name).empty());
    CHECK(number_of_files() == 1);
  }
  CHECK(number_of_files() == 0);
  for(const char* const content : { "second", "third" })
  {
    VMP::IO::Output_file file(name);
    file.stream() << content;
    file.commit();
    CHECK(content_of(name) == content);
  }
  std::filesystem::create_symlink("file.txt", folder + "/link");
  CHECK(VMP::IO::Output_file::path(folder + "/link") == name);
  CHECK_FALSE(VMP::IO::Output_file::is_stream(folder + "/link"));
  CHECK(VMP::IO::write_MEDIT(folder + "/link", cube_soup(1)));
  CHECK(std::filesystem::is_symlink(folder + "/link"));
  CHECK(content_of(name).find("MeshVersionFormatted") == 0);
  CHECK(number_of_files() == 2);
  CHECK_FALSE(VMP::IO::write_MEDIT("/dev/full", cube_soup(1)));
  const auto fail = [](std::ostream&) { throw std::runtime_error("a failure of a property map"); };
  CHECK_THROWS_WITH(VMP::internal::write_file(name, fail), "a failure of a property map");
  CHECK(content_of(name).find("MeshVersionFormatted") == 0);

  const std::string pipe = folder + "/pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  VMP::IO::Output_file file(pipe);
  CHECK(VMP::IO::Output_file::is_stream(pipe));
  file.stream() << "content";
  CHECK_THROWS_AS(file.commit(params::maximum_running_time(0)), VMP::IO::Unread_output);
  std::string received;
  std::thread reader([&] { received = content_of(pipe); });
  file.commit();
  reader.join();
  CHECK(received == "content");
  std::filesystem::remove_all(folder);
}

// CGAL allocates what counts of a file ask for.
TEST_CASE("A surface whose counts are too large for its file is refused")
{
  const std::string name = "surface_of_test_reading.off";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const auto read = [&](const std::string& counts, const std::string& triangle)
  {
    std::ofstream(name) << "OFF\n" << counts << points << triangle;
    return VMP::internal::read_surface(name, VMP::internal::Budget());
  };
  CHECK(read("3 1 0\n", "3 0 1 2\n").facets == std::vector<std::array<std::size_t, 3> >{ { 0, 1, 2 } });
  CHECK_THROWS_WITH(VMP::internal::read_surface("missing.off", VMP::internal::Budget()), "the file cannot be opened");
  const std::string message = "the surface cannot be read: a number of points, of faces or of their vertices is too large";
  CHECK_THROWS_WITH(read("900000000 1 0\n", "3 0 1 2\n"), message);
  CHECK_THROWS_WITH(read("3 900000000 0\n", "3 0 1 2\n"), message);
  CHECK_THROWS_WITH(read("3 1 0\n", "900000000 0 1 2\n"), message);
  std::filesystem::remove(name);
}

// Volume that a surface encloses if its triangles are seen counterclockwise from outside.
double volume_of(const Soup& surface)
{
  double result = 0;
  for(const auto& [u, v, w] : surface.facets)
  {
    const auto &p = surface.points[u], &q = surface.points[v], &r = surface.points[w];
    result += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0])) / 6;
  }
  return result;
}

TEST_CASE("Surfaces as other programs write them enclose a body")
{
  const auto read = [](const std::string& content, const std::string& extension, const double distance = 0)
  {
    const std::string name = "surface_of_test_reading" + extension;
    std::ofstream(name) << content;
    Soup result;
    VMP::IO::read_closed_surface(name, result, distance);
    std::filesystem::remove(name);
    return result;
  };
  // a unit cube by quadrangles, each with points of its own, which differ by a distance
  const auto cube = [](const double distance)
  {
    std::ostringstream points, faces;
    int number = 0;
    for(const std::array<int, 4>& q : { std::array{ 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
                                        { 1, 3, 7, 5 } })
    {
      faces << "f";
      for(const int i : q)
      {
        points << "v " << (i & 1) + distance * (number % 3) << " " << (i >> 1 & 1) << " " << (i >> 2) << "\n";
        faces << " \\\n " << ++number; // a line of OBJ that goes on
      }
      faces << "\n";
    }
    return points.str() + "v 7 7 7\n" + faces.str(); // with a point that is not used
  };
  for(const double distance : { 0., 1e-10 })
  {
    const Soup surface = read(cube(distance), ".obj");
    CHECK(surface.points.size() == 8);
    CHECK(volume_of(surface) == Approx(1));
    REQUIRE(surface.notes.size() == 1);
    CHECK(surface.notes[0].find("points are joined to others") != std::string::npos);
  }
  CHECK_THROWS_WITH(read(cube(1e-3), ".obj"), Catch::Matchers::Contains("is not closed, because the edge between the points (")
                                                && Catch::Matchers::Contains("--merge-points=DISTANCE"));
  CHECK(volume_of(read(cube(1e-3), ".obj", 0.01)) == Approx(1).margin(0.01));

  // an L of two concave polygons and six quadrangles, of any orientation
  const std::string L = "OFF\n12 8 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n"
                        "6 5 4 3 2 1 0\n6 7 8 9 10 11 6\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n";
  CHECK(volume_of(read(L + "4 5 0 6 11\n", ".off")) == Approx(3));
  const Soup turned = read(L + "4 5 11 6 0\n", ".off");
  CHECK(volume_of(turned) == Approx(3));
  CHECK(turned.notes == std::vector<std::string>{ "some triangles of the surface were turned over, and are turned" });
  const std::string tetrahedron = "OFF\n4 4 0\n0 0 0\n3 0 0\n0 2 0\n0 0 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n"; // inside out
  CHECK(volume_of(read(tetrahedron + "3 1 3 2\n", ".off")) == Approx(1));
  CHECK(volume_of(read(tetrahedron + "3 1 2 3\n", ".off")) == Approx(1));

  // a tetrahedron with a point on an edge, where a triangle has no area
  const Soup flat = read("OFF\n5 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n.5 0 0\n3 0 2 1\n3 0 4 3\n3 4 1 3\n3 1 2 3\n3 0 3 2\n3 0 1 4\n",
                         ".off");
  // and with another one on the same edge of that triangle, which makes it a polygon without area
  const Soup polygon = read("OFF\n6 7 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n.5 0 0\n.25 0 0\n3 0 2 1\n3 0 4 3\n3 4 1 3\n"
                            "3 1 2 3\n3 0 3 2\n4 0 1 4 5\n3 4 0 5\n", ".off");
  // and with a point that is on the edge up to rounding
  const Soup rounded = read("OFF\n5 6 0\n0 0 0\n1 0 .3\n0 1 0\n0 0 1\n.1 0 .03\n3 0 2 1\n3 0 4 3\n3 4 1 3\n3 1 2 3\n3 0 3 2\n"
                            "3 0 1 4\n", ".off");
  CHECK_FALSE(CGAL::collinear(Exact_point(0, 0, 0), Exact_point(.1, 0, .03), Exact_point(1, 0, .3)));
  CHECK(std::find(rounded.facets.begin(), rounded.facets.end(), std::array<std::size_t, 3>{ 0, 1, 4 }) == rounded.facets.end());
  for(const Soup& surface : { flat, polygon, rounded })
  {
    CHECK(surface.facets.size() == 6);
    CHECK(surface.points.size() == 5);
    for(const auto& [u, v, w] : surface.facets)
      CHECK_FALSE(CGAL::collinear(Exact_point(surface.points[u][0], surface.points[u][1], surface.points[u][2]),
                                  Exact_point(surface.points[v][0], surface.points[v][1], surface.points[v][2]),
                                  Exact_point(surface.points[w][0], surface.points[w][1], surface.points[w][2])));
  }

  std::string STL = "solid a b\n";
  for(const std::string vertices : { "0 0 0 0 1 0 1 0 0", "0 0 0 1 0 0 0 0 1", "1 0 0 0 1 0 0 0 1", "0 0 0 0 0 1 0 1 0" })
  {
    std::istringstream is(vertices);
    STL += "facet normal 0 0 0\nouter loop\n";
    for(std::string x, y, z; is >> x >> y >> z;)
      STL += "vertex " + x + " " + y + " " + z + "\n";
    STL += "endloop\nendfacet\n";
  }
  CHECK(volume_of(read(STL + "end solid\n", ".stl")) == Approx(1. / 6));
  CHECK_THROWS_WITH(read("OFF\n4 2 0\n0 0 3\n1 0 3\n1 1 3\n0 1 3\n3 0 1 2\n3 0 2 3\n", ".off"),
                    Catch::Matchers::Contains("it is in the plane z = 3"));
}

} } // namespace
