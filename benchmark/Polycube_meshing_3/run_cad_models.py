#!/usr/bin/env python3
"""Meshes CAD models by Gmsh, maps them to a polycube, makes hexahedra, and counts the features that these keep.

run_cad_models.py DRIVER MODEL.step ... [--output PREFIX]

The models are for example those of HexMe (github.com/cgg-bern/hex-me-if-you-can). Tetrahedra have edges of a 25th of the diagonal
of the bounding box, and all curves of the model are marked edges. The spacing of hexahedra is a 40th of the diagonal. A line is
printed for each model: the numbers of tetrahedra and hexahedra, the minimal and mean scaled Jacobian, the corners, curves and
surfaces of the model that are kept, the seconds of processor time, and how the driver ended. A corner is kept if a vertex of the
hexahedra is near it, a curve if edges of quadrangles on the boundary are near all its points, and a surface if its curves are
kept and a quadrangle has its reference. Seams, which have one surface on both sides, do not count. Near is a tenth of the
spacing. The files that are written are read again, and the exit status
is 1 if a hexahedron in one of them is not positive all over it.
"""
import argparse
import itertools
import json
import math
import resource
import statistics
import subprocess
import tempfile
from collections import defaultdict
from pathlib import Path

from check_hexahedra import hexahedra_not_positive, read_cells, sections
from run_hexahedra import conclude, line
from run_random_bodies import QUADRANGLES, boundary, distance_to_segment

GEOMETRY = """SetFactory("OpenCASCADE");
v() = ShapeFromFile("{model}");
b() = BoundingBox Volume{{v()}};
Mesh.MeshSizeMax = Sqrt((b(3) - b(0))^2 + (b(4) - b(1))^2 + (b(5) - b(2))^2) / {number};
Mesh.SaveAll = 1;
"""
LARGEST_DISTANCE = 0.1  # of features that are kept, in spacings
LINE = [("case", "<16"), ("tetrahedra", ">7"), ("hexahedra", ">7"), ("minimum_scaled_jacobian", ">7.3f"),
        ("mean_scaled_jacobian", ">7.3f"), ("corners", ">9"), ("curves", ">9"), ("surfaces", ">9"), ("seconds", ">7.1f"),
        ("status", "")]
TITLES = ["case", "tets", "hexes", "min SJ", "mean SJ", "corners", "curves", "surfaces", "seconds", "status"]


def make_mesh(arguments, model, mesh):
    """Writes a mesh whose triangles and edges have the numbers of surfaces and curves as references, unless it is there."""
    if not mesh.exists():
        geometry = mesh.with_suffix(".geo")
        geometry.write_text(GEOMETRY.format(model=model.resolve(), number=arguments.tetrahedra))
        subprocess.run(["gmsh", "-3", geometry, "-o", mesh, "-v", "1", "-nt", "1"])
    return mesh.exists() and "Tetrahedra" in sections(mesh)


def read_points(of_file):
    return [[float(x) for x in row[:3]] for row in of_file["Vertices"]]


def diagonal_of(points):
    return math.dist([min(x) for x in zip(*points)], [max(x) for x in zip(*points)])


class Nearby:
    """Segments, each in the buckets that its box, enlarged by a distance, has points in."""
    def __init__(self, segments, distance):
        self.distance, self.size, self.buckets = distance, 8 * distance, defaultdict(list)
        for a, b in segments:
            ranges = [range(math.floor((min(x, y) - distance) / self.size), math.floor((max(x, y) + distance) / self.size) + 1)
                      for x, y in zip(a, b)]
            for bucket in itertools.product(*ranges):
                self.buckets[bucket].append((a, b))

    def has(self, p):
        around = self.buckets.get(tuple(math.floor(x / self.size) for x in p), [])
        return any(math.dist(p, a) <= self.distance if a == b else distance_to_segment(p, a, b) <= self.distance
                   for a, b in around)


def kept_features(source, hexahedra, distance):
    """For corners, curves and surfaces of the source: the number that the hexahedra keep, and the number of all."""
    of_source, of_hexahedra = sections(source), sections(hexahedra)
    points, vertices = read_points(of_source), read_points(of_hexahedra)
    quadrangles = boundary(read_cells(of_hexahedra["Hexahedra"], 8), QUADRANGLES)
    edges = {tuple(sorted((q[i - 1], q[i]))) for q in quadrangles for i in range(4)}
    near_edges = Nearby([(vertices[v], vertices[w]) for v, w in edges], distance)
    near_vertices = Nearby([(vertices[v], vertices[v]) for v in {v for q in quadrangles for v in q}], distance)

    curves, curves_of_vertex, curves_of_edge = defaultdict(list), defaultdict(list), {}
    for row in of_source["Edges"]:
        v, w = (int(x) - 1 for x in row[:2])
        curves[row[2]].append((points[v], points[w]))
        curves_of_edge[min(v, w), max(v, w)] = row[2]
        for end in (v, w):
            curves_of_vertex[end].append(row[2])
    corners = [v for v, around in curves_of_vertex.items() if len(around) != 2 or around[0] != around[1]]
    kept_curves = {curve for curve, parts in curves.items()
                   if all(near_edges.has([(x + y) / 2 for x, y in zip(a, b)]) and near_edges.has(a) and near_edges.has(b)
                          for a, b in parts)}
    curves_of_surface = defaultdict(set)
    for row in of_source["Triangles"]:
        triangle = sorted(int(x) - 1 for x in row[:3])
        curves_of_surface[row[3]].update(curves_of_edge[edge] for edge in itertools.combinations(triangle, 2)
                                         if edge in curves_of_edge)
    seams = {curve for curve in curves if sum(curve in around for around in curves_of_surface.values()) < 2}
    for seam in seams:
        del curves[seam]
    for around in curves_of_surface.values():
        around -= seams
    kept_curves -= seams
    references = {row[4] for row in of_hexahedra["Quadrilaterals"]}
    kept_surfaces = [surface for surface, around in curves_of_surface.items()
                     if surface in references and around <= kept_curves]
    return {"corners": (sum(near_vertices.has(points[v]) for v in corners), len(corners)),
            "curves": (len(kept_curves), len(curves)), "surfaces": (len(kept_surfaces), len(curves_of_surface))}


def run_model(arguments, model, folder):
    row = {"case": model.stem}
    mesh = folder / (model.stem + ".mesh")
    if not make_mesh(arguments, model, mesh):
        return {**row, "status": "no mesh by Gmsh"}
    output, report = (mesh.with_name(model.stem + ending) for ending in ("_hexahedra.mesh", ".json"))
    for file in (output, report):
        file.unlink(missing_ok=True)
    spacing = diagonal_of(read_points(sections(mesh))) / arguments.hexahedra
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    run = subprocess.run([arguments.driver, mesh, "--to", "polycube", "--refine", "--threads", "1", "--quiet",
                          "--time-limit", str(arguments.time_limit), "--hexahedra", str(spacing), output, "--report", report],
                         stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    row.update(exit_code=run.returncode, seconds=resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    said = json.loads(report.read_text()) if report.exists() else {}
    result = said.get("hexahedra") or {}
    row.update(tetrahedra=said.get("cells", 0), status=result.get("status") or said.get("status") or run.stderr.strip())
    if output.exists():
        row.update((key, result[key]) for key in ("minimum_scaled_jacobian", "mean_scaled_jacobian"))
        row["hexahedra"] = result["cells"]
        row["refuted_hexahedra"] = hexahedra_not_positive(output)
        row.update((kind, f"{kept}/{number}")
                   for kind, (kept, number) in kept_features(mesh, output, LARGEST_DISTANCE * spacing).items())
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="the program parameterize_mesh_file")
    parser.add_argument("models", type=Path, nargs="+", metavar="MODEL", help="a file that Gmsh reads, such as *.step")
    parser.add_argument("--tetrahedra", type=float, default=25, metavar="NUMBER", help="of edges along the diagonal")
    parser.add_argument("--hexahedra", type=float, default=40, metavar="NUMBER", help="of edges along the diagonal")
    parser.add_argument("--output", metavar="PREFIX", help="write PREFIX.csv and PREFIX.json")
    parser.add_argument("--meshes", metavar="FOLDER", help="keeps the meshes that are made, for the next time")
    parser.add_argument("--time-limit", type=float, default=100, metavar="SECONDS", help="of each model")
    arguments = parser.parse_args()

    rows = []
    print(" ".join(format(title, form.split(".")[0]) for title, (_, form) in zip(TITLES, LINE)))
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(arguments.meshes or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for model in arguments.models:
            rows.append(run_model(arguments, model, folder))
            print(line(rows[-1], LINE), flush=True)

    valid = [row for row in rows if row.get("refuted_hexahedra") == 0]
    print(f"valid: {len(valid)} of {len(rows)}")
    if valid:
        print("medians: minimal scaled Jacobian {:.3f}, seconds {:.1f}".format(
            *(statistics.median(row[key] for row in valid) for key in ("minimum_scaled_jacobian", "seconds"))))
    conclude(rows, arguments.output)


if __name__ == "__main__":
    main()
