#!/usr/bin/python3
"""Draws the maps that the example programs wrote, for the manual.

Usage: xvfb-run -a -s "-screen 0 2560x1280x24 -noreset" scripts/render_examples.py FOLDER [OUTPUT_FOLDER]
FOLDER is where the example programs were run. Needs the Debian packages python3-matplotlib, python3-pil, python3-vtk9, xauth
and xvfb.
"""
import sys
import tempfile
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.colors import ListedColormap, LogNorm, Normalize  # noqa: E402
import numpy  # noqa: E402
from PIL import Image  # noqa: E402
import vtk  # noqa: E402
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "benchmark/Volume_mesh_parameterization/paper"))
import render  # noqa: E402

LARGEST = 10  # largest distortion that colors tell apart
DPI = 200  # pictures are shown at half their size, on screens with small pixels at all of it
render.SIZE = 1040  # pixels of a picture

# name of the .vtu file: direction to the eye, direction upwards, normal of the plane that cuts
VIEWS = {
    "twisted": ((2, 1, 3), (0, 1, 0), (0, 0, 1)),
    "elephant_to_cube": ((2, 1, 3), (0, 1, 0), (0, 0, 1)),
    "polycube": ((2, -3, 2), (0, 0, 1), (0, -1, 0)),
    "sliding_boundary": ((2, -3, 2), (0, 0, 1), (0, -1, 0)),
}


def surface_of(grid):
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.Update()
    return surface.GetOutput()


def line_actor(data, color, width):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-6, -6)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    return actor


def sharp_edges(grid):
    """Where faces meet: without them, faces behind each other look like one with teeth."""
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(surface_of(grid))
    edges.BoundaryEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.Update()
    return line_actor(edges.GetOutput(), (0, 0, 0), 6)


def grid_lines(grid, number=16):
    """Where the surface is cut by a regular grid in the parameter domain."""
    surface = surface_of(grid)
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
    return line_actor(lines.GetOutput(), (0.1, 0.25, 0.5), 4)


def colors_of_positions(grid):
    """A color for each position in the domain: red, green and blue grow with the coordinates."""
    uvw = vtk_to_numpy(grid.GetPointData().GetArray("uvw"))
    low, high = uvw.min(axis=0), uvw.max(axis=0)
    return (60 + 190 * (uvw - low) / (high - low)).astype(numpy.uint8)


def painted_surface(grid, colors):
    """The surface with a color for each vertex."""
    painted = vtk.vtkUnstructuredGrid()
    painted.ShallowCopy(grid)
    array = numpy_to_vtk(colors, deep=True, array_type=vtk.VTK_UNSIGNED_CHAR)
    painted.GetPointData().SetScalars(array)
    actor = render.surface(painted)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUsePointData()
    mapper.SetColorModeToDirectScalars()
    actor.GetProperty().SetAmbient(0.7)
    actor.GetProperty().SetDiffuse(0.3)
    return actor


def show(axes, picture, title):
    axes.imshow(pyplot.imread(picture))
    axes.set_axis_off()
    axes.set_title(title, fontsize=11)


def save(figure, output):
    """With 256 colors, which keeps the file small."""
    with tempfile.TemporaryDirectory() as name:
        figure.savefig(f"{name}/figure.png", dpi=DPI)
        picture = Image.open(f"{name}/figure.png").convert("RGB")
        picture = picture.quantize(palette=picture.quantize(256), dither=Image.Dither.FLOYDSTEINBERG)
        colors = numpy.array(picture.getpalette()).reshape(-1, 3)
        colors[picture.getpixel((0, 0))] = 255  # the background stays white
        picture.putpalette(colors.ravel().tolist())
        picture.save(output, optimize=True)
    pyplot.close(figure)


def draw_row(bodies, output, bar=None):
    """Bodies side by side, each a list of actors with its direction to the eye, direction upwards and title. The bar is
    colors, their scale and what it shows."""
    figure, axes = pyplot.subplots(1, len(bodies), figsize=(10.8, 10.8 / len(bodies)), constrained_layout=True)
    with tempfile.TemporaryDirectory() as name:
        panel = Path(name) / "panel.png"
        for panel_axes, (actors, direction, up, title) in zip(axes, bodies):
            render.picture(panel, actors, direction, up)
            show(panel_axes, panel, title)
    if bar:
        colors, norm, title = bar
        scale = matplotlib.cm.ScalarMappable(norm, ListedColormap(colors))
        drawn = figure.colorbar(scale, ax=axes, orientation="horizontal", shrink=0.4, aspect=40, label=title)
        if isinstance(norm, LogNorm):
            drawn.ax.minorticks_off()
            drawn.set_ticks([2, 3, 4, 6, 8, LARGEST], labels=["2", "3", "4", "6", "8", f"{LARGEST} and more"])
    save(figure, output)


def colors_of(actor):
    """The colors of its lookup table."""
    table = actor.GetMapper().GetLookupTable()
    return [table.GetTableValue(i)[:3] for i in range(table.GetNumberOfTableValues())]


def section(grid, direction):
    """The half of a body behind a plane, whose section has the colors of the distortion of angles."""
    actor = render.colored_surface(render.cut(grid, direction), "angle_distortion", LARGEST)
    actor.GetProperty().SetAmbient(0.85)  # so that colors are those of the scale
    actor.GetProperty().SetDiffuse(0.15)
    return actor


DISTORTION = (render.color_scale(), LogNorm(2, LARGEST), "distortion of angles (2: none), on a logarithmic scale")


def draw_map(vtu, output):
    """Source and image with the same colors, and a section of the image with its distortion."""
    direction, up, normal = VIEWS[vtu.stem]
    source = render.read(str(vtu))
    image = render.image_of(source)
    colors = colors_of_positions(source)
    draw_row([([painted_surface(source, colors)], direction, up, "mesh"),
              ([painted_surface(image, colors)], direction, up, "image; equal colors: equal points"),
              ([section(image, normal)], normal, up, "section of the image")], output, DISTORTION)


def draw_sliding(folder, output):
    """The source, and the distortion on the surface of its image with a boundary that is fixed and one that slides."""
    direction, up, _ = VIEWS["sliding_boundary"]
    grids = [render.read(str(folder / f"{name}_boundary.vtu")) for name in ("fixed", "sliding")]
    bodies = [([render.surface(grids[0])], direction, up, "mesh")]
    for grid, title in zip(grids, ("fixed boundary", "vertices have slid in faces and along edges")):
        distortion = render.colored_surface(render.image_of(grid), "angle_distortion", LARGEST)
        distortion.GetProperty().SetEdgeVisibility(True)
        bodies.append(([distortion], direction, up, title))
    draw_row(bodies, output, DISTORTION)


def body_with_grid(grid):
    return [render.surface(grid, edges=False), grid_lines(grid), sharp_edges(grid)]


def draw_grid(vtu, output):
    """A regular grid in the parameter domain, and what it becomes in the source."""
    direction, up, _ = VIEWS[vtu.stem]
    source = render.read(str(vtu))
    draw_row([(body_with_grid(render.image_of(source)), direction, up, "polycube with a regular grid"),
              (body_with_grid(source), direction, up, "part with the same grid")], output)


def draw_overview(folder, output, icon):
    """A part, its polycube and hexahedra; the last one also as a small picture."""
    direction, up, _ = VIEWS["polycube"]
    source = render.read(str(folder / "polycube.vtu"))
    colors = colors_of_positions(source)
    hexahedra = [render.surface(render.read(str(folder / "hexahedra.vtu")))]
    draw_row([([painted_surface(source, colors)], direction, up, "tetrahedra"),
              ([painted_surface(render.image_of(source), colors)], direction, up, "their map to a polycube"),
              (hexahedra, direction, up, "hexahedra by the inverse map")], output)
    render.picture(icon, hexahedra, direction, up)
    picture = Image.open(icon).convert("RGB").resize((320, 320), Image.LANCZOS)
    picture.quantize(256).save(icon, optimize=True)


def surface_with_field(grid, largest):
    """Colored by a field of the vertices, from 0, orange, to the largest value, blue."""
    table = vtk.vtkLookupTable()
    table.SetHueRange(0.08, 0.6)
    table.SetSaturationRange(0.6, 0.6)
    table.SetTableRange(0, largest)
    table.Build()
    actor = render.surface(grid, edges=False)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("field")
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    return actor


def landmarks(grid):
    """A ball at each marked vertex."""
    marks = vtk_to_numpy(grid.GetPointData().GetArray("landmark"))
    for position in vtk_to_numpy(grid.GetPoints().GetData())[marks > 0]:
        ball = vtk.vtkSphereSource()
        ball.SetCenter(*position)
        ball.SetRadius(0.025 * grid.GetLength())
        ball.Update()
        actor = line_actor(ball.GetOutput(), (0.75, 0.05, 0.1), 1)
        actor.GetProperty().LightingOn()
        yield actor


def draw_carried(folder, output):
    """A field, a regular grid and the landmarks of the elephant, and what becomes of them on the bull."""
    grids = [render.read(str(folder / f"{name}.vtu")) for name in ("elephant", "bull")]
    largest = grids[0].GetPointData().GetArray("field").GetRange()[1]
    bodies = [([surface_with_field(grid, largest), grid_lines(grid), *landmarks(grid)], direction, (0, 1, 0), title)
              for grid, direction, title in zip(grids, ((2, 1, 3), (-2, 1, 3)), ("elephant", "bull"))]
    draw_row(bodies, output, (colors_of(bodies[0][0][0]), Normalize(0, 100), "distance from the tip of the trunk, in % of the largest one"))


def draw_texture(folder, output):
    """The texture in a section of the cube, on the body, and in a section of it."""
    direction, up, normal = (1, -2, 2), (0, 1, 0), (0, 0, 1)
    body = render.read(str(folder / "solid_texture.vtu"))
    sections = [surface_with_field(render.cut(grid, normal), 1) for grid in (render.image_of(body), body)]
    draw_row([([sections[0]], direction, up, "section of the cube"), ([surface_with_field(body, 1)], direction, up, "body"),
              ([sections[1]], direction, up, "section of the body")], output)


def draw_detail(folder, output):
    """The body with the bumps, the other body, and its image with them."""
    direction, up = (1, -2, 2), (0, 1, 0)
    source, target = (render.read(str(folder / f"{name}.vtu")) for name in ("bumpy_ball", "transferred_detail"))
    draw_row([([render.surface(grid, edges=False)], direction, up, title)
              for grid, title in ((source, "ball with bumps"), (target, "another body"),
                                  (render.image_of(target), "with the bumps of the ball"))], output)


def control_net(filename):
    """The coefficients of a trivariate spline with equal numbers along its axes, as hexahedra."""
    rows = numpy.array([line.split() for line in Path(filename).read_text().splitlines() if line and line[0] not in "<"], float)
    n = round(len(rows) ** (1 / 3))
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(n, n, n)
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(rows, deep=True))
    grid.SetPoints(points)
    whole = vtk.vtkAppendFilter()
    whole.AddInputData(grid)
    whole.Update()
    return whole.GetOutput()


def draw_spline(folder, output):
    """The control net of a spline, and one half of it."""
    net = control_net(folder / "spline.xml")
    draw_row([([render.surface(grid)], (1, -2, 2), (0, 1, 0), title)
              for grid, title in ((net, "control net"), (render.whole_cells_behind(net, (0, 0, 1)), "one half of it"))], output)


def draw_moving(folder, output):
    """The half of the mesh behind the middle, at the beginning and after each quarter of the way."""
    frames = [render.read(str(folder / f"moving_boundary_{i}.vtu")) for i in range(1, 5)]
    grids = [frames[0], *(render.image_of(frame) for frame in frames)]
    draw_row([([render.surface(render.whole_cells_behind(grid, (0, 0, 1)))], (0, 0, 1), (0, 1, 0), title)
              for grid, title in zip(grids, ("mesh of the beginning", "1/4", "1/2", "3/4", "end"))], output)


def draw_conditions(folder, output):
    """Bodies with a free boundary and their images, in the same colors."""
    bodies = []
    for name, title, title_of_image in (("bent_bar", "bar", "ends at their targets"),
                                        ("flattened_slab", "folded slab", "bottom and top in planes")):
        source = render.read(str(folder / f"{name}.vtu"))
        colors = colors_of_positions(source)
        bodies += [([painted_surface(body, colors)], (1, -3, 1), (0, 0, 1), words)
                   for body, words in ((source, title), (render.image_of(source), title_of_image))]
    draw_row(bodies, output)


def draw_hexahedra(vtu, output):
    """Hexahedra, and those of one half with their scaled Jacobians."""
    direction, up, normal = VIEWS["polycube"]
    mesh = render.read(str(vtu))
    quality = render.quality_surface(render.whole_cells_behind(mesh, normal), "scaled_jacobian")
    draw_row([([render.surface(mesh)], direction, up, "hexahedra"), ([quality], direction, up, "those of one half")], output,
             (colors_of(quality), Normalize(0, 1), "scaled Jacobian (right angles: 1)"))


def main(folder, output_folder):
    draw_carried(folder, output_folder / "body_to_body.png")
    for name in ("twisted", "elephant_to_cube", "polycube"):
        draw_map(folder / f"{name}.vtu", output_folder / f"{name}.png")
    draw_sliding(folder, output_folder / "sliding_boundary.png")
    draw_grid(folder / "polycube.vtu", output_folder / "polycube_grid.png")
    draw_overview(folder, output_folder / "overview.png", output_folder / "icon.png")
    draw_texture(folder, output_folder / "solid_texture.png")
    draw_detail(folder, output_folder / "transferred_detail.png")
    draw_spline(folder, output_folder / "spline_of_map.png")
    draw_moving(folder, output_folder / "moving_boundary.png")
    draw_conditions(folder, output_folder / "free_boundary.png")
    draw_hexahedra(folder / "hexahedra.vtu", output_folder / "hexahedra.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "doc/Volume_mesh_parameterization/fig")
