#!/usr/bin/env python3
"""Odd values of every option and argument of every command of castaway: scripted, not guided.

    tests/fuzz/odd_arguments.py build/release/castaway [--cases 300] [--only run] [--seed 1]

Takes the options of a command from its --help and gives one to three of them values that make no
sense. What fails is what fails in odd_inputs.py: a signal, 20 s, 2 GiB, an error without a word.
"""
import argparse
import os
import random
import re
import resource
import shutil
import sys
import tempfile

import odd_inputs
from odd_inputs import NUMBERS, QUICK, Lab, judge, put

VALUES = NUMBERS + ["", " ", "-", "--", "..", "/", "/dev/zero", "/dev/null", "/nowhere/at/all", ".", "good",
                    "map.pgm", "x" * 5000, "%s%n", "a=b", "=", "a.b.c=1", ",", "1,2,3",
                    "\u00e4\u4e16", "\x01\x02", "*", "$(false)", "true", "-0", "1e-310", "0.0000001"]

# Commands as they work, and what of it may be made odd: all that follows the words of its name.
COMMANDS = {
    "run": ["--duration", "1", "--out", "o"] + QUICK,
    "experiment": ["1", "--quick", "--out", "o"],
    "compare": ["good", "good", "--out", "o"],
    "dataset": ["d.yaml", "--out", "o", "-n", "1"],
    "replay": ["l.carmen", "--map", "map.yaml", "--out", "o"],
    "evaluate": ["log", "--starts", "1", "--kidnaps", "1", "--no-tracking"],
    "bag": ["b.mcap"],
    "report": ["run"],
    "map": ["lab", "--out", "o"],
    "check-robot": ["good.urdf", "--out", "o"],
    "check-world": ["w.yaml", "--out", "o"],
    "lidars": [], "worlds": [], "robots": [], "scenarios": [], "completion": ["bash"], "man": [],
    "list": ["worlds"], "help": ["run"], "version": [],
    "bench kidnaps": ["--kidnaps", "1", "--window", "1", "--lead", "1"],
    "bench localization": [], "bench simulation": [],
}
# Commands whose work without odd values is minutes: only cases that give them a wrong value run.
LONG = {"experiment", "bench localization", "bench simulation"}


def prepare(lab):
    odd_inputs.prepare(lab)
    put(lab, "d.yaml", odd_inputs.DATASET)
    put(lab, "w.yaml", odd_inputs.WORLD)
    put(lab, "l.carmen", odd_inputs.CARMEN)
    put(lab, "log/l.clf", odd_inputs.CARMEN)
    put(lab, "b.mcap", odd_inputs.good_content(lab, "mcap", None))
    shutil.copytree(os.path.join(lab.folder, "good"), os.path.join(lab.folder, "run"))


def options_of(lab, words):
    """Options that take a value, as the command's help names them."""
    code, text, _, _ = lab.run(words + ["--help"])
    if code != 0:
        sys.exit(f"{' '.join(words)} --help: {text}")
    return re.findall(r"^  (?:-\w,)?(--?[a-z][a-z-]*) [A-Z]", text, re.MULTILINE)


def odd_case(base, options, rng):
    """The command line with one to three values replaced or added."""
    line = list(base)
    for _ in range(rng.choice([1, 1, 2, 3])):
        value = rng.choice(VALUES)
        arguments = [i for i, word in enumerate(line) if not word.startswith("-")]
        if options and (not arguments or rng.random() < 0.6):
            give(line, rng.choice(options), value)
        elif arguments:
            line[rng.choice(arguments)] = value
        else:
            line.append(value)
    return line


def give(line, option, value):
    """Gives an option the value, in place of the one that it has."""
    if option in line[:-1]:
        line[line.index(option) + 1] = value
    else:
        line += [option, value]


def run_command(lab, name, cases, rng):
    words = name.split()
    base, options = COMMANDS[name], options_of(lab, words)
    failures, slowest, most, refused = [], 0.0, 0, 0
    for _ in range(cases):
        line = words + odd_case(base, options, rng)
        shutil.rmtree(os.path.join(lab.folder, "o"), ignore_errors=True)
        code, text, memory, took = lab.run(line)
        slowest, most, refused = max(slowest, took), max(most, memory), refused + (code != 0)
        why = judge(code, text, memory)
        if why == f"longer than {odd_inputs.LIMIT_S} s" and name in LONG:
            continue  # Its values are fine, or its work goes on: minutes are what it takes.
        if why is not None:
            failures.append(line)
            print("FAIL", why, [word[:100] for word in line], text.strip()[-200:], flush=True)
    print(f"{name}: {cases} cases of {len(options)} options, {refused} refused, slowest {slowest:.1f} s, "
          f"most {most >> 20} MiB, {len(failures)} failed", flush=True)
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--cases", type=int, default=300)
    parser.add_argument("--only", nargs="*", choices=sorted(COMMANDS))
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        lab = Lab(arguments.program, folder)
        prepare(lab)
        for name in arguments.only or COMMANDS:
            failures += run_command(lab, name, arguments.cases, random.Random(f"{arguments.seed}/{name}"))
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
