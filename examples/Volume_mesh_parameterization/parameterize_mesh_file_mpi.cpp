// Maps the tetrahedral mesh of a file onto the boundary that another file prescribes, with several processes:
// mpirun -n N parameterize_mesh_file_mpi SOURCE.mesh TARGET [options] [PETSc's options, with one dash]
#include "Command_line.h"
#include "JSON_object.h"
#include "Named_energy_3.h"
#include "Output_file.h"
#include "Report.h"

#include <CGAL/Volume_mesh_parameterization/Distributed/Distributed_tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Distributed/IO.h>
#include <CGAL/Volume_mesh_parameterization/Distributed/stretch_minimizing_volume_parameterization.h>

#include <petscsys.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

int rank()
{
  int result;
  MPI_Comm_rank(MPI_COMM_WORLD, &result);
  return result;
}

// Finds faults in the options before anything expensive is done.
void check(const Options& options)
{
  Named_energy_3{options.energy};
  const auto refuse = [](const bool is_given, const std::string& name)
  {
    if(is_given)
      throw std::runtime_error(name + ": parameterize_mesh_file does this, but not with several processes");
  };
  refuse(options.do_refine || !options.refined_source.empty(), "--refine");
  refuse(options.do_slide, "--slide");
  refuse(options.boundary == "soft", "--boundary soft");
  refuse(options.solver != "cg", "--solver " + options.solver);
  refuse(options.number_of_threads != 1, "--threads");
  refuse(options.maximal_angle_distortion < std::numeric_limits<double>::infinity(), "--max-angle-distortion");
  if(options.number_of_iterations < 0)
    throw std::runtime_error("the number of iterations is too small");
  if(!options.output.empty() && std::filesystem::path(options.output).extension() != ".pvtu")
    throw std::runtime_error(options.output + ": the name of the output does not end with .pvtu");
  if(rank() == 0)
    check_files({options.source, options.target}, {options.output, options.report});
}

Exit_code run(const Options& options, Result& result)
{
  VMP::Distributed_tetrahedron_soup_3 source;
  std::vector<std::array<double, 3> > targets, uvw;
  VMP::IO::read_MEDIT(options.source, source);
  VMP::IO::read_boundary_targets(options.target, source, targets);
  Progress progress{!options.is_quiet && rank() == 0 && isatty(STDERR_FILENO) != 0};
  result = CGAL::stretch_minimizing_volume_parameterization(source, targets, uvw,
    params::energy(Named_energy_3(options.energy))
      .use_volume_weights(options.use_volume_weights)
      .number_of_iterations(static_cast<std::size_t>(options.number_of_iterations))
      .visitor(progress));
  progress.finish();
  const Exit_code code = exit_code(result);
  if(code == SUCCESS)
  {
    if(!options.output.empty())
      VMP::IO::write_PVTU(options.output, source, uvw);
    if(!options.is_quiet && rank() == 0)
      print(result);
  }
  return code;
}

// The same, with what is thrown, in all processes, as a message of the result.
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

// A number of each process; rank 0 gets those of all.
JSON_object of_processes(const double x)
{
  int size;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  std::vector<double> all(size);
  MPI_Gather(&x, 1, MPI_DOUBLE, all.data(), 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  JSON_object result;
  for(int i = 0; i < size; ++i)
    result.add(std::to_string(i).c_str(), all[i]);
  return result;
}

void write_report(const std::string& filename, const Result& result, const Exit_code code)
{
  JSON_object report = json(result, code);
  report.add("processor_seconds_of_processes", of_processes(static_cast<double>(std::clock()) / CLOCKS_PER_SEC))
        .add("peak_memory_bytes_of_processes", of_processes(static_cast<double>(peak_memory_bytes())));
  if(rank() != 0)
    return;
  Output_file file(filename);
  file.stream() << report.text() << "\n";
  file.commit();
}

// Rank 0 speaks, and decides about the options.
Exit_code run(const int argc, char* argv[])
{
  std::string message;
  Options options;
  bool goes_on = false;
  try
  {
    goes_on = parse(argc, argv, options);
    if(goes_on)
      check(options);
  }
  catch(const std::exception& error)
  {
    message = error.what();
  }
  Result result;
  int code = !message.empty() ? BAD_INPUT : SUCCESS;
  MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
  if(code == SUCCESS && goes_on)
  {
    code = run_and_catch(options, result);
    if(code != SUCCESS || result.status != VMP::OK)
      message = result.message;
    if(!options.report.empty())
      write_report(options.report, result, static_cast<Exit_code>(code));
  }
  if(!message.empty() && rank() == 0)
    std::cerr << message << std::endl;
  return static_cast<Exit_code>(code);
}

int main(int argc, char* argv[])
{
  // PETSc's options, which have one dash, come last
  char** const end = argv + argc;
  char** const petsc = std::find_if(argv + 1, end, [](const char* a) { return a[0] == '-' && a[1] != '-'; });
  std::vector<char*> of_petsc = { argv[0] };
  of_petsc.insert(of_petsc.end(), petsc, end);
  int number = static_cast<int>(of_petsc.size());
  of_petsc.push_back(nullptr);
  char** petsc_begin = of_petsc.data();
  if(PetscInitialize(&number, &petsc_begin, nullptr, nullptr) != 0)
    return BAD_INPUT;
  if(rank() != 0)
    std::cout.setstate(std::ios::failbit);
  const Exit_code code = run(static_cast<int>(petsc - argv), argv);
  PetscFinalize();
  return code;
}
