"""Plots time and memory against the number of cells, with lines through the points of each program."""
import math
import subprocess
from itertools import groupby

QUANTITIES = {"seconds_total": ("seconds", 1), "peak_memory_bytes": ("peak memory in MiB", 1 / 2**20)}


def points(rows, quantity):
    """Lists of (cells, value) by program."""
    chosen = [row for row in rows if row.get("cells") and row.get(quantity)]
    chosen.sort(key=lambda row: (row["program"], row["cells"]))
    return {program: [(row["cells"], row[quantity] * QUANTITIES[quantity][1]) for row in group]
            for program, group in groupby(chosen, lambda row: row["program"])}


def fit_power(pairs):
    """(a, b) such that a * cells^b is nearest to the values, by least squares of the logarithms."""
    x = [math.log(cells) for cells, _ in pairs]
    y = [math.log(value) for _, value in pairs]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    spread = sum((t - mean_x)**2 for t in x)
    if spread < 1e-6:
        return None
    exponent = sum((t - mean_x) * (s - mean_y) for t, s in zip(x, y)) / spread
    return math.exp(mean_y - exponent * mean_x), exponent


def fits(rows):
    """One dictionary for each program and quantity with at least two sizes."""
    result = []
    for quantity in QUANTITIES:
        for program, pairs in points(rows, quantity).items():
            fit = fit_power(pairs)
            if fit:
                result.append({"program": program, "quantity": quantity, "factor": fit[0], "exponent": fit[1]})
    return result


def panel(rows, exponents, quantity):
    """The part of the gnuplot script for one quantity."""
    script, lines, marks = [], [], []
    programs = sorted({row["program"] for row in rows})
    for program, pairs in points(rows, quantity).items():
        i = 1 + programs.index(program)   # a program looks the same in both panels
        block = f"${quantity}_{i}"
        script += [f"{block} << EOD", *(f"{cells} {value}" for cells, value in pairs), "EOD"]
        title = program.replace('"', "'")
        fit = next((f for f in exponents if (f["program"], f["quantity"]) == (program, quantity)), None)
        if fit:
            title += f" (exponent {fit['exponent']:.2f})"
            first, last = pairs[0][0], pairs[-1][0]
            lines.append(f"[{first}:{last}] {fit['factor']}*x**{fit['exponent']} with lines lt {i} notitle")
        marks.append(f'{block} with points lt {i} pt {i} title "{title}"')
    if not marks:
        return []
    sample = "sample " if lines else ""   # the keyword must precede a range
    return script + [f'set ylabel "{QUANTITIES[quantity][0]}"', f"plot {sample}" + ", ".join(lines + marks)]


def plot(rows, exponents, filename):
    script = ["set terminal svg size 1200,700 noenhanced background 'white'", f'set output "{filename}"',
              "set logscale xy", 'set format "%g"', 'set xlabel "cells"', "set grid",
              "set key outside below left reverse Left", "set multiplot layout 1,2"]
    for quantity in QUANTITIES:
        script += panel(rows, exponents, quantity)
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)
