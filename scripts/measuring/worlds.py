"""Figures of worlds and maps."""

import json

from measuring.lab import NO_PICTURES, fence, percent, share, table

PUBLISHED = [("turtlebot3_gazebo", "turtlebot3_world.world", "ROBOTIS"), ("turtlebot3_gazebo", "turtlebot3_house.world", "ROBOTIS"),
             ("turtlebot3_gazebo", "turtlebot3_dqn_stage4.world", "ROBOTIS"),
             ("aws-robomaker-small-house-world", "small_house.world", "AWS RoboMaker")]
MOVED = ["lab/moved", "office/moved", "home/rearranged", "warehouse/restocked"]
TWINS = [(name, []) for name in ["lab", "home", "warehouse", "hall", "corridor", "office"]] + [
    ("hall", ["--range-max", "8"]), ("warehouse", ["--range-max", "3.5"]), ("corridor", ["--range-max", "3.5"])]


def moved(lab):
    rows = []
    for name in MOVED:
        summary = lab.summary([name, *NO_PICTURES], name.replace("/", "-"))
        recovery = {who: summary["localizers"][who]["recovery"] for who in ["mh_amcl", "amcl"]}
        time = recovery["mh_amcl"]["time_s"]
        changes = summary["difference"]
        rows.append([f"`{name}`", percent(changes["beams"]), changes_text(changes),
                     share(recovery["mh_amcl"]) + (f", {time['mean']:.2f} s in the mean" if time["mean"] else ""),
                     share(recovery["amcl"])])
    return table(["scenario", "difference number", "what changed", "`mh_amcl` recovered", "`amcl`"], rows)


def changes_text(changes):
    words = [("moved", "moved"), ("removed", "gone"), ("added", "boxes"), ("closed", "closed"), ("opened", "opened")]
    return ", ".join(f"{changes[key]} {word}" for key, word in words if changes.get(key))


def twins(lab):
    rows = []
    for world, options in TWINS:
        alike = json.loads(lab.run(["check-world", world, *options, "--no-picture", "--json"]))["ambiguity"]
        rows.append([f"`{world}`", f"{options[1] if options else 12} m", f"{alike['mean']:.3f}", f"{alike['p90']:.3f}",
                     percent(alike["twins"])])
    return table(["world", "lidar", "likeness, mean", "p90", "places with a twin"], rows)


def exact_beams(lab):
    return fence(lab.program("world_cast_check", ["10"]))


def published_worlds(lab):
    rows = []
    for folder, file, maker in PUBLISHED:
        root = lab.worlds / folder
        report = json.loads(lab.run(["check-world", str(root / "worlds" / file), "--search-path", str(root / "models"),
                                     "--no-picture", "--json"]))
        size = [high - low for low, high in zip(report["min_m"], report["max_m"])]
        objects = report["objects"]
        rows.append([f"`{file}` ({maker})", bodies_text(objects), f"{size[0]:.1f} x {size[1]:.1f} m", percent(report["ambiguity"]["twins"])])
    return table(["world", "bodies", "size", "places with a twin"], rows)


def bodies_text(objects):
    kinds = ["boxes", "cylinders", "meshes", "spheres", "ramps"]
    return ", ".join(f"{objects[kind]} {kind}" for kind in kinds if objects.get(kind))
