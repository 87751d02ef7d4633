#!/usr/bin/env python3
"""Writes blocks with a blind channel, and a map of the boundary of each to a ball, for compare_programs.py --set channels=FOLDER.

write_channels.py PARAMETERIZE_MESH_FILE FOLDER

A block has 24 x 22 x 8 voxels of six tetrahedra. Its channel is one voxel wide, and ends four voxels, or (thin) one voxel, before a
side. Its walls become a small part of the sphere, around which all cells must pass. The targets are the boundary of a map that the
program finds.
"""
import itertools
import subprocess
import sys
import tempfile
from pathlib import Path

from check_map import orientation, read_mesh
from public_sets import write_case

SIZE = (24, 22, 8)


def channels(plug):
    """The corners of each channel, which ends so many voxels before a side."""
    return {"straight": [(0, 6, 2), (23 - plug, 6, 2)], "L": [(0, 6, 2), (14, 6, 2), (14, 21 - plug, 2)],
            "U": [(0, 6, 2), (18, 6, 2), (18, 14, 2), (1 + plug, 14, 2)]}


def voxels_along(corners):
    """From each corner to the next, along an axis."""
    voxels = set()
    for a, b in zip(corners, corners[1:]):
        voxels.update(itertools.product(*(range(min(p, q), max(p, q) + 1) for p, q in zip(a, b))))
    return voxels


def tetrahedra_of(voxels):
    """A tetrahedron for each order of the axes, along which it goes from the lowest to the highest corner of its voxel."""
    numbers, cells = {}, []
    for voxel in voxels:
        for axes in itertools.permutations(range(3)):
            corners = [voxel]
            for axis in axes:
                corners.append(tuple(x + (i == axis) for i, x in enumerate(corners[-1])))
            if orientation(corners, range(4)) < 0:
                corners[2:] = reversed(corners[2:])
            cells.append([numbers.setdefault(p, len(numbers)) for p in corners])
    return list(numbers), cells


def positions_in_ball(driver, mesh):
    with tempfile.TemporaryDirectory() as folder:
        image = Path(folder) / "image.mesh"
        subprocess.run([driver, mesh, "--to", "ball", "--refine", "--quiet", "--output", image], check=True)
        return read_mesh(image).points


def main(driver, folder):
    folder.mkdir(parents=True, exist_ok=True)
    blocks = [*channels(4).items(), *((f"{name}_thin", corners) for name, corners in channels(1).items())]
    for name, corners in blocks:
        channel = voxels_along(corners)
        points, cells = tetrahedra_of(voxel for voxel in itertools.product(*map(range, SIZE)) if voxel not in channel)
        mesh = write_case(folder, name, points, cells, points).source
        write_case(folder, name, points, cells, positions_in_ball(driver, mesh))


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
