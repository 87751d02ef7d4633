// The tetrahedral mesh of a surface by CGAL, for comparison: make_mesh_3() in Mesh_3.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<K::Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<K, Surface>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;

int main()
{
  Surface surface;
  const Domain domain(surface);
  const CGAL::Mesh_criteria_3<Tr> criteria(CGAL::parameters::facet_angle = 25, CGAL::parameters::cell_size = 1);
  return static_cast<int>(CGAL::make_mesh_3<C3t3>(domain, criteria).number_of_cells());
}
