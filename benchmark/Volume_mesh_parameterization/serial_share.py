#!/usr/bin/env python3
"""Measures which share of the driver's work one thread does alone, stage by stage, and what more processors can gain by it.

serial_share.py DRIVER SOURCE TARGET [--threads 2] [--report FILE.json] [-- OPTION...]

Reads the processor time of each thread from /proc while the driver runs, and the stage from what it shows on a terminal.
Parallel loops are shared evenly, so what the first thread works more than the others do is serial. If other programs keep
threads waiting, short loops end before these join in, and the share seems larger: the machine should be idle.

Of s serial and p other seconds, n processors need at least s + p / n (Amdahl), if memory keeps up with them: the matrix is
read once in each iteration of the linear solver, and the rate of that is printed for comparison with the machine's.
"""
import argparse
import json
import os
import pty
import subprocess
import tempfile
import threading
import time
from pathlib import Path

from tables import write_json

PROCESSORS = [2, 4, 16, 64]
INTERVAL = 0.005  # time between samples, in seconds
BYTES_OF_ROW = 15 * (9 * 4 + 4)  # row of the matrix: a vertex has 14 neighbors on average


def follow(terminal, shown):
    """Keeps the first word of the last line that the driver shows."""
    try:
        while text := os.read(terminal, 4096):
            words = text.decode(errors="replace").split("\033[K")[-1].split()
            shown[0] = words[0] if words else shown[0]
    except OSError:  # the driver has ended
        pass


def seconds_of_threads(pid):
    result = {}
    for task in Path(f"/proc/{pid}/task").iterdir():
        try:
            result[int(task.name)] = int((task / "schedstat").read_text().split()[0]) / 1e9
        except OSError:  # the thread has ended
            pass
    return result


def sample(command):
    """For each stage, the seconds of each thread in it."""
    mine, others = pty.openpty()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=others)
    os.close(others)
    shown, stages, last = ["beginning"], {}, {}
    threading.Thread(target=follow, args=(mine, shown), daemon=True).start()
    while process.poll() is None:
        stage = stages.setdefault(shown[0], {})
        try:
            now = seconds_of_threads(process.pid)
        except OSError:
            break
        for thread, seconds in now.items():
            stage[thread] = stage.get(thread, 0) + seconds - last.get(thread, 0)
        last = now
        time.sleep(INTERVAL)
    if process.wait() not in (0, 1):
        raise SystemExit(f"{command[0]} has failed")
    return stages, process.pid


def split(seconds, first, number_of_threads):
    """All seconds of a stage, and the serial ones: what the first thread works more than the others in the mean."""
    total, alone = sum(seconds.values()), seconds.get(first, 0)
    return total, max(0, alone - (total - alone) / (number_of_threads - 1))


def row_of(name, total, serial):
    gains = {f"gain_{k}": total / max(1e-9, serial + (total - serial) / k) for k in PROCESSORS}
    return {"stage": name, "seconds": total, "serial": serial, "share": serial / max(1e-9, total), **gains}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("driver", "source", "target"):
        parser.add_argument(name)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--report")
    parser.add_argument("options", nargs="*")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        stages, first = sample([arguments.driver, arguments.source, arguments.target, "--threads", str(arguments.threads),
                                "--report", report, "--output", Path(folder) / "map.mesh", *arguments.options])
        result = json.loads(report.read_text())
    rows = [row_of(name, *split(seconds, first, arguments.threads)) for name, seconds in stages.items()]
    rows.append(row_of("all", *(sum(row[key] for row in rows) for key in ("seconds", "serial"))))
    print(f"{'stage':<14}{'CPU s':>8}{'serial s':>10}{'share':>8}" + "".join(f"{f'x{k}':>7}" for k in PROCESSORS))
    for row in rows:
        print(f"{row['stage']:<14}{row['seconds']:>8.2f}{row['serial']:>10.2f}{row['share']:>8.1%}"
              + "".join(f"{row[f'gain_{k}']:>7.2f}" for k in PROCESSORS))
    read = result["linear_solver_iterations"] * (result["vertices"] - result["boundary_vertices"]) * BYTES_OF_ROW / 1e9
    print(f"{result['cells']} cells in {result['seconds_total']:.2f} s; the solver reads about {read:.0f} GB of matrices, "
          f"{read / result['seconds_total']:.1f} GB/s on average")
    if arguments.report:
        write_json(arguments.report, rows)


if __name__ == "__main__":
    main()
