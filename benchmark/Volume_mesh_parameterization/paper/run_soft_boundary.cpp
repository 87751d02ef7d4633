// Runs the method of the paper itself, the map with soft boundary, step by step:
//   run_soft_boundary SOURCE.mesh TARGET NAME [options]
// Writes the map NAME.mesh, and NAME.csv with the energies of distortion and positions and the squared
// norms of their gradients after each step; lengths are such that the target has volume 1.
#include "../../../examples/Volume_mesh_parameterization/parameterize_mesh_file/Named_choices.h"
#include "Map_problem.h"
#include "Plain_newton_map_3.h"

#include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Cell_packs_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Soft_boundary_search_3.h>

#include <CGAL/Timer.h>

#include <boost/program_options.hpp>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace po = boost::program_options;

struct Options
{
  std::string source, target, name, energy, start;
  std::size_t number_of_steps, shape_interval;
  bool is_plain;
  VMP::Soft_boundary_parameters parameters;
};

// The mean of an energy over the cells, and its gradient by all vertices.
class Mean_energy
{
public:
  Mean_energy(const Map_problem::Mesh& mesh, const VMP::internal::Cell_energy_3& energy)
    : m_number_of_cells(static_cast<double>(mesh.cells.size())),
      m_energy(energy),
      m_packs(mesh, { 1, scaled_inverse_sources(mesh, 1), cell_weights(mesh) }, all_vertices(mesh),
              sparsity_pattern_3(mesh, all_vertices(mesh)))
  {}

  double value(const Eigen::Matrix3Xd& u) const { return evaluate_energy(m_packs, m_energy, u).energy; }

  // In lengths for which the mesh has volume 1; in those of u, its cells have.
  double squared_gradient_norm(const Eigen::Matrix3Xd& u) const
  {
    CGAL::Volume_mesh_parameterization::internal::Matrix3Xd gradient;
    gradient.setZero(3, u.cols());
    add_energy_gradient(m_packs, m_energy, u, gradient);
    return std::pow(m_number_of_cells, 2. / 3) * gradient.squaredNorm();
  }

private:
  double m_number_of_cells;
  const VMP::internal::Cell_energy_3& m_energy;
  VMP::internal::Cell_packs_3 m_packs;
};

// The source that the options name; nothing if it is to be aligned.
VMP::internal::Search_start_3 start_of(const std::string& name, const Map_problem::Mesh& mesh)
{
  VMP::internal::Search_start_3 start;
  if(name == "aligned")
    return start;
  if(name != "source" && name != "turned")
    throw std::runtime_error("there is no start '" + name + "'");
  start.stage = VMP::internal::Search_start_3::Stage::SOFT_BOUNDARY;
  start.positions = mesh.source;
  if(name == "turned")
    for(int i = 0; i < 3; ++i)
      start.positions.row(i) = mesh.source.row((i + 1) % 3);
  return start;
}

bool parse(int argc, char* argv[], Options& options)
{
  VMP::Soft_boundary_parameters& parameters = options.parameters;
  po::options_description description("Options");
  description.add_options()
    ("help", "print this text")
    ("source", po::value(&options.source)->required())
    ("target", po::value(&options.target)->required())
    ("name", po::value(&options.name)->required())
    ("energy", po::value(&options.energy)->default_value("stretch"), "as in parameterize_mesh_file")
    ("weight", po::value(&parameters.weight)->default_value(1e8), "the weight of the positions")
    ("raises", po::value(&parameters.maximum_number_of_raises)->default_value(0), "how often it may be raised")
    ("relaxations", po::value(&parameters.maximum_number_of_relaxations)->default_value(5), "0: without relaxation")
    ("full-hessian", po::bool_switch(&parameters.use_full_hessian), "do not project the Hessian of a cell")
    ("shifted-newton", po::bool_switch(&options.is_plain),
     "the solver of [39] without relaxation: adds to the Hessian of the whole mesh where it is not positive definite")
    ("start", po::value(&options.start)->default_value("aligned"),
     "the source to begin with: aligned, or of the volume of the target and as it is (source) or turned by a third about the "
     "diagonal (turned)")
    ("steps", po::value(&options.number_of_steps)->default_value(500), "the maximal number of steps")
    ("shape-interval", po::value(&options.shape_interval)->default_value(0),
     "write NAME_STEP.mesh each time so many steps have been taken");
  po::positional_options_description positional;
  positional.add("source", 1).add("target", 1).add("name", 1);
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(description).positional(positional).run(), given);
  if(given.count("help") != 0)
    std::cout << "Usage: run_soft_boundary SOURCE.mesh TARGET NAME [options]\n" << description;
  else
    po::notify(given);
  parameters.do_snap = false;
  return given.count("help") == 0;
}

// Takes the steps of `map`, and writes the log, the shapes and the map.
template <typename Map>
void run(Map& map, const Options& options, const Map_problem& problem, const Mean_energy& mean_energy,
         CGAL::Timer& timer)
{
  std::ofstream log(options.name + ".csv");
  log.precision(std::numeric_limits<double>::max_digits10);
  log << "step,seconds,is_relaxing,weight,distance,step_length,"
         "distortion_energy,position_energy,distortion_gradient,position_gradient\n";
  while(true)
  {
    timer.stop(); // while the log is written
    const std::size_t step = map.last_step().iteration;
    const Eigen::Matrix3Xd u = map.positions();
    const double distance = map.residual(), weight = map.weight();
    log << step << "," << timer.time() << "," << map.is_relaxing() << "," << weight << "," << distance << ","
        << map.last_step().step_length << "," << mean_energy.value(u) << "," << weight * distance * distance << ","
        << mean_energy.squared_gradient_norm(u) << "," << std::pow(2 * weight * distance, 2)
        << std::endl; // the rows of a run that is ended remain
    if(options.shape_interval > 0 && step % options.shape_interval == 0)
      problem.write(options.name + "_" + std::to_string(step) + ".mesh", u);
    if(!map.is_running() || step >= options.number_of_steps)
      break;
    timer.start();
    map.step();
  }
  problem.write(options.name + ".mesh", map.positions());
  if(!log.flush())
    throw std::runtime_error(options.name + ".csv: the file cannot be written");
}

void run(const Options& options)
{
  const Map_problem problem(options.source, options.target);
  const VMP::Any_energy_3 energy = named_energy(options.energy);
  const VMP::internal::Cell_energy_3& cell_energy = cell_energy_3(energy);
  const Mean_energy mean_energy(problem.mesh(), cell_energy);
  CGAL::Timer timer; // of the processor
  timer.start();
  if(options.is_plain)
  {
    Plain_newton_map_3<VMP::Any_energy_3> map(problem.mesh(), energy, options.parameters.weight);
    run(map, options, problem, mean_energy, timer);
  }
  else
  {
    VMP::CHOLMOD_solver_traits_3 cholmod;
    VMP::internal::Linear_solver_of<VMP::CHOLMOD_solver_traits_3> solver(cholmod);
    VMP::internal::Soft_boundary_search_3 map(problem.mesh(), cell_energy, solver, options.parameters, {},
                                              start_of(options.start, problem.mesh()));
    run(map, options, problem, mean_energy, timer);
  }
}

int main(int argc, char* argv[])
{
  try
  {
    Options options;
    if(parse(argc, argv, options))
      run(options);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
