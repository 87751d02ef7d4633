#!/usr/bin/env python3
"""Checks a map of the boundary of a mesh onto a ball, a cube or a polycube with exact arithmetic.

check_boundary.py SOURCE.mesh TARGET.txt ball|cube|polycube

prints the number of triangles that are flipped or flat. In a ball and a cube, the origin must see each triangle
from inside, and the triangles must cover the sphere of directions once. In a cube and a polycube, each triangle
must be in a plane normal to an axis, those that share an edge in one plane must have the same normal, and the
outermost ones must look outwards.
"""
import sys
from collections import defaultdict

from check_map import orientation, read_mesh, read_targets


def oriented_boundary_facets(source):
    """The facets of one cell only, with the orientation of the cell if the apex comes last."""
    facets = {}
    for a, b, c, d in source.cells:
        for facet in ((a, b, c), (b, a, d), (c, d, a), (d, c, b)):
            key = tuple(sorted(facet))
            if facets.pop(key, None) is None:
                facets[key] = facet
    return list(facets.values())


def is_seen(points, facet, apex, sign):
    return orientation([*(points[v] for v in facet), apex], range(4)) == sign


def facets_hidden_from_origin(points, facets, sign):
    """Those that the origin does not see from inside, or that cover a direction again."""
    origin = (0.0, 0.0, 0.0)
    hidden = sum(not is_seen(points, facet, origin, sign) for facet in facets)
    direction = tuple(map(sum, zip(*(points[v] for v in facets[0]))))

    def covers_direction(facet):
        corners = [points[v] for v in facet]
        others = [[direction if k == i else corner for k, corner in enumerate(corners)] for i in range(3)]
        return all(orientation([*triple, origin], range(4)) != -sign for triple in others)

    return hidden + sum(map(covers_direction, facets)) - 1


def axis_and_side(points, facet, sign):
    """The axis normal to the facet, and whether it looks along or against it; None if it is flat or oblique."""
    corners = [points[v] for v in facet]
    for axis in range(3):
        if len({corner[axis] for corner in corners}) == 1:
            below = list(corners[0])
            below[axis] = min(2 * below[axis], 0.0) - 1
            side = orientation([*corners, below], range(4)) * sign
            if side:
                return axis, side
    return None


def facets_off_axes(points, facets, sign):
    """Those that are flat or oblique, or folded onto a neighbour in the same plane, or all if inside is outside."""
    normals = [axis_and_side(points, facet, sign) for facet in facets]
    neighbors = defaultdict(list)
    for facet, normal in zip(facets, normals):
        for i in range(3):
            neighbors[frozenset((facet[i], facet[i - 1]))].append(normal)
    folded = sum(None not in pair and pair[0][0] == pair[1][0] and pair[0][1] != pair[1][1]
                 for pair in neighbors.values())
    x_and_sides = [(points[facet[0]][0], normal[1]) for facet, normal in zip(facets, normals)
                   if normal and normal[0] == 0]
    is_inside_out = max(x_and_sides, default=(0, 1))[1] < 0
    return len(facets) if is_inside_out else normals.count(None) + folded


def check_boundary(source_file, target_file, domain):
    source = read_mesh(source_file)
    points = read_targets(target_file, len(source.points))
    facets = oriented_boundary_facets(source)
    sign = orientation(source.points, source.cells[0])
    faults = 0
    if domain in ("ball", "cube"):
        faults += facets_hidden_from_origin(points, facets, sign)
    if domain in ("cube", "polycube"):
        faults += facets_off_axes(points, facets, sign)
    return faults


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    faults = check_boundary(*sys.argv[1:])
    print("flipped or flat triangles:", faults)
    sys.exit(faults != 0)


if __name__ == "__main__":
    main()
