// Maps a cube of twelve cells onto itself; its centre must stay.
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

int number_of_iterations(); // defined in the other translation unit

int main()
{
  std::vector<std::array<double, 3> > points, uvw;
  for(int i = 0; i < 8; ++i)
    points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  points.push_back({0.5, 0.5, 0.5});
  const std::vector<std::array<std::size_t, 4> > cells
    = {{0, 1, 3, 8}, {0, 3, 2, 8}, {4, 7, 5, 8}, {4, 6, 7, 8}, {0, 5, 1, 8}, {0, 4, 5, 8},
       {2, 3, 7, 8}, {2, 7, 6, 8}, {0, 2, 6, 8}, {0, 6, 4, 8}, {1, 7, 3, 8}, {1, 5, 7, 8}};

  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    points, cells, points, uvw, CGAL::parameters::number_of_iterations(number_of_iterations()));

  std::cout << result.message << std::endl;
  if(result.status != VMP::OK)
    return EXIT_FAILURE;
  const double distance = std::hypot(uvw[8][0] - 0.5, uvw[8][1] - 0.5, uvw[8][2] - 0.5);
  return distance < 1e-10 ? EXIT_SUCCESS : EXIT_FAILURE;
}
