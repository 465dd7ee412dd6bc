#!/usr/bin/env python3
"""A run directory belongs to one run, and to one process at a time."""

import json
import signal
import unittest

from program import (
    CONFIG, DONE, FALLING_BLOCK, FILE_ERROR, NOT_CONVERGED, TERMINATED, WRONG_INPUT, ProgramTest, faulty_disk, settings)

SHORT = [FALLING_BLOCK, "--quiet", *settings(solver__max_steps=40)]


class RunDirectory(ProgramTest):
    def snapshot(self):
        """Everything below the folder, with content and time of the last change."""
        files = [path for path in self.folder.rglob("*") if path.is_file()]
        return {str(path): (path.read_bytes(), path.stat().st_mtime_ns) for path in files}

    def test_a_run_is_not_written_over(self):
        self.call("run", *SHORT, "--output", "run")
        before = self.snapshot()
        _, err = self.call("run", *SHORT, "--output", "run", expect=WRONG_INPUT)
        self.assertIn("ligament resume", err)
        self.assertIn("--overwrite", err)
        self.assertEqual(self.snapshot(), before)

    def test_overwrite(self):
        self.call("run", *SHORT, "--output", "run")
        old = self.checkpoints("run")
        longer = [*SHORT, *settings(solver__max_steps=60)]
        self.call("run", *longer, "--output", "run", "--overwrite")
        self.assertEqual(self.summary("run")["steps"], 60)
        self.assertEqual([file for file in old if file.exists()], [])
        self.assertEqual(len(list((self.folder / "checkpoints").iterdir())), 1)

    def test_overwrite_with_wrong_input_removes_nothing(self):
        self.call("run", *SHORT, "--output", "run")
        before = self.snapshot()
        wrong = [*SHORT, *settings(solver__max_steps=-1)]
        self.call("run", *wrong, "--output", "run", "--overwrite", expect=WRONG_INPUT)
        self.assertEqual(self.snapshot(), before)

    def test_overwrite_removes_no_folder_but_its_own_checkpoints(self):
        self.call("run", *SHORT, "--output", "run")
        (self.folder / "precious").mkdir()
        identity = self.folder / "run" / "run.json"
        changed = json.loads(identity.read_text()) | {"checkpoints": str(self.folder / "precious")}
        identity.write_text(json.dumps(changed))
        self.call("run", *SHORT, "--output", "run", "--overwrite")
        self.assertTrue((self.folder / "precious").exists())

    def test_what_a_killed_start_left_is_cleared_by_the_next_one(self):
        for name in ("run.0123456789abcdef.part", "run.mine.part", "other.0123456789abcdef.part"):
            (self.folder / name / "fields").mkdir(parents=True)
        self.call("run", *SHORT, "--output", "run")
        left = sorted(path.name for path in self.folder.iterdir())
        self.assertEqual(left, ["checkpoints", "other.0123456789abcdef.part", "run", "run.mine.part"])

    def test_what_is_no_run_is_left_alone(self):
        (self.folder / "thesis").mkdir()
        (self.folder / "thesis" / "chapter.tex").write_text("...")
        (self.folder / "file").write_text("...")
        before = self.snapshot()
        for place in ("thesis", "file"):
            for more in ([], ["--overwrite"]):
                _, err = self.call("run", *SHORT, "--output", place, *more, expect=WRONG_INPUT)
                self.assertIn("is no run directory; choose another with --output", err)
        self.assertEqual(self.snapshot(), before)

    def test_a_place_that_cannot_be_made(self):
        (self.folder / "file").write_text("...")
        _, err = self.call("run", *SHORT, "--output", "file/run", expect=FILE_ERROR)
        self.assertIn("cannot make the run directory", err)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["file"])

    def test_names_of_any_letters_but_no_broken_ones(self):
        self.call("run", *SHORT, "--output", "Träger 1, σ")
        self.call("resume", "Träger 1, σ", "--quiet")
        before = self.snapshot()
        _, err = self.call("run", *SHORT, "--output", "caf\udce9", expect=WRONG_INPUT)
        self.assertIn("must be UTF-8 text", err)
        self.assertEqual(self.snapshot(), before)

    def test_an_empty_folder_is_a_place(self):
        (self.folder / "run").mkdir()
        self.call("run", *SHORT, "--output", "run/")
        self.assertEqual(self.summary("run")["ended"], "completed")

    def test_default_place_and_what_is_in_it(self):
        case = CONFIG / "column_hexagonal_h1.toml"
        self.call("run", case, "--quiet", *settings(solver__max_steps=50), expect=NOT_CONVERGED)
        run = self.folder / "results" / "column_hexagonal_h1"
        names = {"case.toml", "case_resolved.toml", "run.json", "run.log", "summary.json"}
        names |= {"history.csv", "energy.csv", "cracks.csv", "fields"}
        self.assertEqual({path.name for path in run.iterdir()}, names)
        self.assertEqual((run / "case.toml").read_bytes(), case.read_bytes())
        self.assertIn("max_steps = 50", (run / "case_resolved.toml").read_text())
        folder = self.checkpoints(run)[0].parent
        self.assertEqual(folder.parent, self.folder / "checkpoints")
        self.assertEqual(folder.name, f"column_hexagonal_h1-{json.loads((run / 'run.json').read_text())['run_id']}")

    def test_checkpoints_beside_the_case(self):
        (self.folder / "cases").mkdir()
        case = self.folder / "cases" / "case.toml"
        case.write_text(FALLING_BLOCK.read_text() + '\n[checkpoint]\nfolder = "states"\n')
        self.call("run", "cases/case.toml", "--quiet", "--stop-after-steps", 20)
        self.assertEqual(self.checkpoints("results/case")[0].parent.parent, self.folder / "cases" / "states")
        self.call("resume", "results/case", "--until-step", 30, "--quiet")
        self.assertFalse((self.folder / "checkpoints").exists())

    def test_the_resolved_case_is_the_same_case(self):
        self.call("run", *SHORT, *settings(generation__seed=7), "--output", "run")
        self.call("run", "run/case_resolved.toml", "--quiet", "--output", "again")
        self.assertEqual(self.summary("again")["case_hash"], self.summary("run")["case_hash"])
        self.assertEqual(self.final_hash("again"), self.final_hash("run"))

    def test_a_moved_run_is_resumed(self):
        self.call("run", *SHORT, "--output", "run")
        self.call("run", *SHORT, "--output", "before", "--stop-after-steps", 20)
        (self.folder / "before").rename(self.folder / "after")
        self.call("resume", "after", "--quiet")
        self.assert_same_results("after", "run")

    def test_one_process_at_a_time(self):
        endless = settings(solver__max_steps=10**9)
        process = self.start("run", FALLING_BLOCK, *endless, "--output", "run")
        while "       100  " not in process.stdout.readline():
            pass
        for command in (["resume", "run"], ["run", *SHORT, "--output", "run", "--overwrite"]):
            _, err = self.call(*command, expect=WRONG_INPUT)
            self.assertIn("another process is at work on this run", err)
        process.send_signal(signal.SIGTERM)
        process.communicate()
        self.assertEqual(process.returncode, TERMINATED)
        self.call("resume", "run", "--until-step", self.summary("run")["steps"] + 10, expect=DONE)
        self.assertEqual(self.unfinished(), [])

    def test_a_dead_process_holds_no_lock(self):
        process = self.start("run", FALLING_BLOCK, *settings(solver__max_steps=10**9), "--output", "run")
        while "       100  " not in process.stdout.readline():
            pass
        process.kill()
        process.wait()
        self.call("resume", "run", "--until-step", 300)
        self.call("run", *SHORT, "--output", "run", "--overwrite")

    def test_of_many_processes_one_resumes_a_run(self):
        self.call("run", *SHORT, "--output", "whole")
        self.call("run", *SHORT, "--output", "run", "--stop-after-steps", 20)
        racers = [self.start("resume", "run", "--quiet", **faulty_disk(delay_us=2000)) for _ in range(6)]
        codes = [racer.communicate() and racer.returncode for racer in racers]
        self.assertIn(DONE, codes)
        self.assertLessEqual(set(codes), {DONE, WRONG_INPUT})
        self.assert_same_results("run", "whole")


if __name__ == "__main__":
    unittest.main()
