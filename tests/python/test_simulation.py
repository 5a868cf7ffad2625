"""castaway.Simulation."""

import math
import threading

import numpy as np
import pytest

import castaway
from castaway import Event, ImuFrame, OdometryFrame, ScanFrame, Simulation


def steps(simulation, kind, seconds):
    """The frames of a kind up to this time."""
    frames = []
    for frame in simulation:
        if isinstance(frame, kind):
            frames.append(frame)
        if frame.stamp_ns >= seconds * 1e9:
            break
    return frames


def test_frames_are_those_of_a_run(short):
    frames = list(Simulation("lab/kidnap", seed=3, set=short))
    truth = castaway.run("lab/kidnap", seed=3, set=short).table("errors")
    scans = [frame for frame in frames if isinstance(frame, ScanFrame)]
    written = truth["true_x_m"][::2]  # Two localizers; six digits.
    assert np.allclose([f.truth[0] for f in scans], written, rtol=0.0, atol=5.1e-7)
    assert [f.stamp_ns for f in frames] == sorted(f.stamp_ns for f in frames)
    kidnaps = [f for f in frames if isinstance(f, Event) and f.kind == "kidnap"]
    assert len(kidnaps) == 1
    assert math.dist(kidnaps[0].pose_from[:2], kidnaps[0].pose_to[:2]) > 3


def test_scans_carry_labels_of_what_they_hit(short):
    simulation = Simulation("lab/kidnap", set=short)
    frame = steps(simulation, ScanFrame, 1.0)[-1]
    assert len(frame.labels) == len(frame.scan) == len(frame.scan.ranges)
    names = {simulation.label_name(label) for label in frame.labels}
    assert any("wall" in name for name in names)
    ranges = simulation.map.cast(frame.truth, frame.scan.angles)
    assert ranges.shape == frame.scan.ranges.shape


def test_an_imu_tells_of_gravity():
    simulation = Simulation("lab/kidnap", set={"imu": True, "duration_s": 4})
    frames = steps(simulation, ImuFrame, 1.0)
    assert 50 < len(frames) < 250
    assert math.isclose(np.mean([f.linear_acceleration[2] for f in frames]), 9.81, abs_tol=0.2)
    assert len(frames[0].angular_velocity) == 3
    assert frames[0].stamp_ns < frames[-1].stamp_ns


def test_people_are_rows():
    frame = steps(Simulation("lab/people", set={"duration_s": 5}), ScanFrame, 2.0)[-1]
    assert len(frame.people) > 0
    assert frame.people.dtype.names[:4] == ("id", "x_m", "y_m", "yaw_rad")
    gaps = np.hypot(frame.people["x_m"] - frame.truth[0], frame.people["y_m"] - frame.truth[1])
    assert (frame.people["gap_m"] < gaps).all()


def test_a_commanded_robot_goes_where_it_is_told():
    simulation = Simulation("lab/kidnap", set={"duration_s": 60, "events": []})
    simulation.command(0.0, 0.5)
    turned = steps(simulation, OdometryFrame, 2.0)
    assert math.dist(turned[0].truth[:2], turned[-1].truth[:2]) < 0.05
    assert turned[-1].truth[2] - turned[0].truth[2] == pytest.approx(1.0, abs=0.2)
    simulation.command(0.0, 0.0)
    stopped = steps(simulation, OdometryFrame, 4.0)
    assert math.dist(stopped[-2].truth, stopped[-1].truth) < 1e-3
    simulation.follow_route()
    driven = steps(simulation, OdometryFrame, 12.0)
    assert math.dist(driven[0].truth[:2], driven[-1].truth[:2]) > 0.5


def test_a_commanded_robot_repeats_itself():
    def drive():
        simulation = Simulation("lab/kidnap", seed=5, set={"duration_s": 3, "events": []})
        simulation.command(0.2, 0.1)
        return [(f.stamp_ns, f.truth, f.pose) for f in steps(simulation, OdometryFrame, 3)]

    assert drive() == drive()


def test_a_kidnap_teleports_without_odometry():
    simulation = Simulation("lab/kidnap", set={"duration_s": 10, "events": []})
    before = steps(simulation, OdometryFrame, 1.0)[-1]
    other = castaway.Simulation("lab/kidnap", seed=9, set={"start": {"random": True}})
    target = other.start_pose
    simulation.kidnap(target)
    frames = steps(simulation, (OdometryFrame, Event), 1.2)
    event = next(f for f in frames if isinstance(f, Event))
    assert (event.kind, event.pose_to) == ("kidnap", target)
    after = next(f for f in frames[frames.index(event) :] if isinstance(f, OdometryFrame))
    assert math.dist(after.truth[:2], target[:2]) < 0.1
    assert math.dist(after.pose[:2], before.pose[:2]) < 0.1


def test_there_is_no_kidnap_into_a_wall():
    with pytest.raises(ValueError, match="no room"):
        Simulation("lab/kidnap").kidnap((1e3, 0.0, 0.0))


def test_it_knows_its_surroundings():
    simulation = Simulation("lab/kidnap", set={"duration_s": 2})
    assert simulation.duration_s == 2.0
    assert simulation.lidars[0].range_max == 12.0
    assert simulation.map.cells.any()
    assert "duration_s: 2" in simulation.scenario
    assert sum(1 for _ in simulation) > 50
    with pytest.raises(StopIteration):
        next(simulation)


def test_a_command_that_is_no_number_is_refused():
    simulation = Simulation("lab/kidnap", set={"duration_s": 2, "events": []})
    for v, w in ((math.nan, 0.0), (0.0, math.inf)):
        with pytest.raises(ValueError, match="finite"):
            simulation.command(v, w)
    with pytest.raises(ValueError, match="finite"):
        simulation.kidnap((math.nan, 0.0, 0.0))


def test_a_second_thread_is_refused():
    simulation = Simulation("lab/kidnap", set={"duration_s": 5, "events": []})
    refused = []

    def play():
        try:
            for _ in simulation:
                pass
        except castaway.Error as error:
            refused.append(str(error))

    threads = [threading.Thread(target=play) for _ in range(16)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(refused) >= 1
    assert all("two threads" in text for text in refused)
