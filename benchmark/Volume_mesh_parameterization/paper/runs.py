"""Runs the programs on the cases, two at a time, and keeps what they write in one folder, from which a second start goes on."""
import csv
import ctypes
import hashlib
import json
import math
import os
import resource
import signal
import subprocess
import sys
from collections import namedtuple
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

Case = namedtuple("Case", "name source target")
# `measures`: of measure_map, for each program alike, or none if there is no map; `log`: a row a step; `vtu`: the map for
# pictures; `message`: why there is no map
Run = namedtuple("Run", "measures log vtu seconds steps message prefix")


class Runs:
    def __init__(self, build, data, folder, time_limit):
        """`time_limit` is in seconds of the processor, for each program."""
        self.build, self.data, self.folder, self.time_limit = Path(build), Path(data), Path(folder), time_limit
        self.folder.mkdir(parents=True, exist_ok=True)
        self.pool = ThreadPoolExecutor(2)
        self.driver = self.build / "examples/Volume_mesh_parameterization/parameterize_mesh_file"
        self.programs = self.build / "benchmark/Volume_mesh_parameterization/paper"
        self.jobs, self.commands = {}, {}
        self.seconds = {}  # of each run, also in an earlier start

    def case(self, model, domain):
        """A case of VOLMAP, or of the pairs if the domain is polycube."""
        if domain == "polycube":
            pairs = self.data / "pairs"
            return Case(model + "_polycube", pairs / f"{model}_source.mesh", pairs / f"{model}_polycube.mesh")
        volmap = self.data / "volmap"
        return Case(f"{model}_{domain}", volmap / f"{model}.mesh", volmap / f"{model}_{domain}.txt")

    def ours(self, case, label, *options):
        """The driver."""
        prefix = self._prefix(case, label)

        command = [self.driver, case.source, case.target, "--quiet", "--output", f"{prefix}.mesh",
                   "--report", f"{prefix}.report.json", *options]

        def run():
            kept = self._kept_run(command, prefix)
            report = Path(f"{prefix}.report.json")
            steps = 0 if kept["message"] or not report.exists() else json.loads(report.read_text())["iterations"]
            return self._measured(case, prefix, [], kept["seconds"], steps, kept["message"])
        return self._job(prefix, command, run)

    def soft(self, case, label, *options):
        """The method of the paper, with soft boundary, step by step."""
        return self._submit(case, label, "run_soft_boundary", [], options)

    def baseline(self, method, case, *options):
        return self._submit(case, "_".join(map(str, (method, *options))), "run_baseline", [method], options)

    def shape(self, case, prefix, step):
        """The map after one of the steps of a run that wrote them all."""
        return self.pool.submit(lambda: self._measured(case, f"{prefix}_{step}", [], 0, step, ""))

    def _submit(self, case, label, program, before, after):
        prefix = self._prefix(case, label)

        command = [self.programs / program, *before, case.source, case.target, prefix, *after]

        def run():
            kept = self._kept_run(command, prefix)
            log = read_log(f"{prefix}.csv")
            last = log[-1] if log else {"seconds": kept["seconds"], "step": 0}
            return self._measured(case, prefix, log, last["seconds"], int(last["step"]), kept["message"])
        return self._job(prefix, command, run)

    def _job(self, prefix, command, run):
        """Experiments may share a run, but not a name."""
        if self.commands.setdefault(prefix, command) != command:
            sys.exit(f"{prefix}: two runs have this name")
        if prefix not in self.jobs:
            self.jobs[prefix] = self.pool.submit(run)
        return self.jobs[prefix]

    def _kept_run(self, command, prefix):
        """Runs the program, unless the same program has ended before with the same arguments and limit."""
        words = list(map(str, command))
        key = {"command": words, "program": digest(words[0]), "time_limit": self.time_limit}
        record = Path(prefix + ".run.json")
        kept = json.loads(record.read_text()) if record.exists() else {}
        if kept.get("key") != key:
            Path(prefix + ".mesh").unlink(missing_ok=True)
            kept = {"key": key, **self._execute(words)}
            if kept["status"] >= 0 and Path(prefix + ".mesh").exists():  # whatever the program thinks of its map
                kept["message"] = ""
            unfinished = Path(prefix + ".unfinished.json")
            unfinished.write_text(json.dumps(kept))
            unfinished.rename(record)  # whole, or not at all
        self.seconds[prefix] = kept["seconds"]
        return kept

    def _measured(self, case, prefix, log, seconds, steps, message):
        if message:
            return Run(None, log, None, seconds, steps, message, prefix)
        name = f"{prefix}.measured"
        measured = self._execute([self.programs / "measure_map", case.source, case.target, f"{prefix}.mesh", name])
        if measured["status"] != 0:
            sys.exit(f"{prefix}.mesh: {measured['message']}")
        return Run(json.loads(Path(name + ".json").read_text()), log, name + ".vtu", seconds, steps, "", prefix)

    def _prefix(self, case, label):
        return str(self.folder / f"{case.name}.{label}")

    def _execute(self, command):
        """The processor time, the exit status or minus the signal that ended it, and a sentence on them."""
        print("  " + " ".join(Path(str(word)).name for word in command[:6]), flush=True)

        def prepare():
            resource.setrlimit(resource.RLIMIT_CPU, (self.time_limit, self.time_limit + 1))
            ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG: does not outlive a killed script
        with subprocess.Popen(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              preexec_fn=prepare, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}) as process:
            errors = process.stderr.read().strip().splitlines()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = -os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status)
        if process.returncode == -signal.SIGXCPU:
            message = f"ended after {self.time_limit} s"
        else:
            message = errors[-1] if errors else f"exit status {process.returncode}"
        return {"seconds": usage.ru_utime + usage.ru_stime, "status": process.returncode, "message": message}


def digest(filename):
    return hashlib.sha256(Path(filename).read_bytes()).hexdigest()


def read_log(filename):
    """The rows that are whole."""
    if not Path(filename).exists():
        return []
    with open(filename, newline="") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file) if None not in row.values()]


def measure(run, key):
    """Infinite without a map."""
    return run.measures[key] if run.measures else math.inf


def distortions(run):
    return tuple(measure(run, key) for key in ("angle_mean", "angle_max", "volume_mean", "volume_max"))


def iterations(run):
    """Infinite if the run was ended."""
    return math.inf if run.message else run.steps
