// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PARALLEL_COMMUNICATOR_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PARALLEL_COMMUNICATOR_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The processes that share a mesh, as computations see them: by global scalars, and where few cells matter, by the numbers
// of all. All processes call the same functions in the same order and get the same results. This process is alone.
class Communicator_3
{
public:
  virtual ~Communicator_3() = default;
  virtual bool is_alone() const { return true; }
  virtual int rank() const { return 0; }
  virtual double sum(const double x) const { return x; }
  virtual double minimum(const double x) const { return x; }
  double maximum(const double x) const { return -minimum(-x); }
  virtual std::vector<double> concatenated(const std::vector<double>& numbers) const { return numbers; }
  bool all(const bool condition) const { return minimum(condition ? 1 : 0) == 1; }

  // The code and the sentence of the first process whose code is not 0.
  virtual std::pair<int, std::string> first_failure(const int code, const std::string& sentence) const
  {
    return { code, sentence };
  }
};

inline const Communicator_3& single_process()
{
  static const Communicator_3 communicator;
  return communicator;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PARALLEL_COMMUNICATOR_3_H
