// The program parameterize_mesh_file: its exit codes, its files and its sentences.
#include "catch.h"
#include "Soup_bytes.h"
#include "array_of_vtu_file.h"

#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>


#include <pty.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Soup = VMP::Tetrahedron_soup_3;
using Point = std::array<double, 3>;
using Names = std::set<std::string>;

namespace {

// A word of a command of the shell.
std::string quoted(const std::string& text) { return "'" + std::regex_replace(text, std::regex("'"), "'\\''") + "'"; }

// A folder of its own for one test, with what the driver needs in it.
class Folder
{
public:
  Folder()
    : m_path(fs::temp_directory_path() / ("test_driver_" + std::to_string(getpid())))
  {
    fs::remove_all(m_path);
    fs::create_directory(m_path);
  }

  ~Folder() { fs::remove_all(m_path); }

  std::string path(const std::string& name) const { return (m_path / name).string(); }

  std::string text(const std::string& name) const
  {
    std::ifstream is(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
  }

  void write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name), std::ios::binary) << text;
  }

  void write(const std::string& name, const Soup& soup) const
  {
    std::ofstream os(path(name), std::ios::binary);
    VMP::IO::write_MEDIT(os, soup);
  }

  Soup soup(const std::string& name) const
  {
    Soup soup;
    VMP::IO::read_MEDIT(path(name), soup);
    return soup;
  }

  // the files other than those with what the driver printed
  Names names() const
  {
    Names result;
    for(const fs::directory_entry& entry : fs::directory_iterator(m_path))
      result.insert(entry.path().filename().string());
    result.erase("stdout");
    result.erase("stderr");
    return result;
  }

  // Runs the driver in this folder and returns its exit code.
  int run(const std::string& arguments) const { return shell("\"$driver\" " + arguments); }

  // Runs a command, in which "$driver" is the program.
  int shell(const std::string& command) const
  {
    const std::string line = "driver=" + quoted(PARAMETERIZE_MESH_FILE) + "; cd " + quoted(m_path.string()) + " && { " + command
      + "\n} > stdout 2> stderr";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

private:
  fs::path m_path;
};

// The driver on a terminal of its own, where it shows its progress.
class Terminal
{
public:
  Terminal(const Folder& folder, const std::string& arguments)
    : m_process(forkpty(&m_terminal, nullptr, nullptr, nullptr))
  {
    REQUIRE(m_process >= 0);
    if(m_process > 0)
      return;
    const std::string command = "cd " + quoted(folder.path("")) + " && exec " + quoted(PARAMETERIZE_MESH_FILE) + " " + arguments;
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }

  ~Terminal() { close(m_terminal); }

  // Reads until the text comes, and not again what was read before.
  bool waits_for(const std::string& text)
  {
    char c;
    while(m_text.find(text) == std::string::npos)
    {
      if(read(m_terminal, &c, 1) != 1)
        return false;
      m_text += c;
    }
    m_text.clear();
    return true;
  }

  void interrupt() const { send(SIGINT); }
  void send(const int signal) const { kill(m_process, signal); }

  // Asks twice at once.
  void interrupt_and_terminate() const
  {
    kill(m_process, SIGSTOP);
    kill(m_process, SIGINT);
    kill(m_process, SIGTERM);
    kill(m_process, SIGCONT);
  }

  int exit_code()
  {
    waits_for("never said");
    int status = 0;
    waitpid(m_process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

private:
  int m_terminal = -1;
  pid_t m_process;
  std::string m_text;
};

// The cube [0, n]^3 of unit cubes, each cut into six cells around its diagonal.
Soup cube(std::size_t n)
{
  Soup soup;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j)
      for(std::size_t k = 0; k <= n; ++k)
        soup.points.push_back({double(i), double(j), double(k)});

  const std::array<std::size_t, 3> step = {(n + 1) * (n + 1), n + 1, 1};
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
      for(std::size_t k = 0; k < n; ++k)
        for(std::size_t a = 0; a < 3; ++a)
        {
          const std::size_t origin = i * step[0] + j * step[1] + k;
          const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
          const std::size_t opposite = origin + step[0] + step[1] + step[2];
          soup.cells.push_back({origin, origin + step[a], origin + step[a] + step[b], opposite});
          soup.cells.push_back({origin, origin + step[a] + step[c], origin + step[a], opposite});
        }
  soup.cell_references.assign(soup.cells.size(), 1);
  return soup;
}

bool is_on_boundary(const Point& p, double n)
{
  for(double x : p)
    if(x == 0 || x == n)
      return true;
  return false;
}

Point affine(const Point& p)
{
  return {0.1 + p[0] / 3 + p[1] / 7, p[1] * 0.7, p[2] * 1.1 + p[0] / 9};
}

// the lines `index x y z` of the boundary of cube(n) under a map
template <typename Map>
std::string boundary_lines(const Soup& soup, double n, const Map& map)
{
  std::ostringstream os;
  os.precision(17);
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(is_on_boundary(soup.points[v], n))
    {
      const Point q = map(soup.points[v]);
      os << v << " " << q[0] << " " << q[1] << " " << q[2] << "\n";
    }
  return os.str();
}

// A prism whose cells all share one interior vertex, the first one. Around half a circle it cannot be bent:
// no point sees all of the bent surface.
Soup fan_in_prism(std::size_t length)
{
  Soup soup;
  soup.points.push_back({0.5, 0.5, double(length) / 2});
  for(std::size_t k = 0; k <= length; ++k)
    for(const Point& p : {Point{0, 0, 0}, Point{1, 0, 0}, Point{1, 1, 0}, Point{0, 1, 0}})
      soup.points.push_back({p[0], p[1], double(k)});

  const auto add_quad = [&soup](std::size_t a, std::size_t b, std::size_t c, std::size_t d)
  {
    soup.cells.push_back({0, a, b, c});
    soup.cells.push_back({0, a, c, d});
  };
  const auto corner = [](std::size_t k, std::size_t i) { return 1 + 4 * k + i % 4; };
  add_quad(corner(0, 3), corner(0, 2), corner(0, 1), corner(0, 0));
  add_quad(corner(length, 0), corner(length, 1), corner(length, 2), corner(length, 3));
  for(std::size_t k = 0; k < length; ++k)
    for(std::size_t i = 0; i < 4; ++i)
      add_quad(corner(k, i), corner(k, i + 1), corner(k + 1, i + 1), corner(k + 1, i));
  soup.cell_references.assign(soup.cells.size(), 1);
  return soup;
}

// The least determinant of the trilinear maps to the hexahedra of a .mesh file, at 9^3 points of each.
double smallest_determinant_of_hexahedra(const std::string& file)
{
  std::istringstream mesh(file);
  const auto numbers_behind = [&mesh](const std::string& keyword, const std::size_t row)
  {
    std::string word;
    while(mesh >> word && word != keyword) {}
    std::size_t size = 0;
    mesh >> size;
    std::vector<double> result(size * row);
    for(double& x : result)
      mesh >> x;
    REQUIRE((mesh && size > 0));
    return result;
  };
  const std::vector<double> points = numbers_behind("Vertices", 4), cells = numbers_behind("Hexahedra", 9);
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t c = 0; c < cells.size(); c += 9)
    for(int l = 0; l < 9 * 9 * 9; ++l)
    {
      const double at[3] = { l / 81 / 8., l / 9 % 9 / 8., l % 9 / 8. };
      double d[3][3] = {}; // derivatives
      for(std::size_t i = 0; i < 8; ++i)
      {
        const int corner[3] = { i % 4 == 1 || i % 4 == 2, i % 4 > 1, i > 3 };
        const std::size_t v = 4 * (static_cast<std::size_t>(cells[c + i]) - 1);
        for(int axis = 0; axis < 3; ++axis)
        {
          double factor = 1;
          for(int k = 0; k < 3; ++k)
            factor *= k == axis ? 2 * corner[k] - 1 : corner[k] == 1 ? at[k] : 1 - at[k];
          for(std::size_t k = 0; k < 3; ++k)
            d[axis][k] += factor * points[v + k];
        }
      }
      double determinant = 0;
      for(int k = 0; k < 3; ++k)
        determinant += d[0][k] * (d[1][(k + 1) % 3] * d[2][(k + 2) % 3] - d[1][(k + 2) % 3] * d[2][(k + 1) % 3]);
      least = (std::min)(least, determinant);
    }
  return least;
}

double number(const std::string& json, const std::string& key)
{
  std::smatch match;
  REQUIRE(std::regex_search(json, match, std::regex("\"" + key + "\": ([-+.eE0-9]+)")));
  return std::stod(match[1]);
}

std::vector<std::string> keys(const std::string& json)
{
  const std::regex key("\"([a-z_]+)\": ");
  std::vector<std::string> result;
  for(std::sregex_iterator it(json.begin(), json.end(), key), end; it != end; ++it)
    result.push_back((*it)[1]);
  return result;
}

const std::vector<std::string> report_keys = {
  "status", "status_code", "has_valid_map", "version",
  "options", "source", "target", "to", "polycube_axes", "improve", "cell_size", "tetrahedra", "features", "regions", "landmarks",
  "tolerance", "merge_points", "separate", "displacements", "staircases", "others", "inside", "conditions", "initial", "boundary",
  "refine", "slide", "energy",
  "volume_weights", "energy_tolerance", "reference_scale", "max_angle_distortion", "minimize_max_angle_distortion",
  "solver", "threads", "max_iterations", "time_limit",
  "vertices", "cells", "boundary_vertices", "added_vertices", "added_boundary_vertices", "sliding_vertices",
  "inverted_cells", "boundary_residual",
  "iterations", "untangling_iterations", "linear_solver_iterations", "untangling_method",
  "seconds_total", "seconds_to_flip_free", "seconds_numbering", "seconds_start", "seconds_untangling",
  "seconds_minimization", "seconds_check", "energy_value", "reference_scale",
  "distortion", "angle_mean", "angle_max", "volume_mean", "volume_max",
  "distortion_at_source_volume", "angle_mean", "angle_max", "volume_mean", "volume_max", "boundary_distortion",
  "unavoidable_angle_distortion", "missed_angle_distortion",
  "coinciding_points", "merged_points", "turned_cells", "tangled_cells", "separated_vertices", "targets_inside", "missed_targets",
  "free_targets", "conditions", "boundary_crosses_itself",
  "seconds_reading", "seconds_boundary", "seconds_hexahedra",
  "steps", "energy", "inverted_cells", "seconds", "peak_memory_bytes"};

const std::vector<std::string> hexahedra_keys = {
  "hexahedra", "status", "status_code", "vertices", "boundary_vertices", "cells", "inverted_corners", "inverted_hexahedra",
  "padding", "minimum_scaled_jacobian", "mean_scaled_jacobian", "boundary_distance", "subdomains", "volumes_of_tetrahedra",
  "volumes_of_hexahedra", "interface_distance", "patches", "references", "quadrangles", "areas", "centers", "normals",
  "features", "corners", "corners_kept", "corners_given_up", "curves", "curves_kept", "curves_given_up", "patches", "patches_kept",
  "patches_given_up"};

// Returns the keys of a report with other ones, which come before the steps.
std::vector<std::string> report_keys_with(const std::vector<std::string>& others)
{
  std::vector<std::string> result = report_keys;
  result.insert(std::find(result.begin(), result.end(), "steps"), others.begin(), others.end());
  return result;
}

std::string hexahedra_of(const std::string& report) { return report.substr(report.find("\"hexahedra\": {")); }

} // namespace

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

TEST_CASE("At the time limit, or interrupted, the valid map reached so far is written")
{
  const Folder folder;
  const Soup source = cube(20);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 20, [](const Point& p)
  {
    const double c = std::cos(p[2] / 20), s = std::sin(p[2] / 20);
    return Point{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  }));
  const std::string command = "source.mesh target.txt --output map.mesh --report report.json";
  const auto check_files = [&](const std::string& reason)
  {
    CHECK(folder.names() == Names{"source.mesh", "target.txt", "map.mesh", "report.json"});
    const std::string report = folder.text("report.json");
    CHECK(report.find("\"status\": \"" + reason + " The map is valid") != std::string::npos);
    CHECK(report.find("\"status_code\": \"ERROR_INTERRUPTED\", \"has_valid_map\": true") != std::string::npos);
    CHECK(number(report, "inverted_cells") == 0);
    CHECK(folder.soup("map.mesh").cells == source.cells);
  };
  Terminal terminal(folder, command);
  CHECK(terminal.waits_for("reading source.mesh"));
  CHECK(terminal.waits_for("minimizing (minimization), step 1"));
  terminal.interrupt();
  CHECK(terminal.exit_code() == 0);
  check_files("Interrupted.");

  // There is no map before a time, and a complete one after another; between these, which depend on the machine, the limit
  // is to be found at which the map is valid only.
  double without_map = -1, complete = std::numeric_limits<double>::infinity();
  bool has_interrupted_map = false;
  for(double limit = 0; !has_interrupted_map;
      limit = std::isinf(complete) ? 2 * limit + 0.1 : (without_map + complete) / 2)
  {
    if(complete - without_map < 1e-3) // other programs took a part of the time: once more
    {
      without_map = 0;
      complete = std::numeric_limits<double>::infinity();
    }
    CAPTURE(limit);
    fs::remove(folder.path("map.mesh"));
    const int code = folder.run(command + " --time-limit " + std::to_string(limit));
    if(code == 3)
    {
      without_map = limit;
      CHECK(folder.text("stderr").find("The time limit was reached. There is no map ") == 0);
      CHECK(folder.names() == Names{"source.mesh", "target.txt", "report.json"});
      continue;
    }
    REQUIRE(code == 0);
    if(folder.text("stderr") == "")
    {
      complete = limit;
      continue;
    }
    has_interrupted_map = true;
    check_files("The time limit was reached.");
  }
  CHECK(without_map >= 0);
  CHECK(has_interrupted_map);
}

// Returns the seconds that processors have spent on processes that have ended. Other programs on the machine leave them alone.
double seconds_of_processes()
{
  rusage usage;
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec)
    + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

TEST_CASE("An interruption, or the time limit, ends each part of the program")
{
  const Folder folder;
  const Soup source = cube(16);
  Soup bent = fan_in_prism(400), target = bent; // no map, and a search that goes on
  for(Point& p : target.points)
  {
    const double angle = 3.14159265358979 * p[2] / 400;
    p = {(100 + p[0]) * std::cos(angle), p[1], (100 + p[0]) * std::sin(angle)};
  }
  folder.write("source.mesh", source);
  folder.write("bent.mesh", bent);
  folder.write("target.mesh", target);
  struct Part
  {
    std::string arguments, text;
    std::set<int> exit_codes;
  };
  const auto check_files = [&](const int code)
  {
    CAPTURE(code, folder.text("report.json").substr(0, 300));
    CHECK(fs::exists(folder.path("map.mesh")) == (code < 2 || folder.text("report.json").find("The map is") != std::string::npos));
    CHECK(!fs::exists(folder.path("hexahedra.mesh")));
    CHECK((code == 0 || folder.text("report.json").find("\"ERROR_INTERRUPTED\"") != std::string::npos));
    fs::remove(folder.path("map.mesh"));
  };
  for(const Part& part : {
        Part{"source.mesh --to polycube", "mapping the boundary to polycube", {3}},
        Part{"source.mesh source.mesh", "numbering cells and vertices", {0, 1, 3}},
        Part{"bent.mesh target.mesh", "untangling", {1, 3}},
        Part{"bent.mesh target.mesh --refine", "untangling", {0, 1, 3}},
        Part{"source.mesh --to ball --refine", "minimizing", {0}},
        Part{"source.mesh source.mesh --hexahedra 0.25 hexahedra.mesh", "making hexahedra", {3}}})
  {
    CAPTURE(part.arguments, part.text);
    const std::string arguments = part.arguments + " -o map.mesh --report report.json";
    Terminal terminal(folder, arguments);
    REQUIRE(terminal.waits_for(part.text));
    terminal.interrupt();
    const int code = terminal.exit_code();
    CHECK(part.exit_codes.count(code) == 1);
    check_files(code);

    const double begin = seconds_of_processes();
    const int code_at_limit = folder.run(arguments + " --time-limit 0.5");
    CHECK(seconds_of_processes() - begin < 3); // two threads, and the end
    CHECK((code_at_limit == 0 || code_at_limit == 1 || code_at_limit == 3));
    if(code_at_limit != 0) // a fast machine may be ready
      check_files(code_at_limit);
    fs::remove(folder.path("map.mesh"));
    fs::remove(folder.path("hexahedra.mesh"));
  }
}

TEST_CASE("The line on a terminal moves with the boundary and with hexahedra")
{
  const Folder folder;
  folder.write("source.mesh", cube(4));
  Terminal terminal(folder, "source.mesh --to polycube --refine=none --hexahedra 1 hexahedra.mesh --report report.json");
  CHECK(terminal.waits_for("mapping the boundary ("));
  CHECK(terminal.waits_for("), round 2"));
  CHECK(terminal.waits_for("making hexahedra (corners), round 1"));
  CHECK(terminal.exit_code() == 0);
  const std::string report = folder.text("report.json"); // whose steps are those of the map
  const std::size_t begin = report.find("\"steps\": {\"energy\": [");
  const std::string energies = report.substr(begin, report.find(']', begin) - begin);
  CHECK(1 + std::count(energies.begin(), energies.end(), ',') == number(report, "iterations"));
}

TEST_CASE("An interruption ends the program while it reads, too")
{
  const Folder folder;
  REQUIRE(mkfifo(folder.path("source.mesh").c_str(), 0600) == 0); // nobody writes
  Terminal terminal(folder, "source.mesh --to ball -o map.vtu --report report.json");
  CHECK(terminal.waits_for("reading source.mesh"));
  usleep(100000);
  terminal.interrupt();
  CHECK(terminal.waits_for("Interrupted. There is no map yet."));
  CHECK(terminal.exit_code() == 3);
  CHECK(folder.names() == Names{"source.mesh", "report.json"});
}

TEST_CASE("The second interruption leaves no unfinished file")
{
  const Folder folder;
  folder.write("source.mesh", cube(20));
  Terminal terminal(folder, "source.mesh source.mesh -o map.mesh");
  CHECK(terminal.waits_for("writing"));
  while(folder.names().size() == 1)
    usleep(100);
  terminal.interrupt_and_terminate();
  terminal.exit_code();
  for(const std::string& name : folder.names())
    CHECK(fs::path(name).extension() == ".mesh");
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("There are no more threads than processors, which is told")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  const std::string processors = std::to_string(std::thread::hardware_concurrency());
  REQUIRE(folder.run("source.mesh --to polycube --refine=none --threads 2147483647 --report report.json") == 0);
  CHECK(folder.text("stderr").find("note: " + processors + " threads run instead of 2147483647, ") == 0);
  CHECK(folder.text("report.json").find("\"threads\": " + processors + ",") != std::string::npos);
}
#endif

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
  Soup roof = cube(4); // whose top falls by 15 degrees on both sides of y = 1, where no plane of the grid is
  std::string ridge = "4\n";
  for(double x = 0; x < 4; ++x)
  {
    const auto vertex = [&](const Point& p) { return std::find(roof.points.begin(), roof.points.end(), p) - roof.points.begin(); };
    ridge += std::to_string(vertex({x, 1, 4})) + " " + std::to_string(vertex({x + 1, 1, 4})) + "\n";
  }
  for(Point& p : roof.points)
    p[2] *= 1 - 0.268 * std::abs(p[1] - 1) / 4;
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

TEST_CASE("Vertices without a cell keep their place in the output")
{
  const Folder folder;
  Soup source = cube(2);
  source.points.insert(source.points.end(), {{7, 8, 9}, {4, 5, 6}});
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(cube(2), 2, affine) + "28 0.1 0.2 0.3\n");
  CHECK(folder.run("source.mesh target.txt --output map.mesh") == 0);
  const Soup map = folder.soup("map.mesh");
  REQUIRE(map.points.size() == 29);
  CHECK(map.points[27] == Point{7, 8, 9});
  CHECK(map.points[28] == Point{0.1, 0.2, 0.3});
}

TEST_CASE("Bad input: exit code 2, a sentence and no output")
{
  const Folder folder;
  const Soup source = cube(2);
  const std::string target = boundary_lines(source, 2, affine);
  const std::string second_line = target.substr(target.find('\n') + 1);
  folder.write("source.mesh", source);
  folder.write("target.txt", target);
  const std::string mesh = folder.text("source.mesh");

  const auto sentence = [&folder](const std::string& files)
  {
    CHECK(folder.run(files + " --quiet --boundary fixed --output map.mesh --report report.json") == 2);
    CHECK(!fs::exists(folder.path("map.mesh")));
    CHECK(folder.text("stdout") == "");
    const std::string report = folder.text("report.json");
    const auto end_of_options = std::find(report_keys.begin(), report_keys.end(), "vertices");
    CHECK(keys(report) == std::vector<std::string>(report_keys.begin(), end_of_options));
    const std::string message = folder.text("stderr");
    CHECK(std::count(message.begin(), message.end(), '\n') == 1);
    const std::string sentence_in_report = "{\"status\": \"" + message.substr(0, message.size() - 1) + "\"";
    CHECK(report.find(sentence_in_report + ", \"status_code\": \"ERROR_") == 0);
    CHECK(report.find("\"has_valid_map\": false") != std::string::npos);
    return message;
  };

  CHECK(sentence("none.mesh target.txt") == "none.mesh: the file cannot be opened\n");
  CHECK(sentence("source.mesh none.txt") == "none.txt: the file cannot be opened\n");
  CHECK(sentence("target.txt target.txt").find("target.txt: line 1: this is not an ASCII MEDIT file") == 0);
  folder.write("mesh.xyz", "v 0 0 0\n");
  CHECK(sentence("mesh.xyz --to ball").find(
    "neither this program (see --help) nor meshio reads files with the extension '.xyz'") != std::string::npos);
  folder.write("mesh.pvtu", "<VTKFile type=\"PUnstructuredGrid\"><Piece Source='a.vtu'/><Piece Source='b.vtu'/></VTKFile>\n");
  CHECK(sentence("mesh.pvtu --to ball").find("UnstructuredGrid; this file is a list of pieces") != std::string::npos);
  folder.write("mesh.med", "HDF");
  CHECK(sentence("mesh.med --to ball").find("; other formats can be converted: meshio convert mesh.med mesh.vtu\n")
        != std::string::npos);
  folder.write("mesh.off", "OFF\n");
  folder.write("mesh.STEP", "ISO-10303-21;\n");
  if(fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
  {
    CHECK(sentence("mesh.off --to ball") == "mesh.off: the surface cannot be read\n");
    CHECK(sentence("mesh.STEP --to ball").find("mesh.STEP: Gmsh says: Could not read file 'mesh.STEP'; save the solids ") == 0);
  }
  else
  {
    CHECK(sentence("mesh.off --to ball").find("; this is a surface; a volume mesher fills it: tetgen -pqg mesh.off writes "
                                              "mesh.1.mesh\n") != std::string::npos);
    CHECK(sentence("mesh.STEP --to ball").find(": gmsh -3 mesh.STEP -o mesh.mesh fills it.") != std::string::npos);
  }
  CHECK(folder.run("source.mesh --to ball --cells 1") == 2);
  CHECK(folder.text("stderr").find("--cells and --tetrahedra need a source that is filled") == 0);
  CHECK(folder.run("none.step --to ball --cells=-1") == 2);
  CHECK(folder.text("stderr").find("the size of cells (--cells) must be a finite number") == 0);
  folder.write("mesh.vtu", "<?xml version=\"1.0\"?>\n");
  CHECK(sentence("mesh.vtu --to ball") == "mesh.vtu: this is not a VTK XML file of the type UnstructuredGrid\n");

  folder.write("bad.mesh", mesh.substr(0, mesh.find("Tetrahedra\n48\n") + 20));
  CHECK(sentence("bad.mesh target.txt").find("bad.mesh: line 34: the file ends where") == 0);

  Soup bad = source;
  bad.points[13] = {1, 1, 2.5}; // through the boundary
  folder.write("bad.mesh", bad);
  CHECK(sentence("bad.mesh target.txt").find("(counted from 0) has the negative volume") != std::string::npos);
  bad = source;
  bad.cells.push_back({0, 9, 12, 14}); // a part of two others
  bad.cell_references.push_back(bad.cell_references[4]);
  folder.write("bad.mesh", bad);
  for(const std::string target : { "target.txt", "--to ball" })
    CHECK(sentence("bad.mesh " + target).find(" overlap, they lie on the same side of their common facet") != std::string::npos);

  folder.write("bad.txt", second_line);
  CHECK(sentence("source.mesh bad.txt")
        == "bad.txt: vertex 0 (counted from 0) is on the boundary of the source, but has no target. --others stay keeps the "
          "positions of such vertices; --others slide lets them slide in planes of the boundary\n");
  folder.write("bad.txt", "0 0 0 nan\n" + second_line);
  CHECK(sentence("source.mesh bad.txt") == "bad.txt: line 1: 'nan' is not a finite coordinate\n");
  folder.write("bad.txt", boundary_lines(source, 2, [](const Point& p) { return Point{p[0], p[1], -p[2]}; }));
  CHECK(sentence("source.mesh bad.txt") != "");
  // a corner with a cell whose vertices are all on the boundary
  folder.write("bad.txt", boundary_lines(source, 2, [](const Point& p)
  {
    return p == Point{2, 0, 0} ? Point{1.2, 0.8, 0} : p;
  }));
  CHECK(sentence("source.mesh bad.txt") != "");
}

TEST_CASE("The content of files of other programs tells what helps, whatever their names are")
{
  const Folder folder;
  const auto sentence = [&](const std::string& name, const std::string& content)
  {
    folder.write(name, content);
    CHECK(folder.run("'" + name + "' --to ball") == 2);
    return folder.text("stderr");
  };
  const std::string nodes = "*NODE, NSET=Nall\n1,0,0,0\n", no_route = "Neither this program nor meshio reads it";
  CHECK(sentence("a b.msh", "** of cgx\n\n" + nodes)
        == "a b.msh: this is a file of Abaqus; it can be converted: meshio convert --input-format abaqus 'a b.msh' 'a b.vtu'\n");
  CHECK(sentence("mesh.inp", nodes).find("can be converted: meshio convert mesh.inp mesh.vtu\n") != std::string::npos);
  CHECK(sentence("mesh.inp", "# of AVS\n4 1 0 0 0\n1 0 0 0\n").find(
    "mesh.inp: this is a file of AVS; it can be converted: meshio convert --input-format avsucd mesh.inp mesh.vtu\n") == 0);
  CHECK(sentence("mesh.msh", "(0 \"Fluent\")\n(2 3)\n").find("mesh.msh: this is a mesh of Fluent. ParaView reads it under") == 0);
  CHECK(sentence("mesh.e", "CDF\x02").find("this is a file of Exodus; it can be converted: python3 -c ")
        != std::string::npos);
  folder.write("mesh.1.ele", "1 10 0\n0 0 1 2 3 4 5 6 7 8 9\n");
  for(const char* name : { "mesh.1.ele", "mesh.1.node" })
    CHECK(sentence(name, name == std::string("mesh.1.ele") ? folder.text(name) : "10 3 0 0\n").find(
      "of second order; it can be converted: tetgen -rg mesh.1 writes mesh.2.mesh\n") != std::string::npos);
  CHECK(sentence("mesh.ele", "1 4 0\n0 0 1 2 3\n").find("meshio convert mesh.ele mesh.vtu\n") != std::string::npos);
  for(const auto& [program, name, content] : { std::array<std::string, 3>{ "LS-DYNA", "mesh.k", "$ text\n*KEYWORD\n*NODE\n" },
                                               { "Ansys", "mesh.cdb", "/COM,ANSYS\n/PREP7\nNBLOCK,6\n" },
                                               { "FEBio", "mesh.feb", "<?xml version=\"1.0\"?>\n<febio_spec version=\"4.0\">\n" },
                                               { "OpenFOAM", "points", "/* */\nFoamFile\n{\n}\n" } })
    CHECK(sentence(name, content).find(name + ": this is a file of " + program + ". " + no_route) == 0);
  fs::create_directory(folder.path("polyMesh"));
  folder.write("polyMesh/faces", "FoamFile");
  folder.write("polyMesh/owner", "FoamFile");
  CHECK(folder.run("polyMesh --to ball") == 2);
  CHECK(folder.text("stderr").find("polyMesh: this is a mesh of OpenFOAM. " + no_route) == 0);
}

// A script of Gmsh for a beam of two solids that share a face, with the size 1 x 1 x 2.
const std::string beam_script = "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\nBox(2) = {0, 0, 1, 1, 1, 1};\n"
  "BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n";

TEST_CASE("Gmsh fills the body of a script or of a closed surface with tetrahedra")
{
  if(!fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
    return;
  const Folder folder;
  folder.write("beam.geo", beam_script);
  CHECK(folder.run("beam.geo --cells 0.5 --to polycube --hexahedra 0.5 beam.inp --tetrahedra beam.mesh") == 0);
  const Soup beam = folder.soup("beam.mesh");
  CHECK(std::set<int>(beam.cell_references.begin(), beam.cell_references.end()) == std::set<int>{ 1, 2 });
  const std::set<int> faces(beam.facet_references.begin(), beam.facet_references.end());
  CHECK(faces.size() == 11); // one of them between the solids
  for(const auto& [u, v] : beam.edges) // of curves, on which two coordinates are integers
    CHECK(std::count_if(beam.points[u].begin(), beam.points[u].end(), [](const double x)
                        { return std::abs(x - std::round(x)) < 1e-9; }) >= 2);
  CHECK(beam.edges.size() >= 20);
  CHECK(folder.text("beam.inp").find("*SURFACE, TYPE=ELEMENT, NAME=INTERFACE_1_2\n") != std::string::npos);
  CHECK(folder.run("beam.geo --cells 0.15 --to box=1,1,2 --tetrahedra finer.mesh") == 0);
  CHECK(folder.soup("finer.mesh").cells.size() > 2 * beam.cells.size());

  // a cube with a cavity, and what is wrong with other surfaces
  const auto write_cubes = [&](const std::string& name, const std::vector<std::array<double, 2> >& cubes,
                               const std::size_t left_out = 0)
  {
    std::ostringstream points, triangles;
    std::size_t first = 0, number = 0;
    for(const auto& [origin, size] : cubes)
    {
      for(int i = 0; i < 8; ++i)
        points << origin + size * (i & 1) << " " << origin + size * (i >> 1 & 1) << " " << origin + size * (i >> 2) << "\n";
      for(const std::array<int, 4>& q : { std::array{ 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
                                          { 1, 3, 7, 5 } })
        if(number++ >= left_out)
          triangles << "4 " << first + q[0] << " " << first + q[1] << " " << first + q[2] << " " << first + q[3] << "\n";
      first += 8;
    }
    folder.write(name, "OFF\n" + std::to_string(first) + " " + std::to_string(number - left_out) + " 0\n" + points.str()
                         + triangles.str());
  };
  const auto sentence = [&](const std::vector<std::array<double, 2> >& cubes, const std::size_t left_out = 0)
  {
    write_cubes("cubes.off", cubes, left_out);
    CHECK(folder.run("cubes.off --cells 1 --to ball") == 2);
    return folder.text("stderr");
  };
  write_cubes("cavity.off", { { 0, 3 }, { 1, 1 } });
  folder.run("cavity.off --cells 1 --to ball --tetrahedra cavity.mesh"); // which is no ball
  const Soup cavity = folder.soup("cavity.mesh");
  CHECK(cavity.edges.empty());
  CHECK(cavity.facets.empty());
  const auto volume = [](const Soup& soup)
  {
    double sum = 0;
    for(const std::array<std::size_t, 4>& cell : soup.cells)
    {
      const auto vector = [&](const std::size_t i)
      {
        const Point &p = soup.points[cell[i]], &q = soup.points[cell[0]];
        return Point{ p[0] - q[0], p[1] - q[1], p[2] - q[2] };
      };
      const Point a = vector(1), b = vector(2), c = vector(3);
      sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    }
    return sum;
  };
  CHECK(volume(cavity) == Approx(26));
  CHECK(sentence({ { 0, 1 } }, 1).find("cubes.off: the surface is not closed, because the edge between the points (") == 0);
  CHECK(sentence({ { 0, 2 }, { 1, 2 } }).find("; the surface must enclose bodies") != std::string::npos);
  // two bodies, one of them in a cavity of another one
  CHECK(sentence({ { 0, 9 }, { 3, 3 }, { 4, 1 }, { 10, 2 } }).find("note: cubes.off: the surface encloses 3 bodies") == 0);
  CHECK(folder.run("cubes.off --cells 1 --to polycube --refine=none --tetrahedra cubes.mesh") == 0);
  CHECK(volume(folder.soup("cubes.mesh")) == Approx(729 - 27 + 1 + 8));
  // points with the same place, and of a surface to which a body is fitted
  const std::string doubled = "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 0 0 0\nv 1 0 0\nv 1 0 1\n"
                              "v 0 0 1\nv 1 0 0\nv 1 1 0\nv 1 1 1\nv 1 0 1\nv 1 1 0\nv 0 1 0\nv 0 1 1\nv 1 1 1\nv 0 1 0\nv 0 0 0\n"
                              "v 0 0 1\nv 0 1 1\nf 1 2 3 4\nf 5 6 7 8\nf 9 10 11 12\nf 13 14 15 16\nf 17 18 19 20\n"
                              "f 21 22 23 24\n";
  folder.write("doubled.obj", doubled);
  CHECK(folder.run("doubled.obj --cells 0.5 --to doubled.obj") == 0);
  CHECK(folder.text("stderr").find("note: doubled.obj: 16 points are joined to others with the same coordinates\n") == 0);
  folder.write("open.obj", doubled.substr(0, doubled.rfind("f 21")));
  CHECK(folder.run("doubled.obj --cells 0.5 --to open.obj") == 2);
  CHECK(folder.text("stderr").find("open.obj: the surface is not closed, because the edge between the points (0, ")
        != std::string::npos);

  // names of faces in a file of STEP, which Gmsh does not give
  folder.write("box.geo", "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\nSave \"box.step\";\n");
  REQUIRE(folder.run("box.geo --cells 0.5 --to ball") == 0);
  CHECK(folder.run("box.step --cells 0.5 --to ball --merge-points=0.1") == 2);
  CHECK(folder.text("stderr").find("--merge-points=DISTANCE needs a mesh or a surface") == 0);
  CHECK(folder.run("box.step --cells 0.5 --to ball") == 0);
  CHECK(folder.text("stderr").find("name of faces") == std::string::npos);
  std::string named = folder.text("box.step");
  const std::string face = "ADVANCED_FACE('";
  REQUIRE(named.find(face) != std::string::npos);
  folder.write("named.step", named.insert(named.find(face) + face.size(), "support"));
  CHECK(folder.run("named.step --cells 0.5 --to ball") == 0);
  CHECK(folder.text("stderr").find("note: named.step: 1 name of faces is left out, because Gmsh does not give them") == 0);

  // a bore and a void that are smaller than cells, and a sheet beside a solid
  const std::string head = "SetFactory(\"OpenCASCADE\");\n";
  folder.write("bore.geo", head + "Box(1) = {0, 0, 0, 2, 2, 2};\nCylinder(2) = {-1, 1, 1, 4, 0, 0, 0.1};\n"
                           "Cylinder(3) = {1, -1, 1, 0, 4, 0, 0.1};\nSphere(4) = {0.4, 0.4, 0.4, 0.08};\n"
                           "BooleanDifference(5) = { Volume{1}; Delete; }{ Volume{2, 3, 4}; Delete; };\n"
                           "Rectangle(50) = {3, 0, 0, 1, 1};\n");
  CHECK(folder.run("bore.geo --cells 0.5 --to polycube -o bore.mesh") == 0);
  CHECK(folder.text("stderr").find("note: bore.geo: 1 face bounds no solid and is left out.") != std::string::npos);
  CHECK(folder.text("stderr").find("cylinders and spheres have a smaller diameter than the cells.") != std::string::npos);
  CHECK(folder.run("bore.geo --cells 0.5 --to ball") == 2);
  CHECK(folder.text("stderr").find("The smallest one is around (0.40") != std::string::npos);
  CHECK(folder.run("none.step --to ball") == 2);
  CHECK(folder.text("stderr") == "none.step: the file cannot be opened\n");
  folder.write("flat.geo", "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\n");
  CHECK(folder.run("flat.geo --to ball") == 2);
  CHECK(folder.text("stderr").find("flat.geo: the file contains no solid") == 0);
  folder.write("endless.geo", "For i In {0 : 1e9}\nEndFor\n");
  CHECK(folder.run("endless.geo --to ball --time-limit 0.5") == 3);
}

TEST_CASE("Marks of corners that contradict the shape everywhere are noted, and do not count")
{
  const Folder folder;
  Soup source = cube(4);
  const std::vector<std::size_t> boundary = VMP::boundary_vertices(source.points, source.cells);
  source.corners = boundary;
  folder.write("source.mesh", source);
  CHECK(folder.run("source.mesh --to polycube --hexahedra 2 hexahedra.mesh") == 0);
  CHECK(folder.text("stderr").find("note: source.mesh: 90 vertices are marked as corners at places where the boundary has no "
                                   "corner. The marks of corners are left out; TetGen makes such marks\n") != std::string::npos);
  source.corners = { boundary[0], boundary[1] }; // of which one is at an edge of the cube
  folder.write("source.mesh", source);
  CHECK(folder.run("source.mesh --to polycube --hexahedra 2 hexahedra.mesh") == 0);
  CHECK(folder.text("stderr").find("marked as corners at places") == std::string::npos);
}

TEST_CASE("Names that Abaqus cannot hold are noted, old and new")
{
  const Folder folder;
  Soup source = cube(2);
  source.facets = { { 0, 1, 4 } };
  for(const std::array<std::size_t, 4>& cell : source.cells)
    for(const std::array<std::size_t, 3>& f : { std::array{ cell[1], cell[2], cell[3] }, { cell[0], cell[2], cell[3] },
                                                { cell[0], cell[1], cell[3] }, { cell[0], cell[1], cell[2] } })
      if(std::all_of(f.begin(), f.end(), [&](const std::size_t v) { return source.points[v][0] == 0; }))
        source.facets.push_back(f);
  source.facets.erase(source.facets.begin());
  source.facet_references.assign(source.facets.size(), 7);
  source.group_names = { { { 2, 7 }, "top wall" }, { { 3, source.cell_references[0] }, "steel" } };
  std::ofstream os(folder.path("source.vtu"), std::ios::binary);
  VMP::IO::write_VTU(os, source, source.points);
  os.close();
  CHECK(folder.run("source.vtu --to polycube --hexahedra 1 hexahedra.inp") == 0);
  CHECK(folder.text("stderr").find("note: hexahedra.inp: the group 'top wall' has the name top_wall\n") != std::string::npos);
  CHECK(folder.text("stderr").find("steel") == std::string::npos);
  CHECK(folder.text("hexahedra.inp").find("NAME=top_wall\n") != std::string::npos);
  CHECK(folder.run("source.vtu --to polycube --hexahedra 1 hexahedra.vtu") == 0);
  CHECK(folder.text("stderr").find("top wall") == std::string::npos);
  CHECK(folder.text("hexahedra.vtu").find("Name=\"top wall\"") != std::string::npos);
}

// One tetrahedron in formats that Gmsh and VTK read, in which a test replaces numbers.
const std::string msh_file = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n"
  "0 1 0\n0 0 1\n$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";
const std::string unv_file = "    -1\n  2411\n         1         1         1        11\n  0 0 0\n"
  "         2         1         1        11\n  1 0 0\n         3         1         1        11\n  0 1 0\n"
  "         4         1         1        11\n  0 0 1\n    -1\n    -1\n  2412\n"
  "         1       111         1         1         7         4\n         1         2         3         4\n    -1\n";
const std::string vtk_file = "# vtk DataFile Version 5.1\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
  "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\nCELL_TYPES 1\n10\n";

TEST_CASE("A damaged file on which a library crashes, or takes all memory, is refused by a sentence with its name")
{
  const Folder folder;
  const auto status = [&](const std::string& name, const std::string& text)
  {
    folder.write(name, text);
    return folder.run(name + " --improve --quiet");
  };
  const auto is_refused = [&](const std::string& name, const std::string& text, const std::string& part, const std::string& other,
                              const std::string& sentence)
  {
    REQUIRE(status(name, text) == 0);
    CHECK(status(name, text.substr(0, text.rfind(part)) + other + text.substr(text.rfind(part) + part.size())) == 2);
    CHECK(folder.text("stderr").find(name + ": " + sentence) == 0);
  };
  if(fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
  {
    is_refused("cell.msh", msh_file, "3 4", "3 -1", "Gmsh crashed (Segmentation fault)");
    is_refused("cell.msh", msh_file, "0 4\n", "0 100000000000\n",
               "Gmsh ran out of memory on a file of " + std::to_string(msh_file.size() + 11) + " bytes; the file contains the "
               "number 100000000000\n");
    is_refused("cell.unv", unv_file, " 4", "-1", "Gmsh crashed (Segmentation fault)");
  }
  if(status("cell.vtk", vtk_file) == 0)
  {
    is_refused("cell.vtk", vtk_file, "POINTS 4", "POINTS 100000000000",
               "VTK cannot read the file. Unable to allocate 300000000003 elements");
    is_refused("cell.vtk", vtk_file, "0 4\nC", "0 400000000\nC", "the offset 400000000 of cell 0 (counted from 0) is wrong");
    is_refused("cell.vtk", vtk_file, "0 1 0 0", "0 x 0 0", "VTK cannot read the file. Error reading ascii data");
    REQUIRE(mkfifo(folder.path("pipe.vtk").c_str(), 0600) == 0); // nobody writes, and VTK waits
    CHECK(folder.run("pipe.vtk --improve --time-limit 0.2") == 3);
    CHECK(folder.text("stderr") == "The time limit was reached. There is no map yet.\n");
  }
}

TEST_CASE("A mesh that another process reads keeps all that it has")
{
  Soup soup = cube(1);
  soup.facets = { { 0, 1, 2 } };
  soup.facet_references = { -3 };
  soup.edges = { { 0, 1 }, { 1, 2 } };
  soup.edge_references = { 4, 5 };
  soup.corners = { 7 };
  soup.group_names = { { { 3, 1 }, "bone" }, { { 2, -3 }, "" } };
  soup.point_data = { { "T", 1, true, { 1, 2, 3, 4, 5, 6, 7, 8 } } };
  soup.cell_data = { { "v", 3, false, std::vector<double>(18, 0.1) } };
  soup.facet_data = { { "f", 1, false, { 0.5 } } };
  soup.edge_data = { { "e", 1, false, { 2, 3 } } };
  soup.notes = { "a note", "another" };
  const std::string bytes = Soup_bytes(soup).bytes();
  Soup other = Soup_bytes(bytes).restored();
  CHECK(other.points == soup.points);
  CHECK(other.cells == soup.cells);
  CHECK(other.cell_references == soup.cell_references);
  CHECK(other.facets == soup.facets);
  CHECK(other.facet_references == soup.facet_references);
  CHECK(other.edges == soup.edges);
  CHECK(other.edge_references == soup.edge_references);
  CHECK(other.corners == soup.corners);
  CHECK(other.group_names == soup.group_names);
  CHECK(other.notes == soup.notes);
  CHECK(other.point_data.at(0).has_integers);
  CHECK(other.cell_data.at(0).number_of_components == 3);
  CHECK(other.cell_data.at(0).values == soup.cell_data[0].values);
  CHECK(other.facet_data.at(0).name == "f");
  CHECK(other.edge_data.at(0).values == soup.edge_data[0].values);
  CHECK(Soup_bytes(other).bytes() == bytes);
  for(const std::size_t size : { std::size_t(0), bytes.size() / 2, bytes.size() - 1 })
    CHECK_THROWS_AS(Soup_bytes(bytes.substr(0, size)).restored(), VMP::Input_error);
}

TEST_CASE("Points of Nastran in a coordinate system of their own are refused")
{
  const Folder folder;
  const auto status = [&](const std::string& first_point)
  {
    folder.write("cell.bdf", "BEGIN BULK\n" + first_point
                 + "GRID    2               1.      0.      0.\nGRID    3       0       0.      1.      0.\n"
                   "GRID    4               0.      0.      1.\nCTETRA  1       1       1       2       3       4\nENDDATA\n");
    return folder.run("cell.bdf --improve");
  };
  const std::string free = "GRID    1               0.      0.      0.\n";
  if(fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
    CHECK(status(free) == 0);
  for(const std::string line : { "GRID    1       7       0.      0.      0.\n", "GRID,1,7,0.,0.,0.\n",
                                 "GRID*   1               7               0.              0.\n*       0.\n" })
  {
    CAPTURE(line);
    CHECK(status(line) == 2);
    CHECK(folder.text("stderr").find("cell.bdf: line 2: the coordinate system (CP) is '7'") == 0);
  }
  CHECK(status(free + "GRDSET          12\n") == 2);
  CHECK(folder.text("stderr").find("cell.bdf: line 3: the coordinate system (CP) is '12'") == 0);
}

TEST_CASE("A faulty command line: exit code 2 and nothing is touched")
{
  const Folder folder;
  const Soup source = cube(2);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 2, affine));
  const std::string mesh = folder.text("source.mesh");
  const std::string target = folder.text("target.txt");

  for(const std::string arguments : {
        "", "source.mesh", "source.mesh target.txt third", "source.mesh target.txt --unknown",
        "source.mesh target.txt --energy none", "source.mesh target.txt --solver none",
        "source.mesh target.txt --threads 0", "source.mesh target.txt --threads x",
        "source.mesh target.txt --max-iterations -1", "source.mesh target.txt --output map.obj",
        "source.mesh target.txt --max-angle-distortion 2", "source.mesh target.txt --energy-tolerance -1",
        "source.mesh target.txt --max-angle-distortion 3 --minimize-max-angle-distortion",
        "source.mesh target.txt --time-limit -1",
        "source.mesh target.txt --to ball", "source.mesh --to", "source.mesh --to none", "source.mesh --to box=1,2",
        "source.mesh --to box=1,2,0", "source.mesh --to box=1,2,3,4", "source.mesh --to box=1:2:3",
        "source.mesh target.txt --output map",
        "source.mesh target.txt --output no/folder/map.mesh", "source.mesh target.txt --report .",
        "- - < source.mesh", "source.mesh target.txt --output - --report -",
        "source.mesh target.txt --output ./source.mesh", "source.mesh target.txt --report target.txt",
        "source.mesh target.txt --output map.mesh --report ./map.mesh"})
  {
    CAPTURE(arguments);
    CHECK(folder.run(arguments) == 2);
    CHECK(folder.text("stderr") != "");
    CHECK(folder.names() == Names{"source.mesh", "target.txt"});
    CHECK(folder.text("source.mesh") == mesh);
    CHECK(folder.text("target.txt") == target);
  }
  const auto alternatives = [&folder](const std::string& arguments)
  {
    folder.run("source.mesh " + arguments);
    const std::string text = folder.text("stderr");
    const std::size_t colon = text.find("; choose among: ");
    return colon == std::string::npos ? text : text.substr(colon + 16);
  };
  CHECK(alternatives("target.txt --energy none") == "stretch, symmetric_dirichlet, mips, arap, dirichlet, lscm, lpm\n");
  CHECK(alternatives("target.txt --solver none").find("cg") == 0);
  CHECK(alternatives("target.txt --boundary none") == "auto, fixed, soft\n");
  CHECK(alternatives("--to polycube --polycube-axes none") == "found, given\n");
  CHECK(alternatives("--to none") == "ball, cube, box=X,Y,Z, polycube, a surface *.off, *.stl, *.obj, *.ply or *.vtp\n");
  // each of them can be chosen; domains are in a test of their own
  for(const std::string option : {"--energy", "--solver", "--boundary", "--refine", "--others"})
  {
    std::istringstream names(alternatives("target.txt " + option + "=NONE"));
    for(std::string name; names >> name;)
      CHECK(folder.run("source.mesh target.txt " + option + "=" + name.substr(0, name.find(','))) == 0);
  }
  CHECK(folder.run("source.mesh --to box=1,2") == 2);
  std::smatch example;
  const std::string advice = folder.text("stderr");
  REQUIRE(std::regex_search(advice, example, std::regex("such as (box=.*)")));
  CHECK(folder.run("source.mesh --refine --to " + example.str(1)) == 0);

  CHECK(folder.run("--version") == 0);
  CHECK(std::regex_match(folder.text("stdout"), std::regex("parameterize_mesh_file [0-9.]+ \\(CGAL .*\\)\n"
                                                         "meshes that it reads: .mesh .meshb .vtu.*\n"
                                                         "bodies that it fills: .*\nmeshes that it writes: .mesh.*\n")));
  CHECK((folder.text("stdout").find(".step") != std::string::npos) == fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"));
  CHECK(folder.run("--help") == 0);
  for(const std::string part : {"Usage:", "SOURCE.mesh", "TARGET", "--output ] FILE", "--to DOMAIN", "--max-iterations N",
                                "Exit status:"})
    CHECK(folder.text("stdout").find(part) != std::string::npos);
}

TEST_CASE("The examples of the help run as they are written")
{
  const Folder folder;
  const fs::path data = fs::path(PARAMETERIZE_MESH_FILE).parent_path() / "data";
  for(const char* name : {"cube.mesh", "cube_to_ball.txt"})
    fs::copy(data / name, folder.path(name));
  REQUIRE(folder.run("--help") == 0);
  std::istringstream help(folder.text("stdout"));
  CHECK(folder.text("stdout").find("Examples:\n") == 0);
  int number_of_examples = 0;
  const std::string part = "part.step";
  Names files = {"cube.mesh", "cube_to_ball.txt", "ball.vtu", "ball.mesh", "source.mesh"};
  const std::string program = "  parameterize_mesh_file ";
  for(std::string line; std::getline(help, line);)
    if(line.find(program) == 0)
    {
      CAPTURE(line);
      ++number_of_examples;
      if(const std::size_t begin = line.find(part); begin != std::string::npos)
      {
        if(!fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
          continue;
        folder.write("part.geo", "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 4, 4, 6};\n");
        line.replace(begin, part.size(), "part.geo"); // another format of a body, which takes a line
        files.insert({ "part.geo", "part.inp" });
      }
      CHECK(folder.run(line.substr(program.size())) == 0);
    }
  CHECK(number_of_examples == 3);
  CHECK(folder.names() == files);
  CHECK(folder.text("ball.vtu").find("Name=\"uvw\"") != std::string::npos);
  for(const char* name : {"angle_distortion", "volume_distortion"})
    CHECK(folder.text("ball.vtu").find(name) != std::string::npos);
  CHECK(folder.soup("ball.mesh").cells == folder.soup("source.mesh").cells);
}

TEST_CASE("Vertices that slide are advised by the name of their option, which helps")
{
  const Folder folder;
  const Soup source = cube(3);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 3, [](const Point& p)
  {
    return p == Point{1, 1, 0} ? Point{1.99, 1.997, 0} : p; // two facets are nearly flat
  }));
  CHECK(folder.run("source.mesh target.txt") == 0);
  CHECK(folder.text("stderr").find("or vertices that slide (--slide), would help") != std::string::npos);
  CHECK(folder.run("source.mesh target.txt --slide") == 0);
  CHECK(folder.text("stderr") == "");
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

TEST_CASE("Each file may be a pipe, and - is the standard input or output")
{
  const Folder folder;
  const Soup source = cube(2);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 2, affine));
  REQUIRE(folder.run("source.mesh target.txt -o map.mesh") == 0);
  const std::string map = folder.text("map.mesh"), summary = folder.text("stdout");

  for(const std::string input : { "-", "/dev/stdin", "/dev/fd/0" })
  {
    CHECK(folder.run(input + " target.txt -o copy.mesh < source.mesh") == 0);
    CHECK(folder.text("copy.mesh") == map);
    CHECK(folder.run("source.mesh " + input + " -o copy.mesh < target.txt") == 0);
    CHECK(folder.text("copy.mesh") == map);
  }
  for(const std::string output : { "-", "/dev/stdout" })
  {
    CHECK(folder.run("source.mesh target.txt -o " + output) == 0);
    CHECK(folder.text("stdout") == map);
    CHECK(folder.text("stderr").find("distortion of angles") != std::string::npos);
    CHECK(folder.run("source.mesh target.txt -o copy.mesh --report " + output) == 0);
    CHECK(keys(folder.text("stdout")) == report_keys);
  }
  CHECK(folder.run("source.mesh target.txt --report /dev/null") == 0);
  CHECK(folder.text("stdout").substr(0, 20) == summary.substr(0, 20));

  for(const std::string name : { "in", "out", "report" })
    REQUIRE(mkfifo(folder.path(name).c_str(), 0600) == 0);
  CHECK(folder.shell("cat source.mesh > in & cat out > copy.mesh & cat report > report.json & "
                     "\"$driver\" in target.txt --quiet -o out --report report && wait")
        == 0);
  CHECK(folder.text("copy.mesh") == map);
  CHECK(keys(folder.text("report.json")) == report_keys);
  CHECK(fs::is_fifo(folder.path("out")));

  // nothing is written of what fails
  CHECK(folder.run("source.mesh none.txt -o -") == 2);
  CHECK(folder.text("stdout") == "");
  CHECK(folder.run("source.mesh target.txt -o /dev/full") == 2);
  CHECK(folder.text("stderr").find("/dev/full: this cannot be written completely") != std::string::npos);
}

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

TEST_CASE("Names of groups and data of the source are in the output, also where it is refined")
{
  const Folder folder;
  Soup source = fan_in_prism(12);
  source.group_names = { { { 3, 1 }, "bone" } };
  source.edges = { { 1, 2 } };
  source.edge_references = { 8 };
  source.point_data = { { "T", 1, false, {} }, { "x", 3, false, {} } };
  for(const Point& p : source.points)
  {
    source.point_data[0].values.push_back(p[0] + 2 * p[1] - p[2] / 3);
    source.point_data[1].values.insert(source.point_data[1].values.end(), p.begin(), p.end());
  }
  source.cell_data = { { "number", 1, true, {} } };
  for(std::size_t c = 0; c < source.cells.size(); ++c)
    source.cell_data[0].values.push_back(static_cast<double>(c));
  std::ofstream vtu(folder.path("source.vtu"), std::ios::binary);
  VMP::IO::write_VTU(vtu, source, source.points);
  vtu.close();
  Soup target = source;
  for(Point& p : target.points)
    p = {(1 + p[0]) * std::cos(p[2] / 4), p[1], (1 + p[0]) * std::sin(p[2] / 4)};
  folder.write("target.mesh", target);
  REQUIRE(folder.run("source.vtu target.mesh --refine -o map.vtu --refined-source refined.mesh") == 0);
  Soup map;
  VMP::IO::read_tetrahedron_soup(folder.path("map.vtu"), map);
  REQUIRE(map.points.size() > source.points.size());
  CHECK(map.group_names == source.group_names);
  CHECK(map.edge_references == std::vector<int>{ 8 });
  CHECK(folder.soup("refined.mesh").edges == source.edges);
  const auto data = [](const std::vector<VMP::Data_array_3>& arrays, const std::string& name)
  {
    const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const auto& array) { return array.name == name; });
    REQUIRE(found != arrays.end());
    return found->values;
  };
  const std::vector<double> T = data(map.point_data, "T"), x = data(map.point_data, "x"), numbers = data(map.cell_data, "number");
  REQUIRE(T.size() == map.points.size());
  REQUIRE(x.size() == 3 * map.points.size());
  for(std::size_t v = 0; v < map.points.size(); ++v)
  {
    const Point& p = map.points[v];
    CHECK(T[v] == Approx(p[0] + 2 * p[1] - p[2] / 3).margin(1e-12));
    CHECK(x[3 * v + 2] == p[2]);
  }
  REQUIRE(numbers.size() == map.cells.size());
  CHECK(numbers.size() > source.cells.size());
  CHECK(std::set<double>(numbers.begin(), numbers.end()).size() == source.cells.size());
}

TEST_CASE("The source may be a file of VTK, and so may the target")
{
  const Folder folder;
  Soup source = cube(2);
  source.cell_references[5] = 3;
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 2, affine));
  REQUIRE(folder.run("source.mesh target.txt -o map.vtu") == 0);
  REQUIRE(folder.run("source.mesh target.txt -o map.mesh") == 0);
  REQUIRE(folder.run("map.vtu target.txt -o other.mesh") == 0); // the points of this file are those of the source
  CHECK(folder.text("other.mesh") == folder.text("map.mesh"));
  REQUIRE(folder.run("source.mesh map.vtu -o same.mesh") == 0);
  CHECK(folder.soup("same.mesh").cell_references == source.cell_references);
}

namespace {

// Writes a file of VTK whose references have another name.
void write_regions(const Folder& folder, const std::string& file, const Soup& soup, const std::string& name)
{
  std::ostringstream os;
  VMP::IO::write_VTU(os, soup, soup.points);
  const std::string text = os.str(), reference = "\"reference\"";
  const std::size_t begin = text.find(reference);
  REQUIRE(begin != std::string::npos);
  folder.write(file, text.substr(0, begin) + "\"" + name + "\"" + text.substr(begin + reference.size()));
}

} // namespace

TEST_CASE("Regions have the names of many programs, or that of --regions; a note lists others")
{
  const Folder folder;
  Soup source = cube(2);
  for(std::size_t c = 0; c < source.cells.size(); ++c)
    source.cell_references[c] = c < 24 ? 7 : 8;
  const auto references = [&](const std::string& arguments)
  {
    CAPTURE(arguments);
    REQUIRE(folder.shell("\"$driver\" source.vtu --improve -o map.mesh " + arguments) == 0);
    return folder.soup("map.mesh").cell_references;
  };
  for(const char* name : { "medit:ref", "gmsh:physical", "material", "attribute", "mat_id", "MaterialIDs", "Material", "su2:tag",
                           "su2_tag", "cell_tags", "ModelRegionID", "RegionId", "CellEntityIds", "elemTag", "labels", "elset" })
  {
    write_regions(folder, "source.vtu", source, name);
    CHECK(references("") == source.cell_references);
    CHECK(folder.text("stderr") == "");
  }
  for(const std::string name : { "zone", "my zone", "it's 1" })
  {
    write_regions(folder, "source.vtu", source, name);
    CHECK(references("") == std::vector<int>(source.cells.size(), 0));
    const std::string note = folder.text("stderr"), advice = "--regions ";
    CHECK(note.find("note: source.vtu: the cell data '" + name + "' are integers with 2 values and are not used") == 0);
    const std::size_t begin = note.find(advice);
    REQUIRE(begin != std::string::npos);
    CHECK(references(note.substr(begin, note.find(" uses them") - begin)) == source.cell_references);
    CHECK(folder.text("stderr") == "");
  }
  // numbers of cells, and a copy of the references, are no other regions
  source.cell_data = { { "number", 1, true, {} }, { "copy", 1, true, {} } };
  for(std::size_t c = 0; c < source.cells.size(); ++c)
  {
    source.cell_data[0].values.push_back(static_cast<double>(c));
    source.cell_data[1].values.push_back(-source.cell_references[c]);
  }
  write_regions(folder, "source.vtu", source, "RegionId");
  CHECK(references("") == source.cell_references);
  CHECK(folder.text("stderr") == "");
  CHECK(folder.run("source.vtu --improve --regions none") == 2);
  CHECK(folder.text("stderr").find("source.vtu: there are no cell data 'none' for --regions; there are RegionId, ") == 0);

  // sets that meshio has joined
  source.cell_data.clear();
  for(std::size_t c = 0; c < source.cells.size(); ++c)
    source.cell_references[c] = c < 24 ? 0 : 2;
  write_regions(folder, "source.vtu", source, "BONE-FLESH-SKIN");
  REQUIRE(folder.run("source.vtu --improve -o map.vtu") == 0);
  CHECK(folder.text("stderr") == "note: source.vtu: the set 'FLESH' has no cell in the file, because meshio keeps only the last "
        "set of a cell. Remove larger sets before the conversion\n");
  Soup map;
  VMP::IO::read_tetrahedron_soup(folder.path("map.vtu"), map);
  using Group_names = std::map<std::pair<int, int>, std::string>;
  CHECK(map.group_names == Group_names{ { { 3, 1 }, "BONE" }, { { 3, 3 }, "SKIN" } });
  for(std::size_t c = 0; c < map.cells.size(); ++c)
    CHECK(map.cell_references[c] == (c < 24 ? 1 : 3));
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

TEST_CASE("An output behind symbolic links is written where they lead, and the links stay")
{
  const Folder folder;
  const Soup source = cube(1);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 1, affine));
  fs::create_directory(folder.path("there"));
  fs::create_symlink("there/map.mesh", folder.path("second.mesh")); // nothing is there yet
  fs::create_symlink("second.mesh", folder.path("first.mesh"));
  for(int run = 0; run < 2; ++run)
  {
    CHECK(folder.run("source.mesh target.txt -o first.mesh") == 0);
    CHECK(fs::is_symlink(folder.path("first.mesh")));
    CHECK(fs::is_symlink(folder.path("second.mesh")));
    CHECK(fs::is_regular_file(fs::symlink_status(folder.path("there/map.mesh"))));
    CHECK(folder.soup("first.mesh").cells == source.cells);
  }
  fs::create_symlink("nowhere/map.mesh", folder.path("lost.mesh"));
  fs::create_symlink("ring.mesh", folder.path("ring.mesh"));
  fs::create_symlink("twin.mesh", folder.path("report.json"));
  for(const std::string names : {"lost.mesh", "ring.mesh", "twin.mesh --report report.json"})
  {
    CAPTURE(names);
    CHECK(folder.run("source.mesh target.txt -o " + names) == 2);
    CHECK(folder.text("stderr") != "");
  }
  CHECK(fs::is_symlink(folder.path("lost.mesh")));
  CHECK(fs::is_symlink(folder.path("report.json")));
}

TEST_CASE("The report never replaces what is not a regular file")
{
  const Folder folder;
  const Soup source = cube(1);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 1, affine));
  fs::create_directory(folder.path("report.json"));
  CHECK(folder.run("source.mesh target.txt --report report.json") == 2);
  CHECK(fs::is_directory(folder.path("report.json")));
}

TEST_CASE("A link in the place of a temporary file leads nowhere")
{
  const Folder folder;
  const Soup source = cube(1);
  folder.write("source.mesh", source);
  folder.write("other.txt", "of somebody else");
  CHECK(folder.shell("sh -c 'ln -s other.txt map.mesh.$$.tmp && exec \"$0\" source.mesh source.mesh -o map.mesh' \"$driver\"")
        == 0);
  CHECK(folder.text("other.txt") == "of somebody else");
  CHECK(folder.soup("map.mesh").cells == source.cells);
}

TEST_CASE("A limit of the size of files ends in a sentence, and leaves nothing")
{
  const Folder folder;
  folder.write("source.mesh", cube(3));
  CHECK(folder.shell("ulimit -f 4; \"$driver\" source.mesh source.mesh -o map.mesh") == 2);
  CHECK(folder.text("stderr").find("map.mesh: the file cannot be written completely: File too large") != std::string::npos);
  CHECK(folder.names() == Names{"source.mesh"});
}

TEST_CASE("A terminal that is closed ends the program as an interruption does")
{
  const Folder folder;
  folder.write("source.mesh", cube(20));
  Soup target = cube(20);
  for(Point& p : target.points)
    p = { p[0] + 0.1 * p[1] * p[2] / 20, p[1], p[2] };
  folder.write("target.mesh", target);
  Terminal terminal(folder, "source.mesh target.mesh -o map.mesh");
  CHECK(terminal.waits_for("minimizing (minimization), step 1"));
  terminal.send(SIGHUP);
  CHECK(terminal.exit_code() == 0);
  CHECK(folder.names() == Names{"source.mesh", "target.mesh", "map.mesh"});
}

TEST_CASE("An output keeps the mode of the file that it replaces, and may have the longest name")
{
  const Folder folder;
  const std::string name = std::string(250, 'm') + ".mesh";
  folder.write("source.mesh", cube(1));
  const auto mode = [&] { return static_cast<unsigned>(fs::status(folder.path(name)).permissions()); };
  CHECK(folder.shell("umask 027; \"$driver\" source.mesh source.mesh -o " + name) == 0);
  CHECK(mode() == 0640);
  fs::permissions(folder.path(name), static_cast<fs::perms>(0602));
  CHECK(folder.shell("umask 027; \"$driver\" source.mesh source.mesh -o " + name) == 0);
  CHECK(mode() == 0602);
  CHECK(folder.run("source.mesh source.mesh -o m" + name) == 2);
  CHECK(folder.text("stderr").find("the file cannot be written: File name too long") != std::string::npos);
}

TEST_CASE("A file that cannot be written after the map is told with the map")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  for(const std::string arguments : { "--refined-source /dev/full", "--hexahedra 1 /dev/full" })
  {
    CAPTURE(arguments);
    CHECK(folder.run("source.mesh source.mesh --report report.json -o map.mesh " + arguments) == 2);
    CHECK(folder.text("stderr") == "The map is complete in map.mesh. /dev/full: this cannot be written completely: "
                                   "No space left on device\n");
    CHECK(folder.soup("map.mesh").cells == cube(2).cells);
    const std::string report = folder.text("report.json");
    CHECK(report.find("\"status_code\": \"ERROR_FILE_NOT_WRITTEN\", \"has_valid_map\": true") != std::string::npos);
    CHECK(number(report, "cells") == 48);
    fs::remove(folder.path("map.mesh"));
  }
}

TEST_CASE("What is printed to a full device is an error")
{
  const Folder folder;
  folder.write("source.mesh", cube(1));
  for(const std::string arguments : { "--help", "--version", "source.mesh source.mesh" })
  {
    CHECK(folder.run(arguments + " > /dev/full") == 2);
    CHECK(folder.text("stderr") == "the standard output cannot be written\n");
  }
  CHECK(folder.run("source.mesh source.mesh --quiet > /dev/full") == 0);
}

TEST_CASE("A stream has one role, whatever its names are")
{
  const Folder folder;
  folder.write("source.mesh", cube(1));
  REQUIRE(mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  fs::create_symlink("pipe", folder.path("other"));
  for(const std::string arguments : {
        "source.mesh source.mesh -o /dev/stdout --report /dev/fd/1", "source.mesh source.mesh -o - --report /proc/self/fd/1",
        "source.mesh source.mesh -o pipe --report other", "source.mesh source.mesh -o map.mesh --report - > map.mesh"})
  {
    CAPTURE(arguments);
    CHECK(folder.run(arguments) == 2);
    CHECK(folder.text("stderr").find("this file has two roles") != std::string::npos);
  }
  CHECK(folder.run("- /dev/fd/0 < source.mesh") == 2);
  CHECK(folder.text("stderr").find("this input has two roles") != std::string::npos);
  CHECK(folder.run("source.mesh source.mesh -o /dev/null --report /dev/null") == 0);
}

TEST_CASE("The standard input is read from where it stands, and may be a socket")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  folder.write("source.txt", "a line of somebody else\n" + folder.text("source.mesh"));
  CHECK(folder.shell("{ read line; \"$driver\" - source.mesh -o map.mesh; } < source.txt") == 0);
  CHECK(folder.soup("map.mesh").cells == cube(2).cells);

  int sockets[2];
  REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, sockets) == 0);
  const pid_t process = fork();
  if(process == 0)
  {
    dup2(sockets[1], 0);
    dup2(sockets[1], 1);
    close(sockets[0]);
    execl(PARAMETERIZE_MESH_FILE, "driver", "-", folder.path("source.mesh").c_str(), "--quiet", "-o", "-",
          static_cast<char*>(nullptr));
    _exit(127);
  }
  close(sockets[1]);
  const std::string mesh = folder.text("source.mesh");
  CHECK(write(sockets[0], mesh.data(), mesh.size()) == static_cast<ssize_t>(mesh.size()));
  shutdown(sockets[0], SHUT_WR);
  std::string map;
  for(char c; read(sockets[0], &c, 1) == 1;)
    map += c;
  close(sockets[0]);
  int status = -1;
  waitpid(process, &status, 0);
  CHECK(status == 0);
  CHECK(map == folder.text("map.mesh"));
}

TEST_CASE("Options that exclude each other, change nothing or cannot succeed are named")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  folder.write("empty.txt", "# nothing\n");
  const auto prints = [&](const std::string& text) { return folder.text("stderr").find(text) != std::string::npos; };
  CHECK(folder.run("source.mesh --improve --to ball") == 2);
  CHECK(prints("--improve excludes TARGET and --to"));
  CHECK(folder.run("source.mesh --conditions empty.txt") == 0);
  CHECK(prints("note: empty.txt: no line changes the condition of a vertex\n"));
  CHECK(folder.run("source.mesh --to polycube --hexahedra 0.001 hexahedra.mesh -o map.mesh") == 2);
  CHECK(prints("source.mesh: with a spacing of 0.001, there would be about 8e+09 hexahedra"));
  CHECK(folder.names() == Names{"source.mesh", "empty.txt"});
  CHECK(folder.run("source.mesh --to ball -o /dev/full") == 2);
  CHECK(folder.text("stdout").find("-o FILE") == std::string::npos);
}

TEST_CASE("The report is UTF-8, whatever the names of files are")
{
  const Folder folder;
  const std::string good = "K\xC3\xB6rper.mesh", bad = "K\xF6rper\xED\xA0\x80.mesh";
  folder.write(good, cube(1));
  folder.write(bad, cube(1));
  REQUIRE(folder.run("'" + good + "' '" + bad + "' --report report.json") == 0);
  CHECK(folder.text("report.json").find("\"source\": \"" + good + "\"") != std::string::npos);
  CHECK(folder.text("report.json").find("\"target\": \"K\\ufffdrper\\ufffd\\ufffd\\ufffd.mesh\"") != std::string::npos);
}

TEST_CASE("A pipe that nobody reads is given up at the time limit, and when interrupted")
{
  const Folder folder;
  folder.write("source.mesh", cube(1));
  REQUIRE(mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  CHECK(folder.shell("timeout 600 \"$driver\" source.mesh source.mesh -o pipe --time-limit 0.5 --report report.json") == 3);
  CHECK(folder.text("stderr")
        == "No file is written. The time limit was reached. pipe: nobody reads this\n");
  CHECK(folder.text("report.json").find("\"ERROR_INTERRUPTED\", \"has_valid_map\": true") != std::string::npos);
  CHECK(folder.shell("timeout 600 \"$driver\" source.mesh none.mesh --time-limit 0.5 --report pipe") == 3);

  Terminal terminal(folder, "source.mesh source.mesh -o pipe");
  CHECK(terminal.waits_for("writing"));
  terminal.interrupt();
  CHECK(terminal.waits_for("Interrupted. pipe: nobody reads this"));
  CHECK(terminal.exit_code() == 3);

  // a reader that comes late gets all
  CHECK(folder.shell("{ sleep 0.5; cat pipe; } > copy.mesh & \"$driver\" source.mesh source.mesh -o pipe; wait") == 0);
  CHECK(folder.soup("copy.mesh").cells == cube(1).cells);
}

TEST_CASE("Where memory is limited, there is a map or a sentence")
{
  const Folder folder;
  folder.write("source.mesh", cube(6));
  std::set<int> codes;
  for(int kilobytes = 20000, steps = 0; codes.count(0) == 0 && steps < 200; kilobytes += 1000, ++steps)
  {
    const auto driver_with = [](const int limit) { return "ulimit -v " + std::to_string(limit) + "; \"$driver\" "; };
    // Libraries cannot be loaded, or at some addresses only. With too little memory, initializers of libgfortran call each other
    // until the stack ends, before the program begins.
    if(folder.shell(driver_with(kilobytes - 2000) + "--version") != 0)
      continue;
    const int code = folder.shell(driver_with(kilobytes) + "source.mesh source.mesh -o map.mesh");
    CAPTURE(kilobytes, folder.text("stderr"));
    CHECK((code == 0 || code == 3));
    CHECK((code == 0 || folder.text("stderr") != ""));
    codes.insert(code);
  }
  CHECK(codes == std::set<int>{0, 3});
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

TEST_CASE("Advised commands have file names as a shell wants them")
{
  const Folder folder;
  fs::create_directory(folder.path("it's here"));
  folder.write("it's here/a b.med", "v 0 0 0\n");
  CHECK(folder.run("\"it's here/a b.med\" --to ball") == 2);
  const std::string sentence = folder.text("stderr"), command = "meshio convert ";
  const std::size_t begin = sentence.find(command);
  REQUIRE(begin != std::string::npos);
  REQUIRE(folder.shell("printf '%s\\n' " + sentence.substr(begin + command.size())) == 0);
  CHECK(folder.text("stdout") == "it's here/a b.med\nit's here/a b.vtu\n");
}

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
  CHECK(energy_of(" --max-angle-distortion 6", 1) <= 2 * energy_of("", 0));

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
