// Runs a method that the paper compares with:
//   run_baseline METHOD SOURCE.mesh TARGET NAME [K]
// METHOD is
// - dirichlet or arap: these energies without a barrier, where all cells count alike, as in the paper,
// - dirichlet_by_volume or arap_by_volume: the same where cells count by their volume,
// - injective or injective_dirichlet: locally injective mapping of the ARAP or the Dirichlet energy,
// - bounded: bounded distortion mapping with the bound K.
// Writes the map NAME.mesh, and NAME.csv with a row for each step.
#include "As_rigid_as_possible_map_3.h"
#include "Bounded_distortion_map_3.h"
#include "Jacobian_system_3.h"
#include "Locally_injective_map_3.h"
#include "Map_problem.h"

#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>

#include <CGAL/Timer.h>

#include <Eigen/Dense>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;

// Calls `row`, which writes the rest of a row, after each step; returns the map.
template <typename Method, typename Row>
Eigen::Matrix3Xd run(Method& method, const int maximum_number_of_steps, std::ostream& log,
                     const CGAL::Timer& timer, const Row& row)
{
  for(int i = 0; i < maximum_number_of_steps && method.is_running(); ++i)
  {
    method.step();
    log << i + 1 << "," << timer.time() << ",";
    row();
    log << std::endl; // the rows of a run that is ended remain
  }
  return method.positions();
}

// Locally injective mapping of an energy, with its barrier.
template <typename Energy>
Eigen::Matrix3Xd run_injective(const Map_problem::Mesh& mesh, std::ostream& log, const CGAL::Timer& timer)
{
  log << "step,seconds,energy,distance,weight,shift,step_length\n";
  Locally_injective_map_3<VMP::Barrier_energy_3<Energy> > map(mesh);
  return run(map, 200, log, timer, [&]()
  {
    log << map.newton().energy() << "," << map.newton().distance() << "," << map.weight() << ","
        << map.newton().shift() << "," << map.newton().step_length();
  });
}

Eigen::Matrix3Xd run(const std::string& method, const Map_problem& problem, const double K, std::ostream& log)
{
  CGAL::Timer timer; // of the processor
  timer.start();
  log.precision(std::numeric_limits<double>::max_digits10);
  Map_problem::Mesh mesh = problem.mesh();
  mesh.has_volume_weights = method == "dirichlet_by_volume" || method == "arap_by_volume" || method == "bounded";
  if(method == "dirichlet" || method == "dirichlet_by_volume")
  {
    const Jacobian_system_3 system(mesh);
    const Eigen::Matrix3Xd u = system.fit(Eigen::Matrix3Xd::Zero(3, 3 * static_cast<Eigen::Index>(mesh.cells.size())));
    log << "step,seconds,energy\n1," << timer.time() << "," << system.jacobians(u).squaredNorm() << "\n";
    return u;
  }
  if(method == "arap" || method == "arap_by_volume")
  {
    log << "step,seconds,energy\n";
    As_rigid_as_possible_map_3 map(mesh);
    return run(map, 1000, log, timer, [&]() { log << map.energy(); });
  }
  if(method == "injective")
    return run_injective<VMP::ARAP_energy_3>(mesh, log, timer);
  if(method == "injective_dirichlet")
    return run_injective<VMP::Dirichlet_energy_3>(mesh, log, timer);
  if(method == "bounded")
  {
    log << "step,seconds,distance,violating_cells\n";
    Bounded_distortion_map_3 map(mesh, K);
    return run(map, 1000, log, timer, [&]() { log << map.distance() << "," << map.number_of_violating_cells(); });
  }
  throw std::runtime_error("there is no method '" + method + "'");
}

int main(int argc, char* argv[])
{
  try
  {
    if(argc < 5)
      throw std::runtime_error("usage: run_baseline METHOD SOURCE.mesh TARGET NAME [K]");
    const Map_problem problem(argv[2], argv[3]);
    const std::string name = argv[4];
    std::ofstream log(name + ".csv");
    problem.write(name + ".mesh", run(argv[1], problem, argc > 5 ? std::atof(argv[5]) : 20, log));
    if(!log.flush())
      throw std::runtime_error(name + ".csv: the file cannot be written");
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
