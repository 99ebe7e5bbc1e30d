# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: convert-grid-vtu.py GRID...   each with a .vtu beside it"""
import random
import sys

from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkBezierTriangle, vtkBezierWedge
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from deformation import SCALE, Deformation, random_place

TOLERANCE = 1e-12


def places(degree):
    return max(1, round((1000 if degree <= 7 else 200) * SCALE))


def load(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    errors = []
    reader.AddObserver('ErrorEvent', lambda *_: errors.append(path))
    reader.Update()
    assert not errors, path
    return reader.GetOutput()


def judge(name, rng):
    grid, mesh = Deformation(name), load(name.replace('.grid', '.vtu'))
    assert mesh.GetNumberOfCells() == len(grid.triangles), name
    assert mesh.GetNumberOfPoints() == len(grid.points) * (2 if grid.depth else 1), name
    source, worst = mesh.GetPointData().GetArray('source'), 0.0
    size = (grid.degree + 1) * (grid.degree + 2) // 2 * (2 if grid.depth else 1)
    for _ in range(places(grid.degree)):
        t, b, up = rng.randrange(len(grid.triangles)), random_place(rng), rng.random()
        cell = mesh.GetCell(t)
        assert isinstance(cell, vtkBezierWedge if grid.depth else vtkBezierTriangle), name
        assert cell.GetNumberOfPoints() == size, name
        where = [b[2], b[1]] if grid.mirrored else [b[1], b[2]]
        found, share = [0.0] * 3, [0.0] * size
        cell.EvaluateLocation(reference(0), where + [up if grid.depth else 0.0], found, share)
        origin = [sum(f * source.GetComponent(cell.GetPointId(q), c) for q, f in enumerate(share))
                  for c in range(3)]
        height = (1 - up) * grid.depth[0] + up * grid.depth[1] if grid.depth else 0.0
        for got, want in ((found, grid.image(t, b, up)),
                          (origin, grid.model(*grid.source(t, b), height))):
            worst = max([worst] + [abs(g - w) for g, w in zip(got, want)])
    worst /= grid.size()
    print(f'{name}: degree {grid.degree}, {places(grid.degree)} places, largest difference {worst:.2g}')
    return worst <= TOLERANCE


generator = random.Random(20111401)
results = [judge(name, generator) for name in sys.argv[1:]]
sys.exit(0 if results and all(results) else 1)
