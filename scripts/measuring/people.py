"""Figures of people and kidnaps."""

from measuring.lab import NO_PICTURES, figure, mean, mean_of, percent, table

CROWDS = [("count: 8", "people.count=8"), ("count: 20", "people.count=20"),
          ("crowd: {blocked: 0.4}", "people.crowd.blocked=0.4"), ("crowd: {blocked: 0.6}", "people.crowd.blocked=0.6")]
KINDS = ["teleport", "nudge", "turn", "carry", "spin", "look_alike"]


def runs_of(lab, arguments, seeds, out):
    """The pooled summary of `run --seeds`, and the summary of every run."""
    pooled = lab.summary([*arguments, "--seeds", str(seeds), "-j", "2", *NO_PICTURES], out)
    return pooled, [lab.json_of(f"{out}/seed-{seed}/summary.json") for seed in range(1, seeds + 1)]


def among_people(lab):
    rows = []
    for words, setting in CROWDS:
        pooled, runs = runs_of(lab, ["--set", setting], 5, setting.replace(".", "-"))
        beams = [run["people"]["beams_on_people"]["mean"] for run in runs]
        way = f"{mean(run['distance_m'] for run in runs):.1f} m"
        for i, (name, figures) in enumerate(pooled["localizers"].items()):
            each = figures["recovery"]
            first = [f"`{words}`", f"{100 * min(beams):.0f} to {100 * max(beams):.0f} %", way] if i == 0 else ["", "", ""]
            rows.append(first + [f"`{name}`", f"{each['recovered']} of {each['events']}", *times(each["time_s"]),
                                 figure(tracking(pooled, name), "{:.3f}", " m"),
                                 percent(pooled["figures"][f"{name}.wrong_lock_share"]["mean"])])
    return table(["people", "beams on them", "driven", "", "recovered", "recovery, mean", "worst", "tracking",
                  "wrong without saying so"], rows)


def times(statistics):
    known = statistics or {}
    return [figure(known.get("mean"), "{:.2f}", " s"), figure(known.get("max"), "{:.2f}", " s")]


def tracking(pooled, name):
    return mean_of(pooled, f"{name}.tracking_error_m.mean")


def kidnap_kinds(lab):
    _, runs = runs_of(lab, ["lab/kidnaps"], 20, "kidnaps")
    rows = []
    for kind in KINDS:
        found = {who: [each for run in runs for each in run["localizers"][who]["recovery"]["each"]
                       if each["kind"] == kind and each["scored"]] for who in ["mh_amcl", "amcl"]}
        took = [each["time_s"] for each in found["mh_amcl"] if each["recovered"]]
        wrong = max(each["wrong_lock_s"] for each in found["mh_amcl"])
        count = {who: f"{sum(each['recovered'] for each in found[who])} of {len(found[who])}" for who in found}
        rows.append([f"`{kind}`", count["mh_amcl"], figure(mean(took), "{:.2f}", " s"), figure(max(took), "{:.2f}", " s"),
                     f"{wrong:.1f} s", count["amcl"]])
    return table(["kind", "`mh_amcl`: recovered", "mean", "worst", "wrong without saying so, worst", "`amcl`: recovered"], rows)


def discrimination(lab):
    pooled, _ = runs_of(lab, ["lab/kidnaps"], 20, "kidnaps")
    rows = [[f"`{name}`", *(figure(mean_of(pooled, f"{name}.discrimination.{key}_auc"), "{:.4f}")
                            for key in ["quality", "probability", "covariance"])] for name in ["mh_amcl", "amcl"]]
    return table(["area under the ROC curve, mean over seeds", "quality", "stated probability", "covariance"], rows)


def marathons(lab):
    rows = []
    for seed in [1, 2, 3, 4]:
        run = lab.summary(["corridor/paper-marathon", "--seed", str(seed), *NO_PICTURES, "--set", "expect={}"],
                          f"marathon-{seed}")
        driving = run["driving"]
        rows.append([seed, f"{run['duration_s'] / 3600:.2f} h", f"{run['distance_m']:.0f} m", driving["recoveries"], run["collisions"],
                     driving["emergency stop"]])
    return table(["seed", "time", "way", "recoveries", "collisions", "emergency stops"], rows)
