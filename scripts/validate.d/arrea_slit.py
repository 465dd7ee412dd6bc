"""How the slope of P over sliding depends on the width of a notch, with elements alone."""
import re
import subprocess

from arrea_run import reference_slope
from validation import LIGAMENT, ROOT, Run, table

WIDTHS = (4.0, 2.0, 1.0)  # mm
CELL = 5.0  # mm


def lines_of(name, values):
    return f"{name} = [" + ", ".join(f'"{value:g} mm"' for value in values) + "]"


def grid_along_x(width):
    """The lines of the case outside of the zone, and inside it cells of about 5 mm beside the slit (mm)."""
    n_cells = 30
    half = 0.5 * width
    side = [half + (150.0 - half) * i / n_cells for i in range(n_cells + 1)]
    text = (ROOT / "config" / "arrea_beam.toml").read_text()
    outside = [float(x) * 1e3 for x in re.findall(r'"(-?[\d.]+) m"', re.search(r"\nx = \[(.*?)\]", text, re.S).group(1))]
    return [x for x in outside if x < -150.0] + [-x for x in reversed(side)] + side + [x for x in outside if x > 150.0]


def case_of_elements(width):
    """config/arrea_beam.toml with elements in place of the particles, and a slit (mm)."""
    text = (ROOT / "config" / "arrea_beam.toml").read_text()
    grid_y = [82.0 * i / 16 for i in range(17)] + [82.0 + 224.0 * i / 45 for i in range(1, 46)]
    text = re.sub(r"\nx = \[\n.*?\]", "\n" + lines_of("x", grid_along_x(width)), text, count=1, flags=re.S)
    text = re.sub(r"\ny = \[\n.*?\]", "\n" + lines_of("y", grid_y), text, count=1, flags=re.S)
    for table_name in (r"\[\[zone\]\]", r"\[material\.concrete\]", r"\[material\.interface\]"):
        text = re.sub(table_name + r"\n(?:[^\[\n].*\n|\n)*", "", text)
    text = re.sub(r'gap = "[^"]*"', f'width = "{width} mm"', text)
    face = 0.5 * width
    return re.sub(r'opening = \{ from = \[.*?\], to = \[.*?\], (direction = "[xy]").*\}',
                  rf'opening = {{ from = ["{-face} mm", "0 m"], to = ["{face} mm", "0 m"], \1 }}', text)


def run_slit(folder, width):
    case, output = folder / f"slit_{width}.toml", folder / f"slit_{width}"
    case.write_text(case_of_elements(width))
    subprocess.run([LIGAMENT, "run", str(case), "--output", str(output), "--quiet", "--set", "solver.max_steps=8"],
                   cwd=folder, check=False)
    return Run(output, 0, None, None).rows("history")[-1]


def slit_section(folder):
    sharp = reference_slope()
    rows = []
    for width in WIDTHS:
        row = run_slit(folder, width)
        slope = row["load_N"] / row["cmsd_m"] * 1e-6
        rows.append([f"{width:g}", f"{slope:.0f}", f"{slope / sharp - 1.0:+.1%}",
                     f"{row['cmod_m'] / row['cmsd_m']:.2f}"])
    rows.append(["0 (sharp, the cohesive solution)", f"{sharp:.0f}", "", ""])
    lines = ["## Why the slope is too low", "",
             "The same case with elements of about 5 mm in place of the particles, and a slit of some width for the notch; "
             "sliding is that of its edges. The sliding of a notch that is sheared depends on its width far more than the "
             "opening of one that is bent. The cut through the bonds of an assembly of particles of 2 to 12 mm is about as "
             "blunt as a slit of 2 to 4 mm; in mode I "
             "([Petersson's beam](petersson.md)) the same cut costs one percent of the stiffness.", ""]
    return lines + table(["width of the slit (mm)", "slope (kN/mm)", "against a sharp notch", "CMOD over CMSD"], rows)
