// Maps a cube onto a dented one. Minimizes the energy of least squares conformal maps (LSCM). One chooses it to compare
// with other work; for maps that preserve angles, MIPS does not favor small cells. It is finite for flat cells, so it
// gets a barrier. Its weight is 1, as with the default of 0.01 the distortion of angles reaches 466.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <cstdlib>
#include <iostream>
#include <unordered_map>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K> >;
namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

int main()
{
  VMP::Tetrahedron_soup_3 soup;
  VMP::IO::read_MEDIT("data/cube.mesh", soup); // [-1,1]^3
  C3t3 cube;
  std::vector<C3t3::Vertex_handle> vertices;
  VMP::tetrahedron_soup_to_mesh_complex_3(soup, cube, vertices);

  std::unordered_map<C3t3::Vertex_handle, K::Point_3> target, uvw;
  for(const C3t3::Vertex_handle v : vertices)
  {
    const double x = v->point().x(), y = v->point().y(), z = v->point().z();
    target[v] = K::Point_3(x, y, z == 1 ? z - 1.4 * (1 - x * x) * (1 - y * y) : z);
  }
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    cube, VMP::make_vertex_point_map(uvw), params::boundary_map(VMP::make_vertex_point_map(target))
                                               .energy(VMP::Barrier_energy_3<VMP::LSCM_energy_3>(VMP::LSCM_energy_3(), 1.)));
  const VMP::Distortion_3& d = result.distortion_at_source_volume;
  std::cout << result.message << "\n"
            << "distortion of angles:  mean " << d.angle_mean << ", max " << d.angle_max << "\n"
            << "distortion of volumes: mean " << d.volume_mean << ", max " << d.volume_max << "\n"
            << "mean energy " << result.energy << ", with the barrier; 0 for a similarity without it" << std::endl;
  const bool is_written = VMP::IO::write_VTU("lscm_energy.vtu", cube, VMP::make_vertex_point_map(uvw));
  return result.status == VMP::OK && is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
