// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// Numbers with a name that a file has for each point, or for each cell, facet or edge.
struct Data_array_3
{
  std::string name;                     ///< the name in the file
  std::size_t number_of_components = 1; ///< numbers of each element
  bool has_integers = false;            ///< whether the file has integers, which are not interpolated
  std::vector<double> values = {};      ///< the components of the first element, then those of the second, ...
};

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// A tetrahedral mesh as a file holds it: arrays in the order of the file, indices that start at 0. References are
/// numbers of materials or patches, 0 if there is none.
///
/// If a mesh is refined, parts of cells, facets and edges have the references and data of these. Point data of a new
/// vertex are interpolated, but integers are those of a vertex beside it.
struct Tetrahedron_soup_3
{
  std::vector<std::array<double, 3> > points;        ///< the coordinates of the vertices
  std::vector<std::array<std::size_t, 4> > cells;    ///< four indices of points each; all cells oriented alike
  std::vector<int> cell_references;                  ///< one per cell
  std::vector<std::array<std::size_t, 3> > facets;   ///< marked facets, of the boundary or inside, in any orientation
  std::vector<int> facet_references;                 ///< one per facet
  std::vector<std::array<std::size_t, 2> > edges = {};        ///< marked edges
  std::vector<int> edge_references = {};                      ///< one per edge
  std::vector<std::size_t> corners = {};                      ///< marked points, which VTU files do not hold
  std::map<std::pair<int, int>, std::string> group_names = {}; ///< by dimension (3 for cells) and reference
  std::vector<Data_array_3> point_data = {};                  ///< arrays with values of the points
  std::vector<Data_array_3> cell_data = {};                   ///< arrays with values of the cells
  std::vector<Data_array_3> facet_data = {};                  ///< arrays with values of the facets
  std::vector<Data_array_3> edge_data = {};                   ///< arrays with values of the edges
  std::vector<std::string> notes = {};                        ///< sentences on what the file has and the soup has not
};

namespace internal {

// Calls f for each vertex of a cell, facet, edge or corner, which f may replace.
template <typename Function>
void for_each_vertex(Tetrahedron_soup_3& soup, const Function& f)
{
  const auto for_each_of = [&](auto& simplices)
  {
    for(auto& simplex : simplices)
      std::for_each(simplex.begin(), simplex.end(), f);
  };
  for_each_of(soup.cells);
  for_each_of(soup.facets);
  for_each_of(soup.edges);
  std::for_each(soup.corners.begin(), soup.corners.end(), f);
}

// Keeps the elements with some indices, which ascend, of an array with several numbers for each element.
template <typename Values>
void keep_elements(const std::vector<std::size_t>& kept, Values& values, const std::size_t number_of_components = 1)
{
  for(std::size_t k = 0; k < kept.size(); ++k)
    for(std::size_t i = 0; i < number_of_components; ++i)
      values[k * number_of_components + i] = values[kept[k] * number_of_components + i];
  values.resize(kept.size() * number_of_components);
}

inline void keep_elements(const std::vector<std::size_t>& kept, std::vector<Data_array_3>& arrays)
{
  for(Data_array_3& array : arrays)
    keep_elements(kept, array.values, array.number_of_components);
}

} // namespace internal

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_3_H
