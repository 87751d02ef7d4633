// The call for arrays of points and cells.
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <array>
#include <vector>

int main()
{
  std::vector<std::array<double, 3> > points, images;
  std::vector<std::array<int, 4> > cells;
  return static_cast<int>(CGAL::stretch_minimizing_volume_parameterization(points, cells, images).number_of_cells);
}
