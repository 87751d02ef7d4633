#!/usr/bin/python3
"""Draws the maps that the example programs wrote, for the manual.

Usage: xvfb-run -a -s "-screen 0 2560x1280x24 -noreset" scripts/render_examples.py FOLDER [OUTPUT_FOLDER]
FOLDER is where the example programs were run, the commands that the manual of Polycube_meshing_3 shows, and those of the section
"Examples in Pictures". Needs the Debian packages python3-matplotlib, python3-pil, python3-vtk9, xauth and xvfb.
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
sys.path += [str(ROOT / "benchmark" / name) for name in ("Volume_mesh_parameterization/paper", "Polycube_meshing_3")]
import render  # noqa: E402
from solve_cantilever import read_inp  # noqa: E402

LARGEST = 10  # largest distortion that colors tell apart
DPI = 200  # pictures are shown at half their size, on screens with small pixels at all of it
render.SIZE = 1040  # pixels of a picture

# name of the .vtu file: direction to the eye, direction upwards, normal of the plane that cuts
VIEWS = {
    "twisted": ((2, 1, 3), (0, 1, 0), (0, 0, 1)),
    "polycube": ((2, -3, 2), (0, 0, 1), (0, -1, 0)),
    "sliding_boundary": ((2, -3, 2), (0, 0, 1), (0, -1, 0)),
    "sloshing_tank": ((1, -3, 1), (0, 0, 1), (0, -1, 0)),
    "body_to_scan": ((3, -2, 1), (0, 0, 1), (0, -1, 0)),
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


def colors_of_positions(grid, is_of_body=False):
    """A color for each position in the domain, or in the body: red, green and blue grow with the coordinates."""
    positions = vtk_to_numpy(grid.GetPoints().GetData() if is_of_body else grid.GetPointData().GetArray("uvw"))
    low, high = positions.min(axis=0), positions.max(axis=0)
    return (60 + 190 * (positions - low) / (high - low)).astype(numpy.uint8)


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
    """With 256 colors, which keeps the file small, and without dithering, which would look like noise."""
    with tempfile.TemporaryDirectory() as name:
        figure.savefig(f"{name}/figure.png", dpi=DPI)
        picture = Image.open(f"{name}/figure.png").convert("RGB")
        picture = picture.quantize(256, kmeans=1, dither=Image.Dither.NONE)
        colors = numpy.array(picture.getpalette()).reshape(-1, 3)
        colors[picture.getpixel((0, 0))] = 255  # the background stays white
        picture.putpalette(colors.ravel().tolist())
        picture.save(output, optimize=True)
    pyplot.close(figure)


def draw_row(bodies, output, bar=None, rows=1):
    """Bodies side by side, each a list of actors with its direction to the eye, direction upwards and title. The bar is
    colors, their scale and what it shows."""
    columns = len(bodies) // rows
    figure, axes = pyplot.subplots(rows, columns, figsize=(10.8, 10.8 / columns * rows), constrained_layout=True)
    with tempfile.TemporaryDirectory() as name:
        panel = Path(name) / "panel.png"
        for panel_axes, (actors, direction, up, title) in zip(axes.flat, bodies):
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


def frame(*grids):
    """An invisible box around all bodies, with which pictures have one scale."""
    box = vtk.vtkBoundingBox()
    for grid in grids:
        box.AddBounds(grid.GetBounds())
    bounds = [0] * 6
    box.GetBounds(bounds)
    outline = vtk.vtkOutlineSource()
    outline.SetBounds(bounds)
    outline.Update()
    actor = line_actor(outline.GetOutput(), (1, 1, 1), 1)
    actor.GetProperty().SetOpacity(0)
    return actor


def draw_tank(vtu, output):
    """The mesh at rest and after the last step at one scale, and a section of the latter with its distortion."""
    direction, up, normal = VIEWS[vtu.stem]
    source = render.read(str(vtu))
    image = render.image_of(source)
    colors = colors_of_positions(source)
    draw_row([([painted_surface(source, colors), frame(source, image)], direction, up, "at rest"),
              ([painted_surface(image, colors), frame(source, image)], direction, up, "after the last step"),
              ([section(image, normal), frame(source, image)], normal, up, "section of the latter")], output, DISTORTION)


def triangles_of_OFF(filename):
    words = filename.read_text().split()
    n, m = int(words[1]), int(words[2])
    coordinates = numpy.array(words[4:4 + 3 * n], float).reshape(n, 3)
    triangles = numpy.array(words[4 + 3 * n:4 + 3 * n + 4 * m], numpy.int64).reshape(m, 4)[:, 1:]
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(coordinates, deep=True))
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    for triangle in triangles:
        grid.InsertNextCell(vtk.VTK_TRIANGLE, 3, triangle)
    return grid


def draw_fit(vtu, scan, output):
    """A scan, the boundary that is fitted to it, and the distance of the scan from this boundary, at one scale."""
    direction, up, _ = VIEWS[vtu.stem]
    image = render.image_of(render.read(str(vtu)))
    scanned = triangles_of_OFF(scan)
    boundary = vtk.vtkImplicitPolyDataDistance()
    boundary.SetInput(surface_of(image))
    distances = numpy.array([abs(boundary.EvaluateFunction(p)) for p in vtk_to_numpy(scanned.GetPoints().GetData())])
    largest = distances.max()
    colored = surface_by_values(scanned, distances, VIRIDIS, 0, largest)
    around = frame(scanned, image)
    draw_row([([render.surface(scanned), around], direction, up, "scan"),
              ([render.surface(image), around], direction, up, "boundary of the cube, fitted to the scan"),
              ([colored, around], direction, up, "distance of the scan from this boundary")], output,
             (VIRIDIS, Normalize(0, largest), "distance; the scan is about 2 wide"))


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


def body_with_grid(grid, direction):
    """The lines are a little nearer to the eye than the surface, which would hide parts of them, and the edges than the lines."""
    lines, edges = grid_lines(grid), sharp_edges(grid)
    for actor, distance in ((lines, 0.004), (edges, 0.006)):
        actor.SetPosition(*(distance * grid.GetLength() / numpy.linalg.norm(direction) * numpy.array(direction)))
    return [render.surface(grid, edges=False), lines, edges]


def draw_grid(vtu, output):
    """A regular grid in the parameter domain, and what it becomes in the source."""
    direction, up, _ = VIEWS[vtu.stem]
    source = render.read(str(vtu))
    draw_row([(body_with_grid(render.image_of(source), direction), direction, up, "polycube with a regular grid"),
              (body_with_grid(source, direction), direction, up, "part with the same grid")], output)


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


def landmarks(grid):
    """A ball at each marked vertex."""
    marks = vtk_to_numpy(grid.GetPointData().GetArray("landmark"))
    return balls_at(vtk_to_numpy(grid.GetPoints().GetData())[marks > 0], 0.025 * grid.GetLength())


VIRIDIS = [matplotlib.colormaps["viridis"](i / 255)[:3] for i in range(256)]
WOOD = [tuple(numpy.array((0.93, 0.78, 0.55)) - i / 255 * numpy.array((0.5, 0.52, 0.42))) for i in range(256)]


def surface_with_field(grid, largest, colors):
    """Colored by a field of the vertices, from 0 to the largest value."""
    actor = surface_by_values(grid, vtk_to_numpy(grid.GetPointData().GetArray("field")), colors, 0, largest)
    actor.GetProperty().SetEdgeVisibility(False)
    return actor


def draw_carried(folder, output):
    """A field, a regular grid and the landmarks of the elephant, and what becomes of them on the bull."""
    grids = [render.read(str(folder / f"{name}.vtu")) for name in ("elephant", "bull")]
    largest = grids[0].GetPointData().GetArray("field").GetRange()[1]
    bodies = [([surface_with_field(grid, largest, VIRIDIS), grid_lines(grid), *landmarks(grid)], direction, (0, 1, 0), title)
              for grid, direction, title in zip(grids, ((2, 1, 3), (-2, 1, 3)), ("elephant", "bull"))]
    draw_row(bodies, output, (VIRIDIS, Normalize(0, 100), "distance from the tip of the trunk, in % of the largest one"))


def draw_texture(folder, output):
    """The texture in a section of the cube, on the body, and in a section of it."""
    direction, up, normal = (1, -2, 2), (0, 1, 0), (0, 0, 1)
    body = render.read(str(folder / "solid_texture.vtu"))
    sections = [surface_with_field(render.cut(grid, normal), 1, WOOD) for grid in (render.image_of(body), body)]
    draw_row([([sections[0]], direction, up, "section of the cube"), ([surface_with_field(body, 1, WOOD)], direction, up, "body"),
              ([sections[1]], direction, up, "section of the body")], output)


def draw_detail(folder, output):
    """The body with the bumps, the other body, and its image with them."""
    direction, up = (1, -2, 2), (0, 1, 0)
    source, target = (render.read(str(folder / f"{name}.vtu")) for name in ("bumpy_ball", "transferred_detail"))
    draw_row([([render.surface(grid, edges=False)], direction, up, title)
              for grid, title in ((source, "ball with bumps"), (target, "another body"),
                                  (render.image_of(target), "with the bumps of the ball"))], output)


def control_net(filename):
    """The coefficients of a trivariate spline with equal numbers along its axes, as hexahedra, and those of its lower half."""
    rows = numpy.array([line.split() for line in Path(filename).read_text().splitlines() if line and line[0] not in "<"], float)
    n = round(len(rows) ** (1 / 3))
    for layers in (n, n // 2 + 1):
        grid = vtk.vtkStructuredGrid()
        grid.SetDimensions(n, n, layers)
        points = vtk.vtkPoints()
        points.SetData(numpy_to_vtk(rows[:n * n * layers], deep=True))
        grid.SetPoints(points)
        whole = vtk.vtkAppendFilter()
        whole.AddInputData(grid)
        whole.Update()
        yield whole.GetOutput()


def draw_spline(folder, output):
    """The control net of a spline, and the net up to its middle layer."""
    draw_row([([render.surface(grid)], (1, -2, 2), (0, 1, 0), title)
              for grid, title in zip(control_net(folder / "spline.xml"), ("control net", "up to its middle layer"))], output)


def plane_section(grid, normal):
    """Where a plane through the middle meets the cells: polygons with the data of the cells."""
    cutter = vtk.vtkCutter()
    cutter.SetInputData(grid)
    cutter.SetCutFunction(render.plane_through(grid, normal))
    cutter.GenerateTrianglesOff()
    cutter.Update()
    return cutter.GetOutput()


def draw_moving(folder, output):
    """A plane section of the mesh, with its distortion, at the beginning, after one half of the way, and at the end."""
    frames = [render.read(str(folder / f"moving_boundary_{i}.vtu")) for i in (2, 4)]
    bodies = [(frames[0], "beginning", False), *((render.image_of(frame), title, True) for frame, title in
                                                zip(frames, ("half of the way", "end")))]
    drawn = []
    for grid, title, has_distortion in bodies:
        flat = plane_section(grid, (0, 0, 1))
        actor = (render.colored_surface(flat, "angle_distortion", LARGEST) if has_distortion
                 else render.surface(flat, render.color_scale()[0]))
        actor.GetProperty().SetEdgeVisibility(True)
        actor.GetProperty().LightingOff()
        drawn.append(([actor], (0, 0, 1), (0, 1, 0), title))
    draw_row(drawn, output, DISTORTION)


def shells(grid, number=8):
    """Colors of bands between spheres around the origin of the image, from the middle to the boundary."""
    radius = numpy.linalg.norm(vtk_to_numpy(grid.GetPointData().GetArray("uvw")), axis=1)
    colors = [(0.97, 0.85, 0.62) if i % 2 else (0.25, 0.45, 0.62) for i in range(number)]
    actor = surface_by_values(grid, radius, colors, 0, 1)
    actor.GetProperty().SetEdgeVisibility(False)
    return actor


def draw_ball(folder, output):
    """A body and its image in the ball with equal colors, and what concentric shells of the ball are in a section of the body."""
    source = render.read(str(folder / "elephant_to_ball.vtu"))
    colors = colors_of_positions(source)
    direction, up, normal = (2, 1, 3), (0, 1, 0), (0, 0, 1)
    draw_row([([painted_surface(source, colors)], direction, up, "body"),
              ([painted_surface(render.image_of(source), colors)], direction, up, "its map to the ball"),
              ([shells(render.cut(source, normal))], normal, up, "concentric shells of the ball, in the body")], output)


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


def draw_lines(folder, output):
    """A block, and what lines of conditions make of it, at one scale."""
    direction, up = (1, -3, 1), (0, 0, 1)
    grids = [(render.read(str(folder / f"{name}.vtu")), title) for name, title in (
        ("held", "left fixed\nright x=3"), ("pressed", "bottom z=0\ntop z=0.5"), ("wavy", "bottom fixed\ntop surface wave.off"))]
    images = [(render.image_of(grid), title) for grid, title in grids]
    around = frame(grids[0][0], *(image for image, _ in images))
    colors = colors_of_positions(grids[0][0], is_of_body=True)
    draw_row([([painted_surface(grid, colors), around], direction, up, title)
              for grid, title in ((grids[0][0], "block"), *images)], output)


def balls_at(points, radius):
    """A red ball at each point."""
    for point in points:
        ball = vtk.vtkSphereSource()
        ball.SetCenter(*point)
        ball.SetRadius(radius)
        ball.Update()
        actor = line_actor(ball.GetOutput(), (0.75, 0.05, 0.1), 1)
        actor.GetProperty().LightingOn()
        yield actor


def draw_refinement(folder, output):
    """A section of a body, of the same body with the vertices that refinement has added, and of its image with them."""
    direction, up = (0, -1, 0), (0, 0, 1)
    given, refined = (render.read(str(folder / f"{name}.vtu")) for name in ("fin", "fin_to_cube"))
    bodies = [([render.surface(render.whole_cells_behind(given, direction))], direction, up, "tetrahedra of a body")]
    for grid, title in ((refined, "added vertices"), (render.image_of(refined), "their images in the cube")):
        added = vtk_to_numpy(grid.GetPoints().GetData())[given.GetNumberOfPoints():]
        middle = sum(grid.GetBounds()[2:4]) / 2
        bodies.append(([render.surface(render.whole_cells_behind(grid, direction)),
                        *balls_at(added[added[:, 1] > middle], 0.008 * grid.GetLength())], direction, up, title))
    draw_row(bodies, output)


def draw_channel(folder, output):
    """A section of a body with a channel, the image of its walls (red) in the ball, and shells of the ball in the section."""
    body = render.read(str(folder / "channel_to_ball.vtu"))
    bounds = numpy.reshape(body.GetBounds(), (3, 2)) + [1e-6, -1e-6]
    colors = [STEEL] * 9 + [RED]

    def walls(grid):
        points, images = (vtk_to_numpy(data) for data in (grid.GetPoints().GetData(), grid.GetPointData().GetArray("uvw")))
        is_inside = ((points > bounds[:, 0]) & (points < bounds[:, 1])).all(axis=1)
        return (is_inside & (numpy.linalg.norm(images, axis=1) > 1 - 1e-9)).astype(float)

    normal, up = (0, -1, 0), (0, 0, 1)
    half, image = render.cut(body, normal), render.image_of(body)
    towards = vtk_to_numpy(image.GetPoints().GetData())[walls(body) > 0].mean(axis=0)
    draw_row([([surface_by_values(half, walls(half), colors, 0, 1)], normal, up, "section of a body with a channel"),
              ([surface_by_values(image, walls(body), colors, 0, 1)], towards, up, "its image, the ball"),
              ([shells(render.cut(body, normal))], normal, up, "concentric shells of the ball, in the section")], output)


def inverted_cells(grid):
    """The cells with a negative volume, red."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    corners = points[vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)]
    edges = corners[:, 1:] - corners[:, :1]
    inverted = vtk.vtkExtractCells()
    inverted.SetInputData(grid)
    ids = vtk.vtkIdList()
    for i in numpy.flatnonzero(numpy.linalg.det(edges) <= 0):
        ids.InsertNextId(i)
    inverted.SetCellList(ids)
    inverted.Update()
    return render.surface(inverted.GetOutput(), RED)


def draw_improvement(folder, output):
    """The inverted cells of a mesh, and one half of it after --improve."""
    direction, up, normal = (2, -3, 2), (0, 0, 1), (0, -1, 0)
    tangled, improved = (render.read(str(folder / f"{name}.vtu")) for name in ("tangled", "improved"))
    half = render.surface(render.whole_cells_behind(improved, normal))
    draw_row([([inverted_cells(tangled), frame(tangled)], direction, up, "inverted cells of a cube"),
              ([half, frame(tangled)], direction, up, "one half after the repair")], output)


def draw_landmarks(folder, output):
    """A cube with landmarks, and its fits to a scan without and with them."""
    direction, up, _ = VIEWS["body_to_scan"]
    source, fitted, marked = (render.read(str(folder / f"{name}.vtu")) for name in ("unmarked", "unmarked", "marked"))
    vertices = [int(line.split()[0]) for line in (folder / "marks.txt").read_text().splitlines()]
    colors = colors_of_positions(source, is_of_body=True)
    bodies = []
    for grid, title in ((source, "cube with landmarks"), (render.image_of(fitted), "fitted to a scan without them"),
                        (render.image_of(marked), "fitted with them")):
        points = vtk_to_numpy(grid.GetPoints().GetData())[vertices]
        bodies.append(([painted_surface(grid, colors), *balls_at(points, 0.02 * grid.GetLength())], direction, up, title))
    draw_row(bodies, output)


def draw_boundaries(folder, output):
    """A body and its images for several boundaries, with equal colors."""
    direction, up, _ = VIEWS["twisted"]
    bodies = []
    for name, title in (("elephant_to_ball", "ball"), ("elephant_to_cube", "box"), ("elephant_to_polycube", "polycube"),
                        ("twisted", "prescribed surface")):
        source = render.read(str(folder / f"{name}.vtu"))
        colors = colors_of_positions(source, is_of_body=True)
        if not bodies:
            bodies.append(([painted_surface(source, colors)], direction, up, "body"))
        bodies.append(([painted_surface(render.image_of(source), colors)], direction, up, title))
    draw_row(bodies, output)


ENERGIES = {"stretch": "stretch", "lp_stretch": "Lp stretch", "symmetric_dirichlet": "symmetric Dirichlet", "mips": "MIPS",
            "power": "third power of MIPS", "dirichlet": "Dirichlet", "arap": "ARAP", "lpm": "LPM", "lscm": "LSCM"}


def draw_energies(folder, output):
    """A plane section of a cube, and of its image on the dented cube by each energy."""
    grids = [(name, render.read(str(folder / f"{name}_energy.vtu"))) for name in ENERGIES]
    source = render.surface(plane_section(grids[0][1], (0, -1, 0)), render.color_scale()[0])
    bodies = [(source, "cube")]
    for name, grid in grids:
        section = plane_section(render.image_of(grid), (0, -1, 0))
        bodies.append((render.colored_surface(section, "angle_distortion", LARGEST), ENERGIES[name]))
    for actor, _ in bodies:
        actor.GetProperty().SetEdgeVisibility(True)
        actor.GetProperty().LightingOff()
    draw_row([([actor], (0, -1, 0), (0, 0, 1), title) for actor, title in bodies], output, DISTORTION, rows=2)


def surface_by_values(grid, values, colors, low, high):
    """Colored by values of the points, or of the cells if there are as many."""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(len(colors))
    table.SetTableRange(low, high)
    for i, color in enumerate(colors):
        table.SetTableValue(i, *color)
    is_of_cells = len(values) == grid.GetNumberOfCells()
    array = numpy_to_vtk(numpy.asarray(values, float), deep=True)
    array.SetName("value")
    (grid.GetCellData() if is_of_cells else grid.GetPointData()).AddArray(array)
    actor = render.surface(grid)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarMode(4 if is_of_cells else 3)  # the field of cells or points that has the name below
    mapper.SelectColorArray("value")
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    return actor


STEEL, BRONZE, RED, BLUE = (0.72, 0.76, 0.80), (0.80, 0.58, 0.32), (0.75, 0.15, 0.15), (0.25, 0.45, 0.70)


def draw_materials(folder, output):
    """Hexahedra of two materials, and those of one half with their scaled Jacobians."""
    direction, up, normal = (2, -3, 3), (0, 0, 1), (0, -1, 0)
    mesh = render.read(str(folder / "bearing.vtu"))
    half = render.whole_cells_behind(mesh, normal)
    quality = render.quality_surface(half, "scaled_jacobian")
    materials = vtk_to_numpy(mesh.GetCellData().GetArray("subdomain"))
    draw_row([([surface_by_values(mesh, materials, (BRONZE, STEEL), 1, 2)], direction, up, "hexahedra of two materials"),
              ([quality], direction, up, "those of one half")], output,
             (colors_of(quality), Normalize(0, 1), "scaled Jacobian (right angles: 1)"))


def results_of_calculix(filename, name):
    """The values of a result of each node in a file *.frd."""
    values, is_wanted = {}, False
    for line in filename.read_text().splitlines():
        if line.startswith(" -4"):
            is_wanted = line.split()[1] == name
        elif line.startswith(" -1") and is_wanted:
            values[int(line[3:13])] = [float(line[i:i + 12]) for i in range(13, len(line), 12)]
    return values


def quadrangles(points, cells):
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(vtk.vtkPoints())
    grid.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    for cell in cells:
        grid.InsertNextCell(vtk.VTK_QUAD, 4, cell)
    return grid


def arrows(points, size):
    """Arrows against the first axis that end at points."""
    for x, y, z in points:
        arrow = vtk.vtkArrowSource()
        arrow.SetTipRadius(0.18)
        arrow.SetShaftRadius(0.05)
        place = vtk.vtkTransform()
        place.Translate(x + size, y, z)
        place.Scale(size, size, size)
        place.RotateY(180)
        placed = vtk.vtkTransformPolyDataFilter()
        placed.SetTransform(place)
        placed.SetInputConnection(arrow.GetOutputPort())
        placed.Update()
        yield line_actor(placed.GetOutput(), BLUE, 1)


def draw_bracket(folder, output):
    """A bracket with what holds and loads it, and its deformation and von Mises stress by CalculiX."""
    direction, up = (3, -2, 1.8), (0, 0, 1)
    points, patches = read_inp(folder / "bracket.inp")
    nodes = {number: i for i, number in enumerate(points)}
    positions = numpy.array(list(points.values()))
    cells, groups = [], []
    for name, faces in patches.items():
        for face in faces if name in ("screws", "wall", "rest") else ():
            cells.append([nodes[v] for v in face])
            groups.append({"rest": 0, "screws": 1, "wall": 2}[name])
    loaded = surface_by_values(quadrangles(positions, cells), groups, (STEEL, RED, (0.62, 0.73, 0.86)), 0, 2)
    tips = [(8, y, z) for y in (4, 20, 36) for z in (14, 32, 50) if (y, z) != (20, 32)]  # on the wall, around its hole
    moved, stress = (results_of_calculix(folder / "bracket_model.frd", name) for name in ("DISP", "STRESS"))
    displacement = numpy.array([moved[number] for number in points])
    a, b, c, d, e, f = numpy.array([stress[number] for number in points]).T
    von_mises = numpy.sqrt(((a - b) ** 2 + (b - c) ** 2 + (c - a) ** 2) / 2 + 3 * (d ** 2 + e ** 2 + f ** 2))
    largest, factor = numpy.percentile(von_mises, 99.5), 6 / numpy.linalg.norm(displacement, axis=1).max()
    bent = surface_by_values(quadrangles(positions + factor * displacement, cells), von_mises, VIRIDIS, 0, largest)
    print(f"bracket: displacements times {factor:.3g}, largest {6 / factor:.3g} mm, stress up to {von_mises.max():.3g} MPa")
    draw_row([([loaded, *arrows(tips, 14)], direction, up, "screws hold, a pressure loads"),
              ([bent], direction, up, f"deformed, displacements times {factor:.0f}")], output,
             (VIRIDIS, Normalize(0, largest), "von Mises stress in MPa"))


def draw_hexahedra(vtu, output, view=VIEWS["polycube"]):
    """Hexahedra, and those of one half with their scaled Jacobians."""
    direction, up, normal = view
    mesh = render.read(str(vtu))
    plane = render.plane_through(mesh, normal)
    clip = vtk.vtkClipPolyData()
    clip.SetInputData(surface_of(mesh))
    clip.SetClipFunction(plane)
    clip.InsideOutOn()
    clip.Update()
    quality = render.quality_surface(clip.GetOutput(), "scaled_jacobian")
    cells_at_plane = render.quality_surface(plane_section(mesh, normal), "scaled_jacobian")
    draw_row([([render.surface(mesh)], direction, up, "hexahedra"),
              ([quality, cells_at_plane], direction, up, "section of one half")], output,
             (colors_of(quality), Normalize(0, 1), "scaled Jacobian (right angles: 1)"))


def numbered_faces(mesh, direction):
    """The quadrangles of a part with one color for each face of the part, and its number where the eye sees it."""
    threshold = vtk.vtkThreshold()
    threshold.SetInputData(mesh)
    threshold.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "surface")
    threshold.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(1)
    threshold.Update()
    quadrangles = threshold.GetOutput()
    numbers = vtk_to_numpy(quadrangles.GetCellData().GetArray("surface")).astype(int)
    colors = [matplotlib.colormaps["tab20"](i % 20)[:3] for i in range(numbers.max() + 1)]
    actors = [surface_by_values(quadrangles, numbers, colors, 0, numbers.max() + 1)]
    points = vtk_to_numpy(quadrangles.GetPoints().GetData())
    corners = points[vtk_to_numpy(quadrangles.GetCells().GetConnectivityArray()).reshape(-1, 4)]
    normals = numpy.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    toward_eye = numpy.array(direction) / numpy.linalg.norm(direction)
    for number in numpy.unique(numbers):
        seen = (numbers == number) & (normals @ toward_eye > 0)
        if not seen.any():
            continue
        centers = corners[seen].mean(axis=1)
        label = vtk.vtkBillboardTextActor3D()  # at the quadrangle in the middle, before the part
        label.SetInput(str(number))
        middle = centers[numpy.argmin(numpy.linalg.norm(centers - centers.mean(axis=0), axis=1))]
        label.SetPosition(*(middle + 0.1 * mesh.GetLength() * toward_eye))
        label.GetTextProperty().SetFontSize(40)
        label.GetTextProperty().SetColor(0, 0, 0)
        label.GetTextProperty().BoldOn()
        actors.append(label)
    return actors


def draw_faces(vtu, output):
    """The numbers of the faces of a part, from two sides."""
    direction, up, _ = VIEWS["polycube"]
    mesh = render.read(str(vtu))
    opposite = tuple(-x for x in direction)
    draw_row([(numbered_faces(mesh, direction), direction, up, "faces of the part"),
              (numbered_faces(mesh, opposite), opposite, up, "seen from the opposite side")], output)


def main(folder, output_folder):
    draw_carried(folder, output_folder / "body_to_body.png")
    draw_ball(folder, output_folder / "elephant_to_ball.png")
    for name in ("twisted", "polycube"):
        draw_map(folder / f"{name}.vtu", output_folder / f"{name}.png")
    draw_tank(folder / "sloshing_tank.vtu", output_folder / "sloshing_tank.png")
    draw_fit(folder / "body_to_scan.vtu", ROOT / "examples/Volume_mesh_parameterization/data/scan.off",
             output_folder / "body_to_scan.png")
    draw_sliding(folder, output_folder / "sliding_boundary.png")
    draw_grid(folder / "polycube.vtu", output_folder / "polycube_grid.png")
    draw_overview(folder, output_folder / "overview.png", output_folder / "icon.png")
    draw_texture(folder, output_folder / "solid_texture.png")
    draw_detail(folder, output_folder / "transferred_detail.png")
    draw_spline(folder, output_folder / "spline_of_map.png")
    draw_moving(folder, output_folder / "moving_boundary.png")
    draw_conditions(folder, output_folder / "free_boundary.png")
    draw_lines(folder, output_folder / "lines_of_conditions.png")
    draw_refinement(folder, output_folder / "refinement.png")
    draw_channel(folder, output_folder / "channel.png")
    draw_improvement(folder, output_folder / "improvement.png")
    draw_landmarks(folder, output_folder / "landmarks.png")
    draw_boundaries(folder, output_folder / "boundaries.png")
    draw_energies(folder, output_folder / "energies.png")
    draw_hexahedra(folder / "hexahedra.vtu", output_folder / "hexahedra.png")
    draw_faces(folder / "hexahedra.vtu", output_folder / "numbered_faces.png")
    draw_hexahedra(folder / "elephant_hexahedra.vtu", output_folder / "organic_body.png", VIEWS["twisted"])
    draw_materials(folder, output_folder / "materials.png")
    draw_bracket(folder, output_folder / "bracket.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "doc/Volume_mesh_parameterization/fig")
