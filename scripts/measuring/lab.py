"""Where commands are measured, and how figures are written."""

import json
import pathlib
import subprocess
import sys
import tempfile

LOGS = ["intel", "freiburg-079", "aces"]
NO_PICTURES = ["--set", "outputs.snapshots=false"]


class Lab:
    """A temporary folder in which commands run."""

    def __init__(self, castaway, logs, worlds):
        self.castaway = pathlib.Path(castaway).resolve()
        self.logs = logs
        self.worlds = worlds
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="castaway-measure-"))

    def run(self, arguments):
        """The standard output of `castaway ARGUMENTS`."""
        return self.program("castaway", arguments)

    def program(self, name, arguments):
        """The standard output of a program that the build put beside castaway."""
        path = self.castaway if name == "castaway" else self.castaway.parent / name
        done = subprocess.run([path, *arguments], cwd=self.folder, text=True, capture_output=True)
        if done.returncode != 0:
            sys.exit(f"measure: {name} {' '.join(arguments)}: exit {done.returncode}\n{done.stdout[-400:]}{done.stderr}")
        return done.stdout

    def summary(self, arguments, out):
        """summary.json of `castaway run ARGUMENTS --out OUT`; a folder that is there is taken as it is."""
        if not (self.folder / out).exists():
            self.run(["run", *arguments, "--out", out])
        return self.json_of(f"{out}/summary.json")

    def json_of(self, path):
        return json.loads((self.folder / path).read_text())

    def log(self, name, file):
        return str(self.logs / name / file)


def fence(text):
    return "```\n" + text.rstrip("\n") + "\n```\n"


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(str(cell) for cell in line) + " |\n" for line in lines)


def figure(value, pattern, unit=""):
    return "-" if value is None else pattern.format(value) + unit


def percent(value, digits=1):
    return "-" if value is None else f"{100 * value:.{digits}f} %"


def share(rate):
    return f"{rate['recovered']} of {rate['trials' if 'trials' in rate else 'events']}"


def mean(values):
    known = [value for value in values if value is not None]
    return sum(known) / len(known) if known else None


def mean_of(summary, key):
    """The mean of a figure over the runs of `run --seeds`; None where no run has it."""
    return summary["figures"].get(key, {}).get("mean")


def percentile(values, percent_below):
    """The smallest value that so many per cent of the values do not exceed."""
    ordered = sorted(values)
    return ordered[max(0, -(-percent_below * len(ordered) // 100) - 1)] if ordered else None


def bench(program, *arguments):
    """A block that shows what a command prints."""
    return lambda lab: fence(lab.program(program, list(arguments)))
