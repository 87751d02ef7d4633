// Calls all that the engines would compile, at least once: scripts/check_seams.sh finds in this unit what it has missed.
#include "map_grid.h"

#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/surfaces.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>

#include <CGAL/property_map.h>

#include <fstream>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  error "This unit is header-only."
#endif

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

Points images_by_headers() { return images_of_grid(); }
Points polycube_by_headers() { return polycube_of_grid(); }
const void* address_of_headers() { return address_of_code(); }

// Returns the number of hexahedra by a map to a cube, which is the grid itself.
std::size_t number_of_hexahedra_by_headers()
{
  Points points, images;
  Cells cells;
  make_grid(points, cells);
  const auto result = CGAL::stretch_minimizing_volume_parameterization(
    points, cells, images, CGAL::parameters::boundary_parameterizer(VMP::Cube_boundary_parameterizer_3()));
  PM::Hexahedron_soup_3 hexahedra;
  const bool is_mapped = result.status == VMP::OK && VMP::non_manifold_boundary_vertices(points, cells).empty();
  return is_mapped && PM::make_hexahedral_mesh_3(points, cells, images, 0.5, hexahedra).status == PM::OK
       ? hexahedra.cells.size() : 0;
}

// Returns whether the vertices of a tetrahedron slide on its own surface.
bool has_slid_by_headers()
{
  const Points points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const Cells cells{ { 0, 1, 2, 3 } };
  const VMP::Triangulated_surface_3 surface(points, { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } });
  const std::vector<VMP::Vertex_condition_3> conditions(4, VMP::Vertex_condition_3::on_surface(surface));
  Points images;
  const auto result = CGAL::stretch_minimizing_volume_parameterization(
    points, cells, points, images,
    CGAL::parameters::vertex_condition_map(CGAL::make_property_map(conditions)).verbose(true)
                     .energy(VMP::Symmetric_Dirichlet_energy_3()));
  return result.status == VMP::OK && VMP::measure_distortion(points, cells, images).angle_max < 2.1;
}

// Returns whether triangles cover the concave polygons of a surface.
bool has_read_surface_by_headers()
{
  std::ofstream("wedge.off") << "OFF\n8 6 0\n0 0 0\n2 0 0\n.5 .5 0\n0 2 0\n0 0 1\n2 0 1\n.5 .5 1\n0 2 1\n"
                                "4 1 0 3 2\n4 5 6 7 4\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  VMP::Tetrahedron_soup_3 surface;
  return VMP::IO::read_closed_surface("wedge.off", surface) && surface.facets.size() == 12;
}
