// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_DIAGNOSE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_DIAGNOSE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/Diagnosis_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/Infeasibility_proof_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/describe_infeasibility_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/prove_infeasibility_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Looks at the best images that were found, in which some cells are not positive.
inline Diagnosis_3 diagnose_3(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& image,
                              const Budget& budget = Budget())
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
