#!/usr/bin/env python3
"""A stand-in for the readers that OVITO has for LAMMPS's text dumps, of grids and of atoms: see ovito_read.py."""
import re

from ovito_read import need, property_name

# particles/import/lammps/LAMMPSTextDumpImporter::generateAutomaticColumnMapping: columns with a meaning
ATOMS = {"id": ("Particle Identifier", 0), "type": ("Particle Type", 0), "radius": ("Radius", 0)}
for word, name in (("{}", "Position"), ("v{}", "Velocity"), ("omega{}", "Angular Velocity"), ("f{}", "Force"),
                   ("tq{}", "Torque")):
    ATOMS.update({word.format(axis): (name, d) for d, axis in enumerate("xyz")})


def atom_column(text):
    return ATOMS.get(text.lower()) or (property_name(text.lower()), 0)


def grid_column(text):
    """grid/io/LAMMPSGridDumpImporter: FIX:GRID:data[2] is the second column of FIX, all else a scalar FIX_NAME"""
    words = text.split(":")
    if len(words) != 3 or not words[0] or not words[2]:
        return property_name(text), 0
    vector = re.fullmatch(r"data\[([1-9]\d*)\]", words[2])
    if vector:
        return property_name(words[0]), int(vector[1]) - 1
    return property_name(words[0] + "_" + words[2]), 0


def table(columns, rows):
    """stdobj/properties/InputColumnMapping: properties, each of columns"""
    found = {}
    for (name, component), values in zip(columns, zip(*rows)):
        parts = found.setdefault(name, {})
        need(name and component not in parts, f"two columns for {name}")
        parts[component] = values
    return {name: [parts[c] for c in sorted(parts)] for name, parts in found.items()}


def frames(path, kind):
    """Snapshots of a dump of kind 'grid' or 'atoms': step, time, lo, hi, shape, values.

    grid/io/LAMMPSGridDumpImporter, particles/import/lammps/LAMMPSTextDumpImporter. Of a grid each line is the next
    cell, x fastest: IDs are not looked at.
    """
    size_mark, data_mark = {"grid": ("ITEM: GRID SIZE", "ITEM: GRID CELLS"),
                            "atoms": ("ITEM: NUMBER OF ATOMS", "ITEM: ATOMS")}[kind]
    with open(path) as file:
        lines = file.read().splitlines()
    need(lines and re.match("ITEM: (TIMESTEP|UNITS|TIME)", lines[0]), "format not known")
    need(any(line.startswith(size_mark) for line in lines[1:21]), "format not known")
    found, frame, at = [], {}, 0
    while at < len(lines):
        line = lines[at]
        at += 1
        if line.startswith("ITEM: TIMESTEP"):
            frame["step"], at = int(lines[at]), at + 1
        elif line.split()[:2] == ["ITEM:", "TIME"]:
            frame["time"], at = float(lines[at]), at + 1
        elif line.startswith("ITEM: BOX BOUNDS"):
            need(not re.match("ITEM: BOX BOUNDS (xy|abc)", line), "an oblique box: OVITO reads it, this does not")
            bounds = [[float(x) for x in bound.split()] for bound in lines[at:at + 3]]
            need(all(len(bound) == 2 for bound in bounds), f"box at line {at}")
            frame["lo"], frame["hi"] = zip(*bounds)
            at += 3
        elif line.startswith(size_mark):
            frame["shape"], at = [int(n) for n in lines[at].split()], at + 1
            need(len(frame["shape"]) == (3 if kind == "grid" else 1), f"size at line {at}")
        elif line.startswith(data_mark):
            words = line[len(data_mark):].split()
            columns = [(grid_column if kind == "grid" else atom_column)(word) for word in words]
            number = 1
            for n in frame["shape"]:
                number *= n
            rows = [[float(x) for x in row.split()] for row in lines[at:at + number]]
            need(len(rows) == number and all(len(row) >= len(columns) for row in rows), "too few lines or columns")
            at += number
            frame["values"] = table(columns, rows)
            # particles/objects/Particles::validateInputColumnMapping
            need(kind == "grid" or "Position" in frame["values"], "no places")
            found.append(frame)
            frame = {}
        else:
            need(line.startswith("ITEM:"), f"line {at}")
            while at < len(lines) and not lines[at].startswith("ITEM:"):
                at += 1
    need(found, "no snapshot")
    return found


def cell_places(frame):
    """grid/objects/VoxelGrid: values are those at the centers of cells, which fill the box"""
    return [[frame["lo"][d] + (i + 0.5) * (frame["hi"][d] - frame["lo"][d]) / frame["shape"][d]
             for i in range(frame["shape"][d])] for d in range(3)]
