"""The peaks of the beam beside the cohesive solution for what the same concrete shows in tension."""
from cohesive_peaks import cohesive_table


def cohesive_section(folder, beams):
    lines = ["## Beside the cohesive solution for the same concrete", "",
             "Strength and fracture energy of specimens of 100 × 200 mm of this concrete in their own tension tests "
             "([concrete](concrete.md)), and the peak that the cohesive-crack model (Rokugo's softening, sharp notch) has "
             "for these two, interpolated in [a table](data/README.md). There is no target. One reason for "
             "a difference: a tension specimen chooses its weakest section, the notch forces one on the beam.", ""]
    return lines + cohesive_table(folder, "petersson", 4, beams, 1.0, "{:.0f}")
