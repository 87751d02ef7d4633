#!/usr/bin/python3
"""Runs the example program of each energy, and compares the distortions with the table of energies in the reference manual.

Usage: scripts/table_of_energies.py FOLDER [--write]

FOLDER has the programs, those of examples/Volume_mesh_parameterization/*_energy.cpp that map the dented cube. Each has one row,
which names it and ends with two cells "mean, max", of angles and of volumes. Numbers differ by a twentieth at most, as other
compilers round otherwise; --write replaces them instead.
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path

from run_page import ROOT, is_same

MANUAL = ROOT / "doc/Volume_mesh_parameterization/PackageDescription.txt"
ROW = re.compile(r"^\| .*/(\w+)_energy\.cpp\b.* \| [^|]+ \| [^|]+ \|$")
DISTORTION = re.compile(r"^distortion of (?:angles|volumes): +mean (\S+), max (\S+)$", re.MULTILINE)


def measured(row, program):
    """The row with the distortions that the program prints."""
    output = subprocess.run([program], cwd=program.parent, check=True, text=True, stdout=subprocess.PIPE).stdout
    cells = [f"{float(mean):.3g}, {float(largest):.3g}" for mean, largest in DISTORTION.findall(output)]
    if len(cells) != 2:
        sys.exit(f"{program} does not print two distortions:\n{output}")
    return " | ".join(row.split(" | ")[:-2] + cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    missing = {path.stem for path in (ROOT / "examples/Volume_mesh_parameterization").glob("*_energy.cpp")} - {"own_energy"}
    lines, differences = MANUAL.read_text().splitlines(), []
    for i, line in enumerate(lines):
        row = ROW.match(line)
        if not row:
            continue
        name = f"{row[1]}_energy"
        missing.discard(name)
        program = arguments.folder.resolve() / name
        if row[1] == "dirichlet" and not program.exists(): # it is built only with CHOLMOD
            continue
        new = measured(line, program)
        if not is_same(line, new):
            differences.append(f"in the manual: {line}\nof the program: {new}")
        lines[i] = new
    differences += [f"{MANUAL} has no row with {name}.cpp" for name in sorted(missing)]
    if arguments.write:
        MANUAL.write_text("\n".join(lines) + "\n")
    print(*differences, sep="\n", end="\n" if differences else "")
    sys.exit(1 if differences and not arguments.write else 0)


if __name__ == "__main__":
    main()
