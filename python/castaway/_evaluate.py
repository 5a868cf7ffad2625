"""Localizers on recorded logs."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from typing import Any

from . import _castaway
from ._localizers import AnyLocalizer, is_own, name_of, require_localizer


def _spec(localizer: AnyLocalizer) -> _castaway.LocalizerSpec:
    if isinstance(localizer, str):
        return _castaway.LocalizerSpec(localizer)
    if not is_own(localizer):
        raise TypeError(f"evaluate: {localizer!r} is neither text nor a castaway.Localizer")
    require_localizer(localizer)
    return _castaway.LocalizerSpec(name_of(localizer), localizer)


def evaluate(
    folders: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    localizers: Iterable[AnyLocalizer] = ("mh_amcl",),
    *,
    starts: int = 24,
    kidnaps: int = 24,
    window_s: float = 60.0,
    kidnap_to: str = "far",
    tracking: bool = True,
    seed: int = 1,
    map3d: str | os.PathLike[str] = "",
) -> list[dict[str, Any]]:
    """Evaluates localizers on recorded logs with their maps, as `castaway evaluate --json` does.

    Returns a dictionary for each log and localizer, logs first. Each trial begins with `setup` and
    `initialize`; give the class of a localizer of Python instead of an object if it does not
    restart there. `map3d`: the 3-D map of the logs, for `mh_amcl:3d`; by default the only one in
    each folder.
    """
    if isinstance(folders, (str, os.PathLike)):
        folders = [folders]
    config = _castaway.EvaluationConfig()
    config.starts, config.kidnaps, config.window_s = starts, kidnaps, window_s
    config.kidnap_to, config.tracking, config.seed = kidnap_to, tracking, seed
    specs = [_spec(localizer) for localizer in localizers]
    rows = []
    for folder in folders:
        place = _castaway.RecordedPlace(os.fspath(folder), specs, os.fspath(map3d))
        rows += [json.loads(_castaway.evaluate(place, spec, config)) for spec in specs]
    return rows
