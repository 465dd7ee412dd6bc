"""Section of docs/validation/restart.md: threads, output, and programs by other compilers."""
import json
import subprocess
import tempfile
from pathlib import Path

import kill_cases
from program import PROGRAM
from validation import ROOT, table

CASES = ("column_hexagonal_h2", "column_random_r2", "falling_block", "tension", "exponential_graded",
         "brittle_local_damping")
SILENT = ["--set", "output.every=1000000", "--set", "checkpoint.every=1000000"]
FULL = kill_cases.SCHEDULES[0]
# More contacts than one thread takes for itself.
FINE = {"falling_block": ["--set", "zone.held.radius=0.004 m", "--set", "zone.falling.radius=0.004 m",
                          "--set", "solver.max_steps=200"]}


def programs():
    """Other builds of the program that are there, by name."""
    builds = {name: ROOT / "build" / name / "app" / "ligament" for name in ("audit", "clang")}
    return {name: path for name, path in builds.items() if path.exists()}


def hash_of(folder, name, program=PROGRAM, options=()):
    case, own = kill_cases.write_case(folder, name)
    output = folder / "run"
    command = [program, "run", case, "--quiet", *own, *FINE.get(name, []), *options, "--output", output, "--overwrite"]
    subprocess.run(list(map(str, command)), cwd=folder, check=False)
    return json.loads((output / "summary.json").read_text())["final_state_hash"]


def builds_section(verdicts):
    variants = {f"{n} threads": dict(options=["--threads", str(n)]) for n in range(2, 9)}
    variants["rows, fields, checkpoints at every step"] = dict(options=FULL)
    variants["almost no output"] = dict(options=SILENT)
    variants |= {f"build `{name}`": dict(program=program) for name, program in programs().items()}
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for name in CASES:
            expected = hash_of(folder, name)
            different = [text for text, choice in variants.items() if hash_of(folder, name, **choice) != expected]
            verdict = verdicts.of(not different, f"{name}: another hash with {', '.join(different)}")
            rows.append([name, f"`{expected}`", verdict])
            print(*rows[-1], flush=True)
    return ["## Threads, output, builds", "",
            "Final state hash with the build `release` and one thread; target: the same with " + ", ".join(variants) + ".", "",
            *table(["case", "hash", "same"], rows)]
