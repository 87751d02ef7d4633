// The formats of meshes by the names of files, and what reads them.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MESH_FORMAT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MESH_FORMAT_H

#ifdef PARAMETERIZE_MESH_FILE_USES_GMSH
#  include "Gmsh_module.h"
#endif
#ifdef PARAMETERIZE_MESH_FILE_USES_VTK
#  include "VTK_file.h"
#endif

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

// Returns a word as a shell wants it in a command, in quotes if it has other characters than those of plain names.
inline std::string shell_quoted(const std::string& word)
{
  const char* const plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./+:,=@%";
  if(!word.empty() && word.find_first_not_of(plain) == std::string::npos)
    return word;
  return "'" + boost::replace_all_copy(word, "'", "'\\''") + "'";
}

// Returns a number with the singular or the plural of the words behind it.
inline std::string counted(const std::size_t number, const std::string& singular, const std::string& plural)
{ return std::to_string(number) + " " + (number == 1 ? singular : plural); }

// LIBRARY: the library reads it, whatever its name is; SOLIDS: of a CAD program or a script of Gmsh; MESHIO: meshio converts it.
enum class Mesh_format { LIBRARY, GMSH, VTK, SOLIDS, SURFACE, MESHIO, OTHER };

inline std::string extension_of(const std::string& filename) { return std::filesystem::path(filename).extension().string(); }

// The extensions of files of bodies, which Gmsh fills with tetrahedra.
const std::vector<std::string> solid_extensions = { ".step", ".stp", ".iges", ".igs", ".brep", ".geo" };
const std::vector<std::string> surface_extensions = { ".stl", ".off", ".obj", ".ply", ".vtp" };

inline Mesh_format format_of(const std::string& filename)
{
  const std::string extension = extension_of(filename);
  const auto is_in = [](const std::string& extension, const std::vector<std::string>& all)
  { return std::find(all.begin(), all.end(), extension) != all.end(); };
  if(is_in(extension, { ".msh", ".msh2", ".msh4", ".unv", ".bdf" }))
    return Mesh_format::GMSH;
  if(extension == ".vtk")
    return Mesh_format::VTK;
  const std::string in_lower_case = boost::to_lower_copy(extension); // programs for CAD write capitals, too
  if(is_in(in_lower_case, solid_extensions))
    return Mesh_format::SOLIDS;
  if(is_in(in_lower_case, surface_extensions))
    return Mesh_format::SURFACE;
  if(is_in(extension, { ".inp", ".avs", ".cgns", ".e", ".ex2", ".exo", ".f3grid", ".fem", ".h5m", ".mdpa", ".med", ".nas", ".vol",
                        ".post", ".dato", ".su2", ".dat", ".tec", ".ele", ".node", ".ugrid", ".xml", ".xdmf", ".xmf", ".hmf" }))
    return Mesh_format::MESHIO;
  return is_in(extension, { ".mesh", ".meshb", ".vtu" }) ? Mesh_format::LIBRARY : Mesh_format::OTHER;
}

inline bool is_body_name(const std::string& filename)
{ return format_of(filename) == Mesh_format::SOLIDS || format_of(filename) == Mesh_format::SURFACE; }

inline bool is_Nastran_name(const std::string& filename)
{
  const std::string extension = extension_of(filename);
  return extension == ".bdf" || extension == ".nas" || extension == ".fem";
}

// Returns the advice for a file that the library does not read, to be put behind the reason.
inline std::string advice_for(const std::string& filename)
{
  const std::filesystem::path path(filename);
  if(format_of(filename) == Mesh_format::LIBRARY || !std::filesystem::is_regular_file(path))
    return "";
  const std::string file = shell_quoted(filename);
  const auto renamed = [&](const char* extension)
  { return shell_quoted(std::filesystem::path(path).replace_extension(extension).string()); };
  if(format_of(filename) == Mesh_format::SOLIDS)
    return "; this is a body, and this program was built without Gmsh: gmsh -3 " + file + " -o " + renamed(".mesh")
      + " fills it. Solids that touch share no triangles then";
  if(extension_of(filename) == ".obj" || extension_of(filename) == ".stl") // TetGen marks corners of STL that are no points
    return "; this is a surface; a volume mesher fills it: meshio convert " + file + " " + renamed(".mesh")
      + ", and then tetgen -pqg " + renamed(".mesh") + " writes " + renamed(".1.mesh");
  if(extension_of(filename) == ".vtp")
    return "; this is a surface; a volume mesher fills it: save it as an ASCII file " + renamed(".ply")
      + " in ParaView, and then tetgen -pqg " + renamed(".ply") + " writes " + renamed(".1.mesh");
  if(format_of(filename) == Mesh_format::SURFACE)
    return "; this is a surface; a volume mesher fills it: tetgen -pqg " + file + " writes " + renamed(".1.mesh");
  if(format_of(filename) == Mesh_format::GMSH) // meshio 5.0 fails where parts of a mesh are in no group
    return "; other formats can be converted: gmsh " + file + " -save -setnumber Mesh.SaveElementTagType 2 -o "
      + renamed(".mesh");
  if(extension_of(filename) == ".pvtu")
    return "; this file is a list of pieces. Save them in ParaView as one file .vtu, and use --merge-points";
  if(format_of(filename) == Mesh_format::OTHER)
    return "; neither this program (see --help) nor meshio reads files with the extension '" + extension_of(filename) + "'";
  return "; other formats can be converted: meshio convert " + file + " " + renamed(".vtu");
}

// Returns the advice for a source whose boundary is too coarse.
inline std::string advice_to_refine(const std::string& filename)
{
  if(is_body_name(filename))
    return " Smaller cells help: --cells SIZE with half of the size.";
  const bool is_of_Gmsh = format_of(filename) == Mesh_format::GMSH || extension_of(filename) == ".mesh";
  const std::string name = is_of_Gmsh ? filename : "SOURCE.mesh";
  const std::string finer = std::filesystem::path(name).replace_extension(".finer" + extension_of(name)).string();
  return " A finer mesh helps: gmsh " + shell_quoted(name) + " -refine -o "
    + shell_quoted(finer) + " splits each cell into eight. This command can be repeated.";
}

// The formats that are written: MEDIT, VTU and, with Gmsh, its own, of the versions 4.1 and 2.2.
inline double version_of_Gmsh_name(const std::string& name) { return extension_of(name) == ".msh2" ? 2.2 : 4.1; }
inline bool is_Gmsh_name(const std::string& name) { return extension_of(name) == ".msh" || extension_of(name) == ".msh2"; }

#ifdef PARAMETERIZE_MESH_FILE_USES_GMSH
constexpr bool can_write_by_Gmsh = true;
const std::string mesh_extensions = ".mesh, .vtu, .msh or .msh2";
#else
constexpr bool can_write_by_Gmsh = false;
const std::string mesh_extensions = ".mesh or .vtu";
#endif

inline std::string body_extensions()
{ return boost::join(solid_extensions, " ") + " " + boost::join(surface_extensions, " "); }

// Returns lines for --version.
inline std::string formats_of_this_build()
{
#ifdef PARAMETERIZE_MESH_FILE_USES_GMSH
  const std::string read = " .msh .unv .bdf", filled = body_extensions();
#else
  const std::string read, filled = "none, because it was built without Gmsh";
#endif
#ifdef PARAMETERIZE_MESH_FILE_USES_VTK
  const std::string legacy = " .vtk";
#else
  const std::string legacy;
#endif
  return "meshes that it reads: .mesh .meshb .vtu" + read + legacy + "\nbodies that it fills: " + filled
    + "\nmeshes that it writes: " + mesh_extensions + "; hexahedra also .inp\n";
}

inline bool is_mesh_name(const std::string& name)
{
  return extension_of(name) == ".mesh" || extension_of(name) == ".vtu" || (can_write_by_Gmsh && is_Gmsh_name(name));
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MESH_FORMAT_H
