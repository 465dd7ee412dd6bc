#!/usr/bin/env python3
"""Signals are acted on at the next step boundary: a stop leaves a checkpoint and is no end."""

import os
import pty
import re
import shutil
import signal
import time
import unittest

from program import (
    DONE, FALLING_BLOCK, INTERRUPTED, PROGRAM, TERMINATED, ProgramTest, faulty_disk, settings)

# Long enough that it never ends by itself, and without checkpoints of its own after the first.
ENDLESS = [FALLING_BLOCK, *settings(solver__max_steps=10**9, checkpoint__every=10**9, output__every=50)]


class Signals(ProgramTest):
    def start_endless(self):
        process = self.start("run", *ENDLESS, "--output", "run")
        self.wait_for(process, "       100  ")
        return process

    def wait_for(self, process, text):
        """Reads the output up to a line with this text."""
        for line in process.stdout:
            if text in line:
                return line
        self.fail(f"the run ended without '{text}': {process.stderr.read()}")

    def stop(self, process, number, code):
        process.send_signal(number)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, code, err)
        self.assertIn("checkpoint: ", out)
        self.assertIn("ligament resume", out)
        summary = self.summary("run")
        self.assertEqual(summary["ended"], "interrupted")
        self.assertTrue(self.checkpoints("run")[-1].name.endswith(f"{summary['steps']:012}.ckpt"))
        return summary["steps"]

    def check_resumed(self, stopped_at):
        """The stopped run goes on to the state and the rows of one that was never stopped."""
        last = stopped_at + 120
        self.call("resume", "run", "--until-step", last, "--quiet")
        self.call("run", *ENDLESS, "--output", "whole", "--stop-after-steps", last, "--quiet")
        self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
        self.assert_same_results("run", "whole")

    def test_terminate(self):
        self.check_resumed(self.stop(self.start_endless(), signal.SIGTERM, TERMINATED))

    def test_interrupt(self):
        self.check_resumed(self.stop(self.start_endless(), signal.SIGINT, INTERRUPTED))

    def test_stop_of_a_resumed_run(self):
        self.stop(self.start_endless(), signal.SIGTERM, TERMINATED)
        process = self.start("resume", "run")
        self.wait_for(process, "resuming from step")
        self.wait_for(process, "00  ")
        self.check_resumed(self.stop(process, signal.SIGINT, INTERRUPTED))

    def test_checkpoint_on_request(self):
        process = self.start_endless()
        self.assertEqual(len(self.checkpoints("run")), 1)
        process.send_signal(signal.SIGUSR1)
        self.wait_for(process, "checkpoint: ")
        self.assertEqual(len(self.checkpoints("run")), 2)
        self.wait_for(process, "00  ")
        self.check_resumed(self.stop(process, signal.SIGTERM, TERMINATED))

    def test_two_signals_in_a_row(self):
        for first, second, codes in (
                (signal.SIGTERM, signal.SIGTERM, (TERMINATED,)), (signal.SIGINT, signal.SIGINT, (INTERRUPTED,)),
                (signal.SIGINT, signal.SIGTERM, (INTERRUPTED, TERMINATED)),
                (signal.SIGUSR1, signal.SIGTERM, (TERMINATED,))):
            with self.subTest(signals=(first.name, second.name)):
                # So slow a disk that the second signal comes while the first is acted on.
                process = self.start("run", *ENDLESS, "--output", "run", **faulty_disk(delay_us=2000))
                self.wait_for(process, "       100  ")
                process.send_signal(first)
                time.sleep(0.01)
                process.send_signal(second)
                _, err = process.communicate(timeout=60)
                self.assertIn(process.returncode, codes, err)
                self.check_resumed(self.summary("run")["steps"])
                shutil.rmtree(self.folder / "run")
                shutil.rmtree(self.folder / "whole")

    def test_a_batch_system_that_terminates_and_later_kills(self):
        process = self.start_endless()
        process.send_signal(signal.SIGTERM)
        # It would wait 30 s.
        process.wait(timeout=15)
        self.assertEqual(process.returncode, TERMINATED)
        self.check_resumed(self.summary("run")["steps"])

    def test_a_kill_while_a_terminated_run_writes_its_checkpoint_loses_no_more_than_a_kill_does(self):
        frequent, last, n_killed = settings(checkpoint__every=40), 2000, 0
        self.call("run", *ENDLESS, *frequent, "--output", "whole", "--stop-after-steps", last, "--quiet")
        for grace in (0.0, 0.02, 0.06):
            with self.subTest(grace=grace):
                # The stop takes this disk about as long as the longest grace.
                process = self.start("run", *ENDLESS, *frequent, "--output", "run", **faulty_disk(delay_us=2000))
                self.wait_for(process, "       100  ")
                process.send_signal(signal.SIGTERM)
                kept = self.checkpoints("run")[-1].stem
                time.sleep(grace)
                process.kill()
                process.communicate()
                n_killed += process.returncode == -signal.SIGKILL
                out, _ = self.call("resume", "run", "--until-step", last)
                resumed_from = int(re.search(r"resuming from step (\d+)", out)[1])
                self.assertGreaterEqual(resumed_from, int(kept.removeprefix("step_")))
                self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
                self.assert_same_results("run", "whole")
                shutil.rmtree(self.folder / "run")
        self.assertGreater(n_killed, 0)

    def test_no_control_characters_in_files_and_pipes(self):
        out, err = self.call("run", FALLING_BLOCK, "--output", "run")
        log = (self.folder / "run" / "run.log").read_text()
        for text in (out, err, log):
            self.assertEqual([c for c in text if c != "\n" and ord(c) < 32], [])
        self.assertEqual(out, log)

    def test_progress_on_a_terminal(self):
        process_id, terminal = pty.fork()
        if process_id == 0:
            os.chdir(self.folder)
            os.execv(PROGRAM, [PROGRAM, "run", *map(str, ENDLESS), "--output", "run"])
        shown = b""
        while b"left at most" not in shown:
            shown += os.read(terminal, 4096)
        os.kill(process_id, signal.SIGTERM)
        try:
            while chunk := os.read(terminal, 4096):
                shown += chunk
        except OSError:
            pass  # the other side has closed
        _, status = os.waitpid(process_id, 0)
        os.close(terminal)
        self.assertEqual(os.waitstatus_to_exitcode(status), TERMINATED)
        self.assertIn(b"\r\x1b[K", shown)
        self.assertNotIn("\x1b", (self.folder / "run" / "run.log").read_text())

    def test_quiet(self):
        out, err = self.call("run", FALLING_BLOCK, "--quiet", *settings(solver__max_steps=10), expect=DONE)
        self.assertEqual((out, err), ("", ""))


if __name__ == "__main__":
    unittest.main()
