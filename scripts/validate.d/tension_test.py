"""The uniaxial tension test of a specimen of concrete, and what is read from it."""
from validation import run_case

AREA = 0.1 * 0.1  # m², cross-section of the specimen and of its ligament
MPA = 1e-6


class TensionTest:
    """A run of config/uniaxial_tension_tableN.toml: strength, and fracture energy told in two ways."""

    def __init__(self, folder, number, seed):
        self.run = run_case(folder, f"uniaxial_tension_table{number}", (f"generation.seed={seed}",))
        self.seed = seed
        self.rows = self.run.rows("history")
        results = self.run.results
        self.strength = results["strength_Pa"] * MPA
        """Peak load over the cross-section (MPa)."""
        self.energy_below_curve = results["fracture_energy_N_per_m"]
        """Area below load over elongation up to the stop, over the ligament (N/m)."""
        self.energy_dissipated = results["dissipated_energy_N_per_m"]
        """Dissipated in bonds and by friction up to the stop, over the ligament (N/m)."""
        ledger = self.run.rows("energy")[-1]
        self.released_share = ledger["released_J"] / ledger["prescribed_motions_J"]
