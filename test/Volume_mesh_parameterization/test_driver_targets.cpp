// The program parameterize_mesh_file: files with the images of vertices.
#include "driver.h"

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

TEST_CASE("Targets of vertices inside are met")
{
  const Folder folder;
  const Soup source = cube(4);
  folder.write("source.mesh", source);
  const auto inside = std::find(source.points.begin(), source.points.end(), Point{2, 2, 2}) - source.points.begin();
  folder.write("target.txt", boundary_lines(source, 4, [](const Point& p) { return p; }) + std::to_string(inside) + " 2.25 2 2\n");
  CHECK(folder.run("source.mesh target.txt -o map.mesh --report report.json") == 0);
  CHECK(folder.soup("map.mesh").points[inside] == Point{2.25, 2, 2});
  CHECK(number(folder.text("report.json"), "targets_inside") == 1);
  CHECK(folder.text("stdout").find("1 target of an interior vertex is met\n") != std::string::npos);
  CHECK(number(folder.text("report.json"), "missed_targets") == 0);

  // two vertices inside change places, which no map follows
  std::ostringstream lines;
  for(std::size_t v = 0; v < source.points.size(); ++v)
  {
    const Point p = source.points[v] == Point{1, 1, 1} ? Point{3, 3, 3} : source.points[v] == Point{3, 3, 3} ? Point{1, 1, 1}
                  : source.points[v];
    lines << v << " " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  folder.write("target.txt", lines.str());
  CHECK(folder.run("source.mesh target.txt --inside met -o map.mesh --report report.json") == 1);
  const std::vector<Point> map = folder.soup("map.mesh").points;
  std::size_t number_met = 0;
  for(std::size_t v = 0; v < map.size(); ++v)
  {
    const Point p = source.points[v] == Point{1, 1, 1} ? Point{3, 3, 3} : source.points[v] == Point{3, 3, 3} ? Point{1, 1, 1}
                  : source.points[v];
    number_met += !is_on_boundary(source.points[v], 4) && map[v] == p;
  }
  CHECK(number_met < 27);
  CHECK(number(folder.text("report.json"), "targets_inside") == number_met);
  CHECK(number(folder.text("report.json"), "missed_targets") == 27 - number_met);
  CHECK(folder.text("stdout").find(std::to_string(27 - number_met) + " targets of interior vertices are missed\n")
        != std::string::npos);
}

TEST_CASE("Of a copy of the mesh, vertices at interfaces are met if they have moved")
{
  const Folder folder;
  Soup source = cube(4), target = source;
  const auto is_of_inclusion = [](const Point& p)
  { return std::all_of(p.begin(), p.end(), [](const double x) { return x >= 1 && x <= 3; }); };
  for(Point& p : target.points)
    p[0] += is_of_inclusion(p) ? 0.25 : 0;
  folder.write("one_material.mesh", source);
  for(std::size_t c = 0; c < source.cells.size(); ++c)
    source.cell_references[c] = std::all_of(source.cells[c].begin(), source.cells[c].end(), [&](const std::size_t v)
                                            { return is_of_inclusion(source.points[v]); }) ? 2 : 1;
  folder.write("source.mesh", source);
  folder.write("target.mesh", target);
  const auto check = [&](const std::string& arguments, const std::size_t met, const std::size_t free)
  {
    CAPTURE(arguments);
    REQUIRE(folder.run(arguments + " -o map.mesh --report report.json") == 0);
    CHECK(number(folder.text("report.json"), "targets_inside") == met);
    CHECK(number(folder.text("report.json"), "free_targets") == free);
    const std::string targets
      = free == 1 ? "1 target of an interior vertex is" : std::to_string(free) + " targets of interior vertices are";
    CHECK((folder.text("stdout").find(targets + " ignored; --inside met prescribes") != std::string::npos) == (free > 0));
  };
  check("source.mesh target.mesh --energy symmetric_dirichlet", 26, 1);
  const std::vector<Point> map = folder.soup("map.mesh").points;
  for(std::size_t v = 0; v < map.size(); ++v)
    if(source.points[v] != Point{2, 2, 2})
      CHECK(map[v] == target.points[v]);
  check("source.mesh target.mesh --inside met", 27, 0);
  CHECK(folder.soup("map.mesh").points == target.points);
  check("source.mesh target.mesh --inside free", 0, 27);
  check("one_material.mesh target.mesh", 0, 27);

  for(std::size_t v = 0; v < source.points.size(); ++v) // only the boundary moves, along x
    target.points[v]
      = {source.points[v][0] * (is_on_boundary(source.points[v], 4) ? 4 : 1), source.points[v][1], source.points[v][2]};
  folder.write("target.mesh", target);
  REQUIRE(folder.run("source.mesh target.mesh --report report.json") == 0);
  CHECK(number(folder.text("report.json"), "targets_inside") == 0);
  CHECK(number(folder.text("report.json"), "free_targets") == 27);
  CHECK(folder.run("source.mesh --to ball --inside met") == 2);
}

TEST_CASE("The target may be a surface with the triangles of the boundary")
{
  const Folder folder;
  Soup source = cube(3);
  source.cells.resize(source.cells.size() - 20); // so that no rotation maps it to itself
  source.cell_references.resize(source.cells.size());
  std::vector<bool> is_used(source.points.size());
  for(const auto& cell : source.cells)
    for(const std::size_t v : cell)
      is_used[v] = true;
  folder.write("source.mesh", source);
  const std::vector<std::size_t> vertices = VMP::boundary_vertices(source.points, source.cells);
  const auto facets = VMP::internal::boundary_facets_3(source.cells);
  // a surface whose vertices are those of the boundary in an order; those of STL are the corners of its triangles
  const auto write = [&](const std::string& name, std::vector<std::size_t> order, const bool is_turned)
  {
    std::ostringstream os;
    os.precision(17);
    const std::string extension = name.substr(name.find('.'));
    const auto point = [&](const std::size_t v)
    {
      const Point p = affine(source.points[v]);
      os << p[0] << " " << p[1] << " " << p[2];
    };
    const auto number = [&](const std::size_t v) { return std::find(order.begin(), order.end(), v) - order.begin(); };
    if(extension == ".off")
      os << "OFF\n" << order.size() << " " << facets.size() << " 0\n";
    if(extension == ".ply")
      os << "ply\nformat ascii 1.0\nelement vertex " << order.size()
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << facets.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    if(extension == ".mesh")
      os << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << order.size() << "\n";
    if(extension == ".stl")
      os << "solid s\n";
    for(const std::size_t v : order)
      if(extension != ".stl")
      {
        os << (extension == ".obj" ? "v " : "");
        point(v);
        os << (extension == ".mesh" ? " 0\n" : "\n");
      }
    if(extension == ".mesh")
      os << "Triangles\n" << facets.size() << "\n";
    for(auto [a, b, c] : facets)
    {
      if(is_turned)
        std::swap(b, c);
      if(extension == ".stl")
      {
        os << "facet normal 0 0 0\nouter loop\n";
        for(const std::size_t v : {a, b, c})
        {
          os << "vertex ";
          point(v);
          os << "\n";
        }
        os << "endloop\nendfacet\n";
        continue;
      }
      const int first = extension == ".off" || extension == ".ply" ? 0 : 1;
      os << (extension == ".obj" ? "f" : extension == ".mesh" ? "" : "3") << " " << number(a) + first << " "
         << number(b) + first << " " << number(c) + first << (extension == ".mesh" ? " 0\n" : "\n");
    }
    os << (extension == ".stl" ? "endsolid s\n" : extension == ".mesh" ? "End\n" : "");
    folder.write(name, os.str());
  };
  const auto check = [&](const std::string& name, const double precision)
  {
    CAPTURE(name);
    REQUIRE(folder.run("source.mesh " + name + " -o map.mesh") == 0);
    const std::vector<Point> map = folder.soup("map.mesh").points;
    for(std::size_t v = 0; v < map.size(); ++v)
      for(std::size_t i = 0; i < 3 && is_used[v]; ++i)
        CHECK(map[v][i] == Approx(affine(source.points[v])[i]).margin(precision));
  };
  std::vector<std::size_t> shuffled = vertices, all(source.points.size());
  for(std::size_t v = 0; v < all.size(); ++v)
    all[v] = v;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937());
  for(const std::string extension : {".off", ".ply", ".obj", ".mesh", ".stl"})
  {
    write("in_order" + extension, vertices, false);
    check("in_order" + extension, 1e-6);
    write("shuffled" + extension, shuffled, false);
    check("shuffled" + extension, 1e-6);
  }
  write("all.off", all, true);
  check("all.off", 1e-6);
  write("turned.off", shuffled, true);
  check("turned.off", 1e-6);

  const auto sentence = [&](const std::string& arguments)
  {
    CHECK(folder.run(arguments) == 2);
    return folder.text("stderr");
  };
  folder.write("cube.mesh", cube(3));
  CHECK(sentence("cube.mesh in_order.off").find("in_order.off: the surface has ") == 0);
  CHECK(folder.text("stderr").find("Move the triangles of the source onto the surface") != std::string::npos);
  source = cube(1); // two of its corners are alike
  const auto facets_of_cube = VMP::internal::boundary_facets_3(source.cells);
  std::ostringstream off;
  off << "OFF\n8 12 0\n";
  for(const std::size_t v : {3, 0, 1, 2, 7, 6, 5, 4})
    off << source.points[v][0] << " " << source.points[v][1] << " " << source.points[v][2] << "\n";
  const std::array<std::size_t, 8> number = {1, 2, 3, 0, 7, 6, 5, 4};
  for(const auto& [a, b, c] : facets_of_cube)
    off << "3 " << number[a] << " " << number[b] << " " << number[c] << "\n";
  folder.write("cube.mesh", source);
  folder.write("cube.off", off.str());
  REQUIRE(folder.run("cube.mesh cube.off -o map.mesh") == 0);
  CHECK(folder.text("stderr").find("note: cube.off: the triangles match the boundary of the source in several ways. The match "
                                   "with the least displacement is used: 0 in the quadratic mean") == 0);
  CHECK(folder.soup("map.mesh").points == source.points);

  // an octahedron, and turned by an eighth of a turn, as far from itself either way
  Soup octahedron;
  octahedron.points = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  std::string triangles;
  for(std::size_t i = 0; i < 4; ++i)
  {
    octahedron.cells.push_back({0, 1, 2 + i, 2 + (i + 1) % 4});
    const std::string v = std::to_string(i), w = std::to_string((i + 1) % 4);
    triangles += "3 " + v + " " + w + " 5\n3 4 " + w + " " + v + "\n";
  }
  octahedron.cell_references.assign(4, 1);
  folder.write("octahedron.mesh", octahedron);
  folder.write("turned.off", "OFF\n6 8 0\n0.7 0.7 0\n-0.7 0.7 0\n-0.7 -0.7 0\n0.7 -0.7 0\n0 0 -1\n0 0 1\n" + triangles);
  CHECK(sentence("octahedron.mesh turned.off").find("turned.off: the triangles of the surface match the boundary of the source in "
                                                    "several ways with the least displacement") == 0);
}

namespace {

// Triangles of a boundary as a surface of its own, with vertices in an order.
std::string part_of_boundary_as_OFF(const Soup& soup, const std::vector<std::array<std::size_t, 3> >& triangles,
                                    const std::vector<std::size_t>& order, const Point& translation)
{
  std::ostringstream os;
  os.precision(17);
  os << "OFF\n" << order.size() << " " << triangles.size() << " 0\n";
  for(const std::size_t v : order)
    os << soup.points[v][0] + translation[0] << " " << soup.points[v][1] + translation[1] << " "
       << soup.points[v][2] + translation[2] << "\n";
  for(const auto& triangle : triangles)
  {
    os << "3";
    for(const std::size_t v : triangle)
      os << " " << std::find(order.begin(), order.end(), v) - order.begin();
    os << "\n";
  }
  return os.str();
}

} // namespace

TEST_CASE("A surface may be a part of the boundary, such as the wall of a cavity, in any order")
{
  const Folder folder;
  Soup source = cube(5);
  const auto is_of_cavity = [](const Point& p)
  { return std::all_of(p.begin(), p.end(), [](const double x) { return x >= 2 && x <= 3; }); };
  const Soup full = source;
  source.cells.clear();
  for(const auto& cell : full.cells)
    if(!std::all_of(cell.begin(), cell.end(), [&](const std::size_t v) { return is_of_cavity(full.points[v]); }))
      source.cells.push_back(cell);
  source.cell_references.resize(source.cells.size());
  REQUIRE(source.cells.size() + 6 == full.cells.size());
  folder.write("source.mesh", source);
  std::vector<std::array<std::size_t, 3> > inner, outer, top;
  for(const auto& facet : VMP::internal::boundary_facets_3(source.cells))
    (is_of_cavity(source.points[facet[0]]) ? inner : outer).push_back(facet);
  for(const auto& facet : outer)
    if(std::all_of(facet.begin(), facet.end(), [&](const std::size_t v) { return source.points[v][2] == 5; }))
      top.push_back(facet);
  const auto vertices_of = [](const auto& triangles)
  {
    std::set<std::size_t> vertices;
    for(const auto& triangle : triangles)
      vertices.insert(triangle.begin(), triangle.end());
    std::vector<std::size_t> result(vertices.begin(), vertices.end());
    std::shuffle(result.begin(), result.end(), std::mt19937());
    return result;
  };
  const auto moved = [&](const std::string& arguments)
  {
    CAPTURE(arguments);
    REQUIRE(folder.run("source.mesh " + arguments + " -o map.mesh") == 0);
    return folder.soup("map.mesh").points;
  };
  const auto check = [&](const std::vector<Point>& map, const std::vector<std::size_t>& vertices, const Point& translation)
  {
    const std::set<std::size_t> those(vertices.begin(), vertices.end());
    for(const std::size_t v : VMP::boundary_vertices(source.points, source.cells))
      for(std::size_t i = 0; i < 3; ++i)
        CHECK(map[v][i] == source.points[v][i] + (those.count(v) > 0 ? translation[i] : 0));
  };
  const Point move = {0.25, -0.125, 0.25};
  folder.write("inner.off", part_of_boundary_as_OFF(source, inner, vertices_of(inner), move));
  check(moved("inner.off --others stay"), vertices_of(inner), move);
  CHECK(folder.run("source.mesh inner.off") == 2);
  CHECK(folder.text("stderr").find("--others stay") != std::string::npos);
  folder.write("top.off", part_of_boundary_as_OFF(source, top, vertices_of(top), {0.125, 0, 0.25}));
  check(moved("top.off --others stay"), vertices_of(top), {0.125, 0, 0.25});

  // all of it, the cavity first, and oriented as a body of its own
  auto all = inner;
  for(auto& triangle : all)
    std::swap(triangle[0], triangle[1]);
  all.insert(all.end(), outer.begin(), outer.end());
  const std::vector<std::size_t> vertices = vertices_of(all);
  folder.write("all.off", part_of_boundary_as_OFF(source, all, vertices, move));
  check(moved("all.off"), vertices, move);
  // not of this boundary
  inner[0] = {inner[0][0], inner[0][1], inner[1][2] == inner[0][0] ? inner[1][1] : inner[1][2]};
  folder.write("other.off", part_of_boundary_as_OFF(source, inner, vertices_of(inner), move));
  CHECK(folder.run("source.mesh other.off --others stay") == 2);
}

TEST_CASE("Targets are read as ParaView writes them: tables with names of columns, and surfaces of VTK")
{
  const Folder folder;
  const Soup source = cube(2);
  folder.write("source.mesh", source);
  const auto check = [&](const std::string& name, const std::string& content)
  {
    CAPTURE(name);
    folder.write(name, content);
    REQUIRE(folder.run("source.mesh " + name + " -o map.mesh") == 0);
    const std::vector<Point> map = folder.soup("map.mesh").points;
    for(std::size_t v = 0; v < map.size(); ++v)
      for(std::size_t i = 0; i < 3 && is_on_boundary(source.points[v], 2); ++i)
        CHECK(map[v][i] == Approx(affine(source.points[v])[i]).margin(1e-12));
  };
  std::istringstream lines(boundary_lines(source, 2, affine));
  std::string rows, rows_of_selection, numbered;
  int row = 0;
  for(std::string v, x, y, z; lines >> v >> x >> y >> z; ++row)
  {
    rows += "7.5," + x + "," + y + "," + z + "," + v + "\r\n";
    rows_of_selection += std::to_string(row) + ";" + v + ";" + x + ";" + y + ";" + z + "\n";
    numbered += v + ", " + x + ", " + y + ", " + z + "\n";
  }
  check("table.csv", "\"T\",\"Points:0\",\"Points:1\",\"Points:2\",\"Point ID\"\r\n" + rows);
  check("selection.csv", "Point ID;vtkOriginalPointIds;Points_0;Points_1;Points_2\n" + rows_of_selection);
  check("numbered.csv", numbered);
  std::ostringstream whole;
  whole.precision(17);
  whole << "x,y,z\n";
  for(const Point& p : source.points)
    whole << affine(p)[0] << "," << affine(p)[1] << "," << affine(p)[2] << "\n";
  check("whole.csv", whole.str());

  const auto facets = VMP::internal::boundary_facets_3(source.cells);
  std::ostringstream points, vertices, ends;
  points.precision(17);
  std::vector<std::size_t> order(source.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937());
  for(const std::size_t v : order)
    points << affine(source.points[v])[0] << " " << affine(source.points[v])[1] << " " << affine(source.points[v])[2] << "\n";
  for(std::size_t f = 0; f < facets.size(); ++f)
  {
    for(const std::size_t v : facets[f])
      vertices << std::find(order.begin(), order.end(), v) - order.begin() << " ";
    ends << 3 * (f + 1) << " ";
  }
  check("surface.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n<Piece>\n"
    "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n" + points.str()
    + "</DataArray>\n</Points>\n<Verts>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n</DataArray>\n"
      "</Verts>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n" + vertices.str()
    + "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n" + ends.str()
    + "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n");

  const auto sentence = [&](const std::string& content)
  {
    folder.write("bad.csv", content);
    CHECK(folder.run("source.mesh bad.csv") == 2);
    return folder.text("stderr");
  };
  CHECK(sentence("Point ID,a,b,c\n0,0,0,0\n").find("bad.csv: line 1: there are no columns 'Points:0'") == 0);
  CHECK(sentence("Point ID,x,y,z\n0,0,0,0\n0,0,0,0\n") == "bad.csv: line 3: vertex 0 has a second line\n");
  CHECK(sentence("Point ID,x,y,z\n27,0,0,0\n").find("bad.csv: line 2: vertex 27 does not exist") == 0);
  CHECK(sentence("Point ID,x,y,z\n2,0,,0\n").find("bad.csv: line 2: ") == 0);
  CHECK(sentence("Point ID,x,y,z\n1,0,0,0\n2,2,2,2,625\n")
        == "bad.csv: line 3: '625' is in column 5, but the first line has 4 columns\n");
  for(const std::string number : { "1.6#25", "3 5", "3\t5", "\"2,625\"" })
    CHECK(sentence("Point ID;x;y;z\n2;0;" + number + ";0\n").find(" is not a finite coordinate (column 3)\n")
          != std::string::npos);
  CHECK(sentence("0,1,5,2,5,3,5\n").find("bad.csv: line 1: there are 7 columns") == 0);
  CHECK(sentence("x,y,z\n0,0,0\n").find("bad.csv: there is no column with the indices of vertices") == 0);
  for(const std::string triangle : { "f 1 2 99\n", "f 1 2 3 4\n" }) // of a missing vertex, and two triangles for a whole boundary
  {
    folder.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + triangle);
    CHECK(folder.run("source.mesh bad.obj") == 2);
    CHECK(folder.text("stderr").find("bad.obj: ") != std::string::npos);
  }
  const bool has_Gmsh = fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so");
  CHECK(folder.run("surface.vtp --to ball") == (has_Gmsh ? 0 : 2));
  CHECK((folder.text("stderr").find("this is a surface; a volume mesher fills it") == std::string::npos) == has_Gmsh);
}

TEST_CASE("Only the part that moves needs targets, which may be displacements")
{
  const Folder folder;
  const Soup source = cube(3);
  folder.write("source.mesh", source);
  std::ostringstream targets, displacements;
  for(std::size_t v = 0; v < source.points.size(); ++v)
    if(source.points[v][2] == 3)
    {
      targets << v << " " << source.points[v][0] << " " << source.points[v][1] << " 4\n";
      displacements << v << " 0 0 1\n";
    }
  folder.write("target.txt", targets.str());
  folder.write("displacements.txt", displacements.str());
  CHECK(folder.run("source.mesh target.txt -o map.mesh") == 2);
  CHECK(folder.text("stderr").find("has no target. --others stay keeps the positions of such vertices; --others slide")
        != std::string::npos);
  REQUIRE(folder.run("source.mesh target.txt --others stay -o map.mesh") == 0);
  const std::vector<Point> stayed = folder.soup("map.mesh").points;
  REQUIRE(folder.run("source.mesh displacements.txt --displacements --others stay -o map.mesh") == 0);
  CHECK(folder.soup("map.mesh").points == stayed);
  REQUIRE(folder.run("source.mesh target.txt --others slide --energy symmetric_dirichlet --volume-weights -o map.mesh") == 0);
  const std::vector<Point> slid = folder.soup("map.mesh").points;
  for(std::size_t v = 0; v < slid.size(); ++v)
  {
    const Point& p = source.points[v];
    if(p[2] == 3)
      CHECK(slid[v] == Point{p[0], p[1], 4});
    else if(is_on_boundary(p, 3))
      CHECK(stayed[v] == p);
    CHECK(slid[v][2] == Approx(p[2] * 4 / 3).margin(0.05)); // nearly affine, as nothing holds the sides
  }

  folder.write("displacements.txt", boundary_lines(source, 3, [](const Point&) { return Point{0, 0, 1}; }));
  CHECK(folder.run("source.mesh displacements.txt") == 2);
  CHECK(folder.text("stderr").find("If TARGET contains displacements, use --displacements.") != std::string::npos);
  CHECK(folder.run("source.mesh displacements.txt --displacements") == 0);
}
