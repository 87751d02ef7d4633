// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SEARCH_START_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SEARCH_START_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Dynamic_matrix.h>

#include <cstddef>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Where a search for a map starts, and what the searches before the last refinements have come to.
struct Search_start_3
{
  enum class Stage { NONE, UNTANGLING, SOFT_BOUNDARY };

  Stage stage = Stage::NONE;        // that continues from the positions; the others start anew
  Matrix3Xd positions = {};         // the images of all vertices, which the soft boundary takes only without inverted cells
  std::size_t number_of_raises = 0; // of the weight of the soft boundary, that have led there
  double distance = std::numeric_limits<double>::infinity(); // the largest one to a target, where that was blocked
  double smallest_distance = std::numeric_limits<double>::infinity(); // of those after all refinements
  std::size_t number_of_vain_refinements = 0; // that did not lower that
  std::size_t fewest_inverted_cells = (std::numeric_limits<std::size_t>::max)(); // that rounds of splits have left
  std::size_t number_of_vain_rounds = 0; // of splits that did not make them fewer
  bool may_split = false;           // may edges be split after the search?
  std::size_t patience = (std::numeric_limits<std::size_t>::max)(); // raises in vain, one after the other, that end it

  // After two rounds in vain, a guess, cells that untangling leaves inverted are left to the soft boundary.
  bool has_given_up_splits() const { return number_of_vain_rounds >= 2; }
  bool may_split_inverted_cells() const { return may_split && !has_given_up_splits(); }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SEARCH_START_3_H
