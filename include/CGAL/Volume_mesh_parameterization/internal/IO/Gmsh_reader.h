// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_READER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_READER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/require_tetrahedra.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>
#include <sstream>

namespace CGAL::Volume_mesh_parameterization::internal {

// Gmsh with an empty model, without messages, from here to the end of the scope.
class Gmsh_session
{
public:
  Gmsh_session()
  {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::model::add("mesh");
  }

  ~Gmsh_session() { gmsh::finalize(); }

  Gmsh_session(const Gmsh_session&) = delete;
  Gmsh_session& operator=(const Gmsh_session&) = delete;
};

// Calls f in a session. Gmsh throws its last message as a string; `remedy` ends the sentence.
template <typename Function>
auto with_Gmsh(const Function& f, const char* const remedy = "")
{
  try
  {
    const Gmsh_session session;
    return f();
  }
  catch(const std::string& message)
  {
    throw Input_error("Gmsh says: " + message.substr(0, message.find_last_not_of(" ") + 1) + remedy);
  }
}

using Names_of_groups = std::map<std::pair<int, int>, std::string>; // by dimension and reference

// Returns the names of the groups in a file. In a model of Gmsh, only one group of a dimension can have a name.
inline Names_of_groups names_of_groups(const std::string& filename)
{
  std::ifstream is(filename);
  const auto begins_with = [](const std::string& line, const char* const keyword) { return line.rfind(keyword, 0) == 0; };
  std::string line;
  while(std::getline(is, line) && !begins_with(line, "$PhysicalNames"))
    if(begins_with(line, "$Entities") || begins_with(line, "$Nodes"))
      return {}; // the names come before these
  Names_of_groups result;
  while(std::getline(is, line) && !begins_with(line, "$End"))
  {
    const std::size_t begin = line.find('"'), end = line.rfind('"');
    int dimension, reference;
    if(std::istringstream(line) >> dimension >> reference && begin < end)
      result[{ dimension, reference }] = line.substr(begin + 1, end - begin - 1);
  }
  return result;
}

// Makes a soup of the model that Gmsh has read, or has filled with tetrahedra. Entities stand for groups if there are none.
class Gmsh_reader
{
public:
  // Elements of the curves `left_out` are no edges of the soup.
  explicit Gmsh_reader(std::set<int> left_out = {}) : m_left_out(std::move(left_out)) {}

  // The names are those of groups for which the model has none.
  Tetrahedron_soup_3 read(const Names_of_groups& names = {})
  {
    read_points();
    std::array<bool, 4> has_groups = {};
    gmsh::vectorpair groups, entities;
    gmsh::model::getPhysicalGroups(groups);
    for(const auto& [dimension, tag] : groups)
    {
      has_groups[dimension] = true;
      std::string name;
      gmsh::model::getPhysicalName(dimension, tag, name);
      if(const auto in_file = names.find({ dimension, tag }); name.empty() && in_file != names.end())
        name = in_file->second;
      if(!name.empty())
        m_soup.group_names[{ dimension, tag }] = name;
    }
    gmsh::model::getEntities(entities);
    for(const auto& [dimension, tag] : entities)
    {
      if(dimension == 1 && m_left_out.count(tag) != 0)
        continue;
      if(!has_groups[dimension])
        read_name(dimension, tag);
      read_entity(dimension, has_groups[dimension] ? groups_of(dimension, tag) : std::vector<int>{ tag }, tag);
    }
    add_quadrilaterals();
    require_tetrahedra(m_soup.cells.size(), m_soup.facets.size(), "gmsh -save -o");
    read_data();
    if(m_has_higher_order)
      remove_nodes_of_higher_order(m_soup);
    return std::move(m_soup);
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Points are in the order of their tags.
  void read_points()
  {
    std::vector<std::size_t> tags, order;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters, -1, -1, false, false);
    order.resize(tags.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](const std::size_t i, const std::size_t j) { return tags[i] < tags[j]; });
    for(const std::size_t i : order)
    {
      const std::array<double, 3> point = { coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2] };
      if(!std::all_of(point.begin(), point.end(), [](const double x) { return std::isfinite(x); }))
        throw Input_error("a coordinate is not finite");
      m_points[tags[i]] = m_soup.points.size();
      m_soup.points.push_back(point);
    }
  }

  // A shape of CAD has the names of its assemblies before its own, which may be one that no user gave.
  void read_name(const int dimension, const int tag)
  {
    std::string name;
    gmsh::model::getEntityName(dimension, tag, name);
    name.erase(0, name.rfind('/') + 1);
    if(!name.empty() && name.find("Open CASCADE STEP translator") != 0)
      m_soup.group_names[{ dimension, tag }] = name;
  }

  // The groups of an entity, or else no group.
  static std::vector<int> groups_of(const int dimension, const int tag)
  {
    std::vector<int> result;
    gmsh::model::getPhysicalGroupsForEntity(dimension, tag, result);
    if(result.empty())
      result.push_back(0);
    return result;
  }

  void read_entity(const int dimension, const std::vector<int>& references, const int entity)
  {
    std::vector<int> types;
    std::vector<std::vector<std::size_t> > tags, nodes;
    gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity);
    for(std::size_t t = 0; t < types.size(); ++t)
    {
      std::string name;
      int type_dimension, order, number_of_nodes, number_of_corners;
      std::vector<double> coordinates;
      gmsh::model::mesh::getElementProperties(types[t], name, type_dimension, order, number_of_nodes, coordinates,
                                              number_of_corners);
      const std::size_t n = static_cast<std::size_t>(number_of_corners);
      const bool is_polyhedron = dimension == 3 && (n == 5 || n == 6 || n == 8);
      if(dimension == 3 && n != 4 && !is_polyhedron)
        throw Input_error(sentence_on_other_cells("elements of Gmsh's type '" + name + "'"));
      if(dimension == 0 || (dimension == 1 && n != 2))
        continue;
      m_has_higher_order = m_has_higher_order || order > 1;
      m_number_of_polyhedra += is_polyhedron ? tags[t].size() : 0;
      for(const int reference : references) // an element has an entry for each of its groups
        for(std::size_t i = 0; i < tags[t].size(); ++i)
          add(dimension, tags[t][i], &nodes[t][i * static_cast<std::size_t>(number_of_nodes)], n, reference);
    }
  }

  // Adds an element with these corners. Quadrilaterals become triangles if the mesh has polyhedra: see `add_quadrilaterals()`.
  void add(const int dimension, const std::size_t tag, const std::size_t* const nodes, const std::size_t number_of_corners,
           const int reference)
  {
    std::vector<std::size_t> corners;
    for(std::size_t i = 0; i < number_of_corners; ++i)
      corners.push_back(m_points.at(nodes[i]));
    switch(number_of_corners)
    {
      case 2: return append(std::array{ corners[0], corners[1] }, m_soup.edges, m_soup.edge_references, m_edges, tag, reference);
      case 3: return append(std::array{ corners[0], corners[1], corners[2] }, m_soup.facets, m_soup.facet_references, m_facets,
                            tag, reference);
      case 4:
        if(dimension == 2)
          return m_quadrilaterals.push_back({ corners, tag, reference });
        return append(std::array{ corners[0], corners[1], corners[2], corners[3] }, m_soup.cells, m_soup.cell_references, m_cells,
                      tag, reference);
      default:
        for_each_tetrahedron(corners, [&](const std::array<std::size_t, 4>& cell)
                             { append(cell, m_soup.cells, m_soup.cell_references, m_cells, tag, reference); });
    }
  }

  template <std::size_t N>
  static void append(const std::array<std::size_t, N>& simplex, std::vector<std::array<std::size_t, N> >& simplices,
                     std::vector<int>& references, std::vector<std::size_t>& tags, const std::size_t tag, const int reference)
  {
    simplices.push_back(simplex);
    references.push_back(reference);
    tags.push_back(tag);
  }

  void add_quadrilaterals()
  {
    if(m_number_of_polyhedra == 0)
      return;
    for(const Quadrilateral& quadrilateral : m_quadrilaterals)
      for_each_triangle(quadrilateral.corners, [&](const std::array<std::size_t, 3>& facet)
      { append(facet, m_soup.facets, m_soup.facet_references, m_facets, quadrilateral.tag, quadrilateral.reference); });
    m_soup.notes.push_back(note_of_split_cells(m_number_of_polyhedra));
  }

  // Reads the first step of each view.
  void read_data()
  {
    std::vector<int> views;
    gmsh::view::getTags(views);
    std::vector<std::size_t> points;
    for(const auto& [tag, p] : m_points)
      points.push_back(tag);
    for(std::size_t i = 0; i < views.size(); ++i)
    {
      std::string name, type;
      std::vector<std::size_t> tags;
      std::vector<std::vector<double> > data;
      double time;
      int number_of_components;
      gmsh::option::getString("View[" + std::to_string(i) + "].Name", name);
      gmsh::view::getModelData(views[i], 0, type, tags, data, time, number_of_components);
      std::map<std::size_t, const std::vector<double>*> values;
      for(std::size_t k = 0; k < tags.size(); ++k)
        values[tags[k]] = &data[k];
      const auto add_to = [&](std::vector<Data_array_3>& arrays, const std::vector<std::size_t>& elements)
      {
        arrays.push_back({ name, static_cast<std::size_t>(number_of_components), false, {} });
        for(const std::size_t tag : elements)
          for(std::size_t k = 0; k < arrays.back().number_of_components; ++k)
            arrays.back().values.push_back(values.count(tag) != 0 && k < values[tag]->size()
                                             ? (*values[tag])[k] : std::numeric_limits<double>::quiet_NaN());
      };
      if(type == "NodeData")
        add_to(m_soup.point_data, points);
      else if(type == "ElementData")
      {
        add_to(m_soup.cell_data, m_cells);
        add_to(m_soup.facet_data, m_facets);
        add_to(m_soup.edge_data, m_edges);
      }
      else
        m_soup.notes.push_back("the data '" + name + "' of the kind " + type + " are left out");
    }
  }

  struct Quadrilateral
  {
    std::vector<std::size_t> corners;
    std::size_t tag;
    int reference;
  };

  std::set<int> m_left_out;
  std::vector<Quadrilateral> m_quadrilaterals;
  std::size_t m_number_of_polyhedra = 0;
  Tetrahedron_soup_3 m_soup;
  std::map<std::size_t, std::size_t> m_points;          // by their tags, in the order of these
  std::vector<std::size_t> m_edges, m_facets, m_cells;  // their tags
  bool m_has_higher_order = false;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_READER_H
