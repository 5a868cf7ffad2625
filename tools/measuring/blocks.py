"""Every measured block: its page, what measures it, and the code that it depends on."""

import dataclasses
import typing

from measuring import localizers, people, robots, sensors, speed, worlds
from measuring.lab import bench

LOOP = ["localization", "tools/metrics", "tools/run/loop.cpp", "tools/run/build_localizers.cpp"]
WORLD = ["sim", ":(exclude)sim/render", "tools/run/build_*.cpp", "tools/run/simulator_source.cpp", "worlds/lab", "robots/waffle"]
SIMULATOR = LOOP + WORLD
REPLAY = LOOP + ["tools/run/carmen_*.cpp", "tools/campaign/evaluation.cpp"]


@dataclasses.dataclass
class Block:
    """A block of a page."""

    page: str
    measure: typing.Callable
    depends: list  # Paths from the root, as `git ls-files` takes them.
    cheap: bool = False  # Seconds, and nothing that a clock measured but what CLOCKS hides.
    logs: bool = False  # Takes recorded logs.
    worlds: bool = False  # Takes published worlds.


LOCALIZATION, SIMULATION = "docs/figures/localization.md", "docs/figures/simulation.md"
EXPERIMENTS, SPEED = "docs/figures/experiments.md", "docs/figures/speed.md"

BLOCKS = {
    "default-run": Block("README.md", localizers.default_run, SIMULATOR, cheap=True),
    "twenty-seeds": Block("README.md", localizers.twenty_seeds, SIMULATOR, cheap=True),
    "replays": Block("README.md", localizers.replays, REPLAY, logs=True),
    "evaluations": Block("README.md", localizers.evaluations, REPLAY, logs=True),
    "seven-localizers": Block(LOCALIZATION, localizers.seven_localizers, SIMULATOR),
    "published-defects": Block(LOCALIZATION, localizers.published_defects, SIMULATOR),
    "kidnaps-among-people": Block(LOCALIZATION, localizers.kidnaps_among_people, SIMULATOR + ["worlds/office"]),
    "stressed-evaluations": Block(LOCALIZATION, localizers.stressed_evaluations, REPLAY, logs=True),
    "localization-speed": Block(SPEED, bench("bench", "localization"), ["localization", "tools/campaign/plain_*.cpp"]),
    "odometry-profiles": Block(SIMULATION, sensors.odometry_profiles,
                               ["sim/sensor", "tools/campaign/odometry_bench.cpp", "worlds/lab", "robots/waffle"], cheap=True),
    "odometry-logs": Block(SIMULATION, sensors.odometry_logs, ["tools/campaign/odometry_drift.cpp"], logs=True),
    "real-lidar": Block(LOCALIZATION, sensors.real_lidar, SIMULATOR + ["lidars"], cheap=True),
    "glass": Block(SIMULATION, sensors.glass, WORLD + ["lidars", "worlds/home"]),
    "faults": Block(LOCALIZATION, sensors.faults, SIMULATOR, cheap=True),
    "experiment-1": Block(EXPERIMENTS, localizers.experiment(1), SIMULATOR),
    "experiment-2": Block(EXPERIMENTS, localizers.experiment(2, "--seeds", "10", "-j", "2"), SIMULATOR),
    "experiment-3": Block(EXPERIMENTS, localizers.experiment(3), SIMULATOR + ["worlds/corridor"]),
    "marathons": Block(EXPERIMENTS, people.marathons, SIMULATOR + ["worlds/corridor", "robots/butler"]),
    "discrimination": Block(EXPERIMENTS, people.discrimination, SIMULATOR),
    "kidnap-kinds": Block(LOCALIZATION, people.kidnap_kinds, SIMULATOR),
    "among-people": Block(LOCALIZATION, people.among_people, SIMULATOR),
    "simulation-speed": Block(SPEED, bench("bench", "simulation"), ["sim", "tools/campaign/simulation_bench.cpp"]),
    "moved": Block(LOCALIZATION, worlds.moved, SIMULATOR + ["worlds"]),
    "twins": Block(SIMULATION, worlds.twins, ["sim/world", "worlds"]),
    "exact-beams": Block(SIMULATION, worlds.exact_beams, ["sim/sensor", "sim/world", "worlds"]),
    "published-worlds": Block(SIMULATION, worlds.published_worlds, ["sim/world"], worlds=True),
    "physics": Block(SIMULATION, bench("bench", "physics"), ["sim/robot", "sim/drive_stage.cpp", "robots/waffle"], cheap=True),
    "shipped-robots": Block(SIMULATION, robots.shipped_robots, ["sim/robot", "robots"]),
    "dataset-speed": Block(SPEED, speed.dataset_speed, ["tools/campaign", "tools/commands/dataset*.cpp", "sim"]),
    "bag-cost": Block(SPEED, speed.bag_cost, ["tools/formats", "tools/run/bag_*.cpp"]),
}
