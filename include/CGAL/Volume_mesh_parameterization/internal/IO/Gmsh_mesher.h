// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_MESHER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_MESHER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Gmsh_reader.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/read_surface.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Loads the solids of a file into the model. Faces without solids, as in files of IGES, are sewn. Solids that touch get common
// faces; a script of Gmsh decides that itself.
inline void load_solids(const std::string& filename)
{
  gmsh::vectorpair solids;
  for(const int makes_solids : { 0, 1 })
  {
    gmsh::clear();
    gmsh::option::setNumber("Geometry.OCCSewFaces", makes_solids);
    gmsh::option::setNumber("Geometry.OCCMakeSolids", makes_solids);
    gmsh::merge(filename);
    gmsh::model::getEntities(solids, 3);
    if(!solids.empty())
      break;
  }
  if(solids.empty())
    throw Input_error("the file contains no solid, and its faces do not enclose one. Close the gaps between faces in a CAD "
                      "program");
  if(solids.size() > 1 && !has_extension(filename, { ".geo" }))
  {
    gmsh::vectorpair parts;
    std::vector<gmsh::vectorpair> parts_of_solids;
    gmsh::model::occ::fragment(solids, {}, parts, parts_of_solids);
    gmsh::model::occ::synchronize();
  }
}

// Returns the curves where a face meets itself, as a cylinder does. They are no edges of the body.
inline std::set<int> seams()
{
  std::set<int> result;
  gmsh::vectorpair faces, curves;
  gmsh::model::getEntities(faces, 2);
  for(const std::pair<int, int>& face : faces)
  {
    std::set<int> before;
    gmsh::model::getBoundary({ face }, curves, false, false);
    for(const auto& [dimension, curve] : curves)
      if(!before.insert(curve).second)
        result.insert(curve);
  }
  return result;
}

// Fills the volumes of the model with tetrahedra. Without a size, that of a script counts, or else a guess: some ten thousand
// tetrahedra fill a box.
inline void generate_tetrahedra(const double cell_size)
{
  std::array<double, 3> low, high;
  gmsh::model::getBoundingBox(-1, -1, low[0], low[1], low[2], high[0], high[1], high[2]);
  const double diagonal = (to_vector(high) - to_vector(low)).norm();
  double size;
  gmsh::option::getNumber("Mesh.MeshSizeMax", size);
  if(size > diagonal)
    size = diagonal / 20;
  gmsh::option::setNumber("Mesh.MeshSizeMax", cell_size > 0 ? cell_size : size);
  gmsh::model::mesh::generate(3);
}

// Fills the solids of a CAD file. Their curves are edges of the soup.
inline Tetrahedron_soup_3 filled_solids(const std::string& filename, const double cell_size)
{
  return with_Gmsh([&]
  {
    load_solids(filename);
    generate_tetrahedra(cell_size);
    return Gmsh_reader(seams()).read();
  }, "; save the solids anew in a CAD program, or try cells of another size");
}

// Throws unless each edge of a surface has two triangles. Those with less than three vertices are removed.
inline void require_closed(Tetrahedron_soup_3& surface)
{
  Triangles& triangles = surface.facets;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), [](const auto& t)
                                 { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }), triangles.end());
  if(triangles.empty())
    throw Input_error("the surface has no triangle");
  for_each_edge(triangles, [&](const auto begin, const auto end)
  {
    const auto point = [&](const std::size_t i)
    { return describe(to_vector(surface.points[triangles[begin->second[i] / 3][begin->second[i] % 3]])); };
    if(end - begin != 2)
      throw Input_error("the surface is not closed, because the edge between the points " + point(0) + " and " + point(1) + " has "
                        + counted(end - begin, "triangle", "triangles") + " instead of 2. Merge points that nearly coincide, or "
                        "close the hole");
  });
  if(!Triangulated_surface(triangles).is_oriented())
    surface.notes.push_back("some triangles of the surface are turned over. Tetrahedra fill what all triangles enclose");
}

// Makes the space that a surface encloses a volume of the model. Each part of the surface is a discrete face; or faces by angles
// are to be meshed anew.
inline void load_enclosed(const Tetrahedron_soup_3& surface, const bool is_meshed_anew)
{
  constexpr double angle = CGAL_PI / 4.5; // 40 degrees, as in an example of Gmsh
  std::vector<std::size_t> tags(surface.points.size());
  std::iota(tags.begin(), tags.end(), std::size_t(1));
  std::vector<double> coordinates;
  for(const std::array<double, 3>& p : surface.points)
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  for(const Triangles& part : components(surface.facets))
  {
    std::vector<std::size_t> nodes;
    for(const auto& triangle : part)
      for(const std::size_t v : triangle)
        nodes.push_back(tags[v]);
    const int face = gmsh::model::addDiscreteEntity(2);
    if(!coordinates.empty())
      gmsh::model::mesh::addNodes(2, face, tags, std::exchange(coordinates, {}));
    gmsh::model::mesh::addElementsByType(face, 2, {}, nodes);
  }
  if(is_meshed_anew)
  {
    gmsh::model::mesh::classifySurfaces(angle, true, true, CGAL_PI);
    gmsh::model::mesh::createGeometry();
  }
  gmsh::vectorpair faces;
  gmsh::model::getEntities(faces, 2);
  std::vector<int> shell;
  for(const auto& [dimension, face] : faces)
    shell.push_back(face);
  gmsh::model::geo::addVolume({ gmsh::model::geo::addSurfaceLoop(shell) });
  gmsh::model::geo::synchronize();
}

// Fills a closed surface with new triangles on it. Where Gmsh finds no parameters for these, triangles of the surface stay. Marks
// that Gmsh returns are left out, as they are not those of the user.
inline Tetrahedron_soup_3 filled_surface(Tetrahedron_soup_3 surface, const double cell_size)
{
  require_closed(surface);
  const auto filled = [&](const bool is_meshed_anew)
  {
    return with_Gmsh([&]
    {
      load_enclosed(surface, is_meshed_anew);
      generate_tetrahedra(cell_size);
      Tetrahedron_soup_3 result = Gmsh_reader().read();
      result.cell_references.assign(result.cells.size(), 0);
      result.facets.clear();
      result.facet_references.clear();
      result.edges.clear();
      result.edge_references.clear();
      result.notes = surface.notes;
      return result;
    }, "; the surface must enclose one body, with or without cavities, and must not touch or cross itself");
  };
  try
  {
    return filled(true);
  }
  catch(const Input_error&)
  {
    surface.notes.push_back("Gmsh makes no new triangles on this surface. The tetrahedra have the triangles of the file");
    return filled(false);
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_MESHER_H
