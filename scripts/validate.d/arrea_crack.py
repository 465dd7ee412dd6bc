"""Cracks of four assemblies, and damage of two: the paper's Figs. 15 and 16."""
from beam_crack import crack_panel, damage_panel, panels
from validation import plot

ZONE = (-0.15, 0.15), (0.0, 0.306)  # m
NOTCH = 0.0, 0.082  # m


def breaks_elsewhere(beams):
    """A paragraph on the beams that break in bending instead; none if there are none."""
    text = " ".join(
        f"Seed {beam.seed} bears {beam.peak * 1e-3:.0f} kN and then breaks in bending over the left support, where the outer "
        f"platen's load makes {beam.bending_stress_over_left_support() * 1e-6:.2f} MPa by beam theory."
        for beam in beams if beam.breaks_over_left_support())
    if not text:
        return []
    stresses = ", ".join(f"{beam.bending_stress_over_left_support() * 1e-6:.2f}" for beam in beams
                         if not beam.breaks_over_left_support())
    return [f"{text} The mouth slides back then, which ends the run. In the others that stress "
            f"stays below ({stresses} MPa).", ""]


def crack_section(folder, beams):
    lines = ["## Cracks and damage", "",
             "The four assemblies at the end, places at the start: the faces of the contacts between particles whose bond is "
             "broken. Load comes from the inner platen at x = 61 mm on top and a support at x = -61 mm below. At the tip the "
             "crack turns away from the vertical by more than 45°: at first the mouth of the notch slides and hardly opens "
             "(in finite elements by a tenth of its sliding, see below), and where a notch only slides the largest tension "
             "around its tip stands at 70.5° to it.", "", *breaks_elsewhere(beams)]
    lines += plot(panels(ZONE, NOTCH, (1400, 1560), "2,2", [crack_panel(folder, beam) for beam in beams]), "arrea_crack",
                  "Broken bonds of four assemblies of the beam in mixed mode")
    lines += ["Damage of the bonds of two of them, from 0 to 1, where there is any:", ""]
    return lines + plot(panels(ZONE, NOTCH, (1400, 700), "1,2", [damage_panel(folder, beam) for beam in beams[:2]]),
                        "arrea_damage", "Damage of the bonds of two assemblies")
