// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_IO_WRITE_HEXAHEDRON_SOUP_H
#define CGAL_POLYCUBE_MESHING_3_IO_WRITE_HEXAHEDRON_SOUP_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedron_soup_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/check_hexahedra.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/VTU_writer.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace CGAL::Polycube_meshing_3 {
namespace internal {

// Returns a number with as many digits as its field has room for: all 17 of most numbers.
inline std::string INP_number(const double number)
{
  constexpr std::ptrdiff_t room = 20; // characters of a number that Abaqus and CalculiX read
  char digits[32];
  std::to_chars_result end = std::to_chars(digits, digits + sizeof(digits), number);
  for(int precision = 17; end.ptr - digits > room; --precision)
    end = std::to_chars(digits, digits + sizeof(digits), number, std::chars_format::general, precision);
  return std::string(digits, end.ptr);
}

inline std::string in_capitals(std::string name)
{
  for(char& c : name)
    c = 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return name;
}

// Returns a name with letters, digits and underscores only, of which the first is a letter, as Abaqus and CalculiX take it.
inline std::string INP_name(const std::string& name)
{
  const auto is_in = [](const char c, const char first, const char last) { return first <= c && c <= last; };
  std::string result;
  for(const char c : name)
    if(is_in(c, 'a', 'z') || is_in(c, 'A', 'Z') || is_in(c, '0', '9'))
      result += c;
    else if((static_cast<unsigned char>(c) & 0xC0) != 0x80) // one underscore for each character of UTF-8
      result += '_';
  if(result.empty() || result[0] == '_' || is_in(result[0], '0', '9'))
    result = "GROUP_" + result;
  return result.substr(0, 80); // as many as both programs allow
}

// Writes a keyword and the numbers, from 1, of nodes or elements with these indices, at most 16 in a line, as both programs take.
template <typename Indices>
void write_INP_set(Text_writer& writer, const std::string& keyword, const Indices& indices)
{
  writer << keyword << "\n";
  std::size_t number_in_line = 0;
  for(const std::size_t i : indices)
  {
    writer << (number_in_line == 0 ? "" : number_in_line % 16 == 0 ? ",\n" : ", ") << i + 1;
    ++number_in_line;
  }
  writer << "\n";
}

// Writes the nodes of quadrangles, for supports, and the faces of elements, for pressures.
inline void write_INP_surface(Text_writer& writer, const Hexahedron_soup_3& mesh, const std::string& name,
                              const std::vector<Quadrangle_of_hexahedron>& quadrangles)
{
  std::set<std::size_t> vertices;
  for(const Quadrangle_of_hexahedron& q : quadrangles)
    for(const std::size_t v : vertices_of(mesh, q))
      vertices.insert(v);
  write_INP_set(writer, "*NSET, NSET=" + name, vertices);
  writer << "*SURFACE, TYPE=ELEMENT, NAME=" << name << "\n";
  for(const Quadrangle_of_hexahedron& q : quadrangles) // the faces of an element are numbered as its quadrangles here
    writer << q.cell + 1 << ", S" << q.side + 1 << "\n";
}

// Returns the cells of each subdomain, by the name of the set.
inline std::map<std::string, std::vector<std::size_t> > INP_subdomains(const Hexahedron_soup_3& mesh)
{
  std::map<std::string, std::vector<std::size_t> > result;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    result["SUBDOMAIN_" + std::to_string(mesh.cell_references[c])].push_back(c);
  return result;
}

// Returns, by name, the quadrangles of faces of the polycube, of patches, and of both sides of interfaces.
inline std::map<std::string, std::vector<Quadrangle_of_hexahedron> > INP_surfaces(const Hexahedron_soup_3& mesh)
{
  std::map<std::string, std::vector<Quadrangle_of_hexahedron> > result;
  const auto add = [&](const std::string& name, const int number, const Quadrangle_of_hexahedron& q)
  { result[name + std::to_string(number)].push_back(q); };
  for(std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    const Quadrangle_of_hexahedron q = { mesh.facet_cells[f], side_of_facet(mesh, f) };
    add("FACE_", mesh.polycube_faces[f], q);
    if(mesh.facet_references[f] != 0)
      add("SURFACE_", mesh.facet_references[f], q);
  }
  for(std::size_t i = 0; i < mesh.interface_facets.size(); ++i)
    for(const std::size_t k : { 0, 1 })
    {
      const std::size_t c = mesh.interface_cells[i][k];
      const Quadrangle_of_hexahedron q = { c, side_of_quadrangle(mesh, c, mesh.interface_facets[i]) };
      const std::array<int, 2> subdomains = subdomains_at_interface(mesh, i);
      add("INTERFACE_" + std::to_string(subdomains[k]) + "_", subdomains[1 - k], q);
      if(k == 0 && mesh.interface_references[i] != 0)
        add("SURFACE_", mesh.interface_references[i], q);
    }
  return result;
}

// Returns, by name, the vertices on each curve whose reference is not 0. A vertex comes once for each of its edges there.
inline std::map<std::string, std::vector<std::size_t> > INP_curves(const Hexahedron_soup_3& mesh)
{
  std::map<std::string, std::vector<std::size_t> > result;
  for(std::size_t e = 0; e < mesh.edges.size(); ++e)
    for(const std::size_t v : mesh.edges[e])
      if(mesh.edge_references[e] != 0)
        result["CURVE_" + std::to_string(mesh.edge_references[e])].push_back(v);
  return result;
}

// Adds, for each name, the union of the sets of all groups of the dimension that have this name. The names of groups are by
// dimension and reference. The set of a group is named by the prefix and the reference. Removes sets that have the name of a group
// but for capitals, because both programs ignore capitals.
template <typename Item>
void add_groups(const std::map<std::pair<int, int>, std::string>& names, const int dimension, const std::string& prefix,
                std::map<std::string, std::vector<Item> >& sets)
{
  std::map<std::string, std::vector<Item> > groups;
  for(const auto& [group, name] : names)
    if(const auto set = sets.find(prefix + std::to_string(group.second)); group.first == dimension && set != sets.end())
      groups[name].insert(groups[name].end(), set->second.begin(), set->second.end());
  for(const auto& [group, name] : names)
    if(group.first == dimension)
      sets.erase(in_capitals(name));
  sets.merge(groups);
}

} // namespace internal

namespace IO {

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra and the quadrangles of their boundary in the ASCII \ref IOStreamMedit "MEDIT (.mesh) file format". The
/// references of hexahedra are their subdomains, those of quadrangles the ones of the body if there are any, else their faces.
/// Quadrangles of interfaces follow, with their references; those without one have a number for each pair of subdomains, in
/// ascending order, that follow all others. Edges along curves have the references of these, and vertices at corners are corners.
///
/// \param os the stream
/// \param mesh the hexahedra
///
/// \return whether the stream has taken everything
///
/// \exception Input_error names the arrays that do not fit together.
inline bool write_MEDIT(std::ostream& os, const Hexahedron_soup_3& mesh)
{
  internal::check_hexahedra(mesh);
  internal::Text_writer writer(os);
  internal::write_MEDIT_points(writer, mesh.points);
  internal::write_MEDIT_cells(writer, "Hexahedra", mesh.cells, mesh.cell_references);
  std::vector<std::array<std::size_t, 4> > quadrangles = mesh.facets;
  std::vector<int> references = mesh.facet_references;
  if(std::count(references.begin(), references.end(), 0) == std::ptrdiff_t(references.size()))
    references.assign(mesh.polycube_faces.begin(), mesh.polycube_faces.end());
  const std::vector<int> at_interfaces = internal::references_at_interfaces(mesh, references);
  quadrangles.insert(quadrangles.end(), mesh.interface_facets.begin(), mesh.interface_facets.end());
  references.insert(references.end(), at_interfaces.begin(), at_interfaces.end());
  internal::write_MEDIT_cells(writer, "Quadrilaterals", quadrangles, references);
  if(!mesh.edges.empty())
    internal::write_MEDIT_cells(writer, "Edges", mesh.edges, mesh.edge_references);
  if(!mesh.corners.empty())
    internal::write_MEDIT_corners(writer, mesh.corners);
  writer << "End\n";
  return writer.finish();
}

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra, and the quadrangles of their boundary and of interfaces, as a VTK XML file (`.vtu`). The points have the
/// vectors `uvw`, their images. The cells have the values `scaled_jacobian` (as in `Hexahedral_mesh_result`), `block`,
/// `grid_index` (the indices (i, j, k) in the block) and `subdomain`. A quadrangle has the values of its hexahedron, which on an
/// interface is the one in the subdomain with the smaller number. The values `face` and `surface` are the face of the polycube and
/// the reference of a quadrangle, and 0 for hexahedra. If there are interfaces, `interface` has the two subdomains of a quadrangle
/// there, and 0 and 0 for all other cells. Names of groups are arrays of the section `FieldData`, for `subdomain` and `surface`.
///
/// \param os the stream, opened in binary mode if it is a file
/// \param mesh the hexahedra
/// \param names the names of groups, as `Tetrahedron_soup_3::group_names` has them
///
/// \return whether the stream has taken everything
///
/// \exception Input_error names the arrays that do not fit together.
inline bool write_VTU(std::ostream& os, const Hexahedron_soup_3& mesh,
                      const std::map<std::pair<int, int>, std::string>& names = {})
{
  internal::check_hexahedra(mesh);
  const std::size_t number_of_hexahedra = mesh.cells.size(), end_of_boundary = number_of_hexahedra + mesh.facets.size();
  const std::size_t number_of_cells = end_of_boundary + mesh.interface_facets.size();
  const std::vector<double> quality = internal::scaled_jacobians(mesh);
  const auto hexahedron = [&](const std::size_t i)
  {
    return i < number_of_hexahedra ? i : i < end_of_boundary ? mesh.facet_cells[i - number_of_hexahedra]
                                                             : mesh.interface_cells[i - end_of_boundary][0];
  };
  const auto reference = [&](const std::size_t i)
  {
    return i < number_of_hexahedra ? 0 : i < end_of_boundary ? mesh.facet_references[i - number_of_hexahedra]
                                                             : mesh.interface_references[i - end_of_boundary];
  };

  internal::VTU_writer writer(mesh.points, internal::VTU_cells<8>{ mesh.cells, 12 }, internal::VTU_cells<4>{ mesh.facets, 9 },
                              internal::VTU_cells<4>{ mesh.interface_facets, 9 }); // numbers of VTK: hexahedra, quadrangles
  writer.add_names(names);
  writer.begin("PointData");
  writer.add_points("uvw", mesh.images);
  writer.end("PointData");
  writer.begin("CellData");
  writer.add<double>("scaled_jacobian", number_of_cells, [&](std::size_t i) { return quality[hexahedron(i)]; });
  writer.add<std::int32_t>("block", number_of_cells, [&](std::size_t i) { return mesh.cell_blocks[hexahedron(i)]; });
  writer.add<std::int32_t>("grid_index", 3 * number_of_cells,
                           [&](std::size_t i) { return mesh.cell_indices[hexahedron(i / 3)][i % 3]; }, 3);
  writer.add<std::int32_t>("subdomain", number_of_cells, [&](std::size_t i) { return mesh.cell_references[hexahedron(i)]; });
  writer.add<std::int32_t>("face", number_of_cells, [&](std::size_t i)
  { return i < number_of_hexahedra || i >= end_of_boundary ? 0 : mesh.polycube_faces[i - number_of_hexahedra]; });
  writer.add<std::int32_t>("surface", number_of_cells, reference);
  if(number_of_cells > end_of_boundary)
    writer.add<std::int32_t>("interface", 2 * number_of_cells, [&](std::size_t i)
    { return i / 2 < end_of_boundary ? 0 : internal::subdomains_at_interface(mesh, i / 2 - end_of_boundary)[i % 2]; }, 2);
  writer.end("CellData");
  writer.write(os);
  return os.good();
}

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra to a file, as to a stream. The file is replaced, but not if an exception is thrown.
///
/// \param filename the name of the file
/// \param mesh the hexahedra
///
/// \return whether the file is complete
inline bool write_MEDIT(const std::string& filename, const Hexahedron_soup_3& mesh)
{ return internal::write_file(filename, [&](std::ostream& os) { IO::write_MEDIT(os, mesh); }); }

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra to a file, as to a stream. The file is replaced, but not if an exception is thrown.
///
/// \param filename the name of the file
/// \param mesh the hexahedra
/// \param names the names of groups
///
/// \return whether the file is complete
inline bool write_VTU(const std::string& filename, const Hexahedron_soup_3& mesh,
                      const std::map<std::pair<int, int>, std::string>& names = {})
{ return internal::write_file(filename, [&](std::ostream& os) { IO::write_VTU(os, mesh, names); }); }

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// returns the names that `write_INP()` gives to groups. Abaqus and CalculiX take up to 80 letters, digits and underscores. The
/// first is a letter, and capitals do not matter. A name that is possible stays. In others, other characters become `_`, and a
/// number follows if another set of elements or nodes has the result. Surfaces have sets of nodes, as curves have: of both, a
/// surface keeps a name. Groups of one dimension with equal names stay together.
///
/// \param group_names the names of groups, by their dimension and reference, as in `Tetrahedron_soup_3`
inline std::map<std::pair<int, int>, std::string> names_in_INP(const std::map<std::pair<int, int>, std::string>& group_names)
{
  std::map<std::pair<int, std::string>, std::string> new_names; // by dimension and name
  std::set<std::string> of_elements = { "NALL", "EALL" }, of_nodes = { "NALL", "EALL", "CORNERS" };
  const auto take = [&](const int dimension, const std::string& name, const std::string& new_name)
  {
    if((dimension == 3 ? of_elements : of_nodes).insert(internal::in_capitals(new_name)).second)
      new_names[{ dimension, name }] = new_name;
  };
  for(const int dimension : { 3, 2, 1 })
    for(const auto& [group, name] : group_names)
      if(group.first == dimension && internal::INP_name(name) == name && new_names.count({ dimension, name }) == 0)
        take(dimension, name, name);
  for(const auto& [group, name] : group_names)
    for(int i = 1; new_names.count({ group.first, name }) == 0; ++i)
      take(group.first, name, i == 1 ? internal::INP_name(name)
                                     : internal::INP_name(name).substr(0, 70) + "_" + std::to_string(i));
  std::map<std::pair<int, int>, std::string> result;
  for(const auto& [group, name] : group_names)
    result[group] = new_names.at({ group.first, name });
  return result;
}

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra as the mesh of an input file for Abaqus and CalculiX (`.inp`). Nodes and elements are numbered from 1. The
/// element sets are `EALL` and `SUBDOMAIN_0`, `SUBDOMAIN_1`, ... Each reference of quadrangles but 0 has a set of its nodes,
/// `SURFACE_1`, ..., for supports. A surface of the same name, of faces of elements, is for pressures. The faces of the polycube
/// likewise have `FACE_1`, `FACE_2`, ... An interface of two subdomains, such as 1 and 2, has two surfaces. `INTERFACE_1_2`
/// consists of faces of elements in subdomain 1, and `INTERFACE_2_1` of the same faces of elements in subdomain 2. The curves that
/// are kept have the node sets `CURVE_1`, `CURVE_2`, ..., by the references of edges but 0, and `CORNERS` has all corners that are
/// kept. The node set `NALL` has all nodes. A model includes it by `*INCLUDE, INPUT=...`. If the group of a subdomain or of a
/// reference of quadrangles or edges has a name, there is also a set of the name that `names_in_INP()` returns. It stands in the
/// place of one of these sets of the same name.
///
/// These programs read at most 20 characters of a number. Coordinates have up to 17 digits, which restore them. If a number has
/// no room for 17 digits, as with a negative exponent, it has at least 13.
///
/// \param os the stream
/// \param mesh the hexahedra
/// \param element_type the type of the elements: `C3D8`, of full integration; `C3D8I`, with incompatible modes, for bending;
///        or `C3D8R`, of reduced integration
/// \param group_names the names of groups, by their dimension (3 for cells) and reference, as in `Tetrahedron_soup_3`
///
/// \return whether the stream has taken everything
///
/// \pre The type is one of these; otherwise `CGAL::Precondition_exception` is thrown, in every build.
///
/// \exception Input_error names the arrays that do not fit together.
inline bool write_INP(std::ostream& os, const Hexahedron_soup_3& mesh, const std::string& element_type = "C3D8",
                      const std::map<std::pair<int, int>, std::string>& group_names = {})
{
  internal::require(element_type == "C3D8" || element_type == "C3D8I" || element_type == "C3D8R",
                    "element_type must be C3D8, C3D8I or C3D8R.");
  internal::check_hexahedra(mesh);
  internal::Text_writer writer(os);
  writer << "*NODE, NSET=NALL\n";
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    writer << v + 1;
    for(const double x : mesh.points[v])
      writer << ", " << internal::INP_number(x);
    writer << "\n";
  }
  writer << "*ELEMENT, TYPE=" << element_type << ", ELSET=EALL\n";
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    writer << c + 1;
    for(const std::size_t v : mesh.cells[c])
      writer << ", " << v + 1;
    writer << "\n";
  }
  const std::map<std::pair<int, int>, std::string> names = names_in_INP(group_names);
  auto subdomains = internal::INP_subdomains(mesh);
  internal::add_groups(names, 3, "SUBDOMAIN_", subdomains);
  for(const auto& [name, cells] : subdomains)
    internal::write_INP_set(writer, "*ELSET, ELSET=" + name, cells);
  auto surfaces = internal::INP_surfaces(mesh);
  internal::add_groups(names, 2, "SURFACE_", surfaces);
  for(const auto& [name, quadrangles] : surfaces)
    internal::write_INP_surface(writer, mesh, name, quadrangles);
  auto curves = internal::INP_curves(mesh);
  internal::add_groups(names, 1, "CURVE_", curves);
  for(const auto& [name, vertices] : curves)
    internal::write_INP_set(writer, "*NSET, NSET=" + name, std::set<std::size_t>(vertices.begin(), vertices.end()));
  if(!mesh.corners.empty())
    internal::write_INP_set(writer, "*NSET, NSET=CORNERS", mesh.corners);
  return writer.finish();
}

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra to a file, as to a stream. The file is replaced, but not if an exception is thrown.
///
/// \param filename the name of the file
/// \param mesh the hexahedra
/// \param element_type the type of the elements
/// \param group_names the names of groups
///
/// \return whether the file is complete
inline bool write_INP(const std::string& filename, const Hexahedron_soup_3& mesh, const std::string& element_type = "C3D8",
                      const std::map<std::pair<int, int>, std::string>& group_names = {})
{ return internal::write_file(filename, [&](std::ostream& os) { IO::write_INP(os, mesh, element_type, group_names); }); }

} // namespace IO
} // namespace CGAL::Polycube_meshing_3

#endif // CGAL_POLYCUBE_MESHING_3_IO_WRITE_HEXAHEDRON_SOUP_H
