#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_GRID_PROBLEM_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_GRID_PROBLEM_H

#include "jittered_grid.h"

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/spatial_order_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Cell_packs_3.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <vector>

// A jittered grid in the arrays of the solver, and a map of it: the regular grid, bent.
struct Grid_problem
{
  using Mesh = CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3;
  using Matrix = CGAL::Volume_mesh_parameterization::Block_sparse_matrix_3<float>;
  using Packs = CGAL::Volume_mesh_parameterization::internal::Cell_packs_3;

  explicit Grid_problem(const std::size_t n)
    : mesh(make_mesh(Jittered_grid(n))),
      inverse_sources(make_inverse_sources(mesh)),
      packs(make_packs(mesh, inverse_sources, hessian)),
      u(mesh.target),
      gradient(3, mesh.number_of_free_vertices)
  {}

  Mesh mesh;
  std::vector<Eigen::Matrix3d> inverse_sources;
  Matrix hessian;
  Packs packs;
  Eigen::Matrix3Xd u, gradient;

private:
  static Mesh make_mesh(const Jittered_grid& grid)
  {
    const auto& points = grid.soup().points;
    std::vector<int> numbers(points.size());
    int number = 0;
    for(const bool is_on_boundary : {false, true})
    {
      for(std::size_t v = 0; v < points.size(); ++v)
        if(grid.is_on_boundary(v) == is_on_boundary)
          numbers[v] = number++;
    }

    Mesh mesh;
    mesh.source.resize(3, number);
    mesh.target.resize(3, number);
    for(std::size_t v = 0; v < points.size(); ++v)
    {
      const auto& [x, y, z] = points[v];
      mesh.source.col(numbers[v]) << x, y, z;
      mesh.target.col(numbers[v]) << x + 0.2 * y * y, y + 0.2 * z * z, z + 0.2 * x * x;
      mesh.number_of_free_vertices += !grid.is_on_boundary(v);
    }
    for(const auto& cell : grid.soup().cells)
      mesh.cells.push_back({numbers[cell[0]], numbers[cell[1]], numbers[cell[2]], numbers[cell[3]]});
    using namespace CGAL::Volume_mesh_parameterization::internal;
    return reordered(mesh, spatial_order_3(mesh));
  }

  static std::vector<Eigen::Matrix3d> make_inverse_sources(const Mesh& mesh)
  {
    std::vector<Eigen::Matrix3d> result;
    for(const std::array<int, 4>& cell : mesh.cells)
      result.push_back(CGAL::Volume_mesh_parameterization::internal::edge_matrix(mesh.source, cell).inverse());
    return result;
  }

  static Packs make_packs(const Mesh& mesh, const std::vector<Eigen::Matrix3d>& inverse_sources, Matrix& hessian)
  {
    CGAL::Volume_mesh_parameterization::internal::set_pattern(mesh, {}, hessian);
    const std::vector<double> weights(mesh.cells.size(), 1. / static_cast<double>(mesh.cells.size()));
    return Packs(mesh, inverse_sources, weights, hessian);
  }
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_GRID_PROBLEM_H
