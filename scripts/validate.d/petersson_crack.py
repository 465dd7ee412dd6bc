"""The crack of Petersson's beam: broken bonds between the particles, counted and drawn."""
import h5py

from validation import plot

BROKEN = 3  # of the field `bond`
VIEW_X, VIEW_Y = (0.95, 1.05), (0.07, 0.2)  # m


def last_field(run, name):
    """The field file of the last step of a run."""
    return max((run.output / "fields").glob(f"{name}_*.hdf"))


def broken_contacts(run):
    """Of every broken contact: both ends at the start (m), opening and slip (m)."""
    with h5py.File(last_field(run, "contacts"), "r") as file:
        cells, points = file["VTKHDF/CellData"], file["VTKHDF/Points"][()]
        for index in (cells["bond"][()] == BROKEN).nonzero()[0]:
            yield points[2 * index], points[2 * index + 1], cells["opening"][index], cells["slip"][index]


def n_broken_by_motion(run):
    """Numbers of broken bonds that opened more than they slid, and of the others."""
    opened = [opening > abs(slip) for _, _, opening, slip in broken_contacts(run)]
    return sum(opened), len(opened) - sum(opened)


def crack_section(folder, beam):
    discs, lines = folder / "discs.dat", folder / "crack.dat"
    with h5py.File(last_field(beam.run, "particles"), "r") as file:
        centres, radii = file["VTKHDF/Points"][()], file["VTKHDF/PointData/radius"][()]
    discs.write_text("".join(f"{x!r} {y!r} {r!r}\n" for (x, y, _), r in zip(centres.tolist(), radii.tolist())))
    lines.write_text("".join(f"{a[0]} {a[1]}\n{b[0]} {b[1]}\n\n" for a, b, _, _ in broken_contacts(beam.run)))
    script = f"""
set terminal pngcairo size 760,900 font 'sans,11'
set size ratio -1
set xrange [{VIEW_X[0]}:{VIEW_X[1]}]
set yrange [{VIEW_Y[0]}:{VIEW_Y[1]}]
set xlabel 'x (m)'
set ylabel 'y (m)'
set key below
set style fill solid 1.0 border lc rgb '#909090'
plot '{discs}' using 1:2:3 with circles lc rgb '#e4e0d8' notitle, \\
     '-' with lines lw 3 lc rgb '#2060a0' title 'notch', \\
     '{lines}' using 1:2 with lines lw 4 lc rgb '#c0392b' title 'broken bonds'
1 0
1 0.1
e
"""
    return ["## The crack", "",
            f"Seed {beam.seed} at the end, places at the start: centres of particles whose bond is broken are joined by a "
            "line. The crack runs from the tip of the notch towards the platen.", ""
            ] + plot(script, "petersson_crack", f"Broken bonds of seed {beam.seed} above the notch")
