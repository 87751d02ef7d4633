// Mesh motion: the mesh of a block follows a hole in it, which turns and shifts, in 40 steps, or in the number of the
// argument, and in one call. A file shows each quarter of the way.
#include "mesh_surface.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <unordered_map>
#include <vector>

using Vertex_handle = C3t3::Vertex_handle;
using Point_map = std::unordered_map<Vertex_handle, Point_3>;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

// Adds the surface of the box [-x,x] x [-y,y] x [-z,z].
void add_box(const double x, const double y, const double z, Surface_mesh& surface)
{
  std::vector<Surface_mesh::Vertex_index> v;
  for(int i = 0; i < 8; ++i)
    v.push_back(surface.add_vertex(Point_3(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z)));
  constexpr int sides[6][4] = { {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5} };
  for(const auto& side : sides)
  {
    surface.add_face(v[side[0]], v[side[1]], v[side[2]]);
    surface.add_face(v[side[0]], v[side[2]], v[side[3]]);
  }
}

// The boundary at a time from 0 to 1: the sides of the block stay, the hole turns by 90 degrees and shifts.
Point_3 moved(const Point_3& p, const double time)
{
  if((std::max)({ std::abs(p.x()), std::abs(p.y()), std::abs(p.z()) }) > 0.999)
    return p;
  const double angle = time * std::acos(0.);
  return Point_3(std::cos(angle) * p.x() - std::sin(angle) * p.y() + 0.3 * time,
                 std::sin(angle) * p.x() + std::cos(angle) * p.y() + 0.2 * time, p.z());
}

// Moves the mesh to the boundary of that time, from these positions of its vertices on, if there are any.
VMP::Parameterization_result move_mesh(const C3t3& c3t3, const double time, const Point_map& initial,
                                       Point_map& position)
{
  const auto boundary = [time](const Vertex_handle v) { return moved(v->point().point(), time); };
  const auto np = params::boundary_map(boost::make_function_property_map<Vertex_handle>(boundary))
                         .energy(VMP::Symmetric_Dirichlet_energy_3());
  const auto position_map = VMP::make_vertex_point_map(position);
  if(initial.empty())
    return CGAL::stretch_minimizing_volume_parameterization(c3t3, position_map, np);
  return CGAL::stretch_minimizing_volume_parameterization(
    c3t3, position_map, np.initial_map(VMP::make_vertex_point_map(initial)));
}

int main(int argc, char* argv[])
{
  const int n = (argc > 1) ? (std::max)(std::atoi(argv[1]), 1) : 40;
  Surface_mesh surface;
  add_box(1, 1, 1, surface);
  add_box(0.5, 0.15, 0.15, surface); // the hole
  const C3t3 c3t3 = mesh_mechanical_part(surface, 0.1);

  std::vector<double> ratios;
  Point_map position, before;
  for(int i = 1; i <= n; ++i)
  {
    // A vertex starts where it would be if it moved on as in the step before.
    Point_map initial = position;
    if(i > 2)
      for(auto& [v, p] : initial)
        p += p - before.at(v);
    before.swap(position);

    Point_map unused;
    const double time = static_cast<double>(i) / n;
    const VMP::Parameterization_result result = move_mesh(c3t3, time, initial, position);
    const VMP::Parameterization_result cold = move_mesh(c3t3, time, Point_map(), unused);
    std::cout << "step " << i << ": " << result.number_of_iterations << " Newton steps (" << cold.number_of_iterations
              << " without initial map), energy " << result.energy << ", inverted cells: "
              << result.number_of_inverted_cells << std::endl;
    if(result.status != VMP::OK || cold.status != VMP::OK)
    {
      std::cerr << result.message << "\n" << cold.message << std::endl;
      return EXIT_FAILURE;
    }
    if(4 * i % n == 0)
    {
      VMP::IO::write_VTU("moving_boundary_" + std::to_string(4 * i / n) + ".vtu", c3t3, VMP::make_vertex_point_map(position));
    }
    ratios.push_back(static_cast<double>(result.number_of_iterations) / static_cast<double>(cold.number_of_iterations));
  }
  std::nth_element(ratios.begin(), ratios.begin() + n / 2, ratios.end());
  std::cout << "median ratio of Newton steps: " << ratios[n / 2] << std::endl;

  Point_map source, at_once;
  for(const Vertex_handle v : c3t3.triangulation().finite_vertex_handles())
    source.emplace(v, v->point().point());
  const VMP::Parameterization_result result = move_mesh(c3t3, 1, source, at_once);
  std::cout << "in one call: " << result.number_of_iterations << " Newton steps, of which "
            << result.number_of_untangling_iterations << " untangle " << result.number_of_inverted_cells_at_start
            << " cells; energy " << result.energy << std::endl;
  return result.status == VMP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
