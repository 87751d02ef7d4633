// Includes and instantiates what many programs of this project need, for compilers that keep instantiations with
// precompiled headers.
#ifndef COMMON_INSTANTIATIONS_H
#define COMMON_INSTANTIATIONS_H

#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Any_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Lp_stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Power_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Surface_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/make_mesh_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <unordered_map>
#include <vector>

namespace common_instantiations
{
namespace VMP = CGAL::Volume_mesh_parameterization;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Remeshing_triangulation = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using Implicit_domain = CGAL::Labeled_mesh_domain_3<K>;
using Polyhedral_domain = CGAL::Polyhedral_mesh_domain_with_features_3<K, CGAL::Surface_mesh<K::Point_3> >;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Remeshing_triangulation>;
using C3t3_of_function = CGAL::Mesh_complex_3_in_triangulation_3<CGAL::Mesh_triangulation_3<Implicit_domain>::type>;
using C3t3_of_surface = CGAL::Mesh_complex_3_in_triangulation_3<CGAL::Mesh_triangulation_3<Polyhedral_domain>::type,
                                                                Polyhedral_domain::Corner_index, Polyhedral_domain::Curve_index>;

template <typename C3t3>
void map(C3t3 c3t3)
{
  std::unordered_map<typename C3t3::Vertex_handle, K::Point_3> uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map);
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, CGAL::parameters::boundary_map(uvw_map));
}

inline void map_bodies()
{
  C3t3 c3t3;
  std::vector<C3t3::Vertex_handle> vertices;
  std::vector<C3t3::Cell_handle> cells;
  VMP::tetrahedron_soup_to_mesh_complex_3(VMP::Tetrahedron_soup_3(), c3t3, vertices, cells);
  map(c3t3);
  map(C3t3_of_function());
  map(C3t3_of_surface());

  const auto function = [](const K::Point_3&) -> K::FT { return 0; };
  const CGAL::Mesh_criteria_3<C3t3_of_function::Triangulation> criteria(
    CGAL::parameters::facet_angle = 25, CGAL::parameters::facet_size = 1, CGAL::parameters::facet_distance = 1,
    CGAL::parameters::cell_radius_edge_ratio = 3, CGAL::parameters::cell_size = 1);
  const Implicit_domain domain = Implicit_domain::create_implicit_mesh_domain(+function, K::Sphere_3(CGAL::ORIGIN, 1));
  CGAL::make_mesh_3<C3t3_of_function>(domain, criteria, CGAL::parameters::no_perturb(),
                                      CGAL::parameters::exude(CGAL::parameters::time_limit = 0));
  CGAL::Surface_mesh<K::Point_3> surface;
  CGAL::IO::read_polygon_mesh(std::string(), surface);
  CGAL::Polygon_mesh_processing::triangulate_faces(surface);
  CGAL::alpha_wrap_3(surface, 1., 1., surface);
  const CGAL::Mesh_criteria_3<C3t3_of_surface::Triangulation> criteria_of_surface(
    CGAL::parameters::edge_size = 1, CGAL::parameters::facet_angle = 25, CGAL::parameters::facet_size = 1,
    CGAL::parameters::facet_distance = 1, CGAL::parameters::facet_topology = CGAL::MANIFOLD,
    CGAL::parameters::cell_radius_edge_ratio = 3, CGAL::parameters::cell_size = 1);
  CGAL::make_mesh_3<C3t3_of_surface>(Polyhedral_domain(surface), criteria_of_surface,
                                     CGAL::parameters::perturb(CGAL::parameters::time_limit = 0),
                                     CGAL::parameters::exude(CGAL::parameters::time_limit = 0));

  std::vector<std::array<double, 3> > points, images;
  std::vector<std::array<std::size_t, 4> > indices;
  CGAL::stretch_minimizing_volume_parameterization(points, indices, points, images);
}
} // namespace common_instantiations

#endif // COMMON_INSTANTIATIONS_H
