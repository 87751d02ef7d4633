// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_ALIGNMENT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_ALIGNMENT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>

#include <Eigen/Dense>

namespace CGAL::Volume_mesh_parameterization::internal {

// The similarity that takes points nearest to their images, by the sum of squared distances. Keeps every orientation: the
// rotation is proper and the scale positive. (The closed form is due to Umeyama 1991.) With a scale, this is taken. Where points
// leave a rotation open, as those on a line do, it is turned as little as possible if the regularization is not 0.
template <typename Points, typename Images>
Similarity_3 similarity_of_points_3(const Points& source, const Images& target, const std::optional<double> scale = {},
                                    const double regularization = 0)
{
  Similarity_3 result;
  if(source.cols() == 0)
    return result;
  const Eigen::Vector3d source_mean = source.rowwise().mean(), target_mean = target.rowwise().mean();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double variance = 0;
  for(Eigen::Index i = 0; i < source.cols(); ++i)
  {
    const Eigen::Vector3d x = source.col(i) - source_mean;
    covariance += (target.col(i) - target_mean) * x.transpose();
    variance += x.squaredNorm();
  }
  covariance += regularization * covariance.norm() * Eigen::Matrix3d::Identity();
  const Rotation_and_stretch_3 polar = rotation_and_stretch_3(covariance);
  const double best_scale = polar.stretch / variance;
  if(best_scale > 0) // without a correlation of source and target the best scale would be zero
    result = { scale.value_or(best_scale), polar.rotation, source_mean, target_mean };
  else if(scale)
    result = { *scale, Eigen::Matrix3d::Identity(), source_mean, target_mean };
  return result;
}

// The source, moved by the similarity that takes its prescribed vertices nearest to their targets. (Jin et al. minimize the same
// sum over 13 variables with a penalty that makes the matrix nearly a scaled rotation, and round the result.)
inline Matrix3Xd similarity_alignment_3(const Numbered_mesh_3& mesh)
{
  const Eigen::Index n = mesh.number_of_prescribed_vertices();
  return moved(mesh.alignment ? *mesh.alignment
                              : similarity_of_points_3(mesh.source.rightCols(n), mesh.target.rightCols(n)), mesh.source);
}

// The vertices that stay at their targets.
inline std::vector<int> fixed_vertices(const Numbered_mesh_3& mesh)
{
  std::vector<int> result;
  for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
    if(mesh.is_fixed(v))
      result.push_back(v);
  return result;
}

// By what edges between vertices at their targets are stretched, the median; nothing, if there is no such edge. A body that
// is held at some facets keeps its size, however far these are from each other.
inline std::optional<double> stretch_of_prescribed_edges_3(const Numbered_mesh_3& mesh)
{
  std::vector<double> stretches;
  for(const std::array<int, 4>& cell : mesh.cells)
    for(const int v : cell)
      for(const int w : cell)
        if(v < w && mesh.is_fixed(v) && mesh.is_fixed(w))
        {
          const double stretch = (mesh.target.col(w) - mesh.target.col(v)).stableNorm()
                                 / (mesh.source.col(w) - mesh.source.col(v)).stableNorm();
          if(stretch > 0 && std::isfinite(stretch))
            stretches.push_back(stretch);
        }
  if(stretches.empty())
    return std::nullopt;
  const auto median = stretches.begin() + stretches.size() / 2;
  std::nth_element(stretches.begin(), median, stretches.end());
  return *median;
}

using Vector_7 = Eigen::Matrix<double, 7, 1>;
using Matrix_7 = Eigen::Matrix<double, 7, 7>;

// Solves A x = b by Jacobi rotations, for a symmetric matrix without negative eigenvalues. The solution has no part in the
// directions in which A vanishes. Eigen's own solver allocates memory by the flags of a unit.
inline Vector_7 least_solution_7(Matrix_7 A, const Vector_7& b)
{
  constexpr int maximal_number_of_sweeps = 30; // a guess; convergence is quadratic
  Matrix_7 directions = Matrix_7::Identity();
  for(int sweep = 0; sweep < maximal_number_of_sweeps; ++sweep)
    for(int p = 0; p < 7; ++p)
      for(int q = p + 1; q < 7; ++q)
      {
        Eigen::JacobiRotation<double> rotation;
        if(!rotation.makeJacobi(A, p, q))
          continue;
        A.applyOnTheLeft(p, q, rotation.adjoint());
        A.applyOnTheRight(p, q, rotation);
        directions.applyOnTheRight(p, q, rotation);
      }
  Vector_7 x = directions.transpose() * b;
  const double largest = A.diagonal().maxCoeff();
  for(int i = 0; i < 7; ++i)
    x[i] = A(i, i) > 1e-9 * largest ? x[i] / A(i, i) : 0;
  return directions * x;
}

// Moves a body by Gauss-Newton steps such that its prescribed vertices come nearest to their targets, planes and lines. What
// these leave open does not change. Returns the sum of the squared distances.
inline double fit_to_conditions_3(const Numbered_mesh_3& mesh, const bool has_scale, Similarity_3& similarity)
{
  constexpr int maximal_number_of_steps = 50; // a guess
  const int n = mesh.number_of_vertices(), first = mesh.number_of_free_vertices;
  const double radius = std::sqrt((mesh.source.colwise() - similarity.source_center).colwise().squaredNorm().mean());
  double squares = 0;
  for(int step = 0; step < maximal_number_of_steps; ++step)
  {
    Matrix_7 A = Matrix_7::Zero();
    Vector_7 b = Vector_7::Zero(); // for a rotation, the logarithm of the scale, and a translation
    const double unit = similarity.scale * radius; // of translations
    squares = 0;
    for(int v = first; v < n; ++v)
    {
      const Eigen::Vector3d y = similarity(mesh.source.col(v)), x = y - similarity.image_center;
      const Eigen::Matrix3d Q = Eigen::Matrix3d::Identity() - mesh.projector(v);
      Eigen::Matrix<double, 3, 7> J;
      J << Eigen::Vector3d::UnitX().cross(x), Eigen::Vector3d::UnitY().cross(x), Eigen::Vector3d::UnitZ().cross(x),
           (has_scale ? 1. : 0.) * x, unit * Eigen::Matrix3d::Identity();
      const Eigen::Vector3d r = Q * (y - mesh.target.col(v));
      A += J.transpose() * Q * J;
      b -= J.transpose() * r;
      squares += r.squaredNorm();
    }
    Vector_7 d = least_solution_7(A, b);
    if(!(d.norm() > 1e-12))
      break;
    d *= (std::min)(1., 0.5 / d.head<4>().norm()); // no turn is larger than half a radian
    similarity.scale *= std::exp(d[3]);
    if(const double angle = d.head<3>().norm(); angle > 0)
      similarity.rotation = Eigen::AngleAxisd(angle, d.head<3>() / angle) * similarity.rotation;
    similarity.image_center += unit * d.tail<3>();
  }
  return squares;
}

// The similarity that takes the source nearest to what is prescribed. The scale is that of edges between vertices at their
// targets. If there are none, four conditions tell one; otherwise it is 1. Where planes and lines leave the body upside
// down, it is turned over.
inline Similarity_3 alignment_3(const Numbered_mesh_3& mesh)
{
  const std::vector<int> fixed = fixed_vertices(mesh);
  std::optional<double> scale = stretch_of_prescribed_edges_3(mesh);
  if(!scale && mesh.number_of_prescribed_vertices() < 4)
    scale = 1;
  Matrix3Xd source(3, fixed.size()), target(3, fixed.size());
  for(std::size_t i = 0; i < fixed.size(); ++i)
  {
    source.col(i) = mesh.source.col(fixed[i]);
    target.col(i) = mesh.target.col(fixed[i]);
  }
  constexpr double regularization = 1e-9;
  Similarity_3 start = similarity_of_points_3(source, target, fixed.size() < 4 ? scale.value_or(1) : scale, regularization);
  if(mesh.projectors.empty())
    return start;
  if(fixed.empty())
    start.source_center = start.image_center = mesh.source.rowwise().mean();
  Similarity_3 best = start;
  double fewest_squares = std::numeric_limits<double>::infinity();
  for(int turn = 0; turn < 4; ++turn)
  {
    Similarity_3 similarity = start;
    if(turn > 0)
      similarity.rotation = Eigen::Vector3d(2 * Eigen::Vector3d::Unit(turn - 1) - Eigen::Vector3d::Ones()).asDiagonal()
                            * similarity.rotation;
    const double squares = fit_to_conditions_3(mesh, !scale, similarity);
    if(!(squares < 0.9 * fewest_squares)) // a turn has to pay off
      continue;
    fewest_squares = squares;
    best = similarity;
  }
  return best;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_ALIGNMENT_3_H
