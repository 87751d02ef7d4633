// Balls of voxels with winding arms, slits and cavities. They grow voxel by voxel, such that a map to each ball exists.
#include "catch.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

namespace {

using Voxel = std::array<int, 3>;
using Points = std::vector<std::array<double, 3> >;
using Cells = std::vector<std::array<std::size_t, 4> >;

// Do the facets that a new voxel shares with others form a disc, which contains all vertices and edges that it shares?
bool touches_in_disc(const std::set<Voxel>& voxels, const Voxel& c)
{
  int euler_characteristic = 0;
  for(int code = 0; code < 27; ++code)
  {
    const Voxel d = { code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1 }; // the direction of a facet, edge or vertex
    const auto n = 3 - std::count(d.begin(), d.end(), 0);
    bool is_shared = false, is_in_shared_facet = false;
    for(int subset = 1; subset < 8; ++subset)
    {
      Voxel e = { 0, 0, 0 };
      for(int i = 0; i < 3; ++i)
        if(subset & (1 << i))
          e[i] = d[i];
      const auto m = 3 - std::count(e.begin(), e.end(), 0);
      const bool is_there = m > 0 && voxels.count({ c[0] + e[0], c[1] + e[1], c[2] + e[2] }) > 0;
      is_shared = is_shared || is_there;
      is_in_shared_facet = is_in_shared_facet || (is_there && m == 1);
    }
    if(is_shared && !is_in_shared_facet)
      return false;
    if(is_in_shared_facet)
      euler_characteristic += n == 2 ? -1 : 1;
  }
  return euler_characteristic == 1;
}

// Nearly all steps grow at one of the newest voxels, which makes arms.
std::set<Voxel> winding_voxels(const unsigned int seed, const std::size_t number, const int size)
{
  std::minstd_rand engine(seed);
  std::set<Voxel> voxels;
  std::vector<Voxel> candidates(1, Voxel{ size / 2, size / 2, size / 2 });
  while(voxels.size() < number && !candidates.empty())
  {
    const std::size_t n = candidates.size();
    const std::size_t i = engine() % 20 == 0 ? engine() % n : n - 1 - engine() % (std::min)(n, std::size_t(4));
    const Voxel c = candidates[i];
    candidates.erase(candidates.begin() + i);
    const auto is_inside = [&](const int x) { return 0 <= x && x < size; };
    if(!std::all_of(c.begin(), c.end(), is_inside) || voxels.count(c) > 0 || (!voxels.empty() && !touches_in_disc(voxels, c)))
      continue;
    voxels.insert(c);
    for(int axis = 0; axis < 3; ++axis)
      for(const int step : { -1, 1 })
      {
        candidates.push_back(c);
        candidates.back()[axis] += step;
      }
  }
  return voxels;
}

// Six tetrahedra in each voxel.
std::pair<Points, Cells> tetrahedra(const std::set<Voxel>& voxels)
{
  std::pair<Points, Cells> result;
  std::map<Voxel, std::size_t> numbers;
  const auto number = [&](const Voxel& p)
  {
    const auto [found, is_new] = numbers.emplace(p, numbers.size());
    if(is_new)
      result.first.push_back({ 1. * p[0], 1. * p[1], 1. * p[2] });
    return found->second;
  };
  for(const Voxel& voxel : voxels)
  {
    std::array<int, 3> axes = { 0, 1, 2 };
    do
    {
      Voxel p = voxel;
      std::array<std::size_t, 4> cell = { number(p) };
      for(int i = 0; i < 3; ++i)
      {
        ++p[axes[i]];
        cell[i + 1] = number(p);
      }
      if((axes[1] - axes[0] + 3) % 3 != 1)
        std::swap(cell[2], cell[3]);
      result.second.push_back(cell);
    }
    while(std::next_permutation(axes.begin(), axes.end()));
  }
  return result;
}

// Maps a body to the ball, and returns the number of its cells before.
std::size_t check_map_to_ball(const unsigned int seed, const std::size_t number_of_voxels, const int size)
{
  auto [points, cells] = tetrahedra(winding_voxels(seed, number_of_voxels, size));
  const std::size_t number_of_cells = cells.size();
  Points images;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    points, cells, images, CGAL::parameters::refinement_mode(VMP::Refinement_mode::BOUNDARY)
                             .boundary_mode(VMP::Boundary_mode::FIXED));
  CHECK(result.status == VMP::OK);
  CHECK(result.boundary_residual == 0);
  CHECK(images.size() == points.size());
  return number_of_cells;
}

} // namespace

TEST_CASE("Small bodies with winding arms are mapped to the ball, as whole meshes untangle what patches and splits leave")
{
  for(const unsigned int seed : { 1, 3, 5 })
  {
    CAPTURE(seed);
    CHECK(check_map_to_ball(seed, 200, 14) == 1200);
  }
}

TEST_CASE("A body of which untangling leaves cells inverted is mapped to the ball once these have vertices of their own")
{
  CHECK(check_map_to_ball(9, 200, 18) == 1200);
}
