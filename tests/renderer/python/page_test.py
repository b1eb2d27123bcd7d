"""Runs the examples of a page: its ```python blocks, in order, in an empty folder.

Usage: page_test.py PAGE. Blocks that import matplotlib are left out where it is missing.
"""

import os
import pathlib
import re
import sys
import tempfile

page = pathlib.Path(sys.argv[1]).resolve()
blocks = re.findall(r"^```python\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)
if len(blocks) < 4:
    sys.exit(f"{page} has {len(blocks)} examples: this test looks wrong")
try:
    import matplotlib

    matplotlib.use("Agg")
except ImportError:
    matplotlib = None
    print("matplotlib is missing: its examples are skipped")
names: dict = {}
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for block in blocks:
        if "matplotlib" in block and matplotlib is None:
            continue
        exec(compile(block, str(page), "exec"), names)  # pylint: disable=exec-used
    os.chdir("/")
print(f"{len(blocks)} examples")
