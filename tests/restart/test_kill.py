#!/usr/bin/env python3
"""Runs that are killed at any moment, as by a power cut, and resumed, end as if nothing had happened."""

import json
import random
import signal
import time
import unittest

import kill_cases
from kill_trials import KillTrials
from program import DONE, INTERRUPTED, TENSION, TERMINATED, ProgramTest, faulty_disk, settings


class Kill(KillTrials):
    """scripts/validate restart does it 500 times."""

    def test_every_case(self):
        schedules = kill_cases.SCHEDULES
        for number, name in enumerate(kill_cases.names()):
            with self.subTest(case=name):
                self.kill_and_resume(name, schedules[number % len(schedules)], n_kills=5, seed=number)
            self.doCleanups()
            self.setUp()

    def test_the_cases_have_every_choice_there_is(self):
        """Every law, generator, method and kind of problem of the schema, and every file of results."""
        schema, _ = self.call("schema")
        tables = json.loads(schema)["properties"]
        wanted = {("kind", value) for value in tables["problem"]["properties"]["kind"]["enum"]}
        wanted |= {("law", value) for value in tables["material"]["additionalProperties"]["properties"]["law"]["enum"]}
        wanted |= {("generator", value) for value in tables["zone"]["items"]["properties"]["generator"]["enum"]}
        wanted |= {("method", value) for value in tables["solver"]["properties"]["method"]["enum"]}
        texts = []
        for name in kill_cases.names():
            self.call("run", *self.options_of(name, []), "--output", name, "--stop-after-steps", 1)
            texts.append((self.folder / name / "case_resolved.toml").read_text())
        for key, value in sorted(wanted):
            with self.subTest(key=key, value=value):
                self.assertTrue(any(f'{key} = "{value}"' in text for text in texts))
        for key in ("control", "transient_every", "beam", "schedule", "gap"):
            with self.subTest(key=key):
                self.assertTrue(any(f"{key} = " in text for text in texts))


class SignalsAtAnyMoment(ProgramTest):
    def test_signals_at_any_moment(self):
        """From the first instruction of the process to its last: it ends by itself, or stops, and goes on whole."""
        case = [TENSION, *settings(checkpoint__every=5, output__fields_every=5)]
        begin = time.monotonic()
        self.call("run", *case, "--output", "whole", "--quiet")
        duration = time.monotonic() - begin
        moments = random.Random(1)
        for number in range(24):
            sent = moments.choices((signal.SIGTERM, signal.SIGINT, signal.SIGUSR1), k=2)
            run = f"run_{number}"
            with self.subTest(number=number, signals=[each.name for each in sent]):
                process = self.start("run", *case, "--output", run, "--quiet", **faulty_disk(delay_us=200))
                for each in sent:
                    time.sleep(moments.uniform(0, duration))
                    process.send_signal(each)
                _, err = process.communicate(timeout=60)
                # Before there is a run they end the process as any other.
                self.assertIn(process.returncode, (DONE, INTERRUPTED, TERMINATED, *(-each for each in sent)), err)
                if (self.folder / run).exists():
                    self.call("resume", run, "--quiet")
                    self.assertEqual(self.final_hash(run), self.final_hash("whole"))
                    self.assert_same_results(run, "whole")


if __name__ == "__main__":
    unittest.main()
