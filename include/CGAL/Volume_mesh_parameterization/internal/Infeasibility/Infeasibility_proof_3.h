// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors


#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_INFEASIBILITY_PROOF_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_INFEASIBILITY_PROOF_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/volume_polynomial_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Proves that no map with the prescribed vertices has only positive cells: the volumes of these cells,
// times these positive factors, have a sum that does not depend on the free vertices and is not positive.
struct Infeasibility_proof_3
{
  std::vector<std::size_t> cells;
  std::vector<Exact_rational> factors;
};

inline Volume_polynomial_3<Exact_rational> exact_volume_polynomial_3(const Numbered_mesh_3& mesh, const std::size_t c)
{
  return volume_polynomial_3<Exact_rational>(mesh, mesh.cells[c], [&](const int v, const int k)
  {
    return Exact_rational(mesh.target(k, v));
  });
}

// Checks the proof with exact numbers only; does not rely on how it was found.
inline bool is_valid(const Infeasibility_proof_3& proof, const Numbered_mesh_3& mesh)
{
  if(proof.cells.empty() || proof.factors.size() != proof.cells.size())
    return false;
  Volume_polynomial_3<Exact_rational> sum;
  for(std::size_t i = 0; i < proof.cells.size(); ++i)
  {
    if(proof.cells[i] >= mesh.cells.size() || proof.factors[i] <= 0)
      return false;
    for(const auto& term : exact_volume_polynomial_3(mesh, proof.cells[i]))
      sum[term.first] += proof.factors[i] * term.second;
  }
  return std::all_of(sum.begin(), sum.end(), [](const auto& term)
  {
    return term.first == constant_monomial ? term.second <= 0 : term.second == 0;
  });
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_INFEASIBILITY_PROOF_3_H
