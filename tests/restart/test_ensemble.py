#!/usr/bin/env python3
"""Ensembles that are stopped or killed on the way go on, with the same call, to the same bytes."""

import os
import signal
import time
import unittest
from pathlib import Path

from program import DONE, INTERRUPTED, TENSION, TERMINATED, ProgramTest, settings

ASKED = ["ensemble", TENSION, "--seeds", "1:3", *settings(solver__increment="0.3 um", checkpoint__every=5)]
RUNS = [f"seed_{seed}" for seed in range(1, 4)]


class Ensembles(ProgramTest):
    def start_and_wait_for_steps(self):
        """Starts the ensemble; returns when a run is under way."""
        process = self.start(*ASKED, "--output", "all")
        end = time.monotonic() + 60
        while not self.runs_with_rows():
            self.assertLess(time.monotonic(), end, "no run has come to its twentieth row")
            time.sleep(0.01)
        return process

    def runs_with_rows(self):
        return [path.parent.name for path in Path(self.folder, "all").glob("seed_*/history.csv")
                if path.read_bytes().count(b"\n") > 20]

    def process_of_run(self, ensemble, names):
        """One of the processes of an ensemble that make these runs."""
        for number in Path(f"/proc/{ensemble.pid}/task/{ensemble.pid}/children").read_text().split():
            command = Path(f"/proc/{number}/cmdline").read_text()
            if any(name in command for name in names):
                return int(number)
        self.fail("no run is under way")

    def go_on(self):
        """Calls the ensemble again until no process of the former call is in its way."""
        end = time.monotonic() + 60
        while time.monotonic() < end:
            process = self.start(*ASKED, "--output", "all")
            _, err = process.communicate(timeout=120)
            if process.returncode == DONE:
                return
            self.assertIn("another process is at work", err)
            time.sleep(0.1)
        self.fail("the former call is still at work")

    def assert_as_undisturbed(self):
        self.call(*ASKED, "--output", "whole")
        for run in RUNS:
            self.assertEqual(self.final_hash(f"all/{run}"), self.final_hash(f"whole/{run}"))
            self.assert_same_results(f"all/{run}", f"whole/{run}")
        for name in ("ensemble.csv", "ensemble.json", "curve.csv"):
            self.assertEqual((self.folder / "all" / name).read_bytes(), (self.folder / "whole" / name).read_bytes())
        self.assertEqual(self.unfinished(), [])

    def stop(self, number, code):
        process = self.start_and_wait_for_steps()
        process.send_signal(number)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, code, out + err)
        self.assertIn("interrupted at step", out)
        self.assertIn("the same call goes on", out)
        self.assertEqual(self.summary(self.stopped_run())["ended"], "interrupted")

    def stopped_run(self):
        return next(path.parent.relative_to(self.folder) for path in (self.folder / "all").glob("seed_*/summary.json")
                    if '"interrupted"' in path.read_text())

    def test_interrupt(self):
        self.stop(signal.SIGINT, INTERRUPTED)
        self.go_on()
        self.assert_as_undisturbed()

    def test_terminate(self):
        self.stop(signal.SIGTERM, TERMINATED)
        self.go_on()
        self.assert_as_undisturbed()

    def test_kill_of_one_run(self):
        process = self.start_and_wait_for_steps()
        os.kill(self.process_of_run(process, self.runs_with_rows()), signal.SIGKILL)
        out, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 128 + signal.SIGKILL, out + err)
        self.assertEqual(out.count("unfinished (exit code 137)"), 1, out)
        self.assertEqual(out.count(": converged at step"), len(RUNS) - 1, out)
        self.go_on()
        self.assert_as_undisturbed()

    def test_kill(self):
        process = self.start_and_wait_for_steps()
        process.send_signal(signal.SIGKILL)
        process.communicate()
        self.go_on()
        self.assert_as_undisturbed()


if __name__ == "__main__":
    unittest.main()
