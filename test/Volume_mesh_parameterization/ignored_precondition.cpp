// A precondition that is broken without effect, as CGAL_NO_PRECONDITIONS is defined.
#include <CGAL/Volume_mesh_parameterization/Vertex_condition_3.h>

int main()
{
  CGAL::Volume_mesh_parameterization::Vertex_condition_3::in_plane(0, 0, 0);
}
