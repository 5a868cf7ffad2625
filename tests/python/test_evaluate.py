"""castaway.evaluate."""

import json
import signal
import time

import pytest
from conftest import WrappedMhAmcl

import castaway

TRIALS = {"starts": 1, "kidnaps": 1, "window_s": 5.0, "tracking": False}


@pytest.fixture(scope="module")
def log(tmp_path_factory):
    folder = tmp_path_factory.mktemp("log") / "run"
    changes = {
        "duration_s": 30,
        "events": [],
        "outputs": {"snapshots": False, "carmen": True, "map": True},
    }
    return castaway.run("lab/kidnap", set=changes, localizers=["mh_amcl"], out=folder).folder


def without_clocks(row):
    return {key: value for key, value in row.items() if "cpu" not in key and key != "localizer"}


def test_rows_are_those_of_the_program(log, program):
    rows = castaway.evaluate(log, ["mh_amcl", "amcl"], **TRIALS)
    arguments = ["--starts", 1, "--kidnaps", 1, "--window", 5, "--no-tracking", "--json"]
    printed = program(
        "evaluate", log, *arguments, "--localizer", "mh_amcl", "--localizer", "amcl"
    ).stdout
    expected = json.loads(printed)
    assert [row["localizer"] for row in rows] == ["mh_amcl", "amcl"]
    assert list(map(without_clocks, rows)) == list(map(without_clocks, expected))


def test_a_localizer_of_python_is_evaluated_as_castaways_own(log):
    own, wrapped = castaway.evaluate(log, ["mh_amcl", WrappedMhAmcl], **TRIALS)
    assert without_clocks(wrapped) == without_clocks(own)
    assert own["starts"]["trials"] == 1


def test_wrong_arguments_are_named(log):
    with pytest.raises(ValueError, match="window"):
        castaway.evaluate(log, window_s=0.0)
    with pytest.raises(castaway.Error, match="nowhere"):
        castaway.evaluate("nowhere")
    with pytest.raises(ValueError, match="unknown localizer"):
        castaway.evaluate(log, ["mh_amcll"])


def test_a_signal_ends_an_evaluation(log):
    def stop(*_):
        raise InterruptedError

    before = signal.signal(signal.SIGALRM, stop)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.5)
        begin = time.monotonic()
        with pytest.raises(InterruptedError):
            castaway.evaluate(log, ["amcl:amcl-global"], starts=10_000, kidnaps=0, tracking=False)
        assert time.monotonic() - begin < 3
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
