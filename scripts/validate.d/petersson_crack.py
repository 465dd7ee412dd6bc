"""The crack of Petersson's beam in four assemblies."""
from beam_crack import crack_panel, panels
from validation import plot

ZONE = (0.9, 1.1), (0.0, 0.2)  # m
NOTCH = 1.0, 0.1  # m


def crack_section(folder, beams):
    parts = [crack_panel(folder, beam) for beam in beams]
    return ["## The crack", "",
            "The four assemblies at the end, places at the start: the faces of the contacts between particles whose bond is "
            "broken. The crack runs from the tip of the notch towards the platen, around large particles.", ""
            ] + plot(panels(ZONE, NOTCH, (1400, 1480), "2,2", parts), "petersson_crack",
                     "Broken bonds above the notch in four assemblies")
