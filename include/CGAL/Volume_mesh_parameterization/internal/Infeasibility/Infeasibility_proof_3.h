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

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Proves that no map with the prescribed vertices has only positive cells: the volumes of these cells,
// times these positive factors, have a sum that does not depend on the free vertices and is not positive.
struct Infeasibility_proof_3
{
  std::vector<std::size_t> cells;
  std::vector<Exact_rational> factors;
};

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

// Six times the volume of the image of a cell whose free vertices are among u and v is linear in u, v and u x v: the
// constant, and the three coefficients of each of them.
using Volume_form_3 = std::array<Exact_rational, 10>;

inline Volume_form_3 volume_form_3(const Numbered_mesh_3& mesh, const std::array<int, 4>& cell, const int u)
{
  using Point = Simple_cartesian<Exact_rational>::Point_3;
  const auto volume = [&](const Point& image_of_u, const Point& image_of_v)
  {
    std::array<Point, 4> p;
    for(int i = 0; i < 4; ++i)
      p[i] = cell[i] == u           ? image_of_u
           : mesh.is_free(cell[i]) ? image_of_v
           : Point(mesh.target(0, cell[i]), mesh.target(1, cell[i]), mesh.target(2, cell[i]));
    return CGAL::determinant(p[1] - p[0], p[2] - p[0], p[3] - p[0]);
  };
  const Point origin(0, 0, 0), unit[3] = { Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) };
  Volume_form_3 form;
  form[0] = volume(origin, origin);
  for(int k = 0; k < 3; ++k)
  {
    form[1 + k] = volume(unit[k], origin) - form[0];
    form[4 + k] = volume(origin, unit[k]) - form[0];
  }
  for(int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    form[7 + k] = volume(unit[i], unit[j]) - form[1 + i] - form[4 + j] - form[0];
  }
  return form;
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
  Volume_form_3 sum;
  sum.fill(0);
  for(std::size_t i = 0; i < proof.cells.size(); ++i)
  {
    if(proof.factors[i] <= 0)
      return false;
    const Volume_form_3 form = volume_form_3(mesh, mesh.cells[proof.cells[i]], free.empty() ? -1 : *free.begin());
    for(std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += proof.factors[i] * form[k];
  }
  return sum[0] <= 0 && std::all_of(sum.begin() + 1, sum.end(), [](const Exact_rational& x) { return x == 0; });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_INFEASIBILITY_PROOF_3_H
