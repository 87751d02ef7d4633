"""Pictures of maps by VTK, without a screen of its own: needs an X server such as Xvfb."""
import math
from pathlib import Path

import vtk

SIZE = 520
GREY, RED = (0.82, 0.85, 0.88), (0.85, 0.05, 0.05)


def read(filename):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(filename)
    reader.Update()
    return reader.GetOutput()


def image_of(grid):
    """The same mesh with the vertices at their images."""
    image = vtk.vtkUnstructuredGrid()
    image.ShallowCopy(grid)
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(grid.GetPointData().GetArray("uvw"))
    image.SetPoints(points)
    return image


def plane_through(grid, normal):
    """A plane through the middle of the bounding box."""
    bounds = grid.GetBounds()
    plane = vtk.vtkPlane()
    plane.SetOrigin(*((bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)))
    plane.SetNormal(*normal)
    return plane


def cut(grid, normal):
    """What is behind a plane through the middle of the bounding box, with cells cut where the plane meets them."""
    clip = vtk.vtkClipDataSet()
    clip.SetInputData(grid)
    clip.SetClipFunction(plane_through(grid, normal))
    clip.InsideOutOn()
    clip.Update()
    return clip.GetOutput()


def whole_cells_behind(grid, normal):
    """What is behind a plane through the middle of the bounding box, without the cells that the plane meets."""
    extract = vtk.vtkExtractGeometry()
    extract.SetInputData(grid)
    extract.SetImplicitFunction(plane_through(grid, normal))
    extract.ExtractInsideOn()
    extract.Update()
    return extract.GetOutput()


def inverted_cells(grid):
    threshold = vtk.vtkThreshold()
    threshold.SetInputData(grid)
    threshold.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "det_J")
    threshold.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_LOWER)
    threshold.SetLowerThreshold(0)
    threshold.Update()
    return threshold.GetOutput()


def surface(grid, color=GREY, edges=True):
    return actor(grid, edges, lambda mapper, prop: (mapper.ScalarVisibilityOff(), prop.SetColor(*color)))


def color_scale():
    """256 colours, from light to dark."""
    return [(1 - 0.6 * t * t, 0.92 * (1 - t) ** 1.3, 0.86 * (1 - t) ** 1.5) for t in (i / 255 for i in range(256))]


def colored_surface(grid, array, largest):
    """Colours by a distortion, from light red for 2, the smallest one, to dark red, on a logarithmic scale."""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetScaleToLog10()
    table.SetTableRange(2, max(largest, 2.1))
    for i, color in enumerate(color_scale()):
        table.SetTableValue(i, *color)
    return surface_by_table(grid, array, table)


def quality_surface(grid, array):
    """Colours by a quality, from dark red for 0 to light grey for 1."""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetTableRange(0, 1)
    for i in range(256):
        t = i / 255
        table.SetTableValue(i, 0.6 + 0.25 * t, 0.85 * t, 0.87 * t)
    return surface_by_table(grid, array, table, True)


def surface_by_table(grid, array, table, edges=False):
    """Colours by values of the cells."""
    table.Build()

    def paint(mapper, _):
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(array)
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
    return actor(grid, edges, paint)


def actor(grid, edges, paint):
    boundary = vtk.vtkDataSetSurfaceFilter()
    boundary.SetInputData(grid)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(boundary.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetEdgeVisibility(edges)
    actor.GetProperty().SetEdgeColor(0.35, 0.38, 0.42)
    actor.GetProperty().SetLineWidth(0.6)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()  # lines on the surface are before it
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2)
    actor.GetProperty().SetAmbient(0.4)
    actor.GetProperty().SetDiffuse(0.6)
    paint(mapper, actor.GetProperty())
    return actor


def picture(filename, actors, direction, up, legend="", aspect=1):
    """Looks along -direction at all actors, which fill the view. The legend, with that title, is of the first one."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    focus, half_size, right = _frame(actors, direction, up, aspect)
    if legend:
        renderer.AddActor2D(_color_bar(actors[0].GetMapper().GetLookupTable(), legend))
        focus = [x + 0.2 * half_size * r for x, r in zip(focus, right)]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*(x + 10 * half_size * d for x, d in zip(focus, direction)))  # in front of all
    camera.SetViewUp(*up)
    camera.SetParallelScale(1.04 * half_size)
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(round((1.2 if legend else aspect) * SIZE), SIZE)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(filename))
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()
    return Path(filename).name


def _color_bar(table, title):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(title)
    bar.SetNumberOfLabels(4)
    bar.SetLabelFormat("%.3g")
    bar.SetPosition(0.87, 0.05)
    bar.SetWidth(0.1)
    bar.SetHeight(0.35)
    bar.UnconstrainedFontSizeOn()
    for text in (bar.GetLabelTextProperty(), bar.GetTitleTextProperty()):
        text.SetColor(0, 0, 0)
        text.SetFontSize(16)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    return bar


def _frame(actors, direction, up, aspect):
    """The middle of what is seen, half of the height of a view that it fits, and the direction to the right."""
    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    def unit(a):
        return [x / math.sqrt(sum(y * y for y in a)) for x in a]
    back = unit(direction)
    right = unit(cross(up, back))
    axes = (right, cross(back, right), back)
    low, high = [math.inf] * 3, [-math.inf] * 3
    for actor in actors:
        if not hasattr(actor, "GetMapper"):  # a label
            continue
        actor.GetMapper().Update()
        points = actor.GetMapper().GetInput().GetPoints()
        for v in range(points.GetNumberOfPoints() if points else 0):
            p = points.GetPoint(v)
            for i, axis in enumerate(axes):
                x = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2]
                low[i], high[i] = min(low[i], x), max(high[i], x)
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    focus = [sum(middle[i] * axes[i][k] for i in range(3)) for k in range(3)]
    return focus, max((high[0] - low[0]) / aspect, high[1] - low[1]) / 2, right
