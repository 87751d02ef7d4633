#include "mesh_surface.h"

#include <CGAL/alpha_wrap_3.h>

Surface_mesh close_gaps(const Surface_mesh& surface, const double gap, const double offset)
{
  Surface_mesh wrap;
  CGAL::alpha_wrap_3(surface, gap, offset, wrap);
  return wrap;
}
