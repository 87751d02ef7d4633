// Maps the tetrahedral mesh of a file onto the boundary that another file prescribes.
#include "Command_line.h"
#include "JSON_object.h"
#include "Named_energy_3.h"
#include "Output_file.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
#  include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#endif
#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace fs = std::filesystem;
namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;
using Cell_handle = C3t3::Cell_handle;
using Points = std::vector<std::array<double, 3> >;
using Index_map = std::unordered_map<Vertex_handle, std::size_t>;   // to the order of the file
using Result = VMP::Parameterization_result;

// The number of threads is limited at run time; results do not depend on it.
using Concurrency_tag = CGAL::Parallel_if_available_tag;

enum Exit_code { SUCCESS = 0, BOUNDARY_MISSED = 1, BAD_INPUT = 2, NOT_FLIP_FREE = 3 };

// Calls `f` with the linear solver of that name.
template <typename F>
void with_solver(const std::string& name, const F& f)
{
  if(name == "cg") return f(VMP::Conjugate_gradient_solver_traits_3<Concurrency_tag>());
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
  if(name == "cholmod") return f(VMP::CHOLMOD_solver_traits_3());
#endif
  throw std::runtime_error("there is no solver '" + name + "'");
}

VMP::Boundary_mode boundary_mode(const std::string& name)
{
  if(name == "auto") return VMP::Boundary_mode::AUTO;
  if(name == "fixed") return VMP::Boundary_mode::FIXED;
  if(name == "soft") return VMP::Boundary_mode::SOFT;
  throw std::runtime_error("there is no boundary mode '" + name + "'");
}

// The mesh in the order of the file, and the same mesh as a complex.
struct Problem
{
  explicit Problem(const Options& options)
  {
    VMP::IO::read_MEDIT(options.source, source);
    VMP::IO::read_boundary_targets(options.target, source, targets);
    build(options.source);
    check_targets(options.target);
  }

  // Takes over the vertices that refinement has added, behind those of the file.
  void update_source(const std::size_t number_of_points)
  {
    VMP::Tetrahedron_soup_3 refined;
    std::vector<Vertex_handle> vertices;
    VMP::mesh_complex_3_to_tetrahedron_soup(c3t3, refined, vertices);
    source.points.resize(number_of_points);
    for(std::size_t v = 0; v < vertices.size(); ++v)
      source.points[indices.at(vertices[v])] = refined.points[v];
    for(auto& cell : refined.cells)
      for(std::size_t& v : cell)
        v = indices.at(vertices[v]);
    source.cells = std::move(refined.cells);
    source.cell_references = std::move(refined.cell_references);
  }

  VMP::Tetrahedron_soup_3 source;
  Points targets;
  C3t3 c3t3;
  Index_map indices;

private:
  void build(const std::string& filename)
  {
    std::vector<Vertex_handle> vertices;
    try
    {
      VMP::tetrahedron_soup_to_mesh_complex_3(source, c3t3, vertices, cells);
    }
    catch(const VMP::Input_error& error)
    {
      throw VMP::Input_error(filename + ": " + error.what());
    }
    for(std::size_t v = 0; v < vertices.size(); ++v)
      if(vertices[v] != Vertex_handle()) // otherwise it has no cell
        indices.emplace(vertices[v], v);
  }

  // The library would find a missing target too, but it does not know the index in the file.
  void check_targets(const std::string& filename) const
  {
    for(Cell_handle c : cells)
      for(int i = 0; i < 4; ++i)
        for(int j = 1; j < 4 && !c3t3.is_in_complex(c->neighbor(i)); ++j)
        {
          const std::size_t v = indices.at(c->vertex((i + j) % 4));
          if(std::isnan(targets[v][0]))
            throw VMP::Input_error(filename + ": vertex " + std::to_string(v)
                                   + " (counted from 0) is on the boundary of the source, but has no target");
        }
  }

  std::vector<Cell_handle> cells;
};

// A property map that finds the point of a vertex by its index in the file. New vertices are appended.
struct Point_map
{
  using key_type = Vertex_handle;
  using value_type = Point_3;
  using reference = Point_3;
  using category = boost::read_write_property_map_tag;

  friend Point_3 get(const Point_map& map, Vertex_handle v)
  {
    const std::array<double, 3>& p = (*map.points)[map.indices->at(v)];
    return Point_3(p[0], p[1], p[2]);
  }

  friend void put(const Point_map& map, Vertex_handle v, const Point_3& p)
  {
    const auto [entry, is_new] = map.indices->emplace(v, map.points->size());
    if(is_new)
      map.points->emplace_back();
    (*map.points)[entry->second] = {p.x(), p.y(), p.z()};
  }

  Index_map* indices;
  Points* points;
};

// Keeps one line of a terminal up to date.
struct Progress
{
  bool after_step(const VMP::Parameterization_step& step) const
  {
    if(is_shown)
      std::cerr << clear_line << "iteration " << step.iteration << ", " << step.number_of_inverted_cells
                << " inverted cells, energy " << step.energy << ", " << step.seconds << " s" << std::flush;
    return true;
  }

  void finish() const
  {
    if(is_shown)
      std::cerr << clear_line << std::flush;
  }

  static constexpr const char* clear_line = "\r\033[K";
  bool is_shown;
};

Result parameterize(Problem& problem, const Options& options, Points& uvw)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(options.number_of_threads));
#endif
  // a vertex without a cell keeps its place, or takes the prescribed one
  uvw = problem.source.points;
  for(std::size_t v = 0; v < uvw.size(); ++v)
    if(!std::isnan(problem.targets[v][0]))
      uvw[v] = problem.targets[v];

  Result result;
  Progress progress{!options.is_quiet && isatty(STDERR_FILENO) != 0};
  with_solver(options.solver, [&](const auto& solver)
  {
    result = CGAL::stretch_minimizing_volume_parameterization<Concurrency_tag>(
      problem.c3t3, Point_map{&problem.indices, &uvw},
      params::boundary_map(Point_map{&problem.indices, &problem.targets})
        .boundary_mode(boundary_mode(options.boundary))
        .do_refine(options.do_refine)
        .do_slide_boundary(options.do_slide)
        .energy(Named_energy_3(options.energy))
        .use_volume_weights(options.use_volume_weights)
        .maximal_angle_distortion(options.maximal_angle_distortion)
        .solver_traits(solver)
        .number_of_iterations(static_cast<std::size_t>(options.number_of_iterations))
        .visitor(progress));
  });
  progress.finish();
  if(result.number_of_added_vertices > 0 && result.has_valid_map)
    problem.update_source(uvw.size());
  return result;
}

Exit_code exit_code(const Result& result)
{
  if(result.has_valid_map)
    return (result.boundary_residual == 0) ? SUCCESS : BOUNDARY_MISSED;
  switch(result.status)
  {
    case VMP::ERROR_NOT_FLIP_FREE:
    case VMP::ERROR_INTERRUPTED:
    case VMP::ERROR_LINEAR_SOLVER_FAILED: return NOT_FLIP_FREE;
    default: return BAD_INPUT;
  }
}

void write_mesh(const std::string& filename, const VMP::Tetrahedron_soup_3& mesh)
{
  Output_file file(filename);
  VMP::IO::write_MEDIT(file.stream(), mesh);
  file.commit();
}

void write_map(const std::string& filename, const VMP::Tetrahedron_soup_3& source, const Points& uvw)
{
  if(fs::path(filename).extension() == ".vtu")
  {
    Output_file file(filename);
    VMP::IO::write_VTU(file.stream(), source, uvw);
    file.commit();
  }
  else
  {
    VMP::Tetrahedron_soup_3 image = source;
    image.points = uvw;
    write_mesh(filename, image);
  }
}

std::size_t peak_memory_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * static_cast<std::size_t>(usage.ru_maxrss);
}

JSON_object json(const VMP::Distortion_3& d)
{
  return JSON_object().add("angle_mean", d.angle_mean).add("angle_max", d.angle_max)
                      .add("volume_mean", d.volume_mean).add("volume_max", d.volume_max);
}

// Of bad input there is nothing to tell but the message.
void write_report(const std::string& filename, const Result& result, Exit_code code)
{
  JSON_object report;
  report.add("status", result.message);
  if(code != BAD_INPUT)
    report.add("vertices", result.number_of_vertices)
          .add("cells", result.number_of_cells)
          .add("boundary_vertices", result.number_of_boundary_vertices)
          .add("added_vertices", result.number_of_added_vertices)
          .add("sliding_vertices", result.number_of_sliding_vertices)
          .add("inverted_cells", result.number_of_inverted_cells)
          .add("boundary_residual", result.boundary_residual)
          .add("iterations", result.number_of_iterations)
          .add("untangling_iterations", result.number_of_untangling_iterations)
          .add("seconds_total", result.seconds_total)
          .add("seconds_to_flip_free", result.seconds_to_flip_free)
          .add("seconds_numbering", result.seconds_numbering)
          .add("seconds_start", result.seconds_start)
          .add("seconds_untangling", result.seconds_untangling)
          .add("seconds_minimization", result.seconds_minimization)
          .add("seconds_check", result.seconds_check)
          .add("energy_value", result.energy)
          .add("distortion", json(result.distortion))
          .add("distortion_at_source_volume", json(result.distortion_at_source_volume))
          .add("peak_memory_bytes", peak_memory_bytes());

  Output_file file(filename);
  file.stream() << report.text() << "\n";
  file.commit();
}

// Finds faults in the options before anything expensive is done.
void check(const Options& options)
{
  Named_energy_3{options.energy};
  with_solver(options.solver, [](const auto&) {});
  boundary_mode(options.boundary);
  if(options.number_of_threads < 1 || options.number_of_iterations < 0)
    throw std::runtime_error("the number of threads or of iterations is too small");
  if(!(options.maximal_angle_distortion > 2))
    throw std::runtime_error("the distortion of angles cannot be below 2");
#ifndef CGAL_LINKED_WITH_TBB
  if(options.number_of_threads > 1)
    throw std::runtime_error("this program was built without TBB, it has only one thread");
#endif

  const fs::path extension = fs::path(options.output).extension();
  if(!options.output.empty() && extension != ".mesh" && extension != ".vtu")
    throw std::runtime_error(options.output + ": the name of the output ends neither with .mesh nor with .vtu");

  const auto canonical = [](const std::string& name) { return fs::weakly_canonical(fs::absolute(name)); };
  std::vector<fs::path> others = {canonical(options.source), canonical(options.target)};
  for(const std::string& name : {options.output, options.refined_source, options.report})
  {
    if(name.empty())
      continue;
    const fs::path path = canonical(name);
    if(std::find(others.begin(), others.end(), path) != others.end())
      throw std::runtime_error(name + ": this file has two roles, it would be overwritten");
    others.push_back(path);
    Output_file can_be_written(name);
  }
}

void print(const Result& result)
{
  const VMP::Distortion_3& d = result.distortion;
  std::cout << result.number_of_cells << " cells, " << result.number_of_vertices << " vertices, "
            << result.number_of_boundary_vertices << " on the boundary\n"
            << result.number_of_iterations << " iterations in " << result.seconds_total << " s, "
            << result.number_of_inverted_cells << " inverted cells, energy " << result.energy << "\n"
            << "distortion of angles:  mean " << d.angle_mean << ", max " << d.angle_max << "\n"
            << "distortion of volumes: mean " << d.volume_mean << ", max " << d.volume_max << "\n";
}

Exit_code run(const Options& options, Result& result)
{
  Problem problem(options);
  Points uvw;
  result = parameterize(problem, options, uvw);

  const Exit_code code = exit_code(result);
  if(code == SUCCESS || code == BOUNDARY_MISSED)
  {
    if(!options.output.empty())
      write_map(options.output, problem.source, uvw);
    if(!options.refined_source.empty())
      write_mesh(options.refined_source, problem.source);
    if(!options.is_quiet)
      print(result);
  }
  return code;
}

// The same, with what is thrown as a message of the result.
Exit_code run_and_catch(const Options& options, Result& result)
{
  try
  {
    return run(options, result);
  }
  catch(const std::bad_alloc&)
  {
    result.message = "There is not enough memory.";
    return NOT_FLIP_FREE;
  }
  catch(const std::exception& error)
  {
    result.message = error.what();
    return BAD_INPUT;
  }
}

int main(int argc, char* argv[])
{
  try
  {
    Options options;
    if(!parse(argc, argv, options))
      return SUCCESS;
    check(options);

    Result result;
    const Exit_code code = run_and_catch(options, result);
    if(code != SUCCESS || result.status != VMP::OK)
      std::cerr << result.message << std::endl;
    if(code == BOUNDARY_MISSED)
      std::cerr << "The boundary residual is " << result.boundary_residual << "." << std::endl;
    if(!options.report.empty())
      write_report(options.report, result, code);
    return code;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return BAD_INPUT;
  }
}
