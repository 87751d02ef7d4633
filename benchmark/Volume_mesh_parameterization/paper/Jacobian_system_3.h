#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_JACOBIAN_SYSTEM_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_JACOBIAN_SYSTEM_3_H

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>

#include <Eigen/CholmodSupport>
#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

// The linear part of methods that prescribe the Jacobians of the cells: finds the positions whose
// Jacobians are nearest to given ones, with the weights of the cells that the mesh asks for and the
// boundary fixed. The matrix, the Laplacian, is factorized once.
//
// The Jacobians of all cells form one matrix of three rows; multiplied by the square root of the weight
// of the cell, so that inner products of such matrices are those of the weighted problem.
class Jacobian_system_3
{
public:
  using Mesh = CGAL::Volume_mesh_parameterization::internal::Numbered_mesh_3;
  using Positions = Eigen::Matrix3Xd;
  using Jacobians = Eigen::Matrix3Xd;

  explicit Jacobian_system_3(const Mesh& mesh)
    : m_number_of_free_vertices(mesh.number_of_free_vertices),
      m_weights(cell_weights(mesh)),
      m_gradients(gradients(mesh)),
      m_prescribed(mesh.target.rightCols(mesh.number_of_vertices() - m_number_of_free_vertices)),
      m_of_prescribed(m_prescribed * m_gradients.bottomRows(m_prescribed.cols())),
      m_of_free(m_gradients.topRows(m_number_of_free_vertices))
  {
    m_factorization.compute(m_of_free * m_of_free.transpose());
    if(m_factorization.info() != Eigen::Success)
      throw std::runtime_error("the Laplacian is not positive definite");
  }

  double weight(const std::size_t cell) const { return m_weights[cell]; }

  // Returns the weighted Jacobians of a map.
  Jacobians jacobians(const Positions& u) const { return u * m_gradients; }

  // Returns the map with the prescribed boundary whose Jacobians are nearest to the ones passed.
  Positions fit(const Jacobians& jacobians) const
  {
    Positions u(3, m_number_of_free_vertices + m_prescribed.cols());
    u << solve(jacobians - m_of_prescribed), m_prescribed;
    return u;
  }

  // Returns the displacement with nearest Jacobians, which leaves the boundary alone.
  Positions fit_displacement(const Jacobians& jacobians) const
  {
    Positions u = Positions::Zero(3, m_number_of_free_vertices + m_prescribed.cols());
    u.leftCols(m_number_of_free_vertices) = solve(jacobians);
    return u;
  }

private:
  using Matrix = Eigen::SparseMatrix<double>;

  // Column 3 t + i holds the derivatives of the hat functions in cell t by the i-th coordinate.
  Matrix gradients(const Mesh& mesh) const
  {
    using CGAL::Volume_mesh_parameterization::internal::edge_matrix;
    std::vector<Eigen::Triplet<double> > entries;
    for(std::size_t t = 0; t < mesh.cells.size(); ++t)
    {
      const Eigen::Matrix3d X = edge_matrix(mesh.source, mesh.cells[t]);
      const Eigen::Matrix3d inverse = std::sqrt(m_weights[t]) * X.inverse();
      for(int i = 0; i < 3; ++i)
      {
        const int column = static_cast<int>(3 * t) + i;
        entries.emplace_back(mesh.cells[t][0], column, -inverse.col(i).sum());
        for(int a = 0; a < 3; ++a)
          entries.emplace_back(mesh.cells[t][a + 1], column, inverse(a, i));
      }
    }
    Matrix result(mesh.number_of_vertices(), 3 * static_cast<Eigen::Index>(mesh.cells.size()));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Eigen::MatrixXd solve(const Jacobians& jacobians) const
  {
    const Eigen::MatrixXd right_side = m_of_free * jacobians.transpose();
    return m_factorization.solve(right_side).transpose();
  }

  int m_number_of_free_vertices;
  std::vector<double> m_weights;
  Matrix m_gradients;
  Positions m_prescribed;
  Jacobians m_of_prescribed;
  Matrix m_of_free;
  Eigen::CholmodSupernodalLLT<Matrix> m_factorization;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_JACOBIAN_SYSTEM_3_H
