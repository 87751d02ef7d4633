"""The experiments on convergence: Fig. 2 and 3, weights and initial guess, Fig. 6 and 7, Table 1, and relaxation."""
import math
from pathlib import Path

from figure import ENERGIES, Convergence_of_energies, against, curve
from page import claim, figures, heading, paragraph, table

import printed_values as printed
from plots import plot
from render import image_of, picture, read, surface
from runs import distortions, iterations, measure
from views import view

D_COLUMNS = ["Daa", "Dma", "Dav", "Dmv"]


def end_of(run):
    """The energy with the penalty, and the distance to the targets, after the last step."""
    if not run.log:
        return math.inf, math.inf
    end = run.log[-1]
    return end["distortion_energy"] + end["position_energy"], end["distance"]


class Relaxation_figures:
    """Fig. 2 and 3: one model, weight 1e4, with relaxation and by the solver of [39] without it."""
    MODEL, DOMAIN = "bone", "tet"

    def __init__(self, runs):
        self.runs = runs
        self.case = runs.case(self.MODEL, self.DOMAIN)
        options = ["--weight", "1e4", "--shape-interval", 1]
        self.jobs = {"with": runs.soft(self.case, "relaxed", *options, "--full-hessian"),
                     "without": runs.soft(self.case, "plain", *options, "--shifted-newton")}

    def parts(self, output):
        result = {name: job.result() for name, job in self.jobs.items()}
        shapes = {name: self._submit_shapes(run) for name, run in result.items()}
        self.claims = self._claims(result)
        parts = [heading("Fig. 2: with and without relaxation, w = 1e4"), self._numbers(output, result)]
        panels = []
        for name, run in result.items():
            for what, keys in (("energy", ("distortion_energy", "position_energy")),
                               ("squared norm of gradient", ("distortion_gradient", "position_gradient"))):
                panels.append((f"{name} relaxation", what, [("stretch", curve(run, keys[0])),
                                                            ("positions", curve(run, keys[1]))]))
        parts.append(figures([(plot(output / "figure_2.svg", panels), "")], 1000))
        parts.append(heading("Fig. 3: shapes along the iteration"))
        for name, jobs in shapes.items():
            pictures = []
            for job in jobs:
                run = job.result()
                filename = output / f"figure_3_{name}_{run.steps}.png"
                pictures.append((picture(filename, [surface(image_of(read(run.vtu)))], *view(self.case)),
                                 f"{name} relaxation, step {run.steps}"))
            parts.append(figures(pictures, 210))
        return parts

    def _submit_shapes(self, run):
        """As in the paper, the first step, the last one and three between them; the other shapes are removed."""
        steps = sorted({max(1, round(run.steps * i / 4)) for i in range(5)})
        prefix = Path(run.prefix)
        for shape in prefix.parent.glob(prefix.name + "_*.mesh"):
            if int(shape.stem.rsplit("_", 1)[1]) not in steps:
                shape.unlink()
        return [self.runs.shape(self.case, run.prefix, step) for step in steps]

    def _numbers(self, output, result):
        rows = [(f"paper, cow, {name} relaxation", values["steps"], float(values["seconds"]), "", "")
                for name, values in printed.FIGURE_2.items()]
        rows += [(f"ours, {self.case.name}, {name} relaxation", run.steps, run.seconds, *end_of(run))
                 for name, run in result.items()]
        columns = ["", "iterations", "seconds", "energy at the end", "|P(u)| at the end"]
        return table(output / "figure_2.csv", columns, rows, (0, 1))

    def _claims(self, result):
        stretch = {name: [value for _, value in curve(run, "distortion_energy")] for name, run in result.items()}
        peak = {name: f"peak {max(values):.4g} at step {values.index(max(values))}, end {values[-1]:.4g}"
                for name, values in stretch.items()}
        steps = [iterations(result[name]) for name in ("with", "without")]
        increases = all(b >= a for a, b in zip(stretch["with"], stretch["with"][1:]))
        return [claim("Fig. 2a", "with relaxation, the stretch energy increases monotonously", [increases], peak["with"]),
                claim("Fig. 2c", "without relaxation, the stretch energy reaches a peak before it decreases",
                      [max(stretch["without"]) > 2 * stretch["without"][-1]], peak["without"]),
                claim("Fig. 2", "relaxation needs fewer iterations", [steps[0] < steps[1]],
                      f"{against([steps])}; in the paper 46 against 500")]


class Relaxation_table:
    """Iterations and time of Newton's method with and without relaxation, by what is done to an indefinite Hessian."""
    STEPS = 250
    CASES = (("duck", "cube"), ("bone", "tet"), ("bone", "cube"), ("max", "polycube"), ("bimba", "cube"),
             ("sphinx", "cube"))
    SOLVERS = (("relaxation, full Hessian (the paper)", ["--full-hessian"]),
               ("no relaxation, shifted Hessian ([39])", ["--shifted-newton"]),
               ("no relaxation, full Hessian where it is definite", ["--full-hessian", "--relaxations", 0]),
               ("relaxation, partly projected Hessian (our default)", []),
               ("no relaxation, partly projected Hessian", ["--relaxations", 0]))
    SHIFTED, PROJECTED = 1, 4

    def __init__(self, runs):
        self.jobs = [[runs.soft(runs.case(model, domain), f"solver{i}", "--weight", "1e4", "--steps", self.STEPS, *options)
                      for i, (_, options) in enumerate(self.SOLVERS)] for model, domain in self.CASES]

    def parts(self, output):
        results = [[job.result() for job in jobs] for jobs in self.jobs]
        rows = [(f"{model} to {domain}, {name}", run.steps, int(sum(r["is_relaxing"] for r in run.log)), run.seconds,
                 *end_of(run), run.message)
                for (model, domain), runs in zip(self.CASES, results) for (name, _), run in zip(self.SOLVERS, runs)]
        self.claims = [self._claim(results, i, name) for i, name in
                       ((self.SHIFTED, "the shifted Hessian without relaxation"),
                        (self.PROJECTED, "the projected Hessian without relaxation"))]
        return [heading("Relaxation against plain Newton, w = 1e4"),
                paragraph(f"At most {self.STEPS} iterations, from the aligned source. With relaxation a step must decrease "
                          "the norm of the gradient, too. A Hessian that is not definite leads to relaxation, or it is "
                          "shifted by a multiple of the identity, or the Hessian of each cell loses its negative "
                          "eigenvalues."),
                table(output / "relaxation.csv",
                      ["", "iterations", "of them relaxing", "seconds", "energy", "|P(u)|", ""], rows)]

    @staticmethod
    def _claim(results, i, name):
        pairs = [(iterations(runs[0]), iterations(runs[i])) for runs in results]
        return claim("4.2", f"relaxation needs fewer iterations than {name}", [a < b for a, b in pairs], against(pairs))


class Weights_and_guesses:
    """The weight of the positions, and the initial guess, in the solver of the paper."""
    CASES = (("bone", "tet"), ("bone", "cube"), ("duck", "cube"), ("max", "polycube"))
    GROWING = ["--full-hessian", "--weight", 100, "--raises", 5]
    CHOICES = (("weights from 100 by factors of 25", GROWING),
               ("weight 1e8", ["--full-hessian"]),
               ("weights from 100 by factors of 25, from the source as it is", [*GROWING, "--start", "source"]),
               ("weights from 100 by factors of 25, from the source turned by a third", [*GROWING, "--start", "turned"]))
    ACUTE = 2  # the first cases, whose boundaries are hard to reach

    def __init__(self, runs):
        self.jobs = [[runs.soft(runs.case(model, domain), f"choice{i}", *options)
                      for i, (_, options) in enumerate(self.CHOICES)] for model, domain in self.CASES]

    def parts(self, output):
        results = [[job.result() for job in jobs] for jobs in self.jobs]
        rows = [(f"{model} to {domain}, {name}", run.steps, run.seconds, *end_of(run), measure(run, "inverted_cells"))
                for (model, domain), runs in zip(self.CASES, results) for (name, _), run in zip(self.CHOICES, runs)]
        acute = [(model, domain, *runs[:2]) for (model, domain), runs in list(zip(self.CASES, results))[:self.ACUTE]]
        guesses = [(iterations(runs[0]), iterations(run)) for runs in results for run in runs[2:]]
        self.claims = [
            claim("4.2", "for acute boundary constraints, weights that grow from 100 by factors of 25 work better than 1e8",
                  [condition for _, _, growing, single in acute for condition in
                   (iterations(growing) < iterations(single), end_of(growing)[1] < end_of(single)[1])],
                  "; ".join(f"{model} to {domain}: {against([(iterations(growing), iterations(single))])} iterations, |P(u)| = "
                            f"{against([(end_of(growing)[1], end_of(single)[1])])}" for model, domain, growing, single in acute)),
            claim("4.2", "the solver behaves better if the initial mesh approximates the target",
                  [a < b for a, b in guesses], f"iterations: {against(guesses)}")]
        return [heading("Weight of the positions, and initial guess"),
                paragraph("At most 500 iterations with the full Hessian and relaxation. The source as it is has been scaled to "
                          "the volume of the target, but neither turned nor moved; the turned one has been turned by a third "
                          "about the diagonal (1, 1, 1)."),
                table(output / "weights.csv", ["", "iterations", "seconds", "energy", "|P(u)|", "inverted cells"], rows)]


class Energies(Convergence_of_energies):
    """The same figures for the duck, and Table 1."""

    def __init__(self, runs):
        super().__init__(runs, runs.case("duck", "cube"))
        cases = {"duck": self.case, "max": runs.case("max", "polycube"), "sphinx": runs.case("sphinx", "cube")}
        self.fixed = {(model, energy): runs.ours(case, "fixed_" + energy, "--energy", energy, "--max-iterations", 300)
                      for model, case in cases.items() for energy in ENERGIES}

    def parts(self, output):
        parts = super().parts(output)
        soft = {energy: job.result() for energy, job in self.soft.items()}
        fixed = {key: job.result() for key, job in self.fixed.items()}
        parts.append(heading("Table 1: distortions and time with five energies"))
        rows, indices = [], []
        for energy in ENERGIES:
            row = printed.TABLE_1[energy]
            indices.append(len(rows))
            rows.append((f"paper, duck, {row.method}", *row.D, row.seconds, ""))
            rows.append((f"ours, duck, {row.method}, soft boundary", *self._row(soft[energy])))
            rows += [(f"ours, {model}, {row.method}, fixed boundary", *self._row(fixed[model, energy]))
                     for model in ("duck", "max", "sphinx")]
        parts.append(table(output / "table_1.csv", ["", *D_COLUMNS, "seconds", "inverted cells"], rows, indices))
        return parts

    @staticmethod
    def _row(run):
        return (*distortions(run), run.seconds, measure(run, "inverted_cells"))
