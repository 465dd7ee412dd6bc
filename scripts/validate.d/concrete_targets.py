"""Numbers of the paper about its two concretes (Tables 4 and 5), and the tolerances that the project set itself."""

SEEDS = range(1, 4)

# Counts of the paper: particles, contacts, contacts with elements; and the same of a separate implementation.
ZONES = {
    "0.20 m × 0.20 m": {"paper": (3038, 8795, 121), "check": ("3034-3049", "8772-8803", "123-124"), "seeds": SEEDS},
    "0.30 m × 0.306 m": {"paper": (6908, 20212, 195), "check": ("6896", "20252", "189"), "seeds": range(1, 2)},
}
COUNT_TOLERANCE, EDGE_CONTACT_TOLERANCE = 0.04, 0.08
CONTACTS_PER_PARTICLE, CONTACTS_PER_PARTICLE_TOLERANCE = 2.895, 0.015

# E (GPa) and ν by table.
PROPERTIES = {4: (30.0, 0.19), 5: (25.0, 0.18)}
MODULUS_TOLERANCE, RATIO_TOLERANCE = 0.03, 0.01

# Tension: strength (MPa) and fracture energy (N/m); and the ranges of three assemblies of a separate implementation.
TENSION = {
    4: {"strength": 3.28, "energy": "57.3", "check": "2.82-2.95 MPa, 62-77 N/m"},
    5: {"strength": 2.74, "energy": "—", "check": "2.74-2.86 MPa, 55-61 N/m"},
}
# Compression: strength (MPa), and the range of three assemblies of a separate implementation.
COMPRESSION = {4: {"strength": 37.2, "check": "31.9-32.2 MPa"}, 5: {"strength": 30.4, "check": "27.0-27.3 MPa"}}
PEAK_CHANGE_TOLERANCE = 0.01  # with half the increment, or a quarter of the unbalanced forces
STRENGTH_TOLERANCE = {5: 0.08}
LEDGER_TOLERANCE = 1e-3
