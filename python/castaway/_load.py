"""Loads the module so that the libraries that come with it call its elementary functions.

Python itself has loaded glibc's exp, sin, ..., whose last bits depend on the CPU. Without RTLD_DEEPBIND Bullet would find
those first, and runs would differ from those of the program.
"""

import os
import sys

_flags = sys.getdlopenflags()
sys.setdlopenflags(os.RTLD_NOW | os.RTLD_DEEPBIND)
try:
    from . import _castaway  # noqa: F401
finally:
    sys.setdlopenflags(_flags)
