// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_DIAGNOSE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_DIAGNOSE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/prove_infeasibility_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Self_intersection_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The vertices a proof is about: its free vertices, and those that all its cells share.
// These are the ends of an edge, the vertices of a cell, or a single vertex.
inline std::set<int> blamed_vertices(const Infeasibility_proof_3& proof, const Numbered_mesh_3& mesh)
{
  std::set<int> result;
  for(const std::size_t c : proof.cells)
    for(const int v : mesh.cells[c])
    {
      const bool is_shared = std::all_of(proof.cells.begin(), proof.cells.end(), [&](const std::size_t d)
      { return std::find(mesh.cells[d].begin(), mesh.cells[d].end(), v) != mesh.cells[d].end(); });
      if(is_shared || !mesh.is_fixed(v))
        result.insert(v);
    }
  return result;
}

// A sentence for the user about some proofs, at least one.
inline std::string describe_infeasibility(const std::vector<Infeasibility_proof_3>& proofs, const Numbered_mesh_3& mesh)
{
  std::string points;
  for(const int v : blamed_vertices(proofs.front(), mesh))
    points += (points.empty() ? "" : ", ") + describe(mesh.source.col(v));
  return sentence("No map with this connectivity meets this boundary, because the cells of a set cannot all be positive. Number "
                  "of such sets found: ", proofs.size(), ". Number of cells of the first set: ",
                  proofs.front().cells.size(), ", around the vertices of the source at ", points, ".");
}

// A sentence with the cells, the first ones of many; by default if there is no proof.
inline std::string describe_inverted_cells(const std::vector<std::size_t>& cells, const Numbered_mesh_3& mesh,
                                           std::string result = "With the boundary at its targets, these cells stay inverted: ")
{
  constexpr std::size_t maximum_number = 5; // as many as one looks at
  const std::size_t number = (std::min)(maximum_number, cells.size());
  for(std::size_t i = 0; i < number; ++i)
    result += sentence(i == 0 ? "" : ", ", mesh.user_number(cells[i]));
  return result + (cells.size() > number ? sentence(", and ", cells.size() - number, " others.") : ".");
}

// Two facets in which the image of the boundary intersects itself, with a space and the name of that surface in front; empty if
// there are none.
inline std::string describe_self_intersection(const Numbered_mesh_3& mesh, const Matrix3Xd& image, const char* const name,
                                              const Budget& budget)
{
  const std::vector<std::array<int, 3> > facets = boundary_facets_3(mesh.cells, mesh.is_parallel);
  const auto found = Self_intersection_3(image, facets).find(budget);
  if(found.empty())
    return "";
  const auto corners = [&](const std::size_t facet)
  {
    const auto& [a, b, c] = facets[facet];
    return describe(mesh.source.col(a)) + ", " + describe(mesh.source.col(b)) + ", " + describe(mesh.source.col(c));
  };
  return sentence(" The ", name, " intersects itself, for instance in the images of two facets. The vertices of the first facet "
                  "are at ", corners(found.front().first), " in the source, and those of the second one at ",
                  corners(found.front().second));
}

// Looks at the cells that are not positive in the best images that were found.
inline Diagnosis_3 diagnose_3(const Numbered_mesh_3& mesh, const std::vector<std::size_t>& inverted_cells,
                              const Budget& budget)
{
  const std::vector<Infeasibility_proof_3> proofs = prove_infeasibility_3(mesh, inverted_cells, budget);
  return { inverted_cells, proofs.size(), proofs.empty() ? describe_inverted_cells(inverted_cells, mesh)
                                                         : describe_infeasibility(proofs, mesh) };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_DIAGNOSE_3_H
