// A cube cut into tetrahedra, as numbered arrays and as a soup.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CUBE_MESH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_CUBE_MESH_H

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

// The cube [0, n]^3, cut into n^3 unit cubes of six tetrahedra each, with the identity as target.
// Vertices inside are moved by up to `jitter` in each direction; below 0.2 no cell is inverted.
inline CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3
cube_mesh(const int n, const double jitter = 0)
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

// The cube [0, n]^3 with target f(source).
template <typename Function>
CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3
mapped_cube(const int n, const double jitter, const Function& f)
{
  auto mesh = cube_mesh(n, jitter);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    mesh.target.col(v) = f(Eigen::Vector3d(mesh.source.col(v)));
  mesh.target.leftCols(mesh.number_of_free_vertices).setZero();
  return mesh;
}

// Turns the cube about the z-axis, by an angle that grows with the height.
inline CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3
twisted_cube(const int n, const double jitter = 0)
{
  return mapped_cube(n, jitter, [n](const Eigen::Vector3d& p) -> Eigen::Vector3d
  {
    const Eigen::Vector3d center = Eigen::Vector3d::Constant(n / 2.);
    return center + Eigen::AngleAxisd(2 * p[2] / n, Eigen::Vector3d::UnitZ()) * (p - center);
  });
}

// Bends the cube to most of a ring: a harmonic map leaves it through the inner side.
inline CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3 ring(const int n)
{
  return mapped_cube(n, 0, [n](const Eigen::Vector3d& p) -> Eigen::Vector3d
  {
    const double angle = 5 * p[0] / n, radius = 0.5 + p[1] / n;
    return Eigen::Vector3d(radius * std::sin(angle), radius * std::cos(angle), p[2] / n);
  });
}

// A vertex in the middle, which is prescribed as the boundary is, is pulled aside; the boundary stays.
inline CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3
pulled_cube(const int n, const double jitter, const double distance)
{
  auto mesh = cube_mesh(n, jitter);
  const int last = --mesh.number_of_free_vertices;
  int middle = 0;
  (mesh.source.colwise() - Eigen::Vector3d::Constant(n / 2.)).colwise().norm().minCoeff(&middle);
  std::swap(mesh.source.col(middle), mesh.source.col(last));
  for(std::array<int, 4>& cell : mesh.cells)
    for(int& v : cell)
      v = v == middle ? last : (v == last ? middle : v);
  mesh.target = mesh.source;
  mesh.target(0, last) += distance;
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
