// A tetrahedral mesh of a body that a function describes.
#ifndef MESH_BODY_H
#define MESH_BODY_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Domain = CGAL::Labeled_mesh_domain_3<K>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;

// Meshes a domain without limits of time, which would give another mesh in each run.
inline C3t3 mesh_body(const Domain& domain, const CGAL::Mesh_criteria_3<Tr>& criteria)
{
  return CGAL::make_mesh_3<C3t3>(domain, criteria, CGAL::parameters::no_perturb(),
                                 CGAL::parameters::exude(CGAL::parameters::time_limit = 0));
}

#endif // MESH_BODY_H
