"""The package writes the bytes of the program, and Python computes what C++ does."""

import json
import os
import subprocess
import sys

import pytest
from conftest import ROOT, DeadReckoning, WrappedMhAmcl

import castaway

# They hold clocks, or the names of files.
DIFFERENT = {"timing.json", "timing.csv", "report.html", ".castaway.json", "scenario.yaml"}


def sets(changes):
    return [x for key, value in changes.items() for x in ("--set", f"{key}={json.dumps(value)}")]


def bytes_of(folder):
    return {f.name: f.read_bytes() for f in folder.iterdir() if f.is_file()}


def test_every_file_is_that_of_the_program(program, short, tmp_path):
    own = castaway.run("lab/kidnap", seed=3, set=short, out=tmp_path / "python")
    program("run", "lab/kidnap", "--seed", 3, *sets(short), "--out", tmp_path / "program")
    python, cpp = bytes_of(own.folder), bytes_of(tmp_path / "program")
    assert python.keys() == cpp.keys()
    assert python["scenario.yaml"] == cpp["scenario.yaml"]
    differing = {name for name in cpp if python[name] != cpp[name]}
    assert differing <= DIFFERENT
    assert len(cpp) - len(DIFFERENT) >= 5


def test_pictures_are_those_of_the_program(program, tmp_path):
    changes = {"duration_s": 3, "events": [], "outputs.snapshots": {"every_s": 2}}
    own = castaway.run("lab/kidnap", set=changes, out=tmp_path / "python")
    program("run", "lab/kidnap", *sets(changes), "--out", tmp_path / "program")
    cpp = bytes_of(tmp_path / "program" / "snapshots")
    assert bytes_of(own.folder / "snapshots") == cpp
    assert cpp


@pytest.mark.parametrize("localizer", [WrappedMhAmcl, WrappedMhAmcl()])
def test_mh_amcl_through_python_is_mh_amcl(program, short, tmp_path, localizer):
    own = castaway.run("lab/kidnap", seed=3, set=short, localizers=[localizer])
    program("run", "--seed", 3, *sets(short), "--localizer", "mh_amcl", "--out", tmp_path / "run")
    trajectory = (tmp_path / "run" / "mh_amcl.tum").read_bytes()
    assert (own.folder / "mh_amcl.tum").read_bytes() == trajectory
    assert trajectory.count(b"\n") > 100


def test_dead_reckoning_in_python_is_the_program_of_the_examples(program, short, tmp_path):
    own = castaway.run("lab/kidnap", seed=2, set=short, localizers=[DeadReckoning()])
    example = f"program:/usr/bin/python3 {ROOT}/examples/program/dead_reckoning.py"
    program("run", "--seed", 2, *sets(short), "--localizer", example, "--out", tmp_path / "run")
    (written,) = (f for f in (tmp_path / "run").glob("*.tum") if f.name != "truth.tum")
    trajectory = written.read_bytes()
    assert (own.folder / "dead_reckoning.tum").read_bytes() == trajectory
    assert trajectory.count(b"\n") > 100


def test_localizers_of_python_and_castaways_own_ride_one_run_in_order(program, short, tmp_path):
    own = castaway.run(
        "lab/kidnap", set=short, localizers=["amcl", DeadReckoning, {"mh_amcl": {"name": "mh"}}]
    )
    assert list(own.errors["localizer"][:3]) == ["amcl", "dead_reckoning", "mh"]
    program("run", *sets(short), "--localizer", "amcl", "--out", tmp_path / "run")
    alone = (tmp_path / "run" / "amcl.tum").read_bytes()
    assert (own.folder / "amcl.tum").read_bytes() == alone


def test_the_robot_drives_by_a_localizer_of_python_as_by_castaways_own(program, tmp_path):
    changes = {"duration_s": 12, "drive": {"by": "mh_amcl"}, "outputs.snapshots": False}
    own = castaway.run("lab/kidnap", set=changes, localizers=[WrappedMhAmcl])
    program("run", *sets(changes), "--localizer", "mh_amcl", "--out", tmp_path / "run")
    assert (own.folder / "truth.tum").read_bytes() == (tmp_path / "run/truth.tum").read_bytes()


def test_the_bytes_are_the_same_without_fma(tmp_path):
    """glibc takes other variants of sin, exp, ... for CPUs without FMA; castaway does not use them."""
    code = (
        "import castaway, sys; castaway.run('lab/kidnap', out=sys.argv[1], "
        "set={'duration_s': 60, 'outputs.snapshots': False})"
    )
    masked = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA"}
    runs = []
    for name, extra in {"plain": {}, "masked": masked}.items():
        out = tmp_path / name
        subprocess.run([sys.executable, "-c", code, out], check=True, env={**os.environ, **extra})
        runs.append([(out / f).read_bytes() for f in ("truth.tum", "mh_amcl.tum", "errors.csv")])
    assert runs[0] == runs[1]
