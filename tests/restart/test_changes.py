#!/usr/bin/env python3
"""What may change between run and resume, what may not, and what checkpoints say of the run that they belong to."""

import unittest

from program import FALLING_BLOCK, TENSION, WRONG_INPUT, ProgramTest, settings

SHORT = [FALLING_BLOCK, "--quiet", *settings(solver__max_steps=60, checkpoint__every=20, generation__seed=5)]


class Changes(ProgramTest):
    def test_a_later_end(self):
        self.call("run", *SHORT, "--output", "run")
        self.call("run", *SHORT, *settings(solver__max_steps=100), "--output", "whole")
        self.call("resume", "run", "--quiet", "--until-step", 80, *settings(solver__max_steps=100))
        self.assertIn("max_steps = 100", (self.folder / "run" / "case_resolved.toml").read_text())
        # It holds for every resume that follows.
        self.call("resume", "run", "--quiet")
        self.assertEqual(self.summary("run")["steps"], 100)
        self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
        self.assertEqual(self.summary("run")["case_hash"], self.summary("whole")["case_hash"])

    def test_a_stop_that_is_given_or_moved(self):
        self.call("run", TENSION, "--quiet", "--output", "run", "--stop-after-steps", 12)
        stop = {"stop__gauge": '"load"', "stop__drop_to_share": 0.5}
        self.call("run", TENSION, "--quiet", "--output", "whole", *settings(**stop))
        self.call("resume", "run", "--quiet", *settings(**stop))
        self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
        self.assert_same_results("run", "whole")

    def test_other_intervals_change_no_bit(self):
        self.call("run", *SHORT, "--output", "whole")
        self.call("run", *SHORT, "--output", "run", "--stop-after-steps", 30)
        changes = settings(output__every=7, output__fields_every=11, checkpoint__every=3, checkpoint__keep=2,
                           audit__tolerance=0.01, audit__every_step="true", output__on_failed_write='"stop"')
        self.call("resume", "run", "--quiet", *changes, "--threads", 2)
        self.assertEqual(self.final_hash("run"), self.final_hash("whole"))
        self.assertEqual(len(self.checkpoints("run")), 2)

    def test_a_key_changed_twice_has_the_later_value(self):
        self.call("run", *SHORT, "--output", "run")
        for steps in (70, 90, 80):
            self.call("resume", "run", "--quiet", *settings(solver__max_steps=steps))
        self.assertIn("max_steps = 80", (self.folder / "run" / "case_resolved.toml").read_text())
        out, _ = self.call("info", self.checkpoints("run")[-1])
        self.assertEqual(out.count("solver.max_steps"), 1)

    def test_any_other_change_is_refused_with_both_values(self):
        self.call("run", *SHORT, "--output", "run", "--stop-after-steps", 30)
        before = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        for override, line in (
                ("generation.seed=6", "generation.seed: 5 in the run, 6 now"),
                ("material.rock.young_modulus=2 MPa",
                 'material.rock.young_modulus: "1e+06 Pa" in the run, "2e+06 Pa" now'),
                ("zone.falling.radius=0.02 m", 'zone.falling.radius: "0.01 m" in the run, "0.02 m" now'),
                ("solver.unbalanced_force_ratio=0.1", "solver.unbalanced_force_ratio: not given in the run, 0.1 now"),
                ('solver.method="local_damping"', 'solver.method: "undamped" in the run, "local_damping" now'),
                ("gauge.fall.factor=2", "gauge.fall.factor: 1.0 in the run, 2.0 now"),
                ('checkpoint.folder="x"', 'checkpoint.folder: not given in the run, "x" now')):
            with self.subTest(override=override):
                _, err = self.call("resume", "run", "--set", "output.every=1", "--set", override, expect=WRONG_INPUT)
                self.assertIn("must stay the same run", err)
                self.assertIn(line, err)
                self.assertIn("what may change is title, solver.max_steps, ", err)
                self.assertNotIn("output.every:", err)
        _, err = self.call("resume", "run", "--set", "solver.max_step=70", expect=WRONG_INPUT)
        self.assertIn("did you mean 'max_steps'?", err)
        self.assertEqual({path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}, before)

    def test_a_key_removed_from_the_case_is_refused(self):
        self.call("run", *SHORT, "--output", "run", "--stop-after-steps", 30)
        case = self.folder / "run" / "case.toml"
        case.write_text(case.read_text().replace('gravity = ["0.5 m/s2", "-9.81 m/s2"]\n', "").replace(
            "particles = [1, 2, 3, 4, 5, 6]", "particles = [1]"))
        _, err = self.call("resume", "run", expect=WRONG_INPUT)
        self.assertIn('problem.gravity: ["0.5 m/s2", "-9.81 m/s2"] in the run, ["0 m/s2", "0 m/s2"] now', err)
        self.assertIn("support.base.particles: [1, 2, 3, 4, 5, 6] in the run, [1] now", err)

    def test_a_checkpoint_says_where_it_came_from(self):
        self.call("run", *SHORT, "--output", "run")
        out, _ = self.call("info", self.checkpoints("run")[-1])
        for part in (self.summary("run")["case_hash"], self.final_hash("run"), "step 60", "seed         5",
                     "set          solver.max_steps=60", "bytes a word", "Boost", "written by   ligament "):
            self.assertIn(part, out)
        out, _ = self.call("info", "--case", self.checkpoints("run")[-1])
        self.assertTrue(out.endswith((self.folder / "run" / "case_resolved.toml").read_text()))


if __name__ == "__main__":
    unittest.main()
