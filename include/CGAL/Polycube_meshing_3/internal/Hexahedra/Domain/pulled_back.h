// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_PULLED_BACK_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_PULLED_BACK_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Box_grid_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Sliding_hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Layers/Layer_choice_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

using Locations_3 = std::vector<std::optional<Volume_map_3::Location> >;

// Checks that a map has a cell, and at the vertices of cells only finite coordinates of sizes that numbers have room for.
inline Input_check_3 check_map_3(const Mapped_soup_3& soup)
{
  if(soup.cells.empty())
    return failed_check(ERROR_EMPTY_COMPLEX, get_error_message(ERROR_EMPTY_COMPLEX));
  check_simplices(soup);
  for(const std::array<std::size_t, 4>& cell : soup.cells)
    for(const std::size_t v : cell)
      if(!to_vector(soup.points[v]).allFinite() || !to_vector(soup.images[v]).allFinite())
        return failed_check(ERROR_NON_FINITE_COORDINATE, "Point ", v, " has the coordinates ",
                            describe(to_vector(soup.points[v])), " and the image ", describe(to_vector(soup.images[v])),
                            ".");
  Eigen::AlignedBox3d source, image;
  for(const std::array<std::size_t, 4>& cell : soup.cells)
    for(const std::size_t v : cell)
    {
      source.extend(to_vector(soup.points[v]));
      image.extend(to_vector(soup.images[v]));
    }
  if(source.sizes().isZero(0))
    return failed_check(ERROR_INVERTED_SOURCE_CELL, "All points of the source coincide.");
  const Input_check_3 check = check_size(source, "source");
  return check.status == OK ? check_size(image, "images") : check;
}

// Returns the preimages of points, in blocks between which the budget is asked; none at all once it is exhausted.
inline Locations_3 preimages_3(const Volume_map_3& map, const std::vector<std::array<double, 3> >& points,
                               const bool is_parallel, const Budget& budget)
{
  constexpr std::size_t size_of_block = 4096; // a guess
  Locations_3 result;
  result.reserve(points.size());
  std::vector<Volume_map_3::Point_3> block;
  for(const std::array<double, 3>& q : points)
  {
    block.emplace_back(q[0], q[1], q[2]);
    if(block.size() < size_of_block && result.size() + block.size() < points.size())
      continue;
    if(budget.is_exhausted())
      return {};
    const Locations_3 found = is_parallel ? map.preimages<Parallel_if_available_tag>(block) : map.preimages(block);
    result.insert(result.end(), found.begin(), found.end());
    block.clear();
  }
  return result;
}

// Finds the images of vertices. Coordinates that differ from the old ones by rounding alone, as on planes, keep their value.
inline void set_images(const Volume_map_3& map, const bool is_parallel, Hexahedron_soup_3& mesh)
{
  double rounding = 0;
  for(const std::array<double, 3>& q : mesh.images)
    rounding = (std::max)(rounding, 1e-14 * to_vector(q).lpNorm<Eigen::Infinity>());
  for_each_index(is_parallel, 0, mesh.points.size(), [&](const std::size_t v)
  {
    const auto& [x, y, z] = mesh.points[v];
    if(const auto image = map.nearest_image(Volume_map_3::Point_3(x, y, z)))
      for(std::size_t axis = 0; axis < 3; ++axis)
        if(const double q = image->point[static_cast<int>(axis)]; std::abs(q - mesh.images[v][axis]) > rounding)
          mesh.images[v][axis] = q;
  });
}

// Returns the result for input that does not allow a mesh.
inline Hexahedral_mesh_result refused_result(const Input_check_3& check)
{
  Hexahedral_mesh_result result;
  result.status = check.status;
  result.message = check.message;
  return result;
}

// Returns the hexahedra of a domain, pulled back to the body; none once the budget is exhausted.
inline Hexahedron_soup_3 pulled_back(const Volume_map_3& map, const Hexahedron_soup_3& domain, const bool is_parallel,
                                     const Budget& budget)
{
  const Locations_3 preimages = preimages_3(map, domain.points, is_parallel, budget);
  if(budget.is_exhausted())
    return {};
  Hexahedron_soup_3 result = domain;
  result.images = domain.points;
  for(std::size_t v = 0; v < domain.points.size(); ++v)
  {
    const auto& [x, y, z] = domain.points[v];
    result.points[v] = coordinates(preimages[v] ? preimages[v]->point // padding may leave the domain
                                                : map.nearest_preimage(Volume_map_3::Point_3(x, y, z))->point);
  }
  return result;
}

// Puts the vertices of the boundary onto that of the body, from which rounding may keep them where cells of the map are thin.
inline void put_on_boundary(const Body_surface_3& surface, Hexahedron_soup_3& mesh)
{
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    if(is_outer[v])
      if(const Eigen::Vector3d p = to_vector(mesh.points[v]), q = surface.nearest(p, Freedom_3::SURFACE); !surface.are_equal(p, q))
        mesh.points[v] = coordinates(q);
}

// Returns the freedom of each vertex.
inline std::vector<Freedom_3> freedoms_3(const Hexahedron_soup_3& mesh, const Body_surface_3& surface)
{
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  std::vector<Freedom_3> result;
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    result.push_back(is_outer[v] ? surface.freedom(to_vector(mesh.points[v])) : Freedom_3::SPACE);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_PULLED_BACK_H
