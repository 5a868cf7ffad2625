#!/usr/bin/env python3
"""Odd inputs for every command and format of castaway: scripted, not guided.

    tests/fuzz/odd_inputs.py build/release/castaway [--cases 300] [--only urdf] [--seed 1]

Makes files that are cut short, changed by bytes, numbers of any size in place of others, nested
deep, empty, of another format, folders, pipes and devices, and runs the program on each. A case
fails if the program crashes (a signal), runs longer than 20 s or takes more than 2 GiB. Prints the
failures and how many cases ran; exit code 1 if any failed. The failing files are kept.
"""
import argparse
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

LIMIT_S = 20
LIMIT_BYTES = 2 << 30
NUMBERS = ["0", "-1", "1e300", "-1e308", "1e12", "1e-300", "1e-38", "nan", "inf", "1e999",
           "2147483648", "99999999999999999999", "0x10", "''", "[]", "{}", "true", "~"]
QUICK = ["--set", "outputs.report=false", "--set", "outputs.snapshots=false",
         "--set", "localizers=[mh_amcl]"]

SCENARIO = """world: lab
duration_s: 1
seed: 3
start: {pose: [1, 2, 0.5]}
drive: {route: loop, max_speed: 0.5}
lidar: {beams: 90, range_max: 8, noise: {sigma_m: 0.01}}
odometry: {drift_along: 0.01, slip: {rate_per_m: 1, length_m: 0.2}}
people: {count: 2}
events:
  - kidnap: {at_s: 0.5, kind: teleport, min_distance_m: 1}
  - fault: {at_s: 0.2, for_s: 0.5, kind: lidar-blocked, from_deg: 1, to_deg: 40}
localizers: [mh_amcl, {amcl: {max_particles: 500}}]
outputs: {report: false, snapshots: false, tables: csv}
"""
WORLD = """name: w
extent: {min: [0, 0], max: [6, 4]}
start: [3, 2, 0]
objects:
  - wall: {points: [[0, 0], [6, 0], [6, 4], [0, 4]], closed: true}
  - box: {at: [1, 1], size: [0.5, 0.5, 0.5], yaw_deg: 10}
  - shelf: {at: [5, 3], size: [1, 0.4, 1], levels: 3}
  - repeat: {at: [2, 3], count: [2, 2], spacing: [0.5, 0.5], objects: [{cylinder: {at: [0, 0], radius: 0.1, height: 1}}]}
routes: {loop: [[2, 2], [4, 2]]}
slip_zones: [{outline: [[0, 0], [1, 0], [1, 1]], slip: 0.1}]
"""
MAP_YAML = "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
URDF = """<robot name="r"><link name="base_link"><inertial><mass value="2"/>\
<inertia ixx=".01" iyy=".02" izz=".02" ixy="0" ixz="0" iyz="0"/></inertial>
<visual><geometry><mesh filename="part.stl" scale="1 1 1"/></geometry></visual>
<collision><origin xyz="0 0 0.1" rpy="0 0 0"/><geometry><box size="0.3 0.2 0.1"/></geometry></collision></link>
<link name="l"><collision><origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.05" length="0.02"/></geometry></collision></link>
<link name="r"><collision><origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.05" length="0.02"/></geometry></collision></link>
<link name="scan"/>
<joint name="lj" type="continuous"><parent link="base_link"/><child link="l"/><origin xyz="0 0.12 0"/><axis xyz="0 1 0"/>\
<limit effort="1" velocity="10"/></joint>
<joint name="rj" type="continuous"><parent link="base_link"/><child link="r"/><origin xyz="0 -0.12 0"/><axis xyz="0 1 0"/></joint>
<joint name="sj" type="fixed"><parent link="base_link"/><child link="scan"/><origin xyz="0 0 0.2"/></joint>
<gazebo reference="scan"><sensor name="s" type="ray"><update_rate>10</update_rate>\
<ray><scan><horizontal><samples>360</samples><min_angle>-3.1</min_angle><max_angle>3.1</max_angle></horizontal></scan>\
<range><min>0.1</min><max>10</max></range></ray></sensor></gazebo>
</robot>
"""
XACRO = URDF.replace('<robot name="r">', """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:property name="w" value="${2 * 0.1 + 0.1}"/><xacro:arg name="p" default="a"/>
<xacro:macro name="m" params="n size:=^|3 *block"><link name="${n}_x"/>\
<joint name="${n}_j" type="fixed"><parent link="base_link"/><child link="${n}_x"/><xacro:insert_block name="block"/></joint></xacro:macro>
<xacro:property name="size" value="0.5"/><xacro:m n="$(arg p)"><origin xyz="0 0 ${w * size if True else 1}"/></xacro:m>
<xacro:if value="${len([1, 2]) == 2}"><link name="yes"/>\
<joint name="yj" type="fixed"><parent link="base_link"/><child link="yes"/></joint></xacro:if>""")
SDF = """<?xml version="1.0"?><sdf version="1.6"><world name="w">
<model name="box"><static>true</static><pose>1 1 0.5 0 0 0</pose>\
<link name="l"><collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision>
<visual name="v"><geometry><box><size>1 1 1</size></box></geometry></visual></link></model>
<model name="wall"><static>1</static><pose>0 3 0.5 0 0 0.3</pose>\
<link name="l"><collision name="c"><geometry><box><size>6 0.2 1</size></box></geometry></collision></link></model>
<model name="can"><static>1</static><pose>4 0 0.5 0 0 0</pose>\
<link name="l"><collision name="c"><geometry><cylinder><radius>0.3</radius><length>1</length></cylinder></geometry></collision></link></model>
<model name="m"><static>1</static><link name="l"><collision name="c"><geometry><mesh><uri>part.stl</uri></mesh></geometry></collision></link></model>
</world></sdf>
"""
STL = "solid a\n" + "".join(
    f"facet normal 0 0 1\nouter loop\nvertex {i} 0 0.1\nvertex {i + 1} 0 0.2\nvertex {i} 1 0.3\nendloop\nendfacet\n"
    for i in range(4)) + "endsolid a\n"
OBJ = "mtllib part.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1 2 4\ng a\nf 2 3 4\n"
PLY = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n")
DAE = """<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter="1"/></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array>\
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>\
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">\
<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_nodes><node id="n"><instance_geometry url="#g"/></node></library_nodes>
<library_visual_scenes><visual_scene id="s"><node id="a"><instance_node url="#n"/></node></visual_scene></library_visual_scenes>\
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""
GLTF = """{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"children":[]}],\
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],\
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]}"""
RANGES = " ".join(["2.5"] * 180)
CARMEN = "PARAM laser_front_laser_fov 180\n" + "".join(
    f"ODOM {0.1 * i} 0 0 0.5 0 0 {i}.0 h {i}.0\nFLASER 180 {RANGES} {0.1 * i} 0 0 {0.1 * i} 0 0 {i}.05 h {i}.05\n"
    f"TRUEPOS {0.1 * i} 0 0 {0.1 * i} 0 0 {i}.06 h {i}.06\n"
    for i in range(6))
TWIST = "t_s,v,w\n" + "".join(f"{0.1 * i},0.3,0.1\n" for i in range(20))
DATASET = """name: d
scenario: {world: lab, duration_s: 1, localizers: []}
vary:
  lidar.range_max: {uniform: [5, 10]}
  people.count: {integer: [0, 2]}
  drive.max_speed: {choice: [0.3, 0.5], weights: [1, 2]}
  odometry.drift_along: {normal: {mean: 0.01, sd: 0.01, min: 0, max: 0.05}}
splits: {train: 2, val: 1, test: 1}
outputs: {tables: csv}
"""
PGM = b"P5\n80 60\n255\n" + bytes(0 if x in (0, 79) or y in (0, 59) else 254 for y in range(60) for x in range(80))
JOINTS = "name: [lj, rj]\nposition: [0.1, 0.2]\nheader: {frame_id: ''}\n"


class Lab:
    """The program and a folder with what cases stand on."""

    def __init__(self, program, folder):
        self.program = os.path.abspath(program)
        self.folder = folder
        put(self, "map.yaml", MAP_YAML)
        put(self, "map.pgm", PGM)
        put(self, "part.stl", STL)
        put(self, "part.mtl", "newmtl m\nKd 1 0 0\n")
        code, text, _, _ = self.run(["run", "--duration", "2", "--out", "good", "--set", "events=[]",
                                     "--set", "outputs.bag=true"] + QUICK[2:])
        if code != 0:
            sys.exit("the run that all else stands on failed: " + text)

    def run(self, arguments):
        started = time.monotonic()
        with tempfile.TemporaryFile() as out:
            child = subprocess.Popen([self.program] + arguments, cwd=self.folder, stdout=out,
                                     stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                     start_new_session=True)
            late = False
            while True:
                pid, status, usage = os.wait4(child.pid, os.WNOHANG)
                if pid:
                    break
                if time.monotonic() - started > LIMIT_S:
                    late = True
                    os.killpg(child.pid, signal.SIGKILL)
                    pid, status, usage = os.wait4(child.pid, 0)
                    break
                time.sleep(0.005)
            child.returncode = 0
            out.seek(0)
            text = out.read().decode(errors="replace")
        code = -os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status)
        return ("late" if late else code), text, usage.ru_maxrss * 1024, time.monotonic() - started


def put(lab, name, content):
    path = os.path.join(lab.folder, name)
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())
    return path


def mutations(good, rng, count):
    """`count` variants of a good file, bytes; the first ones are the same for every format."""
    data = good if isinstance(good, bytes) else good.encode()
    yield from [b"", b"\0" * 64, b"\xff\xfe\xfd" * 50, b"\n" * 1000, b"[" * 100000, b"{" * 100000,
                b"<a>" * 100000, b'{"a":' * 20000, b"a: &a [*a]\n", data * 2, b"P5 99999 99999 255\n",
                b"\x89PNG\r\n\x1a\n" + bytes(40), b"\x1f\x8b\x08" + bytes(20), b"\x89MCAP0\r\n" + bytes(30)]
    spots = [m.span() for m in re.finditer(rb"-?\d+\.?\d*(?:[eE]-?\d+)?", data)]
    for i in range(max(count - 14, 0)):
        kind = i % 6
        if kind == 0:
            yield data[:rng.randrange(len(data) + 1)]
        elif kind == 1:
            changed = bytearray(data)
            for _ in range(rng.choice([1, 1, 2, 5, 20])):
                changed[rng.randrange(len(changed))] = rng.randrange(256)
            yield bytes(changed)
        elif kind in (2, 3) and spots:
            begin, end = rng.choice(spots)
            yield data[:begin] + rng.choice(NUMBERS).encode() + data[end:]
        elif kind == 4:
            lines = data.split(b"\n")
            a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
            lines[a] = lines[b] if rng.random() < 0.5 else lines[a] * rng.choice([2, 50])
            yield b"\n".join(lines)
        else:
            begin = rng.randrange(len(data))
            end = min(len(data), begin + rng.choice([1, 3, 10, 100]))
            yield data[:begin] + data[begin:end] * rng.choice([0, 2, 300]) + data[end:]


# name: good content, file name, command line
FORMATS = {
    "scenario": (SCENARIO, "s.yaml", ["run", "s.yaml", "--out", "o"]),
    "scenario-left": (None, "run/scenario.yaml", ["run", "run/scenario.yaml", "--out", "o"]),
    "world": (WORLD, "w.yaml", ["check-world", "w.yaml", "--no-picture"]),
    "world-run": (WORLD, "w.yaml", ["run", "--world", "w.yaml", "--duration", "1", "--out", "o"] + QUICK),
    "map": (MAP_YAML, "m.yaml", ["run", "--world", "m.yaml", "--duration", "1", "--out", "o"] + QUICK),
    "map-image": (PGM, "i.pgm", ["run", "--world", "i.yaml", "--duration", "1", "--out", "o"] + QUICK),
    "sdf": (SDF, "w.sdf", ["check-world", "w.sdf", "--no-picture"]),
    "urdf": (URDF, "r.urdf", ["check-robot", "r.urdf", "--no-picture"]),
    "urdf-run": (URDF, "r.urdf", ["run", "--robot", "r.urdf", "--duration", "1", "--out", "o"] + QUICK),
    "xacro": (XACRO, "r.urdf.xacro", ["check-robot", "r.urdf.xacro", "--no-picture"]),
    "joints": (JOINTS, "j.yaml", ["check-robot", "good.urdf", "--joints", "j.yaml", "--no-picture"]),
    "stl": (STL, "mesh.stl", ["check-robot", "stl.urdf", "--no-picture"]),
    "obj": (OBJ, "mesh.obj", ["check-robot", "obj.urdf", "--no-picture"]),
    "ply": (PLY, "mesh.ply", ["check-robot", "ply.urdf", "--no-picture"]),
    "dae": (DAE, "mesh.dae", ["check-robot", "dae.urdf", "--no-picture"]),
    "gltf": (GLTF, "mesh.gltf", ["check-robot", "gltf.urdf", "--no-picture"]),
    "carmen": (CARMEN, "l.carmen", ["replay", "l.carmen", "--map", "map.yaml", "--out", "o", "--start", "truth"]),
    "mcap": (None, "b.mcap", ["replay", "b.mcap", "--map", "map.yaml", "--out", "o"]),
    "mcap-info": (None, "b.mcap", ["bag", "b.mcap"]),
    "evaluate": (CARMEN, "log/l.clf", ["evaluate", "log", "--starts", "1", "--kidnaps", "1", "--no-tracking"]),
    "twist": (TWIST, "t.csv", ["run", "--set", "drive.twist_log=t.csv", "--duration", "1", "--out", "o"] + QUICK),
    "dataset": (DATASET, "d.yaml", ["dataset", "d.yaml", "--out", "ds", "-n", "1"]),
    "summary": (None, "run/summary.json", ["report", "run"]),
    "compare": (None, "run/summary.json", ["compare", "run", "good"]),
    "errors": (None, "run/errors.csv", ["report", "run"]),
    "recording": (None, "run/recording.gz", ["report", "run"]),
}


def good_content(lab, name, content):
    if content is not None:
        return content
    if name.startswith("mcap"):
        folder = os.path.join(lab.folder, "good/bag")
        files = [f for f in os.listdir(folder) if f.endswith(".mcap")]
        return open(os.path.join(folder, files[0]), "rb").read()
    shutil.copytree(os.path.join(lab.folder, "good"), os.path.join(lab.folder, "run"),
                    dirs_exist_ok=True)
    file = FORMATS[name][1].split("/")[1]
    return open(os.path.join(lab.folder, "good", file), "rb").read()


def prepare(lab):
    put(lab, "good.urdf", URDF)
    os.makedirs(os.path.join(lab.folder, "log"))
    put(lab, "log/map.yaml", MAP_YAML)
    put(lab, "log/map.pgm", PGM)
    put(lab, "i.yaml", MAP_YAML.replace("map.pgm", "i.pgm"))
    for kind in ("stl", "obj", "ply", "dae", "gltf"):
        put(lab, kind + ".urdf", URDF.replace("part.stl", "mesh." + kind))


def special(path):
    """A folder, a pipe and links to devices in the file's place."""
    def clear():
        if os.path.isdir(path) and not os.path.islink(path):
            shutil.rmtree(path)
        elif os.path.lexists(path):
            os.remove(path)
    for make in (os.mkdir, os.mkfifo, lambda p: os.symlink("/dev/zero", p),
                 lambda p: os.symlink("/dev/tty", p), lambda p: os.symlink(p, p)):
        clear()
        make(path)
        yield
    clear()


def judge(code, text, memory):
    if code == "late":
        return f"longer than {LIMIT_S} s"
    if code < 0 or code >= 128:
        return f"crashed ({code})"
    if memory > LIMIT_BYTES:
        return f"{memory >> 20} MiB"
    if code != 0 and not text.strip():
        return f"exit code {code} without a word"
    return None


def run_format(lab, name, cases, rng, keep):
    content, file, command = FORMATS[name]
    data = good_content(lab, name, content)
    path = os.path.join(lab.folder, file)
    failures, slowest, most, refused = [], 0.0, 0, 0

    def one(label, variant):
        nonlocal slowest, most, refused
        for out in ("o", "ds"):
            shutil.rmtree(os.path.join(lab.folder, out), ignore_errors=True)
        code, text, memory, took = lab.run(command)
        slowest, most = max(slowest, took), max(most, memory)
        refused += code != 0
        why = judge(code, text, memory)
        if why is None:
            return
        kept = os.path.join(keep, f"{name}-{label}")
        if variant is not None:
            open(kept, "wb").write(variant)
        last = text.strip().splitlines()[-1:] or [""]
        failures.append(f"{name} {label}: {why}: {last[0][:150]} ({kept})")
        print("FAIL", failures[-1], flush=True)

    put(lab, file, data)
    code, text, _, _ = lab.run(command)
    if code != 0:
        sys.exit(f"{name}: the good file itself is refused: {text}")
    for i, _ in enumerate(special(path)):
        one(f"special-{i}", None)
    for i, variant in enumerate(mutations(data, rng, cases)):
        put(lab, file, variant)
        one(str(i), variant)
    put(lab, file, data)
    print(f"{name}: {cases + 5} cases, {refused} refused, slowest {slowest:.1f} s, "
          f"most {most >> 20} MiB, {len(failures)} failed", flush=True)
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--cases", type=int, default=300)
    parser.add_argument("--only", nargs="*", choices=sorted(FORMATS))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", default="odd-inputs-failed")
    arguments = parser.parse_args()
    os.makedirs(arguments.keep, exist_ok=True)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        lab = Lab(arguments.program, folder)
        prepare(lab)
        for name in arguments.only or FORMATS:
            good_content(lab, name, FORMATS[name][0])
            rng = random.Random(f"{arguments.seed}/{name}")
            failures += run_format(lab, name, arguments.cases, rng, os.path.abspath(arguments.keep))
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
