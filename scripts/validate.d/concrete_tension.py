"""Uniaxial tension with the micro-parameters of Tables 4 and 5."""
from concrete_targets import LEDGER_TOLERANCE, SEEDS, STRENGTH_TOLERANCE, TENSION
from tension_test import AREA, TensionTest
from validation import mean, plot, table

COLOURS = ("#c0392b", "#2060a0", "#27864f")


def test_row(number, test, verdicts):
    summary = test.run.summary
    sound = verdicts.of(summary["ended"] == "completed" and summary["energy_error"] <= LEDGER_TOLERANCE,
                        f"tension of Table {number}, seed {test.seed}: ledger ({summary['energy_error']:.1e})")
    return [f"Table {number}, seed {test.seed}", f"{test.strength:.2f}", f"{test.energy_below_curve:.1f}",
            f"{test.energy_dissipated:.1f}", f"{test.released_share:.0%}", f"{test.rows[-1]['elongation_m'] * 1e6:.1f}",
            f"{summary['n_broken']}", f"{summary['n_evaluations']}", f"{test.run.wall:.1f}",
            f"{summary['energy_error']:.1e}, {sound}"]


def strength_row(number, tests, verdicts):
    target = TENSION[number]
    strength = mean(test.strength for test in tests)
    by = strength / target["strength"] - 1.0
    tolerance = STRENGTH_TOLERANCE.get(number)
    met = "for information" if tolerance is None else (
        f"mean ± {tolerance:.0%}: " + verdicts.of(abs(by) <= tolerance, f"Table {number}: tensile strength ({by:+.1%})"))
    return [f"Table {number}", f"{target['strength']}", f"{strength:.2f}", f"{by:+.1%}", met, target["energy"],
            f"{mean(test.energy_below_curve for test in tests):.1f}",
            f"{mean(test.energy_dissipated for test in tests):.1f}", target["check"]]


def drawn(folder, number, tests):
    parts = []
    for test, colour in zip(tests, COLOURS):
        path = folder / f"tension_{number}_{test.seed}.dat"
        path.write_text("".join(f"{row['elongation_m'] * 1e6!r} {row['load_N'] / AREA * 1e-6!r}\n" for row in test.rows))
        parts.append(f"'{path}' with linespoints pt 7 ps 0.4 lw 1.6 lc rgb '{colour}' title 'seed {test.seed}'")
    script = f"""
set key top right
set grid
set yrange [0:4.5]
set xlabel 'elongation of 200 mm (μm)'
set ylabel 'load over the cross-section (MPa)'
plot {", ".join(parts)}, {TENSION[number]["strength"]} with lines dt 2 lc rgb '#404040' title 'strength in the paper'
"""
    return plot(script, f"concrete_tension_table{number}", f"Uniaxial tension, Table {number}")


def tension_section(folder, verdicts):
    tests = {number: [TensionTest(folder, number, seed) for seed in SEEDS] for number in TENSION}
    lines = ["## Uniaxial tension", "",
             "`config/uniaxial_tension_table4.toml` and `…table5.toml`: specimens 100 mm wide, 200 mm high, 100 mm thick; "
             "the particles at the end walls are held along the walls' normal and free along them; the upper wall moves by "
             "0.5 μm at a time. Strength is the peak load over the cross-section. Fracture energy is told in two ways, both "
             "over the area of the ligament and up to the stop, where the load has fallen to a tenth of its peak: the area "
             "below load over elongation, and what bonds and friction have dissipated. They differ by the energy set free "
             "where the specimen snaps back, as it does when the crack runs through under a prescribed elongation, and by "
             "what little strain energy is left.", ""]
    lines += table(["", "paper: strength (MPa)", "got, mean", "deviation", "target", "paper: fracture energy (N/m)",
                    "below the curve", "dissipated", "separate implementation"],
                   [strength_row(number, tests[number], verdicts) for number in TENSION])
    lines += table(["", "strength (MPa)", "below the curve (N/m)", "dissipated (N/m)", "set free", "end at (μm)", "broken",
                    "evaluations", "s", "ledger error"],
                   [test_row(number, test, verdicts) for number in TENSION for test in tests[number]])
    return lines + [line for number in TENSION for line in drawn(folder, number, tests[number])]
