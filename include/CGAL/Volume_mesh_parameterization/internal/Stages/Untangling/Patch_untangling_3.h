// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_UNTANGLING_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_UNTANGLING_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Untangler_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Untangling_setting.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Untangles what a global search has left: each inverted cell with a ring of neighbors, then with two, as a problem of its
// own in which all other vertices are prescribed where they are. Small problems get past what stops the whole, in
// thousandths of a second. A step is a patch.
class Patch_untangling_3 : public Stage_3
{
public:
  Patch_untangling_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, Eigen::Matrix3Xd positions)
    : m_mesh(mesh), m_solver(solver), m_positions(std::move(positions)), m_cells_of_vertex(mesh.number_of_free_vertices)
  {
    for(std::size_t c = 0; c < mesh.cells.size(); ++c)
      for(const int v : mesh.cells[c])
        if(mesh.is_free(v))
          m_cells_of_vertex[v].push_back(c);
    begin_sweep();
  }

  void step() override
  {
    const std::size_t cell = m_waiting.back();
    m_waiting.pop_back();
    if(!is_positive(m_positions, m_mesh.cells[cell]))
      untangle(free_vertices_around(cell));
    next_step(Phase::UNTANGLING).number_of_inverted_cells = m_number_of_inverted_cells;
    if(m_waiting.empty())
    {
      ++m_number_of_rings;
      begin_sweep();
    }
  }

  Eigen::Matrix3Xd positions() const override { return m_positions; }
  bool is_flip_free() const override { return m_number_of_inverted_cells == 0; }

private:
  static constexpr int maximal_number_of_rings = 2;
  static constexpr int maximal_number_of_steps = 60;

  void begin_sweep()
  {
    for(std::size_t c = 0; c < m_mesh.cells.size(); ++c)
      if(!is_positive(m_positions, m_mesh.cells[c]))
        m_waiting.push_back(c);
    m_number_of_inverted_cells = m_waiting.size();
    if(m_waiting.empty())
      end(OK);
    else if(m_number_of_rings > maximal_number_of_rings)
      end(ERROR_NOT_FLIP_FREE);
  }

  std::set<int> free_vertices_around(const std::size_t cell) const
  {
    std::set<int> result;
    add_free_vertices(cell, result);
    for(int ring = 1; ring < m_number_of_rings; ++ring)
      for(const int v : std::set<int>(result))
        for(const std::size_t c : m_cells_of_vertex[v])
          add_free_vertices(c, result);
    return result;
  }

  void add_free_vertices(const std::size_t cell, std::set<int>& vertices) const
  {
    for(const int v : m_mesh.cells[cell])
      if(m_mesh.is_free(v))
        vertices.insert(v);
  }

  // Moves these vertices if fewer cells around them are inverted then.
  void untangle(const std::set<int>& free)
  {
    std::set<std::size_t> cells;
    for(const int v : free)
      cells.insert(m_cells_of_vertex[v].begin(), m_cells_of_vertex[v].end());
    std::vector<int> vertices(free.begin(), free.end()); // of the patch, the free ones first
    std::map<int, int> number;
    for(const int v : vertices)
      number.emplace(v, static_cast<int>(number.size()));

    Numbered_mesh_3 patch;
    patch.number_of_free_vertices = static_cast<int>(vertices.size());
    for(const std::size_t c : cells)
    {
      patch.cells.push_back(m_mesh.cells[c]);
      for(int& v : patch.cells.back())
      {
        const auto inserted = number.emplace(v, static_cast<int>(number.size()));
        if(inserted.second)
          vertices.push_back(v);
        v = inserted.first->second;
      }
    }
    Eigen::Matrix3Xd positions(3, vertices.size());
    patch.source.resize(3, vertices.size());
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      patch.source.col(i) = m_mesh.source.col(vertices[i]);
      positions.col(i) = m_positions.col(vertices[i]);
    }
    patch.target = positions;
    patch.target.leftCols(free.size()).setZero();

    // the volume does not depend on the free vertices
    if(volume(patch, patch.target) > 0 && improve(patch, positions))
      for(std::size_t i = 0; i < free.size(); ++i)
        m_positions.col(vertices[i]) = positions.col(i);
  }

  // From the positions and from the harmonic map, with each setting, until no cell is inverted. Returns whether fewer are.
  bool improve(const Numbered_mesh_3& patch, Eigen::Matrix3Xd& positions)
  {
    const std::size_t before = inverted_cells(patch, positions).number;
    std::size_t fewest = before;
    const Eigen::Matrix3Xd start = positions;
    for(const bool is_harmonic : {false, true})
      for(const Untangling_setting& setting : untangling_settings)
      {
        if(fewest == 0)
          break;
        Newton_system_3 system(patch, reference_cells(patch, setting), free_vertices(patch), m_solver, false);
        Eigen::Matrix3Xd u = system.unit() * start;
        if(is_harmonic)
          harmonic_map_3(system, u);
        Untangler_3 untangler(system, u, setting.theta);
        for(int i = 0; i < maximal_number_of_steps && untangler.step() == Step_status::CONTINUE; ++i) {}
        const Eigen::Matrix3Xd found = snapped(patch, untangler.positions() / system.unit());
        const std::size_t number = inverted_cells(patch, found).number;
        if(number < fewest)
        {
          fewest = number;
          positions = found;
        }
      }
    m_number_of_inverted_cells -= before - fewest;
    return fewest < before;
  }

  const Numbered_mesh_3& m_mesh;
  Linear_solver_3& m_solver;
  Eigen::Matrix3Xd m_positions;
  std::vector<std::vector<std::size_t> > m_cells_of_vertex; // of each free vertex
  std::vector<std::size_t> m_waiting;                       // cells that were inverted when the sweep began
  std::size_t m_number_of_inverted_cells = 0;
  int m_number_of_rings = 1;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_UNTANGLING_3_H
