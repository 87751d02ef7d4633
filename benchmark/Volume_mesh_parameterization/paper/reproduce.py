"""Reruns the experiments of the paper and writes a page: reproduce.py OUTPUT DATA BUILD, called by reproduce_paper."""
import sys
import time
from pathlib import Path

import page
from comparisons import Bounded_distortion, Inverted_cells, Locally_injective
from convergence import Energies, Relaxation_figures, Relaxation_table
from runs import Runs

INTRODUCTION = (
    "The experiments of Jin et al., Stretch-Minimizing Volumetric Parameterization (JCST 30(3), 2015), rerun. Rows in "
    "italics are printed in the paper. Its models are not public in that form: ours are others of the same kind, so "
    "numbers are compared in kind. D = (Daa, Dma, Dav, Dmv) is measured by one program for all methods, on maps scaled "
    "to the volume of the source. Energies are means over the cells, lengths such that the target has volume 1 (the "
    "paper takes sums, and units as they are). Times are those of this machine, with one thread, while a second run "
    "occupied another one.")


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    output, data, build = map(Path, sys.argv[1:])
    output.mkdir(parents=True, exist_ok=True)
    begin = time.time()
    runs = Runs(build, data, output / "runs")
    sections = [section(runs) for section in (Relaxation_figures, Relaxation_table, Inverted_cells, Locally_injective,
                                              Energies, Bounded_distortion)]
    parts = [page.paragraph(INTRODUCTION)]
    for section in sections:
        parts += section.parts(output)
    for pictured in runs.folder.glob("*.vtu"):
        pictured.unlink()
    parts.append(page.paragraph(f"All runs and pictures took {(time.time() - begin) / 60:.1f} minutes."))
    (output / "index.html").write_text(page.page("Stretch-minimizing volumetric parameterization: the paper, rerun", parts))
    print(f"Open {output / 'index.html'}")


if __name__ == "__main__":
    main()
