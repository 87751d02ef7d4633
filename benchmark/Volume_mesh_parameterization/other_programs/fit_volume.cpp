// Untangles FOLDER/start.mesh by Versatile Volume Fitting, with the vertices of FOLDER/targets.txt locked, and writes
// FOLDER/result.mesh. Prints the seconds until no cell is inverted.
//
//   fit_volume FOLDER
#include <Mesh_optimization/Mesh_conformal_optimizer.h>

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

struct Mesh : Mesh_optimization::basic_structures::Tetrahedral_mesh
{
  std::vector<Point_3> rest;

  std::array<Point_3, 4> cell_reference_shape(const Cell_descriptor cell) const
  {
    const auto& c = _tetrahedra[cell];
    return { rest[c[0]], rest[c[1]], rest[c[2]], rest[c[3]] };
  }
};

int main(int argc, char** argv)
{
  const std::string folder = argc > 1 ? argv[1] : ".";
  VMP::Tetrahedron_soup_3 rest, start;
  if(!VMP::IO::read_MEDIT(folder + "/rest.mesh", rest) || !VMP::IO::read_MEDIT(folder + "/start.mesh", start))
    return EXIT_FAILURE;
  const auto vectors_of = [](const VMP::Tetrahedron_soup_3& soup)
  {
    std::vector<Eigen::Vector3d> result;
    for(const auto& p : soup.points)
      result.emplace_back(p[0], p[1], p[2]);
    return result;
  };
  Mesh mesh;
  mesh.rest = vectors_of(rest);
  mesh._points = vectors_of(start);
  mesh._tetrahedra = rest.cells;

  Mesh_optimization::Mesh_conformal_optimizer<Mesh> optimizer(mesh);
  std::vector<std::size_t> locked;
  std::ifstream targets(folder + "/targets.txt");
  double x, y, z;
  for(std::size_t v; targets >> v >> x >> y >> z; )
    locked.push_back(v);
  optimizer.set_locked_boundary(false);
  optimizer.set_locked_vertices(locked);
  const auto begin = std::chrono::steady_clock::now();
  bool is_valid = false;
  optimizer.set_callback_function([&](const auto& status, const auto&, const auto&)
  {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if(!is_valid && status.nb_inverted == 0 && status.min_det > 0)
    {
      std::cout << "valid after " << seconds.count() << " s" << std::endl;
      is_valid = true;
    }
    return false; // do not stop
  });
  optimizer.untangle();
  for(std::size_t v = 0; v < start.points.size(); ++v)
    start.points[v] = { mesh._points[v][0], mesh._points[v][1], mesh._points[v][2] };
  return VMP::IO::write_MEDIT(folder + "/result.mesh", start) ? EXIT_SUCCESS : EXIT_FAILURE;
}
