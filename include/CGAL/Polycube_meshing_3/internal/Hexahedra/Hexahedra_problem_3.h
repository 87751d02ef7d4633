// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_HEXAHEDRA_PROBLEM_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_HEXAHEDRA_PROBLEM_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/Hexahedron_soup_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Mapped_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>

namespace CGAL::Polycube_meshing_3::internal {

constexpr double usable_scaled_jacobian = 0.01; // a guess; solvers of finite elements want more, but take it

// Map of a body to a domain whose boundary facets are orthogonal to the axes, and what is wanted of its hexahedra.
struct Hexahedra_problem_3
{
  const Mapped_soup_3& soup;
  double spacing;                 // of the grid in the domain
  Linear_solver_3& solver;
  bool is_parallel;               // may threads share the work?
  double minimum_scaled_jacobian; // below which a hexahedron is poor
  bool do_keep_interfaces;        // do hexahedra follow the interfaces between subdomains?
};

// Result with hexahedra of the body; these are empty unless the result has a valid mesh.
struct Found_hexahedra_3
{
  Hexahedral_mesh_result result;
  Hexahedron_soup_3 mesh;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_HEXAHEDRA_PROBLEM_3_H
