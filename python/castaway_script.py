#!python
"""`castaway` on the PATH after `pip install` of the wheel: this process becomes the program in the package."""

import importlib.util
import os
import sys

folder = importlib.util.find_spec("castaway").submodule_search_locations[0]
os.execv(os.path.join(folder, "bin/castaway"), sys.argv)
