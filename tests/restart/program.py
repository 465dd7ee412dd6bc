"""Runs of the program as its users start them: processes, files and exit codes."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["LIGAMENT"]
FAULTY_DISK = os.environ["FAULTY_DISK"]
ROOT = Path(__file__).resolve().parents[2]
CONFIG = ROOT / "config"
COLUMNS = [CONFIG / f"column_{name}.toml" for name in ("fem", "hexagonal_h1", "hexagonal_h2", "random_r2")]
TENSION = Path(__file__).resolve().parent / "tension.toml"
FALLING_BLOCK = Path(__file__).resolve().parent / "falling_block.toml"
BEAM_ON_PLATENS = Path(__file__).resolve().parent / "beam_on_platens.toml"
DONE, DIFFERENT, WRONG_INPUT, FILE_ERROR, NOT_CONVERGED, INTERRUPTED, TERMINATED = 0, 1, 2, 5, 6, 130, 143


def settings(**values):
    """Options that replace values of a case: settings(output__every=1) sets output.every."""
    return [word for key, value in values.items() for word in ("--set", f"{key.replace('__', '.')}={value}")]


# Keeps a column from converging, so that it goes on to its last step.
ENDLESS = settings(solver__unbalanced_force_ratio=1e-300)


def faulty_disk(**values):
    """Options of a process whose disk is slow or fails; faulty_disk.c says what can be set."""
    more = {f"FAULTY_DISK_{name.upper()}": str(value) for name, value in values.items()}
    # Sanitizers want to be loaded first, but do not need to.
    return {"env": {**os.environ, "LD_PRELOAD": FAULTY_DISK, "ASAN_OPTIONS": "verify_asan_link_order=0", **more}}


def scratch_parent():
    """In memory if there is room: runs that flush a checkpoint to a disk at every step would take minutes."""
    memory = Path("/dev/shm")
    has_room = os.access(memory, os.W_OK) and shutil.disk_usage(memory).free > 1e9
    return memory if has_room else None


class ProgramTest(unittest.TestCase):
    """Gives each test a folder of its own to work in."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="ligament_", dir=scratch_parent()))
        self.addCleanup(shutil.rmtree, self.folder)

    def start(self, *arguments, **options):
        """Starts the program and leaves it running; it is killed at the end of the test if it still runs."""
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL}
        pipes |= {"text": True, "errors": "replace"}
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, **pipes, **options)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        return process

    def call(self, *arguments, expect=DONE, **options):
        """Runs the program to its end and checks its exit code; returns what it wrote."""
        process = self.start(*arguments, **options)
        out, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, expect, f"{' '.join(map(str, arguments))}\n{out}{err}")
        return out, err

    def summary(self, run):
        return json.loads((self.folder / run / "summary.json").read_text())

    def final_hash(self, run):
        return self.summary(run)["final_state_hash"]

    def checkpoints(self, run):
        """The checkpoint files of a run, oldest first."""
        folder = Path(json.loads((self.folder / run / "run.json").read_text())["checkpoints"])
        return sorted(folder.glob("*.ckpt")) if folder.exists() else []

    def results(self, run):
        """Content of all result files of a run, by name."""
        folder = self.folder / run
        tables = [folder / name for name in ("history.csv", "energy.csv", "cracks.csv")]
        tables += folder.glob("transient.csv")
        files = [*tables, *sorted((folder / "fields").iterdir())]
        return {str(file.relative_to(folder)): file.read_bytes() for file in files}

    def unfinished(self):
        """What was not written to its end and not cleared away."""
        return [str(path.relative_to(self.folder)) for path in self.folder.rglob("*.part")]

    def assert_same_results(self, run, expected):
        """Byte for byte, no file more and none less."""
        found, wanted = self.results(run), self.results(expected)
        self.assertEqual(sorted(found), sorted(wanted))
        for name in wanted:
            self.assertEqual(found[name], wanted[name], f"{name} differs")
