// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors


#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_COLUMNS_AROUND_ORIGIN_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_COLUMNS_AROUND_ORIGIN_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// A point of the convex hull of the columns of a matrix, as a combination of affinely independent columns.
struct Hull_point
{
  Eigen::VectorXd point;
  std::vector<Eigen::Index> columns;
  std::vector<double> weights;
};

// The weights, with sum 1, of the point next to the origin in the affine hull of some columns: the solution of least
// squares of the system with a row of ones added, whose right side is 1 there and 0 elsewhere. By Gram and Schmidt's
// modified method, which is stable with the right side as a further column, and small to compile.
inline Eigen::VectorXd nearest_point_of_affine_hull(const Eigen::MatrixXd& points,
                                                    const std::vector<Eigen::Index>& columns)
{
  const Eigen::Index n = static_cast<Eigen::Index>(columns.size()), rows = points.rows() + 1;
  Eigen::MatrixXd Q(rows, n + 1), R = Eigen::MatrixXd::Zero(n, n + 1);
  for(Eigen::Index j = 0; j < n; ++j)
    Q.col(j) << 1, points.col(columns[j]);
  Q.col(n) = Eigen::VectorXd::Unit(rows, 0);
  for(Eigen::Index j = 0; j < n; ++j)
  {
    R(j, j) = Q.col(j).norm();
    Q.col(j) /= R(j, j);
    for(Eigen::Index k = j + 1; k <= n; ++k)
    {
      R(j, k) = Q.col(j).dot(Q.col(k));
      Q.col(k) -= R(j, k) * Q.col(j);
    }
  }
  Eigen::VectorXd weights = R.col(n);
  for(Eigen::Index j = n - 1; j >= 0; --j)
  {
    weights[j] /= R(j, j);
    weights.head(j) -= weights[j] * R.col(j).head(j);
  }
  return weights / weights.sum();
}

// Moves towards the point next to the origin in the affine hull until a weight vanishes, and drops its column.
// Returns whether that point was reached.
inline bool move_in_affine_hull(const Eigen::MatrixXd& points, Hull_point& p)
{
  const Eigen::VectorXd goal = nearest_point_of_affine_hull(points, p.columns);
  double step = 1;
  for(std::size_t i = 0; i < p.columns.size(); ++i)
    if(goal[i] <= 0)
      step = (std::min)(step, p.weights[i] / (p.weights[i] - goal[i]));

  const double smallest_weight = 1e-14;
  Hull_point next;
  next.point.setZero(points.rows());
  for(std::size_t i = 0; i < p.columns.size(); ++i)
  {
    const double weight = (1 - step) * p.weights[i] + step * goal[i];
    if(weight < smallest_weight)
      continue;
    next.columns.push_back(p.columns[i]);
    next.weights.push_back(weight);
    next.point += weight * points.col(p.columns[i]);
  }
  p = next;
  return step == 1;
}

// The smallest scalar product of a vector with a column, and which column that is.
inline double smallest_product(const Eigen::MatrixXd& points, const Eigen::VectorXd& vector, Eigen::Index& column)
{
  column = 0;
  for(Eigen::Index i = 1; i < points.cols(); ++i)
    if(points.col(i).dot(vector) < points.col(column).dot(vector))
      column = i;
  return points.col(column).dot(vector);
}

// Columns, of at most unit length, whose convex hull contains the origin up to rounding; none if there is a
// vector that has positive scalar products with all columns.
// Looks for the point of the convex hull next to the origin (Wolfe, Finding the nearest point in a polytope,
// Mathematical Programming 11, 1976), which is such a vector unless it is the origin.
inline std::vector<Eigen::Index> columns_around_origin(const Eigen::MatrixXd& points)
{
  const double tolerance = 1e-12;
  Eigen::Index column;
  points.colwise().squaredNorm().minCoeff(&column);
  Hull_point p = { points.col(column), {column}, {1.} };
  for(Eigen::Index iteration = 0; iteration < 10 * points.cols(); ++iteration)
  {
    const double norm = p.point.norm();
    if(smallest_product(points, p.point, column) > tolerance * norm)
      return {};
    if(norm < tolerance || std::find(p.columns.begin(), p.columns.end(), column) != p.columns.end())
      break;
    p.columns.push_back(column);
    p.weights.push_back(0);
    while(!move_in_affine_hull(points, p)) {}
  }
  return p.columns;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_COLUMNS_AROUND_ORIGIN_H
