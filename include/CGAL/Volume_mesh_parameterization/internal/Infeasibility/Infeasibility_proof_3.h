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

#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/volume_form_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Proves that no map with the prescribed vertices has only positive cells: the volumes of these cells,
// times these positive factors, have a sum that does not depend on the free vertices and is not positive.
struct Infeasibility_proof_3
{
  std::vector<std::size_t> cells;
  std::vector<Exact_rational> factors;
};

inline Volume_form_3<Exact_rational> exact_volume_form_3(const Numbered_mesh_3& mesh, const std::size_t c, const int u)
{
  return volume_form_3<Exact_rational>(mesh, mesh.cells[c], u, [&](const int v)
  {
    return std::array<Exact_rational, 3>{ Exact_rational(mesh.target(0, v)), Exact_rational(mesh.target(1, v)),
                                          Exact_rational(mesh.target(2, v)) };
  });
}

// The free vertices of some cells.
inline std::set<int> free_vertices_of(const Numbered_mesh_3& mesh, const std::vector<std::size_t>& cells)
{
  std::set<int> result;
  for(const std::size_t c : cells)
    for(const int v : mesh.cells[c])
      if(mesh.is_free(v))
        result.insert(v);
  return result;
}

// Checks the proof with exact numbers only; does not rely on how it was found.
inline bool is_valid(const Infeasibility_proof_3& proof, const Numbered_mesh_3& mesh)
{
  if(proof.cells.empty() || proof.factors.size() != proof.cells.size()
     || *std::max_element(proof.cells.begin(), proof.cells.end()) >= mesh.cells.size())
    return false;
  const std::set<int> free = free_vertices_of(mesh, proof.cells);
  if(free.size() > 2)
    return false;
  Volume_form_3<Exact_rational> sum;
  sum.fill(Exact_rational(0));
  for(std::size_t i = 0; i < proof.cells.size(); ++i)
  {
    if(proof.factors[i] <= 0)
      return false;
    const Volume_form_3<Exact_rational> form = exact_volume_form_3(mesh, proof.cells[i], free.empty() ? -1 : *free.begin());
    for(std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += proof.factors[i] * form[k];
  }
  return sum[0] <= 0 && std::all_of(sum.begin() + 1, sum.end(), [](const Exact_rational& x) { return x == 0; });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_INFEASIBILITY_PROOF_3_H
