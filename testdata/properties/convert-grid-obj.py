# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: convert-grid-obj.py NAME.grid...   each with NAME.1.obj, NAME.2.obj and NAME.5.obj"""
import collections
import math
import sys

from deformation import Deformation, weights

TOLERANCE = 1e-13


def load(path):
    """Positions, sources, and faces as corners (position, source) by group."""
    v, vt, groups, group = [], [], collections.defaultdict(list), 'sheet'
    for line in open(path, encoding='utf-8'):
        word = line.split('#')[0].split()
        if not word:
            continue
        if word[0] == 'g':
            group = word[1]
        elif word[0] == 'f':
            groups[group].append([tuple(int(x) - 1 for x in corner.split('/')) for corner in word[1:]])
        else:
            {'v': v, 'vt': vt}[word[0]].append(tuple(float(x) for x in word[1:]))
    return v, vt, groups


def judge_points(grid, steps, v, vt):
    """Largest error of source or image; each sample point must be there once, nothing else."""
    sheets, worst, seen = (2 if grid.depth else 1), 0.0, set()
    assert len(v) == sheets * len(vt)
    lattice = {}
    for t, corner in enumerate(grid.triangles):
        for w in weights(steps):
            key = tuple(sum(w[m] * grid.vertices[corner[m]][c] for m in range(3)) for c in range(2))
            lattice.setdefault(key, (t, [m / steps for m in w]))
    assert len(lattice) == len(vt) == len(set(vt)), 'points'
    by_source = {source: number for number, source in enumerate(vt)}
    step, x0, y0 = grid.lattice
    for key, (t, b) in lattice.items():
        number = by_source[x0 + step * key[0] / steps, y0 + step * key[1] / steps]
        seen.add(number)
        for sheet in range(sheets):
            image = grid.image(t, b, sheet)
            worst = max([worst] + [abs(g - w) for g, w in zip(v[sheet * len(vt) + number], image)])
    assert len(seen) == len(vt)
    return worst / grid.size()


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def judge_closed(grid, v, faces):
    """Every directed edge once, with its reverse, and the surface the right way out."""
    edges = collections.Counter((face[m - 1], face[m]) for face in faces for m in range(3))
    assert all(count == 1 and edges[b, a] == 1 for (a, b), count in edges.items()), 'not closed'
    volume = math.fsum(sum(x * y for x, y in zip(v[a], cross(v[b], v[c]))) for a, b, c in faces) / 6
    assert volume > 0, 'inside out'
    assert {corner for face in faces for corner in face} == set(range(len(v))), 'unused points'
    return volume


def judge_open(grid, v, faces):
    """Every edge in one or two faces, those turned to the eye: area along the axis of depth."""
    edges = collections.Counter((face[m - 1], face[m]) for face in faces for m in range(3))
    assert max(edges.values()) == 1
    area = math.fsum(cross([x - y for x, y in zip(v[b], v[a])],
                           [x - y for x, y in zip(v[c], v[a])])[grid.axes[2]] for a, b, c in faces)
    assert area > 0, 'turned away'
    return area


def judge(name):
    grid = Deformation(name)
    for steps in (1, 2, 5):
        v, vt, groups = load(name.replace('.grid', f'.{steps}.obj'))
        assert set(groups) == ({'bottom', 'top', 'walls'} if grid.depth else {'sheet'}), name
        corners = [corner for faces in groups.values() for face in faces for corner in face]
        assert all(a % len(vt) == b for a, b in corners), name
        faces = [[a for a, _ in face] for group in groups.values() for face in group]
        n = len(grid.triangles) * steps ** 2
        assert all(len(groups[group]) == n for group in groups if group != 'walls')
        worst = judge_points(grid, steps, v, vt)
        content = (judge_closed if grid.depth else judge_open)(grid, v, faces)
        print(f'{name}: {steps} steps, off by {worst:.2g}, content {content:.9g}')
        assert worst <= TOLERANCE, name
        if name == 'hole-1.grid':  # 8 of a square less the hole, height 2 + X/8: both parts in closed form
            assert abs(content - (8 * 2.375 + 2 * 3.5)) < 1e-12, content


assert len(sys.argv) > 1
for operand in sys.argv[1:]:
    judge(operand)
