"""The examples of README, of docs/python.md and its notebook run as they are printed."""

import re
import runpy

import pytest
from conftest import ROOT


def test_the_notebook_runs(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(ROOT / "docs/python_notebook.py"), run_name="__main__")
    assert "mh_amcl" in capsys.readouterr().out


def blocks():
    text = (ROOT / "README.md").read_text() + (ROOT / "docs/python.md").read_text()
    return re.findall(r"```python\n(.*?)```", text, re.DOTALL)


@pytest.mark.parametrize("block", blocks(), ids=lambda block: block.split("\n")[0])
def test_a_block_of_the_guide_runs(block, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "the page", "exec"), {"__name__": "guide"})  # noqa: S102


def test_the_guide_has_blocks():
    assert len(blocks()) >= 6
