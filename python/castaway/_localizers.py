"""Localizers: the class to derive from, and castaway's own."""

from __future__ import annotations

import inspect
import json
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Union

from . import _castaway
from ._castaway import Estimate, Map, Population, Scan, Setup

Pose = Sequence[float]
"""(x [m], y [m], yaw [rad]): a tuple from castaway, any sequence or array to it."""


class Localizer:
    """A localizer to derive from. Calls come in order of delivery, from one thread.

    `name` names it in a run and in files; without one, its class does. An exception ends the run
    and reaches the caller of `castaway.run`.
    """

    name: str | None = None

    def setup(self, setup: Setup) -> None:
        """Takes what is known before a run: `map`, `seed`, `name`, `lidars`. May do nothing."""

    def initialize(self, pose: Pose | None, covariance: Any) -> None:
        """Restarts, at any time: at a pose of base in map with a 3 x 3 covariance, or anywhere."""
        raise NotImplementedError

    def on_odometry(self, stamp_ns: int, pose: Pose, twist: Sequence[float]) -> None:
        """Takes a pose of base in odom and the mean velocity since the one before, in base
        [m/s, m/s, rad/s]."""
        raise NotImplementedError

    def on_scan(self, scan: Scan) -> Estimate | None:
        """Takes a scan at the time of its last beam; answers for its stamp, that of the first."""
        raise NotImplementedError


AnyLocalizer = Union[str, Mapping[str, Any], Localizer, Callable[[], Localizer]]
"""A localizer of a run: "mh_amcl", "amcl:amcl-recovery", "program:python3 mine.py",
"library:./libmine.so"; settings as in a scenario, {"mh_amcl": {"name": "mine"}}; a Localizer,
or what makes one when it is called, such as its class."""


class _Native(Localizer):
    """One of castaway's own localizers, with the settings of a scenario."""

    _kind = ""

    def __init__(self, map: Map | str | os.PathLike[str], *, seed: int = 1, **params: Any) -> None:
        if not isinstance(map, Map):
            map = Map.load(map)
        yaml = json.dumps({self._kind: params})
        self._native = _castaway.NativeLocalizer(yaml, map, seed, type(self).__name__)

    def initialize(self, pose: Pose | None = None, covariance: Any = None) -> None:
        """Restarts at a pose of base in map with its 3 x 3 covariance, or anywhere on the map."""
        self._native.initialize(pose, covariance)

    def on_odometry(self, stamp_ns: int, pose: Pose, twist: Sequence[float] = ()) -> None:
        """Takes a pose of base in odom; the twist is not used. Late readings are dropped."""
        self._native.on_odometry(stamp_ns, pose)

    def on_scan(self, scan: Scan) -> Estimate | None:
        """The estimate at the scan's stamp; None if there is none, or the scan was dropped."""
        return self._native.on_scan(scan)

    @property
    def populations(self) -> list[Population]:
        """The populations of particles after the latest call."""
        return self._native.populations


class MhAmcl(_Native):
    """MH-AMCL on a map (or a map's YAML file). Starts at an unknown pose.

    `params`: settings `localizers[].mh_amcl.*` of `castaway settings`; `mode`: "improved", "paper"
    or "published". The same calls and seed give the same estimates. Raises castaway.Error for a setting
    that is unknown or out of range.
    """

    _kind = "mh_amcl"
    name = "mh_amcl"


class Amcl(_Native):
    """The baseline: adaptive Monte Carlo localization as in Nav2. Starts at an unknown pose.

    `params`: settings `localizers[].amcl.*` of `castaway settings`; `preset`: "amcl",
    "amcl-recovery", "amcl-global" or "amcl-prob".
    """

    _kind = "amcl"
    name = "amcl"


def is_own(localizer: AnyLocalizer) -> bool:
    """True for an object of Python, or what makes one."""
    return not isinstance(localizer, (str, Mapping))


def name_of(localizer: AnyLocalizer) -> str:
    """The name of an object of Python in a run."""
    named = getattr(localizer, "name", None)
    if isinstance(named, str):
        return named
    has_name = inspect.isclass(localizer) or inspect.isroutine(localizer)
    return _castaway.file_name_of(localizer.__name__ if has_name else type(localizer).__name__)


def require_localizer(localizer: AnyLocalizer) -> None:
    """Raises TypeError for an object that is neither a localizer nor makes one."""
    missing = [m for m in ("initialize", "on_odometry", "on_scan") if not hasattr(localizer, m)]
    if missing and (len(missing) < 3 or not callable(localizer)):
        raise TypeError(
            f"localizer {localizer!r} has no {missing[0]}(): derive it from castaway.Localizer"
        )
