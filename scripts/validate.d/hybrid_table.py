"""The hybrid beam and the beam of particles side by side."""
import re

from validation import table


def n_nodes(run):
    """As the banner of the run counts them."""
    return int(re.search(r"(\d+) nodes", (run.output / "run.log").read_text()).group(1))


def comparison_section(seed, hybrid, particles):
    def row(label, form, value):
        one, other = value(hybrid), value(particles)
        return [label, form.format(one), form.format(other), f"{other / one:.3g}" if one else ""]

    def freedoms(beam):
        return 3 * beam.summary["n_particles"] + 2 * n_nodes(beam.run)

    rows = [
        row("particles", "{}", lambda beam: beam.summary["n_particles"]),
        row("contacts between particles", "{}", lambda beam: beam.summary["n_contacts"]),
        row("elements", "{}", lambda beam: beam.summary["n_elements"]),
        row("degrees of freedom (3 a particle, 2 a node)", "{}", freedoms),
        row("increments of loading", "{}", lambda beam: beam.summary["steps"]),
        row("evaluations of the forces", "{}", lambda beam: beam.summary["n_evaluations"]),
        row("seconds of the processor (user), packing included", "{:.1f}", lambda beam: beam.run.user),
        row("peak memory of the process (MB)", "{:.0f}", lambda beam: beam.run.memory),
        row("elastic stiffness, 0.05 to 0.10 mm (kN/mm)", "{:.3f}", lambda beam: beam.stiffness),
        row("peak load (N)", "{:.1f}", lambda beam: beam.peak),
        row("deflection at the peak (mm)", "{:.3f}", lambda beam: beam.deflection_at_peak * 1e3),
        row("work to the end (mJ)", "{:.1f}", lambda beam: beam.work * 1e3),
        row("broken bonds", "{}", lambda beam: beam.summary["n_broken"]),
        row("ledger error", "{:.1e}", lambda beam: beam.summary["energy_error"]),
        row("load at the end over the peak", "{:.3f}", lambda beam: beam.rows[-1]["load_N"] / beam.peak),
    ]
    return [f"## Seed {seed}", ""] + table(["", "hybrid", "particles alone", "ratio"], rows)
