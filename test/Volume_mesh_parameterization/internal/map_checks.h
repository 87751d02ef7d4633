// Helpers of the tests of maps on plain arrays.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_MAP_CHECKS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_MAP_CHECKS_H

#include "cube_mesh.h"
#include "fixed_boundary.h"

#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>

#include <CGAL/tags.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::Matrix3d;
using CGAL::Volume_mesh_parameterization::internal::Matrix3Xd;
using Eigen::Vector3d;
using VMP::internal::Numbered_mesh_3;

template <typename Tag = CGAL::Sequential_tag>
using Solver = VMP::Conjugate_gradient_solver_traits_3<Tag>;

inline Matrix3Xd noise(const Eigen::Index size, const double amplitude, const unsigned int seed = 0)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> distribution(-amplitude, amplitude);
  return Matrix3Xd::NullaryExpr(3, size, [&]() { return distribution(engine); });
}

template <typename Energy>
double psi(const Energy& energy, const Numbered_mesh_3& mesh, const Matrix3Xd& u, const std::array<int, 4>& cell,
           const double scale = 1)
{
  const Matrix3d J = scale * VMP::internal::edge_matrix(u, cell)
                   * VMP::internal::edge_matrix(mesh.source, cell).inverse();
  Vector3d s = Eigen::JacobiSVD<Matrix3d, Eigen::NoQRPreconditioner>(J).singularValues();
  s[2] = std::copysign(s[2], J.determinant());
  return energy.value(s);
}

// The mean over the cells as a stage reports it: both meshes scaled to one volume.
template <typename Energy>
double mean_energy(const Energy& energy, const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  const double scale = std::cbrt(VMP::internal::volume(mesh, mesh.source)
                                 / VMP::internal::volume(mesh, mesh.target));
  double sum = 0;
  for(const std::array<int, 4>& cell : mesh.cells)
    sum += psi(energy, mesh, u, cell, scale);
  return sum / static_cast<double>(mesh.cells.size());
}

inline std::size_t number_of_inverted_cells(const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  return VMP::internal::inverted_cells(mesh, u).number;
}

inline bool has_same_bits(const Matrix3Xd& a, const Matrix3Xd& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

inline bool has_target_boundary(const Numbered_mesh_3& mesh, const Matrix3Xd& u)
{
  const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
  return has_same_bits(Matrix3Xd(u.rightCols(n)), Matrix3Xd(mesh.target.rightCols(n)));
}

using fixed_boundary::Outcome;

template <typename Energy, typename Solver>
Outcome run(const Numbered_mesh_3& mesh, const Energy& energy, Solver solver)
{
  return fixed_boundary::run(mesh, energy, solver);
}

template <typename Energy = VMP::Stretch_energy_3>
Outcome run(const Numbered_mesh_3& mesh, const Energy& energy = Energy())
{
  return run(mesh, energy, Solver<>());
}

// Many steps, and no end.
inline VMP::internal::Progress_3 patient_progress() { return VMP::internal::Progress_3(VMP::internal::Budget(), 1000); }

inline std::vector<VMP::internal::Matrix_3> inverse_sources(const Numbered_mesh_3& mesh)
{
  std::vector<VMP::internal::Matrix_3> result;
  for(const std::array<int, 4>& cell : mesh.cells)
    result.push_back(VMP::internal::edge_matrix(mesh.source, cell).inverse());
  return result;
}

// The free vertices that are nearest to the middle, and farthest from it.
inline std::array<Eigen::Index, 2> middle_and_corner(const Numbered_mesh_3& mesh)
{
  const Matrix3Xd inside = mesh.source.leftCols(mesh.number_of_free_vertices);
  const Eigen::RowVectorXd distances = (inside.colwise() - inside.rowwise().mean()).colwise().norm();
  std::array<Eigen::Index, 2> result;
  distances.minCoeff(&result[0]);
  distances.maxCoeff(&result[1]);
  return result;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_MAP_CHECKS_H
