// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_PARALLEL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_PARALLEL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

// CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE, a macro that the target CGAL::Volume_mesh_parameterization_engine
// defines, means that the functions that headers `x.h` declare are compiled once, in its library. Otherwise each unit has them
// inline, by the headers `x_impl.h` at the foot of these.
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
#else
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE inline
#endif

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Communicator of the processes that share a mesh: exchanges global scalars, and, where few cells matter, the numbers of all
// processes. All processes call the same functions in the same order and get the same results. The base class is the
// communicator of a process that is alone.
class Communicator_3
{
public:
  virtual ~Communicator_3() = default;
  virtual bool is_alone() const { return true; }
  virtual int rank() const { return 0; }
  virtual std::vector<double> gathered(const double x) const { return { x }; } // numbers in the order of the ranks
  virtual std::vector<double> concatenated(const std::vector<double>& numbers) const { return numbers; }
  // Returns the code and the sentence of the first process whose code is not 0.
  virtual std::pair<int, std::string> first_failure(const int code, const std::string& sentence) const
  { return { code, sentence }; }

  double sum(const double x) const
  {
    const std::vector<double> all = gathered(x);
    return std::accumulate(all.begin(), all.end(), 0.);
  }

  double minimum(const double x) const
  {
    const std::vector<double> all = gathered(x);
    return *std::min_element(all.begin(), all.end());
  }

  double maximum(const double x) const { return -minimum(-x); }
  bool all(const bool condition) const { return minimum(condition ? 1 : 0) == 1; }

  // Returns the rows of all processes in ascending order, each once.
  template <std::size_t n>
  std::set<std::array<double, n> > gather(const std::vector<std::array<double, n> >& rows) const
  {
    std::vector<double> numbers;
    for(const std::array<double, n>& row : rows)
      numbers.insert(numbers.end(), row.begin(), row.end());
    numbers = concatenated(numbers);
    std::set<std::array<double, n> > result;
    for(std::size_t i = 0; i < numbers.size(); i += n)
    {
      std::array<double, n> row;
      std::copy_n(numbers.begin() + i, n, row.begin());
      result.insert(row);
    }
    return result;
  }

  // Returns the numbers that `find()` returns in the first process. In another process, rounding may differ.
  template <typename Find>
  std::vector<double> of_first_process(const Find& find) const
  { return concatenated(rank() == 0 ? find() : std::vector<double>()); }
};

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE const Communicator_3& single_process();

// Returns whether a tag asks for threads, which do not compile without TBB.
template <typename ConcurrencyTag>
constexpr bool is_parallel()
{
  constexpr bool result = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!result, "Parallel_tag requires TBB: link with CGAL::TBB_support, or without CMake compile with "
                         "-DCGAL_LINKED_WITH_TBB and link with -ltbb.");
#endif
  return result;
}

// Function of an index, by reference: the types of `std::function` would make an object file larger by a sixth.
class Index_function
{
public:
  template <typename Function>
  explicit Index_function(const Function& f)
    : m_function(&f), m_call([](const void* function, const std::size_t i) { (*static_cast<const Function*>(function))(i); })
  {}

  void operator()(const std::size_t i) const { m_call(m_function, i); }

private:
  const void* m_function;
  void (*m_call)(const void*, std::size_t);
};

// Calls f for each index. The function is defined with the engine, so that only the engine needs TBB's headers.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
void call_for_each_index(bool is_parallel, std::size_t first, std::size_t last, Index_function f);

// Calls f(first), ..., f(last - 1), in parallel if asked for. The calls must be independent; callers
// that sum keep one partial sum an index and add them in order, so results do not depend on threads.
template <typename Function>
void for_each_index(const bool is_parallel, const std::size_t first, const std::size_t last, const Function& f)
{ call_for_each_index(is_parallel, first, last, Index_function(f)); }

// Cuts [0, n) into ranges of one size, the last of which may be shorter, and calls f(number, first, last) for each, in parallel
// if asked for.
template <typename Index, typename Function>
void for_each_range(const bool is_parallel, const Index n, const int size, const Function& f)
{
  for_each_index(is_parallel, 0, static_cast<std::size_t>((n + size - 1) / size), [&](const std::size_t i)
  {
    const Index first = static_cast<Index>(i) * size;
    f(i, first, (std::min)(n, first + size));
  });
}

// Calls f(0), ..., f(n - 1), which are short, in ranges.
template <typename Index, typename Function>
void for_each_in_ranges(const bool is_parallel, const Index n, const int size, const Function& f)
{
  for_each_range(is_parallel, n, size, [&](std::size_t, const Index first, const Index last)
  {
    for(Index i = first; i < last; ++i)
      f(i);
  });
}

// Returns f(0), ..., f(n - 1), called in ranges.
template <typename Function>
auto values_of_indices(const bool is_parallel, const std::size_t n, const Function& f)
{
  constexpr int indices_per_range = 4096; // a guess
  using Value = std::invoke_result_t<Function, std::size_t>;
  static_assert(!std::is_same<Value, bool>::value, "Bits of one word are not independent.");
  std::vector<Value> result(n);
  for_each_in_ranges(is_parallel, n, indices_per_range, [&](const std::size_t i) { result[i] = f(i); });
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Support/parallel_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_PARALLEL_H
