"""castaway.run: what it returns, where it writes, what it refuses."""

import traceback

import numpy as np
import pytest
from conftest import DeadReckoning

import castaway


class Broken(DeadReckoning):
    """Raises at a scan."""

    def on_scan(self, scan):
        raise LookupError("no such wall")


def test_results_are_tables(short):
    run = castaway.run("lab/kidnap", seed=3, set=short, localizers=["mh_amcl"])
    assert run.summary["seed"] == 3
    assert run.summary["localizers"]["mh_amcl"]["recovery"]["recovered"] == 1
    errors = run.table("errors")
    assert errors.dtype["position_error_m"] == np.float64
    assert np.nanmedian(errors["position_error_m"]) < 0.1
    assert "kidnap" in list(run.events["kind"])
    assert len(run.truth) == len(errors)
    assert np.allclose(run.truth["x_m"], errors["true_x_m"], atol=1e-6)
    assert np.allclose(np.cos(run.truth["yaw_rad"] - errors["true_yaw_rad"]), 1.0)


def test_tables_are_frames_of_pandas_where_it_is_installed(short):
    pandas = pytest.importorskip("pandas")
    run = castaway.run("lab/kidnap", set=short, localizers=["mh_amcl"])
    assert isinstance(run.errors, pandas.DataFrame)
    assert isinstance(run.table("errors"), np.ndarray)


def test_a_temporary_folder_goes_with_the_run(short):
    run = castaway.run("lab/kidnap", set=short, localizers=["mh_amcl"])
    folder = run.folder
    assert run.report().read_text().startswith("<!DOCTYPE html>")
    assert folder.exists()
    del run
    assert not folder.parent.exists()


def test_a_report_can_be_kept(short, tmp_path):
    page = castaway.run("lab/kidnap", set=short).report(tmp_path / "page.html")
    assert page.stat().st_size > 10_000


def test_files_of_others_are_never_replaced(short, tmp_path):
    (tmp_path / "thesis.tex").write_text("mine")
    with pytest.raises(castaway.Error, match="thesis.tex"):
        castaway.run("lab/kidnap", set=short, out=tmp_path)
    assert [f.name for f in tmp_path.iterdir()] == ["thesis.tex"]


def test_an_exception_of_a_localizer_reaches_the_caller_with_its_traceback(short, tmp_path):
    with pytest.raises(LookupError, match="no such wall") as caught:
        castaway.run("lab/kidnap", set=short, localizers=[Broken()], out=tmp_path / "run")
    frames = traceback.extract_tb(caught.value.__traceback__)
    assert frames[-1].name == "on_scan"
    assert not (tmp_path / "run").exists()


def test_an_answer_that_is_none_is_a_type_error(short):
    class Odd(DeadReckoning):
        def on_scan(self, scan):
            return (0.0, 0.0, 0.0)

    with pytest.raises(TypeError, match="'tuple': return a castaway.Estimate or None"):
        castaway.run("lab/kidnap", set=short, localizers=[Odd()])


def test_what_is_no_localizer_is_refused_before_the_run():
    with pytest.raises(TypeError, match="initialize"):
        castaway.run("lab/kidnap", localizers=[object()])


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"lidar.range_maxx": 6}, "range_max"),
        ({"duration_s": -1}, "duration_s"),
        ({"localizers": ["mh_amcl", "mh_amcl"]}, "two localizers are called 'mh_amcl'"),
    ],
)
def test_errors_have_the_text_of_the_program(changes, text):
    with pytest.raises(castaway.Error, match=text) as caught:
        castaway.run("lab/kidnap", set=changes)
    assert "\n" not in str(caught.value)


def test_an_unknown_scenario_is_answered_with_the_nearest_one():
    with pytest.raises(castaway.Error, match="did you mean 'lab/kidnap'"):
        castaway.run("lab/kidnapp")


def test_the_scenario_of_a_run_with_a_localizer_of_python_says_that_it_needs_it(short, tmp_path):
    run = castaway.run("lab/kidnap", set=short, localizers=[DeadReckoning], out=tmp_path / "run")
    with pytest.raises(castaway.Error, match="'dead_reckoning': is an object of the program"):
        castaway.run(run.folder / "scenario.yaml", out=tmp_path / "again")
    again = castaway.run(run.folder / "scenario.yaml", localizers=[DeadReckoning])
    assert np.array_equal(again.trajectory("truth"), run.trajectory("truth"))


def test_a_run_goes_on_without_a_program_that_fails(short):
    run = castaway.run("lab/kidnap", set=short, localizers=["mh_amcl", "program:false"])
    assert "exited with 1" in run.failed["false"]
    assert run.summary["failed"]


def test_expectations_that_are_not_met_are_named(short):
    expect = {"mh_amcl.recovery.success": ">= 1", "mh_amcl.position_error_m.max": "< 0.0001"}
    run = castaway.run("lab/kidnap", set={**short, "expect": expect}, localizers=["mh_amcl"])
    assert len(run.missed) == 1
    assert run.missed[0].startswith("mh_amcl.position_error_m.max is ")
