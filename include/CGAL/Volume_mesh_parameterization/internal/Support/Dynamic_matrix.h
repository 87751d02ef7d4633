// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_DYNAMIC_MATRIX_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_DYNAMIC_MATRIX_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Vector_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// A matrix of few numbers, whose alignment would depend on flags if its size is a multiple of that of a register.
template <int rows, int columns>
using Small_matrix = Eigen::Matrix<double, rows, columns, Eigen::DontAlign>;
using Small_array_2 = Eigen::Array<double, 2, 1, Eigen::DontAlign>;

// A matrix or vector whose size is known at run time, in memory of its own. Eigen's own ones allocate and align memory by the
// flags of a unit; the linker may merge their functions with those of a unit that has other flags. This one is the same in
// all units, and begins with a line of the cache. As with Eigen, numbers are not initialized.
template <typename NT, int rows, int columns = 1>
class Dynamic_matrix : public Eigen::Map<Eigen::Matrix<NT, rows, columns>, Eigen::Aligned64>
{
  using Base = Eigen::Map<Eigen::Matrix<NT, rows, columns>, Eigen::Aligned64>;
  using Index = Eigen::Index;
  static constexpr std::align_val_t alignment{64};
  static_assert(std::is_trivially_copyable<NT>::value && std::is_trivially_destructible<NT>::value);

  static constexpr bool has_vectors = std::is_same<NT, double>::value && rows == 3 && columns == Eigen::Dynamic;

  template <typename Expression>
  using If_expression = decltype(std::declval<const Expression&>().derived());

public:
  Dynamic_matrix() : Base(nullptr, rows == Eigen::Dynamic ? 0 : rows, columns == Eigen::Dynamic ? 0 : columns) {}
  Dynamic_matrix(const Index number_of_rows, const Index number_of_columns)
    : Base(allocated(number_of_rows * number_of_columns), number_of_rows, number_of_columns)
  {}
  explicit Dynamic_matrix(const Index size) : Dynamic_matrix() { resize(size); }
  Dynamic_matrix(const Dynamic_matrix& other) : Dynamic_matrix(other.rows(), other.cols()) { Base::operator=(other); }
  Dynamic_matrix(Dynamic_matrix&& other) noexcept : Dynamic_matrix() { swap(other); }
  template <typename Expression, typename = If_expression<Expression> >
  Dynamic_matrix(const Expression& other) : Dynamic_matrix(other.rows(), other.cols()) { Base::operator=(other); }
  ~Dynamic_matrix() { ::operator delete(this->m_data, alignment); }

  Dynamic_matrix& operator=(const Dynamic_matrix& other) { return assign(other); }
  Dynamic_matrix& operator=(Dynamic_matrix&& other) noexcept
  {
    swap(other);
    return *this;
  }
  template <typename Expression, typename = If_expression<Expression> >
  Dynamic_matrix& operator=(const Expression& other) { return assign(other); }

  // A column of three numbers is a vector that returns values.
  decltype(auto) col(const Index j)
  {
    if constexpr(has_vectors)
      return reinterpret_cast<Vector_3*>(this->m_data)[j];
    else
      return Base::col(j);
  }
  decltype(auto) col(const Index j) const
  {
    if constexpr(has_vectors)
      return reinterpret_cast<const Vector_3*>(this->m_data)[j];
    else
      return Base::col(j);
  }

  // Numbers are kept only if their number is.
  void resize(const Index number_of_rows, const Index number_of_columns)
  {
    if(number_of_rows * number_of_columns != this->size())
      *this = Dynamic_matrix(number_of_rows, number_of_columns);
    else
      rebind(this->m_data, number_of_rows, number_of_columns);
  }

  void resize(const Index size)
  { columns == Eigen::Dynamic ? resize(rows, size) : resize(size, columns); }

  using Base::setZero;
  void setZero(const Index number_of_rows, const Index number_of_columns)
  {
    resize(number_of_rows, number_of_columns);
    Base::setZero();
  }

  void swap(Dynamic_matrix& other) noexcept
  {
    NT* const data = this->m_data;
    const Index number_of_rows = this->rows(), number_of_columns = this->cols();
    rebind(other.m_data, other.rows(), other.cols());
    other.rebind(data, number_of_rows, number_of_columns);
  }

private:
  static NT* allocated(const Index size)
  { return size == 0 ? nullptr : static_cast<NT*>(::operator new(std::size_t(size) * sizeof(NT), alignment)); }

  // Eigen documents this way to let a map see other numbers.
  void rebind(NT* const data, const Index number_of_rows, const Index number_of_columns)
  { new(static_cast<Base*>(this)) Base(data, number_of_rows, number_of_columns); }

  // An expression of other size may depend on the numbers here.
  template <typename Expression>
  Dynamic_matrix& assign(const Expression& other)
  {
    if(other.rows() == this->rows() && other.cols() == this->cols())
      Base::operator=(other);
    else
      *this = Dynamic_matrix(other);
    return *this;
  }
};

using Matrix3Xd = Dynamic_matrix<double, 3, Eigen::Dynamic>;
using VectorXd = Dynamic_matrix<double, Eigen::Dynamic>;

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_DYNAMIC_MATRIX_H
