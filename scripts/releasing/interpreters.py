"""Headers of the interpreters that the wheel is built for: Debian's packages of three suites."""

import csv
import gzip
import pathlib
import re
import shutil
import subprocess
import tempfile

SUITES = {"bullseye": "3.9", "bookworm": "3.11", "trixie": "3.13"}
BINDINGS = "trixie"  # Its pybind11 knows Python 3.13 and numpy 2, and has no part but headers.
MACHINE = "x86_64-linux-gnu"


def extract(suite, packages, folder, mirror):
    command = ["mmdebstrap", "--variant=extract", "--quiet", f"--include={','.join(packages)}", suite, str(folder), mirror]
    done = subprocess.run(command, text=True, capture_output=True)
    if done.returncode != 0:
        raise SystemExit(f"release: mmdebstrap failed: {done.stderr.strip()[-500:]}")
    return folder / "usr/include"


def copy_terms(doc, target):
    """Copies a package's licence, and adds the package with version and source package to the list of `packages`."""
    (target / "licences").mkdir(parents=True, exist_ok=True)
    shutil.copyfile(doc / "copyright", target / "licences" / doc.name)
    with gzip.open(doc / "changelog.Debian.gz", "rt", encoding="utf-8") as file:
        source, version = re.match(r"(\S+) \((\S+)\)", file.readline()).groups()
    with (target / "packages.tsv").open("a", newline="") as file:
        csv.writer(file, delimiter="\t", lineterminator="\n").writerow([doc.name, version, source])


def packages(target):
    """Package, version, source package, and file of the licence."""
    if not (target / "packages.tsv").is_file():
        return []
    with (target / "packages.tsv").open(newline="") as file:
        return [(*row, target / "licences" / row[0]) for row in csv.reader(file, delimiter="\t")]


def fetch_headers(target, mirror):
    """Fills `target` with a folder pythonX.Y for each interpreter, with pybind11, and with what is of this machine's kind only."""
    shutil.rmtree(target, ignore_errors=True)
    for suite, version in SUITES.items():
        packages = [f"libpython{version}-dev", *(["pybind11-dev"] if suite == BINDINGS else [])]
        with tempfile.TemporaryDirectory() as folder:
            found = extract(suite, packages, pathlib.Path(folder) / suite, mirror)
            for package in packages:
                copy_terms(found.parent / "share/doc" / package, target)
            for name in [f"python{version}", f"{MACHINE}/python{version}", *(["pybind11"] if suite == BINDINGS else [])]:
                shutil.copytree(found / name, target / name, symlinks=True)


def add_headers(target, folder):
    """Adds an interpreter by its folder include/pythonX.Y; pyconfig.h is in it, or where Debian and Ubuntu have it."""
    for name in [folder.name, f"{MACHINE}/{folder.name}"]:
        if (folder.parent / name).is_dir():
            shutil.copytree(folder.parent / name, target / name, dirs_exist_ok=True)
