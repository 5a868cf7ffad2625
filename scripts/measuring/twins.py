"""Figures of `castaway calibrate` and `castaway twin`."""

import json

from measuring.lab import LOGS, table

BENCH = ["bench", "calibration", "--trials", "20", "--seed", "2", "-j", "2", "--json"]
LOCALIZERS = ["mh_amcl", "mh_amcl:paper", "mh_amcl:published", "amcl", "amcl:amcl-recovery", "amcl:amcl-prob", "amcl:amcl-global"]
PREDICTED = ["fhw", "intel", "aces", "edmonton", "belgioioso", "csail", "freiburg-101", "seattle", "acapulco", "freiburg-079", "infinite-corridor"]


def calibration(lab):
    settings = {}
    for setting in json.loads(lab.run(BENCH)):
        settings.setdefault(setting["name"], []).append(setting)
    rows = []
    for name, found in settings.items():
        errors = sorted(abs(each["found"] - each["truth"]) / abs(each["truth"]) for each in found)
        rows.append([name, *counts(found), f"{100 * errors[len(errors) // 2]:.1f} %", f"{100 * errors[-1]:.1f} %"])
    everything = [setting for found in settings.values() for setting in found]
    rows.append(["all", *counts(everything), "", ""])
    return table(["setting", "near enough", "truth in the interval", "median error", "largest"], rows)


def counts(found):
    return [f"{sum(each[what] for each in found)} of {len(found)}" for what in ["near", "held"]]


def likeness(lab):
    rows = []
    for name in LOGS:
        twin = json.loads(lab.run(["calibrate", str(lab.logs / name), "--out", name, "--json"]))
        for each in twin["likeness"]:
            values = [f"{each[key]:.3g}" for key in ["log_median", "log_p90", "twin_median", "twin_p90", "wasserstein"]]
            rows.append([name, f"{each['name']} {'[' + each['unit'] + ']' if each['unit'] else ''}".strip(), *values])
    return table(["log", "", "log: median", "90 %", "twin: median", "90 %", "Wasserstein distance"], rows)


def predictions(lab):
    logs = [str(lab.logs / name) for name in PREDICTED]
    choice = [part for name in LOCALIZERS for part in ("--localizer", name)]
    found = json.loads(lab.run(["twin", *logs, *choice, "--starts", "24", "--kidnaps", "24", "--out", "twins", "-j", "2", "--json"]))
    rows = [[each["localizer"], *(f"{100 * each[key]:.1f} %" for key in ["measured", "predicted"]), f"{100 * each['bias']:+.1f}",
             f"{100 * each['apart']:.1f}", f"{each['tracked_near']} of {each['tracked']}"] for each in found["localizers"]]
    tau = found["kendall_tau"]
    low, high = tau["interval"]
    tracking = [[row["log"], *(f"{row[side]['tracking_no_alarm_m']:.3f}" for side in ["on_log", "in_twin"])]
                for row in found["rows"] if row["localizer"] == "mh_amcl"]
    return (table(["localizer", "success: logs", "twins", "bias [points]", "apart, mean over logs [points]", "tracking within 25 %"], rows) +
            f"\nKendall's tau of both rankings: {tau['value']:.2f} ({low:.2f} to {high:.2f}).\n\n" +
            table(["tracking error of `mh_amcl` [m]", "log", "twin"], tracking))


DRIFTS = [("drift_along", 3), ("drift_yaw_deg", 2), ("drift_turn_deg", 2)]  # Key, digits.


def with_interval(value):
    """In thousandths."""
    low, high = value["interval"]
    return f"{1000 * value['value']:.0f} ({1000 * low:.0f} to {1000 * high:.0f})"


def fits(lab):
    rows = []
    for name in PREDICTED:
        fit = json.loads(lab.run(["calibrate", str(lab.logs / name), "--out", f"fits-{name}", "--json"]))
        odometry = fit["odometry"]
        rows.append([name, *(f"{odometry[key]['value']:.{digits}f}" for key, digits in DRIFTS),
                     with_interval(odometry["stamp_sigma_s"]), with_interval(odometry["drive_in_base"]["x_m"]),
                     f"{100 * odometry['outlier_share']:.1f}", f"{1000 * fit['range_noise']['sigma_typical_m']['value']:.0f}",
                     f"{fit['mixed_pixels']['divergence_deg']['value']:.2f}"])
    return table(["log", "walk along [m/√m]", "yaw by travel [°/√m]", "by turn [°/√rad]", "error of stamps [ms]", "drive ahead of base [mm]",
                  "outliers [%]", "noise [mm]", "beam [°]"], rows)
