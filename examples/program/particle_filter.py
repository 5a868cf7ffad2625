#!/usr/bin/env python3
"""A particle filter with a likelihood field in numpy, as a localizer for castaway (needs numpy).

    castaway run --localizer mh_amcl --localizer "program:python3 examples/program/particle_filter.py"

S. Thrun, W. Burgard, D. Fox, "Probabilistic Robotics", 2005: odometry motion model (5.4), likelihood
field (6.4), low variance resampling (4.2.4), augmented MCL (8.3.3), which draws particles anywhere
when the scans fit worse than they used to. `params`: particles, beams.
"""

import math

import numpy as np
from protocol import Estimate, Localizer, run

SIGMA_HIT = 0.15  # [m]
Z_RANDOM = 0.05
SLOW, FAST = 0.01, 0.3  # rates of the averages of augmented MCL
FARTHEST = 2.0  # [m] reach of the likelihood field


def distance_field(occupied, resolution):
    """Distance of every cell to the nearest wall [m], up to FARTHEST: chamfer sweeps of the grid."""
    reach = int(FARTHEST / resolution)
    field = np.where(occupied, 0.0, FARTHEST)
    for _ in range(reach):
        before = field.copy()
        for dy, dx in [(0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1)]:
            shifted = np.full_like(field, FARTHEST)
            source = field[max(dy, 0) : field.shape[0] + min(dy, 0), max(dx, 0) : field.shape[1] + min(dx, 0)]
            shifted[max(-dy, 0) : field.shape[0] + min(-dy, 0), max(-dx, 0) : field.shape[1] + min(-dx, 0)] = source
            field = np.minimum(field, shifted + resolution * math.hypot(dx, dy))
        if np.array_equal(before, field):
            break
    return field


def wrap(angle):
    return (angle + np.pi) % (2.0 * np.pi) - np.pi


class ParticleFilter(Localizer):
    def __init__(self, map, lidars, params, seed):
        super().__init__(map, lidars, params, seed)
        self.rng = np.random.default_rng(seed)
        self.count = params.get("particles", 1000)
        self.beams = params.get("beams", 60)
        cells = np.frombuffer(map.cells, dtype=np.int8).reshape(map.height, map.width)
        self.free = np.argwhere((cells >= 0) & (cells < 20))
        self.field = distance_field(cells >= 65, map.resolution)
        self.poses = None  # (n, 3): x, y, yaw
        self.odom = self.odom_used = None
        self.slow = self.fast = 0.0

    def anywhere(self, count):
        """Poses drawn from the free cells."""
        cell = self.free[self.rng.integers(len(self.free), size=count)]
        at = (cell[:, ::-1] + self.rng.random((count, 2))) * self.map.resolution
        yaw = self.map.origin[2]
        x = self.map.origin[0] + math.cos(yaw) * at[:, 0] - math.sin(yaw) * at[:, 1]
        y = self.map.origin[1] + math.sin(yaw) * at[:, 0] + math.cos(yaw) * at[:, 1]
        return np.column_stack([x, y, self.rng.uniform(-np.pi, np.pi, count)])

    def initialize(self, pose, covariance):
        self.slow = self.fast = 0.0
        if pose is None:
            self.poses = self.anywhere(5 * self.count)
        else:
            self.poses = self.rng.multivariate_normal(pose, np.reshape(covariance, (3, 3)), self.count)

    def on_odometry(self, stamp_ns, pose, twist):
        self.odom = np.array(pose)

    def move(self):
        """Moves the particles as odometry did since the last scan, each with noise of its own."""
        last, self.odom_used = self.odom_used, self.odom
        if last is None or self.odom is None:
            return
        dx, dy = self.odom[:2] - last[:2]
        forward = math.cos(last[2]) * dx + math.sin(last[2]) * dy
        sideways = -math.sin(last[2]) * dx + math.cos(last[2]) * dy
        turn = wrap(self.odom[2] - last[2])
        n = len(self.poses)
        way = abs(forward) + abs(sideways)
        f = forward + self.rng.normal(0.0, 0.002 + 0.1 * way, n)
        s = sideways + self.rng.normal(0.0, 0.001 + 0.05 * way, n)
        t = turn + self.rng.normal(0.0, 0.002 + 0.1 * abs(turn) + 0.05 * way, n)
        yaw = self.poses[:, 2]
        self.poses = np.column_stack(
            [self.poses[:, 0] + f * np.cos(yaw) - s * np.sin(yaw), self.poses[:, 1] + f * np.sin(yaw) + s * np.cos(yaw), wrap(yaw + t)]
        )

    def points(self, ranges, lidar):
        """Ends of some beams in base. [m]"""
        r = np.array([np.nan if value is None else value for value in ranges])
        angle = lidar["angle_min"] + lidar["angle_increment"] * np.arange(len(r))
        valid = np.flatnonzero((r >= lidar["range_min"]) & (r < lidar["range_max"]))
        chosen = valid[:: max(1, len(valid) // self.beams)]
        at = np.column_stack([r[chosen] * np.cos(angle[chosen]), r[chosen] * np.sin(angle[chosen]), np.zeros(len(chosen))])
        T = np.reshape(lidar["T_base_laser"], (3, 4))
        return (at @ T[:, :3].T + T[:, 3])[:, :2]

    def likelihoods(self, p_base):
        c, s = np.cos(self.poses[:, 2, None]), np.sin(self.poses[:, 2, None])
        x = self.poses[:, 0, None] + c * p_base[:, 0] - s * p_base[:, 1] - self.map.origin[0]
        y = self.poses[:, 1, None] + s * p_base[:, 0] + c * p_base[:, 1] - self.map.origin[1]
        cm, sm = math.cos(self.map.origin[2]), math.sin(self.map.origin[2])
        column = np.floor((cm * x + sm * y) / self.map.resolution).astype(int)
        row = np.floor((-sm * x + cm * y) / self.map.resolution).astype(int)
        inside = (column >= 0) & (row >= 0) & (column < self.map.width) & (row < self.map.height)
        distance = np.where(inside, self.field[np.clip(row, 0, self.map.height - 1), np.clip(column, 0, self.map.width - 1)], FARTHEST)
        hit = (1.0 - Z_RANDOM) * np.exp(-0.5 * (distance / SIGMA_HIT) ** 2) + Z_RANDOM
        return np.exp(np.log(hit).mean(axis=1))

    def resample(self, weights):
        """Low variance resampling, and particles anywhere where the fit has become worse."""
        n = self.count
        lost = max(0.0, 1.0 - self.fast / self.slow) if self.slow > 0.0 else 0.0
        fresh = int(lost * n)
        edges = np.cumsum(weights)
        at = np.searchsorted(edges / edges[-1], (self.rng.random() + np.arange(n - fresh)) / max(n - fresh, 1))
        kept = self.poses[np.minimum(at, len(self.poses) - 1)]
        self.poses = np.vstack([kept, self.anywhere(fresh)])

    def on_scan(self, stamp_ns, ranges, lidar, time_increment_s):
        if self.poses is None:
            return None
        self.move()
        p_base = self.points(ranges, lidar)
        if len(p_base) > 0:
            fit = self.likelihoods(p_base)
            self.slow += SLOW * (fit.mean() - self.slow) if self.slow > 0.0 else fit.mean()
            self.fast += FAST * (fit.mean() - self.fast) if self.fast > 0.0 else fit.mean()
            self.resample(fit ** len(p_base) ** 0.5)
        yaw = np.arctan2(np.sin(self.poses[:, 2]).mean(), np.cos(self.poses[:, 2]).mean())
        mean = [*self.poses[:, :2].mean(axis=0), yaw]
        away = self.poses - mean
        away[:, 2] = wrap(away[:, 2])
        covariance = away.T @ away / len(self.poses)
        near = np.hypot(away[:, 0], away[:, 1]) < 0.5
        return Estimate([float(v) for v in mean], covariance.ravel().tolist(), float(near.mean()))


if __name__ == "__main__":
    run(ParticleFilter)
