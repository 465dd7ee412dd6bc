#!/usr/bin/env python3
"""The step of YADE on the assembly of the benchmark whole_step: a hexagonal lattice in the plane that stands on its
lowest line and settles under its weight, every particle bonded to its neighbours by the concrete law (CPM).

    yade -j THREADS -n -x yade_step.py PARTICLES

Prints particles, bonds, nanoseconds of processor time and of real time per bond and step, and bytes per bond.
"""

import math
import resource
import sys
import time

from yade import utils
from yade.wrapper import *  # noqa: F403  (YADE hands its classes to scripts in this way)

RADIUS = 0.01
N_WARM_UP = 20


def lattice(n_particles):
    """Centres of about so many discs in a square, lines along x."""
    side = RADIUS * math.sqrt(2.0 * math.sqrt(3.0) * n_particles)
    n_columns = int(side / (2.0 * RADIUS))
    n_lines = int(side / (math.sqrt(3.0) * RADIUS))
    for line in range(n_lines):
        for column in range(n_columns - line % 2):
            yield RADIUS * (1.0 + 2.0 * column + line % 2), RADIUS * (1.0 + math.sqrt(3.0) * line)


def build(n_particles):
    O = Omega()  # noqa: F405,E741
    material = CpmMat(  # noqa: F405
        young=1e9, poisson=0.2, frictionAngle=0.3, density=2000.0, sigmaT=1e7, epsCrackOnset=1e-2, relDuctility=10.0)
    O.materials.append(material)
    for x, y in lattice(n_particles):
        body = utils.sphere((x, y, 0.0), RADIUS, material=material, fixed=y < 1.1 * RADIUS)
        body.state.blockedDOFs = "xyzXYZ" if y < 1.1 * RADIUS else "zXY"
        O.bodies.append(body)
    reach = 1.01
    O.engines = [
        ForceResetter(),  # noqa: F405
        InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=reach)], verletDist=-0.25),  # noqa: F405
        InteractionLoop(  # noqa: F405
            [Ig2_Sphere_Sphere_ScGeom(interactionDetectionFactor=reach)],  # noqa: F405
            [Ip2_CpmMat_CpmMat_CpmPhys(cohesiveThresholdIter=2)],  # noqa: F405
            [Law2_ScGeom_CpmPhys_Cpm()]),  # noqa: F405
        NewtonIntegrator(damping=0.4, gravity=(0.0, -9.81, 0.0)),  # noqa: F405
    ]
    O.dt = 0.3 * utils.PWaveTimeStep()
    return O


def memory():
    """Largest memory of the process so far (bytes)."""
    return 1024.0 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def main():
    n_particles = int(sys.argv[1])
    memory_before = memory()
    O = build(n_particles)  # noqa: E741
    O.run(N_WARM_UP, True)
    n_bonds = O.interactions.countReal()
    n_steps = max(20, 6_000_000 // n_bonds)
    processor, real = time.process_time(), time.perf_counter()
    O.run(n_steps, True)
    processor, real = time.process_time() - processor, time.perf_counter() - real
    per_bond = 1e9 / (n_steps * n_bonds)
    print(f"particles {len(O.bodies)} bonds {n_bonds} threads {O.numThreads} "
          f"processor {processor * per_bond:.1f} ns real {real * per_bond:.1f} ns "
          f"memory {(memory() - memory_before) / n_bonds:.0f} B")


main()
