#!/usr/bin/env python3
"""A run keeps the files that its case names: it goes on without them, and not with others."""

import unittest

from program import CONFIG, NOT_CONVERGED, WRONG_INPUT, ProgramTest, settings

RANDOM = CONFIG / "column_random_r2.toml"
KEYS_OF_RANDOM = ("smallest_radius", "largest_radius", "count")
LIMIT = settings(solver__max_steps=60)


class Inputs(ProgramTest):
    def setUp(self):
        super().setUp()
        lines = [line for line in RANDOM.read_text().splitlines() if not line.startswith(KEYS_OF_RANDOM)]
        text = "\n".join(lines).replace('generator = "random"', 'generator = "file"\npath = "../discs.h5"')
        (self.folder / "cases").mkdir()
        (self.folder / "cases" / "loading.toml").write_text(text)
        self.generate("discs.h5")
        self.run_half("half")

    def generate(self, file, seed=1):
        self.call("generate", RANDOM, "--output", file, "--overwrite", *settings(generation__seed=seed))

    def run_half(self, run):
        case = ["cases/loading.toml", "--quiet", *LIMIT, "--output", run]
        self.call("run", *case, "--stop-after-steps", 30)

    def test_a_run_goes_on_without_the_file_it_began_with(self):
        self.call("run", RANDOM, "--quiet", *LIMIT, "--output", "whole", expect=NOT_CONVERGED)
        (self.folder / "discs.h5").unlink()
        (self.folder / "half").rename(self.folder / "moved")
        self.call("resume", "moved", "--quiet", expect=NOT_CONVERGED)
        self.assertEqual(self.final_hash("moved"), self.final_hash("whole"))

    def test_a_changed_original_does_not_matter(self):
        self.call("run", RANDOM, "--quiet", *LIMIT, "--output", "whole", expect=NOT_CONVERGED)
        self.generate("discs.h5", seed=2)
        self.call("resume", "half", "--quiet", expect=NOT_CONVERGED)
        self.assertEqual(self.final_hash("half"), self.final_hash("whole"))

    def test_a_changed_copy_is_refused(self):
        self.generate("half/inputs/1.h5", seed=2)
        _, err = self.call("resume", "half", "--quiet", expect=WRONG_INPUT)
        self.assertIn("inputs/ of the run directory is not the one the checkpoints were written with", err)

    def test_a_copy_that_is_gone_or_damaged_is_refused(self):
        copy = self.folder / "half" / "inputs" / "1.h5"
        copy.write_bytes(copy.read_bytes()[:3000])
        _, err = self.call("resume", "half", "--quiet", expect=WRONG_INPUT)
        self.assertIn("half/inputs/1.h5", err)
        copy.unlink()
        _, err = self.call("resume", "half", "--quiet", expect=WRONG_INPUT)
        self.assertIn("half/inputs/1.h5: there is no such file", err)


if __name__ == "__main__":
    unittest.main()
