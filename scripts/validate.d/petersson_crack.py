"""The crack of Petersson's beam: broken bonds between the particles, counted and drawn."""
import math

import h5py

from validation import plot

BROKEN = 3  # of the field `bond`
ZONE_X, ZONE_Y = (0.9, 1.1), (0.0, 0.2)  # m


def last_field(run, name):
    """The field file of the last step of a run."""
    return max((run.output / "fields").glob(f"{name}_*.hdf"))


def broken_contacts(run):
    """Of every broken contact: both ends at the start (m), opening and slip (m)."""
    with h5py.File(last_field(run, "contacts"), "r") as file:
        cells, points = file["VTKHDF/CellData"], file["VTKHDF/Points"][()]
        for index in (cells["bond"][()] == BROKEN).nonzero()[0]:
            one, other = (tuple(point[:2].tolist()) for point in points[2 * index:2 * index + 2])
            yield one, other, cells["opening"][index], cells["slip"][index]


def n_broken_by_motion(run):
    """Numbers of broken bonds that opened more than they slid, and of the others."""
    opened = [opening > abs(slip) for _, _, opening, slip in broken_contacts(run)]
    return sum(opened), len(opened) - sum(opened)


def discs_of(run):
    """Centre at the start and radius of every particle (m)."""
    with h5py.File(last_field(run, "particles"), "r") as file:
        centres, radii = file["VTKHDF/Points"][()], file["VTKHDF/PointData/radius"][()]
    return {(x, y): radius for (x, y, _), radius in zip(centres.tolist(), radii.tolist())}


def face(one, other, radius_of):
    """The two ends of the face where two discs touch: across the line of their centres, as long as the smaller disc."""
    (ax, ay), (bx, by) = one, other
    distance = math.hypot(bx - ax, by - ay)
    nx, ny = (bx - ax) / distance, (by - ay) / distance
    half = min(radius_of[one], radius_of[other])
    reach = 0.5 * (distance + radius_of[one] - radius_of[other])
    x, y = ax + reach * nx, ay + reach * ny
    return (x - half * ny, y + half * nx), (x + half * ny, y - half * nx)


def written_assembly(folder, beam):
    """The files of the discs and of the broken faces of a run."""
    discs, crack = folder / f"discs_{beam.seed}.dat", folder / f"crack_{beam.seed}.dat"
    radius_of = discs_of(beam.run)
    discs.write_text("".join(f"{x!r} {y!r} {radius!r}\n" for (x, y), radius in radius_of.items()))
    faces = (face(one, other, radius_of) for one, other, _, _ in broken_contacts(beam.run)
             if one in radius_of and other in radius_of)
    crack.write_text("".join(f"{a[0]!r} {a[1]!r}\n{b[0]!r} {b[1]!r}\n\n" for a, b in faces))
    return discs, crack


def panel(folder, beam):
    discs, crack = written_assembly(folder, beam)
    return f"""
set title 'seed {beam.seed}'
plot '{discs}' using 1:2:3 with circles lc rgb '#e8e4dc' notitle, \\
     $notch using 1:2 with lines lw 3 lc rgb '#2060a0' title 'notch', \\
     '{crack}' using 1:2 with lines lw 3 lc rgb '#c0392b' title 'broken bonds'
"""


def crack_section(folder, beams):
    script = f"""
$notch << end
1 0
1 0.1
end
set terminal pngcairo size 1400,1480 font 'sans,11'
set multiplot layout 2,2
set size ratio -1
set xrange [{ZONE_X[0]}:{ZONE_X[1]}]
set yrange [{ZONE_Y[0]}:{ZONE_Y[1]}]
set xlabel 'x (m)'
set ylabel 'y (m)'
set key below
set style fill solid 1.0 border lc rgb '#a8a8a8'
{"".join(panel(folder, beam) for beam in beams)}
unset multiplot
"""
    return ["## The crack", "",
            "The four assemblies at the end, places at the start: the faces of the contacts between particles whose bond is "
            "broken. The crack runs from the tip of the notch towards the platen, around large particles.", ""
            ] + plot(script, "petersson_crack", "Broken bonds above the notch in four assemblies")
