// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BODY_WITH_DOMAIN_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BODY_WITH_DOMAIN_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Mapped_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Input_check_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/check_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <optional>

namespace CGAL::Polycube_meshing_3::internal {

// Checks that a map has a cell, that coordinates at vertices of cells are finite, that not all points coincide, and that points
// and images are neither too small nor too large for energies. Throws Input_error if arrays do not fit together.
inline Input_check_3 check_map_3(const Mapped_soup_3& soup)
{
  if(soup.cells.empty())
    return failed_check(ERROR_EMPTY_COMPLEX, get_error_message(ERROR_EMPTY_COMPLEX));
  check_simplices(soup);
  const std::vector<Vector_3> points = vectors_of(soup.points), images = vectors_of(soup.images);
  Box_3 source, image;
  for(const std::array<std::size_t, 4>& cell : soup.cells)
    for(const std::size_t v : cell)
    {
      if(!points[v].allFinite() || !images[v].allFinite())
        return failed_check(ERROR_NON_FINITE_COORDINATE, "Point ", v, " has the coordinates ", describe(points[v]),
                            " and the image ", describe(images[v]), ".");
      source.extend(points[v]);
      image.extend(images[v]);
    }
  if(source.diagonal() == Vector_3::Zero())
    return failed_check(ERROR_INVERTED_SOURCE_CELL, "All points of the source coincide.");
  const Input_check_3 check = check_size(source, "source");
  return check.status == OK ? check_size(image, "images") : check;
}

// Body that is mapped to a domain whose boundary facets are orthogonal to the axes.
struct Body_with_domain_3
{
  const Mapped_soup_3& soup;
  const std::vector<Vector_3> points, images; // of the soup
  const Body_surface_3 surface;
  const Volume_map_3 map;
  const bool is_parallel; // may threads share the work?

  Body_with_domain_3(const Mapped_soup_3& s, const bool may_use_threads)
    : soup(s), points(vectors_of(s.points)), images(vectors_of(s.images)), surface(s), map(s.points, s.cells, s.images),
      is_parallel(may_use_threads)
  {}
};

using Locations_3 = std::vector<std::optional<Volume_map_3::Location> >;

// Returns the preimage of each point of the domain, without a value for points outside. Asks the budget between blocks of points;
// returns an empty vector once the budget is exhausted.
inline Locations_3 preimages_3(const Body_with_domain_3& body, const std::vector<Vector_3>& points, const Budget& budget)
{
  constexpr std::size_t size_of_block = 4096; // a guess
  Locations_3 result;
  result.reserve(points.size());
  std::vector<Volume_map_3::Point_3> block;
  for(const Vector_3& q : points)
  {
    block.push_back(exact_point(q));
    if(block.size() < size_of_block && result.size() + block.size() < points.size())
      continue;
    if(budget.is_exhausted())
      return {};
    const Locations_3 found = body.is_parallel ? body.map.preimages<Parallel_if_available_tag>(block) : body.map.preimages(block);
    result.insert(result.end(), found.begin(), found.end());
    block.clear();
  }
  return result;
}

// Returns the hexahedra of a domain with their vertices at the preimages in the body, and the old points as images. Returns no
// hexahedra once the budget is exhausted.
inline Hexahedra_3 pulled_back(const Body_with_domain_3& body, const Hexahedra_3& domain, const Budget& budget)
{
  const Locations_3 preimages = preimages_3(body, domain.points, budget);
  if(budget.is_exhausted())
    return {};
  Hexahedra_3 result = domain;
  result.images = domain.points;
  for(std::size_t v = 0; v < domain.points.size(); ++v) // padding may leave the domain
    result.points[v] = to_vector((preimages[v] ? preimages[v] : body.map.nearest_preimage(exact_point(domain.points[v])))->point);
  return result;
}

// Sets the images of vertices anew from their points. Coordinates that differ from the old ones by rounding alone, as on planes,
// keep their value.
inline void update_images(const Body_with_domain_3& body, Hexahedra_3& mesh)
{
  double rounding = 0;
  for(const Vector_3& q : mesh.images)
    rounding = (std::max)(rounding, 1e-14 * q.cwiseAbs().maxCoeff()); // a guess
  for_each_index(body.is_parallel, 0, mesh.points.size(), [&](const std::size_t v)
  {
    if(const auto image = body.map.nearest_image(exact_point(mesh.points[v])))
      for(int axis = 0; axis < 3; ++axis)
        if(const double q = image->point[axis]; std::abs(q - mesh.images[v][axis]) > rounding)
          mesh.images[v][axis] = q;
  });
}

// Puts vertices of the boundary exactly on planes of the surface that are normal to an axis, as those of symmetry.
inline void put_on_planes(const Body_surface_3& surface, Hexahedra_3& mesh)
{
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    if(is_outer[v])
      mesh.points[v] = surface.put_on_planes(mesh.points[v]);
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BODY_WITH_DOMAIN_3_H
