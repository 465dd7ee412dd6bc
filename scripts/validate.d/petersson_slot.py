"""The stiffness of the beam with a slit of 10 mm."""
from petersson_run import Beam
from validation import mean, table

SEEDS = range(1, 5)
# Finite elements with a slit of 10 mm, E = 30 GPa.
STIFFNESS, STIFFNESS_TOLERANCE = 2.83, 0.04  # kN/mm


def slot_section(folder, verdicts):
    beams = [Beam(folder, seed, case="petersson_beam_slot") for seed in SEEDS]
    stiffness = mean(beam.stiffness for beam in beams)
    by = stiffness / STIFFNESS - 1.0
    verdict = verdicts.of(abs(by) <= STIFFNESS_TOLERANCE, f"Petersson with a slit: stiffness ({by:+.1%})")
    rows = [[f"{beam.seed}", f"{beam.summary['n_particles']}", f"{beam.stiffness:.3f}", f"{beam.stiffness / STIFFNESS - 1.0:+.1%}",
             f"{beam.peak:.1f}", f"{beam.deflection_at_peak * 1e3:.3f}", f"{beam.summary['n_broken']}",
             f"{beam.summary['energy_error']:.1e}", ""] for beam in beams]
    rows.append(["mean", "", f"{stiffness:.3f}", f"{by:+.1%}", f"{mean(beam.peak for beam in beams):.1f}",
                 f"{mean(beam.deflection_at_peak for beam in beams) * 1e3:.3f}", "", "", verdict])
    lines = ["## With a slit of 10 mm", "",
             f"`config/petersson_beam_slot.toml`: particles in a slit of 10 mm are taken away instead of bonds cut. Finite "
             f"elements have a tangent stiffness of {STIFFNESS} kN/mm; the mean should lie within "
             f"{STIFFNESS_TOLERANCE:.0%} of it (between deflections of 0.05 and 0.10 mm). No target for the peak.", ""]
    return lines + table(["seed", "particles", "stiffness (kN/mm)", "difference", "peak load (N)", "at (mm)", "broken bonds",
                          "ledger error", ""], rows)
