#!/usr/bin/env python3
"""Bends a part that is clamped at one end, made of hexahedra, by CalculiX, and compares with quadratic tetrahedra.

solve_cantilever.py DRIVER SOURCE.mesh SPACING [--ccx PROGRAM] [--tolerance RATIO]

DRIVER is parameterize_mesh_file: it maps the part to a polycube and writes hexahedra of that spacing as an input file. Of
the patches that are plane and normal to an axis, the two that are farthest from each other are the ends; a uniform
traction across the longest way between them bends the part. The same is done with the tetrahedra of the source, as
elements with nodes on their edges, whose ends are found by their coordinates. What must agree: the reaction with the
force, to 1e-6, and the mean deflection of the loaded end, the same for both, to the tolerance.
"""
import argparse
import itertools
import re
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

YOUNG, POISSON, FORCE = 210000, 0.3, 1000
NODES_OF_FACE = [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]  # S1 to S6


def read_inp(filename):
    """Points, elements, and for each patch its quadrangles."""
    points, elements, patches, section = {}, {}, defaultdict(list), ""
    for line in filename.read_text().splitlines():
        if line.startswith("*"):
            section = line
            continue
        words = [word.strip() for word in line.split(",")]
        if section.startswith("*NODE"):
            points[int(words[0])] = [float(x) for x in words[1:]]
        elif section.startswith("*ELEMENT"):
            elements[int(words[0])] = [int(v) for v in words[1:]]
        elif section.startswith("*SURFACE"):
            element = elements[int(words[0])]
            patches[section.split("NAME=")[1]].append([element[i] for i in NODES_OF_FACE[int(words[1][1:]) - 1]])
    return points, patches


def read_mesh(filename):
    words = filename.read_text().split()
    begin, cells = words.index("Vertices") + 2, words.index("Tetrahedra") + 2
    points = [[float(x) for x in words[i:i + 3]] for i in range(begin, begin + 4 * int(words[begin - 1]), 4)]
    return points, [[int(v) for v in words[i:i + 4]] for i in range(cells, cells + 5 * int(words[cells - 1]), 5)]


def box(points):
    return [(min(x), max(x)) for x in zip(*points)]


def ends(points, patches):
    """The patches at both ends, the axis between them, and their boxes."""
    width = max(high - low for low, high in box(points.values()))
    plane = defaultdict(list)
    for name, quadrangles in patches.items():
        patch = box([points[v] for quadrangle in quadrangles for v in quadrangle])
        for axis, (low, high) in enumerate(patch):
            if high - low < 1e-6 * width:
                plane[axis].append((low, name, patch))
    axis = max((axis for axis in plane if len(plane[axis]) > 1), key=lambda a: max(plane[a])[0] - min(plane[a])[0])
    return axis, min(plane[axis])[1:], max(plane[axis])[1:]


def area(*polygon):
    p = polygon[0]
    total = [0, 0, 0]
    for q, r in zip(polygon[1:], polygon[2:]):
        a, b = [[y - x for x, y in zip(p, s)] for s in (q, r)]
        total = [t + (a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2]) / 2 for i, t in enumerate(total)]
    return sum(t * t for t in total) ** 0.5


def shares(faces, points, loaded):
    """The parts of a uniform traction at the nodes of faces, of which `loaded` gives those that take an equal part."""
    result = Counter()
    for face in faces:
        for v in loaded(face):
            result[v] += area(*(points[v] for v in face)) / len(loaded(face))
    return {v: part / sum(result.values()) for v, part in result.items()}


def solve(ccx, folder, name, mesh, clamped, parts, direction):
    """The sum of reactions and the mean deflection, weighted as the force is, in the direction."""
    (folder / f"{name}.inp").write_text(mesh
        + "*NSET, NSET=CLAMPED\n" + "".join(f"{v},\n" for v in clamped)
        + "*NSET, NSET=LOADED\n" + "".join(f"{v},\n" for v in parts)
        + f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{YOUNG}, {POISSON}\n*SOLID SECTION, ELSET=EALL, MATERIAL=STEEL\n"
        + "*STEP\n*STATIC\n*BOUNDARY\nCLAMPED, 1, 3\n*CLOAD\n"
        + "".join(f"{v}, {direction + 1}, {part * FORCE:.12g}\n" for v, part in parts.items())
        + "*NODE PRINT, NSET=CLAMPED, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=LOADED\nU\n*END STEP\n")
    subprocess.run([ccx, name], cwd=folder, check=True, stdout=subprocess.PIPE)
    reaction, displacements = re.split("displacements", (folder / f"{name}.dat").read_text())
    rows = [line.split() for line in displacements.splitlines()]
    deflection = sum(parts[int(row[0])] * float(row[direction + 1]) for row in rows if len(row) == 4 and row[0].isdigit())
    forces = [line.split() for line in reaction.splitlines()]
    return float(next(row for row in forces if len(row) == 3)[direction]), deflection


def quadratic(points, cells):
    """An input file with a node on each edge, and these by their ends."""
    middles = {}
    for cell in cells:
        for edge in itertools.combinations(sorted(cell), 2):
            middles.setdefault(edge, len(points) + len(middles) + 1)
    text = "*NODE, NSET=NALL\n" + "".join(f"{v}, {x:.12g}, {y:.12g}, {z:.12g}\n" for v, (x, y, z) in enumerate(points, 1))
    for (v, w), middle in middles.items():
        p = [(x + y) / 2 for x, y in zip(points[v - 1], points[w - 1])]
        text += f"{middle}, {p[0]:.12g}, {p[1]:.12g}, {p[2]:.12g}\n"
    text += "*ELEMENT, TYPE=C3D10, ELSET=EALL\n"
    for i, c in enumerate(cells, 1):
        edges = [middles[tuple(sorted((c[a], c[b])))] for a, b in [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]]
        text += f"{i}, {', '.join(map(str, c + edges))}\n"
    return text, middles


def triangles_in(points, cells, box, width):
    facets = Counter(tuple(sorted(f)) for c in cells for f in itertools.combinations(c, 3))
    return [f for f, number in facets.items() if number == 1
            and all(low - 1e-6 * width <= points[v - 1][axis] <= high + 1e-6 * width
                    for v in f for axis, (low, high) in enumerate(box))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver")
    parser.add_argument("source", type=Path)
    parser.add_argument("spacing")
    parser.add_argument("--ccx", default="ccx", help="the program of CalculiX")
    parser.add_argument("--tolerance", type=float, default=0.15, help="of deflections, relative")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run([arguments.driver, arguments.source, "--to", "polycube", "--refine", "--quiet",
                        "--hexahedra", arguments.spacing, folder / "part.inp"], check=True)
        points, patches = read_inp(folder / "part.inp")
        axis, (clamped, clamped_box), (loaded, loaded_box) = ends(points, patches)
        direction = (axis + 1) % 3
        parts = shares(patches[loaded], points, lambda quadrangle: quadrangle)
        hexahedra = solve(arguments.ccx, folder, "hexahedra", "*INCLUDE, INPUT=part.inp\n",
                          {v for quadrangle in patches[clamped] for v in quadrangle}, parts, direction)

        nodes, cells = read_mesh(arguments.source)
        mesh, middles = quadratic(nodes, cells)
        width = max(high - low for low, high in box(nodes))
        on_edges = lambda triangle: [middles[edge] for edge in itertools.combinations(triangle, 2)]
        by_number = dict(enumerate(nodes, 1))
        parts = shares(triangles_in(nodes, cells, loaded_box, width), by_number, on_edges)
        clamped_nodes = {v for f in triangles_in(nodes, cells, clamped_box, width) for v in [*f, *on_edges(f)]}
        tetrahedra = solve(arguments.ccx, folder, "tetrahedra", mesh, clamped_nodes, parts, direction)

    print(f"clamped at {clamped}, loaded at {loaded}, in direction {'xyz'[direction]} by {FORCE}")
    for title, (reaction, deflection) in ("hexahedra", hexahedra), ("tetrahedra", tetrahedra):
        print(f"{title}: reaction {reaction:g}, deflection {deflection:g}")
    ratio = hexahedra[1] / tetrahedra[1]
    print(f"ratio of deflections: {ratio:g}")
    agree = abs(hexahedra[0] + FORCE) <= 1e-6 * FORCE and hexahedra[1] > 0 and abs(ratio - 1) <= arguments.tolerance
    sys.exit(0 if agree else "the solutions disagree")


if __name__ == "__main__":
    main()
