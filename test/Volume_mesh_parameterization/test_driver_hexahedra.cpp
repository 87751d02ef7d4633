// The program parameterize_mesh_file: polycubes and hexahedra.
#include "driver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>

TEST_CASE("Hexahedra are written for a box, and refused for what is none")
{
  const Folder folder;
  const Soup source = cube(3);
  folder.write("source.mesh", source);
  folder.write("target.mesh", source);
  REQUIRE(folder.run("source.mesh target.mesh --quiet --hexahedra 1.5 hexahedra.mesh") == 0);
  CHECK(folder.text("hexahedra.mesh").find("\nHexahedra\n8\n") != std::string::npos);
  REQUIRE(folder.run("source.mesh target.mesh --quiet --hexahedra 1 hexahedra.inp") == 0);
  CHECK(folder.text("hexahedra.inp").find("*NSET, NSET=FACE_6\n") != std::string::npos);
  CHECK(folder.text("hexahedra.inp").find("*ELSET, ELSET=SUBDOMAIN_") != std::string::npos);
  REQUIRE(folder.run("source.mesh target.mesh --hexahedra 1 hexahedra.vtu --report report.json") == 0);
  CHECK(folder.text("hexahedra.vtu").find("NumberOfCells=\"81\"") != std::string::npos); // 27 hexahedra, 54 facets
  CHECK(folder.text("stdout").find("27 hexahedra, scaled Jacobian: minimal 1") != std::string::npos);
  CHECK(keys(folder.text("report.json")) == report_keys_with(hexahedra_keys));
  const std::string report = hexahedra_of(folder.text("report.json"));
  CHECK(number(report, "cells") == 27);
  CHECK(number(report, "vertices") == 64);
  CHECK(number(report, "boundary_vertices") == 56);
  CHECK(number(report, "minimum_scaled_jacobian") == Approx(1));

  for(const char* option : {"1", "0 no.mesh", "1x no.mesh", "inf no.mesh", "1 no.txt", "1 target.mesh"})
    CHECK(folder.run("source.mesh target.mesh --hexahedra " + std::string(option)) == 2);
  CHECK(folder.run("source.mesh --to ball -o no.mesh --hexahedra 1 no.vtu") == 2);
  CHECK(folder.text("stderr").find("--to polycube instead of ball") != std::string::npos); // before there is a map
  Soup sheared = source;
  for(Point& p : sheared.points)
    p[0] += 0.1 * p[1];
  folder.write("target.mesh", sheared);
  CHECK(folder.run("source.mesh target.mesh --output map.mesh --report report.json --hexahedra 1 no.vtu") == 2);
  CHECK(folder.text("stderr").find("The map is complete. There are no hexahedra: The facet at (") == 0);
  CHECK(folder.text("stderr").find("not orthogonal to an axis") != std::string::npos);
  CHECK(folder.names()
        == Names({"source.mesh", "target.mesh", "hexahedra.mesh", "hexahedra.vtu", "hexahedra.inp", "map.mesh", "report.json"}));
  CHECK(folder.soup("map.mesh").cells == source.cells); // the map is written all the same
  CHECK(keys(folder.text("report.json")) == report_keys_with(hexahedra_keys));
  CHECK(folder.text("report.json").find("\"has_valid_map\": true") != std::string::npos);
  CHECK(folder.text("report.json").find("\"status_code\": \"ERROR_DOMAIN_NOT_AXIS_PARALLEL\"") != std::string::npos);
}

TEST_CASE("Hexahedra keep the interface of two subdomains, whose volumes are told, unless staircases are asked for")
{
  const Folder folder;
  Soup source = cube(3);
  for(std::size_t c = 0; c < source.cells.size(); ++c)
  {
    double sum = 0;
    for(const std::size_t v : source.cells[c])
      sum += source.points[v][2];
    source.cell_references[c] = sum < 4 ? 1 : 2;
  }
  for(Point& p : source.points)
    p[2] = p[2] == 1 ? 1.3 : p[2];
  folder.write("source.mesh", source);
  folder.write("target.mesh", source);
  REQUIRE(folder.run("source.mesh target.mesh --inside free --hexahedra 1 hexahedra.mesh --report report.json") == 0);
  CHECK(folder.text("stdout").find("subdomain 1: volume 11.7, of hexahedra 11.7\n") != std::string::npos);
  CHECK(number(hexahedra_of(folder.text("report.json")), "interface_distance") < 1e-9);
  CHECK(folder.text("hexahedra.mesh").find("\nQuadrilaterals\n63\n") != std::string::npos);
  REQUIRE(folder.run("source.mesh target.mesh --inside free --staircases --hexahedra 1 hexahedra.mesh --report report.json") == 0);
  CHECK(folder.text("stdout").find("subdomain 1: volume 11.7, of hexahedra 9") != std::string::npos);
  CHECK(number(hexahedra_of(folder.text("report.json")), "interface_distance") > 0.25);
  CHECK(folder.run("source.mesh target.mesh --staircases") == 2);
}

TEST_CASE("The faces of a polycube are multiples of the spacing of hexahedra")
{
  const Folder folder;
  Soup source = cube(3);
  const Soup other = cube(2);
  for(const Point& p : other.points)
    source.points.push_back({p[0] + 3.7, p[1], p[2]});
  for(const auto& [a, b, c, d] : other.cells)
    source.cells.push_back({a + 64, b + 64, c + 64, d + 64});
  source.cell_references.assign(source.cells.size(), 1);
  folder.write("source.mesh", source);
  REQUIRE(folder.run("source.mesh --to polycube --refine=none --hexahedra 1 hexahedra.mesh") == 0);
  CHECK(folder.text("stdout").find("35 hexahedra, scaled Jacobian: minimal 1, mean 1") != std::string::npos);
}

TEST_CASE("Hexahedra follow a ridge that is in a list of features")
{
  const Folder folder;
  Soup roof = cube(4); // whose top falls by 6 degrees, which is no bend, on both sides of y = 1, where no plane of the grid is
  std::string ridge = "4\n";
  for(double x = 0; x < 4; ++x)
  {
    const auto vertex = [&](const Point& p) { return std::find(roof.points.begin(), roof.points.end(), p) - roof.points.begin(); };
    ridge += std::to_string(vertex({x, 1, 4})) + " " + std::to_string(vertex({x + 1, 1, 4})) + "\n";
  }
  for(Point& p : roof.points)
    p[2] *= 1 - 0.1 * std::abs(p[1] - 1) / 4;
  folder.write("source.mesh", roof);
  folder.write("ridge.feat", ridge);
  folder.write("triangles.sharp", "1\n0 5 2\n");
  const auto vertices_on_ridge = [&](const std::string& options)
  {
    REQUIRE(folder.run("source.mesh --to polycube --refine=none --slide --hexahedra 2 hexahedra.mesh" + options) == 0);
    std::istringstream mesh(folder.text("hexahedra.mesh"));
    std::string word;
    while(mesh >> word && word != "Vertices") {}
    int size, number = 0;
    mesh >> size;
    for(double x, y, z, reference; size > 0 && mesh >> x >> y >> z >> reference; --size)
      number += std::hypot(y - 1, z - 4) < 0.2;
    return number;
  };
  CHECK(vertices_on_ridge(" --features ridge.feat") == 3);
  CHECK(folder.text("stderr").find("48 sharp edges of the boundary") != std::string::npos); // those of the cube
  CHECK(vertices_on_ridge("") == 0);
  CHECK(folder.text("stderr").find("sharp edges") == std::string::npos);
  CHECK(folder.run("source.mesh --to polycube --features triangles.sharp") == 2);
  CHECK(folder.text("stderr").find("triangles.sharp: line 2: '2' follows the two vertices of an edge") != std::string::npos);
  folder.write("triangles.sharp", "2\n1,0,0\n1,0,1\n"); // as LoopyCuts has it
  CHECK(folder.run("source.mesh --to polycube --features triangles.sharp") == 2);
  CHECK(folder.text("stderr").find("triangles.sharp: line 2: a line must contain two vertices") == 0);
}

TEST_CASE("Sharp edges that a polycube gives up are counted, and their place is told")
{
  const Folder folder;
  const Soup source = cube(4);
  folder.write("source.mesh", source);
  const auto vertex = [&](const double x, const double y)
  {
    const Point p = { x, y, 4 };
    return std::to_string(std::find(source.points.begin(), source.points.end(), p) - source.points.begin());
  };
  const std::string diagonal = vertex(1, 1) + " " + vertex(2, 2) + "\n" + vertex(2, 2) + " " + vertex(3, 3) + "\n";
  folder.write("diagonal.feat", diagonal + vertex(1, 0) + " " + vertex(2, 0) + "\n");
  REQUIRE(folder.run("source.mesh --to polycube --refine=none --features diagonal.feat --report report.json") == 0);
  CHECK(folder.text("stderr").find("2 of 3 sharp edges follow no axis of the polycube, in 1 line. The longest line "
                                   "goes through (2, 2, 4)") != std::string::npos);
  CHECK(folder.text("report.json").find("\"sharp_edges_given_up\": 2, \"features_given_up\": [2, 2, 4]") != std::string::npos);
  REQUIRE(folder.run("source.mesh --to polycube --refine=none --report report.json") == 0);
  CHECK(folder.text("stderr").find("sharp edges follow") == std::string::npos);
  CHECK(number(folder.text("report.json"), "sharp_edges_given_up") == 0);
}

TEST_CASE("A turned source has its own polycube, unless the axes are given")
{
  const Folder folder;
  Soup source = cube(3);
  for(Point& p : source.points)
    p = {0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1], p[2]};
  folder.write("source.mesh", source);
  REQUIRE(folder.run("source.mesh --to polycube --refine=none --report report.json") == 0);
  CHECK(number(folder.text("report.json"), "boundary_distortion") < 1e-4);
  CHECK(folder.text("report.json").find("\"polycube_rotation\": [0.8") != std::string::npos);
  REQUIRE(folder.run("source.mesh --to polycube --refine=none --polycube-axes given --report report.json") == 0);
  CHECK(folder.text("report.json").find("\"polycube_rotation\": [1, 0, 0, 0, 1, 0, 0, 0, 1]") != std::string::npos);
  CHECK(folder.run("source.mesh --to ball --tolerance 0.1") == 2);
  CHECK(folder.text("stderr").find("--tolerance needs --to with a surface") != std::string::npos);
  CHECK(folder.run("source.mesh --to ball --polycube-axes given") == 2);
  CHECK(folder.text("stderr").find("--polycube-axes needs --to polycube") != std::string::npos);
}

TEST_CASE("Hexahedra that cannot be made leave the map, and say why there are none")
{
  const Folder folder;
  const Soup prism = fan_in_prism(24);
  folder.write("source.mesh", prism);
  Soup target = prism;
  for(Point& p : target.points)
  {
    const double angle = 3.14 * p[2] / 24, radius = 1 + p[0];
    p = {radius * std::cos(angle), p[1], radius * std::sin(angle)};
  }
  folder.write("target.mesh", target);
  REQUIRE(folder.run("source.mesh target.mesh -o map.mesh --report report.json --hexahedra 1 hexahedra.mesh") == 1);
  CHECK(folder.names() == Names{"source.mesh", "target.mesh", "map.mesh", "report.json"});
  CHECK(folder.text("stderr").find(" There are no hexahedra, because the boundary is missed.") != std::string::npos);

  // nearly a whole ring cannot be one hexahedron
  const Soup box = cube(6);
  Soup ring = box;
  for(Point& p : ring.points)
  {
    const double angle = 5.8 * p[2] / 6, radius = 1 + p[0];
    p = {radius * std::cos(angle), p[1], radius * std::sin(angle)};
  }
  folder.write("source.mesh", ring);
  folder.write("target.mesh", box);
  fs::remove(folder.path("map.mesh"));
  CHECK(folder.run("source.mesh target.mesh -o map.mesh --report report.json --hexahedra 6 hexahedra.mesh") == 3);
  CHECK(folder.names() == Names{"source.mesh", "target.mesh", "map.mesh", "report.json"});
  CHECK(folder.text("report.json").find("\"has_valid_map\": true") != std::string::npos);
  CHECK(number(hexahedra_of(folder.text("report.json")), "inverted_corners") > 0);
}

TEST_CASE("Hexahedra are positive at all points, not only at their corners")
{
  // three cubes in the form of an L, and sheared: bent into a cube, hexahedra turn by more than a right angle
  const Folder folder;
  for(const double shear : { 0., 0.3 })
  {
    Soup source = cube(2);
    const auto is_outside = [&](const std::array<std::size_t, 4>& cell)
    {
      const auto all = [&](const auto& f)
      { return std::all_of(cell.begin(), cell.end(), [&](const std::size_t v) { return f(source.points[v]); }); };
      return all([](const Point& p) { return p[2] >= 1; }) || all([](const Point& p) { return p[0] >= 1 && p[1] >= 1; });
    };
    source.cells.erase(std::remove_if(source.cells.begin(), source.cells.end(), is_outside), source.cells.end());
    source.cell_references.resize(source.cells.size());
    for(Point& p : source.points)
      p = { p[0], p[1] + shear * p[2], p[2] };
    folder.write("source.mesh", source);
    const int code = folder.run("source.mesh --to cube --refine=all --hexahedra 0.25 hexahedra.mesh --report report.json");
    const std::string report = hexahedra_of(folder.text("report.json"));
    // The hexahedra are valid in both cases, but the boundary of the body may be farther from them than an edge.
    REQUIRE((code == 0 || (code == 1 && report.find("ERROR_INCOMPLETE_HEXAHEDRA") != std::string::npos)));
    CHECK(number(report, "inverted_hexahedra") == 0);
    CHECK(smallest_determinant_of_hexahedra(folder.text("hexahedra.mesh")) > 0);
  }
}

TEST_CASE("A plain grid is taken where layers along interfaces are worse")
{
  // four boxes as a checkerboard of two materials, which touch in an edge
  const Folder folder;
  Soup source = cube(2);
  for(Point& p : source.points)
    p[2] /= 2;
  for(std::size_t c = 0; c < source.cells.size(); ++c)
  {
    Point center = { 0, 0, 0 };
    for(const std::size_t v : source.cells[c])
      for(std::size_t i = 0; i < 3; ++i)
        center[i] += source.points[v][i] / 4;
    source.cell_references[c] = (center[0] < 1) == (center[1] < 1) ? 1 : 2;
  }
  folder.write("source.mesh", source);
  REQUIRE(folder.run("source.mesh --to polycube --refine --hexahedra 0.5 hexahedra.mesh --report report.json") == 0);
  const std::string report = hexahedra_of(folder.text("report.json"));
  CHECK(number(report, "interface_distance") < 1e-9);
  CHECK(number(report, "minimum_scaled_jacobian") > 1 - 1e-9);
  CHECK(folder.text("stdout").find("staircases") == std::string::npos); // there are none
}

TEST_CASE("Hexahedra that leave out a subdomain have a status of their own")
{
  const Folder folder;
  Soup source = cube(3);
  for(std::size_t c = 0; c < source.cells.size(); ++c)
  {
    const auto& cell = source.cells[c];
    const bool is_low = std::all_of(cell.begin(), cell.end(), [&](const std::size_t v) { return source.points[v][2] <= 1; });
    source.cell_references[c] = is_low ? 7 : 2;
  }
  folder.write("source.mesh", source);
  CHECK(folder.run("source.mesh source.mesh --hexahedra 3 hexahedra.mesh --report report.json") == 1);
  CHECK(folder.text("report.json").find("\"status_code\": \"ERROR_INCOMPLETE_HEXAHEDRA\"") != std::string::npos);
  CHECK(folder.text("stderr").find("Subdomain 7 at (") != std::string::npos);
  CHECK(folder.text("hexahedra.mesh").find("\nHexahedra\n1\n") != std::string::npos);
  CHECK(folder.run("source.mesh source.mesh --hexahedra 1 hexahedra.mesh") == 0);
}

TEST_CASE("Hexahedra that leave out a part of the body farther than their edges have that status, too")
{
  const Folder folder;
  const Soup target = cube(2);
  Soup source = target;
  for(Point& p : source.points)
    if(p == Point{ 1, 1, 2 })
      p[2] = 6; // the tip of a spire, where a grid with the spacing 2 has no vertex
  folder.write("source.mesh", source);
  folder.write("target.mesh", target);
  CHECK(folder.run("source.mesh target.mesh --hexahedra 2 hexahedra.mesh --report report.json") == 1);
  CHECK(folder.text("report.json").find("\"status_code\": \"ERROR_INCOMPLETE_HEXAHEDRA\"") != std::string::npos);
  CHECK(folder.text("stderr").find(" apart at (1, 1, 6)") != std::string::npos);
  CHECK(folder.text("stdout").find("\nvolume 12, of hexahedra 8\n") != std::string::npos);
  CHECK(folder.run("target.mesh target.mesh --hexahedra 2 hexahedra.mesh") == 0);
  CHECK(folder.text("stdout").find("\nvolume 8, of hexahedra 8\n") != std::string::npos);
  CHECK(folder.text("stderr").find("note") == std::string::npos);
}

TEST_CASE("A note tells of a polycube that is much larger than the body, as it is thicker than the body by the spacing")
{
  const Folder folder;
  Soup plate = cube(2);
  for(Point& p : plate.points)
    p[2] *= 0.05;
  folder.write("plate.mesh", plate);
  CHECK(folder.run("plate.mesh --to polycube --refine --hexahedra 0.5 hexahedra.mesh") == 0);
  CHECK(folder.text("stderr").find("the polycube has 5 times the volume of the body") != std::string::npos);
  CHECK(folder.run("plate.mesh --to polycube --refine --hexahedra 0.1 hexahedra.mesh") == 0);
  CHECK(folder.text("stderr").find("note") == std::string::npos);
}

TEST_CASE("A note comes before the hexahedra of a map that distorts angles beyond hope")
{
  const Folder folder;
  Soup source = cube(2);
  for(Point& p : source.points)
    p[2] *= 2000; // angles are distorted by 2000 + 1 / 2000
  folder.write("source.mesh", source);
  folder.write("target.mesh", cube(2));
  folder.run("source.mesh target.mesh --hexahedra 1 hexahedra.mesh");
  CHECK(folder.text("stderr").find("note: source.mesh: the map distorts angles by a factor of up to 2000") != std::string::npos);
}
