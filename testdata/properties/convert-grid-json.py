# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: convert-grid-json.py NAME.grid...   each with NAME.json"""
import json
import sys

from deformation import Deformation, weights


def grid_text(data):
    """The grid file of parsed JSON whose numbers are still text."""
    assert data['format'] == 'supple-grid' and data['version'] == '1'
    lines = ['grid 1'] + ['# ' + line for line in data['history'][:-1]] + ['degree ' + data['degree']]
    if data['plane'] != 'xy':
        lines.append('plane ' + data['plane'])
    lattice = [data['lattice']['step']] + data['lattice']['origin']
    if lattice != ['1', '0', '0']:
        lines.append('lattice ' + ' '.join(lattice))
    if 'depth' in data:
        lines.append('depth ' + ' '.join(data['depth']))
    points = data['points']
    if 'heights' in data:
        points = [xy + z for xy, z in zip(points, data['heights'], strict=True)]
    for name, rows in (('vertices', data['vertices']), ('triangles', data['triangles']), ('points', points)):
        lines += [f'{name} {len(rows)}'] + [' '.join(row) for row in rows]
    return '\n'.join(lines + ['end', ''])


def judge(name):
    with open(name.replace('.grid', '.json'), encoding='utf-8') as file:
        data = json.load(file, parse_int=str, parse_float=str)
    if not name.startswith('hostile'):  # its history is no UTF-8
        with open(name, encoding='utf-8') as file:
            assert grid_text(data) == file.read(), name
    assert data['history'][-1] == 'convert-grid --to json ' + name, name
    grid, d = Deformation(name), int(data['degree'])
    for t, patch in enumerate(data['patches']):
        assert [int(p) for p in patch] == [grid.of[t, w] for w in weights(d)], (name, t)
        for p, w in zip(patch, weights(d)):
            nominal = [float(x) for x in data['nominal'][int(p)]]
            source = grid.source(t, [m / d for m in w])
            assert max(abs(a - b) for a, b in zip(nominal, source)) < 1e-14 * grid.size(), (name, p)
    assert len(data['patches']) == len(grid.triangles) and len(data['nominal']) == len(grid.points)


assert len(sys.argv) > 1
for operand in sys.argv[1:]:
    judge(operand)
print(f'{len(sys.argv) - 1} grids')
