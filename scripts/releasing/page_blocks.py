"""Runs the examples in Python of a page, each with a name space of its own. usage: page_blocks.py PAGE"""

import pathlib
import re
import sys

blocks = re.findall(r"```python\n(.*?)```", pathlib.Path(sys.argv[1]).read_text(), re.DOTALL)
for block in blocks:
    exec(compile(block, block.split("\n")[0], "exec"), {"__name__": "page"})
print(f"{len(blocks)} examples")
