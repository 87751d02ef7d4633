// Meshes a labeled image whose body touches itself, as segmentations do, and writes it as MEDIT: mesh_labels FILE.mesh
#include "mesh_body.h"

#include <array>
#include <cstdlib>
#include <fstream>

namespace {

// Returns the label of the voxel at a point: of blocks along a ring whose ends have one corner in common, of two materials.
int label(const Point_3& p)
{
  constexpr std::array<std::array<int, 3>, 10> blocks
    = {{ {0, 0, 0}, {-1, 0, 0}, {-1, 0, 1}, {-1, 0, 2}, {-1, 0, 3}, {0, 0, 3}, {1, 0, 3}, {1, 1, 3}, {1, 1, 2}, {1, 1, 1} }};
  for(const std::array<int, 3>& block : blocks)
    if(block[0] < p.x() && p.x() < block[0] + 1 && block[1] < p.y() && p.y() < block[1] + 1 && block[2] < p.z()
       && p.z() < block[2] + 1)
      return p.z() < 2.5 ? 1 : 2;
  return 0;
}

} // namespace

int main(int, char* argv[])
{
  namespace params = CGAL::parameters;
  const Domain domain(params::function = label, params::bounding_object = CGAL::Bbox_3(-1.5, -0.5, -0.5, 2.5, 2.5, 4.5));
  const double size = 0.4; // with smaller ones, the blocks at the corner are joined or apart
  const C3t3 c3t3 = mesh_body(domain, CGAL::Mesh_criteria_3<Tr>(
    params::facet_size = size, params::facet_distance = 0.02, params::cell_radius_edge_ratio = 3, params::cell_size = size));
  std::ofstream os(argv[1]);
  c3t3.output_to_medit(os);
  return os ? EXIT_SUCCESS : EXIT_FAILURE;
}
