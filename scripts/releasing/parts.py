"""The parts of the bundle: their packages, source packages and licences."""

import csv
import dataclasses
import json
import pathlib
import re
import shutil
import subprocess

COMMON = pathlib.Path("/usr/share/common-licenses")
DOC = pathlib.Path("/usr/share/doc")
# Licences of the libraries of source packages whose copyright files only tell them, not in Debian's format.
TOLD = {
    "gcc-12": "GPL-3+ with GCC Runtime Library exception", "glibc": "LGPL-2.1+", "gnutls28": "LGPL-2.1+", "krb5": "MIT",
    "libaec": "BSD-2-clause", "libdrm": "MIT", "libpciaccess": "MIT", "libtasn1-6": "LGPL-2.1+", "libx11": "MIT", "libxau": "MIT",
    "libxcb": "MIT", "libxdmcp": "MIT", "libxshmfence": "MIT", "lm-sensors": "LGPL-2.1+", "python3.9": "PSF-2", "python3.11": "PSF-2",
    "python3.13": "PSF-2", "rtmpdump": "LGPL-2.1+", "wayland": "MIT"}


@dataclasses.dataclass
class Row:
    part: str
    package: str
    version: str
    source: str
    source_version: str
    licence: str
    text: str  # The file of the licence, before it is copied; then its name in the folder of licences.


def owners_of(files):
    """The Debian package of each file."""
    found = {}
    # Before a file of /usr/lib its package may name it in /lib, which is a link.
    names = {name: file for file in files for name in {str(file), str(file).removeprefix("/usr"), f"/usr{file}"}}
    text = subprocess.run(["dpkg", "-S", *names], text=True, capture_output=True).stdout
    for line in text.splitlines():
        package, _, name = line.rpartition(": ")
        if not line.startswith("diversion ") and name in names:
            found[names[name]] = package.split(",")[0]
    lost = [str(file) for file in files if file not in found]
    if lost:
        raise SystemExit(f"release: these files are of no package: {', '.join(lost)}")
    return found


def licence_of(source, text):
    """The licences that the copyright file of a source package names: of all its files, those that build and test it included."""
    if "copyright-format" not in text.split("\n\n")[0]:
        return TOLD.get(source, "see its text")
    names = re.findall(r"^License: *(\S.*)$", text, re.M)
    return "; ".join(dict.fromkeys(name.strip() for name in names))


def package_row(part, package):
    name = package.split(":")[0]
    form = "${Version}\t${source:Package}\t${source:Version}"
    version, source, source_version = subprocess.run(
        ["dpkg-query", "-W", "-f", form, package], check=True, text=True, capture_output=True).stdout.split("\t")
    text = DOC / name / "copyright"
    return Row(part, name, version, source, source_version, licence_of(source, text.read_text(errors="replace")), str(text))


def compiled_in(build):
    """Debian packages of the headers that the program was compiled with, and of the archive of elementary functions."""
    text = subprocess.run(["ninja", "-C", str(build), "-t", "deps"], check=True, text=True, capture_output=True).stdout
    headers, wanted = set(), False
    for line in text.splitlines():
        if not line.startswith(" "):
            wanted = not re.match(r"(tests|python)/", line)
        elif wanted and line.strip().startswith("/usr/"):
            headers.add(str(pathlib.Path(line.strip()).resolve()))
    cache = (build / "CMakeCache.txt").read_text()
    headers.add(re.search(r"^CASTAWAY_MUSL_LIBC:FILEPATH=(.*)$", cache, re.M)[1])
    return sorted(set(owners_of(sorted(headers)).values()))


def player_rows(package_file, modules):
    for name in json.loads(package_file.read_text())["dependencies"]:
        about = json.loads((modules / name / "package.json").read_text())
        yield Row("bin/castaway: the player", f"npm:{name}", about["version"], f"npm:{name}", about["version"], about["license"],
                  str(modules / name / "LICENSE"))


def rows(libraries, packages, package_file, modules):
    owners = owners_of(sorted({str(pathlib.Path(file).resolve()) for file in libraries.values()}))
    shared = [package_row(f"lib/{name}", owners[str(pathlib.Path(file).resolve())]) for name, file in sorted(libraries.items())]
    inside = [package_row("bin/castaway: headers and archives", package) for package in packages]
    return [*shared, *inside, *player_rows(package_file, modules)]


def module_rows(packages):
    """Headers that the modules of the wheel were compiled with."""
    for package, version, source, text in packages:
        yield Row("castaway/_castaway: headers", package, version, source, version, licence_of(source, text.read_text()), str(text))


def copy_licences(found, folder):
    """Copies every text once, and the common licences that texts refer to."""
    (folder / "common-licenses").mkdir(parents=True)
    for row in found:
        if not row.text.startswith("/"):
            continue
        text, target = pathlib.Path(row.text), folder / row.package.replace(":", "-").replace("/", "-")
        shutil.copyfile(text, target)
        row.text = f"licences/{target.name}"
        for name in re.findall(r"/usr/share/common-licenses/([A-Za-z0-9.-]*[A-Za-z0-9])", text.read_text(errors="replace")):
            if (COMMON / name).is_file():
                shutil.copyfile(COMMON / name, folder / "common-licenses" / name)


def write(found, target):
    with target.open("w", newline="") as file:
        table = csv.writer(file, delimiter="\t", lineterminator="\n", quoting=csv.QUOTE_MINIMAL)
        table.writerow(field.name for field in dataclasses.fields(Row))
        table.writerows(dataclasses.astuple(row) for row in found)
