// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Hexahedra_problem_3.h>
#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the best valid hexahedra that are found, with the layers that they need or with one along the whole boundary. The status
// and message of the result say what prevents hexahedra, or where they do not suffice.
CGAL_POLYCUBE_MESHING_3_INLINE
Found_hexahedra_3 find_hexahedra_3(const Hexahedra_problem_3& problem, const Budget& budget);

} // namespace CGAL::Polycube_meshing_3::internal

#ifndef CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE
#  include <CGAL/Polycube_meshing_3/internal/Hexahedra/find_hexahedra_3_impl.h>
#endif

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_H
