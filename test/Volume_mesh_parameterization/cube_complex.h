// A cube mesh as a C3t3, with property maps for its vertices.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CUBE_COMPLEX_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CUBE_COMPLEX_H

#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/Vertex_map.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <unordered_map>
#include <vector>

// `vertices` are in the order of the mesh. `target` holds prescribed vertices only.
template <typename Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
struct Cube_complex
{
  using Point_3 = typename Kernel::Point_3;
  using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel>;
  using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Cell_handle = typename C3t3::Cell_handle;
  using Point_map = std::unordered_map<Vertex_handle, Point_3>;

  CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3 mesh;
  C3t3 c3t3;
  std::vector<Vertex_handle> vertices;
  std::vector<Cell_handle> cells;
  Point_map target, uvw;

  explicit Cube_complex(const CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3& mesh)
    : Cube_complex(mesh, source_soup(mesh))
  {}

  Cube_complex(const CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3& mesh,
               const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
    : mesh(mesh)
  {
    CGAL::Volume_mesh_parameterization::tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(!mesh.is_free(v))
        target.emplace(vertices[v], Point_3(mesh.target(0, v), mesh.target(1, v), mesh.target(2, v)));
  }

  Cube_complex(const Cube_complex&) = delete;

  auto boundary_map() { return CGAL::Volume_mesh_parameterization::make_vertex_point_map(target); }
  auto uvw_map() { return CGAL::Volume_mesh_parameterization::make_vertex_point_map(uvw); }
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CUBE_COMPLEX_H
