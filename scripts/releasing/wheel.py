"""The wheel that contains its libraries: the bundle with modules for Python.

Libraries of the same name exist in a process once. So all but those of the C and C++ compilers get names of their own: they
neither meet those of Debian's or other packages, nor serve them. The C library and libstdc++ are the machine's for the modules,
and the bundle's for the program.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import time

from releasing import older_glibc

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
import castaway_build  # noqa: E402  The wheel of `pip install .`.

LOADER = "ld-linux-x86-64.so.2"
OF_COMPILERS = re.compile(r"lib(anl|c|dl|gcc_s|m|mvec|pthread|resolv|rt|stdc\+\+|util)\.so\.\d+")
OWN = "caw"  # Takes the place of `lib`: names keep their length.
NAME = re.compile(rb'lib[\w.+-]+(?=[\0"])')
PART_OF_NAME = re.compile(rb"[\w.+-]")
LEAST_GLIBC = 35  # What systems have whose libstdc++ is that of GCC 12, as the tags manylinux_2_N have it.
RANDOM = "cawrandom.so"
# Opened by name: by libepoxy, by libglvnd, and by Mesa's EGL.
OPENED = {"cawEGL.so.1": "$ORIGIN", "cawGL.so.1": "$ORIGIN", "cawEGL_mesa.so.0": "$ORIGIN", "renderer/swrast_dri.so": "$ORIGIN/.."}


def own_name(name):
    return OWN + name.removeprefix("lib")


def rename_in(data, names):
    """The bytes of a file with the names of libraries replaced: of those that it loads, by the linker or by itself, and its own."""

    def replace(match):
        whole = match.start() == 0 or not PART_OF_NAME.match(data, match.start() - 1)
        return own_name(match[0].decode()).encode() if whole and match[0].decode() in names else match[0]

    return NAME.sub(replace, data)


def rename_libraries(package):
    """Moves the compilers' libraries to lib/system and renames all others, wherever they are named."""
    folder = package / "lib"
    files = [file for file in folder.iterdir() if file.is_file() and file.name != LOADER]
    (folder / "system").mkdir()
    names = {file.name for file in files if not OF_COMPILERS.fullmatch(file.name)}
    for file in files:
        file.rename(folder / own_name(file.name) if file.name in names else folder / "system" / file.name)
    for file in [*folder.glob("caw*"), *(folder / "renderer").iterdir(), package / "bin/castaway", *package.glob("_castaway.*.so")]:
        file.write_bytes(rename_in(file.read_bytes(), names))
    table = package / "share/doc/castaway/PARTS.tsv"
    lines = [part_line(line, names) for line in table.read_text().splitlines()]
    lines += [f"lib/{name}\tcastaway\t\tcastaway\t\tApache-2.0\tLICENSE" for name in ["cawcastaway.so", RANDOM]]
    table.write_text("\n".join(lines) + "\n")


def compile_library(source, target, *options):
    fixed = ["-std=c11", "-O2", "-fPIC", "-shared", "-D_GNU_SOURCE", f"-Wl,-soname,{target.name},--build-id=none"]
    subprocess.run(["cc", *fixed, *options, "-o", target, source], check=True)
    subprocess.run(["strip", target], check=True)


def drop_icu_data(package):
    """Replaces the data of ICU by none (bundle/no_icu_data.c)."""
    file, = (package / "lib").glob("libicudata.so.*")
    version = file.name.rsplit(".", 1)[1]
    file.unlink()
    compile_library(ROOT / "bundle/no_icu_data.c", file, "-nostdlib", f"-DCASTAWAY_ICU_DATA=icudt{version}_dat")


def allow_older_glibc(package):
    """Gives arc4random to the libraries that need a newer C library for it only (bundle/random.c)."""
    compile_library(ROOT / "bundle/random.c", package / "lib" / RANDOM)
    for file in (package / "lib").glob("caw*"):
        text = output_of("objdump", "-T", file)
        if set(re.findall(rf"\({re.escape(older_glibc.NEWER)}\)\s+(\S+)", text)) & {"arc4random", "arc4random_buf"}:
            file.write_bytes(older_glibc.with_older_version(file.read_bytes()))
            subprocess.run(["patchelf", "--add-needed", RANDOM, file], check=True)


def set_run_paths(package):
    """Libraries that are opened by name do not inherit the run path of the module: they get their own."""
    for name, path in OPENED.items():
        file = package / "lib" / name
        subprocess.run(["patchelf", "--force-rpath", "--set-rpath", path, file], check=True)


def part_line(line, names):
    """A line of PARTS.tsv with the names of the wheel."""
    part, rest = line.split("\t", 1)
    name = part.removeprefix("lib/")
    if name.startswith("libicudata"):
        rest = "castaway\t\tcastaway\t\tApache-2.0\tLICENSE"
    if name in names:
        part = f"lib/{own_name(name)}"
    elif OF_COMPILERS.fullmatch(name):
        part = f"lib/system/{name}"
    return f"{part}\t{rest}"


def output_of(*command):
    return subprocess.run([str(word) for word in command], check=True, text=True, capture_output=True).stdout


def require_complete(package, files):
    """All that the files load is in the wheel, or of the compilers."""
    there = {file.name for file in (package / "lib").iterdir()}
    for file in files:
        for name in re.findall(r"NEEDED\s+(\S+)", output_of("objdump", "-p", file)):
            if name not in there and not OF_COMPILERS.fullmatch(name):
                raise SystemExit(f"release: {file.name} in the wheel needs {name}, which is not")


def needed_glibc(files):
    """The minor number of the oldest glibc 2 that has all that the files need."""
    found = [int(number) for file in files for number in re.findall(r"\(GLIBC_2\.(\d+)", output_of("objdump", "-T", file))]
    return max([LEAST_GLIBC, *found])


def zip_time(stamp):
    """The date of files in the wheel: zip begins with 1980."""
    return time.gmtime(max(stamp, 315532800))[:6]


def interpreters(package):
    """cp39, cp311, ...: those that there are modules for."""
    versions = [re.search(r"cpython-3(\d+)-", file.name)[1] for file in package.glob("_castaway.*.so")]
    return [f"cp3{minor}" for minor in sorted(versions, key=int)]


def metadata(python):
    project = castaway_build.read_project()
    return castaway_build.metadata(project | {"requires-python": f">=3.{python[0].removeprefix('cp3')}"})


def fill_package(stage, core, modules, package):
    shutil.copytree(stage, package)
    shutil.copyfile(core, package / "lib" / core.name)
    subprocess.run(["strip", package / "lib" / core.name], check=True)
    for name, file in castaway_build.package_files().items():
        if not name.startswith("castaway/data/"):
            shutil.copyfile(file, package / pathlib.Path(name).name)
    for module in modules:
        shutil.copyfile(module, package / module.name)
        subprocess.run(["strip", package / module.name], check=True)
        (package / module.name).chmod(0o755)


def write(stage, core, modules, folder, stamp):
    """Makes the wheel in `folder` of a staged bundle, the modules and their common library, for the interpreters and glibc that they need."""
    package = stage.parent / "wheel/castaway"
    fill_package(stage, core, modules, package)
    drop_icu_data(package)
    rename_libraries(package)
    allow_older_glibc(package)
    set_run_paths(package)
    loaded = [*package.glob("_castaway.*.so"), *(package / "lib").glob("caw*"), *(package / "lib/renderer").glob("*.so")]
    require_complete(package, [*loaded, package / "bin/castaway"])
    python, platform = interpreters(package), f"manylinux_2_{needed_glibc(loaded)}_x86_64"
    project = castaway_build.read_project()
    release = f"{project['name']}-{project['version']}"
    target = folder / f"{release}-{'.'.join(python)}-{'.'.join(python)}-{platform}.whl"
    wheel = castaway_build.Wheel(target, f"{release}.dist-info", zip_time(stamp))
    for file in sorted(file for file in package.rglob("*") if file.is_file()):
        name = file.relative_to(package.parent).as_posix()
        wheel.add(name, file.read_bytes(), 0o755 if file.stat().st_mode & 0o100 else 0o644)
    wheel.add(f"{release}.data/scripts/castaway", (ROOT / "python/castaway_script.py").read_bytes(), 0o755)
    tags = "".join(f"Tag: {one}-{one}-{platform}\n" for one in python)
    wheel.add(f"{release}.dist-info/METADATA", metadata(python).encode())
    wheel.add(f"{release}.dist-info/LICENSE", (ROOT / "LICENSE").read_bytes())
    wheel.add(f"{release}.dist-info/WHEEL", f"Wheel-Version: 1.0\nGenerator: castaway\nRoot-Is-Purelib: false\n{tags}".encode())
    wheel.close()
    return target
