"""Table 2 of the paper: displacements and reactions of the column, one assembly or the mean of several."""
from column_targets import (DIRECT_TOLERANCE, LONGEST_TIME, MORE_SEEDS, NODES, SEEDS, SUPPORTS, quantities)
from validation import direct_solution, mean, render_fields, run_case, table

TIGHT = ("solver.unbalanced_force_ratio=1e-10",)


def picture(run, name):
    return render_fields(run, name, f"{name}, displacements × 100000", 100000)


def largest_difference(values, reference):
    return max(abs(values[column] / value - 1.0) for column, value in reference.items())


def common_lines(name, case, run, verdicts):
    """How the case as it is in config/ ran."""
    summary = run.summary
    lines = []
    if "n_particles" in case:
        met = verdicts.of(summary["n_particles"] == case["n_particles"], f"{name}: number of particles")
        lines.append(f"- Particles: {summary['n_particles']}, paper {case['n_particles']}: {met}. Contacts: "
                     f"{summary['n_contacts']} between particles, {summary['n_edge_contacts']} with element edges.")
    ended = verdicts.of(run.exit_code == 0 and summary["ended"] == "converged", f"{name}: converges")
    lines.append(f"- Ended: {summary['ended']} (exit {run.exit_code}) at step {summary['steps']}: {ended}.")
    lines.append(f"- Energy ledger: largest error {summary['energy_error']:.1e}, tolerance "
                 f"{summary['audit_tolerance']:.0e}: {verdicts.of(summary['audit'] == 'passed', name + ': audit')}.")
    lines.append(f"- Time from start to converged result, packing included, one core: {run.wall:.2f} s, of which "
                 f"{run.processor:.2f} s on the processor; target {LONGEST_TIME:g} s: "
                 f"{verdicts.of(run.wall < LONGEST_TIME, name + ': time')}.")
    return lines


def value_rows(name, case, values, reference, verdicts):
    for column, label, scale, target, tolerance in quantities(case):
        got = values[column] * scale
        direct = reference[column] * scale
        deviation = got / target - 1.0
        if tolerance is None:
            passed = round(got, case["digits"]) == target
            wanted = "every digit"
        else:
            passed = abs(deviation) <= tolerance
            wanted = f"± {tolerance:.1%}"
        from_direct = abs(got / direct - 1.0)
        direct_verdict = verdicts.of(from_direct <= DIRECT_TOLERANCE, f"{name}: {label} against the direct solution")
        yield [label, f"{target:.3f}", f"{got:.4f}", f"{deviation:+.2%}", f"{direct:.4f}",
               f"{from_direct:.1e}, {direct_verdict}", f"{wanted}: {verdicts.of(passed, f'{name}: {label}')}"]


def single_section(name, case, folder, verdicts):
    """A case with one answer: finite elements, or a lattice."""
    run = run_case(folder, name)
    # The same case relaxed further, so that what is compared with the direct solution is the stiffness, not the stop.
    tight = run_case(folder, name, TIGHT)
    reference = direct_solution(run)
    head = ["quantity", "paper", "got", "deviation", "direct solution", "from it", "target"]
    lines = [f"## `config/{name}.toml`: {case['what']}", ""]
    lines += table(head, value_rows(name, case, tight.results, reference, verdicts))
    lines += ["Values are those of an unbalanced force ratio of 1e-10; at the 1e-6 of the case they differ from these by "
              f"at most {max(abs(run.results[c] / tight.results[c] - 1.0) for c in reference):.1e}.", ""]
    return lines + common_lines(name, case, run, verdicts) + [""] + picture(run, name)


def seed_row(seed, run, case):
    packing = run.packing()
    values = [f"{run.results[column] * scale:.3f}" for column, _, scale, _, _ in quantities(case)]
    return [str(seed), *values, f"{packing['area_ratio']:.3f}", f"{packing['contacts_per_particle']:.2f}",
            f"{packing['mean_overlap']:.3f}"]


def mean_row(label, runs, case):
    values = [f"{mean(run.results[column] for run in runs) * scale:.3f}" for column, _, scale, _, _ in quantities(case)]
    keys = (("area_ratio", 3), ("contacts_per_particle", 2), ("mean_overlap", 3))
    return [label, *values, *(f"{mean(run.packing()[key] for run in runs):.{digits}f}" for key, digits in keys)]


def mean_rows(name, case, runs, more_runs, verdicts):
    for column, label, scale, target, tolerance in quantities(case):
        got = mean(run.results[column] for run in runs) * scale
        deviation = got / target - 1.0
        more = mean(run.results[column] for run in more_runs) * scale
        met = verdicts.of(abs(deviation) <= tolerance, f"{name}: mean {label} ({deviation:+.2%})")
        yield [label, f"{target:.3f}", f"{got:.4f}", f"{deviation:+.2%}", f"± {tolerance:.1%}: {met}", f"{more:.4f}",
               f"{more / target - 1.0:+.2%}"]


def random_section(name, case, folder, verdicts):
    """A case with an assembly of its own for every seed."""
    run = run_case(folder, name)
    more_runs = [run_case(folder, name, (*TIGHT, f"generation.seed={seed}")) for seed in MORE_SEEDS]
    runs = [more_runs[seed - 1] for seed in SEEDS]
    from_direct = max(largest_difference(each.results, direct_solution(each)) for each in runs)
    first, last = SEEDS[0], SEEDS[-1]
    numbers = [f"u {n}" for n in NODES] + [f"r {n}" for n in SUPPORTS]
    lines = [f"## `config/{name}.toml`: {case['what']}", ""]
    lines += table(["quantity", "paper", f"mean of seeds {first}-{last}", "deviation", "target",
                    f"mean of {len(more_runs)} seeds", "deviation"],
                   mean_rows(name, case, runs, more_runs, verdicts))
    lines += ["Every seed (displacements in μm, reactions in kN):", ""]
    lines += table(["seed", *numbers, "area ratio", "contacts a particle", "mean overlap"],
                   [seed_row(seed, each, case) for seed, each in zip(SEEDS, runs)]
                   + [mean_row(f"1-{len(more_runs)}", more_runs, case)])
    met = verdicts.of(from_direct <= DIRECT_TOLERANCE, f"{name}: direct solution")
    lines.append(f"- Largest difference of a displacement or reaction of seeds {first}-{last} from the direct solution: "
                 f"{from_direct:.1e}; target {DIRECT_TOLERANCE:.0e}: {met}.")
    lines += common_lines(name, case, run, verdicts)
    return lines + [""] + picture(run, name)
