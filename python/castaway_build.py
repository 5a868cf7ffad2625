"""Builds the wheel of castaway (PEP 517): CMake for the module, the standard library for the rest.

CASTAWAY_BUILD_DIR: the build folder (build/<tag>), used as it is configured.
CMAKE_BUILD_PARALLEL_LEVEL: compilers at once.
"""

from __future__ import annotations

import base64
import hashlib
import os
import subprocess
import sys
import sysconfig
import tarfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DATA_FOLDERS = ("worlds", "robots", "lidars", "datasets")
EPOCH = (2020, 1, 1, 0, 0, 0)  # The same files give the same wheel.


def read_project() -> dict:
    return tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def metadata(project: dict) -> str:
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {project['name']}",
        f"Version: {project['version']}",
        f"Summary: {project['description']}",
        f"Requires-Python: {project['requires-python']}",
        *(f"Requires-Dist: {name}" for name in project["dependencies"]),
    ]
    for extra, names in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f'Requires-Dist: {name}; extra == "{extra}"' for name in names]
    lines += ["Description-Content-Type: text/markdown", "", (ROOT / "README.md").read_text()]
    return "\n".join(lines)


def _tag() -> str:
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def _build_module() -> Path:
    """Compiles the module and returns its file."""
    folder = ROOT / os.environ.get("CASTAWAY_BUILD_DIR", f"build/{_tag()}")
    if not (folder / "CMakeCache.txt").exists():
        options = [
            "-DCMAKE_BUILD_TYPE=Release",
            "-DCASTAWAY_PYTHON=ON",
            "-DCASTAWAY_BUILD_TESTS=OFF",
            f"-DPython3_EXECUTABLE={os.path.realpath(sys.executable)}",
        ]
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", *options], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "castaway_python"], check=True)
    return folder / "python/castaway" / f"_castaway{sysconfig.get_config_var('EXT_SUFFIX')}"


def package_files() -> dict[str, Path]:
    """Files of the package besides the module, by their names in the wheel."""
    files = {}
    sources = ROOT / "python/castaway"
    for file in sorted(sources.iterdir()):
        if file.suffix in (".py", ".pyi") or file.name == "py.typed":
            files[f"castaway/{file.name}"] = file
    for folder in DATA_FOLDERS:
        for file in sorted((ROOT / folder).rglob("*")):
            if file.is_file():
                files[f"castaway/data/{file.relative_to(ROOT).as_posix()}"] = file
    return files


class Wheel:
    """A wheel that is being written, with its RECORD."""

    def __init__(self, file: Path, info: str, date: tuple[int, ...] = EPOCH) -> None:
        self._zip = zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED)
        self._record = f"{info}/RECORD"
        self._date = date
        self._lines: list[str] = []

    def add(self, name: str, content: bytes, mode: int = 0o644) -> None:
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        self._lines.append(f"{name},sha256={digest},{len(content)}")
        self._write(name, content, mode)

    def close(self) -> None:
        lines = "\n".join([*self._lines, f"{self._record},,"]) + "\n"
        self._write(self._record, lines.encode(), 0o644)
        self._zip.close()

    def _write(self, name: str, content: bytes, mode: int) -> None:
        entry = zipfile.ZipInfo(name, self._date)
        entry.external_attr = (0o100000 | mode) << 16
        entry.compress_type = zipfile.ZIP_DEFLATED
        self._zip.writestr(entry, content)


def _info(project: dict) -> dict[str, bytes]:
    """Files of the wheel's .dist-info folder, without RECORD."""
    text = f"Wheel-Version: 1.0\nGenerator: castaway_build\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    return {
        "METADATA": metadata(project).encode(),
        "LICENSE": (ROOT / "LICENSE").read_bytes(),
        "WHEEL": text.encode(),
    }


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None) -> str:
    project = read_project()
    folder = Path(metadata_directory) / f"{project['name']}-{project['version']}.dist-info"
    folder.mkdir()
    for name, content in _info(project).items():
        (folder / name).write_bytes(content)
    return folder.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None) -> str:
    project = read_project()
    module = _build_module()
    release = f"{project['name']}-{project['version']}"
    name = f"{release}-{_tag()}.whl"
    wheel = Wheel(Path(wheel_directory) / name, f"{release}.dist-info")
    for path, file in package_files().items():
        wheel.add(path, file.read_bytes())
    wheel.add(f"castaway/{module.name}", module.read_bytes(), 0o755)
    for path, content in _info(project).items():
        wheel.add(f"{release}.dist-info/{path}", content)
    wheel.close()
    return name


def build_sdist(sdist_directory, config_settings=None) -> str:
    project = read_project()
    release = f"{project['name']}-{project['version']}"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True)
    with tarfile.open(Path(sdist_directory) / f"{release}.tar.gz", "w:gz") as archive:
        for path in filter(None, listed.stdout.decode().split("\0")):
            archive.add(ROOT / path, f"{release}/{path}")
    return f"{release}.tar.gz"
