"""Reruns the experiments of the paper and writes a page: reproduce.py OUTPUT DATA BUILD [TIME_LIMIT], called by reproduce_paper.

TIME_LIMIT is in seconds of the processor, for each run."""
import subprocess
import sys
from pathlib import Path

import page
from comparisons import Bounded_distortion, Inverted_cells, Locally_injective
from convergence import Energies, Relaxation_figures, Relaxation_table, Weights_and_guesses
from runs import Runs

INTRODUCTION = (
    "The experiments of Jin et al., Stretch-Minimizing Volumetric Parameterization (JCST 30(3), 2015), rerun. Rows in "
    "italics are printed in the paper. Its models are not public in that form: ours are others of the same kind, so "
    "numbers are compared in kind. D = (Daa, Dma, Dav, Dmv) is measured by one program for all methods, on maps scaled "
    "to the volume of the source. Energies are means over the cells, lengths such that the target has volume 1 (the "
    "paper takes sums, and units as they are). Therefore a weight w corresponds to n w in the paper, and a tolerance of "
    "energies likewise, for n cells. Seconds are those of the processor, with one thread: of the steps, and for the driver of "
    "the whole program with its files. The solver of the paper is the soft boundary with relaxation and full Hessian.")

# Lists claims that a page cannot decide: the models are not public, or only a look decides.
UNTESTED = (
    ("Fig. 2 to 8, Table 1 and 2", "the numbers of the cow, the Isis, the horse, the hand, and of the authors' duck, sphinx and "
     "MaxPlanck", "no data"),
    ("Table 1 and 2", "the times in seconds", "another machine, and [7] by MATLAB"),
    ("Fig. 3", "with relaxation, the shape deforms more smoothly", "pictures only"),
    ("Fig. 8", "the method of the paper distributes distortions more evenly than [7]", "pictures only"),
    ("5", "the evaluation of the Hessian takes most of the time", "not measured by this page"))


def is_free_of_inverted_cells(runs):
    """Of all maps by run_soft_boundary, which alone logs this energy."""
    results = [job.result() for job in runs.jobs.values()]
    inverted = [run.measures["inverted_cells"] for run in results
                if run.measures and run.log and "distortion_energy" in run.log[0]]
    return page.claim("3.2", "no map by the solver has inverted cells", [not any(inverted)],
                      f"{sum(map(bool, inverted))} of {len(inverted)} maps have some")


def cut_runs(runs):
    results = [job.result() for job in runs.jobs.values()]
    return [(Path(run.prefix).name, run.steps, run.message) for run in results if run.message]


def head(runs, output, claims):
    commit = subprocess.run(["git", "describe", "--always", "--dirty", "--exclude=*"], cwd=Path(__file__).parent, text=True,
                            stdout=subprocess.PIPE, check=False).stdout.strip()
    minutes = sum(runs.seconds.values()) / 60
    parts = [page.paragraph(INTRODUCTION),
             page.paragraph(f"Commit {commit or 'unknown'}. The {len(runs.jobs)} runs took {minutes:.1f} minutes of the "
                            f"processor, so about {minutes / 2:.0f} minutes on two idle cores, and each at most "
                            f"{runs.time_limit} s."),
             page.heading("The claims of the paper"),
             page.table(output / "claims.csv", page.Claim._fields, claims)]
    cut = cut_runs(runs)
    if cut:
        parts += [page.heading("Runs without a map"), page.table(output / "cut.csv", ["", "iterations", "reason"], cut)]
    return parts


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    output, data, build = map(Path, sys.argv[1:4])
    output.mkdir(parents=True, exist_ok=True)
    runs = Runs(build, data, output / "runs", int(sys.argv[4]) if len(sys.argv) == 5 else 300)
    sections = [section(runs) for section in (Relaxation_figures, Relaxation_table, Weights_and_guesses, Inverted_cells,
                                              Locally_injective, Energies, Bounded_distortion)]
    parts = [part for section in sections for part in section.parts(output)]
    for pictured in runs.folder.glob("*.vtu"):
        pictured.unlink()
    claims = [claim for section in sections for claim in section.claims] + [is_free_of_inverted_cells(runs)]
    claims += [page.claim(place, text, [], reason) for place, text, reason in UNTESTED]
    (output / "index.html").write_text(page.page("Stretch-minimizing volumetric parameterization: the paper, rerun",
                                                 head(runs, output, claims) + parts))
    print(f"Open {output / 'index.html'}")


if __name__ == "__main__":
    main()
