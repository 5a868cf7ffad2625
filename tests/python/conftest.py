"""What the tests of the package share."""

import math
import os
import subprocess
from pathlib import Path

import pytest

import castaway

ROOT = Path(__file__).resolve().parents[2]


def compose(a, b):
    """T_a_c of T_a_b and T_b_c."""
    c, s = math.cos(a[2]), math.sin(a[2])
    return [a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]]


def invert(a):
    c, s = math.cos(a[2]), math.sin(a[2])
    return [-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]]


class DeadReckoning(castaway.Localizer):
    """The start pose and odometry, as examples/program/dead_reckoning.py."""

    name = "dead_reckoning"

    def __init__(self):
        self.T_odom_base = (0.0, 0.0, 0.0)

    def initialize(self, pose, covariance):
        self.start, self.T_map_odom = pose, None

    def on_odometry(self, stamp_ns, pose, twist):
        if self.T_map_odom is None and self.start is not None:
            self.T_map_odom = compose(self.start, invert(pose))
        self.T_odom_base = pose

    def on_scan(self, scan):
        if self.T_map_odom is None:
            return None
        return castaway.Estimate(compose(self.T_map_odom, self.T_odom_base))


class WrappedMhAmcl(castaway.Localizer):
    """castaway's own localizer, through Python, with the seed of the run."""

    name = "mh_amcl"

    def setup(self, setup):
        self.filter = castaway.MhAmcl(setup.map, seed=setup.seed)

    def initialize(self, pose, covariance):
        self.filter.initialize(pose, covariance)

    def on_odometry(self, stamp_ns, pose, twist):
        self.filter.on_odometry(stamp_ns, pose)

    def on_scan(self, scan):
        return self.filter.on_scan(scan)


@pytest.fixture
def program():
    """Runs the program of the same build."""

    def run(*arguments, **options):
        command = [os.environ["CASTAWAY_PROGRAM"], *map(str, arguments)]
        return subprocess.run(command, check=True, capture_output=True, text=True, **options)

    return run


@pytest.fixture
def short():
    """Changes of a scenario for a run that takes a second."""
    return {"duration_s": 12, "events.0.kidnap.at_s": 5.05, "outputs.snapshots": False}
