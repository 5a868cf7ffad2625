#!/usr/bin/env python3
"""Dead reckoning as a localizer for castaway: the start pose and odometry, no scans.

    castaway run --localizer mh_amcl --localizer "program:python3 examples/program/dead_reckoning.py"
"""

import math

from protocol import Estimate, Localizer, run


def compose(a, b):
    """T_a_c of T_a_b and T_b_c."""
    c, s = math.cos(a[2]), math.sin(a[2])
    return [a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]]


def invert(a):
    c, s = math.cos(a[2]), math.sin(a[2])
    return [-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]]


class DeadReckoning(Localizer):
    T_map_odom = None
    T_map_base_start = None
    T_odom_base = [0.0, 0.0, 0.0]

    def initialize(self, pose, covariance):
        self.T_map_base_start, self.T_map_odom = pose, None

    def on_odometry(self, stamp_ns, pose, twist):
        if self.T_map_odom is None and self.T_map_base_start is not None:
            self.T_map_odom = compose(self.T_map_base_start, invert(pose))
        self.T_odom_base = pose

    def on_scan(self, stamp_ns, ranges, lidar, time_increment_s):
        if self.T_map_odom is None:
            return None
        return Estimate(compose(self.T_map_odom, self.T_odom_base))


run(DeadReckoning)
