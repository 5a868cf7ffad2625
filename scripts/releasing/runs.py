"""What a run leaves, compared with what the normal build leaves."""

import filecmp
import os
import subprocess

COST = ("timing.json", "timing.csv", "report.html")  # They state what the run cost.


def run_normal(program, folder):
    done = subprocess.run([str(program.resolve()), "run", "--out", str(folder)], text=True, capture_output=True)
    if done.returncode != 0:
        raise SystemExit(f"try_bare: {program} ends with {done.returncode}: {done.stderr.strip()}")


def files_of(folder):
    return {os.path.relpath(os.path.join(at, name), folder) for at, _, files in os.walk(folder) for name in files}


def compared_files(folder):
    return sorted(files_of(folder) - set(COST))


def differences(expected, run):
    one, other = files_of(expected), files_of(run)
    found = [f"{name} is {'missing' if name in one else 'there, and not of the normal build'}" for name in sorted(one ^ other)]
    same_named = [name for name in compared_files(expected) if name in other]
    found += [f"{name} has other bytes than of the normal build" for name in same_named if not filecmp.cmp(expected / name, run / name, False)]
    if not any(name.endswith(".png") for name in same_named):
        found.append("it leaves no pictures")
    page = run / "report.html"
    if not page.is_file() or "castaway-player" not in page.read_text() or "castaway-recording" not in page.read_text():
        found.append("its report has no player")
    return found
