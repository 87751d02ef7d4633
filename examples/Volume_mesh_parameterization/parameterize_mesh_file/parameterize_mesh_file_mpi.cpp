// Maps the tetrahedral mesh of a file onto the boundary that another file prescribes, with several processes:
// mpirun -n N parameterize_mesh_file_mpi SOURCE.mesh TARGET [options] [PETSc's options, with one dash]
#include "Command_line.h"
#include "Named_choices.h"
#include "Progress_line.h"
#include "Result_report.h"
#include "check_roles.h"

#include <CGAL/Volume_mesh_parameterization/Distributed/Distributed_tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Distributed/IO.h>
#include <CGAL/Volume_mesh_parameterization/Distributed/distributed_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#include <petscsys.h>

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace fs = std::filesystem;
namespace params = CGAL::parameters;

using Points = std::vector<std::array<double, 3> >;
using Result = VMP::Parameterization_result;

int rank()
{
  int result;
  MPI_Comm_rank(MPI_COMM_WORLD, &result);
  return result;
}

int number_of_processes()
{
  int result;
  MPI_Comm_size(MPI_COMM_WORLD, &result);
  return result;
}

constexpr const char* help_before =
R"(Usage: mpirun -n N parameterize_mesh_file_mpi SOURCE.mesh TARGET [options] [options of PETSc, with one dash]

Several processes map a tetrahedral mesh onto the boundary that TARGET prescribes. No cell of the image is inverted or flat.

  SOURCE.mesh  the mesh: a MEDIT file as text
  TARGET       a text with a line 'vertex_index x y z' for each boundary vertex, with indices from 0;
               or a copy of SOURCE.mesh with other coordinates
Each process reads a part of these files. Therefore, they must be regular files.
)";

constexpr const char* help_after = R"(
Exit status:
  0  success: no inverted cell, and the boundary is met exactly
  2  bad input: the message names the file, line or vertex. No output is written
  3  no map without inverted cells was found. No output is written

Example:
  mpirun -n 4 parameterize_mesh_file_mpi cube.mesh cube_to_ball.txt --output ball.pvtu -ksp_rtol 1e-6
)";

Command_line distributed_command_line(Options& options)
{
  namespace po = boost::program_options;
  po::options_description files("Files", options_of_both_programs::width);
  files.add_options()
    ("output", po::value(&options.output)->value_name("NAME.pvtu"),
     "the source with the map and its distortion as data, in a file NAME_0.vtu, NAME_1.vtu, ... of each process")
    ("report", po::value(&options.report)->value_name("FILE"), "a JSON file with counts, times and distortions");
  po::options_description computation("Computation", options_of_both_programs::width);
  options_of_both_programs::add_limits(computation, options);
  po::options_description all(options_of_both_programs::width);
  all.add(files).add(options_of_both_programs::distortion(options, "stretch")).add(computation);
  return { "parameterize_mesh_file_mpi", all, help_before, help_after };
}

// The other options of parameterize_mesh_file are refused by name.
void check_names(const int argc, char* argv[], const Command_line& line)
{
  for(int i = 1; i < argc; ++i)
  {
    const std::string name = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if(name.substr(0, 2) == "--" && line.options.find_nothrow(name.substr(2), false) == nullptr)
      throw std::runtime_error(name + " is an option of parameterize_mesh_file only, not of several processes");
  }
}

Result parameterize(const Options& options, const VMP::Distributed_tetrahedron_soup_3& source, const Points& targets,
                    Points& uvw, Progress_line& progress)
{
  try
  {
    return CGAL::stretch_minimizing_volume_parameterization(source, targets, uvw,
      params::energy(named_energy(options.energy))
        .use_volume_weights(options.use_volume_weights)
        .energy_tolerance(options.energy_tolerance)
        .number_of_iterations(static_cast<std::size_t>(options.number_of_iterations))
        .visitor(std::ref(progress)));
  }
  catch(const VMP::Input_error& error)
  {
    throw VMP::Input_error(options.source + ": " + error.what());
  }
}

// Finds faults in the options before anything expensive is done; where files are concerned, on rank 0.
void check(const Options& options)
{
  named_energy(options.energy);
  options_of_both_programs::check_limits(options);
  refuse_if(!options.output.empty() && fs::path(options.output).extension() != ".pvtu",
            options.output + ": the name of the output does not end with .pvtu");
  if(rank() != 0)
    return;
  std::vector<std::string> outputs = { options.report, options.output };
  outputs.erase(std::remove(outputs.begin(), outputs.end(), ""), outputs.end());
  for(int i = 0; i < number_of_processes() && !options.output.empty(); ++i)
    outputs.push_back(VMP::IO::name_of_piece(options.output, i));
  check_roles({ options.source, options.target }, outputs);
}

// Reads the files, makes the map and writes it. Without the files, there is no map.
Exit_code run(const Options& options, Progress_line& progress, Result& result)
{
  VMP::Distributed_tetrahedron_soup_3 source;
  Points targets, uvw;
  const auto limits = params::visitor(std::ref(progress)).maximum_running_time(options.time_limit);
  if(VMP::IO::read_MEDIT(options.source, source, limits)
     && VMP::IO::read_boundary_targets(options.target, source, targets, limits))
    result = parameterize(options, source, targets, uvw, progress);
  else
  {
    result.status = VMP::ERROR_INTERRUPTED;
    result.message = std::string(progress.reason()) + " There is no map yet.";
  }
  progress.finish();
  const Exit_code code = exit_code(result);
  if(code == SUCCESS && !options.output.empty())
    VMP::IO::write_PVTU(options.output, source, uvw);
  if(code == SUCCESS && !options.is_quiet && rank() == 0)
    print(result);
  return code;
}

// Runs the program, and turns exceptions of any process into messages of the result in all processes.
Exit_code run_and_catch(const Options& options, Progress_line& progress, Result& result)
{
  try
  {
    return run(options, progress, result);
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

// A number of each process; rank 0 gets those of all.
std::vector<double> of_processes(const double x)
{
  std::vector<double> all(number_of_processes());
  MPI_Gather(&x, 1, MPI_DOUBLE, all.data(), 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return all;
}

// Writes the report, which is the message alone for bad input.
void write_report(const std::string& filename, const Result& result, const Exit_code code, Progress_line& progress)
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const double seconds = static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
  JSON_object report;
  report.add("status", result.message);
  if(code != BAD_INPUT)
  {
    add(report, result);
    report.add("user_seconds_of_processes", of_processes(seconds))
          .add("peak_memory_bytes_of_processes", of_processes(1024 * static_cast<double>(usage.ru_maxrss)));
  }
  if(rank() != 0)
    return;
  VMP::IO::Output_file file(filename);
  file.stream() << report.text() << "\n";
  file.commit(params::visitor(std::ref(progress)));
}

// Rank 0 speaks, and decides about the options.
int run(const int argc, char* argv[])
{
  Options options;
  std::string message;
  bool has_task = false;
  try
  {
    const Command_line line = distributed_command_line(options);
    check_names(argc, argv, line);
    has_task = parse(argc, argv, line, options);
    if(has_task)
      check(options);
    else if(rank() == 0)
      flush_standard_output();
  }
  catch(const std::exception& error)
  {
    message = error.what();
  }
  int code = message.empty() ? SUCCESS : BAD_INPUT;
  MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
  if(code == SUCCESS && has_task)
  {
    Result result;
    Progress_line progress(!options.is_quiet && rank() == 0, options.time_limit);
    code = run_and_catch(options, progress, result);
    if(code != SUCCESS || result.status != VMP::OK)
      message = result.message;
    try
    {
      if(!options.report.empty())
        write_report(options.report, result, static_cast<Exit_code>(code), progress);
    }
    catch(const std::exception& error) // an error of rank 0, after all communication
    {
      message = error.what();
      code = BAD_INPUT;
    }
  }
  if(!message.empty() && rank() == 0)
    std::cerr << message << std::endl;
  return code;
}

int main(int argc, char* argv[])
{
  char** const petsc = std::find_if(argv + 1, argv + argc, [](const char* a) { return a[0] == '-' && a[1] != '-'; });
  std::vector<char*> of_petsc(petsc, argv + argc);
  of_petsc.insert(of_petsc.begin(), argv[0]);
  int number = static_cast<int>(of_petsc.size());
  of_petsc.push_back(nullptr);
  char** begin = of_petsc.data();
  setenv("SCOTCH_PTHREAD_NUMBER", "1", 0); // PT-Scotch with threads would find another partition in each run
  if(PetscInitialize(&number, &begin, nullptr, nullptr) != 0)
    return BAD_INPUT;
  if(rank() != 0)
    std::cout.setstate(std::ios::failbit); // only one process prints, also the help
  const int code = run(static_cast<int>(petsc - argv), argv);
  PetscFinalize();
  return code;
}
