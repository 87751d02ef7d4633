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
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/projector_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

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
  // twice the area, times the unit normal
  static Vector_3 area_vector(const Matrix3Xd& points, const Facet& facet)
  {
    const Vector_3 &p = points.col(facet[0]), &q = points.col(facet[1]), &r = points.col(facet[2]);
    return (q - p).cross(r - p);
  }

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

// Where the vertices of a boundary may go if its planar regions are to cover the same polygons: a vertex inside a region
// moves parallel to its plane, one between two regions along their line, and every other vertex stays at its target. Sharp edges
// of the body that lead along an axis inside of a region are lines, too, on which vertices stay.
//
// While no cell is inverted, no facet of the boundary can be turned over, as it would have to be flat, and
// its cell with it, in between. And regions of facets that are not turned over cover each point as often
// as their outlines wind around it. Those keep their corners and run along the same lines. So regions
// remain one to one, vertices keep their order along edges, and the image of the complex remains the same.
class Sliding_boundary_3
{
public:
  // Takes the conditions of a mesh. Those on surfaces slide.
  explicit Sliding_boundary_3(const Numbered_mesh_3& mesh)
    : m_mesh(mesh), m_regions(mesh.target, {}, 0), m_projectors(mesh.projectors), m_surfaces(mesh.surfaces)
  {
    m_projectors.resize(m_surfaces.size(), Matrix_3::Zero());
    for(std::size_t i = 0; i < m_surfaces.size(); ++i)
      if(m_surfaces[i].is_sliding())
        m_projectors[i] = put_on_surface_3(m_surfaces[i], mesh.target.col(mesh.number_of_free_vertices + i)).second;
  }

  // Vertices for which `is_constrained` is true stay at their targets, too.
  template <typename Predicate>
  Sliding_boundary_3(const Numbered_mesh_3& mesh, const Predicate& is_constrained)
    : m_mesh(mesh), m_facets(boundary_facets_3(mesh.cells, mesh.is_parallel)),
      m_regions(mesh.target, m_facets, planarity * target_diagonal(mesh))
  {
    std::vector<std::vector<std::size_t> > regions(mesh.number_of_vertices());
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      for(const int v : m_facets[f])
        if(std::find(regions[v].begin(), regions[v].end(), m_regions.region(f)) == regions[v].end())
          regions[v].push_back(m_regions.region(f));
    for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
      m_projectors.push_back(is_constrained(v) ? Matrix_3::Zero() : projector(regions[v]));
    hold_lines();
    slide_on_curved_patches(is_constrained);
  }

  std::size_t number_of_sliding_vertices() const
  {
    return std::count_if(m_projectors.begin(), m_projectors.end(),
                         [](const Matrix_3& projector) { return !projector.is_zero(); });
  }

  // Returns the projector of each prescribed vertex onto the directions in which it may move.
  const Projectors_3& projectors() const { return m_projectors; }

  // Returns the conditions of prescribed vertices on surfaces, free for others, or none.
  const std::vector<Vertex_condition_3>& surfaces() const { return m_surfaces; }

  // Is each facet of a planar region, if no vertex of it is on a surface, oriented as in the target? Decided by exact predicates
  // on the coordinates, without the one in which the normal is the longest.
  bool has_same_orientations(const Matrix3Xd& positions) const
  {
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      if(m_regions.is_planar(m_regions.region(f)) && !has_vertex_on_surface(f)
         && orientation(positions, f) != orientation(m_mesh.target, f))
        return false;
    return true;
  }

private:
  static constexpr double planarity = 1e-7; // relative to the diagonal; more than eight digits in a file round

  // onto the directions in which a vertex of these regions may move
  Matrix_3 projector(const std::vector<std::size_t>& regions) const
  {
    constexpr double small_sine = 1e-3; // a guess; of the angle between planes
    const bool is_planar = std::all_of(regions.begin(), regions.end(), [&](const std::size_t region)
                                       { return m_regions.is_planar(region); });
    if(is_planar && regions.size() == 1)
    {
      const Vector_3& normal = m_regions.normal(regions[0]);
      return Matrix_3::Identity() - Matrix_3::outer_product(normal, normal);
    }
    if(is_planar && regions.size() == 2)
    {
      const Vector_3 line = m_regions.normal(regions[0]).cross(m_regions.normal(regions[1]));
      if(line.norm() > small_sine)
        return Matrix_3::outer_product(line.normalized(), line.normalized());
    }
    return Matrix_3::Zero();
  }

  // Lets the vertices of lines inside of regions move along the axis of the line, and those where lines meet or end at the border
  // of a region stay.
  void hold_lines()
  {
    const auto point = [&](const int v) { return Vector_3(m_mesh.source.col(v)); };
    const auto lines = sharp_edges_3(m_facets, m_mesh.marked_edges, point);
    for_each_edge(m_facets, [&](const auto begin, const auto end)
    {
      const auto& [v, w] = begin->first;
      const Vector_3 p = m_mesh.target.col(v), q = m_mesh.target.col(w);
      if(!leads_along_axis(p, q) || !std::binary_search(lines.begin(), lines.end(), begin->first)
         || m_regions.region(begin->second[0] / 3) != m_regions.region((end - 1)->second[0] / 3))
        return;
      const Matrix_3 along = Matrix_3::diagonal({ double(p[0] != q[0]), double(p[1] != q[1]), double(p[2] != q[2]) });
      for(const int u : { v, w })
        if(!m_mesh.is_free(u))
          if(Matrix_3& projector = m_projectors[u - m_mesh.number_of_free_vertices]; projector != along)
            projector = projector.trace() > 1.5 ? along : Matrix_3::Zero();
    });
  }

  // Lets vertices that would stay, but are inside of curved patches of the target or on curves between patches, slide on these. A
  // patch is curved at a vertex if a facet there has no coplanar neighbour, or almost coplanar ones that lead around a bend.
  template <typename Predicate>
  void slide_on_curved_patches(const Predicate& is_constrained)
  {
    std::vector<int> sizes(m_facets.size(), 0); // of the regions
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      ++sizes[m_regions.region(f)];
    std::vector<bool> is_curved(m_mesh.number_of_vertices(), false);
    std::vector<std::array<std::size_t, 3> > triangles;
    for(std::size_t f = 0; f < m_facets.size(); ++f)
    {
      const auto& [u, v, w] = m_facets[f];
      triangles.push_back({ std::size_t(u), std::size_t(v), std::size_t(w) });
      if(sizes[m_regions.region(f)] == 1 || !m_regions.is_planar(m_regions.region(f)))
        is_curved[u] = is_curved[v] = is_curved[w] = true;
    }
    const int first = m_mesh.number_of_free_vertices;
    for(int v = first; v < m_mesh.number_of_vertices(); ++v)
      is_curved[v] = is_curved[v] && m_projectors[v - first].is_zero() && !is_constrained(v);
    if(std::find(is_curved.begin() + first, is_curved.end(), true) == is_curved.end())
      return;
    std::vector<std::array<double, 3> > points;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      points.push_back(coordinates(m_mesh.target.col(v)));
    std::vector<std::array<std::size_t, 2> > features;
    for(const auto& [v, w] : m_mesh.marked_edges)
      features.push_back({ std::size_t(v), std::size_t(w) });
    const Triangulated_surface_3 surface(points, triangles, features);
    m_surfaces.resize(m_projectors.size());
    for(int v = first; v < m_mesh.number_of_vertices(); ++v)
      if(const Vertex_condition_3& condition = surface.condition(v); is_curved[v] && condition.is_sliding())
      {
        m_surfaces[v - first] = condition;
        m_projectors[v - first] = put_on_surface_3(condition, m_mesh.target.col(v)).second;
      }
  }

  bool has_vertex_on_surface(const std::size_t facet) const
  {
    return !m_surfaces.empty() && std::any_of(m_facets[facet].begin(), m_facets[facet].end(), [&](const int v)
    { return !m_mesh.is_free(v) && m_surfaces[v - m_mesh.number_of_free_vertices].is_sliding(); });
  }

  CGAL::Orientation orientation(const Matrix3Xd& positions, const std::size_t facet) const
  {
    using Point_2 = Exact_predicates_inexact_constructions_kernel::Point_2;
    const int longest = m_regions.normal(m_regions.region(facet)).cwiseAbs().largest_index();
    const auto point = [&](const int k)
    {
      const auto p = positions.col(m_facets[facet][k]);
      return Point_2(p[(longest + 1) % 3], p[(longest + 2) % 3]);
    };
    return CGAL::orientation(point(0), point(1), point(2));
  }

  const Numbered_mesh_3& m_mesh;
  std::vector<std::array<int, 3> > m_facets;
  Planar_regions_3 m_regions;
  Projectors_3 m_projectors; // at the targets, if a vertex is on a surface
  std::vector<Vertex_condition_3> m_surfaces;
};

// Puts vertices that slide where they may be, and evaluates their positions.
inline Map_3 evaluated_map(const Numbered_mesh_3& mesh, const Sliding_boundary_3& boundary, Matrix3Xd positions)
{
  positions = snapped(mesh, std::move(positions), boundary.projectors(), boundary.surfaces());
  Map_3 map = evaluated_map(mesh, std::move(positions), boundary.projectors(), boundary.surfaces());
  map.meets_boundary = map.meets_boundary && boundary.has_same_orientations(map.positions);
  return map;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SLIDING_BOUNDARY_3_H
