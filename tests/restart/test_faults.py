#!/usr/bin/env python3
"""Writes that fail for a while, for good, at any operation: the run goes on, and its files are those of a quiet one."""

import errno
import resource
import shutil
import signal
import unittest

from program import (
    COLUMNS, DONE, FALLING_BLOCK, FILE_ERROR, INTERRUPTED, TENSION, WRONG_INPUT, ProgramTest, faulty_disk, settings)

SCHEDULE = settings(output__every=1, checkpoint__every=5, output__fields_every=10)
CASE = [TENSION, "--quiet", *SCHEDULE]
FOR_EVER = 10**9


class FailingWrites(ProgramTest):
    def setUp(self):
        super().setUp()
        self.call("run", *CASE, "--output", "whole")

    def run_with(self, run, *options, **faults):
        """A run on a disk with these faults; its exit code and what it said of errors."""
        process = self.start("run", *CASE, *options, "--output", run, **faulty_disk(**faults))
        _, err = process.communicate()
        return process.returncode, err

    def assert_ends_whole(self, run, code):
        """At once, or resumed on a good disk, if it was made at all."""
        self.assertIn(code, (DONE, FILE_ERROR))
        if not (self.folder / run).exists():
            self.assertEqual(code, FILE_ERROR)
            return
        if code == FILE_ERROR:
            self.call("resume", run, "--quiet")
        self.assertEqual(self.final_hash(run), self.final_hash("whole"))
        self.assert_same_results(run, "whole")
        self.assertEqual(self.unfinished(), [])

    def test_a_disk_that_is_full_for_a_while(self):
        for first, last in ((100, 130), (150, 260), (300, 310), (350, 420)):
            with self.subTest(operations=(first, last)):
                run = f"run_{first}"
                code, err = self.run_with(run, fail=f"{first}-{last}")
                self.assertEqual(code, DONE, err)
                self.assertIn("results wait in memory for the next try: cannot ", err)
                self.assertIn("No space left on device", err)
                self.assertIn("the results that waited are written", (self.folder / run / "run.log").read_text())
                self.assert_ends_whole(run, code)

    def test_any_single_operation_that_fails(self):
        for number in [*range(1, 60), *range(60, 400, 11)]:
            with self.subTest(operation=number):
                code, err = self.run_with("run", fail=f"{number}-{number}")
                self.assertNotEqual((code, err), (FILE_ERROR, ""))
                self.assert_ends_whole("run", code)
                shutil.rmtree(self.folder / "run", ignore_errors=True)

    def test_a_disk_that_fails_for_good(self):
        for number, error in ((160, errno.ENOSPC), (200, errno.EROFS), (250, errno.EIO), (330, errno.EACCES)):
            with self.subTest(error=errno.errorcode[error]):
                run = f"run_{number}"
                code, err = self.run_with(run, fail=f"{number}-{FOR_EVER}", errno=error)
                self.assertEqual(code, FILE_ERROR)
                self.assertIn("results could not be written", err)
                self.assertIn(f"last good checkpoint: {self.checkpoints(run)[-1]}", err)
                self.assert_ends_whole(run, code)

    def test_a_case_may_ask_for_an_end(self):
        stop = settings(output__on_failed_write='"stop"')
        code, err = self.run_with("run", *stop, fail=f"200-{FOR_EVER}")
        self.assertEqual(code, FILE_ERROR)
        self.assertNotIn("warning", err)
        self.assertIn(f"last good checkpoint: {self.checkpoints('run')[-1]}", err)
        self.assertLess(len(self.results("run")["history.csv"]), len(self.results("whole")["history.csv"]))
        self.assert_ends_whole("run", code)


class RemovedFolders(ProgramTest):
    ENDLESS = [FALLING_BLOCK, *settings(solver__max_steps=10**9, checkpoint__every=40, output__every=20)]

    def start_endless(self):
        process = self.start("run", *self.ENDLESS, "--output", "run")
        while "       100  " not in process.stdout.readline():
            pass
        return process

    def test_a_run_directory_removed_under_the_run_is_told(self):
        process = self.start_endless()
        shutil.rmtree(self.folder / "run")
        warning = process.stderr.readline()
        self.assertIn("history.csv: it was removed or replaced under the run", warning)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate()
        self.assertEqual(process.returncode, FILE_ERROR)
        self.assertIn("results could not be written", err)

    def test_a_folder_of_checkpoints_removed_under_the_run_is_made_again(self):
        process = self.start_endless()
        shutil.rmtree(self.checkpoints("run")[-1].parent)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate()
        self.assertEqual((process.returncode, err), (INTERRUPTED, ""))
        last = self.summary("run")["steps"] + 100
        self.call("resume", "run", "--until-step", last, "--quiet")
        self.call("run", *self.ENDLESS, "--stop-after-steps", last, "--output", "whole", "--quiet")
        self.assert_same_results("run", "whole")

    def block_checkpoints(self):
        """Puts a file where the folder of the checkpoints is; returns both."""
        folder = self.checkpoints("run")[-1].parent
        aside = folder.rename(folder.parent / "aside")
        folder.touch()
        return folder, aside

    def test_a_checkpoint_that_cannot_be_written_does_not_end_the_run(self):
        process = self.start_endless()
        folder, aside = self.block_checkpoints()
        self.assertIn("no checkpoint written: ", process.stderr.readline())
        folder.unlink()
        aside.rename(folder)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate()
        self.assertEqual(process.returncode, INTERRUPTED, err)
        last = self.summary("run")["steps"] + 100
        self.call("resume", "run", "--until-step", last, "--quiet")
        self.call("run", *self.ENDLESS, "--stop-after-steps", last, "--output", "whole", "--quiet")
        self.assert_same_results("run", "whole")

    def test_a_stop_without_its_checkpoint_is_an_error(self):
        process = self.start_endless()
        self.block_checkpoints()
        process.send_signal(signal.SIGINT)
        _, err = process.communicate()
        self.assertEqual(process.returncode, FILE_ERROR)
        self.assertIn("stopped without a checkpoint", err)

    def test_a_run_that_cannot_save_its_start_is_not_begun(self):
        (self.folder / "blocked").touch()
        blocked = settings(checkpoint__folder=f'"{self.folder / "blocked"}"')
        _, err = self.call("run", *self.ENDLESS, *blocked, "--output", "run", "--quiet", expect=FILE_ERROR)
        self.assertIn("checkpoint folder", err)

    def test_a_folder_that_cannot_be_written_is_an_error_before_the_first_step(self):
        code = self.start("run", COLUMNS[1], "--output", "run", **faulty_disk(fail=f"1-{FOR_EVER}", errno=errno.EROFS))
        _, err = code.communicate()
        self.assertEqual(code.returncode, FILE_ERROR)
        self.assertIn("Read-only file system", err)


class LittleMemory(ProgramTest):
    # Some 30 000 particles.
    LARGE = [FALLING_BLOCK, "--quiet", *settings(zone__held__radius='"0.001 m"', zone__falling__radius='"0.001 m"'),
             *settings(solver__max_steps=4, output__every=1, checkpoint__every=1)]

    def call_with(self, megabytes, *arguments):
        limit = megabytes << 20
        process = self.start(*arguments, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        _, err = process.communicate()
        return process.returncode, err

    def test_a_run_that_needs_more_memory_than_there_is_ends_with_an_error_and_goes_on_with_more(self):
        self.call("run", *self.LARGE, "--output", "whole")
        code, n_refused = None, 0
        megabytes = 40
        while code != DONE:
            code, err = self.call_with(megabytes, "run", *self.LARGE, "--output", "run")
            self.assertLess(megabytes, 2000)
            with self.subTest(megabytes=megabytes):
                self.assertIn(code, (DONE, WRONG_INPUT, FILE_ERROR), err)
                self.assertTrue(code == DONE or "memory" in err, err)
                n_refused += code != DONE
                if (self.folder / "run").exists():
                    self.assertTrue(code == DONE or "ligament resume" in err, err)
                    self.call("resume", "run", "--quiet")
                    self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
                    self.assert_same_results("run", "whole")
                    shutil.rmtree(self.folder / "run")
            megabytes += 16
        self.assertGreater(n_refused, 2)


if __name__ == "__main__":
    unittest.main()
