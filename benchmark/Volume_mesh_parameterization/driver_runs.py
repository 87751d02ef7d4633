"""Runs the driver on cases, checks what it writes in exact arithmetic, and prints one line a case."""
import json
import statistics
import subprocess
import tempfile
from pathlib import Path

from check_map import check
from tables import write_csv, write_json

CLAIMS = {0: "exact", 1: "flip-free", 2: "bad input", 3: "no map"}


def run_driver(driver, case, folder, options, time_limit):
    """The exit code, the last line of standard error and the report."""
    report = folder / "report.json"
    command = [driver, case.source, case.target, "--quiet", "--report", report, "--output", folder / "map.mesh",
               "--refined-source", folder / "refined.mesh", *options]
    try:
        run = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, timeout=time_limit)
    except subprocess.TimeoutExpired:
        return None, "time limit", {}
    errors = run.stderr.strip().splitlines()
    return run.returncode, errors[-1] if errors else "", json.loads(report.read_text()) if report.exists() else {}


def run_case(driver, case, options, time_limit):
    """One row of the table."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        code, error, report = run_driver(driver, case, folder, options, time_limit)
        claim = CLAIMS.get(code, "crash" if code is not None else "time limit")
        row = {"case": case.name, "cells": report.get("cells"), "exit_code": code, "status": claim}
        verdict = None
        if code in (0, 1):
            verdict = check(case.source, case.target, folder / "refined.mesh", folder / "map.mesh")
            row["status"] = status(verdict)
            row["refuted"] = verdict.fault != "" or row["status"] not in ("exact", claim)

    added = report.get("added_vertices")
    row["added_vertices"] = added
    if added is not None:
        row["added_percent"] = 100 * added / max(1, report["vertices"] - added)
    row["inverted_cells"] = verdict.inverted_cells if verdict else report.get("inverted_cells")
    row["missed_vertices"] = verdict.missed_vertices if verdict else None
    for key in ("boundary_residual", "iterations", "untangling_iterations", "seconds_to_flip_free", "seconds_total",
                "energy_value"):
        row[key] = report.get(key)
    row.update((f"D_{key}", value) for key, value in report.get("distortion_at_source_volume", {}).items())
    row["message"] = (verdict.fault if verdict else "") or report.get("status") or error
    return row


def status(verdict):
    if verdict.fault or verdict.inverted_cells:
        return "refuted"
    return "flip-free" if verdict.missed_vertices else "exact"


LINE = [("case", "<20"), ("cells", ">7"), ("exit_code", ">4"), ("status", "<10"), ("added_vertices", ">6"),
        ("added_percent", ">8.3f"), ("inverted_cells", ">8"), ("boundary_residual", ">9.2g"), ("iterations", ">5"),
        ("seconds_to_flip_free", ">8.2f"), ("seconds_total", ">8.2f"), ("energy_value", ">12.7g"),
        ("D_angle_mean", ">8.3f"), ("D_angle_max", ">8.1f"), ("D_volume_mean", ">8.3f"), ("D_volume_max", ">9.3g")]
TITLES = ["case", "cells", "exit", "status", "added", "added%", "inverted", "residual", "steps", "s free", "s total",
          "energy", "Daa", "Dma", "Dav", "Dmv"]


def width(form):
    return form.split(".")[0]


def line(row):
    words = [format(row[key], form) if row.get(key) is not None else format("-", width(form)) for key, form in LINE]
    return " ".join(words) + ("" if row["status"] == "exact" else "  " + row["message"])


def summary(rows):
    """Success rates, in all and by domain, and the share of added vertices."""
    domain_of = [row["case"].rsplit("_", 1)[1] for row in rows]
    rates = {}
    for name in dict.fromkeys(["all", *domain_of]):
        chosen = [row for row, domain in zip(rows, domain_of) if name in ("all", domain)]
        rates[name] = {
            "cases": len(chosen),
            "exact": sum(row["status"] == "exact" for row in chosen),
            "flip_free": sum(row["status"] in ("exact", "flip-free") for row in chosen)}
    added = [row["added_percent"] for row in rows if row.get("added_percent") is not None]
    return {"success": rates,
            "refuted": sum(bool(row.get("refuted")) for row in rows),
            "added_percent_median": statistics.median(added) if added else None,
            "added_percent_worst": max(added, default=None)}


def print_titles():
    print(" ".join(format(title, width(form)) for title, (_, form) in zip(TITLES, LINE)))


def print_summary(result):
    for domain, rate in result["success"].items():
        n = max(1, rate["cases"])
        print(f"{domain + ':':<10} {rate['exact']} of {rate['cases']} exact ({100 * rate['exact'] / n:.1f} %),"
              f" {rate['flip_free']} flip-free ({100 * rate['flip_free'] / n:.1f} %)")
    if result["added_percent_median"] is not None:
        print(f"added vertices: median {result['added_percent_median']:.3f} %,"
              f" worst {result['added_percent_worst']:.3f} %")
    print(f"claims refuted by the check: {result['refuted']}")


def write_tables(prefix, options, result, rows):
    write_csv(prefix + ".csv", rows)
    write_json(prefix + ".json", {"options": options, "summary": result, "cases": rows})
