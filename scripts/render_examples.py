#!/usr/bin/python3
"""Draws the maps that the example programs wrote, for the manual.

Usage: xvfb-run -a -s "-screen 0 2560x1280x24 -noreset" scripts/render_examples.py FOLDER [OUTPUT_FOLDER]
FOLDER is where the example programs were run. If it has convergence.json, a report of parameterize_mesh_file, its steps
are drawn. Needs the Debian packages python3-matplotlib, python3-pil, python3-vtk9, xauth and xvfb.
"""
import json
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

# name of the .vtu file: direction to the eye, direction upwards, normal of the plane that cuts the image
VIEWS = {
    "twisted": ((2, 1, 3), (0, 1, 0), (0, 0, 1)),
    "elephant_to_ball": ((2, 1, 3), (0, 1, 0), (0, 0, 1)),
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
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    return actor


def edges_of_domain(grid):
    """Where faces of the domain meet: without them, faces behind each other look like one with teeth."""
    surface = surface_of(grid)
    positions = surface.GetPoints().GetData()
    positions.SetName("position")
    surface.GetPointData().AddArray(positions)
    points = vtk.vtkPoints()
    points.SetData(surface.GetPointData().GetArray("uvw"))
    domain = vtk.vtkPolyData()
    domain.ShallowCopy(surface)
    domain.SetPoints(points)
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(domain)
    edges.BoundaryEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.Update()
    lines = edges.GetOutput()
    points = vtk.vtkPoints()
    points.SetData(lines.GetPointData().GetArray("position"))
    lines.SetPoints(points)
    return line_actor(lines, (0, 0, 0), 6)


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
    """A colour for each position in the domain: red, green and blue grow with the coordinates."""
    uvw = vtk_to_numpy(grid.GetPointData().GetArray("uvw"))
    low, high = uvw.min(axis=0), uvw.max(axis=0)
    return (60 + 190 * (uvw - low) / (high - low)).astype(numpy.uint8)


def painted_surface(grid, colors):
    """The surface with a colour for each vertex."""
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


def opened(grid, array, normal, up):
    """Both halves of a body, opened like a book: one sees the planar cut of each."""
    right = numpy.cross(up, normal)
    bounds = numpy.array(grid.GetBounds()).reshape(3, 2)
    width = abs(right) @ (bounds[:, 1] - bounds[:, 0])
    turn = vtk.vtkTransform()
    turn.Translate(*(1.08 * width * right))
    turn.Translate(*bounds.mean(axis=1))
    turn.RotateWXYZ(180, *up)
    turn.Translate(*(-bounds.mean(axis=1)))
    halves = [render.colored_surface(render.cut(grid, n), array, LARGEST)
              for n in (normal, tuple(-x for x in normal))]
    turned = vtk.vtkTransformPolyDataFilter()
    surface = halves[1].GetMapper().GetInputConnection(0, 0)
    turned.SetInputConnection(surface)
    turned.SetTransform(turn)
    halves[1].GetMapper().SetInputConnection(turned.GetOutputPort())
    for half in halves:
        half.GetProperty().SetAmbient(0.85)  # so that colours are those of the scale
        half.GetProperty().SetDiffuse(0.15)
    return halves


def volumes(grid):
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    points = vtk_to_numpy(grid.GetPoints().GetData())[cells].astype(float)
    return numpy.linalg.det(points[:, 1:] - points[:, :1]) / 6


def scale_to_source_volume(grid):
    """Lets the distortions of volumes be those of the map scaled to the volume of the source."""
    volume = volumes(grid)
    determinant = vtk_to_numpy(grid.GetCellData().GetArray("det_J"))
    determinant = determinant * volume.sum() / (determinant * volume).sum()
    array = numpy_to_vtk(determinant + 1 / determinant, deep=True)
    array.SetName("volume_distortion")
    grid.GetCellData().AddArray(array)


def draw_histogram(axes, grid):
    """Which share of the volume of the source has which distortion."""
    volume = volumes(grid)
    for array, name, color in (("angle_distortion", "angles", "tab:blue"),
                               ("volume_distortion", "volumes", "tab:orange")):
        values = vtk_to_numpy(grid.GetCellData().GetArray(array))
        order = numpy.argsort(values)
        share = volume[order].cumsum() / volume.sum()
        percentiles = [values[order][min(numpy.searchsorted(share, p), len(order) - 1)] for p in (0.5, 0.95, 0.99)]
        label = f"{name}: " + ", ".join(f"{x:.3g}" for x in [*percentiles, values.max()])
        axes.hist(values.clip(max=2 * LARGEST), numpy.geomspace(2, 2 * LARGEST, 33), histtype="step", color=color,
                  weights=100 * volume / volume.sum(), label=label)
    axes.set_xscale("log")
    axes.set_xlim(2, 2 * LARGEST)
    axes.set_xticks([2, 3, 5, 10, 20], ["2", "3", "5", "10", "20+"])
    axes.minorticks_off()
    axes.set_xlabel("distortion")
    axes.set_ylabel("% of the volume")
    axes.legend(frameon=False, title="median, 95 %, 99 %, max", fontsize=7.5, title_fontsize=7.5, handlelength=1,
                loc="upper right")


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
    colours, the values at its ends and what it shows."""
    figure, axes = pyplot.subplots(1, len(bodies), figsize=(10.8, 10.8 / len(bodies)), constrained_layout=True)
    with tempfile.TemporaryDirectory() as name:
        panel = Path(name) / "panel.png"
        for panel_axes, (actors, direction, up, title) in zip(axes, bodies):
            render.picture(panel, actors, direction, up)
            show(panel_axes, panel, title)
    if bar:
        colors, (low, high), title = bar
        scale = matplotlib.cm.ScalarMappable(Normalize(low, high), ListedColormap(colors))
        figure.colorbar(scale, ax=axes, orientation="horizontal", shrink=0.4, aspect=40, label=title)
    save(figure, output)


def colors_of(actor):
    """The colours of its lookup table."""
    table = actor.GetMapper().GetLookupTable()
    return [table.GetTableValue(i)[:3] for i in range(table.GetNumberOfTableValues())]


def draw_map(vtu, output):
    """Source and image with the same colours; both distortions in both halves of the image, and their histograms.
    Where the boundary slides, the targets are beside the points that the vertices have slid to."""
    direction, up, normal = VIEWS[vtu.stem]
    source = render.read(str(vtu))
    scale_to_source_volume(source)
    image = render.image_of(source)
    colors = colors_of_positions(source)
    bodies = [(source, "source"), (image, "image; equal colors: equal points")]
    fixed = vtu.with_name(vtu.stem.replace("sliding", "fixed") + ".vtu")
    if fixed != vtu:
        targets = render.read(str(fixed))
        colors = colors_of_positions(targets)
        bodies = [(source, "source"), (render.image_of(targets), "targets; equal colors: equal points"),
                  (image, "where the vertices have slid to")]

    figure = pyplot.figure(figsize=(10.8, 6.8))
    rows = figure.add_gridspec(2, 1, height_ratios=(1.25, 1), left=0.01, right=0.99, bottom=0.11, top=0.96, hspace=0.16)
    with tempfile.TemporaryDirectory() as name:
        panel = Path(name) / "panel.png"
        for axes, (grid, title) in zip(rows[0].subgridspec(1, len(bodies), wspace=0.02).subplots(), bodies):
            render.picture(panel, [painted_surface(grid, colors)], direction, up)
            show(axes, panel, title)
        below = rows[1].subgridspec(1, 3, width_ratios=(2, 2, 1.4), wspace=0.1).subplots()
        for axes, quantity in zip(below, ("angle", "volume")):
            render.picture(panel, opened(image, f"{quantity}_distortion", normal, up), normal, up, aspect=2)
            show(axes, panel, f"distortion of {quantity}s in both halves")
    draw_histogram(below[2], source)
    box = below[2].get_position()
    below[2].set_position((box.x0 + 0.02, box.y0, box.width - 0.03, box.height))
    scale = figure.add_axes((0.16, 0.075, 0.4, 0.02))
    colors = matplotlib.cm.ScalarMappable(LogNorm(2, LARGEST), ListedColormap(render.color_scale()))
    bar = figure.colorbar(colors, scale, orientation="horizontal", ticks=[2, 3, 4, 5, 6, 8, 10])
    bar.ax.minorticks_off()
    bar.ax.set_xticklabels(["2", "3", "4", "5", "6", "8", "10 and more"])
    bar.set_label("distortion (2: none), on a logarithmic scale that ends at 10")
    save(figure, output)


def draw_convergence(report, output):
    """The energy above its last value, and the inverted cells, after each step."""
    report = json.loads(report.read_text())
    first = report["untangling_iterations"]
    inverted = report["steps"]["inverted_cells"][:first]
    energy = numpy.array(report["steps"]["energy"][first:])
    numbers = numpy.arange(1, report["iterations"] + 1)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10.8, 3), constrained_layout=True)
    left.plot(numbers[:first], inverted, "o-", color="tab:red")
    left.set_title("untangling")
    left.set_ylabel("inverted cells")
    right.semilogy(numbers[first:-1], energy[:-1] - energy[-1], "o-")
    right.set_title("minimization")
    right.set_ylabel("energy above the last one")
    for axes in (left, right):
        axes.set_xlabel("Newton step")
        axes.xaxis.get_major_locator().set_params(integer=True)
    save(figure, output)


def draw_grid(vtu, output, icon):
    """A regular grid in the parameter domain, and what it becomes in the source; the latter also as a small picture."""
    direction, up, _ = VIEWS[vtu.stem]
    source = render.read(str(vtu))
    bodies = [[render.surface(grid, edges=False), grid_lines(grid), edges_of_domain(grid)]
              for grid in (render.image_of(source), source)]
    draw_row([(bodies[0], direction, up, "polycube with a regular grid"), (bodies[1], direction, up, "part with the same grid")],
             output)
    render.picture(icon, bodies[1], direction, up)
    picture = Image.open(icon).convert("RGB").resize((320, 320), Image.LANCZOS)
    picture.quantize(256).save(icon, optimize=True)


def surface_with_field(grid):
    """Coloured by the references of the cells, from 0, orange, to 100, blue."""
    table = vtk.vtkLookupTable()
    table.SetHueRange(0.08, 0.6)
    table.SetSaturationRange(0.6, 0.6)
    table.SetTableRange(0, 100)
    return render.surface_by_table(grid, "reference", table)


def draw_carried(folder, output):
    """A field and a regular grid of the elephant, and what becomes of them on the bull."""
    bodies = []
    for name, direction in (("elephant", (2, 1, 3)), ("bull", (-2, 1, 3))):
        grid = render.read(str(folder / f"{name}.vtu"))
        bodies.append(([surface_with_field(grid), grid_lines(grid)], direction, (0, 1, 0), name))
    draw_row(bodies, output, (colors_of(bodies[0][0][0]), (0, 100), "distance from the tip of the trunk, in % of the largest one"))


def draw_moving(folder, output):
    """The half of the mesh behind the middle, at the beginning and after each quarter of the way."""
    frames = [render.read(str(folder / f"moving_boundary_{i}.vtu")) for i in range(1, 5)]
    grids = [frames[0], *(render.image_of(frame) for frame in frames)]
    draw_row([([render.surface(render.whole_cells_behind(grid, (0, 0, 1)))], (0, 0, 1), (0, 1, 0), title)
              for grid, title in zip(grids, ("mesh of the beginning", "1/4", "1/2", "3/4", "end"))], output)


def draw_hexahedra(vtu, output):
    """Hexahedra, and those of one half with their scaled Jacobians."""
    direction, up, normal = VIEWS["polycube"]
    mesh = render.read(str(vtu))
    quality = render.quality_surface(render.whole_cells_behind(mesh, normal), "scaled_jacobian")
    draw_row([([render.surface(mesh)], direction, up, "hexahedra"), ([quality], direction, up, "those of one half")], output,
             (colors_of(quality), (0, 1), "scaled Jacobian (right angles: 1)"))


def main(folder, output_folder):
    draw_carried(folder, output_folder / "body_to_body.png")
    for name in VIEWS:
        draw_map(folder / f"{name}.vtu", output_folder / f"{name}.png")
    if (folder / "convergence.json").exists():
        draw_convergence(folder / "convergence.json", output_folder / "convergence.png")
    draw_grid(folder / "polycube.vtu", output_folder / "polycube_grid.png", output_folder / "icon.png")
    draw_moving(folder, output_folder / "moving_boundary.png")
    draw_hexahedra(folder / "hexahedra.vtu", output_folder / "hexahedra.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "doc/Volume_mesh_parameterization/fig")
