#!/usr/bin/env python3
"""Damaged checkpoints and full disks: the run falls back on what is whole, and says so."""

import json
import resource
import unittest

from program import COLUMNS, FALLING_BLOCK, FILE_ERROR, NOT_CONVERGED, ProgramTest, settings

CASE = [FALLING_BLOCK, "--quiet", *settings(solver__max_steps=200, checkpoint__every=20, output__fields_every=50)]


def flip_a_byte(file):
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)


def cut_in_half(file):
    content = file.read_bytes()
    file.write_bytes(content[: len(content) // 2])


def make_empty(file):
    file.write_bytes(b"")


def replace_by_text(file):
    file.write_text("not a checkpoint\n" * 1000)


def replace_by_a_directory(file):
    file.unlink()
    file.mkdir()


class Damage(ProgramTest):
    """Of checkpoints."""

    def test_the_checkpoint_before_a_damaged_one_is_taken(self):
        self.call("run", *CASE, "--output", "whole")
        for damage in (flip_a_byte, cut_in_half, make_empty, replace_by_text, replace_by_a_directory):
            with self.subTest(damage=damage.__name__):
                run = damage.__name__
                self.call("run", *CASE, "--output", run, "--stop-after-steps", 110)
                newest, before = self.checkpoints(run)[-1], self.checkpoints(run)[-2]
                damage(newest)
                out, err = self.call("resume", run)
                self.assertIn(f"warning: {newest}: ", err)
                self.assertIn(f"resuming from step {int(before.stem.removeprefix('step_'))}", out)
                self.assertEqual(self.final_hash(run), self.final_hash("whole"))
                self.assert_same_results(run, "whole")

    def test_two_damaged_ones(self):
        self.call("run", *CASE, "--output", "whole")
        self.call("run", *CASE, "--output", "run", "--stop-after-steps", 110)
        flip_a_byte(self.checkpoints("run")[-1])
        cut_in_half(self.checkpoints("run")[-2])
        _, err = self.call("resume", "run", "--quiet")
        self.assertEqual(err.count("warning: "), 2)
        self.assert_same_results("run", "whole")

    def test_all_damaged(self):
        self.call("run", *CASE, "--output", "run", "--stop-after-steps", 110)
        before = self.results("run")
        for checkpoint in self.checkpoints("run"):
            flip_a_byte(checkpoint)
        _, err = self.call("resume", "run", expect=5)
        self.assertEqual(err.count("warning: "), 3)
        self.assertIn("there is no good checkpoint of this run, though it has results", err)
        self.assertEqual(self.results("run"), before)

    def test_what_a_killed_write_left_is_passed_over_and_cleared(self):
        self.call("run", *CASE, "--output", "whole")
        self.call("run", *CASE, "--output", "run", "--stop-after-steps", 110)
        newest = self.checkpoints("run")[-1]
        (newest.parent / "step_000000000999.ckpt.part").write_bytes(newest.read_bytes()[:100])
        (self.folder / "run" / "fields" / "particles_000150.hdf.part").write_bytes(b"torn")
        with (self.folder / "run" / "history.csv").open("a") as history:
            history.write("150,0.04,-0.0")
        _, err = self.call("resume", "run", "--quiet")
        self.assertEqual(err, "")
        self.assert_same_results("run", "whole")
        self.assertEqual(self.unfinished(), [])

    def test_a_checkpoint_of_another_run_is_passed_over(self):
        self.call("run", *CASE, "--output", "other", "--stop-after-steps", 110)
        self.call("run", *CASE, "--output", "run", "--stop-after-steps", 90)
        stray = self.checkpoints("run")[-1].parent / self.checkpoints("other")[-1].name
        stray.write_bytes(self.checkpoints("other")[-1].read_bytes())
        out, err = self.call("resume", "run")
        self.assertIn(f"warning: {stray}", err)
        self.assertIn("another run", err)
        self.assertIn("resuming from step 90", out)


class FullDisk(ProgramTest):
    """A limit on the size of files stands for a disk without room."""

    def limit(self, n_bytes):
        return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (n_bytes, resource.RLIM_INFINITY))}

    def assert_nothing_is_torn(self, run):
        self.assertEqual(self.unfinished(), [])
        for name, content in self.results(run).items():
            if name.endswith(".csv"):
                lines = content.decode().split("\n")
                self.assertEqual(lines.pop(), "")
                self.assertEqual({line.count(",") for line in lines}, {lines[0].count(",")}, name)
            elif name.endswith(".series"):
                json.loads(content)

    def test_results_that_find_no_room_to_the_end_are_resumed(self):
        case = [COLUMNS[0], *settings(solver__method="dynamic_relaxation", output__every=1, checkpoint__every=10)]
        self.call("run", *case, "--output", "whole", "--quiet")
        checkpoint_size = max(file.stat().st_size for file in self.checkpoints("whole"))
        history_size = len(self.results("whole")["history.csv"])
        self.assertGreater(history_size, 2 * checkpoint_size)
        out, err = self.call("run", *case, "--output", "run", expect=FILE_ERROR, **self.limit(history_size // 2))
        self.assertIn("results wait in memory for the next try: cannot write", err)
        self.assertIn("the run is at its end, and results could not be written", err)
        self.assertIn(f"last good checkpoint: {self.checkpoints('run')[-1]}", err)
        self.assertIn("File too large", err)
        self.assertIn("ligament resume", err)
        self.assertIn("File too large", (self.folder / "run" / "run.log").read_text())
        self.assert_nothing_is_torn("run")
        self.call("resume", "run", "--quiet")
        self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
        self.assert_same_results("run", "whole")

    def test_no_room_at_any_size(self):
        """Whatever the first write is that fails: an exit code of its own, nothing torn, and a run that can go on."""
        case = [COLUMNS[1], *settings(solver__max_steps=60, output__every=1, checkpoint__every=10)]
        self.call("run", *case, "--output", "whole", "--quiet", expect=NOT_CONVERGED)
        for n_bytes in (0, 100, 1000, 2300, 3000, 20000, 90000, 200000, 400000):
            with self.subTest(limit=n_bytes):
                run = f"run_{n_bytes}"
                process = self.start("run", *case, "--output", run, "--quiet", **self.limit(n_bytes))
                _, err = process.communicate()
                self.assertIn(process.returncode, (FILE_ERROR, NOT_CONVERGED), err)
                self.assertEqual("File too large" in err, process.returncode == FILE_ERROR or "warning" in err)
                self.assertEqual(self.unfinished(), [])
                if (self.folder / run).exists():
                    self.assert_nothing_is_torn(run)
                    self.call("resume", run, "--quiet", expect=NOT_CONVERGED)
                    self.assert_same_results(run, "whole")


if __name__ == "__main__":
    unittest.main()
