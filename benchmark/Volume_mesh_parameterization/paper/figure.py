"""Draws Fig. 6 and 7 of the paper for one case, and writes a page: figure.py OUTPUT SOURCE TARGET BUILD.

Called by reproduce_figure.sh."""
import sys
from pathlib import Path

import page
import printed_values as printed
from page import claim, figures, heading, number, table
from plots import plot
from runs import Case, Runs, distortions, iterations

ENERGIES = ("dirichlet", "arap", "stretch", "lscm", "lpm")


def curve(run, *keys):
    return [(row["step"], sum(row[key] for key in keys)) for row in run.log]


def against(pairs):
    return ", ".join(f"{number(a)} against {number(b)}" for a, b in pairs)


class Convergence_of_energies:
    """Fig. 6 and 7: five energies, with the inverse spline barrier where they have none, w = 1e8."""

    def __init__(self, runs, case):
        self.case = case
        self.soft = {energy: runs.soft(case, "soft_" + energy, "--energy", energy, "--full-hessian") for energy in ENERGIES}

    def parts(self, output):
        soft = {energy: job.result() for energy, job in self.soft.items()}
        keys = ("distortion_energy", "position_energy")
        self.claims = self._claims(soft)
        parts = [heading(f"Fig. 6 and 7: convergence with five energies, {self.case.name.replace('_', ' to the ')}, w = 1e8"),
                 self._steps(output, soft)]
        for name, energies in (("figure_6", ENERGIES[:3]), ("figure_7", ENERGIES[3:])):
            panels = [(energy, "energy", [("total", curve(soft[energy], *keys))]) for energy in energies]
            parts.append(figures([(plot(output / f"{name}.svg", panels, len(panels)), name.replace("_", " "))],
                                 370 * len(panels)))
        return parts

    def _steps(self, output, soft):
        rows = [("paper, read off the plots", *(printed.FIGURES_6_7[energy] for energy in ENERGIES)),
                ("ours", *(soft[energy].steps for energy in ENERGIES))]
        return table(output / "figures_6_7.csv", ["iterations", *ENERGIES], rows, (0,))

    @staticmethod
    def _claims(soft):
        D = {energy: distortions(run) for energy, run in soft.items()}
        factor = min(D[energy][1] for energy in ENERGIES if energy != "stretch") / D["stretch"][1]
        volumes = [D[energy][3] for energy in ENERGIES]
        steps = {energy: iterations(run) for energy, run in soft.items()}
        seconds = {energy: run.seconds for energy, run in soft.items()}
        three = [steps[energy] for energy in ENERGIES[:3]]
        return [
            claim("Fig. 6", "Dirichlet, ARAP and stretch converge alike, within a factor of 2", [max(three) <= 2 * min(three)],
                  f"{', '.join(map(number, three))} iterations; in the paper about 18, 12, 14"),
            claim("Table 1", "stretch has much lower distortions of angles, at least by a factor of 5 in Dma", [factor >= 5],
                  f"factor {factor:.1f}; in the paper 19.2"),
            claim("Table 1", "the volumes are distorted alike by all energies, within a factor of 1.2 in Dmv",
                  [max(volumes) <= 1.2 * min(volumes)], ", ".join(f"{name} {x:.4g}" for name, x in zip(ENERGIES, volumes))),
            claim("Table 1", "stretch takes longer than Dirichlet and ARAP",
                  [seconds["stretch"] > seconds[energy] for energy in ENERGIES[:2]],
                  ", ".join(f"{energy} {seconds[energy]:.2f} s" for energy in ENERGIES[:3])),
            claim("Fig. 7", "LPM converges faster than LSCM", [steps["lpm"] < steps["lscm"]],
                  f"{against([(steps['lpm'], steps['lscm'])])} iterations; in the paper about 25 against 70"),
            claim("Table 1", "LPM has lower distortions than LSCM", [a < b for a, b in zip(D["lpm"], D["lscm"])],
                  against(zip(D["lpm"], D["lscm"])) + " for Daa, Dma, Dav, Dmv")]


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    output, source, target, build = map(Path, sys.argv[1:])
    figure = Convergence_of_energies(Runs(build, build, output / "runs", 300), Case(target.stem, source, target))
    parts = figure.parts(output)
    parts.insert(0, table(output / "claims.csv", page.Claim._fields, figure.claims))
    (output / "index.html").write_text(page.page("Stretch-minimizing volumetric parameterization: five energies", parts))
    print(*(f"{place}, {text}: {verdict} ({numbers})" for place, text, verdict, numbers in figure.claims), sep="\n")
    print(f"Open {output / 'index.html'}")


if __name__ == "__main__":
    main()
