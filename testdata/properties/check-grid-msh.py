# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: check-grid-msh.py LOG NAME.grid...   each with NAME.json of check-grid, and Gmsh's LOG of all"""
import json
import re
import sys

from deformation import Deformation

def samples(grid, t, area2, cuts):
    return [grid.determinant(t, (1 - (r + s) / cuts, r / cuts, s / cuts)) / area2
            for r in range(cuts + 1) for s in range(cuts + 1 - r)]


def area2_of(grid, t):
    (x0, y0), (x1, y1), (x2, y2) = (grid.world(v) for v in grid.triangles[t])
    return (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)


def expected(low, high):
    return 'certified' if low > 0 else 'folds' if high < 0 else 'degenerate' if high == 0 else 'undecided'


def least_of(log):
    """What Gmsh found, by grid."""
    with open(log, encoding='utf-8') as file:
        runs = file.read().split('\ngrid ')[1:]
    return {run.split('\n')[0]: float(re.search(r'minJ +=([^,]*),', run).group(1)) for run in runs}


def judge(path, gmsh):
    name, grid = path[:-len('.grid')], Deformation(path)
    with open(name + '.json', encoding='utf-8') as file:
        report = json.load(file)
    rows, least, scale = report['det-of'], [], 0.0
    cuts = 4 if name.startswith('edited') else 12  # along an edge
    assert len(rows) == len(grid.triangles)
    for t, (number, verdict, low, high) in enumerate(rows):
        area2, tol = area2_of(grid, t), 0.001
        values = samples(grid, t, area2, cuts)
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
    low_bound = min(low for low, _ in least)
    worst = abs(gmsh - low_bound) / scale
    print(f'{name}: {report["local"]}, least {low_bound:.6g}, Gmsh {gmsh:.6g}')
    assert worst <= 0.012, (name, 'not what Gmsh found')
    assert (gmsh > 0) == (not folds) or abs(low_bound) < 0.012 * scale, name
    return folds


assert len(sys.argv) > 2
found = least_of(sys.argv[1])
folded = [judge(operand, found[operand[:-len('.grid')]]) for operand in sys.argv[2:]]
assert 10 < sum(folded) < len(folded) - 10, (sum(folded), len(folded))
print(f'{sum(folded)} of {len(folded)} fold')
