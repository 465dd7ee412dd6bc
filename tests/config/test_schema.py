#!/usr/bin/env python3
"""Every case of config/ is valid by the JSON Schema that the program writes, and a wrong one is not."""

import json
import os
import subprocess
import sys
import tomllib
import unittest
from pathlib import Path

try:
    import jsonschema
except ImportError:
    print("SKIPPED: jsonschema is not installed")
    sys.exit(77)

CONFIG = Path(__file__).resolve().parents[2] / "config"


class Schema(unittest.TestCase):
    def setUp(self):
        text = subprocess.run([os.environ["LIGAMENT"], "schema"], check=True, capture_output=True, text=True).stdout
        self.schema = json.loads(text)
        self.validator = jsonschema.validators.validator_for(self.schema)(self.schema)

    def test_the_schema_is_one(self):
        self.validator.check_schema(self.schema)

    def test_cases(self):
        paths = sorted(CONFIG.glob("*.toml"))
        self.assertTrue(paths)
        for path in paths:
            with self.subTest(case=path.name):
                self.validator.validate(tomllib.loads(path.read_text()))

    def test_wrong_cases(self):
        good = (CONFIG / "column_fem.toml").read_text()
        for right, wrong in (
            ("young_modulus", "young_moduls"),
            ('"20 GPa"', "20e9"),
            ('law = "linear_elastic"', 'law = "rubber"'),
            ("max_steps = 20000", "max_steps = -1"),
            ("[output]", "[outptu]"),
        ):
            with self.subTest(wrong=wrong):
                self.assertIn(right, good)
                self.assertFalse(self.validator.is_valid(tomllib.loads(good.replace(right, wrong))))


if __name__ == "__main__":
    unittest.main()
