# SPDX-License-Identifier: GPL-3.0-or-later
"""A grid file as supple-grid(5) describes it, and its map: an oracle that shares no code with lib/.

The map is the defining sum over the control points, each term in doubles, the sum by math.fsum.
Barycentric coordinates (b0, b1, b2) belong to a triangle's corners in file order."""
import functools
import math
import operator
import os
import random

SCALE = float(os.environ.get('SUPPLE_TEST_SCALE', '100')) / 100  # of the numbers of random cases


@functools.lru_cache(maxsize=None)
def weights(degree):
    """All (i, j, k) of that sum, i descending, then j descending."""
    return [(i, j, degree - i - j) for i in range(degree, -1, -1) for j in range(degree - i, -1, -1)]


@functools.lru_cache(maxsize=None)
def multinomial(w):
    n = math.factorial(sum(w))
    for m in w:
        n //= math.factorial(m)
    return n


def basis(degree, b):
    """The Bernstein polynomials in the order of weights."""
    return [multinomial(w) * b[0] ** w[0] * b[1] ** w[1] * b[2] ** w[2] for w in weights(degree)]


known_basis = functools.lru_cache(maxsize=10000)(basis)  # for a raster of samples


class Deformation:
    def __init__(self, path):
        with open(path, encoding='utf-8', errors='replace') as file:
            rows = [line.split('#')[0].split() for line in file]
        self.rows = iter([row for row in rows if row])
        self.plane, self.lattice, self.depth = 'xy', [1.0, 0.0, 0.0], None
        self.known_slopes = {}
        self.read()
        self.number()

    def read(self):
        assert next(self.rows) == ['grid', '1']
        for row in self.rows:
            key, value = row[0], row[1:]
            if key == 'degree':
                self.degree = int(value[0])
            elif key == 'plane':
                self.plane = value[0]
            elif key == 'lattice':
                self.lattice = [float(x) for x in value]
            elif key == 'depth':
                self.depth = [float(x) for x in value]
            elif key == 'end':
                break
            else:
                kind = float if key == 'points' else int
                setattr(self, key, [[kind(x) for x in next(self.rows)] for _ in range(int(value[0]))])
        axes = ['xyz'.index(letter) for letter in self.plane]
        self.axes = axes + [3 - sum(axes)]
        self.mirrored = self.axes not in ([0, 1, 2], [1, 2, 0], [2, 0, 1])

    def number(self):
        """The number of each control point: corners, then edges, then interiors."""
        d, self.of = self.degree, {}
        edges = sorted({tuple(sorted((t[m], t[m - 1]))) for t in self.triangles for m in range(3)})
        first = {edge: len(self.vertices) + n * (d - 1) for n, edge in enumerate(edges)}
        number = len(self.vertices) + len(edges) * (d - 1)
        for t, corner in enumerate(self.triangles):
            for w in weights(d):
                on = [(corner[m], w[m]) for m in range(3) if w[m] > 0]
                if len(on) == 1:
                    self.of[t, w] = on[0][0]
                elif len(on) == 2:
                    (a, _), (b, step) = sorted(on)
                    self.of[t, w] = first[a, b] + step - 1
                else:
                    self.of[t, w] = number
                    number += 1
        assert number == len(self.points)

    def world(self, vertex):
        step, x0, y0 = self.lattice
        return [x0 + step * self.vertices[vertex][0], y0 + step * self.vertices[vertex][1]]

    def source(self, t, b):
        """The place in the domain, grid's frame."""
        corner = [self.world(v) for v in self.triangles[t]]
        return [math.fsum(b[m] * corner[m][c] for m in range(3)) for c in range(2)]

    def sums(self, t, b):
        """phi, sigma0 and sigma1 at b."""
        term = [(f, self.points[self.of[t, w]]) for w, f in zip(weights(self.degree), basis(self.degree, b))]
        return [math.fsum(f * q[c] for f, q in term) for c in range(len(self.points[0]))]

    def image(self, t, b, up=0.0):
        """psi at the height `up` between bottom (0) and top (1), in model axes."""
        value = self.sums(t, b)
        z = (1 - up) * value[2] + up * value[3] if self.depth else 0.0
        return self.model(value[0], value[1], z)

    def model(self, x, y, z):
        result = [0.0] * 3
        for axis, value in zip(self.axes, (x, y, z)):
            result[axis] = value
        return result

    def slopes(self, t):
        """Differences of control points towards b1 and b2, x and y of each, as basis(degree-1) weighs them."""
        if t not in self.known_slopes:
            pairs = [(m, (w[0] + 1, w[1], w[2]), tuple(w[n] + (n == m) for n in range(3)))
                     for m in (1, 2) for w in weights(self.degree - 1)]
            self.known_slopes[t] = [[self.points[self.of[t, up]][c] - self.points[self.of[t, back]][c]
                                     for n, back, up in pairs if n == m] for m in (1, 2) for c in range(2)]
        return self.known_slopes[t]

    def determinant(self, t, b):
        """Of the derivative by (b1, b2): det grad phi times twice the triangle's area."""
        f = known_basis(self.degree - 1, b)
        x1, y1, x2, y2 = (self.degree * sum(map(operator.mul, f, slope)) for slope in self.slopes(t))
        return x1 * y2 - y1 * x2

    def size(self):
        """What errors are measured by: the largest coordinate."""
        return max(abs(x) for point in self.points for x in point)


def random_place(source=random):
    """Barycentric coordinates, uniform on the triangle."""
    r, s = source.random(), source.random()
    if r + s > 1:
        r, s = 1 - r, 1 - s
    return (1 - r - s, r, s)
