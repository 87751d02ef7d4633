// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_DIAGNOSE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_DIAGNOSE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/prove_infeasibility_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>
#include <CGAL/box_intersection_d.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Looks, by exact predicates, for two triangles of a surface that have more in common than their common vertices.
class Self_intersection_3
{
public:
  using Facet = std::array<int, 3>;
  using Pair = std::pair<std::size_t, std::size_t>; // indices of facets

  Self_intersection_3(const Matrix3Xd& points, const std::vector<Facet>& facets) : m_points(points), m_facets(facets)
  {}

  // The first pair, whatever the order is in which the boxes are compared. Triangles without area are left out. Nothing, if
  // the budget ends before all have been compared.
  std::optional<Pair> find(const Budget& budget = Budget()) const
  {
    std::vector<Box> boxes;
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      if(const Triangle t = triangle(f); !CGAL::collinear(t[0], t[1], t[2]))
        boxes.emplace_back(t.bbox(), f);
    std::optional<Pair> result;
    struct End_of_time {}; // the only way out of the comparison
    try
    {
      CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b)
      {
        if(budget.is_exhausted())
          throw End_of_time();
        const Pair pair = std::minmax(a.info(), b.info());
        if((!result || pair < *result) && do_intersect(pair.first, pair.second))
          result = pair;
      });
    }
    catch(const End_of_time&) { return std::nullopt; }
    return result;
  }

private:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Triangle = Kernel::Triangle_3;
  using Segment = Kernel::Segment_3;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

  Exact_point_3 point(const int v) const { return exact_point(m_points.col(v)); }

  Triangle triangle(const std::size_t f) const
  { return Triangle(point(m_facets[f][0]), point(m_facets[f][1]), point(m_facets[f][2])); }

  // Common vertices come last.
  static int put_common_vertices_last(Facet& f, const Facet& other)
  {
    const auto is_single = [&](const int v) { return std::find(other.begin(), other.end(), v) == other.end(); };
    return static_cast<int>(f.end() - std::stable_partition(f.begin(), f.end(), is_single));
  }

  bool do_intersect(const std::size_t a, const std::size_t b) const
  {
    Facet f = m_facets[a], g = m_facets[b];
    const int n = put_common_vertices_last(f, g);
    put_common_vertices_last(g, f);
    if(n == 0)
      return CGAL::do_intersect(triangle(a), triangle(b));
    if(n == 1) // the common vertex is an end of all other edges
      return CGAL::do_intersect(Segment(point(f[0]), point(f[1])), triangle(b))
          || CGAL::do_intersect(Segment(point(g[0]), point(g[1])), triangle(a));
    if(n == 2) // folded onto each other
      return CGAL::coplanar(point(f[1]), point(f[2]), point(f[0]), point(g[0]))
          && CGAL::coplanar_orientation(point(f[1]), point(f[2]), point(f[0]), point(g[0])) == CGAL::POSITIVE;
    return true;
  }

  const Matrix3Xd& m_points;
  const std::vector<Facet>& m_facets;
};

// The vertices a proof is about: its free vertices, and those that all its cells share.
// These are the ends of an edge, the vertices of a cell, or a single vertex.
inline std::set<int> blamed_vertices(const Infeasibility_proof_3& proof, const Numbered_mesh_3& mesh)
{
  std::set<int> result;
  for(const std::size_t c : proof.cells)
    for(const int v : mesh.cells[c])
    {
      const bool is_shared = std::all_of(proof.cells.begin(), proof.cells.end(), [&](const std::size_t d)
      { return std::find(mesh.cells[d].begin(), mesh.cells[d].end(), v) != mesh.cells[d].end(); });
      if(is_shared || !mesh.is_fixed(v))
        result.insert(v);
    }
  return result;
}

// A sentence for the user about some proofs, at least one.
inline std::string describe_infeasibility(const std::vector<Infeasibility_proof_3>& proofs, const Numbered_mesh_3& mesh)
{
  std::string points;
  for(const int v : blamed_vertices(proofs.front(), mesh))
    points += (points.empty() ? "" : ", ") + describe(mesh.source.col(v));
  return sentence("No map with this connectivity meets this boundary, because the cells of a set cannot all be positive. Number "
                  "of such sets found: ", proofs.size(), ". Number of cells of the first set: ",
                  proofs.front().cells.size(), ", around the vertices of the source at ", points, ".");
}

// A sentence with the cells, the first ones of many; by default if there is no proof.
inline std::string describe_inverted_cells(const std::vector<std::size_t>& cells, const Numbered_mesh_3& mesh,
                                           std::string result = "With the boundary at its targets, these cells stay inverted: ")
{
  constexpr std::size_t maximum_number = 5; // as many as one looks at
  const std::size_t number = (std::min)(maximum_number, cells.size());
  for(std::size_t i = 0; i < number; ++i)
    result += sentence(i == 0 ? "" : ", ", mesh.user_number(cells[i]));
  return result + (cells.size() > number ? sentence(", and ", cells.size() - number, " others.") : ".");
}

// Two facets in which the image of the boundary intersects itself, with a space and the name of that surface in front; empty if
// there are none.
inline std::string describe_self_intersection(const Numbered_mesh_3& mesh, const Matrix3Xd& image, const char* const name,
                                              const Budget& budget)
{
  const std::vector<std::array<int, 3> > facets = boundary_facets_3(mesh.cells, mesh.is_parallel);
  const auto found = Self_intersection_3(image, facets).find(budget);
  if(!found)
    return "";
  const auto corners = [&](const std::size_t facet)
  {
    const auto& [a, b, c] = facets[facet];
    return describe(mesh.source.col(a)) + ", " + describe(mesh.source.col(b)) + ", " + describe(mesh.source.col(c));
  };
  return sentence(" The ", name, " intersects itself, for instance in the images of two facets. The vertices of the first facet "
                  "are at ", corners(found->first), " in the source, and those of the second one at ", corners(found->second));
}

// Looks at the cells that are not positive in the best images that were found.
inline Diagnosis_3 diagnose_3(const Numbered_mesh_3& mesh, const std::vector<std::size_t>& inverted_cells,
                              const Budget& budget)
{
  const std::vector<Infeasibility_proof_3> proofs = prove_infeasibility_3(mesh, inverted_cells, budget);
  return { inverted_cells, proofs.size(), proofs.empty() ? describe_inverted_cells(inverted_cells, mesh)
                                                         : describe_infeasibility(proofs, mesh) };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_DIAGNOSE_3_H
