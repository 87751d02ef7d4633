// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_PACK_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_PACK_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Dense>

#include <algorithm>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

template <typename T> using Vector_3 = Eigen::Matrix<T, 3, 1>;
template <typename T> using Matrix_3 = Eigen::Matrix<T, 3, 3>;

// A number for each of several cells. All arithmetic on cells is written once, for a scalar type `T`
// that is `double` or `Pack`. A pack is made of Eigen's SIMD packets: compilers copy a fixed-size
// `Eigen::Array` through integer registers, which made the same code up to eight times slower.
// Two packets hide the latency of divisions and square roots; a function that is not inlined would pass them in memory.
class Pack
{
  using Packet = Eigen::internal::packet_traits<double>::type;
  static constexpr int packet_size = Eigen::internal::packet_traits<double>::size;
  static constexpr int number_of_packets = 2;

#if defined(__GNUC__) // says that a template argument loses an attribute, which does not matter here
#  pragma GCC diagnostic push
#  pragma GCC diagnostic ignored "-Wignored-attributes"
#endif
  using Packet_block = Eigen::internal::PacketBlock<Packet, packet_size>;
#if defined(__GNUC__)
#  pragma GCC diagnostic pop
#endif

public:
  static constexpr int size = number_of_packets * packet_size;

  // The result of a comparison: all bits or none, in each cell.
  struct Mask { Packet packets[number_of_packets]; };

  Pack() = default;
  EIGEN_ALWAYS_INLINE Pack(const double x) { for(Packet& p : m_packets) p = Eigen::internal::pset1<Packet>(x); }

  EIGEN_ALWAYS_INLINE static Pack load(const double* values)
  {
    Pack result;
    for(int i = 0; i < number_of_packets; ++i)
      result.m_packets[i] = Eigen::internal::ploadu<Packet>(values + i * packet_size);
    return result;
  }

  EIGEN_ALWAYS_INLINE void store(double* values) const
  {
    for(int i = 0; i < number_of_packets; ++i)
      Eigen::internal::pstoreu(values + i * packet_size, m_packets[i]);
  }

  // Stores the N numbers of each cell side by side: numbers[cell][i] is the one of packs[i].
  template <int N>
  EIGEN_ALWAYS_INLINE static void store_by_cells(const Pack* const packs, double (*numbers)[N])
  {
    for(int p = 0; p < number_of_packets; ++p, numbers += packet_size)
    {
      int i = 0;
      for(; i + packet_size <= N; i += packet_size)
      {
        Packet_block block;
        for(int k = 0; k < packet_size; ++k)
          block.packet[k] = packs[i + k].m_packets[p];
        Eigen::internal::ptranspose(block);
        for(int k = 0; k < packet_size; ++k)
          Eigen::internal::pstoreu(numbers[k] + i, block.packet[k]);
      }
      for(; i < N; ++i)
      {
        double rest[packet_size];
        Eigen::internal::pstoreu(rest, packs[i].m_packets[p]);
        for(int k = 0; k < packet_size; ++k)
          numbers[k][i] = rest[k];
      }
    }
  }

  EIGEN_ALWAYS_INLINE friend Pack operator+(const Pack& a, const Pack& b)
  { return apply([](auto x, auto y) { return Eigen::internal::padd(x, y); }, a, b); }
  EIGEN_ALWAYS_INLINE friend Pack operator-(const Pack& a, const Pack& b)
  { return apply([](auto x, auto y) { return Eigen::internal::psub(x, y); }, a, b); }
  EIGEN_ALWAYS_INLINE friend Pack operator*(const Pack& a, const Pack& b)
  { return apply([](auto x, auto y) { return Eigen::internal::pmul(x, y); }, a, b); }
  EIGEN_ALWAYS_INLINE friend Pack operator/(const Pack& a, const Pack& b)
  { return apply([](auto x, auto y) { return Eigen::internal::pdiv(x, y); }, a, b); }
  EIGEN_ALWAYS_INLINE friend Pack operator-(const Pack& a)
  { return apply([](auto x) { return Eigen::internal::pnegate(x); }, a); }

  EIGEN_ALWAYS_INLINE Pack& operator+=(const Pack& b) { return *this = *this + b; }
  EIGEN_ALWAYS_INLINE Pack& operator-=(const Pack& b) { return *this = *this - b; }
  EIGEN_ALWAYS_INLINE Pack& operator*=(const Pack& b) { return *this = *this * b; }
  EIGEN_ALWAYS_INLINE Pack& operator/=(const Pack& b) { return *this = *this / b; }

  EIGEN_ALWAYS_INLINE friend Pack sqrt(const Pack& a) { return apply([](auto x) { return Eigen::internal::psqrt(x); }, a); }
  EIGEN_ALWAYS_INLINE friend Pack abs(const Pack& a) { return apply([](auto x) { return Eigen::internal::pabs(x); }, a); }
  EIGEN_ALWAYS_INLINE friend Pack exp(const Pack& a) { return apply([](auto x) { return Eigen::internal::pexp(x); }, a); }
  EIGEN_ALWAYS_INLINE friend Pack log(const Pack& a) { return apply([](auto x) { return Eigen::internal::plog(x); }, a); }
  EIGEN_ALWAYS_INLINE friend Pack minimum(const Pack& a, const Pack& b)
  { return apply([](auto x, auto y) { return Eigen::internal::pmin(x, y); }, a, b); }
  EIGEN_ALWAYS_INLINE friend Pack maximum(const Pack& a, const Pack& b)
  { return apply([](auto x, auto y) { return Eigen::internal::pmax(x, y); }, a, b); }

  EIGEN_ALWAYS_INLINE friend Mask operator<(const Pack& a, const Pack& b)
  { return compare([](auto x, auto y) { return Eigen::internal::pcmp_lt(x, y); }, a, b); }
  EIGEN_ALWAYS_INLINE friend Mask operator<=(const Pack& a, const Pack& b)
  { return compare([](auto x, auto y) { return Eigen::internal::pcmp_le(x, y); }, a, b); }
  EIGEN_ALWAYS_INLINE friend Mask operator>(const Pack& a, const Pack& b) { return b < a; }
  EIGEN_ALWAYS_INLINE friend Mask operator>=(const Pack& a, const Pack& b) { return b <= a; }

  // `mask ? a : b` in each cell
  EIGEN_ALWAYS_INLINE friend Pack select(const Mask& mask, const Pack& a, const Pack& b)
  {
    Pack result;
    for(int i = 0; i < number_of_packets; ++i)
      result.m_packets[i] = Eigen::internal::pselect(mask.packets[i], a.m_packets[i], b.m_packets[i]);
    return result;
  }

  EIGEN_ALWAYS_INLINE friend double sum(const Pack& a)
  {
    double result = 0;
    for(const Packet& p : a.m_packets)
      result += Eigen::internal::predux(p);
    return result;
  }

  EIGEN_ALWAYS_INLINE friend double smallest(const Pack& a)
  {
    double result = Eigen::internal::predux_min(a.m_packets[0]);
    for(int i = 1; i < number_of_packets; ++i)
      result = (std::min)(result, Eigen::internal::predux_min(a.m_packets[i]));
    return result;
  }

  EIGEN_ALWAYS_INLINE friend bool any(const Mask& mask) { return smallest(select(mask, -1., 0.)) < 0; }

private:
  template <typename Function>
  EIGEN_ALWAYS_INLINE static Pack apply(const Function& f, const Pack& a)
  {
    Pack result;
    for(int i = 0; i < number_of_packets; ++i)
      result.m_packets[i] = f(a.m_packets[i]);
    return result;
  }

  template <typename Function>
  EIGEN_ALWAYS_INLINE static Pack apply(const Function& f, const Pack& a, const Pack& b)
  {
    Pack result;
    for(int i = 0; i < number_of_packets; ++i)
      result.m_packets[i] = f(a.m_packets[i], b.m_packets[i]);
    return result;
  }

  template <typename Function>
  EIGEN_ALWAYS_INLINE static Mask compare(const Function& f, const Pack& a, const Pack& b)
  {
    Mask result;
    for(int i = 0; i < number_of_packets; ++i)
      result.packets[i] = f(a.m_packets[i], b.m_packets[i]);
    return result;
  }

  Packet m_packets[number_of_packets];
};

// The same for a single cell.
inline double minimum(const double a, const double b) { return b < a ? b : a; }
inline double maximum(const double a, const double b) { return a < b ? b : a; }
inline double select(const bool mask, const double a, const double b) { return mask ? a : b; }
inline bool any(const bool mask) { return mask; }

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

namespace Eigen {

template <>
struct NumTraits<CGAL::Volume_mesh_parameterization::internal::Pack>
  : GenericNumTraits<CGAL::Volume_mesh_parameterization::internal::Pack>
{
  using Pack = CGAL::Volume_mesh_parameterization::internal::Pack;
  using Real = Pack;
  using NonInteger = Pack;
  using Nested = Pack;
  using Literal = Pack;

  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 0,
         ReadCost = 1, AddCost = 1, MulCost = 1 };
};

} // namespace Eigen

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_PACK_H
