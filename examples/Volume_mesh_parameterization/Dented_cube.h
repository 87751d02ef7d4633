// The problem that several examples share: a cube of 384 cells, whose upper face is pressed down beyond the middle.
#ifndef DENTED_CUBE_H
#define DENTED_CUBE_H

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Vertex_point_map.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <unordered_map>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

struct Dented_cube
{
  C3t3 c3t3;
  std::unordered_map<Vertex_handle, Point_3> targets; // of the vertices on the boundary of the cube [-1,1]^3
  std::unordered_map<Vertex_handle, Point_3> uvw;

  Dented_cube()
  {
    VMP::Tetrahedron_soup_3 soup;
    std::vector<Vertex_handle> vertices, on_boundary;
    std::vector<C3t3::Cell_handle> cells;
    VMP::IO::read_MEDIT("data/cube.mesh", soup);
    VMP::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
    VMP::boundary_vertices(c3t3, std::back_inserter(on_boundary));
    for(const Vertex_handle v : on_boundary)
      targets.emplace(v, dent(v->point()));
  }

  auto boundary_map() { return VMP::make_vertex_point_map(targets); }
  auto uvw_map() { return VMP::make_vertex_point_map(uvw); }

private:
  static Point_3 dent(const Point_3& p)
  {
    const double depth = p.z() == 1 ? 1.4 * (1 - p.x() * p.x()) * (1 - p.y() * p.y()) : 0;
    return Point_3(p.x(), p.y(), p.z() - depth);
  }
};

// Prints the result and returns the exit code of the program.
inline int print(const VMP::Parameterization_result& result)
{
  const VMP::Distortion_3& d = result.distortion_at_source_volume;
  std::cout << result.message << "\n"
            << result.number_of_inverted_cells << " inverted cells, energy " << result.energy << "\n"
            << "distortion of angles:  mean " << d.angle_mean << ", max " << d.angle_max << "\n"
            << "distortion of volumes: mean " << d.volume_mean << ", max " << d.volume_max
            << " (of the map scaled to the volume of the source)" << std::endl;
  return result.has_valid_map ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif // DENTED_CUBE_H
