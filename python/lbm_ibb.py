"""Fields of fix lb/ibb as NumPy arrays, beside LAMMPS's own Python module.

    from lammps import lammps
    import lbm_ibb

    lmp = lammps()
    lmp.file("in.mine")                                # with a line "fix water all lb/ibb ..."
    u = lbm_ibb.field(lmp, "water", "velocity")        # [z, y, x, 3], in 2d [y, x, 3]
    solid = lbm_ibb.field(lmp, "water", "solid") > 0   # [z, y, x]

Needs LAMMPS as a shared library: ./run python SCRIPT builds one and runs SCRIPT with it.
"""
import ctypes

import numpy as np

NAMES = ("density", "pressure", "velocity", "solid")


def block(lmp, fix, name):
    """This rank's part of a field, a copy, and the place (x, y, z) of its first node on the lattice.

    All ranks must call it. Nodes (i, j, k) lie at the lower corner of the box plus (i + 1/2, ...) dx.
    """
    ask = lmp.lib.lbm_ibb_field
    ask.restype = ctypes.POINTER(ctypes.c_double)
    three = ctypes.c_int * 3
    lo, n, whole, columns = three(), three(), three(), ctypes.c_int()
    data = ask(lmp.lmp, fix.encode(), name.encode(), lo, n, whole, ctypes.byref(columns))
    if not data:
        message = ctypes.create_string_buffer(4096)
        lmp.lib.lammps_get_last_error_message(lmp.lmp, message, len(message))
        raise ValueError(message.value.decode().strip())
    shape = [n[2], n[1], n[0]]
    if whole[2] == 1 and lmp.extract_setting("dimension") == 2:
        shape = shape[1:]
    if columns.value:
        shape.append(columns.value)
    return np.ctypeslib.as_array(data, shape).copy(), tuple(lo)


def field(lmp, fix, name):
    """A field of the whole lattice, on one rank. On more, put the blocks together."""
    values, lo = block(lmp, fix, name)
    if lmp.extract_setting("world_size") > 1:
        raise ValueError("lbm_ibb.field is for one rank: use lbm_ibb.block, the part of each rank")
    return values


def centres(lmp, dx):
    """Coordinates x, y, z of the nodes, each a one-dimensional array."""
    lo, hi = lmp.extract_box()[:2]
    return tuple(a + dx * (np.arange(round((b - a) / dx)) + 0.5) for a, b in zip(lo, hi))
