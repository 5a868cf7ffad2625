"""Runs and benches of localizers: in the simulator and on recorded logs."""

import json
import pathlib

from measuring.lab import LOGS, fence, figure, mean_of, percent, percentile, share, table


def default_run(lab):
    return fence(lab.run(["run"]))


def seven_localizers(lab):
    localizers = (
        "localizers=[mh_amcl, {mh_amcl: {mode: paper}}, amcl, {amcl: {preset: amcl-recovery}}, "
        "{amcl: {preset: amcl-prob}}, {amcl: {name: beam, laser_model_type: beam}}, {amcl: {preset: amcl-global}}]"
    )
    summary = json.loads(
        lab.run(["run", "--seeds", "20", "-j", "2", "--set", "outputs.snapshots=false", "--json", "--out", "seven",
                 "--set", localizers])
    )
    rows = []
    for name, pooled in summary["localizers"].items():
        wrong = mean_of(summary, f"{name}.wrong_lock_share")
        recovery = pooled["recovery"]
        rows.append([
            f"`{name}`",
            f"{recovery['recovered']} of {recovery['events']}",
            figure(recovery["time_s"]["mean"], "{:.2f}", " s"),
            figure(recovery["time_s"]["max"], "{:.2f}", " s"),
            figure(mean_of(summary, f"{name}.tracking_error_m.mean"), "{:.3f}", " m"),
            figure(None if wrong is None else 100 * wrong, "{:.1f}", " %"),
        ])
    return table(["localizer", "recovered", "recovery time, mean", "worst", "tracking error", "wrong without saying so"], rows)


def published_defects(lab):
    rows = []
    for score in json.loads(lab.program("workbench", ["published", "--seeds", "20", "--json"])):
        name = score["variant"]
        wrong = score["wrong_lock_share"]
        rows.append([
            f"`{name}`", f"{score['recovered']} of {score['events']}",
            figure(score["recovery_time_s"], "{:.2f}", " s"), figure(score["tracking_error_m"], "{:.3f}", " m"),
            figure(None if wrong is None else 100 * wrong, "{:.1f}", " %"),
        ])
    return table(["variant", "recovered", "recovery time, mean", "tracking error", "wrong without saying so"], rows)


def replays(lab):
    rows = []
    for name in LOGS:
        out = f"replay-{name}"
        lab.run(["replay", lab.log(name, "log.carmen.gz"), "--map", lab.log(name, "map.yaml"), "--start", "unknown",
                 "--localizer", "mh_amcl", "--localizer", "amcl", "--no-pictures", "--out", out])
        summary = json.loads((lab.folder / out / "summary.json").read_text())
        timing = json.loads((lab.folder / out / "timing.json").read_text())
        cells = []
        for localizer in ["mh_amcl", "amcl"]:
            each = summary["localizers"][localizer]["recovery"]
            late = each["time_s"]["max"] if each["time_s"] else None
            cells.append("never" if not each["recovered"] else f"after {late:.1f} s" if late else "the first scan on")
        error = summary["localizers"]["mh_amcl"]["tracking_error_m"]["mean"]
        cpu = timing["localizers"]["mh_amcl"]["update_ms"]["mean"]
        rows.append([f"{name}, {summary['distance_m']:.0f} m", cells[0], f"{error:.3f} m", f"{cpu:.2f} ms", cells[1]])
    return table(["log", "`mh_amcl`: right from", "tracking error", "CPU per scan", "`amcl`: right from"], rows)


def evaluations(lab):
    def p90(trials):
        return figure(percentile(trials["time_s"], 90), "{:.1f}", " s")

    rows = []
    for row in json.loads(lab.run(["evaluate", *(str(lab.logs / name) for name in LOGS), "--json"])):
        rows.append([
            row["log"], share(row["starts"]), share(row["kidnaps"]), f"{p90(row['starts'])}; {p90(row['kidnaps'])} after a kidnap",
            f"{row['tracking_m']:.3f} m, {57.29578 * row['tracking_yaw_rad']:.1f} deg",
            f"{100 * row['wrong_scans'] / row['scans']:.2f} %", f"{row['cpu_mean_ms']:.1f} ms, {row['cpu_max_ms']:.0f} ms",
        ])
    return table(["log", "unknown start found", "kidnap recovered", "time to the right output, 90 % below", "tracking",
                  "wrong without saying so", "CPU per scan: mean, largest"], rows)


def shipped_logs(lab):
    names = ["logs/office", "logs/home", "logs/warehouse"]
    rows = [
        [row["log"], f"`{row['localizer']}`", share(row["starts"]), share(row["kidnaps"]), f"{row['tracking_m']:.3f} m",
         f"{100 * row['wrong_scans'] / row['scans']:.1f} %"]
        for row in json.loads(lab.run(["evaluate", *names, "--localizer", "mh_amcl", "--localizer", "amcl", "--json"]))
    ]
    return table(["log", "localizer", "unknown start found", "kidnap recovered", "tracking", "wrong without saying so"], rows)


def experiment(number, *arguments):
    def measured(lab):
        out = lab.run(["experiment", str(number), *arguments])
        return fence(out.split("\n\n", 1)[1].split("\nFolder")[0])
    return measured


STRESSES = [("as recorded", []), ("`--odd-scans` (not used for the map)", ["--odd-scans"]), ("`--max-range 8`", ["--max-range", "8"]),
            ("`--blocked 0.3`", ["--blocked", "0.3"]),
            ("`--erase-walls 0.2 --add-boxes 0.02`", ["--erase-walls", "0.2", "--add-boxes", "0.02"])]


def in_each_log(logs, pattern, value):
    return ", ".join(pattern.format(value(log)) for log in logs)


def found_in_each_log(logs, kind):
    return in_each_log(logs, "{}", lambda log: log[kind]["recovered"]) + f" of {logs[0][kind]['trials']}"


def stressed_evaluations(lab):
    table_rows = []
    for words, options in STRESSES:
        logs = json.loads(lab.run(["evaluate", *(str(lab.logs / name) for name in LOGS), *options, "--json"]))
        late = [percentile(log[kind]["time_s"], 90) for log in logs for kind in ["starts", "kidnaps"]]
        table_rows.append([
            words, found_in_each_log(logs, "starts"), found_in_each_log(logs, "kidnaps"), f"{min(late):.1f} to {max(late):.1f} s",
            in_each_log(logs, "{:.2f}", lambda log: 100 * log["wrong_scans"] / log["scans"]) + " %",
            f"{max(log['longest_wrong_s'] for log in logs):.1f} s", in_each_log(logs, "{:.3f}", lambda log: log["calibration"]["brier"]),
            in_each_log(logs, "{:.1f}", lambda log: 3600 * log["false_alarms"] / log["watched_s"]),
            f"{min(log['cpu_mean_ms'] for log in logs):.1f} to {max(log['cpu_mean_ms'] for log in logs):.1f} ms",
        ])
    return table(["", "unknown start found (intel, freiburg-079, aces)", "kidnap recovered", "90 % right within",
                  "wrong without saying so", "longest", "Brier score", "false alarms per hour", "CPU per scan, mean"], table_rows)


DESIGN_CASES = [("as recorded", []), ("`--blocked 0.3`", ["--blocked", "0.3"]),
                ("`--kidnap-to look-alike --max-range 8`", ["--kidnap-to", "look-alike", "--max-range", "8"])]
DESIGN_HALL = ["--world", "hall", "--kind", "look-alike", "--min-distance", "1", "--kidnaps", "100"]


def total(rows, value):
    return sum(value(row) for row in rows)


def designs(lab):
    file = str(pathlib.Path(__file__).parent / "designs.yaml")
    rows = {}
    for words, options in DESIGN_CASES:
        logs = json.loads(lab.run(["evaluate", *(str(lab.logs / name) for name in LOGS), "--localizer", file, "--no-tracking", *options, "--json"]))
        for name in dict.fromkeys(row["localizer"] for row in logs):
            own = [row for row in logs if row["localizer"] == name]
            found = total(own, lambda row: row["starts"]["recovered"] + row["kidnaps"]["recovered"])
            rows.setdefault(name, []).append([
                words, f"`{name}`", f"{found} of {total(own, lambda row: row['starts']['trials'] + row['kidnaps']['trials'])}",
                percent(total(own, lambda row: row["wrong_scans"]) / total(own, lambda row: row["scans"]), 2),
                f"{max(row['longest_wrong_s'] for row in own):.1f} s",
                f"{3600 * total(own, lambda row: row['false_alarms']) / total(own, lambda row: row['watched_s']):.1f}"])
    hall = json.loads(lab.run(["bench", "kidnaps", *DESIGN_HALL, "--localizer", file, "--json"]))[0]
    for name, each in hall["localizers"].items():
        told = each["distinguishable"]
        rows[name].append(["hall, look-alikes", f"`{name}`", f"{each['recovered']['count']} of {hall['kidnaps']}",
                           percent(told["wrong_share"], 2), f"{told['longest_wrong_s']:.1f} s", "-"])
    ordered = [row for case in zip(*rows.values()) for row in case]
    return table(["", "design", "recovered", "wrong without saying so", "longest", "false alarms per hour"], ordered)


def kidnaps_among_people(lab):
    batches = [("lab", batch) for batch in json.loads(lab.run(["bench", "kidnaps", "--kidnaps", "300", "--json"]))]
    crowds = ["--obstacles", "0", "--obstacles", "6", "--obstacles", "12"]
    batches += [("office", batch) for batch in json.loads(lab.run(["bench", "kidnaps", "--world", "office", *crowds, "--json"]))]
    rows = []
    for world, batch in batches:
        each = batch["localizers"]["mh_amcl"]
        time = each["recovery_time_s"]
        rows.append([f"{world}, {batch['obstacles']}", percent(batch["blocked_share"], 0), f"{batch['top5']['count']} of {batch['kidnaps']}",
                     f"{each['recovered']['count']} of {batch['kidnaps']}", f"{time['mean']:.2f}, {time['p95']:.2f}, {time['max']:.1f} s",
                     percent(each["wrong_lock_share"], 2), f"{each['tracking_m']:.3f} m"])
    return table(["world, people", "beams blocked", "search", "`mh_amcl` right within 10 s", "mean, 95 %, worst",
                  "wrong without saying so", "tracking error"], rows)
