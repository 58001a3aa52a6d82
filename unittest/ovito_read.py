#!/usr/bin/env python3
"""A stand-in for the readers of OVITO, where OVITO itself cannot be had: it takes a file only if their rules take it.

The rules are those of the sources of OVITO 3.16.1 (14 September 2026); each is given with its file below src/ovito.
The readers are driven by Qt's QXmlStreamReader, whose steps Xml has, and stop where OVITO stops. Properties have the
names that OVITO gives them. Where a rule of OVITO reads nonsense as 0, this refuses.
"""
import array
import base64
import os
import re
from xml.etree import ElementTree


class Refused(Exception):
    """why OVITO would not read it, or would show nothing"""


def need(condition, why):
    if not condition:
        raise Refused(why)


class Xml:
    """Elements one after the other. Fed by lines: what is behind the place that was reached is not looked at."""

    def __init__(self, path):
        self.events = self.all_events(path)

    @staticmethod
    def all_events(path):
        parser = ElementTree.XMLPullParser(("start", "end", "comment", "pi"))
        try:
            with open(path, "rb") as file:
                for line in file:
                    parser.feed(line)
                    yield from parser.read_events()
        except ElementTree.ParseError as error:
            raise Refused(f"XML: {error}") from error

    def start(self):
        """the next element that starts in the present one; None at the end of that, which is then left"""
        for kind, element in self.events:
            if kind in ("start", "end"):
                return element if kind == "start" else None
        return None

    def leave(self, element):
        """goes to the end of an element that has started; its text"""
        for kind, other in self.events:
            if kind == "end" and other is element:
                break
        return element.text or ""

    def first(self, kind):
        """mesh/io, grid/io, particles/import/vtk: nothing comes before VTKFile, which is of this type"""
        event, element = next(self.events, ("", None))
        return event == "start" and element.tag == "VTKFile" and element.get("type") == kind


def count(element, name):
    digits = element.get(name, "")
    need(digits.isdigit(), f"{name}='{digits}'")
    return int(digits)


def recognised(path):
    """core/dataset/io/FileImporter: the first reader whose checkFileFormat agrees; None: the format is not known"""
    if Xml(path).first("Collection"):
        return "pvd"    # mesh/io/ParaViewPVDImporter
    xml = Xml(path)
    if xml.first("ImageData"):    # grid/io/ParaViewVTIGridImporter
        while (element := xml.start()) is not None:
            if element.tag == "ImageData":
                return "vti"
    xml = Xml(path)
    if xml.first("PolyData"):
        # particles/import/vtk/ParaViewVTPParticleImporter: it steps into all that is before Piece, and so does not come
        # out of FieldData; mesh/io/ParaViewVTPMeshImporter skips that, but wants strips or polygons
        while (element := xml.start()) is not None:
            if element.tag == "Piece":
                lone = all(count(element, "NumberOf" + name) == 0 for name in ("Lines", "Strips", "Polys"))
                return "vtp" if lone and element.get("NumberOfPoints") == element.get("NumberOfVerts") else None
    return None


# mesh/io/ParaViewVTPMeshImporter::parseVTKDataArray: types that it knows; what it writes to is of doubles or integers
TYPES = {"Float32": "f", "Float64": "d", "Int32": "i", "UInt32": "I", "Int64": "q", "UInt64": "q"}


def header_bytes(element, kind):
    """grid/io/ParaViewVTIGridImporter, particles/import/vtk/ParaViewVTPParticleImporter: VTKFile"""
    need(element.get("type") == kind, f"not of type {kind}")
    need(element.get("byte_order") == "LittleEndian", "byte order")
    need(not element.get("compressor"), "compressed data")
    return 4 if element.get("header_type") == "UInt32" else 8


def data_array(xml, element, header, tuples):
    """mesh/io/ParaViewVTPMeshImporter::parseVTKDataArray: columns of numbers"""
    columns = max(1, int(element.get("NumberOfComponents", "0")))
    form = element.get("format")
    need(form in ("binary", "ascii"), f"{form} data")
    need(element.get("type") in TYPES, f"data of type {element.get('type')}")
    text = xml.leave(element)
    values = array.array(TYPES[element.get("type")])
    if form == "ascii":
        values.extend(map(float if values.typecode in "fd" else int, text.split()))
    else:
        # QByteArray::fromBase64 passes over all that is no digit, also at the end
        digits = re.sub("[^A-Za-z0-9+/]", "", text)
        digits = digits[:len(digits) // 4 * 4 + (0, 0, 2, 3)[len(digits) % 4]]
        data = base64.b64decode(digits + "=" * (-len(digits) % 4))
        need(int.from_bytes(data[:header], "little") + header == len(data), "size of data: not as its header says")
        need((len(data) - header) % (values.itemsize * columns) == 0, "size of data: not of tuples")
        values.frombytes(data[header:])
    need(len(values) == tuples * columns, f"size of data: {len(values)} values, not {tuples} tuples of {columns}")
    return [values[c::columns] for c in range(columns)]


def property_name(name):
    """stdobj/properties/Property::makePropertyNameValid"""
    return re.sub("[./:]", "_", name.strip()).rstrip("_")


def extent(element, name):
    """lengths along x, y and z"""
    words = element.get(name, "").split()
    need(len(words) == 6 and all(w.isdigit() for w in words), f"{name} must be six numbers from 0 on")
    return [int(words[2 * d + 1]) - int(words[2 * d]) for d in range(3)]


def vector(element, name):
    """needed: without Spacing a grid has no place (grid/objects/VoxelGrid::verifyIntegrity)"""
    words = element.get(name, "").split()
    need(len(words) == 3, f"{name} must be three numbers")
    return [float(w) for w in words]


def read_vti(path):
    """grid/io/ParaViewVTIGridImporter: where its nodes are along x, y and z, and fields of columns, x fastest"""
    xml, header, shape, kind, places, fields = Xml(path), 8, None, None, None, {}
    need(recognised(path) == "vti", "format not known")
    while (element := xml.start()) is not None:
        if element.tag == "VTKFile":
            header = header_bytes(element, "ImageData")
        elif element.tag == "ImageData":
            shape = extent(element, "WholeExtent")
            need(all(0 < n <= 100000 for n in shape), f"dimensions {shape}: cells along a direction, 1 to 100000")
            step, origin = vector(element, "Spacing"), vector(element, "Origin")
        elif element.tag == "Piece":
            need(not element.get("Extent") or extent(element, "Extent") == shape, "not of a single piece")
        elif element.tag in ("PointData", "CellData"):
            block = element.tag
            while (element := xml.start()) is not None:
                need(element.tag == "DataArray", f"element {element.tag}")
                need(kind in (None, block), "data of points and of cells")
                kind, at_points = block, block == "PointData"
                nodes = [n + at_points for n in shape]
                places = [[origin[d] + (i + (0.0 if at_points else 0.5)) * step[d] for i in range(nodes[d])]
                          for d in range(3)]
                name = property_name(element.get("Name", ""))
                fields[name] = data_array(xml, element, header, nodes[0] * nodes[1] * nodes[2])
        else:
            need(element.tag == "FieldData", f"element {element.tag}")
            xml.leave(element)
    need(fields, "no data")
    return places, fields


# particles/import/vtk/ParaViewVTPParticleImporter::createPropertyForDataArray: what it knows of what we write
VTP_NAMES = {("points", 3): "Position", ("id", 1): "Particle Identifier", ("type", 1): "Material Type",
             ("radius", 1): "Radius", ("omega", 3): "Angular Velocity"}


def read_vtp(path):
    """particles/import/vtk/ParaViewVTPParticleImporter: properties, each of columns"""
    xml, header, points, found = Xml(path), 8, 0, {}
    need(recognised(path) == "vtp", "format not known")
    while (element := xml.start()) is not None:
        if element.tag == "VTKFile":
            header = header_bytes(element, "PolyData")
        elif element.tag == "Piece":
            points = count(element, "NumberOfPoints")    # recognised: as many vertices, and nothing else
        elif element.tag in ("PointData", "Points", "Verts"):
            while (element := xml.start()) is not None:
                need(element.tag == "DataArray", f"element {element.tag}")
                name = element.get("Name", "").lower()
                if name in ("connectivity", "offsets"):
                    xml.leave(element)
                    continue
                columns = max(1, int(element.get("NumberOfComponents", "0")))
                name = VTP_NAMES.get((name, columns)) or property_name(element.get("Name", ""))
                found[name] = data_array(xml, element, header, points)
        elif element.tag != "PolyData":
            need(element.tag in ("FieldData", "CellData", "Lines", "Strips", "Polys"), f"element {element.tag}")
            xml.leave(element)
    need("Position" in found, "no places")
    return found


def read_pvd(path):
    """mesh/io/ParaViewPVDImporter: times and files; one that is not recognised leaves the picture as it was"""
    xml, found = Xml(path), []
    need(recognised(path) == "pvd", "format not known")
    while (element := xml.start()) is not None:
        if element.tag == "DataSet":
            name = element.get("file", "")
            need(name and not set(name) & set(":?#%"), f"file '{name}' is no plain part of an address (QUrl)")
            name = os.path.join(os.path.dirname(path), name)
            need(os.path.exists(name) and recognised(name), f"format of {name} not known")
            found.append((float(element.get("timestep", "0")), name))
            xml.leave(element)
        else:
            need(element.tag in ("VTKFile", "Collection"), f"element {element.tag}")
    return found
