"""Particles and contacts of the zones of the two beams, and the elastic constants of the assembly."""
from concrete_targets import (CONTACTS_PER_PARTICLE, CONTACTS_PER_PARTICLE_TOLERANCE, COUNT_TOLERANCE,
                              EDGE_CONTACT_TOLERANCE, MODULUS_TOLERANCE, PROPERTIES, RATIO_TOLERANCE, SEEDS, ZONES)
from validation import mean, run_case, table

# The zone of the beam in mixed mode between two elements, with its notch of 82 mm; nothing is loaded.
LARGER_ZONE = (
    'mesh.x=["0 m", "0.2 m", "0.5 m", "0.7 m"]', 'mesh.y=["0 m", "0.306 m"]',
    'zone.middle.from=["0.2 m", "0 m"]', 'zone.middle.to=["0.5 m", "0.306 m"]',
    'notch.notch.from=["0.35 m", "0 m"]', 'notch.notch.to=["0.35 m", "0.082 m"]',
    'wall.platen.from=["0.34 m", "0.306 m"]', 'wall.platen.to=["0.36 m", "0.306 m"]',
    'support.right.at.x="0.7 m"',
    'gauge.cmod.opening.from=["0.347 m", "0 m"]', 'gauge.cmod.opening.to=["0.353 m", "0 m"]',
    'gauge.cmsd.opening.from=["0.347 m", "0 m"]', 'gauge.cmsd.opening.to=["0.353 m", "0 m"]',
)
OVERRIDES = {"0.20 m × 0.20 m": (), "0.30 m × 0.306 m": LARGER_ZONE}


def count_rows(folder, verdicts):
    for zone, numbers in ZONES.items():
        paper = numbers["paper"]
        yield [zone, "paper", *(str(n) for n in paper), f"{paper[1] / paper[0]:.3f}", ""]
        yield [zone, "separate implementation", *numbers["check"], "", ""]
        for seed in numbers["seeds"]:
            run = run_case(folder, "petersson_beam", (f"generation.seed={seed}", *OVERRIDES[zone]),
                           ("--stop-after-steps", "0"))
            particles, contacts, edges = (run.summary[f"n_{what}"] for what in ("particles", "contacts", "edge_contacts"))
            ratio = contacts / particles
            passed = (abs(particles / paper[0] - 1.0) <= COUNT_TOLERANCE
                      and abs(contacts / paper[1] - 1.0) <= COUNT_TOLERANCE
                      and abs(edges / paper[2] - 1.0) <= EDGE_CONTACT_TOLERANCE
                      and abs(ratio / CONTACTS_PER_PARTICLE - 1.0) <= CONTACTS_PER_PARTICLE_TOLERANCE)
            yield [zone, f"seed {seed}", str(particles), str(contacts), str(edges), f"{ratio:.3f}",
                   verdicts.of(passed, f"counts of {zone}, seed {seed}")]


def counts_section(folder, verdicts):
    lines = ["## The assemblies", "",
             "In the beam, the notch cut: contacts that cross it are not counted. Targets: particles and contacts "
             f"± {COUNT_TOLERANCE:.0%}, contacts with elements ± {EDGE_CONTACT_TOLERANCE:.0%}, contacts a particle "
             f"± {CONTACTS_PER_PARTICLE_TOLERANCE:.1%}. (The aggregate content taken at its word would give some 9800 "
             "particles; the [user guide](../user_guide.md) tells how the zone is filled instead.)", ""]
    return lines + table(["zone", "", "particles", "contacts", "with elements", "a particle", ""],
                         list(count_rows(folder, verdicts)))


def constants_of(run):
    """E (GPa) and ν from the walls, means of both directions."""
    results = run.results
    return (mean(results[f"young_modulus_{axis}_Pa"] for axis in "xy") * 1e-9,
            mean(results[f"poisson_ratio_{axis}"] for axis in "xy"))


def property_rows(folder, number, verdicts):
    modulus, ratio = PROPERTIES[number]
    runs = [run_case(folder, f"assembly_properties_concrete_table{number}", (f"generation.seed={seed}",))
            for seed in SEEDS]
    got = [constants_of(run) for run in runs]
    verdicts.of(all(run.summary["ended"] == "converged" for run in runs), f"Table {number}: elastic constants converge")
    mean_modulus, mean_ratio = mean(m for m, _ in got), mean(r for _, r in got)
    by_modulus, by_ratio = mean_modulus / modulus - 1.0, mean_ratio - ratio
    modulus_met = verdicts.of(abs(by_modulus) <= MODULUS_TOLERANCE, f"Table {number}: E ({by_modulus:+.1%})")
    ratio_met = verdicts.of(abs(by_ratio) <= RATIO_TOLERANCE, f"Table {number}: ν ({by_ratio:+.3f})")
    yield [f"Table {number}", f"{modulus:.0f}, {ratio}", *(f"{m:.2f}, {r:.3f}" for m, r in got),
           f"{mean_modulus:.2f}, {mean_ratio:.3f}", f"{by_modulus:+.1%}, {by_ratio:+.3f}", f"{modulus_met}, {ratio_met}"]


def properties_section(folder, verdicts):
    lines = ["## Young's modulus and Poisson's ratio", "",
             "`config/assembly_properties_concrete_table4.toml` and `…table5.toml`: boxes of 0.2 m × 0.2 m between "
             "frictionless walls, means of compression along x and along y, from the forces and motions of the walls; E in "
             f"GPa. Targets of the mean: E ± {MODULUS_TOLERANCE:.0%}, ν ± {RATIO_TOLERANCE}.", ""]
    return lines + table(["", "paper E, ν", *(f"seed {seed}" for seed in SEEDS), "mean", "deviation", "target"],
                         [row for number in PROPERTIES for row in property_rows(folder, number, verdicts)])
