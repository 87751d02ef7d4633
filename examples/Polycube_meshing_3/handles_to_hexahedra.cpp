// Meshes a body with two handles, maps it onto a polycube, and makes hexahedra. Edges of the boundary may be split.
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <fstream>
namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;
using namespace CGAL::parameters;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<CGAL::Epick, CGAL::Surface_mesh<CGAL::Epick::Point_3> >;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<CGAL::Mesh_triangulation_3<Domain>::type>;
int main()
{
  Domain::Polyhedron surface;
  std::ifstream(CGAL::data_file_path("meshes/joint.off")) >> surface;
  Domain domain(surface);
  domain.detect_features();
  CGAL::Mesh_criteria_3<C3t3::Triangulation> criteria(edge_size = 0.08, facet_angle = 25,
                                                     facet_size = 0.08, cell_size = 0.08);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, manifold(), no_perturb(), no_exude());
  std::unordered_map<C3t3::Vertex_handle, CGAL::Epick::Point_3> uvw;
  const auto map = CGAL::stretch_minimizing_volume_parameterization(c3t3, VMP::make_vertex_point_map(uvw),
    boundary_parameterizer(PM::Polycube_boundary_parameterizer_3(0.05))
    .refinement_mode(VMP::Refinement_mode::BOUNDARY));
  PM::Hexahedron_soup_3 hexahedra;
  const auto result = PM::make_hexahedral_mesh_3(c3t3, VMP::make_vertex_point_map(uvw), 0.05, hexahedra);
  std::cout << map.message << " " << result.message << " " << hexahedra.cells.size() << " hexahedra" << std::endl;
  return PM::IO::write_VTU("hexahedra_of_handles.vtu", hexahedra) && result.status == PM::OK ? 0 : 1;
}
