#include "map_grid.h"

Points images_by_headers() { return images_of_grid(); }
const void* address_of_headers() { return address_of_code(); }
