// The command line of parameterize_mesh_file.
#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H

#include "Mesh_format.h"

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
  std::string reference_scale; // a number or found; empty by default
  std::string tetrahedra, output, refined_source, report, energy, solver, boundary, refinement;
  std::vector<std::string> hexahedra, evaluated, evaluated_inverse;
  bool are_staircases = false;
  int number_of_threads = 1, number_of_iterations = 0;
  double cell_size = 0, joining_distance = 0, tolerance = 0, energy_tolerance = 0, maximum_angle_distortion = 0, time_limit = 0;
  bool do_improve = false, do_merge_points = false, do_separate = false, do_fill_voids = false;
  bool do_leave_out_flat_cells = false;
  bool are_displacements = false, do_slide = false;
  bool use_volume_weights = false, minimize_maximum_angle_distortion = false, is_quiet = false;
};

// The options of a program, and the text around them in its help.
struct Command_line
{
  const char* name;
  boost::program_options::options_description options;
  const char *before, *after;
  std::string formats = {}; // that this build reads and writes
};

constexpr const char* help_before_options =
R"(Examples:
  parameterize_mesh_file part.step --cells 2 --to polycube --hexahedra 2 part.inp
      Gmsh fills a part of a CAD program with tetrahedra. Hexahedra for Abaqus and CalculiX follow. Both have edges of about 2,
      in the unit of part.step, for example mm.
  parameterize_mesh_file cube.mesh --to ball -o ball.vtu
      In ParaView, the filter Calculator with Coordinate Results and the expression uvw shows the image.
      The data angle_distortion and volume_distortion can color the cells.
  parameterize_mesh_file cube.mesh cube_to_ball.txt --refine --output ball.mesh --refined-source source.mesh
      A text prescribes the boundary. Other programs can use this pair of meshes with the same cells.

Usage: parameterize_mesh_file SOURCE.mesh --to ball|cube|box=X,Y,Z|polycube|SURFACE.stl [options]
       parameterize_mesh_file SOURCE.mesh TARGET [options]
       parameterize_mesh_file SOURCE.mesh --conditions FILE [options]
       parameterize_mesh_file SOURCE.mesh --improve [options]

Maps a tetrahedral mesh onto another domain. The option --to or the file TARGET prescribes the image of the boundary. The program
computes the images of the interior vertices. No cell of the image is inverted or flat, and the distortion is low. With --improve,
the boundary does not move, and the source may have inverted and flat cells.

  SOURCE.mesh  the mesh: a file of MEDIT (*.mesh or *.meshb) or VTK (*.vtu). If the program was built with Gmsh, also *.msh, *.unv
               or *.bdf. If it was built with VTK, also *.vtk. The program meshio converts other formats:
               meshio convert a.inp a.vtu
               With Gmsh, SOURCE.mesh may also be a body: solids of a CAD program (*.step, *.stp, *.iges, *.igs, *.brep), a script
               of Gmsh (*.geo), or a closed surface (*.stl, *.off, *.obj, *.ply, *.vtp). Gmsh fills it with tetrahedra
  TARGET       a text with a line 'vertex_index x y z' for each boundary vertex, with indices from 0;
               or a table *.csv of ParaView;
               or a copy of SOURCE.mesh with other coordinates;
               or a surface with triangles of the boundary (*.mesh, *.off, *.ply, *.obj, *.stl or *.vtp).
               Interior vertices may have targets, too: see --inside
Each file may be a pipe, or - for the standard input or output. If a file goes to the standard output, messages go to the
standard error.
)";

constexpr const char* help_after_options = R"(
Exit status:
  0  success: no cell is inverted, and the boundary is met exactly
  1  no cell is inverted, but the result is not as asked for. The message names what is missed: the boundary (try --refine), the
     bound of --max-angle-distortion, the end of a minimization, or a part of the body that hexahedra leave out
  2  bad input: the message names the file, line or vertex. No output is written
  3  no map without inverted cells was found. No output is written. Try --refine
If the map is written, but another file cannot be written, the status is 2 or 3, and the message says so.
Ctrl-C and the time limit end the program in each of its parts. The program then writes valid results, with status 0, 1 or 3.
A second Ctrl-C ends the program at once.
)";

// Throws a sentence that names an option and what is wrong with it.
inline void refuse_if(const bool is_wrong, const std::string& sentence)
{
  if(is_wrong)
    throw std::runtime_error(sentence);
}

namespace options_of_both_programs {

constexpr unsigned width = 100; // columns of the help, a guess

inline boost::program_options::options_description distortion(Options& options, const char* const default_energy)
{
  namespace po = boost::program_options;
  po::options_description result("Distortion", width);
  result.add_options()
    ("energy", po::value(&options.energy)->value_name("NAME")->default_value("stretch", default_energy),
     "the minimized energy. stretch: for maps onto a ball, box or polycube. symmetric_dirichlet: if the boundary moves little, "
     "or if cells must keep their shapes, as in boundary layers. mips: for angles only. Others: "
     "arap, dirichlet, lscm, lpm")
    ("volume-weights", po::bool_switch(&options.use_volume_weights),
     "weight cells by their volume; otherwise, all cells count alike")
    ("energy-tolerance", po::value(&options.energy_tolerance)->value_name("PART")->default_value(1e-3, "0.001"),
     "end the minimization if five Newton steps lower the energy by less than this part of it; with 0, continue to a minimum");
  return result;
}

inline void add_limits(boost::program_options::options_description& computation, Options& options)
{
  namespace po = boost::program_options;
  computation.add_options()
    ("max-iterations", po::value(&options.number_of_iterations)->value_name("N")->default_value(1000),
     "the largest number of Newton steps of each stage")
    ("time-limit", po::value(&options.time_limit)->value_name("SECONDS")
       ->default_value(std::numeric_limits<double>::infinity(), "none"),
     "the time limit from the start of the program, after which it writes valid results")
    ("quiet", po::bool_switch(&options.is_quiet), "print errors only")
    ("version", "print the version, and the formats of files that this program has been built for")
    ("help", "print this text");
}

inline void check_limits(const Options& options)
{
  refuse_if(options.number_of_iterations < 0, "the number of iterations must not be negative");
  refuse_if(!(options.energy_tolerance >= 0), "the tolerance of the energy must not be negative");
  refuse_if(!(options.time_limit >= 0), "the time limit must not be negative");
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
     "the file for the map. *.mesh: the mesh with the new coordinates; with Gmsh also *.msh, or *.msh2 for version 2.2. *.vtu: "
     "the source with the map and its distortion as data. Groups and data of the source are kept if the format can store them")
    ("tetrahedra", po::value(&options.tetrahedra)->value_name("FILE"),
     "the tetrahedra that Gmsh makes of a body (*.mesh, *.vtu, *.msh)")
    ("refined-source", po::value(&options.refined_source)->value_name("FILE"),
     "the source (*.mesh, *.msh) with the vertices that --refine added; it has the cells of the output")
    ("hexahedra", po::value(&options.hexahedra)->multitoken()->value_name("SPACING FILE"),
     "hexahedra (*.mesh, *.vtu, *.msh or *.inp). They fill a box or polycube, and are pulled back to the source. SPACING is their "
     "size there: a cube has sides of length 1, a polycube about the lengths of the source")
    ("staircases", po::bool_switch(&options.are_staircases), "do not let hexahedra follow the interfaces between subdomains")
    ("evaluate", po::value(&options.evaluated)->multitoken()->value_name("POINTS FILE"),
     "points of the source that the map carries: POINTS has three coordinates in each line. FILE (*.csv) gets the point x, y, z, "
     "its image u, v, w, the cell with its reference, and the data of the mesh there. A point outside is moved to the nearest "
     "point of the source, by the distance in FILE")
    ("evaluate-inverse", po::value(&options.evaluated_inverse)->multitoken()->value_name("POINTS FILE"),
     "likewise, with points of the image")
    ("report", po::value(&options.report)->value_name("FILE"), "a JSON file with counts, times and distortions");

  po::options_description source("Source", width);
  source.add_options()
    ("cells", po::value(&options.cell_size)->value_name("SIZE")->default_value(0, "a 20th of the diagonal of the box"),
     "the largest edges, about, of the tetrahedra that Gmsh makes of a body, in the unit of its file")
    ("fill-voids", po::bool_switch(&options.do_fill_voids),
     "fill voids inside of a body, which balls, boxes and polycubes do not have")
    ("leave-out-flat-cells", po::bool_switch(&options.do_leave_out_flat_cells),
     "leave out flat cells at the boundary of a mesh if the boundary consists of the same points without them")
    ("merge-points", po::value(&options.joining_distance)->value_name("DISTANCE"),
     "without a value: join cells at points with the same coordinates. With a distance: join points on the boundary of a mesh, "
     "and at gaps of surfaces, SOURCE or that of --to, that are at most this far from each other, in the unit of the file. "
     "Without the option, the distance for surfaces is a tiny part of them")
    ("features", po::value(&options.features)->value_name("FILE"),
     "the sharp edges of the source: lines with two vertices, counted from 0. They replace the edges marked in SOURCE.mesh. If "
     "no edges are marked, edges with 60 degrees or more between the normals are sharp")
    ("regions", po::value(&options.regions)->value_name("NAME"),
     "the cell data that are the subdomains, instead of data with a known name, such as material or RegionId")
    ("separate", po::bool_switch(&options.do_separate),
     "separate parts of the body that touch at a vertex or an edge only, by copies of vertices, and of midpoints of edges");

  po::options_description boundary("Boundary", width);
  boundary.add_options()
    ("to", po::value(&options.domain)->value_name("DOMAIN"),
     "the domain, instead of TARGET. ball: the unit ball. cube: the unit cube. box=X,Y,Z: a box with sides of these lengths. "
     "polycube: a polycube close to the source. A closed surface (*.off, *.stl, *.obj, *.ply or *.vtp) may have any triangles: "
     "the boundary is fitted to it. --to refines the source like --refine=boundary, unless --refine=none is given")
    ("polycube-axes", po::value(&options.polycube_axes)->value_name("WHICH")->default_value("found"),
     "found: the source is turned until its faces are nearly normal to the axes of the polycube. given: it is not turned")
    ("improve", po::bool_switch(&options.do_improve),
     "repair inverted and flat cells, instead of TARGET. Vertices of the boundary, of interfaces between references and of "
     "interior triangles stay. The other vertices move until each cell is as regular as possible. With --refine, cells whose "
     "vertices all stay are split")
    ("landmarks", po::value(&options.landmarks)->value_name("FILE"),
     "a file like TARGET with lines for some vertices, for --to. A ball, or a source that is fitted to a surface, is turned to "
     "bring these vertices close to their points. A box has eight landmarks as corners, each in the octant of its point")
    ("tolerance", po::value(&options.tolerance)->value_name("DISTANCE")
       ->default_value(std::numeric_limits<double>::infinity(), "none"),
     "split edges of the boundary that is fitted to a surface until vertices of the surface and midpoints of these edges are at "
     "most this far from the other surface, in the unit of its file. With --slide, they may be farther")
    ("displacements", po::bool_switch(&options.are_displacements), "TARGET contains displacements, not positions")
    ("others", po::value(&options.others)->value_name("WAY")->default_value("missing"),
     "the treatment of boundary vertices without a target. missing: there is no map. stay: they keep their positions. slide: "
     "they move in the planes, along the edges and on curved patches of the boundary; vertices with a target do not slide. free: "
     "they move to where the energy is lowest")
    ("conditions", po::value(&options.conditions)->value_name("FILE"),
     "lines for vertices that are not free. A line begins with the reference or the name of triangles, or with 'vertex' and an "
     "index. A name with blanks needs quotes. It ends with fixed, free, plane and a normal, a coordinate such as z=1, or "
     "surface. A fixed vertex is at its target in TARGET, or keeps its position. A plane with a normal goes through the same "
     "point. surface lets vertices slide on their triangles; with a file (*.off, *.stl, *.ply, *.obj, *.vtp), on the surface "
     "there. --others is about boundary vertices without a target and a line, here with the default free")
    ("inside", po::value(&options.inside)->value_name("WAY")->default_value("auto"),
     "the treatment of interior vertices with a target. met: they meet the target. free: they ignore it. auto: they meet it if "
     "some vertices have no target. A copy of SOURCE.mesh has one for all. Vertices between cells of different references then "
     "meet it if one of them has moved")
    ("initial", po::value(&options.initial)->value_name("FILE"),
     "an initial map, as a file like TARGET; for example, the --output for other targets nearby")
    ("boundary", po::value(&options.boundary)->value_name("NAME")->default_value("auto"),
     "fixed: the targets are met, or there is no map. soft: the boundary is pulled to its targets, and may miss them. auto: "
     "fixed, and soft if fixed finds no map")
    ("refine", po::value(&options.refinement)->value_name("WHERE")->default_value("none", "none, or boundary with --to"),
     "none: add no vertices. needed: add vertices if the targets cannot be met otherwise. helpful: also in interior edges "
     "between boundary vertices if these edges make the map slow or distorted. boundary, and --refine without a value: also on "
     "edges of the boundary if a polycube or --tolerance needs this. all: first in all interior edges between boundary vertices")
    ("slide", po::bool_switch(&options.do_slide),
     "let vertices move in the planes, along the edges and on curved patches of the target, or on the surface of --to, for a "
     "lower distortion");

  po::options_description distortion = options_of_both_programs::distortion(
    options, "stretch; mips with --improve; symmetric_dirichlet if boundary vertices are free");
  distortion.add_options()
    ("reference-scale", po::value(&options.reference_scale)->value_name("NUMBER")->default_value("", "1, or found"),
     "the scale of the source at which its cells are undistorted. found: that of equal volumes, or if a part of the boundary is "
     "free, the stretch between vertices at their targets. If a part of the boundary is free, the default is 1, otherwise found")
    ("max-angle-distortion", po::value(&options.maximum_angle_distortion)->value_name("K")
       ->default_value(std::numeric_limits<double>::infinity(), "none"),
     "bring the distortion of angles of every cell below K, if possible; without distortion, it is 2")
    ("minimize-max-angle-distortion", po::bool_switch(&options.minimize_maximum_angle_distortion),
     "make the largest distortion of angles as small as possible, which takes longer");

  po::options_description computation("Computation", width);
  computation.add_options()
    ("solver", po::value(&options.solver)->value_name("NAME")->default_value("cg"),
     "cg: conjugate gradients. cholmod: a direct solver, if the program was built with CHOLMOD")
    ("threads", po::value(&options.number_of_threads)->value_name("N")->default_value(1),
     "the number of threads, at most the number of processors; the result does not depend on it");
  options_of_both_programs::add_limits(computation, options);

  po::options_description all(width);
  all.add(files).add(source).add(boundary).add(distortion).add(computation);
  return { "parameterize_mesh_file", all, help_before_options, help_after_options, formats_of_this_build() };
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
  std::replace(arguments.begin(), arguments.end(), std::string("--merge-points"), std::string("--merge-points=0"));
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
              << ")\n" << line.formats;
    return false;
  }
  for(std::string* name : { &options.source, &options.target, &options.features, &options.landmarks, &options.conditions,
                            &options.initial })
    if(*name == "-")
      *name = "/dev/stdin";
  for(std::vector<std::string>* words : { &options.hexahedra, &options.evaluated, &options.evaluated_inverse })
    if(!words->empty() && words->back() == "-")
      words->back() = "/dev/stdout";
  for(std::string* name : { &options.tetrahedra, &options.output, &options.refined_source, &options.report })
    if(*name == "-")
      *name = "/dev/stdout";
  const int number_of_ways = !options.target.empty() + !options.domain.empty() + options.do_improve;
  if(options.do_improve && number_of_ways > 1)
    throw std::runtime_error("--improve excludes TARGET and --to: it keeps the boundary where it is");
  if(options.source.empty() || number_of_ways > 1 || (number_of_ways == 0 && options.conditions.empty()))
    throw std::runtime_error("give SOURCE.mesh and one of TARGET, --to DOMAIN, --improve and --conditions FILE; --help lists "
                             "all options");
  options.do_merge_points = given.count("merge-points") != 0;
  if(!options.domain.empty() && given["refine"].defaulted())
    options.refinement = "boundary"; // as the library refines for a boundary parameterizer
  if(!options.conditions.empty() && given["others"].defaulted())
    options.others = "free";
  if((options.others == "free" || !options.conditions.empty()) && given["energy"].defaulted())
    options.energy = "symmetric_dirichlet"; // which has a minimum if a part of the boundary is free
  if(options.do_improve && given["energy"].defaulted())
    options.energy = "mips"; // which does not compare sizes, so small cells stay small
  return true;
}

#endif // COMMAND_LINE_H
