"""What a live run and its page cost."""

import json
import pathlib
import shutil
import subprocess

from measuring.lab import percent, percentile, table

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "web/test/browser/live_cost.mjs"
HOURS = 8
MEMORY = {"server": "the server", "run": "the run", "copies": "the run and its sleeping copies, shared pages counted once",
          "page": "JavaScript heap of the page"}


def measured(lab):
    chromium = next((path for path in map(shutil.which, ["chromium", "chromium-browser", "google-chrome"]) if path), None)
    if not chromium:
        raise SystemExit("measure: live needs chromium (apt-get install chromium)")
    done = subprocess.run(["node", SCRIPT, lab.castaway, chromium, str(HOURS)], cwd=lab.folder, text=True, stdout=subprocess.PIPE)
    if done.returncode != 0:
        raise SystemExit(f"measure: {SCRIPT.name}: exit {done.returncode}")
    return json.loads(done.stdout)


def took(times_ms):
    return [f"{percentile(times_ms, 50):.0f} ms", f"{percentile(times_ms, 95):.0f} ms"]


def paces(found):
    scans = found["fast_scans"]
    rows = [[asked, f"{each['times_real']:.1f} x", f"{each['redraws_hz']:.0f} /s"]
            for asked, each in [("1 x", found["real"]), ("20 x", found["fast"])]]
    answers = " and ".join(f"{count} by `{name}`" for name, count in zip(found["localizers"], scans["answers"]))
    return (table(["speed asked for", "reached", "redraws of the map"], rows)
            + f"\nAt 20 x, {scans['due']} scans were due and {scans['came']} came ({percent(scans['came'] / scans['due'])}); "
            + f"answered were {answers}.\n")


def latencies(found):
    rows = [["robot dragged, at 1 x: its outline follows", *took(found["real_ghost_ms"])],
            ["robot dragged, at 20 x", *took(found["fast_ghost_ms"])],
            ["*Anywhere* pressed, at 1 x: the kidnap is on the map", *took(found["kidnap_ms"])]]
    return table(["from the hand to the picture", "median", "95 % below"], rows)


def memory(found):
    samples = found["memory"]

    def after(hours):
        return min(samples, key=lambda sample: abs(sample["time_s"] - 3600 * hours))

    rows = [[words, *(f"{sample[key]:.0f} MiB" for sample in [after(1), after(HOURS)]), f"{max(each[key] for each in samples):.0f} MiB"]
            for key, words in MEMORY.items()]
    return table(["memory", "after 1 simulated hour", f"after {HOURS}", f"greatest of {len(samples)} samples"], rows)


def live(lab):
    found = measured(lab)
    return "\n".join([paces(found), latencies(found), memory(found)])
