// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SLIDING_BOUNDARY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SLIDING_BOUNDARY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Twice the area, times the unit normal.
inline Vector_3 area_vector(const Matrix3Xd& points, const std::array<int, 3>& facet)
{
  const Vector_3 &p = points.col(facet[0]), &q = points.col(facet[1]), &r = points.col(facet[2]);
  return (q - p).cross(r - p);
}

// A triangulated surface as regions of neighbouring facets that are coplanar: exactly, or nearly, as
// where coordinates were rounded in a file. A region is planar if its vertices are within `tolerance` of
// its plane. A region that almost coplanar facets have led around a bend is not.
class Planar_regions_3
{
public:
  using Facet = std::array<int, 3>;

  Planar_regions_3(const Matrix3Xd& points, const std::vector<Facet>& facets, const double tolerance)
    : m_region(facets.size())
  {
    unite_coplanar_facets(points, facets);
    fit_planes(points, facets, tolerance);
  }

  // The region of a facet is named by one of its facets.
  std::size_t region(const std::size_t facet) const { return m_region[facet]; }
  bool is_planar(const std::size_t region) const { return m_is_planar[region]; }

  // The unit normal; exactly an axis if a coordinate of all vertices is the same.
  const Vector_3& normal(const std::size_t region) const { return m_normal[region]; }

private:
  // Are two facets with a common edge coplanar, and on either side of it?
  static bool are_coplanar(const Matrix3Xd& points, const Facet& f, const Facet& g)
  {
    constexpr double small_angle = 1e-3; // a guess: a rounded coordinate turns a small facet much
    const Vector_3 m = area_vector(points, f).stableNormalized(), n = area_vector(points, g).stableNormalized();
    if(m.dot(n) > 0 && m.cross(n).norm() <= small_angle)
      return true;
    const int i = apex(f, g);
    const auto point = [&](const int v) { return exact_point(points.col(v)); };
    const Exact_point_3 p = point(f[(i + 1) % 3]), q = point(f[(i + 2) % 3]), r = point(f[i]), s = point(g[apex(g, f)]);
    return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::NEGATIVE;
  }

  // The index of the vertex of f that is not in its neighbour g.
  static int apex(const Facet& f, const Facet& g)
  {
    int i = 0;
    while(std::find(g.begin(), g.end(), f[i]) != g.end())
      ++i;
    return i;
  }

  void unite_coplanar_facets(const Matrix3Xd& points, const std::vector<Facet>& facets)
  {
    Disjoint_sets regions(facets.size());
    for_each_edge(facets, [&](const auto begin, const auto end) // one of more than two facets joins none of them
    {
      if(end - begin != 2)
        return;
      const std::size_t f = begin->second[0] / 3, g = (begin + 1)->second[0] / 3;
      if(are_coplanar(points, facets[f], facets[g]))
        regions.unite(f, g);
    });
    for(std::size_t f = 0; f < facets.size(); ++f)
      m_region[f] = regions.find(f);
  }

  void fit_planes(const Matrix3Xd& points, const std::vector<Facet>& facets, const double tolerance)
  {
    m_normal.assign(facets.size(), Vector_3::Zero());
    m_is_planar.assign(facets.size(), true);
    for(std::size_t f = 0; f < facets.size(); ++f)
      m_normal[m_region[f]] += area_vector(points, facets[f]);
    for(Vector_3& normal : m_normal)
      normal = unit_vector_3(normal);
    for(std::size_t f = 0; f < facets.size(); ++f)
    {
      const std::size_t region = m_region[f];
      for(const int v : facets[f])
        if(!(std::abs(m_normal[region].dot(points.col(v) - points.col(facets[region][0]))) <= tolerance))
          m_is_planar[region] = false;
    }
  }

  std::vector<std::size_t> m_region;      // of each facet
  std::vector<Vector_3> m_normal; // of each region
  std::vector<bool> m_is_planar;
};

// Conditions of vertices that slide. The planar regions of the boundary are to cover the same polygons: a vertex inside a region
// moves parallel to its plane, and one between two regions along their line. Sharp edges of the body that lead along an axis
// inside of a region are lines, too, on which vertices stay. Vertices of curved patches move on the triangles, and between patches
// on the curve. Corners stay at their targets.
//
// While no cell is inverted, no facet of the boundary can be turned over, as it would have to be flat, and
// its cell with it, in between. And regions of facets that are not turned over cover each point as often
// as their outlines wind around it. Those keep their corners and run along the same lines. So regions
// remain one to one, vertices keep their order along edges, and the image of the complex remains the same.
class Sliding_boundary_3
{
public:
  explicit Sliding_boundary_3(const Numbered_mesh_3& mesh)
    : m_mesh(mesh), m_conditions(mesh.sliding_conditions.empty() ? mesh.conditions : mesh.sliding_conditions)
  {
    if(!are_some_in_boundary(m_conditions))
      return;
    for(const std::array<int, 3>& facet : boundary_facets_3(mesh.cells, mesh.is_parallel))
      if(std::all_of(facet.begin(), facet.end(), [&](const int v) { return mesh.is_fixed(v); }))
        m_facets.push_back(facet);
      else
        for(const int v : facet)
          if(slides(v))
            condition(v) = Vertex_condition_3::at_target();
    const Planar_regions_3 regions(mesh.target, m_facets, planarity * target_diagonal(mesh));
    slide_in_regions(regions);
    hold_lines(regions);
    slide_on_curved_patches(regions);
  }

  std::size_t number_of_sliding_vertices() const
  {
    std::size_t result = 0;
    for(int v = m_mesh.number_of_free_vertices; v < m_mesh.number_of_vertices() && !m_conditions.empty(); ++v)
      result += m_mesh.is_fixed(v) && condition(v).dimension() > 0;
    return result;
  }

  // Returns the conditions of the prescribed vertices. None is in the boundary but in its planes, on its lines or on its surface.
  const Conditions_3& conditions() const { return m_conditions; }

  // Is each facet of the boundary oriented as in the target, unless a vertex is on a surface? Decided by exact predicates on the
  // coordinates, without the one in which the normal is the longest.
  bool has_same_orientations(const Matrix3Xd& positions) const
  {
    return std::all_of(m_facets.begin(), m_facets.end(), [&](const std::array<int, 3>& facet)
    {
      const int axis = area_vector(m_mesh.target, facet).cwiseAbs().largest_index();
      return std::any_of(facet.begin(), facet.end(), [&](const int v) { return condition(v).is_sliding(); })
          || orientation(positions, facet, axis) == orientation(m_mesh.target, facet, axis);
    });
  }

private:
  static constexpr double planarity = 1e-7; // relative to the diagonal; more than eight digits in a file round

  Vertex_condition_3& condition(const int v) { return m_conditions[v - m_mesh.number_of_free_vertices]; }
  const Vertex_condition_3& condition(const int v) const { return m_conditions[v - m_mesh.number_of_free_vertices]; }
  bool slides(const int v) const { return !m_mesh.is_free(v) && slides_in_boundary(condition(v)); }

  void slide_in_regions(const Planar_regions_3& regions)
  {
    std::vector<std::vector<std::size_t> > regions_of_vertices(m_mesh.number_of_vertices());
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      for(const int v : m_facets[f])
        if(auto& around = regions_of_vertices[v]; std::find(around.begin(), around.end(), regions.region(f)) == around.end())
          around.push_back(regions.region(f));
    for(int v = m_mesh.number_of_free_vertices; v < m_mesh.number_of_vertices(); ++v)
      if(const auto& around = regions_of_vertices[v]; slides(v)
         && std::all_of(around.begin(), around.end(), [&](const std::size_t region) { return regions.is_planar(region); }))
        slide_between(regions, around, condition(v));
  }

  static void slide_between(const Planar_regions_3& regions, const std::vector<std::size_t>& around, Vertex_condition_3& condition)
  {
    constexpr double small_sine = 1e-3; // a guess; of the angle between planes
    if(around.size() == 1)
      condition = in_plane(regions.normal(around[0]));
    if(around.size() == 2)
      if(const Vector_3 line = regions.normal(around[0]).cross(regions.normal(around[1])); line.norm() > small_sine)
        condition = on_line(line);
  }

  static Vertex_condition_3 in_plane(const Vector_3& n) { return Vertex_condition_3::in_plane(n[0], n[1], n[2]); }
  static Vertex_condition_3 on_line(const Vector_3& d) { return Vertex_condition_3::on_line(d[0], d[1], d[2]); }

  // Lets the vertices of lines inside of regions move along the axis of the line. Those where lines meet or end at the border of a
  // region have no plane or line any more.
  void hold_lines(const Planar_regions_3& regions)
  {
    const auto point = [&](const int v) { return Vector_3(m_mesh.source.col(v)); };
    const auto lines = sharp_edges_3(m_facets, m_mesh.marked_edges, point);
    for_each_edge(m_facets, [&](const auto begin, const auto end)
    {
      const auto& [v, w] = begin->first;
      const Vector_3 p = m_mesh.target.col(v), q = m_mesh.target.col(w);
      if(!leads_along_axis(p, q) || !std::binary_search(lines.begin(), lines.end(), begin->first)
         || regions.region(begin->second[0] / 3) != regions.region((end - 1)->second[0] / 3))
        return;
      const Vector_3 axis(double(p[0] != q[0]), double(p[1] != q[1]), double(p[2] != q[2]));
      for(const int u : { v, w })
        if(const Matrix_3 projector = projector_3(condition(u)); condition(u).dimension() == 2 && !projector.is_zero())
          condition(u) = on_line(axis);
        else if(condition(u).dimension() == 1 && !projector.is_zero() && projector != Matrix_3::diagonal(axis))
          condition(u) = Vertex_condition_3::in_boundary();
    });
  }

  // Lets vertices without a plane or line that are inside of curved patches of the target or on curves between patches slide on
  // these, and others stay. A patch is curved at a vertex if a facet there has no coplanar neighbour, or almost coplanar ones that
  // lead around a bend.
  void slide_on_curved_patches(const Planar_regions_3& regions)
  {
    std::vector<int> sizes(m_facets.size(), 0); // of the regions
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      ++sizes[regions.region(f)];
    std::vector<bool> is_curved(m_mesh.number_of_vertices(), false);
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      for(const int v : m_facets[f])
        if(slides(v) && (sizes[regions.region(f)] == 1 || !regions.is_planar(regions.region(f))))
          is_curved[v] = true;
    const bool are_some_curved = std::find(is_curved.begin(), is_curved.end(), true) != is_curved.end();
    const std::optional<Triangulated_surface_3> surface = are_some_curved ? std::optional(target_surface()) : std::nullopt;
    for(int v = m_mesh.number_of_free_vertices; v < m_mesh.number_of_vertices(); ++v)
      if(slides(v))
        condition(v) = is_curved[v] && surface->condition(v).is_sliding() ? surface->condition(v)
                                                                          : Vertex_condition_3::at_target();
  }

  Triangulated_surface_3 target_surface() const
  {
    std::vector<std::array<double, 3> > points;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      points.push_back(coordinates(m_mesh.target.col(v)));
    std::vector<std::array<std::size_t, 3> > triangles;
    for(const auto& [u, v, w] : m_facets)
      triangles.push_back({ std::size_t(u), std::size_t(v), std::size_t(w) });
    std::vector<std::array<std::size_t, 2> > features;
    for(const auto& [v, w] : m_mesh.marked_edges)
      features.push_back({ std::size_t(v), std::size_t(w) });
    return Triangulated_surface_3(points, triangles, features);
  }

  static CGAL::Orientation orientation(const Matrix3Xd& positions, const std::array<int, 3>& facet, const int axis)
  {
    using Point_2 = Exact_predicates_inexact_constructions_kernel::Point_2;
    const auto point = [&](const int k)
    { return Point_2(positions((axis + 1) % 3, facet[k]), positions((axis + 2) % 3, facet[k])); };
    return CGAL::orientation(point(0), point(1), point(2));
  }

  const Numbered_mesh_3& m_mesh;
  std::vector<std::array<int, 3> > m_facets; // of the boundary, with all vertices at their targets until they slide
  Conditions_3 m_conditions;
};

// Puts vertices that slide where they may be, and evaluates their positions.
inline Map_3 evaluated_map(const Numbered_mesh_3& mesh, const Sliding_boundary_3& boundary, Matrix3Xd positions)
{
  Map_3 map = evaluated_map(mesh, snapped(mesh, std::move(positions), boundary.conditions()), boundary.conditions());
  map.meets_boundary = map.meets_boundary && boundary.has_same_orientations(map.positions);
  return map;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SLIDING_BOUNDARY_3_H
