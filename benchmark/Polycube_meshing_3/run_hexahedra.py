#!/usr/bin/env python3
"""Maps models of CGAL's data to a cube and a polycube, and makes hexahedra of the maps.

run_hexahedra.py PROGRAM MESHER DATA [--output PREFIX]

PROGRAM is map_to_hexahedra, MESHER is mesh_model, and DATA the folder data/meshes of CGAL. A line is printed for each
case: the numbers of tetrahedra and hexahedra, whether they have a layer of padding, the minimal and mean scaled
Jacobian, the part of the sharp edges within a tenth of the spacing of edges of hexahedra, the Hausdorff distance of the
surfaces in spacings, and the seconds for the map and for the hexahedra. The files that are written are read again, and the
exit status is 1 if a hexahedron in one of them is not positive all over it.
"""
import argparse
import itertools
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Volume_mesh_parameterization"))
from check_hexahedra import hexahedra_not_positive
from run_models import MECHANICAL, MECHANICAL_WITH_HANDLES, SMOOTH, make_mesh
from tables import write_csv, write_json

LINE = [("case", "<24"), ("tetrahedra", ">8"), ("hexahedra", ">8"), ("padding", ">4"),
        ("minimum_scaled_jacobian", ">9.4f"), ("mean_scaled_jacobian", ">7.4f"), ("sharp_edges", ">7.4f"),
        ("hausdorff_distance", ">9.3f"),
        ("seconds_map", ">7.2f"), ("seconds_hexahedra", ">7.2f"), ("status", "")]
TITLES = ["case", "tets", "hexes", "pad", "min SJ", "mean SJ", "sharp", "Hausdorff", "s map", "s hexes", "status"]


def domains_of(model):
    return ["cube"] * (model not in MECHANICAL_WITH_HANDLES) + ["polycube"]


def value(word):
    try:
        return float(word) if "." in word or "e-" in word else int(word)
    except ValueError:
        return word


def run_case(arguments, name, domain, number):
    row = {"case": f"{name.name}_{domain}_{number}"}
    output = name.with_name(row["case"] + "_hexahedra.mesh")
    output.unlink(missing_ok=True)
    command = [arguments.program, name.with_name(name.name + ".mesh"), domain, str(number), output]
    try:
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             timeout=arguments.time_limit)
    except subprocess.TimeoutExpired:
        return {**row, "status": "time limit"}
    said = dict(text.split(": ", 1) for text in run.stdout.splitlines() if ": " in text)
    row.update((key, value(word)) for key, word in said.items())
    row.setdefault("status", run.stdout.strip() or f"exit code {run.returncode}")
    if output.exists():
        row["refuted_hexahedra"] = hexahedra_not_positive(output)
    return row


def line(row, columns=LINE):
    return " ".join(format(row[key], form) if key in row else format("-", form.split(".")[0]) for key, form in columns)


def add_options(parser):
    parser.add_argument("--numbers", nargs="+", type=int, default=[10, 20], metavar="NUMBER",
                        help="of hexahedra along the longest side")
    parser.add_argument("--output", metavar="PREFIX", help="write PREFIX.csv and PREFIX.json")
    parser.add_argument("--meshes", metavar="FOLDER", help="keeps the meshes that are made, for the next time")


def conclude(rows, prefix):
    """Writes the rows, and exits."""
    refuted = sum(row.get("refuted_hexahedra", 0) for row in rows)
    print(f"hexahedra that are not positive in meshes that were written: {refuted}")
    if prefix:
        write_csv(prefix + ".csv", rows)
        write_json(prefix + ".json", rows)
    sys.exit(refuted > 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program map_to_hexahedra")
    parser.add_argument("mesher", help="the program mesh_model")
    parser.add_argument("data", type=Path, help="the folder with the surfaces")
    parser.add_argument("--models", nargs="+", default=SMOOTH + MECHANICAL + MECHANICAL_WITH_HANDLES, metavar="NAME")
    parser.add_argument("--domains", nargs="+", default=["cube", "polycube"], metavar="DOMAIN")
    parser.add_argument("--sizes", nargs="+", type=float, default=[0.05, 0.035, 0.025], metavar="SIZE",
                        help="of the tetrahedra, relative to the diagonal of the model")
    add_options(parser)
    parser.add_argument("--time-limit", type=float, default=120, metavar="SECONDS", help="of each mesh and each case")
    arguments = parser.parse_args()

    rows = []
    print(" ".join(format(title, form.split(".")[0]) for title, (_, form) in zip(TITLES, LINE)))
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(arguments.meshes or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for model, size in itertools.product(arguments.models, arguments.sizes):
            name = folder / f"{model}_{size:g}"
            make_mesh(arguments, model, size, name)
            for domain, number in itertools.product(domains_of(model), arguments.numbers):
                if domain in arguments.domains:
                    rows.append(run_case(arguments, name, domain, number))
                    print(line(rows[-1]), flush=True)

    for domain in arguments.domains:
        chosen = [row for row in rows if f"_{domain}_" in row["case"]]
        print(f"{domain}: {sum(row['status'] == 'OK' for row in chosen)} of {len(chosen)} OK")
    conclude(rows, arguments.output)


if __name__ == "__main__":
    main()
