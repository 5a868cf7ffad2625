"""Turns arguments into a scenario and its changes."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from typing import Any

from . import _castaway
from ._localizers import AnyLocalizer, is_own, name_of, require_localizer


def plain(value: Any) -> Any:
    """What JSON knows of a number or array of numpy, or of a path."""
    return value.tolist() if hasattr(value, "tolist") else os.fspath(value)


def override(key: str, value: Any) -> str:
    """One change of a scenario, as `--set` takes it. Text is a value, never YAML."""
    return f"{key}={json.dumps(value, default=plain)}"


def localizers_yaml(localizers: Iterable[AnyLocalizer]) -> str:
    """The list `localizers` of a scenario, in YAML's flow style."""
    items = []
    for localizer in localizers:
        if isinstance(localizer, str):
            items.append(_castaway.localizer_yaml(localizer))
        elif isinstance(localizer, Mapping):
            items.append(json.dumps(localizer))
        else:
            require_localizer(localizer)
            items.append(json.dumps({"python": {"name": name_of(localizer)}}))
    return "[" + ", ".join(items) + "]"


def request(
    scenario: str | os.PathLike[str],
    seed: int | None,
    set: Mapping[str, Any] | None,
    localizers: Iterable[AnyLocalizer] | None,
    allow_programs: bool,
    first: Iterable[str] = (),
) -> tuple[_castaway.ScenarioRequest, dict[str, Any]]:
    """The scenario with its changes, and the localizers of Python by name. `first`: changes that
    `set` overrides."""
    overrides = list(first)
    own: dict[str, Any] = {}
    if seed is not None:
        overrides.append(override("seed", seed))
    if localizers is not None:
        chosen = list(localizers)
        overrides.append("localizers=" + localizers_yaml(chosen))
        own = {name_of(localizer): localizer for localizer in chosen if is_own(localizer)}
    overrides += [override(key, value) for key, value in (set or {}).items()]
    return _castaway.ScenarioRequest(os.fspath(scenario), overrides, allow_programs), own
