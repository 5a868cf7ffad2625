"""Localizers that are not castaway's own, beside those that are."""

import json
import pathlib
import subprocess

from measuring.lab import LOGS, figure, mean, mean_of, percent, share, table

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = ["mh_amcl", "amcl", "mrpt", "particle_filter", "dead_reckoning"]


def python_with_numpy():
    for python in ["python3", "/usr/bin/python3"]:
        if subprocess.run([python, "-c", "import numpy"], capture_output=True).returncode == 0:
            return python
    raise SystemExit("measure: foreign-localizers needs python3-numpy")


def choice(lab):
    """The options that choose the localizers. MRPT's is built with the tests."""
    programs = ROOT / "examples/program"
    texts = [
        "mh_amcl", "amcl", f"library:{lab.castaway.parent / 'tests/program/libmrpt.so'}",
        f"program:{python_with_numpy()} {programs / 'particle_filter.py'}", f"program:{python_with_numpy()} {programs / 'dead_reckoning.py'}",
    ]
    return [part for text in texts for part in ("--localizer", text)]


def default_kidnap(lab):
    lab.run(["run", "--seeds", "20", "-j", "2", "--set", "outputs.snapshots=false", *choice(lab), "--out", "foreign"])
    summary = lab.json_of("foreign/summary.json")
    timings = [lab.json_of(f"foreign/seed-{seed}/timing.json") for seed in range(1, 21)]
    cells = {}
    for name in NAMES:
        recovery = summary["localizers"][name]["recovery"]
        cells[name] = [
            f"{recovery['recovered']} of {recovery['events']}", figure(recovery["time_s"]["mean"], "{:.2f}", " s"),
            figure(mean_of(summary, f"{name}.tracking_error_m.mean"), "{:.3f}", " m"), percent(mean_of(summary, f"{name}.wrong_lock_share")),
            figure(mean([timing["localizers"][name]["update_ms"]["mean"] for timing in timings]), "{:.2f}", " ms"),
        ]
    return cells


def kidnaps_in_the_office(lab):
    found = json.loads(lab.run(["bench", "kidnaps", "--world", "office", "--kidnaps", "40", *choice(lab), "--json"]))
    return {name: [f"{each['recovered']['count']} of {found[0]['kidnaps']}"] for name, each in found[0]["localizers"].items()}


def recorded_logs(lab):
    rows = json.loads(lab.run(["evaluate", *(str(lab.logs / name) for name in LOGS), *choice(lab), "--starts", "8", "--kidnaps", "8", "--json"]))
    cells = {}
    for name in NAMES:
        own = [row for row in rows if row["localizer"] == name]
        recovered = {"recovered": sum(row[kind]["recovered"] for row in own for kind in ["starts", "kidnaps"]),
                     "trials": sum(row[kind]["trials"] for row in own for kind in ["starts", "kidnaps"])}
        cells[name] = [share(recovered)]
    return cells


def foreign_localizers(lab):
    run, office, logs = default_kidnap(lab), kidnaps_in_the_office(lab), recorded_logs(lab)
    rows = [[f"`{name}`", *run[name], *office[name], *logs[name]] for name in NAMES]
    return table(["localizer", "default kidnap, 20 seeds", "recovery time", "tracking error", "wrong without saying so", "update",
                  "office, 40 kidnaps", "three logs: starts and kidnaps"], rows)
