"""Figures of run time, which differ between machines."""

import os
import time

from measuring.lab import NO_PICTURES, mean, percent, table

PEOPLE_SPEC = """name: people
license: CC0-1.0
scenario:
  world: office
  duration_s: 60
  start: {random: true}
  drive: {route: random}
  lidar: {rate_hz: 10, beams: 360, range_max: 12}
  people: {count: 6}
outputs: {bag: {compression: zstd}, tables: hdf5}
"""


def dataset_speed(lab):
    (lab.folder / "people.yaml").write_text(PEOPLE_SPEC)
    rows = []
    for count in ["25", "50", "100"]:
        began, before = time.monotonic(), os.times()
        lab.run(["dataset", "people.yaml", "-j", "2", "-n", count, "--out", f"people-{count}"])
        after = os.times()
        cpu = after.children_user + after.children_system - before.children_user - before.children_system
        wall = time.monotonic() - began
        rows.append([f"`-n {count}`", f"{cpu:.1f} s", f"{wall:.1f} s", percent(cpu / (2 * wall), 0)])
    return table(["`castaway dataset people.yaml -j 2 --out DIR`, with", "CPU time", "in all", "of two cores"], rows)


def bag_cost(lab):
    rows = []
    for name in ["no bag", "zstd", "lz4", "none"]:
        bag = ["--set", "outputs.bag=false"] if name == "no bag" else ["--set", f"outputs.bag.compression={name}"]
        runs = [bag_run(lab, bag, f"bag-{name.replace(' ', '-')}-{seed}", seed) for seed in ["1", "2", "3"]]
        rows.append([name if name == "no bag" else f"`{name}`", f"{mean(run[0] for run in runs):.0f}",
                     f"{mean(run[1] for run in runs):.3f} s", f"{mean(run[2] for run in runs):.2f} s"])
    return table(["", "bytes a scan, all topics and attachments", "CPU of all sinks (`timing.json`)", "CPU of the run"], rows)


def bag_run(lab, bag, out, seed):
    lab.run(["run", "office/people", "--duration", "60", "--seed", seed, "--set", "people.count=6", "--set", "lidar.rate_hz=10",
             *NO_PICTURES, "--set", "outputs.report=false", *bag, "--out", out])
    timing = lab.json_of(f"{out}/timing.json")
    files = (lab.folder / out / "bag").glob("*") if (lab.folder / out / "bag").exists() else []
    scans = 600
    return sum(file.stat().st_size for file in files) / scans, timing["cpu_s"]["sinks"], sum(timing["cpu_s"].values())
