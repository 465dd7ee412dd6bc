"""Numbers about the beam of Arrea and Ingraffea, and the tolerances that the project set itself."""

SEEDS = range(1, 5)

# Section 3.3 of the paper.
N_PARTICLES, N_CONTACTS, N_EDGE_CONTACTS = 6908, 20212, 195
PARTICLE_TOLERANCE, EDGE_CONTACT_TOLERANCE = 0.04, 0.08
CONTACTS_PER_PARTICLE_TOLERANCE = 0.015

# The slope of load over sliding of the mouth against that of the cohesive solution, both between these shares of the
# peak.
REFERENCE = "arrea_rokugo_ft28_GF100"
SLOPE_FROM, SLOPE_TO = 0.05, 0.15
SLOPE_TOLERANCE = 0.05

LOWEST_PEAK, HIGHEST_PEAK = 80.0, 140.0  # kN, mean of the seeds

NOTCH_DEPTH, DEPTH, THICKNESS = 82e-3, 306e-3, 156e-3  # m
OUTER_PLATEN, LEFT_SUPPORT = -458e-3, -61e-3  # m, x
LEAST_ANGLE, LARGEST_ANGLE = 35.0, 45.0  # degrees from the vertical, at the tip of the notch
LEAST_END, LARGEST_END = 75e-3, 100e-3  # m, x of the crack at the top
ZONE_HALF_WIDTH = 0.15  # m

LAST_SLIDING = 0.14e-3  # m
LEDGER_TOLERANCE = 1e-3
BALANCE_TOLERANCE = 5e-3
LONGEST_TIME, GOAL_OF_TIME = 120.0, 15.0  # s, one core
STEEL_TOLERANCE = 0.01
CONTROL_TOLERANCE = 0.02
