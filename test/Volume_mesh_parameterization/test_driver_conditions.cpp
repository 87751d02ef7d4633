// The program parameterize_mesh_file: what vertices may do.
#include "driver.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

TEST_CASE("Vertices of the boundary are free, in planes and on lines")
{
  const Folder folder;
  Soup source = cube(3);
  for(const std::array<std::size_t, 4>& cell : source.cells)
    for(int i = 0; i < 4; ++i)
      for(const int z : { 0, 3 })
        if(const std::array<std::size_t, 3> facet = { cell[(i + 1) % 4], cell[(i + 2) % 4], cell[(i + 3) % 4] };
           std::all_of(facet.begin(), facet.end(), [&](const std::size_t v) { return source.points[v][2] == z; }))
        {
          source.facets.push_back(facet);
          source.facet_references.push_back(z + 1);
        }
  folder.write("source.mesh", source);
  std::ostringstream handles;
  for(std::size_t v = 0; v < source.points.size(); ++v)
    if(const Point& p = source.points[v]; p[2] == 0 || p[2] == 3)
      handles << v << " " << p[0] << " " << p[1] << " " << (p[2] == 3 ? 4 : 0) << "\n";
  folder.write("handles.txt", handles.str());
  REQUIRE(folder.run("source.mesh handles.txt --others free -o map.mesh") == 0);
  CHECK(folder.text("stdout").find("boundary vertices: 32 at targets, 0 in planes, 0 on lines, 24 free") != std::string::npos);
  const std::vector<Point> stretched = folder.soup("map.mesh").points;
  for(std::size_t v = 0; v < stretched.size(); ++v)
  {
    const Point& p = source.points[v];
    if(p[2] == 0 || p[2] == 3)
      CHECK(stretched[v] == Point{p[0], p[1], p[2] == 3 ? 4. : 0.});
    CHECK(stretched[v][2] == Approx(p[2] * 4 / 3).margin(0.05));
  }
  CHECK(folder.run("source.mesh handles.txt --others free --energy stretch") == 2);
  CHECK(folder.text("stderr").find("--energy symmetric_dirichlet has a minimum") != std::string::npos);

  folder.write("conditions.txt", "# depths\n1 z=0\n4 z=1.5\n");
  REQUIRE(folder.run("source.mesh --conditions conditions.txt -o map.mesh") == 0);
  CHECK(folder.text("stdout").find("0 at targets, 32 in planes, 0 on lines, 24 free") != std::string::npos);
  CHECK(folder.text("stdout").find("cells before the map: dihedral angles 45 to 90 degrees, least sca") != std::string::npos);
  CHECK(folder.text("stdout").find("cells after the map: dihedral angles ") != std::string::npos);
  const std::vector<Point> depths = folder.soup("map.mesh").points;
  for(std::size_t v = 0; v < depths.size(); ++v)
    if(const double z = source.points[v][2]; z == 0 || z == 3)
      CHECK(depths[v][2] == z / 2);

  for(const auto& [line, message] : std::vector<std::pair<std::string, std::string> >{
        { "1 z=0\n\n1 z=1", "lines 1 and 3 contradict each other" },
        { "7 fixed", "the reference or the name '7'. There are 1 and 4" },
        { "1 held", "'held' is not a condition" },
        { "vertex 99 fixed", "there is no vertex 99" }, { "1 z=a", "'a' is not a coordinate" }, { "1 plane 0 0 0", "is zero" },
        { "1 free 2", "follows the condition" } })
  {
    folder.write("bad.txt", line);
    CHECK(folder.run("source.mesh --conditions bad.txt") == 2);
    CHECK(folder.text("stderr").find("bad.txt: ") != std::string::npos);
    CHECK(folder.text("stderr").find(message) != std::string::npos);
  }
  CHECK(folder.run("source.mesh --to cube --conditions conditions.txt") == 2);
}

namespace {

// Three unit cubes in a row. The first two have points of their own where they meet, and the third one shares one vertex with the
// second. The facets at x = 0, x = 2 and x = 3 have the references 1, 2 and 3.
Soup torn_and_pinched_body()
{
  Soup soup;
  std::vector<std::map<Point, std::size_t> > vertices(2);
  for(const Point& corner : { Point{ 0, 0, 0 }, Point{ 1, 0, 0 }, Point{ 2, 1, 1 } })
    for(const auto& cell : cube(1).cells)
    {
      soup.cells.emplace_back();
      for(std::size_t i = 0; i < 4; ++i)
      {
        const Point q = cube(1).points[cell[i]], p = { q[0] + corner[0], q[1] + corner[1], q[2] + corner[2] };
        const auto [entry, is_new] = vertices[corner[0] > 0].emplace(p, soup.points.size());
        if(is_new)
          soup.points.push_back(p);
        soup.cells.back()[i] = entry->second;
      }
      for(const int x : { 0, 2, 3 })
        for(std::size_t i = 0; i < 4; ++i)
        {
          std::array<std::size_t, 3> facet;
          for(std::size_t j = 0; j < 3; ++j)
            facet[j] = soup.cells.back()[(i + 1 + j) % 4];
          if((x != 2 || corner[0] == 1)
             && std::all_of(facet.begin(), facet.end(), [&](const std::size_t v) { return soup.points[v][0] == x; }))
          {
            soup.facets.push_back(facet);
            soup.facet_references.push_back((std::max)(1, x));
          }
        }
    }
  soup.cell_references.assign(soup.cells.size(), 1);
  return soup;
}

} // namespace

TEST_CASE("What a vertex may do is kept in all combinations of TARGET, --conditions, --others, merged and separated copies")
{
  const Folder folder;
  const Soup source = torn_and_pinched_body();
  const std::size_t n = source.points.size();
  folder.write("source.mesh", source);
  const auto first_vertex_at = [&](const Point& p)
  { return static_cast<std::size_t>(std::find(source.points.begin(), source.points.end(), p) - source.points.begin()); };
  const auto last_vertex_at = [&](const Point& p) // of two copies the one that is merged with the other
  { return static_cast<std::size_t>(source.points.rend() - std::find(source.points.rbegin(), source.points.rend(), p)) - 1; };
  const std::size_t torn = last_vertex_at({ 1, 0, 0 }), pinched = last_vertex_at({ 2, 1, 1 }), moved = last_vertex_at({ 1, 1, 0 }),
                    conditioned = last_vertex_at({ 3, 2, 1 });
  folder.write("conditions.txt", "vertex " + std::to_string(torn) + " x=1.1\n1 fixed\n2 fixed\n3 x=3.0625\nvertex "
                                 + std::to_string(pinched) + " z=1\n");
  folder.write("target.txt", std::to_string(moved) + " 1.0625 1.125 0\n" + std::to_string(conditioned) + " 3 2.125 1\n"
                             + std::to_string(torn) + " 1.125 0.125 0\n");
  for(const bool has_target : { false, true })
    for(const bool has_conditions : { false, true })
      for(const std::string others : { "", "missing", "stay", "slide", "free" })
        for(const std::string copies : { "", " --merge-points", " --separate", " --merge-points --separate" })
        {
          const std::string arguments = std::string("source.mesh") + (has_target ? " target.txt" : "")
            + (has_conditions ? " --conditions conditions.txt" : "") + (others.empty() ? "" : " --others " + others) + copies;
          CAPTURE(arguments);
          const int exit_code = folder.run(arguments + " -o map.mesh");
          const std::string way = !others.empty() ? others : has_conditions ? "free" : "missing";
          const bool is_refused = (!has_target && !has_conditions) || way == "missing" || (has_conditions && way == "slide");
          CAPTURE(folder.text("stderr"));
          REQUIRE(exit_code == (is_refused ? 2 : 0));
          if(is_refused)
            continue;
          const Soup map = folder.soup("map.mesh");
          const bool is_merged = copies.find("merge") != std::string::npos;
          REQUIRE(map.points.size() == n + (copies.find("separate") != std::string::npos));
          for(std::size_t v = 0; v < map.points.size(); ++v)
          {
            const Point& p = v < n ? source.points[v] : source.points[pinched];
            const Point& image = map.points[v];
            const auto is_copy_of = [&](const std::size_t w) { return is_merged ? p == source.points[w] : v == w; };
            bool is_in_facet[4] = {};
            for(std::size_t f = 0; f < map.facets.size(); ++f)
              if(std::count(map.facets[f].begin(), map.facets[f].end(), v) > 0)
                is_in_facet[map.facet_references[f]] = true;
            Point position = p;
            const bool is_given = has_target && (is_copy_of(moved) || is_copy_of(conditioned) || is_copy_of(torn));
            if(is_given)
              position = is_copy_of(moved) ? Point{ 1.0625, 1.125, 0 } : is_copy_of(torn) ? Point{ 1.125, 0.125, 0 }
                                                                                        : Point{ 3, 2.125, 1 };
            if(has_conditions && (is_in_facet[1] || is_in_facet[2]))
              CHECK(image == position);
            else if(has_conditions && is_in_facet[3])
              CHECK(image[0] == 3.0625);
            else if(has_conditions && is_copy_of(torn))
              CHECK(image[0] == 1.1);
            else if(has_conditions && p == source.points[pinched])
              CHECK(image[2] == 1);
            else if(is_given || way == "stay")
              CHECK(image == position);
          }
        }
  const std::string two_copies[] = { std::to_string(torn), std::to_string(first_vertex_at({ 1, 0, 0 })) };
  folder.write("contradiction.txt", "3 fixed\nvertex " + two_copies[0] + " x=1.1\n\nvertex " + two_copies[1] + " x=1.2");
  CHECK(folder.run("source.mesh --conditions contradiction.txt") == 0);
  CHECK(folder.run("source.mesh --conditions contradiction.txt --merge-points") == 2);
  CHECK(folder.text("stderr").find("contradiction.txt: lines 2 and 4 contradict each other at vertex ") != std::string::npos);
  folder.write("contradiction.txt", two_copies[0] + " 1 0 0\n" + two_copies[1] + " 1 0.1 0");
  CHECK(folder.run("source.mesh contradiction.txt --others stay") == 0);
  CHECK(folder.run("source.mesh contradiction.txt --others stay --merge-points") == 2);
  CHECK(folder.text("stderr").find("are merged, but have different points here") != std::string::npos);
}

TEST_CASE("Groups of a file of Gmsh may have one name, and all of them have its conditions")
{
  if(!fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
    return;
  const Folder folder;
  folder.write("source.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 1 \"the wall\"\n2 2 \"the wall\"\n"
    "2 3 \"top\"\n$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n4\n"
    "1 4 2 1 1 1 2 3 4\n2 2 2 1 1 1 2 3\n3 2 2 2 2 1 2 4\n4 2 2 3 3 2 3 4\n$EndElements\n");
  folder.write("conditions.txt", "\"the wall\" plane 1 1 1\n");
  REQUIRE(folder.run("source.msh --conditions conditions.txt") == 0);
  CHECK(folder.text("stdout").find("boundary vertices: 0 at targets, 4 in planes") != std::string::npos);
  folder.write("conditions.txt", "wall fixed\n");
  CHECK(folder.run("source.msh --conditions conditions.txt") == 2);
  CHECK(folder.text("stderr").find("There are 'the wall', 'the wall' and 'top'; names with blanks need quotes")
        != std::string::npos);
}

TEST_CASE("Conditions that leave a part of the boundary free have an energy with a minimum, whatever --others is")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  folder.write("conditions.txt", "vertex 0 free\n");
  CHECK(folder.run("source.mesh --conditions conditions.txt --others stay") == 0);
  folder.write("far.txt", "0 1e300 0 0\n");
  CHECK(folder.run("source.mesh far.txt --others free") == 2);
  CHECK(folder.text("stderr").find("at coordinates of up to 1e+300, where rounding is larger than the image of the body")
        != std::string::npos);
  folder.write("empty.txt", "# nothing yet\n");
  CHECK(folder.run("source.mesh empty.txt --others stay") == 2);
  CHECK(folder.text("stderr") == "empty.txt: there is no target of a vertex\n");
}
