#!/usr/bin/python3
"""Draws the hybrid model of a run: elements, and particles as discs, in their displaced places.

    xvfb-run -a /usr/bin/python3 scripts/render_fields.py RUN_DIR OUT.png [--step N] [--scale S] [--color NAME]

Needs the Python of ParaView (Debian: python3-paraview, xvfb, xauth); with python3-h5py units are shown, too.
"""

import argparse
import math
import re
import sys
import tomllib
from pathlib import Path

import numpy
import vtkmodules.vtkRenderingFreeType  # noqa: F401 (importing it registers the fonts)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (importing it registers the window)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkExtractEdges
from vtkmodules.vtkFiltersGeneral import vtkWarpVector
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource
from vtkmodules.vtkIOHDF import vtkHDFReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkDataSetMapper,
    vtkGlyph3DMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

MODEL_WIDTH, MODEL_HEIGHT = 1600, 1100  # largest picture of the model, pixels
HEADER, FOOTER, MARGIN = 70, 140, 30  # title, colour bar, blank border, pixels
SMALLEST_OUTLINED_RADIUS = 4  # pixels; outlines of smaller discs would hide their colours
LINE_HEIGHT = 0.01  # above the faces; the camera stands at 1
INK = (0.15, 0.15, 0.15)
GREY = (0.82, 0.82, 0.82)
COMPONENTS = {"x": 0, "y": 1, "z": 2, "xx": 0, "yy": 1, "xy": 2}
VIRIDIS = ("440154", "482878", "3e4989", "31688e", "26828e", "1f9e89", "35b779", "6ece58", "b5de2b", "fde725")
DIVERGING = ("3b4cc0", "7b9ff9", "c0d4f5", "f2f2f2", "f7b89c", "e7745b", "b40426")


def fail(message):
    sys.exit(f"render_fields.py: {message}")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("run_directory", type=Path)
    parser.add_argument("picture", type=Path, help="PNG file to write")
    parser.add_argument("--step", type=int, help="step of an output (default: the last one)")
    parser.add_argument("--scale", type=float, help="factor on displacements (default: the largest is well visible)")
    parser.add_argument(
        "--color",
        default="displacement",
        metavar="NAME",
        help="array that gives the colour: the magnitude, or one component as in stress:xx (default: displacement)",
    )
    return parser.parse_args()


def output_steps(folder):
    names = (re.fullmatch(r"(?:particles|elements)_(\d{6,})\.hdf", path.name) for path in folder.glob("*.hdf"))
    return sorted({int(name[1]) for name in names if name})


def read_grid(path):
    """The unstructured grid of a field file, None if there is no such file or it has no cells."""
    if not path.exists():
        return None
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    return grid if grid.GetNumberOfCells() > 0 else None


def unit_of(path, name):
    try:
        import h5py
    except ImportError:
        return ""
    with h5py.File(path, "r") as file:
        for data in ("PointData", "CellData"):
            if name in file["VTKHDF"][data]:
                unit = file["VTKHDF"][data][name].attrs.get("unit", b"").decode()
                return "" if unit == "1" else unit
    return ""


def case_title(run_directory):
    for name in ("case_resolved.toml", "case.toml"):
        try:
            return tomllib.loads((run_directory / name).read_text()).get("title", run_directory.name)
        except (OSError, tomllib.TOMLDecodeError):
            continue
    return run_directory.name


def colour_values(data, color):
    """The numbers behind the colour in point or cell data, None if the array is not there."""
    name, _, component = color.partition(":")
    array = data.GetArray(name)
    if array is None:
        return None
    values = vtk_to_numpy(array).astype(float)
    if not component:
        return values if values.ndim == 1 else numpy.linalg.norm(values, axis=1)
    if component not in COMPONENTS or values.ndim == 1 or COMPONENTS[component] >= values.shape[1]:
        fail(f"'{name}' has no component '{component}'")
    return values[:, COMPONENTS[component]]


def add_colour(grid, color):
    """Adds the array `colour` to the points or cells; returns its range, None if the grid does not have the array."""
    for data in (grid.GetPointData(), grid.GetCellData()):
        values = colour_values(data, color)
        if values is not None:
            array = numpy_to_vtk(values, deep=True)
            array.SetName("colour")
            data.AddArray(array)
            data.SetActiveScalars("colour")
            return numpy.nanmin(values), numpy.nanmax(values)
    return None


def colour_table(low, high):
    """Equal steps of brightness; values of both signs get two colours that meet at zero."""
    two_signs = low < 0 < high
    if two_signs:
        low, high = -max(-low, high), max(-low, high)
    if not high > low:
        low, high = low - (abs(low) or 1) * 1e-3, high + (abs(high) or 1) * 1e-3
    palette = DIVERGING if two_signs else VIRIDIS
    anchors = numpy.array([[int(code[i : i + 2], 16) / 255 for i in (0, 2, 4)] for code in palette])
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetRange(low, high)
    for i, place in enumerate(numpy.linspace(0, len(anchors) - 1, 256)):
        rgb = [numpy.interp(place, range(len(anchors)), anchors[:, channel]) for channel in range(3)]
        table.SetTableValue(i, *rgb, 1.0)
    return table


def model_size(grids):
    bounds = numpy.array([grid.GetBounds() for grid in grids])
    return math.hypot(bounds[:, 1].max() - bounds[:, 0].min(), bounds[:, 3].max() - bounds[:, 2].min())


def default_scale(grids):
    """A round factor that draws the largest displacement about a twentieth of the model long."""
    displacements = (vtk_to_numpy(grid.GetPointData().GetArray("displacement")) for grid in grids)
    largest = max(numpy.linalg.norm(values, axis=1).max() for values in displacements)
    if not largest > 0:
        return 1.0
    wanted = max(1.0, 0.05 * model_size(grids) / largest)
    decade = 10.0 ** math.floor(math.log10(wanted))
    return decade * max(factor for factor in (1, 2, 5) if factor * decade <= wanted * (1 + 1e-12))


def warped(grid, scale):
    warp = vtkWarpVector()
    warp.SetInputData(grid)
    warp.SetInputArrayToProcess(0, 0, 0, 0, "displacement")
    warp.SetScaleFactor(scale)
    warp.Update()
    return warp.GetOutput()


def model_box(elements, particles):
    """x and y range of all that is drawn."""
    corners = []
    if elements:
        bounds = elements.GetBounds()
        corners += [(bounds[0], bounds[2]), (bounds[1], bounds[3])]
    if particles:
        centres = vtk_to_numpy(particles.GetPoints().GetData())[:, :2]
        radii = vtk_to_numpy(particles.GetPointData().GetArray("radius"))[:, None]
        corners += [(centres - radii).min(axis=0), (centres + radii).max(axis=0)]
    return numpy.min(corners, axis=0), numpy.max(corners, axis=0)


def apply_colours(mapper, actor, table):
    mapper.SetLookupTable(table)
    mapper.SetUseLookupTableScalarRange(True)
    actor.SetMapper(mapper)
    actor.GetProperty().SetLighting(False)
    actor.GetProperty().SetColor(*GREY)


def make_lines(mapper, actor):
    """Dark lines that lie above the coloured faces."""
    mapper.ScalarVisibilityOff()
    actor.GetProperty().SetColor(*INK)
    actor.SetPosition(0, 0, LINE_HEIGHT)


def element_actor(grid, table):
    mapper, actor = vtkDataSetMapper(), vtkActor()
    mapper.SetInputData(grid)
    apply_colours(mapper, actor, table)
    return actor


def edge_actor(grid, table):
    edges = vtkExtractEdges()
    edges.SetInputData(grid)
    mapper, actor = vtkDataSetMapper(), vtkActor()
    mapper.SetInputConnection(edges.GetOutputPort())
    apply_colours(mapper, actor, table)
    make_lines(mapper, actor)
    actor.GetProperty().SetLineWidth(1.5)
    return actor


def disc_actor(grid, table, outline):
    disc = vtkRegularPolygonSource()
    disc.SetNumberOfSides(32)
    disc.SetRadius(1.0)
    disc.SetGeneratePolygon(not outline)
    disc.SetGeneratePolyline(outline)
    mapper, actor = vtkGlyph3DMapper(), vtkActor()
    mapper.SetInputData(grid)
    mapper.SetSourceConnection(disc.GetOutputPort())
    mapper.SetScaleArray("radius")
    mapper.SetScaleModeToScaleByMagnitude()
    apply_colours(mapper, actor, table)
    if outline:
        make_lines(mapper, actor)
    return actor


def text_actor(text, size, place):
    actor = vtkTextActor()
    actor.SetInput(text)
    style = actor.GetTextProperty()
    style.SetFontSize(size)
    style.SetColor(*INK)
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToCentered()
    actor.SetPosition(*place)
    return actor


def colour_bar(table, width):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(5)
    bar.SetMaximumNumberOfColors(256)
    low, high = table.GetRange()
    bar.SetLabelFormat("%.3g" if 1e-2 <= max(-low, high) < 1e5 else "%.2e")
    bar.SetTextPad(8)
    bar.UnconstrainedFontSizeOn()
    bar.SetTextPositionToPrecedeScalarBar()
    bar.GetLabelTextProperty().SetFontSize(22)
    bar.GetLabelTextProperty().SetColor(*INK)
    bar.GetLabelTextProperty().ShadowOff()
    bar.GetLabelTextProperty().ItalicOff()
    bar.GetLabelTextProperty().BoldOff()
    bar.GetPositionCoordinate().SetCoordinateSystemToDisplay()
    bar.GetPositionCoordinate().SetValue(0.2 * width, 20)
    bar.GetPosition2Coordinate().SetCoordinateSystemToDisplay()
    bar.GetPosition2Coordinate().SetValue(0.6 * width, 70)
    return bar


def model_renderer(box, width, height):
    """A view of the box from above, as large as fits between title and colour bar."""
    low, high = box
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetViewport(0, FOOTER / height, 1, 1 - HEADER / height)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    middle = (low + high) / 2
    camera.SetFocalPoint(*middle, 0)
    camera.SetPosition(*middle, 1)
    pixel = pixel_size(box)
    camera.SetParallelScale((height - HEADER - FOOTER) * pixel / 2)
    camera.SetClippingRange(0.5, 1.5)
    return renderer


def pixel_size(box):
    width, height = box[1] - box[0]
    return max(width / MODEL_WIDTH, height / MODEL_HEIGHT)


def picture_size(box):
    pixels = numpy.ceil((box[1] - box[0]) / pixel_size(box)) + 2 * MARGIN
    return max(900, int(pixels[0])), int(pixels[1]) + HEADER + FOOTER


def frame_renderer(title, legend, table, width, height):
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor2D(text_actor(title, 28 if width > 1200 else 20, (width / 2, height - HEADER / 2)))
    renderer.AddActor2D(colour_bar(table, width))
    renderer.AddActor2D(text_actor(legend, 22, (width / 2, FOOTER - 25)))
    return renderer


def write_picture(renderers, width, height, path):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(width, height)
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    if writer.GetErrorCode() != 0:
        fail(f"cannot write {path}")


def draw_model(elements, particles, box, table, width, height):
    model = model_renderer(box, width, height)
    if elements:
        model.AddActor(element_actor(elements, table))
        model.AddActor(edge_actor(elements, table))
    if particles:
        model.AddActor(disc_actor(particles, table, outline=False))
        radii = vtk_to_numpy(particles.GetPointData().GetArray("radius"))
        if numpy.median(radii) / pixel_size(box) > SMALLEST_OUTLINED_RADIUS:
            model.AddActor(disc_actor(particles, table, outline=True))
    return model


def color_title(path, color):
    unit = unit_of(path, color.partition(":")[0])
    name = "displacement magnitude" if color == "displacement" else color.replace(":", " ")
    return f"{name} ({unit})" if unit else name


def field_paths(run_directory, step):
    """The output of this step, or of the last one, by group; and its step."""
    folder = run_directory / "fields"
    steps = output_steps(folder)
    if not steps:
        fail(f"no field files in {folder}")
    chosen = steps[-1] if step is None else step
    if chosen not in steps:
        fail(f"no output at step {chosen}; there are {', '.join(map(str, steps))}")
    return {group: folder / f"{group}_{chosen:06}.hdf" for group in ("elements", "particles")}, chosen


def main():
    arguments = parse_arguments()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)
    run_directory = arguments.run_directory.resolve()
    paths, step = field_paths(run_directory, arguments.step)
    grids = {group: grid for group, path in paths.items() if (grid := read_grid(path))}
    if not grids:
        fail(f"the output at step {step} has neither elements nor particles")
    ranges = {group: span for group, grid in grids.items() if (span := add_colour(grid, arguments.color))}
    if not ranges:
        fail(f"no array '{arguments.color}' in the output at step {step}")
    table = colour_table(min(span[0] for span in ranges.values()), max(span[1] for span in ranges.values()))

    scale = default_scale(grids.values()) if arguments.scale is None else arguments.scale
    drawn = {group: warped(grid, scale) for group, grid in grids.items()}
    elements, particles = drawn.get("elements"), drawn.get("particles")
    box = model_box(elements, particles)
    width, height = picture_size(box)
    title = f"{case_title(run_directory)}, step {step}, displacements \u00d7 {scale:g}"
    legend = color_title(paths[next(iter(ranges))], arguments.color)
    frame = frame_renderer(title, legend, table, width, height)
    model = draw_model(elements, particles, box, table, width, height)
    write_picture([frame, model], width, height, arguments.picture.resolve())


if __name__ == "__main__":
    main()
