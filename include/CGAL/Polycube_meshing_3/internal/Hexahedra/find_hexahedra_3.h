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

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/Hexahedron_soup_3.h>
#include <CGAL/Polycube_meshing_3/internal/compiled_engine.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Finds hexahedra by a map to a domain whose boundary facets are orthogonal to the axes, with the layers that the mesh needs or
// with one along the whole boundary; on request they keep the interfaces between subdomains. The mesh is written if and only if
// no hexahedron is inverted.
CGAL_POLYCUBE_MESHING_3_INLINE
Hexahedral_mesh_result find_hexahedra_3(const Mapped_soup_3& soup, double spacing, Linear_solver_3& solver,
                                        bool is_parallel, const Budget& budget, double minimum_scaled_jacobian,
                                        bool do_keep_interfaces, Hexahedron_soup_3& mesh);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE
#  include <CGAL/Polycube_meshing_3/internal/Hexahedra/find_hexahedra_3_impl.h>
#endif

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_H
