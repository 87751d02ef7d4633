#!/usr/bin/env python3
"""Checks the written result of the driver with exact arithmetic, and without the library that made it.

check_map.py SOURCE.mesh TARGET REFINED_SOURCE.mesh MAP.mesh

The refined source must be the source with added vertices, each cell of the map must have the sign of its cell in the
refined source, and boundary vertices must have the prescribed coordinates, bit for bit. (Cells of one sign with one
boundary cover the domain once.) Added vertices on the boundary have no such coordinates.
"""
import struct
import sys
from collections import Counter, namedtuple
from fractions import Fraction

Mesh = namedtuple("Mesh", "points cells")
Verdict = namedtuple("Verdict", "fault inverted_cells missed_vertices added_vertices")


def read_mesh(filename):
    with open(filename) as file:
        words = " ".join(line.partition("#")[0] for line in file).split()

    def rows(keyword, width):
        begin = words.index(keyword) + 2
        end = begin + width * int(words[begin - 1])
        return [words[i:i + width] for i in range(begin, end, width)]

    points = [tuple(map(float, row[:3])) for row in rows("Vertices", 4)]
    cells = [tuple(int(v) - 1 for v in row[:4]) for row in rows("Tetrahedra", 5)]
    return Mesh(points, cells)


def read_targets(filename, number_of_source_points):
    """The prescribed points by vertex, from a text or from a mesh of the same connectivity."""
    if str(filename).endswith(".mesh"):
        return dict(enumerate(read_mesh(filename).points[:number_of_source_points]))
    targets = {}
    with open(filename) as file:
        for line in file:
            words = line.partition("#")[0].split()
            if words:
                targets[int(words[0])] = tuple(map(float, words[1:4]))
    return targets


def determinant(a, b, c, d):
    """The determinant of the edges from d, and the same sum with the absolute values of its products."""
    ax, ay, az = a[0] - d[0], a[1] - d[1], a[2] - d[2]
    bx, by, bz = b[0] - d[0], b[1] - d[1], b[2] - d[2]
    cx, cy, cz = c[0] - d[0], c[1] - d[1], c[2] - d[2]
    value = az * (bx * cy - by * cx) + bz * (cx * ay - cy * ax) + cz * (ax * by - ay * bx)
    size = (abs(az) * (abs(bx * cy) + abs(by * cx)) + abs(bz) * (abs(cx * ay) + abs(cy * ax))
            + abs(cz) * (abs(ax * by) + abs(ay * bx)))
    return value, size


def orientation(points, cell):
    """The exact sign of the volume of a cell."""
    corners = [points[v] for v in cell]
    value, size = determinant(*corners)
    # rounding: below 8 * 2^-53 times the size; underflow: far below 1e-200
    if not abs(value) > 1e-15 * size + 1e-200:
        value, _ = determinant(*[tuple(map(Fraction, p)) for p in corners])
    return (value < 0) - (value > 0)


def boundary_facets(cells):
    """The facets that belong to one cell only."""
    count = Counter()
    for a, b, c, d in map(sorted, cells):
        count.update(((a, b, c), (a, b, d), (a, c, d), (b, c, d)))
    return {facet for facet, n in count.items() if n == 1}


def bits(point):
    return struct.pack("<3d", *point)


def volume(mesh):
    return sum(determinant(*[mesh.points[v] for v in cell])[0] for cell in mesh.cells)


def structural_fault(source, refined, image):
    """What is wrong with the refined source, or with the connectivity of the map."""
    if refined.cells != image.cells or len(refined.points) != len(image.points):
        return "the map has another connectivity than the refined source"
    if any(bits(p) != bits(q) for p, q in zip(source.points, refined.points)):
        return "the refined source moves vertices of the source"
    facets, refined_facets = boundary_facets(source.cells), boundary_facets(refined.cells)
    is_split = any(v >= len(source.points) for facet in refined_facets for v in facet)
    # programs may write the cells of the refined source in the other orientation
    if facets != refined_facets and (not is_split or abs(abs(volume(refined) / volume(source)) - 1) > 1e-9):
        return "the refined source has another boundary than the source"
    if not all(abs(x) < float("inf") for p in image.points for x in p):
        return "the map has a coordinate that is not finite"
    return ""


def check(source_file, target_file, refined_file, image_file, is_free=False):
    """If the boundary is free, only vertices with a target are prescribed. Vertices that split facets of the boundary have none,
    and count as missed: they are on the prescribed triangles up to rounding only."""
    source, refined, image = map(read_mesh, (source_file, refined_file, image_file))
    targets = read_targets(target_file, len(source.points))
    added = len(refined.points) - len(source.points)

    fault = structural_fault(source, refined, image)
    if fault:
        return Verdict(fault, None, None, added)

    signs = Counter(orientation(source.points, cell) for cell in source.cells)
    if len(signs) != 1 or 0 in signs:
        fault = "the cells of the source do not have one orientation"
    refined_signs = [orientation(refined.points, cell) for cell in refined.cells]
    if len(set(refined_signs)) != 1 or 0 in refined_signs:
        fault = "the cells of the refined source do not have one orientation"

    inverted = sum(orientation(image.points, cell) != sign for cell, sign in zip(image.cells, refined_signs))
    prescribed = targets if is_free else {v for facet in boundary_facets(refined.cells) for v in facet}
    missed = sum(v not in targets or bits(image.points[v]) != bits(targets[v]) for v in prescribed)
    return Verdict(fault, inverted, missed, added)


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    verdict = check(*sys.argv[1:])
    print(*(f"{key}: {value}" for key, value in verdict._asdict().items()), sep="\n")
    sys.exit(verdict.fault != "" or verdict.inverted_cells != 0 or verdict.missed_vertices != 0)


if __name__ == "__main__":
    main()
