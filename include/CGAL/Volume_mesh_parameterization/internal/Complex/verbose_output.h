// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_VERBOSE_OUTPUT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_VERBOSE_OUTPUT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>

#include <iomanip>
#include <iostream>

namespace CGAL::Volume_mesh_parameterization::internal {

// Says what is going to be solved, and by which linear solver.
inline void print(const Numbered_mesh_3& mesh, const Linear_solver_3& solver)
{
  std::cout << mesh.cells.size() << " cells, " << mesh.number_of_vertices() << " vertices, "
            << mesh.number_of_free_vertices << " of them free; linear solver " << solver.name() << std::endl;
}

inline void print(const Parameterization_step& step)
{
  std::cout << std::setw(5) << step.iteration
            << (step.phase == Phase::UNTANGLING ? " untangling  " : " minimization")
            << "  energy " << std::setw(12) << step.energy
            << "  inverted " << std::setw(6) << step.number_of_inverted_cells
            << "  gradient " << std::setw(11) << step.gradient_norm
            << "  decrement " << std::setw(11) << step.decrement
            << "  step " << std::setw(9) << step.step_length
            << "  seconds " << step.seconds << "  " << step.attempt << std::endl;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_VERBOSE_OUTPUT_H
