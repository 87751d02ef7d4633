// Finds faults in the options before anything expensive is done.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_OPTIONS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_OPTIONS_H

#include "Command_line.h"
#include "Evaluated_points.h"
#include "Hexahedra_file.h"
#include "Named_choices.h"
#include "Target_points.h"
#include "boundary_targets_of.h"
#include "check_roles.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

inline void check_number_of_threads(const Options& options)
{
  refuse_if(options.number_of_threads < 1, "the number of threads must be positive");
#ifndef CGAL_LINKED_WITH_TBB
  refuse_if(options.number_of_threads > 1, "this program was built without TBB, and has only one thread");
#endif
  if(const std::size_t number = number_of_threads(options);
     static_cast<std::size_t>(options.number_of_threads) > number && !options.is_quiet)
    std::cerr << "note: " << number << " threads run instead of " << options.number_of_threads
              << ", because there are no more processors" << std::endl;
}

inline std::vector<std::string> without_empty(std::vector<std::string> names)
{
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  return names;
}

inline std::vector<std::string> inputs(const Options& options)
{
  return without_empty({ options.source, options.target, options.features, options.landmarks, options.conditions,
                         options.initial, is_surface_domain(options.domain) ? options.domain : "",
                         Evaluated_points(options.evaluated, false).input(),
                         Evaluated_points(options.evaluated_inverse, true).input() });
}

inline std::vector<std::string> outputs(const Options& options)
{
  return without_empty({ options.tetrahedra, options.output, options.refined_source, options.report,
                         Hexahedra_file(options.hexahedra).name(), Evaluated_points(options.evaluated, false).name(),
                         Evaluated_points(options.evaluated_inverse, true).name() });
}

inline bool writes_to_standard_output(const Options& options)
{
  const std::vector<std::string> names = outputs(options);
  return std::any_of(names.begin(), names.end(), [](const std::string& name)
    { return name == "/dev/stdout" || name == "/dev/fd/1" || name == "/proc/self/fd/1"; });
}

inline void check_cells(const Options& options)
{
  refuse_if(!(options.cell_size >= 0) || std::isinf(options.cell_size),
            "the size of cells (--cells) must be a finite number that is not negative");
  refuse_if((options.cell_size > 0 || !options.tetrahedra.empty()) && !is_body_name(options.source),
            "--cells and --tetrahedra need a source that is filled, with one of the extensions " + body_extensions());
  refuse_if(options.do_fill_voids && (!is_body_name(options.source) || extension_of(options.source) == ".geo"),
            "--fill-voids needs a source of a CAD program or a closed surface. A script of Gmsh fills voids itself");
  refuse_if(!(options.joining_distance >= 0) || std::isinf(options.joining_distance),
            "the distance of points (--merge-points) must be a finite number that is not negative");
  const bool has_points = !is_body_name(options.source) || format_of(options.source) == Mesh_format::SURFACE
                          || is_surface_domain(options.domain);
  refuse_if(options.joining_distance > 0 && !has_points,
            "--merge-points=DISTANCE needs a mesh or a surface, as SOURCE or with --to. Solids of a CAD program have no points to "
            "join");
  refuse_if(!options.tetrahedra.empty() && !Output_file::is_stream(options.tetrahedra) && !is_mesh_name(options.tetrahedra),
            options.tetrahedra + ": the name of the tetrahedra must end with " + mesh_extensions);
}

inline void check_files(const Options& options)
{
  refuse_if(!options.output.empty() && !Output_file::is_stream(options.output) && !is_mesh_name(options.output),
            options.output + ": the name of the output must end with " + mesh_extensions + ". Convert it to other formats by: "
            "meshio convert map.vtu map.OTHER");
  check_roles(inputs(options), outputs(options));
}

inline void check(const Options& options)
{
  named_energy(options.energy);
  named_solver(options.solver);
  named_boundary_mode(options.boundary);
  named_refinement(options.refinement);
  if(!options.domain.empty() && !is_surface_domain(options.domain))
    named_boundary_parameterizer(options.domain, Polycube(Hexahedra_file(options.hexahedra).spacing()));
  refuse_if(named_polycube_axes(options.polycube_axes) != PM::Polycube_axes::FOUND
            && options.domain != "polycube", "--polycube-axes needs --to polycube");
  refuse_if(!options.landmarks.empty() && (options.domain.empty() || options.domain == "polycube"),
            "--landmarks needs --to ball, --to cube, --to box=X,Y,Z or --to with a surface");
  refuse_if(!(options.tolerance > 0), "the tolerance of a fit (--tolerance) must be positive");
  refuse_if(std::isfinite(options.tolerance) && !is_surface_domain(options.domain), "--tolerance needs --to with a surface");
  refuse_if(std::isfinite(options.tolerance) && named_refinement(options.refinement).mode != VMP::Refinement_mode::BOUNDARY,
            "--tolerance splits edges of the boundary, which --refine=" + options.refinement + " excludes");
  refuse_if(!options.hexahedra.empty() && (options.domain == "ball" || is_surface_domain(options.domain)),
            "hexahedra need a box or a polycube: use --to cube, --to box=X,Y,Z or --to polycube instead of " + options.domain);
  refuse_if(!options.conditions.empty()
            && (!options.domain.empty() || options.do_improve || options.do_slide || options.others == "slide"),
            "--conditions excludes --to, --improve, --slide and --others slide");
  refuse_if(options.others == "free" && options.do_slide,
            "--slide excludes --others free; use --conditions for planes of a free boundary");
  refuse_if(named_others(options.others) != Others::MISSING && options.target.empty() && options.conditions.empty(),
            "--others needs TARGET or --conditions");
  refuse_if(named_inside(options.inside) != Inside::AUTO && options.target.empty(), "--inside needs TARGET");
  refuse_if(options.are_displacements && options.target.empty(), "--displacements needs TARGET");
  refuse_if(options.are_staircases && options.hexahedra.empty(), "--staircases needs --hexahedra");
  refuse_if(options.do_improve && (!options.initial.empty() || !options.hexahedra.empty() || options.boundary == "soft"),
            "--improve excludes --initial, --hexahedra and --boundary soft");
  refuse_if(!(options.maximum_angle_distortion > 2), "the bound of the distortion of angles must be larger than 2");
  refuse_if(options.minimize_maximum_angle_distortion && std::isfinite(options.maximum_angle_distortion),
            "--minimize-max-angle-distortion excludes --max-angle-distortion");
  options_of_both_programs::check_limits(options);
  check_number_of_threads(options);
  check_cells(options);
  check_files(options);
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_CHECK_OPTIONS_H
