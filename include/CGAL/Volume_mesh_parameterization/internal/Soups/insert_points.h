// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_INSERT_POINTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_INSERT_POINTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Refinement_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/check_tetrahedron_soup.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Appends a copy of the numbers of an element.
inline void copy_data(const std::size_t element, std::vector<Data_array_3>& arrays)
{
  for(Data_array_3& array : arrays)
    for(std::size_t i = 0; i < array.number_of_components; ++i)
      array.values.push_back(double(array.values[element * array.number_of_components + i]));
}

// Makes the insertions into the body of a soup in the soup, too. New cells, facets and edges have the references and data of those
// they come from.
inline void insert_points(Body_3 body, const std::vector<Insertion_3>& insertions, Tetrahedron_soup_3& soup)
{
  Incident_simplices_3<3> facets(soup.facets, soup.points.size());
  Incident_simplices_3<2> edges(soup.edges, soup.points.size());
  const auto copy = [](const std::size_t origin, std::vector<int>& references, std::vector<Data_array_3>& data)
  {
    references.push_back(int(references[origin]));
    copy_data(origin, data);
  };
  for(const Insertion_3& insertion : insertions)
  {
    for(const std::size_t c : insertion.cells) // in the order of `Incident_simplices_3::insert()`
      for(std::size_t k = 1; k < insertion.simplex.size(); ++k)
        copy(c, soup.cell_references, soup.cell_data);
    for(const std::size_t f : facets.insert(insertion.simplex))
      copy(f, soup.facet_references, soup.facet_data);
    for(const std::size_t e : edges.insert(insertion.simplex))
      copy(e, soup.edge_references, soup.edge_data);
    for(Data_array_3& array : soup.point_data)
      for(std::size_t i = 0; i < array.number_of_components; ++i)
      {
        const auto value = [&](const std::size_t v) { return array.values[v * array.number_of_components + i]; };
        array.values.push_back(array.has_integers ? value(insertion.simplex[0]) : insertion.mean(value));
      }
  }
  soup.points = std::move(body.points);
  soup.cells = std::move(body.cells);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_INSERT_POINTS_H
