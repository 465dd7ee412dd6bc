"""A run of the beam of Arrea and Ingraffea, and what is read from it."""
import csv
import math

from arrea_targets import (DEPTH, LAST_SLIDING, LEFT_SUPPORT, NOTCH_DEPTH, OUTER_PLATEN, REFERENCE, SLOPE_FROM, SLOPE_TO,
                           THICKNESS, ZONE_HALF_WIDTH)
from beam_crack import broken_contacts, contacts_of
from validation import PAGES, run_case

TIP_REACH = 50e-3  # m, how far from the tip of the notch the direction of the crack is taken
BORDER = 10e-3  # m, beside the elements
TOP_STRIP = 30e-3  # m, below the top of the beam, where the end of the crack is looked for


def slope_of(sliding, loads):
    """Load over sliding (kN/mm) by least squares between two shares of the peak before it; m and N."""
    top = max(range(len(loads)), key=loads.__getitem__)
    rising = [(s, p) for s, p in zip(sliding[:top], loads[:top]) if SLOPE_FROM * loads[top] <= p <= SLOPE_TO * loads[top]]
    mean_s, mean_p = (sum(values) / len(rising) for values in zip(*rising))
    return (sum((s - mean_s) * (p - mean_p) for s, p in rising) / sum((s - mean_s) ** 2 for s, _ in rising)) * 1e-6


def reference_slope():
    with open(PAGES / "data" / f"{REFERENCE}.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    return slope_of([float(row["cmsd_mm"]) * 1e-3 for row in rows], [float(row["load_N"]) for row in rows])


def middle(one, other):
    return 0.5 * (one[0] + other[0]), 0.5 * (one[1] + other[1])


class MixedBeam:
    """A run of config/arrea_beam.toml or one of its variants."""

    def __init__(self, run, seed):
        self.run, self.seed = run, seed
        self.summary, self.rows = run.summary, run.rows("history")
        top = max(self.rows, key=lambda row: row["load_N"])
        self.peak = top["load_N"]
        self.sliding_at_peak, self.deflection_at_peak = top["cmsd_m"], top["deflection_m"]
        self.slope = slope_of([row["cmsd_m"] for row in self.rows], [row["load_N"] for row in self.rows])
        self.last_sliding = self.rows[-1]["cmsd_m"]
        self.reaches_end = self.last_sliding >= LAST_SLIDING

    def imbalance(self):
        """The largest difference of the actuator's force from the supports', over the largest load up to then."""
        peak = largest = 0.0
        for row in self.rows[1:]:
            peak = max(peak, row["total_load_N"])
            largest = max(largest, abs(row["total_load_N"] - row["support_reaction_N"]) / peak)
        return largest

    def angle_at_tip(self):
        """Mean direction from the tip of the notch to the broken bonds about it, from the vertical (degrees)."""
        right = up = 0.0
        for one, other, _, _ in broken_contacts(self.run):
            x, y = middle(one, other)
            distance = math.hypot(x, y - NOTCH_DEPTH)
            if y > NOTCH_DEPTH and distance <= TIP_REACH:
                right, up = right + x / distance, up + (y - NOTCH_DEPTH) / distance
        return math.degrees(math.atan2(right, up))

    def end_at_top(self):
        """Mean x (m) of the broken bonds in the uppermost strip; nan if the crack does not come there."""
        places = (middle(one, other) for one, other, _, _ in broken_contacts(self.run))
        xs = [x for x, y in places if y > DEPTH - TOP_STRIP]
        return sum(xs) / len(xs) if xs else math.nan

    def breaks_over_left_support(self):
        """Whether the crack that comes to the top does so on the side of the outer platen: in bending."""
        return self.end_at_top() < 0.0

    def bending_stress_over_left_support(self):
        """The largest that beam theory gives for the outer platen's load (Pa)."""
        outer = max(row["total_load_N"] - row["load_N"] for row in self.rows)
        return outer * (LEFT_SUPPORT - OUTER_PLATEN) * 6.0 / (THICKNESS * DEPTH**2)

    def height_of_crack(self):
        """The highest broken bond (m)."""
        return max(middle(one, other)[1] for one, other, _, _ in broken_contacts(self.run))

    def share_of_tensile(self):
        """Broken bonds whose strength was reached in tension, over all."""
        return self.summary["n_broken_tension"] / self.summary["n_broken"]

    def farthest_break(self):
        """The largest |x| (m) of a broken bond."""
        return max(abs(middle(one, other)[0]) for one, other, _, _ in broken_contacts(self.run))

    def damage_at_border(self):
        """The largest damage of a contact between particles near the elements."""
        return max((damage for one, other, _, damage, _, _ in contacts_of(self.run)
                    if abs(middle(one, other)[0]) > ZONE_HALF_WIDTH - BORDER), default=0.0)


def run_beam(folder, case, seed, overrides=()):
    return MixedBeam(run_case(folder, case, (f"generation.seed={seed}", *overrides)), seed)
