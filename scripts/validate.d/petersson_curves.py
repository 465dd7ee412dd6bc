"""Load over deflection and over the opening of the crack mouth, beside the cohesive solutions."""
from validation import PAGES, plot

DATA = PAGES / "data"
REFERENCES = (
    ("petersson_bilinear_GF124", "cohesive crack, Petersson's bilinear, 3.33 MPa, 124 N/m", "#404040", 1),
    ("petersson_rokugo_GF124", "cohesive crack, Rokugo's bilinear, 3.33 MPa, 124 N/m", "#404040", 2),
    ("petersson_rokugo_GF57_ft328", "cohesive crack, Rokugo's bilinear, 3.28 MPa, 57.3 N/m", "#909090", 1),
)
COLOURS = ("#c0392b", "#2060a0", "#27864f", "#b07d10")


def written_curve(folder, beam):
    path = folder / f"petersson_{beam.seed}.dat"
    path.write_text("".join(f"{row['deflection_m'] * 1e3!r} {row['cmod_m'] * 1e3!r} {row['load_N']!r}\n"
                            for row in beam.rows))
    return path


def curves(folder, beams, column, end, label):
    parts = [f"'< tail -n +2 {DATA / name}.csv | tr , \" \"' using {column}:4 with lines lw 1.6 dt {dash} "
             f"lc rgb '{colour}' title \"{title}\"" for name, title, colour, dash in REFERENCES]
    parts += [f"'{written_curve(folder, beam)}' using {column}:3 with lines lw 1.8 lc rgb '{colour}' "
              f"title 'seed {beam.seed}'" for beam, colour in zip(beams, COLOURS)]
    return f"""
set key top right
set grid
set xrange [0:{end}]
set yrange [0:900]
set xlabel '{label}'
set ylabel 'load (N)'
plot {", ".join(parts)}
"""


def curves_section(folder, beams):
    lines = ["## Load over deflection, and over the opening of the crack mouth", "",
             "Beside the cohesive-crack model with a vertical crack ([data](data/README.md)); these lines are calculations, "
             "too. The lowest has the macroscopic strength and fracture energy of the paper's Table 4. The beam of particles rises "
             "with the same stiffness and softens faster than any of them.", ""]
    lines += plot(curves(folder, beams, 1, 0.8, "deflection (mm)"), "petersson_deflection",
                  "Load over deflection of Petersson's beam")
    return lines + plot(curves(folder, beams, 2, 0.3, "opening of the crack mouth (mm)"), "petersson_cmod",
                        "Load over the opening of the crack mouth of Petersson's beam")
