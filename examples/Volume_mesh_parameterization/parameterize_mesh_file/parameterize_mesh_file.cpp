// Maps the tetrahedral mesh of a file onto the boundary that another file prescribes, a ball, a box, a polycube, or its own.
#include "Command_line.h"
#include "Evaluated_points.h"
#include "Hexahedra_file.h"
#include "Named_choices.h"
#include "Progress_line.h"
#include "Report.h"
#include "Target_points.h"
#include "boundary_targets_of.h"
#include "check_options.h"
#include "mapped_to_targets.h"
#include "notes_on_hexahedra.h"
#include "read_source.h"

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/Output_file.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include <boost/algorithm/string/replace.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <string>

void write_mesh(const std::string& filename, const VMP::Tetrahedron_soup_3& mesh, Progress_line& progress)
{
  VMP::IO::Output_file file(filename);
#ifdef PARAMETERIZE_MESH_FILE_USES_GMSH
  if(is_Gmsh_name(filename))
    gmsh_module().write(file.stream(), mesh, version_of_Gmsh_name(filename));
  else
#endif
    VMP::IO::write_MEDIT(file.stream(), mesh);
  file.commit(CGAL::parameters::visitor(std::ref(progress)));
}

// Writes the image with its own data if it is an improved mesh: its source may be tangled, and is of no use.
void write_map(const std::string& filename, const VMP::Tetrahedron_soup_3& source, const Points& uvw, const bool is_improved,
               Progress_line& progress)
{
  VMP::Tetrahedron_soup_3 image = source;
  image.points = uvw;
  if(extension_of(filename) != ".vtu")
    return write_mesh(filename, image, progress);
  VMP::IO::Output_file file(filename);
  VMP::IO::write_VTU(file.stream(), is_improved ? image : source, uvw);
  file.commit(CGAL::parameters::visitor(std::ref(progress)));
}

// Makes hexahedra of a map that has been written, if the map meets the boundary, and adds their result to the outcome.
void make_hexahedra(const Options& options, const VMP::Tetrahedron_soup_3& mesh, const Points& uvw,
                    Progress_line& progress, Outcome& outcome)
{
  if(outcome.result.boundary_residual != 0)
  {
    outcome.result.message += " There are no hexahedra, because the boundary is missed.";
    return;
  }
  note_on_hexahedra(options, mesh, uvw, outcome.result.distortion.angle_max, progress);
  progress.show("making hexahedra");
  const double begin = progress.seconds();
  const Hexahedra_file file(options.hexahedra);
  const PM::Hexahedral_mesh_result hexahedra = file.write(mesh, uvw, options.are_staircases, progress);
  outcome.hexahedra = hexahedra;
  outcome.seconds_hexahedra = progress.seconds() - begin;
  if(hexahedra.has_valid_mesh)
  {
    outcome.files.push_back(file.name());
    note_changed_names(options, mesh);
  }
  if(hexahedra.status == VMP::OK)
    return;
  const bool is_interrupted = hexahedra.status == VMP::ERROR_INTERRUPTED;
  if(!hexahedra.has_valid_mesh)
    outcome.exit_code = is_interrupted || hexahedra.status == VMP::ERROR_INVERTED_HEXAHEDRON ? NOT_FLIP_FREE : BAD_INPUT;
  else if(!is_interrupted)
    outcome.exit_code = NOT_AS_ASKED;
  Result& result = outcome.result;
  const std::string of_map = result.status == VMP::OK ? "The map is complete. " : result.message + " ";
  const std::string of_hexahedra
    = boost::replace_all_copy(hexahedra.message, VMP::get_error_message(VMP::ERROR_INTERRUPTED), progress.reason());
  result.status = hexahedra.status;
  outcome.status_code = error_code_name(result.status);
  result.message = of_map + (hexahedra.has_valid_mesh || is_interrupted ? "" : "There are no hexahedra: ") + of_hexahedra;
}

// Points with the table that they are written to.
using Tables_of_points = std::vector<std::pair<Evaluated_points, Points> >;

Tables_of_points read_points_to_evaluate(const Options& options)
{
  Tables_of_points result;
  for(const bool is_inverse : { false, true })
    if(const Evaluated_points table(is_inverse ? options.evaluated_inverse : options.evaluated, is_inverse); !table.name().empty())
      result.emplace_back(table, table.read());
  return result;
}

// Writes the files of a map. The outcome names the file that cannot be written, and those that have been.
void write_files(const Options& options, const Source& source, const Points& uvw, const Tables_of_points& tables,
                 Progress_line& progress, Outcome& outcome)
{
  const auto fail = [&](const Exit_code exit_code, const char* status_code, const std::string& sentence)
  {
    outcome.exit_code = exit_code;
    outcome.status_code = status_code;
    outcome.result.message = (outcome.files.empty() ? "No file is written. "
      : (outcome.result.status == VMP::OK ? "The map is complete" : outcome.result.message + " It is") + " in "
        + list(outcome.files) + ". ") + sentence;
  };
  try
  {
    if(!options.output.empty())
    {
      write_map(options.output, source.soup, uvw, options.do_improve, progress);
      outcome.files.push_back(options.output);
    }
    if(!options.refined_source.empty())
    {
      write_mesh(options.refined_source, source.soup, progress);
      outcome.files.push_back(options.refined_source);
    }
    for(const auto& [table, points] : tables)
    {
      table.write(points, source.soup, uvw, progress);
      outcome.files.push_back(table.name());
    }
    if(!options.hexahedra.empty())
      make_hexahedra(options, source.soup, uvw, progress, outcome);
  }
  catch(const VMP::IO::Unread_output& error)
  {
    fail(NOT_FLIP_FREE, error_code_name(VMP::ERROR_INTERRUPTED), progress.reason() + std::string(" ") + error.what());
  }
  catch(const std::bad_alloc&)
  {
    fail(NOT_FLIP_FREE, "ERROR_OUT_OF_MEMORY", "There is not enough memory for the other files.");
  }
  catch(const std::exception& error)
  {
    fail(BAD_INPUT, "ERROR_FILE_NOT_WRITTEN", error.what());
  }
}

Outcome run(const Options& options, Progress_line& progress)
{
#ifdef CGAL_LINKED_WITH_TBB
  // never destroyed: where the limit ends, TBB starts a thread, and throws if there is no memory for that
  static const auto* const limit = new tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                                           number_of_threads(options));
  CGAL_USE(limit);
#endif
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  progress.begin("reading " + options.source);
  Source source = read_source(options, progress);
  VMP::Tetrahedron_soup_3& mesh = source.soup;
  progress.show("");
  const auto print_note = [&](const std::string& name, const std::string& note)
  {
    if(options.is_quiet || note.empty())
      return;
    progress.show("");
    std::cerr << "note: " << name << ": " << note << std::endl;
  };
  for(const std::string& note : source.notes)
    print_note(options.source, note);
  if(!options.tetrahedra.empty())
    write_map(options.tetrahedra, mesh, mesh.points, false, progress);

  const bool has_file = !options.target.empty();
  if(has_file)
    progress.begin("reading " + options.target);
  const auto read_points = [&](const std::string& name)
  {
    std::vector<std::string> notes;
    Points points = targets_of_file(name, source.in_file(), progress, notes);
    for(const std::string& note : notes)
      print_note(name, note);
    return naming(name, [&] { return source.carried(std::move(points)); });
  };
  Target_points target;
  if(options.do_improve)
    target = naming(options.source, [&] { return targets_to_improve(mesh); });
  else if(options.domain.empty())
  {
    const Points points = has_file ? read_points(options.target) : Points(mesh.points.size(), { nan, nan, nan });
    target = naming(options.source, [&] { return target_points(source, points, options); });
  }
  if(!options.conditions.empty() && !read_conditions(source, options, progress, target))
    throw Interruption();
  Points initial = options.do_improve ? mesh.points : options.initial.empty() ? Points() : read_points(options.initial);
  const Tables_of_points tables = read_points_to_evaluate(options);
  const Landmarks landmarks = landmarks_of_file(options.landmarks, source.in_file(), progress);
  const double seconds_reading = progress.seconds();
  Mapped_mesh mapped = mapped_to_targets({ std::move(mesh), std::move(target), std::move(initial) }, options, landmarks, progress);
  mesh = std::move(mapped.mesh);
  target = std::move(mapped.target);
  const Result& result = mapped.result;
  if(result.status == VMP::ERROR_MISSING_BOUNDARY_TARGET)
    name_missing_target(options, mesh, target);
  Outcome outcome = { exit_code(result), error_code_name(result.status), result };
  outcome.seconds_reading = seconds_reading;
  outcome.seconds_boundary = result.seconds_boundary;
  if(options.domain == "polycube" && result.number_of_cells > 0)
    outcome.polycube = mapped.polycube;
  outcome.repairs = source.repairs;
  outcome.numbers_of_conditions = numbers_of_conditions(mesh, target);
  if(!result.has_valid_map && result.status != VMP::ERROR_INTERRUPTED)
    outcome.result.message = options.source + ": " + result.message;
  if(!result.has_valid_map)
    return outcome;
  outcome.quality_of_source = VMP::measure_quality(mesh.points, mesh.cells);
  outcome.surface_fit = mapped.surface_fit;
  if(!mapped.surface.facets.empty() && !outcome.surface_fit)
    outcome.surface_fit = VMP::measure_surface_fit(mapped.uvw, mesh.cells, mapped.surface.points, mapped.surface.facets,
                                                   landmarks);
  if(outcome.surface_fit)
  {
    const auto [of_landmarks, of_surface] = notes_on_fit(mapped.surface, *outcome.surface_fit);
    print_note(options.landmarks, of_landmarks);
    print_note(options.domain, of_surface);
  }
  outcome.number_of_targets_inside = number_of_met_targets(target, mapped.uvw);
  outcome.number_of_missed_targets = target.inside.size() - outcome.number_of_targets_inside;
  if(has_file && outcome.exit_code == SUCCESS && !target.is_boundary_free && !options.do_slide
     && named_others(options.others) != Others::SLIDE)
    outcome.number_of_free_targets = number_of_free_targets(target, mapped.uvw);
  source.complete_images(mapped.uvw);
  progress.show("writing"); // also if the computation was interrupted
  write_files(options, source, mapped.uvw, tables, progress, outcome);
  return outcome;
}

// Runs the program, and turns exceptions into messages of the result.
Outcome run_and_catch(const Options& options, Progress_line& progress)
{
  Result result;
  try
  {
    return run(options, progress);
  }
  catch(const Interruption& interruption)
  {
    result.message = std::string(progress.reason()) + " " + interruption.sentence;
    return { NOT_FLIP_FREE, error_code_name(VMP::ERROR_INTERRUPTED), result };
  }
  catch(const std::bad_alloc&)
  {
    result.message = "There is not enough memory.";
    return { NOT_FLIP_FREE, "ERROR_OUT_OF_MEMORY", result };
  }
  catch(const std::exception& error)
  {
    result.message = error.what();
    return { BAD_INPUT, "ERROR_BAD_INPUT", result };
  }
}

int main(int argc, char* argv[])
{
  try
  {
    Options options;
    if(!parse(argc, argv, command_line(options), options))
    {
      flush_standard_output();
      return SUCCESS;
    }
    check(options);
    // the file must be all of the standard output; text goes to the standard error
    if(writes_to_standard_output(options))
      std::cout.rdbuf(std::cerr.rdbuf());

    Progress_line progress(!options.is_quiet, options.time_limit);
    const Outcome outcome = run_and_catch(options, progress);
    progress.finish();
    const Result& result = outcome.result;
    if(result.has_valid_map && !options.is_quiet)
      print(options, outcome);
    if(outcome.exit_code != SUCCESS || result.status != VMP::OK)
      std::cerr << result.message << std::endl;
    else if(!options.is_quiet)
      print_notes(options, result);
    if(outcome.exit_code == NOT_AS_ASKED && result.boundary_residual > 0)
      std::cerr << "The boundary residual is " << result.boundary_residual << "." << std::endl;
    if(!options.report.empty())
      write_report(options, outcome, progress);
    if(result.has_valid_map && !options.is_quiet)
      print_end(options, outcome);
    flush_standard_output();
    return outcome.exit_code;
  }
  catch(const std::bad_alloc&)
  {
    std::cerr << "There is not enough memory." << std::endl;
    return NOT_FLIP_FREE;
  }
  catch(const VMP::IO::Unread_output& error) // the report
  {
    std::cerr << error.what() << std::endl;
    return NOT_FLIP_FREE;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return BAD_INPUT;
  }
}
