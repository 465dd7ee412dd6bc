"""Peaks of the cohesive-crack model over strength and fracture energy, and beams beside them."""
import csv

from tension_test import TensionTest
from validation import PAGES, mean, table


def read_peaks(beam):
    """Peak load (N) of a beam by macroscopic strength (MPa) and fracture energy (N/m)."""
    with open(PAGES / "data" / "cohesive_peaks.csv", newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {(float(row["tensile_strength_MPa"]), float(row["fracture_energy_N_per_m"])): float(row["peak_load_N"])
                for row in rows if row["beam"] == beam}


def interval(values, value):
    """The neighbours between which a value lies, or the outermost two of its side; and its place between them."""
    values = sorted(values)
    upper = next((i for i, v in enumerate(values) if v >= value), len(values) - 1)
    low, high = values[max(upper, 1) - 1], values[max(upper, 1)]
    return low, high, (value - low) / (high - low)


def cohesive_peak(peaks, strength, energy):
    """Bilinear in the grid, and linear on from its border."""
    low_s, high_s, s = interval({key[0] for key in peaks}, strength)
    low_e, high_e, e = interval({key[1] for key in peaks}, energy)
    return ((1 - s) * ((1 - e) * peaks[low_s, low_e] + e * peaks[low_s, high_e])
            + s * ((1 - e) * peaks[high_s, low_e] + e * peaks[high_s, high_e]))


def cohesive_table(folder, name, number, beams, unit, form):
    """The beams `name` beside the cohesive peaks for what the concrete of Table `number` shows in its own tension tests;
    loads in `unit` (N)."""
    peaks = read_peaks(name)
    tests = [TensionTest(folder, number, beam.seed) for beam in beams]
    cohesive = [cohesive_peak(peaks, test.strength, test.energy_below_curve) / unit for test in tests]
    of_beams = [beam.peak / unit for beam in beams]
    columns = [[test.strength for test in tests], [test.energy_below_curve for test in tests], cohesive, of_beams]
    labels = [f"{beam.seed}" for beam in beams] + ["mean"]
    rows = [[label, f"{strength:.2f}", f"{energy:.1f}", form.format(peak), form.format(of_beam), f"{of_beam / peak - 1.0:+.1%}"]
            for label, strength, energy, peak, of_beam in zip(labels, *([*values, mean(values)] for values in columns))]
    name_of_unit = {1.0: "N", 1e3: "kN"}[unit]
    return table(["seed", "tension: strength (MPa)", "fracture energy (N/m)", f"cohesive peak ({name_of_unit})",
                  f"peak of the beam ({name_of_unit})", "difference"], rows)
