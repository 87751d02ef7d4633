#!/usr/bin/env python3
"""Meshes bodies of two materials by Gmsh, maps them to a polycube, and makes hexahedra that keep the interface.

run_interfaces.py DRIVER [--output PREFIX]

A line is printed for each case: the numbers of tetrahedra and hexahedra, the minimal and mean scaled Jacobian, the largest
distance between the interfaces of tetrahedra and of hexahedra in spacings, the largest relative error of a volume, and the
seconds. The files that are written are read again, and the exit status is 1 if a hexahedron in one of them is not positive all over it.
"""
import argparse
import itertools
import json
import subprocess
import tempfile
from pathlib import Path

from check_hexahedra import hexahedra_not_positive
from run_hexahedra import add_options, conclude, line

# The longest side of each body, and its two parts in the language of Gmsh: the body a(), and b(), which it is cut by.
CUBE = "Box(1) = {0, 0, 0, 1, 1, 1}; a() = {1}; "
BODIES = {
    "half_spaces": (1, CUBE + "Box(2) = {-1, -1, -1, 3, 3, 1.43}; Rotate {{0.3, 1, 0}, {0.5, 0.5, 0.43}, 0.35} {Volume{2};} "
                    "b() = BooleanIntersection {Volume{1};} {Volume{2}; Delete;};"),
    "layer": (1, CUBE + "Box(2) = {0, 0, 0.33, 1, 1, 0.28}; b() = {2};"),
    "slanted_layer": (5, "Box(1) = {0, 0, 0, 5, 3, 2}; a() = {1}; Box(2) = {-1, -1, 0.8, 7, 5, 0.4}; "
                      "Rotate {{0, 1, 0}, {2.5, 1.5, 1}, 0.15} {Volume{2};} "
                      "b() = BooleanIntersection {Volume{1};} {Volume{2}; Delete;};"),
    "box_inside": (1, CUBE + "Box(2) = {0.27, 0.3, 0.33, 0.41, 0.42, 0.37}; b() = {2};"),
    "turned_box_inside": (1, CUBE + "Box(2) = {0.27, 0.3, 0.33, 0.41, 0.42, 0.37}; "
                          "Rotate {{0.3, 1, 0.2}, {0.5, 0.5, 0.5}, 0.5} {Volume{2};} b() = {2};"),
    "ball_inside": (1, CUBE + "Sphere(2) = {0.5, 0.5, 0.5, 0.3}; b() = {2};"),
    "cylinder_inside": (1, CUBE + "Cylinder(2) = {0.5, 0.5, 0.2, 0, 0, 0.6, 0.3}; b() = {2};"),
    "fibre": (1, CUBE + "Cylinder(2) = {0.5, 0.5, 0, 0, 0, 1, 0.3}; b() = {2};"),
    "boxed_bracket": (8, "Box(1) = {-1, -1, -1, 8, 6, 7}; a() = {1}; Box(2) = {0, 0, 0, 6, 4, 1}; Box(3) = {0, 0, 0, 1, 4, 5}; "
                      "b() = BooleanUnion {Volume{2}; Delete;} {Volume{3}; Delete;};"),
    "boxed_gear": (10, "Box(1) = {-5, -5, -1.5, 10, 10, 4.5}; a() = {1}; Cylinder(2) = {0, 0, 0, 0, 0, 1.5, 3}; "
                   "\nFor i In {0 : 7}\n  Box(3 + i) = {2.8, -0.5, 0, 0.9, 1, 1.5}; "
                   "Rotate {{0, 0, 1}, {0, 0, 0}, i * Pi / 4} {Volume{3 + i};}\nEndFor\n"
                   "b() = BooleanUnion {Volume{2}; Delete;} {Volume{3 : 10}; Delete;};"),
}
# Each connected part is a material.
GEOMETRY = """SetFactory("OpenCASCADE");
{parts}
v() = BooleanFragments {{Volume{{a()}}; Delete;}} {{Volume{{b()}}; Delete;}};
For i In {{0 : #v() - 1}}
  Physical Volume(i + 1) = {{v(i)}};
EndFor
Mesh.MeshSizeMax = {edge};
Mesh.SaveElementTagType = 2;
"""
LINE = [("case", "<26"), ("tetrahedra", ">8"), ("hexahedra", ">8"), ("minimum_scaled_jacobian", ">7.3f"),
        ("mean_scaled_jacobian", ">7.3f"), ("interface_distance", ">9.2g"), ("volume_error", ">9.2g"),
        ("seconds", ">7.2f"), ("status", "")]
TITLES = ["case", "tets", "hexes", "min SJ", "mean SJ", "distance", "volume", "s hexes", "status"]


def make_mesh(body, size, name):
    """Writes NAME.mesh with edges of SIZE times the longest side, unless it is there."""
    mesh = name.with_name(name.name + ".mesh")
    if not mesh.exists():
        length, parts = BODIES[body]
        geometry = name.with_name(name.name + ".geo")
        geometry.write_text(GEOMETRY.format(parts=parts, edge=size * length))
        subprocess.run(["gmsh", "-3", geometry, "-o", mesh, "-v", "1"], check=True)
    return mesh


def run_case(arguments, mesh, length, number, options=("--to", "polycube")):
    """One row of the table; the hexahedra are in CASE_hexahedra.mesh beside the mesh."""
    row = {"case": f"{mesh.stem}_{number}"}
    output, report = (mesh.with_name(row["case"] + ending) for ending in ("_hexahedra.mesh", ".json"))
    for file in (output, report):
        file.unlink(missing_ok=True)
    spacing = length / number
    command = [arguments.driver, mesh, *options, "--refine", "--threads", "1", "--quiet",
               "--time-limit", str(arguments.time_limit), "--hexahedra", str(spacing), output, "--report", report]
    run = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    row["exit_code"] = run.returncode
    said = json.loads(report.read_text()) if report.exists() else {}
    result = said.get("hexahedra")
    if not result or result["interface_distance"] is None:
        return {**row, "status": run.stderr.strip() or said.get("status", f"exit code {run.returncode}")}
    row.update(tetrahedra=said["cells"], hexahedra=result["cells"], seconds=said["seconds_hexahedra"],
               interface_distance=result["interface_distance"] / spacing, status=result["status_code"])
    row.update((key, result[key]) for key in ("minimum_scaled_jacobian", "mean_scaled_jacobian"))
    volumes = zip(result["volumes_of_tetrahedra"], result["volumes_of_hexahedra"])
    row["volume_error"] = max(abs(after / before - 1) for before, after in volumes)
    if output.exists():
        row["refuted_hexahedra"] = hexahedra_not_positive(output)
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="the program parameterize_mesh_file")
    parser.add_argument("--bodies", nargs="+", choices=BODIES, default=list(BODIES), metavar="NAME")
    parser.add_argument("--sizes", nargs="+", type=float, default=[0.05], metavar="SIZE",
                        help="of the edges of tetrahedra, relative to the longest side")
    add_options(parser)
    parser.add_argument("--time-limit", type=float, default=120, metavar="SECONDS", help="of each case")
    arguments = parser.parse_args()

    rows = []
    print(" ".join(format(title, form.split(".")[0]) for title, (_, form) in zip(TITLES, LINE)))
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(arguments.meshes or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for body, size in itertools.product(arguments.bodies, arguments.sizes):
            mesh = make_mesh(body, size, folder / f"{body}_{size:g}")
            for number in arguments.numbers:
                rows.append(run_case(arguments, mesh, BODIES[body][0], number))
                print(line(rows[-1], LINE), flush=True)

    conclude(rows, arguments.output)


if __name__ == "__main__":
    main()
