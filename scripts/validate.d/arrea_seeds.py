"""The beam in mixed mode with four assemblies: every number beside its target."""
import math

from arrea_run import reference_slope
from arrea_targets import (BALANCE_TOLERANCE, CONTACTS_PER_PARTICLE_TOLERANCE, EDGE_CONTACT_TOLERANCE, GOAL_OF_TIME,
                           HIGHEST_PEAK, LARGEST_ANGLE, LARGEST_END, LEAST_ANGLE, LEAST_END, LEDGER_TOLERANCE,
                           LONGEST_TIME, LOWEST_PEAK, N_CONTACTS, N_EDGE_CONTACTS, N_PARTICLES, PARTICLE_TOLERANCE,
                           SLOPE_FROM, SLOPE_TO, SLOPE_TOLERANCE)
from beam_crack import n_broken_by_motion
from seed_rows import row_below, row_of_all, row_within
from validation import mean, table

BEAM = "Arrea and Ingraffea"


def count_rows(beams, verdicts):
    particles = [beam.summary["n_particles"] for beam in beams]
    contacts = [beam.summary["n_contacts"] for beam in beams]
    edges = [beam.summary["n_edge_contacts"] for beam in beams]
    yield row_within(BEAM, "particles", particles, N_PARTICLES, PARTICLE_TOLERANCE, verdicts)
    yield row_of_all("contacts without those cut by the notch", contacts, "{:.0f}", f"paper {N_CONTACTS}", "")
    yield row_within(BEAM, "contacts a particle", [c / p for c, p in zip(contacts, particles)],
                     N_CONTACTS / N_PARTICLES, CONTACTS_PER_PARTICLE_TOLERANCE, verdicts)
    yield row_within(BEAM, "contacts with elements", edges, N_EDGE_CONTACTS, EDGE_CONTACT_TOLERANCE, verdicts)


def strength_rows(beams, verdicts):
    slopes, of_reference = [beam.slope for beam in beams], reference_slope()
    by = mean(slopes) / of_reference - 1.0
    yield row_of_all(f"slope of P over CMSD, {SLOPE_FROM:.0%} to {SLOPE_TO:.0%} of the peak (kN/mm)", slopes, "{:.0f}",
                     f"mean {of_reference:.0f} ± {SLOPE_TOLERANCE:.0%}",
                     verdicts.of(abs(by) <= SLOPE_TOLERANCE, f"{BEAM}: slope ({by:+.1%})"))
    peaks = [beam.peak * 1e-3 for beam in beams]
    yield row_of_all("peak of P (kN)", peaks, "{:.1f}", f"mean {LOWEST_PEAK:.0f} to {HIGHEST_PEAK:.0f}",
                     verdicts.of(LOWEST_PEAK <= mean(peaks) <= HIGHEST_PEAK, f"{BEAM}: peak ({mean(peaks):.1f} kN)"))
    yield row_of_all("peak of 1.13 P (kN)", [max(row["total_load_N"] for row in beam.rows) * 1e-3 for beam in beams],
                     "{:.1f}", "", "")
    yield row_of_all("CMSD at the peak (μm)", [beam.sliding_at_peak * 1e6 for beam in beams], "{:.0f}", "", "")
    yield row_of_all("CMSD at the end (μm)", [beam.last_sliding * 1e6 for beam in beams], "{:.0f}", "≥ 140, each",
                     verdicts.of(all(beam.reaches_end for beam in beams), f"{BEAM}: curve to 0.14 mm"))
    yield row_of_all("P at the end over the peak", [beam.rows[-1]["load_N"] / beam.peak for beam in beams], "{:.3f}", "", "")


def crack_rows(beams, verdicts):
    angles = [beam.angle_at_tip() for beam in beams]
    yield row_of_all("direction at the tip of the notch, from the vertical (°)", angles, "{:.0f}",
                     f"{LEAST_ANGLE:.0f} to {LARGEST_ANGLE:.0f}, each",
                     verdicts.of(all(LEAST_ANGLE <= angle <= LARGEST_ANGLE for angle in angles),
                                 f"{BEAM}: direction at the tip (mean {mean(angles):.0f}°)"))
    yield row_of_all("height of the crack at the end (mm)", [beam.height_of_crack() * 1e3 for beam in beams], "{:.0f}", "", "")
    ends = [beam.end_at_top() for beam in beams]
    come = [end for end in ends if not math.isnan(end)]
    yield row_of_all("x of the crack within 30 mm of the top (mm)", [end * 1e3 for end in ends], "{:.0f}",
                     f"about {LEAST_END * 1e3:.0f} to {LARGEST_END * 1e3:.0f}, where it comes there",
                     verdicts.of(come and all(LEAST_END <= end <= LARGEST_END for end in come), f"{BEAM}: end of the crack"))
    yield row_of_all("broken bonds", [beam.summary["n_broken"] for beam in beams], "{:.0f}", "", "")
    shares = [beam.share_of_tensile() for beam in beams]
    yield row_of_all("— whose strength was reached in tension", shares, "{:.0%}", "paper: all", "")
    broken = [n_broken_by_motion(beam.run) for beam in beams]
    yield row_of_all("— that opened more than they slid", [opened / (opened + slid) for opened, slid in broken], "{:.0%}", "", "")
    at_border = [beam.damage_at_border() for beam in beams]
    yield row_of_all("largest damage within 10 mm of the elements", at_border, "{:.2f}", "none, each",
                     verdicts.of(max(at_border) == 0.0, f"{BEAM}: damage near the elements (at most {max(at_border):.2f})"))
    yield row_of_all("farthest broken bond from the notch, |x| (mm)", [beam.farthest_break() * 1e3 for beam in beams], "{:.0f}",
                     "", "")


def run_rows(beams, verdicts):
    yield row_below(BEAM, "ledger error", [beam.summary["energy_error"] for beam in beams], LEDGER_TOLERANCE, "{:.1e}",
                    verdicts)
    yield row_below(BEAM, "actuator less supports, over the peak so far", [beam.imbalance() for beam in beams],
                    BALANCE_TOLERANCE, "{:.2%}", verdicts)
    yield row_of_all("increments", [beam.summary["steps"] for beam in beams], "{:.0f}", "", "")
    yield row_of_all("evaluations", [beam.summary["n_evaluations"] for beam in beams], "{:.0f}", "", "")
    yield row_of_all("factorisations", [beam.summary["n_factorisations"] for beam in beams], "{:.0f}", "", "")
    yield row_of_all("seconds on the processor", [beam.run.processor for beam in beams], "{:.0f}", "", "")
    times = [beam.run.wall for beam in beams]
    row = row_below(BEAM, "seconds, packing included", times, LONGEST_TIME, "{:.0f}", verdicts)
    row[-1] += f"; goal {GOAL_OF_TIME:.0f} s: " + ("met" if max(times) <= GOAL_OF_TIME else "not met")
    yield row


def seeds_section(beams, verdicts):
    rows = [*count_rows(beams, verdicts), *strength_rows(beams, verdicts), *crack_rows(beams, verdicts),
            *run_rows(beams, verdicts)]
    lines = ["## Four assemblies", "",
             "`config/arrea_beam_cmsd.toml` with `generation.seed` 1 to 4: the sliding of the crack mouth (CMSD) grows by a "
             "micrometre at a time, up to 0.14 mm. P is the load of the inner platen, 1.13 P that of the actuator. The "
             "direction at the tip is the mean of those from the tip to the broken bonds within 50 mm of it.", ""]
    return lines + table(["", *(f"seed {beam.seed}" for beam in beams), "mean", "target", ""], rows)
