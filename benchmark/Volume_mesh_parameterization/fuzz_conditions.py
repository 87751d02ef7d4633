#!/usr/bin/env python3
"""Runs the driver with random conditions beside other options, and checks each result in exact arithmetic, without the library.

fuzz_conditions.py DRIVER [FIRST_SEED [NUMBER]]

A run has a body of a few cubes, torn along facets and pinched at vertices, and random files for TARGET and --conditions, beside
--others, --slide, --displacements, --merge-points and --separate. A line that contradicts another one must be refused, and
nothing else. Otherwise coordinates, targets and vertices that stay must be met bit by bit, and planes within rounding. Faults are
printed with their seed; the exit status is 1 if there are any.
"""
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from fractions import Fraction
from itertools import permutations
from pathlib import Path

from check_map import orientation, read_mesh

ROUNDING, SMALLEST_ANGLE = Fraction(1, 10**12), Fraction(1, 10**9)


def cube_cells():
    """Six tetrahedra along the diagonal of the unit cube, as corners."""
    for axes in permutations(range(3)):
        corners = [(0, 0, 0)]
        for axis in axes:
            corners.append(tuple(x + (i == axis) for i, x in enumerate(corners[-1])))
        is_even = axes in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
        yield corners if is_even else [corners[1], corners[0], corners[2], corners[3]]


def random_body(rand):
    """Points, cells and referenced boundary triangles of cubes; each part of the body has points of its own."""
    places = rand.sample([(i, j, k) for i in range(3) for j in range(2) for k in range(2)], rand.randint(1, 4))
    scale, offset = rand.choice([(1, 0), (0.1, 0), (0.375, 1000), (1, 1e9), (1e-6, 0)])
    number_of_parts = rand.randint(1, 2)
    numbers, points, cells, facets = {}, [], [], Counter()
    for place in places:
        part = rand.randrange(number_of_parts)
        for corners in cube_cells():
            cell = []
            for corner in corners:
                p = tuple(float(offset + scale * (a + b)) for a, b in zip(place, corner))
                cell.append(numbers.setdefault((part, p), len(points)))
                if cell[-1] == len(points):
                    points.append(p)
            cells.append(cell)
            facets.update(tuple(sorted(cell[:i] + cell[i + 1:])) for i in range(4))
    triangles = []
    for facet, number in facets.items():
        axis = next((i for i in range(3) if len({points[v][i] for v in facet}) == 1), None)
        if number == 1 and rand.random() < 0.9:
            triangles.append((facet, 7 if axis is None else axis + 1))
    return points, cells, triangles


def write_body(path, points, cells, triangles):
    rows = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    rows += [f"{x!r} {y!r} {z!r} 0" for x, y, z in points]
    rows += ["Tetrahedra", str(len(cells))] + [" ".join(str(v + 1) for v in cell) + " 1" for cell in cells]
    rows += ["Triangles", str(len(triangles))] + [" ".join(str(v + 1) for v in f) + f" {ref}" for f, ref in triangles]
    path.write_text("\n".join(rows + ["End"]) + "\n")


def random_condition(rand, point, scale):
    """The text of a condition, and its planes: a normal, and an offset or none for a plane through the start."""
    unit = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    kind = rand.choice(["fixed", "free", "plane", "plane", "coordinate", "coordinate"])
    if kind == "plane":
        normal = [float(rand.randint(-2, 2)) for _ in range(3)]
        while not any(normal):
            normal = [float(rand.randint(-2, 2)) for _ in range(3)]
        if rand.random() < 0.3:
            normal[rand.randrange(3)] += rand.choice([1e-4, 1e-6, 3e-9, 1e-10, 1e-11])
        factor = rand.choice([1.0, 1.0, 1.0, 1e-5, 2.0**1020, 2.0**-1060])
        normal = [factor * x for x in normal]
        return "plane {!r} {!r} {!r}".format(*normal), [(tuple(normal), None)]
    if kind == "coordinate":
        axis = rand.randrange(3)
        value = point[axis] + rand.choice([0, 0, 0.125, 0.1]) * scale
        return f"{'xyz'[axis]}={value!r}", [(unit[axis], value)]
    return kind, [(n, None) for n in unit] if kind == "fixed" else []


def exact(values):
    return [Fraction(x) for x in values]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def is_contradiction(start, planes, size):
    """Do planes contradict each other, or are they nearly parallel? None if this is for rounding to decide."""
    point, moves, coordinates = exact(start), [], {}
    is_unit = lambda n: sorted(n) == [0, 0, 1]
    for normal, offset in sorted(planes, key=lambda plane: (not is_unit(plane[0]), plane[0])):
        n = exact(normal)
        offset = dot(n, exact(start)) if offset is None else Fraction(offset)
        if is_unit(normal):
            if coordinates.setdefault(normal, offset) != offset:
                return True
        free = list(n)
        for move in moves:
            factor = dot(n, move) / dot(move, move)
            free = [x - factor * y for x, y in zip(free, move)]
        squared_sine, distance = dot(free, free) / dot(n, n), offset - dot(n, point)
        if squared_sine >= SMALLEST_ANGLE**2:
            point = [x + distance / dot(free, free) * y for x, y in zip(point, free)]
            moves.append(free)
        elif squared_sine > ROUNDING**2:
            return True
        elif distance**2 > (ROUNDING * Fraction(size))**2 * dot(n, n):
            return None if distance**2 < (1000 * ROUNDING * Fraction(size))**2 * dot(n, n) else True
    return False


def is_plane_missed(image, start, normal, offset, size):
    n = exact(normal)
    distance = dot(n, exact(image)) - (dot(n, exact(start)) if offset is None else Fraction(offset))
    if sorted(normal) == [0, 0, 1]:
        return distance != 0
    tolerance = Fraction(64, 2**53) * (Fraction(size) + max(abs(Fraction(x)) for x in image)) + ROUNDING * Fraction(size)
    return distance**2 > tolerance**2 * dot(n, n)


class Run:
    def __init__(self, seed, folder):
        rand = self.rand = random.Random(seed)
        self.folder = folder
        self.points, self.cells, self.triangles = random_body(rand)
        self.size = max(max(p[i] for p in self.points) - min(p[i] for p in self.points) for i in range(3)) * 1.7
        write_body(folder / "body.mesh", self.points, self.cells, self.triangles)
        self.options = {name for name in ("merge-points", "separate") if rand.random() < 0.4}
        self.arguments = ["body.mesh"]
        self.targets = self.random_targets() if rand.random() < 0.6 else {}
        self.lines = self.random_lines() if rand.random() < 0.8 or not self.targets else []
        self.others = rand.choice([None, "missing", "stay", "stay", "free"] + ["slide"] * (not self.lines))
        if self.others:
            self.arguments += ["--others", self.others]
        else:
            self.others = "free" if self.lines else "missing"
        self.is_sliding = not self.lines and self.others != "free" and rand.random() < 0.2
        if self.is_sliding:
            self.arguments.append("--slide")
        self.arguments += ["--" + name for name in self.options] + ["-o", "map.mesh", "--quiet", "--max-iterations", "30"]

    def random_targets(self):
        scale = self.size / 8
        targets = {v: tuple(x + self.rand.choice([0, 0, 0.25, -0.2]) * scale for x in p)
                   for v, p in enumerate(self.points) if self.rand.random() < 0.4} or {0: self.points[0]}
        if self.rand.random() < 0.7:  # copies move alike
            targets = {v: targets[next(w for w in targets if self.points[w] == self.points[v])] for v in targets}
        are_displacements = self.rand.random() < 0.3
        rows = targets
        if are_displacements:
            rows = {v: tuple(x - y for x, y in zip(t, self.points[v])) for v, t in targets.items()}
            targets = {v: tuple(x + y for x, y in zip(d, self.points[v])) for v, d in rows.items()}
            self.arguments.append("--displacements")
        (self.folder / "target.txt").write_text("".join(f"{v} {x!r} {y!r} {z!r}\n" for v, (x, y, z) in rows.items()))
        self.arguments.append("target.txt")
        return targets

    def random_lines(self):
        """Lines of conditions, as what they are about and their planes; their order in the file is that of the list."""
        references = sorted({reference for _, reference in self.triangles})
        lines, text = [], []
        for _ in range(self.rand.randint(0, 6)):
            v = self.rand.randrange(len(self.points))
            condition, planes = random_condition(self.rand, self.points[v], self.size / 8)
            is_index = not references or self.rand.random() < 0.7
            subject = v if is_index else self.rand.choice(references)
            lines.append((is_index, subject, planes))
            text.append((f"vertex {v} " if is_index else f"{subject} ") + condition + self.rand.choice(["", "  # a comment", "\r"]))
            text += [""] * self.rand.randint(0, 1)
        (self.folder / "conditions.txt").write_text("\n".join(text))
        self.arguments += ["--conditions", "conditions.txt"]
        return lines or [(True, -1, [])]

    def cells_of_file(self):
        """The cells, with the first one of merged points."""
        first = {}
        for v, p in enumerate(self.points):
            first.setdefault(p, v)
        return [[first[self.points[v]] if "merge-points" in self.options else v for v in cell] for cell in self.cells]

    def separated(self, cells):
        """The cells with vertices of its own for each fan of cells around a vertex that facets join."""
        corners_of_facets = defaultdict(list)
        for c, cell in enumerate(cells):
            for i in range(4):
                corners_of_facets[tuple(sorted(cell[:i] + cell[i + 1:]))].append(c)
        fans = {(c, v): (c, v) for c, cell in enumerate(cells) for v in cell}

        def root(corner):
            while fans[corner] != corner:
                corner = fans[corner]
            return corner

        for facet, sides in corners_of_facets.items():
            for v in facet:
                fans[root((sides[0], v))] = root((sides[-1], v))
        return [[root((c, v)) for v in cell] for c, cell in enumerate(cells)]

    def expected(self, cells):
        """What is prescribed to each vertex of cells: its position, a target or none, and the planes of each line."""
        of_file = self.cells_of_file()
        origins = {v: w for cell, other in zip(cells, of_file) for v, w in zip(cell, other)}
        copies = defaultdict(set)
        for other, cell in zip(of_file, self.cells):
            for v, w in zip(other, cell):
                copies[v].add(w)
        references = {tuple(sorted(facet)): reference for facet, reference in self.triangles}
        references_of_vertices = defaultdict(set)  # facets follow their cells
        for cell, in_file in zip(cells, self.cells):
            for i in range(4):
                reference = references.get(tuple(sorted(in_file[:i] + in_file[i + 1:])))
                for v in cell[:i] + cell[i + 1:]:
                    references_of_vertices[v].add(reference)
        result = {}
        for v, origin in origins.items():
            numbers = copies[origin]
            target = next((self.targets[w] for w in sorted(numbers) if w in self.targets), None)
            lines = [planes for is_index, subject, planes in self.lines
                     if (subject in numbers if is_index else subject in references_of_vertices[v])]
            result[v] = (self.points[origin], target, lines)
        return result

    def refusal(self):
        """Why the program must refuse the input; empty if it must not, and none if rounding decides."""
        by_place = defaultdict(set)
        for v, target in self.targets.items():
            by_place[self.points[v]].add(target)
        if "merge-points" in self.options and any(len(targets) > 1 for targets in by_place.values()):
            return "merged, but"
        cells = self.cells_of_file()
        expected = self.expected(self.separated(cells) if "separate" in self.options else cells).values()
        answers = [is_contradiction(target or p, sum(lines, []), self.size) for p, target, lines in expected if lines]
        if True in answers:
            return "contradict|nearly parallel"
        if None in answers:
            return None
        if self.others == "missing" and any(target is None and not lines for _, target, lines in expected):
            return "has no target"
        return ""

    def fault(self, driver):
        """Runs the program; what is wrong, and the kind of the outcome."""
        (self.folder / "map.mesh").unlink(missing_ok=True)
        process = subprocess.run([driver] + self.arguments, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 universal_newlines=True, timeout=120)
        code, message = process.returncode, process.stderr
        if code not in (0, 1, 2, 3):
            return f"exit status {code}: {message}", "crash"
        refusal = self.refusal()
        is_refused = code == 2 and re.search("merged, but|contradict|nearly parallel|has no target", message) is not None
        if is_refused or refusal:
            is_right = refusal is None or (is_refused and refusal and re.search(refusal, message))
            return None if is_right else f"refusal: '{refusal}' is right, but not: {code} {message}", "refused"
        if code != 0:
            return None, "without a map: " + re.sub(r"[^a-zA-Z ].*", "", message.partition(": ")[2])[:50].strip()
        written = read_mesh(self.folder / "map.mesh")
        if any(orientation([written.points[v] for v in cell], range(4)) <= 0 for cell in written.cells):
            return "a cell is inverted", "map"
        for v, (p, target, lines) in self.expected([list(cell) for cell in written.cells]).items():
            image, start = written.points[v], target or p
            if any(is_plane_missed(image, start, *plane, self.size) for planes in lines for plane in planes):
                return f"vertex {v} at {image} misses its lines", "map"
            is_fixed = not lines and not self.is_sliding and (target or self.others == "stay")
            if is_fixed and image != start:
                return f"vertex {v} is at {image} instead of {start}", "map"
        return None, "map"


def main():
    driver = str(Path(sys.argv[1]).resolve())
    first, number = (int(word) for word in (sys.argv[2:4] + ["1", "2000"][len(sys.argv[2:4]):]))
    kinds, number_of_faults = Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + number):
            run = Run(seed, Path(folder))
            fault, kind = run.fault(driver)
            kinds[kind] += 1
            if fault:
                number_of_faults += 1
                print(f"seed {seed}: {' '.join(run.arguments)}: {fault.strip()}", flush=True)
    for kind, count in kinds.most_common():
        print(f"{count:6} {kind}")
    print(f"seeds {first} to {first + number - 1}: {number_of_faults} faults")
    return 1 if number_of_faults else 0


if __name__ == "__main__":
    sys.exit(main())
