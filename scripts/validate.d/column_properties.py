"""Table 1(a) of the paper: Young's moduli and Poisson's ratios of the assemblies."""
from column_targets import MODULUS_TOLERANCE, PROPERTIES, RATIO_TOLERANCE, SEEDS
from validation import mean, run_case, table

COLUMNS = ("young_modulus_x_Pa", "poisson_ratio_x", "young_modulus_y_Pa", "poisson_ratio_y")
GPA = 1e-9


def four(values):
    modulus_x, ratio_x, modulus_y, ratio_y = values
    return [f"{modulus_x:.2f}", f"{ratio_x:.3f}", f"{modulus_y:.2f}", f"{ratio_y:.3f}"]


def four_of(run, prefix=""):
    values = [run.results[prefix + column] for column in COLUMNS]
    return [values[0] * GPA, values[1], values[2] * GPA, values[3]]


def means_of(values):
    """Mean modulus and mean ratio of both directions."""
    return mean(values[0::2]), mean(values[1::2])


def mean_rows(name, runs, verdicts):
    modulus, ratio = means_of(PROPERTIES[name])
    short = name.removeprefix("assembly_properties_").upper()
    for label, prefix in (("walls", ""), ("region", "region_")):
        all_means = [means_of(four_of(run, prefix)) for run in runs]
        got_modulus = mean(m for m, _ in all_means)
        got_ratio = mean(r for _, r in all_means)
        by_modulus = got_modulus / modulus - 1.0
        by_ratio = got_ratio - ratio
        row = [short, label, f"{modulus:.2f}, {ratio:.3f}", f"{got_modulus:.2f}, {got_ratio:.3f}",
               f"{by_modulus:+.1%}, {by_ratio:+.3f}"]
        if label == "walls":
            modulus_met = verdicts.of(abs(by_modulus) <= MODULUS_TOLERANCE, f"{name}: E ({by_modulus:+.1%})")
            ratio_met = verdicts.of(abs(by_ratio) <= RATIO_TOLERANCE, f"{name}: ν ({by_ratio:+.3f})")
            row.append(f"± {MODULUS_TOLERANCE:.0%}: {modulus_met}; ± {RATIO_TOLERANCE}: {ratio_met}")
        else:
            row.append("for information")
        yield row


def seed_rows(name, runs):
    short = name.removeprefix("assembly_properties_").upper()
    yield [short, "paper", *four(PROPERTIES[name]), "", "", "", ""]
    for number, run in enumerate(runs, start=1):
        label = f"seed {number}" if len(runs) > 1 else "lattice"
        yield [short, label, *four(four_of(run)), *four(four_of(run, "region_"))]


def properties_section(folder, verdicts):
    runs = {}
    for name in PROPERTIES:
        seeds = SEEDS if name[-2] == "r" else SEEDS[:1]
        runs[name] = [run_case(folder, name, (f"generation.seed={seed}",)) for seed in seeds]
        for run in runs[name]:
            verdicts.of(run.summary["ended"] == "converged", f"{name}: converges")
    lines = ["## Elastic properties of the assemblies (Table 1(a))", "",
             "The boxes of the four assemblies between frictionless walls, compressed along x, then along y "
             "(`config/assembly_properties_*.toml`). *Walls*: from the forces on the walls and their motion, as the paper "
             "does. *Region*: from mean stress and strain of the particles inside, a margin of 15 % away from the walls. "
             "Means of both directions, and of five seeds for R1 and R2; E in GPa.", ""]
    lines += table(["assembly", "measured by", "paper E, ν", "got E, ν", "deviation", "target"],
                   [row for name in PROPERTIES for row in mean_rows(name, runs[name], verdicts)])
    lines += ["Every assembly; the paper's difference between the directions is that of its one assembly:", ""]
    lines += table(["assembly", "", "E_x", "ν_x", "E_y", "ν_y", "region E_x", "ν_x", "E_y", "ν_y"],
                   [row for name in PROPERTIES for row in seed_rows(name, runs[name])])
    return lines
