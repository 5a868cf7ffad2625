"""Figures of `castaway calibrate`."""

import json

from measuring.lab import LOGS, table

BENCH = ["bench", "calibration", "--trials", "20", "--seed", "2", "-j", "2", "--json"]


def calibration(lab):
    settings = {}
    for setting in json.loads(lab.run(BENCH)):
        settings.setdefault(setting["name"], []).append(setting)
    rows = []
    for name, found in settings.items():
        errors = sorted(abs(each["found"] - each["truth"]) / abs(each["truth"]) for each in found)
        count = lambda what: f"{sum(each[what] for each in found)} of {len(found)}"
        rows.append([name, count("near"), count("held"), f"{100 * errors[len(errors) // 2]:.1f} %", f"{100 * errors[-1]:.1f} %"])
    return table(["setting", "near enough", "truth in the interval", "median error", "largest"], rows)


def likeness(lab):
    rows = []
    for name in LOGS:
        twin = json.loads(lab.run(["calibrate", str(lab.logs / name), "--out", name, "--json"]))
        for each in twin["likeness"]:
            values = [f"{each[key]:.3g}" for key in ["log_median", "log_p90", "twin_median", "twin_p90", "wasserstein"]]
            rows.append([name, f"{each['name']} {'[' + each['unit'] + ']' if each['unit'] else ''}".strip(), *values])
    return table(["log", "", "log: median", "90 %", "twin: median", "90 %", "Wasserstein distance"], rows)
