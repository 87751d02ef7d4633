"""The experiments on convergence: Fig. 2 and 3, Fig. 6 and 7, Table 1, and relaxation on several models."""
from pathlib import Path

from page import claims, figures, heading, paragraph, table

import printed_values as printed
from plots import plot
from render import image_of, picture, read, surface
from runs import distortions
from views import view

ENERGIES = ("dirichlet", "arap", "stretch", "lscm", "lpm")
D_COLUMNS = ["Daa", "Dma", "Dav", "Dmv"]


def curve(run, *keys):
    return [(row["step"], sum(row[key] for key in keys)) for row in run.log]


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
            self._remove_shapes(result[name])
        return parts

    @staticmethod
    def _remove_shapes(run):
        prefix = Path(run.prefix)
        for shape in prefix.parent.glob(prefix.name + "_*"):
            shape.unlink()

    def _submit_shapes(self, run):
        """As in the paper, the first step, the last one and three between them."""
        steps = sorted({max(1, round(run.steps * i / 4)) for i in range(5)})
        return [self.runs.shape(self.case, run.prefix, step) for step in steps]

    def _numbers(self, output, result):
        rows = [(f"paper, cow, {name} relaxation", values["steps"], float(values["seconds"]), "", "")
                for name, values in printed.FIGURE_2.items()]
        rows += [(f"ours, {self.case.name}, {name} relaxation", run.steps, run.seconds,
                  run.log[-1]["distortion_energy"] + run.log[-1]["position_energy"], run.log[-1]["distance"])
                 for name, run in result.items()]
        columns = ["", "iterations", "seconds", "energy at the end", "|P(u)| at the end"]
        return table(output / "figure_2.csv", columns, rows, (0, 1))


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

    def __init__(self, runs):
        self.jobs = [(model, name, runs.soft(runs.case(model, domain), f"solver{i}", "--weight", "1e4",
                                             "--steps", self.STEPS, *options))
                     for model, domain in self.CASES for i, (name, options) in enumerate(self.SOLVERS)]

    def parts(self, output):
        rows = []
        for i, (model, domain) in enumerate(self.CASES):
            for _, name, job in self.jobs[len(self.SOLVERS) * i:len(self.SOLVERS) * (i + 1)]:
                run = job.result()
                end = run.log[-1]
                rows.append((f"{model} to {domain}, {name}", run.steps, int(sum(r["is_relaxing"] for r in run.log)),
                             run.seconds, end["distortion_energy"] + end["position_energy"], end["distance"]))
        return [heading("Relaxation against plain Newton, w = 1e4"),
                paragraph(f"At most {self.STEPS} iterations, from the aligned source. With relaxation a step must decrease "
                          "the norm of the gradient, too. A Hessian that is not definite leads to relaxation, or it is "
                          "shifted by a multiple of the identity, or the Hessian of each cell loses its negative "
                          "eigenvalues."),
                table(output / "relaxation.csv",
                      ["", "iterations", "of them relaxing", "seconds", "energy", "|P(u)|"], rows)]


class Energies:
    """Fig. 6 and 7, Table 1: five energies, with the inverse spline barrier where they have none, w = 1e8."""

    def __init__(self, runs):
        self.case = runs.case("duck", "cube")
        self.soft = {energy: runs.soft(self.case, "soft_" + energy, "--energy", energy) for energy in ENERGIES}
        cases = {"duck": self.case, "max": runs.case("max", "polycube"), "sphinx": runs.case("sphinx", "cube"),
                 "hand": runs.refined(runs.case("hand", "polycube"))}
        self.fixed = {(model, energy): runs.ours(case, "fixed_" + energy, "--energy", energy, "--max-iterations", 300)
                      for model, case in cases.items() for energy in ENERGIES}

    def parts(self, output):
        soft = {energy: job.result() for energy, job in self.soft.items()}
        fixed = {key: job.result() for key, job in self.fixed.items()}
        keys = ("distortion_energy", "position_energy")
        parts = [heading("Fig. 6 and 7: convergence with five energies, duck to the cube, w = 1e8"),
                 self._steps(output, soft)]
        for name, energies in (("figure_6", ENERGIES[:3]), ("figure_7", ENERGIES[3:])):
            panels = [(energy, "energy", [("total", curve(soft[energy], *keys))]) for energy in energies]
            parts.append(figures([(plot(output / f"{name}.svg", panels, len(panels)), name.replace("_", " "))],
                                 370 * len(panels)))
        parts += [heading("Table 1: distortions and time with five energies"), self._claims(soft)]
        rows, indices = [], []
        for energy in ENERGIES:
            row = printed.TABLE_1[energy]
            indices.append(len(rows))
            rows.append((f"paper, duck, {row.method}", *row.D, row.seconds, ""))
            rows.append((f"ours, duck, {row.method}, soft boundary", *self._row(soft[energy])))
            rows += [(f"ours, {model}, {row.method}, fixed boundary", *self._row(fixed[model, energy]))
                     for model in ("duck", "max", "sphinx", "hand")]
        parts.append(table(output / "table_1.csv", ["", *D_COLUMNS, "seconds", "inverted cells"], rows, indices))
        return parts

    def _steps(self, output, soft):
        rows = [("paper, read off the plots", *(printed.FIGURES_6_7[energy] for energy in ENERGIES)),
                ("ours", *(soft[energy].steps for energy in ENERGIES))]
        return table(output / "figures_6_7.csv", ["iterations", *ENERGIES], rows, (0,))

    @staticmethod
    def _row(run):
        return (*distortions(run), run.seconds, run.measures["inverted_cells"])

    @staticmethod
    def _claims(soft):
        largest = {energy: distortions(run)[1] for energy, run in soft.items()}
        factor = min(x for energy, x in largest.items() if energy != "stretch") / largest["stretch"]
        inverted = [run.measures["inverted_cells"] for run in soft.values()]
        return claims([("the stretch energy has the lowest maximal distortion of angles, by a factor of 5 or more",
                        factor >= 5, f"factor {factor:.1f}; in the paper 19.2"),
                       ("all five maps of the duck are without inverted cells", not any(inverted),
                        f"inverted cells: {inverted}")])
