"""Finds the worlds, robots, lidars and data sets of the package, and its renderer."""

from pathlib import Path

from . import _castaway

_PACKAGE = Path(__file__).absolute().parent
# In the wheel that contains its libraries they lie as in the portable bundle, for its program, too. Else `data` is a folder of
# the installed package, and in the build tree a link to the source tree's data.
_SHARED = _PACKAGE / "share/castaway"
_castaway.set_shipped_data(str(_SHARED if _SHARED.is_dir() else _PACKAGE / "data"))
if (_PACKAGE / "lib/renderer").is_dir():
    _castaway.use_renderer_in(str(_PACKAGE / "lib/renderer"))


def data_root() -> Path:
    """The folder of worlds, robots, lidars and datasets: $CASTAWAY_DATA, or the package's."""
    return Path(_castaway.data_root())
