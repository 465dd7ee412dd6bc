"""Two ways to equilibrium, two controls: momenta and secants, the platen and the opening of the crack mouth."""
from petersson_run import Beam
from petersson_targets import LEDGER_TOLERANCE, PEAK_CHANGE_TOLERANCE
from validation import plot, table

SEEDS = (1, 2)
MOMENTA = "solver.method=quasi_static"


def way_back(rows):
    """How far the platen goes back from the furthest point it has reached (m)."""
    furthest = back = 0.0
    for row in rows:
        furthest = max(furthest, row["deflection_m"])
        back = max(back, furthest - row["deflection_m"])
    return back


def verdict_on(label, beam, of_case, verdicts):
    what = f"Petersson, seed {beam.seed}, {label}"
    change, error = beam.peak / of_case.peak - 1.0, beam.summary["energy_error"]
    peak = verdicts.of(abs(change) <= PEAK_CHANGE_TOLERANCE, f"{what}: peak ({change:+.2%})")
    ledger = verdicts.of(error <= LEDGER_TOLERANCE, f"{what}: ledger ({error:.1e})")
    end = verdicts.of(beam.is_followed, f"{what}: followed to a fifth of the peak")
    return f"peak: {peak}, ledger: {ledger}, to the end: {end}"


def row_of(label, beam, of_case, verdict):
    return [f"{beam.seed}", label, f"{beam.peak:.1f}", f"{beam.peak / of_case.peak - 1.0:+.2%}", f"{beam.stiffness:.3f}",
            f"{beam.work * 1e3:.1f}", f"{beam.share_of_work('released'):.1%}", f"{beam.summary['n_broken']}",
            f"{way_back(beam.rows) * 1e6:.1f}", f"{beam.summary['steps']}", f"{beam.summary['n_evaluations']}",
            f"{beam.summary['n_factorisations']}", f"{beam.run.processor:.1f}", f"{beam.summary['energy_error']:.1e}",
            verdict]


def written(folder, name, beam):
    path = folder / f"{name}.dat"
    path.write_text("".join(f"{row['deflection_m'] * 1e3!r} {row['load_N']!r}\n" for row in beam.rows))
    return path


def picture(folder, curves):
    parts = [f"'{written(folder, f'control_{number}', beam)}' using 1:2 with linespoints ps 0.4 pt {6 + number} lw 1.4 "
             f"lc rgb '{colour}' title '{label}'"
             for number, (label, colour, beam) in enumerate(curves)]
    return f"""
set key top right
set grid
set xrange [0:0.5]
set yrange [0:*]
set xlabel 'deflection (mm)'
set ylabel 'load (N)'
plot {", ".join(parts)}
"""


def control_section(folder, beams, verdicts):
    rows, curves = [], []
    for of_case in (beam for beam in beams if beam.seed in SEEDS):
        by_momenta = Beam(folder, of_case.seed, (MOMENTA,))
        by_opening = Beam(folder, of_case.seed, case="petersson_beam_cmod")
        rows.append(row_of("secants, platen 3 μm", of_case, of_case, ""))
        for label, beam in (("momenta, platen 3 μm", by_momenta), ("secants, mouth 1 μm", by_opening)):
            rows.append(row_of(label, beam, of_case, verdict_on(label, beam, of_case, verdicts)))
        if not curves:
            curves = [("secants, platen by 3 μm", "#27864f", of_case), ("momenta, platen by 3 μm", "#2060a0", by_momenta),
                      ("secants, crack mouth by 1 μm", "#c0392b", by_opening)]
    lines = ["## Other control, other way to equilibrium", "",
             "The case has `method = \"secant\"`, which finds the equilibrium of an increment with a factorised stiffness; "
             "`method = \"quasi_static\"` finds it with momenta. With "
             "`control = \"cmod\"` (`config/petersson_beam_cmod.toml`) the opening of the crack mouth grows by 1 μm at a time, and "
             "the platen goes back where the beam snaps back. *Back* is how far it does. Under control of the platen the "
             "energy of a snap-back is set free at a jump; under that of the crack mouth there is less to set free, so that "
             "the work to the end is smaller by it. Peaks should agree within "
             f"{PEAK_CHANGE_TOLERANCE:.0%}; a ramp of 0.5 nm a step comes to the same (above).", ""]
    lines += table(["seed", "", "peak (N)", "change", "stiffness (kN/mm)", "work (mJ)", "set free", "broken", "back (μm)",
                    "increments", "evaluations", "factorisations", "s, processor", "ledger error", ""], rows)
    return lines + plot(picture(folder, curves), "petersson_control",
                        "Load over deflection of Petersson's beam, seed 1, under either control")
