// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_WRITER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_WRITER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Gmsh_reader.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/add_VTU_data.h>
#include <CGAL/Volume_mesh_parameterization/repair_tetrahedron_soup.h>

#include <stdlib.h>

#include <filesystem>

namespace CGAL::Volume_mesh_parameterization::internal {

// Makes elements of Gmsh. Those with a reference are a group of that number, whatever their dimension is.
class Gmsh_writer
{
public:
  Gmsh_writer(const std::vector<std::array<double, 3> >& points, const std::map<std::pair<int, int>, std::string>& names)
    : m_points(points), m_names(names)
  {}

  // `type` is that of Gmsh. Elements may be in further groups. Returns the tags.
  template <std::size_t N>
  std::vector<std::size_t> add(const int dimension, const int type, const std::vector<std::array<std::size_t, N> >& elements,
                               const std::vector<int>& references,
                               const std::vector<std::vector<double> >& further_groups = {})
  {
    std::map<std::vector<int>, std::array<std::vector<std::size_t>, 2> > of_references; // tags, and nodes
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < elements.size(); ++i)
    {
      std::vector<int> groups = { references[i] };
      for(const std::vector<double>& further : further_groups)
        groups.push_back(static_cast<int>(further[i]));
      auto& [tags, nodes] = of_references[groups];
      result.push_back(++m_number_of_elements);
      tags.push_back(result.back());
      for(const std::size_t v : elements[i])
        nodes.push_back(v + 1);
    }
    std::map<int, std::vector<int> > entities; // of groups
    const auto add_entity = [&](const std::vector<int>& groups, const auto& tags_and_nodes, const int tag)
    {
      const int entity = gmsh::model::addDiscreteEntity(dimension, tag);
      if(m_number_of_entities++ == 0)
        add_nodes(dimension, entity);
      gmsh::model::mesh::addElementsByType(entity, type, tags_and_nodes[0], tags_and_nodes[1]);
      if(*std::max_element(groups.begin(), groups.end()) <= 0)
        gmsh::option::setNumber("Mesh.SaveAll", 1);
      for(const int reference : groups)
        if(reference > 0)
          entities[reference].push_back(entity);
    };
    const auto has_number = [](const std::vector<int>& groups) { return groups.size() == 1 && groups[0] > 0; };
    for(const auto& [groups, tags_and_nodes] : of_references)
      if(has_number(groups))
        add_entity(groups, tags_and_nodes, groups[0]);
    for(const auto& [groups, tags_and_nodes] : of_references) // which get tags that are free
      if(!has_number(groups))
        add_entity(groups, tags_and_nodes, -1);
    for(const auto& [reference, entities_of_reference] : entities)
    {
      gmsh::model::addPhysicalGroup(dimension, entities_of_reference, reference);
      if(const auto name = m_names.find({ dimension, reference }); name != m_names.end())
        gmsh::model::setPhysicalName(dimension, reference, name->second);
    }
    return result;
  }

  static void add_data(const std::string& kind, const std::vector<Data_array_3>& arrays,
                       const std::vector<std::size_t>& tags)
  {
    for(const auto& array : arrays)
    {
      std::vector<std::vector<double> > values;
      std::vector<std::size_t> tags_of_values;
      for(std::size_t i = 0; i < tags.size(); ++i)
      {
        const auto begin = array.values.begin() + static_cast<std::ptrdiff_t>(i * array.number_of_components);
        if(std::isnan(*begin))
          continue;
        values.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(array.number_of_components));
        tags_of_values.push_back(tags[i]);
      }
      gmsh::view::addModelData(gmsh::view::add(array.name), 0, "mesh", kind, tags_of_values, values, 0,
                               static_cast<int>(array.number_of_components));
    }
  }

  // Gmsh recognizes formats by names: the file gets a folder of its own.
  void write(std::ostream& os, const double version) const
  {
    namespace fs = std::filesystem;
    std::string folder = (fs::temp_directory_path() / "Gmsh.XXXXXX").string();
    if(mkdtemp(folder.data()) == nullptr)
      throw std::runtime_error(folder + ": the folder for a temporary file cannot be made");
    struct Remover
    {
      const std::string& folder;
      ~Remover() { std::error_code ignored; fs::remove_all(folder, ignored); }
    } const remover = { folder };
    const fs::path path = fs::path(folder) / "mesh.msh";
    gmsh::option::setNumber("Mesh.MshFileVersion", version);
    gmsh::option::setNumber("Mesh.Binary", version > 4 ? 1 : 0);
    gmsh::option::setNumber("PostProcessing.SaveMesh", 0);
    gmsh::write(path.string());
    std::vector<int> views;
    gmsh::view::getTags(views);
    for(const int view : views)
      gmsh::view::write(view, path.string(), true);
    std::ifstream is(path, std::ios::binary);
    if(!is || !(os << is.rdbuf()))
      throw std::runtime_error("Gmsh cannot write the mesh");
  }

private:
  void add_nodes(const int dimension, const int entity) const
  {
    std::vector<std::size_t> tags(m_points.size());
    std::iota(tags.begin(), tags.end(), std::size_t(1));
    std::vector<double> coordinates;
    for(const std::array<double, 3>& p : m_points)
      coordinates.insert(coordinates.end(), p.begin(), p.end());
    gmsh::model::mesh::addNodes(dimension, entity, tags, coordinates);
  }

  const std::vector<std::array<double, 3> >& m_points;
  const std::map<std::pair<int, int>, std::string>& m_names;
  std::size_t m_number_of_elements = 0, m_number_of_entities = 0;
};

// Takes the further references of cells in several groups, as merge_coinciding_cells() makes them, out of the cell data.
inline std::vector<std::vector<double> > take_further_references(Tetrahedron_soup_3& soup)
{
  std::vector<std::vector<double> > result;
  for(auto it = soup.cell_data.begin(); it != soup.cell_data.end();)
    if(it->name == name_of_reference(result.size() + 2) && it->has_integers && it->number_of_components == 1)
    {
      result.push_back(std::move(it->values));
      it = soup.cell_data.erase(it);
    }
    else
      ++it;
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_WRITER_H
