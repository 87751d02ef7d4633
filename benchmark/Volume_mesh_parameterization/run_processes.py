#!/usr/bin/env python3
"""Measures several processes against one, on a grid that goes to a ball, and predicts how the time grows with both.

run_processes.py DRIVER MPI_DRIVER COUNT_HALOS GRID_TO_BALL [--grid 55] [--repeat 3] [--report PREFIX]

Prints tables: times of parameterize_mesh_file with two threads and of parameterize_mesh_file_mpi with one and two
processes (medians of alternating runs); where the time goes; iterations of the linear solver with two preconditioners; and
what the model predicts for two processes and for weak scaling. The model is described in the manual, "Large Meshes".
"""
import argparse
import csv
import json
import math
import os
import re
import statistics
import subprocess
import tempfile
from pathlib import Path

from tables import write_json

MPIRUN = ["mpirun", "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1", "-n"]
GAMG = ["-pc_type", "gamg", "-mg_levels_pc_type", "pbjacobi"]
STAGES = ["start", "untangling", "minimization"]
HALO = ["VecScatterBegin", "VecScatterEnd"]
REDUCTIONS = ["VecTDot", "VecDot", "VecNorm"]


def events(filename):
    """Of PETSc's log: for each event, the largest count and the largest seconds of a process."""
    result = {}
    with open(filename, newline="") as file:
        for row in csv.DictReader(file):
            count, seconds = result.get(row["Event Name"], (0, 0.))
            result[row["Event Name"]] = (max(count, int(row["Count"])), max(seconds, float(row["Time"])))
    return result


def split(report, log):
    """Where the time of the stages went."""
    seconds = lambda names: sum(log.get(name, (0, 0.))[1] for name in names)
    stages = sum(report[f"seconds_{stage}"] for stage in STAGES)
    solver, halo = seconds(["KSPSolve"]), seconds(HALO)
    return {"total": report["seconds_total"], "stages": stages, "assembly": stages - solver, "halo": halo,
            "solver": solver - halo, "other": report["seconds_total"] - stages,
            "systems": log["KSPSolve"][0], "products": log["MatMult"][0],
            "reductions": sum(log.get(name, (0, 0.))[0] for name in REDUCTIONS)}


def start(arguments, case, folder, n, options=()):
    """A process, and what reads its results when it has ended."""
    folder.mkdir()
    command = [*MPIRUN, str(n), arguments.mpi_driver, *case, "--quiet", "--report", folder / "report.json",
               *options, "-ksp_converged_reason", "-log_view", f":{folder / 'log.csv'}:ascii_csv"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)

    def finish():
        output, _ = process.communicate()
        if process.returncode != 0:
            raise SystemExit(f"exit code {process.returncode} of {n} processes")
        result = split(json.loads((folder / "report.json").read_text()), events(folder / "log.csv"))
        result["iterations"] = sum(map(int, re.findall(r"iterations (\d+)", output)))
        return result
    return finish


def run_serial(arguments, case, folder):
    report = folder / "serial.json"
    subprocess.run([arguments.driver, *case, "--quiet", "--threads", "2", "--boundary", "fixed", "--report", report],
                   check=True)
    return {"total": json.loads(report.read_text())["seconds_total"]}


def median(runs):
    return {key: statistics.median(run[key] for run in runs) for key in runs[0]}


def halos(arguments, case):
    """Largest numbers of a part, by the number of parts."""
    output = subprocess.run([arguments.count_halos, case[0], *map(str, arguments.parts)], check=True,
                            stdout=subprocess.PIPE, text=True).stdout
    return {int(row["parts"]): {key: int(row[key]) for key in row} for row in csv.DictReader(output.splitlines())}


def messages(arguments, one, part, n):
    """Seconds for halos and sums: each product exchanges a halo of three doubles a vertex, each sum of n processes takes
    as many rounds as n has binary digits."""
    halo = part["largest_neighbors"] * arguments.latency + 24 * part["largest_halo"] / arguments.bandwidth
    return one["products"] * halo + one["reductions"] * math.ceil(math.log2(n)) * arguments.latency


def predict(arguments, one, part, n, growth=1.):
    """Seconds of the stages for n processes from those of one, which has all cells and vertices of `part`."""
    scaled = dict(one, products=growth * one["products"], reductions=growth * one["reductions"])
    return (one["assembly"] * part["largest_cells"] / part["cells"]
            + growth * one["solver"] * part["largest_vertices"] / part["vertices"] + messages(arguments, scaled, part, n))


def weak_scaling(arguments, one, parts):
    """Seconds for meshes with as many cells a process as one process had in the measurement. Halos grow with the surface
    of a part; the numbers of iterations with the cells along a diameter."""
    many = parts[max(parts)]
    n = many["parts"]
    vertices, cells = many["vertices"], many["cells"]
    surface = n**(2 / 3)  # surface of a part as large as the whole mesh, relative to that of a part here
    for number in arguments.weak:
        part = {"cells": cells, "vertices": vertices, "largest_neighbors": many["largest_neighbors"],
                "largest_vertices": many["largest_vertices"] * n,
                "largest_halo": many["largest_halo"] * surface,
                "largest_cells": cells + (many["largest_cells"] - cells / n) * surface}
        if number == 1:
            part.update(largest_neighbors=0, largest_halo=0, largest_cells=cells, largest_vertices=vertices)
        growth = min(number**(1 / 3), 2000 * one["systems"] / one["iterations"])
        yield number, number * cells, predict(arguments, one, part, number, growth), growth


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("driver", "mpi_driver", "count_halos", "grid_to_ball"):
        parser.add_argument(name)
    parser.add_argument("--grid", default="55", metavar="N", help="6 N^3 cells (55: 998,250)")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--parts", type=int, nargs="+", default=[2, 8, 16, 32, 64, 128, 256, 512, 1024])
    parser.add_argument("--weak", type=int, nargs="+", default=[1, 8, 64, 512, 1002], help="numbers of processes")
    # figures of one port of HDR InfiniBand and Open MPI, as published for Azure's HBv3; 120 processes of a node share the port
    parser.add_argument("--latency", type=float, default=1.2e-6, help="seconds")
    parser.add_argument("--bandwidth", type=float, default=24e9 / 120, help="bytes a second of each process")
    parser.add_argument("--report", metavar="PREFIX", help="write PREFIX.json")
    arguments = parser.parse_args()
    os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run([arguments.grid_to_ball, arguments.grid, folder / "grid"], check=True)
        case = [folder / "grid.mesh", folder / "grid_ball.txt"]
        serial, one, two = [], [], []
        for i in range(arguments.repeat):
            serial.append(run_serial(arguments, case, folder))
            one.append(start(arguments, case, folder / f"one_{i}", 1)())
            two.append(start(arguments, case, folder / f"two_{i}", 2)())
        at_once = [start(arguments, case, folder / f"at_once_{i}", 1) for i in range(2)]
        occupied = median([finish() for finish in at_once])
        gamg = start(arguments, case, folder / "gamg", 2, GAMG)()
        parts = halos(arguments, case)

    ratios = {n: statistics.median(r["total"] / s["total"] for r, s in zip(runs, serial))
              for n, runs in ((1, one), (2, two))}
    table = {"n = 1": median(one), "n = 2": median(two), "n = 1, two at once": occupied, "n = 2, GAMG": gamg}
    print(f"parameterize_mesh_file, two threads: {median(serial)['total']:.2f} s;"
          f" ratio n = 1: {ratios[1]:.2f}, n = 2: {ratios[2]:.2f}\n")
    columns = ["total", "assembly", "halo", "solver", "other", "systems", "iterations"]
    print("| seconds |", " | ".join(columns), "|\n|", "--- | " * (len(columns) + 1))
    for name, row in table.items():
        print(f"| {name} |", " | ".join(f"{row[key]:.2f}" if key in columns[:5] else f"{row[key]:.0f}"
                                       for key in columns), "|")
    predicted = predict(arguments, occupied, parts[2], 2)
    print(f"\nstages of n = 2: predicted {predicted:.2f} s, measured {table['n = 2']['stages']:.2f} s,"
          f" ratio {predicted / table['n = 2']['stages']:.2f}\n")
    print("| processes | cells | seconds of the stages | iterations relative to one process |\n| --- | --- | --- | --- |")
    weak = list(weak_scaling(arguments, occupied, parts))
    for n, cells, seconds, growth in weak:
        print(f"| {n} | {cells} | {seconds:.0f} | {growth:.1f} |")
    print("\n| parts | cells held | vertices | copied vertices | neighbors |\n| --- | --- | --- | --- | --- |")
    for n, part in parts.items():
        print(f"| {n} | {part['largest_cells']} | {part['largest_vertices']} | {part['largest_halo']} |"
              f" {part['largest_neighbors']} |")
    if arguments.report:
        write_json(arguments.report + ".json", {"serial": serial, "ratios": ratios, "runs": table, "parts": parts,
                                                "predicted": predicted, "weak": weak})


if __name__ == "__main__":
    main()
