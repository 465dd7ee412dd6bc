"""The crack of a beam: bonds between the particles that are broken or damaged, counted and drawn."""
import math

import h5py

BROKEN = 3  # of the field `bond`


def last_field(run, name):
    """The field file of the last step of a run."""
    return max((run.output / "fields").glob(f"{name}_*.hdf"))


def contacts_of(run):
    """Of every contact: both ends at the start (m), state of the bond, damage, opening and slip (m)."""
    with h5py.File(last_field(run, "contacts"), "r") as file:
        cells, points = file["VTKHDF/CellData"], file["VTKHDF/Points"][()]
        columns = [cells[name][()] for name in ("bond", "damage", "opening", "slip")]
        for index, values in enumerate(zip(*columns)):
            one, other = (tuple(point[:2].tolist()) for point in points[2 * index:2 * index + 2])
            yield (one, other, *values)


def broken_contacts(run):
    """Of every broken contact: both ends at the start (m), opening and slip (m)."""
    for one, other, bond, _, opening, slip in contacts_of(run):
        if bond == BROKEN:
            yield one, other, opening, slip


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


def written_discs(folder, beam):
    path = folder / f"discs_{beam.seed}.dat"
    path.write_text("".join(f"{x!r} {y!r} {radius!r}\n" for (x, y), radius in discs_of(beam.run).items()))
    return path


def written_faces(folder, beam, name, contacts):
    """The file of the faces of contacts (both ends, and a value) between particles."""
    radius_of = discs_of(beam.run)
    faces = ((*face(one, other, radius_of), value) for one, other, value in contacts
             if one in radius_of and other in radius_of)
    path = folder / f"{name}_{beam.seed}.dat"
    path.write_text("".join(f"{a[0]!r} {a[1]!r} {value!r}\n{b[0]!r} {b[1]!r} {value!r}\n\n" for a, b, value in faces))
    return path


def crack_panel(folder, beam):
    crack = written_faces(folder, beam, "crack", ((one, other, 1.0) for one, other, _, _ in broken_contacts(beam.run)))
    return f"""
set title 'seed {beam.seed}'
plot '{written_discs(folder, beam)}' using 1:2:3 with circles lc rgb '#e8e4dc' notitle, \\
     $notch using 1:2 with lines lw 3 lc rgb '#2060a0' title 'notch', \\
     '{crack}' using 1:2 with lines lw 3 lc rgb '#c0392b' title 'broken bonds'
"""


def damage_panel(folder, beam):
    damaged = written_faces(folder, beam, "damage", ((one, other, float(damage))
                                                     for one, other, _, damage, _, _ in contacts_of(beam.run) if damage > 0))
    return f"""
set title 'seed {beam.seed}'
plot '{written_discs(folder, beam)}' using 1:2:3 with circles lc rgb '#f0eee8' notitle, \\
     $notch using 1:2 with lines lw 3 lc rgb '#2060a0' title 'notch', \\
     '{damaged}' using 1:2:3 with lines lw 3 lc palette notitle
"""


def panels(zone, notch, size, layout, parts):
    """A gnuplot script: pictures of the zone (low and high x, low and high y, m) with the notch (x, height) side by side."""
    (low_x, high_x), (low_y, high_y) = zone
    x, height = notch
    return f"""
$notch << end
{x} 0
{x} {height}
end
set terminal pngcairo size {size[0]},{size[1]} font 'sans,11'
set multiplot layout {layout}
set size ratio -1
set xrange [{low_x}:{high_x}]
set yrange [{low_y}:{high_y}]
set cbrange [0:1]
set palette defined (0 '#f7c948', 0.5 '#e67e22', 1 '#7b1e12')
set cblabel 'damage'
set xlabel 'x (m)'
set ylabel 'y (m)'
set key below
set style fill solid 1.0 border lc rgb '#a8a8a8'
{"".join(parts)}
unset multiplot
"""
