#!/usr/bin/env python3
"""Runs that are killed at any moment, as by a power cut, and resumed, end as if nothing had happened."""

import random
import shutil
import signal
import time
import unittest

from program import COLUMNS, DONE, ENDLESS, FALLING_BLOCK, NOT_CONVERGED, TENSION, ProgramTest, settings

EVERYTHING_AT_EVERY_STEP = settings(checkpoint__every=1, output__every=1, output__fields_every=20)


class Kill(ProgramTest):
    def start_or_resume(self, options):
        # A kill may come before there is a run directory; the run is then to be started again.
        if (self.folder / "run" / "run.json").exists():
            return self.start("resume", "run", "--quiet")
        return self.start("run", *options, "--output", "run")

    def kill_and_resume(self, options, expect, n_kills, seed):
        """Kills a run at n_kills moments, resuming it each time; a run that ends in between is checked and done anew."""
        begin = time.monotonic()
        self.call("run", *options, "--output", "whole", expect=expect)
        duration = time.monotonic() - begin
        moments = random.Random(seed)
        kills = 0
        while kills < n_kills:
            process = self.start_or_resume(options)
            time.sleep(moments.uniform(0, duration / 6))
            process.send_signal(signal.SIGKILL)
            process.communicate()
            if process.returncode == -signal.SIGKILL:
                kills += 1
                continue
            self.assert_is_whole(process.returncode, expect)
            shutil.rmtree(self.folder / "run")
        process = self.start_or_resume(options)
        process.communicate()
        self.assert_is_whole(process.returncode, expect)

    def assert_is_whole(self, code, expect):
        self.assertEqual(code, expect)
        self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
        self.assert_same_results("run", "whole")
        self.assertEqual(self.unfinished(), [])

    def test_columns(self):
        for number, case in enumerate(COLUMNS):
            options = [case, "--quiet", *ENDLESS, *settings(solver__max_steps=300), *EVERYTHING_AT_EVERY_STEP]
            with self.subTest(case=case.stem):
                self.kill_and_resume(options, NOT_CONVERGED, n_kills=20, seed=number)
            shutil.rmtree(self.folder)
            self.folder.mkdir()

    def test_bonds_that_break_under_increments_of_loading(self):
        self.kill_and_resume([TENSION, "--quiet", *EVERYTHING_AT_EVERY_STEP, *settings(output__transient_every=10)], DONE, n_kills=20, seed=20)

    def test_contacts_that_come_and_go(self):
        options = [FALLING_BLOCK, "--quiet", *settings(solver__max_steps=600), *EVERYTHING_AT_EVERY_STEP]
        self.kill_and_resume(options, DONE, n_kills=20, seed=10)


if __name__ == "__main__":
    unittest.main()
