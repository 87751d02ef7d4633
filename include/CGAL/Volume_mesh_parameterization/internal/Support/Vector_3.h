// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_VECTOR_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_VECTOR_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// A vector of three numbers with the functions of Eigen's vectors, which return values: an expression of Eigen has a type of its
// own, and takes the compiler ten times as long. As with Eigen, numbers are not initialized.
class Vector_3
{
public:
  Vector_3() = default;
  Vector_3(const double x, const double y, const double z) : m_values{ x, y, z } {}
  template <typename Expression, typename = decltype(std::declval<const Expression&>().derived())>
  Vector_3(const Expression& v) { Eigen::Map<Eigen::Vector3d>{ m_values } = v; }
  operator Eigen::Vector3d() const { return Eigen::Vector3d(m_values); }

  static Vector_3 Constant(const double x) { return { x, x, x }; }
  static Vector_3 Zero() { return { 0, 0, 0 }; }
  static Vector_3 Ones() { return { 1, 1, 1 }; }
  static Vector_3 Unit(const int i) { return { double(i == 0), double(i == 1), double(i == 2) }; }

  double& operator[](const std::ptrdiff_t i) { return m_values[i]; }
  const double& operator[](const std::ptrdiff_t i) const { return m_values[i]; }
  double x() const { return m_values[0]; }
  double y() const { return m_values[1]; }
  double z() const { return m_values[2]; }
  const double* data() const { return m_values; }

  // f of each number
  template <typename Function>
  Vector_3 unaryExpr(const Function& f) const { return { f(x()), f(y()), f(z()) }; }

  friend Vector_3 operator+(const Vector_3& v, const Vector_3& w) { return { v.x() + w.x(), v.y() + w.y(), v.z() + w.z() }; }
  friend Vector_3 operator-(const Vector_3& v, const Vector_3& w) { return { v.x() - w.x(), v.y() - w.y(), v.z() - w.z() }; }
  friend Vector_3 operator-(const Vector_3& v) { return { -v.x(), -v.y(), -v.z() }; }
  friend Vector_3 operator*(const double s, const Vector_3& v) { return { s * v.x(), s * v.y(), s * v.z() }; }
  friend Vector_3 operator*(const Vector_3& v, const double s) { return s * v; }
  friend Vector_3 operator/(const Vector_3& v, const double s) { return { v.x() / s, v.y() / s, v.z() / s }; }
  Vector_3& operator+=(const Vector_3& w) { return *this = *this + w; }
  Vector_3& operator-=(const Vector_3& w) { return *this = *this - w; }
  friend bool operator==(const Vector_3& v, const Vector_3& w)
  { return v.x() == w.x() && v.y() == w.y() && v.z() == w.z(); }
  friend bool operator!=(const Vector_3& v, const Vector_3& w) { return !(v == w); }

  double dot(const Vector_3& w) const { return x() * w.x() + y() * w.y() + z() * w.z(); }
  Vector_3 cross(const Vector_3& w) const
  { return { y() * w.z() - z() * w.y(), z() * w.x() - x() * w.z(), x() * w.y() - y() * w.x() }; }
  double prod() const { return x() * y() * z(); }
  double squaredNorm() const { return dot(*this); }
  double norm() const { return std::sqrt(squaredNorm()); }
  Vector_3 normalized() const
  {
    const double squares = squaredNorm();
    return squares > 0 ? *this / std::sqrt(squares) : *this;
  }
  // Also normalizes vectors whose length, or half of whose length, is out of the range of numbers.
  Vector_3 stableNormalized() const
  {
    const double largest_of_all = cwiseAbs().maxCoeff();
    if(!(largest_of_all > 0) || std::isinf(largest_of_all))
      return *this;
    const int exponent = std::ilogb(largest_of_all);
    const Vector_3 v = unaryExpr([&](const double x) { return std::scalbn(x, -exponent); });
    const double largest = v.cwiseAbs().maxCoeff();
    return v / (std::sqrt((v / largest).squaredNorm()) * largest);
  }

  bool hasNaN() const { return std::isnan(x()) || std::isnan(y()) || std::isnan(z()); }
  bool hasInf() const { return std::isinf(x()) || std::isinf(y()) || std::isinf(z()); }
  bool allFinite() const { return std::isfinite(x()) && std::isfinite(y()) && std::isfinite(z()); }
  double sum() const { return x() + y() + z(); }
  Vector_3 cwiseAbs() const { return { std::abs(x()), std::abs(y()), std::abs(z()) }; }
  Vector_3 cwiseMin(const Vector_3& w) const
  { return { (std::min)(x(), w.x()), (std::min)(y(), w.y()), (std::min)(z(), w.z()) }; }
  Vector_3 cwiseMax(const Vector_3& w) const
  { return { (std::max)(x(), w.x()), (std::max)(y(), w.y()), (std::max)(z(), w.z()) }; }
  // the index of the largest number
  int largest_index() const { return static_cast<int>(std::max_element(m_values, m_values + 3) - m_values); }
  double minCoeff() const { return (std::min)((std::min)(x(), y()), z()); }
  double maxCoeff() const { return (std::max)((std::max)(x(), y()), z()); }

private:
  double m_values[3];
};

// Returns the length of a vector, without overflow or underflow, as std::hypot() does except in libc++. The stable norm of Eigen
// adds in an order that depends on the address of the vector.
inline double length_3(const Vector_3& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  if(largest == 0 || std::isinf(largest))
    return std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z());
  return largest * (v / largest).norm();
}

// Returns the unit vector of a direction. Along an axis, it is exact: a division may be a product with a rounded reciprocal.
inline Vector_3 unit_vector_3(const Vector_3& n)
{
  const auto sign = [](const double x) { return double(x > 0) - double(x < 0); };
  return (n[0] != 0) + (n[1] != 0) + (n[2] != 0) == 1 ? n.unaryExpr(sign) : n.stableNormalized();
}

// A matrix of three columns.
class Matrix_3
{
public:
  Matrix_3() = default;
  Matrix_3(const Vector_3& a, const Vector_3& b, const Vector_3& c) : m_columns{ a, b, c } {}
  template <typename Expression, typename = decltype(std::declval<const Expression&>().derived())>
  Matrix_3(const Expression& m) { Eigen::Map<Eigen::Matrix3d>(&(*this)(0, 0)) = m; }
  operator Eigen::Matrix3d() const { return Eigen::Matrix3d(m_columns[0].data()); }

  static Matrix_3 diagonal(const Vector_3& d) { return { { d[0], 0, 0 }, { 0, d[1], 0 }, { 0, 0, d[2] } }; }
  static Matrix_3 Zero() { return diagonal(Vector_3::Zero()); }
  static Matrix_3 Identity() { return diagonal(Vector_3::Ones()); }
  static Matrix_3 outer_product(const Vector_3& v, const Vector_3& w) { return { w[0] * v, w[1] * v, w[2] * v }; }

  double& operator()(const int i, const int j) { return m_columns[j][i]; }
  const double& operator()(const int i, const int j) const { return m_columns[j][i]; }
  Vector_3& col(const int j) { return m_columns[j]; }
  const Vector_3& col(const int j) const { return m_columns[j]; }
  void set_row(const int i, const Vector_3& row)
  {
    for(int j = 0; j < 3; ++j)
      (*this)(i, j) = row[j];
  }
  Vector_3 row(const int i) const { return { m_columns[0][i], m_columns[1][i], m_columns[2][i] }; }

  friend Matrix_3 operator+(const Matrix_3& A, const Matrix_3& B)
  { return { A.col(0) + B.col(0), A.col(1) + B.col(1), A.col(2) + B.col(2) }; }
  friend Matrix_3 operator-(const Matrix_3& A, const Matrix_3& B)
  { return { A.col(0) - B.col(0), A.col(1) - B.col(1), A.col(2) - B.col(2) }; }
  friend Matrix_3 operator*(const double s, const Matrix_3& A) { return { s * A.col(0), s * A.col(1), s * A.col(2) }; }
  friend Matrix_3 operator*(const Matrix_3& A, const double s) { return s * A; }
  friend Matrix_3 operator/(const Matrix_3& A, const double s) { return { A.col(0) / s, A.col(1) / s, A.col(2) / s }; }
  Matrix_3& operator+=(const Matrix_3& B) { return *this = *this + B; }
  friend bool operator==(const Matrix_3& A, const Matrix_3& B)
  { return A.col(0) == B.col(0) && A.col(1) == B.col(1) && A.col(2) == B.col(2); }
  friend bool operator!=(const Matrix_3& A, const Matrix_3& B) { return !(A == B); }

  // Adds alike in all rows: if the last row is added from the right, as by Eigen, g++ 12 exchanges terms of two columns of a
  // product in registers of AVX-512.
  friend Vector_3 operator*(const Matrix_3& A, const Vector_3& v)
  {
    const auto entry = [&](const int i) { return A(i, 0) * v[0] + A(i, 1) * v[1] + A(i, 2) * v[2]; };
    return { entry(0), entry(1), entry(2) };
  }
  friend Matrix_3 operator*(const Matrix_3& A, const Matrix_3& B) { return { A * B.col(0), A * B.col(1), A * B.col(2) }; }

  Matrix_3 transpose() const { return { row(0), row(1), row(2) }; }
  double trace() const { return (*this)(0, 0) + ((*this)(1, 1) + (*this)(2, 2)); }
  double norm() const
  {
    const double* const a = m_columns[0].data();
    const auto square = [a](const int i) { return a[i] * a[i]; };
    return std::sqrt(((square(0) + square(2)) + (square(4) + square(6))) + ((square(1) + square(3)) + (square(5) + square(7)))
                     + square(8));
  }
  double determinant() const
  {
    const auto term = [this](const int i, const int j, const int k)
    { return (*this)(0, i) * ((*this)(1, j) * (*this)(2, k) - (*this)(1, k) * (*this)(2, j)); };
    return term(0, 1, 2) - term(1, 0, 2) + term(2, 0, 1);
  }

  Matrix_3 inverse() const
  {
    const Vector_3 cofactors[] = { col(1).cross(col(2)), col(2).cross(col(0)), col(0).cross(col(1)) };
    const double factor = 1 / cofactors[0].dot(col(0));
    return factor * Matrix_3(cofactors[0], cofactors[1], cofactors[2]).transpose();
  }

  bool allFinite() const { return col(0).allFinite() && col(1).allFinite() && col(2).allFinite(); }
  bool is_zero() const { return *this == Zero(); }
  bool is_diagonal() const { return *this == diagonal({ (*this)(0, 0), (*this)(1, 1), (*this)(2, 2) }); }

private:
  Vector_3 m_columns[3];
};

// The smallest box around points that is parallel to the axes.
struct Box_3
{
  Vector_3 smallest = Vector_3::Constant((std::numeric_limits<double>::max)()), largest = -smallest;

  void extend(const Vector_3& p)
  {
    smallest = smallest.cwiseMin(p);
    largest = largest.cwiseMax(p);
  }
  bool is_empty() const { return (largest - smallest).minCoeff() < 0; }
  Vector_3 diagonal() const { return largest - smallest; }
  Vector_3 center() const { return (smallest + largest) / 2; }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_VECTOR_3_H
