// The program parameterize_mesh_file: meshes that are turned, joined, separated and untangled.
#include "driver.h"

#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

TEST_CASE("Negative cells are turned and counted by a note, and are positive in written files")
{
  const Folder folder;
  const Soup positive = cube(2);
  Soup negative = positive;
  for(auto& cell : negative.cells)
    std::swap(cell[2], cell[3]);
  folder.write("target.txt", boundary_lines(positive, 2, affine));
  folder.write("positive.mesh", positive);
  folder.write("negative.mesh", negative);
  REQUIRE(folder.run("positive.mesh target.txt -o positive_map.mesh") == 0);
  CHECK(folder.text("stderr") == "");
  REQUIRE(folder.run("negative.mesh target.txt -o negative_map.mesh --refined-source again.mesh --report report.json") == 0);
  CHECK(folder.text("stderr") == "note: negative.mesh: all 48 cells are negative and are turned. The written files have "
        "positive cells\n");
  CHECK(number(folder.text("report.json"), "turned_cells") == 48);
  CHECK(folder.text("negative_map.mesh") == folder.text("positive_map.mesh"));
  CHECK(folder.text("again.mesh") == folder.text("positive.mesh"));
}

TEST_CASE("Cells that a file has twice, as those of two groups, are one")
{
  const Folder folder;
  const Soup source = cube(2);
  Soup twice = source;
  for(std::size_t c = 0; c < source.cells.size(); c += 2)
  {
    auto cell = source.cells[c];
    std::swap(cell[0], cell[3]); // in any order, and reversed
    twice.cells.push_back(cell);
    twice.cell_references.push_back(c < 24 ? 5 : 1);
  }
  folder.write("twice.mesh", twice);
  folder.write("target.txt", boundary_lines(source, 2, affine));
  for(const std::string target : { "target.txt", "twice.mesh" }) // the target may be a copy of the file
  {
    REQUIRE(folder.run("twice.mesh " + target + " -o map.vtu") == 0);
    CHECK(folder.text("stderr").find("note: twice.mesh: 24 cells have the vertices of an earlier cell and are left out. For "
                                     "example, cell 48 has those of cell 0 (counted from 0). Their references are the cell data "
                                     "'reference_2'")
          == 0);
    Soup map;
    VMP::IO::read_tetrahedron_soup(folder.path("map.vtu"), map);
    CHECK(map.cells == source.cells);
    CHECK(map.cell_references == source.cell_references);
    REQUIRE(map.cell_data.size() > 0);
    const auto found = std::find_if(map.cell_data.begin(), map.cell_data.end(),
                                    [](const auto& array) { return array.name == "reference_2"; });
    REQUIRE(found != map.cell_data.end());
    for(std::size_t c = 0; c < map.cells.size(); ++c)
      CHECK(found->values[c] == (c < 24 && c % 2 == 0 ? 5 : 0));
  }
}

TEST_CASE("A body that is torn at doubled points is told, and joined")
{
  const Folder folder;
  // the halves of a bar, each with points of its own where they meet
  Soup bar = cube(2);
  const std::size_t n = bar.points.size();
  for(const Point& p : cube(2).points)
    bar.points.push_back({p[0] + 2, p[1], p[2]});
  for(const auto& [a, b, c, d] : cube(2).cells)
    bar.cells.push_back({a + n, b + n, c + n, d + n});
  bar.cell_references.assign(bar.cells.size(), 1);
  folder.write("torn.mesh", bar);
  CHECK(folder.run("torn.mesh --to polycube --refine=none --report report.json") == 0);
  CHECK(folder.text("stderr").find("note: torn.mesh: 9 vertices of the boundary have the position of another one. For example, "
                                   "vertex 35 has the position of vertex 26 (counted from 0)") == 0);
  CHECK(number(folder.text("report.json"), "coinciding_points") == 9);

  CHECK(folder.run("torn.mesh --to ball") == 2);
  CHECK(folder.run("torn.mesh --to ball --refine --merge-points -o map.mesh --report report.json") == 0);
  CHECK(folder.text("stderr").find("note: torn.mesh: 9 points have the position of another point, and are merged") == 0);
  CHECK(number(folder.text("report.json"), "merged_points") == 9);
  CHECK(number(folder.text("report.json"), "coinciding_points") == 0);
  // points a little apart are joined up to a distance, and so are their targets
  Soup gap = bar;
  for(std::size_t v = n; v < gap.points.size(); ++v)
    gap.points[v][0] += 1e-4;
  folder.write("gap.mesh", gap);
  CHECK(folder.run("gap.mesh gap.mesh --merge-points=0.001 -o map.mesh") == 0);
  CHECK(folder.text("stderr").find("note: gap.mesh: 9 points have the position of another point, and are merged with it; or ")
        == 0);
  CHECK(folder.run("gap.mesh --to ball --merge-points=1.5") == 2);
  CHECK(folder.text("stderr").find("gap.mesh: the distance 1.5 joins the vertices ") == 0);
  // targets are told of the points of the file, of any of those at one place
  CHECK(folder.run("torn.mesh torn.mesh --merge-points -o map.mesh") == 0);
  const std::vector<Point> map = folder.soup("map.mesh").points;
  REQUIRE(map.size() == 2 * n);
  for(std::size_t v = 0; v < map.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
      CHECK(map[v][i] == Approx(bar.points[v][i]).margin(1e-6));
  std::string lines;
  for(std::size_t v = 0; v < bar.points.size(); ++v)
    if(bar.points[v] != Point{1, 1, 1} && bar.points[v] != Point{3, 1, 1} && (bar.points[v][0] != 2 || v >= n)
       && bar.points[v] != Point{2, 1, 1})
      lines += std::to_string(v) + " " + std::to_string(bar.points[v][0] * 2) + " " + std::to_string(bar.points[v][1]) + " "
             + std::to_string(bar.points[v][2]) + "\n";
  folder.write("lines.txt", lines);
  CHECK(folder.run("torn.mesh lines.txt --merge-points -o map.mesh") == 0);
  CHECK(folder.soup("map.mesh").points[26] == Point{4, 2, 2});
  CHECK(folder.soup("map.mesh").points[35] == Point{4, 2, 2});
}

TEST_CASE("Reversed cells are turned, and told")
{
  const Folder folder;
  const Soup source = cube(2);
  Soup reversed = source;
  for(std::size_t c = 0; c < source.cells.size(); c += 2)
    std::swap(reversed.cells[c][0], reversed.cells[c][1]);
  folder.write("source.mesh", source);
  folder.write("reversed.mesh", reversed);
  folder.write("target.txt", boundary_lines(source, 2, affine));
  CHECK(folder.run("reversed.mesh target.txt -o map.mesh --report report.json") == 0);
  CHECK(folder.text("stderr") == "note: reversed.mesh: 24 of 48 cells were reversed and are turned\n");
  CHECK(number(folder.text("report.json"), "turned_cells") == 24);
  const double energy = number(folder.text("report.json"), "energy_value");
  CHECK(folder.run("source.mesh target.txt --report report.json") == 0);
  CHECK(number(folder.text("report.json"), "energy_value") == Approx(energy));
}

TEST_CASE("Reversed cells are turned also if others are flat")
{
  const Folder folder;
  Soup source = cube(2);
  source.cells.push_back({0, 12, 9, 3}); // on the side z = 0
  source.cell_references.push_back(1);
  for(std::size_t c = 0; c < 48; c += 2)
    std::swap(source.cells[c][0], source.cells[c][1]);
  folder.write("source.mesh", source);
  CHECK(folder.run("source.mesh --to ball --refine") == 2);
  CHECK(std::regex_search(folder.text("stderr"), std::regex("^source.mesh: 24 of 49 cells were reversed and are turned; cell 48 "
                                                            "\\(counted from 0\\) has zero volume; --improve -o FILE")));
  REQUIRE(folder.run("source.mesh --improve --refine -o improved.mesh --report report.json") == 0); // as advised
  CHECK(number(folder.text("report.json"), "turned_cells") == 24);
  CHECK(number(folder.text("report.json"), "tangled_cells") == 1);
  CHECK(folder.run("improved.mesh --to ball --refine") == 0);
  CHECK(folder.text("stderr") == "");
}

TEST_CASE("Flat cells at the boundary are left out on request, as advised")
{
  const Folder folder;
  Soup source; // two cells below a triangle with a vertex on an edge, and a flat cell on this triangle
  source.points = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, 0.5, -1}};
  source.cells = {{0, 3, 1, 2}, {0, 2, 3, 4}, {3, 2, 1, 4}};
  source.cell_references = {1, 1, 1};
  folder.write("source.mesh", source);
  CHECK(folder.run("source.mesh --improve -o map.mesh") == 2);
  CHECK(folder.text("stderr").find("--leave-out-flat-cells leaves out flat cells at the boundary") != std::string::npos);
  REQUIRE(folder.run("source.mesh --improve --leave-out-flat-cells -o map.mesh") == 0);
  CHECK(folder.text("stderr").find("note: source.mesh: 1 flat cell at the boundary is left out.") == 0);
  CHECK(folder.soup("map.mesh").cells.size() == 2);
}

TEST_CASE("A tangled mesh is improved within its boundary")
{
  const Folder folder;
  Soup source = cube(4);
  const auto vertex
    = [&](const Point& p) { return std::find(source.points.begin(), source.points.end(), p) - source.points.begin(); };
  const auto lower = vertex({2, 2, 1}), middle = vertex({2, 2, 2}), upper = vertex({2, 2, 3});
  const Soup cube_of_4 = source;
  std::swap(source.points[lower], source.points[upper]);
  source.points[middle] = {9, 2, 2};
  folder.write("tangled.mesh", source);
  CHECK(folder.run("tangled.mesh --to ball") == 2);
  CHECK(folder.text("stderr").find("; --improve -o FILE moves interior vertices") != std::string::npos);
  const auto check = [&](const std::string& arguments)
  {
    CAPTURE(arguments);
    REQUIRE(folder.run(arguments + " --improve -o mended.mesh --report report.json") == 0);
    const Soup mended = folder.soup("mended.mesh");
    CHECK(mended.cells == source.cells);
    CHECK(mended.cell_references == source.cell_references);
    REQUIRE(mended.points.size() == source.points.size());
    for(std::size_t v = 0; v < source.points.size(); ++v)
      if(is_on_boundary(cube_of_4.points[v], 4))
        CHECK(mended.points[v] == source.points[v]);
    CHECK(number(folder.text("report.json"), "boundary_residual") == 0);
    REQUIRE(folder.run("mended.mesh --to cube --refine") == 0); // which wants positive cells
    return mended.points;
  };
  CHECK(check("tangled.mesh")[middle][0] == Approx(2).margin(0.1));
  CHECK(folder.text("report.json").find("\"energy\": \"mips\"") != std::string::npos);
  const double number_before = number(folder.text("report.json"), "tangled_cells");
  CHECK(number_before > 10);
  check("tangled.mesh --energy stretch");

  Soup negative = source;
  for(auto& cell : negative.cells)
    std::swap(cell[2], cell[3]);
  folder.write("negative.mesh", negative);
  check("negative.mesh");
  CHECK(folder.text("stdout").find(" cells were inverted or flat") == std::string::npos); // of the cube
  CHECK(number(folder.text("report.json"), "tangled_cells") == number_before);

  // the interface between two materials, and triangles inside, stay
  for(std::size_t c = 0; c < source.cells.size(); ++c)
    source.cell_references[c] = std::all_of(source.cells[c].begin(), source.cells[c].end(), [&](const std::size_t v)
                                            { return cube_of_4.points[v][0] <= 1; }) ? 7 : 8;
  source.points[vertex({1, 1, 1})] = {1, 1.1, 1.2};
  source.points[vertex({3, 1, 1})] = {3, 1.1, 1.2};
  const std::vector<std::size_t> staying
    = {static_cast<std::size_t>(vertex({1, 1.1, 1.2})), static_cast<std::size_t>(vertex({3, 1.1, 1.2}))};
  source.facets = {{staying[1], static_cast<std::size_t>(vertex({3, 1, 2})), static_cast<std::size_t>(vertex({3, 2, 2}))}};
  source.facet_references = {5};
  folder.write("materials.mesh", source);
  const std::vector<Point> mended = check("materials.mesh");
  for(const std::size_t v : staying)
    CHECK(mended[v] == source.points[v]);

  // a flat cell below two facets of the boundary
  Soup flat = cube(2);
  flat.cells.push_back({0, 12, 9, 3}); // the corners of a square on the side z = 0, along its diagonal from 0 to 12
  flat.cell_references.push_back(4);
  folder.write("flat.mesh", flat);
  CHECK(folder.run("flat.mesh --to ball") == 2);
  CHECK(folder.text("stderr").find("flat.mesh: cell 48 (counted from 0) has zero volume; --improve -o FILE") == 0);
  CHECK(folder.run("flat.mesh --improve -o mended.mesh") == 2);
  CHECK(folder.text("stderr").find(" --refine splits such cells.") != std::string::npos);
  REQUIRE(folder.run("flat.mesh --improve --refine -o mended.mesh") == 0);
  CHECK(folder.text("stdout").find("\n1 cell was inverted or flat\n") != std::string::npos);
  CHECK(folder.soup("mended.mesh").points.size() > flat.points.size());
  CHECK(folder.run("mended.mesh --to ball --refine") == 0);
  CHECK(folder.run("flat.mesh --improve --refine=all -o mended.vtu") == 0);

  Soup sliver = cube(2); // whose volumes are positive in exact arithmetic only
  for(Point& p : sliver.points)
    p[2] *= 1e-320;
  folder.write("sliver.mesh", sliver);
  CHECK(folder.run("sliver.mesh sliver.mesh") == 2);
  CAPTURE(folder.text("stderr"));
  CHECK(folder.text("stderr").find(" --improve -o FILE moves interior vertices") != std::string::npos);

  CHECK(folder.run("flat.mesh --improve --to ball") == 2);
  CHECK(folder.run("flat.mesh --improve --boundary soft") == 2);
  CHECK(folder.run("flat.mesh --improve --hexahedra 1 h.mesh") == 2);
}

TEST_CASE("A body that touches itself is separated on request")
{
  const Folder folder;
  // cubes along a bow whose ends touch each other along two edges
  Soup soup;
  std::map<Point, std::size_t> vertices;
  for(const Point& corner : {Point{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {1, 1, 1}, {1, 1, 0}})
    for(const auto& cell : cube(1).cells)
    {
      soup.cells.emplace_back();
      for(std::size_t i = 0; i < 4; ++i)
      {
        const Point p = cube(1).points[cell[i]];
        const auto [entry, is_new]
          = vertices.emplace(Point{p[0] + corner[0], p[1] + corner[1], p[2] + corner[2]}, vertices.size());
        if(is_new)
          soup.points.push_back(entry->first);
        soup.cells.back()[i] = entry->second;
      }
    }
  soup.cell_references.assign(soup.cells.size(), 1);
  folder.write("source.mesh", soup);
  CHECK(folder.run("source.mesh --to ball --refine") == 2);
  CAPTURE(folder.text("stderr"));
  CHECK(folder.text("stderr").find("--separate separates them") != std::string::npos);
  CHECK(folder.run("source.mesh --to ball --refine --separate --report report.json -o map.mesh --refined-source refined.mesh")
        == 0);
  CHECK(number(folder.text("report.json"), "separated_vertices") == 2);
  CHECK(folder.soup("refined.mesh").points[soup.points.size()][2] < 2);
}

TEST_CASE("Gaps between cells that touch each other along an edge are joined on request, or closing one helps")
{
  const Folder folder;
  // a block of 2 x 2 x 3 cubes, two of which are missing in the middle, on either side of an edge
  Soup soup = cube(3);
  const auto write = [&](const std::string& name, const std::set<std::array<int, 3> >& missing)
  {
    Soup block;
    block.points = soup.points;
    for(std::size_t c = 0; c < soup.cells.size(); ++c)
    {
      std::array<int, 3> corner = {3, 3, 3};
      for(const std::size_t v : soup.cells[c])
        for(std::size_t i = 0; i < 3; ++i)
          corner[i] = (std::min)(corner[i], static_cast<int>(soup.points[v][i]));
      if(corner[0] < 2 && corner[1] < 2 && missing.count(corner) == 0)
        block.cells.push_back(soup.cells[c]);
    }
    block.cell_references.assign(block.cells.size(), 1);
    folder.write(name, block);
  };
  write("gaps.mesh", { {0, 0, 1}, {1, 1, 1} });
  write("closed.mesh", { {0, 0, 1} });
  CHECK(folder.run("gaps.mesh --to polycube") == 2);
  CHECK(folder.text("stderr").find("--separate separates them") != std::string::npos);
  CHECK(folder.run("gaps.mesh --improve --separate --report report.json -o map.mesh") == 0);
  CHECK(number(folder.text("report.json"), "separated_vertices") == 2); // the midpoint, and its copy
  CHECK(folder.run("closed.mesh --to ball --refine") == 0);
}
