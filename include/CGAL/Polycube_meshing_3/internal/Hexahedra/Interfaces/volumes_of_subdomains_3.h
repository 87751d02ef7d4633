// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_VOLUMES_OF_SUBDOMAINS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_VOLUMES_OF_SUBDOMAINS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_with_domain_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Interface_quadrangles_3.h>

#include <array>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the volume of a trilinear hexahedron, by the divergence theorem. The term of a bilinear quadrangle is the mean of the
// terms of its two cuts into triangles.
inline double volume_of_hexahedron(const Hexahedra_3& mesh, const std::size_t c)
{
  const Vector_3& origin = mesh.points[mesh.cells[c][0]]; // less rounding than by the origin of the axes
  double sum = 0;
  for(std::size_t side = 0; side < 6; ++side)
  {
    const std::array<std::size_t, 4> v = vertices_of(mesh, { c, side });
    const auto point = [&](const std::size_t i) -> Vector_3 { return mesh.points[v[i % 4]] - origin; };
    for(std::size_t i = 0; i < 4; ++i)
      sum += point(i).dot(point(i + 1).cross(point(i + 2))) / 12;
  }
  return sum;
}

inline double volume_of_tetrahedron(const Body_with_domain_3& body, const std::size_t c)
{
  const Matrix_3 edges = edge_matrix(body.points, body.soup.cells[c]);
  return edges.col(0).cross(edges.col(1)).dot(edges.col(2)) / 6;
}

// Sets the volume that the hexahedra of each subdomain have now.
inline void update_volumes_of_hexahedra(const Hexahedra_3& mesh, std::vector<Subdomain_volumes>& volumes)
{
  std::map<int, double> sums;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    sums[mesh.cell_references[c]] += volume_of_hexahedron(mesh, c);
  for(Subdomain_volumes& of_reference : volumes)
    of_reference.of_hexahedra = sums[of_reference.reference];
}

// Returns the volumes of all subdomains of the body, in the order of their references.
inline std::vector<Subdomain_volumes> volumes_of_subdomains(const Body_with_domain_3& body, const Hexahedra_3& mesh)
{
  std::map<int, Subdomain_volumes> volumes;
  for(std::size_t c = 0; c < body.soup.cells.size(); ++c)
    volumes[body.soup.cell_references[c]].of_tetrahedra += volume_of_tetrahedron(body, c);
  std::vector<Subdomain_volumes> result;
  for(auto& [reference, of_reference] : volumes)
  {
    of_reference.reference = reference;
    result.push_back(of_reference);
  }
  update_volumes_of_hexahedra(mesh, result);
  return result;
}

// Returns the distance out of the first of two subdomains by which their interface must move for the least sum of the squares of
// the relative errors of both volumes; 0 if no area of it moves.
inline double distance_of_least_errors(const std::vector<Subdomain_volumes>& volumes_of_all, const Body_interfaces_3::Pair& pair,
                                       const double area)
{
  double gradient = 0, curvature = 0;
  for(const Subdomain_volumes& volumes : volumes_of_all)
    if(volumes.reference == pair[0] || volumes.reference == pair[1])
    {
      const double slope = (volumes.reference == pair[0] ? area : -area) / volumes.of_tetrahedra;
      gradient += slope * (volumes.of_hexahedra / volumes.of_tetrahedra - 1);
      curvature += slope * slope;
    }
  return curvature == 0 ? 0 : -gradient / curvature;
}

// Moves the vertices of each hexahedron that is inverted, or has lost too much of its first scaled Jacobian, back to `before`.
// They may not move any more. Repeats this until there is no such hexahedron with moved vertices.
inline void undo_losses(const std::vector<Vector_3>& before, const std::vector<double>& first_quality, Hexahedra_3& mesh,
                        std::vector<bool>& may_move)
{
  constexpr double largest_loss = 0.1; // a guess
  for(bool has_changed = true; has_changed; )
  {
    has_changed = false;
    const std::vector<double> quality = scaled_jacobians(mesh);
    for(std::size_t c = 0; c < mesh.cells.size(); ++c)
      if(quality[c] < (1 - largest_loss) * first_quality[c] || !is_positive_hexahedron(mesh.points, mesh.cells[c]))
        for(const std::size_t v : mesh.cells[c])
          if(mesh.points[v] != before[v])
          {
            mesh.points[v] = before[v];
            may_move[v] = false;
            has_changed = true;
          }
  }
}

// Moves vertices that are in one patch and inside the body along normals, such that each subdomain keeps its volume. If all
// vertices are on a curved interface, its chords cut volume off. Vertices stay where hexahedra would lose too much quality.
inline void keep_volumes_3(const Body_with_domain_3& body, Body_interfaces_3& interfaces, Hexahedra_3& mesh)
{
  constexpr int number_of_rounds = 5;  // a guess
  std::vector<Interface_quadrangle_3> quadrangles = interface_quadrangles_3(mesh);
  set_patches(mesh, interfaces, quadrangles);
  std::vector<Vector_3> areas(mesh.points.size(), Vector_3::Zero()); // of quadrangles at each vertex, out of the first subdomain
  std::vector<std::set<std::size_t> > patches(mesh.points.size());
  std::map<Body_interfaces_3::Pair, std::set<std::size_t> > vertices_of_pairs;
  for(const Interface_quadrangle_3& q : quadrangles)
    for(const std::size_t v : q.vertices)
    {
      areas[v] += area_vector(mesh.points, q.vertices) / 4;
      patches[v].insert(q.patch);
      vertices_of_pairs[subdomains_of(mesh, q)].insert(v);
    }
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  std::vector<bool> may_move(mesh.points.size());
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    may_move[v] = patches[v].size() == 1 && !is_outer[v];
  const std::vector<double> quality = scaled_jacobians(mesh);
  std::vector<Subdomain_volumes> volumes_of_all = volumes_of_subdomains(body, mesh);
  for(int round = 0; round < number_of_rounds; ++round)
    for(const auto& [pair, vertices] : vertices_of_pairs)
    {
      double area = 0;
      for(const std::size_t v : vertices)
        area += may_move[v] * areas[v].norm();
      update_volumes_of_hexahedra(mesh, volumes_of_all);
      const double distance = distance_of_least_errors(volumes_of_all, pair, area);
      const std::vector<Vector_3> before = mesh.points;
      for(const std::size_t v : vertices)
        if(may_move[v])
          mesh.points[v] += distance * areas[v].stableNormalized();
      undo_losses(before, quality, mesh, may_move);
    }
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_VOLUMES_OF_SUBDOMAINS_3_H
