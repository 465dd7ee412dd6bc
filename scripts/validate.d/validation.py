"""What validations share: runs of the program, direct solutions, pictures, and the count of what was met and missed."""
import csv
import json
import os
import resource
import subprocess
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "docs" / "validation"
LIGAMENT = os.environ["LIGAMENT"]
REFERENCE_SOLUTION = os.environ["REFERENCE_SOLUTION"]


class Verdicts:
    """Counts what was met and what was missed."""

    def __init__(self):
        self.missed = []

    def of(self, passed, what):
        if not passed:
            self.missed.append(what)
        return "met" if passed else "**missed**"


class Run:
    """A finished run of a case: its summary, its rows, and what it cost on one core."""

    def __init__(self, output, exit_code, wall, processor):
        self.output = output
        self.exit_code = exit_code
        self.wall = wall
        self.processor = processor
        self.summary = json.loads((output / "summary.json").read_text())
        self.results = self.summary["results"]

    def rows(self, name):
        """The rows of history.csv or energy.csv, as numbers by column."""
        with open(self.output / f"{name}.csv", newline="") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def packing(self):
        """The report on the only assembly."""
        return next(iter(self.summary["packing"].values()))


def call(folder, command, *arguments):
    """The program in a folder; exit code, seconds of the clock and of the processor."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.perf_counter()
    result = subprocess.run([LIGAMENT, command, *arguments, "--quiet"], cwd=folder, check=False)
    wall = time.perf_counter() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return result.returncode, wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def run_case(folder, name, overrides=(), options=()):
    """Runs config/NAME.toml in a directory of its own under the folder."""
    output = folder / f"{name}-{len(list(folder.iterdir()))}"
    arguments = [str(ROOT / "config" / f"{name}.toml"), "--output", str(output), *options]
    for override in overrides:
        arguments += ["--set", override]
    return Run(output, *call(folder, "run", *arguments))


def resume(folder, output, options=()):
    return Run(output, *call(folder, "resume", str(output), *options))


def direct_solution(run):
    """The gauges of the run's case, overrides included, from one sparse factorisation."""
    case = run.output / "case_resolved.toml"
    result = subprocess.run([REFERENCE_SOLUTION, str(case)], check=True, capture_output=True, text=True)
    return json.loads(result.stdout)


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def table(head, rows):
    """A table in Markdown."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def render_fields(run, name, caption, scale):
    """Draws the displaced bodies of a run; the lines that show the picture."""
    picture = PAGES / f"{name}.png"
    subprocess.run(["xvfb-run", "-a", "/usr/bin/python3", str(ROOT / "scripts" / "render_fields.py"), str(run.output),
                    str(picture), "--scale", str(scale)], check=True)
    return [f"![{caption}]({picture.name})", ""]


def plot(script, name, caption):
    """Lets gnuplot draw a picture; the lines that show it."""
    picture = PAGES / f"{name}.png"
    head = f"set terminal pngcairo size 900,540 font 'sans,11'\nset output '{picture}'\n"
    subprocess.run(["gnuplot"], input=head + script, text=True, check=True)
    return [f"![{caption}]({picture.name})", ""]


def write_page(name, title, introduction, lines, verdicts):
    """Writes docs/validation/NAME.md; the exit code of the validation."""
    head = [f"# {title}", "", introduction, "",
            f"Targets missed: {'; '.join(verdicts.missed) if verdicts.missed else 'none'}.", ""]
    page = PAGES / f"{name}.md"
    page.write_text("\n".join(head + lines).rstrip() + "\n")
    print(f"wrote {page.relative_to(ROOT)}; targets missed: {len(verdicts.missed)}")
    return 1 if verdicts.missed else 0
