#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_GRID_PROBLEM_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_GRID_PROBLEM_H

#include "jittered_grid.h"

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Cell_packs_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

// A jittered grid in the arrays of the solver, and a map of it: the regular grid, bent.
struct Grid_problem
{
  using Mesh = CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3;
  using Cells = CGAL::Volume_mesh_parameterization::internal::Scaled_cells_3;
  using Matrix = CGAL::Volume_mesh_parameterization::Block_sparse_matrix_3<float>;
  using Packs = CGAL::Volume_mesh_parameterization::internal::Cell_packs_3;

  explicit Grid_problem(const std::size_t n)
    : mesh(make_mesh(Jittered_grid(n))),
      cells{ 1, scaled_inverse_sources(mesh, 1), cell_weights(mesh) },
      packs(make_packs(mesh, cells, hessian)),
      u(bent(mesh.source)),
      gradient(3, mesh.number_of_free_vertices)
  {}

  Mesh mesh;
  Cells cells;
  Matrix hessian;
  Packs packs;
  CGAL::Volume_mesh_parameterization::internal::Matrix3Xd u, gradient;

private:
  static Mesh make_mesh(const Jittered_grid& grid)
  {
    const auto& points = grid.soup().points;
    Eigen::Matrix3Xd source(3, points.size());
    std::vector<bool> is_prescribed;
    for(std::size_t v = 0; v < points.size(); ++v)
    {
      source.col(v) = Eigen::Vector3d(points[v].data());
      is_prescribed.push_back(grid.is_on_boundary(v));
    }
    std::vector<std::array<int, 4> > cells;
    for(const auto& cell : grid.soup().cells)
      cells.push_back({int(cell[0]), int(cell[1]), int(cell[2]), int(cell[3])});

    return CGAL::Volume_mesh_parameterization::internal::ordered_mesh_3(cells, source, is_prescribed).first;
  }

  static Eigen::Matrix3Xd bent(const Eigen::Matrix3Xd& points)
  {
    Eigen::Matrix3Xd result = points;
    for(int i = 0; i < 3; ++i)
      result.row(i) += 0.2 * points.row((i + 1) % 3).cwiseAbs2();
    return result;
  }

  static Packs make_packs(const Mesh& mesh, const Cells& cells, Matrix& hessian)
  {
    const auto unknowns = free_vertices(mesh);
    auto pattern = sparsity_pattern_3(mesh, unknowns);
    Packs packs(mesh, cells, unknowns, pattern);
    hessian.set_pattern(std::move(pattern.row_begin), std::move(pattern.columns));
    return packs;
  }
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_GRID_PROBLEM_H
