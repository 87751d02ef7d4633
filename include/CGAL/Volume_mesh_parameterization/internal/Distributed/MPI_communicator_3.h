// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_MPI_COMMUNICATOR_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_MPI_COMMUNICATOR_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <mpi.h>

#include <cstdint>
#include <new>

namespace CGAL::Volume_mesh_parameterization::internal {

// Processes that fail together. All communication begins with a round in which each sends a number and whether it has
// failed. If one has, all throw what the first of them has thrown. Therefore, none waits for one that is gone. Numbers are
// added in the order of the ranks: all processes get the same bits, in each run.
class MPI_communicator_3 final : public Communicator_3
{
public:
  explicit MPI_communicator_3(const MPI_Comm communicator)
  {
    MPI_Comm_dup(communicator, &m_communicator); // messages of other code are never mistaken for ours
    MPI_Comm_rank(m_communicator, &m_rank);
    MPI_Comm_size(m_communicator, &m_size);
    m_messages.resize(m_size);
  }

  MPI_communicator_3(const MPI_communicator_3&) = delete;
  MPI_communicator_3& operator=(const MPI_communicator_3&) = delete;
  ~MPI_communicator_3() override { MPI_Comm_free(&m_communicator); }

  MPI_Comm get() const { return m_communicator; }
  int rank() const override { return m_rank; }
  int size() const { return m_size; }

  // Returns false with one process, too, so that the same is computed with any number of processes.
  bool is_alone() const override { return false; }

  std::vector<double> gathered(const double x) const override { return gathered(x, Failure()); }

  std::vector<double> concatenated(const std::vector<double>& numbers) const override
  { return exchanged(std::vector<std::vector<double> >(m_size, numbers)); }

  std::pair<int, std::string> first_failure(const int code, const std::string& sentence) const override
  {
    const std::vector<double> codes = gathered(code);
    const auto first = std::find_if(codes.begin(), codes.end(), [](const double c) { return c != 0; });
    if(first == codes.end())
      return { 0, "" };
    return { static_cast<int>(*first), text_of(static_cast<int>(first - codes.begin()), sentence) };
  }

  // Returns where the slices of all processes begin, one behind the other, and where the last one ends.
  std::vector<std::size_t> begins(const std::size_t size_of_slice) const
  {
    std::vector<std::size_t> result = { 0 };
    for(const double size : gathered(static_cast<double>(size_of_slice)))
      result.push_back(result.back() + static_cast<std::size_t>(size));
    return result;
  }

  // Throws if a process has failed. Is called before communication that is not ours.
  void synchronize() const { gathered(0); }

  // Returns where parts of the sizes begin, and where the last one ends. MPI counts in `int`.
  static std::vector<int> begins_of(const std::vector<std::uint64_t>& sizes)
  {
    std::vector<int> result = { 0 };
    std::uint64_t end = 0;
    for(const std::uint64_t size : sizes)
    {
      end += size;
      if(end > static_cast<std::uint64_t>((std::numeric_limits<int>::max)()))
        throw std::runtime_error("One process would send or receive 2^31 cells or vertices or more; take more processes.");
      result.push_back(static_cast<int>(end));
    }
    return result;
  }

  // Sends elements to each process; returns those for this one, in the order of the ranks that they come from.
  template <typename T>
  std::vector<T> exchanged(const std::vector<std::vector<T> >& elements) const
  {
    std::vector<std::uint64_t> sizes, new_sizes(m_size);
    std::vector<T> sent;
    for(const std::vector<T>& part : elements)
    {
      sizes.push_back(part.size());
      sent.insert(sent.end(), part.begin(), part.end());
    }
    synchronize();
    MPI_Alltoall(sizes.data(), 1, MPI_UINT64_T, new_sizes.data(), 1, MPI_UINT64_T, m_communicator);
    const std::vector<int> begins = begins_of(sizes), new_begins = begins_of(new_sizes);
    const std::vector<int> counts(sizes.begin(), sizes.end()), new_counts(new_sizes.begin(), new_sizes.end());
    std::vector<T> received(static_cast<std::size_t>(new_begins.back()));
    synchronize();
    MPI_Datatype type;
    MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Alltoallv(sent.data(), counts.data(), begins.data(), type,
                  received.data(), new_counts.data(), new_begins.data(), type, m_communicator);
    MPI_Type_free(&type);
    return received;
  }

  // Returns the process whose slice has element i of the whole, by the begins of the slices.
  static std::size_t holder(const std::vector<std::size_t>& begins, const std::size_t i)
  { return static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), i) - begins.begin()) - 1; }

  // Returns the elements in slices with new begins. Before and after, the slices are in the order of the ranks.
  template <typename T>
  std::vector<T> redistributed(const std::vector<T>& elements, const std::vector<std::size_t>& new_begins) const
  {
    const std::size_t first = begins(elements.size())[m_rank];
    std::vector<std::vector<T> > parts(m_size);
    for(std::size_t i = 0; i < elements.size(); ++i)
      parts[holder(new_begins, first + i)].push_back(elements[i]);
    return exchanged(parts);
  }

  // Returns the elements in slices of equal length, up to one element.
  template <typename T>
  std::vector<T> evenly(const std::vector<T>& elements) const
  {
    const std::size_t n = begins(elements.size()).back(), size = static_cast<std::size_t>(m_size);
    std::vector<std::size_t> new_begins;
    for(std::size_t i = 0; i <= size; ++i)
      new_begins.push_back((i * n + size - 1) / size);
    return redistributed(elements, new_begins);
  }

  // Runs f, which ends in all processes alike: if it throws in one, then in all.
  template <typename Function>
  auto together(const Function& f) const
  {
    try
    {
      auto result = f();
      synchronize();
      return result;
    }
    catch(const Failure& failure) { throw_again(failure); }
    catch(const Interruption&) { throw_again(first_failure({ Kind::INTERRUPTED, "" })); }
    catch(const std::bad_alloc&) { throw_again(first_failure({ Kind::MEMORY, "" })); }
    catch(const Input_error& error) { throw_again(first_failure({ Kind::INPUT, error.what() })); }
    catch(const std::exception& error) { throw_again(first_failure({ Kind::OTHER, error.what() })); }
    catch(...) { throw_again(first_failure({ Kind::OTHER, "an exception of unknown type" })); }
  }

private:
  enum class Kind { NONE, MEMORY, INTERRUPTED, INPUT, OTHER };
  struct Failure { Kind kind = Kind::NONE; std::string sentence; };
  struct Message { double number, kind; };

  // Throws the first failure, if there is one.
  std::vector<double> gathered(const double x, const Failure& mine) const
  {
    const Message message = { x, static_cast<double>(mine.kind) };
    MPI_Allgather(&message, 2, MPI_DOUBLE, m_messages.data(), 2, MPI_DOUBLE, m_communicator);
    std::vector<double> numbers;
    for(int i = 0; i < m_size; ++i)
    {
      if(m_messages[i].kind != 0)
        throw Failure{ static_cast<Kind>(static_cast<int>(m_messages[i].kind)), text_of(i, mine.sentence) };
      numbers.push_back(m_messages[i].number);
    }
    return numbers;
  }

  // Returns the first failure of all processes; this one has failed.
  Failure first_failure(const Failure& mine) const
  {
    try { gathered(0, mine); }
    catch(const Failure& failure) { return failure; }
    return mine;
  }

  [[noreturn]] static void throw_again(const Failure& failure)
  {
    switch(failure.kind)
    {
      case Kind::MEMORY: throw std::bad_alloc();
      case Kind::INTERRUPTED: throw Interruption();
      case Kind::INPUT: throw Input_error(failure.sentence);
      default: throw std::runtime_error(failure.sentence);
    }
  }

  std::string text_of(const int rank, std::string text) const
  {
    int length = static_cast<int>(text.size());
    MPI_Bcast(&length, 1, MPI_INT, rank, m_communicator);
    text.resize(length);
    MPI_Bcast(text.data(), length, MPI_CHAR, rank, m_communicator);
    return text;
  }

  MPI_Comm m_communicator;
  int m_rank, m_size;
  mutable std::vector<Message> m_messages; // messages of all processes; memory for them is there when memory is out
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_MPI_COMMUNICATOR_3_H
