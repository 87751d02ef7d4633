// Files to a soup and back, and a soup to a C3t3.
#include "catch.h"
#include "array_of_vtu_file.h"

#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <boost/property_map/property_map.hpp>

#ifndef _WIN32
#  include <fcntl.h>
#  include <sys/stat.h>
#  include <unistd.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <locale>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <unordered_map>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;
using Cell_handle = C3t3::Cell_handle;
using Soup = VMP::Tetrahedron_soup_3;
using Points = std::vector<std::array<double, 3> >;

namespace {

// The sentence of the Input_error that f() throws, or an empty string.
template <typename F>
std::string sentence(const F& f)
{
  try
  {
    f();
  }
  catch(const VMP::Input_error& error)
  {
    return error.what();
  }
  return "";
}

Soup read(const std::string& text)
{
  std::istringstream is(text);
  Soup soup;
  VMP::IO::read_MEDIT(is, soup);
  return soup;
}

std::string reading_error(const std::string& text)
{
  return sentence([&]() { read(text); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

bool has_same_bits(const Points& a, const Points& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

const std::string tetrahedron = "MeshVersionFormatted 1\nDimension 3\n"
                                "Vertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
                                "Tetrahedra\n1\n1 2 3 4 7\nEnd\n";

Soup single_cell()
{
  return read(tetrahedron);
}

void add_cell(Soup& soup, const std::array<std::size_t, 4>& cell, int reference)
{
  soup.cells.push_back(cell);
  soup.cell_references.push_back(reference);
}

// A box of nx * ny * nz unit cubes, each cut into six cells around its diagonal.
Soup box(std::size_t nx, std::size_t ny, std::size_t nz)
{
  Soup soup;
  for(std::size_t i = 0; i <= nx; ++i)
    for(std::size_t j = 0; j <= ny; ++j)
      for(std::size_t k = 0; k <= nz; ++k)
        soup.points.push_back({double(i), double(j), double(k)});

  const std::array<std::size_t, 3> step = {(ny + 1) * (nz + 1), nz + 1, 1};
  for(std::size_t i = 0; i < nx; ++i)
    for(std::size_t j = 0; j < ny; ++j)
      for(std::size_t k = 0; k < nz; ++k)
        for(std::size_t a = 0; a < 3; ++a)
        {
          const std::size_t origin = i * step[0] + j * step[1] + k;
          const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
          const std::size_t opposite = origin + step[0] + step[1] + step[2];
          add_cell(soup, {origin, origin + step[a], origin + step[a] + step[b], opposite}, 1);
          add_cell(soup, {origin, origin + step[a] + step[c], origin + step[a], opposite}, 1);
        }
  return soup;
}

struct Built
{
  explicit Built(const Soup& soup)
  {
    VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
  }

  C3t3 c3t3;
  std::vector<Vertex_handle> vertices;
  std::vector<Cell_handle> cells;
};

std::string building_error(const Soup& soup)
{
  return sentence([&]() { Built built(soup); });
}

// Checks what must hold for every soup. The Euler relation in Tds::is_valid() holds only for balls.
void check(const Built& built, const Soup& soup)
{
  const C3t3& c3t3 = built.c3t3;
  const Tr& tr = c3t3.triangulation();
  REQUIRE(tr.dimension() == 3);
  for(auto it = tr.tds().cells_begin(); it != tr.tds().cells_end(); ++it)
    REQUIRE(tr.tds().is_valid(Cell_handle(it)));
  for(auto it = tr.tds().vertices_begin(); it != tr.tds().vertices_end(); ++it)
    REQUIRE(tr.tds().is_valid(Vertex_handle(it)));

  REQUIRE(built.cells.size() == soup.cells.size());
  CHECK(c3t3.number_of_cells_in_complex() == soup.cells.size());
  CHECK(tr.number_of_finite_cells() == soup.cells.size());
  CHECK(std::size_t(std::distance(c3t3.facets_in_complex_begin(), c3t3.facets_in_complex_end()))
        == c3t3.number_of_facets_in_complex());

  REQUIRE(built.vertices.size() == soup.points.size());
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(built.vertices[v] != Vertex_handle())
      CHECK(tr.point(built.vertices[v]) == K::Point_3(soup.points[v][0], soup.points[v][1], soup.points[v][2]));
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    for(std::size_t v : soup.cells[c])
      CHECK(built.cells[c]->has_vertex(built.vertices[v]));
  for(Cell_handle c : built.cells)
    CHECK(tr.tetrahedron(c).orientation() == CGAL::POSITIVE);
}

Points targets_of(const std::string& lines, std::size_t number_of_vertices)
{
  std::istringstream is(lines);
  Points targets;
  VMP::IO::read_boundary_targets(is, number_of_vertices, targets);
  return targets;
}

std::string targets_error(const std::string& lines)
{
  return sentence([&]() { targets_of(lines, 4); });
}

} // namespace

TEST_CASE("A MEDIT file becomes a soup")
{
  const Soup soup = single_cell();
  CHECK(soup.points == Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(soup.cells == std::vector<std::array<std::size_t, 4> >{{0, 1, 2, 3}});
  CHECK(soup.cell_references == std::vector<int>{7});
  CHECK(soup.facets.empty());
}

TEST_CASE("The MEDIT reader takes sections in any order, comments and what it does not know")
{
  const Soup soup = read("# Made by hand\r\nMeshVersionFormatted\n2 # double\n"
                         "Corners 2 1\n2\nTetrahedra 1 1 2\n3 4 -2\nHexahedra 0\nNormals 1 0 0 nan\n"
                         "Triangles 2\n1 2 3 5\n4 3 2 0\nRequiredVertices\n1 1\n\n"
                         "Vertices 4 0 0 0 0 +1 0 0 0\t0 1e0 -0 0 #last is 4\n0 .0 1 0\nDimension\n3\n");
  CHECK(soup.points == single_cell().points);
  CHECK(std::signbit(soup.points[2][2]));
  CHECK(soup.cells == single_cell().cells);
  CHECK(soup.cell_references == std::vector<int>{-2});
  CHECK(soup.facets == std::vector<std::array<std::size_t, 3> >{{0, 1, 2}, {3, 2, 1}});
  CHECK(soup.facet_references == std::vector<int>{5, 0});
}

TEST_CASE("Each fault in a MEDIT file has a sentence with its line")
{
  CHECK(reading_error("") == "line 1: this is not an ASCII MEDIT file, because it does not begin with 'MeshVersionFormatted'");
  CHECK(reading_error("OFF\n4 4 6\n") == reading_error(""));
  for(const std::string version : {"0", "5"})
    CHECK(reading_error(replaced(tetrahedron, "Formatted 1", "Formatted " + version))
          == "line 1: the version of the format is " + version + " instead of 1 to 4");
  CHECK(reading_error(replaced(tetrahedron, "Dimension 3", "Dimension 2")) == "line 2: the dimension is not 3");

  // a truncated file
  CHECK(reading_error(tetrahedron.substr(0, tetrahedron.find("Tetrahedra")))
        == "the file contains no tetrahedron");
  CHECK(reading_error(tetrahedron.substr(0, tetrahedron.find(" 3 4 7")))
        == "line 11: the file ends where the number of a vertex should be");
  CHECK(reading_error(tetrahedron.substr(0, tetrahedron.find("\n1\n1 2 3 4")))
        == "line 9: the file ends where a number of elements should be");
  CHECK(reading_error(replaced(tetrahedron, "Vertices\n4", "Vertices\n5"))
        == "line 9: 'Tetrahedra' follows 4 instead of 5 elements of the section 'Vertices'");
  CHECK(reading_error(replaced(tetrahedron, "Tetrahedra\n1\n", "Tetrahedra\n1000000000000000000\n"))
        == "line 12: 'End' follows 1 instead of 1000000000000000000 elements of the section 'Tetrahedra'");
  CHECK(reading_error(replaced(replaced(tetrahedron, "Tetrahedra\n1\n", "Tetrahedra\n2\n"), "End\n", ""))
        == "line 12: the end of the file follows 1 instead of 2 elements of the section 'Tetrahedra'");

  // other cells
  CHECK(reading_error(replaced(tetrahedron, "End", "Hexahedra\n1\n1 2 3 4 1 2 3 5 0\nEnd"))
        == "line 14: vertex 5 does not exist, the vertices are numbered from 1 to 4");
  CHECK(reading_error(replaced(tetrahedron, "End", "Prisms 1\n"))
        == "line 14: the end of the file follows 0 instead of 1 elements of the section 'Prisms'");
  CHECK(reading_error(replaced(tetrahedron, "Tetrahedra\n1\n1 2 3 4 7", "Tetrahedra\n0"))
        == "the file contains no tetrahedron");

  // indices
  CHECK(reading_error(replaced(tetrahedron, "1 2 3 4", "1 2 3 5"))
        == "line 11: vertex 5 does not exist, the vertices are numbered from 1 to 4");
  CHECK(reading_error(replaced(tetrahedron, "1 2 3 4", "0 2 3 4"))
        == "line 11: vertex 0 does not exist, the vertices are numbered from 1 to 4");
  CHECK(reading_error(replaced(tetrahedron, "1 2 3 4", "1 -2 3 4"))
        == "line 11: vertex -2 does not exist, the vertices are numbered from 1 to 4");
  CHECK(reading_error(replaced(tetrahedron, "1 2 3 4", "1 2.5 3 4")) == "line 11: '2.5' is not the number of a vertex");
  CHECK(reading_error(replaced(tetrahedron, "3 4 7", "3 4 7000000000"))
        == "line 11: '7000000000' is not an integral reference");

  // numbers
  for(const std::string bad : {"nan", "NaN", "inf", "-inf", "1e999", "0x1", "1,5", "1.5.2", "++1", "+-1", "-", "one"})
    CHECK(reading_error(replaced(tetrahedron, "1 0 0 0", "1 " + bad + " 0 0"))
          == "line 6: '" + bad + "' is not a finite coordinate");
  CHECK(reading_error(replaced(tetrahedron, "1 0 0 0", "nan 0 0 0"))
        == "line 6: 'nan' is not a finite coordinate");
  CHECK(reading_error(replaced(tetrahedron, "Tetrahedra\n1", "Tetrahedra\n-1"))
        == "line 10: '-1' is not a number of elements");
  CHECK(reading_error(replaced(tetrahedron, "1 0 0 0", "\x1b[2J" + std::string(100, 'x') + " 0 0 0"))
        == "line 6: '?[2J" + std::string(26, 'x') + "...' is not a finite coordinate");

  // too much
  CHECK(reading_error(replaced(tetrahedron, "Vertices\n4", "Vertices\n3"))
        == "line 9: 'Tetrahedra' follows 4 instead of 3 elements of the section 'Vertices'");
  CHECK(reading_error(replaced(tetrahedron, "Tetrahedra", "Vertices\n1\nTetrahedra"))
        == "line 11: 'Tetrahedra' follows 4 instead of 5 elements of the section 'Vertices'");
  CHECK(reading_error(tetrahedron + "4 5 6") == "line 13: '4' follows the keyword 'End'");
}

TEST_CASE("Sections of a MEDIT file with the same keyword are joined")
{
  const Soup soup = read("MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0 Tetrahedra 1 1 2 3 4 11\n"
                         "Vertices 1 1 1 1 0 Edges 1 1 2 5 Tetrahedra 1 2 5 3 4 12 Edges 1 2 3 6 Triangles 0");
  CHECK(soup.points.size() == 5);
  CHECK(soup.cells == std::vector<std::array<std::size_t, 4> >{{0, 1, 2, 3}, {1, 4, 2, 3}});
  CHECK(soup.cell_references == std::vector<int>{11, 12});
  CHECK(soup.edges == std::vector<std::array<std::size_t, 2> >{{0, 1}, {1, 2}});
  CHECK(soup.edge_references == std::vector<int>{5, 6});
  std::ostringstream os;
  VMP::IO::write_MEDIT(os, soup);
  CHECK(read(os.str()).edges == soup.edges);
  CHECK(read(os.str()).edge_references == soup.edge_references);
}

TEST_CASE("Corners of a MEDIT file are kept, and edges count whether they are ridges or not")
{
  const std::string begin = "MeshVersionFormatted 2 Dimension 3 Corners 2 4 2 Ridges 1 2\n"
                            "Vertices 4 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0\n"
                            "Edges 2 1 2 5 2 3 6\nTetrahedra 1 1 2 3 4 11 Corners 1";
  const Soup soup = read(begin + " 1\n");
  CHECK(soup.corners == std::vector<std::size_t>{3, 1, 0});
  CHECK(soup.edges.size() == 2);
  CHECK(reading_error(begin + " 5\n") == "line 4: vertex 5 does not exist, the vertices are numbered from 1 to 4");
  std::ostringstream os;
  VMP::IO::write_MEDIT(os, soup);
  CHECK(read(os.str()).corners == soup.corners);

  C3t3 c3t3;
  std::vector<Vertex_handle> vertices;
  std::vector<Cell_handle> cells;
  VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
  CHECK(c3t3.number_of_vertices_in_complex() == 3);
  for(const std::size_t v : { 0, 1, 3 })
    CHECK((c3t3.is_in_complex(vertices[v]) && c3t3.in_dimension(vertices[v]) == 0));
  Soup again;
  VMP::mesh_complex_3_to_tetrahedron_soup(c3t3, again, vertices);
  std::set<std::array<double, 3> > points, expected = { soup.points[0], soup.points[1], soup.points[3] };
  for(const std::size_t v : again.corners)
    points.insert(again.points[v]);
  CHECK(points == expected);

  Soup wrong = soup;
  wrong.corners.push_back(4);
  CHECK(sentence([&] { VMP::IO::write_MEDIT(os, wrong); }) == "corner 3 (counted from 0) has a vertex 4 that does not exist");
}

TEST_CASE("Of second-order cells the corners are read, and it is noted")
{
  const Soup soup = read("MeshVersionFormatted 2\nDimension 3\nVertices\n11\n.5 0 0 0\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                         "0 0 1 0\n.5 .5 0 0\n0 .5 0 0\n0 0 .5 0\n.5 0 .5 0\n0 .5 .5 0\n9 9 9 0\n"
                         "TetrahedraP2\n1\n2 3 4 5 1 6 7 8 9 10 7\nTrianglesP2 1 2 3 4 1 6 7 3 EdgesP2 1 3 4 6 2 Corners 1 5\n");
  CHECK(soup.points == single_cell().points);
  CHECK(soup.cells == single_cell().cells);
  CHECK(soup.cell_references == std::vector<int>{7});
  CHECK(soup.facets == std::vector<std::array<std::size_t, 3> >{{0, 1, 2}});
  CHECK(soup.edges == std::vector<std::array<std::size_t, 2> >{{1, 2}});
  CHECK(soup.corners == std::vector<std::size_t>{3});
  REQUIRE(soup.notes.size() == 1);
  CHECK(soup.notes[0]
        == "the mesh has cells of a higher order. Only their corners are used; 7 other points are left out");
}

TEST_CASE("A surface is told from a mesh without tetrahedra")
{
  CHECK(reading_error(replaced(tetrahedron, "Tetrahedra\n1\n1 2 3 4 7", "Triangles\n1\n1 2 3 7"))
        == "the mesh is a surface with 1 triangle and no tetrahedron. A volume mesher fills it: pass it to 'tetgen -pqg', which "
           "writes a file *.1.mesh");
}

TEST_CASE("All versions of the format are read, with a byte order mark or without")
{
  const std::string mark = "\xEF\xBB\xBF";
  for(const std::string version : {"1", "2", "3", "4"})
    for(const std::string& first : {std::string(), mark})
      CHECK(read(first + replaced(tetrahedron, "Formatted 1", "Formatted " + version)).cells == single_cell().cells);
  CHECK(targets_of(mark + "1 1 2 3\n", 4)[1] == std::array<double, 3>{1, 2, 3});
  CHECK(reading_error(mark.substr(0, 2) + tetrahedron) != "");
}

namespace {

struct Impatient_visitor
{
  bool after_step(const VMP::Parameterization_step&) { return true; }
  bool goes_on() { return ++number_of_questions < 3; }
  int number_of_questions = 0;
};

} // namespace

TEST_CASE("Reading ends with the time, or when the visitor wants it")
{
  namespace params = CGAL::parameters;
  Soup soup = single_cell();
  const Points points = soup.points;
  std::istringstream text(tetrahedron + "# " + std::string(1 << 20, 'x')), lines("0 1 2 3\n");
  CHECK_FALSE(VMP::IO::read_MEDIT(text, soup, params::maximum_running_time(0)));
  Impatient_visitor visitor;
  CHECK_FALSE(VMP::IO::read_MEDIT(text, soup, params::visitor(std::ref(visitor))));
  CHECK(visitor.number_of_questions == 3);
  Points targets = points;
  CHECK_FALSE(VMP::IO::read_boundary_targets(lines, 4, targets, params::maximum_running_time(0)));
  CHECK(soup.points == points);
  CHECK(targets == points);
}

#ifndef _WIN32
TEST_CASE("A pipe is waited for, but not for ever")
{
  namespace params = CGAL::parameters;
  const std::string pipe = "test_files_pipe.mesh";
  std::remove(pipe.c_str());
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  Soup soup;
  const auto limit = params::maximum_running_time(0.1);
  CHECK_FALSE(VMP::IO::read_MEDIT(pipe, soup, limit)); // nobody has opened it

  const int end = open(pipe.c_str(), O_RDWR); // does not wait for a reader
  REQUIRE(write(end, tetrahedron.data(), tetrahedron.size()) == static_cast<ssize_t>(tetrahedron.size()));
  Impatient_visitor visitor;
  CHECK_FALSE(VMP::IO::read_MEDIT(pipe, soup, params::visitor(std::ref(visitor)))); // is not closed
  Points targets;
  CHECK_FALSE(VMP::IO::read_boundary_targets(pipe, single_cell(), targets, limit));
  close(end);

  std::thread writer([&]() { std::ofstream(pipe) << tetrahedron; });
  CHECK(VMP::IO::read_MEDIT(pipe, soup));
  writer.join();
  CHECK(soup.cells == single_cell().cells);
  std::remove(pipe.c_str());
}
#endif

TEST_CASE("A soup is unchanged by a failure to read")
{
  std::istringstream is("MeshVersionFormatted 1\nDimension 3\nVertices\n1\n0 0 zero 0\n");
  Soup soup = single_cell();
  CHECK_THROWS_AS(VMP::IO::read_MEDIT(is, soup), VMP::Input_error);
  CHECK(soup.cells.size() == 1);

  CHECK(sentence([&]() { VMP::IO::read_MEDIT("no/such/file.mesh", soup); })
        == "no/such/file.mesh: the file cannot be opened");
  CHECK(sentence([&]() { VMP::IO::read_MEDIT(".", soup); }) != "");
  CHECK(soup.cells.size() == 1);
}

TEST_CASE("Writing and reading a MEDIT file restores each bit, whatever the locale is")
{
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  Soup soup = box(2, 2, 2);
  const double tiny = std::numeric_limits<double>::denorm_min();
  soup.points[0] = {0.1, -0.0, 1. / 3};
  soup.points[1] = {tiny, (std::numeric_limits<double>::max)(), std::nextafter(1., 2.)};
  soup.cell_references[3] = -12;
  soup.facets = {{0, 1, 3}, {4, 1, 0}};
  soup.facet_references = {5, 0};

  std::ostringstream os;
  os.precision(3);
  VMP::IO::write_MEDIT(os, soup);
  const Soup copy = read(os.str());
  std::locale::global(before);
  CHECK(has_same_bits(copy.points, soup.points));
  CHECK(copy.cells == soup.cells);
  CHECK(copy.cell_references == soup.cell_references);
  CHECK(copy.facets == soup.facets);
  CHECK(copy.facet_references == soup.facet_references);
}

TEST_CASE("A VTU file has the map and its distortions, bit by bit")
{
  const Soup soup = single_cell();
  Points uvw = soup.points;
  uvw[1] = {2, 0, 0};
  uvw[2] = {0, 1. / 3, 0};
  std::ostringstream os;
  VMP::IO::write_VTU(os, soup, uvw);
  const std::string file = os.str();

  CHECK(file.find("NumberOfPoints=\"4\" NumberOfCells=\"1\"") != std::string::npos);
  CHECK(array_of(file, "Points") == std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  CHECK(array_of(file, "uvw") == std::vector<double>{0, 0, 0, 2, 0, 0, 0, 1. / 3, 0, 0, 0, 1});
  CHECK(array_of<std::int32_t>(file, "connectivity", "Int32") == std::vector<std::int32_t>{0, 1, 2, 3});
  CHECK(file.find("NumberOfComponents=\"1\"") == std::string::npos); // meshio converts no arrays that say so
  CHECK(array_of<std::int64_t>(file, "offsets", "Int64") == std::vector<std::int64_t>{4});
  CHECK(array_of<std::uint8_t>(file, "types", "UInt8") == std::vector<std::uint8_t>{10});
  CHECK(array_of<std::int32_t>(file, "reference", "Int32") == std::vector<std::int32_t>{7});
  CHECK(std::abs(array_of(file, "det_J")[0] - 2. / 3) < 1e-14);
  CHECK(std::abs(array_of(file, "volume_distortion")[0] - 2) < 1e-14); // the only cell, scaled to its volume
  CHECK(std::abs(array_of(file, "angle_distortion")[0] - (6 + 1. / 6)) < 1e-13);
}

TEST_CASE("The distortion of volumes in a VTU file is that of the map scaled to the volume of the source")
{
  Soup soup;
  soup.points = { {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1} };
  soup.cells = { {0, 1, 2, 3}, {0, 2, 1, 4} };
  soup.cell_references = {1, 2};
  Points uvw = soup.points;
  for(std::array<double, 3>& p : uvw)
    for(double& x : p)
      x *= 10;
  uvw[4][2] = -30; // volumes of 1000 and 3000 times those of the cells: 1/2 and 3/2 of the mean
  std::ostringstream os;
  VMP::IO::write_VTU(os, soup, uvw);
  const std::vector<double> distortions = array_of(os.str(), "volume_distortion");
  CHECK(std::abs(distortions[0] - (1. / 2 + 2)) < 1e-13);
  CHECK(std::abs(distortions[1] - (3. / 2 + 2. / 3)) < 1e-13);
  CHECK(std::abs(array_of(os.str(), "det_J")[1] - 3000) < 1e-9);
  CHECK(array_of<std::int32_t>(os.str(), "reference", "Int32") == std::vector<std::int32_t>{1, 2});
}

TEST_CASE("A VTU file is written of a C3t3 and a property map")
{
  const Built built(box(2, 1, 1));
  std::unordered_map<Vertex_handle, K::Point_3> uvw;
  for(Vertex_handle v : built.vertices)
    uvw[v] = K::Point_3(v->point().x(), 2 * v->point().y(), v->point().z());
  std::ostringstream os;
  VMP::IO::write_VTU(os, built.c3t3, boost::make_assoc_property_map(uvw));
  CHECK(array_of<std::int32_t>(os.str(), "reference", "Int32") == std::vector<std::int32_t>(12, 1));
  for(double det_J : array_of(os.str(), "det_J"))
    CHECK(std::abs(det_J - 2) < 1e-14);
}

TEST_CASE("A VTU file is written of arrays and of matrices, as of a soup without references")
{
  Soup soup = box(2, 1, 1);
  soup.cell_references.assign(soup.cells.size(), 0);
  Points uvw = soup.points;
  uvw[3][0] += 0.25;
  std::ostringstream expected, of_arrays, of_matrices;
  CHECK(VMP::IO::write_VTU(expected, soup, uvw));

  std::vector<K::Point_3> points;
  std::vector<std::array<int, 4> > cells;
  Eigen::MatrixXd images(uvw.size(), 3);
  for(std::size_t v = 0; v < uvw.size(); ++v)
  {
    points.emplace_back(soup.points[v][0], soup.points[v][1], soup.points[v][2]);
    images.row(v) = Eigen::RowVector3d(uvw[v].data());
  }
  Eigen::MatrixXi corners(soup.cells.size(), 4);
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    cells.push_back({ int(soup.cells[c][0]), int(soup.cells[c][1]), int(soup.cells[c][2]), int(soup.cells[c][3]) });
    corners.row(c) = Eigen::RowVector4i(cells[c].data());
  }
  CHECK(VMP::IO::write_VTU(of_arrays, points, cells, uvw));
  CHECK(of_arrays.str() == expected.str());
  CHECK(VMP::IO::write_VTU(of_matrices, soup.points, corners, images));
  CHECK(of_matrices.str() == expected.str());

  cells[0][2] = -1;
  CHECK_THROWS_AS(VMP::IO::write_VTU(of_arrays, points, cells, uvw), VMP::Input_error);
  uvw.pop_back();
  CHECK_THROWS_AS(VMP::IO::write_VTU(of_arrays, points, corners, uvw), CGAL::Precondition_exception);
}

TEST_CASE("Files are written by their names, and what is no mesh leaves them as they were")
{
  const std::string name = "written_by_name.vtu";
  const auto content = [&]()
  {
    std::ifstream file(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  };
  Soup soup = single_cell(), copy;
  std::ostringstream vtu, medit;
  VMP::IO::write_VTU(vtu, soup, soup.points);
  VMP::IO::write_MEDIT(medit, soup);
  CHECK(VMP::IO::write_VTU(name, soup, soup.points));
  CHECK(content() == vtu.str());
  CHECK(VMP::IO::read_VTU(name, copy));
  CHECK(has_same_bits(copy.points, soup.points));
  CHECK(copy.cells == soup.cells);
  std::istringstream is(vtu.str());
  CHECK(VMP::IO::read_VTU(is, copy));
  CHECK(copy.cell_references == soup.cell_references);
  CHECK_FALSE(VMP::IO::read_VTU(name, copy, CGAL::parameters::maximum_running_time(0)));

  soup.cells[0][0] = 4;
  CHECK_THROWS_AS(VMP::IO::write_VTU(name, soup, soup.points), VMP::Input_error);
  CHECK_THROWS_AS(VMP::IO::write_MEDIT(name, soup), VMP::Input_error);
  CHECK(content() == vtu.str());
  soup = single_cell();
  CHECK(VMP::IO::write_MEDIT(name, soup));
  CHECK(content() == medit.str());
  std::remove(name.c_str());
  CHECK_FALSE(VMP::IO::write_VTU("no/such/folder.vtu", soup, soup.points));
  CHECK_FALSE(VMP::IO::write_MEDIT("no/such/folder.mesh", soup));
  vtu.setstate(std::ios::badbit);
  CHECK_FALSE(VMP::IO::write_VTU(vtu, soup, soup.points));
  medit.setstate(std::ios::badbit);
  CHECK_FALSE(VMP::IO::write_MEDIT(medit, soup));
#ifndef _WIN32
  if(std::ifstream("/dev/full"))
    CHECK_FALSE(VMP::IO::write_MEDIT("/dev/full", soup));
#endif
}

namespace {

// Bytes of numbers, in the order of this machine or turned.
struct Bytes
{
  bool is_turned;
  std::string text = {};

  template <typename Number>
  Bytes& add(const Number number)
  {
    std::string bytes(sizeof(number), ' ');
    std::memcpy(&bytes[0], &number, sizeof(number));
    if(is_turned)
      std::reverse(bytes.begin(), bytes.end());
    text += bytes;
    return *this;
  }
};

// The cell of `tetrahedron` and a marked facet of it as a binary MEDIT file: with a section that is unknown, and the
// vertices behind all that names them.
std::string binary_MEDIT(const int version, const bool is_turned)
{
  Bytes file{is_turned};
  const auto integer = [&](const std::int64_t i)
  {
    version == 4 ? file.add(i) : file.add(static_cast<std::int32_t>(i));
  };
  const auto section = [&](const std::int32_t keyword, const auto& write)
  {
    Bytes content{is_turned};
    std::swap(file, content);
    write();
    std::swap(file, content);
    const std::size_t end = file.text.size() + 4 + (version >= 3 ? 8 : 4) + content.text.size();
    file.add(keyword);
    version >= 3 ? file.add(static_cast<std::int64_t>(end)) : file.add(static_cast<std::int32_t>(end));
    file.text += content.text;
  };
  file.add(std::int32_t(1)).add(std::int32_t(version));
  section(3, [&]() { file.add(std::int32_t(3)); });
  section(8, [&]()
  {
    for(const int i : { 1, 1, 2, 3, 4, -7 })
      integer(i);
  });
  section(77, [&]() { file.text += "what nobody knows"; });
  section(6, [&]()
  {
    for(const int i : { 1, 1, 2, 3, 5 })
      integer(i);
  });
  section(4, [&]()
  {
    integer(4);
    for(const std::array<double, 3>& p : single_cell().points)
    {
      for(const double x : p)
        version == 1 ? file.add(static_cast<float>(x / 4)) : file.add(x / 4);
      integer(0);
    }
  });
  section(54, []() {});
  return file.text;
}

// A file of VTK with the same cell and facet, with arrays as `array(type, values)` tells and `end` behind.
template <typename WriteArray>
std::string VTU(const std::string& attributes, const WriteArray& array, const std::string& end = "")
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" " + attributes
    + ">\n<!-- by hand -->\n<UnstructuredGrid><Piece NumberOfPoints='4' NumberOfCells='3'>\n<Points>"
    + array("Float64", "Points' NumberOfComponents='3", std::vector<double>{ 0, 0, 0, .25, 0, 0, 0, .25, 0, 0, 0, .25 })
    + "</Points><Cells>" + array("Int64", "connectivity", std::vector<std::int64_t>{ 3, 0, 1, 2, 0, 1, 2, 3 })
    + array("Int64", "offsets", std::vector<std::int64_t>{ 1, 4, 8 })
    + array("UInt8", "types", std::vector<std::uint8_t>{ 1, 5, 10 }) + "</Cells><CellData>"
    + array("Int32", "reference", std::vector<std::int32_t>{ 0, 5, -7 })
    + "</CellData></Piece></UnstructuredGrid>" + end + "</VTKFile>\n";
}

std::string base64(const std::string& bytes)
{
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t bits = 0;
    for(std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for(std::size_t k = 0; k < 4; ++k)
      result += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
  }
  return result;
}

Soup read_any(const std::string& text)
{
  return VMP::internal::read_soup(text, VMP::internal::Budget());
}

void check_small_cell(const Soup& soup)
{
  CHECK(soup.points == Points{{0, 0, 0}, {.25, 0, 0}, {0, .25, 0}, {0, 0, .25}});
  CHECK(soup.cells == single_cell().cells);
  CHECK(soup.cell_references == std::vector<int>{-7});
  CHECK(soup.facets == std::vector<std::array<std::size_t, 3> >{{0, 1, 2}});
  CHECK(soup.facet_references == std::vector<int>{5});
}

// The compressors that are compiled in, and none.
std::vector<std::string> compressors()
{
  std::vector<std::string> result = { "" };
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_ZLIB
  result.push_back("vtkZLibDataCompressor");
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_LZMA
  result.push_back("vtkLZMADataCompressor");
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_LZ4
  result.push_back("vtkLZ4DataCompressor");
#endif
  return result;
}

std::string compressed_block([[maybe_unused]] const std::string& compressor, [[maybe_unused]] const std::string& data)
{
  std::string result(data.size() + 1000, '\0');
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_ZLIB
  if(compressor == "vtkZLibDataCompressor")
  {
    uLongf size = result.size();
    REQUIRE(compress(reinterpret_cast<Bytef*>(&result[0]), &size, reinterpret_cast<const Bytef*>(&data[0]), data.size()) == Z_OK);
    result.resize(size);
  }
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_LZMA
  if(compressor == "vtkLZMADataCompressor")
  {
    std::size_t size = 0;
    REQUIRE(lzma_easy_buffer_encode(0, LZMA_CHECK_CRC32, nullptr, reinterpret_cast<const std::uint8_t*>(&data[0]), data.size(),
                                    reinterpret_cast<std::uint8_t*>(&result[0]), &size, result.size()) == LZMA_OK);
    result.resize(size);
  }
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_LZ4
  if(compressor == "vtkLZ4DataCompressor")
    result.resize(LZ4_compress_default(&data[0], &result[0], static_cast<int>(data.size()), static_cast<int>(result.size())));
#endif
  return result;
}

// An array in blocks of 10 bytes, as VTK compresses it: the sizes of blocks, and the blocks.
std::array<std::string, 2> compressed(const std::string& compressor, const std::string& data, const bool is_long,
                                      const bool is_turned)
{
  const std::size_t size = 10, number = (data.size() + size - 1) / size;
  std::vector<std::size_t> sizes = { number, size, data.size() % size };
  std::string blocks;
  for(std::size_t i = 0; i < number; ++i)
  {
    const std::string block = compressed_block(compressor, data.substr(i * size, size));
    sizes.push_back(block.size());
    blocks += block;
  }
  Bytes header{is_turned};
  for(const std::size_t s : sizes)
    is_long ? header.add(static_cast<std::uint64_t>(s)) : header.add(static_cast<std::uint32_t>(s));
  return { header.text, blocks };
}

// No part of a file, and no file with a changed byte, does any harm.
void check_spoilt_files(const std::string& file)
{
  for(std::size_t size = 0; size < file.size(); ++size)
    sentence([&]() { read_any(file.substr(0, size)); });
  for(std::size_t i = 0; i < file.size(); ++i)
    for(const char c : { '\0', '\1', '\x7F', '\xFF', '<', '"', '9' })
    {
      std::string spoilt = file;
      spoilt[i] = c;
      sentence([&]() { read_any(spoilt); });
    }
}

} // namespace

TEST_CASE("A binary MEDIT file is read in each version and in both orders of bytes")
{
  for(const int version : { 1, 2, 3, 4 })
    for(const bool is_turned : { false, true })
    {
      const std::string file = binary_MEDIT(version, is_turned);
      check_small_cell(read(file));
      check_spoilt_files(file);
      for(std::size_t size = 4; size + 20 < file.size(); ++size) // the last section only tells that it is the last one
        CHECK(reading_error(file.substr(0, size)) != "");
    }
}

TEST_CASE("Of a binary MEDIT file, sections of a kind are joined, and of second-order cells the corners are read")
{
  Bytes file{false};
  const auto numbers = [&](const std::initializer_list<std::int32_t> all)
  {
    for(const std::int32_t i : all)
      file.add(i);
  };
  const Points points = single_cell().points;
  numbers({ 1, 2, 3, 20, 3 });
  for(const std::size_t first : { 0, 2 })
  {
    numbers({ 4, static_cast<std::int32_t>(file.text.size()) + 12 + 2 * 28, 2 });
    for(std::size_t v = first; v < first + 2; ++v)
    {
      for(const double x : points[v])
        file.add(x);
      numbers({ 0 });
    }
  }
  const auto end = [&](const std::int32_t size) { return static_cast<std::int32_t>(file.text.size()) + 8 + 4 * size; };
  numbers({ 13, end(3), 2, 4, 2 });
  numbers({ 5, end(4), 1, 1, 2, 3 });
  numbers({ 30, end(12), 1, 1, 2, 3, 4, 1, 2, 3, 1, 2, 3, -7 });
  numbers({ 24, end(8), 1, 1, 2, 3, 1, 2, 3, 5 });
  numbers({ 54, 0 });
  const Soup soup = read(file.text);
  CHECK(soup.points == single_cell().points);
  CHECK(soup.cells == single_cell().cells);
  CHECK(soup.cell_references == std::vector<int>{-7});
  CHECK(soup.facet_references == std::vector<int>{5});
  CHECK(soup.edges == std::vector<std::array<std::size_t, 2> >{{0, 1}});
  CHECK(soup.corners == std::vector<std::size_t>{3, 1});
  CHECK(soup.notes.size() == 1);
}

TEST_CASE("Each fault in a binary MEDIT file has a sentence")
{
  const std::string file = binary_MEDIT(2, false);
  const auto with = [&](const std::size_t position, const std::int32_t number)
  {
    std::string result = file;
    std::memcpy(&result[position], &number, sizeof(number));
    return result;
  };
  // code, version; dimension: keyword, end, 3; tetrahedra: keyword, end, number, four vertices, reference
  CHECK(reading_error(with(4, 5)) == "the version of the format is 5 instead of 1 to 4");
  CHECK(reading_error(with(16, 2)) == "the dimension is not 3");
  CHECK(reading_error(with(24, 1000)) == "the section 8 ends at byte 1000 of " + std::to_string(file.size()));
  CHECK(reading_error(with(24, 28)) == "the section 8 ends at byte 28 of " + std::to_string(file.size()));
  CHECK(reading_error(with(28, 1000000000)) == "the file ends too early, it has not 1000000000 elements of a section");
  CHECK(reading_error(with(28, -1)) == "the file ends too early, it has not -1 elements of a section");
  CHECK(reading_error(with(32, 5)) == "vertex 5 does not exist, there are 4, counted from 1");
  CHECK(reading_error(with(32, 0)).find("vertex 0 does not exist") == 0);
  CHECK(reading_error(with(20, 10)) != ""); // a hexahedron with too few vertices
  CHECK(reading_error(with(20, 12)).find("the mesh is a surface with 1 triangle and no tetrahedron") == 0);
  std::string infinite = file;
  const double infinity = std::numeric_limits<double>::infinity();
  std::memcpy(&infinite[file.find(std::string("\0\0\0\0\0\0\xD0\x3F", 8))], &infinity, sizeof(infinity));
  CHECK(reading_error(infinite) == "a coordinate is not finite");
}

TEST_CASE("A VTU file is read in each of its forms")
{
  const auto tag = [](const std::string& type, const std::string& name, const std::string& rest)
  {
    return "<DataArray type=\"" + type + "\" Name='" + name + "' " + rest;
  };
  const auto array_as_text = [&](const std::string& type, const std::string& name, const auto& values)
  {
    std::ostringstream os;
    for(const auto x : values)
      os << " " << +x << "\n";
    return tag(type, name, "format=\"ascii\">") + os.str() + "</DataArray>\n";
  };
  check_small_cell(read_any(VTU("", array_as_text)));
  check_spoilt_files(VTU("", array_as_text));

  for(const std::string& compressor : compressors())
  for(const bool is_turned : { false, true })
  {
    const bool is_little = is_turned != VMP::internal::is_little_endian_machine;
    const std::string order = std::string("byte_order=\"") + (is_little ? "Little" : "Big") + "Endian\""
      + (compressor.empty() ? "" : " compressor=\"" + compressor + "\"");
    for(const bool is_long : { false, true })
    {
      const std::string attributes = order + (is_long ? " header_type=\"UInt64\"" : " header_type='UInt32'");
      const auto bytes_of = [&](const auto& values)
      {
        Bytes header{is_turned}, data{is_turned};
        for(const auto x : values)
          data.add(x);
        if(!compressor.empty())
          return compressed(compressor, data.text, is_long, is_turned);
        const std::size_t size = data.text.size();
        is_long ? header.add(static_cast<std::uint64_t>(size)) : header.add(static_cast<std::uint32_t>(size));
        return std::array{ header.text, data.text };
      };
      const auto array_in_place = [&](const std::string& type, const std::string& name, const auto& values)
      {
        const auto [header, data] = bytes_of(values);
        return tag(type, name, "format=\"binary\">\n  ") + base64(header + data) + "\n</DataArray>\n";
      };
      const auto array_in_two_parts = [&](const std::string& type, const std::string& name, const auto& values)
      {
        const auto [header, data] = bytes_of(values);
        return tag(type, name, "format=\"binary\">") + base64(header) + base64(data) + "</DataArray>\n";
      };
      check_small_cell(read_any(VTU(attributes, array_in_place)));
      check_small_cell(read_any(VTU(attributes, array_in_two_parts)));
      const bool are_spoilt = is_long == is_turned && (compressor.empty() || is_long); // others would tell nothing else
      if(are_spoilt)
        check_spoilt_files(VTU(attributes, array_in_place));
      for(const bool is_raw : { false, true })
      {
        std::string appended;
        const auto array_behind = [&](const std::string& type, const std::string& name, const auto& values)
        {
          const std::string offset = std::to_string(appended.size());
          const auto [header, data] = bytes_of(values);
          appended += is_raw ? header + data : base64(header + data);
          return tag(type, name, "format=\"appended\" offset=\"" + offset + "\"/>\n");
        };
        const std::string file = VTU(attributes, array_behind, "@");
        const std::size_t mark = file.find('@');
        const std::string whole = file.substr(0, mark) + "<AppendedData encoding=\"" + (is_raw ? "raw" : "base64")
          + "\">\n   _" + appended + "\n</AppendedData>" + file.substr(mark + 1);
        check_small_cell(read_any(whole));
        if(are_spoilt && is_raw)
          check_spoilt_files(whole);
      }
    }
  }

  // files that this package writes
  Soup soup = single_cell();
  soup.points[1][0] = 1. / 3;
  std::ostringstream os;
  VMP::IO::write_VTU(os, soup, soup.points);
  const Soup again = read_any(os.str());
  CHECK(has_same_bits(again.points, soup.points));
  CHECK(again.cells == soup.cells);
  CHECK(again.cell_references == soup.cell_references);
}

TEST_CASE("A VTU file keeps marked facets and edges, names of groups and data")
{
  Soup soup = box(1, 1, 1);
  soup.facets = { { 0, 4, 6 }, { 0, 1, 2 } }; // the second one is no facet of a cell
  soup.facet_references = { 5, 6 };
  soup.edges = { { 0, 7 } };
  soup.edge_references = { 8 };
  soup.group_names = { { { 3, 1 }, "bone <&\"'>" }, { { 2, 5 }, "wall" } };
  soup.point_data = { { "speed > 0", 3, false, {} }, { "number", 1, true, {} }, { "uvw", 1, true, std::vector<double>(8) } };
  for(int i = 0; i < 24; ++i)
    soup.point_data[0].values.push_back(i / 3.);
  soup.point_data[1].values = { 1, 2, 3, 4, 5, 6, 7, -8 };
  soup.cell_data = { { "stiffness", 1, false, { 1, 2, 3, 4, 5, 1e-300 } } };
  soup.facet_data = { { "pressure", 2, false, { 1, 2, 3, 4 } } };
  std::ostringstream os;
  VMP::IO::write_VTU(os, soup, soup.points);
  const Soup again = read_any(os.str());
  CHECK(again.facets == soup.facets);
  CHECK(again.facet_references == soup.facet_references);
  CHECK(again.edges == soup.edges);
  CHECK(again.edge_references == soup.edge_references);
  CHECK(again.group_names == soup.group_names);
  const auto data = [](const std::vector<VMP::Data_array_3>& arrays, const std::string& name)
  {
    const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const auto& array) { return array.name == name; });
    REQUIRE(found != arrays.end());
    return *found;
  };
  CHECK(data(again.point_data, "speed > 0").number_of_components == 3);
  CHECK(data(again.point_data, "speed > 0").values == soup.point_data[0].values);
  CHECK(data(again.point_data, "number").has_integers);
  CHECK(data(again.point_data, "number").values == soup.point_data[1].values);
  CHECK(data(again.point_data, "uvw").number_of_components == 3); // the map's
  CHECK(data(again.cell_data, "stiffness").values == soup.cell_data[0].values);
  CHECK(std::isnan(data(again.facet_data, "stiffness").values[1]));
  CHECK(data(again.facet_data, "pressure").values == soup.facet_data[0].values);
  CHECK(data(again.facet_data, "angle_distortion").values[0] == Approx(2));
  CHECK(std::isnan(data(again.facet_data, "angle_distortion").values[1]));
  CHECK(data(again.edge_data, "det_J").values[0] == Approx(1));
  CHECK(again.notes.empty());
}

TEST_CASE("Of second-order cells in a VTU file the corners are read, with their data")
{
  const auto array_as_text = [](const std::string& type, const std::string& name, const auto& values)
  {
    std::ostringstream os;
    for(const auto x : values)
      os << +x << " ";
    return "<DataArray type=\"" + type + "\" Name='" + name + "'>" + os.str() + "</DataArray>";
  };
  std::string file = VTU("", array_as_text);
  file = replaced(replaced(file, "3 0 1 2 0 1 2 3", "3 0 1 2 0 0 0 0 1 2 3 0 0 0 0 0 0"), "1 4 8", "1 7 17");
  file = replaced(file, "NumberOfPoints='4'", "NumberOfPoints='5'");
  file = replaced(replaced(file, "1 5 10", "1 22 24"), "0.25 0 0 0 0.25 0 0 0 0.25", "0.25 0 0 0 0.25 0 0 0 0.25 9 9 9");
  const std::string temperatures = array_as_text("Float32", "T", std::vector<double>{ 1, 2, 3, 4, 5 });
  file = replaced(file, "<Cells>", "<PointData>" + temperatures + "</PointData><Cells>");
  const Soup soup = read_any(file);
  check_small_cell(soup);
  CHECK(soup.point_data.at(0).values == std::vector<double>{ 1, 2, 3, 4 });
  CHECK(soup.notes.size() == 1);
}

// Two hexahedra, a prism and a pyramid that share quadrilaterals: a tower of two cubes with half a cube and a roof beside the
// lower one. Their vertices have any order.
const Points points_of_polyhedra = { { 1, 1, 2 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 1 }, { 0, 1, 0 }, { 1, 1, 1 }, { 0, 0, 1 },
                                     { 1, 1, 0 }, { 1, 0, 1 }, { 0, 0, 2 }, { 1, 0, 2 }, { 0, 1, 2 }, { 2, 0, 0 }, { 2, 0, 1 },
                                     { .5, 2, .5 } };
const std::vector<std::vector<std::size_t> > polyhedra = { { 1, 2, 7, 4, 6, 8, 5, 3 }, { 6, 8, 5, 3, 9, 10, 0, 11 },
                                                           { 2, 12, 7, 8, 13, 5 }, { 3, 5, 7, 4, 14 } };

// Checks the volume of a soup, its boundary, and the references of cells: 1 to 4 for those of the polyhedra.
void check_split_polyhedra(const Soup& soup)
{
  std::array<double, 4> volumes = {};
  Soup oriented = soup;
  CHECK(VMP::orient_tetrahedron_soup(oriented) == 0); // all cells are positive
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    std::array<Eigen::Vector3d, 4> p;
    for(std::size_t i = 0; i < 4; ++i)
      p[i] = Eigen::Vector3d(soup.points[soup.cells[c][i]].data());
    volumes[static_cast<std::size_t>(soup.cell_references[c] - 1)] += (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]) / 6;
  }
  for(std::size_t k = 0; k < 4; ++k)
    CHECK(volumes[k] == Approx(std::array{ 1., 1., .5, 1. / 3 }[k]));
  // if two cells split a common quadrilateral by different diagonals, there are more facets than the triangles of the boundary
  CHECK(VMP::internal::boundary_facets_3(soup.cells).size() == 2 * 8 + 2 * 2 + 2 + 4);
  CHECK(soup.facet_references == std::vector<int>{ 9, 9 });
  const auto facets = VMP::internal::boundary_facets_3(soup.cells);
  for(auto facet : soup.facets)
    CHECK(std::count_if(facets.begin(), facets.end(), [&](const auto& f)
                        { return VMP::internal::sorted(f) == VMP::internal::sorted(facet); }) == 1);
  REQUIRE(soup.notes.size() == 1);
  CHECK(soup.notes[0].find("4 hexahedra, prisms and pyramids are split into tetrahedra") == 0);
}

TEST_CASE("Hexahedra, prisms and pyramids are split into tetrahedra with common facets, and keep their references")
{
  std::ostringstream file;
  file << "MeshVersionFormatted 2\nDimension 3\nVertices " << points_of_polyhedra.size() << "\n";
  for(const auto& [x, y, z] : points_of_polyhedra)
    file << x << " " << y << " " << z << " 0\n";
  const auto add = [&](const char* const keyword, const std::size_t begin, const std::size_t end)
  {
    file << keyword << " " << end - begin << "\n";
    for(std::size_t c = begin; c < end; ++c)
    {
      for(const std::size_t v : polyhedra[c])
        file << v + 1 << " ";
      file << c + 1 << "\n";
    }
  };
  add("Hexahedra", 0, 2);
  add("Prisms", 2, 3);
  add("Pyramids", 3, 4);
  file << "Quadrilaterals 1\n2 5 8 3 9\nEnd\n"; // the bottom of the lower cube
  check_split_polyhedra(read(file.str()));

  Bytes bytes{false};
  const auto numbers = [&](const std::initializer_list<std::int32_t> all)
  {
    for(const std::int32_t i : all)
      bytes.add(i);
  };
  const auto begin_section = [&](const std::int32_t keyword, const std::size_t number, const std::size_t size_of_element)
  {
    const std::size_t end = bytes.text.size() + 12 + number * size_of_element;
    numbers({ keyword, static_cast<std::int32_t>(end), static_cast<std::int32_t>(number) });
  };
  numbers({ 1, 2, 3, 20, 3 });
  begin_section(4, points_of_polyhedra.size(), 28);
  for(const auto& p : points_of_polyhedra)
  {
    for(const double x : p)
      bytes.add(x);
    numbers({ 0 });
  }
  for(std::size_t c = 0; c < polyhedra.size(); ++c)
  {
    begin_section(std::array{ 10, 10, 9, 49 }[c], 1, 4 * (polyhedra[c].size() + 1));
    for(const std::size_t v : polyhedra[c])
      numbers({ static_cast<std::int32_t>(v + 1) });
    numbers({ static_cast<std::int32_t>(c + 1) });
  }
  begin_section(7, 1, 20);
  numbers({ 2, 5, 8, 3, 9, 54, 0 });
  check_split_polyhedra(read(bytes.text));

  std::ostringstream grid;
  const auto array_of = [&](const char* const type, const char* const name, const auto& values)
  {
    grid << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
         << (std::string(name) == "Points" ? 3 : 1) << "\" format=\"ascii\">";
    for(const auto& value : values)
      grid << value << " ";
    grid << "</DataArray>";
  };
  std::vector<double> coordinates;
  std::vector<std::size_t> connectivity, ends, types = { 12, 11, 13, 14, 9 }, references = { 1, 2, 3, 4, 9 };
  for(const auto& p : points_of_polyhedra)
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  auto cells = polyhedra;
  std::swap(cells[1][2], cells[1][3]); // a voxel of VTK
  std::swap(cells[1][6], cells[1][7]);
  std::swap(cells[2][1], cells[2][2]); // the base of a prism of VTK is seen from outside
  std::swap(cells[2][4], cells[2][5]);
  cells.push_back({ 1, 4, 7, 2 });
  for(const auto& cell : cells)
  {
    connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    ends.push_back(connectivity.size());
  }
  grid << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\"><UnstructuredGrid><Piece NumberOfPoints=\"" << coordinates.size() / 3
       << "\" NumberOfCells=\"" << cells.size() << "\"><Points>";
  array_of("Float64", "Points", coordinates);
  grid << "</Points><Cells>";
  array_of("Int64", "connectivity", connectivity);
  array_of("Int64", "offsets", ends);
  array_of("UInt8", "types", types);
  grid << "</Cells><CellData>";
  array_of("Int32", "reference", references);
  grid << "</CellData></Piece></UnstructuredGrid></VTKFile>";
  check_split_polyhedra(read_any(grid.str()));

  // a hexahedron whose top is an edge is a prism
  const Soup prism = read("MeshVersionFormatted 2\nDimension 3\nVertices 6\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n"
                          "Hexahedra 1\n1 2 3 4 5 6 6 5 3\nEnd\n");
  CHECK(prism.cells.size() == 3);
  CHECK(prism.cell_references == std::vector<int>{ 3, 3, 3 });
}

TEST_CASE("Each fault in a VTU file has a sentence")
{
  CHECK(sentence([]() { VMP::internal::decompress("vtkOtherDataCompressor", "block", 5); })
        == "the file is compressed by vtkOtherDataCompressor, which is not compiled in; write it without compression");
  for(const std::string& compressor : compressors())
    if(!compressor.empty())
    {
      CHECK(sentence([&]() { VMP::internal::decompress(compressor, "block", 5); }) == "a compressed block is damaged");
      CHECK(sentence([&]() { VMP::internal::decompress(compressor, "block", std::size_t(1) << 40); }) != "");
      CHECK(VMP::internal::decompress(compressor, compressed_block(compressor, "block"), 5) == "block");
    }
  const auto array_as_text = [](const std::string& type, const std::string& name, const auto& values)
  {
    std::ostringstream os;
    for(const auto x : values)
      os << +x << " ";
    return "<DataArray type=\"" + type + "\" Name='" + name + "'>" + os.str() + "</DataArray>";
  };
  const std::string file = VTU("", array_as_text);
  const auto error = [&](const std::string& part, const std::string& other)
  {
    return sentence([&]() { read_any(replaced(file, part, other)); });
  };
  CHECK(error("Points' Num", "Points' Num") == "");
  CHECK(error("UnstructuredGrid\" version", "PolyData\" version")
        == "this is not a VTK XML file of the type UnstructuredGrid");
  CHECK(error("1 5 10", "1 5 12") == "cell 2 (counted from 0) has only 4 vertices");
  CHECK(error("1 5 10", "1 5 42") == "the mesh is not tetrahedral, because it has polyhedra, such as cell 2 (counted from 0); "
                                     "ParaView's filter Tetrahedralize cuts cells into tetrahedra");
  CHECK(error("1 5 10", "1 5 99").find("it has cells of VTK's type 99, such as cell 2") != std::string::npos);
  CHECK(error("1 5 10", "1 5 5").find("the mesh is a surface with 2 triangles") == 0);
  CHECK(error("1 4 8", "1 4 80") == "the offset 80 of cell 2 (counted from 0) is wrong");
  CHECK(error("1 4 8", "1 4 2") == "the offset 2 of cell 2 (counted from 0) is wrong");
  CHECK(error("1 4 8", "1 4") == "the arrays of the cells are not equally long");
  CHECK(error("3 0 1 2", "3 0 1 -2") == "vertex -2 does not exist, there are 4, counted from 0");
  CHECK(error("3 0 1 2", "3 0 1 4") == "vertex 4 does not exist, there are 4, counted from 0");
  CHECK(error("0 5 -7", "0 5 7777777777") == "the reference 7777777777 is too large");
  CHECK(error("0.25 0 0", "0.25 0 nan").find("'nan' is not a number of an array") != std::string::npos);
  CHECK(error("0.25 0 0", "0.25 0") == "the array Points is not complete");
  CHECK(error("connectivity", "connections") == "there is no array Cells/connectivity");
  CHECK(error("Points='4'", "Points='5'") == "NumberOfPoints is 5, but the arrays have 4");
  CHECK(error("Cells='3'", "Cells='2'") == "NumberOfCells is 2, but the arrays have 3");
  CHECK(error("Cells='3'", "Cells='-3'") == "the attribute NumberOfCells is '-3' instead of a number");
  CHECK(error("Points' NumberOfComponents='3'", "Points' format='appended' offset='-1'")
        == "the attribute offset is '-1' instead of a number");
  CHECK(error("<Points>", "<Piece NumberOfPoints='0'><Points>")
        == "the mesh has several pieces: save it in ParaView as one piece, and use --merge-points");
  CHECK(error("<Points>", std::string("<PointData\0>", 12) + "<DataArray Name='a'>1</DataArray></PointData><Points>") == "");
  CHECK(sentence([&]() { read_any("<?xml version=\"1.0\"?><VTKFile"); }) == "the file ends within a tag");
  std::string deep = "<?xml version=\"1.0\"?>";
  for(int i = 0; i < 100000; ++i)
    deep += "<a>";
  CHECK(sentence([&]() { read_any(deep); }) != "");
}

TEST_CASE("A file is read whatever its name is, and the targets may be a mesh of any format")
{
  const std::string name = "test_files_any";
  const auto write = [&](const std::string& text) { std::ofstream(name, std::ios::binary) << text; };
  Points targets;
  std::ostringstream vtu;
  VMP::IO::write_VTU(vtu, single_cell(), single_cell().points);
  for(const std::string& text : { tetrahedron, vtu.str(), "# a comment\n" + tetrahedron })
  {
    Soup soup;
    write(text);
    CHECK(VMP::IO::read_tetrahedron_soup(name, soup));
    CHECK(soup.cells == single_cell().cells);
    CHECK(VMP::IO::read_boundary_targets(name, single_cell(), targets));
    CHECK(targets == single_cell().points);
  }
  write(binary_MEDIT(3, true));
  CHECK(VMP::IO::read_boundary_targets(name, single_cell(), targets));
  CHECK(targets[3] == std::array<double, 3>{0, 0, .25});
  write("3 1 2 3\n");
  CHECK(VMP::IO::read_boundary_targets(name, single_cell(), targets));
  CHECK(targets[3] == std::array<double, 3>{1, 2, 3});
  std::remove(name.c_str());
}

TEST_CASE("Cells of a soup that are all negative are turned, and a faulty soup is refused")
{
  Soup soup = single_cell();
  CHECK(!VMP::orient_tetrahedron_soup(soup));
  CHECK(soup.cells == single_cell().cells);
  std::swap(soup.cells[0][0], soup.cells[0][1]);
  CHECK(VMP::orient_tetrahedron_soup(soup));
  CHECK(soup.cells[0] == std::array<std::size_t, 4>{1, 0, 3, 2});
  soup.cells[0][0] = 4;
  CHECK(sentence([&]() { VMP::orient_tetrahedron_soup(soup); }) == "cell 0 (counted from 0) has a vertex 4 that does not exist");
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("Threads turn a soup, or find its first fault, as one does")
{
  Soup soup; // single cells, more than one thread gets at a time
  for(std::size_t i = 0; i < 10000; ++i)
  {
    for(const std::array<double, 3>& p : single_cell().points)
      soup.points.push_back({ p[0] + static_cast<double>(i), p[1], p[2] });
    soup.cells.push_back({ 4 * i + 1, 4 * i, 4 * i + 2, 4 * i + 3 });
    soup.cell_references.push_back(0);
  }
  Soup turned = soup;
  CHECK(VMP::orient_tetrahedron_soup(turned));
  CHECK(VMP::orient_tetrahedron_soup<CGAL::Parallel_tag>(soup));
  CHECK(soup.cells == turned.cells);

  for(const std::size_t c : {9000, 5000})
    soup.points[4 * c] = soup.points[4 * c + 1];
  CHECK(sentence([&] { VMP::orient_tetrahedron_soup<CGAL::Parallel_tag>(soup); })
        == sentence([&] { VMP::orient_tetrahedron_soup(soup); }));
  CHECK(sentence([&] { VMP::orient_tetrahedron_soup(soup); })
        == "2 cells have zero volume, among them cells 5000 and 9000 (counted from 0)");
}
#endif

TEST_CASE("Boundary targets are read from lines")
{
  const Points targets = targets_of("# targets\n2 0.1 -2e3 +5 # two\n\n0 1 2 3", 4);
  REQUIRE(targets.size() == 4);
  CHECK(targets[0] == std::array<double, 3>{1, 2, 3});
  CHECK(targets[2] == std::array<double, 3>{0.1, -2e3, 5});
  CHECK(std::isnan(targets[1][0]));
  CHECK(std::isnan(targets[3][2]));

  CHECK(targets_error("0 1 2 3\n4 1 2 3\n")
        == "line 2: vertex 4 does not exist, the mesh has 4 vertices, counted from 0");
  CHECK(targets_error("-1 1 2 3\n") == "line 1: vertex -1 does not exist, the mesh has 4 vertices, counted from 0");
  CHECK(targets_error("0 1 2 3\n1 1 2 3\n0 1 2 3\n") == "line 3: vertex 0 has a second line");
  CHECK(targets_error("0 1 2\n1 0 0 0\n") == "line 1: the line ends where a finite coordinate should be");
  CHECK(targets_error("0 1 2 3 4\n") == "line 1: '4' follows the three coordinates of vertex 0");
  CHECK(targets_error("0 1 nan 3\n") == "line 1: 'nan' is not a finite coordinate");
  CHECK(targets_error("0.5 1 2 3\n") == "line 1: '0.5' is not the index of a vertex");
}

TEST_CASE("Boundary targets are read from a mesh of the same connectivity")
{
  const std::string filename = "test_files_target.mesh";
  const Soup source = box(2, 2, 1);
  const auto error_of = [&](const Soup& target)
  {
    std::ofstream os(filename);
    VMP::IO::write_MEDIT(os, target);
    os.close();
    return sentence([&]()
    {
      Points targets;
      VMP::IO::read_boundary_targets(filename, source, targets);
      CHECK(has_same_bits(targets, target.points));
    });
  };

  Soup target = source;
  target.points[5] = {0.1, 0.2, 0.3};
  CHECK(error_of(target) == "");
  std::reverse(target.cells.begin(), target.cells.end());
  std::swap(target.cells[2][0], target.cells[2][3]);
  CHECK(error_of(target) == "");

  target.cells[0][0] = target.cells[0][0] == 0 ? 1 : 0;
  CHECK(error_of(target) == filename + ": the cells of the target join other vertices than those of the source");
  target = source;
  target.points.push_back({0, 0, 0});
  CHECK(error_of(target) == filename + ": the target has 19 vertices and the source has 18");
  CHECK(error_of(box(1, 1, 1)) == filename + ": the target has 8 vertices and the source has 18");
  target = source;
  add_cell(target, {0, 1, 2, 3}, 0);
  CHECK(error_of(target) == filename + ": the target has 25 cells and the source has 24");
  std::remove(filename.c_str());
}

TEST_CASE("A soup of one component becomes a valid C3t3 in the order of the soup")
{
  const Soup soup = box(3, 2, 4);
  const Built built(soup);
  check(built, soup);
  CHECK(built.c3t3.triangulation().tds().is_valid());
  CHECK(built.c3t3.number_of_facets_in_complex() == 4 * (3 * 2 + 2 * 4 + 3 * 4));
  CHECK(built.c3t3.triangulation().number_of_vertices() == soup.points.size());

  const auto on_boundary = [](const K::Point_3& p)
  {
    return p.x() == 0 || p.x() == 3 || p.y() == 0 || p.y() == 2 || p.z() == 0 || p.z() == 4;
  };
  for(Vertex_handle v : built.vertices)
    CHECK(built.c3t3.in_dimension(v) == (on_boundary(v->point()) ? 2 : 3));

  Soup copy;
  std::vector<Vertex_handle> vertices;
  VMP::mesh_complex_3_to_tetrahedron_soup(built.c3t3, copy, vertices);
  CHECK(copy.cells.size() == soup.cells.size());
  CHECK(vertices.size() == soup.points.size());
  CHECK(std::set<std::array<double, 3> >(copy.points.begin(), copy.points.end())
        == std::set<std::array<double, 3> >(soup.points.begin(), soup.points.end()));
}

TEST_CASE("A complex that was in use is replaced")
{
  Built built(box(2, 2, 2));
  const Soup soup = box(1, 1, 1);
  VMP::tetrahedron_soup_to_mesh_complex_3(soup, built.c3t3, built.vertices, built.cells);
  check(built, soup);
}

TEST_CASE("The points of another kernel")
{
  using Other_tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<CGAL::Simple_cartesian<double> >;
  CGAL::Mesh_complex_3_in_triangulation_3<Other_tr> c3t3;
  VMP::tetrahedron_soup_to_mesh_complex_3(box(1, 1, 1), c3t3);
  CHECK(c3t3.number_of_cells_in_complex() == 6);
}

TEST_CASE("References become subdomain and patch indices")
{
  Soup soup = box(2, 1, 1);
  for(std::size_t c = 0; c < 6; ++c)
    soup.cell_references[c] = 0;
  soup.facets = {{0, 2, 3}, {3, 1, 0}, {1, 3, 7}, {0, 1, 11}};   // the last one is not a facet of a cell
  soup.facet_references = {2, 9, 0, 4};
  const Built built(soup);
  check(built, soup);

  for(std::size_t c = 0; c < 12; ++c)
    CHECK(built.c3t3.subdomain_index(built.cells[c]) == (c < 6 ? 2 : 1));
  CHECK(built.c3t3.number_of_facets_in_complex() == 20 + 2);   // the interface has two
  std::size_t number_of_facets[10] = {};
  for(auto it = built.c3t3.facets_in_complex_begin(); it != built.c3t3.facets_in_complex_end(); ++it)
    ++number_of_facets[built.c3t3.surface_patch_index(*it)];
  CHECK(number_of_facets[2] == 1);
  CHECK(number_of_facets[9] == 1);
  CHECK(number_of_facets[1] == 20);
}

TEST_CASE("Several components and isolated vertices")
{
  Soup soup = box(1, 1, 1);
  soup.points.insert(soup.points.begin(), {{5, 5, 5}});
  for(std::array<std::size_t, 4>& cell : soup.cells)
    for(std::size_t& v : cell)
      ++v;
  const std::size_t n = soup.points.size();
  soup.points.insert(soup.points.end(), {{9, 0, 0}, {8, 8, 8}, {10, 0, 0}, {9, 1, 0}, {9, 0, 1}});
  add_cell(soup, {n, n + 2, n + 3, n + 4}, 1);

  const Built built(soup);
  check(built, soup);
  CHECK(built.c3t3.number_of_facets_in_complex() == 12 + 4);
  CHECK(built.c3t3.triangulation().number_of_vertices() == soup.points.size() - 2);
  CHECK(built.vertices[0] == Vertex_handle());
  CHECK(built.vertices[n + 1] == Vertex_handle());
}

TEST_CASE("A boundary with a non-manifold edge or vertex")
{
  // two cells that share the edge 0 1, and one more that shares the vertex 2
  Soup soup = single_cell();
  soup.points.insert(soup.points.end(), {{0, -1, 0}, {0, 0, -1}, {0, 2, 0}, {1, 2, 0}, {0, 2, 1}});
  add_cell(soup, {0, 1, 4, 5}, 7);
  add_cell(soup, {2, 6, 8, 7}, 7);
  const Built built(soup);
  check(built, soup);
  CHECK(built.c3t3.number_of_facets_in_complex() == 12);
}

TEST_CASE("A boundary with a handle")
{
  const Soup full = box(3, 3, 1);
  Soup ring = full;
  ring.cells.clear();
  ring.cell_references.clear();
  for(std::size_t c = 0; c < full.cells.size(); ++c)
    if(c / 6 != 4)
      add_cell(ring, full.cells[c], 1);
  const Built built(ring);
  check(built, ring);
  CHECK(built.c3t3.number_of_facets_in_complex() == 2 * (8 + 8 + 12 + 4));
}

TEST_CASE("Cells that are all negative are turned")
{
  Soup soup = box(2, 2, 2);
  for(std::array<std::size_t, 4>& cell : soup.cells)
    std::swap(cell[0], cell[1]);
  const Built built(soup);
  check(built, soup);
}

TEST_CASE("Each fault of a soup has a sentence")
{
  Soup soup = box(1, 1, 1);
  std::swap(soup.cells[2][0], soup.cells[2][1]);
  CHECK(building_error(soup)
        == "cell 2 (counted from 0) has the negative volume -0.166667, but cell 0 has the positive volume 0.166667");

  soup = single_cell();
  soup.points[3] = {0.25, 0.25, 0};
  CHECK(building_error(soup) == "cell 0 (counted from 0) has zero volume");
  soup.points[3] = {0.1, 0.2, std::numeric_limits<double>::denorm_min()};
  CHECK(building_error(soup) == "");
  soup.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(building_error(soup) == "vertex 3 (counted from 0) has a coordinate that is not finite");

  soup = single_cell();
  soup.cells[0][3] = 1;
  CHECK(building_error(soup) == "cell 0 (counted from 0) has the vertex 1 twice");
  soup.cells[0][3] = 4;
  CHECK(building_error(soup) == "cell 0 (counted from 0) has a vertex 4 that does not exist");
  soup = single_cell();
  soup.cell_references.clear();
  CHECK(building_error(soup) == "there is not one reference per cell, facet and edge");

  // a second and a third cell on the facet 1 2 3
  soup = single_cell();
  soup.points.push_back({1, 1, 1});
  add_cell(soup, {4, 1, 3, 2}, 7);
  CHECK(building_error(soup) == "");
  soup.points.push_back({2, 2, 2});
  add_cell(soup, {5, 1, 3, 2}, 7);
  CHECK(building_error(soup) == "more than two cells share a facet, among them cell 0, cell 1 and cell 2");
  soup.cells.erase(soup.cells.begin());
  soup.cell_references.pop_back();
  CHECK(building_error(soup) == "cell 0 and cell 1 overlap, they lie on the same side of their common facet");
  soup.cells[1] = {1, 4, 2, 3};
  CHECK(building_error(soup) == "cell 0 and cell 1 overlap, they lie on the same side of their common facet");
}

TEST_CASE("A complex is unchanged by a faulty soup")
{
  Built built(box(1, 1, 1));
  Soup soup = single_cell();
  soup.cells[0][3] = 1;
  CHECK_THROWS_AS(VMP::tetrahedron_soup_to_mesh_complex_3(soup, built.c3t3, built.vertices, built.cells),
                  VMP::Input_error);
  check(built, box(1, 1, 1));
}
