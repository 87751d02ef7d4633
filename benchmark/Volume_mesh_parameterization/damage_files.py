#!/usr/bin/python3
"""Damages files of meshes in all formats that the driver reads, and reports how it ends on each.

damage_files.py DRIVER [--number N] [--first I] [--formats NAME...] [--keep FOLDER]

The driver must end by itself, either with exit status 0 and a mesh without flat cells, or with a sentence that names the file.
Files on which it does not are kept in FOLDER, and the exit status is then 1. A file has the same damage in each run.
Needs Gmsh, the Debian package python3-meshio, and a driver that was built with Gmsh and VTK.
"""
import argparse
import random
import re
import struct
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import meshio
import numpy

from check_map import orientation, read_mesh

BODY = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Physical Volume("bone", 3) = {1};
Physical Surface("all", 4) = {1 : 6};
Mesh.MeshSizeFactor = 4;
"""
GMSH = {"41.msh": ["msh41"], "41_binary.msh": ["msh41", "-bin"], "22.msh": ["msh22"], "22_binary.msh": ["msh22", "-bin"],
        "nodes.unv": ["unv"], "nodes.bdf": ["bdf"]}
MESHIO = {"text.vtk": {"file_format": "vtk42", "binary": False}, "binary.vtk": {"file_format": "vtk42"},
          "new_binary.vtk": {"file_format": "vtk"}, "text.mesh": {}, "binary.meshb": {}, "text.vtu": {"binary": False},
          "base64.vtu": {"compression": None}, "zlib.vtu": {}}
NUMBERS = ["-1", "0", "1", "7", "2147483648", "-2147483649", "100000000000", "9223372036854775807", "nan", "1e308", "x"]
NUMBER = re.compile(rb"(?<![\w.])[-+]?\d+(?:\.\d*)?(?:[eEdD][-+]?\d+)?(?![\w.])")
SECONDS = 100  # after which a run hangs; the driver ends by itself before


def write_files(driver, folder):
    """A file of each format, of which the names are returned."""
    (folder / "body.geo").write_text(BODY)
    for name, (form, *options) in GMSH.items():
        subprocess.run(["gmsh", "-3", "-format", form, *options, "-o", name, "body.geo"], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL)
    mesh = meshio.read(folder / "22.msh")
    cells = mesh.cells_dict["tetra"]
    mesh = meshio.Mesh(mesh.points, [("triangle", mesh.cells_dict["triangle"]), ("tetra", cells)])
    mesh.point_data["T"] = mesh.points[:, 0]
    mesh.cell_data["material"] = [numpy.full(len(block.data), 4) for block in mesh.cells]
    for name, options in MESHIO.items():
        meshio.write(folder / name, mesh, **options)
    subprocess.run([driver, "22.msh", "--improve", "--quiet", "-o", "appended.vtu"], cwd=folder, check=True)
    return [*GMSH, *MESHIO, "appended.vtu"]


def other_number(random_, text):
    """A text with one of its numbers replaced, which keeps the width of its column if it can."""
    matches = list(NUMBER.finditer(text))
    if not matches:
        return text
    match = random_.choice(matches)
    return text[:match.start()] + random_.choice(NUMBERS).encode().rjust(len(match.group())) + text[match.end():]


def other_bytes(random_, text):
    """A text with some bytes replaced: by any, or by a number of a binary file."""
    values = [bytes([random_.randrange(256)]), bytes([text[random_.randrange(len(text))]])]
    values += [struct.pack("<i", n) for n in (-1, 0, 1, 99, 2**31 - 1)]
    values += [struct.pack("<q", n) for n in (-1, 0, 10**11, 2**63 - 1)]
    values += [struct.pack("<d", x) for x in (float("nan"), 1e308, -1.)]
    value = random_.choice(values)
    begin = random_.randrange(len(text))
    return text[:begin] + value + text[begin + len(value):]


def other_lines(random_, text):
    """A text with a line, or some bytes of a binary file, deleted, doubled or exchanged."""
    size = random_.choice((1, 4, 8, 24))
    parts = (text.splitlines(keepends=True) if text.isascii() else [text[i:i + size] for i in range(0, len(text), size)])
    i, j = (random_.randrange(len(parts)) for _ in range(2))
    parts[i], parts[j] = random_.choice(((b"", parts[j]), (2 * parts[i], parts[j]), (parts[j], parts[i])))
    return b"".join(parts)


def cut(random_, text):
    return text[:random_.randrange(len(text))]


def damaged(text, seed):
    """The text with one to three damages."""
    random_ = random.Random(seed)
    for _ in range(random_.choice((1, 1, 2, 3))):
        if text:
            text = random_.choices((other_number, other_bytes, other_lines, cut), (6, 3, 3, 1))[0](random_, text)
    return text


def fault(driver, name, folder):
    """What is wrong with a run, or nothing, and how it ended."""
    (folder / "map.mesh").unlink(missing_ok=True)
    try:
        run = subprocess.run([driver, name, "--improve", "--quiet", "--time-limit", "30", "-o", "map.mesh"], cwd=folder,
                             capture_output=True, timeout=SECONDS, errors="replace")
    except subprocess.TimeoutExpired:
        return "hangs", ""
    end = f"{run.returncode}: " + re.sub(r"[-+]?\d[\d.e+-]*|'.*'", "#", run.stderr.strip().replace("\n", " "))[:110]
    if run.returncode < 0:
        return f"signal {-run.returncode}", end
    if run.returncode == 0:
        image = read_mesh(folder / "map.mesh")
        return "a flat cell is written" if any(orientation(image.points, c) == 0 for c in image.cells) else "", "0"
    return "" if name in run.stderr else f"status {run.returncode}, the file is not named", end


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", type=Path)
    parser.add_argument("--number", type=int, default=2000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--formats", nargs="+", default=[])
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--sentences", action="store_true", help="print how often each sentence comes")
    arguments = parser.parse_args()
    driver, has_fault = arguments.driver.resolve(), False
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for form in write_files(driver, folder):
            if arguments.formats and form not in arguments.formats:
                continue
            text, faults, ends = (folder / form).read_bytes(), Counter(), Counter()
            for i in range(arguments.first, arguments.first + arguments.number):
                file = f"{i}_{form}"
                (folder / file).write_bytes(damaged(text, f"{form} {i}"))
                of_run, end = fault(driver, file, folder)
                ends[end] += 1
                if of_run:
                    faults[of_run] += 1
                    if arguments.keep:
                        arguments.keep.mkdir(parents=True, exist_ok=True)
                        (folder / file).rename(arguments.keep / file)
                    print(f"{file}: {of_run}, {end}", flush=True)
                (folder / file).unlink(missing_ok=True)
            print(f"{form}: {arguments.number} files, {ends['0']} maps,", dict(faults) or "no fault", flush=True)
            if arguments.sentences:
                print(*(f"  {n} {end}" for end, n in ends.most_common()), sep="\n", flush=True)
            has_fault = has_fault or bool(faults)
    sys.exit(has_fault)


if __name__ == "__main__":
    main()
