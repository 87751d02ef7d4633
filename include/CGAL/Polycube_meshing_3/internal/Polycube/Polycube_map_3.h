// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_MAP_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_MAP_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Lines_of_charts_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_coordinates_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_lengths_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Unit_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Chart_relaxation_2.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cmath>
#include <optional>

namespace CGAL::Polycube_meshing_3::internal {

// Maps a labelled surface onto the polycube whose faces have the directions of the labels.
class Polycube_map_3
{
public:
  using Face = Boundary_mesh_3::Face_index;

  Polycube_map_3(const Unit_surface_3& surface, const std::vector<std::size_t>& labels)
    : m_surface(surface), m_mesh(surface.mesh), m_charts(m_mesh, labels), m_planes(m_mesh, m_charts),
      m_images(m_mesh.number_of_vertices(), Vector_3::Zero()), m_relaxations(m_charts.number_of_charts())
  {
    const double size = surface.box.diagonal().maxCoeff();
    m_grid = { -surface.box.center() / size, surface.spacing / size, surface.may_move };
  }

  // Finds the polycube that is closest to the surface, and maps the charts harmonically.
  Error_code start_close_to_surface(const Budget& budget)
  {
    if(m_charts.number_of_defects() > 0)
      return ERROR_NO_POLYCUBE;
    return start_close_to(mean_coordinates_3(m_mesh, m_charts, m_planes), budget);
  }

  // Returns the map to the polycube whose lengths are closest to those of the surface; none if there is no such map, or if its
  // distortion is not less than that of this map.
  std::optional<Polycube_map_3> with_lengths_of_surface(const Budget& budget) const
  {
    const std::vector<double> coordinates = Polycube_lengths_3(m_mesh, m_charts, m_planes).run(m_coordinates, m_grid, budget);
    Polycube_map_3 result(*this);
    if(result.start_close_to(coordinates, budget) != OK || !(result.distortion() < distortion()))
      return std::nullopt;
    return result;
  }

  // Maps the charts harmonically to faces with the coordinates of the charts along their axes. Fails if edges of the polycube
  // leave no room for some faces, which flipped_faces() returns then.
  Error_code start_at(const std::vector<double>& coordinates, const Budget& budget)
  {
    for(const auto v : m_charts.corners())
      for(const auto h : CGAL::halfedges_around_target(v, m_mesh))
        m_images[v][m_charts.axis(m_charts.chart(h))] = coordinates[m_charts.chart(h)];
    m_coordinates = coordinates;
    m_is_on_line = m_is_held = Held_coordinates(m_images.size(), { false, false, false });
    map_chains();
    find_flipped_faces_on_edges();
    if(!m_flipped_faces.empty())
      return ERROR_BOUNDARY_TOO_COARSE;
    map_charts(budget);
    return OK;
  }

  // Lowers the distortion, brings the images back to the size and place of the body, and checks the map. Sharp edges inside charts
  // become lines where that leaves room for all faces.
  Error_code finish(const Budget& budget)
  {
    relax(budget);
    if(m_flipped_faces.empty())
      straighten(budget);
    if(!m_flipped_faces.empty())
      return ERROR_BOUNDARY_TOO_COARSE;
    for(Vector_3& image : m_images)
      image = at_size_of_body(image);
    if(m_surface.spacing > 0)
      move_to_multiples();
    const auto faces = m_mesh.faces();
    if(!std::all_of(faces.begin(), faces.end(), [this](const Face f) { return has_positive_image(f); }))
      return ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
    Boundary_mesh_3 image = m_mesh;
    set_points(image, m_images);
    return Polygon_mesh_processing::does_self_intersect(image) ? ERROR_NO_POLYCUBE : OK;
  }

  const std::vector<Vector_3>& images() const { return m_images; }
  const Polycube_charts_3& charts() const { return m_charts; }

  // Returns faces for which the edges of the polycube leave no room, if the boundary is too coarse.
  const std::vector<Face>& flipped_faces() const { return m_flipped_faces; }

  // Returns the distortion of the map as it is. In experiments with several polycubes, the one whose harmonic map has the least
  // distortion had (nearly) the least distortion inside, too.
  double distortion() const { return distortion_3(m_mesh, m_images); }

private:
  // Finds the polycube that is closest to coordinates of its planes, and maps the charts harmonically.
  Error_code start_close_to(const std::vector<double>& coordinates_of_planes, const Budget& budget)
  {
    Polycube_coordinates_3 coordinates(m_mesh, m_charts, m_planes, m_grid, budget);
    if(!coordinates.run(coordinates_of_planes))
      return ERROR_NO_POLYCUBE;
    m_grid = coordinates.grid();
    return start_at(coordinates.of_charts(), budget);
  }

  // Maps the chains to edges of the polycube, by arc length between vertices held along the edge, and holds all their vertices.
  void map_chains()
  {
    for(const Polycube_chain_3& chain : m_charts.chains())
    {
      const auto vertices = m_charts.vertices(chain);
      std::size_t first = 0;
      for(std::size_t i = 1; i < vertices.size(); ++i)
        if(i + 1 == vertices.size() || m_is_held[vertices[i]][chain.axis])
        {
          std::vector<Boundary_mesh_3::Vertex_index> part(vertices.begin() + first, vertices.begin() + i + 1);
          for(int axis = 0; axis < 3; ++axis)
            if(axis != chain.axis)
              m_images[part.back()][axis] = m_images[part.front()][axis];
          map_path_to_segment_3(m_mesh, part, chain.axis, m_images);
          first = i;
        }
    }
    for(const Polycube_chain_3& chain : m_charts.chains())
      for(const auto v : m_charts.vertices(chain))
        m_is_held[v] = { true, true, true };
  }

  // Moves the vertices inside charts for a low distortion, and finds the faces that are flipped then.
  void relax(const Budget& budget)
  {
    for(std::optional<Chart_relaxation_2>& relaxation : m_relaxations)
      if(relaxation)
        relaxation->run(m_images, budget);
    m_flipped_faces.clear();
    for(const Face f : m_mesh.faces())
      if(!has_positive_image(f))
        m_flipped_faces.push_back(f);
  }

  // Makes lines of sharp edges inside charts as far as that leaves room for all faces, and no lines if none do.
  void straighten(const Budget& budget)
  {
    const std::vector<Vector_3> images = m_images;
    for(Lines_of_charts_3 lines(m_mesh, m_charts, followed_edges(), m_grid, images); !lines.are_empty(); )
    {
      map_with(lines, images, budget);
      relax(budget);
      if(m_flipped_faces.empty() || !lines.give_up(m_flipped_faces))
        break;
    }
    if(m_flipped_faces.empty())
      return;
    m_images = images;
    m_is_on_line.assign(m_images.size(), { false, false, false });
    m_flipped_faces.clear();
  }

  // Returns whether lines follow each edge: they do if it is sharp and not at a step. Facets of a step are nearly normal to the
  // face of their chart, or turned away from it, and the map flattens them.
  std::vector<bool> followed_edges() const
  {
    constexpr double least_cosine = 0.1; // a guess
    std::vector<bool> result = m_surface.is_sharp;
    for(const auto h : m_mesh.halfedges())
    {
      const Facet_edges_3 X = edges_of_face(m_mesh, m_mesh.face(h));
      const Vector_3 direction = vector_of_direction(m_charts.labels()[m_charts.chart(h)]);
      if(X[0].cross(X[1]).stableNormalized().dot(direction) < least_cosine)
        result[m_mesh.edge(h)] = false;
    }
    return result;
  }

  // Maps the charts harmonically with lines, from images without them.
  void map_with(const Lines_of_charts_3& lines, const std::vector<Vector_3>& images, const Budget& budget)
  {
    m_images = images;
    m_is_held.assign(m_images.size(), { false, false, false });
    lines.apply(m_images, m_is_held);
    m_is_on_line = m_is_held;
    map_chains();
    map_charts(budget);
  }

  // Finds the flipped faces with all vertices on edges of the polycube. Their images are final before the charts are mapped.
  void find_flipped_faces_on_edges()
  {
    m_flipped_faces.clear();
    constexpr std::array<bool, 3> all = { true, true, true };
    for(const Face f : m_mesh.faces())
    {
      const auto around = CGAL::vertices_around_face(m_mesh.halfedge(f), m_mesh);
      if(std::all_of(around.begin(), around.end(), [&](const auto v) { return m_is_held[v] == all; }) && !has_positive_image(f))
        m_flipped_faces.push_back(f);
    }
  }

  // Maps the charts harmonically between their held vertices, or restores the maps made for the same held vertices.
  void map_charts(const Budget& budget)
  {
    std::vector<std::vector<Face> > faces(m_charts.number_of_charts());
    for(const Face f : m_mesh.faces())
    {
      const std::size_t c = m_charts.chart_of_face()[f];
      faces[c].push_back(f);
      for(const auto v : CGAL::vertices_around_face(m_mesh.halfedge(f), m_mesh))
        m_images[v][m_charts.axis(c)] = m_coordinates[c];
    }
    for(std::size_t c = 0; c < faces.size() && !budget.is_exhausted(); ++c)
    {
      const auto [u, v] = m_charts.plane_axes(c);
      if(m_relaxations[c] && m_relaxations[c]->was_made_for(m_is_held, m_images))
        m_relaxations[c]->write(m_images);
      else
        m_relaxations[c].emplace(m_mesh, faces[c], m_is_held, u, v, m_images);
    }
  }

  bool has_positive_image(const Face f) const
  {
    const auto [u, v] = m_charts.plane_axes(m_charts.chart_of_face()[f]);
    const auto point = [this, u = u, v = v](const Boundary_mesh_3::Vertex_index w)
    { return Boundary_point_2(m_images[w][u], m_images[w][v]); };
    const auto [a, b, c] = vertices_of_face(m_mesh, f);
    return CGAL::orientation(point(a), point(b), point(c)) == POSITIVE;
  }

  // Returns a point of the polycube, whose body has the longest side 1 and the center 0, in the coordinates of the given body.
  Vector_3 at_size_of_body(const Vector_3& p) const
  { return m_surface.box.center() + m_surface.box.diagonal().maxCoeff() * p; }

  // Makes the coordinates of faces multiples of the spacing, and those of lines multiples of a part of it.
  void move_to_multiples()
  {
    const double spacing = m_surface.spacing;
    if(m_grid.may_move)
    {
      const Vector_3 origin = at_size_of_body(m_grid.origin);
      for(Vector_3& image : m_images) // by what brings the origin to a multiple
        image += origin.unaryExpr([&](const double x) { return spacing * std::round(x / spacing) - x; });
    }
    const auto round = [](double& x, const double unit) { x = unit * std::round(x / unit); };
    for(const auto h : m_mesh.halfedges())
      round(m_images[m_mesh.target(h)][m_charts.axis(m_charts.chart(h))], spacing);
    for(std::size_t v = 0; v < m_images.size(); ++v)
      for(int axis = 0; axis < 3; ++axis)
        if(m_is_on_line[v][axis])
          round(m_images[v][axis], Lines_of_charts_3::smallest_part_of_spacing * spacing);
  }

  const Unit_surface_3& m_surface;
  const Boundary_mesh_3& m_mesh; // of the surface
  const Polycube_charts_3 m_charts;
  const Polycube_planes_3 m_planes;
  Plane_grid_3 m_grid;
  std::vector<double> m_coordinates; // of the faces of the charts, along their axes
  std::vector<Vector_3> m_images;
  Held_coordinates m_is_held;    // on edges of the polycube, and across lines
  Held_coordinates m_is_on_line; // across lines
  std::vector<std::optional<Chart_relaxation_2> > m_relaxations; // by chart; none of those not mapped yet
  std::vector<Face> m_flipped_faces;
};

// Returns the finished map to the polycube with the lengths of the surface. If that one is worse or cannot be finished, finishes
// the given map.
inline Surface_map_3 finished_map_3(Polycube_map_3& map, const Budget& budget)
{
  if(std::optional<Polycube_map_3> other = map.with_lengths_of_surface(budget); other && other->finish(budget) == OK)
    return { OK, other->images(), other->distortion() };
  if(const Error_code status = map.finish(budget); status != OK)
    return { status };
  return { OK, map.images(), map.distortion() };
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_MAP_3_H
