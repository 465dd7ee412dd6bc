"""Petersson's beam under a slow ramp, step by step, beside the increments, whose criteria it does not have."""
from petersson_run import largest_imbalance
from petersson_targets import LEDGER_TOLERANCE, PEAK_CHANGE_TOLERANCE
from validation import ROOT, Run, call, table

SEED = 1
LAST_DEFLECTION = 2.7e-4  # m, beyond the peak
RAMPS = ((0.5, 20000, True), (5.0, 2000, True), (20.0, 500, False))
"""Velocity of the platen (nm a step), time of its rise (s), whether the peak is asked."""


def replaced(text, old, new):
    """The case with a part that it must have exchanged."""
    if text.count(old) != 1:
        raise ValueError(f"config/petersson_beam.toml does not have {old!r} once")
    return text.replace(old, new)


def ramp_case(velocity, rise_time):
    """The beam with a platen that moves on and on; stepped, not relaxed."""
    text = (ROOT / "config" / "petersson_beam.toml").read_text()
    text = replaced(text, 'displacement = "-1.2 mm"\nstop_time = "1 s"',
                    f'velocity = "-{velocity} nm/s"\nrise_time = "{rise_time} s"')
    text = replaced(text, 'method = "secant"\nincrement = "3 um"\nmax_steps = 1000',
                    'method = "two_level_relaxation"\nsmallest_damping = 0.05\nlargest_damping = 0.05\n'
                    "max_steps = 1000000\ncheck_every = 20")
    text = replaced(text, 'gauge = "load"\ndrop_to_share = 0.2', f'gauge = "deflection"\nabove = {LAST_DEFLECTION}')
    text = replaced(text, "[output]\nevery = 1", f"[output]\nevery = {round(400 / velocity)}")
    return replaced(text, "[checkpoint]\nevery = 50", "[checkpoint]\nevery = 200000")


def run_ramp(folder, velocity, rise_time):
    case, output = folder / f"ramp_{velocity:g}.toml", folder / f"ramp_{velocity:g}"
    case.write_text(ramp_case(velocity, rise_time))
    return Run(output, *call(folder, "run", str(case), "--output", str(output), "--set", f"generation.seed={SEED}"))


def ramp_row(velocity, run, of_case, is_asked, verdicts):
    rows = run.rows("history")
    top = max(rows, key=lambda row: row["load_N"])
    change, error = top["load_N"] / of_case.peak - 1.0, run.summary["energy_error"]
    ledger = verdicts.of(error <= LEDGER_TOLERANCE, f"Petersson, ramp of {velocity:g} nm a step: ledger ({error:.1e})")
    peak = verdicts.of(abs(change) < PEAK_CHANGE_TOLERANCE,
                       f"Petersson, ramp of {velocity:g} nm a step: peak ({change:+.2%})") if is_asked else "not asked"
    risen = [row for row in rows if row["load_N"] > 0.5 * top["load_N"] or row is rows[0]]
    return [f"ramp, {velocity:g} nm a step", f"{run.summary['steps']}", f"{top['load_N']:.1f}", f"{change:+.2%}",
            f"{top['deflection_m'] * 1e3:.3f}", f"{largest_imbalance(risen):.1%}", f"{error:.1e}",
            f"{run.processor:.0f}", f"peak: {peak}, ledger: {ledger}"]


def ramp_section(folder, of_case, verdicts):
    """`of_case` is the run of the case in increments with the same seed."""
    rows = [["increments, the case", f"{of_case.summary['n_evaluations']} to its end", f"{of_case.peak:.1f}", "",
             f"{of_case.deflection_at_peak * 1e3:.3f}", f"{of_case.imbalance:.1%}",
             f"{of_case.summary['energy_error']:.1e}", f"{of_case.run.processor:.0f}", ""]]
    for velocity, rise_time, is_asked in RAMPS:
        run = run_ramp(folder, velocity, rise_time)
        rows.append(ramp_row(velocity, run, of_case, is_asked, verdicts))
    lines = ["## A slow ramp beside the increments", "",
             f"Seed {SEED}, with a platen that moves on at a constant velocity to a deflection of {LAST_DEFLECTION * 1e3:g} "
             "mm, past the peak, and masses of two levels with a damping of 0.05. Nothing is relaxed to equilibrium, and "
             "contacts remember every step. A ramp that is slow enough should have the peak of the increments within "
             f"{PEAK_CHANGE_TOLERANCE:.0%}. *Imbalance* is the largest "
             "difference of the platen's force from the supports', over the load up to then, from half of the peak on: what "
             "inertia and damping carry. The last ramp shows what one too fast does.", ""]
    return lines + table(["", "steps, or evaluations", "peak (N)", "change", "at (mm)", "imbalance",
                          "ledger error", "seconds on the processor", ""], rows)
