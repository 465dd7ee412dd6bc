"""The peaks of the beam in mixed mode beside the cohesive solution for what the same concrete shows in tension."""
from cohesive_peaks import cohesive_table


def cohesive_section(folder, beams):
    lines = ["## Beside the cohesive solution for the same concrete", "",
             "Strength and fracture energy of specimens of 100 × 200 mm of this concrete in their own tension tests "
             "([concrete](concrete.md)), and the peak of P that the cohesive-crack model (Rokugo's softening, sharp notch) has "
             "for these two, interpolated in [a table](data/README.md), or on from its border. There is no target.", ""]
    return lines + cohesive_table(folder, "arrea", 5, beams, 1e3, "{:.1f}")
