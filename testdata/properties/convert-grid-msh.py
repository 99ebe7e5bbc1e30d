# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: convert-grid-msh.py LOG NAME.grid...   each with what Gmsh made of NAME.msh: NAME.copy.msh, the mesh
written again; NAME.pos, the ratio of least to largest Jacobian of each element; LOG, of one run with all."""
import re
import sys

from deformation import Deformation

TYPES = [0, 2, 9, 21, 23, 25, 42, 43, 44, 45, 46]
CUTS = 24  # samples along an edge


def section(path, name):
    lines = iter(open(path, encoding='utf-8'))
    for line in lines:
        if line.strip() == '$' + name:
            return [next(lines).split() for _ in range(int(next(lines)))]
    raise AssertionError(f'{path}: no {name}')


def order(d, ring=0):
    """Gmsh's order of nodes: vertices, edges, and the rest as a triangle of degree d-3."""
    if d < 0:
        return []
    if d == 0:
        return [(ring, ring, ring)]
    corner = [(d, 0, 0), (0, d, 0), (0, 0, d)]
    edge = [tuple((corner[m][c] * (d - s) + corner[(m + 1) % 3][c] * s) // d for c in range(3))
            for m in range(3) for s in range(1, d)]
    return [tuple(x + ring for x in w) for w in corner + edge] + order(d - 3, ring + 1)


def judge_nodes(name, grid):
    """Largest distance of a node from the image of its nominal position."""
    node = {int(row[0]): [float(x) for x in row[1:]] for row in section(name + '.copy.msh', 'Nodes')}
    elements = section(name + '.copy.msh', 'Elements')
    n, d, worst = len(grid.triangles), grid.degree, 0.0
    assert len(elements) == n * (2 if grid.depth else 1), name
    for number, row in enumerate(elements):
        row = [int(x) for x in row]
        assert row[1] == TYPES[d] and row[3] == number // n + 1, (name, row)
        for tag, w in zip(row[3 + row[2]:], order(d), strict=True):
            b = [w[0] / d, w[2] / d, w[1] / d] if grid.mirrored else [m / d for m in w]
            image = grid.image(number % n, b, number // n)
            worst = max([worst] + [abs(g - x) for g, x in zip(node[tag], image)])
    shared = len(grid.points) * (2 if grid.depth else 1)
    assert len(node) == shared, f'{name}: {len(node)} nodes, {shared} nominal positions'
    return worst / grid.size()


def jacobian_range(grid, t):
    value = [grid.determinant(t, (1 - (r + s) / CUTS, r / CUTS, s / CUTS))
             for r in range(CUTS + 1) for s in range(CUTS + 1 - r)]
    return min(value), max(value)


def judge_jacobians(name, grid, log):
    """Largest difference from Gmsh's bounds, which lie outside the true ones by 1 % at most. They
    are Jacobians relative to the unit triangle: twice the domain triangle's area times det grad."""
    view = re.findall(r'ST\(.*?\)\{(.*?),', open(name + '.pos', encoding='utf-8').read())
    ranges = [jacobian_range(grid, t) for t in range(len(grid.triangles))]
    worst = max(abs(float(ratio) - low / high)
                for ratio, (low, high) in zip(view, ranges, strict=True))
    found = re.search(r'minJ +=(.*)\(min, avg, max\)', log).group(1).split(',')
    lows = [low for low, _ in ranges]
    for got, want in zip(found, (min(lows), sum(lows) / len(lows), max(lows)), strict=True):
        worst = max(worst, abs(float(got) - want) / max(high for _, high in ranges))
    return worst


def judge(path, log):
    name, grid = path[:-len('.grid')], Deformation(path)
    assert 'Error' not in log, name
    nodes = judge_nodes(name, grid)
    text, good = f'{path}: degree {grid.degree}, nodes off by {nodes:.2g}', nodes <= 1e-12
    if not grid.depth and grid.plane == 'xy':
        jacobians = judge_jacobians(name, grid, log)
        text += f', Jacobians by {jacobians:.2g}'
        good = good and jacobians <= 0.011  # 1 % of Gmsh, and what lies between the samples
    print(text)
    return good


with open(sys.argv[1], encoding='utf-8') as file:
    logs = dict(run.split('\n', 1) for run in file.read().split('\ngrid ')[1:])
results = [judge(path, logs[path[:-len('.grid')]]) for path in sys.argv[2:]]
sys.exit(0 if results and all(results) else 1)
