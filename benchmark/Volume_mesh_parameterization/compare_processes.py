#!/usr/bin/env python3
"""Compares the maps of several processes with those of one program, and checks them in exact arithmetic.

compare_processes.py DRIVER MPI_DRIVER VOLMAP [--pairs FOLDER] [--filter REGEX] [--processes N ...] [options of both]

Prints for each case and number of processes: exit codes, relative difference of the energies, largest distance of
positions relative to the diagonal of the target, whether a second run gives the same bytes, and the verdict of
check_map.py. The exit status is 1 if a map is refuted or not repeated.
"""
import argparse
import json
import math
import os
import re
import shlex
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

from check_map import check, read_mesh
from volmap_cases import add_case_options, find_cases

MPIRUN = "mpirun --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 -n {n}"


def array(data, name):
    """An array of coordinates of a VTU file in the appended form."""
    begin = data.index(b"_", data.index(b"<AppendedData")) + 1
    begin += int(re.search(rb'Name="' + name + rb'"[^>]*offset="(\d+)"', data).group(1))
    size, = struct.unpack_from("<Q", data, begin)
    numbers = struct.unpack_from(f"<{size // 8}d", data, begin + 8)
    return list(zip(*[iter(numbers)] * 3))


def image_of_pieces(folder, n, points):
    """The image of each point of the source, from the pieces of all processes."""
    images = {}
    for rank in range(n):
        data = (folder / f"map_{rank}.vtu").read_bytes()
        images.update(zip(array(data, b"Points"), array(data, b"uvw")))
    return [images.get(p, p) for p in points]


def write_mesh(filename, points, cells):
    with open(filename, "w") as file:
        print("MeshVersionFormatted 2\nDimension 3\nVertices", len(points), sep="\n", file=file)
        file.writelines(f"{x!r} {y!r} {z!r} 0\n" for x, y, z in points)
        print("Tetrahedra", len(cells), sep="\n", file=file)
        file.writelines(" ".join(str(v + 1) for v in cell) + " 0\n" for cell in cells)


def run(command, case, folder, output, options):
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    words = [*shlex.split(command), case.source, case.target, "--quiet", "--report", report,
             "--output", folder / output, *options]
    code = subprocess.run(words, stderr=subprocess.DEVNULL).returncode
    return code, json.loads(report.read_text()) if report.exists() else {}


def compare(arguments, options, case, folder):
    """Whether all maps of the case are right."""
    code, serial = run(arguments.driver, case, folder, "map.mesh", options)
    source, image = read_mesh(case.source), read_mesh(folder / "map.mesh")
    diagonal = math.dist(*[[f(p[i] for p in image.points) for i in range(3)] for f in (min, max)])
    is_right = True
    for n in arguments.processes:
        outputs = []
        for _ in range(2):
            mpi_code, result = run(f"{MPIRUN.format(n=n)} {arguments.mpi_driver}", case, folder, "map.pvtu", options)
            outputs.append([(folder / f"map_{rank}.vtu").read_bytes() for rank in range(n)])
        points = image_of_pieces(folder, n, source.points)
        write_mesh(folder / "distributed.mesh", points, source.cells)
        verdict = check(case.source, case.target, case.source, folder / "distributed.mesh")
        is_refuted = verdict.fault != "" or verdict.inverted_cells != 0 or verdict.missed_vertices != 0
        energy = result["energy_value"] / serial["energy_value"] - 1
        distance = max(map(math.dist, points, image.points)) / diagonal
        counts = all(result[key] == serial[key] for key in ("vertices", "cells", "boundary_vertices", "inverted_cells"))
        print(f"{case.name:<20} n = {n}  exit codes {code} {mpi_code}  energy {energy:9.2e}  positions {distance:8.2e}"
              f"  steps {serial['iterations']} {result['iterations']}  counts {'equal' if counts else 'differ'}"
              f"  {'repeated' if outputs[0] == outputs[1] else 'NOT REPEATED'}"
              f"  {'REFUTED' if is_refuted else 'valid'}", flush=True)
        is_right = is_right and not is_refuted and counts and code == mpi_code and outputs[0] == outputs[1]
    return is_right


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="the program parameterize_mesh_file")
    parser.add_argument("mpi_driver", help="the program parameterize_mesh_file_mpi")
    add_case_options(parser)
    parser.add_argument("--processes", nargs="+", type=int, default=[1, 2, 3, 4], metavar="N")
    arguments, options = parser.parse_known_args()
    os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    are_right = []
    for case in find_cases(arguments.volmap, arguments.pairs, arguments.filter):
        with tempfile.TemporaryDirectory() as folder:
            are_right.append(compare(arguments, options, case, Path(folder)))
    sys.exit(not all(are_right))


if __name__ == "__main__":
    main()
