#!/usr/bin/env python3
"""Runs the driver on all cases of a VOLMAP folder, checks what it writes, and prints one line a case.

run_volmap.py DRIVER VOLMAP [--pairs FOLDER] [--output PREFIX] [options that are passed to the driver]

"exact" are maps without inverted cells and with the prescribed boundary, bit for bit; "flip-free" are also
those that miss the boundary; both by an independent check in exact arithmetic. The exit status is 1 if the
driver claimed something that the check refutes.
"""
import argparse
import sys

from driver_runs import line, print_summary, print_titles, run_case, summary, write_tables
from volmap_cases import add_case_options, find_cases


def main():
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("driver", help="the program parameterize_mesh_file")
    add_case_options(parser)
    parser.add_argument("--output", metavar="PREFIX", help="write PREFIX.csv and PREFIX.json")
    parser.add_argument("--time-limit", type=float, metavar="SECONDS", help="of each case")
    arguments, options = parser.parse_known_args()

    cases = find_cases(arguments.volmap, arguments.pairs, arguments.filter)
    if not cases:
        sys.exit("there is no case in this folder")
    print_titles()
    rows = []
    for case in cases:
        rows.append(run_case(arguments.driver, case, options, arguments.time_limit))
        print(line(rows[-1]), flush=True)

    result = summary(rows)
    print_summary(result)
    if arguments.output:
        write_tables(arguments.output, options, result, rows)
    sys.exit(result["refuted"] > 0)


if __name__ == "__main__":
    main()
