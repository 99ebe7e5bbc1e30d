# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: check-grid-msh.py NAME.grid...   each with NAME.json of check-grid and Gmsh's NAME.log"""
import json
import re
import sys

from deformation import Deformation

CUTS = 16  # samples along an edge


def samples(grid, t, area2):
    return [grid.determinant(t, (1 - (r + s) / CUTS, r / CUTS, s / CUTS)) / area2
            for r in range(CUTS + 1) for s in range(CUTS + 1 - r)]


def area2_of(grid, t):
    (x0, y0), (x1, y1), (x2, y2) = (grid.world(v) for v in grid.triangles[t])
    return (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)


def expected(low, high):
    return 'certified' if low > 0 else 'folds' if high < 0 else 'degenerate' if high == 0 else 'undecided'


def judge(path):
    name, grid = path[:-len('.grid')], Deformation(path)
    with open(name + '.json', encoding='utf-8') as file:
        report = json.load(file)
    rows, least, scale = report['det-of'], [], 0.0
    assert len(rows) == len(grid.triangles)
    for t, (number, verdict, low, high) in enumerate(rows):
        area2, tol = area2_of(grid, t), 0.001
        values = samples(grid, t, area2)
        size = max(abs(v) for v in values)
        assert number == t and verdict == expected(low, high), (name, t)
        assert low <= min(values) + 1e-12 * size, (name, t, 'a sample is below the bound')
        assert low <= high <= low + 1.001 * tol * abs(high), (name, t, 'bounds too wide')
        assert high <= min(values) + 1.001 * tol * abs(min(values)), (name, t, 'bound too high')
        least.append((low * area2, high * area2))
        scale = max(scale, size * area2)
    assert report['det-lower'] == min(row[2] for row in rows)
    assert report['det-upper'] == min(row[3] for row in rows)
    folds = any(row[1] != 'certified' for row in rows)
    assert (report['local'] == 'certified') == (not folds)
    log = open(name + '.log', encoding='utf-8').read()
    found = re.search(r'minJ +=(.*)\(min, avg, max\)', log).group(1).split(',')
    low_bound = min(low for low, _ in least)
    worst = abs(float(found[0]) - low_bound) / scale
    print(f'{name}: {report["local"]}, least {low_bound:.6g}, Gmsh {float(found[0]):.6g}')
    assert worst <= 0.012, (name, 'not what Gmsh found')
    assert (float(found[0]) > 0) == (not folds) or abs(low_bound) < 0.012 * scale, name


assert len(sys.argv) > 1
for operand in sys.argv[1:]:
    judge(operand)
