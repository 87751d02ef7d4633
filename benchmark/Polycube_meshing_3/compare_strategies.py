#!/usr/bin/env python3
"""Tells which strategies of polycubes and hexahedra decide results, by switching them off one after the other.

compare_strategies.py FOLDER BODY.mesh ... [--number NUMBER] [--output PREFIX]

A copy of the project in FOLDER gets a switch at each strategy in the list below, and its driver is built. The project itself has
no switches. The driver maps the boundary of each body to a polycube, and again without each strategy that it came across. If the
images of the boundary differ then, or if the strategy is one of hexahedra, it makes hexahedra with and without it. A line is
printed for each strategy: how many bodies came across it, and which are lost, worse, as good or better without it; for the others,
nothing changes. A body is worse if its minimal scaled Jacobian is lower by 0.01 at least. If that is equal, the number of features
that are kept decides, and then the distance from the boundary. A strategy without which no body is lost or worse has no reason to stay.
"""
import argparse
import json
import os
import resource
import shutil
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Volume_mesh_parameterization"))
from check_hexahedra import read_points, sections
from run_cad_models import diagonal_of
from tables import write_csv, write_json

ROOT = Path(__file__).resolve().parents[2]
INTERNAL = Path("include/CGAL/Polycube_meshing_3/internal")
POLYCUBE = "Polycube"
HEXAHEDRA = "Hexahedra"
TOLERANCE = 0.01  # of scaled Jacobians, and of distances from the boundary in spacings

# Strategies, the file each one is in, a text that is there once, and the text with the switch.
STRATEGIES = {
    "bounding box": (POLYCUBE, "map_to_polycube_3_impl.h", '"bounding box", is_sphere', '"bounding box", is_sphere && is_on()'),
    "voxels": (POLYCUBE, "map_to_polycube_3_impl.h", '"voxels", is_connected && may_split',
               '"voxels", is_connected && may_split && is_on()'),
    "slopes": (POLYCUBE, "Search_for_polycube_3.h", "    int failures = 0;\n",
               "    int failures = is_on() ? 0 : maximum_number_of_failures;\n"),
    "giving faces away": (POLYCUBE, "Search_for_polycube_3.h", "= give_away_faces(m_mesh, map.flipped_faces(), costs, labels)",
                          "= (!map.flipped_faces().empty() && is_on() && give_away_faces(m_mesh, map.flipped_faces(), costs, "
                          "labels))"),
    "lengths": (POLYCUBE, "Polycube_map_3.h", "with_lengths_of_surface(const Budget& budget) const\n  {",
                "with_lengths_of_surface(const Budget& budget) const\n  {\n    if(!is_on())\n      return std::nullopt;"),
    "rounding of lengths": (POLYCUBE, "Polycube_lengths_3.h", "if(grid.spacing > 0)", "if(grid.spacing > 0 && is_on())"),
    "keeping corners": (POLYCUBE, "map_to_voxels_3.h", "face_of_piece))\n      break;", "face_of_piece) || !is_on())\n      break;"),
    "relaxing charts": (POLYCUBE, "Drawn_polycube_3.h", "&& has_changed;", "&& has_changed && is_on();"),
    "fewest folds": (POLYCUBE, "Placement_of_voxel_faces_3.h", "number < fewest)", "(number < fewest || !is_on()))"),
    "lines": (POLYCUBE, "Polycube_map_3.h", "!lines.are_empty(); )", "!lines.are_empty() && is_on(); )"),
    "straightening chains": (POLYCUBE, "repair_labels_3.h", "if(straighten_chains_3(", "if(is_on() && straighten_chains_3("),
    "opposite neighbors": (POLYCUBE, "Normal_labels_3.h", "&& avoid_opposite_neighbors(labels));",
                           "&& is_on() && avoid_opposite_neighbors(labels));"),
    "larger regions": (POLYCUBE, "Normal_labels_3.h", "else if(!relabel_regions(1,", "else if(!is_on() || !relabel_regions(1,"),
    "shift of planes": (POLYCUBE, "ordered_coordinates_3.h", "grid.may_move ? closest", "grid.may_move && is_on() ? closest"),
    "joining planes": (POLYCUBE, "Polycube_coordinates_3.h", "    join_equal_coordinates();\n",
                       "    if(is_on())\n      join_equal_coordinates();\n"),
    "enclosing holes": (POLYCUBE, "Polycube_coordinates_3.h", "while(enclose_holes()", "while((is_on() && enclose_holes())"),
    "edges of steps": (POLYCUBE, "Polycube_map_3.h", ".dot(direction) < least_cosine)",
                       ".dot(direction) < least_cosine && is_on())"),
    "more maps of voxels": (POLYCUBE, "map_to_voxels_3.h", "number_of_maps == maximum_number_of_maps ||",
                            "number_of_maps == maximum_number_of_maps || (number_of_maps > 0 && !is_on()) ||"),
    "shortest edges": (POLYCUBE, "map_to_voxels_3.h", "surface, best.status != OK, budget",
                       "surface, best.status != OK && is_on(), budget"),
    "other layers": (HEXAHEDRA, "find_hexahedra_3_impl.h", "is_at_least(best.result, poor_scaled_jacobian))",
                     "is_at_least(best.result, poor_scaled_jacobian) || (!best.mesh.cells.empty() && !is_on()))"),
    "leaving the surface": (HEXAHEDRA, "find_hexahedra_3_impl.h", "is_at_least(best.result, bad_scaled_jacobian)))",
                            "(is_at_least(best.result, bad_scaled_jacobian) || !is_on())))"),
    "leaving lines": (HEXAHEDRA, "Hexahedra_improvement_3.h", "m_hexahedra.leave_lines_and_interfaces(0)",
                      "is_on() && m_hexahedra.leave_lines_and_interfaces(0)"),
    "choice of layers": (HEXAHEDRA, "find_hexahedra_3_impl.h", "  result.layers = Layer_choice_3(result.in_body).layers();\n",
                         "  result.layers = Layer_choice_3(result.in_body).layers();\n  if(!is_on() && !result.layers.empty())\n"
                         "    result.layers = { all_faces_of_domain(result.in_domain) };\n"),
    "moving to corners": (HEXAHEDRA, "find_hexahedra_3_impl.h", "    move_to_corners_3(",
                          "    if(is_on())\n      move_to_corners_3("),
    "separation": (HEXAHEDRA, "find_hexahedra_3_impl.h", "  Subdomain_separation_3(",
                   "  if(is_on())\n    Subdomain_separation_3("),
    "keeping volumes": (HEXAHEDRA, "volumes_of_subdomains_3.h", "  constexpr double largest_loss",
                        "  if(!is_on())\n    return;\n  constexpr double largest_loss"),
    "staircases": (HEXAHEDRA, "find_hexahedra_3_impl.h", "  return is_better_as_staircases(",
                   "  return is_on() && is_better_as_staircases("),
    "pulling middles": (HEXAHEDRA, "Sliding_hexahedra_3.h", "        if(is_valid)\n          pull_middles_3(",
                        "        if(is_valid && is_on())\n          pull_middles_3("),
    "single corners": (HEXAHEDRA, "Hexahedra_improvement_3.h", "    m_hexahedra.smooth((std",
                       "    if(is_on())\n      m_hexahedra.smooth((std"),
    "far points": (HEXAHEDRA, "Hexahedra_improvement_3.h", "double weight = 1;\n",
                   "double weight = m_best.result.boundary_distance > sufficient_distance * m_best.edge && !is_on() ? 0 : 1;\n"
                   "    if(weight == 0)\n      return;\n"),
}
SWITCH = """
#include <cstdlib>
#include <fstream>
#include <string>
namespace CGAL::Polycube_meshing_3::internal {
inline bool is_on(const std::string& strategy)
{
  std::ofstream(std::getenv("STRATEGY_LOG"), std::ios::app) << "strategy " << strategy << std::endl;
  return strategy != std::getenv("STRATEGY_OFF");
}
}
"""
END_OF_POLYCUBE = "    return found.status;\n"
IMAGES = """    {
      std::ofstream log(std::getenv("STRATEGY_LOG"), std::ios::app);
      for(const internal::Mapped_boundary_3& boundary : boundaries)
      {
        log << "images " << boundary.splits.size() << ' ' << std::hexfloat;
        for(const auto& [x, y, z] : boundary.targets)
          log << x << ' ' << y << ' ' << z << ' ';
        log << std::endl;
      }
      if(std::getenv("STRATEGY_POLYCUBE"))
        std::exit(0);
    }
"""


def replace_once(file, text, replacement):
    content = file.read_text()
    if content.count(text) != 1:
        sys.exit(f"{file}: {content.count(text)} times instead of once: {text}")
    file.write_text(content.replace(text, replacement))


def build(folder):
    """Copies the project, adds the switches, and builds the driver."""
    tracked = subprocess.run(["git", "ls-files"], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True).stdout.split("\n")
    for name in filter(None, tracked):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, folder / name)
    replace_once(folder / INTERNAL / "basic.h", "\n#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_BASIC_H",
                 SWITCH + "\n#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_BASIC_H")
    for strategy, (part, name, text, replacement) in STRATEGIES.items():
        file, = (folder / INTERNAL / part).rglob(name)
        replace_once(file, text, replacement.replace("is_on()", f'is_on("{strategy}")'))
    replace_once(folder / INTERNAL.parent / "Polycube_boundary_parameterizer_3.h", END_OF_POLYCUBE, IMAGES + END_OF_POLYCUBE)
    build_folder = folder / "build"
    subprocess.run(["cmake", "-S", folder, "-B", build_folder, "-DCGAL_Volume_mesh_parameterization_TESTS=OFF"], check=True)
    subprocess.run(["cmake", "--build", build_folder, "--target", "parameterize_mesh_file"], check=True)
    return build_folder / "examples/Volume_mesh_parameterization/parameterize_mesh_file"


def run(arguments, driver, mesh, spacing, off="", only_polycube=False):
    """The strategies that the driver comes across, the images of the boundary, and the result."""
    log, report, output = (arguments.folder / name for name in ("strategies.log", "report.json", "hexahedra.mesh"))
    for file in (log, report, output):
        file.unlink(missing_ok=True)
    environment = {**os.environ, "STRATEGY_LOG": str(log), "STRATEGY_OFF": off}
    if only_polycube:
        environment["STRATEGY_POLYCUBE"] = "1"
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([driver, mesh, "--to", "polycube", "--refine", "--threads", "1", "--quiet", "--time-limit",
                    str(arguments.time_limit), "--hexahedra", str(spacing), output, "--report", report],
                   env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    lines = log.read_text().splitlines() if log.exists() else []
    said = json.loads(report.read_text()) if report.exists() else {}
    result = {"seconds": resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before}
    if output.exists():
        result.update((key, said["hexahedra"][key]) for key in ("cells", "minimum_scaled_jacobian", "mean_scaled_jacobian"))
        result["boundary_distance"] = said["hexahedra"]["boundary_distance"] / spacing
        features = said["hexahedra"]["features"]
        result["features"] = sum(features[kind + "_kept"] for kind in ("corners", "curves", "patches"))
    return ({text[9:] for text in lines if text.startswith("strategy ")},
            [text for text in lines if text.startswith("images ")], result)


def compared(before, after):
    """What the second result is: lost, worse, better, the same, or about as good."""
    keys = ("cells", "minimum_scaled_jacobian", "mean_scaled_jacobian", "boundary_distance", "features")
    if [before.get(key) for key in keys] == [after.get(key) for key in keys]:
        return "same"
    if "cells" not in after:
        return "lost"
    if "cells" not in before:
        return "better"
    for key, sign in (("minimum_scaled_jacobian", 1), ("features", 1), ("boundary_distance", -1)):
        difference = sign * (after[key] - before[key])
        if abs(difference) >= TOLERANCE:
            return "better" if difference > 0 else "worse"
    return "as good"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="for the copy of the project")
    parser.add_argument("bodies", type=Path, nargs="+", metavar="BODY", help="a tetrahedral mesh")
    parser.add_argument("--polycubes", action="store_true", help="leave out the strategies of hexahedra")
    parser.add_argument("--strategies", type=lambda text: set(text.split(",")), default=set(STRATEGIES), metavar="NAME,...",
                        help="the strategies that are switched off; all if left out")
    parser.add_argument("--number", type=float, default=40, help="of hexahedra along the diagonal of the bounding box")
    parser.add_argument("--output", metavar="PREFIX", help="write PREFIX.csv and PREFIX.json")
    parser.add_argument("--time-limit", type=float, default=600, metavar="SECONDS",
                        help="of each run; if it ends one, the result depends on the machine")
    parser.add_argument("--driver", type=Path, help="the driver with switches, if it has been built before")
    arguments = parser.parse_args()

    arguments.folder.mkdir(parents=True, exist_ok=True)
    driver = arguments.driver or build(arguments.folder)
    rows, ends = [], defaultdict(lambda: defaultdict(list))
    for body in arguments.bodies:
        spacing = diagonal_of([[float(x) for x in p] for p in read_points(sections(body)["Vertices"])]) / arguments.number
        strategies, images, _ = run(arguments, driver, body, spacing, only_polycube=True)
        strategies &= arguments.strategies
        others = sorted(strategy for strategy in strategies
                        if run(arguments, driver, body, spacing, strategy, True)[1] != images)
        for strategy in strategies.difference(others):
            ends[strategy]["same"].append(body.stem)
        result = {}
        if others or not arguments.polycubes:
            strategies, _, result = run(arguments, driver, body, spacing)
            others += sorted(strategy for strategy in strategies & arguments.strategies if STRATEGIES[strategy][0] == HEXAHEDRA)
        rows.append({"body": body.stem, "off": "", **result})
        print(rows[-1], flush=True)
        for strategy in others:
            other = run(arguments, driver, body, spacing, strategy)[2]
            end = compared(result, other)
            ends[strategy][end].append(body.stem)
            rows.append({"body": body.stem, "off": strategy, "end": end, **other})
            print(rows[-1], flush=True)
    print("strategy, bodies that came across it, lost, worse, as good, better without it")
    for strategy in STRATEGIES:
        number = sum(map(len, ends[strategy].values()))
        print(f"{strategy}: {number};", "; ".join(f"{end} {len(ends[strategy][end])} {' '.join(ends[strategy][end])}".strip()
                                                  for end in ("lost", "worse", "as good", "better")))
    if arguments.output:
        write_csv(arguments.output + ".csv", rows)
        write_json(arguments.output + ".json", rows)


if __name__ == "__main__":
    main()
