"""Runs of a scenario."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
from collections.abc import Iterable, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from . import _castaway, _tables
from ._localizers import AnyLocalizer
from ._scenario import request


class Run:
    """What a run left behind. `errors`, `events` and `truth` are pandas.DataFrames where pandas is
    installed, else numpy structured arrays; `table` always gives arrays."""

    def __init__(self, folder: str | os.PathLike[str], *, owner: Any = None) -> None:
        """Opens a run folder, of the program too. `owner` is kept: it may remove the folder."""
        self._owner = owner
        self.folder = Path(folder)
        self.summary: dict[str, Any] = json.loads((self.folder / "summary.json").read_text("utf-8"))
        self.failed: dict[str, str] = {}
        """What went wrong, by localizer, with those that the run went on without."""
        self.missed: list[str] = []
        """Expectations of the scenario (`expect`) that were not met, a sentence each."""
        self.warnings: list[str] = []
        """Remarks about the robot, the world and the run, a sentence each."""

    @cached_property
    def errors(self) -> Any:
        """A row for each scan and localizer: truth, estimate and its errors."""
        return _tables.as_frame(self.table("errors"))

    @cached_property
    def events(self) -> Any:
        """Kidnaps, collisions, faults, alarms, recoveries, in order of time."""
        return _tables.as_frame(self.table("events"))

    @cached_property
    def truth(self) -> Any:
        """True pose of base in map at each scan: stamp_s, x_m, y_m, yaw_rad."""
        return _tables.as_frame(self.trajectory("truth"))

    def table(self, name: str) -> np.ndarray:
        """`<name>.csv` of the run folder, e.g. "errors", "events", "people"."""
        return _tables.read_csv(self.folder / f"{name}.csv")

    def trajectory(self, localizer: str) -> np.ndarray:
        """Estimates of a localizer, or the "truth": stamp_s, x_m, y_m, yaw_rad."""
        return _tables.read_tum(self.folder / f"{localizer}.tum")

    def report(self, file: str | os.PathLike[str] | None = None) -> Path:
        """The run as a page: report.html in the run folder, or a copy of it as `file`."""
        page = self.folder / "report.html"
        if not page.exists():
            _castaway.write_report(str(self.folder))
        return Path(shutil.copyfile(page, file)) if file is not None else page

    def __repr__(self) -> str:
        return f"Run({str(self.folder)!r})"


def run(
    scenario: str | os.PathLike[str] = "lab/kidnap",
    *,
    seed: int | None = None,
    set: Mapping[str, Any] | None = None,
    localizers: Iterable[AnyLocalizer] | None = None,
    out: str | os.PathLike[str] | None = None,
    force: bool = False,
    allow_programs: bool = False,
) -> Run:
    """Simulates a scenario, as `castaway run` does, and returns what it left behind.

    scenario: a file, or <world>/<name> of one that comes along (`castaway.scenarios()`).
    seed: root of all random streams; None: the scenario's.
    set: changes by key, e.g. {"lidar.range_max": 6, "events.0.kidnap.at_s": 20}.
    localizers: instead of the scenario's (`castaway.AnyLocalizer`).
    out: the run folder. Files that castaway did not write are never replaced; `force` allows others
        beside its own. None: a temporary folder that goes with the Run, without pictures unless
        `set` has "outputs.snapshots".
    allow_programs: the scenario may name programs and libraries as localizers.

    The files are those of the program, byte for byte (timing.* apart). Raises castaway.Error or
    ValueError with the program's text, KeyboardInterrupt, and what a localizer of Python raises;
    then nothing is left in `out`.
    """
    temporary = None
    first: list[str] = []
    if out is None:
        temporary = tempfile.TemporaryDirectory(prefix="castaway-")
        out = Path(temporary.name) / "run"
        first = ["outputs.snapshots=false"]
    asked, own = request(scenario, seed, set, localizers, allow_programs, first)
    played = _castaway.play(asked, own, os.fspath(out), force)
    run = Run(out, owner=temporary)
    run.failed, run.missed, run.warnings = played.failed, played.missed, played.warnings
    return run
