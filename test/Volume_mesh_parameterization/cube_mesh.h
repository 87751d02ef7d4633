// A cube cut into tetrahedra, as numbered arrays and as a soup.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CUBE_MESH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CUBE_MESH_H

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Numbered_mesh_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

// The cube [0, n]^3, cut into n^3 unit cubes of six tetrahedra each, with the identity as target.
// Vertices inside are moved by up to `jitter` in each direction; below 0.2 no cell is inverted.
inline CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3 cube_mesh(const int n, const double jitter = 0)
{
  CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3 mesh;
  mesh.source.resize(3, (n + 1) * (n + 1) * (n + 1));
  std::mt19937 engine;
  std::uniform_real_distribution<double> noise(-jitter, jitter);

  std::vector<int> number(mesh.source.cols());
  const auto index = [&](const Eigen::Vector3i& p) { return (p[0] * (n + 1) + p[1]) * (n + 1) + p[2]; };
  int next = 0;
  for(const bool is_on_boundary : {false, true})
  {
    for(int x = 0; x <= n; ++x)
      for(int y = 0; y <= n; ++y)
        for(int z = 0; z <= n; ++z)
        {
          const Eigen::Vector3i p(x, y, z);
          if((p.minCoeff() == 0 || p.maxCoeff() == n) != is_on_boundary)
            continue;
          mesh.source.col(next) = p.cast<double>();
          if(!is_on_boundary)
            mesh.source.col(next) += Eigen::Vector3d(noise(engine), noise(engine), noise(engine));
          number[index(p)] = next++;
        }
    if(!is_on_boundary)
      mesh.number_of_free_vertices = next;
  }
  mesh.target = mesh.source;

  // the paths along edges of a unit cube from its first corner to the opposite one
  for(int cube = 0; cube < n * n * n; ++cube)
  {
    std::array<int, 3> axes = {0, 1, 2};
    do
    {
      Eigen::Vector3i p(cube / (n * n), cube / n % n, cube % n);
      std::array<int, 4> cell;
      cell[0] = number[index(p)];
      for(int i = 0; i < 3; ++i)
      {
        ++p[axes[i]];
        cell[i + 1] = number[index(p)];
      }
      const bool is_even = (axes[0] < axes[1]) ^ (axes[1] < axes[2]) ^ (axes[0] < axes[2]);
      if(!is_even)
        std::swap(cell[2], cell[3]);
      mesh.cells.push_back(cell);
    }
    while(std::next_permutation(axes.begin(), axes.end()));
  }
  return mesh;
}

// The source as a soup, with the vertices in the same order.
inline CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3
source_soup(const CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3& mesh)
{
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 soup;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    soup.points.push_back({mesh.source(0, v), mesh.source(1, v), mesh.source(2, v)});
  for(const std::array<int, 4>& cell : mesh.cells)
  {
    std::array<std::size_t, 4> indices;
    std::copy(cell.begin(), cell.end(), indices.begin());
    soup.cells.push_back(indices);
  }
  soup.cell_references.assign(soup.cells.size(), 1);
  return soup;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CUBE_MESH_H
