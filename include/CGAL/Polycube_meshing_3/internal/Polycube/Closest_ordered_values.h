// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_CLOSEST_ORDERED_VALUES_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_CLOSEST_ORDERED_VALUES_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Order of two coordinates: the second one must be larger than the first one by the distance.
struct Order_of_coordinates
{
  std::size_t first, second;
  double distance;
};

// Values, each as the mean position of its tree and the distance from there, which is a sum of distances of orders.
struct Values_on_trees
{
  std::vector<double> bases, offsets;
};

// Values that are closest to wanted ones, by weighted least squares, among those in given orders. The method is the dual one of
// Goldfarb and Idnani [A numerically stable dual method for solving strictly convex quadratic programs, 1983]. Orders that hold
// with equality are the edges of trees of values, which move as one: linear systems are solved from the leaves to the roots.
class Closest_ordered_values
{
public:
  // Takes positive weights, and orders that do not contradict each other.
  Closest_ordered_values(const std::vector<double>& weights, const std::vector<double>& wanted,
                         const std::vector<Order_of_coordinates>& orders)
    : m_weights(weights), m_wanted(wanted), m_orders(orders), m_values(wanted), m_multipliers(orders.size(), 0)
  {}

  // Enforces the order that is violated most, until none is violated by more than rounding, and returns the values.
  Values_on_trees run()
  {
    constexpr double tolerance = 1e-12;
    const std::size_t maximum_number_of_steps = 100 * m_orders.size(); // far above what is needed
    for(std::size_t step = 0; step < maximum_number_of_steps; ++step)
    {
      std::size_t worst = none;
      double largest = tolerance;
      for(std::size_t k = 0; k < m_orders.size(); ++k)
        if(violation(k) > largest)
        {
          largest = violation(k);
          worst = k;
        }
      if(worst == none || !enforce(worst))
        break;
    }
    return values_on_trees();
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Value in the trees, in which values stand behind their parents.
  struct Node
  {
    std::size_t value, order_to_parent; // none at a root
  };

  double violation(const std::size_t k) const
  { return m_orders[k].distance - (m_values[m_orders[k].second] - m_values[m_orders[k].first]); }

  std::size_t other(const std::size_t k, const std::size_t value) const
  { return m_orders[k].first == value ? m_orders[k].second : m_orders[k].first; }

  // Finds the trees of the orders that hold with equality.
  void update_trees()
  {
    std::vector<std::vector<std::size_t> > orders_of_value(m_values.size());
    for(const std::size_t k : m_active)
      for(const std::size_t value : { m_orders[k].first, m_orders[k].second })
        orders_of_value[value].push_back(k);
    m_nodes.clear();
    m_trees.assign(m_values.size(), none);
    for(std::size_t root = 0; root < m_values.size(); ++root)
    {
      if(m_trees[root] != none)
        continue;
      m_trees[root] = root;
      std::size_t i = m_nodes.size();
      for(m_nodes.push_back({ root, none }); i < m_nodes.size(); ++i)
        for(const std::size_t k : orders_of_value[m_nodes[i].value])
          if(const std::size_t next = other(k, m_nodes[i].value); m_trees[next] == none)
          {
            m_trees[next] = root;
            m_nodes.push_back({ next, k });
          }
    }
  }

  // Returns the sum over each tree, at its root.
  std::vector<double> sums_of_trees(const std::vector<double>& x) const
  {
    std::vector<double> result(x.size(), 0);
    for(std::size_t i = 0; i < x.size(); ++i)
      result[m_trees[i]] += x[i];
    return result;
  }

  // Moves values until a violated order holds with equality, together with the multipliers of the orders that did before. Orders
  // whose multipliers become 0 are released on the way. Returns whether that is possible.
  bool enforce(const std::size_t p)
  {
    while(true)
    {
      update_trees();
      std::vector<double> forces(m_values.size(), 0);
      forces[m_orders[p].first] = -1;
      forces[m_orders[p].second] = 1;
      const std::vector<double> weights = sums_of_trees(m_weights), forces_of_trees = sums_of_trees(forces);
      std::vector<double> speeds(m_values.size()), rates(m_orders.size(), 0); // of values and multipliers, by the multiplier of p
      for(std::size_t i = 0; i < m_values.size(); ++i)
      {
        speeds[i] = forces_of_trees[m_trees[i]] / weights[m_trees[i]];
        forces[i] -= m_weights[i] * speeds[i];
      }
      for(auto node = m_nodes.rbegin(); node != m_nodes.rend(); ++node)
        if(const std::size_t k = node->order_to_parent; k != none)
        {
          rates[k] = m_orders[k].second == node->value ? -forces[node->value] : forces[node->value];
          forces[other(k, node->value)] += forces[node->value];
        }

      const double speed = speeds[m_orders[p].second] - speeds[m_orders[p].first];
      double step = speed > 0 ? violation(p) / speed : (std::numeric_limits<double>::infinity)();
      auto released = m_active.end();
      for(auto k = m_active.begin(); k != m_active.end(); ++k)
        if(rates[*k] < 0 && m_multipliers[*k] < -rates[*k] * step)
        {
          step = m_multipliers[*k] / -rates[*k];
          released = k;
        }
      if(!(step < (std::numeric_limits<double>::infinity)()))
        return false;
      for(std::size_t i = 0; i < m_values.size(); ++i)
        m_values[i] += step * speeds[i];
      for(const std::size_t k : m_active)
        m_multipliers[k] += step * rates[k];
      m_multipliers[p] += step;
      if(released == m_active.end())
      {
        m_active.push_back(p);
        return true;
      }
      m_multipliers[*released] = 0;
      m_active.erase(released);
    }
  }

  // Returns the values without the rounding of the steps.
  Values_on_trees values_on_trees()
  {
    update_trees();
    Values_on_trees result = { {}, std::vector<double>(m_values.size(), 0) };
    for(const auto& [value, k] : m_nodes)
      if(k != none)
        result.offsets[value] = result.offsets[other(k, value)] + (m_orders[k].second == value ? 1 : -1) * m_orders[k].distance;
    std::vector<double> moments;
    for(std::size_t i = 0; i < m_values.size(); ++i)
      moments.push_back(m_weights[i] * (m_wanted[i] - result.offsets[i]));
    const std::vector<double> weights = sums_of_trees(m_weights), moments_of_trees = sums_of_trees(moments);
    for(const std::size_t tree : m_trees)
      result.bases.push_back(moments_of_trees[tree] / weights[tree]);
    return result;
  }

  const std::vector<double>& m_weights;
  const std::vector<double>& m_wanted;
  const std::vector<Order_of_coordinates>& m_orders;
  std::vector<double> m_values, m_multipliers;
  std::vector<std::size_t> m_active; // orders that hold with equality
  std::vector<Node> m_nodes;
  std::vector<std::size_t> m_trees; // for each value the root of its tree
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_CLOSEST_ORDERED_VALUES_H
