#include "map_grid.h"

Points images_by_headers() { return images_of_grid(); }
