#!/usr/bin/env python3
"""Reads what fix lb/ibb/vtk has written with VTK's own readers: vtk_read.py lists|compare NAME...

lists     every file in the lists NAME.pvd can be read, and is of the time that the list says
compare   the series NAME... show, in their last files, what LAMMPS's own dumps show
"""
import os
import re
import sys
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def read(path):
    """(data set, arrays at its points, time)"""
    vti = path.endswith("vti")
    reader = vtk.vtkXMLImageDataReader() if vti else vtk.vtkXMLPolyDataReader()
    failed = []
    reader.AddObserver("ErrorEvent", lambda *_: failed.append(path))
    reader.SetFileName(path)
    reader.Update()
    if failed:
        sys.exit(f"VTK cannot read {path}")
    data = reader.GetOutput()
    points = data.GetPointData()
    arrays = {points.GetArrayName(k): vtk_to_numpy(points.GetArray(k))
              for k in range(points.GetNumberOfArrays())}
    return data, arrays, data.GetFieldData().GetArray("TimeValue").GetValue(0)


def entries(name):
    with open(name + ".pvd") as file:
        found = re.findall(r'timestep="(.*?)".*?file="(.*?)"', file.read())
    return [(float(time), os.path.join(os.path.dirname(name), path)) for time, path in found]


def check_list(name):
    times = [time for time, _ in entries(name)]
    if not times or times != sorted(set(times)):
        sys.exit(f"{name}.pvd: times {times}")
    for time, path in entries(name):
        data, arrays, own = read(path)
        if abs(own - time) > 1e-9 * max(times):
            sys.exit(f"{path}: time {own}, not {time} as listed")
        if not arrays or data.GetNumberOfPoints() == 0:
            sys.exit(f"{path} is empty")
    print(f"{name}: {len(times)} files")


def table(path, mark):
    """rows of numbers after the last line that starts so"""
    with open(path) as file:
        lines = file.read().splitlines()
    at = max(k for k, line in enumerate(lines) if line.startswith(mark))
    return np.array([[float(x) for x in line.split()] for line in lines[at + 1:]])


def near(found, wanted, what):
    wanted = np.asarray(wanted).reshape(found.shape)
    worst = np.abs(found - wanted).max()
    if not worst <= 1e-6 * np.abs(wanted).max():
        sys.exit(f"{what}: differs by {worst} of {np.abs(wanted).max()}")


def compare(name):
    """cells.dump: id, density, pressure, velocity, solid; grains.dump: id, x, r, v, omega, f, t"""
    cells = table("cells.dump", "ITEM: GRID CELLS")
    cells = cells[np.argsort(cells[:, 0])]
    image, fields, _ = read(entries(name + "-fluid")[-1][1])
    n, step = image.GetDimensions(), image.GetSpacing()[0] / 1e-4
    stride = int(round(step))
    grid = cells.reshape(32, 20, 24, -1)[::stride, ::stride, ::stride]
    if grid.shape[2::-1] != tuple(n):
        sys.exit(f"{name}: {n} nodes, not {grid.shape}")
    for columns, field in ((slice(1, 2), "density"), (slice(2, 3), "pressure"),
                           (slice(3, 6), "velocity"), (slice(6, 7), "solid")):
        near(fields[field], grid[..., columns], f"{name}: {field}")
    if not np.allclose(image.GetOrigin(), 0.5e-4):
        sys.exit(f"{name}: origin {image.GetOrigin()}")

    grains = table("grains.dump", "ITEM: ATOMS")
    grains = grains[np.argsort(grains[:, 0])]
    points, arrays, _ = read(entries(name + "-grains")[-1][1])
    near(vtk_to_numpy(points.GetPoints().GetData()), grains[:, 1:4], f"{name}: places")
    if points.GetNumberOfVerts() != len(grains):
        sys.exit(f"{name}: {points.GetNumberOfVerts()} vertices")
    for columns, array in ((slice(0, 1), "id"), (slice(4, 5), "radius"), (slice(5, 8), "velocity"),
                           (slice(8, 11), "omega"), (slice(11, 14), "force"),
                           (slice(14, 17), "torque")):
        near(arrays[array], grains[:, columns], f"{name}: {array}")
    print(f"{name}: as dumped")


for series in sys.argv[2:]:
    {"lists": check_list, "compare": compare}[sys.argv[1]](series)
