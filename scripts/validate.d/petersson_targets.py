"""Numbers about Petersson's beam, and the tolerances that the project set itself."""

SEEDS = range(1, 5)

# Section 3.2 of the paper.
N_PARTICLES, N_CONTACTS, N_EDGE_CONTACTS = 3038, 8795, 121
PARTICLE_TOLERANCE, EDGE_CONTACT_TOLERANCE = 0.04, 0.08
CONTACTS_PER_PARTICLE_TOLERANCE = 0.015

# Finite elements with a sharp notch, E = 30 GPa.
STIFFNESS, STIFFNESS_TOLERANCE = 2.96, 0.06  # kN/mm
STIFFNESS_FROM, STIFFNESS_TO = 0.05e-3, 0.10e-3  # m, deflections between which the tangent is taken

# About the cohesive solutions; seeds 1 to 4 of a separate implementation of the paper's model lie at 661 to 784 N.
LOWEST_PEAK, HIGHEST_PEAK = 640.0, 760.0  # N, mean of the seeds

LEDGER_TOLERANCE = 1e-3
BALANCE_TOLERANCE = 5e-3
LONGEST_TIME, GOAL_OF_TIME = 20.0, 5.0  # s, one core, packing included
PEAK_CHANGE_TOLERANCE = 0.01
