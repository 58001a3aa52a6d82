#!/usr/bin/env python3
"""python3 check.py [quick|full]: the benchmark of Schaefer & Turek (1996), into results.txt

2D-1: drag, lift, pressure difference between front and back of the cylinder against the values of John & Matthies,
Int. J. Numer. Meth. Fluids 37, 885 (2001); 2D-2: largest drag and lift and the Strouhal number against the intervals
of Schaefer & Turek.
"""
import pathlib
import sys

C_D, C_L, DP = 5.57953523384, 0.010618948146, 0.11752016697
LIMIT = {10: (2, 10, 5), 20: (0.7, 3, 2), 40: (0.25, 1.5, 1)}    # per cent, of drag, lift and pressure, by cells per diameter


def read_grid(name):
    """x and y of the nodes, and columns by name, of the last snapshot of a grid dump"""
    lines = pathlib.Path(name).read_text().split("ITEM: ")[1:]
    part = {}
    for section in lines:
        head, _, body = section.partition("\n")
        part[head.split()[0] + head.split()[1] if len(head.split()) > 1 else head] = (head, body)
    box = [[float(x) for x in row.split()] for row in part["BOXBOUNDS"][1].splitlines()]
    size = [int(x) for x in part["GRIDSIZE"][1].split()]
    words, body = part["GRIDCELLS"]
    rows = [[float(x) for x in row.split()] for row in body.splitlines()]
    dx = (box[0][1] - box[0][0]) / size[0]
    x = [box[0][0] + (i + 0.5) * dx for i in range(size[0])]
    y = [box[1][0] + (j + 0.5) * dx for j in range(size[1])]
    names = words.split()[2:]
    columns = {n.split(":")[-1]: [r[k] for r in rows] for k, n in enumerate(names)}
    return x, y, columns


def pressure_at_surface(name, side):
    """on the line y = 0.2 at the cylinder, from the two rows of nodes next to it and three fluid nodes outwards"""
    x, y, field = read_grid(name)
    p, solid = field["pressure"], field["solid"]
    j = max(k for k in range(len(y)) if y[k] <= 0.2)
    w = (0.2 - y[j]) / (y[j + 1] - y[j])

    def value(i):
        return (1 - w) * p[i + len(x) * j] + w * p[i + len(x) * (j + 1)]

    at = 0.2 + 0.05 * side
    free = [i for i in range(len(x)) if (x[i] - at) * side > 0 and not solid[i + len(x) * j] and not solid[i + len(x) * (j + 1)]]
    near = sorted(free, key=lambda i: abs(x[i] - at))[:3]
    total = 0.0
    for a in near:    # Lagrange
        part = value(a)
        for b in near:
            if b != a:
                part *= (at - x[b]) / (x[a] - x[b])
        total += part
    return total


def steady(name, cells, out, gated):
    words = pathlib.Path(f"{name}.dat").read_text().split()
    found = float(words[4]), float(words[5]), pressure_at_surface(f"{name}.grid", -1) - pressure_at_surface(f"{name}.grid", 1)
    for what, value, exact, limit in zip(("c_D", "c_L", "dp"), found, (C_D, C_L, DP), LIMIT[cells]):
        error = 100 * (value / exact - 1)
        print(f"{what}_{name} {value:.6f} - -", file=out)
        print(f"{what}_error_%_{name} {error:.3f} {f'{-limit} {limit}' if gated else '- -'}", file=out)
    return 100 * (found[0] / C_D - 1)


def street(name, out):
    rows = [[float(x) for x in row.split()] for row in pathlib.Path(f"{name}.series").read_text().splitlines() if row.strip()]
    rows = [r for r in rows if r[0] > rows[-1][0] - 1.5]
    drag, lift = max(r[1] for r in rows), max(r[2] for r in rows)
    ups = [a[0] - a[2] * (b[0] - a[0]) / (b[2] - a[2]) for a, b in zip(rows, rows[1:]) if a[2] < 0 <= b[2]]
    period = (ups[-1] - ups[0]) / (len(ups) - 1)
    for what, value, low, high in (("c_D_max", drag, 3.22, 3.24), ("c_L_max", lift, 0.99, 1.01), ("Strouhal", 0.1 / period, 0.295, 0.305)):
        slack = 0.0 if what == "Strouhal" else 0.05    # of 20 cells per diameter and Ma = 0.19
        print(f"{what}_{name} {value:.4f} {low * (1 - slack):.4f} {high * (1 + slack):.4f}", file=out)


def main(size):
    with open("results.txt", "w") as out:
        errors = [steady(f"steady{cells}", cells, out, True) for cells in ((10, 20, 40) if size == "full" else (10, 20))]
        # errors of second order: a quarter with twice the cells; a third at least
        for cells, coarse, fine in zip((20, 40), errors, errors[1:]):
            print(f"c_D_error_ratio_{cells} {fine / coarse:.3f} -0.6 0.6", file=out)
        rough = steady("staircase20", 20, out, False)
        print(f"c_D_error_staircase_over_fractions {abs(rough / errors[1]):.1f} 2 -", file=out)
        street("street20", out)
    print(open("results.txt").read(), end="")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "quick")
