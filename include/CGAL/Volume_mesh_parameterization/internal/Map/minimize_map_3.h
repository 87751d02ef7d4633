// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MINIMIZE_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MINIMIZE_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The cells far above both the median and the mean of the energy.
struct Dominant_cells_3
{
  std::vector<std::size_t> cells; // the first one holds most
  double part_of_energy = 0;      // that all of them hold
  double logarithmic_mean = 0;    // of 1 + the energy of all cells, each capped far above the median

  bool hold_majority() const { return part_of_energy > 0.5; }
};

inline Dominant_cells_3 dominant_cells_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy,
                                         const Matrix3Xd& image)
{
  constexpr double far_above = 100; // a guess; times the median
  const std::vector<double> psi
    = energies_of_cells_3(singular_values_of_cells_3(mesh, image), energy, factor_to_source_volume(mesh, image));
  const std::vector<double> weights = cell_weights(mesh);
  const double mean = std::inner_product(psi.begin(), psi.end(), weights.begin(), 0.);
  std::vector<double> sorted = psi;
  const auto median = sorted.begin() + sorted.size() / 2;
  std::nth_element(sorted.begin(), median, sorted.end());
  const double high = far_above * *median, bound = (std::max)(high, mean);
  Dominant_cells_3 result;
  for(std::size_t c = 0; c < psi.size(); ++c)
  {
    result.logarithmic_mean += weights[c] * std::log1p((std::min)(psi[c], high));
    if(!(psi[c] > bound))
      continue;
    result.part_of_energy += weights[c] * psi[c] / mean;
    result.cells.push_back(c);
    if(psi[c] > psi[result.cells.front()])
      std::swap(result.cells.front(), result.cells.back());
  }
  return result;
}

// Judges, every five steps, whether a minimization still gains. The energy stagnates if it has fallen by less than a
// tolerance times itself, and the squared Newton decrement, which falls fast near a minimum, has hardly fallen. If few cells
// hold most of the energy, it may fall for these cells alone: the minimization crawls. The mean of the logarithms, in which they
// count like others, shows this: it has not become notably lower for a hundred steps.
class Gain_3
{
public:
  static constexpr double large_energy = 100; // a guess; a mean that hints at dominant cells

  Gain_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, const double tolerance)
    : m_mesh(mesh), m_energy(energy), m_tolerance(tolerance)
  {}

  const std::vector<std::size_t>& dominant_cells() const { return m_dominant.cells; } // of the last image looked at

  // Why the minimization over all vertices was ended.
  std::string describe_dominant_cells() const
  {
    return sentence(m_dominant.cells.size(), " of ", m_mesh.cells.size(), " cells hold ",
                    std::floor(100 * m_dominant.part_of_energy), " % of the energy, because prescribed vertices make these "
                      "cells flat. Further steps would hardly lower the energy, or only in these cells. The cell at ",
                    describe(m_mesh.source.col(m_mesh.cells[m_dominant.cells.front()][0])),
                    " has the largest part. A boundary with less distortion there, or vertices that slide, would help. The "
                    "other vertices were then moved until they hardly improved either.");
  }

  bool is_stagnating(const Newton_iterate_3& iterate)
  {
    const double energy = iterate.evaluation.energy;
    m_smallest_decrement = (std::min)(m_smallest_decrement, -iterate.direction.slope);
    if(++m_number_of_steps % interval != 0)
      return false;
    const bool result = m_last_energy - energy < m_tolerance * energy && m_smallest_decrement > 0.1 * m_last_decrement;
    m_last_energy = energy;
    m_last_decrement = m_smallest_decrement;
    m_smallest_decrement = std::numeric_limits<double>::infinity();
    return result;
  }

  // Returns the status with which to end, or nothing: OK if nothing is gained, and ERROR_NOT_CONVERGED if few cells dominate the
  // energy and all others gain nothing.
  std::optional<Error_code> status_of_end(const Newton_iterate_3& iterate)
  {
    constexpr std::size_t patience = 100; // a guess; number of steps
    constexpr double notable = 1e-3; // a guess; in the mean of logarithms
    const bool stagnates = is_stagnating(iterate);
    if(m_number_of_steps % interval != 0 || !(stagnates || iterate.energy() > large_energy))
      return std::nullopt;
    if(!is_dominated(iterate.positions()))
      return stagnates ? std::optional(OK) : std::nullopt;
    if(m_dominant.logarithmic_mean < m_lowest_mean - notable)
    {
      m_lowest_mean = m_dominant.logarithmic_mean;
      m_step_of_lowest_mean = m_number_of_steps;
    }
    m_is_crawling = stagnates || m_number_of_steps >= m_step_of_lowest_mean + patience;
    return m_is_crawling ? std::optional(ERROR_NOT_CONVERGED) : std::nullopt;
  }

  // Do a few cells hold most of the energy where the minimization has crawled, or has reached a minimum?
  bool is_dominated_at_end(const Newton_result_3& end)
  { return m_is_crawling || (end.status == OK && end.energy > large_energy && is_dominated(end.positions)); }

private:
  bool is_dominated(const Matrix3Xd& image)
  {
    if(m_mesh.is_whole()) // the median of a part is not that of all
      m_dominant = dominant_cells_3(m_mesh, m_energy, image);
    return m_dominant.hold_majority();
  }

  static constexpr std::size_t interval = 5; // a guess; number of steps between two looks at the gain

  const Numbered_mesh_3& m_mesh;
  const Cell_energy_3& m_energy;
  double m_tolerance;
  std::size_t m_number_of_steps = 0;
  double m_last_energy = std::numeric_limits<double>::infinity();
  double m_smallest_decrement = std::numeric_limits<double>::infinity();
  double m_last_decrement = std::numeric_limits<double>::infinity();
  Dominant_cells_3 m_dominant;
  double m_lowest_mean = std::numeric_limits<double>::infinity();
  std::size_t m_step_of_lowest_mean = 0;
  bool m_is_crawling = false;
};

// Ends a minimization where nothing is gained.
inline Ends_here ends_if_stagnating(const Numbered_mesh_3& mesh, const Map_problem_3& problem)
{
  return [gain = Gain_3(mesh, problem.energy, problem.options.energy_tolerance)](const Newton_iterate_3& iterate) mutable
  { return gain.is_stagnating(iterate) ? std::optional(OK) : std::nullopt; };
}

// Returns the unknowns that are vertices of no chosen cell.
inline Unknowns_3 unknowns_without_cells(const Numbered_mesh_3& mesh, const Unknowns_3& unknowns,
                                         const std::vector<std::size_t>& cells)
{
  std::vector<bool> is_chosen(mesh.number_of_vertices());
  for(const std::size_t c : cells)
    for(const int v : mesh.cells[c])
      is_chosen[v] = true;
  return unknowns.without([&](const int v) { return is_chosen[v]; });
}

// Minimizes over the free vertices, from a map without inverted cells on. Prescribed vertices may make a few cells so flat that
// they hold most of the energy. Such cells crawl along curved valleys for thousands of steps, and their stiffness keeps the
// others from their minimum. Then the minimization ends as soon as the energy stagnates, or falls for these cells alone.
// A second minimization moves the vertices of no such cell.
inline Found_map_3 minimize_map_3(Newton_system_3& system, const Map_problem_3& problem, Found_map_3 found)
{
  const Numbered_mesh_3& mesh = system.mesh();
  Progress_3& progress = problem.progress;
  const double negligible_gain = problem.options.negligible_gain();
  const auto take = [&](const Newton_result_3& result)
  {
    found.map = evaluated_map(mesh, snapped(mesh, result.positions));
    found.status = result.status;
    found.reason = result.reason;
    progress.end_check();
  };
  Gain_3 gain(mesh, problem.energy, problem.options.energy_tolerance);
  progress.begin_attempt("minimization");
  const Newton_result_3 whole = minimize_energy_3(
    system, problem.energy, found.map.positions, progress, Negative_curvature(found.may_be_near_minimum ? 1 : 0),
    [&](const Newton_iterate_3& iterate) { return gain.status_of_end(iterate); }, negligible_gain);
  take(whole);
  if(!gain.is_dominated_at_end(whole))
    return found;

  const Unknowns_3 other_unknowns = unknowns_without_cells(mesh, system.unknowns(), gain.dominant_cells());
  if(other_unknowns.size() == 0)
    return found;
  Newton_system_3 rest(mesh, other_unknowns, system.solver());
  progress.begin_attempt("minimization apart from dominant cells");
  take(minimize_energy_3(rest, problem.energy, whole.positions, progress, Negative_curvature(),
                         ends_if_stagnating(mesh, problem), negligible_gain));
  if(found.status == OK || found.status == ERROR_NOT_CONVERGED)
    found.status = whole.status; // counts, as the energy of all vertices is to be minimal
  if(found.status == ERROR_NOT_CONVERGED)
    found.reason = gain.describe_dominant_cells();
  return found;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MINIMIZE_MAP_3_H
