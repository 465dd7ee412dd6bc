"""Load over sliding and opening of the crack mouth and over deflection, beside the cohesive solutions."""
from validation import PAGES, plot

DATA = PAGES / "data"
REFERENCES = (
    ("arrea_rokugo_ft28_GF100", "cohesive crack, Rokugo's bilinear, 2.8 MPa, 100 N/m", "#404040", 2),
    ("arrea_linear_ft28_GF100", "cohesive crack, linear, 2.8 MPa, 100 N/m", "#404040", 1),
    ("arrea_linear_ft35_GF100", "cohesive crack, linear, 3.5 MPa, 100 N/m", "#909090", 1),
)
COLOURS = ("#c0392b", "#2060a0", "#27864f", "#b07d10")
COLUMNS = {"deflection": (1, "deflection of the actuator (mm)"), "cmod": (2, "CMOD (mm)"), "cmsd": (3, "CMSD (mm)")}


def written_curve(folder, beam, name):
    path = folder / f"{name}_{beam.seed}.dat"
    path.write_text("".join(f"{row['deflection_m'] * 1e3!r} {row['cmod_m'] * 1e3!r} {row['cmsd_m'] * 1e3!r} "
                            f"{row['load_N'] * 1e-3!r}\n" for row in beam.rows))
    return path


def references(column):
    number, _ = COLUMNS[column]
    return [f"'< tail -n +2 {DATA / name}.csv | tr , \" \"' using {number}:($4/1000) with lines lw 1.6 dt {dash} "
            f"lc rgb '{colour}' title \"{title}\"" for name, title, colour, dash in REFERENCES]


def beam_curve(folder, beam, column, colour, title, name="arrea"):
    number, _ = COLUMNS[column]
    return (f"'{written_curve(folder, beam, name)}' using {number}:4 with lines lw 1.8 lc rgb '{colour}' "
            f"title '{title}'")


def load_picture(parts, column, end):
    _, label = COLUMNS[column]
    return f"""
set key top right
set grid
set xrange [0:{end}]
set yrange [0:160]
set xlabel '{label}'
set ylabel 'P, load of the inner platen (kN)'
plot {", ".join(parts)}
"""


def curves_section(folder, beams):
    lines = ["## P over the sliding of the crack mouth, and over deflection", "",
             "Beside the cohesive-crack model with a crack along a given curve ([data](data/README.md)); these lines are "
             "calculations, too, with loads and supports at points and without the steel beam, so that deflections do not "
             "compare. All curves show P, the load of the inner platen; the actuator carries 1.13 P.", ""]
    for column, end in (("cmsd", 0.16), ("cmod", 0.4), ("deflection", 0.25)):
        parts = references(column) if column != "deflection" else []
        parts += [beam_curve(folder, beam, column, colour, f"seed {beam.seed}") for beam, colour in zip(beams, COLOURS)]
        lines += plot(load_picture(parts, column, end), f"arrea_{column}", f"P over {COLUMNS[column][1]} of the beam in mixed mode")
    return lines
