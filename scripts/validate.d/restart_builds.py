"""Sections of docs/validation/restart.md: threads and output, and programs by other compilers."""
import json
import subprocess
import tempfile
from pathlib import Path

import kill_cases
from program import PROGRAM, settings
from validation import ROOT, table

SILENT = settings(output__every=1000000, checkpoint__every=1000000)
FULL = kill_cases.SCHEDULES[0]
# More contacts than one thread takes for itself, and so few steps that this does not take long.
FINE = {
    "column_random_r2": settings(zone__middle__smallest_radius='"4 mm"', zone__middle__largest_radius='"8 mm"',
                                 zone__middle__count=2700, solver__max_steps=100),
    "falling_block": settings(zone__held__radius='"0.004 m"', zone__falling__radius='"0.004 m"', solver__max_steps=200),
    "brittle_local_damping": settings(zone__specimen__smallest_radius='"0.3 mm"',
                                      zone__specimen__largest_radius='"0.6 mm"', solver__max_steps=400),
    "tension": [*settings(zone__specimen__smallest_radius='"0.8 mm"', zone__specimen__largest_radius='"1.2 mm"',
                          solver__increment='"5 um"'), "--stop-after-steps", "3"],
}
SMALLEST_SHARED_LOOP = 4096


def programs():
    """Other builds of the program that are there, by name."""
    builds = {name: ROOT / "build" / name / "app" / "ligament" for name in ("audit", "clang")}
    return {name: path for name, path in builds.items() if path.exists()}


def outcome_of(folder, name, program=PROGRAM, options=()):
    """What the summary of the run says."""
    case, own = kill_cases.write_case(folder, name)
    command = [program, "run", case, "--quiet", *own, *options, "--output", folder / "run", "--overwrite"]
    subprocess.run(list(map(str, command)), cwd=folder, check=False)
    return json.loads((folder / "run" / "summary.json").read_text())


def compared(folder, name, variants, verdicts, options=()):
    """The undisturbed outcome, and the verdict on the hashes of the variants."""
    expected = outcome_of(folder, name, options=options)
    different = []
    for text, choice in variants.items():
        found = outcome_of(folder, name, choice.get("program", PROGRAM), [*options, *choice.get("options", [])])
        if found["final_state_hash"] != expected["final_state_hash"]:
            different.append(text)
    return expected, verdicts.of(not different, f"{name}: another hash with {', '.join(different)}")


def threads_section(folder, verdicts):
    variants = {f"{n} threads": dict(options=["--threads", str(n)]) for n in range(2, 9)}
    variants["rows, fields, checkpoints at every step"] = dict(options=FULL)
    variants["almost no output"] = dict(options=SILENT)
    rows = []
    for name, fine in FINE.items():
        expected, verdict = compared(folder, name, variants, verdicts, fine)
        verdicts.of(expected["n_contacts"] > SMALLEST_SHARED_LOOP, f"{name}: too few contacts for threads to share")
        rows.append([name, str(expected["n_contacts"]), str(expected["steps"]), f"`{expected['final_state_hash']}`", verdict])
        print(*rows[-1], flush=True)
    return ["## Threads and output", "",
            "Assemblies so fine that threads share their contacts. Final state hash with one thread; target: the same with "
            + ", ".join(variants) + ".", "",
            *table(["case", "contacts", "steps", "hash", "same"], rows)]


def builds_section(verdicts):
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        lines = threads_section(folder, verdicts)
        variants = {f"`{name}`": dict(program=program) for name, program in programs().items()}
        rows = []
        for name in kill_cases.names():
            expected, verdict = compared(folder, name, variants, verdicts)
            rows.append([name, str(expected["steps"]), str(expected["n_broken"]), f"`{expected['final_state_hash']}`", verdict])
            print(*rows[-1], flush=True)
    return [*lines, "## Builds", "",
            "Final state hash of the whole run with the build `release` (gcc); target: the same with the builds "
            + " and ".join(variants) + ".", "",
            *table(["case", "steps", "broken bonds", "hash", "same"], rows)]
