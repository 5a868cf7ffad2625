"""Measured blocks in pages: which code, commit, day and machine they are of."""

import datetime
import hashlib
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# What a clock measured differs between machines and is not compared.
CLOCKS = [r"[\d.]+ x real time.*", r"[\d.]+ ms"]


def git(*arguments):
    return subprocess.run(["git", "-C", str(ROOT), *arguments], text=True, capture_output=True).stdout.strip()


def meaning_of(path):
    """What of a file can change a figure: of C++ not its comments, includes, white space and place."""
    data = path.read_bytes()
    if path.suffix not in (".cpp", ".hpp"):
        return data
    text = re.sub(r"^\s*(#include|#pragma once|//).*$|(?<=[;{},)])\s*//.*$", "", data.decode(), flags=re.M)
    return "".join(text.split()).encode()


def code_of(depends):
    """Hash of the files under these paths, as they stand, whatever their names."""
    listed = git("ls-files", *depends).splitlines()
    if not listed:  # Not a checkout: every file.
        listed = [str(p.relative_to(ROOT)) for d in depends for p in sorted((ROOT / d).rglob("*")) if p.is_file()]
    paths = [ROOT / name for name in listed if not name.endswith(("CMakeLists.txt", ".md"))]
    files = sorted(hashlib.sha256(meaning_of(path)).digest() for path in paths if path.is_file())
    return hashlib.sha256(b"".join(files)).hexdigest()[:12]


def machine():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown"


def find(page, name):
    """The match of a block: its head, then its text."""
    pattern = re.compile(rf"<!-- measured: {name}\b(?!-)(.*?) -->\n(.*?)<!-- end of {name} -->\n", re.S)
    found = pattern.search(page)
    if not found:
        sys.exit(f"measure: no block '{name}' in its page")
    return found


def text_of(name, block):
    return find((ROOT / block.page).read_text(), name).group(2)


def write(name, block, text):
    path = ROOT / block.page
    old = path.read_text()
    found = find(old, name)
    head = (f"<!-- measured: {name}, commit {git('rev-parse', '--short', 'HEAD')}, {datetime.date.today()}, {machine()}, "
            f"code {code_of(block.depends)} -->\n")
    path.write_text(old[: found.start()] + head + text + f"<!-- end of {name} -->\n" + old[found.end():])


def restamp(name, block):
    """States that the code as it stands gives the same figures."""
    path = ROOT / block.page
    old = path.read_text()
    found = find(old, name)
    head = re.sub(r"code \w+(, same results at \w+)?", f"code {code_of(block.depends)}, same results at {git('rev-parse', '--short', 'HEAD')}",
                  found.group(1))
    path.write_text(old[: found.start(1)] + head + old[found.end(1):])


def is_fresh(name, block):
    said = re.search(r"code (\w+)", find((ROOT / block.page).read_text(), name).group(1))
    return said is not None and said.group(1) == code_of(block.depends)


def without_clocks(text):
    for pattern in CLOCKS:
        text = re.sub(pattern, "#", text)
    return re.sub(r" +", " ", text)
