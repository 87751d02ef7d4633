"""Starts runs of reproduce_paper with small programs in place of those that it runs, ends them, and starts them again.

Usage: check_paper_runs.py FOLDER_OF_RUNS_PY
"""
import sys
import tempfile
from pathlib import Path

# Writes a map and a log of two steps. Begins endless work after the first one for the target "endless", and fails for "bad".
STEPS = """#!/usr/bin/env python3
import pathlib, sys
source, target, name = sys.argv[1:4]
with open(pathlib.Path(name).parent / "starts", "a") as file:
    print(name, file=file)
if target == "bad":
    sys.exit("no such target")
log = open(name + ".csv", "w")
print("step,seconds", "1,0.5", sep="\\n", file=log, flush=True)
while target == "endless":
    pass
print("2,0.75", file=log)
pathlib.Path(name + ".mesh").write_text("map")
"""
MEASURE = """#!/usr/bin/env python3
import pathlib, sys
pathlib.Path(sys.argv[4] + ".json").write_text('{"angle_max": 3, "inverted_cells": 0}')
"""


def write_program(filename, text):
    filename.parent.mkdir(parents=True, exist_ok=True)
    filename.write_text(text)
    filename.chmod(0o755)


def main(folder_of_runs):
    sys.path.insert(0, folder_of_runs)
    from runs import Case, Runs, iterations, measure
    with tempfile.TemporaryDirectory() as name:
        build, folder = Path(name) / "build", Path(name) / "kept"
        program = build / "benchmark/Volume_mesh_parameterization/paper/run_soft_boundary"
        write_program(program, STEPS)
        write_program(program.with_name("measure_map"), MEASURE)
        targets = ("good", "endless", "bad")

        def start():
            runs = Runs(build, name, folder, 1)
            jobs = [runs.soft(Case(target, "source", target), "label") for target in (*targets, "good")]
            results = [job.result() for job in jobs]
            assert jobs[0] is jobs[-1]  # of an experiment that shares a run
            assert sorted(runs.seconds) == sorted(str(folder / f"{target}.label") for target in targets)
            return results[:3], [Path(line).name for line in (folder / "starts").read_text().split()]

        runs = Runs(build, name, folder, 1)
        for method in ("dirichlet", "arap"):  # runs of one name would otherwise be taken for each other
            try:
                runs.soft(Case("good", "source", "good"), "one_name", method)
            except SystemExit as error:
                assert method == "arap" and "two runs have this name" in str(error)
            else:
                assert method == "dirichlet"
        runs.jobs[str(folder / "good.one_name")].result()
        (folder / "starts").unlink()

        first, starts = start()
        assert sorted(starts) == ["bad.label", "endless.label", "good.label"], starts
        good, endless, bad = first
        assert (good.message, good.steps, good.seconds, measure(good, "angle_max")) == ("", 2, 0.75, 3), good
        assert (endless.message, endless.steps, endless.measures) == ("ended after 1 s", 1, None), endless
        assert iterations(endless) == measure(endless, "angle_max") == float("inf") and iterations(good) == 2
        assert bad.message == "no such target" and not bad.log, bad

        second, starts = start()  # goes on from what is kept
        assert second == first and len(starts) == 3, (second, starts)

        (folder / "good.label.run.json").unlink()  # as if killed before it had ended
        (folder / "good.label.mesh").write_text("half of a map")
        third, starts = start()
        assert third == first and starts[3:] == ["good.label"] and (folder / "good.label.mesh").read_text() == "map", starts

        program.write_text(STEPS.replace("0.75", "0.875"))  # another build does not mix with what is kept
        fourth, starts = start()
        assert fourth[0].seconds == 0.875 and len(starts) == 7, (fourth, starts)
    print("Finished runs are kept, and ended ones are rows.")


if __name__ == "__main__":
    main(sys.argv[1])
