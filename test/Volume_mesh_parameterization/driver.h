// Runs the program parameterize_mesh_file in a folder of its own, and reads what it writes.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_DRIVER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_DRIVER_H

#include "catch.h"

#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Soup = VMP::Tetrahedron_soup_3;
using Point = std::array<double, 3>;
using Names = std::set<std::string>;

// A word of a command of the shell.
inline std::string quoted(const std::string& text) { return "'" + std::regex_replace(text, std::regex("'"), "'\\''") + "'"; }

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
inline Soup cube(std::size_t n)
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

inline bool is_on_boundary(const Point& p, double n)
{
  for(double x : p)
    if(x == 0 || x == n)
      return true;
  return false;
}

inline Point affine(const Point& p)
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
inline Soup fan_in_prism(std::size_t length)
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
inline double smallest_determinant_of_hexahedra(const std::string& file)
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

inline double number(const std::string& json, const std::string& key)
{
  std::smatch match;
  REQUIRE(std::regex_search(json, match, std::regex("\"" + key + "\": ([-+.eE0-9]+)")));
  return std::stod(match[1]);
}

inline std::vector<std::string> keys(const std::string& json)
{
  const std::regex key("\"([a-z_]+)\": ");
  std::vector<std::string> result;
  for(std::sregex_iterator it(json.begin(), json.end(), key), end; it != end; ++it)
    result.push_back((*it)[1]);
  return result;
}

inline const std::vector<std::string> report_keys = {
  "status", "status_code", "has_valid_map", "version",
  "options", "source", "target", "to", "polycube_axes", "improve", "cell_size", "tetrahedra", "features", "regions", "landmarks",
  "tolerance", "merge_points", "fill_voids", "leave_out_flat_cells", "separate", "displacements", "staircases", "others", "inside",
  "conditions", "initial", "boundary", "refine", "slide", "energy",
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
  "quality_of_source", "minimum_dihedral_angle", "maximum_dihedral_angle", "minimum_scaled_jacobian", "maximum_aspect_ratio",
  "quality", "minimum_dihedral_angle", "maximum_dihedral_angle", "minimum_scaled_jacobian", "maximum_aspect_ratio",
  "seconds_reading", "seconds_boundary", "seconds_hexahedra",
  "steps", "energy", "inverted_cells", "seconds", "peak_memory_bytes"};

inline const std::vector<std::string> hexahedra_keys = {
  "hexahedra", "status", "status_code", "vertices", "boundary_vertices", "cells", "inverted_corners", "inverted_hexahedra",
  "padding", "minimum_scaled_jacobian", "mean_scaled_jacobian", "boundary_distance", "subdomains", "volumes_of_tetrahedra",
  "volumes_of_hexahedra", "interface_distance", "patches", "references", "quadrangles", "areas", "centers", "normals",
  "features", "corners", "corners_kept", "corners_given_up", "curves", "curves_kept", "curves_given_up", "patches", "patches_kept",
  "patches_given_up"};

// Returns the keys of a report with other ones, which come before the steps.
inline std::vector<std::string> report_keys_with(const std::vector<std::string>& others)
{
  std::vector<std::string> result = report_keys;
  result.insert(std::find(result.begin(), result.end(), "steps"), others.begin(), others.end());
  return result;
}

inline std::string hexahedra_of(const std::string& report) { return report.substr(report.find("\"hexahedra\": {")); }

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_DRIVER_H
