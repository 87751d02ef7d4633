// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_HEXAHEDRON_SOUP_3_H
#define CGAL_POLYCUBE_MESHING_3_HEXAHEDRON_SOUP_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Polycube_meshing_3 {

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// A mesh of hexahedra as arrays, with its blocks. The planes of all faces of a polycube cut it into blocks. A block is a
/// regular grid of hexahedra. The part of a layer of padding over a face of one block, or of another layer, is a block, too.
/// Blocks and faces are numbered from 1. If hexahedra follow interfaces, layers of padding are also blocks: one on each side of
/// each layer of hexahedra in a block. Such a block may be incomplete: some triples of indices have no hexahedron. Two hexahedra
/// of a block whose indices are neighbors share a quadrangle.
struct Hexahedron_soup_3
{
  std::vector<std::array<double, 3> > points; ///< the coordinates of the vertices
  std::vector<std::array<double, 3> > images; ///< the positions of the vertices in the domain
  /// eight indices of points each, in the order of VTK: the points around a quadrangle, then those of the opposite quadrangle in
  /// the same order. The first quadrangle turns counterclockwise, seen from the opposite one
  std::vector<std::array<std::size_t, 8> > cells;
  std::vector<std::size_t> cell_blocks;       ///< the block of each hexahedron
  /// the indices (i, j, k) of each hexahedron in its block, from 0. The quadrangle of the vertices 1, 2, 6 and 5 of a hexahedron
  /// is in direction of i. The quadrangle of 2, 3, 7 and 6 is in direction of j, and that of 4, 5, 6 and 7 of k
  std::vector<std::array<std::size_t, 3> > cell_indices;
  std::vector<int> cell_references;           ///< the subdomain that the center of each hexahedron is mapped to
  std::vector<std::array<std::size_t, 4> > facets; ///< the quadrangles of the boundary, counterclockwise seen from outside
  std::vector<std::size_t> facet_cells;       ///< the index of the hexahedron of each quadrangle
  std::vector<std::size_t> polycube_faces;    ///< the face of the polycube of each quadrangle
  /// the reference of each quadrangle: that of the facet of the body nearest to its center, 0 if this has none
  std::vector<int> facet_references;
  /// the quadrangles of interfaces, between hexahedra of two subdomains, counterclockwise seen from the larger one
  std::vector<std::array<std::size_t, 4> > interface_facets = {};
  /// the hexahedra on both sides of each, first that of the subdomain with the smaller index
  std::vector<std::array<std::size_t, 2> > interface_cells = {};
  /// the reference of each: that of the facet of the interface nearest to its center, 0 if this has none
  std::vector<int> interface_references = {};
  /// the edges along curves that are kept (see `Hexahedral_mesh_features`)
  std::vector<std::array<std::size_t, 2> > edges = {};
  std::vector<int> edge_references = {};      ///< the reference of the curve of each: that of the marked edges of the body
  std::vector<std::size_t> corners = {};      ///< the vertices at corners that are kept
};

} // namespace CGAL::Polycube_meshing_3

#endif // CGAL_POLYCUBE_MESHING_3_HEXAHEDRON_SOUP_3_H
