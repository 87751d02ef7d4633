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

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/axis_direction.h>

#include <CGAL/boost/graph/Dual.h>
#include <CGAL/boost/graph/alpha_expansion_graphcut.h>

#include <Eigen/Dense>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Labels the faces of a surface with axis directions that are close to their normals and change along short lines, as
// Livesu et al., PolyCut: monotone graph-cuts for polycube base-complex construction (2013). The labels minimize
//   sum over faces f of area(f) (1 - n(f) . direction(label(f)))
//   + smoothing sum over edges between faces f, g of different labels of length max(0, n(f) . n(g))^2,
// by alpha expansion. Sharp edges are free.
class Normal_labels_3
{
public:
  // The surface has diameter about 1, so that lengths and areas compare.
  explicit Normal_labels_3(const Boundary_mesh_3& mesh) : m_mesh(mesh)
  {
    for(const auto f : mesh.faces())
    {
      const auto h = mesh.halfedge(f);
      const Eigen::Vector3d a = eigen_point(mesh, mesh.source(h)), b = eigen_point(mesh, mesh.target(h)),
                            c = eigen_point(mesh, mesh.target(mesh.next(h)));
      m_area_vectors.push_back((b - a).cross(c - a) / 2);
    }
  }

  std::vector<std::size_t> minimize(const double smoothing) const
  {
    std::vector<std::size_t> labels;
    for(const Eigen::Vector3d& area : m_area_vectors)
    {
      const std::vector<double> costs = costs_of_face(area);
      labels.push_back(std::min_element(costs.begin(), costs.end()) - costs.begin());
    }
    const auto edge_costs = boost::make_function_property_map<Boundary_mesh_3::Edge_index>(
      [&](const Boundary_mesh_3::Edge_index e) { return smoothing * weight(e); });
    const auto label_costs = boost::make_function_property_map<Boundary_mesh_3::Face_index>(
      [&](const Boundary_mesh_3::Face_index f) { return costs_of_face(m_area_vectors[f]); });
    const auto index = get(boost::face_index, m_mesh);
    alpha_expansion_graphcut(Dual<const Boundary_mesh_3>(m_mesh), edge_costs, label_costs,
                             boost::make_iterator_property_map(labels.begin(), index),
                             parameters::vertex_index_map(index));
    return labels;
  }

  double area(const Boundary_mesh_3::Face_index f) const { return m_area_vectors[f].norm(); }

  double cost(const Boundary_mesh_3::Face_index f, const std::size_t label) const
  {
    return m_area_vectors[f].norm() - m_area_vectors[f].dot(vector_of_direction(label));
  }

  // What it costs, without the factor, if the faces on the sides of the edge have different labels.
  double weight(const Boundary_mesh_3::Edge_index e) const
  {
    const auto h = m_mesh.halfedge(e);
    const Eigen::Vector3d n = m_area_vectors[m_mesh.face(h)].normalized();
    const Eigen::Vector3d m = m_area_vectors[m_mesh.face(m_mesh.opposite(h))].normalized();
    const double cosine = (std::max)(0., n.dot(m));
    return (eigen_point(m_mesh, m_mesh.target(h)) - eigen_point(m_mesh, m_mesh.source(h))).norm() * cosine * cosine;
  }

private:
  static std::vector<double> costs_of_face(const Eigen::Vector3d& area)
  {
    std::vector<double> costs;
    for(std::size_t label = 0; label < 6; ++label)
      costs.push_back(area.norm() - area.dot(vector_of_direction(label)));
    return costs;
  }

  const Boundary_mesh_3& m_mesh;
  std::vector<Eigen::Vector3d> m_area_vectors; // normal times area
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_NORMAL_LABELS_3_H
