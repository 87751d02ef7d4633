#!/usr/bin/env python3
"""Meshes models of CGAL's data at several sizes, maps them to a ball, a cube and a polycube, and checks the maps.

run_models.py DRIVER MESHER DATA [--output PREFIX] [options that are passed to the driver]

MESHER is the program mesh_model, and DATA the folder data/meshes of CGAL. A line is printed for each case: the
model, the size of its cells relative to the diagonal, and the domain. Mechanical parts are meshed with their sharp
edges and also mapped to a polycube. Some models have handles, two components or a boundary that is not a
manifold: for these a ball and a cube must be refused. The exit status is 1 if a claim of the driver or a map of a
boundary was refuted.
"""
import argparse
import itertools
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from check_boundary import check_boundary
from driver_runs import line, print_summary, print_titles, run_case, summary, write_tables
from volmap_cases import Case

SMOOTH = ["armadillo", "bear", "blobby", "bull", "bunny00", "ellipsoid", "hand", "handle", "homer", "part", "retinal",
          "triceratops"]
MECHANICAL = ["corner", "cross", "dragknob", "fandisk", "spool", "tripod", "u"]
MECHANICAL_WITH_HANDLES = ["anchor", "joint", "pipe"]
SMOOTH_WITH_HANDLES = ["elephant", "eight", "knot1"]
OF_TWO_COMPONENTS = ["knot2"]
NOT_MANIFOLD = ["camel", "cow", "man"]  # the surfaces intersect themselves

NO_SPHERES = MECHANICAL_WITH_HANDLES + SMOOTH_WITH_HANDLES + OF_TWO_COMPONENTS + NOT_MANIFOLD
MODELS = SMOOTH + MECHANICAL + NO_SPHERES


def is_mechanical(model):
    return model in MECHANICAL + MECHANICAL_WITH_HANDLES


def kind_of(model):
    return "any" if model in NOT_MANIFOLD else "sharp" if is_mechanical(model) else "smooth"


def domains_of(model):
    return ["ball", "cube"] + ["polycube"] * is_mechanical(model)


def must_be_refused(row):
    return row["model"] in NO_SPHERES and row["domain"] != "polycube"


def make_mesh(arguments, model, size, name):
    """Writes NAME.mesh and the targets, unless they are there; what the program says about each domain."""
    log = name.with_name(name.name + ".log")
    if not log.exists():
        command = [arguments.mesher, arguments.data / f"{model}.off", str(size), kind_of(model), name,
                   *domains_of(model)]
        try:
            run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                 timeout=arguments.time_limit)
            log.write_text(run.stdout)
        except subprocess.TimeoutExpired:
            log.write_text("time limit\n")
    lines = log.read_text().splitlines()
    said = dict(text.split(": ", 1) for text in lines if ": " in text)
    return {domain: said.get(domain, "no mesh: " + " ".join(lines)) for domain in domains_of(model)}


def rows_of_mesh(arguments, options, folder, model, size):
    """A row for each domain."""
    name = folder / f"{model}_{size:g}"
    rows = []
    for domain, message in make_mesh(arguments, model, size, name).items():
        case = Case(f"{name.name}_{domain}", name.with_name(name.name + ".mesh"),
                    name.with_name(f"{name.name}_{domain}.txt"))
        row = {"case": case.name, "model": model, "size": size, "domain": domain}
        if case.target.exists():
            row.update(run_case(arguments.driver, case, options, arguments.time_limit),
                       boundary_faults=check_boundary(case.source, case.target, domain))
        else:
            row.update(status="no target", message=message)
        rows.append(row)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="the program parameterize_mesh_file")
    parser.add_argument("mesher", help="the program mesh_model")
    parser.add_argument("data", type=Path, help="the folder with the surfaces")
    parser.add_argument("--models", nargs="+", default=MODELS, metavar="NAME", help="some of the models")
    parser.add_argument("--sizes", nargs="+", type=float, default=[0.05, 0.035, 0.025], metavar="SIZE",
                        help="of the cells, relative to the diagonal of the model")
    parser.add_argument("--output", metavar="PREFIX", help="write PREFIX.csv and PREFIX.json")
    parser.add_argument("--meshes", metavar="FOLDER", help="keeps the meshes that are made, for the next time")
    parser.add_argument("--time-limit", type=float, default=60, metavar="SECONDS", help="of each mesh and each map")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="number of models at the same time")
    arguments, options = parser.parse_known_args()

    rows = []
    print_titles()
    with tempfile.TemporaryDirectory() as temporary, ThreadPoolExecutor(arguments.jobs) as pool:
        folder = Path(arguments.meshes or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        meshes = itertools.product(arguments.models, arguments.sizes)
        for some in pool.map(lambda mesh: rows_of_mesh(arguments, options, folder, *mesh), meshes):
            rows += some
            print(*map(line, some), sep="\n", flush=True)

    refusals = [row for row in rows if must_be_refused(row)]
    result = summary([row for row in rows if not must_be_refused(row)])
    result["refused"] = sum(row["status"] == "no target" for row in refusals)
    result["boundary_faults"] = sum(row.get("boundary_faults", 0) for row in rows)
    print_summary(result)
    print(f"refused as they must be: {result['refused']} of {len(refusals)}")
    print(f"flipped or flat triangles in maps of boundaries: {result['boundary_faults']}")
    if arguments.output:
        write_tables(arguments.output, options, result, rows)
    sys.exit(result["refuted"] > 0 or result["boundary_faults"] > 0)


if __name__ == "__main__":
    main()
