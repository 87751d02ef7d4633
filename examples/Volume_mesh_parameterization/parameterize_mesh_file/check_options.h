// Finds faults in the options before anything expensive is done.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_OPTIONS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_OPTIONS_H

#include "Command_line.h"
#include "Hexahedra_file.h"
#include "Named_choices.h"
#include "Target_points.h"
#include "boundary_targets_of.h"
#include "check_roles.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

inline void check_number_of_threads(const Options& options)
{
  if(options.number_of_threads < 1)
    throw std::runtime_error("the number of threads is too small");
#ifndef CGAL_LINKED_WITH_TBB
  if(options.number_of_threads > 1)
    throw std::runtime_error("this program was built without TBB, it has only one thread");
#endif
  if(const std::size_t number = number_of_threads(options);
     static_cast<std::size_t>(options.number_of_threads) > number && !options.is_quiet)
    std::cerr << "note: " << number << " threads run in place of " << options.number_of_threads
              << ", as many as there are processors" << std::endl;
}

inline std::vector<std::string> without_empty(std::vector<std::string> names)
{
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  return names;
}

inline std::vector<std::string> inputs(const Options& options)
{
  return without_empty({ options.source, options.target, options.features, options.landmarks, options.conditions,
                         options.initial });
}

inline std::vector<std::string> outputs(const Options& options)
{
  return without_empty({ options.output, options.refined_source, options.report, Hexahedra_file(options.hexahedra).name() });
}

inline bool writes_to_standard_output(const Options& options)
{
  const std::vector<std::string> names = outputs(options);
  return std::any_of(names.begin(), names.end(), [](const std::string& name)
    { return name == "/dev/stdout" || name == "/dev/fd/1" || name == "/proc/self/fd/1"; });
}

inline void check_files(const Options& options)
{
  if(!options.output.empty() && !Output_file::is_stream(options.output) && !is_mesh_name(options.output))
    throw std::runtime_error(options.output + ": the name of the output ends neither with " + mesh_extensions + "; "
                             "other formats can be made of both: meshio convert map.vtu map.OTHER");
  check_roles(inputs(options), outputs(options));
}

inline void check(const Options& options)
{
  named_energy(options.energy);
  named_solver(options.solver);
  named_boundary_mode(options.boundary);
  named_refinement(options.refinement);
  if(!options.domain.empty())
    named_boundary_parameterizer(options.domain, Polycube(Hexahedra_file(options.hexahedra).spacing()));
  if(named_polycube_axes(options.polycube_axes) != CGAL::Volume_mesh_parameterization::Polycube_axes::FOUND
     && options.domain != "polycube")
    throw std::runtime_error("the axes are those of a polycube, and --to polycube is missing");
  if(!options.landmarks.empty() && (options.domain.empty() || options.domain == "polycube"))
    throw std::runtime_error("landmarks are for a ball or a box that --to names, a polycube has none");
  if(!options.hexahedra.empty() && options.domain == "ball")
    throw std::runtime_error("hexahedra fill a box or a polycube: --to cube, --to box=X,Y,Z or --to polycube in place of ball");
  if(!options.conditions.empty()
     && (!options.domain.empty() || options.do_improve || options.do_slide || options.others == "slide"))
    throw std::runtime_error("--conditions tells what vertices do, and is not for --to, --improve and those that slide");
  if(options.others == "free" && options.do_slide)
    throw std::runtime_error("vertices slide in the planes of a boundary that is not free: --conditions tells other planes");
  if(named_others(options.others) != Others::MISSING && options.target.empty() && options.conditions.empty())
    throw std::runtime_error("other vertices than those of TARGET are told by --others, which is missing");
  if(named_inside(options.inside) != Inside::AUTO && options.target.empty())
    throw std::runtime_error("vertices inside with a target are told by --inside, which is missing");
  if(options.are_displacements && options.target.empty())
    throw std::runtime_error("displacements are those of TARGET, which is missing");
  if(options.are_staircases && options.hexahedra.empty())
    throw std::runtime_error("--staircases is for hexahedra (--hexahedra)");
  if(options.do_improve && (!options.initial.empty() || !options.hexahedra.empty() || options.boundary == "soft"))
    throw std::runtime_error("--improve starts from SOURCE.mesh, keeps its boundary, and makes no hexahedra");
  if(options.number_of_iterations < 0)
    throw std::runtime_error("the number of iterations is too small");
  if(!(options.energy_tolerance >= 0))
    throw std::runtime_error("the tolerance of the energy is negative");
  if(!(options.maximum_angle_distortion > 2))
    throw std::runtime_error("the distortion of angles cannot be below 2");
  if(!(options.time_limit >= 0))
    throw std::runtime_error("the time limit is negative");
  check_number_of_threads(options);
  check_files(options);
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_OPTIONS_H
