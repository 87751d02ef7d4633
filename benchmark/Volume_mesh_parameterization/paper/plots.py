"""Curves by gnuplot, as SVG."""
import subprocess
from pathlib import Path


def plot(filename, panels, columns=2):
    """panels: (title, label of y, [(title of a curve, [(x, y), ...]), ...]); logarithmic in y."""
    rows = -(-len(panels) // columns)
    script = [f"set terminal svg size {520 * columns},{340 * rows} noenhanced font 'sans,12' background 'white'",
              f'set output "{filename}"', f"set multiplot layout {rows},{columns}",
              'set logscale y', 'set format y "%.0e"', 'set xlabel "iteration"', "set grid", "set key top right"]
    for number, (title, label, curves) in enumerate(panels):
        drawn = []
        for i, (name, points) in enumerate(curves):
            block = f"$p{number}_{i}"
            script += [f"{block} << EOD", *(f"{x} {y}" for x, y in points if y > 0), "EOD"]
            drawn.append(f'{block} with linespoints lt {i + 1} lw 2 pt 7 ps 0.3 title "{name}"')
        script += [f'set title "{title}"', f'set ylabel "{label}"', "plot " + ", ".join(drawn)]
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)
    return Path(filename).name
