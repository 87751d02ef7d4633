// Maps a tetrahedral mesh that is kept in arrays, without a complex of CGAL.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

int main()
try
{
  VMP::Tetrahedron_soup_3 soup;
  std::vector<std::array<double, 3> > targets, images; // one for each point; points that are not on the boundary have no target
  VMP::IO::read_MEDIT("data/cube.mesh", soup);
  VMP::IO::read_boundary_targets("data/cube_to_ball.txt", soup, targets);

  const VMP::Parameterization_result result
    = CGAL::stretch_minimizing_volume_parameterization(soup.points, soup.cells, targets, images);
  std::cout << result.message << std::endl;
  if(!result.has_valid_map)
    return EXIT_FAILURE;

  const auto distortions = VMP::cell_distortions(soup.points, soup.cells, images);
  const auto worst = std::max_element(distortions.begin(), distortions.end(), [](const auto& a, const auto& b)
  {
    return a.angle < b.angle;
  });
  std::cout << "largest distortion of angles: " << worst->angle << ", in cell " << worst - distortions.begin()
            << std::endl;

  return VMP::IO::write_VTU("ball.vtu", soup, images) ? EXIT_SUCCESS : EXIT_FAILURE;
}
catch(const std::exception& error) // names the mistake in the files or in the indices
{
  std::cerr << error.what() << std::endl;
  return EXIT_FAILURE;
}
