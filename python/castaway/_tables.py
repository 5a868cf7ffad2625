"""Tables of a run folder as structured arrays."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from typing import Any

import numpy as np

# Columns of text; all others are numbers, and an empty cell is nan.
_TEXT = {"localizer", "event", "kind", "detail"}


def read_csv(file: Path) -> np.ndarray:
    """A CSV file as a structured array, a field a column."""
    with open(file, newline="", encoding="utf-8") as stream:
        rows = csv.reader(stream)
        names = next(rows)
        columns = list(zip(*rows)) or [()] * len(names)
    return _array({n: _column(n, c) for n, c in zip(names, columns)})


def read_tum(file: Path) -> np.ndarray:
    """A trajectory as a structured array: stamp_s, x_m, y_m, yaw_rad."""
    rows = np.loadtxt(file, ndmin=2).reshape(-1, 8)
    stamp, x, y, z, w = rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 6], rows[:, 7]
    return _array({"stamp_s": stamp, "x_m": x, "y_m": y, "yaw_rad": 2.0 * np.arctan2(z, w)})


def as_frame(table: np.ndarray) -> Any:
    """The table as a pandas.DataFrame where pandas is installed, else as it is."""
    try:
        import pandas
    except ImportError:
        return table
    return pandas.DataFrame({name: table[name] for name in table.dtype.names or ()})


def _column(name: str, cells: tuple[str, ...]) -> np.ndarray:
    if name in _TEXT:
        return np.array(cells, dtype=f"U{max(map(len, cells), default=0) or 1}")
    return np.array([float(cell) if cell else math.nan for cell in cells], dtype=np.float64)


def _array(columns: dict[str, np.ndarray]) -> np.ndarray:
    lengths = [len(column) for column in columns.values()]
    table = np.empty(lengths[0], dtype=[(n, c.dtype) for n, c in columns.items()])
    for name, column in columns.items():
        table[name] = column
    return table
