#!/usr/bin/env python3
"""Fits each of ten bodies of CGAL's data to the surfaces of the nine others.

run_fits.py DRIVER MESHER DATA [--size 0.05] [--originals] [--output FILE.csv] [options that are passed to the driver]

MESHER is the program mesh_model, and DATA the folder data/meshes of CGAL. Bodies are filled with cells of SIZE times the
diagonal. The targets are the boundaries of the other bodies, which are meshed for themselves; with --originals, the surfaces of
DATA. Each pair is mapped twice: with the boundary fixed, and sliding. A line has the distortion before and after sliding, the
distances of both surfaces relative to the diagonal of the target, and the times, also that of the map of the body to a ball.
"""
import argparse
import csv
import itertools
import json
import math
import subprocess
import tempfile
from pathlib import Path

from run_models import SMOOTH

MODELS = [model for model in SMOOTH if model not in ("ellipsoid", "part")]  # ten with limbs or bumps
COLUMNS = ["body", "target", "status", "added", "turned", "intersections", "to_surface", "from_surface", "angle_before",
           "angle_after", "volume_before", "volume_after", "energy_before", "energy_after", "seconds_fixed", "seconds_slid",
           "seconds_ball", "message"]


def sections(mesh):
    """The points and the cells of a mesh of MEDIT, counted from 0."""
    words = iter(mesh.read_text().split())
    points, cells = [], []
    for word in words:
        if word == "Vertices":
            points = [[float(next(words)) for _ in range(4)][:3] for _ in range(int(next(words)))]
        elif word == "Tetrahedra":
            cells = [[int(next(words)) - 1 for _ in range(5)][:4] for _ in range(int(next(words)))]
    return points, cells


def write_boundary(mesh, surface):
    """Writes the facets of one cell only, counterclockwise as seen from outside."""
    points, cells = sections(mesh)
    facets = {}
    for a, b, c, d in cells:
        for facet in ((b, c, d), (a, d, c), (a, b, d), (a, c, b)):
            key = tuple(sorted(facet))
            facets[key] = None if key in facets else facet
    boundary = [facet for facet in facets.values() if facet]
    number = {v: i for i, v in enumerate(sorted({v for facet in boundary for v in facet}))}
    lines = [f"OFF\n{len(number)} {len(boundary)} 0"] + [" ".join(map(repr, points[v])) for v in number]
    surface.write_text("\n".join(lines + ["3 " + " ".join(str(number[v]) for v in facet) for facet in boundary]) + "\n")


def diagonal(surface):
    words = surface.read_text().split()
    number = int(words[1])
    points = list(zip(*[iter(map(float, words[4:4 + 3 * number]))] * 3))
    return math.dist([min(x) for x in zip(*points)], [max(x) for x in zip(*points)])


def run_driver(arguments, options, *command):
    """The report, and why there is no map."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        try:
            subprocess.run([arguments.driver, *command, "--quiet", "--report", report, *options], stderr=subprocess.DEVNULL,
                           timeout=arguments.time_limit)
        except subprocess.TimeoutExpired:
            return {"status": "time limit"}
        return json.loads(report.read_text()) if report.exists() else {"status": "crash"}


def row_of(arguments, options, body, target, surface, ball):
    fixed, slid = (run_driver(arguments, options, f"{body}.mesh", "--to", surface, *way) for way in ([], ["--slide"]))
    row = {"body": body.name, "target": target, "added": fixed.get("added_vertices"), "message": slid["status"],
           "seconds_fixed": fixed.get("seconds_total"), "seconds_slid": slid.get("seconds_total"),
           "seconds_ball": ball.get("seconds_total")}
    fit = slid.get("surface_fit")
    if fit and "surface_fit" in fixed:
        size = diagonal(surface)
        row.update(turned=fit["turned_facets"], intersections=fit["intersections"], to_surface=fit["distance_to_surface"] / size,
                   from_surface=fit["distance_from_surface"] / size)
        for when, report in (("before", fixed), ("after", slid)):
            row[f"angle_{when}"] = report["distortion"]["angle_mean"]
            row[f"volume_{when}"] = report["distortion_at_source_volume"]["volume_mean"]
            row[f"energy_{when}"] = report["energy_value"]
    is_fitted = fit and fixed.get("boundary_residual") == 0 and slid["inverted_cells"] == 0 and row["to_surface"] <= 1e-12
    row["status"] = "no map" if not is_fitted else "turned" if row["turned"] else "fitted"
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", type=Path)
    parser.add_argument("mesher", type=Path)
    parser.add_argument("data", type=Path)
    parser.add_argument("--size", type=float, default=0.05)
    parser.add_argument("--originals", action="store_true")
    parser.add_argument("--output", type=Path)
    parser.add_argument("--time-limit", type=float, default=120)
    arguments, options = parser.parse_known_args()
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        balls = {}
        for model in MODELS:
            subprocess.run([arguments.mesher, arguments.data / f"{model}.off", str(arguments.size), "smooth", folder / model,
                            "ball"], stdout=subprocess.DEVNULL, check=True)
            write_boundary(folder / f"{model}.mesh", folder / f"{model}.off")
            balls[model] = run_driver(arguments, options, folder / f"{model}.mesh", "--to", "ball")
        for body, target in itertools.permutations(MODELS, 2):
            surface = (arguments.data if arguments.originals else folder) / f"{target}.off"
            rows.append(row_of(arguments, options, folder / body, target, surface, balls[body]))
            print("  ".join(f"{value:.4g}" if isinstance(value, float) else str(value)
                            for value in (rows[-1].get(column, "-") for column in COLUMNS)), flush=True)
    print(sum(row["status"] == "fitted" for row in rows), "of", len(rows), "are fitted")
    ratios = sorted(row["seconds_fixed"] / row["seconds_ball"] for row in rows if row["status"] == "fitted")
    if ratios:
        print(f"time over that of the map to a ball: median {ratios[len(ratios) // 2]:.2f}, largest {ratios[-1]:.2f}")
    if arguments.output:
        with arguments.output.open("w", newline="") as file:
            writer = csv.DictWriter(file, COLUMNS)
            writer.writeheader()
            writer.writerows(rows)


if __name__ == "__main__":
    main()
