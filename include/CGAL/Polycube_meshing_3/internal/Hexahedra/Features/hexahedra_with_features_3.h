// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_HEXAHEDRA_WITH_FEATURES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_HEXAHEDRA_WITH_FEATURES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/Placed_features_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/Sheets_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Hexahedra_problem_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Hexahedra_improvement_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Layers/Layer_choice_3.h>

#include <array>
#include <limits>
#include <memory>
#include <optional>

namespace CGAL::Polycube_meshing_3::internal {

constexpr double tolerance_of_features = 0.1; // largest distance of hexahedra from features that they keep, in edges

// Returns for each corner of a body the vertices of the boundary that are near it.
inline std::vector<std::vector<std::size_t> > vertices_at_corners_3(const Body_complex_3& complex, const Hexahedra_3& mesh,
                                                                    const double edge)
{
  std::vector<std::vector<std::size_t> > result(complex.corners().size());
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  for(std::size_t c = 0; c < result.size(); ++c)
    for(std::size_t v = 0; v < is_outer.size() && complex.corners()[c].is_of_body; ++v)
      if(is_outer[v] && (mesh.points[v] - complex.points()[complex.corners()[c].vertex]).norm() <= tolerance_of_features * edge)
        result[c].push_back(v);
  return result;
}

// Counts and names the corners, curves and patches of a body that hexahedra keep: a corner is near a vertex of the boundary, all
// vertices of a curve and middles of its edges are near edges, the curves of a patch are kept, and it has a quadrangle. Near is
// within the tolerance.
inline Hexahedral_mesh_features kept_features_3(const Body_complex_3& complex, const Body_surface_3& boundary,
                                                const Hexahedra_3& mesh, const double edge)
{
  AABB_trees_3::Segments segments;
  for(const auto& [v, w] : boundary_edges_3(mesh))
    segments.emplace_back(exact_point(mesh.points[v]), exact_point(mesh.points[w]));
  AABB_trees_3::Of_segments edges(segments.cbegin(), segments.cend());
  edges.accelerate_distance_queries();
  Hexahedral_mesh_features result;
  const auto count = [&](const bool is_kept, const Vector_3& point, std::size_t& number, std::size_t& number_of_kept,
                         std::vector<std::array<double, 3> >& given_up)
  {
    ++number;
    if(is_kept)
      ++number_of_kept;
    else
      given_up.push_back(coordinates(point));
  };
  const std::vector<std::vector<std::size_t> > at_corners = vertices_at_corners_3(complex, mesh, edge);
  for(std::size_t c = 0; c < at_corners.size(); ++c)
    if(const Corner_3& corner = complex.corners()[c]; corner.is_of_body)
      count(!at_corners[c].empty(), complex.points()[corner.vertex], result.number_of_corners, result.number_of_corners_kept,
            result.corners_given_up);
  std::vector<bool> is_curve_kept(complex.number_of_curves(), true), is_patch_kept(complex.number_of_patches(), false);
  for(std::size_t a = 0; a < complex.arcs().size(); ++a)
  {
    const std::vector<Vector_3>& points = complex.line(a).points();
    for(std::size_t i = 0; i < points.size(); ++i)
      for(const Vector_3& p : { points[i], Vector_3((points[i] + points[i - (i > 0)]) / 2) })
        if(std::sqrt(edges.squared_distance(exact_point(p))) > tolerance_of_features * edge)
          is_curve_kept[complex.arcs()[a].curve] = false;
  }
  for(const std::array<std::size_t, 4>& q : mesh.facets)
    is_patch_kept[complex.patch_of_facet(boundary.nearest_facet(center_of(mesh.points, q)))] = true;
  std::vector<bool> is_counted(complex.number_of_curves(), false);
  for(std::size_t a = 0; a < complex.arcs().size(); ++a)
  {
    const std::size_t curve = complex.arcs()[a].curve;
    if(!is_curve_kept[curve])
      for(const std::size_t patch : complex.arcs()[a].patches)
        is_patch_kept[patch] = false;
    if(!is_counted[curve])
      count(is_curve_kept[curve], complex.line(a).point(complex.line(a).length() / 2), result.number_of_curves,
            result.number_of_curves_kept, result.curves_given_up);
    is_counted[curve] = true;
  }
  for(std::size_t patch = 0; patch < is_patch_kept.size(); ++patch)
    count(is_patch_kept[patch], complex.point_in_patch(patch), result.number_of_patches, result.number_of_patches_kept,
          result.patches_given_up);
  return result;
}

inline std::size_t number_of_kept(const Hexahedral_mesh_features& features)
{ return features.number_of_corners_kept + features.number_of_curves_kept + features.number_of_patches_kept; }

inline std::size_t number_of_features(const Hexahedral_mesh_features& features)
{ return features.number_of_corners + features.number_of_curves + features.number_of_patches; }

// Returns a sentence on features that are not kept at a spacing; an empty string if all are.
inline std::string sentence_on_features(const Hexahedral_mesh_features& features, const double spacing)
{
  constexpr double smaller = 0.75; // makes 2.4 times as many hexahedra; three of six bodies that lost features kept all with it
  if(number_of_kept(features) == number_of_features(features))
    return "";
  const auto& positions = !features.curves_given_up.empty() ? features.curves_given_up
                        : !features.corners_given_up.empty() ? features.corners_given_up : features.patches_given_up;
  return sentence(" Hexahedra keep ", features.number_of_corners_kept, " of ", features.number_of_corners, " corners, ",
                  features.number_of_curves_kept, " of ", features.number_of_curves, " curves and ",
                  features.number_of_patches_kept, " of ", features.number_of_patches,
                  " patches of the boundary. One that is not kept is at ", describe(to_vector(positions[0])),
                  ". To keep more, make the spacing smaller, such as ", smaller * spacing, ".");
}

// Adds to the soup the edges with both vertices on one curve, with its reference, and the vertices at corners. Takes the length of
// edges without distortion.
inline void add_features(const Body_complex_3& complex, const Hexahedra_3& mesh, const double edge, Hexahedron_soup_3& soup)
{
  const double tolerance = tolerance_of_features * edge, rounding = 1e-6 * edge;
  for(const std::vector<std::size_t>& at_corner : vertices_at_corners_3(complex, mesh, edge))
    soup.corners.insert(soup.corners.end(), at_corner.begin(), at_corner.end());
  for(const auto& [v, w] : boundary_edges_3(mesh))
  {
    std::pair<double, std::size_t> nearest = { tolerance, complex.arcs().size() };
    for(std::size_t a = 0; a < complex.arcs().size(); ++a)
    {
      const auto distance = [&](const Vector_3& p) { return complex.line(a).nearest(p).first; };
      if(distance(mesh.points[v]) <= rounding && distance(mesh.points[w]) <= rounding)
        nearest = (std::min)(nearest, { distance((mesh.points[v] + mesh.points[w]) / 2), a });
    }
    if(nearest.second == complex.arcs().size())
      continue;
    soup.edges.push_back({ v, w });
    soup.edge_references.push_back(complex.arcs()[nearest.second].reference);
  }
}

// Returns hexahedra with a layer along the boundary, and with more edges at the vertices for corners where many arcs end: one of
// the hexahedra there gets a layer around it, but not on the boundary.
inline Hexahedra_3 with_room_for_corners_3(const Body_complex_3& complex, const Hexahedra_3& mesh, const double edge)
{
  constexpr int number_of_rounds = 6; // a guess
  std::vector<int> parts(mesh.cells.size(), 0);
  Hexahedra_3 result = Padding_3(mesh, quadrangles_in(mesh, all_faces_of_domain(mesh)), parts).result();
  for(int round = 0; round < number_of_rounds; ++round)
  {
    std::vector<Quadrangle_of_hexahedron> covered;
    parts.assign(result.cells.size(), 0);
    int part = 0;
    for(const std::size_t c : Feature_embedding_3(complex, result, edge).hexahedra_without_room())
    {
      parts[c] = ++part;
      for(std::size_t side = 0; side < 6; ++side)
        covered.push_back({ c, side });
    }
    if(covered.empty())
      break;
    for(std::size_t f = 0; f < result.facets.size(); ++f)
      if(parts[result.facet_cells[f]] > 0)
        covered.erase(std::find_if(covered.begin(), covered.end(), [&, side = side_of_facet(result, f)](const auto& q)
                                   { return q.cell == result.facet_cells[f] && q.side == side; }));
    result = Padding_3(result, covered, parts).result();
  }
  return result;
}

// Hexahedra with vertices and paths for the features of a body.
struct Embedded_features_3
{
  Hexahedra_3 mesh;
  Feature_embedding_3 embedding; // refers to the mesh and the complex; has paths as soon as it has been run

  Embedded_features_3(const Body_complex_3& complex, Hexahedra_3 hexahedra, const double edge)
    : mesh(std::move(hexahedra)), embedding(complex, mesh, edge)
  {}

  Embedded_features_3(const Embedded_features_3&) = delete;

  // Returns the sheet across an edge of the graph.
  std::size_t sheet(const Sheets_3& sheets, const std::size_t e) const
  { return sheets.sheet({ embedding.graph().source(e), embedding.graph().target(e) }); }
};

// Returns sheets across paths that have too few edges for the bends of their arcs, those across the longest edges of a path first.
// The sheets add `most` hexahedra at most.
inline std::set<std::size_t> sheets_for_bends_3(const Body_complex_3& complex, const Embedded_features_3& features,
                                                const Sheets_3& sheets, const double edge, std::size_t most)
{
  std::set<std::size_t> result;
  const Boundary_graph_3& graph = features.embedding.graph();
  const std::vector<Vector_3>& points = features.mesh.points;
  for(std::size_t a = 0; a < complex.arcs().size(); ++a)
  {
    const std::vector<std::size_t>& path = features.embedding.path(a);
    const std::size_t needed = 1 + complex.line(a).bends(distance_of_bends * edge).size();
    if(path.size() >= needed || path.empty())
      continue;
    std::vector<std::pair<double, std::size_t> > candidates;
    std::size_t number = path.size();
    for(const std::size_t e : path)
      if(const std::size_t sheet = features.sheet(sheets, e); result.count(sheet) > 0)
        ++number;
      else
        candidates.emplace_back(-(points[graph.source(e)] - points[graph.target(e)]).norm(), sheet);
    std::sort(candidates.begin(), candidates.end());
    for(auto candidate = candidates.begin(); candidate != candidates.end() && number < needed; ++candidate)
      number += sheets.take(candidate->second, result, most);
  }
  return result;
}

// Returns hexahedra with paths for features but the curves given up, made of others by a layer along the boundary and sheets
// across curves that have too few edges. Then sheets across contested edges are cut, as long as fewer arcs are given up with them.
// Returns null if there are no paths.
inline std::unique_ptr<Embedded_features_3> embedded_features_3(const Body_complex_3& complex, const Hexahedra_3& start,
                                                                const double edge, const Budget& budget,
                                                                const std::set<std::size_t>& curves_given_up = {})
{
  constexpr double largest_growth = 0.5; // a guess; part of the hexahedra that sheets across curves may add
  std::unique_ptr<Embedded_features_3> result;
  Hexahedra_3 mesh = with_room_for_corners_3(complex, start, edge);
  std::size_t most = static_cast<std::size_t>(largest_growth * static_cast<double>(mesh.cells.size()));
  for(bool is_for_room = false; ; ) // whether the last cuts are across contested edges
  {
    auto next = std::make_unique<Embedded_features_3>(complex, std::move(mesh), edge);
    if(!next->embedding.run(budget, curves_given_up)
       || (is_for_room && next->embedding.number_given_up() >= result->embedding.number_given_up()))
      return result;
    if(result) // sheets that cross add more than both alone
      most -= (std::min)(most, next->mesh.cells.size() - result->mesh.cells.size());
    result = std::move(next);
    const Sheets_3 sheets(result->mesh);
    std::set<std::size_t> cut = sheets_for_bends_3(complex, *result, sheets, edge, most);
    is_for_room = cut.empty();
    if(std::size_t left = most; is_for_room)
      for(const std::size_t e : result->embedding.contested())
        sheets.take(result->sheet(sheets, e), cut, left);
    if(cut.empty())
      return result;
    mesh = sheets.cut(cut);
  }
}

// Returns a curve near each hexahedron that is inverted or not usable: of the curves with a path within an edge of the center, the
// one with the shortest arc, which has least room.
inline std::set<std::size_t> curves_without_room_3(const Body_complex_3& complex, const Feature_embedding_3& embedding,
                                                   const Hexahedra_3& mesh, const double edge)
{
  const std::vector<double> quality = scaled_jacobians(mesh);
  std::set<std::size_t> result;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    if(quality[c] >= usable_scaled_jacobian && is_positive_hexahedron(mesh.points, mesh.cells[c]))
      continue;
    std::pair<double, std::size_t> shortest = { (std::numeric_limits<double>::infinity)(), 0 };
    for(std::size_t a = 0; a < complex.arcs().size(); ++a)
      if(!embedding.path(a).empty() && complex.line(a).nearest(center_of(mesh.points, mesh.cells[c])).first <= edge)
        shortest = (std::min)(shortest, { complex.line(a).length(), complex.arcs()[a].curve });
    if(std::isfinite(shortest.first))
      result.insert(shortest.second);
  }
  return result;
}

// Returns hexahedra with their boundary as it is, and vertices inside moved onto the interfaces that they are at.
inline Placed_hexahedra_3 on_interfaces_3(Placed_hexahedra_3 hexahedra, Body_interfaces_3& interfaces)
{
  std::vector<Interface_quadrangle_3> quadrangles = interface_quadrangles_3(hexahedra.mesh);
  set_patches(hexahedra.mesh, interfaces, quadrangles);
  const Placed_hexahedra_3 others = placed_hexahedra_3(hexahedra.mesh, quadrangles, interfaces);
  for(std::size_t v = 0; v < others.positions.size(); ++v)
    if(!hexahedra.positions[v].is_on_boundary)
    {
      hexahedra.positions[v] = others.positions[v];
      hexahedra.mesh.points[v] = others.mesh.points[v];
    }
  hexahedra.covered.insert(hexahedra.covered.end(), others.covered.begin() + 1, others.covered.end());
  return hexahedra;
}

// Returns hexahedra with features of the body, with other sheets where a quadrangle would be flat, and new positions, on
// interfaces unless these are staircases. Returns no hexahedra if there are no paths. If hexahedra are not usable, vertices may
// leave their curves. If this does not help, all layers stay, and after that, curves near bad hexahedra are given up.
inline Best_hexahedra_3 fitted_to_features_3(const Body_complex_3& complex, std::unique_ptr<Embedded_features_3> features,
                                             Body_interfaces_3& interfaces, const Best_hexahedra_3& start, Linear_solver_3& solver,
                                             const bool is_parallel, const Budget& budget)
{
  constexpr int number_of_rounds = 5; // a guess
  const double edge = start.edge;
  Best_hexahedra_3 result = { edge, {}, {}, start.staircases };
  std::set<std::size_t> curves_given_up;
  for(int round = 0; round < number_of_rounds; ++round)
  {
    if(!curves_given_up.empty())
      features = embedded_features_3(complex, start.mesh, edge, budget, curves_given_up);
    if(!features)
      return result;
    const Placed_features_3 placed(complex, features->embedding, features->mesh, edge, interfaces.boundary(), round == 0);
    Sliding_hexahedra_3 hexahedra(start.staircases == Staircases::NONE ? on_interfaces_3(placed.result(), interfaces)
                                                                       : placed.result(), solver, is_parallel, budget);
    Best_hexahedra_3 next = { edge, {}, {}, start.staircases };
    for(const std::optional<double> bound_of_lines : { std::optional<double>(), std::optional<double>(usable_scaled_jacobian) })
      if(!is_at_least(next.result, usable_scaled_jacobian))
        Hexahedra_improvement_3(hexahedra, true, budget, next, bound_of_lines).run();
    result.take_if_better(next.result, next.mesh);
    if(is_at_least(result.result, usable_scaled_jacobian))
      break;
    if(placed.has_removed_layers())
      continue;
    const std::set<std::size_t> curves = curves_without_room_3(complex, features->embedding, next.mesh, edge);
    if(curves.empty())
      break;
    curves_given_up.insert(curves.begin(), curves.end());
  }
  return result;
}

// Complex of a body, with hexahedra that have paths for its arcs; null if there are none.
struct Complex_with_paths_3
{
  std::unique_ptr<Body_complex_3> complex;
  std::unique_ptr<Embedded_features_3> features;

  // Returns the number of arcs given up; the largest number there is if there are no paths.
  std::ptrdiff_t number_given_up() const
  { return features ? features->embedding.number_given_up() : (std::numeric_limits<std::ptrdiff_t>::max)(); }
};

// Returns a complex whose needles share edges of hexahedra. Needles of up to 11 degrees do if no arc is given up for that;
// otherwise only those below 7 degrees, unless more arcs are given up then.
inline Complex_with_paths_3 complex_with_paths_3(const Body_with_domain_3& body, const Best_hexahedra_3& others,
                                                 const Budget& budget)
{
  constexpr double width_without_room = 0.09;                    // a guess; in edges
  constexpr std::array<double, 2> lengths_of_needles = { 5, 8 }; // guesses; in widths
  Complex_with_paths_3 best;
  for(const double length : lengths_of_needles)
    if(best.number_given_up() > 0)
    {
      Complex_with_paths_3 next
        = { std::make_unique<Body_complex_3>(body.soup, body.points, width_without_room * others.edge, length), nullptr };
      if(best.complex && next.complex->has_arcs_of(*best.complex))
        break;
      next.features = embedded_features_3(*next.complex, others.mesh, others.edge, budget);
      if(!best.complex || next.number_given_up() < best.number_given_up())
        best = std::move(next);
    }
  return best;
}

// Returns whether hexahedra with features may replace others: they are not poor, and no boundary is too far from the other one.
inline bool may_replace(const Best_hexahedra_3& others, const Hexahedral_mesh_result& with_features, const double minimum)
{
  return is_at_least(with_features, minimum)
    && with_features.boundary_distance <= (std::max)(largest_distance * others.edge, others.result.boundary_distance);
}

// Returns hexahedra that keep more features of the body than others, no fewer marked corners, and interfaces, up to a tolerance,
// as well. Returns nothing if there are no such hexahedra, or if they may not replace the others.
inline std::optional<Best_hexahedra_3> hexahedra_with_features_3(const Hexahedra_problem_3& problem,
                                                                 const Body_with_domain_3& body, Body_interfaces_3& interfaces,
                                                                 const Best_hexahedra_3& others, const Budget& budget)
{
  const Body_complex_3 complex(body.soup, body.points);
  const Hexahedral_mesh_features before = kept_features_3(complex, body.surface, others.mesh, others.edge);
  if(number_of_kept(before) == number_of_features(before))
    return std::nullopt;
  Complex_with_paths_3 with_paths = complex_with_paths_3(body, others, budget);
  Best_hexahedra_3 result = fitted_to_features_3(*with_paths.complex, std::move(with_paths.features), interfaces, others,
                                                 problem.solver, body.is_parallel, budget);
  if(!may_replace(others, result.result, problem.minimum_scaled_jacobian)
     || number_of_kept(kept_features_3(complex, body.surface, result.mesh, result.edge)) <= number_of_kept(before)
     || corners_given_up_3(body, result.mesh).size() > corners_given_up_3(body, others.mesh).size()
     || interface_distance_3(result.mesh, interfaces).distance
          > (std::max)(tolerance_of_interfaces * others.edge, interface_distance_3(others.mesh, interfaces).distance))
    return std::nullopt;
  const Body_surface_3 domain(body.images, boundary_facets_3(body.soup.cells));
  result.mesh.images.resize(result.mesh.points.size());
  for(std::size_t v = 0; v < result.mesh.points.size(); ++v)
    if(const auto image = body.map.nearest_image(exact_point(result.mesh.points[v])))
      result.mesh.images[v] = domain.put_on_planes(to_vector(image->point));
  result.has_features = true;
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_HEXAHEDRA_WITH_FEATURES_3_H
