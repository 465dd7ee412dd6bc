"""Numbers of section 3.1 of the paper, and the tolerances that the project set itself."""

NODES = (7, 14, 21, 28)
SUPPORTS = (1, 8, 15, 22)

# Table 2: displacements (μm), reactions (kN); steps to convergence, whose criterion the paper does not give.
SINGLE_CASES = {
    "column_fem": {
        "what": "finite elements alone",
        "displacement": (2.402, 2.399, 2.399, 2.402),
        "reaction": (-1.650, -3.350, -3.350, -1.650),
        "digits": 3,
    },
    "column_hexagonal_h1": {
        "what": "hexagonal assembly H1, the third column of elements",
        "displacement": (2.406, 2.403, 2.403, 2.406),
        "reaction": (-1.651, -3.348, -3.348, -1.651),
        "displacement_tolerance": 0.005,
        "reaction_tolerance": 0.002,
        "n_particles": 595,
    },
    "column_hexagonal_h2": {
        "what": "hexagonal assembly H2, one element in the middle",
        "displacement": (2.411, 2.408, 2.408, 2.411),
        "reaction": (-1.650, -3.350, -3.350, -1.650),
        "displacement_tolerance": 0.005,
        "reaction_tolerance": 0.002,
        "n_particles": 357,
    },
}
RANDOM_CASES = {
    "column_random_r1": {
        "what": "random assembly R1, the third column of elements",
        "displacement": (2.412, 2.410, 2.412, 2.417),
        "reaction": (-1.652, -3.350, -3.349, -1.652),
        "displacement_tolerance": 0.01,
        "reaction_tolerance": 0.003,
        "n_particles": 1258,
    },
    "column_random_r2": {
        "what": "random assembly R2, one element in the middle",
        "displacement": (2.404, 2.401, 2.401, 2.404),
        "reaction": (-1.650, -3.350, -3.350, -1.650),
        "displacement_tolerance": 0.005,
        "reaction_tolerance": 0.002,
        "n_particles": 773,
    },
}
SEEDS = range(1, 6)
MORE_SEEDS = range(1, 26)

PAPER_STEPS = {
    "column_fem": 160,
    "column_hexagonal_h1": 816,
    "column_random_r1": 1123,
    "column_hexagonal_h2": 395,
    "column_random_r2": 1032,
}

# Table 1(a): E_x (GPa), ν_x, E_y (GPa), ν_y of the assemblies.
PROPERTIES = {
    "assembly_properties_h1": (19.84, 0.196, 20.02, 0.192),
    "assembly_properties_r1": (19.45, 0.181, 20.65, 0.194),
    "assembly_properties_h2": (19.94, 0.204, 20.26, 0.188),
    "assembly_properties_r2": (19.75, 0.201, 19.96, 0.198),
}
MODULUS_TOLERANCE = 0.03
RATIO_TOLERANCE = 0.015

LONGEST_TIME = 2.0  # s, from start to the converged result, packing included
DIRECT_TOLERANCE = 1e-6
ENERGY_TOLERANCE = 1e-6


def quantities(case):
    """Column of the results, label, factor to the unit of the paper, target and tolerance of the eight numbers."""
    lists = (("displacement", "u_{}_m", "displacement of node {} (μm)", 1e6, NODES),
             ("reaction", "r_{}_N", "reaction of node {} (kN)", 1e-3, SUPPORTS))
    for kind, column, label, scale, numbers in lists:
        for number, target in zip(numbers, case[kind]):
            yield column.format(number), label.format(number), scale, target, case.get(f"{kind}_tolerance")
