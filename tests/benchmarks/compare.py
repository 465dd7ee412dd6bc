#!/usr/bin/env python3
"""Compares the medians of a run of the benchmarks with the recorded ones, or records them.

    compare.py --compare|--record MEASURED.json MEDIANS.json

Times are read against that of the benchmark 'calibration', a fixed loop: a slower machine is no regression.
"""

import json
import platform
import sys
from pathlib import Path

CALIBRATION = "calibration"


def processor():
    """What the machine calls its processor."""
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def machine(context):
    return {
        "processor": processor(),
        "n_processors": context["num_cpus"],
        "mhz": context["mhz_per_cpu"],
        "caches": [f"L{cache['level']} {cache['type']} {cache['size'] // 1024} KiB" for cache in context["caches"]],
    }


def medians(measured):
    """Time of an item (ns), and what and how many the items are, by benchmark."""
    found = {}
    # The repetitions come interleaved.
    for run in sorted(measured["benchmarks"], key=lambda run: (run["family_index"], run["per_family_instance_index"])):
        if run.get("aggregate_name") != "median":
            continue
        items = next(key for key in run if key.startswith("n_"))
        found[run["run_name"].removesuffix("/real_time")] = {
            "ns_per_item": round(1e9 * run["per_item"], 4),
            "items": items.removeprefix("n_"),
            "n_items": round(run[items]),
        }
    return found


def table(new, old):
    """One line per benchmark; the ratio is new over recorded, the difference of the machines taken out."""
    known = old.get("medians", {})
    speed = new[CALIBRATION]["ns_per_item"] / known[CALIBRATION]["ns_per_item"] if CALIBRATION in known else None
    yield f"{'benchmark':44} {'items':>16} {'ns/item':>9} {'recorded':>9} {'ratio':>6}"
    for name, median in new.items():
        before = known.get(name)
        items = f"{median['n_items']} {median['items']}"
        line = f"{name:44} {items:>16} {median['ns_per_item']:9.2f}"
        if before and speed:
            ratio = median["ns_per_item"] / before["ns_per_item"] / speed
            line += f" {before['ns_per_item']:9.2f} {ratio:6.2f}"
        yield line
    if speed:
        yield f"ratio: new over recorded, over that of '{CALIBRATION}' ({speed:.2f})"


def main():
    action, measured_path, medians_path = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    measured = json.loads(measured_path.read_text())
    new = medians(measured)
    if CALIBRATION not in new:
        sys.exit(f"the benchmark '{CALIBRATION}' is missing: do not filter it out")
    old = json.loads(medians_path.read_text()) if medians_path.exists() else {}
    print("\n".join(table(new, old)))
    if action == "--record":
        text = json.dumps({"machine": machine(measured["context"]), "medians": new}, indent=2)
        medians_path.write_text(text + "\n")
        print(f"recorded in {medians_path}")


if __name__ == "__main__":
    main()
