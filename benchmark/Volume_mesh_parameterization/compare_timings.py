#!/usr/bin/env python3
"""Compares the times of the driver with those of another program on the same cases.

Both run alternately, several times. A ratio is the driver's median divided by the other program's median;
the last line is the median of the ratios over the cases that both solve. For example:

  compare_timings.py DRIVER VOLMAP --filter cube --options "--threads 1" --options "--threads 2" \\
    --other "other_program -s {source} -b {target}" --other-total "time (\\S+)" --other-solved "flips 0 "

The regular expressions are applied to all that the other program prints. Each has one group, a number, and
its last match counts; where an expression is given several times, the numbers are added.
"""
import argparse
import json
import re
import shlex
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from tables import write_csv, write_json
from volmap_cases import add_case_options, find_cases

# our key in the report, and the option that finds the same in the other program's output
QUANTITIES = {"total": "seconds_total", "flip_free": "seconds_to_flip_free", "energy": "energy_value"}


def run_driver(driver, options, case):
    """The quantities of one run, or None if it does not reach the boundary without inverted cells."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        command = [driver, case.source, case.target, "--quiet", "--report", report, *shlex.split(options)]
        if subprocess.run(command, capture_output=True).returncode != 0:
            return None
        values = json.loads(report.read_text())
        return {quantity: values[key] for quantity, key in QUANTITIES.items()}


def run_other(arguments, expressions, case):
    """The same of the other program."""
    template = (case.target.suffix == ".mesh" and arguments.other_for_meshes) or arguments.other
    command = [word.format(source=case.source, target=case.target) for word in shlex.split(template)]
    try:
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             timeout=arguments.time_limit)
    except subprocess.TimeoutExpired:
        return None
    if run.returncode != 0 or not re.search(arguments.other_solved, run.stdout):
        return None
    matches = {quantity: [re.findall(regex, run.stdout) for regex in regexes]
               for quantity, regexes in expressions.items()}
    return {quantity: sum(float(found[-1]) for found in lists) if lists and all(lists) else None
            for quantity, lists in matches.items()}


def median_of(runs, quantity):
    """The median over the runs, None if one of them failed."""
    values = [run[quantity] if run else None for run in runs]
    return None if None in values else statistics.median(values)


def compare(case, arguments, expressions):
    """One row of the table."""
    other, ours = [], [[] for _ in arguments.options]
    for _ in range(arguments.repeat):
        other.append(run_other(arguments, expressions, case))
        for runs, options in zip(ours, arguments.options):
            runs.append(run_driver(arguments.driver, options, case))

    row = {"case": case.name}
    for quantity in QUANTITIES:
        b = median_of(other, quantity)
        row[f"other {quantity}"] = b
        for runs, options in zip(ours, arguments.options):
            a = median_of(runs, quantity)
            row[f"{quantity} {options}".strip()] = a
            if quantity == "energy":
                row[f"energy difference {options}".strip()] = abs(a - b) / abs(b) if a is not None and b else None
            else:
                row[f"{quantity} ratio {options}".strip()] = a / b if a is not None and b else None
    return row


def text(value, digits):
    return "-" if value is None else f"{value:.{digits}g}" if isinstance(value, float) else str(value)


def print_row(row, columns):
    print("  ".join(text(row[c], 3).ljust(max(len(c), 18 if c == "case" else 8)) for c in columns), flush=True)


def median_row(rows):
    """The medians of the ratios, the largest difference of energies."""
    result = {}
    for column in rows[0]:
        values = [row[column] for row in rows if row[column] is not None]
        result[column] = (statistics.median(values) if " ratio" in column and values else
                          max(values) if "difference" in column and values else None)
    result["case"] = f"median of {sum(row['other total'] is not None for row in rows)}"
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="the program parameterize_mesh_file")
    add_case_options(parser)
    parser.add_argument("--options", action="append", help="options of the driver; once for each variant to compare")
    parser.add_argument("--other", required=True, metavar="COMMAND", help="with {source} and {target}")
    parser.add_argument("--other-for-meshes", metavar="COMMAND", help="the same for targets that are meshes")
    parser.add_argument("--other-total", action="append", required=True, metavar="REGEX", help="seconds in all")
    parser.add_argument("--other-flip-free", action="append", default=[], metavar="REGEX",
                        help="seconds until no cell was inverted")
    parser.add_argument("--other-energy", action="append", default=[], metavar="REGEX")
    parser.add_argument("--other-solved", default="", metavar="REGEX", help="found where the case is solved")
    parser.add_argument("--repeat", type=int, default=3, help="number of runs of each program (3)")
    parser.add_argument("--time-limit", type=float, metavar="SECONDS", help="of each run of the other program")
    parser.add_argument("--output", metavar="PREFIX", help="write PREFIX.csv and PREFIX.json")
    arguments = parser.parse_args()
    arguments.options = arguments.options or [""]
    expressions = {quantity: getattr(arguments, "other_" + quantity) for quantity in QUANTITIES}

    cases = find_cases(arguments.volmap, arguments.pairs, arguments.filter)
    if not cases:
        sys.exit("there is no case in this folder")
    rows = []
    for case in cases:
        rows.append(compare(case, arguments, expressions))
        columns = [c for c in rows[0] if c == "case" or " ratio" in c or "difference" in c or c.startswith("other")]
        if len(rows) == 1:
            print("  ".join(c.ljust(18 if c == "case" else 8) for c in columns))
        print_row(rows[-1], columns)
    medians = median_row(rows)
    print_row(medians, columns)
    if arguments.output:
        write_csv(arguments.output + ".csv", rows + [medians])
        write_json(arguments.output + ".json", {"cases": rows, "medians": medians})


if __name__ == "__main__":
    main()
