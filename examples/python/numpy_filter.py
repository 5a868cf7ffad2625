"""The particle filter of examples/program as a class of the package castaway, in a kidnap.

    PYTHONPATH=examples/program python3 examples/python/numpy_filter.py
"""

from particle_filter import ParticleFilter

import castaway


class NumpyFilter(castaway.Localizer):
    """Hands maps, odometry and scans on; no program is started and no text is exchanged."""

    name = "numpy_filter"

    def __init__(self, **params):
        self.params = params

    def setup(self, setup):
        self.filter = ParticleFilter(setup.map, {}, self.params, setup.seed)

    def initialize(self, pose, covariance):
        self.filter.initialize(pose, covariance)

    def on_odometry(self, stamp_ns, pose, twist):
        self.filter.on_odometry(stamp_ns, pose, twist)

    def on_scan(self, scan):
        lidar = {key: getattr(scan, key) for key in ("angle_min", "angle_increment", "range_min", "range_max")}
        lidar["T_base_laser"] = scan.T_base_laser[:3]
        found = self.filter.on_scan(scan.stamp_ns, scan.ranges, lidar, scan.time_increment_s)
        return found and castaway.Estimate(found.pose, covariance=found.covariance, probability=found.probability)


if __name__ == "__main__":
    run = castaway.run("lab/kidnap", localizers=["mh_amcl", NumpyFilter(particles=1000)])
    for name, summary in run.summary["localizers"].items():
        recovery = summary["recovery"]
        print(f"{name}: {recovery['recovered']} of {recovery['events']} kidnaps, {recovery['time_s']['mean']:.1f} s")
