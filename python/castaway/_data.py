"""Finds the worlds, robots, lidars and data sets of the package."""

from pathlib import Path

from . import _castaway

# A folder of the installed package; in the build tree a link to the source tree's data.
_castaway.set_shipped_data(str(Path(__file__).absolute().parent / "data"))


def data_root() -> Path:
    """The folder of worlds, robots, lidars and datasets: $CASTAWAY_DATA, or the package's."""
    return Path(_castaway.data_root())
