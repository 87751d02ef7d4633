// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_DIAGNOSE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_DIAGNOSE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/Self_intersection_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/prove_infeasibility_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/boundary_facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

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
      {
        return std::find(mesh.cells[d].begin(), mesh.cells[d].end(), v) != mesh.cells[d].end();
      });
      if(is_shared || mesh.is_free(v))
        result.insert(v);
    }
  return result;
}

// A sentence for the user about some proofs, at least one.
inline std::string describe_infeasibility(const std::vector<Infeasibility_proof_3>& proofs,
                                          const Numbered_mesh_3& mesh)
{
  std::string places;
  for(const int v : blamed_vertices(proofs.front(), mesh))
    places += (places.empty() ? "" : ", ") + describe(mesh.source.col(v));
  return sentence("No map with this connectivity meets this boundary: some sets of cells cannot all be positive, "
                  "wherever the free vertices are. Number of sets found: ", proofs.size(), "; cells of the first one: ",
                  proofs.front().cells.size(), ", around the source's vertices at ", places, ".");
}

// A sentence with the cells, the first ones of many, if there is no proof.
inline std::string describe_inverted_cells(const std::vector<std::size_t>& cells, const Numbered_mesh_3& mesh)
{
  constexpr std::size_t maximal_number = 100;
  const std::size_t number = (std::min)(maximal_number, cells.size());
  std::string result = "With the boundary at its targets, these cells stay inverted: ";
  for(std::size_t i = 0; i < number; ++i)
    result += sentence(i == 0 ? "" : ", ", mesh.user_number(cells[i]));
  return result + (cells.size() > number ? sentence(", and ", cells.size() - number, " others.") : ".");
}

// Two facets that the prescribed surface intersects itself in, with a space in front; empty if there are none.
inline std::string describe_self_intersection(const Numbered_mesh_3& mesh, const Budget& budget)
{
  const std::vector<std::array<int, 3> > facets = boundary_facets_3(mesh.cells, mesh.is_parallel);
  const auto found = Self_intersection_3(mesh.target, facets).find(budget);
  if(!found)
    return "";
  const auto corners = [&](const std::size_t facet)
  {
    const auto& [a, b, c] = facets[facet];
    return describe(mesh.source.col(a)) + ", " + describe(mesh.source.col(b)) + ", " + describe(mesh.source.col(c));
  };
  return " The prescribed boundary intersects itself, for instance in the images of two facets, the one with the "
         "source's vertices at " + corners(found->first) + ", and the one at " + corners(found->second)
         + "; few such boundaries have a map without inverted cells, and none that is one to one.";
}

// Looks at the best images that were found, in which some cells are not positive.
inline Diagnosis_3 diagnose_3(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& image, const Budget& budget)
{
  Diagnosis_3 result;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    if(!is_positive(image, mesh.cells[c]))
      result.inverted_cells.push_back(c);
  const std::vector<Infeasibility_proof_3> proofs = prove_infeasibility_3(mesh, image, budget);
  result.number_of_proofs = proofs.size();
  result.message = proofs.empty() ? describe_inverted_cells(result.inverted_cells, mesh)
                                  : describe_infeasibility(proofs, mesh);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_DIAGNOSE_3_H
