// The command line of parameterize_mesh_file.
#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H

#include <CGAL/version.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

struct Options
{
  std::string source, target, domain, polycube_axes, features, regions, landmarks, others, conditions, inside, initial;
  std::string output, refined_source, report, energy, solver, boundary, refinement;
  std::vector<std::string> hexahedra;
  bool are_staircases = false;
  int number_of_threads = 1, number_of_iterations;
  double energy_tolerance, maximum_angle_distortion, time_limit;
  bool do_improve, do_merge_points, do_separate, are_displacements, do_slide, use_volume_weights;
  bool minimize_maximum_angle_distortion, is_quiet;
};

// The options of a program, and the text around them in its help.
struct Command_line
{
  const char* name;
  boost::program_options::options_description options;
  const char *before, *after;
};

constexpr const char* help_before_options =
R"(Usage: parameterize_mesh_file SOURCE.mesh --to ball|cube|box=X,Y,Z|polycube [options]
       parameterize_mesh_file SOURCE.mesh TARGET [options]
       parameterize_mesh_file SOURCE.mesh --conditions FILE [options]
       parameterize_mesh_file SOURCE.mesh --improve [options]

Maps a tetrahedral mesh onto another domain. The boundary goes to the domain with that name, or where TARGET
tells; the vertices inside are placed such that no cell is inverted or flat, and that the distortion is low. Or it stays, and
SOURCE.mesh may have inverted and flat cells.

  SOURCE.mesh  the mesh: a MEDIT file (*.mesh or *.meshb) or one of VTK (*.vtu); if the program was built with Gmsh, also
               *.msh, *.unv or *.bdf; if it was built with VTK, also *.vtk. Of other formats,
               meshio makes a file *.vtu: meshio convert a.inp a.vtu
  TARGET       either a text with a line 'vertex_index x y z' for each vertex of the boundary, where
               the first vertex has the index 0; or a table *.csv of ParaView; or a copy of SOURCE.mesh with other
               coordinates; or a surface with triangles of its boundary (*.mesh, *.off, *.ply, *.obj, *.stl or *.vtp).
               Vertices inside may be told as well: see --inside
Each file may be a pipe, or - for the standard input or output; then the summary goes to the standard error.
)";

constexpr const char* help_after_options = R"(
Exit status:
  0  success: no inverted cell, and the boundary is met exactly
  1  no inverted cell, but the boundary is missed by the distance that is printed; try --refine
  2  bad input: the message names the file, line or vertex; no output is written
  3  no map without inverted cells was found; no output is written; try --refine
  2 or 3 after the map is written: another file is not, as the message says
Ctrl-C and the time limit end the program in each of its parts. What is valid by then is written: this is 0, 1 or 3.
Ctrl-C once more ends the program at once.

Examples:
  parameterize_mesh_file cube.mesh --to ball -o ball.vtu
  parameterize_mesh_file cube.mesh cube_to_ball.txt --output ball.vtu
      For ParaView: there, the filter Calculator with Coordinate Results and the expression uvw shows
      the image. The cells can be colored by angle_distortion and volume_distortion.
  parameterize_mesh_file cube.mesh cube_to_ball.txt --refine --output ball.mesh --refined-source source.mesh
      A pair of meshes with the same cells, for programs that show or use the map.
)";

namespace options_of_both_programs {

constexpr unsigned width = 100; // columns of the help, a guess

inline boost::program_options::options_description distortion(Options& options)
{
  namespace po = boost::program_options;
  po::options_description result("Distortion", width);
  result.add_options()
    ("energy", po::value(&options.energy)->value_name("NAME")->default_value("stretch"),
     "what is minimized: stretch, for maps to a ball, box or polycube; symmetric_dirichlet, where the boundary moves little, or "
     "cells are to keep their shapes, as in boundary layers; mips, for angles only, and the default of --improve; arap, "
     "dirichlet, lscm or lpm")
    ("volume-weights", po::bool_switch(&options.use_volume_weights), "count cells by their volume, not all alike")
    ("energy-tolerance", po::value(&options.energy_tolerance)->value_name("PART")->default_value(1e-3, "0.001"),
     "end where five Newton steps lower the energy by less than this part of it; 0: at a minimum");
  return result;
}

inline void add_limits(boost::program_options::options_description& computation, Options& options)
{
  namespace po = boost::program_options;
  computation.add_options()
    ("max-iterations", po::value(&options.number_of_iterations)->value_name("N")->default_value(1000),
     "largest number of Newton steps of each stage")
    ("time-limit", po::value(&options.time_limit)->value_name("SECONDS")
       ->default_value(std::numeric_limits<double>::infinity(), "none"),
     "when the program ends, counted from its start; what is valid by then is written")
    ("quiet", po::bool_switch(&options.is_quiet), "print errors only")
    ("version", "print the version")
    ("help", "print this text");
}

} // namespace options_of_both_programs

// Refers to the members of `options`, which receive the values.
inline Command_line command_line(Options& options)
{
  namespace po = boost::program_options;
  const unsigned width = options_of_both_programs::width;

  po::options_description files("Files", width);
  files.add_options()
    ("output,o", po::value(&options.output)->value_name("FILE"),
     "the map; *.mesh: the mesh with the new coordinates, with Gmsh also *.msh, or *.msh2 for its version 2.2; *.vtu: the source "
     "with the map and its distortion as data. Groups and data of the source are in what can hold them")
    ("refined-source", po::value(&options.refined_source)->value_name("FILE"),
     "the source (*.mesh, *.msh) with the vertices that --refine has added; it has the cells of the output")
    ("hexahedra", po::value(&options.hexahedra)->multitoken()->value_name("SPACING FILE"),
     "if the target is a box or a polycube: hexahedra of that size in it, pulled back to the source (*.mesh, *.vtu, *.msh or "
     "*.inp)")
    ("staircases", po::bool_switch(&options.are_staircases), "let hexahedra not follow the interfaces between subdomains")
    ("report", po::value(&options.report)->value_name("FILE"), "a JSON file with counts, times and distortions");

  po::options_description source("Source", width);
  source.add_options()
    ("merge-points", po::bool_switch(&options.do_merge_points), "join cells where several points have one place")
    ("features", po::value(&options.features)->value_name("FILE"),
     "the sharp edges of the source: lines with two vertices, counted from 0, in place of the edges that SOURCE.mesh marks. "
     "If none are marked, edges with more than 60 degrees between the normals are sharp")
    ("regions", po::value(&options.regions)->value_name("NAME"),
     "cell data that are the subdomains, in place of those with a known name, such as material or RegionId")
    ("separate", po::bool_switch(&options.do_separate),
     "where the body touches itself at a vertex or an edge, give each of its parts there vertices of its own");

  po::options_description boundary("Boundary", width);
  boundary.add_options()
    ("to", po::value(&options.domain)->value_name("DOMAIN"),
     "in place of TARGET: ball, the unit ball; cube, the unit cube; box=X,Y,Z, a box with sides of these lengths; "
     "polycube, one that is close to the source; most meshes need --refine for that, which also splits edges of the boundary of a "
     "body with handles where the polycube needs that")
    ("polycube-axes", po::value(&options.polycube_axes)->value_name("WHICH")->default_value("found"),
     "found: the source is turned such that its faces are nearly normal to the axes of the polycube; given: it stays as it is")
    ("improve", po::bool_switch(&options.do_improve),
     "in place of TARGET: vertices of the boundary stay, and those between cells of different references and of triangles inside; "
     "the others move such that no cell is inverted or flat, each as regular as it can be. With --refine, cells are also split "
     "whose vertices all stay")
    ("landmarks", po::value(&options.landmarks)->value_name("FILE"),
     "lines as of TARGET for some vertices, where --to is to bring them: a ball is turned such that they are close, a box has "
     "eight of them as corners, each in the octant of its line")
    ("displacements", po::bool_switch(&options.are_displacements), "TARGET tells by what vertices move, and not where they go")
    ("others", po::value(&options.others)->value_name("WAY")->default_value("missing"),
     "what vertices of the boundary without a target do: missing: there is no map; stay: they stay where they are; slide: they "
     "move in the planes and along the straight edges of the boundary, and those with a target do not; free: they go where the "
     "energy is lowest")
    ("conditions", po::value(&options.conditions)->value_name("FILE"),
     "lines for vertices that are free in part, others are free: the reference or the name of triangles, or 'vertex' and an "
     "index; and fixed, free, plane with a normal, or a coordinate such as z=1. What stays, or the point of a plane, is the "
     "target of a vertex if there is one, and its place in SOURCE.mesh otherwise")
    ("inside", po::value(&options.inside)->value_name("WAY")->default_value("auto"),
     "what vertices inside with a target do: met: they meet it; free: they do not; auto: they meet it if others have none, and "
     "where all have one, as in a copy of SOURCE.mesh, those between cells of different references do, if one of them has moved")
    ("initial", po::value(&options.initial)->value_name("FILE"),
     "a map nearby to start from, a file as TARGET: what --output has written for other targets")
    ("boundary", po::value(&options.boundary)->value_name("NAME")->default_value("auto"),
     "fixed: the targets are met or there is no map; soft: the boundary is pulled to its targets and may miss them; "
     "auto: fixed, and soft if that finds no map")
    ("refine", po::value(&options.refinement)->value_name("WHERE")->default_value("none"),
     "--refine=needed: add vertices where the targets cannot be met otherwise; --refine=helpful: also where edges inside between "
     "vertices of the boundary make the map slow or distorted; --refine, or --refine=boundary: also on edges of the boundary "
     "where a polycube needs that; --refine=all: first in all edges inside between vertices of the boundary")
    ("slide", po::bool_switch(&options.do_slide),
     "let vertices move in the planes and along the straight edges of the target, for a lower distortion");

  po::options_description distortion = options_of_both_programs::distortion(options);
  distortion.add_options()
    ("max-angle-distortion", po::value(&options.maximum_angle_distortion)->value_name("K")
       ->default_value(std::numeric_limits<double>::infinity(), "none"),
     "bring the distortion of angles of every cell below K, if that is possible; without distortion, it is 2")
    ("minimize-max-angle-distortion", po::bool_switch(&options.minimize_maximum_angle_distortion),
     "make the largest distortion of angles as small as possible, which takes longer");

  po::options_description computation("Computation", width);
  computation.add_options()
    ("solver", po::value(&options.solver)->value_name("NAME")->default_value("cg"),
     "cg: conjugate gradients; cholmod: a direct solver, if the program was built with CHOLMOD")
    ("threads", po::value(&options.number_of_threads)->value_name("N")->default_value(1),
     "number of threads, at most that of processors; they do not change the result");
  options_of_both_programs::add_limits(computation, options);

  po::options_description all(width);
  all.add(files).add(source).add(boundary).add(distortion).add(computation);
  return { "parameterize_mesh_file", all, help_before_options, help_after_options };
}

// No more than there are processors, where their number is known: more cost memory and time, and gain nothing.
inline std::size_t number_of_threads(const Options& options)
{
  const std::size_t number = static_cast<std::size_t>(options.number_of_threads);
  const std::size_t number_of_processors = std::thread::hardware_concurrency();
  return number_of_processors == 0 ? number : (std::min)(number, number_of_processors);
}

// False if only help or the version was asked for.
inline bool parse(int argc, char* argv[], const Command_line& line, Options& options)
{
  namespace po = boost::program_options;
  po::options_description all;
  all.add(line.options).add_options()
    ("source", po::value(&options.source))
    ("target", po::value(&options.target));
  po::positional_options_description positional;
  positional.add("source", 1).add("target", 1);

  // alone, an option with a value would take the argument behind it
  std::vector<std::string> arguments(argv + 1, argv + argc);
  std::replace(arguments.begin(), arguments.end(), std::string("--refine"), std::string("--refine=boundary"));
  po::variables_map given;
  po::store(po::command_line_parser(arguments).options(all).positional(positional).run(), given);
  po::notify(given);
  if(given.count("help") != 0)
  {
    std::cout << line.before << line.options << line.after;
    return false;
  }
  if(given.count("version") != 0)
  {
    std::cout << line.name << " " << VOLUME_MESH_PARAMETERIZATION_VERSION << " (CGAL " << CGAL_VERSION_STR
              << ")\n";
    return false;
  }
  for(std::string* name : { &options.source, &options.target, &options.features, &options.landmarks, &options.conditions,
                            &options.initial })
    if(*name == "-")
      *name = "/dev/stdin";
  if(!options.hexahedra.empty() && options.hexahedra.back() == "-")
    options.hexahedra.back() = "/dev/stdout";
  for(std::string* name : { &options.output, &options.refined_source, &options.report })
    if(*name == "-")
      *name = "/dev/stdout";
  const int number_of_ways = !options.target.empty() + !options.domain.empty() + options.do_improve;
  if(options.source.empty() || number_of_ways > 1 || (number_of_ways == 0 && options.conditions.empty()))
    throw std::runtime_error("SOURCE.mesh is needed, and one of TARGET, --to DOMAIN, --improve and --conditions FILE; --help "
                             "tells more");
  if(!options.domain.empty() && given["refine"].defaulted())
    options.refinement = "boundary"; // as the library refines for a boundary parameterizer
  if(!options.conditions.empty() && given["others"].defaulted())
    options.others = "free";
  if(options.others == "free" && given["energy"].defaulted())
    options.energy = "symmetric_dirichlet"; // which has a minimum
  if(options.do_improve && given["energy"].defaulted())
    options.energy = "mips"; // which does not compare sizes, so small cells stay small
  return true;
}

#endif // COMMAND_LINE_H
