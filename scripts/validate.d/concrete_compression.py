"""Uniaxial compression with the micro-parameters of Tables 4 and 5."""
from compression_test import AREA, CompressionTest
from concrete_targets import COMPRESSION, LEDGER_TOLERANCE, PEAK_CHANGE_TOLERANCE, SEEDS
from beam_crack import broken_contacts, discs_of, face
from validation import mean, plot, table

COLOURS = ("#c0392b", "#2060a0", "#27864f")
VARIANTS = (  # label, overrides, whether the peak may not change
    ("increment 1 μm, half of the case's", ('solver.increment="1 um"',), True),
    ("criterion of equilibrium a quarter", ("solver.unbalanced_force_ratio=3.125e-4", "solver.force_mismatch=6.25e-5"), True),
    ("contacts live in nearly every increment", ("solver.most_evaluations=10",), False),
)
SEED_OF_VARIANTS = 1


def test_row(name, test, of_case, is_asked, verdicts):
    summary = test.summary
    sound = verdicts.of(summary["energy_error"] <= LEDGER_TOLERANCE,
                        f"compression of {name}: ledger ({summary['energy_error']:.1e})")
    followed = verdicts.of(summary["ended"] == "completed", f"compression of {name}: past its peak")
    change = test.strength / of_case.strength - 1.0
    verdict = verdicts.of(abs(change) < PEAK_CHANGE_TOLERANCE, f"compression of {name}: peak ({change:+.2%})")
    return [name, f"{test.strength:.2f}", "" if test is of_case else f"{change:+.2%}" + (f", {verdict}" if is_asked else ""),
            f"{test.shortening_at_peak * 1e6:.0f}", f"{test.load_after_failure:.2%}, {followed}",
            f"{test.released_share:.0%}", f"{summary['n_broken']}", f"{summary['n_evaluations']}", f"{test.run.wall:.1f}",
            f"{summary['energy_error']:.1e}, {sound}"]


def strength_row(number, tests):
    target = COMPRESSION[number]
    strength = mean(test.strength for test in tests)
    return [f"Table {number}", f"{target['strength']}", f"{strength:.2f}", f"{strength / target['strength'] - 1.0:+.1%}",
            "for information", target["check"]]


def variant_rows(folder, number, of_case, verdicts):
    for label, overrides, is_asked in VARIANTS:
        test = CompressionTest(folder, number, SEED_OF_VARIANTS, overrides)
        yield test_row(f"Table {number}, seed {SEED_OF_VARIANTS}, {label}", test, of_case, is_asked, verdicts)


def curves(folder, number, tests):
    parts = []
    for test, colour in zip(tests, COLOURS):
        path = folder / f"compression_{number}_{test.seed}.dat"
        path.write_text("".join(f"{row['shortening_m'] * 1e6!r} {row['load_N'] / AREA * 1e-6!r}\n" for row in test.rows))
        parts.append(f"'{path}' with linespoints pt 7 ps 0.3 lw 1.6 lc rgb '{colour}' title 'seed {test.seed}'")
    script = f"""
set key top left
set grid
set yrange [0:45]
set xlabel 'shortening of 200 mm (μm)'
set ylabel 'load over the cross-section (MPa)'
plot {", ".join(parts)}, {COMPRESSION[number]["strength"]} with lines dt 2 lc rgb '#404040' title 'strength in the paper'
"""
    return plot(script, f"concrete_compression_table{number}", f"Uniaxial compression, Table {number}")


def cracks(folder, test):
    """The broken bonds of a test at its end, at their places at the start."""
    discs, crack = folder / "crushed_discs.dat", folder / "crushed_cracks.dat"
    radius_of = discs_of(test.run)
    discs.write_text("".join(f"{x!r} {y!r} {radius!r}\n" for (x, y), radius in radius_of.items()))
    faces = (face(one, other, radius_of) for one, other, _, _ in broken_contacts(test.run)
             if one in radius_of and other in radius_of)
    crack.write_text("".join(f"{a[0]!r} {a[1]!r}\n{b[0]!r} {b[1]!r}\n\n" for a, b in faces))
    script = f"""
set terminal pngcairo size 1000,1060 font 'sans,11'
set size ratio -1
set xrange [0:0.2]
set yrange [0:0.2]
set xlabel 'x (m)'
set ylabel 'y (m)'
set key below
set style fill solid 1.0 border lc rgb '#a8a8a8'
plot '{discs}' using 1:2:3 with circles lc rgb '#e8e4dc' notitle, \\
     '{crack}' using 1:2 with lines lw 3 lc rgb '#c0392b' title 'broken bonds'
"""
    return plot(script, "concrete_compression_cracks", f"Broken bonds of Table 4, seed {test.seed}, after its failure")


def compression_section(folder, verdicts):
    tests = {number: [CompressionTest(folder, number, seed) for seed in SEEDS] for number in COMPRESSION}
    lines = ["## Uniaxial compression", "",
             "`config/uniaxial_compression_table4.toml` and `…table5.toml`: specimens of 200 mm × 200 mm, 100 mm thick, "
             "free to slide along the end walls; the upper wall moves by 2 μm at a time. The specimens fail all at once: what they "
             "store at the peak is about twice what cracks and friction take until they have come apart, and the rest is "
             "set free. No increment beyond the peak settles from what contacts remember of it; the one that holds the "
             "failure is relaxed live ([theory](../theory.md#loading-in-increments)), and the next row is the equilibrium "
             "after it. The peak is the last row before.", ""]
    lines += table(["", "paper: strength (MPa)", "got, mean", "deviation", "target", "separate implementation"],
                   [strength_row(number, tests[number]) for number in COMPRESSION])
    rows = [test_row(f"Table {number}, seed {test.seed}", test, test, False, verdicts)
            for number in COMPRESSION for test in tests[number]]
    for number in COMPRESSION:
        rows += variant_rows(folder, number, tests[number][SEED_OF_VARIANTS - 1], verdicts)
    lines += ["Quasi-static enough? With half the increment, and with a quarter of the unbalanced forces, the peak should "
              f"change by less than {PEAK_CHANGE_TOLERANCE:.0%}. In the last variant nearly every increment is relaxed live, "
              "so that the path to the peak is found in another way.", ""]
    lines += table(["", "strength (MPa)", "change", "at (μm)", "load after failure, of the peak", "set free", "broken",
                    "evaluations", "s", "ledger error"], rows)
    lines += [line for number in COMPRESSION for line in curves(folder, number, tests[number])]
    return lines + cracks(folder, tests[4][SEED_OF_VARIANTS - 1])
