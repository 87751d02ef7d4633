"""Runs the programs on the cases, two at a time, and keeps what they write in one folder."""
import csv
import json
import os
import subprocess
import sys
from collections import namedtuple
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from check_map import boundary_facets, read_mesh  # noqa: E402

Case = namedtuple("Case", "name source target")
# `measures`: of measure_map, for each program alike; `log`: a row a step; `vtu`: the map for pictures
Run = namedtuple("Run", "measures log vtu seconds steps message prefix")

TIME_LIMIT = 900


class Runs:
    def __init__(self, build, data, folder):
        self.build, self.data, self.folder = Path(build), Path(data), Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.pool = ThreadPoolExecutor(2)
        self.driver = self.build / "examples/Volume_mesh_parameterization/parameterize_mesh_file"
        self.programs = self.build / "benchmark/Volume_mesh_parameterization/paper"

    def case(self, model, domain):
        """A case of VOLMAP, or of the pairs if the domain is polycube."""
        if domain == "polycube":
            pairs = self.data / "pairs"
            return Case(model + "_polycube", pairs / f"{model}_source.mesh", pairs / f"{model}_polycube.mesh")
        volmap = self.data / "volmap"
        return Case(f"{model}_{domain}", volmap / f"{model}.mesh", volmap / f"{model}_{domain}.txt")

    def refined(self, case):
        """The case with the vertices that make it possible, for methods that cannot add them by themselves."""
        source, target = self.folder / f"{case.name}_refined.mesh", self.folder / f"{case.name}_refined.txt"
        refined = Case(case.name + "_refined", source, target)
        if target.exists():
            return refined
        self._execute([self.driver, case.source, case.target, "--quiet", "--refine", "--boundary", "fixed",
                       "--max-iterations", 100, "--refined-source", source])
        boundary = {v for facet in boundary_facets(read_mesh(case.source).cells) for v in facet}
        points = read_mesh(case.target).points
        target.write_text("".join("%d %r %r %r\n" % (v, *points[v]) for v in sorted(boundary)))
        return refined

    def ours(self, case, label, *options):
        """The driver."""
        def run():
            prefix = self._prefix(case, label)
            process = self._execute([self.driver, case.source, case.target, "--quiet",
                                     "--output", f"{prefix}.mesh", "--report", f"{prefix}.report.json", *options])
            report = json.loads(Path(f"{prefix}.report.json").read_text())
            if not Path(f"{prefix}.mesh").exists():
                sys.exit(f"{case.name}, {label}: {process.stderr}")
            return self._checked(case, prefix, [], report["seconds_total"], report["iterations"], report["status"])
        return self.pool.submit(run)

    def soft(self, case, label, *options):
        """The method of the paper, with soft boundary, step by step."""
        return self._submit(case, label, "run_soft_boundary", [], options)

    def baseline(self, method, case, *options):
        return self._submit(case, "_".join(map(str, (method, *options))), "run_baseline", [method], options)

    def shape(self, case, prefix, step):
        """The map after one of the steps of a run that wrote them all."""
        return self.pool.submit(lambda: self._checked(case, f"{prefix}_{step}", [], 0, step, ""))

    def _submit(self, case, label, program, before, after):
        def run():
            prefix = self._prefix(case, label)
            self._execute([self.programs / program, *before, case.source, case.target, prefix, *after])
            with open(f"{prefix}.csv", newline="") as file:
                log = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
            last = log[-1] if log else {"seconds": 0, "step": 0}
            return self._checked(case, prefix, log, last["seconds"], int(last["step"]), "")
        return self.pool.submit(run)

    def _checked(self, case, prefix, log, seconds, steps, message):
        name = f"{prefix}.measured"
        process = self._execute([self.programs / "measure_map", case.source, case.target, f"{prefix}.mesh", name])
        if process.returncode != 0:
            sys.exit(process.stderr)
        measures = json.loads(Path(name + ".json").read_text())
        return Run(measures, log, name + ".vtu", seconds, steps, message, prefix)

    def _prefix(self, case, label):
        return str(self.folder / f"{case.name}.{label}")

    def _execute(self, command):
        print("  " + " ".join(Path(str(word)).name for word in command[:6]), flush=True)
        return subprocess.run(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              timeout=TIME_LIMIT, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})


def distortions(run):
    return tuple(run.measures[key] for key in ("angle_mean", "angle_max", "volume_mean", "volume_max"))
