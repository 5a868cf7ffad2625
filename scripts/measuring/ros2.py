"""A node of ROS 2 in lock step, and the same localizer inside of castaway."""

import subprocess

from measuring.lab import NO_PICTURES, table

DOMAIN = 231
SECONDS = 600


def run_with(lab, localizers, out):
    texts = [part for text in localizers for part in ("--localizer", text)]
    lab.summary(["--duration", str(SECONDS), *NO_PICTURES, "--set", "outputs.report=false", *texts], out)
    return lab.json_of(f"{out}/timing.json")["realtime_factor"]


def lock_step(lab):
    """`ros2_peer` is built with the tests."""
    inside = run_with(lab, ["mh_amcl", "mh_amcl:paper"], "inside")
    node = subprocess.Popen([lab.castaway.parent / "ros2_peer", "--domain", str(DOMAIN)], stdout=subprocess.DEVNULL)
    try:
        outside = run_with(lab, ["mh_amcl", f"ros2:{DOMAIN}"], "outside")
    finally:
        node.terminate()
        node.wait()
    answers = lab.json_of("outside/summary.json")["localizers"]["ros2"]["answers"]
    rows = [["`mh_amcl` and the node", f"{outside:.0f} x"], ["`mh_amcl` and `mh_amcl:paper`, both inside", f"{inside:.0f} x"]]
    return table(["localizers", "real time"], rows) + f"\nThe node answered {answers['answered']} of {answers['sent']} scans.\n"
