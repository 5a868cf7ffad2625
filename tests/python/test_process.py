"""What a run does to the process around it: signals, threads, memory."""

import gc
import signal
import subprocess
import sys
import threading
import time

import pytest
from conftest import DeadReckoning

import castaway

LONG = """
import castaway
castaway.run("lab/kidnap", set={{"duration_s": 3600}}, localizers={localizers}, out={out!r})
"""


@pytest.mark.parametrize("localizers", [["mh_amcl"], []])
def test_ctrl_c_raises_keyboard_interrupt_and_leaves_nothing(tmp_path, localizers):
    out = tmp_path / "run"
    script = LONG.format(localizers=localizers, out=str(out))
    if not localizers:
        script = script.replace("3600", '3600, "outputs.report": False')
    child = subprocess.Popen([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 60
    while not list(out.rglob("errors.csv*")) and time.monotonic() < deadline:
        assert child.poll() is None, child.stderr.read()
        time.sleep(0.02)
    time.sleep(0.3)  # It simulates by now.
    sent = time.monotonic()
    child.send_signal(signal.SIGINT)
    _, errors = child.communicate(timeout=30)
    assert time.monotonic() - sent < 5
    assert child.returncode == -signal.SIGINT
    assert errors.rstrip().endswith("KeyboardInterrupt")
    assert not out.exists()


def test_an_exception_of_a_signal_handler_ends_a_run(short):
    class Enough(Exception):
        pass

    def stop(*_):
        raise Enough

    before = signal.signal(signal.SIGALRM, stop)
    try:
        signal.setitimer(signal.ITIMER_REAL, 1.0)
        with pytest.raises(Enough):
            castaway.run("lab/kidnap", set={**short, "duration_s": 3600})
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_other_threads_go_on_while_it_simulates(short):
    done = threading.Event()
    ticks = []

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    castaway.run("lab/kidnap", set=short, localizers=["mh_amcl"])
    seconds = time.monotonic() - begin
    done.set()
    thread.join()
    pauses = [b - a for a, b in zip(ticks, ticks[1:])]
    assert len(ticks) > 50 * seconds
    assert max(pauses) < 0.5 * seconds


def test_runs_in_threads_are_those_of_one_thread(short):
    def bytes_of(seed):
        run = castaway.run("lab/kidnap", seed=seed, set=short, localizers=[DeadReckoning, "mh_amcl"])
        return (run.folder / "errors.csv").read_bytes()

    found = {}
    threads = [
        threading.Thread(target=lambda s=seed: found.update({s: bytes_of(s)})) for seed in (1, 2)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == {seed: bytes_of(seed) for seed in (1, 2)}


def resident_kb():
    with open("/proc/self/status", encoding="ascii") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS:"))


def test_a_thousand_runs_do_not_grow():
    changes = {
        "duration_s": 0.4,
        "physics": "kinematic",
        "events": [],
        "outputs": {"snapshots": False, "report": False},
    }
    resident = []
    for seed in range(1, 1001):
        run = castaway.run(
            "lab/kidnap", seed=seed, set=changes, localizers=[DeadReckoning(), "mh_amcl"]
        )
        assert len(run.errors)
        if seed in (200, 1000):
            del run
            gc.collect()
            resident.append(resident_kb())
    print("VmRSS [kB] after 200 and 1000 runs:", resident)
    assert resident[1] - resident[0] < 8 * 1024
