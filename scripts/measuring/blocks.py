"""Every measured block: its page, what measures it, and the code that it depends on."""

import dataclasses
import typing

from measuring import foreign, live, localizers, people, robots, ros2, sensors, space, speed, twins, worlds
from measuring.lab import bench

LOOP = ["localization", "tools/run/metrics", "tools/run/loop.cpp", "tools/build/build_localizers.cpp"]
WORLD = ["sim", "xacro", ":(exclude)sim/render", "tools/build/build_*.cpp", "tools/build/simulator_source.cpp", "worlds/lab", "robots/waffle"]
SIMULATOR = LOOP + WORLD
TWIN = ["tools/twin/alignment", ":(glob)tools/twin/*", "tools/twin/odometry", "tools/twin/fits"]
FOREIGN = ["tools/build/foreign", "tools/run/foreign_config.*pp", "tools/run/ros2_config.hpp"] + [
    f"tools/base/process/{name}.*pp" for name in ("child_process", "guard", "line_channel", "no_pipe_signal", "process_use")]
REPLAY = LOOP + ["tools/build/recorded/carmen_*.cpp", "tools/batch/evaluate/evaluation.cpp"]


@dataclasses.dataclass
class Block:
    """A block of a page."""

    page: str
    measure: typing.Callable
    depends: list  # Paths from the root, as `git ls-files` takes them.
    cheap: bool = False  # Seconds, and nothing that a clock measured but what CLOCKS hides.
    logs: bool = False  # Takes recorded logs.
    worlds: bool = False  # Takes published worlds.
    times: bool = False  # A clock measured some of it.


LOCALIZATION, SIMULATION = "docs/figures/localization.md", "docs/figures/simulation.md"
TRUTH, SPACE = "docs/truth.md", "docs/maps-3d.md"
EXPERIMENTS, SPEED = "docs/figures/experiments.md", "docs/figures/speed.md"

BLOCKS = {
    "default-run": Block("README.md", localizers.default_run, SIMULATOR, cheap=True),
    "compared": Block("README.md", localizers.seven_localizers, SIMULATOR),
    "shipped-logs": Block("README.md", localizers.shipped_logs, REPLAY + ["logs"]),
    "replays": Block("README.md", localizers.replays, REPLAY, logs=True, times=True),
    "evaluations": Block("README.md", localizers.evaluations, REPLAY, logs=True, times=True),
    "seven-localizers": Block(LOCALIZATION, localizers.seven_localizers, SIMULATOR),
    "published-defects": Block(LOCALIZATION, localizers.published_defects, SIMULATOR),
    "kidnaps-among-people": Block(LOCALIZATION, localizers.kidnaps_among_people, SIMULATOR + ["worlds/office"]),
    "stressed-evaluations": Block(LOCALIZATION, localizers.stressed_evaluations, REPLAY, logs=True, times=True),
    "designs": Block("docs/localization.md", localizers.designs,
                     REPLAY + WORLD + ["worlds/hall", "scripts/measuring/designs.yaml"], logs=True),
    "foreign-localizers": Block("docs/your-localizer.md", foreign.foreign_localizers,
                                SIMULATOR + ["worlds/office", "examples", "include"] + FOREIGN, logs=True, times=True),
    "localization-speed": Block(SPEED, bench("castaway", "bench", "localization"), ["localization", "tools/batch/bench/plain_*.cpp"], times=True),
    "odometry-profiles": Block(SIMULATION, sensors.odometry_profiles,
                               ["sim/sensor", "tests/bench/workbench/odometry_bench.cpp", "worlds/lab", "robots/waffle"], cheap=True),
    "odometry-logs": Block(SIMULATION, sensors.odometry_logs, ["tests/bench/workbench/odometry_drift.cpp"], logs=True),
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
    "calibration": Block(TRUTH, twins.calibration, SIMULATOR + [*TWIN, "robots/butler", "worlds"]),
    "likeness": Block(TRUTH, twins.likeness, SIMULATOR + [*TWIN, "robots/disc"], logs=True),
    "predictions": Block(TRUTH, twins.predictions,
                         SIMULATOR + ["localization", *TWIN, "tools/batch/evaluate", "tools/play/replay/spliced_kidnap.*pp",
                                      "tools/twin/prediction", "tools/pages/twin", "robots/disc"],
                         logs=True),
    "fits": Block(TRUTH, twins.fits, SIMULATOR + ["localization", *TWIN, "robots/disc"], logs=True),
    "simulation-speed": Block(SPEED, bench("castaway", "bench", "simulation"), ["sim", "tools/batch/bench/simulation_bench.cpp"], times=True),
    "moved": Block(LOCALIZATION, worlds.moved, SIMULATOR + ["worlds"]),
    "twins": Block(SIMULATION, worlds.twins, ["sim/world", "sim/map", "sim/difference", "worlds"]),
    "exact-beams": Block(SIMULATION, worlds.exact_beams, ["sim/sensor", "sim/casting", "sim/world", "worlds"]),
    "published-worlds": Block(SIMULATION, worlds.published_worlds, ["sim/world", "sim/map"], worlds=True),
    "physics": Block(SIMULATION, bench("workbench", "physics"), ["sim/robot", "sim/stages/drive_stage.cpp", "robots/waffle"], cheap=True),
    "shipped-robots": Block(SIMULATION, robots.shipped_robots, ["sim/robot", "robots"]),
    "dataset-speed": Block(SPEED, speed.dataset_speed, ["tools/batch/dataset", "tools/pages/dataset", "sim"], times=True),
    "ros2": Block("docs/ros2.md", ros2.lock_step, ["tools/build/ros2", "tools/ros/dds", "tests/program/ros2_peer"], times=True),
    "live": Block("docs/live.md", live.live, ["tools/live", "tools/commands/live.cpp", "web/src"], times=True),
    "space-planar-worlds": Block(SPACE, space.planar_worlds, SIMULATOR + ["tools/build/map3d", "worlds"]),
    "space-people-and-changes": Block(SPACE, space.people_and_changes, SIMULATOR + ["tools/build/map3d", "worlds"]),
    "space-beam-errors": Block(SPACE, space.beam_errors, SIMULATOR + ["tools/build/map3d", "worlds/car-park", "worlds/hillside"]),
    "space-kidnaps": Block(SPACE, space.kidnaps_on_floors, SIMULATOR + ["tools/build/map3d", "lidars", "worlds"]),
    "space-replays": Block(SPACE, space.replays,
                           SIMULATOR + ["tools/build/map3d", "tools/play/replay", "tools/build/bag", "worlds/car-park"]),
    "beliefs": Block("docs/localization.md", space.beliefs, SIMULATOR + ["tools/build/map3d", "worlds", "scripts/measuring/beliefs.yaml"],
                     logs=True, times=True),
    "bag-cost": Block(SPEED, speed.bag_cost, ["tools/ros", "tools/outputs/sinks/bag_sink.cpp"], times=True),
}
