"""The archive: the same bytes for the same files."""

import hashlib
import os
import subprocess
import tarfile


def entry_of(tar, path, name, stamp):
    entry = tar.gettarinfo(path, name)
    entry.mtime = stamp
    entry.uid = entry.gid = 0
    entry.uname = entry.gname = ""
    entry.mode = 0o755 if entry.isdir() or os.access(path, os.X_OK) else 0o644
    return entry


def write(folder, target, stamp, level):
    """Packs `folder` with its name, and writes the checksum of the archive beside it."""
    paths = [folder, *sorted(folder.rglob("*"), key=lambda path: path.relative_to(folder).as_posix())]
    zstd = ["zstd", f"-{level}", "--long=27", "--single-thread", "--quiet", "--force", "-o", str(target)]
    with subprocess.Popen(zstd, stdin=subprocess.PIPE) as packer:
        with tarfile.open(fileobj=packer.stdin, mode="w|", format=tarfile.GNU_FORMAT) as tar:
            for path in paths:
                entry = entry_of(tar, path, path.relative_to(folder.parent).as_posix(), stamp)
                if entry.isreg():
                    with path.open("rb") as file:
                        tar.addfile(entry, file)
                else:
                    tar.addfile(entry)
        packer.stdin.close()
    if packer.returncode != 0:
        raise subprocess.CalledProcessError(packer.returncode, zstd)
    sums = target.with_name(target.name + ".sha256")
    sums.write_text(f"{hashlib.sha256(target.read_bytes()).hexdigest()}  {target.name}\n")
    return target
