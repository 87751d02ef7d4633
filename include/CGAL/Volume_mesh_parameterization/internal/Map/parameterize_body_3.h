// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/check_derivatives.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Map_problem_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The seam of the map: all between arrays and the images of points. It knows no complex, an energy only as `Cell_energy_3`, and
// a solver only as `Linear_solver_3`, so that it can be compiled once.

// Map of a body: images of its points, with those of the insertions, if the result has a valid map.
struct Body_map_3
{
  Parameterization_result result;
  std::vector<std::array<double, 3> > images;
  std::vector<Insertion_3> insertions;
};

// Maps a body. Whoever moves the body there does not keep a second copy of the cells.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Body_map_3 parameterize_body_3(Body_3 body, const Prescription_3& prescription, const Map_problem_3& problem);

// Maps a body and refines it further; `insertions` have refined it before.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Body_map_3 refine_and_parameterize_body_3(Body_3& body, Prescription_3 prescription, const Map_problem_3& problem,
                                          std::vector<Insertion_3> insertions = {});

// Returns the distortion of the map from the points of a body to images.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Distortion_3 distortion_of_body_3(const Body_3& body, const std::vector<std::array<double, 3> >& images);

// A line of `verbose`.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void print(const Parameterization_step& step);

// Prints which derivatives of the energy are wrong. An energy that is not finite where it is tried cannot be compared.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void print(const Derivative_errors_3& errors);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_H
