"""`pip install .` without network: the wheel, and the package in an environment of its own."""

import csv
import io
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from conftest import ROOT

SCRIPT = """
import castaway
run = castaway.run("lab/kidnap", set={"duration_s": 1, "outputs.snapshots": False})
assert "site-packages" in str(castaway.data_root()), castaway.data_root()
print(castaway.__version__, len(run.errors))
"""


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """An environment with the package, which took the module of this build."""
    folder = tmp_path_factory.mktemp("pip")
    subprocess.run(
        [sys.executable, "-m", "venv", "--system-site-packages", folder / "venv"], check=True
    )
    environment = {**os.environ, "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    environment.pop("PYTHONPATH", None)
    pip = [folder / "venv/bin/python", "-m", "pip"]
    wheel = [*pip, "wheel", "--no-deps", "--quiet", "--wheel-dir", folder, ROOT]
    subprocess.run(wheel, check=True, env=environment)
    file = next(folder.glob("castaway-*.whl"))
    subprocess.run([*pip, "install", "--quiet", file], check=True, env=environment)
    return folder / "venv/bin/python", file, environment


def test_the_installed_package_runs_from_anywhere(installed, tmp_path):
    python, _, environment = installed
    done = subprocess.run(
        [python, "-c", SCRIPT],
        cwd=tmp_path,
        env={k: v for k, v in environment.items() if k != "CASTAWAY_DATA"},
        check=True,
        capture_output=True,
        text=True,
    )
    assert done.stdout.split()[0] == "0.1.0"
    assert int(done.stdout.split()[1]) > 5


def test_the_record_lists_every_file(installed):
    with zipfile.ZipFile(installed[1]) as wheel:
        names = set(wheel.namelist())
        record = next(name for name in names if name.endswith("RECORD"))
        rows = list(csv.reader(io.StringIO(wheel.read(record).decode())))
    assert {row[0] for row in rows} == names
    assert {"castaway/py.typed", "castaway/_castaway.pyi"} <= names
    assert "castaway/data/worlds/lab/scenarios/kidnap.yaml" in names
    assert Path(record).parent.name == "castaway-0.1.0.dist-info"
