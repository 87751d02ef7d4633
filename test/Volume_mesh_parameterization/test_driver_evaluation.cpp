// The program parameterize_mesh_file: points that a map carries.
#include "driver.h"

#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

TEST_CASE("Points are carried by the map and back, with data, and those outside with their distance")
{
  const Folder folder;
  Soup source = cube(2);
  source.point_data = { { "T", 2, false, {} }, { "id", 1, true, {} } };
  for(const Point& p : source.points)
  {
    source.point_data[0].values.insert(source.point_data[0].values.end(), { p[0] - p[2], 2 * p[1] });
    source.point_data[1].values.push_back(p[0] + 3 * p[1] + 9 * p[2]);
  }
  std::ofstream vtu(folder.path("source.vtu"), std::ios::binary);
  VMP::IO::write_VTU(vtu, source, source.points);
  vtu.close();
  Soup target = source;
  for(Point& p : target.points)
    p = affine(p);
  folder.write("target.mesh", target);
  const auto rows = [&](const std::string& name)
  {
    std::istringstream lines(folder.text(name));
    std::string line;
    std::getline(lines, line);
    CHECK(line.find("x,y,z,u,v,w,distance,cell,reference,\"T:0\",\"T:1\",\"id\"") == 0);
    std::vector<std::vector<double> > result;
    while(std::getline(lines, line))
    {
      result.emplace_back();
      std::istringstream words(line);
      for(std::string word; std::getline(words, word, ','); )
        result.back().push_back(std::stod(word));
    }
    return result;
  };
  const std::vector<Point> points = { { 0.3, 1.25, 0.7 }, { 1.9, 0.1, 1 }, { 1, 1, 2.5 } };
  folder.write("points.csv", "a, b, c\n0.3, 1.25, 0.7\n1.9 0.1 1 # inside\n\n1,1,2.5\n");
  REQUIRE(folder.run("source.vtu target.mesh --evaluate points.csv images.csv") == 0);
  CHECK(folder.text("stdout").find("Written: images.csv") != std::string::npos);
  const auto images = rows("images.csv");
  REQUIRE(images.size() == 3);
  std::string back;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const std::vector<double>& row = images[i];
    const Point p = { points[i][0], points[i][1], (std::min)(points[i][2], 2.) }, q = affine(p);
    CHECK(row[6] == Approx(points[i][2] - p[2]).margin(1e-12));
    CHECK(row[9] == Approx(p[0] - p[2]).margin(1e-12));
    CHECK(row[10] == Approx(2 * p[1]).margin(1e-12));
    for(std::size_t k = 0; k < 3; ++k)
    {
      CHECK(row[k] == Approx(p[k]).margin(1e-12));
      CHECK(row[3 + k] == Approx(q[k]).margin(1e-4));
      back += std::to_string(row[3 + k]) + " ";
    }
    back += "\n";
  }
  CHECK(images[0][11] == std::round(images[0][11])); // of a vertex
  folder.write("images.txt", back);
  REQUIRE(folder.run("source.vtu target.mesh --evaluate-inverse images.txt points_again.csv") == 0);
  const auto again = rows("points_again.csv");
  REQUIRE(again.size() == 3);
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      CHECK(again[i][k] == Approx(images[i][k]).margin(1e-5));
  folder.write("bad.csv", "1 2 3\n1 2\n");
  CHECK(folder.run("source.vtu target.mesh --evaluate bad.csv t.csv") == 2);
  CHECK(folder.text("stderr").find("bad.csv: line 2 does not have three coordinates") != std::string::npos);
  CHECK(folder.run("source.vtu target.mesh --evaluate points.csv") == 2);
}
