"""Compares the driver with itself and with a program that fails, by compare_programs.py.

Usage: check_comparison.py COMPARE_PROGRAMS PARAMETERIZE_MESH_FILE DATA_FOLDER
"""
import json
import math
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def main(script, driver, data):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copy(data / "cube.mesh", folder / "cube.mesh")
        shutil.copy(data / "cube_to_ball.txt", folder / "cube_ball.txt")
        subprocess.run([
            sys.executable, script, driver, folder, "--output", folder / "table",
            "--external", f"twin='{driver}' {{source}} {{target}} --output {{output}}",
            "--first-valid", r"twin=iterations in (\S+) s", "--external", "broken=false"],
            check=True, stdout=subprocess.DEVNULL)
        subprocess.run([driver, folder / "cube.mesh", folder / "cube_ball.txt", "--quiet",
                        "--report", folder / "report.json"], check=True)
        report = json.loads((folder / "report.json").read_text())
        table = json.loads((folder / "table.json").read_text())

    ours, twin, broken = table["cases"]
    assert [row["status"] for row in (ours, twin, broken)] == ["exact", "exact", "no map"]
    for key, value in report["distortion_at_source_volume"].items():
        assert math.isclose(ours[key], value, rel_tol=1e-6) and ours[key] == twin[key], key
    assert ours["seconds_to_first_valid"] > 0 and twin["seconds_to_first_valid"] > 0
    assert [line["exact"] for line in table["summary"]] == [1, 1, 0]
    print("The tables agree.")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], Path(sys.argv[3]))
