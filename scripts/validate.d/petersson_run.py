"""A run of Petersson's beam, and what is read from it."""
from petersson_targets import STIFFNESS_FROM, STIFFNESS_TO
from validation import run_case

LIGAMENT_AREA = 0.1 * 0.05  # m², above the notch


def load_at(rows, deflection):
    """The load at a deflection before the peak, linear between the rows."""
    for before, after in zip(rows, rows[1:]):
        if before["deflection_m"] <= deflection <= after["deflection_m"]:
            share = (deflection - before["deflection_m"]) / (after["deflection_m"] - before["deflection_m"])
            return before["load_N"] + share * (after["load_N"] - before["load_N"])
    raise ValueError(f"the run does not reach a deflection of {deflection} m")


def largest_imbalance(rows):
    """The largest difference of the platen's force from the supports', over the largest load up to then."""
    peak = largest = 0.0
    for row in rows[1:]:
        peak = max(peak, row["load_N"])
        largest = max(largest, abs(row["load_N"] - row["support_reaction_N"]) / peak)
    return largest


class Beam:
    """A run of config/petersson_beam.toml, or of another case of the same beam."""

    def __init__(self, folder, seed, overrides=(), case="petersson_beam"):
        self.run = run_case(folder, case, (f"generation.seed={seed}", *overrides))
        self.seed = seed
        self.summary = self.run.summary
        self.rows = self.run.rows("history")
        top = max(self.rows, key=lambda row: row["load_N"])
        self.peak = top["load_N"]
        self.deflection_at_peak = top["deflection_m"]
        rise = load_at(self.rows, STIFFNESS_TO) - load_at(self.rows, STIFFNESS_FROM)
        self.stiffness = rise / (STIFFNESS_TO - STIFFNESS_FROM) * 1e-6
        """Tangent (kN/mm)."""
        self.imbalance = largest_imbalance(self.rows)
        self.ledger = self.run.rows("energy")[-1]
        self.work = self.ledger["prescribed_motions_J"]
        self.work_over_ligament = self.work / LIGAMENT_AREA
        """Work up to the end (J/m²)."""
        self.is_followed = self.summary["ended"] == "completed" and self.rows[-1]["load_N"] <= 0.2 * self.peak
        """Whether the curve was followed down to a fifth of the peak."""

    def share_of_work(self, name):
        return self.ledger[f"{name}_J"] / self.work
