// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_CELL_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_CELL_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>

#include <boost/type_traits/is_detected.hpp>

#include <limits>

namespace CGAL::Volume_mesh_parameterization { struct Stretch_energy_3; }

namespace CGAL::Volume_mesh_parameterization::internal {

// Number of cells side by side: as many as the longest vector instructions take in two registers.
constexpr int cells_per_pack = 16;
using Packed_number = double[cells_per_pack];
using Packed_vector_3 = double[3][cells_per_pack];
using Packed_matrix_3 = double[9][cells_per_pack]; // column by column

// Pack of cells, with all that an evaluation reads. Cells that fill up the last pack repeat another cell with weight 0 and
// without unknown vertices. A pack begins with a line of the cache.
struct alignas(64) Cell_pack_3
{
  using Indices = std::array<int, cells_per_pack>;

  Cell_pack_3() {} // leaves the first write to the thread that fills the pack

  Packed_matrix_3 inverse_source;   // X^{-1}, times the factor that gives both meshes the same volume
  Packed_number weight;
  std::array<Indices, 4> vertices;  // sorted by rows, which changes the orientation, but not J
  std::array<Indices, 4> rows;      // rows in the matrix; -1 if the vertex is not unknown
  // Positions in the matrix of the pairs a <= b of vertices, the upper triangle row by row; -1 if a vertex is not unknown.
  std::array<Indices, 10> blocks;

  static constexpr int index_of_block(const int a, const int b) { return a * (7 - a) / 2 + b; }

  std::array<int, 4> cell(const std::size_t lane) const
  { return { vertices[0][lane], vertices[1][lane], vertices[2][lane], vertices[3][lane] }; }
};

// Result of one pass over the cells.
struct Energy_evaluation
{
  double energy = 0;                                                  // sum of weight times psi
  double smallest_determinant = std::numeric_limits<double>::infinity();
  std::size_t number_of_inverted_cells = 0;                           // det J <= 0, or not a number

  bool is_flip_free() const { return number_of_inverted_cells == 0; }

  void add(const Energy_evaluation& other)
  {
    energy += other.energy;
    smallest_determinant = (std::min)(smallest_determinant, other.smallest_determinant);
    number_of_inverted_cells += other.number_of_inverted_cells;
  }
};

// Energy as the engine knows it: psi and its derivatives by the singular values s, for a pack of cells at a time. The class
// is the seam between energies of any type and an engine that is compiled once.
class Cell_energy_3
{
public:
  virtual ~Cell_energy_3() = default;
  virtual void value(const Packed_vector_3& s, Packed_number& psi) const = 0;
  virtual void gradient(const Packed_vector_3& s, Packed_vector_3& g) const = 0;
  virtual void derivatives(const Packed_vector_3& s, Packed_vector_3& g, Packed_matrix_3& H) const = 0;

  // Returns whether psi follows from |J|^2, |J^{-1}|^2 and det J, which cost far less than the singular values.
  virtual bool is_of_norms() const = 0;
  virtual void value_of_norms(const Packed_vector_3& norms, Packed_number& psi) const = 0;
  virtual bool is_squared_norm() const = 0; // whether psi = |J|^2, with constant second derivatives
};

template <typename Energy, typename T>
using Value_of_norms
  = decltype(std::declval<const Energy&>().value_of_norms(std::declval<T>(), std::declval<T>(), std::declval<T>()));

template <typename Energy, typename T>
using Is_of_norms = boost::is_detected<Value_of_norms, Energy, T>;

template <typename Energy, typename T, typename = void>
struct Is_energy : std::false_type {};

template <typename Energy, typename T>
struct Is_energy<Energy, T, std::enable_if_t<
  std::is_convertible<decltype(std::declval<const Energy&>().value(std::declval<const Eigen::Matrix<T, 3, 1>&>())), T>::value
  && std::is_convertible<decltype(std::declval<const Energy&>().gradient(std::declval<const Eigen::Matrix<T, 3, 1>&>())),
                         Eigen::Matrix<T, 3, 1> >::value
  && std::is_convertible<decltype(std::declval<const Energy&>().hessian(std::declval<const Eigen::Matrix<T, 3, 1>&>())),
                         Eigen::Matrix<T, 3, 3> >::value> >
  : std::true_type
{};

// Energy of a model of `DistortionEnergy_3`. A unit that names the model evaluates it with the instructions for which the unit
// is compiled, those of its `Pack`.
template <typename Energy, typename Pack = internal::Pack>
class Cell_energy_of final : public Cell_energy_3
{
  static_assert(Is_energy<Energy, Pack>::value,
                "energy must be a model of DistortionEnergy_3: value(), gradient() and hessian() are const templates of a type T, "
                "with an argument of the type Eigen::Matrix<T, 3, 1>.");

public:
  explicit Cell_energy_of(const Energy& energy) : m_energy(energy) {}

  void value(const Packed_vector_3& s, Packed_number& psi) const override
  {
    for(int first = 0; first < cells_per_pack; first += Pack::size)
      m_energy.value(load(s, first)).store(psi + first);
  }

  void gradient(const Packed_vector_3& s, Packed_vector_3& g) const override
  {
    for(int first = 0; first < cells_per_pack; first += Pack::size)
      store(m_energy.gradient(load(s, first)), g, first);
  }

  void derivatives(const Packed_vector_3& s, Packed_vector_3& g, Packed_matrix_3& H) const override
  {
    for(int first = 0; first < cells_per_pack; first += Pack::size)
    {
      const Vector v = load(s, first);
      store(m_energy.gradient(v), g, first);
      const Eigen::Matrix<Pack, 3, 3> hessian = m_energy.hessian(v);
      for(int i = 0; i < 9; ++i)
        hessian(i).store(H[i] + first);
    }
  }

  bool is_of_norms() const override { return Is_of_norms<Energy, Pack>::value; }
  bool is_squared_norm() const override { return std::is_same<Energy, Dirichlet_energy_3>::value; }

  void value_of_norms(const Packed_vector_3& norms, Packed_number& psi) const override
  {
    if constexpr(Is_of_norms<Energy, Pack>::value)
      for(int first = 0; first < cells_per_pack; first += Pack::size)
        m_energy.value_of_norms(Pack::load(norms[0] + first), Pack::load(norms[1] + first), Pack::load(norms[2] + first))
          .store(psi + first);
  }

private:
  using Vector = Eigen::Matrix<Pack, 3, 1>;

  static Vector load(const Packed_vector_3& numbers, const int first)
  { return Vector(Pack::load(numbers[0] + first), Pack::load(numbers[1] + first), Pack::load(numbers[2] + first)); }

  static void store(const Vector& v, Packed_vector_3& numbers, const int first)
  {
    for(int i = 0; i < 3; ++i)
      v[i].store(numbers[i] + first);
  }

  Energy m_energy;
};

// Returns an energy as the engine knows it. An overload takes `Any_energy_3`.
template <typename Energy>
Cell_energy_of<Energy> cell_energy_3(const Energy& energy) { return Cell_energy_of<Energy>(energy); }

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
// The default energy is compiled with the engine. Other energies use the instructions for which a unit is compiled.
const Cell_energy_3& cell_energy_3(const Stretch_energy_3& energy);
#endif

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_CELL_ENERGY_3_H
