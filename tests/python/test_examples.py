"""The examples of the package."""

import sys

from conftest import ROOT

import castaway


def test_the_numpy_filter_recovers_as_a_class_and_as_a_program(program, tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "path", [*sys.path, f"{ROOT}/examples/program", f"{ROOT}/examples/python"])
    from numpy_filter import NumpyFilter

    changes = {"duration_s": 40, "events": [{"kidnap": {"kind": "teleport", "at_s": 10}}], "outputs.snapshots": False}
    own = castaway.run("lab/kidnap", set=changes, localizers=[NumpyFilter])
    assert own.summary["localizers"]["numpy_filter"]["recovery"]["success"] == 1.0
    own = castaway.run("lab/kidnap", set=changes, localizers=[f"program:/usr/bin/python3 {ROOT}/examples/program/particle_filter.py"])
    assert own.summary["localizers"]["particle_filter"]["recovery"]["success"] == 1.0
