// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/parallel.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/map_to_box_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Patch_relaxation_2.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Normal_labels_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Polycube_charts_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Polycube_coordinates_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/repair_labels_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/map_patch_to_polygon_3.h>
#  include <CGAL/Polygon_mesh_processing/self_intersections.h>
#endif

#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a surface onto a polycube. Without labels of the facets, which are the axes that their images are normal to, some
// are proposed such that there are as many details as possible. The coordinates of the faces are multiples of the
// spacing, or any if that is 0.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_polycube_3(const Numbered_surface_3& surface, const std::vector<std::size_t>& labels, double spacing,
                             std::vector<Eigen::Vector3d>& images, const Budget& budget);

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE

// Maps a labelled surface onto the polycube whose faces have the directions of the labels. The surface is given such
// that the longest side of its bounding box is 1, and the polycube made for the box that it had before.
class Polycube_map_3
{
public:
  using Face = Boundary_mesh_3::Face_index;

  // The faces get multiples of the spacing as coordinates, or any if it is 0.
  Polycube_map_3(const Boundary_mesh_3& mesh, const Eigen::AlignedBox3d& box, const std::vector<std::size_t>& labels,
                 const double spacing)
    : m_mesh(mesh), m_box(box), m_spacing(spacing), m_charts(mesh, labels),
      m_images(mesh.number_of_vertices(), Eigen::Vector3d::Zero())
  {}

  // Finds the polycube, and maps the charts harmonically.
  Error_code start(const Budget& budget)
  {
    const double size = m_box.sizes().maxCoeff();
    const Grid_planes_3 planes = { -m_box.center() / size, m_spacing / size };
    Polycube_coordinates_3 coordinates(m_mesh, m_charts, planes, budget);
    if(m_charts.number_of_defects() > 0 || !coordinates.run())
      return ERROR_NO_POLYCUBE;
    for(const auto v : m_charts.corners())
      m_images[v] = coordinates.corner(v);
    std::vector<bool> is_on_edge(m_images.size(), false);
    for(const Polycube_chain_3& chain : m_charts.chains())
    {
      const auto vertices = m_charts.vertices(chain);
      map_path_to_segment_3(m_mesh, vertices, chain.axis, m_images);
      for(const auto v : vertices)
        is_on_edge[v] = true;
    }
    find_flipped_faces_between_edges(is_on_edge);
    if(!m_flipped_faces.empty())
      return ERROR_BOUNDARY_TOO_COARSE;
    map_charts(coordinates, is_on_edge, budget);
    return OK;
  }

  // Lowers the distortion, and checks the map.
  Error_code finish(const Budget& budget)
  {
    for(Patch_relaxation_2& patch : m_patches)
      patch.run(m_images, budget);
    const auto faces = m_mesh.faces();
    std::copy_if(faces.begin(), faces.end(), std::back_inserter(m_flipped_faces),
                 [this](const Face f) { return !is_positive(f); });
    if(!m_flipped_faces.empty())
      return ERROR_BOUNDARY_TOO_COARSE;
    for(Eigen::Vector3d& image : m_images)
      image = m_box.center() + m_box.sizes().maxCoeff() * image;
    if(m_spacing > 0)
      remove_rounding();
    if(!std::all_of(faces.begin(), faces.end(), [this](const Face f) { return is_positive(f); }))
      return ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
    Boundary_mesh_3 image = m_mesh;
    set_points(image, m_images);
    return Polygon_mesh_processing::does_self_intersect(image) ? ERROR_NO_POLYCUBE : OK;
  }

  const std::vector<Eigen::Vector3d>& images() const { return m_images; }
  const Polycube_charts_3& charts() const { return m_charts; }

  // If the boundary is too coarse, some faces for which the edges of the polycube leave no place.
  const std::vector<Face>& flipped_faces() const { return m_flipped_faces; }

  // Of the harmonic maps: the integral of log(s)^2 + log(t)^2 over the surface, with the singular values s and t. Of
  // several polycubes, the one where this is least had the least distortion inside, too, or nearly, in experiments.
  double distortion() const
  {
    double sum = 0;
    for(const Face f : m_mesh.faces())
    {
      const auto h = m_mesh.halfedge(f);
      const auto a = m_mesh.source(h), b = m_mesh.target(h), c = m_mesh.target(m_mesh.next(h));
      Eigen::Matrix<double, 3, 2> from, to;
      from << eigen_point(m_mesh, b) - eigen_point(m_mesh, a), eigen_point(m_mesh, c) - eigen_point(m_mesh, a);
      to << m_images[b] - m_images[a], m_images[c] - m_images[a];
      const Eigen::Matrix2d metric = from.transpose() * from, ratio = metric.inverse() * (to.transpose() * to);
      const double mean = ratio.trace() / 2, determinant = ratio.determinant(); // of the squared singular values
      const double larger = mean + std::sqrt((std::max)(0., mean * mean - determinant));
      sum += std::sqrt(metric.determinant()) / 8
             * (std::pow(std::log(larger), 2) + std::pow(std::log(determinant / larger), 2));
    }
    return std::isfinite(sum) ? sum : (std::numeric_limits<double>::infinity)();
  }

private:
  void find_flipped_faces_between_edges(const std::vector<bool>& is_on_edge)
  {
    for(const Face f : m_mesh.faces())
    {
      const auto around = CGAL::vertices_around_face(m_mesh.halfedge(f), m_mesh);
      if(std::all_of(around.begin(), around.end(), [&](const auto v) { return is_on_edge[v]; }) && !is_positive(f))
        m_flipped_faces.push_back(f);
    }
  }

  void map_charts(const Polycube_coordinates_3& coordinates, const std::vector<bool>& is_on_edge, const Budget& budget)
  {
    std::vector<std::vector<Face> > faces(m_charts.number_of_charts());
    for(const Face f : m_mesh.faces())
    {
      const std::size_t c = m_charts.chart_of_face()[f];
      faces[c].push_back(f);
      for(const auto v : CGAL::vertices_around_face(m_mesh.halfedge(f), m_mesh))
        m_images[v][m_charts.axis(c)] = coordinates[c];
    }
    for(std::size_t c = 0; c < faces.size() && !budget.is_exhausted(); ++c)
    {
      const auto [u, v] = plane_axes(c);
      m_patches.emplace_back(m_mesh, faces[c], is_on_edge, u, v, m_images);
    }
  }

  // The axes of the plane of a chart, in the order that makes its image positive.
  std::array<int, 2> plane_axes(const std::size_t c) const
  {
    const int axis = m_charts.axis(c), u = (axis + 1) % 3, v = (axis + 2) % 3;
    return (sign_of_direction(m_charts.labels()[c]) > 0) ? std::array<int, 2>{u, v} : std::array<int, 2>{v, u};
  }

  bool is_positive(const Face f) const
  {
    const auto [u, v] = plane_axes(m_charts.chart_of_face()[f]);
    const auto point = [this, u = u, v = v](const Boundary_mesh_3::Vertex_index w)
    {
      return Boundary_point_2(m_images[w][u], m_images[w][v]);
    };
    const auto h = m_mesh.halfedge(f);
    return CGAL::orientation(point(m_mesh.source(h)), point(m_mesh.target(h)), point(m_mesh.target(m_mesh.next(h))))
           == POSITIVE;
  }

  // Makes the coordinates of faces multiples of the spacing again.
  void remove_rounding()
  {
    for(const auto h : m_mesh.halfedges())
    {
      double& x = m_images[m_mesh.target(h)][m_charts.axis(m_charts.chart(h))];
      x = m_spacing * std::round(x / m_spacing);
    }
  }

  const Boundary_mesh_3& m_mesh;
  const Eigen::AlignedBox3d m_box;
  const double m_spacing;
  const Polycube_charts_3 m_charts;
  std::vector<Eigen::Vector3d> m_images;
  std::vector<Patch_relaxation_2> m_patches;
  std::vector<Face> m_flipped_faces;
};

// Proposes labels with more and more smoothing, and takes those whose map has the least distortion. Where the boundary
// is too coarse, faces for which there is no place are given to neighbouring charts, and borders that fold are unfolded.
inline Error_code map_to_proposed_polycube_3(const Boundary_mesh_3& mesh, const Eigen::AlignedBox3d& box,
                                             const double spacing, std::vector<Eigen::Vector3d>& images,
                                             const Budget& budget)
{
  Error_code status = ERROR_NO_POLYCUBE;
  std::multimap<double, Polycube_map_3> maps; // by their distortion
  std::set<std::vector<std::size_t> > tried;
  Normal_labels_3 costs(mesh, budget);
  for(double smoothing = 0.001; smoothing < 0.1 && !budget.is_exhausted(); smoothing *= std::sqrt(2.))
  {
    std::vector<std::size_t> candidate = costs.closest();
    costs.minimize(smoothing, candidate);
    for(int attempt = 0; attempt < 10 && !budget.is_exhausted(); ++attempt)
    {
      if(!repair_labels_3(mesh, costs, smoothing, candidate, budget) || !tried.insert(candidate).second)
        break;
      Polycube_map_3 map(mesh, box, candidate, spacing);
      const Error_code status_of_map = map.start(budget);
      if(status == ERROR_NO_POLYCUBE)
        status = status_of_map;
      const bool has_changed = give_away_faces(mesh, map.flipped_faces(), costs, candidate)
        || unfold_chain(mesh, map.charts(), costs, candidate);
      if(status_of_map == OK)
        maps.emplace(map.distortion(), std::move(map));
      if(!has_changed)
        break;
    }
  }
  for(auto& [distortion, map] : maps)
  {
    status = map.finish(budget);
    if(status == OK)
    {
      images = map.images();
      break;
    }
  }
  return status;
}

inline Error_code map_mesh_to_polycube_3(const Boundary_mesh_3& mesh, const Eigen::AlignedBox3d& box,
                                         const std::vector<std::size_t>& labels, const double spacing,
                                         std::vector<Eigen::Vector3d>& images, const Budget& budget)
{
  if(labels.empty())
  {
    const Error_code status = map_to_proposed_polycube_3(mesh, box, spacing, images, budget);
    const bool needs_box = status != OK && !budget.is_exhausted() && check_sphere(mesh) == OK;
    return needs_box ? map_to_bounding_box_3(mesh, box, spacing, images, budget) : status;
  }
  Polycube_map_3 map(mesh, box, labels, spacing);
  Error_code status = map.start(budget);
  if(status == OK)
    status = map.finish(budget);
  if(status == OK)
    images = map.images();
  return status;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_polycube_3(const Numbered_surface_3& surface, const std::vector<std::size_t>& labels,
                             const double spacing, std::vector<Eigen::Vector3d>& images, const Budget& budget)
{
  Boundary_mesh_3 mesh;
  Error_code status = build_boundary_mesh_3(surface, mesh);
  if(status != OK)
    return status;
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  set_points(mesh, unit_points(mesh));
  status = map_mesh_to_polycube_3(mesh, box, labels, spacing, images, budget);
  std::vector<Eigen::Vector3d> any;
  if(status != OK && spacing > 0 && map_mesh_to_polycube_3(mesh, box, labels, 0, any, budget) == OK)
    return ERROR_SPACING_TOO_COARSE;
  return status;
}
#endif

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H
