"""The beam with four assemblies: every number beside its target."""
from beam_crack import n_broken_by_motion
from petersson_targets import (BALANCE_TOLERANCE, CONTACTS_PER_PARTICLE_TOLERANCE, EDGE_CONTACT_TOLERANCE, GOAL_OF_TIME,
                               HIGHEST_PEAK, LEDGER_TOLERANCE, LONGEST_TIME, LOWEST_PEAK, N_CONTACTS, N_EDGE_CONTACTS,
                               N_PARTICLES, PARTICLE_TOLERANCE, STIFFNESS, STIFFNESS_TOLERANCE)
from seed_rows import row_below, row_of_all, row_within
from validation import mean, table

BEAM = "Petersson"


def count_rows(beams, verdicts):
    particles = [beam.summary["n_particles"] for beam in beams]
    contacts = [beam.summary["n_contacts"] for beam in beams]
    edges = [beam.summary["n_edge_contacts"] for beam in beams]
    yield row_within(BEAM, "particles", particles, N_PARTICLES, PARTICLE_TOLERANCE, verdicts)
    yield row_of_all("contacts without those cut by the notch", contacts, "{:.0f}", f"paper {N_CONTACTS}", "")
    yield row_within(BEAM, "contacts a particle", [c / p for c, p in zip(contacts, particles)], N_CONTACTS / N_PARTICLES,
                     CONTACTS_PER_PARTICLE_TOLERANCE, verdicts)
    yield row_within(BEAM, "contacts with elements", edges, N_EDGE_CONTACTS, EDGE_CONTACT_TOLERANCE, verdicts)


def strength_rows(beams, verdicts):
    stiffness = [beam.stiffness for beam in beams]
    by = mean(stiffness) / STIFFNESS - 1.0
    yield row_of_all("stiffness (kN/mm)", stiffness, "{:.3f}", f"mean {STIFFNESS} ± {STIFFNESS_TOLERANCE:.0%}",
                     verdicts.of(abs(by) <= STIFFNESS_TOLERANCE, f"Petersson: stiffness ({by:+.1%})"))
    peaks = [beam.peak for beam in beams]
    yield row_of_all("peak load (N)", peaks, "{:.1f}", f"mean {LOWEST_PEAK:.0f} to {HIGHEST_PEAK:.0f}",
                     verdicts.of(LOWEST_PEAK <= mean(peaks) <= HIGHEST_PEAK, f"Petersson: peak ({mean(peaks):.0f} N)"))
    yield row_of_all("deflection at the peak (mm)", [beam.deflection_at_peak * 1e3 for beam in beams], "{:.3f}", "", "")
    yield row_of_all("load at the end over the peak", [beam.rows[-1]["load_N"] / beam.peak for beam in beams], "{:.3f}",
                     "≤ 0.2, each", verdicts.of(all(beam.is_followed for beam in beams), "Petersson: softening"))
    yield row_of_all("deflection at the end (mm)", [beam.rows[-1]["deflection_m"] * 1e3 for beam in beams], "{:.3f}", "", "")


def fracture_rows(beams):
    broken = [n_broken_by_motion(beam.run) for beam in beams]
    yield row_of_all("broken bonds", [beam.summary["n_broken"] for beam in beams], "{:.0f}", "", "")
    yield row_of_all("— that opened more than they slid", [opened for opened, _ in broken], "{:.0f}", "", "")
    yield row_of_all("— that slid more than they opened", [slid for _, slid in broken], "{:.0f}", "", "")
    yield row_of_all("work to the end (mJ)", [beam.work * 1e3 for beam in beams], "{:.1f}", "", "")
    yield row_of_all("work over the ligament (N/m)", [beam.work_over_ligament for beam in beams], "{:.1f}", "", "")
    for label, name in (("spent in tension", "fracture_tension"), ("spent in shear", "fracture_shear"),
                        ("spent in friction", "friction"), ("set free at jumps", "released")):
        yield row_of_all(f"— of the work, {label}", [beam.share_of_work(name) for beam in beams], "{:.1%}", "", "")


def run_rows(beams, verdicts):
    yield row_below(BEAM, "ledger error", [beam.summary["energy_error"] for beam in beams], LEDGER_TOLERANCE, "{:.1e}", verdicts)
    yield row_below(BEAM, "platen less supports, over the peak so far", [beam.imbalance for beam in beams], BALANCE_TOLERANCE,
                    "{:.2%}", verdicts)
    yield row_of_all("increments", [beam.summary["steps"] for beam in beams], "{:.0f}", "", "")
    yield row_of_all("evaluations of the forces", [beam.summary["n_evaluations"] for beam in beams], "{:.0f}", "", "")
    yield row_of_all("seconds on the processor", [beam.run.processor for beam in beams], "{:.1f}", "", "")
    times = [beam.run.wall for beam in beams]
    row = row_below(BEAM, "seconds, packing included", times, LONGEST_TIME, "{:.1f}", verdicts)
    row[-1] += f"; goal {GOAL_OF_TIME:.0f} s: " + ("met" if max(times) <= GOAL_OF_TIME else "not met")
    yield row


def seeds_section(beams, verdicts):
    rows = [*count_rows(beams, verdicts), *strength_rows(beams, verdicts), *fracture_rows(beams), *run_rows(beams, verdicts)]
    lines = ["## Four assemblies", "",
             "`config/petersson_beam.toml` with `generation.seed` 1 to 4. The stiffness is the tangent of load over "
             "deflection between 0.05 and 0.10 mm, against finite elements with a sharp notch. Broken bonds are told apart "
             "by how their contacts stand at the end. *Set free at jumps* is what the ledger calls released: the energy that "
             "relaxation takes out between one equilibrium and the next. Times are those of one core.", ""]
    return lines + table(["", *(f"seed {beam.seed}" for beam in beams), "mean", "target", ""], rows)
