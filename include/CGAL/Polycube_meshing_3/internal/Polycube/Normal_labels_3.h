// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_NORMAL_LABELS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_NORMAL_LABELS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Label_functional_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <algorithm>
#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Relabelling of a chart, and the increase of the cost of all labels by it.
struct Chart_relabelling_3
{
  std::size_t chart, label;
  double cost;
};

// Labels the faces of a surface with axis directions that are close to their normals and change along short lines, which lower
// the sum of `Label_functional_3`. Small regions and whole charts change their labels as long as the sum falls: nearly as far as
// with minimum cuts, which take many times as long. No polycube has edges where opposite directions meet: around such edges,
// labels of their axis are made expensive, until nothing changes.
class Normal_labels_3
{
public:
  using Labels = std::vector<std::size_t>;
  using Face = Boundary_mesh_3::Face_index;

  // Takes a surface of diameter about 1, such that lengths and areas compare, and whether each of its edges is sharp.
  Normal_labels_3(const Boundary_mesh_3& mesh, const std::vector<bool>& is_sharp, const Budget& budget)
    : m_mesh(mesh), m_budget(budget), m_is_expensive(mesh.number_of_faces(), { false, false, false })
  {
    const Label_functional_3 functional(mesh, is_sharp);
    for(const Face f : mesh.faces())
    {
      m_face_costs.emplace_back();
      for(std::size_t label = 0; label < 6; ++label)
        m_face_costs.back()[label] = functional.cost(f, label);
      m_sides.emplace_back();
      std::size_t i = 0;
      for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
        m_sides.back()[i++] = { mesh.face(mesh.opposite(h)), functional.length(h) };
      m_ring.emplace_back();
      for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        for(const Face g : CGAL::faces_around_target(mesh.halfedge(v), mesh))
          if(g != f && std::find(m_ring.back().begin(), m_ring.back().end(), g) == m_ring.back().end())
            m_ring.back().push_back(g);
    }
  }

  // Returns for each face the direction that is closest to the normal.
  Labels closest() const
  {
    Labels labels;
    for(const Costs& costs : m_face_costs)
      labels.push_back(std::min_element(costs.begin(), costs.end()) - costs.begin());
    return labels;
  }

  // Connected faces that are far from all directions and have the same two closest ones.
  struct Slope { double area = 0; std::vector<Face> faces; };

  // Returns the slopes, the largest ones first.
  std::vector<Slope> slopes() const
  {
    constexpr double least_area = 0.004, least_cost = 0.05; // guesses; parts of the whole area and of that of a face: 18 degrees
    Labels directions; // a number for the two closest ones, or 0
    for(const Face f : m_mesh.faces())
    {
      const auto [a, b] = two_closest(f);
      directions.push_back(cost(f, a) > least_cost * area_of_face(m_mesh, f) ? 1 + 6 * a + b : 0);
    }
    const auto [slope_of_face, n] = connected_charts_3(m_mesh, directions);
    std::vector<Slope> result(n);
    double whole_area = 0;
    for(const Face f : m_mesh.faces())
    {
      whole_area += area_of_face(m_mesh, f);
      if(directions[f] == 0)
        continue;
      result[slope_of_face[f]].area += area_of_face(m_mesh, f);
      result[slope_of_face[f]].faces.push_back(f);
    }
    std::stable_sort(result.begin(), result.end(), [](const Slope& a, const Slope& b) { return a.area > b.area; });
    while(!result.empty() && result.back().area < least_area * whole_area)
      result.pop_back();
    return result;
  }

  // Makes labels of the closest directions of a slope expensive, such that its faces prefer their second closest ones.
  void prefer_second_direction(const Slope& slope)
  {
    for(const Face f : slope.faces)
      m_face_costs[f][two_closest(f)[0]] += area_of_face(m_mesh, f);
  }

  // Changes labels such that the sum falls, `smoothing` being the weight of the lengths.
  void minimize(const double smoothing, Labels& labels)
  {
    const std::vector<bool> none(labels.size(), false);
    Settled_faces is_settled;
    do
    {
      is_settled.fill(none);
      while(!m_budget.is_exhausted())
        if(relabel_regions(0, smoothing, is_settled, labels))
          continue;
        else if(relabel_charts(smoothing, labels))
          is_settled.fill(none);
        else if(!relabel_regions(1, smoothing, is_settled, labels) && !relabel_regions(2, smoothing, is_settled, labels))
          break;
    }
    while(!m_budget.is_exhausted() && avoid_opposite_neighbors(labels));
  }

  // Returns the term of a face, which is raised if the label is expensive there, or not preferred.
  double cost(const Face f, const std::size_t label) const { return m_face_costs[f][label]; }

  // Returns the changes of each chart to each other label, the change with the least increase of the cost first.
  std::vector<Chart_relabelling_3> chart_relabellings(const double smoothing, const Labels& labels,
                                                      const std::vector<std::size_t>& chart_of_face) const
  {
    const std::size_t n = 1 + *std::max_element(chart_of_face.begin(), chart_of_face.end());
    std::vector<Costs> cost_of_chart(n, Costs{});
    Labels label_of_chart(n);
    for(const Face f : m_mesh.faces())
    {
      const std::size_t c = chart_of_face[f];
      label_of_chart[c] = labels[f];
      for(std::size_t label = 0; label < 6; ++label)
        cost_of_chart[c][label] += cost(f, label);
      for(const auto& [g, cost_of_edge] : m_sides[f])
        if(chart_of_face[g] != c)
          cost_of_chart[c][labels[g]] -= smoothing * cost_of_edge;
    }
    std::vector<Chart_relabelling_3> result;
    for(std::size_t c = 0; c < cost_of_chart.size(); ++c)
      for(std::size_t label = 0; label < 6; ++label)
        if(label != label_of_chart[c])
          result.push_back({ c, label, cost_of_chart[c][label] - cost_of_chart[c][label_of_chart[c]] });
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
    return result;
  }

private:
  using Costs = std::array<double, 6>;

  // Side of a face: the face beyond, and the cost of different labels on both sides with a smoothing of 1.
  struct Side { Face face; double cost; };

  // Returns the two cheapest labels of a face.
  std::array<std::size_t, 2> two_closest(const Face f) const
  {
    std::array<std::size_t, 6> order = { 0, 1, 2, 3, 4, 5 };
    std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) { return cost(f, a) < cost(f, b); });
    return { order[0], order[1] };
  }

  // Relabels the charts whose new labels lower the sum more than those of their neighbors: the gain of a chart is known as long as
  // its neighbors keep their labels. Returns whether there were any.
  bool relabel_charts(const double smoothing, Labels& labels) const
  {
    const auto [chart_of_face, n] = connected_charts_3(m_mesh, labels);
    std::vector<Chart_relabelling_3> best(n, Chart_relabelling_3{ 0, 0, 0 });
    for(const Chart_relabelling_3& change : chart_relabellings(smoothing, labels, chart_of_face))
      if(change.cost < best[change.chart].cost - least_gain)
        best[change.chart] = change;
    std::vector<bool> is_best(n);
    for(std::size_t c = 0; c < n; ++c)
      is_best[c] = best[c].cost < 0;
    for(const auto h : m_mesh.halfedges())
    {
      const std::size_t c = chart_of_face[m_mesh.face(h)], d = chart_of_face[m_mesh.face(m_mesh.opposite(h))];
      if(std::pair(best[d].cost, d) < std::pair(best[c].cost, c))
        is_best[c] = false;
    }
    for(const Face f : m_mesh.faces())
      if(is_best[chart_of_face[f]])
        labels[f] = best[chart_of_face[f]].label;
    return std::find(is_best.begin(), is_best.end(), true) != is_best.end();
  }

  // Tells, by number of rings and by face, whether the region around the face keeps its labels as long as none nearby changes.
  using Settled_faces = std::array<std::vector<bool>, 3>;

  // Gives the faces within some rings around each face on a border of charts one label, where the sum falls thereby, and updates
  // which faces are settled. Returns whether any label changed.
  bool relabel_regions(const int rings, const double smoothing, Settled_faces& is_settled, Labels& labels) const
  {
    bool has_changed = false;
    std::vector<Face> region, center_of_face(labels.size(), Boundary_mesh_3::null_face());
    for(const Face f : m_mesh.faces())
    {
      if(is_settled[rings][f]
         || std::all_of(m_sides[f].begin(), m_sides[f].end(), [&](const Side& side) { return labels[side.face] == labels[f]; }))
        continue;
      region.assign(1, f);
      center_of_face[f] = f;
      add_rings(rings, f, center_of_face, region);
      const auto [label, gain] = best_label(region, f, center_of_face, smoothing, labels);
      is_settled[rings][f] = gain <= least_gain;
      if(is_settled[rings][f])
        continue;
      has_changed = true;
      for(const Face g : region)
        labels[g] = label;
      add_rings(static_cast<int>(is_settled.size()), f, center_of_face, region); // faces whose regions touch this one
      for(const Face g : region)
        for(std::vector<bool>& of_rings : is_settled)
          of_rings[g] = false;
    }
    return has_changed;
  }

  // Adds rings of faces around a region. Faces in the region, also new ones, have its center in `center_of_face`, no others do.
  void add_rings(const int rings, const Face center, std::vector<Face>& center_of_face, std::vector<Face>& region) const
  {
    for(int ring = 0; ring < rings; ++ring)
      for(std::size_t i = 0, n = region.size(); i < n; ++i)
        for(const Face g : m_ring[region[i]])
          if(std::exchange(center_of_face[g], center) != center)
            region.push_back(g);
  }

  // Returns the cheapest label for all faces of a region, and by how much the sum falls with this label.
  std::pair<std::size_t, double> best_label(const std::vector<Face>& region, const Face center,
                                            const std::vector<Face>& center_of_face, const double smoothing,
                                            const Labels& labels) const
  {
    Costs costs{};
    double cost_before = 0;
    for(const Face f : region)
    {
      cost_before += cost(f, labels[f]);
      for(std::size_t label = 0; label < 6; ++label)
        costs[label] += cost(f, label);
      for(const auto& [g, cost_of_side] : m_sides[f])
      {
        const double cost_of_edge = smoothing * cost_of_side;
        if(center_of_face[g] != center)
        {
          costs[labels[g]] -= cost_of_edge;
          cost_before -= (labels[g] == labels[f]) ? cost_of_edge : 0;
        }
        else if(labels[g] != labels[f])
          cost_before += cost_of_edge / 2; // the edge is met from both sides
      }
    }
    const std::size_t label = std::min_element(costs.begin(), costs.end()) - costs.begin();
    return { label, cost_before - costs[label] };
  }

  // Makes labels expensive where opposite directions meet. Returns whether any label has become expensive.
  bool avoid_opposite_neighbors(const Labels& labels)
  {
    constexpr double factor = 9; // a guess; of the area
    bool has_changed = false;
    for(const auto h : m_mesh.halfedges())
    {
      const std::size_t label = labels[m_mesh.face(h)], neighbor = labels[m_mesh.face(m_mesh.opposite(h))];
      if(label == neighbor || axis_of_direction(label) != axis_of_direction(neighbor))
        continue;
      for(const auto k : CGAL::halfedges_around_target(h, m_mesh))
      {
        bool& is_expensive = m_is_expensive[m_mesh.face(k)][axis_of_direction(label)];
        if(is_expensive)
          continue;
        is_expensive = has_changed = true;
        Costs& costs = m_face_costs[m_mesh.face(k)];
        const double area = (costs[label] + costs[neighbor]) / 2; // as the scalar products in both costs cancel
        for(const std::size_t expensive : { label, neighbor })
          costs[expensive] += factor * area;
      }
    }
    return has_changed;
  }

  static constexpr double least_gain = 1e-12; // above rounding of sums of about 1, so that no change is undone by the next

  const Boundary_mesh_3& m_mesh;
  const Budget& m_budget;
  std::vector<std::array<bool, 3> > m_is_expensive; // for each face, labels of each axis
  std::vector<Costs> m_face_costs;                  // costs of a face by label
  std::vector<std::array<Side, 3> > m_sides;        // of each face
  std::vector<std::vector<Face> > m_ring;           // for each face, those with a vertex in common
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_NORMAL_LABELS_3_H
