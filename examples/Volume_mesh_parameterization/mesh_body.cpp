#include "mesh_body.h"

#include <CGAL/make_mesh_3.h>

C3t3 mesh_body(const Domain& domain, const CGAL::Mesh_criteria_3<Tr>& criteria)
{
  // limits of time, as by default, would give another mesh in each run
  return CGAL::make_mesh_3<C3t3>(domain, criteria, CGAL::parameters::no_perturb(),
                                 CGAL::parameters::exude(CGAL::parameters::time_limit = 0));
}
