"""Figures of odometry, lidars and faults."""

import collections
import csv

from measuring.lab import NO_PICTURES, figure, percent, share, table

NOTHING, GLASS = "0", "6"  # Classes of beams: docs/datasets.md.


def odometry_rows(text):
    rows = []
    for line in text.splitlines()[1:]:
        words = line.rsplit(None, 3)
        if len(words) == 4:
            rows.append([f"`{words[0].strip()}`", *words[1:]])
    return rows


def odometry_profiles(lab):
    return table(["", "segments of 10 m", "%", "deg/m"], odometry_rows(lab.program("workbench", ["odometry"])))


def odometry_logs(lab):
    logs = [lab.log(name, "log.carmen.gz") for name in ["aces", "freiburg-079", "intel"]]
    rows = odometry_rows(lab.program("workbench", ["odometry", *logs]))[-len(logs):]
    names = [[f"recorded: {name}", *row[1:]] for name, row in zip(["aces", "freiburg-079", "intel"], rows)]
    return table(["", "segments of 10 m", "%", "deg/m"], names)


def real_lidar(lab):
    rows = []
    for words, scenario in [("default", "lab/kidnap"), ("RPLIDAR A2, worn wheels", "lab/real-lidar")]:
        each = lab.summary([scenario, *NO_PICTURES], scenario.replace("/", "-"))["localizers"]
        cells = []
        for name in ["mh_amcl", "amcl"]:
            time = each[name]["recovery"]["time_s"]
            cells += [share(each[name]["recovery"]) + (f", {time['mean']:.2f} s" if time["mean"] else ""),
                      figure(each[name]["tracking_error_m"]["mean"], "{:.3f}", " m")]
        rows.append([words, *cells])
    return table(["", "`mh_amcl`: recovered, after", "tracking error", "`amcl`: recovered, after", "tracking error"], rows)


def glass(lab):
    rows = []
    for profile in ["ideal", "ust-10lx"]:
        out = "glass-" + profile
        lab.run(["run", "--world", "home", "--duration", "60", "--set", "events=[]", "--set", f"lidar.profile={profile}",
                 "--set", "outputs.tables=csv", *NO_PICTURES, "--out", out])
        rows.append([f"`{profile}`", *(percent(part) for part in beam_shares(lab.folder / out))])
    return table(["profile", "objects", "glass", "nothing"], rows)


def beam_shares(run):
    """Shares of all beams that end on objects, on glass and on nothing."""
    csv.field_size_limit(1 << 30)
    ends = collections.Counter()
    with open(run / "tables/scans.csv", newline="") as rows:
        for row in csv.DictReader(rows):
            ends.update(row["classes"].split())
    total = sum(ends.values())
    return [(total - ends[GLASS] - ends[NOTHING]) / total, ends[GLASS] / total, ends[NOTHING] / total]


def faults(lab):
    rows = []
    for fault in lab.summary(["lab/faults", *NO_PICTURES], "faults")["faults"]:
        cells = []
        for name in ["mh_amcl", "amcl"]:
            each = fault["localizers"][name]
            cells += [figure(each["mean_error_m"], "{:.2f}", " m"), percent(each["wrong_confident_share"], 0), "yes" if each["alarm"] else "no"]
        rows.append([fault["fault"], f"{fault['begin_s']:.0f}", *cells])
    return table(["fault", "at, s", "`mh_amcl`: error", "wrong", "alarm", "`amcl`: error", "wrong", "alarm"], rows)
