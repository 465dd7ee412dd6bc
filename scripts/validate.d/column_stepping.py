"""Steps to convergence, energy without damping (Fig. 7), and the same bits from any number of threads."""
from column_targets import ENERGY_TOLERANCE, PAPER_STEPS
from validation import plot, resume, run_case, table

METHODS = {
    "two_level_relaxation": ("solver.method=two_level_relaxation",),
    "dynamic_relaxation": ("solver.method=dynamic_relaxation",),
    "local_damping": ("solver.method=local_damping", "solver.mass_safety=1.3"),
}


def steps_section(folder, verdicts):
    rows = []
    for name, paper in PAPER_STEPS.items():
        steps = {}
        for method, overrides in METHODS.items():
            run = run_case(folder, name, (*overrides, "solver.max_steps=50000"))
            verdicts.of(run.summary["ended"] == "converged", f"{name}: {method} converges")
            steps[method] = run.summary["steps"]
        met = verdicts.of(steps["two_level_relaxation"] <= paper, f"{name}: steps")
        rows.append([f"`{name}`", str(paper), *(str(steps[method]) for method in METHODS), met])
    return ["## Steps to convergence", "",
            "To an unbalanced force ratio of 1e-6, looked at every 10 steps. The paper gives numbers of steps, not its "
            "criterion. The goal is no more steps than the paper's, and is asked of the method of the cases, "
            "`two_level_relaxation`; local damping has `mass_safety = 1.3`.", ""
            ] + table(["case", "paper", *(f"`{method}`" for method in METHODS), "goal"], rows)


def energy_section(folder, verdicts):
    run = run_case(folder, "column_energy")
    rows = run.rows("energy")
    work = [row["applied_loads_J"] for row in rows]
    sums = {kind: [sum(value for key, value in row.items() if key.startswith(kind)) for row in rows]
            for kind in ("kinetic", "elastic")}
    total = [k + e for k, e in zip(sums["kinetic"], sums["elastic"])]
    largest = max(abs(t - w) for t, w in zip(total, work)) / max(abs(w) for w in work)
    error = run.summary["energy_error"]
    ended = verdicts.of(run.summary["ended"] == "completed" and run.summary["steps"] == 5000, "energy of R1: 5000 steps")
    met = verdicts.of(max(error, largest) <= ENERGY_TOLERANCE, "energy of R1")
    data = folder / "energy.dat"
    data.write_text("".join(f"{row['step']:.0f} {w!r} {t!r} {k!r} {e!r}\n" for row, w, t, k, e in
                            zip(rows, work, total, sums["kinetic"], sums["elastic"])))
    script = f"""
set key outside right center reverse Left
set grid
set xlabel 'step'
set ylabel 'energy (J)'
plot '{data}' using 1:2 with lines lw 3 lc rgb '#bbbbbb' title 'work of the load', \\
     '{data}' using 1:3 with points pt 7 ps 0.5 lc rgb '#000000' title 'kinetic + strain', \\
     '{data}' using 1:4 with lines lw 1.2 lc rgb '#c0392b' title 'kinetic', \\
     '{data}' using 1:5 with lines lw 1.2 lc rgb '#2060a0' title 'strain'
"""
    return ["## Energy of R1 under a suddenly applied load (Fig. 7)", "",
            f"`config/column_energy.toml`: no damping, scaled masses, 5000 steps ({run.summary['ended']} at step "
            f"{run.summary['steps']}: {ended}). Kinetic and strain energy together against the work of the load, over "
            f"{len(rows)} rows: largest difference {largest:.1e} of the largest work; largest error of the ledger "
            f"{error:.1e}; target {ENERGY_TOLERANCE:.0e}: {met}. The paper is within 1e-2.", ""
            ] + plot(script, "column_energy", "Energy of the column with R1, undamped")


def threads_section(folder, verdicts):
    rows = []
    for name in ("column_hexagonal_h2", "column_random_r1"):
        tight = ("solver.unbalanced_force_ratio=1e-10",)
        hashes = [run_case(folder, name, tight, ("--threads", str(n))).summary["final_state_hash"] for n in (1, 2, 3, 8)]
        for before, after in ((1, 8), (3, 2)):
            stopped = run_case(folder, name, tight, ("--threads", str(before), "--stop-after-steps", "73"))
            hashes.append(resume(folder, stopped.output, ("--threads", str(after))).summary["final_state_hash"])
        rows.append([f"`{name}`", f"`{hashes[0]}`", verdicts.of(len(set(hashes)) == 1, f"{name}: threads")])
    return ["## Threads", "",
            "Hash of the final state at an unbalanced force ratio of 1e-10 with 1, 2, 3 and 8 threads, and of runs stopped "
            "at step 73 and resumed with another number (1, then 8; 3, then 2); all six must agree.", ""
            ] + table(["case", "hash of the final state", "the same"], rows)
