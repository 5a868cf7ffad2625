"""Figures of localization on 3-D maps, and of normal distributions beside particles."""

import json
import pathlib

from measuring.lab import NO_PICTURES, figure, percent, share, table

BOTH = "localizers=[mh_amcl, {mh_amcl: {mode: 3d}}]"
BELIEFS = "localizers=[{mh_amcl: {mode: 3d, name: p-climb}},{mh_amcl: {mode: 3d, name: g-climb, belief: gaussians}}]"
VLP = ["--set", "lidar={profile: vlp-16}"]
PLANAR = ["lab/kidnap", "home/kidnap", "corridor/kidnap", "office/kidnap", "warehouse/kidnap", "hall/kidnap", "car-park/kidnap", "hall/podium"]
CHANGES = [("lab/crowd", 12), ("home/people", 12), ("warehouse/restocked", 36), ("office/moved", 36)]
SLOWEST = ["recovered", "time to recover, mean, slowest", "error while tracking", "wrong without an alarm"]


def run(lab, scenario, *options, seeds=1):
    """summary.json of a run, or the pooled one of several."""
    out = f"run-{len(list(lab.folder.iterdir()))}"
    many = ["--seeds", str(seeds), "-j", "2"] if seeds > 1 else []
    return lab.summary([scenario, *NO_PICTURES, *many, *options], out)


def value_of(summary, name, key):
    """A figure of a localizer, as "tracking_error_m.mean": of the run, or the mean of the runs."""
    if "figures" in summary:
        return summary["figures"].get(f"{name}.{key}", {}).get("mean")
    value = summary["localizers"][name]
    for part in key.split("."):
        value = value[part]
    return value


def error_text(summary, name):
    return figure(value_of(summary, name, "tracking_error_m.mean"), "{:.3f}", " m")


def recovery_text(summary, name):
    """Recovered kidnaps, mean time, error; the error alone without kidnaps."""
    recovery = summary["localizers"][name]["recovery"]
    if recovery["events"] == 0:
        return error_text(summary, name)
    return ", ".join([share(recovery), figure(recovery["time_s"]["mean"], "{:.2f}", " s"), error_text(summary, name)])


def recovery_cells(summary, name):
    time = summary["localizers"][name]["recovery"]["time_s"]
    return [share(summary["localizers"][name]["recovery"]), f"{figure(time['mean'], '{:.2f}', ' s')}, {figure(time['max'], '{:.2f}', ' s')}",
            error_text(summary, name), percent(value_of(summary, name, "wrong_lock_share"))]


def only(summary):
    return next(iter(summary["localizers"]))


def planar_worlds(lab):
    rows = []
    for scenario in PLANAR:
        found = run(lab, scenario, "--set", BOTH)
        rows.append([f"`{scenario}`", *(recovery_text(found, name) for name in ["mh_amcl", "mh_amcl-3d"])])
    return table(["scenario", "`mh_amcl`", "`mh_amcl:3d`"], rows)


def people_and_changes(lab):
    rows = []
    for scenario, seeds in CHANGES:
        found = run(lab, scenario, "--set", BOTH, seeds=seeds)
        cells = [f"{recovery_text(found, name)}, {percent(value_of(found, name, 'wrong_lock_share'))}" for name in ["mh_amcl", "mh_amcl-3d"]]
        rows.append([f"`{scenario}`", *cells])
    return table(["scenario", "`mh_amcl`", "`mh_amcl:3d`"], rows)


def beam_errors(lab):
    rows = []
    for words, options in [("distance to the nearest surface", []),
                           ("distance along the beam", ["--set", "localizers=[{mh_amcl: {mode: 3d, track_by: along_beam}}]"])]:
        found = [run(lab, "car-park/levels-kidnaps", *options, seeds=4), run(lab, "hillside/kidnaps", *options)]
        rows.append([words, *(recovery_text(each, only(each)) for each in found)])
    return table(["particles weighed by", "car park", "hillside"], rows)


def kidnaps_on_floors(lab):
    rows = []
    for scenario, seeds in [("car-park/levels-kidnaps", 4), ("mezzanine/kidnaps", 1), ("mezzanine/upstairs", 4)]:
        found = run(lab, scenario, seeds=seeds)
        rows.append([f"`{scenario}`", "planar", "particles", *recovery_cells(found, only(found))])
    for scenario, options in [("car-park/levels-kidnaps", VLP), ("hillside/kidnaps", [])]:
        found = run(lab, scenario, *options, "--set", BELIEFS, seeds=4)
        rows += [[f"`{scenario}`", "16 layers", words, *recovery_cells(found, name)]
                 for name, words in [("p-climb", "particles"), ("g-climb", "normal distributions")]]
    return table(["scenario", "lidar", "belief", *SLOWEST], rows)


def replay(lab, *options):
    out = f"replay-{len(list(lab.folder.iterdir()))}"
    lab.run(["replay", "levels", "--no-pictures", *options, "--out", out])
    return lab.json_of(f"{out}/summary.json")


def replays(lab):
    lab.run(["run", "car-park/levels-kidnaps", *NO_PICTURES, "--set", "outputs.bag=true", "--out", "levels"])
    lab.run(["map", "car-park", "--out", "car-park.map3d"])
    lab.run(["map", "car-park", "--out", "car-park.bt"])
    lab.run(["map", "car-park", "--out", "coarse.bt", "--resolution", "0.2"])
    cases = [
        ("the run", lab.json_of("levels/summary.json")),
        ("replay on `car-park.map3d` from the true start (`--start truth`)", replay(lab, "--map3d", "car-park.map3d", "--start", "truth")),
        ("the same without the IMU (`--imu-topic none`) from an unknown start, which counts, too",
         replay(lab, "--map3d", "car-park.map3d", "--start", "unknown", "--imu-topic", "none")),
        ("replay on `car-park.bt` with voxels of 0.1 m (`--map3d car-park.bt`) from an unknown start",
         replay(lab, "--map3d", "car-park.bt", "--start", "unknown")),
        ("the same with voxels of 0.2 m (`castaway map car-park --out car-park.bt --resolution 0.2`)",
         replay(lab, "--map3d", "coarse.bt", "--start", "unknown")),
    ]
    return table(["", *SLOWEST[:3]], [[words, *recovery_cells(found, only(found))[:3]] for words, found in cases])


def beliefs(lab):
    file = str(pathlib.Path(__file__).parent / "beliefs.yaml")
    benches = json.loads(lab.run(["bench", "kidnaps", "--kidnaps", "100", "--obstacles", "0", "--obstacles", "6", "--localizer", file, "--json"]))
    settings = [(f"{belief[0]}-{refine}", belief, refine) for belief in ["particles", "gaussians"]
                for refine in ["climb", "ndt_points", "ndt_distributions"]]
    listed = ", ".join(f"{{mh_amcl: {{mode: 3d, name: {name}, belief: {belief}, refine_by: {refine}}}}}" for name, belief, refine in settings)
    floors = run(lab, "car-park/levels-kidnaps", "--set", f"localizers=[{listed}]", seeds=4)
    logs = json.loads(lab.run(["evaluate", str(lab.logs / "freiburg-079"), str(lab.logs / "seattle"), "--starts", "12", "--kidnaps", "12",
                               "--localizer", file, "--json"]))
    rows = []
    for short, belief, refine in settings:
        name = f"{belief}-{refine.replace('_', '-')}"
        told = [bench["localizers"][name] for bench in benches]
        own = {row["log"]: row for row in logs if row["localizer"] == name}
        rows.append([f"{'particles' if belief == 'particles' else 'normal distributions'}, `{refine}`",
                     *(f"{each['recovered']['count']}, {each['recovery_time_s']['mean']:.2f} s, {each['tracking_m']:.3f} m" for each in told),
                     recovery_text(floors, short), *(trials_text(own[log]) for log in ["freiburg-079", "seattle"]),
                     f"{own['seattle']['cpu_mean_ms']:.2f} ms"])
    return table(["belief, refined by", "laboratory", "six people", "car park", "freiburg-079", "seattle", "CPU"], rows)


def trials_text(row):
    trials = sum(row[kind]["trials"] for kind in ["starts", "kidnaps"])
    return f"{sum(row[kind]['recovered'] for kind in ['starts', 'kidnaps'])} of {trials}, {row['tracking_m']:.3f} m"
