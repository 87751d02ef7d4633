"""Checks hexahedra of a .mesh file in exact arithmetic on the numbers of the file."""
import itertools
from fractions import Fraction

# The positions of the vertices in the unit cube, in VTK's order.
CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
WEIGHTS = [(2, 0), (1, 1), (0, 2)]  # of both ends at 0, 1/2 and 1, times two
MAXIMAL_DEPTH = 60


def sections(filename):
    """The numbers behind each keyword of the file, in rows."""
    lines = [line.split() for line in filename.read_text().splitlines() if line.strip()]
    result, i = {}, 0
    while i < len(lines):
        keyword = lines[i][0]
        i += 1
        if keyword in ("Vertices", "Edges", "Triangles", "Quadrilaterals", "Tetrahedra", "Hexahedra"):
            number = int(lines[i][0])
            result[keyword] = lines[i + 1:i + 1 + number]
            i += 1 + number
    return result


def read_points(rows):
    return [[Fraction(float(x)) for x in row[:3]] for row in rows]


def read_cells(rows, size):
    return [[int(v) - 1 for v in row[:size]] for row in rows]


def determinant(a, b, c):
    return sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))


def jacobian(points, at):
    """64 times the determinant of the trilinear map at a point whose coordinates are 0, 1/2 and 1 for 0, 1 and 2."""
    def derivative(axis):
        result = [0, 0, 0]
        for corner, p in zip(CORNERS, points):
            weight = 1
            for k in range(3):
                weight *= (2 * corner[k] - 1) if k == axis else WEIGHTS[at[k]][corner[k]]
            result = [x + weight * y for x, y in zip(result, p)]
        return result
    return determinant(derivative(0), derivative(1), derivative(2))


def along(axis, table, function):
    """Applies a function to the three values in each row along an axis."""
    result = {}
    for i, j in itertools.product(range(3), repeat=2):
        keys = [tuple((i, j)[:axis] + (k,) + (i, j)[axis:]) for k in range(3)]
        result.update(zip(keys, function(*(table[key] for key in keys))))
    return result


def is_positive_polynomial(coefficients, depth=0):
    """Of degree 2 in each variable, over the closed unit cube: by Bernstein coefficients and halving."""
    if any(x <= 0 for key, x in coefficients.items() if 1 not in key):
        return False
    if all(x > 0 for x in coefficients.values()):
        return True
    if depth == MAXIMAL_DEPTH:
        return False
    halves = (lambda a, b, c: (4 * a, 2 * (a + b), a + 2 * b + c), lambda a, b, c: (a + 2 * b + c, 2 * (b + c), 4 * c))
    return all(is_positive_polynomial(along(depth % 3, coefficients, half), depth + 1) for half in halves)


def is_positive(points):
    """Whether the determinant is positive all over a hexahedron with integral coordinates."""
    table = {at: jacobian(points, at) for at in itertools.product(range(3), repeat=3)}
    for axis in range(3):
        table = along(axis, table, lambda a, b, c: (2 * a, 4 * b - a - c, 2 * c))
    return is_positive_polynomial(table)


def hexahedra_not_positive(filename):
    """The number of hexahedra of the file that are not positive all over."""
    of_file = sections(filename)
    points = read_points(of_file["Vertices"])
    scale = max(x.denominator for p in points for x in p)  # a power of two
    whole = [[int(x * scale) for x in p] for p in points]
    return sum(not is_positive([whole[v] for v in cell]) for cell in read_cells(of_file["Hexahedra"], 8))
