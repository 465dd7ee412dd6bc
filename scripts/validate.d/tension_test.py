"""The uniaxial tension test of a specimen of concrete, and what is read from it."""
from validation import run_case

AREA = 0.1 * 0.1  # m², cross-section of the specimen and of its ligament
MPA = 1e-6


def area_below(rows, x, y):
    """The integral of one column over another, by trapezoids."""
    return sum(0.5 * (after[y] + before[y]) * (after[x] - before[x]) for before, after in zip(rows, rows[1:]))


class TensionTest:
    """A run of config/uniaxial_tension_tableN.toml: strength, and fracture energy told in two ways."""

    def __init__(self, folder, number, seed):
        self.run = run_case(folder, f"uniaxial_tension_table{number}", (f"generation.seed={seed}",))
        self.seed = seed
        self.rows = self.run.rows("history")
        self.strength = self.run.summary["peak_load_N"] / AREA * MPA
        """Peak load over the cross-section (MPa)."""
        self.energy_below_curve = area_below(self.rows, "elongation_m", "load_N") / AREA
        """Area below load over elongation up to the stop, over the ligament (N/m)."""
        ledger = self.run.rows("energy")[-1]
        dissipated = sum(ledger[f"{name}_J"] for name in ("fracture_tension", "fracture_shear", "friction"))
        self.energy_dissipated = dissipated / AREA
        """Dissipated in bonds and by friction up to the stop, over the ligament (N/m)."""
        self.released_share = ledger["released_J"] / ledger["prescribed_motions_J"]
