// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_HEXAHEDRA_IMPROVEMENT_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_HEXAHEDRA_IMPROVEMENT_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Best_hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Sliding_hexahedra_3.h>

#include <limits>
#include <optional>

namespace CGAL::Polycube_meshing_3::internal {

// Improves hexahedra, and keeps the best ones. Vertices of corners that stay inverted, or whose scaled Jacobian stays below a
// bound, leave their lines, and those of inverted corners their interfaces. Without a bound, none does.
class Hexahedra_improvement_3
{
public:
  Hexahedra_improvement_3(Sliding_hexahedra_3& hexahedra, const bool has_padding, const Budget& budget, Best_hexahedra_3& best,
                          const std::optional<double> bound_of_lines = flat_scaled_jacobian)
    : m_hexahedra(hexahedra), m_has_padding(has_padding), m_bound_of_lines(bound_of_lines), m_budget(budget), m_best(best)
  {}

  // Makes all improvements on the surface, without an end of the first ones for a small gain.
  void run()
  {
    evaluate();
    move_all((std::numeric_limits<double>::infinity)());
    polish();
  }

  // Moves vertices until no corner is inverted and their mean gains little. If vertices may leave the surface, they do so before
  // all else. Returns false if corners stay inverted there: all else would be in vain.
  bool untangle(const bool may_leave_surface)
  {
    evaluate();
    if(may_leave_surface)
    {
      const bool is_untangled = m_hexahedra.leave_and_return();
      evaluate();
      if(!is_untangled)
        return false;
    }
    constexpr double least_gain = 0.002; // a guess
    move_all(least_gain);
    return true;
  }

  // Improves the worst corners if few are inverted, and the distance from the boundary.
  void polish()
  {
    if(has_few_inverted_corners())
      improve_corners();
    approach_boundary();
  }

private:
  static constexpr int number_of_rounds = 10, patience = 3; // guesses; the latter in rounds without a gain
  static constexpr std::size_t first_steps = 10, steps = 3; // guesses; of Newton's method in the first round and in others
  static constexpr double usual_price = 0.03, smallest_price = 0.0003; // guesses; of uncovered points

  // Returns whether few corners are inverted. If more are, this is due to the map, not to the worst corners or lines.
  bool has_few_inverted_corners() const
  {
    constexpr std::size_t corners_per_inverted_corner = 100; // a guess
    return m_result.number_of_inverted_corners * corners_per_inverted_corner <= 8 * m_result.number_of_cells;
  }

  // Returns whether only the last corners are inverted, which are left to moves of single vertices.
  bool has_last_inverted_corners() const
  {
    return m_result.number_of_inverted_corners > 0
           && m_result.number_of_inverted_corners * corners_per_last_inverted_one <= 8 * m_result.number_of_cells;
  }

  // Returns whether a corner is so flat that it holds up steps for all vertices.
  bool is_held_up() const
  {
    constexpr double nearly_flat = 0.001; // a guess
    return std::abs(m_result.minimum_scaled_jacobian) <= nearly_flat;
  }

  // Measures the hexahedra as they are, and keeps them if they are the best ones.
  void evaluate()
  {
    m_result = evaluated_hexahedra(m_hexahedra.mesh(), m_has_padding);
    m_result.boundary_distance = m_hexahedra.boundary_distance();
    m_best.take_if_better(m_result, m_hexahedra.mesh());
  }

  // Moves vertices one after the other: for all corners below a target, and then, if some are poor, for the worst ones alone, as
  // others would count as much with a target far above these. While hexahedra are inverted, uncovered points count little.
  void smooth(const double price_of_uncovered)
  {
    for(const double gain : { 0.2, 0.05 }) // guesses
    {
      const bool is_valid = m_result.has_valid_mesh;
      m_hexahedra.smooth((is_valid ? m_result.minimum_scaled_jacobian : 0) + gain, is_valid ? price_of_uncovered : smallest_price);
      evaluate();
      if(is_at_least(m_result, poor_scaled_jacobian))
        break;
    }
  }

  // Moves all vertices at once: first those inside, then all, and in the end for the sake of poor corners, until no corner is
  // inverted and a round gains little for the mean. Where corners are inverted or almost flat in between, their vertices move one
  // after the other. They alone move while that untangles some and corners are so flat that they hold up all others, or while
  // only the last corners are inverted and that is not in vain. Rounds that do not halve the number of inverted corners are in
  // vain; then their vertices may leave lines, and later interfaces.
  void move_all(const double least_gain)
  {
    constexpr int number_of_first_rounds = 3; // a guess
    std::size_t fewest_inverted_corners = m_result.number_of_inverted_corners;
    for(int round = 0, in_vain = 0; round < number_of_rounds && in_vain < (has_few_inverted_corners() ? patience : patience - 1)
        && m_budget.may_begin_round(Phase::HEXAHEDRA, "corners"); ++round)
    {
      if(in_vain == patience - 1 && m_bound_of_lines && m_hexahedra.leave_lines_and_interfaces(0))
        in_vain = 0;
      const Hexahedral_mesh_result before = m_result;
      if(round > 0 && m_result.minimum_scaled_jacobian < flat_scaled_jacobian)
        smooth(usual_price);
      const double mean = m_result.mean_scaled_jacobian;
      if((!is_held_up() || !(inverted(m_result) < inverted(before))) && (in_vain == patience - 1 || !has_last_inverted_corners()))
      {
        m_hexahedra.improve(round == 0 ? first_steps : steps, round > 0,
                            round < number_of_first_rounds ? Corners_to_improve::ALL : Corners_to_improve::POOR);
        evaluate();
      }
      in_vain = m_result.number_of_inverted_corners <= fewest_inverted_corners / 2 ? 0 : in_vain + 1;
      fewest_inverted_corners = (std::min)(fewest_inverted_corners, m_result.number_of_inverted_corners);
      if(round + 1 >= number_of_first_rounds && m_result.number_of_inverted_corners == 0
         && m_result.mean_scaled_jacobian < mean + least_gain)
        break;
    }
  }

  // Improves corners, the worst ones most, and the hexahedra that are inverted inside, all vertices at once and, until the least
  // scaled Jacobian suffices, one vertex after the other in turn, until a few rounds gain neither for the least one nor the mean.
  // While corners are inverted, a gain is a smaller number of inverted corners or hexahedra than ever before. If a round gains
  // nothing, and corners are positive, but hexahedra poor or inverted inside, points that the boundary does not cover count less,
  // and the vertices of corners below the bound leave their lines.
  void improve_corners()
  {
    constexpr double least_gain = 0.005, least_gain_of_mean = 0.002; // guesses; in a round
    const auto suffices = [this]
    { return m_result.minimum_scaled_jacobian >= sufficient_scaled_jacobian && m_result.number_of_inverted_hexahedra == 0; };
    double price_of_uncovered = usual_price;
    std::size_t fewest_corners = m_result.number_of_inverted_corners, fewest_hexahedra = m_result.number_of_inverted_hexahedra;
    for(int round = 0, in_vain = 0;
        round < number_of_rounds && in_vain < (suffices() ? 1 : patience)
        && m_budget.may_begin_round(Phase::HEXAHEDRA, "worst corners"); ++round)
    {
      const double before = m_result.minimum_scaled_jacobian, mean = m_result.mean_scaled_jacobian;
      if((round > 0 || suffices()) && !is_held_up() && !has_last_inverted_corners())
      {
        m_hexahedra.improve(first_steps, true, Corners_to_improve::WORST_ANGLES);
        evaluate();
      }
      if(!suffices())
        smooth(price_of_uncovered);
      const bool is_gain = (m_result.number_of_inverted_corners == 0
                            && (m_result.minimum_scaled_jacobian > before + least_gain
                                || m_result.mean_scaled_jacobian > mean + least_gain_of_mean))
                           || m_result.number_of_inverted_corners < fewest_corners
                           || m_result.number_of_inverted_hexahedra < fewest_hexahedra;
      fewest_corners = (std::min)(fewest_corners, m_result.number_of_inverted_corners);
      fewest_hexahedra = (std::min)(fewest_hexahedra, m_result.number_of_inverted_hexahedra);
      in_vain = is_gain ? 0 : in_vain + 1;
      if(in_vain > 0 && m_result.number_of_inverted_corners == 0 && !is_at_least(m_result, poor_scaled_jacobian))
      {
        if(m_bound_of_lines)
          m_hexahedra.leave_lines_and_interfaces(*m_bound_of_lines);
        price_of_uncovered = (std::max)(smallest_price, price_of_uncovered / 10);
      }
    }
  }

  // Pulls hexahedra more and more to points of the boundary that are far away, as long as that leads to better ones. Hexahedra may
  // be of any length there, as in tips.
  void approach_boundary()
  {
    constexpr double growth = 4; // a guess; of the weight
    double weight = 1;
    for(int round = 0, in_vain = 0;
        round < number_of_rounds && in_vain < patience && m_result.number_of_inverted_hexahedra == 0
        && m_best.result.boundary_distance > sufficient_distance * m_best.edge
        && m_budget.may_begin_round(Phase::HEXAHEDRA, "far points"); ++round)
    {
      const Hexahedral_mesh_result before = m_best.result;
      weight *= growth;
      m_hexahedra.improve(steps, true, Corners_to_improve::WORST_ANGLES, weight);
      evaluate();
      smooth(usual_price * weight);
      in_vain = is_better(m_best.result, before, m_best.edge) ? 0 : in_vain + 1;
    }
  }

  Sliding_hexahedra_3& m_hexahedra;
  const bool m_has_padding;
  const std::optional<double> m_bound_of_lines;
  const Budget& m_budget;
  Best_hexahedra_3& m_best;
  Hexahedral_mesh_result m_result; // of the hexahedra as they are
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_HEXAHEDRA_IMPROVEMENT_3_H
