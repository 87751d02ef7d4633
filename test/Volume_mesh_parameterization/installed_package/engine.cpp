#include "map_grid.h"

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  error "This unit links the engine."
#endif

Points images_by_engine() { return images_of_grid(); }
Points polycube_by_engine() { return polycube_of_grid(); }
const void* address_of_engine() { return address_of_code(); }
