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
#include <CGAL/Volume_mesh_parameterization/internal/IO/Polygon_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/repair_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Self_intersection_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cctype>

namespace CGAL::Volume_mesh_parameterization::internal {

// How Gmsh is to fill a body. After a failure, another algorithm may succeed, or larger cells.
struct Gmsh_attempt
{
  double cell_size = 0;
  int number = 0; // of attempts before
  bool do_fill_voids = false;

  bool is_second() const { return number == 1; }
};

// Calls `f(entity)` for each entity of a file of STEP with a keyword, without blanks; for none in other files.
template <typename Function>
void for_each_entity_of_STEP(const std::string& filename, const char* const keyword, const Function& f)
{
  if(!has_extension(filename, { ".step", ".stp" }))
    return;
  std::ifstream is(filename);
  for(std::string entity; std::getline(is, entity, ';');)
  {
    const auto is_blank = [](const unsigned char c) { return std::isspace(c) != 0; };
    entity.erase(std::remove_if(entity.begin(), entity.end(), is_blank), entity.end());
    if(entity.find(keyword) != entity.npos)
      f(entity);
  }
}

// Returns the unit of lengths in a file of STEP by its name in Open CASCADE; nothing for millimetres, to which it converts others.
inline std::string unit_of_STEP(const std::string& filename)
{
  std::set<std::string> units;
  for_each_entity_of_STEP(filename, "LENGTH_UNIT", [&](const std::string& entity)
  {
    for(const auto& [text, unit] : { std::pair("CONVERSION_BASED_UNIT('INCH'", "INCH"), { "SI_UNIT(.MILLI.,.METRE.)", "" },
                                     { "SI_UNIT(.CENTI.,.METRE.)", "CM" }, { "SI_UNIT($,.METRE.)", "M" } })
      if(entity.find(text) != entity.npos)
        units.insert(unit);
  });
  if(units.count("INCH") > 0) // which is a multiple of another unit in the file
    return "INCH";
  return units.size() == 1 ? *units.begin() : "";
}

// Returns the shells of a solid of the model, which are its faces that share curves: the outer one is last.
inline std::vector<gmsh::vectorpair> shells_of_solid(const std::pair<int, int>& solid)
{
  gmsh::vectorpair faces, curves;
  gmsh::model::getBoundary({ solid }, faces, false, false);
  std::map<int, std::size_t> face_of_curve;
  Disjoint_sets sets(faces.size());
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    gmsh::model::getBoundary({ faces[f] }, curves, false, false);
    for(const auto& [dimension, curve] : curves)
      sets.unite(f, face_of_curve.emplace(curve, f).first->second);
  }
  std::vector<gmsh::vectorpair> shells;
  std::vector<Box_3> boxes;
  const std::vector<std::size_t> numbers = sets.numbers();
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    shells.resize((std::max)(shells.size(), numbers[f] + 1));
    boxes.resize(shells.size());
    shells[numbers[f]].push_back(faces[f]);
    std::array<double, 3> low, high;
    gmsh::model::getBoundingBox(2, faces[f].second, low[0], low[1], low[2], high[0], high[1], high[2]);
    boxes[numbers[f]].extend(to_vector(low));
    boxes[numbers[f]].extend(to_vector(high));
  }
  const auto is_smaller = [](const Box_3& a, const Box_3& b) { return a.diagonal().norm() < b.diagonal().norm(); };
  std::swap(shells[std::max_element(boxes.begin(), boxes.end(), is_smaller) - boxes.begin()], shells.back());
  return shells;
}

// Replaces each solid of the model that has voids by what its outer shell encloses, and adds the number of voids.
inline void fill_voids(gmsh::vectorpair& solids, std::size_t& number_of_voids)
{
  for(std::pair<int, int>& solid : solids)
  {
    std::vector<gmsh::vectorpair> voids = shells_of_solid(solid);
    std::vector<int> outer;
    for(const auto& [dimension, face] : voids.back())
      outer.push_back(face);
    voids.pop_back();
    if(voids.empty())
      continue;
    std::string name;
    gmsh::model::getEntityName(3, solid.second, name);
    gmsh::model::occ::remove({ solid });
    solid.second = gmsh::model::occ::addVolume({ gmsh::model::occ::addSurfaceLoop(outer) });
    for(const gmsh::vectorpair& faces : voids)
      gmsh::model::occ::remove(faces, true);
    gmsh::model::occ::synchronize();
    gmsh::model::setEntityName(3, solid.second, name);
    number_of_voids += voids.size();
  }
}

// Loads the solids of a file into the model. Faces without solids, as in files of IGES, are sewn. Voids are filled if that is
// wanted. Solids that touch get common faces; a script of Gmsh decides all of that itself. Returns the number of filled voids.
inline std::size_t load_solids(const std::string& filename, const bool do_fill_voids)
{
  gmsh::vectorpair solids;
  for(const int makes_solids : { 0, 1 })
  {
    gmsh::clear();
    gmsh::option::setNumber("Geometry.OCCSewFaces", makes_solids);
    gmsh::option::setNumber("Geometry.OCCMakeSolids", makes_solids);
    gmsh::option::setString("Geometry.OCCTargetUnit", unit_of_STEP(filename));
    gmsh::merge(filename);
    gmsh::model::getEntities(solids, 3);
    if(!solids.empty())
      break;
  }
  if(solids.empty())
    throw Input_error("the file contains no solid, and its faces do not enclose one. Close the gaps between faces in a CAD "
                      "program");
  std::size_t number_of_voids = 0;
  if(has_extension(filename, { ".geo" }))
    return number_of_voids;
  if(do_fill_voids)
    fill_voids(solids, number_of_voids);
  if(solids.size() > 1)
  {
    gmsh::vectorpair parts;
    std::vector<gmsh::vectorpair> parts_of_solids;
    gmsh::model::occ::fragment(solids, {}, parts, parts_of_solids);
    gmsh::model::occ::synchronize();
  }
  return number_of_voids;
}

// Returns a note on voids that have been filled; nothing if there are none.
inline std::string note_of_voids(const std::size_t number)
{ return number == 0 ? "" : counted(number, "void is filled", "voids are filled"); }

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

// Returns a note on names of faces in a file of STEP that Gmsh does not give; nothing if there are none.
inline std::string note_of_names(const std::string& filename, const Tetrahedron_soup_3& soup)
{
  std::set<std::string> names;
  for_each_entity_of_STEP(filename, "ADVANCED_FACE('", [&](const std::string& entity)
  {
    const std::size_t begin = entity.find('\'') + 1;
    names.insert(entity.substr(begin, entity.find('\'', begin) - begin));
  });
  names.erase("");
  names.erase("NONE");
  const bool has_sets = std::any_of(soup.group_names.begin(), soup.group_names.end(),
                                    [](const auto& group) { return group.first.first == 2; });
  return names.empty() || has_sets ? "" : counted(names.size(), "name of faces is", "names of faces are") + " left out, because "
    "Gmsh does not give them. A script of Gmsh names faces by number: the page on this program in the manual has an example";
}

// Returns a note on faces of the model that bound no solid, such as sheets; nothing if there are none.
inline std::string note_of_sheets()
{
  gmsh::vectorpair faces;
  gmsh::model::getEntities(faces, 2);
  const auto number = std::count_if(faces.begin(), faces.end(), [](const auto& face)
  {
    std::vector<int> solids, curves;
    gmsh::model::getAdjacencies(2, face.second, solids, curves);
    return solids.empty();
  });
  return number == 0 ? "" : counted(number, "face bounds no solid and is", "faces bound no solid and are")
    + " left out. If a solid is missing, close the gaps between its faces in a CAD program";
}

// Returns the diameters, smaller than the cells, of faces that go around half of a cylinder or more, or of a sphere. These are
// faces of thin bores, pins and small voids.
inline std::vector<double> diameters_of_thin_faces(const double cell_size)
{
  gmsh::vectorpair faces;
  gmsh::model::getEntities(faces, 2);
  std::vector<double> result;
  for(const auto& [dimension, face] : faces)
  {
    std::string type;
    std::vector<double> begin, end, curvature;
    gmsh::model::getType(dimension, face, type);
    if(type != "Cylinder" && type != "Sphere")
      continue;
    gmsh::model::getParametrizationBounds(dimension, face, begin, end); // the first parameter is the angle
    gmsh::model::getCurvature(dimension, face, { (begin[0] + end[0]) / 2, (begin[1] + end[1]) / 2 }, curvature);
    constexpr double half_turn = 0.99 * CGAL_PI; // up to rounding
    if(end[0] - begin[0] > half_turn && std::abs(curvature[0]) * cell_size > 2)
      result.push_back(2 / std::abs(curvature[0]));
  }
  return result;
}

// Fills the volumes of the model with tetrahedra. Without a size, that of a script counts, or else a guess: some ten thousand
// tetrahedra fill a box. Returns a note, or nothing.
inline std::string generate_tetrahedra(const Gmsh_attempt& attempt)
{
  std::array<double, 3> low, high;
  gmsh::model::getBoundingBox(-1, -1, low[0], low[1], low[2], high[0], high[1], high[2]);
  const double diagonal = (to_vector(high) - to_vector(low)).norm();
  double size, least_size, edges_of_script;
  gmsh::option::getNumber("Mesh.MeshSizeMax", size);
  gmsh::option::getNumber("Mesh.MeshSizeMin", least_size);
  gmsh::option::getNumber("Mesh.MeshSizeFromCurvature", edges_of_script);
  if(size > diagonal)
    size = diagonal / 20;
  if(attempt.cell_size > 0)
    size = attempt.cell_size;
  const bool is_last = attempt.number == 2; // triangles of faces close to each other may cross less where both are large
  if(is_last)
    size *= 2;
  constexpr double MeshAdapt = 1; // Gmsh's manual calls this algorithm for faces the most robust one
  if(attempt.is_second())
    gmsh::option::setNumber("Mesh.Algorithm", MeshAdapt);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  std::string note;
  const std::vector<double> thin = diameters_of_thin_faces(size);
  if(edges_of_script == 0 && !is_last && (!thin.empty() || attempt.is_second()))
  {
    // guesses; four charts of a polycube around a bore need two edges each, and with more, triangles of faces nearby do not cross
    const int number_of_edges = attempt.is_second() ? 24 : 8;
    gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", number_of_edges);
    // elsewhere, as at tiny fillets and where a spline folds, curvature asks for cells without end
    const double thinnest = thin.empty() ? size : *std::min_element(thin.begin(), thin.end());
    gmsh::option::setNumber("Mesh.MeshSizeMin", (std::max)(least_size, CGAL_PI * thinnest / number_of_edges));
    if(!thin.empty())
      note = counted(thin.size(), "cylinder or sphere has", "cylinders and spheres have") + " a smaller diameter than the cells. ";
    note += "Cells are smaller at curved faces, with " + std::to_string(number_of_edges) + " edges around a circle";
  }
  gmsh::model::mesh::generate(3);
  return note;
}

// Fills the solids of a CAD file. Their curves are edges of the soup.
inline Tetrahedron_soup_3 filled_solids(const std::string& filename, const Gmsh_attempt& attempt)
{
  return with_Gmsh([&]
  {
    const std::size_t number_of_voids = load_solids(filename, attempt.do_fill_voids);
    const std::string note_of_circles = generate_tetrahedra(attempt);
    Tetrahedron_soup_3 result = Gmsh_reader(seams()).read();
    for(const std::string& note : { note_of_voids(number_of_voids), note_of_sheets(), note_of_circles,
                                    note_of_names(filename, result) })
      if(!note.empty())
        result.notes.push_back(note);
    return result;
  }, "; save the solids anew in a CAD program, or try cells of another size");
}

// Returns the solid angle of a surface at a point (Van Oosterom and Strackee, The solid angle of a plane triangle, IEEE
// Transactions on Biomedical Engineering, 1983).
inline double solid_angle(const Points& points, const Triangles& triangles, const Vector_3& point)
{
  double result = 0;
  for(const auto& [u, v, w] : triangles)
  {
    const Vector_3 a = to_vector(points[u]) - point, b = to_vector(points[v]) - point, c = to_vector(points[w]) - point;
    const double p = a.norm(), q = b.norm(), r = c.norm();
    result += 2 * std::atan2(a.dot(b.cross(c)), p * q * r + a.dot(b) * r + b.dot(c) * p + c.dot(a) * q);
  }
  return result;
}

// Returns for each part of a closed surface the others that it is inside of.
inline std::vector<std::vector<std::size_t> > parts_around(const Points& points, const std::vector<Triangles>& parts)
{
  std::vector<std::vector<std::size_t> > around(parts.size());
  for(std::size_t i = 0; i < parts.size(); ++i)
    for(std::size_t j = 0; j < parts.size(); ++j)
      if(i != j && std::abs(solid_angle(points, parts[j], to_vector(points[parts[i][0][0]]))) > 2 * CGAL_PI)
        around[i].push_back(j);
  return around;
}

// Returns for each part of a closed surface the part that bounds the same body from outside: itself, or the one around a cavity.
inline std::vector<std::size_t> outer_parts(const Points& points, const std::vector<Triangles>& parts)
{
  const std::vector<std::vector<std::size_t> > around = parts_around(points, parts);
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < parts.size(); ++i)
    result.push_back(around[i].size() % 2 == 0 ? i : *std::max_element(around[i].begin(), around[i].end(),
      [&](const std::size_t j, const std::size_t k) { return around[j].size() < around[k].size(); }));
  return result;
}

// Leaves out the parts of a closed surface that are inside of others, and returns the number of voids among them.
inline std::size_t leave_out_voids(Tetrahedron_soup_3& surface)
{
  const std::vector<Triangles> parts = components(surface.facets);
  const std::vector<std::vector<std::size_t> > around = parts_around(surface.points, parts);
  surface.facets.clear();
  std::size_t number = 0;
  for(std::size_t i = 0; i < parts.size(); ++i)
    if(around[i].empty())
      surface.facets.insert(surface.facets.end(), parts[i].begin(), parts[i].end());
    else
      number += around[i].size() % 2;
  return number;
}

// Returns a surface with new triangles, whose edges have about the same length. Edges along sharp ones stay on these.
inline Tetrahedron_soup_3 remeshed_surface(Tetrahedron_soup_3 surface, double length)
{
  namespace PMP = Polygon_mesh_processing;
  constexpr double angle = 40; // in degrees, as in an example of Gmsh
  constexpr unsigned int number_of_iterations = 3;
  const Polygon_soup soup(surface);
  if(!soup.is_mesh())
    throw Input_error("the surface touches itself");
  Box_3 box;
  for(const std::array<double, 3>& p : surface.points)
    box.extend(to_vector(p));
  const double diagonal = box.diagonal().norm();
  length = length == 0 ? diagonal / 20 : (std::min)(length, diagonal / 10); // as Gmsh's edges of solids
  Repaired_mesh mesh = soup.mesh();
  auto is_sharp = get(dynamic_edge_property_t<bool>(), mesh);
  for(const auto e : edges(mesh))
    put(is_sharp, e, false);
  PMP::detect_sharp_edges(mesh, angle, is_sharp);
  PMP::isotropic_remeshing(faces(mesh), length, mesh, parameters::edge_is_constrained_map(is_sharp)
                                                                  .number_of_iterations(number_of_iterations));
  mesh.collect_garbage();
  Polygon_soup(mesh).assign_to(surface);
  return surface;
}

// Makes each body that a surface encloses a volume of the model, and returns their number. Each part of the surface is a discrete
// face.
inline std::size_t load_enclosed(const Tetrahedron_soup_3& surface)
{
  std::vector<std::size_t> tags(surface.points.size());
  std::iota(tags.begin(), tags.end(), std::size_t(1));
  std::vector<double> coordinates;
  for(const std::array<double, 3>& p : surface.points)
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  const std::vector<Triangles> parts = components(surface.facets);
  const std::vector<std::size_t> outer = outer_parts(surface.points, parts);
  std::map<std::size_t, std::vector<int> > shells;
  for(std::size_t i = 0; i < parts.size(); ++i)
  {
    std::vector<std::size_t> nodes;
    for(const auto& triangle : parts[i])
      for(const std::size_t v : triangle)
        nodes.push_back(tags[v]);
    const int face = gmsh::model::addDiscreteEntity(2);
    if(!coordinates.empty())
      gmsh::model::mesh::addNodes(2, face, tags, std::exchange(coordinates, {}));
    gmsh::model::mesh::addElementsByType(face, 2, {}, nodes);
    shells[outer[i]].push_back(face);
  }
  for(const auto& [body, shell] : shells)
    gmsh::model::geo::addVolume({ gmsh::model::geo::addSurfaceLoop(shell) });
  gmsh::model::geo::synchronize();
  return shells.size();
}

// Throws if a surface crosses itself, and names a place.
inline void require_no_crossing(const Tetrahedron_soup_3& surface)
{
  Matrix3Xd points(3, surface.points.size());
  for(std::size_t v = 0; v < surface.points.size(); ++v)
    points.col(static_cast<int>(v)) = Eigen::Vector3d(to_vector(surface.points[v]));
  std::vector<Self_intersection_3::Facet> facets;
  for(const auto& [u, v, w] : surface.facets)
    facets.push_back({ static_cast<int>(u), static_cast<int>(v), static_cast<int>(w) });
  const auto pairs = Self_intersection_3(points, facets).find(Budget(), 1);
  if(pairs.empty())
    return;
  const auto& [u, v, w] = surface.facets[pairs[0].first];
  const Vector_3 middle = (to_vector(surface.points[u]) + to_vector(surface.points[v]) + to_vector(surface.points[w])) / 3;
  throw Input_error("the surface crosses itself near " + describe(middle)
                    + ". Unite the solids that cross there in a CAD program, or save each of them in a file of its own");
}

// Fills a closed surface with new triangles on it, unless parts of it cross each other. Where Gmsh finds no tetrahedra for these,
// triangles of the surface stay. Marks that Gmsh returns are left out, as they are not those of the user.
inline Tetrahedron_soup_3 filled_surface(Tetrahedron_soup_3 surface, const Gmsh_attempt& attempt)
{
  const auto filled = [&](const bool is_meshed_anew)
  {
    return with_Gmsh([&]
    {
      const std::size_t number_of_bodies
        = load_enclosed(is_meshed_anew ? remeshed_surface(surface, attempt.cell_size) : surface);
      generate_tetrahedra(attempt);
      Tetrahedron_soup_3 result = Gmsh_reader().read();
      result.cell_references.assign(result.cells.size(), 0);
      result.facets.clear();
      result.facet_references.clear();
      result.edges.clear();
      result.edge_references.clear();
      result.notes = surface.notes;
      if(number_of_bodies > 1)
        result.notes.push_back("the surface encloses " + std::to_string(number_of_bodies) + " bodies, which become one mesh. "
                               "Polycubes of bodies stand side by side; all other targets need a file for each body");
      return result;
    }, "; the surface must enclose bodies, with or without cavities, and must not touch itself. Bodies that touch need files of "
       "their own, or their union in a CAD program");
  };
  if(components(surface.facets).size() > 1)
    require_no_crossing(surface);
  if(attempt.do_fill_voids)
    if(const std::string note = note_of_voids(leave_out_voids(surface)); !note.empty())
      surface.notes.push_back(note);
  if(attempt.number == 0)
    try { return filled(true); }
    catch(const Input_error&) {}
  surface.notes.push_back("Gmsh makes no new triangles on this surface. The tetrahedra have the triangles of the file");
  try { return filled(false); }
  catch(const Input_error&)
  {
    require_no_crossing(surface);
    throw;
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_GMSH_MESHER_H
