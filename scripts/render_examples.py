#!/usr/bin/python3
"""Draws the maps that the example programs wrote, for the manual.

Usage: xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" scripts/render_examples.py FOLDER [OUTPUT_FOLDER]
FOLDER is where the example programs were run. Needs the Debian packages python3-pil, python3-vtk9, xauth and xvfb.
"""
import sys
import tempfile
from pathlib import Path

from PIL import Image
import vtk

ROOT = Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "benchmark/Volume_mesh_parameterization/paper"))
import render  # noqa: E402

LARGEST = 10  # of the distortions that are told apart
HEIGHT = 340  # of a picture

# name of the .vtu file: direction to the eye, direction upwards, normal of the plane that cuts the image
VIEWS = {
    "twisted": ((2, 1, 3), (0, 1, 0), (0, 0, 1)),
    "elephant_to_ball": ((2, 1, 3), (0, 1, 0), (0, 0, 1)),
    "elephant_to_cube": ((2, 1, 3), (0, 1, 0), (0, 0, 1)),
    "polycube": ((2, -3, 2), (0, 0, 1), (0, -1, 0)),
    "sliding_boundary": ((2, -3, 2), (0, 0, 1), (0, -1, 0)),
}


def join(panels, output, height=HEIGHT):
    """Puts pictures side by side and stores them with 256 colors, which keeps the file small."""
    images = [Image.open(panel).convert("RGB") for panel in panels]
    row = Image.new("RGB", (sum(image.width for image in images), images[0].height))
    x = 0
    for image in images:
        row.paste(image, (x, 0))
        x += image.width
    row.resize((row.width * height // row.height, height), Image.LANCZOS).quantize(256).save(output, optimize=True)


def grid_lines(grid, number=16):
    """Where the surface is cut by a regular grid in the parameter domain."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.Update()
    surface = surface.GetOutput()
    uvw = surface.GetPointData().GetArray("uvw")
    ranges = [uvw.GetRange(i) for i in range(3)]
    step = max(high - low for low, high in ranges) / number
    lines = vtk.vtkAppendPolyData()
    for i, (low, high) in enumerate(ranges):
        coordinate = vtk.vtkDoubleArray()
        coordinate.SetNumberOfTuples(uvw.GetNumberOfTuples())
        coordinate.CopyComponent(0, uvw, i)
        level_set = vtk.vtkPolyData()
        level_set.CopyStructure(surface)
        level_set.GetPointData().SetScalars(coordinate)
        contours = vtk.vtkContourFilter()
        contours.SetInputData(level_set)
        for k in range(int((high - low) / step) + 1):  # not in the plane of a facet
            contours.SetValue(k, low + (k + 0.5) * step)
        contours.Update()
        lines.AddInputData(contours.GetOutput())
    lines.Update()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(lines.GetOutput())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.1, 0.25, 0.5)
    actor.GetProperty().SetLineWidth(2)
    actor.GetProperty().LightingOff()
    return actor


def draw_map(vtu, output):
    """The source, its image, and the distortion of angles in one half of the image."""
    direction, up, normal = VIEWS[vtu.stem]
    source = render.read(str(vtu))
    image = render.image_of(source)
    distortion = render.colored_surface(render.cut(image, normal), "angle_distortion", LARGEST)
    with tempfile.TemporaryDirectory() as name:
        panels = [Path(name) / f"{i}.png" for i in range(3)]
        render.picture(panels[0], [render.surface(source)], direction, up)
        render.picture(panels[1], [render.surface(image)], direction, up)
        render.picture(panels[2], [distortion], direction, up, legend=True)
        join(panels, output)


def draw_grid(vtu, output, icon):
    """A regular grid in the parameter domain, and what it becomes in the source; the latter also as a small picture."""
    direction, up, _ = VIEWS[vtu.stem]
    source = render.read(str(vtu))
    with tempfile.TemporaryDirectory() as name:
        panels = [Path(name) / f"{i}.png" for i in range(2)]
        for panel, grid in zip(panels, (render.image_of(source), source)):
            render.picture(panel, [render.surface(grid, edges=False), grid_lines(grid)], direction, up)
        join(panels, output)
        join(panels[1:], icon, 160)


def draw_hexahedra(vtu, output):
    """Hexahedra, and those of one half with their scaled Jacobians."""
    direction, up, normal = VIEWS["polycube"]
    mesh = render.read(str(vtu))
    quality = render.quality_surface(render.cut(mesh, normal), "scaled_jacobian")
    with tempfile.TemporaryDirectory() as name:
        panels = [Path(name) / f"{i}.png" for i in range(2)]
        render.picture(panels[0], [render.surface(mesh)], direction, up)
        render.picture(panels[1], [quality], direction, up, legend=True)
        join(panels, output)


def main(folder, output_folder):
    for name in VIEWS:
        draw_map(folder / f"{name}.vtu", output_folder / f"{name}.png")
    draw_grid(folder / "polycube.vtu", output_folder / "polycube_grid.png", output_folder / "icon.png")
    draw_hexahedra(folder / "hexahedra.vtu", output_folder / "hexahedra.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "doc/Volume_mesh_parameterization/fig")
