"""Roots with nothing installed, and what runs in them."""

import os
import pathlib
import stat
import subprocess
import sys

EMPTY = "empty"
MIRROR = "http://deb.debian.org/debian"
PRIVATE = "CASTAWAY_BARE_PRIVATE"  # Set in the process whose mounts are its own.
BUNDLE = "opt"


class RootError(RuntimeError):
    pass


def mount_privately():
    """Starts this script again in a mount namespace: its mounts end with it."""
    if PRIVATE not in os.environ:
        os.environ[PRIVATE] = "1"
        os.execvp("unshare", ["unshare", "--mount", "--propagation", "private", sys.executable, "-B", *sys.argv])


def own_mirror():
    """The mirror that this machine's apt takes Debian from."""
    command = ["apt-get", "indextargets", "--format", "$(REPO_URI)", "Created-By: Packages", "Label: Debian"]
    lines = subprocess.run(command, text=True, capture_output=True).stdout.split()
    return lines[0] if lines else MIRROR


def make(suite, folder, mirror, packages=()):
    """A root of a suite's essential packages, and of further ones."""
    if suite == EMPTY:
        folder.mkdir()
    else:
        include = [f"--include={name}" for name in packages]
        command = ["mmdebstrap", "--variant=essential", "--quiet", *include, suite, str(folder), mirror or own_mirror()]
        done = subprocess.run(command, text=True, capture_output=True)
        if done.returncode != 0:
            raise RootError(f"mmdebstrap failed: {done.stderr.strip()[-500:]}")
    for name in [BUNDLE, "proc", "dev", "tmp", "work"]:
        (folder / name).mkdir(exist_ok=True)
    folder.chmod(0o755)


def unpack(archive, folder):
    subprocess.run(["tar", "--zstd", "--no-same-owner", "-xf", str(archive), "-C", str(folder / BUNDLE)], check=True)


def work_of(user):
    return pathlib.Path("work") / str(user)


def mount(folder, work_mode="noexec"):
    """Mounts what runs need, and the bundle's folder read-only. In the folder of the runs no program starts, unless its mode is `exec`."""
    def mount_one(*words):
        subprocess.run(["mount", *words], check=True)

    bundle, work = folder / BUNDLE, folder / "work"
    mount_one("--bind", str(bundle), str(bundle))
    mount_one("-o", "remount,bind,ro,nosuid,nodev", str(bundle))
    mount_one("-t", "proc", "-o", "nosuid,nodev,noexec", "proc", str(folder / "proc"))
    for name, mode in {"tmp": "noexec", "work": work_mode}.items():
        mount_one("-t", "tmpfs", "-o", f"nosuid,nodev,{mode},mode=1777", "tmpfs", str(folder / name))
    mount_one("-t", "tmpfs", "-o", "nosuid,mode=0755", "tmpfs", str(folder / "dev"))
    for name, number in {"null": 3, "zero": 5, "random": 8, "urandom": 9}.items():
        os.mknod(folder / "dev" / name, stat.S_IFCHR | 0o666, os.makedev(1, number))
        (folder / "dev" / name).chmod(0o666)
    work.chmod(0o755)


def unmount(folder):
    for name in ["dev", "work", "tmp", "proc", BUNDLE]:
        subprocess.run(["umount", "--lazy", str(folder / name)], capture_output=True)


def run(folder, user, command, path="/usr/bin:/bin"):
    """Runs a program in the root, by its absolute path, in a folder of the user's own."""
    work = folder / work_of(user)
    work.mkdir(exist_ok=True)
    os.chown(work, user, user)

    def enter():
        os.chroot(folder)
        os.chdir("/" + str(work_of(user)))
        os.setgroups([])
        os.setgid(user)
        os.setuid(user)

    environment = {"PATH": path, **({"HOME": "/root"} if user == 0 else {})}
    return subprocess.run(command, preexec_fn=enter, env=environment, text=True, capture_output=True)


def state_of(folder):
    """Size and time of change of everything in the root but what the kernel shows and the folder of the runs."""
    found = {}
    for at, folders, files in os.walk(folder):
        if at == str(folder):
            folders[:] = [name for name in folders if name not in ("proc", "dev", "work")]
        for name in [*folders, *files]:
            facts = os.lstat(os.path.join(at, name))
            found[os.path.relpath(os.path.join(at, name), folder)] = (facts.st_size, facts.st_mtime_ns, facts.st_ctime_ns)
    return found


def changes(before, after):
    return sorted(name for name in before.keys() | after.keys() if before.get(name) != after.get(name))
