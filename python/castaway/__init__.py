"""castaway: kidnap a simulated robot and measure how a localizer finds it again.

    import castaway

    run = castaway.run("lab/kidnap", seed=3, localizers=["mh_amcl", "amcl"])
    print(run.summary["localizers"])

Units are m, rad, s (stamps: ns) and frames those of REP-103 and REP-105: a pose is (x, y, yaw).
"""

from . import _load  # noqa: F401  Before all others.
from ._castaway import (
    Error,
    Estimate,
    Event,
    ImuFrame,
    Lidar,
    Map,
    OdometryFrame,
    Population,
    Scan,
    ScanFrame,
    Setup,
    __version__,
    scenarios,
)
from ._data import data_root
from ._evaluate import evaluate
from ._localizers import Amcl, AnyLocalizer, Localizer, MhAmcl, Pose
from ._run import Run, run
from ._simulation import Frame, Simulation

__all__ = [
    "Amcl",
    "AnyLocalizer",
    "Error",
    "Estimate",
    "Event",
    "Frame",
    "ImuFrame",
    "Lidar",
    "Localizer",
    "Map",
    "MhAmcl",
    "OdometryFrame",
    "Pose",
    "Population",
    "Run",
    "Scan",
    "ScanFrame",
    "Setup",
    "Simulation",
    "__version__",
    "data_root",
    "evaluate",
    "run",
    "scenarios",
]
