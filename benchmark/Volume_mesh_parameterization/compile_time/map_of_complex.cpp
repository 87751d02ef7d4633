// The call that most users make, on a constant complex of Mesh_3.
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <unordered_map>
#include <utility>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<K, CGAL::Surface_mesh<K::Point_3> >;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;

int main()
{
  C3t3 c3t3;
  std::unordered_map<Vertex_handle, K::Point_3> target, uvw;
  const auto result = CGAL::stretch_minimizing_volume_parameterization(
    std::as_const(c3t3), boost::make_assoc_property_map(uvw),
    CGAL::parameters::boundary_map(boost::make_assoc_property_map(target)));
  return static_cast<int>(c3t3.number_of_cells() + result.number_of_cells);
}
