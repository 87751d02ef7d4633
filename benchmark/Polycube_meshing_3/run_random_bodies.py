#!/usr/bin/env python3
"""Makes hexahedra of random bodies of one to four materials, and checks them in exact arithmetic.

run_random_bodies.py DRIVER [--voxel-bodies N] [--cad-bodies N] [--seed SEED] [--output PREFIX]

Voxel bodies are unions of cubes that are sheared and jittered, CAD bodies are made and meshed by Gmsh. A line is printed for
each: the numbers of tetrahedra and hexahedra, the minimal scaled Jacobian, the largest distance of interfaces in spacings, the
largest distance of a boundary vertex of the hexahedra from the boundary of the body, relative to its diagonal, the same figures
with `--staircases`, the seconds, and how the driver ended. Each success is checked without the library. It is refuted by a
hexahedron that is not positive all over it, by a boundary vertex farther from the boundary than 1e-9 of the diagonal, and by
`--staircases`, if their worst scaled Jacobian and their interfaces are both better, and volumes of materials are kept as well.
The exit status is 1 then.
"""
import argparse
import itertools
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from check_hexahedra import read_cells, sections
from run_interfaces import GEOMETRY, run_case
from run_hexahedra import line
from tables import write_csv, write_json

LARGEST_DISTANCE = 1e-9  # of boundary vertices, relative to the diagonal
TOLERANCE = 1e-6  # of scaled Jacobians and of distances in spacings, in comparisons
TOLERANCE_OF_VOLUMES = 0.05  # relative; more of a material is not lost for better hexahedra
TRIANGLES = list(itertools.combinations(range(4), 3))
QUADRANGLES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (3, 7, 6, 2), (0, 4, 7, 3)]
LINE = [("case", "<16"), ("tetrahedra", ">6"), ("hexahedra", ">6"), ("minimum_scaled_jacobian", ">8.4f"),
        ("interface_distance", ">9.2g"), ("off_boundary", ">9.2g"), ("jacobian_of_staircases", ">8.4f"),
        ("distance_of_staircases", ">9.2g"), ("seconds", ">7.2f"), ("status", ""), ("refuted", "")]
TITLES = ["case", "tets", "hexes", "min SJ", "interface", "off", "min SJ_s", "interf_s", "s hexes", "status", "refuted"]


def is_manifold(voxels):
    """Whether the voxels around each vertex, and the others there, are joined by faces."""
    for corner in {tuple(x + d for x, d in zip(v, o)) for v in voxels for o in itertools.product((0, 1), repeat=3)}:
        around = [tuple(x - d for x, d in zip(corner, o)) for o in itertools.product((0, 1), repeat=3)]
        for part in ([v for v in around if v in voxels], [v for v in around if v not in voxels]):
            reached = part[:1]
            for v in reached:
                reached += [w for w in part if w not in reached and sum(map(abs, (x - y for x, y in zip(v, w)))) == 1]
            if len(reached) < len(part):
                return False
    return True


def random_voxels(number):
    voxels = {(0, 0, 0)}
    while len(voxels) < number:
        axis, step = random.randrange(3), random.choice((-1, 1))
        voxels.add(tuple(x + step * (k == axis) for k, x in enumerate(random.choice(sorted(voxels)))))
    return voxels if is_manifold(voxels) else random_voxels(number)


def voxel_body(name):
    """Writes a mesh of six tetrahedra for each voxel, and returns the edge of a voxel."""
    voxels = sorted(random_voxels(random.randint(2, 10)))
    materials = random.randint(1, 4)
    shear = [[(i == j) + random.choice((0, 0.3)) * random.uniform(-1, 1) for j in range(3)] for i in range(3)]
    jitter = random.choice((0, 0.02))
    numbers, cells = {}, []
    for voxel in voxels:
        material = random.randint(1, materials)
        for axes in itertools.permutations(range(3)):
            corner, cell = list(voxel), [voxel]
            for axis in axes:
                corner[axis] += 1
                cell.append(tuple(corner))
            if sum(a > b for a, b in itertools.combinations(axes, 2)) % 2 == 1:
                cell[:2] = cell[1::-1]
            cells.append([numbers.setdefault(v, len(numbers) + 1) for v in cell] + [material])
    points = [[sum(a * x for a, x in zip(row, v)) + random.uniform(-jitter, jitter) for row in shear] + [0] for v in numbers]
    with open(name, "w") as file:
        print("MeshVersionFormatted 2\nDimension 3", file=file)
        for keyword, rows in (("Vertices", points), ("Tetrahedra", cells)):
            print(keyword, len(rows), *(" ".join(map(repr, row)) for row in rows), sep="\n", file=file)
        print("End", file=file)
    return 1


def cad_body(name):
    """Lets Gmsh mesh a box, and a second body in it, added to it, or cut out of it; returns the edge of the box."""
    def uniform(low, high, number=3):
        return ", ".join(f"{random.uniform(low, high):.3f}" for _ in range(number))
    second = random.choice((f"Sphere(2) = {{{uniform(0.2, 1)}, {uniform(0.15, 0.35, 1)}}}; ",
                            f"Cylinder(2) = {{{uniform(0.2, 0.8)}, {uniform(-1, 1)}, {uniform(0.15, 0.3, 1)}}}; ",
                            f"Box(2) = {{{uniform(0, 0.6)}, {uniform(0.3, 0.9)}}}; "
                            f"Rotate {{{{{uniform(-1, 1)}}}, {{0.5, 0.5, 0.5}}, {uniform(0, 1, 1)}}} {{Volume{{2}};}} "))
    parts = random.choice((
        "a() = {1}; b() = BooleanIntersection {Volume{1};} {Volume{2}; Delete;};",
        "a() = BooleanUnion {Volume{1}; Delete;} {Volume{2}; Delete;}; b() = {};",
        "a() = BooleanDifference {Volume{1}; Delete;} {Volume{2}; Delete;}; b() = {};"))
    geometry = name.with_suffix(".geo")
    geometry.write_text(GEOMETRY.format(parts="Box(1) = {0, 0, 0, 1, 1, 1}; " + second + parts, edge=0.25))
    subprocess.run(["gmsh", "-3", geometry, "-o", name, "-v", "0"], timeout=60)
    return 1


def boundary(cells, faces):
    """The faces that one cell has, as tuples of vertices."""
    found = {}
    for cell in cells:
        for face in faces:
            vertices = tuple(cell[i] for i in face)
            found.setdefault(tuple(sorted(vertices)), []).append(vertices)
    return [those[0] for those in found.values() if len(those) == 1]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


def distance_to_segment(p, a, b):
    ab = minus(b, a)
    t = min(1, max(0, dot(minus(p, a), ab) / dot(ab, ab)))
    return math.dist(p, [x + t * y for x, y in zip(a, ab)])


def distance_to_triangle(p, triangle):
    a, b, c = triangle
    normal = cross(minus(b, a), minus(c, a))
    if all(dot(cross(minus(w, v), minus(p, v)), normal) >= 0 for v, w in ((a, b), (b, c), (c, a))):
        return abs(dot(minus(p, a), normal)) / math.sqrt(dot(normal, normal))
    return min(distance_to_segment(p, v, w) for v, w in ((a, b), (b, c), (c, a)))


def off_boundary(source, hexahedra):
    """The largest distance of a boundary vertex of hexahedra from the boundary of the source, relative to the diagonal."""
    of_source, of_hexahedra = sections(source), sections(hexahedra)
    points, vertices = ([[float(x) for x in row[:3]] for row in those["Vertices"]] for those in (of_source, of_hexahedra))
    triangles = [[points[v] for v in face] for face in
                 boundary(read_cells(of_source["Tetrahedra"], 4), TRIANGLES)]
    outer = {v for face in boundary(read_cells(of_hexahedra["Hexahedra"], 8), QUADRANGLES) for v in face}
    diagonal = math.dist([min(x) for x in zip(*points)], [max(x) for x in zip(*points)])
    boxes = [([min(x) for x in zip(*t)], [max(x) for x in zip(*t)]) for t in triangles]

    def distance(p):
        near = [t for t, (low, high) in zip(triangles, boxes)
                if all(a - 1e-6 * diagonal <= x <= b + 1e-6 * diagonal for a, x, b in zip(low, p, high))]
        return min(distance_to_triangle(p, t) for t in near or triangles)
    return max(distance(vertices[v]) for v in outer) / diagonal


def run_body(arguments, mesh, edge):
    """The row of a body: what the driver made of it, and what the checks say if it claims success."""
    number = random.choice((2, 3, 4))
    domain = random.choice(("polycube", "polycube", "cube"))
    options = ["--to", domain]
    row = run_case(arguments, mesh, edge, number, options)
    if row["exit_code"] != 0:
        return row
    hexahedra = mesh.with_name(row["case"] + "_hexahedra.mesh")
    row["off_boundary"] = off_boundary(mesh, hexahedra)
    faults = ["positive"] * (row["refuted_hexahedra"] > 0) + ["boundary"] * (row["off_boundary"] > LARGEST_DISTANCE)
    plain = run_case(arguments, mesh, edge, number, [*options, "--staircases"])
    if plain["exit_code"] == 0:
        row["jacobian_of_staircases"] = plain["minimum_scaled_jacobian"]
        row["distance_of_staircases"] = plain["interface_distance"]
        if (plain["minimum_scaled_jacobian"] > row["minimum_scaled_jacobian"] + TOLERANCE
                and plain["interface_distance"] < row["interface_distance"] - TOLERANCE
                and plain["volume_error"] < row["volume_error"] + TOLERANCE_OF_VOLUMES):
            faults.append("staircases")
    row["refuted"] = " ".join(faults)
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="the program parameterize_mesh_file")
    parser.add_argument("--voxel-bodies", type=int, default=500, metavar="N")
    parser.add_argument("--cad-bodies", type=int, default=50, metavar="N")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", metavar="PREFIX", help="write PREFIX.csv and PREFIX.json")
    parser.add_argument("--meshes", metavar="FOLDER", help="keeps the meshes that are made")
    parser.add_argument("--time-limit", type=float, default=60, metavar="SECONDS", help="of each run")
    arguments = parser.parse_args()

    rows = []
    print(" ".join(format(title, form.split(".")[0]) for title, (_, form) in zip(TITLES, LINE)))
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(arguments.meshes or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for kind, make, number in (("voxels", voxel_body, arguments.voxel_bodies), ("cad", cad_body, arguments.cad_bodies)):
            for i in range(number):
                random.seed(f"{kind} {arguments.seed} {i}")
                mesh = folder / f"{kind}_{i}.mesh"
                edge = make(mesh)
                if mesh.exists():
                    rows.append(run_body(arguments, mesh, edge))
                    print(line(rows[-1], LINE), flush=True)

    ends = [row["exit_code"] for row in rows]
    print(f"exit codes: {({code: ends.count(code) for code in sorted(set(ends))})}")
    refuted = [row["case"] for row in rows if row.get("refuted")]
    print(f"refuted: {len(refuted)}", *refuted)
    if arguments.output:
        write_csv(arguments.output + ".csv", rows)
        write_json(arguments.output + ".json", rows)
    sys.exit(bool(refuted))


if __name__ == "__main__":
    main()
