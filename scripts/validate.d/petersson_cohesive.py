"""The peaks of the beam beside the cohesive solution for what the same concrete shows in tension."""
import csv

from tension_test import TensionTest
from validation import PAGES, mean, table


def read_peaks():
    """Peak load (N) by macroscopic strength (MPa) and fracture energy (N/m)."""
    with open(PAGES / "data" / "cohesive_peaks.csv", newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {(float(row["tensile_strength_MPa"]), float(row["fracture_energy_N_per_m"])): float(row["peak_load_N"])
                for row in rows if row["beam"] == "petersson"}


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


def cohesive_section(folder, beams):
    peaks = read_peaks()
    tests = [TensionTest(folder, 4, beam.seed) for beam in beams]
    cohesive = [cohesive_peak(peaks, test.strength, test.energy_below_curve) for test in tests]
    rows = [[f"{beam.seed}", f"{test.strength:.2f}", f"{test.energy_below_curve:.1f}", f"{peak:.0f}", f"{beam.peak:.0f}",
             f"{beam.peak / peak - 1.0:+.1%}"] for beam, test, peak in zip(beams, tests, cohesive)]
    means = [mean(values) for values in ([test.strength for test in tests], [test.energy_below_curve for test in tests],
                                         cohesive, [beam.peak for beam in beams])]
    rows.append(["mean", f"{means[0]:.2f}", f"{means[1]:.1f}", f"{means[2]:.0f}", f"{means[3]:.0f}",
                 f"{means[3] / means[2] - 1.0:+.1%}"])
    lines = ["## Beside the cohesive solution for the same concrete", "",
             "Strength and fracture energy of specimens of 100 × 200 mm of this concrete in their own tension tests "
             "([concrete](concrete.md)), and the peak that the cohesive-crack model (Rokugo's softening, sharp notch) has "
             "for these two, interpolated in [a table](data/README.md). There is no target. One reason for "
             "a difference: a tension specimen chooses its weakest section, the notch forces one on the beam.", ""]
    return lines + table(["seed", "tension: strength (MPa)", "fracture energy (N/m)", "cohesive peak (N)",
                          "peak of the beam (N)", "difference"], rows)
