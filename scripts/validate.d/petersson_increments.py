"""How the peak depends on the increment and on the criterion of equilibrium."""
from petersson_run import Beam
from petersson_targets import LEDGER_TOLERANCE, PEAK_CHANGE_TOLERANCE
from validation import table

SEEDS = (1, 2)
MOMENTA = "solver.method=quasi_static"
USUAL_CRITERION = {"secants": (5e-3, 1e-3), "momenta": (1.25e-3, 2.5e-4)}  # unbalanced force ratio, force mismatch


def criterion(method, share):
    """This share of what a method asks of an equilibrium."""
    ratio, mismatch = USUAL_CRITERION[method]
    return f"solver.unbalanced_force_ratio={share * ratio:g}", f"solver.force_mismatch={share * mismatch:g}"


def variants(method):
    """Label, overrides, whether the peak may not change."""
    yield "increment 1.5 μm, half of the case's", ('solver.increment="1.5 um"',), True
    yield "criterion of equilibrium a quarter", criterion(method, 1 / 4), True
    yield "criterion of equilibrium a sixteenth", criterion(method, 1 / 16), False
    yield "increment 1 μm", ('solver.increment="1 um"',), False
    yield "increment 6 μm", ('solver.increment="6 um"',), False


def verdict_on(label, beam, usual, is_asked, verdicts):
    """The change of the peak, where it is asked for; the ledger must be right in every run."""
    change, error = beam.peak / usual.peak - 1.0, beam.summary["energy_error"]
    what = f"Petersson, seed {beam.seed}, {label}"
    ledger = verdicts.of(error <= LEDGER_TOLERANCE, f"{what}: ledger ({error:.1e})")
    peak = verdicts.of(abs(change) < PEAK_CHANGE_TOLERANCE, f"{what}: peak ({change:+.2%})") if is_asked else "not asked"
    return f"peak: {peak}, ledger: {ledger}"


def variant_row(label, beam, usual, verdict):
    change = beam.peak / usual.peak - 1.0
    return [f"{beam.seed}", label, f"{beam.peak:.1f}", f"{change:+.2%}", f"{beam.deflection_at_peak * 1e3:.3f}",
            f"{beam.work * 1e3:.1f}", f"{beam.share_of_work('released'):.1%}", f"{beam.summary['energy_error']:.1e}",
            f"{beam.summary['n_broken']}", f"{beam.summary['n_evaluations']}", f"{beam.run.wall:.1f}", verdict]


def variant_rows(folder, method, usual, overrides, verdicts):
    """The usual run with a method, and its variants beside it."""
    yield variant_row(f"{method}, 3 μm as in the case", usual, usual, "")
    for what, more, is_asked in variants(method):
        label = f"{method}, {what}"
        beam = Beam(folder, usual.seed, (*overrides, *more))
        yield variant_row(label, beam, usual, verdict_on(label, beam, usual, is_asked, verdicts))


def increments_section(folder, beams, verdicts):
    rows = []
    for of_case in (beam for beam in beams if beam.seed in SEEDS):
        rows += variant_rows(folder, "secants", of_case, (), verdicts)
        rows += variant_rows(folder, "momenta", Beam(folder, of_case.seed, (MOMENTA,)), (MOMENTA,), verdicts)
    lines = ["## Increment and criterion of equilibrium", "",
             f"With half the increment, and with a quarter of the unbalanced forces, the peak should change by less than "
             f"{PEAK_CHANGE_TOLERANCE:.0%}; the others are for information. Changes are against the run of the same method, "
             "the direct search of the case or the momenta of `method = \"quasi_static\"`, with the increment and the "
             f"criterion of the case. The ledger has its target of {LEDGER_TOLERANCE:.0e} in every run.", ""]
    return lines + table(["seed", "", "peak (N)", "change", "at (mm)", "work (mJ)", "set free", "ledger error",
                          "broken", "evaluations", "s", ""], rows)
