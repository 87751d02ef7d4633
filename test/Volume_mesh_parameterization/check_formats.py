"""Goes the whole way of meshes of other programs: from Gmsh, TetGen, meshio and VTK to maps and hexahedra, and back. Compares
groups and data before and after, and follows each advice that the program gives.

Usage: check_formats.py PARAMETERIZE_MESH_FILE MESH_LABELS [--gmsh] [--vtk]

MESH_LABELS meshes a labeled image. The options tell what the program was built with. The programs gmsh, meshio and tetgen are run.
"""
import re
import shlex
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import meshio
import numpy

TWO_MATERIALS = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 3, 1, 1};
Box(2) = {3, 0, 0, 2, 1, 1};
v() = BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("bone", 11) = {1};
Physical Volume("flesh", 12) = {2};
left() = Surface In BoundingBox{-.1, -.1, -.1, .1, 1.1, 1.1};
right() = Surface In BoundingBox{4.9, -.1, -.1, 5.1, 1.1, 1.1};
middle() = Surface In BoundingBox{2.9, -.1, -.1, 3.1, 1.1, 1.1};
Physical Surface("clamped", 21) = {left()};
Physical Surface("loaded", 22) = {right()};
Physical Surface("interface", 23) = {middle()};
Mesh.MeshSizeFactor = 4;
"""


SOLIDS = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 3, 3, 1};
Box(2) = {0, 0, 1, 3, 3, 1};
Cylinder(3) = {1.5, 1.5, 0, 0, 0, 1, 0.5};
Cylinder(4) = {1.5, 1.5, 0, 0, 0, 1, 0.5};
BooleanDifference{ Volume{1}; Delete; }{ Volume{3}; Delete; }
"""
INCLUSION = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Sphere(2) = {0.5, 0.5, 0.5, 0.25};
v() = BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("inclusion", 11) = {2};
Physical Volume("matrix", 12) = {3};
Physical Surface("interface", 21) = {Boundary{ Volume{2}; }};
Mesh.MeshSizeMax = 0.25;
"""


def run(*arguments, folder):
    return subprocess.run([str(a) for a in arguments], cwd=folder, check=True, capture_output=True, text=True)


def refused(*arguments, folder):
    """The sentence of the program where it has to refuse."""
    result = subprocess.run([str(a) for a in arguments], cwd=folder, capture_output=True, text=True)
    assert result.returncode == 2, result
    return result.stderr


def gmsh_groups(mesh):
    """How many elements each group has, by its name."""
    names = {(tag, dimension): name for name, (tag, dimension) in mesh.field_data.items()}
    result = Counter()
    for block, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
        dimension = {"line": 1, "triangle": 2, "quad": 2, "tetra": 3, "hexahedron": 3}[block.type]
        for tag, number in zip(*numpy.unique(tags, return_counts=True)):
            result[names[tag, dimension]] += number
    return dict(result)


def areas_of_groups(mesh, key="gmsh:physical"):
    """The area or the volume of each group, which refinement keeps."""
    result = Counter()
    for block, tags in zip(mesh.cells, mesh.cell_data[key]):
        corners = mesh.points[block.data]
        edges = corners[:, 1:] - corners[:, :1]
        sizes = (numpy.abs(numpy.linalg.det(edges)) / 6 if block.type == "tetra"
                 else numpy.linalg.norm(numpy.cross(edges[:, 0], edges[:, 1]), axis=1) / 2)
        for tag, size in zip(tags, sizes):
            result[block.type, int(tag)] += size
    return dict(result)


def check_gmsh(driver, folder):
    """From Gmsh to a ball, a polycube and hexahedra, and back."""
    (folder / "bar.geo").write_text(TWO_MATERIALS)
    images = []
    for version, options in {"4.1": [], "4.1 binary": ["-bin"], "2.2": ["-format", "msh22"],
                             "2.2 binary": ["-format", "msh22", "-bin"]}.items():
        run("gmsh", "-3", *options, "-o", "bar.msh", "bar.geo", folder=folder)
        run(driver, "bar.msh", "--to", "ball", "--refine", "-o", "ball.msh", "--refined-source", "refined.msh", folder=folder)
        source, ball, refined = (meshio.read(folder / name) for name in ("bar.msh", "ball.msh", "refined.msh"))
        assert set(gmsh_groups(source)) == {"bone", "flesh", "clamped", "loaded", "interface"}
        assert gmsh_groups(ball) == gmsh_groups(refined), version
        for group, size in areas_of_groups(source).items():
            assert abs(areas_of_groups(refined)[group] - size) < 1e-12, (version, group)
        images.append(gmsh_groups(ball))
        run("gmsh", "ball.msh", "-save", "-o", "again.msh", folder=folder) # Gmsh reads it, too
        assert gmsh_groups(meshio.read(folder / "again.msh")) == gmsh_groups(ball)
        run(driver, "refined.msh", "ball.msh", "-o", "same.msh", folder=folder) # the target may be such a file, too
        assert numpy.array_equal(meshio.read(folder / "same.msh").cells_dict["tetra"], ball.cells_dict["tetra"])
    assert all(image == images[0] for image in images)

    # the bar is refined: parts of triangles and cells are in their groups
    run(driver, "bar.msh", "--to", "box=5,1,1", "--refine=all", "-o", "box.msh", "--refined-source", "refined.msh", folder=folder)
    box, refined = (meshio.read(folder / name) for name in ("box.msh", "refined.msh"))
    assert len(refined.points) > len(source.points)
    assert gmsh_groups(refined) == gmsh_groups(box)
    for group, size in areas_of_groups(source).items():
        assert abs(areas_of_groups(refined)[group] - size) < 1e-12, group

    run(driver, "bar.msh", "--to", "polycube", "--refine", "-o", "polycube.msh2", "--hexahedra", "0.5", "hexahedra.msh", folder=folder)
    assert set(gmsh_groups(meshio.read(folder / "polycube.msh2", file_format="gmsh"))) == set(gmsh_groups(source))
    hexahedra = gmsh_groups(meshio.read(folder / "hexahedra.msh"))
    assert hexahedra == {"bone": 24, "flesh": 16, "clamped": 4, "loaded": 4, "interface": 4}, hexahedra

    # meshio 5.0 takes one array for another where an offset is that of another array in base64, hence this way back
    run(driver, "bar.msh", "--to", "ball", "--refine", "-o", "ball.vtu", folder=folder)
    run(driver, "ball.vtu", "--to", "ball", "-o", "again.msh", folder=folder)
    assert gmsh_groups(meshio.read(folder / "again.msh")) == gmsh_groups(ball)

    run("gmsh", "-3", "-order", "2", "-o", "curved.msh", "bar.geo", folder=folder)
    curved = run(driver, "curved.msh", "--to", "ball", "--refine", "-o", "ball.msh", folder=folder)
    assert "their corners are used" in curved.stderr
    assert set(gmsh_groups(meshio.read(folder / "ball.msh"))) == set(gmsh_groups(source))
    for extension in ("unv", "bdf"):
        run("gmsh", "-3", "-o", "bar." + extension, "bar.geo", folder=folder)
        run(driver, "bar." + extension, "--to", "ball", "--refine", "-o", "ball.mesh", folder=folder)
        assert len(meshio.read(folder / "ball.mesh").points) > 0


def check_nested_groups(driver, folder):
    """Cells in two physical groups are one, and in both groups afterwards; a body with groups 0 and 1 goes to Gmsh, too."""
    both = TWO_MATERIALS + 'Physical Volume("all", 13) = {1, 2};\n'
    (folder / "nested.geo").write_text(both)
    for options in [], ["-format", "msh22"]:
        run("gmsh", "-3", *options, "-o", "nested.msh", "nested.geo", folder=folder)
        ball = run(driver, "nested.msh", "--to", "ball", "--refine=all", "-o", "ball.msh", folder=folder)
        assert "(counted from 0). Their references are the cell data 'reference_2'" in ball.stderr
        groups = gmsh_sets(folder / "ball.msh")
        assert groups["bone"].isdisjoint(groups["flesh"]) and groups["all"] == groups["bone"] | groups["flesh"]
    bar = meshio.read(folder / "bar.msh")
    cells = bar.cells_dict["tetra"]
    meshio.write(folder / "zero.vtu", meshio.Mesh(bar.points, [("tetra", cells)],
                                                  cell_data={"material": [numpy.arange(len(cells)) % 2]}))
    run(driver, "zero.vtu", "--improve", "-o", "zero.msh", folder=folder)
    run(driver, "zero.msh", "--improve", "-o", "again.mesh", folder=folder)  # meshio 5.0 reads no cell without a group
    references = meshio.read(folder / "again.mesh").cell_data_dict["medit:ref"]["tetra"]
    assert sorted(references.tolist()) == sorted((numpy.arange(len(cells)) % 2).tolist())


def gmsh_sets(file):
    """The centers of the cells of each group."""
    mesh = meshio.read(file)
    result = {}
    for name, (_, dimension) in mesh.field_data.items():
        if dimension == 3:
            result[name] = {tuple(x.tolist()) for block, cells in zip(mesh.cells, mesh.cell_sets[name]) if block.type == "tetra"
                            for x in mesh.points[block.data[cells]].mean(axis=1)}
    return result


def check_one_cell(driver, folder):
    """A boundary that is too coarse for a box is refined as advised, until it is fine enough."""
    (folder / "one cell.mesh").write_text("MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                                          "0 0 1 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n")
    name = "one cell.mesh"
    for _ in range(2):
        words = shlex.split(refused(driver, name, "--to", "cube", "--refine=none", folder=folder).split("A finer mesh helps: ")[1])
        command = words[:words.index("splits")]
        run(*command, folder=folder)
        name = command[-1]
    run(driver, name, "--to", "cube", "--refine", folder=folder)


def check_data_of_gmsh(driver, folder):
    """Data of nodes and elements of a .msh file come back."""
    mesh = meshio.read(folder / "bar.msh")
    mesh.point_data = {"T": mesh.points @ [1, 2, 3]}
    mesh.cell_data["k"] = [numpy.arange(len(block.data), dtype=float) for block in mesh.cells]
    meshio.write(folder / "data.msh", mesh, file_format="gmsh22", binary=True)
    run(driver, "data.msh", "--to", "box=5,1,1", "--refine=all", "-o", "box.msh", "--refined-source", "refined.msh", folder=folder)
    refined = meshio.read(folder / "refined.msh")
    assert len(refined.points) > len(mesh.points)
    assert numpy.allclose(refined.point_data["T"].ravel(), refined.points @ [1, 2, 3])
    assert numpy.array_equal(meshio.read(folder / "box.msh").point_data["T"], refined.point_data["T"])
    assert set(numpy.concatenate([k.ravel() for k in refined.cell_data["k"]])) == set(
        numpy.concatenate([k.ravel() for k in mesh.cell_data["k"]]))


def check_moved_inclusion(driver, folder):
    """The targets are a mesh that meshio has written, in which an inclusion and its surroundings have moved."""
    (folder / "inclusion.geo").write_text(INCLUSION)
    run("gmsh", "-3", "-o", "inclusion.msh", "inclusion.geo", folder=folder)
    mesh = meshio.read(folder / "inclusion.msh")
    groups = gmsh_groups(mesh)
    moved = mesh.points.copy()
    moved[:, 0] *= 1 + 0.2 * moved[:, 1] * moved[:, 2]
    meshio.write(folder / "moved.vtu", meshio.Mesh(moved, [("tetra", mesh.cells_dict["tetra"])]))
    run(driver, "inclusion.msh", "moved.vtu", "-o", "image.msh", folder=folder)
    image = meshio.read(folder / "image.msh")
    assert gmsh_groups(image) == groups
    has_target = ((mesh.points == 0) | (mesh.points == 1)).any(axis=1)
    has_target[mesh.cells_dict["triangle"]] = True  # those of the interface
    assert numpy.array_equal(image.points[has_target], moved[has_target])


def check_labeled_image(driver, mesh_labels, folder):
    """A body of two materials that touches itself at a vertex is refused, and separated on request."""
    run(mesh_labels, "labels.mesh", folder=folder)
    assert "--separate separates them" in refused(driver, "labels.mesh", "--to", "ball", "--refine", folder=folder)
    run(driver, "labels.mesh", "--to", "ball", "--refine", "--separate", "-o", "ball.mesh", "--refined-source", "refined.mesh",
        folder=folder)
    labels, ball, refined = (meshio.read(folder / name) for name in ("labels.mesh", "ball.mesh", "refined.mesh"))
    areas, areas_of_refined = areas_of_groups(labels, "medit:ref"), areas_of_groups(refined, "medit:ref")
    assert {("tetra", 1), ("tetra", 2)} <= set(areas) == set(areas_of_refined)
    for group, size in areas.items():
        assert abs(areas_of_refined[group] - size) < 1e-5, group  # meshio reads version 1 in single precision
    for kind in ("triangle", "tetra"):
        assert numpy.array_equal(ball.cells_dict[kind], refined.cells_dict[kind])
        assert numpy.array_equal(ball.cell_data_dict["medit:ref"][kind], refined.cell_data_dict["medit:ref"][kind])


def check_advice_for_gmsh(driver, folder):
    """A program without Gmsh tells what makes a file that it reads."""
    run("gmsh", "-3", "-o", "bar.msh", folder / "bar.geo", folder=folder)
    command, = advice(refused(driver, "bar.msh", "--to", "ball", folder=folder), "can be converted: ", "bar.msh")
    run(*command, folder=folder)
    run(driver, "bar.mesh", "--to", "ball", "--refine", "-o", "ball.mesh", folder=folder)
    references = meshio.read(folder / "ball.mesh").cell_data_dict["medit:ref"]
    assert set(references["tetra"].tolist()) == {11, 12} and set(references["triangle"].tolist()) == {21, 22, 23}, references


def triangles_of_references(file):
    return Counter(meshio.read(file).cell_data_dict["medit:ref"]["triangle"].tolist())


def advice(sentence, before, name):
    """The commands that a sentence tells behind some words, with FILE replaced."""
    words = sentence.strip().split(before)[1].replace("FILE", Path(name).stem)
    commands = [shlex.split(command.split(" writes ")[0]) for command in words.split(", and then ")]
    return [[sys.executable if word == "python3" else word for word in command] for command in commands]


def commands_for_surface(sentence, name):
    """The commands that a sentence advises for a surface. The library, which knows no names of files, quotes their beginnings."""
    words = sentence.split("fills it: ")[1]
    if "'" not in words:
        return advice(sentence, "fills it: ", name)
    *converters, mesher = [command.split() for command in re.findall("'([^']+)'", words)]
    return [[*converter, name, "surface.mesh"] for converter in converters] + [[*mesher, "surface.mesh"]]


def check_tetgen(driver, folder, has_gmsh):
    """A surface is refused with the command of a mesher, whose mesh keeps its references. Gmsh fills some formats."""
    points = numpy.array([[x, y, z] for x in (0., 1.) for y in (0., 1.) for z in (0., 1.)])
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    triangles = [[q[0], *q[i:i + 2]] for q in quads for i in (1, 2)]
    (folder / "surface.off").write_text("OFF\n8 12 0\n" + "".join("%g %g %g\n" % tuple(p) for p in points)
                                        + "".join("3 %d %d %d\n" % tuple(t) for t in triangles))
    meshio.write(folder / "surface.mesh", meshio.Mesh(points, [("triangle", triangles)]))
    meshio.write(folder / "surface.vtu", meshio.Mesh(points, [("triangle", triangles)]))
    meshio.write(folder / "surface.obj", meshio.Mesh(points, [("triangle", triangles)]))
    meshio.write(folder / "surface.stl", meshio.Mesh(points, [("triangle", triangles)]))
    for name in ("surface.mesh", "surface.off", "surface.obj", "surface.stl", "surface.vtu"):
        if has_gmsh and name[-3:] in ("off", "obj", "stl"):
            run(driver, name, "--cells", "0.3", "--to", "cube", "-o", "cube.mesh", "--tetrahedra", "filled.mesh", folder=folder)
            volumes = areas_of_groups(meshio.read(folder / "filled.mesh"), "medit:ref")
            assert list(volumes) == [("tetra", 0)] and abs(volumes["tetra", 0] - 1) < 1e-6, volumes
            continue
        sentence = refused(driver, name, "--to", "ball", folder=folder)
        assert "surface" in sentence and "volume mesher fills it" in sentence
        for command in commands_for_surface(sentence, name):
            run(*command, folder=folder)
        run(driver, "surface.1.mesh", "--to", "ball", "--refine", "-o", "ball.mesh", folder=folder)
        assert triangles_of_references(folder / "ball.mesh") == triangles_of_references(folder / "surface.1.mesh")
        (folder / "surface.1.mesh").unlink()


def check_solids(driver, folder):
    """From solids of CAD that touch to hexahedra in one command, as by commands of Gmsh in a program without it."""
    (folder / "touching.geo").write_text(SOLIDS)
    for extension in ("step", "brep"):
        name = f"solids.{extension}"
        run("gmsh", "-0", "touching.geo", "-o", name, folder=folder)
        run(driver, name, "--cells", "0.5", "--to", "polycube", "--hexahedra", "0.5", "hexahedra.msh", "--tetrahedra", "solids.mesh",
            folder=folder)
        mesh = meshio.read(folder / "solids.mesh")
        kinds = {kind: len(set(references.tolist())) for kind, references in mesh.cell_data_dict["medit:ref"].items()}
        # faces: four sides of each box, three rings or discs at three heights less one, and the side of the cylinder
        assert kinds["tetra"] == 3 and kinds["triangle"] == 14, kinds
        cells = numpy.sort(mesh.cells_dict["tetra"], axis=1)
        sides = Counter(map(tuple, numpy.concatenate([numpy.delete(cells, i, axis=1) for i in range(4)])))
        on_boundary = {v for side, number in sides.items() if number == 1 for v in side}
        assert len(numpy.unique(mesh.points[sorted(on_boundary)].round(9), axis=0)) == len(on_boundary), "solids are torn"
        lines = mesh.points[mesh.cells_dict["line"]]
        is_seam = (abs(numpy.linalg.norm(lines[:, :, :2] - [1.5, 1.5], axis=2) - 0.5) < 1e-6).all(axis=1)
        assert not (is_seam & (lines[:, 0, 2] != lines[:, 1, 2])).any(), "a seam of a cylinder is an edge"
        hexahedra = meshio.read(folder / "hexahedra.msh").cell_data_dict["gmsh:physical"]["hexahedron"]
        assert len(set(hexahedra.tolist())) == 3 and len(hexahedra) >= 6 * 6 * 4


def check_advice_for_solids(driver, folder):
    """A program without Gmsh tells what fills solids."""
    (folder / "touching.geo").write_text(SOLIDS)
    run("gmsh", "-0", "touching.geo", "-o", "solids.step", folder=folder)
    sentence = refused(driver, "solids.step", "--to", "ball", folder=folder)
    run(*sentence.split("built without Gmsh: ")[1].split(" fills it")[0].split(), folder=folder)
    assert len(meshio.read(folder / "solids.mesh").cells_dict["tetra"]) > 0


def check_content(driver, folder):
    """What the content of files tells: each advised command makes a mesh with the same cells and subdomains."""
    points = numpy.array([[0., 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
    mesh = meshio.Mesh(points, [("tetra", numpy.array([[0, 1, 2, 3]])), ("tetra", numpy.array([[1, 4, 2, 3]]))])

    def check_command(name, number_of_subdomains):
        sentence = refused(driver, name, "--to", "ball", folder=folder)
        command, = advice(sentence, "can be converted: ", name)
        run(*command, folder=folder)
        target = shlex.split(sentence)[-1]
        assert "2 cells" in run(driver, target, "--to", "ball", "-o", "ball.mesh", folder=folder).stdout, sentence
        references = meshio.read(folder / "ball.mesh").cell_data_dict["medit:ref"]["tetra"]
        assert len(set(references.tolist())) == number_of_subdomains, sentence

    meshio.write(folder / "of abaqus.msh", mesh, file_format="abaqus")
    (folder / "of abaqus.msh").write_text((folder / "of abaqus.msh").read_text().replace("*Heading", "*HEADING"))
    check_command("of abaqus.msh", 1)
    materials = meshio.Mesh(points, [("tetra", numpy.array([[0, 1, 2, 3], [1, 4, 2, 3]]))],
                            cell_data={"avsucd:material": [numpy.array([1, 2])]})
    meshio.write(folder / "ucd.inp", materials, file_format="avsucd")
    check_command("ucd.inp", 2)
    try:
        meshio.write(folder / "blocks.e", mesh)
        check_command("blocks.e", 2)
    except ModuleNotFoundError:
        pass
    middles = [(points[i] + points[j]) / 2 for cell in ((0, 1, 2, 3), (1, 4, 2, 3)) for i, j in
               ((cell[2], cell[3]), (cell[0], cell[1]), (cell[1], cell[2]), (cell[0], cell[2]), (cell[1], cell[3]), (cell[0], cell[3]))]
    (folder / "second.1.node").write_text("17 3 0 0\n" + "".join("%d %g %g %g\n" % (i, *p) for i, p in enumerate([*points, *middles])))
    (folder / "second.1.ele").write_text("2 10 0\n0 0 1 2 3 5 6 7 8 9 10\n1 1 4 2 3 11 12 13 14 15 16\n")
    check_command("second.1.ele", 1)


def check_abaqus(driver, folder):
    """An input file with two sets goes by meshio, in both formats."""
    (folder / "sets.inp").write_text("*HEADING\ntwo\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, 1, 1, 1\n"
                                     "*ELEMENT, TYPE=C3D4, ELSET=BONE\n1, 1, 2, 3, 4\n"
                                     "*ELEMENT, TYPE=C3D4, ELSET=FLESH\n2, 2, 5, 3, 4\n")
    command, = advice(refused(driver, "sets.inp", "--to", "ball", folder=folder), "can be converted: ", "sets.inp")
    run(*command, folder=folder)
    run(driver, "sets.vtu", "--to", "ball", "-o", "ball.vtu", folder=folder)
    assert meshio.read(folder / "sets.vtu").cell_data.keys() <= meshio.read(folder / "ball.vtu").cell_data.keys()
    sentence = refused(driver, "sets.vtu", "--to", "ball", "-o", "map.OTHER", folder=folder)
    command, = advice(sentence.replace("OTHER", "vtk"), "to other formats by: ", "map.vtu")
    run(driver, "sets.vtu", "--to", "ball", "-o", "map.vtu", folder=folder)
    run(*command, folder=folder)
    assert "uvw" in meshio.read(folder / "map.vtk").point_data
    assert set(meshio.read(folder / "ball.vtu").field_data) == {"BONE", "FLESH"}  # the sets are groups
    assert meshio.read(folder / "ball.vtu").cell_data["reference"][0].tolist() == [1, 2]
    run("meshio", "convert", "sets.inp", "sets.mesh", folder=folder)
    assert "2 cells" in run(driver, "sets.mesh", "--to", "ball", folder=folder).stdout


def check_meshio(driver, folder):
    """Each format that meshio converts, as far as its libraries are installed, and formats for which there is no command."""
    points = numpy.array([[0., 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
    mesh = meshio.Mesh(points, [("tetra", numpy.array([[0, 1, 2, 3], [1, 4, 2, 3]]))])
    for extension in ("inp avs cgns e ex2 exo f3grid fem h5m mdpa med nas vol post dato su2 dat tec ele ugrid xml xdmf xmf "
                      "hmf").split():
        name = f"cells.{extension}"
        try:
            meshio.write(folder / name, mesh)
        except ModuleNotFoundError:
            continue
        command, = advice(refused(driver, name, "--to", "ball", folder=folder), "can be converted: ", name)
        run(*command, folder=folder)
        assert "2 cells" in run(driver, "cells.vtu", "--to", "ball", folder=folder).stdout, name
        (folder / "cells.vtu").unlink()
    for extension in ("tet", "veg", "neu"):
        (folder / f"cells.{extension}").write_text("cells\n")
        assert "meshio convert" not in refused(driver, f"cells.{extension}", "--to", "ball", folder=folder)


FLUENT = """(0 "Fluent")
(2 3)
(10 (0 1 5 0 3))
(10 (1 1 5 1 3)(
0 0 0
1 0 0
0 1 0
0 0 1
1 1 1
))
(12 (0 1 2 0))
(12 (2 1 2 1 2))
(13 (0 1 7 0))
(13 (3 1 1 2 3)(
2 3 4 1 2
))
(13 (4 2 7 3 3)(
1 2 3 1 0
1 4 2 1 0
1 3 4 1 0
2 5 3 2 0
2 4 5 2 0
3 5 4 2 0
))
"""
PIECE = """<Piece NumberOfPoints="4" NumberOfCells="1"><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0 0 0 %d</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray><DataArray type="UInt8" Name="types" format="ascii">10</DataArray>
</Cells></Piece>"""
GRID = """<?xml version="1.0"?>
<VTKFile type="%sUnstructuredGrid" version="0.1" byte_order="LittleEndian"><%sUnstructuredGrid>%s</%sUnstructuredGrid></VTKFile>"""


def check_paraview(driver, folder):
    """What is advised to be done in ParaView helps, here by VTK's classes, if they are installed."""
    try:
        import vtk
    except ImportError:
        return

    def saved(reader, name, filters=()):
        reader.SetFileName(str(folder / name))
        for of_vtk in (*filters, vtk.vtkXMLUnstructuredGridWriter()):
            of_vtk.SetInputConnection(reader.GetOutputPort())
            reader = of_vtk
        reader.SetFileName(str(folder / "saved.vtu"))
        reader.Write()
        return "saved.vtu"

    (folder / "of fluent.msh").write_text(FLUENT)
    sentence = refused(driver, "of fluent.msh", "--to", "ball", folder=folder)
    name = shlex.split(sentence.split("under the name ")[1].split(". Apply")[0])[0]
    (folder / "of fluent.msh").rename(folder / name)
    reader = vtk.vtkFLUENTReader()
    reader.SetFileName(str(folder / name))
    reader.Update()
    merged = vtk.vtkAppendFilter()
    merged.AddInputData(reader.GetOutput().GetBlock(0))
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetInputConnection(merged.GetOutputPort())
    writer.SetFileName(str(folder / "saved.vtu"))
    writer.Write()
    assert "2 cells" in run(driver, "saved.vtu", "--to", "ball", folder=folder).stdout

    for i, z in enumerate((1, -1)):
        (folder / f"piece_{i}.vtu").write_text(GRID % ("", "", PIECE % z, ""))
    (folder / "pieces.vtu").write_text(GRID % ("", "", PIECE % 1 + PIECE % -1, ""))
    (folder / "pieces.pvtu").write_text(GRID % ("P", "P", '<PPoints><PDataArray type="Float64" NumberOfComponents="3"/>'
                                               '</PPoints><Piece Source="piece_0.vtu"/><Piece Source="piece_1.vtu"/>', "P"))
    readers = {"pieces.vtu": vtk.vtkXMLUnstructuredGridReader, "pieces.pvtu": vtk.vtkXMLPUnstructuredGridReader}
    for name, reader in readers.items():
        assert "--merge-points" in refused(driver, name, "--to", "ball", folder=folder), name
        file = saved(reader(), name)
        assert "2 cells, 5 vertices" in run(driver, file, "--merge-points", "--to", "ball", folder=folder).stdout

    points = numpy.array([[x, y, z] for z in (0., 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))] + [[.5, .5, 2.]])
    meshio.write(folder / "mixed.vtu", meshio.Mesh(points, [("hexahedron", numpy.array([range(8)])),
                                                            ("pyramid", numpy.array([[4, 5, 6, 7, 8]]))]))
    assert "hexahedra, such as cell 0" in refused(driver, "mixed.vtu", "--to", "ball", folder=folder)
    file = saved(vtk.vtkXMLUnstructuredGridReader(), "mixed.vtu", [vtk.vtkDataSetTriangleFilter()])
    assert "0 inverted cells" in run(driver, file, "--to", "ball", "--refine", folder=folder).stdout


def check_vtk(driver, folder):
    """Legacy files of VTK, as MFEM writes them, with data of cells and points."""
    run("tetgen", "-pqga0.1", "surface.off", folder=folder)
    mesh = meshio.read(folder / "surface.1.mesh")
    cells = mesh.cells_dict["tetra"]
    x = mesh.points[cells].mean(axis=1)[:, 0]
    mesh = meshio.Mesh(mesh.points, [("tetra", cells)], point_data={"T": mesh.points @ [1., 2., 3.]},
                       cell_data={"material": [1 + (x > 0.5)]})
    meshio.write(folder / "cube.vtk", mesh, file_format="vtk42", binary=True)
    run(driver, "cube.vtk", "--to", "ball", "--refine", "-o", "ball.vtu", folder=folder)
    ball = meshio.read(folder / "ball.vtu")
    assert numpy.allclose(ball.point_data["T"], ball.points @ [1, 2, 3])
    assert set(ball.cell_data["reference"][0].tolist()) == {1, 2}
    assert numpy.array_equal(ball.cell_data["reference"][0], ball.cell_data["material"][0])


def main(driver, mesh_labels, options):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "bar.geo").write_text(TWO_MATERIALS)
        if "--gmsh" in options:
            check_gmsh(driver, folder)
            check_nested_groups(driver, folder)
            check_data_of_gmsh(driver, folder)
            check_moved_inclusion(driver, folder)
            check_solids(driver, folder)
        else:
            check_advice_for_gmsh(driver, folder)
            check_advice_for_solids(driver, folder)
        check_one_cell(driver, folder)
        check_labeled_image(driver, mesh_labels, folder)
        check_tetgen(driver, folder, "--gmsh" in options)
        check_content(driver, folder)
        check_abaqus(driver, folder)
        check_meshio(driver, folder)
        check_paraview(driver, folder)
        if "--vtk" in options:
            check_vtk(driver, folder)
    print("Groups and data go through.")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
