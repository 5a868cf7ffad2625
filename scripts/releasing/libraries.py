"""The shared libraries of the bundle: the program's, those of a software renderer, and the dynamic loader."""

import os
import pathlib
import re
import shutil
import struct
import subprocess

SYSTEM = pathlib.Path("/usr/lib/x86_64-linux-gnu")
LOADER = "ld-linux-x86-64.so.2"
# What is loaded by name: by libepoxy, by libglvnd, and by Mesa's EGL.
LOADED = ["libEGL.so.1", "libGL.so.1", "libEGL_mesa.so.0"]
# All of the C library: a localizer in a shared library may need parts that castaway does not, and they go with its own only.
LOADED += ["libanl.so.1", "libdl.so.2", "libmvec.so.1", "libpthread.so.0", "libresolv.so.2", "librt.so.1", "libutil.so.1"]
DRIVER = SYSTEM / "dri/swrast_dri.so"
VENDOR = pathlib.Path("/usr/share/glvnd/egl_vendor.d/50_mesa.json")

DT_NULL, DT_RUNPATH = 0, 29
PT_DYNAMIC = 2


def needed_by(file):
    """Name and file of every library that `file` loads with it, the loader included."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("LD_")}
    text = subprocess.run(["ldd", str(file)], check=True, text=True, capture_output=True, env=dict(environment, LC_ALL="C")).stdout
    if "not found" in text:
        raise SystemExit(f"release: {file} lacks libraries:\n{text}")
    found = dict(re.findall(r"(\S+) => (/\S+)", text))
    found.update((pathlib.Path(path).name, path) for path in re.findall(r"^\s+(/\S+) \(", text, re.M))
    return found


def without_runpath(data):
    """The bytes of a library without its own folders of libraries: the program's hold for it then."""
    data = bytearray(data)
    table, = struct.unpack_from("<Q", data, 32)
    size, count = struct.unpack_from("<HH", data, 54)
    for header in range(table, table + size * count, size):
        kind, _, offset, _, _, length = struct.unpack_from("<IIQQQQ", data, header)
        if kind != PT_DYNAMIC:
            continue
        entries = [struct.unpack_from("<qQ", data, at) for at in range(offset, offset + length, 16)]
        kept = [entry for entry in entries if entry[0] != DT_RUNPATH]
        kept += [(DT_NULL, 0)] * (len(entries) - len(kept))
        for i, entry in enumerate(kept):
            struct.pack_into("<qQ", data, offset + 16 * i, *entry)
    return bytes(data)


def copy_all(program, folder):
    """Copies the libraries into `folder` and the renderer into `renderer` in it; returns the origin of each copied file by its name."""
    files = {name: str(SYSTEM / name) for name in LOADED}
    for file in [program, *files.values(), DRIVER]:
        files = {**needed_by(file), **files}
    files[f"renderer/{DRIVER.name}"] = str(DRIVER)
    (folder / "renderer").mkdir(parents=True)
    for name, file in sorted(files.items()):
        (folder / name).write_bytes(without_runpath(pathlib.Path(file).read_bytes()))
    (folder / LOADER).chmod(0o755)
    shutil.copyfile(VENDOR, folder / "renderer/vendor.json")
    files["renderer/vendor.json"] = str(VENDOR)
    return files
