"""The simulator, to step through."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import Any, Union

from . import _castaway
from ._castaway import Event, ImuFrame, Lidar, Map, OdometryFrame, ScanFrame
from ._localizers import Pose
from ._scenario import request

Frame = Union[OdometryFrame, ScanFrame, ImuFrame, Event]  # "|" takes Python 3.10.


class Simulation:
    """A scenario to step through: an iterator over what its sensors deliver, in order of time.

        for frame in castaway.Simulation("lab/kidnap", seed=3):
            if isinstance(frame, castaway.ScanFrame):
                frame.scan.ranges, frame.truth, frame.people, frame.labels

    The same scenario and seed give the same frames as `castaway.run`. The scenario's localizers do
    not run. Arguments are those of `castaway.run`.
    """

    def __init__(
        self,
        scenario: str | os.PathLike[str] = "lab/kidnap",
        *,
        seed: int | None = None,
        set: Mapping[str, Any] | None = None,
        allow_programs: bool = False,
    ) -> None:
        asked, _ = request(scenario, seed, set, None, allow_programs)
        self._native = _castaway.NativeSimulation(asked)

    def __iter__(self) -> Iterator[Frame]:
        return self

    def __next__(self) -> Frame:
        """The next frame. Raises StopIteration once the scenario's duration is over."""
        return next(self._native)

    def command(self, v: float, w: float) -> None:
        """Drives the robot from the next control step (20 Hz) on: v [m/s] forward, w [rad/s]
        counter-clockwise. Holds until it is changed."""
        self._native.command(v, w)

    def follow_route(self) -> None:
        """Lets the scenario drive the robot again."""
        self._native.follow_route()

    def kidnap(self, pose: Pose) -> None:
        """Teleports base to a pose in map at the next step; an Event tells of it. Raises ValueError
        if the robot has no room there."""
        self._native.kidnap(pose)

    def set_estimate(self, pose: Pose | None) -> None:
        """Tells the scenario a localizer's estimate: a robot whose `drive.by` is a localizer drives
        by it, and kidnaps that wait for a localizer watch it. Ignored by other scenarios."""
        self._native.set_estimate(pose)

    def label_name(self, label: int) -> str:
        """What a beam with this label hit, e.g. "wall"."""
        return self._native.label_name(label)

    @property
    def start_pose(self) -> Pose:
        """True pose of base in map at the start."""
        return self._native.start_pose

    @property
    def map(self) -> Map:
        """The map given to localizers."""
        return self._native.map

    @property
    def lidars(self) -> list[Lidar]:
        """The robot's lidars."""
        return self._native.lidars

    @property
    def duration_s(self) -> float:
        """[s] Simulated time at which the frames end."""
        return self._native.duration_s

    @property
    def scenario(self) -> str:
        """The scenario with all defaults filled in, as YAML."""
        return self._native.scenario

    @property
    def warnings(self) -> list[str]:
        """Remarks about the robot, the world and the run so far, a sentence each."""
        return self._native.warnings
