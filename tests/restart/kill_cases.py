"""Small cases that together have every law, method, generator and kind of output, for runs that are killed."""

import subprocess

from program import BEAM_ON_PLATENS, CONFIG, DONE, FALLING_BLOCK, NOT_CONVERGED, PROGRAM, TENSION, settings

SPECIMEN = """\
title = "A small specimen is pulled and let go, again and again"
[problem]
thickness = "0.1 m"
{gravity}
[material.rock]
young_modulus = "20 GPa"
poisson_ratio = 0.25
density = "2400 kg/m3"
friction_coefficient = 0.2
{law}
[[zone]]
name = "specimen"
from = ["0 m", "0 m"]
to = ["0.03 m", "0.06 m"]
material = "rock"
{generator}
[[wall]]
name = "bottom"
from = ["0 m", "0 m"]
to = ["0.03 m", "0 m"]
contact = "tied"
[[wall]]
name = "top"
from = ["0 m", "0.06 m"]
to = ["0.03 m", "0.06 m"]
contact = "tied"
[[support]]
name = "side"
particles = [10]
fix = ["x"]
{motions}
[[gauge]]
name = "load"
reaction = {{ wall = "top", direction = "y" }}
[solver]
{solver}
[audit]
tolerance = 1.0
"""

MOTION = """\
[[motion]]
name = "pull_{stage}"
walls = ["top"]
direction = "y"
displacement = "{displacement} um"
stop_time = "{time} s"
stage = {stage}
"""
# The same on one schedule.
SCHEDULED = """\
[[motion]]
name = "pull"
walls = ["top"]
direction = "y"
schedule = { time = ["0 s", "1 s", "2 s", "3 s"], displacement = ["0 um", "8 um", "2 um", "32 um"] }
"""

BRITTLE = 'law = "mohr_coulomb_brittle"\ntensile_strength = "2 MPa"\ncohesion = "6 MPa"'
EXPONENTIAL = ('law = "mohr_coulomb_exponential"\ntensile_strength = "2 MPa"\ncohesion = "6 MPa"\n'
               'fracture_energy_tension = "20 N/m"\nfracture_energy_shear = "500 N/m"')
BILINEAR = EXPONENTIAL.replace("exponential", "bilinear")
RANDOM = 'generator = "random"\nsmallest_radius = "1.5 mm"\nlargest_radius = "3 mm"\narea_ratio = 1.1'
GRADED = ('generator = "graded"\nsieves = ["0 mm", "3 mm", "4 mm", "6 mm"]\nmass_shares = [0.3, 0.4, 0.3]\n'
          'threshold_diameter = "3 mm"\naggregate_content = "1879 kg/m3"\ngrain_density = "2650 kg/m3"\n'
          'area_ratio = 1.1\nvoid_diameter = "3 mm"\nsmallest_void_radius = "0.5 mm"')
FILE = 'generator = "file"\npath = "discs.csv"'


def cycles(displacements, time):
    """Motions of the top, one a stage (µm)."""
    return "".join(MOTION.format(stage=stage, displacement=value, time=time)
                   for stage, value in enumerate(displacements, start=1))


def solver(method, steps, masses="real", **more):
    keys = {"method": f'"{method}"', "masses": f'"{masses}"', "max_steps": steps, **more}
    return "\n".join(f"{key} = {value}" for key, value in keys.items())


# Pulls beyond the strength, lets go, and pulls apart.
APART = (8, -6, 30)
SPECIMENS = {
    "brittle_local_damping": dict(
        law=BRITTLE, generator=RANDOM, motions=cycles(APART, 2e-4), gravity='gravity = ["0 m/s2", "-9.81 m/s2"]',
        solver=solver("local_damping", 1500, unbalanced_force_ratio=0.05)),
    "exponential_graded": dict(
        law=EXPONENTIAL, generator=GRADED, motions=cycles(APART, 1), gravity="",
        solver=solver("dynamic_relaxation", 1200, "scaled", unbalanced_force_ratio=0.01)),
    "from_a_file": dict(
        law=BRITTLE, generator=FILE, motions=SCHEDULED, gravity="",
        solver=solver("quasi_static", 60, "scaled", increment='"1 um"')),
}
ENDLESS = settings(solver__unbalanced_force_ratio=1e-300, solver__max_steps=300)


def coarse(zone):
    """A concrete of few particles, of which a specimen or beam breaks within seconds."""
    grading = dict(sieves='["0 mm", "10 mm", "16 mm"]', mass_shares="[0.5, 0.5]", threshold_diameter='"10 mm"',
                   void_diameter='"10 mm"', smallest_void_radius='"1 mm"')
    return settings(**{f"zone__{zone}__{key}": value for key, value in grading.items()})


# Fails in an increment that settles only while contacts live.
CRUSHED = settings(motion__pull__displacement='"-148 um"', motion__pull_apart__displacement='"4 um"',
                   solver__increment='"4 um"', solver__most_evaluations=200, solver__smallest_share=1.0)
SLIDING = settings(material__rock__law='"frictional"', material__rock__friction_coefficient=0.3)
READY = {
    "column_fem": (CONFIG / "column_fem.toml", ENDLESS),
    "column_hexagonal_h1": (CONFIG / "column_hexagonal_h1.toml", ENDLESS),
    "column_hexagonal_h2": (CONFIG / "column_hexagonal_h2.toml", ENDLESS),
    "column_random_r2": (CONFIG / "column_random_r2.toml", ENDLESS),
    "column_relaxed": (CONFIG / "column_hexagonal_h1.toml", [*ENDLESS, *settings(solver__method="dynamic_relaxation")]),
    "falling_block": (FALLING_BLOCK, settings(solver__max_steps=600)),
    "assembly_properties": (CONFIG / "assembly_properties_h2.toml", []),
    "falling_block_frictional": (FALLING_BLOCK, [*SLIDING, *settings(solver__max_steps=600)]),
    "beam_on_platens": (BEAM_ON_PLATENS, ENDLESS),
    "tension": (TENSION, settings(output__transient_every=10)),
    "tension_secant": (TENSION, settings(solver__method='"secant"', solver__max_steps=24, output__transient_every=3)),
    "tension_crushed": (TENSION, CRUSHED),
    "notched_beam_cmod": (CONFIG / "petersson_beam_cmod.toml", [*coarse("middle"), *settings(solver__increment='"5 um"')]),
    "sheared_beam_cmsd": (CONFIG / "arrea_beam_cmsd.toml", [*coarse("middle"), *settings(solver__increment='"5 um"')]),
    "uniaxial_tension": (CONFIG / "uniaxial_tension_table5.toml",
                         [*coarse("specimen"), *settings(solver__increment='"2 um"')]),
    "uniaxial_compression": (CONFIG / "uniaxial_compression_table5.toml",
                             [*coarse("specimen"), *settings(solver__increment='"20 um"')]),
}
# Everything at every step, or at steps that differ.
SCHEDULES = (settings(checkpoint__every=1, output__every=1, output__fields_every=20),
             settings(checkpoint__every=7, output__every=3, output__fields_every=5, checkpoint__keep=2))


def write_case(folder, name):
    """The file of a case, made in the folder if it is none of those that are there; and its settings."""
    if name in READY:
        return READY[name]
    if name == "from_a_file" and not (folder / "discs.csv").exists():
        source, _ = write_case(folder, "brittle_local_damping")
        subprocess.run([PROGRAM, "generate", source, "--output", folder / "discs.csv"], check=True, capture_output=True)
    path = folder / f"{name}.toml"
    path.write_text(SPECIMEN.format(**SPECIMENS[name]))
    return path, []


def names():
    return [*READY, *SPECIMENS]


ENDINGS = (DONE, NOT_CONVERGED)
