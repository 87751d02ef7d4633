#!/usr/bin/env python3
"""Compares the maps of several programs, and the times that they take, on the same cases of public sets.

compare_programs.py PARAMETERIZE_MESH_FILE --set volmap=FOLDER --set wrapd=FOLDER --set handles=FOLDER --options "--refine" \\
  --external "NAME=other -s {source} -b {target} -o {output}" --first-valid "NAME=untangled at (\\S+) s" --page page.md

other_programs/compare_with_others.sh builds other programs, and calls this script with them.
public_sets.py lists the sets that are read, as they are published.
parameterize_mesh_file and the other programs, which are not part of this package, run one after the other. A command has the
words {source} (MODEL.mesh), {target} (MODEL_DOMAIN.txt) and {output}, a mesh of the same cells with the new coordinates. A program
that refines writes the refined source to {refined}. If the boundary is free, as in the set "handles", {target} has the handles only.
All maps are checked alike, by check_map.py in exact arithmetic, and so are their distortions, of the map scaled to the volume of
the source. Seconds are those that the processor spends on the whole program with its files, so other programs on the machine hardly
change them; those until the first valid map are what the program says, less the part of its time in which it did not run. Each
program gets --time-limit seconds for each case. Memory is the largest that was in use. Tables are in Markdown, and so is the page:
what was run, on which machine, all results, and each case that parameterize_mesh_file does not solve. The page begins with the
cases in which another program is better than parameterize_mesh_file.

PREFIX.json of --output is written after each run. Runs that it has already are not repeated, so that a comparison which was ended
goes on.
"""
import argparse
import datetime
import json
import math
import os
import platform
import re
import resource
import shlex
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from check_map import check, determinant, read_mesh
from driver_runs import status
from public_sets import READERS, cases_of_set
from tables import write_csv, write_json

COLUMNS = ["case", "program", "status", "seconds_to_first_valid", "seconds", "megabytes", "angle_mean", "angle_max", "volume_mean",
           "volume_max"]
TIMES = COLUMNS[3:5]
HEADINGS = {"flip_free": "valid", "seconds_to_first_valid": "s to first", "seconds": "s in all", "megabytes": "MB",
            "angle_mean": "angles, mean", "angle_max": "angles, largest", "volume_mean": "volumes, mean",
            "volume_max": "volumes, largest", "ratio_of_seconds_to_first_valid": "ratio to first",
            "ratio_of_seconds": "ratio in all", "better": "better than parameterize_mesh_file"}
INTRODUCTION = """\
A map is valid if it has no inverted cell. It is exact if it also meets the prescribed boundary bit by bit, or the handles if the
rest of the boundary is free. Rational arithmetic decides this for the written files. Seconds are processor time of the whole
program, with its files: until the first map without inverted cells ("s to first"), and in all. MB is the largest memory in use. The
distortion of angles is s1 / s3 + s3 / s1, and the distortion of volumes is det + 1 / det. Both have two columns: the mean over the
volume of the source, and the largest value. Tables of programs have medians over the common cases: the cases of all programs,
except programs without any map. Ratios are relative to the first program, and are medians over the cases that both map. Programs
may have other aims: some stop at the first valid map. A program that its limit of processor time ended has the status "not within"
this limit: it may find a map later.

"""
OURS = "parameterize_mesh_file"


def edges(points, cell):
    corners = [points[v] for v in cell]
    return [[p[i] - corners[3][i] for i in range(3)] for p in corners[:3]]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def largest_eigenvalue(m):
    """Of a symmetric 3x3 matrix, by Cardano's formula."""
    q = (m[0][0] + m[1][1] + m[2][2]) / 3
    shifted = [[m[i][j] - (q if i == j else 0) for j in range(3)] for i in range(3)]
    p = math.sqrt(sum(x * x for row in shifted for x in row) / 6)
    if p < 1e-14 * q:
        return q
    half = sum(x * y for x, y in zip(shifted[0], cross(shifted[1], shifted[2]))) / (2 * p ** 3)
    return q + 2 * p * math.cos(math.acos(max(-1, min(1, half))) / 3)


def angle_distortion(x, u):
    """s1 / s3 + s3 / s1 of the linear map that takes the edges x to u: the largest eigenvalue of J J^T is s1^2, that of
    its inverse 1 / s3^2."""
    def gram(a, b):
        volume = sum(p * q for p, q in zip(a[0], cross(a[1], a[2])))
        inverse = [cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])]
        j = [[sum(b[k][i] * inverse[k][l] for k in range(3)) / volume for l in range(3)] for i in range(3)]
        return [[sum(j[i][k] * j[l][k] for k in range(3)) for l in range(3)] for i in range(3)]
    ratio = math.sqrt(largest_eigenvalue(gram(x, u)) * largest_eigenvalue(gram(u, x)))
    return ratio + 1 / ratio


def distortions(source, image):
    """Daa, Dma, Dav, Dmv: means by volume, and maxima, which are infinite if a cell of the source is flat in doubles."""
    volumes = [determinant(*[source.points[v] for v in cell])[0] for cell in source.cells]
    largest = [float("inf")] if 0 in volumes else []
    cells = [cell for cell, volume in zip(source.cells, volumes) if volume != 0]
    volumes = [volume for volume in volumes if volume != 0]
    images = [determinant(*[image.points[v] for v in cell])[0] for cell in cells]
    total, scale = sum(volumes), sum(volumes) / sum(images)
    angles = [angle_distortion(edges(source.points, cell), edges(image.points, cell)) for cell in cells]
    ratios = [scale * b / a for a, b in zip(volumes, images)]
    stretched = [r + 1 / r for r in ratios]
    return {"angle_mean": sum(v * x for v, x in zip(volumes, angles)) / total, "angle_max": max(angles + largest),
            "volume_mean": sum(v * x for v, x in zip(volumes, stretched)) / total, "volume_max": max(stretched + largest)}


def judge(case, folder):
    """The status of what was written, and its distortions if it is a map."""
    output, refined = folder / "output.mesh", folder / "refined.mesh"
    source = refined if refined.exists() else case.source
    try:
        verdict = check(case.source, case.target, source, output, case.is_free)
    except (OSError, ValueError, IndexError):
        return {"status": "no map"}
    row = {"status": status(verdict)}
    if row["status"] != "refuted":
        row.update(distortions(read_mesh(source), read_mesh(output)))
    return row


def run_command(words, folder, time_limit):
    """What the program prints, the resources that it has used, its own children included, and whether the system ended it after
    this processor time. The system ends each of its children by this limit, too."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (time_limit, time_limit + 1))
    with open(folder / "output.txt", "w+") as output:
        process = subprocess.Popen(words, stdout=output, stderr=subprocess.STDOUT, preexec_fn=limit)
        _, status_of_process, usage = os.wait4(process.pid, 0)
        is_ended = os.WIFSIGNALED(status_of_process) and os.WTERMSIG(status_of_process) == signal.SIGXCPU
        output.seek(0)
        return output.read(), usage, is_ended


def needs_vertices(driver, case, time_limit):
    """Whether the driver proves, in this processor time, that no map exists with the connectivity of the source."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        words = [driver, case.source, case.target, "--quiet", "--boundary", "fixed", "--output", folder / "output.mesh"]
        output, *_ = run_command(words, folder, time_limit)
    return bool(re.search("No map with this connectivity meets this boundary|--refine splits such cells", output))


def run(name, command, first_valid, case, time_limit, pool):
    """One row of the table. Meshes are read in another process: a program has at least the memory of the one that starts it."""
    row = {"case": case.name, "program": name, "date": str(datetime.date.today())}
    with tempfile.TemporaryDirectory() as path:
        folder = Path(path)
        paths = {"source": case.source, "target": case.target, "output": folder / "output.mesh",
                 "refined": folder / "refined.mesh", "report": folder / "report.json"}
        begin = time.monotonic()
        words = [word.format(**paths) for word in shlex.split(command)]
        if name == OURS and case.is_free:
            words += ["--others", "free"]
        output, usage, is_ended = run_command(words, folder, time_limit)
        elapsed, row["seconds"] = time.monotonic() - begin, usage.ru_utime + usage.ru_stime
        row["megabytes"] = usage.ru_maxrss / 1000
        row.update(pool.submit(judge, case, folder).result())
        is_late = row["seconds"] > 0.9 * time_limit  # as if a child was ended; the system counts in ticks
        if row["status"] == "no map" and (is_ended or is_late):
            row["status"] = f"not within {time_limit} s"
        if name == OURS:
            row["needs_vertices"] = not case.is_free and needs_vertices(words[0], case, time_limit)
        said = first_valid(output, folder) if row["status"] in ("exact", "flip-free") else None
        if said is not None:
            row["seconds_to_first_valid"] = said * row["seconds"] / elapsed
        if row["status"] != "exact" and output.strip():
            row["message"] = output.strip().splitlines()[-1]
    return row


def number_in_output(regex):
    def find(output, _):
        found = re.findall(regex, output) if regex else []
        return float(found[-1]) if found else None
    return find


def number_in_report(_, folder):
    return json.loads((folder / "report.json").read_text())["seconds_to_flip_free"]


def rows_of_set(name, cases, programs, tables, filename, run_it):
    """A row for each case and program, unless the program takes no such case, or adds no vertices and the case needs some. The file
    of all tables has each row from the end of its run on, and rows that it has already are taken from there."""
    known = {(row["case"], row["program"]): row for row in tables.get(name, {"cases": []})["cases"]}
    rows = []
    for case in cases:
        for program, (command, _, takes) in programs.items():
            key, ours = (case.name, program), known.get((case.name, OURS), {})
            is_in_vain = ours.get("needs_vertices") and "{refined}" not in command
            if not re.search(takes, f"{name}/{case.name}") or is_in_vain:
                continue
            if key not in known:
                known[key] = run_it(program, case)
                tables[name] = {"cases": list(known.values())}
                if filename:
                    write_json(filename, tables)
            rows.append(known[key])
    return rows


def summary(rows, programs):
    """A row a program: how many cases it solves, and medians over those that all map without inverted cells, except
    programs that never do; how the times relate to those of the first, medians over the cases that both map."""
    mapped = [{row["case"] for row in rows if row["program"] == name and "angle_mean" in row} for name in programs]
    common = set.intersection(*(filter(None, mapped))) if any(mapped) else set()
    result = []
    for name in programs:
        own = [row for row in rows if row["program"] == name]
        if not own:
            continue
        line = {"program": name, "cases": len(own), "exact": sum(row["status"] == "exact" for row in own),
                "flip_free": sum("angle_mean" in row for row in own), "common": len(common)}
        for column in COLUMNS[3:]:
            values = [row.get(column) for row in own if row["case"] in common]
            line[column] = statistics.median(values) if values and None not in values else None
        for column in TIMES:
            ratios = [a[column] / b[column] for a in own for b in rows
                      if b["program"] == OURS and b["case"] == a["case"] and "angle_mean" in a and "angle_mean" in b
                      and column in a and b[column] > 0]
            line["ratio_of_" + column] = statistics.median(ratios) if ratios else None
        result.append(line)
    return result


def losses(rows, programs):
    """A row for each other program: in how many of the cases that both map it is better than parameterize_mesh_file, by column."""
    ours = {row["case"]: row for row in rows if row["program"] == OURS}
    result = []
    for name in programs:
        both = [(ours[row["case"]], row) for row in rows
                if row["program"] == name != OURS and "angle_mean" in row and "angle_mean" in ours[row["case"]]]
        if both:
            better = {column: sum(column in b and b[column] < a[column] for a, b in both) for column in COLUMNS[3:]}
            result.append({"better": name, "both map": len(both), **better})
    return result


def cell_text(value):
    return "" if value is None else f"{value:.3g}" if isinstance(value, float) else str(value)


def table(rows, columns):
    rules = ["---" if column in ("case", "program", "status", "message", "set", "better") else "---:" for column in columns]
    lines = [[HEADINGS.get(column, column) for column in columns], rules,
             *([cell_text(row.get(column)) for column in columns] for row in rows)]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines) + "\n"


def machine():
    """What times depend on."""
    name = re.findall(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 1e9
    return f"Machine: {os.cpu_count()} of {name[0] if name else platform.processor()}, {memory:.0f} GB, {platform.platform()}."


def page(programs, versions, sets):
    """Everything that was run: `sets` has the name, rows, and number of cases left out of each."""
    lines = [machine(), *(f"{name}: {versions[name]}" if name in versions else f"{name}: `{command}`"
                           for name, (command, *_) in programs.items())]
    text = "# Maps of Public Sets {#PkgVolumeMeshParameterizationPublicSets}\n\n" + INTRODUCTION
    text += "".join(f"- {line}\n" for line in lines) + "\n"
    lost = [{"set": name, **line} for name, rows, *_ in sets for line in losses(rows, programs)]
    if lost:
        text += f"The number of cases in which another program is better than {OURS}, of those that both map:\n\n"
        text += table(lost, list(lost[0]))
    for name, rows, number_left_out in sets:
        without_map = [row["case"] for row in rows if row.get("needs_vertices")]
        lines, dates = summary(rows, programs), sorted({row["date"] for row in rows})
        text += f"## {name}\n\nDates of runs: {', '.join(dates)}.\n\n" + table(lines, list(lines[0]))
        if number_left_out:
            text += f"{number_left_out} cases are left out, because cells of their source are flat or inverted.\n\n"
        if without_map:
            text += f"Cases that are proved to have no map with their connectivity: {', '.join(without_map)}.\n" \
                    "They are not among the cases of programs that add no vertices.\n\n"
        lost = [row for row in rows if row["program"] == OURS and row["status"] != "exact"]
        text += f"Not exact by {OURS}: {len(lost)}.\n\n" + (table(lost, ["case", "status", "message"]) if lost else "")
        text += table(rows, COLUMNS)
    return text


def pairs(parser, texts):
    """NAME=TEXT, as a dictionary."""
    for text in texts:
        if "=" not in text:
            parser.error(f"'{text}' has no '='")
    return dict(text.split("=", 1) for text in texts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="the program parameterize_mesh_file")
    parser.add_argument("--set", action="append", required=True, metavar="NAME=FOLDER",
                        help="a folder of " + ", ".join(READERS))
    parser.add_argument("--filter", default="", metavar="REGEX",
                        help="only cases that this regular expression finds in SET/CASE")
    parser.add_argument("--options", default="", help="options of parameterize_mesh_file")
    parser.add_argument("--external", action="append", default=[], metavar="NAME=COMMAND", help="another program")
    parser.add_argument("--first-valid", action="append", default=[], metavar="NAME=REGEX",
                        help="seconds until no cell was inverted, in the output of that program; the last match counts")
    parser.add_argument("--takes", action="append", default=[], metavar="NAME=REGEX",
                        help="only these cases of SET/CASE for that program, as it cannot solve others")
    parser.add_argument("--version", action="append", default=[], metavar="NAME=TEXT",
                        help="what the page says of that program, in place of its command")
    parser.add_argument("--time-limit", type=int, default=120, metavar="SECONDS",
                        help="of the processor, for each program and case (%(default)s)")
    parser.add_argument("--output", metavar="PREFIX", help="write PREFIX.csv and PREFIX.json, after each run")
    parser.add_argument("--page", metavar="FILE", help="write a page with all results")
    arguments = parser.parse_args()

    regexes, takes = pairs(parser, arguments.first_valid), pairs(parser, arguments.takes)
    ours = f"{shlex.quote(arguments.driver)} {{source}} {{target}} --quiet --output {{output}}" \
           f" --refined-source {{refined}} --report {{report}} {arguments.options}"
    programs = {OURS: (ours, number_in_report, "")}
    for name, command in pairs(parser, arguments.external).items():
        programs[name] = (command, number_in_output(regexes.get(name)), takes.get(name, ""))

    version = subprocess.run([arguments.driver, "--version"], stdout=subprocess.PIPE, text=True, check=False).stdout.split("\n")[0]
    versions = {OURS: version, **pairs(parser, arguments.version)}
    versions[OURS] += f", `{ours.replace(arguments.driver, OURS)}`"
    filename = Path(f"{arguments.output}.json") if arguments.output else None
    tables = json.loads(filename.read_text()) if filename and filename.exists() else {}
    sets = []
    with tempfile.TemporaryDirectory() as folder, ProcessPoolExecutor(1) as pool:
        for name, source in pairs(parser, arguments.set).items():
            if name not in READERS:
                parser.error(f"there is no set '{name}'")
            cases, number_left_out = pool.submit(cases_of_set, name, source, folder).result()
            cases = [case for case in cases if re.search(arguments.filter, f"{name}/{case.name}")]
            if not cases:
                sys.exit(f"there is no case in the folder {source}")
            rows = rows_of_set(name, cases, programs, tables, filename, lambda program, case: run(
                program, *programs[program][:2], case, arguments.time_limit, pool))
            sets.append((name, rows, number_left_out))
            print(table(rows, COLUMNS) + table(summary(rows, programs), list(summary(rows, programs)[0])), flush=True)
    if arguments.output:
        write_csv(arguments.output + ".csv", [{"set": name, **row} for name, rows, *_ in sets for row in rows])
        write_json(filename, {**tables, **{name: {"cases": rows, "summary": summary(rows, programs)} for name, rows, *_ in sets}})
    if arguments.page:
        Path(arguments.page).write_text(page(programs, versions, sets))


if __name__ == "__main__":
    main()
