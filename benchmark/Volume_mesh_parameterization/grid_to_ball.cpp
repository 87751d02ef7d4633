// Writes a case of the grid-to-ball family: a grid of 6 n^3 cells in a cube, whose boundary goes to the unit sphere.
#include "jittered_grid.h"
#include "write_case.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>

// The smooth map from the surface of the cube [-1, 1]^3 to the unit sphere.
std::array<double, 3> cube_to_sphere(const std::array<double, 3>& p)
{
  std::array<double, 3> q;
  for(int i = 0; i < 3; ++i)
  {
    const double a = p[(i + 1) % 3] * p[(i + 1) % 3], b = p[(i + 2) % 3] * p[(i + 2) % 3];
    q[i] = p[i] * std::sqrt(1 - a / 2 - b / 2 + a * b / 3);
  }
  return q;
}

int main(int argc, char* argv[])
{
  const int n = (argc == 3) ? std::atoi(argv[1]) : 0;
  if(n < 1 || n > 500)
  {
    std::cerr << "Usage: grid_to_ball N NAME\n"
                 "Writes NAME.mesh, with 6 N^3 cells (N at most 500), and its target NAME_ball.txt." << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    const Jittered_grid grid(static_cast<std::size_t>(n));
    write_mesh(argv[2], grid.soup());
    write_targets(argv[2], "ball", grid.soup().points.size(),
                  [&](std::size_t v) { return grid.is_on_boundary(v); },
                  [&](std::size_t v) { return cube_to_sphere(grid.soup().points[v]); });
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
