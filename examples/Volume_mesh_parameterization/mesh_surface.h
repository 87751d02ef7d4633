// Tetrahedral meshes of bodies that closed surfaces enclose. They are compiled once for several programs, as make_mesh_3()
// takes longer to compile than the rest of each.
#ifndef MESH_SURFACE_H
#define MESH_SURFACE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>

#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<K, Surface_mesh>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr, Domain::Corner_index, Domain::Curve_index>;

// Reads a surface and splits its faces into triangles. Returns false if there is none in the file, or it is not closed.
bool read_closed_surface(const std::string& filename, Surface_mesh& surface);

// A surface at this distance from another one, which does not enter gaps that are narrower.
Surface_mesh close_gaps(const Surface_mesh& surface, double gap, double offset);

// Closes the gaps of the surface in a file, and fills it.
C3t3 mesh_elephant(const std::string& filename);

// Keeps the sharp edges of the surface; the size of the cells is relative to the bounding box.
C3t3 mesh_mechanical_part(const Surface_mesh& surface, double relative_size = 0.05);

#endif // MESH_SURFACE_H
