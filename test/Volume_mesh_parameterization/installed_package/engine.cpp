#include "map_grid.h"

#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  error "This unit links the engine."
#endif

Points images_by_engine() { return images_of_grid(); }
const void* address_of_engine() { return address_of_code(); }

// Solves sparse systems.
bool has_polycube_by_engine()
{
  namespace PM = CGAL::Polycube_meshing_3;
  namespace VMP = CGAL::Volume_mesh_parameterization;
  Points points, targets;
  Cells cells;
  make_grid(points, cells);
  return PM::Polycube_boundary_parameterizer_3().parameterize(points, cells, targets) == VMP::OK;
}
