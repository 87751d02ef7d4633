// The parameterization of a surface by CGAL, for comparison: ARAP in Surface_mesh_parameterization.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

using K = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<K::Point_3>;

int main()
{
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, K::Point_2>("v:uv").first;
  CGAL::Surface_mesh_parameterization::ARAP_parameterizer_3<Mesh> parameterizer;
  return CGAL::Surface_mesh_parameterization::parameterize(mesh, parameterizer, Mesh::Halfedge_index(), uv);
}
