"""The uniaxial compression test of a specimen of concrete, and what is read from it."""
from validation import run_case

AREA = 0.2 * 0.1  # m², cross-section of the specimen
MPA = 1e-6


class CompressionTest:
    """A run of config/uniaxial_compression_tableN.toml."""

    def __init__(self, folder, number, seed, overrides=()):
        self.run = run_case(folder, f"uniaxial_compression_table{number}", (f"generation.seed={seed}", *overrides))
        self.seed = seed
        self.summary = self.run.summary
        self.rows = self.run.rows("history")
        top = max(self.rows, key=lambda row: row["load_N"])
        self.strength = self.run.results["strength_Pa"] * MPA
        """Peak load over the cross-section (MPa)."""
        self.shortening_at_peak = top["shortening_m"]
        self.load_after_failure = self.rows[-1]["load_N"] / top["load_N"]
        """Load of the last row, over the peak."""
        ledger = self.run.rows("energy")[-1]
        self.released_share = ledger["released_J"] / ledger["prescribed_motions_J"]
