"""How the peak depends on the increment and on the criterion of equilibrium."""
from petersson_run import Beam
from petersson_targets import PEAK_CHANGE_TOLERANCE
from validation import table

SEEDS = (1, 2)
VARIANTS = (  # label, overrides, whether the peak may not change
    ("increment 1.5 μm, half of the case's", ('solver.increment="1.5 um"',), True),
    ("criterion of equilibrium a quarter", ("solver.unbalanced_force_ratio=1.25e-3", "solver.force_mismatch=2.5e-4"), True),
    ("increment 1 μm", ('solver.increment="1 um"',), False),
    ("increment 6 μm", ('solver.increment="6 um"',), False),
)


def variant_row(label, beam, of_case, verdict):
    change = beam.peak / of_case.peak - 1.0
    return [f"{beam.seed}", label, f"{beam.peak:.1f}", f"{change:+.2%}", f"{beam.deflection_at_peak * 1e3:.3f}",
            f"{beam.work * 1e3:.1f}", f"{beam.share_of_work('released'):.1%}", f"{beam.summary['energy_error']:.1e}",
            f"{beam.summary['n_broken']}", f"{beam.summary['n_evaluations']}", f"{beam.run.wall:.1f}", verdict(change)]


def increments_section(folder, beams, verdicts):
    rows = []
    for of_case in (beam for beam in beams if beam.seed in SEEDS):
        rows.append(variant_row("the case, 3 μm", of_case, of_case, lambda _: ""))
        for label, overrides, is_asked in VARIANTS:
            def verdict(change):
                if not is_asked:
                    return "for information"
                return verdicts.of(abs(change) < PEAK_CHANGE_TOLERANCE, f"Petersson, seed {of_case.seed}: {label} "
                                   f"({change:+.2%})")
            rows.append(variant_row(label, Beam(folder, of_case.seed, overrides), of_case, verdict))
    lines = ["## Increment and criterion of equilibrium", "",
             f"The peak should change by less than {PEAK_CHANGE_TOLERANCE:.0%}.", ""]
    return lines + table(["seed", "", "peak (N)", "change", "at (mm)", "work (mJ)", "set free", "ledger error",
                          "broken", "evaluations", "s", ""], rows)
