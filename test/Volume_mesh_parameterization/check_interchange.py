"""Reads the files that parameterize_mesh_file writes with meshio, a reader that shares no code with this package.

Usage: check_interchange.py PARAMETERIZE_MESH_FILE DATA_FOLDER
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import meshio
import numpy


def run(*arguments):
    subprocess.run([str(argument) for argument in arguments], check=True, stdout=subprocess.DEVNULL)


def read(filename):
    mesh = meshio.read(filename)
    return mesh, mesh.points, mesh.cells_dict["tetra"]


def volumes(points, cells):
    return numpy.linalg.det(points[cells[:, 1:]] - points[cells[:, :1]]) / 6


def singular_values(source, image, cells):
    edges = [numpy.swapaxes(points[cells[:, 1:]] - points[cells[:, :1]], 1, 2) for points in (source, image)]
    return numpy.linalg.svd(edges[1] @ numpy.linalg.inv(edges[0]), compute_uv=False)


def check_map(driver, source_file, target_file, folder, *options):
    """Writes the same map as a pair of MEDIT files and as a VTU file, and compares all three meshes."""
    mesh_file, vtu_file, refined_file = folder / "map.mesh", folder / "map.vtu", folder / "refined.mesh"
    run(driver, source_file, target_file, "--output", mesh_file, "--refined-source", refined_file, *options)
    run(driver, source_file, target_file, "--output", vtu_file, *options)
    _, source, source_cells = read(refined_file)
    _, image, image_cells = read(mesh_file)
    vtu, vtu_source, vtu_cells = read(vtu_file)

    assert numpy.array_equal(source_cells, image_cells) and numpy.array_equal(source_cells, vtu_cells)
    assert numpy.array_equal(source, vtu_source)
    assert numpy.array_equal(image, vtu.point_data["uvw"])
    assert (volumes(source, source_cells) > 0).all() and (volumes(image, image_cells) > 0).all()

    s = singular_values(source, image, source_cells)
    angle = s[:, 0] / s[:, 2] + s[:, 2] / s[:, 0]
    assert numpy.allclose(vtu.cell_data["det_J"][0].ravel(), s.prod(axis=1), rtol=1e-9)
    assert numpy.allclose(vtu.cell_data["angle_distortion"][0].ravel(), angle, rtol=1e-9)
    return source, image


def check_targets(image, target_file):
    vertices, points = numpy.split(numpy.loadtxt(target_file), [1], axis=1)
    assert numpy.array_equal(image[vertices.ravel().astype(int)], points)


def write_fan(filename):
    """A bar of which all cells share one vertex, the last one. Returns the others."""
    square, length = [[0, 0], [1, 0], [1, 1], [0, 1]], 6
    points = [[x, y, z] for z in range(length + 1) for x, y in square]
    quads = [[3, 2, 1, 0], [4 * length + i for i in range(4)]]
    for z in range(length):
        quads += [[4 * z + i, 4 * z + (i + 1) % 4, 4 * z + 4 + (i + 1) % 4, 4 * z + 4 + i] for i in range(4)]
    cells = [[len(points), a, *bc] for a, b, c, d in quads for bc in ([b, c], [c, d])]
    meshio.write(filename, meshio.Mesh(points + [[0.5, 0.5, length / 2]], [("tetra", cells)]))
    return numpy.array(points)


def bend(points):
    """The bar around half a circle: no point sees all of its surface, so vertices must be added."""
    x, y, z = points.T
    angle = numpy.pi * z / 6
    return numpy.column_stack([(1 + x) * numpy.cos(angle), y, (1 + x) * numpy.sin(angle)])


def check_sources(driver, cube_file, target_file, folder):
    """The same map comes of what meshio writes of the source, in each format that is read."""
    map_file = folder / "map.mesh"
    run(driver, cube_file, target_file, "--output", map_file)
    expected = map_file.read_text()
    mesh = meshio.read(cube_file)
    mesh = meshio.Mesh(mesh.points, mesh.cells, cell_data={"medit:ref": [numpy.full(len(block.data), 7) for block in mesh.cells]})
    names = {"source.meshb": {}, "text.vtu": {"binary": False}, "binary.vtu": {"compression": None},
             "long.vtu": {"compression": None, "header_type": "UInt64"}}
    for name, options in names.items():
        meshio.write(folder / name, mesh, **options)
        run(driver, folder / name, target_file, "--output", map_file)
        image = meshio.read(map_file)
        assert image.cell_data["medit:ref"][-1].tolist() == [7] * len(mesh.cells_dict["tetra"]), name
        lines = [line.rsplit(" ", 1)[0] for line in map_file.read_text().split("Triangles")[0].split("Tetrahedra")[0].splitlines()]
        assert lines == [line.rsplit(" ", 1)[0] for line in
                         expected.split("Triangles")[0].split("Tetrahedra")[0].splitlines()], name


def check_conversion(driver, cube_file, target_file, folder):
    """Other formats take the arrays of a map, with one number a cell."""
    vtu_file = folder / "map.vtu"
    run(driver, cube_file, target_file, "--output", vtu_file)
    mesh = meshio.read(vtu_file)
    for name, blocks in mesh.cell_data.items():
        assert all(block.ndim == 1 for block in blocks), name
    for name in ("map.vtk", "map.msh"):
        meshio.write(folder / name, mesh)
        assert numpy.array_equal(meshio.read(folder / name).points, mesh.points)


def main(driver, data):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        cube_file, target_file = data / "cube.mesh", data / "cube_to_ball.txt"
        source, image = check_map(driver, cube_file, target_file, folder)
        assert numpy.array_equal(source, read(cube_file)[1])
        check_targets(image, target_file)
        check_sources(driver, cube_file, target_file, folder)
        check_conversion(driver, cube_file, target_file, folder)

        fan_file, bent_file = folder / "fan.mesh", folder / "bent.txt"
        surface = write_fan(fan_file)
        targets = numpy.column_stack([numpy.arange(len(surface)), bend(surface)])
        numpy.savetxt(bent_file, targets, "%d %.17g %.17g %.17g")
        source, image = check_map(driver, fan_file, bent_file, folder, "--refine")
        assert len(source) > len(surface) + 1 and numpy.array_equal(source[:len(surface)], surface)
        check_targets(image, bent_file)
    print("The files agree.")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
