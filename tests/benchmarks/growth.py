#!/usr/bin/env python3
"""How cost grows with the number of particles: a picture and a table from the benchmark 'growth'.

    growth.py MEASURED.json FOLDER
"""

import json
import subprocess
import sys
from pathlib import Path

COLUMNS = ("n_particles", "n_contacts", "step (s)", "ns per contact", "set-up (s)", "rebuild (s)", "bytes per contact")

PICTURE = """
set terminal pngcairo size 720,560 font 'sans,11'
set output '{folder}/growth.png'
set datafile separator ','
set logscale xy
set format x '10^{{%L}}'
set format y '10^{{%L}}'
set xlabel 'particles'
set ylabel 'processor time (s)'
set key top left
set grid
set xrange [700:1.5e6]
data = '{folder}/growth.csv'
plot data using 1:5 skip 1 with linespoints pt 7 title 'set-up', \\
     data using 1:6 skip 1 with linespoints pt 5 title 'search of all contacts', \\
     data using 1:3 skip 1 with linespoints pt 9 title 'step', \\
     {per_particle:.3e} * x dashtype 2 linecolor 'gray40' title 'in proportion to particles'
"""


def rows(measured):
    """Medians of every size, in the order of COLUMNS."""
    for run in measured["benchmarks"]:
        if run.get("aggregate_name") != "median" or not run["run_name"].startswith("growth/"):
            continue
        particles = int(run["run_name"].split("particles:")[1].split("/")[0])
        contacts = round(run["n_contacts"])
        yield (particles, contacts, run["per_item"] * contacts, 1e9 * run["per_item"], run["set_up"], run["rebuild"],
               run["memory"])


def main():
    measured, folder = json.loads(Path(sys.argv[1]).read_text()), Path(sys.argv[2])
    table = sorted(rows(measured))
    folder.mkdir(parents=True, exist_ok=True)
    lines = [",".join(COLUMNS)] + [",".join(f"{value:.6g}" for value in row) for row in table]
    (folder / "growth.csv").write_text("\n".join(lines) + "\n")
    middle = table[len(table) // 2]
    subprocess.run(["gnuplot"], input=PICTURE.format(folder=folder, per_particle=middle[2] / middle[0]), text=True,
                   check=True)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
