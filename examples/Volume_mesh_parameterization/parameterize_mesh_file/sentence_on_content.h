// Sentences on files of other programs, which the content reveals, whatever the names are.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_SENTENCE_ON_CONTENT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_SENTENCE_ON_CONTENT_H

#include "Mesh_format.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <utility>
#include <vector>

// Returns the command that converts a file, to a file `.vtu`.
inline std::string conversion(const std::string& filename, const std::string& options)
{
  return "it can be converted: meshio convert " + options + " " + shell_quoted(filename) + " "
    + shell_quoted(std::filesystem::path(filename).replace_extension(".vtu").string());
}

// meshio reads the blocks, but does not write their numbers.
inline std::string conversion_of_blocks(const std::string& filename)
{
  const std::string vtu = std::filesystem::path(filename).replace_extension(".vtu").string();
  return "it can be converted: python3 -c " + shell_quoted(
    "import meshio, numpy, sys; m = meshio.read(sys.argv[1], \"exodus\"); m.cell_data[\"block_id\"] = "
    "[numpy.full(len(c.data), i + 1) for i, c in enumerate(m.cells)]; m.write(sys.argv[2])")
    + " " + shell_quoted(filename) + " " + shell_quoted(vtu);
}

// meshio reads no cells of second order of TetGen, which writes the mesh with the next number.
inline std::string conversion_by_TetGen(const std::string& filename)
{
  const std::string name = std::filesystem::path(filename).replace_extension("").string(), number = extension_of(name);
  const bool is_numbered = std::regex_match(number, std::regex(R"(\.[0-9]{1,6})"));
  return "it can be converted: tetgen -rg " + shell_quoted(name) + " writes "
    + shell_quoted(std::filesystem::path(name + (is_numbered ? "" : ".0"))
                     .replace_extension(std::to_string(is_numbered ? std::stoi(number.substr(1)) + 1 : 1) + ".mesh").string());
}

// Returns a sentence on a file that is none of this program by its content, with what helps; nothing for all others.
inline std::string sentence_on_content(const std::string& filename)
{
  namespace fs = std::filesystem;
  if(fs::exists(fs::path(filename) / "faces") && fs::exists(fs::path(filename) / "owner"))
    return "this is a mesh of OpenFOAM. Neither this program nor meshio reads it; save it in a format that --help lists";
  if(!fs::is_regular_file(filename))
    return "";
  const auto beginning = [](const std::string& name)
  {
    std::string result(4096, '\0');
    std::ifstream is(name, std::ios::binary);
    is.read(result.data(), static_cast<std::streamsize>(result.size()));
    result.resize(static_cast<std::size_t>(is.gcount()));
    return result;
  };
  const std::string begin = beginning(filename), extension = extension_of(filename);
  const auto begins_with = [](const std::string& text, const char* const pattern)
  { return std::regex_search(text, std::regex(pattern, std::regex::icase), std::regex_constants::match_continuous); };

  for(const auto& [pattern, program] : { std::make_pair(R"(\s*(\$[^\n]*\n\s*)*\*KEYWORD)", "LS-DYNA"),
                                         { R"([^]*<febio_spec)", "FEBio" }, { R"(/PREP7|/COM|[^]*\nNBLOCK)", "Ansys" },
                                         { R"([^]*FoamFile)", "OpenFOAM" } })
    if(begins_with(begin, pattern))
      return "this is a file of " + std::string(program) + ". Neither this program nor meshio reads it; save the mesh in a format "
             "that --help lists";
  if(begins_with(begin, R"(\([0-9]+ )"))
    return "this is a mesh of Fluent. ParaView reads it under the name "
      + shell_quoted(fs::path(filename).replace_extension(".cas").string())
      + ". Apply the filter Merge Blocks, which loses the zones, and save the result as a file .vtu";
  if(extension != ".inp" && begins_with(begin, R"(\s*(\*\*[^\n]*\n\s*)*\*(HEADING|NODE|PART|ELEMENT))"))
    return "this is a file of Abaqus; " + conversion(filename, "--input-format abaqus");
  if(begins_with(begin, R"((#[^\n]*\n)*\s*([0-9]+[ \t]+){4}[0-9]+\s*\n)"))
    return "this is a file of AVS; " + conversion(filename, "--input-format avsucd");
  if((extension == ".e" || extension == ".exo" || extension == ".ex2") && begins_with(begin, "CDF|.HDF"))
    return "this is a file of Exodus; " + conversion_of_blocks(filename);
  if((extension == ".ele" || extension == ".node")
     && begins_with(beginning(fs::path(filename).replace_extension(".ele").string()), R"((#[^\n]*\n)*\s*[0-9]+\s+10\s)"))
    return "this is a mesh of TetGen of second order; " + conversion_by_TetGen(filename);
  return "";
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_SENTENCE_ON_CONTENT_H
