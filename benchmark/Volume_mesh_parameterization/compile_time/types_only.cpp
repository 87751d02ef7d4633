// Names the types of a complex, and calls nothing: what map_of_complex.cpp costs more is the package.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<K, CGAL::Surface_mesh<K::Point_3> >;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;

int main()
{
  C3t3 c3t3;
  return static_cast<int>(c3t3.number_of_cells());
}
