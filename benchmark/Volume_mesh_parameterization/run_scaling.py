#!/usr/bin/env python3
"""Runs the driver on models of many sizes, and plots time and memory against the number of cells.

run_scaling.py DRIVER PREFIX [--volmap FOLDER] [--surfaces FILE.off ... --mesher mesh_model]
               [--grids N ... --generator grid_to_ball] [--comparison FILE.csv] ...

Writes PREFIX.csv, PREFIX.json and PREFIX.svg. A comparison file brings other programs onto the plot: a CSV
file with the columns program, cells, seconds_total, and perhaps model and peak_memory_bytes.
"""
import argparse
import csv
import itertools
import json
import platform
import subprocess
import sys
import tempfile
from pathlib import Path

from scaling_plot import fits, plot
from tables import write_csv, write_json
from volmap_cases import Case, find_cases

PHASES = ["numbering", "start", "untangling", "minimization", "check"]


def generated_case(command, folder, name, domain):
    """The case that a program writes, unless it is there already."""
    case = Case(name, folder / f"{name}.mesh", folder / f"{name}_{domain}.txt")
    if not case.target.exists():
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return case


def all_cases(arguments, folder):
    """Pairs of a family and a case; meshes are made when their turn comes."""
    for case in find_cases(arguments.volmap, None, arguments.filter):
        yield "VOLMAP", case
    for surface, size in itertools.product(arguments.surfaces, arguments.sizes):
        stem = Path(surface).stem
        name = f"{stem}_{size:g}"
        command = [arguments.mesher, surface, str(size), "smooth", folder / name, "twist"]
        yield stem, generated_case(command, folder, name, "twist")
    for n in arguments.grids:
        name = f"grid_{n}"
        yield "grid to ball", generated_case([arguments.generator, str(n), folder / name], folder, name, "ball")


def run(driver, family, case, threads, solver, options):
    """One row of the table."""
    row = {"program": f"{family}, {solver}, {threads} thread{'s' * (threads > 1)}", "model": case.name,
           "threads": threads, "solver": solver}
    with tempfile.TemporaryDirectory() as folder:
        report_file = Path(folder) / "report.json"
        command = [driver, case.source, case.target, "--quiet", "--report", report_file, "--threads", str(threads),
                   "--solver", solver, *options]
        row["exit_code"] = subprocess.run(command, stderr=subprocess.DEVNULL).returncode
        report = json.loads(report_file.read_text()) if report_file.exists() else {}
    row["cells"] = report.get("cells")
    row["steps"] = report.get("iterations")
    row["untangling_steps"] = report.get("untangling_iterations")
    for key in ["total", "to_flip_free", *PHASES]:
        row[f"seconds_{key}"] = report.get(f"seconds_{key}")
    row["peak_memory_bytes"] = report.get("peak_memory_bytes")
    row["energy"] = report.get("energy_value")
    row.update(report.get("distortion_at_source_volume", {}))
    return row


def read_comparison(filename):
    """The rows of other programs, with numbers instead of text."""
    with open(filename, newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for key in ("cells", "seconds_total", "peak_memory_bytes"):
            row[key] = float(row[key]) if row.get(key) else None
    return rows


def processor():
    """Its name, if the system has it."""
    cpuinfo = Path("/proc/cpuinfo")
    lines = cpuinfo.read_text().splitlines() if cpuinfo.exists() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.machine()


def line(row):
    if row["exit_code"] != 0:
        return f"{row['model']:<24} {row['program']:<32} exit code {row['exit_code']}"
    phases = " ".join(f"{phase} {row[f'seconds_{phase}']:.2f}" for phase in PHASES)
    return (f"{row['model']:<24} {row['program']:<32} {row['cells']:>9} cells {row['steps']:>4} steps"
            f" {row['seconds_total']:>8.2f} s ({phases}) {row['peak_memory_bytes'] / 2**20:>7.0f} MiB")


def main():
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="the program parameterize_mesh_file")
    parser.add_argument("prefix", help="of the files to write")
    parser.add_argument("--volmap", metavar="FOLDER", help="with MODEL.mesh and MODEL_DOMAIN.txt")
    parser.add_argument("--filter", default="", metavar="REGEX", help="choose among the cases of VOLMAP")
    parser.add_argument("--surfaces", nargs="+", default=[], metavar="FILE", help="closed surfaces to fill with cells")
    parser.add_argument("--sizes", nargs="+", type=float, default=[0.024, 0.015, 0.01, 0.007, 0.005], metavar="SIZE",
                        help="of their cells, relative to the diagonal of the model")
    parser.add_argument("--mesher", metavar="PROGRAM", help="the program mesh_model")
    parser.add_argument("--grids", nargs="+", type=int, default=[], metavar="N", help="grids of 6 N^3 cells")
    parser.add_argument("--generator", metavar="PROGRAM", help="the program grid_to_ball")
    parser.add_argument("--threads", nargs="+", type=int, default=[1], metavar="N")
    parser.add_argument("--solvers", nargs="+", default=["cg"], metavar="NAME")
    parser.add_argument("--comparison", metavar="FILE", help="a CSV file with the results of other programs")
    parser.add_argument("--meshes", metavar="FOLDER", help="keeps the meshes that are made, for the next time")
    arguments, options = parser.parse_known_args()
    if (arguments.surfaces and not arguments.mesher) or (arguments.grids and not arguments.generator):
        parser.error("--surfaces needs --mesher, and --grids needs --generator")

    rows = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(arguments.meshes or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for family, case in all_cases(arguments, folder):
            for solver, threads in itertools.product(arguments.solvers, arguments.threads):
                rows.append(run(arguments.driver, family, case, threads, solver, options))
                print(line(rows[-1]), flush=True)

    write_csv(arguments.prefix + ".csv", rows)
    solved = [row for row in rows if row["exit_code"] == 0]
    compared = solved + (read_comparison(arguments.comparison) if arguments.comparison else [])
    if not compared:
        sys.exit("there is nothing to plot")
    exponents = fits(compared)
    for fit in exponents:
        print(f"{fit['program']:<32} {fit['quantity']:<18} ~ cells^{fit['exponent']:.2f}")
    machine = {"processor": processor(), "system": platform.platform()}
    write_json(arguments.prefix + ".json", {"machine": machine, "options": options, "runs": rows, "fits": exponents})
    plot(compared, exponents, arguments.prefix + ".svg")


if __name__ == "__main__":
    main()
