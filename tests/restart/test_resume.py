#!/usr/bin/env python3
"""A run that was stopped and resumed by a new process is the run that never stopped: state, rows and fields."""

import unittest

from program import BEAM_ON_PLATENS, COLUMNS, CONFIG, DONE, ENDLESS, FALLING_BLOCK, NOT_CONVERGED, TENSION, WRONG_INPUT, ProgramTest, settings

CASES = [*COLUMNS, FALLING_BLOCK, BEAM_ON_PLATENS]
# And keys of the bilinear law that they do not have.
LAWS_OF_BONDS = (("mohr_coulomb_bilinear", ()), ("mohr_coulomb_exponential", ()),
                 ("mohr_coulomb_brittle", ("fracture_energy",)))


class Resume(ProgramTest):
    def limited(self, case, steps, **more):
        """Options that end a run at this step, and the exit code to expect."""
        if case == FALLING_BLOCK:
            return [case, "--quiet", *settings(solver__max_steps=steps, **more)], DONE
        return [case, "--quiet", *ENDLESS, *settings(solver__max_steps=steps, **more)], NOT_CONVERGED

    def test_half_and_half_is_the_whole(self):
        for case in CASES:
            for every in (1, 1000):
                with self.subTest(case=case.stem, checkpoint_every=every):
                    # Either way of relaxation, one with each interval.
                    method = {} if every == 1 or case == FALLING_BLOCK else {"solver__method": "dynamic_relaxation"}
                    run, code = self.limited(
                        case, 400, checkpoint__every=every, output__fields_every=100, **method)
                    self.call("run", *run, "--output", f"whole_{case.stem}_{every}", expect=code)
                    half = f"half_{case.stem}_{every}"
                    self.call("run", *run, "--output", half, "--stop-after-steps", 200)
                    self.assertEqual(self.summary(half)["ended"], "stopped")
                    self.call("resume", half, "--quiet", expect=code)
                    self.assertEqual(self.final_hash(half), self.final_hash(f"whole_{case.stem}_{every}"))
                    self.assert_same_results(half, f"whole_{case.stem}_{every}")

    def test_a_run_in_many_pieces(self):
        run, code = self.limited(FALLING_BLOCK, 1200, output__fields_every=150)
        self.call("run", *run, "--output", "whole", expect=code)
        self.call("run", *run, "--output", "pieces", "--stop-after-steps", 1)
        for step in (2, 149, 150, 151, 333, 1199):
            self.call("resume", "pieces", "--until-step", step, "--quiet")
            self.assertEqual(self.summary("pieces")["steps"], step)
        self.call("resume", "pieces", "--quiet")
        self.assertEqual(self.final_hash("pieces"), self.final_hash("whole"))
        self.assert_same_results("pieces", "whole")

    def test_stages_of_loading_survive_a_stop(self):
        case = CONFIG / "assembly_properties_h2.toml"
        self.call("run", case, "--output", "whole", "--quiet")
        steps = self.summary("whole")["steps"]
        rows = (self.folder / "whole" / "history.csv").read_text().splitlines()[1:]
        end_of_first_stage = next(step for step in (int(row.split(",")[0]) for row in rows) if step % 100)
        self.assertLess(end_of_first_stage, steps)
        self.call("run", case, "--output", "pieces", "--quiet", "--stop-after-steps", 150)
        for step in (end_of_first_stage - 1, end_of_first_stage, end_of_first_stage + 1, steps - 1):
            self.call("resume", "pieces", "--until-step", step, "--quiet")
        self.call("resume", "pieces", "--quiet")
        self.assertEqual(self.final_hash("pieces"), self.final_hash("whole"))
        self.assertEqual(self.summary("pieces")["results"], self.summary("whole")["results"])
        self.assert_same_results("pieces", "whole")

    def test_increments_of_loading_survive_a_stop_while_bonds_soften_and_break(self):
        self.call("run", TENSION, "--output", "whole", "--quiet")
        self.call("run", TENSION, "--output", "pieces", "--quiet", "--stop-after-steps", 1)
        for step in (9, 10, 11, 15, 16, 35, 36, 37, 50):
            self.call("resume", "pieces", "--quiet", "--until-step", step)
            self.assertEqual(self.summary("pieces")["steps"], step)
        self.call("resume", "pieces", "--quiet", "--threads", 2)
        self.assertEqual(self.final_hash("pieces"), self.final_hash("whole"))
        self.assertEqual(self.summary("pieces")["peak_load_N"], self.summary("whole")["peak_load_N"])
        self.assert_same_results("pieces", "whole")
        self.assertGreater(self.summary("whole")["n_broken"], 0)

    def tension_with(self, law, without=()):
        """The specimen with another law of its bonds, pulled apart on a schedule that turns back on the way."""
        text = TENSION.read_text().replace("mohr_coulomb_bilinear", law)
        lines = [line for line in text.splitlines() if not line.startswith(without)]
        text = "\n".join(lines) + "\n"
        begin, end = text.index("[[motion]]"), text.index("[[gauge]]")
        motion = '''[[motion]]
name = "pull"
walls = ["top"]
direction = "y"
schedule = { time = ["0 s", "1 s", "2 s", "3 s"], displacement = ["0 um", "10 um", "6 um", "46 um"] }

'''
        case = self.folder / f"{law}.toml"
        case.write_text(text[:begin] + motion + text[end:])
        return case

    def test_every_law_of_bonds_survives_stops_and_threads_in_the_middle_of_cracking(self):
        for law, without in LAWS_OF_BONDS:
            with self.subTest(law=law):
                run = [self.tension_with(law, without), "--quiet", *settings(output__transient_every=7)]
                self.call("run", *run, "--output", f"{law}_whole")
                self.assertGreater(self.summary(f"{law}_whole")["n_broken"], 0)
                pieces = f"{law}_pieces"
                self.call("run", *run, "--output", pieces, "--stop-after-steps", 9)
                # Before, at and beyond the corners, and where bonds break.
                for step, threads in ((10, 2), (11, 1), (14, 3), (15, 2), (35, 1)):
                    self.call("resume", pieces, "--quiet", "--until-step", step, "--threads", threads)
                self.call("resume", pieces, "--quiet", "--threads", 2)
                self.assertEqual(self.final_hash(pieces), self.final_hash(f"{law}_whole"))
                for name in ("force_mismatch_max", "energy_error", "results"):
                    self.assertEqual(self.summary(pieces)[name], self.summary(f"{law}_whole")[name])
                self.assert_same_results(pieces, f"{law}_whole")

    def test_threads_that_share_the_bonds_of_an_increment_change_no_bit(self):
        fine = settings(zone__specimen__smallest_radius='"0.8 mm"', zone__specimen__largest_radius='"1.2 mm"')
        for law, without in LAWS_OF_BONDS:
            with self.subTest(law=law):
                run = [self.tension_with(law, without), "--quiet", *fine, *settings(solver__increment='"5 um"')]
                self.call("run", *run, "--output", f"{law}_1", "--stop-after-steps", 3)
                self.assertGreater(self.summary(f"{law}_1")["n_contacts"], 4096)
                self.call("run", *run, "--output", f"{law}_2", "--stop-after-steps", 3, "--threads", 2)
                self.assertEqual(self.final_hash(f"{law}_2"), self.final_hash(f"{law}_1"))
                self.assert_same_results(f"{law}_2", f"{law}_1")

    def test_a_live_increment_survives_a_stop_before_and_after_it(self):
        # The specimen is crushed: it fails in an increment that settles only while contacts live.
        crushed = settings(motion__pull__displacement='"-148 um"', motion__pull_apart__displacement='"4 um"',
                           solver__increment='"4 um"', solver__most_evaluations=200, solver__smallest_share=1.0)
        run = [TENSION, "--quiet", *crushed]
        self.call("run", *run, "--output", "whole")
        rows = (self.folder / "whole" / "history.csv").read_text().splitlines()[1:]
        loads = [-float(row.split(",")[3]) for row in rows]
        failure = next(step for step, load in enumerate(loads) if step > 10 and load < 0.1 * max(loads))
        self.assertLess(failure, len(loads) - 3)
        self.call("run", *run, "--output", "pieces", "--stop-after-steps", failure - 1)
        for step in (failure, failure + 1):
            self.call("resume", "pieces", "--quiet", "--until-step", step)
        self.call("resume", "pieces", "--quiet", "--threads", 2)
        self.assertEqual(self.final_hash("pieces"), self.final_hash("whole"))
        self.assert_same_results("pieces", "whole")
        self.assertGreater(self.summary("whole")["n_broken"], 100)

    def test_a_gauge_that_is_followed_survives_a_stop_while_bonds_soften(self):
        run = [TENSION, "--quiet", *settings(solver__method="secant", solver__control="opening", solver__max_steps=24)]
        self.call("run", *run, "--output", "whole", expect=NOT_CONVERGED)
        self.call("run", *run, "--output", "pieces", "--stop-after-steps", 1)
        for step in (9, 10, 11, 20, 22):
            self.call("resume", "pieces", "--quiet", "--until-step", step)
        self.call("resume", "pieces", "--quiet", "--threads", 2, expect=NOT_CONVERGED)
        self.assertEqual(self.final_hash("pieces"), self.final_hash("whole"))
        self.assert_same_results("pieces", "whole")

    def test_breaks_are_recorded_and_counted_once(self):
        # Contacts that break leave the list when they have opened by so little.
        run = [TENSION, "--quiet", *settings(contact__skin='"2 um"', output__fields_every=10)]
        self.call("run", *run, "--output", "whole")
        rows = (self.folder / "whole" / "cracks.csv").read_text().splitlines()[1:]
        steps = [int(row.split(",")[0]) for row in rows]
        self.assertGreater(len(steps), 10)
        self.assertGreater(len(steps), len(set(steps)), "several bonds break in one increment")
        self.call("run", *run, "--output", "pieces", "--stop-after-steps", 1)
        for step in sorted(set(steps)):
            self.call("resume", "pieces", "--until-step", step, "--quiet")
            self.assertEqual(self.summary("pieces")["n_broken"], sum(1 for other in steps if other <= step))
        self.call("resume", "pieces", "--quiet")
        self.assert_same_results("pieces", "whole")
        whole, pieces = self.summary("whole"), self.summary("pieces")
        self.assertEqual(whole["n_broken_tension"] + whole["n_broken_shear"], len(steps))
        for name in ("n_broken", "n_broken_tension", "n_broken_shear", "crack", "final_state_hash"):
            self.assertEqual(pieces[name], whole[name])

    def test_the_record_of_breaks_does_not_depend_on_when_rows_are_written(self):
        self.call("run", TENSION, "--output", "every", "--quiet")
        self.call("run", TENSION, "--output", "seldom", "--quiet", *settings(output__every=1000))
        every, seldom = self.results("every"), self.results("seldom")
        self.assertGreater(every["cracks.csv"].count(b"\n"), 10)
        self.assertEqual(seldom["cracks.csv"], every["cracks.csv"])

    def test_what_is_written_when_changes_no_bit_of_the_run(self):
        schedules = [
            {"checkpoint__every": 1},
            {"checkpoint__every": 7, "checkpoint__keep": 1},
            {"output__every": 1},
            {"output__every": 100000},
            {"output__fields_every": 1},
            {"audit__every_step": "true"},
            {"output__every": 3, "output__fields_every": 5, "checkpoint__every": 2},
        ]
        for case in CASES:
            run, code = self.limited(case, 120)
            self.call("run", *run, "--output", case.stem, expect=code)
            for number, schedule in enumerate(schedules):
                with self.subTest(case=case.stem, schedule=schedule):
                    name = f"{case.stem}_{number}"
                    self.call("run", *run, *settings(**schedule), "--output", name, expect=code)
                    self.assertEqual(self.final_hash(name), self.final_hash(case.stem))

    def test_the_number_of_threads_changes_no_bit_of_the_run(self):
        # So many contacts that threads share them.
        fine = settings(zone__held__radius='"0.004 m"', zone__falling__radius='"0.004 m"')
        run, code = self.limited(FALLING_BLOCK, 300)
        self.call("run", *run, *fine, "--output", "alone", expect=code)
        self.assertGreater(self.summary("alone")["n_contacts"], 4096)
        for first, then in ((2, 3), (3, 1), (8, 2)):
            with self.subTest(threads=(first, then)):
                name = f"threads_{first}_{then}"
                self.call("run", *run, *fine, "--output", name, "--threads", first, "--stop-after-steps", 150)
                self.assertEqual(self.summary(name)["threads"], first)
                self.call("resume", name, "--quiet", "--threads", then, expect=code)
                self.assertEqual(self.summary(name)["threads"], then)
                self.assertEqual(self.final_hash(name), self.final_hash("alone"))
                self.assert_same_results(name, "alone")

    def test_resuming_a_finished_run_changes_nothing(self):
        case = CONFIG / "column_fem.toml"
        self.call("run", case, "--output", "run")
        before, final_hash = self.results("run"), self.final_hash("run")
        out, _ = self.call("resume", "run")
        self.assertIn("converged at step", out)
        self.assertEqual(self.results("run"), before)
        self.assertEqual(self.final_hash("run"), final_hash)
        self.assertEqual(self.summary("run")["case"], str(case))

    def test_a_run_killed_before_its_first_checkpoint_starts_anew(self):
        run, code = self.limited(FALLING_BLOCK, 100)
        self.call("run", *run, "--output", "whole", expect=code)
        self.call("run", *run, "--output", "bare", "--stop-after-steps", 60)
        for checkpoint in self.checkpoints("bare"):
            checkpoint.unlink()
        for table in ("history.csv", "energy.csv"):
            lines = (self.folder / "bare" / table).read_text().splitlines(keepends=True)
            (self.folder / "bare" / table).write_text("".join(lines[:2]))
        out, _ = self.call("resume", "bare", expect=code)
        self.assertIn("no checkpoint yet: starting from step 0", out)
        self.assert_same_results("bare", "whole")

    def test_overrides_of_the_first_run_hold_for_the_next(self):
        run, code = self.limited(FALLING_BLOCK, 60, problem__thickness='"0.2 m"')
        self.call("run", *run, "--output", "whole", expect=code)
        self.call("run", *run, "--output", "half", "--stop-after-steps", 30)
        self.call("resume", "half", "--quiet", expect=code)
        self.assertEqual(self.final_hash("half"), self.final_hash("whole"))
        self.assertEqual(self.summary("half")["case_hash"], self.summary("whole")["case_hash"])

    def test_a_checkpoint_of_another_case_is_refused(self):
        run, _ = self.limited(FALLING_BLOCK, 60)
        self.call("run", *run, "--output", "run", "--stop-after-steps", 30)
        case = self.folder / "run" / "case.toml"
        original = case.read_text()
        before = self.results("run")
        case.write_text(original.replace('young_modulus = "1 MPa"', 'young_modulus = "2 MPa"'))
        _, err = self.call("resume", "run", expect=WRONG_INPUT)
        self.assertIn('material.rock.young_modulus: "1e+06 Pa" in the run, "2e+06 Pa" now', err)
        self.assertEqual(self.results("run"), before)
        case.write_text(original.replace("# Contacts that come", "# Only a comment"))
        self.call("resume", "run", "--quiet")

    def test_what_is_no_run_cannot_be_resumed(self):
        _, err = self.call("resume", "nowhere", expect=WRONG_INPUT)
        self.assertIn("nowhere", err)
        (self.folder / "empty").mkdir()
        _, err = self.call("resume", "empty", expect=WRONG_INPUT)
        self.assertIn("run.json", err)


if __name__ == "__main__":
    unittest.main()
