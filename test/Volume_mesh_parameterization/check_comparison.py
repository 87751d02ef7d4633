"""Compares the driver with itself and with a program that fails, by compare_programs.py, on small sets of each form.

Usage: check_comparison.py COMPARE_PROGRAMS PARAMETERIZE_MESH_FILE DATA_FOLDER
"""
import itertools
import json
import math
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def write_TetGen(stem, points, cells, first):
    """As TetGen writes it, with comments and indices from 0 or 1."""
    with open(f"{stem}.node", "w") as file:
        print("# points\n", len(points), 3, 0, 0, file=file)
        for v, p in enumerate(points):
            print(v + first, *p, "# a point", file=file)
    with open(f"{stem}.ele", "w") as file:
        print(len(cells), 4, 0, file=file)
        for c, cell in enumerate(cells):
            print(c + first, *(v + first for v in cell), file=file)


def write_MEDIT(filename, points, keyword, cells):
    rows = [f"{x} {y} {z} 0" for x, y, z in points] + [keyword, str(len(cells))]
    rows += [" ".join(str(v + 1) for v in cell) + " 0" for cell in cells]
    filename.write_text("\n".join(["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points)), *rows, "End", ""]))


def write_sets(folder):
    """A cube of 2 x 2 x 2 cubes in each form: its center and 26 vertices of the boundary, which is sheared."""
    points = [(x, y, z) for z, y, x in itertools.product(range(3), repeat=3)]
    sheared = [(x + 0.5 * y, y, z) for x, y, z in points]
    corners = [x + 3 * y + 9 * z for z, y, x in itertools.product(range(2), repeat=3)]
    hexahedra = [tuple(v + i for i in (0, 1, 4, 3, 9, 10, 13, 12)) for v in corners]
    pairs = ((1, 4), (4, 3), (3, 12), (12, 9), (9, 10), (10, 1))
    cells = [(v, v + a, v + b, v + 13) for v in corners for a, b in pairs]
    for name in ("wrapd", "hexahedra", "poses"):
        (folder / name).mkdir()
    write_TetGen(folder / "wrapd/cube_rest", points, cells, 1)
    write_TetGen(folder / "wrapd/cube_nh_soln", sheared, cells, 0)
    write_TetGen(folder / "wrapd/flat_rest", [(x, y, 0) for x, y, _ in points], cells, 0)  # is left out
    write_TetGen(folder / "wrapd/flat_soln", points, cells, 0)
    (folder / "wrapd/cube_handles.txt").write_text("0 2\n24 26\n")  # four corners
    write_MEDIT(folder / "hexahedra/cube.mesh", sheared, "Hexahedra", hexahedra)
    write_MEDIT(folder / "hexahedra/cube_polycube.mesh", points, "Hexahedra", hexahedra)
    write_MEDIT(folder / "poses/cube.mesh", points, "Tetrahedra", cells)
    for name, pose in (("cube-0", sheared), ("cube-1", sheared), ("cube-part", sheared[:5])):  # the last is left out
        (folder / f"poses/{name}.obj").write_text("# a pose\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in pose) + "f 1 2 3\n")


def check_forms(script, driver, folder):
    sets = [f"{name}={folder / name}" for name in ("wrapd", "hexahedra", "poses")] + [f"handles={folder / 'wrapd'}"]
    subprocess.run([sys.executable, script, driver, *(word for name in sets for word in ("--set", name)),
                    "--output", folder / "forms", "--page", folder / "page.md"], check=True, stdout=subprocess.DEVNULL)
    table = json.loads((folder / "forms.json").read_text())
    names = {name: [row["case"] for row in table[name]["cases"]] for name in table}
    assert names == {"wrapd": ["cube_to_solution", "cube_to_rest", "flat_to_rest"], "hexahedra": ["cube_polycube"],
                     "poses": ["cube-0", "cube-1"], "handles": ["cube_handles"]}, names
    for name in table:
        for row in table[name]["cases"]:
            is_flat = row["case"] == "flat_to_rest"  # a target without volume has no map
            assert row["status"] == ("no map" if is_flat else "exact"), row
            if name == "handles":  # a free boundary is less distorted than the sheared one
                assert row["angle_mean"] < table["wrapd"]["cases"][0]["angle_mean"], row
            elif not is_flat:  # the map is linear, of one distortion
                assert math.isclose(row["angle_mean"], row["angle_max"], rel_tol=1e-6), row
                assert math.isclose(row["volume_max"], 2, rel_tol=1e-6) and row["megabytes"] > 1, row
    page = (folder / "page.md").read_text()
    assert "1 cases are left out" in page and "Not exact by parameterize_mesh_file: 1." in page and "Machine: " in page
    for line in page.splitlines():
        if line.startswith("| case |"):
            assert len(set(line.split("|"))) == len(line.split("|")) - 1, line  # each column has a name of its own


def check_flat_cell(script, driver, folder):
    """A cube of six cells, whose targets make one flat. It is not given to programs that add no vertices. A second comparison
    keeps the rows of the first one."""
    points = list(itertools.product(range(2), repeat=3))
    cells = [(0, *pair, 7) for pair in ((1, 5), (5, 4), (4, 6), (6, 2), (2, 3), (3, 1))]
    (folder / "flat").mkdir()
    write_MEDIT(folder / "flat/cube.mesh", points, "Tetrahedra", cells)
    targets = [*points[:4], (0.5, 0.3, 0.5), *points[5:]]
    (folder / "flat/cube_flat.txt").write_text("".join(f"{v} {x} {y} {z}\n" for v, (x, y, z) in enumerate(targets)))
    words = [sys.executable, script, driver, "--set", f"volmap={folder / 'flat'}", "--output", folder / "flat_table"]
    for name, command, takes in (("keeps", "false", ""), ("refines", "false {refined}", ""), ("other", "false", "^poses/")):
        words += ["--external", f"{name}={command}", "--takes", f"{name}={takes}"]

    def rows_of_run(options):
        subprocess.run([*words, f"--options={options}"], check=True, stdout=subprocess.DEVNULL)
        return json.loads((folder / "flat_table.json").read_text())["volmap"]["cases"]
    rows = rows_of_run("--refine")
    assert [(row["program"], row["status"]) for row in rows] == [("parameterize_mesh_file", "exact"), ("refines", "no map")], rows
    assert rows_of_run("--help") == rows


def check_other_orientation(script):
    """A refined source may have cells of the other orientation than the source, and cells that are flat in doubles."""
    sys.path.insert(0, str(Path(script).parent))
    from check_map import Mesh, structural_fault
    from compare_programs import distortions
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    source = Mesh(points, [(0, 1, 2, 3)])
    split = Mesh([*points, (0.5, 0, 0)], [(0, 4, 3, 2), (4, 1, 3, 2)])
    assert structural_fault(source, split, split) == ""
    assert structural_fault(source, Mesh(split.points, split.cells[:1]), Mesh(split.points, split.cells[:1])) != ""
    flat = Mesh([*points, (0, 0, 0.5)], [(0, 1, 2, 3), (0, 1, 3, 4)])
    found = distortions(flat, flat)
    assert math.isinf(found["angle_max"]) and math.isclose(found["angle_mean"], 2), found


def main(script, driver, data):
    check_other_orientation(script)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "volmap").mkdir()
        shutil.copy(data / "cube.mesh", folder / "volmap/cube.mesh")
        shutil.copy(data / "cube_to_ball.txt", folder / "volmap/cube_ball.txt")
        subprocess.run([
            sys.executable, script, driver, "--set", f"volmap={folder / 'volmap'}", "--output", folder / "table",
            "--external", f"twin='{driver}' {{source}} {{target}} --output {{output}}",
            "--first-valid", r"twin=iterations in (\S+) s", "--external", "broken=false",
            "--external", f"endless='{sys.executable}' -c 'while True: pass'", "--time-limit", "2",
            "--page", folder / "losses.md"],
            check=True, stdout=subprocess.DEVNULL)
        losses = (folder / "losses.md").read_text()
        subprocess.run([driver, folder / "volmap/cube.mesh", folder / "volmap/cube_ball.txt", "--quiet",
                        "--report", folder / "report.json"], check=True)
        report = json.loads((folder / "report.json").read_text())
        table = json.loads((folder / "table.json").read_text())["volmap"]
        write_sets(folder)
        check_forms(script, driver, folder)
        check_flat_cell(script, driver, folder)

    ours, twin, *failing = table["cases"]
    assert [row["status"] for row in (ours, twin, *failing)] == ["exact", "exact", "no map", "not within 2 s"], table["cases"]
    for key, value in report["distortion_at_source_volume"].items():
        assert math.isclose(ours[key], value, rel_tol=1e-6) and ours[key] == twin[key], key
    assert ours["seconds_to_first_valid"] > 0 and twin["seconds_to_first_valid"] > 0
    assert [line["exact"] for line in table["summary"]] == [1, 1, 0, 0]
    (line,) = [line for line in losses.splitlines() if line.startswith("| volmap | twin |")]  # none for programs without maps
    assert line.startswith("| volmap | twin | 1 | ") and line.endswith("| 0 | 0 | 0 | 0 |"), line  # the same map is no loss
    print("The tables agree.")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], Path(sys.argv[3]))
