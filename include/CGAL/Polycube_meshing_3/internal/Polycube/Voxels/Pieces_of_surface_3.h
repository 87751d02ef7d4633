// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_PIECES_OF_SURFACE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_PIECES_OF_SURFACE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Label_functional_3.h>

#include <map>

namespace CGAL::Volume_mesh_parameterization::internal {

// Pieces of a surface that keep together while the polycube changes, one for each face of the voxels at first, and what labels
// of them cost.
struct Pieces_of_surface_3
{
  std::vector<std::array<double, 6> > costs;           // of the labels
  std::vector<std::map<std::size_t, double> > borders; // lengths of borders with other pieces

  Pieces_of_surface_3(const Boundary_mesh_3& mesh, const Label_functional_3& functional,
                    const std::vector<std::size_t>& piece_of_facet, const std::size_t number_of_pieces)
    : costs(number_of_pieces), borders(number_of_pieces)
  {
    for(std::array<double, 6>& c : costs)
      c.fill(0);
    for(const auto f : mesh.faces())
      for(std::size_t d = 0; d < 6; ++d)
        costs[piece_of_facet[f]][d] += functional.cost(f, d);
    for(const auto h : mesh.halfedges())
      if(const std::size_t a = piece_of_facet[mesh.face(h)], b = piece_of_facet[mesh.face(mesh.opposite(h))]; a != b)
        borders[a][b] += functional.length(h);
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_PIECES_OF_SURFACE_3_H
