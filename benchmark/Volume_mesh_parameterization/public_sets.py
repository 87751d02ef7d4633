"""Reads public sets of bodies and targets as they are published, and writes each case as a mesh and a text of targets.

A set is a name and a folder:

- volmap: MODEL.mesh with MODEL_DOMAIN.txt (VOLMAP, and the meshes that run_models.py keeps; CuboidBlocks likewise), taken as
  they are
- channels: the same form, as write_channels.py makes it
- pairs: NAME_source.mesh and NAME_polycube.mesh, taken as they are
- wrapd: folders with *_rest and *_soln of TetGen (.node, .ele): the boundary of each is the target of the other
- handles: the same folders, with *_handles.txt: the vertices that are moved to their positions in *_soln, and all others are free
- hexahedra: NAME.mesh and NAME_polycube.mesh, or NAME_model.mesh and NAME_polycube.mesh, of the same hexahedra (polycube
  papers in HexaLab): each hexahedron becomes six tetrahedra
- poses: NAME.mesh and NAME-*.obj, each with a position for each vertex (flip-free parametrization): NAME is mapped to the
  boundary of each
"""
from pathlib import Path

from check_map import boundary_facets, orientation
from volmap_cases import Case, find_cases



def rows_of_TetGen(filename):
    """The rows without comments, and the first index."""
    lines = [line.partition("#")[0].split() for line in Path(filename).read_text().splitlines()]
    lines = [words for words in lines if words]
    rows = lines[1:1 + int(lines[0][0])]
    return [row[1:] for row in rows], int(rows[0][0])


def read_TetGen(stem):
    points, _ = rows_of_TetGen(f"{stem}.node")
    cells, first = rows_of_TetGen(f"{stem}.ele")
    return [tuple(map(float, row[:3])) for row in points], [tuple(int(v) - first for v in row[:4]) for row in cells]


def read_MEDIT(filename, keyword, size):
    words = Path(filename).read_text().split()

    def rows(name, width):
        begin = words.index(name) + 2
        return [words[i:i + width] for i in range(begin, begin + width * int(words[begin - 1]), width)]
    return ([tuple(map(float, row[:3])) for row in rows("Vertices", 4)],
            [tuple(int(v) - 1 for v in row[:size]) for row in rows(keyword, size + 1)])


def tetrahedra_of(hexahedra):
    """The diagonal of each quadrangle begins at its smallest index, so that both hexahedra beside it agree."""
    turns = ((0, 1, 2, 3, 4, 5, 6, 7), (1, 2, 3, 0, 5, 6, 7, 4), (2, 3, 0, 1, 6, 7, 4, 5), (3, 0, 1, 2, 7, 4, 5, 6),
             (4, 7, 6, 5, 0, 3, 2, 1), (5, 4, 7, 6, 1, 0, 3, 2), (6, 5, 4, 7, 2, 1, 0, 3), (7, 6, 5, 4, 3, 2, 1, 0))
    far = ((1, 2, 6, 5), (2, 3, 7, 6), (4, 5, 6, 7))  # the quadrangles without the vertex 0
    cells = []
    for hexahedron in hexahedra:
        h = [hexahedron[i] for i in turns[min(range(8), key=lambda i: hexahedron[i])]]
        for quadrangle in far:
            q = [h[i] for i in quadrangle]
            k = min(range(4), key=lambda i: q[i])
            a, b, c, d = q[k:] + q[:k]
            cells += [(h[0], a, b, c), (h[0], a, c, d)]
    return cells


def oriented(points, cells):
    """All cells with the sign of the first one turned to be positive; none if they are of both signs."""
    signs = {orientation(points, cell) for cell in cells}
    if signs == {1}:
        return cells
    return [(a, c, b, d) for a, b, c, d in cells] if signs == {-1} else None


def write_case(folder, name, points, cells, targets, handles=None):
    """A case in the form of VOLMAP; none if cells of the source are flat or of both signs. With handles, the boundary is free."""
    cells = oriented(points, cells)
    if cells is None:
        return None
    mesh, text = folder / f"{name}.mesh", folder / f"{name}_target.txt"
    with open(mesh, "w") as file:
        print("MeshVersionFormatted 2\nDimension 3\nVertices", len(points), sep="\n", file=file)
        file.writelines(f"{x!r} {y!r} {z!r} 0\n" for x, y, z in points)
        print("Tetrahedra", len(cells), sep="\n", file=file)
        file.writelines(" ".join(str(v + 1) for v in cell) + " 0\n" for cell in cells)
        print("End", file=file)
    with open(text, "w") as file:
        for v in sorted(handles or {v for facet in boundary_facets(cells) for v in facet}):
            print(v, *map(repr, targets[v]), file=file)
    return Case(name, mesh, text, handles is not None)


def cases_of_wrapd(source, output):
    for node in sorted(Path(source).rglob("*_rest.node")):
        name = node.stem[:-len("_rest")]
        rest, cells = read_TetGen(node.with_suffix(""))
        for solution in sorted(node.parent.glob(f"{name}*_soln.node")):
            solved, _ = read_TetGen(solution.with_suffix(""))
            yield write_case(output, f"{name}_to_solution", rest, cells, solved)
            yield write_case(output, f"{name}_to_rest", solved, cells, rest)


def cases_of_handles(source, output):
    for handles in sorted(Path(source).rglob("*_handles.txt")):
        name = handles.stem[:-len("_handles")]
        rest, cells = read_TetGen(handles.with_name(f"{name}_rest"))
        (solution,) = handles.parent.glob(f"{name}*_soln.node")
        solved, _ = read_TetGen(solution.with_suffix(""))
        yield write_case(output, f"{name}_handles", rest, cells, solved, set(map(int, handles.read_text().split())))


def cases_of_hexahedra(source, output):
    for polycube in sorted(Path(source).rglob("*_polycube.mesh")):
        stem = polycube.name[:-len("_polycube.mesh")]
        for model in (polycube.with_name(f"{stem}.mesh"), polycube.with_name(f"{stem}_model.mesh")):
            if model.exists():
                points, hexahedra = read_MEDIT(model, "Hexahedra", 8)
                targets, _ = read_MEDIT(polycube, "Hexahedra", 8)
                yield write_case(output, f"{stem}_polycube", points, tetrahedra_of(hexahedra), targets)


def points_of_OBJ(filename):
    return [tuple(map(float, line.split()[1:4])) for line in Path(filename).read_text().splitlines() if line.startswith("v ")]


def cases_of_poses(source, output):
    for mesh in sorted(Path(source).rglob("*.mesh")):
        points, cells = read_MEDIT(mesh, "Tetrahedra", 4)
        for pose in sorted(mesh.parent.glob(f"{mesh.stem}-*.obj")):
            targets = points_of_OBJ(pose)
            if len(targets) == len(points):
                yield write_case(output, pose.stem, points, cells, targets)


def cases_of_volmap(source, _):
    return find_cases(volmap=source)


READERS = {"volmap": cases_of_volmap, "channels": cases_of_volmap, "pairs": lambda source, _: find_cases(pairs=source),
           "wrapd": cases_of_wrapd, "handles": cases_of_handles, "hexahedra": cases_of_hexahedra, "poses": cases_of_poses}


def cases_of_set(name, folder, output):
    """The cases, and the number of those left out, whose cells of the source are not all positive."""
    output = Path(output) / name
    output.mkdir(parents=True, exist_ok=True)
    found = list(READERS[name](folder, output))
    return [case for case in found if case], found.count(None)
