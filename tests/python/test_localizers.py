"""castaway.MhAmcl and castaway.Amcl in one's own code."""

import math

import numpy as np
import pytest
from conftest import DeadReckoning, WrappedMhAmcl

import castaway


def trajectory(localizer, simulation):
    localizer.initialize(simulation.start_pose, np.diag([0.1 * 0.1, 0.1 * 0.1, 0.05 * 0.05]))
    poses = []
    for frame in simulation:
        if isinstance(frame, castaway.OdometryFrame):
            localizer.on_odometry(frame.stamp_ns, frame.pose)
        elif isinstance(frame, castaway.ScanFrame):
            estimate = localizer.on_scan(frame.scan)
            if estimate:
                poses.append(estimate.pose)
    return poses


def test_embedded_mh_amcl_is_that_of_a_run(short):
    simulation = castaway.Simulation("lab/kidnap", seed=3, set=short)
    seed = castaway._castaway.localizer_seed(3, "mh_amcl")
    own = trajectory(castaway.MhAmcl(simulation.map, seed=seed), simulation)

    class Recorded(WrappedMhAmcl):
        poses = []

        def on_scan(self, scan):
            estimate = super().on_scan(scan)
            self.poses.append(estimate.pose)
            return estimate

    castaway.run("lab/kidnap", seed=3, set=short, localizers=[Recorded])
    assert own == Recorded.poses  # Every bit of them.
    assert len(own) > 100


def test_parameters_are_those_of_a_scenario(short):
    simulation = castaway.Simulation("lab/kidnap", set=short)
    amcl = castaway.Amcl(simulation.map, preset="amcl-recovery", min_particles=100, max_particles=300)
    assert len(trajectory(amcl, simulation)) > 10
    assert sum(len(p.particles) for p in amcl.populations) <= 300


def test_an_unknown_parameter_is_an_error_with_the_nearest_one():
    room = castaway.Map(np.zeros((20, 20), np.int8), 0.1)
    with pytest.raises(castaway.Error, match="max_particles"):
        castaway.MhAmcl(room, max_particels=10)
    with pytest.raises(castaway.Error, match="MhAmcl"):
        castaway.MhAmcl(room, mode="best")


def test_populations_hold_particles():
    cells = np.zeros((60, 80), np.int8)
    cells[[0, -1]] = 100
    cells[:, [0, -1]] = 100
    room = castaway.Map(cells, 0.1)
    localizer = castaway.MhAmcl(room)
    localizer.initialize((4.0, 3.0, 0.0), np.diag([0.01, 0.01, 0.01]))
    localizer.on_odometry(0, (0.0, 0.0, 0.0))
    localizer.on_odometry(100_000_000, (0.0, 0.0, 0.0))
    angles = np.linspace(0, 2 * math.pi, 180, endpoint=False)
    scan = castaway.Scan(
        room.cast((4.0, 3.0, 0.0), angles),
        stamp_ns=50_000_000,
        angle_min=0.0,
        angle_increment=angles[1],
        range_min=0.1,
        range_max=12.0,
    )
    estimate = localizer.on_scan(scan)
    assert np.allclose(estimate.pose[:2], (4.0, 3.0), atol=0.1)
    assert estimate.covariance.shape == (3, 3)
    assert sum(p.selected for p in localizer.populations) == 1
    assert localizer.populations[0].particles.shape[1] == 3


def test_ranges_are_a_view_that_cannot_be_written():
    scan = castaway.Scan(
        [1, 2, 3], stamp_ns=0, angle_min=0, angle_increment=1, range_min=0, range_max=9
    )
    assert scan.ranges.base is not None
    assert scan.ranges.__array_interface__["data"] == scan.ranges.__array_interface__["data"]
    with pytest.raises(ValueError, match="read-only"):
        scan.ranges[0] = 5
    ranges = scan.ranges
    del scan
    assert list(ranges) == [1, 2, 3]


def test_scans_that_a_localizer_keeps_stay_as_they_are(short):
    class Keeper(DeadReckoning):
        kept = []

        def on_scan(self, scan):
            self.kept.append((scan.ranges, scan.ranges.copy()))
            return super().on_scan(scan)

    castaway.run("lab/kidnap", set=short, localizers=[Keeper()])
    assert len(Keeper.kept) > 100
    assert all(np.array_equal(view, copy) for view, copy in Keeper.kept)


def test_an_estimate_that_cannot_be_is_refused_where_it_is_made():
    with pytest.raises(ValueError, match="not finite"):
        castaway.Estimate((0.0, math.nan, 0.0))
    with pytest.raises(ValueError, match="probability"):
        castaway.Estimate((0.0, 0.0, 0.0), probability=2.0)
    with pytest.raises(ValueError, match=r"\(x, y, yaw\)"):
        castaway.Estimate((0.0, 0.0))
    with pytest.raises(ValueError, match="3 x 3"):
        castaway.Estimate((0.0, 0.0, 0.0), covariance=[1.0])


def test_no_scan_is_no_scan(short):
    simulation = castaway.Simulation("lab/kidnap", set=short)
    with pytest.raises(TypeError):
        castaway.MhAmcl(simulation.map).on_scan(None)
