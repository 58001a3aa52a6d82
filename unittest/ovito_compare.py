#!/usr/bin/env python3
"""What unittest/ovito.sh has written, as OVITO reads it (ovito_read.py, ovito_dump.py): ovito_compare.py RANKS

What is in the series of fix lb/ibb/vtk is what is in LAMMPS's own dumps, at all times; and what OVITO would refuse is
refused, so that what is taken means something.
"""
import sys

import ovito_dump
import ovito_read
from ovito_read import Refused

FIELDS = {"density": ["f_w_density"], "pressure": ["f_w_pressure"], "solid": ["f_w_solid"],
          "velocity": ["f_w_velocity[1]", "f_w_velocity[2]", "f_w_velocity[3]"]}
# the names that OVITO gives in files and dumps
GRAINS = {"Material Type": ["Particle Type"], "velocity": ["Velocity"], "Radius": ["Radius"],
          "Angular Velocity": ["Angular Velocity"], "force": ["f_w[1]", "f_w[2]", "f_w[3]"],
          "torque": ["f_w[4]", "f_w[5]", "f_w[6]"], "Particle Identifier": ["Particle Identifier"]}


def columns(values, names):
    return [column for name in names for column in values[name]]


def near(found, wanted, what):
    """columns of numbers, the same in single precision"""
    size = max(abs(w) for column in wanted for w in column)
    if [len(column) for column in found] != [len(column) for column in wanted]:
        sys.exit(f"{what}: not as many")
    worst = max(abs(f - w) for pair in zip(found, wanted) for f, w in zip(*pair))
    if not worst <= 1e-6 * size:
        sys.exit(f"{what}: differs by {worst} of {size}")
    return size


def places_of(some, among, what):
    """which of the places along a direction these are"""
    step = among[1] - among[0]
    index = [round((x - among[0]) / step) for x in some]
    near([some], [[among[i] for i in index]], what)
    return index


def compare_fluid(path, frame, stride):
    """largest numbers of the fields"""
    places, fields = ovito_read.read_vti(path)
    cells = ovito_dump.cell_places(frame)
    index = [places_of(places[d], cells[d], f"{path}: nodes") for d in range(3)]
    if any(i != list(range(0, n, stride)) for i, n in zip(index, frame["shape"])):
        sys.exit(f"{path}: not the nodes of the dump")
    nx, ny, _ = frame["shape"]
    at = [(k * ny + j) * nx + i for k in index[2] for j in index[1] for i in index[0]]
    return [near(fields[field], [[column[a] for a in at] for column in columns(frame["values"], names)],
                 f"{path}: {field}") for field, names in FIELDS.items()]


def compare_grains(path, frame):
    found, wanted = ovito_read.read_vtp(path), frame["values"]
    order = sorted(range(len(wanted["Radius"][0])), key=lambda k: wanted["Particle Identifier"][0][k])
    for name, names in GRAINS.items():
        near(found[name], [[column[k] for k in order] for column in columns(wanted, names)], f"{path}: {name}")
    for d in range(3):    # periodic along x and y: in files they are wrapped
        lo, hi = frame["lo"][d], frame["hi"][d]
        wrapped = [wanted["Position"][d][k] for k in order]
        if d < 2:
            wrapped = [lo + (x - lo) % (hi - lo) for x in wrapped]
        near([found["Position"][d]], [wrapped], f"{path}: places")


def compare(series, dumped, compare_one, *more):
    listed = ovito_read.read_pvd(series + ".pvd")
    near([[time for time, _ in listed]], [[frame["time"] for frame in dumped]], f"{series}: times")
    return [compare_one(path, frame, *more) for (_, path), frame in zip(listed, dumped)][-1]


def refused(read, path, why):
    try:
        read(path)
    except Refused as reason:
        if why in str(reason):
            return
        sys.exit(f"{path} is refused as '{reason}', not for '{why}'")
    sys.exit(f"{path} is not refused: '{why}'")


def refused_if(read, path, changes):
    """the same file with this changed into that is refused for these words"""
    with open(path) as file:
        text = file.read()
    for old, new, why in changes:
        if old not in text:
            sys.exit(f"{path} has no '{old}'")
        with open("changed-" + path, "w") as file:
            file.write(text.replace(old, new, 1))
        refused(read, "changed-" + path, why)


def refuses():
    fluid, grains = "text-fluid-000000040.vti", "text-grains-000000040.vtp"
    for name, why in (("raw", "appended"), ("default", "")):    # zlib where LAMMPS has it
        refused(ovito_read.read_vti, name + "-fluid-000000040.vti", why)
        refused(ovito_read.read_vtp, name + "-grains-000000040.vtp", why)
    with open("default-fluid-000000040.vti", "rb") as file:
        if b"compressor" in file.readline() + file.readline():
            refused(ovito_read.read_vti, "default-fluid-000000040.vti", "compressed")
            refused(ovito_read.read_vtp, "default-grains-000000040.vtp", "compressed")
    refused(ovito_read.read_vti, "plane-fluid-000000040.vti", "dimensions [23, 0, 31]")
    both = [("LittleEndian", "BigEndian", "byte order"), ("UInt64", "UInt32", "size of data"),
            ("<VTKFile", "<!-- -->\n<VTKFile", "not known"), ("</DataArray>", "AAAA</DataArray>", "size of data"),
            ("<PointData>", "<PointData><Other/>", "element Other"), ("</Piece>", "<Other/></Piece>", "element Other"),
            ('format="binary"', "", "None data")]
    refused_if(ovito_read.read_vti, fluid, both + [
        ("Float32", "Float16", "type"), ('NumberOfComponents="3"', "", "size of data"),
        ('<Piece Extent="0 23', '<Piece Extent="0 11', "piece"),
        ('WholeExtent="0 23', 'WholeExtent="0 223', "piece"), ("Spacing", "Space", "three numbers")])
    time = "<FieldData><DataArray>1</DataArray></FieldData>"
    refused_if(ovito_read.read_vtp, grains, both + [
        ("<Piece", time + "<Piece", "not known"), ('NumberOfVerts="2"', 'NumberOfVerts="1"', "not known"),
        ('NumberOfLines="0"', 'NumberOfLines="1"', "not known"), ('"Int64"', '"Int16"', "type"),
        ('Points="2" NumberOfVerts="2"', 'Points="3" NumberOfVerts="3"', "size of data"),
        ('"points"', '"places"', "no places")])
    refused_if(ovito_read.read_pvd, "text-grains.pvd", [
        ("<DataSet", "<Other/><DataSet", "element Other"), ("000000040", "000000041", "not known"),
        ("text-", "a:text-", "address"), ("Collection", "Other", "not known")])


def main(ranks):
    cells, grains = ovito_dump.frames("sorted.grid", "grid"), ovito_dump.frames("grains.atoms", "atoms")
    largest = compare("text-fluid", cells, compare_fluid, 1)
    if not all(largest) or largest[2] != 1.0:
        sys.exit(f"nothing flows around grains: {largest}")
    compare("half-fluid", cells, compare_fluid, 2)
    compare("text-grains", grains, compare_grains)
    refuses()
    # cells that are not sorted come rank by rank, and OVITO does not look at their IDs
    plain = ovito_dump.frames("plain.grid", "grid")[-1]["values"]["f_w_solid"]
    if (plain == cells[-1]["values"]["f_w_solid"]) != (ranks == 1):
        sys.exit(f"cells of a dump that is not sorted, on {ranks} ranks, are {'not ' * (ranks == 1)}in order")
    print(f"{ranks} ranks: files are as dumps, {len(cells)} times; what OVITO would refuse is refused")


try:
    main(int(sys.argv[1]))
except Refused as reason:
    sys.exit(f"refused: {reason}")
