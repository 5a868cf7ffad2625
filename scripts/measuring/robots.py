"""Figures of the shipped robots."""

from measuring.lab import table

ROBOTS = ["waffle", "disc", "butler", "mule"]


def shipped_robots(lab):
    """Errors that the tests record for every shipped robot."""
    lab.program("sim_tests", ["--gtest_filter=*ShippedRobot*", "--gtest_output=json:robots.json"])
    found = {name: {} for name in ROBOTS}
    for suite in lab.json_of("robots.json")["testsuites"]:
        for test in suite["testsuite"]:
            robot = next((name for name in ROBOTS if name in test["name"] + str(test.get("value_param"))), None)
            if robot:
                found[robot].update({key: value for key, value in test.items() if key.endswith(("_um", "_urad"))})
    rows = [[name, *(error_text(errors, what) for what in ["straight", "turn", "course"])] for name, errors in found.items()]
    return table(["robot", "20 m straight on", "two turns on the spot", "6 m with eight turns"], rows)


def error_text(errors, what):
    return f"{int(errors[what + '_position_um']) / 1e3:.2f} mm, {int(errors[what + '_yaw_urad']) / 1e3:.1f} mrad"
