// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_NORMAL_LABELS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_NORMAL_LABELS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Polycube_charts_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>

#include <CGAL/boost/graph/Dual.h>
#include <CGAL/boost/graph/alpha_expansion_graphcut.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Dense>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Labels the faces of a surface with axis directions that are close to their normals and change along short lines, as
// Livesu et al., PolyCut: monotone graph-cuts for polycube base-complex construction (2013). The labels minimize
//   sum over faces f of area(f) (1 - n(f) . direction(label(f)))
//   + smoothing sum over edges between faces f, g of different labels of length max(0, n(f) . n(g))^2,
// by alpha expansion. Sharp edges are free. Around edges at which opposite directions meet, which no polycube has,
// labels of their axis are made expensive, until no more can be done against such edges.
class Normal_labels_3
{
public:
  using Labels = std::vector<std::size_t>;

  // The surface has diameter about 1, so that lengths and areas compare.
  Normal_labels_3(const Boundary_mesh_3& mesh, const double smoothing, const Budget& budget)
    : m_mesh(mesh), m_smoothing(smoothing), m_budget(budget),
      m_is_expensive(mesh.number_of_faces(), { false, false, false })
  {
    for(const auto f : mesh.faces())
    {
      const auto h = mesh.halfedge(f);
      const Eigen::Vector3d a = eigen_point(mesh, mesh.source(h)), b = eigen_point(mesh, mesh.target(h)),
                            c = eigen_point(mesh, mesh.target(mesh.next(h)));
      m_area_vectors.push_back((b - a).cross(c - a) / 2);
    }
  }

  Labels minimize()
  {
    Labels labels = cut();
    while(!m_budget.is_exhausted() && has_opposite_neighbours(labels))
      labels = cut();
    return labels;
  }

  double cost(const Boundary_mesh_3::Face_index f, const std::size_t label) const
  {
    const double factor = m_is_expensive[f][axis_of_direction(label)] ? 10 : 1;
    return factor * m_area_vectors[f].norm() - m_area_vectors[f].dot(vector_of_direction(label));
  }

  // What it costs if the faces on the sides of the edge have different labels.
  double cost(const Boundary_mesh_3::Edge_index e) const
  {
    const auto h = m_mesh.halfedge(e);
    const Eigen::Vector3d n = m_area_vectors[m_mesh.face(h)].normalized();
    const Eigen::Vector3d m = m_area_vectors[m_mesh.face(m_mesh.opposite(h))].normalized();
    const double cosine = (std::max)(0., n.dot(m));
    return m_smoothing * cosine * cosine
           * (eigen_point(m_mesh, m_mesh.target(h)) - eigen_point(m_mesh, m_mesh.source(h))).norm();
  }

private:
  Labels cut() const
  {
    Labels labels;
    for(const auto f : m_mesh.faces())
    {
      const std::vector<double> costs = costs_of_face(f);
      labels.push_back(std::min_element(costs.begin(), costs.end()) - costs.begin());
    }
    struct Interruption {}; // the only way out of the expansion
    const auto ask = [this]
    {
      if(m_budget.is_exhausted())
        throw Interruption();
    };
    const auto edge_costs = boost::make_function_property_map<Boundary_mesh_3::Edge_index>(
      [&](const Boundary_mesh_3::Edge_index e) { ask(); return cost(e); });
    const auto label_costs = boost::make_function_property_map<Boundary_mesh_3::Face_index>(
      [&](const Boundary_mesh_3::Face_index f) { ask(); return costs_of_face(f); });
    const auto index = get(boost::face_index, m_mesh);
    try
    {
      alpha_expansion_graphcut(Dual<const Boundary_mesh_3>(m_mesh), edge_costs, label_costs,
                               boost::make_iterator_property_map(labels.begin(), index),
                               parameters::vertex_index_map(index));
    }
    catch(const Interruption&) {}
    return labels;
  }

  std::vector<double> costs_of_face(const Boundary_mesh_3::Face_index f) const
  {
    std::vector<double> costs;
    for(std::size_t label = 0; label < 6; ++label)
      costs.push_back(cost(f, label));
    return costs;
  }

  // Makes them expensive. Returns whether there are any that have not been so before.
  bool has_opposite_neighbours(const Labels& labels)
  {
    bool has_changed = false;
    for(const auto h : m_mesh.halfedges())
    {
      const std::size_t label = labels[m_mesh.face(h)], neighbour = labels[m_mesh.face(m_mesh.opposite(h))];
      if(label == neighbour || axis_of_direction(label) != axis_of_direction(neighbour))
        continue;
      for(const auto k : CGAL::halfedges_around_target(h, m_mesh))
      {
        bool& is_expensive = m_is_expensive[m_mesh.face(k)][axis_of_direction(label)];
        has_changed = has_changed || !is_expensive;
        is_expensive = true;
      }
    }
    return has_changed;
  }

  const Boundary_mesh_3& m_mesh;
  const double m_smoothing;
  const Budget& m_budget;
  std::vector<std::array<bool, 3> > m_is_expensive; // for each face, labels of each axis
  std::vector<Eigen::Vector3d> m_area_vectors;      // normal times area
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_NORMAL_LABELS_3_H
