"""The beam driven by its actuator, with a step of its own kind to equilibrium, and with a stiffer steel beam."""
from arrea_curves import beam_curve, load_picture
from arrea_run import run_beam
from arrea_targets import CONTROL_TOLERANCE, LEDGER_TOLERANCE, SEEDS, STEEL_TOLERANCE
from validation import plot, table

STIFFER_STEEL = "material.steel.young_modulus=2100 GPa"


def row_of(label, beam, other_peak):
    return [f"{beam.seed}", label, f"{beam.peak * 1e-3:.1f}", f"{beam.peak / other_peak - 1.0:+.2%}",
            f"{beam.sliding_at_peak * 1e6:.1f}", f"{beam.deflection_at_peak * 1e6:.1f}", f"{beam.summary['n_broken']}",
            f"{beam.summary['n_evaluations']}", f"{beam.run.processor:.0f}",
            f"{beam.summary['energy_error']:.1e}"]


def verdict_on(label, beam, other_peak, tolerance, verdicts):
    change = beam.peak / other_peak - 1.0
    return verdicts.of(abs(change) <= tolerance, f"Arrea and Ingraffea, seed {beam.seed}, {label}: peak ({change:+.2%})")


def ledger_verdict(label, beam, verdicts):
    error = beam.summary["energy_error"]
    return verdicts.of(error <= LEDGER_TOLERANCE, f"Arrea and Ingraffea, seed {beam.seed}, {label}: ledger ({error:.1e})")


def control_section(folder, beams, verdicts):
    rows, pushed = [], []
    for beam in beams:
        by_actuator = run_beam(folder, "arrea_beam", beam.seed)
        pushed.append(by_actuator)
        verdict = verdict_on("actuator", by_actuator, beam.peak, CONTROL_TOLERANCE, verdicts)
        ledger = ledger_verdict("actuator", by_actuator, verdicts)
        rows.append([*row_of("mouth by 1 μm, secants", beam, beam.peak), ""])
        rows.append([*row_of("actuator by 4 μm, momenta", by_actuator, beam.peak), f"peak: {verdict}, ledger: {ledger}"])
    stiffer = run_beam(folder, "arrea_beam_cmsd", SEEDS[0], (STIFFER_STEEL,))
    verdict = verdict_on("steel, mouth", stiffer, beams[0].peak, STEEL_TOLERANCE, verdicts)
    ledger = ledger_verdict("steel, mouth", stiffer, verdicts)
    rows.append([*row_of("mouth by 1 μm, steel ten times stiffer", stiffer, beams[0].peak), f"peak: {verdict}, ledger: {ledger}"])
    stiffer_pushed = run_beam(folder, "arrea_beam", SEEDS[0], (STIFFER_STEEL, "stop.drop_to_share=0.5"))
    verdict = verdict_on("steel, actuator", stiffer_pushed, pushed[0].peak, STEEL_TOLERANCE, verdicts)
    rows.append([*row_of("actuator, steel ten times stiffer (change against the actuator's run)", stiffer_pushed, pushed[0].peak),
                 f"peak: {verdict}"])
    lines = ["## The actuator in control, and the steel beam", "",
             "`config/arrea_beam.toml` moves the actuator by 4 μm at a time and finds equilibrium by momenta. Soon after the "
             "peak the beam snaps back, which the actuator cannot follow: the load falls in one increment to what is left of "
             "it. Under control of the sliding the curve goes on. Where the crack itself jumps ahead the sliding has to "
             "jump, too. Peaks of the two should agree within "
             f"{CONTROL_TOLERANCE:.0%}; ten times the stiffness of the steel beam should change the peak by less than "
             f"{STEEL_TOLERANCE:.0%}. An increment of the actuator is a thirtieth of the peak, coarse for a percent of it.", "",
             "What the ledger lacks under the actuator is of that one increment: it takes bodies straight to where they come "
             "to lie; where they turn far, openings and slips go there in curves, while the law takes each bond straight. "
             "Sixteen times as many intervals of the integral change nothing.", ""]
    lines += table(["seed", "", "peak of P (kN)", "change", "CMSD at the peak (μm)", "deflection (μm)", "broken",
                    "evaluations", "s", "ledger error", ""], rows)
    parts = [beam_curve(folder, beams[0], "deflection", "#c0392b", "seed 1, mouth by 1 μm", "mouth"),
             beam_curve(folder, pushed[0], "deflection", "#2060a0", "seed 1, actuator by 4 μm", "actuator"),
             beam_curve(folder, stiffer, "deflection", "#27864f", "seed 1, mouth by 1 μm, steel ten times stiffer", "stiffer")]
    return lines + plot(load_picture(parts, "deflection", 0.2), "arrea_control",
                        "P over deflection of the actuator's point under either control")
