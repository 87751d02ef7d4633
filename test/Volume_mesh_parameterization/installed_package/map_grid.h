// A grid of boxes, and its map to a ball with refinement, which each unit that uses the package makes. No two boxes have the same
// sides, so that rounding, which flags change, does not choose between equals.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

using Points = std::vector<std::array<double, 3> >;
using Cells = std::vector<std::array<int, 4> >;

int number_of_iterations(); // of the unit that knows only CGAL

// Returns the address of an object that the code of the map defines once.
static const void* address_of_code() { return &CGAL::Volume_mesh_parameterization::internal::single_process(); }

static void make_grid(Points& points, Cells& cells)
{
  const int n = 4;
  for(int v = 0; v < n * n * n; ++v)
  {
    points.push_back({ std::pow(1.1, v % n), std::pow(1.2, v / n % n), std::pow(1.3, v / n / n) });
    if(v % n < n - 1 && v / n % n < n - 1 && v / n / n < n - 1)
      for(const auto& [a, b] : { std::array{ 1, 1 + n }, { 1 + n, n }, { n, n + n * n }, { n + n * n, n * n },
                                 { n * n, 1 + n * n }, { 1 + n * n, 1 } })
        cells.push_back({ v, v + a, v + b, v + 1 + n + n * n });
  }
}

static Points images_of_grid()
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  Points points, targets, images;
  Cells cells;
  make_grid(points, cells);
  if(VMP::Ball_boundary_parameterizer_3().parameterize(points, cells, targets) != VMP::OK)
    throw std::runtime_error("no boundary");
  const auto result = CGAL::stretch_minimizing_volume_parameterization(
    points, cells, targets, images, CGAL::parameters::refinement_mode(VMP::Refinement_mode::HELPFUL)
                                       .number_of_iterations(number_of_iterations()));
  if(result.status != VMP::OK)
    throw std::runtime_error(result.message);
  return images;
}

// Solves sparse systems. Returns nothing if there is no polycube.
static Points polycube_of_grid()
{
  Points points, targets;
  Cells cells;
  make_grid(points, cells);
  CGAL::Polycube_meshing_3::Polycube_boundary_parameterizer_3 polycube;
  return polycube.parameterize(points, cells, targets) == CGAL::Polycube_meshing_3::OK ? targets : Points();
}
