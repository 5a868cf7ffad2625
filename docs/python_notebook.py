# A kidnap in a notebook: open it as one (VS Code, Jupytext), or run it. The test python_docs runs it.

# %% A localizer of one's own: dead reckoning that scores many poses around it by a distance field.
import math

import numpy as np

import castaway


def compose(a, b):
    """T_a_c of T_a_b and T_b_c, arrays of ... x 3."""
    c, s = np.cos(a[..., 2]), np.sin(a[..., 2])
    x, y = b[..., 0], b[..., 1]
    return np.stack(
        [a[..., 0] + c * x - s * y, a[..., 1] + s * x + c * y, a[..., 2] + b[..., 2]], axis=-1
    )


class Matcher(castaway.Localizer):
    """Moves with odometry, then takes the best of 500 poses nearby. It cannot find a kidnapped robot."""

    name = "matcher"

    def setup(self, setup):
        self.map = setup.map
        self.walls = np.minimum(setup.map.distance_field, 1.0)
        self.random = np.random.default_rng(setup.seed)

    def initialize(self, pose, covariance):
        self.pose = None if pose is None else np.array(pose)
        self.odometry = None

    def on_odometry(self, stamp_ns, pose, twist):
        pose = np.array(pose)
        if self.pose is not None and self.odometry is not None:
            back = self.odometry
            c, s = math.cos(back[2]), math.sin(back[2])
            dx, dy, turn = pose - back
            self.pose = compose(self.pose, np.array([c * dx + s * dy, c * dy - s * dx, turn]))
        self.odometry = pose

    def distances(self, points):
        """[m] From points in map (... x 2) to the nearest wall."""
        column, row = np.moveaxis((points - self.map.origin[:2]) // self.map.resolution, -1, 0)
        row = np.clip(row.astype(int), 0, self.map.height - 1)
        column = np.clip(column.astype(int), 0, self.map.width - 1)
        return self.walls[row, column]

    def on_scan(self, scan):
        if self.pose is None:
            return None
        seen = np.isfinite(scan.ranges)
        angles, ranges = scan.angles[seen][::4], scan.ranges[seen][::4]
        laser = scan.T_base_laser
        points = np.stack([ranges * np.cos(angles), ranges * np.sin(angles)], axis=-1)
        points = points @ laser[:2, :2].T + laser[:2, 3]  # In base.
        poses = self.pose + self.random.normal(0.0, [0.04, 0.04, 0.02], (500, 3))
        c, s = np.cos(poses[:, 2, None]), np.sin(poses[:, 2, None])
        x = poses[:, 0, None] + c * points[:, 0] - s * points[:, 1]
        y = poses[:, 1, None] + s * points[:, 0] + c * points[:, 1]
        misfit = (self.distances(np.stack([x, y], axis=-1)) ** 2).mean(axis=1)
        self.pose = poses[misfit.argmin()]
        return castaway.Estimate(self.pose, covariance=np.cov(poses.T), lost=misfit.min() > 0.1)


# %% One run, three localizers on the same scans.
run = castaway.run(
    "lab/kidnap",
    seed=3,
    set={"duration_s": 40, "lidar.range_max": 6},
    localizers=["mh_amcl", "amcl", Matcher()],
)
print(run.events)
print(run.errors.groupby("localizer")["position_error_m"].median())

# %% The summary is that of the program.
for name, metrics in run.summary["localizers"].items():
    recovery = metrics["recovery"]
    print(f"{name}: {recovery['recovered']} of {recovery['events']} kidnaps recovered")

# %% The map, the true way and the estimates as arrays, ready for matplotlib:
#        plt.imshow(map.cells, origin="lower"); plt.plot(truth["x_m"], truth["y_m"])
truth = run.trajectory("truth")
mine = run.trajectory("matcher")
print(f"{len(truth)} true poses, {len(mine)} of matcher")

# %% The page of the run.
print(run.report("kidnap.html"))
