"""The protocol between castaway and a localizer, in nothing but the standard library of Python 3.7 or newer.

    class Mine(Localizer):
        def initialize(self, pose, covariance): ...
        def on_odometry(self, stamp_ns, pose, twist): ...
        def on_scan(self, stamp_ns, ranges, lidar): ...  # returns an Estimate or None

    run(Mine)

Poses are [x, y, yaw] in m and rad. Standard output belongs to the protocol: print to sys.stderr.
"""

from __future__ import annotations

import base64
import dataclasses
import json
import sys


@dataclasses.dataclass
class Map:
    """An occupancy grid as ROS has it: rows from the smallest y, -1 unknown, 0 free ... 100 occupied."""

    name: str
    file: str | None
    width: int
    height: int
    resolution: float
    origin: list  # [x, y, yaw] of the lower left corner of cell 0
    cells: bytes  # one a cell; 255 is -1

    def occupied(self, x, y):
        """Whether the point [m] of a map without a yaw lies in a wall; unknown cells do not count."""
        column = int((x - self.origin[0]) // self.resolution)
        row = int((y - self.origin[1]) // self.resolution)
        inside = 0 <= column < self.width and 0 <= row < self.height
        return inside and 65 <= self.cells[row * self.width + column] <= 100


@dataclasses.dataclass
class Estimate:
    """An answer to a scan: the pose of base in map at the stamp of the scan."""

    pose: list
    covariance: list | None = None  # 9 numbers of (x, y, yaw), row by row
    probability: float | None = None  # in [0, 1] that the pose is right
    lost: bool = False  # the pose must not be used
    hypotheses: list | None = None  # [{"pose": [x, y, yaw], "probability": p}, ...]


class Localizer:
    """What castaway calls. `params` is the map of the scenario, `lidars` is by name."""

    def __init__(self, map, lidars, params, seed):
        self.map, self.lidars, self.params, self.seed = map, lidars, params, seed

    def initialize(self, pose, covariance):
        """A start at a pose, or (None, None) for anywhere on the map."""

    def on_odometry(self, stamp_ns, pose, twist):
        """The pose of base in odom, and [m/s, m/s, rad/s] since the reading before."""

    def on_scan(self, stamp_ns, ranges, lidar, time_increment_s):
        """Ranges [m]: None for no return, a negative number for an invalid one."""


def read_map(message):
    fields = dict(message, cells=base64.b64decode(message["cells"]))
    return Map(**fields)


def answer(estimate, stamp_ns):
    message = {"type": "estimate", "stamp_ns": stamp_ns}
    if estimate is not None:
        fields = dataclasses.asdict(estimate)
        message.update({key: value for key, value in fields.items() if value is not None})
    return message


def run(kind, lines=sys.stdin, out=sys.stdout):
    """Serves castaway until it says goodbye. `kind` is a subclass of Localizer."""

    def say(message):
        out.write(json.dumps(message, separators=(",", ":")) + "\n")
        out.flush()

    localizer = None
    for line in lines:
        message = json.loads(line)
        what = message["type"]
        if what == "hello":
            lidars = {lidar["name"]: lidar for lidar in message["lidars"]}
            localizer = kind(read_map(message["map"]), lidars, message["params"], message["seed"])
            say({"type": "ready", "protocol": 1})
        elif what == "lidar":
            localizer.lidars[message["lidar"]["name"]] = message["lidar"]
        elif what == "initialize":
            localizer.initialize(message["pose"], message["covariance"])
        elif what == "odometry":
            localizer.on_odometry(message["stamp_ns"], message["pose"], message["twist"])
        elif what == "scan":
            lidar = localizer.lidars[message["lidar"]]
            estimate = localizer.on_scan(message["stamp_ns"], message["ranges"], lidar, message["time_increment_s"])
            say(answer(estimate, message["stamp_ns"]))
        elif what == "bye":
            return
