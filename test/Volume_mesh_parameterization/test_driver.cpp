// The program parameterize_mesh_file: its maps, and the codes, reports and sentences with which it ends.
#include "driver.h"
#include "array_of_vtu_file.h"

#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

TEST_CASE("An affine boundary gives an affine map, in the order of the file")
{
  const Folder folder;
  const Soup source = cube(3);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 3, affine));

  for(const std::string options : {"", " --solver cg", " --energy dirichlet",
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
                                   " --solver cholmod",
#endif
#ifdef CGAL_LINKED_WITH_TBB
                                   " --threads 2",
#endif
                                   " --volume-weights --max-angle-distortion 100"})
  {
    CHECK(folder.run("source.mesh target.txt --quiet --output map.mesh --report report.json" + options) == 0);
    CHECK(folder.text("stdout") + folder.text("stderr") == "");
    CHECK(folder.names() == Names{"source.mesh", "target.txt", "map.mesh", "report.json"});

    const Soup map = folder.soup("map.mesh");
    CHECK(map.cells == source.cells);
    REQUIRE(map.points.size() == source.points.size());
    for(std::size_t v = 0; v < map.points.size(); ++v)
    {
      const Point q = affine(source.points[v]);
      if(is_on_boundary(source.points[v], 3))
        CHECK(map.points[v] == q);
      for(std::size_t i = 0; i < 3; ++i)
        CHECK(std::abs(map.points[v][i] - q[i]) < 1e-6);
    }

    const std::string report = folder.text("report.json");
    CHECK(keys(report) == report_keys);
    CHECK(number(report, "vertices") == 64);
    CHECK(number(report, "cells") == 162);
    CHECK(number(report, "boundary_vertices") == 56);
    CHECK(number(report, "inverted_cells") == 0);
    CHECK(number(report, "boundary_residual") == 0);
    CHECK(number(report, "peak_memory_bytes") > 1e6);

    std::smatch match;
    REQUIRE(std::regex_search(report, match, std::regex("\"steps\": \\{\"energy\": \\[(.*?)\\]")));
    const std::string energies = match[1];
    CHECK(1 + std::count(energies.begin(), energies.end(), ',') == number(report, "iterations"));
    if(options.find("angle") == std::string::npos) // a bound of angles has another energy
      CHECK(std::stod(energies.substr(energies.rfind(',') + 1)) == Approx(number(report, "energy_value")));
  }
}

TEST_CASE("A boundary that slides finds the identity")
{
  const Folder folder;
  const Soup source = cube(3);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 3, [](const Point& p)
  {
    Point q = p;
    for(std::size_t i = 0; i < 3; ++i)
      q[i] += 0.1 * p[i] * (3 - p[i]) * std::sin(p[(i + 1) % 3]);
    return q;
  }));
  CHECK(folder.run("source.mesh target.txt --slide --output map.mesh --report report.json") == 0);
  CHECK(number(folder.text("report.json"), "sliding_vertices") == 56 - 8);
  CHECK(number(folder.text("report.json"), "boundary_residual") == 0);
  const Soup map = folder.soup("map.mesh");
  REQUIRE(map.points.size() == source.points.size());
  for(std::size_t v = 0; v < map.points.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
      CHECK(std::abs(map.points[v][i] - source.points[v][i]) < 1e-4);
}

TEST_CASE("The identity is minimal if cells count by their volume, and not for the stretch energy if they count alike")
{
  const Folder folder;
  Soup source = cube(3);
  for(Point& p : source.points) // cells of different volumes
    p[0] = p[0] * (p[0] + 1) / 4;
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 3, [](const Point& p) { return p; }));
  const auto energy = [&folder](const std::string& options)
  {
    CHECK(folder.run("source.mesh target.txt --report report.json " + options) == 0);
    return number(folder.text("report.json"), "energy_value");
  };
  CHECK(energy("--volume-weights") == Approx(3).epsilon(1e-7));
  CHECK(energy("") < 2.99);
  CHECK(energy("--energy arap") == Approx(0).margin(1e-7));
}

TEST_CASE("The target may be a mesh, and the output a VTU file")
{
  const Folder folder;
  const Soup source = cube(2);
  Soup target = source;
  for(Point& p : target.points)
    p = affine(p);
  folder.write("source.mesh", source);
  folder.write("target.mesh", target);
  CHECK(folder.run("source.mesh target.mesh --output map.vtu") == 0);
  CHECK(folder.text("stdout").find("48 cells, 27 vertices, 26 on the boundary") == 0);
  CHECK(folder.text("map.vtu").find("Name=\"uvw\"") != std::string::npos);
  CHECK(folder.names() == Names{"source.mesh", "target.mesh", "map.vtu"});
}

TEST_CASE("The boundary goes to a domain that has a name")
{
  const Folder folder;
  const Soup source = cube(3);
  folder.write("source.mesh", source);

  const auto map_to = [&](const std::string& domain)
  {
    CAPTURE(domain);
    CHECK(folder.run("source.mesh --refine -o map.mesh --report report.json --to " + domain) == 0);
    CHECK(number(folder.text("report.json"), "inverted_cells") == 0);
    CHECK(number(folder.text("report.json"), "boundary_residual") == 0);
    Soup map = folder.soup("map.mesh");
    REQUIRE(map.points.size() >= source.points.size());
    map.points.resize(source.points.size()); // points that were there before refinement
    return map.points;
  };
  const auto ball = map_to("ball");
  for(std::size_t v = 0; v < ball.size(); ++v)
  {
    const double radius = std::sqrt(ball[v][0] * ball[v][0] + ball[v][1] * ball[v][1] + ball[v][2] * ball[v][2]);
    CHECK((is_on_boundary(source.points[v], 3) ? std::abs(radius - 1) < 1e-14 : radius < 1));
  }

  const auto sides_of = [](const std::vector<Point>& points)
  {
    Point low = points[0], high = points[0];
    for(const Point& p : points)
      for(std::size_t i = 0; i < 3; ++i)
      {
        low[i] = (std::min)(low[i], p[i]);
        high[i] = (std::max)(high[i], p[i]);
      }
    return Point{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  };
  CHECK(sides_of(map_to("cube")) == Point{1, 1, 1});
  CHECK(sides_of(map_to("box=1,2,0.5")) == Point{1, 2, 0.5});
  const Point polycube = sides_of(map_to("polycube"));
  for(const double side : polycube)
    CHECK(side == Approx(3));

  // two cubes with a common vertex
  Soup two = cube(1);
  for(const Point& p : cube(1).points)
    two.points.push_back({p[0] + 1, p[1] + 1, p[2] + 1});
  for(const auto& cell : cube(1).cells)
  {
    two.cells.push_back(cell);
    for(std::size_t& v : two.cells.back())
      v = v == 0 ? 7 : v + 8;
  }
  two.cell_references.assign(12, 1);
  folder.write("source.mesh", two);
  CHECK(folder.run("source.mesh --to ball --report report.json") == 2);
  CHECK(folder.text("stderr").find("at 1 vertex, number 7 (counted from 0)") != std::string::npos);
  CHECK(folder.text("report.json").find("\"status_code\": \"ERROR_NON_MANIFOLD_BOUNDARY\"") != std::string::npos);
}

TEST_CASE("A ball is turned to landmarks, and a box has eight of them as corners")
{
  const Folder folder;
  const Soup source = cube(2);
  folder.write("source.mesh", source);
  const auto vertex = [&](const Point& p)
  { return std::find(source.points.begin(), source.points.end(), p) - source.points.begin(); };
  const std::string command = "source.mesh --refine -o map.mesh --landmarks landmarks.txt --report report.json --to ";

  const std::string one = std::to_string(vertex({2, 1, 1})) + " 0 0 1\n";
  folder.write("landmarks.txt", one);
  REQUIRE(folder.run(command + "ball") == 0);
  const Point there = folder.soup("map.mesh").points[vertex({2, 1, 1})];
  CHECK(std::hypot(there[0], there[1], there[2] - 1) < 1e-15);
  CHECK(folder.text("report.json").find("\"landmarks\": \"landmarks.txt\"") != std::string::npos);
  CHECK(folder.run(command + "cube") == 2);
  CHECK(folder.text("stderr").find("eight vertices as landmarks, one in each octant") != std::string::npos);
  CHECK(folder.run(command + "polycube") == 2);
  folder.write("landmarks.txt", std::to_string(vertex({1, 1, 1})) + " 0 0 1\n"); // inside
  CHECK(folder.run(command + "ball") == 2);
  CHECK(folder.text("report.json").find("ERROR_INVALID_LANDMARK") != std::string::npos);

  std::ostringstream corners; // the axes are exchanged in turn
  for(const double x : {0, 2})
    for(const double y : {0, 2})
      for(const double z : {0, 2})
        corners << vertex({x, y, z}) << " " << y - 1 << " " << z - 1 << " " << x - 1 << "\n";
  folder.write("landmarks.txt", corners.str());
  REQUIRE(folder.run(command + "box=1,2,3") == 0);
  CHECK(folder.soup("map.mesh").points[vertex({0, 2, 0})] == Point{0.5, -1, -1.5});
}

TEST_CASE("A note says that a part of a surface is far from the boundary, and its step helps")
{
  const Folder folder;
  folder.write("source.mesh", cube(4));
  folder.write("angle.off", "OFF\n12 8 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n"
    "6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n");
  const std::string note = "note: angle.off: A part of the surface is away from the boundary by ";
  REQUIRE(folder.run("source.mesh --to angle.off -o map.mesh") == 0);
  CHECK(folder.text("stderr").find(note) != std::string::npos);
  REQUIRE(folder.run("source.mesh --to angle.off --tolerance 0.1 -o map.mesh") == 0);
  CHECK(folder.text("stderr").find(note) == std::string::npos);
}

TEST_CASE("A body is fitted to a closed surface with other triangles, and slides on it")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  folder.write("octahedron.off", "OFF\n6 8 0\n3 0 0\n-3 0 0\n0 2 0\n0 -2 0\n0 0 2\n0 0 -2\n3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n"
                                 "3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  const std::string command = "source.mesh -o map.mesh --report report.json --to octahedron.off";
  REQUIRE(folder.run(command) == 0);
  const std::string fixed = folder.text("report.json");
  CHECK(fixed.find("\"turned_facets\": 0") != std::string::npos);
  REQUIRE(folder.run(command + " --slide") == 0);
  const Soup map = folder.soup("map.mesh");
  std::size_t number_on_surface = 0; // the faces |x| / 3 + |y| / 2 + |z| / 2 = 1
  for(const auto& [x, y, z] : map.points)
    number_on_surface += std::abs(std::abs(x) / 3 + std::abs(y) / 2 + std::abs(z) / 2 - 1) < 1e-14;
  CHECK(number_on_surface >= 26);
  CHECK(number(folder.text("report.json"), "energy_value") < number(fixed, "energy_value"));

  folder.write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  CHECK(folder.run("source.mesh --to open.off") == 2);
  CHECK(folder.text("stderr").find("open.off: ") == 0);
  CHECK(folder.text("stderr").find("it is in the plane z = 0") != std::string::npos);
  CHECK(folder.run("source.mesh --to missing.off --quiet") == 2);
  CHECK(folder.text("stderr") == "missing.off: the file cannot be opened\n");

  const std::string face_of_4e9_vertices = std::string("\0\x28\x6b\xee", 4) + std::string(12, '\0');
  folder.write("damaged.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                              "property float z\nelement face 1\nproperty list uint uint vertex_indices\nend_header\n"
                              + std::string(12, '\0') + face_of_4e9_vertices);
  for(const std::string target : { "--to damaged.ply", "damaged.ply" })
  {
    CHECK(folder.run("source.mesh --quiet " + target) == 2);
    CHECK(folder.text("stderr").find("damaged.ply: the surface cannot be read") == 0);
  }
}

TEST_CASE("A boundary that cannot be reached: exit code 3 if fixed, 1 if it may be missed, 0 with refinement")
{
  const Folder folder;
  const std::size_t length = 12;
  const double pi = 3.14159265358979;
  Soup source = fan_in_prism(length);
  for(std::size_t c = 0; c < source.cells.size(); ++c)
    source.cell_references[c] = static_cast<int>(c % 3) + 5;
  for(const auto& [i, j, k, l] : source.cells)
    for(const std::array<std::size_t, 3>& facet : { std::array{j, k, l}, {i, k, l}, {i, j, l}, {i, j, k} })
      source.facets.push_back(facet); // all of them, those inside twice
  source.facet_references.assign(source.facets.size(), 9);
  source.points.resize(source.points.size() + 2, Point{9, 9, 9}); // two vertices without a cell
  Soup target = source;
  for(Point& p : target.points)
  {
    const double angle = pi * p[2] / length;
    p = {(1 + p[0]) * std::cos(angle), p[1], (1 + p[0]) * std::sin(angle)};
  }
  folder.write("source.mesh", source);
  folder.write("target.mesh", target);
  CHECK(folder.run("source.mesh target.mesh --boundary fixed") == 2); // the vertex inside has several references
  CHECK(folder.text("stderr").find("Interior vertices have targets, too; --inside free ignores them.")
        != std::string::npos);
  const std::string command = "source.mesh target.mesh --inside free --quiet --output map.mesh --report report.json --boundary ";
  CHECK(folder.run(command + "fixed") == 3);
  CHECK(folder.text("stderr") != "");
  CHECK(folder.names() == Names{"source.mesh", "target.mesh", "report.json"});
  CHECK(keys(folder.text("report.json")) == report_keys);
  CHECK(number(folder.text("report.json"), "inverted_cells") > 0);

  // a valid map that misses the boundary
  CHECK(folder.run(command + "auto") == 1);
  CHECK(folder.names() == Names{"map.mesh", "report.json", "source.mesh", "target.mesh"});
  CHECK(number(folder.text("report.json"), "inverted_cells") == 0);
  CHECK(number(folder.text("report.json"), "boundary_residual") > 0);
  CHECK(folder.text("stderr").find("Allow refinement (--refine), or") != std::string::npos);
  CHECK(folder.text("report.json").find("Allow refinement (--refine), or") != std::string::npos);

  // edges are split where the boundary could not be reached
  CHECK(folder.run(command + "fixed --refine") == 0); // as the help advises for both
  CHECK(folder.run(command + "auto --refine --refined-source refined.mesh") == 0);
  CHECK(number(folder.text("report.json"), "added_vertices") > 0);
  const Soup refined = folder.soup("refined.mesh");
  CHECK(refined.points.size() == folder.soup("map.mesh").points.size());
  CHECK(refined.points.size() > source.points.size());
  CHECK(std::equal(source.points.begin(), source.points.end(), refined.points.begin()));
  CHECK(refined.cells == folder.soup("map.mesh").cells);

  // parts of cells have the references of these, in each output, and marked facets are facets of the new cells
  CHECK(refined.cell_references == folder.soup("map.mesh").cell_references);
  const auto volumes = [](const Soup& soup)
  {
    std::map<int, double> result;
    for(std::size_t c = 0; c < soup.cells.size(); ++c)
    {
      std::array<std::array<double, 3>, 3> e;
      for(int i = 0; i < 3; ++i)
        for(int k = 0; k < 3; ++k)
          e[i][k] = soup.points[soup.cells[c][i + 1]][k] - soup.points[soup.cells[c][0]][k];
      result[soup.cell_references[c]] += e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1])
        + e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) + e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    }
    return result;
  };
  for(const auto& [reference, volume] : volumes(source))
    CHECK(volumes(refined)[reference] == Approx(volume));
  const auto facets_of_cells = [](const Soup& soup)
  {
    std::set<std::set<std::size_t> > result;
    for(const auto& [i, j, k, l] : soup.cells)
      for(const std::set<std::size_t>& facet : { std::set{j, k, l}, {i, k, l}, {i, j, l}, {i, j, k} })
        result.insert(facet);
    return result;
  };
  const std::set<std::set<std::size_t> > facets = facets_of_cells(refined);
  for(const auto& [i, j, k] : refined.facets)
    CHECK(facets.count({ i, j, k }) == 1);
  CHECK(refined.facets.size() > source.facets.size());
  CHECK(folder.run("source.mesh target.mesh --inside free --quiet --refine --output map.vtu") == 0);
  std::vector<int> references = refined.cell_references;
  references.insert(references.end(), refined.facet_references.begin(), refined.facet_references.end());
  CHECK(array_of<std::int32_t>(folder.text("map.vtu"), "reference", "Int32") == references);
}

TEST_CASE("Notes name refinement if it may improve a map much, and the file of the refined source")
{
  const Folder folder;
  Soup source = cube(2); // a flat corner of the cube is the top of a cell whose vertices are all on the boundary
  for(Point& p : source.points)
    p[2] *= 0.1;
  folder.write("source.mesh", source);
  const auto energy_of = [&](const std::string& options)
  {
    REQUIRE(folder.run("source.mesh --to ball --report report.json -o map.mesh" + options) == 0);
    return number(folder.text("report.json"), "energy_value");
  };
  const std::string advice = "Refinement (--refine) may lower the distortion much.", lacking = "--refined-source FILE writes";
  const double plain = energy_of(" --refine=none");
  CHECK(folder.text("stderr").find("note: source.mesh: The prescribed vertices alone distort the angles of ") == 0);
  CHECK(folder.text("stderr").find(advice) != std::string::npos);
  CHECK(folder.text("stderr").find(lacking) == std::string::npos);
  CHECK(energy_of("") < plain);
  CHECK(folder.text("stderr").find(advice) == std::string::npos);
  CHECK(folder.text("stderr").find(lacking) != std::string::npos);
  energy_of(" --refined-source refined.mesh");
  CHECK(folder.text("stderr") == "");
  energy_of(" --refine=none --quiet");
  CHECK(folder.text("stderr") == "");
}

TEST_CASE("Vertices are added where they are needed, where they help, or in all bridges")
{
  const Folder folder;
  const Soup source = cube(2);
  Soup sheared = source;
  for(Point& p : sheared.points)
    p[0] += 5 * p[2];
  folder.write("source.mesh", source);
  folder.write("same.mesh", source);
  folder.write("sheared.mesh", sheared);
  const auto added = [&](const std::string& options)
  {
    REQUIRE(folder.run("source.mesh --quiet --report report.json --refined-source refined.mesh --output map.mesh " + options)
            == 0);
    CHECK(folder.soup("refined.mesh").points.size() == folder.soup("map.mesh").points.size());
    CHECK(folder.soup("refined.mesh").points.size()
          == source.points.size() + static_cast<std::size_t>(number(folder.text("report.json"), "added_vertices")));
    return number(folder.text("report.json"), "added_vertices");
  };
  Soup refined = source;
  const auto number_of_bridges = static_cast<double>(VMP::make_parameterizable(refined));
  REQUIRE(number_of_bridges > 0);
  const double needed = added("--refine=needed sheared.mesh");
  CHECK(needed < number_of_bridges);
  CHECK(added("sheared.mesh") == 0);
  CHECK(added("--refine=none sheared.mesh") == 0);
  CHECK(added("--refine sheared.mesh") == number_of_bridges); // which is not taken for a value
  CHECK(added("--refine=helpful same.mesh") == needed);
  CHECK(added("--refine=all same.mesh") == number_of_bridges);
  CHECK(folder.run("source.mesh sheared.mesh --refine=most") == 2);
  CHECK(folder.text("stderr").find("'most'") != std::string::npos);
}

TEST_CASE("A map nearby is a start")
{
  const Folder folder;
  const Soup source = cube(6);
  folder.write("source.mesh", source);
  const auto twisted = [](const double angle)
  {
    return [angle](const Point& p)
    {
      const double c = std::cos(angle * p[2]), s = std::sin(angle * p[2]);
      return Point{c * (p[0] - 3) - s * (p[1] - 3), s * (p[0] - 3) + c * (p[1] - 3), p[2]};
    };
  };
  folder.write("target.txt", boundary_lines(source, 6, twisted(0.3)));
  REQUIRE(folder.run("source.mesh target.txt -o nearby.mesh --report report.json") == 0);
  const double number_from_scratch = number(folder.text("report.json"), "iterations");
  REQUIRE(folder.run("source.mesh target.txt --initial nearby.mesh -o map.mesh --report report.json") == 0);
  CHECK(number(folder.text("report.json"), "iterations") < number_from_scratch);
  CHECK(folder.run("source.mesh target.txt --initial none.mesh") == 2);
}

TEST_CASE("The last lines tell times, files and success")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  REQUIRE(folder.run("source.mesh --to polycube --refine=none -o map.vtu --hexahedra 1 hexahedra.mesh --report report.json") == 0);
  const std::string text = folder.text("stdout");
  const std::string end = "\nWritten: map.vtu and hexahedra.mesh\nSuccess\n";
  CHECK(text.find(end) + end.size() == text.size());
  const std::string report = folder.text("report.json");
  for(const char* part : {"seconds_reading", "seconds_boundary", "seconds_hexahedra"})
    CHECK(number(report, part) > 0);
}

TEST_CASE("A result that is not as asked for has a status and a sentence that helps")
{
  const Folder folder;
  const Soup source = cube(4);
  folder.write("source.mesh", source);
  const auto says = [&](const std::string& sentence)
  {
    CAPTURE(folder.text("stdout"), folder.text("stderr"), sentence);
    CHECK((folder.text("stdout") + folder.text("stderr")).find(sentence) != std::string::npos);
  };
  CHECK(folder.run("source.mesh --to ball --refine=none") == 0);
  says("No file is written; -o FILE writes the map\nSuccess\n");
  CHECK(folder.run("source.mesh --to ball --refine=none --max-angle-distortion 2.1 -o map.mesh --report report.json") == 1);
  says("The largest distortion of angles is ");
  CHECK(folder.text("stderr").find("boundary residual") == std::string::npos);
  CHECK(folder.text("report.json").find("\"status_code\": \"ERROR_ANGLE_BOUND_NOT_REACHED\"") != std::string::npos);
  CHECK(folder.soup("map.mesh").points.size() == source.points.size());
  CHECK(folder.run("source.mesh --to box=1,1,3 --refine=none --max-angle-distortion 3 --hexahedra 0.5 h.mesh") == 1);
  CHECK(folder.names().count("h.mesh") == 1); // as the boundary is met

  Soup angle = source; // a bar with an angle of 90 degrees
  const auto is_in_angle = [&](const std::size_t v) { return source.points[v][0] >= 1 && source.points[v][1] >= 1; };
  angle.cells.erase(std::remove_if(angle.cells.begin(), angle.cells.end(), [&](const auto& cell)
                                   { return std::all_of(cell.begin(), cell.end(), is_in_angle); }), angle.cells.end());
  angle.cell_references.resize(angle.cells.size());
  folder.write("angle.mesh", angle);
  const auto energy_of = [&](const std::string& bound, const int status)
  {
    CHECK(folder.run("angle.mesh --to cube --slide -o map.mesh --report report.json" + bound) == status);
    return number(folder.text("report.json"), "energy_value");
  };
  CHECK(energy_of(" --max-angle-distortion 5.5", 1) <= 2 * energy_of("", 0));

  Soup mirror = source;
  for(Point& p : mirror.points)
    p[2] *= -1;
  folder.write("mirror.mesh", mirror);
  CHECK(folder.run("source.mesh mirror.mesh") == 2);
  says("TARGET is a mirror image of SOURCE. Reverse the sign of one coordinate in one of them.");
  CHECK(folder.text("stderr").find("--displacements") == std::string::npos);

  Soup ring = source;
  ring.cells.clear();
  for(const auto& cell : source.cells)
  {
    const auto is_near_axis = [&](const std::size_t v)
    { return std::abs(source.points[v][0] - 2) <= 1 && std::abs(source.points[v][1] - 2) <= 1; };
    if(!std::all_of(cell.begin(), cell.end(), is_near_axis))
      ring.cells.push_back(cell);
  }
  ring.cell_references.resize(ring.cells.size());
  folder.write("ring.mesh", ring);
  CHECK(folder.run("ring.mesh --to cube") == 2);
  says("--to polycube maps bodies with handles.");

  CHECK(folder.run("missing.mesh --to cube") == 2);
  says("missing.mesh: the file cannot be opened");
}
