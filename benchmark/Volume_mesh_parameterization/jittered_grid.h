#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_JITTERED_GRID_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_JITTERED_GRID_H

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

using CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3;

// The cube [-1, 1]^3 as n^3 small cubes of six tetrahedra each. Interior vertices are moved at random
// by up to 0.15 of the grid's width in each direction: below 1/6 no cell can be inverted.
class Jittered_grid
{
public:
  explicit Jittered_grid(const std::size_t n) : m_n(n)
  {
    for(std::size_t i = 0; i <= n; ++i)
      for(std::size_t j = 0; j <= n; ++j)
        for(std::size_t k = 0; k <= n; ++k)
          add_point({i, j, k});
    m_soup.cells.reserve(6 * n * n * n);
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; j < n; ++j)
        for(std::size_t k = 0; k < n; ++k)
          add_cells({i, j, k});
    m_soup.cell_references.assign(m_soup.cells.size(), 1);
  }

  const Tetrahedron_soup_3& soup() const { return m_soup; }

  bool is_on_boundary(const std::size_t vertex) const
  {
    const std::size_t m = m_n + 1;
    return is_on_boundary(Triple{vertex / (m * m), vertex / m % m, vertex % m});
  }

private:
  using Triple = std::array<std::size_t, 3>;

  bool is_on_boundary(const Triple& t) const
  {
    return std::any_of(t.begin(), t.end(), [&](std::size_t i) { return i == 0 || i == m_n; });
  }

  // Returns numbers that are equal on all platforms, which the distributions of the standard library do not promise.
  double random_between_minus_one_and_one()
  {
    return 2 * (static_cast<double>(m_random() >> 11) / 9007199254740992.) - 1; // 2^53
  }

  void add_point(const Triple& t)
  {
    const double width = 2. / static_cast<double>(m_n);
    std::array<double, 3> p;
    for(int i = 0; i < 3; ++i)
    {
      p[i] = width * static_cast<double>(t[i]) - 1;
      if(!is_on_boundary(t))
        p[i] += 0.15 * width * random_between_minus_one_and_one();
    }
    m_soup.points.push_back(p);
  }

  // One cell for each path along three edges from a corner of the small cube to the opposite one.
  void add_cells(const Triple& corner)
  {
    const std::size_t m = m_n + 1;
    const Triple strides = {m * m, m, 1};
    std::array<int, 3> axes = {0, 1, 2};
    do
    {
      std::array<std::size_t, 4> cell = {(corner[0] * m + corner[1]) * m + corner[2], 0, 0, 0};
      for(int i = 0; i < 3; ++i)
        cell[i + 1] = cell[i] + strides[axes[i]];
      const bool is_even = (axes[1] - axes[0] + 3) % 3 == 1;
      if(!is_even)
        std::swap(cell[2], cell[3]);
      m_soup.cells.push_back(cell);
    }
    while(std::next_permutation(axes.begin(), axes.end()));
  }

  std::size_t m_n;
  std::mt19937_64 m_random{1};
  Tetrahedron_soup_3 m_soup;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_JITTERED_GRID_H
