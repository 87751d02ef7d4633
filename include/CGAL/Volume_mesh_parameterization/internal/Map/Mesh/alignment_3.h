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

// Returns the similarity that takes points nearest to their images, by the sum of squared distances (Umeyama 1991). The rotation
// is proper and the scale positive; a given scale is kept. Points on a line leave a rotation open. If the regularization is not
// 0, the smallest one is chosen.
template <typename Points, typename Images>
Similarity_3 similarity_of_points_3(const Points& source, const Images& target, const std::optional<double> scale = {},
                                    const double regularization = 0)
{
  if(source.cols() == 0)
    return { scale.value_or(1) };
  Similarity_3 result;
  const Vector_3 source_mean = source.rowwise().mean(), target_mean = target.rowwise().mean();
  Matrix_3 covariance = Matrix_3::Zero();
  double variance = 0;
  for(Eigen::Index i = 0; i < source.cols(); ++i)
  {
    const Vector_3 x = source.col(i) - source_mean;
    covariance += Matrix_3::outer_product(target.col(i) - target_mean, x);
    variance += x.squaredNorm();
  }
  covariance += regularization * covariance.norm() * Matrix_3::Identity();
  const Rotation_and_stretch_3 polar = rotation_and_stretch_3(covariance);
  const double best_scale = polar.stretch / variance;
  if(best_scale > 0) // without a correlation of source and target the best scale would be zero
    result = { scale.value_or(best_scale), polar.rotation, source_mean, target_mean };
  else if(scale)
    result = { *scale, Matrix_3::Identity(), source_mean, target_mean };
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

// The median of ratios of distances, of those that are positive and finite; nothing, if there are none.
inline std::optional<double> median_ratio(std::vector<double> ratios)
{
  const auto end = std::remove_if(ratios.begin(), ratios.end(), [](const double r) { return !(r > 0 && std::isfinite(r)); });
  if(end == ratios.begin())
    return std::nullopt;
  const auto median = ratios.begin() + (end - ratios.begin()) / 2;
  std::nth_element(ratios.begin(), median, end);
  return *median;
}

// Returns the median factor by which edges between vertices at their targets are stretched. A body that is held at some facets
// keeps its size, however far these are from each other.
inline std::optional<double> stretch_of_prescribed_edges_3(const Numbered_mesh_3& mesh)
{
  std::vector<double> ratios;
  for(const std::array<int, 4>& cell : mesh.cells)
    for(const int v : cell)
      for(const int w : cell)
        if(v < w && mesh.is_fixed(v) && mesh.is_fixed(w))
          ratios.push_back(length_3(mesh.target.col(w) - mesh.target.col(v))
                           / length_3(mesh.source.col(w) - mesh.source.col(v)));
  return median_ratio(std::move(ratios));
}

// Returns the least factor by which conditions stretch the body, as a median over their vertices. For each vertex, the largest
// distance between its condition and another one counts, divided by the distance of the vertices in the source. So the thickness
// of a shell between two planes gives the scale, however it is curved. Skew lines count as if they met.
inline std::optional<double> stretch_between_conditions_3(const Numbered_mesh_3& mesh)
{
  constexpr int many_vertices = 300; // a guess: of more, some are compared with all
  const int first = mesh.number_of_free_vertices, n = mesh.number_of_vertices();
  std::vector<double> ratios;
  for(int v = first; v < n; v += 1 + mesh.number_of_prescribed_vertices() / many_vertices)
  {
    const Matrix_3 Q = Matrix_3::Identity() - mesh.projector(v);
    double largest = 0;
    for(int w = first; w < n; ++w)
    {
      const Matrix_3 both = Q - Q * mesh.projector(w); // onto what both prescribe, if the factors commute
      const double distance = length_3(mesh.source.col(w) - mesh.source.col(v));
      if(distance > 0 && Eigen::Matrix3d(both).isApprox(Eigen::Matrix3d(both.transpose())))
        largest = (std::max)(largest, (both * (mesh.target.col(w) - mesh.target.col(v))).norm() / distance);
    }
    ratios.push_back(largest);
  }
  return median_ratio(std::move(ratios));
}

// Returns the rotation about a vector by its length.
inline Matrix_3 rotation_3(const Vector_3& turn)
{
  const double angle = turn.norm();
  return angle > 0 ? Matrix_3(Eigen::AngleAxisd(angle, Eigen::Vector3d(turn / angle)).toRotationMatrix()) : Matrix_3::Identity();
}

using Vector_6 = Small_matrix<6, 1>;
using Matrix_6 = Small_matrix<6, 6>;

// Solves A x = b by conjugate gradients, for a symmetric matrix without negative eigenvalues. The solution has no part in the
// directions in which A vanishes.
inline Vector_6 least_solution_6(const Matrix_6& A, const Vector_6& b)
{
  constexpr int maximum_number_of_steps = 20; // six, but for rounding
  constexpr double tolerance = 1e-10;
  Vector_6 x = Vector_6::Zero(), r = b, p = b;
  for(int step = 0; step < maximum_number_of_steps && r.norm() > tolerance * b.norm(); ++step)
  {
    const Vector_6 Ap = A * p;
    const double squares = r.squaredNorm(), length = squares / p.dot(Ap);
    if(!(length > 0 && std::isfinite(length)))
      break;
    x += length * p;
    r -= length * Ap;
    p = r + r.squaredNorm() / squares * p;
  }
  return x;
}

// Moves a body rigidly by Gauss-Newton steps such that its prescribed vertices come nearest to their targets, planes and lines.
// Motions that these leave open are not made. Returns the sum of the squared distances.
inline double fit_to_conditions_3(const Numbered_mesh_3& mesh, Similarity_3& similarity)
{
  constexpr int maximum_number_of_steps = 50; // a guess
  const int n = mesh.number_of_vertices(), first = mesh.number_of_free_vertices;
  const Eigen::Vector3d center = similarity.source_center;
  const double radius = std::sqrt((mesh.source.colwise() - center).colwise().squaredNorm().mean());
  const double unit = similarity.scale * radius; // of translations
  double squares = 0;
  for(int step = 0; step < maximum_number_of_steps; ++step)
  {
    Matrix_6 A = Matrix_6::Zero();
    Vector_6 b = Vector_6::Zero(); // for a rotation and a translation
    squares = 0;
    for(int v = first; v < n; ++v)
    {
      const Eigen::Vector3d y = similarity(mesh.source.col(v)), x = y - Eigen::Vector3d(similarity.image_center);
      const Eigen::Matrix3d Q = Matrix_3::Identity() - mesh.projector(v);
      Small_matrix<3, 6> J;
      J << Eigen::Vector3d::UnitX().cross(x), Eigen::Vector3d::UnitY().cross(x), Eigen::Vector3d::UnitZ().cross(x),
           unit * Eigen::Matrix3d::Identity();
      const Eigen::Vector3d r = Q * (y - Eigen::Vector3d(mesh.target.col(v)));
      A += J.transpose() * Q * J;
      b -= J.transpose() * r;
      squares += r.squaredNorm();
    }
    Vector_6 d = least_solution_6(A, b);
    if(!(d.norm() > 1e-12))
      break;
    d *= (std::min)(1., 0.5 / d.head<3>().norm()); // no turn is larger than half a radian
    similarity.rotation = rotation_3({ d[0], d[1], d[2] }) * similarity.rotation;
    similarity.image_center += Vector_3(unit * d.tail<3>());
  }
  return squares;
}

// Returns the similarity that takes the source nearest to what is prescribed. Its scale comes from edges between vertices at their
// targets, or else from four such vertices, or from four conditions; otherwise it is 1. If planes and lines leave the body upside
// down, it is turned over.
inline Similarity_3 alignment_3(const Numbered_mesh_3& mesh)
{
  const std::vector<int> fixed = fixed_vertices(mesh);
  std::optional<double> scale = stretch_of_prescribed_edges_3(mesh);
  if(!scale && fixed.size() < 4)
    scale = mesh.number_of_prescribed_vertices() < 4 ? 1 : stretch_between_conditions_3(mesh).value_or(1);
  Matrix3Xd source(3, fixed.size()), target(3, fixed.size());
  for(std::size_t i = 0; i < fixed.size(); ++i)
  {
    source.col(i) = mesh.source.col(fixed[i]);
    target.col(i) = mesh.target.col(fixed[i]);
  }
  constexpr double regularization = 1e-9;
  Similarity_3 start = similarity_of_points_3(source, target, scale, regularization);
  if(mesh.conditions.empty())
    return start;
  if(fixed.empty())
    start.source_center = start.image_center = mesh.source.rowwise().mean();
  Similarity_3 best = start;
  double fewest_squares = std::numeric_limits<double>::infinity();
  for(int turn = 0; turn < 4; ++turn)
  {
    Similarity_3 similarity = start;
    if(turn > 0)
      similarity.rotation = Matrix_3::diagonal(2 * Vector_3::Unit(turn - 1) - Vector_3::Ones()) * similarity.rotation;
    const double squares = fit_to_conditions_3(mesh, similarity);
    if(!(squares < 0.9 * fewest_squares)) // a turn has to pay off
      continue;
    fewest_squares = squares;
    best = similarity;
  }
  return best;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_ALIGNMENT_3_H
