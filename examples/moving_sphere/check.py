#!/usr/bin/env python3
"""Drag on the moving sphere against that on the fixed one: check.py quick|full

Reads force-MOTION-COLLISION-LINK-REFILL-AVERAGE.dat, writes results.txt: name, value, low, high (- where
there is no limit). Per cent of the drag on the fixed sphere, mean of two steps, over a window that begins
200 fluid steps after the start, when the sphere has passed 8 cells.
"""
import glob
import math
import sys

WINDOW = 200    # first fluid step after the start that counts
CELL = 25       # fluid steps in which the sphere passes one cell


def read(name):
    with open(name) as file:
        return [float(line.split()[1]) for line in file if not line.startswith("#")]


def two_steps(force):
    return [force[0]] + [0.5 * (a + b) for a, b in zip(force, force[1:])]


def rms(x):
    return math.sqrt(sum(y * y for y in x) / len(x))


def measure(moving, fixed):
    """of moving/fixed - 1 in the window, per cent: bias, rms, largest, rms of what repeats in each cell"""
    d = [100 * (m / f - 1) for m, f in zip(moving[WINDOW:], fixed[WINDOW:])]
    bias = sum(d) / len(d)
    whole = len(d) // CELL * CELL
    repeated = [sum(d[k:whole:CELL]) * CELL / whole - bias for k in range(CELL)]
    return bias, rms(d), max(abs(x) for x in d), rms(repeated)


def collect():
    """{(collision, link, refill, how): measure()}; how: no, two (steps, by us), yes (by the fix)"""
    runs = {tuple(name[6:-4].split("-")): read(name) for name in glob.glob("force-*.dat")}
    table, ringing = {}, {}
    for (motion, collision, link, refill, average), force in sorted(runs.items()):
        if motion == "fixed":
            if average == "no":
                mean = two_steps(force)
                ringing[collision, link] = measure(force, mean)[1]
            continue
        if average == "yes":
            table[collision, link, refill, "yes"] = measure(force, runs["fixed", collision, link, "grad", "yes"])
        else:
            fixed = two_steps(runs["fixed", collision, link, "grad", "no"])
            table[collision, link, refill, "no"] = measure(force, fixed)
            table[collision, link, refill, "two"] = measure(two_steps(force), fixed)
    return table, ringing


def check(mode):
    table, ringing = collect()
    results = []

    def add(name, value, low="-", high="-"):
        results.append(f"{name} {value:.4g} {low} {high}")

    for key, values in sorted(table.items()):
        for name, value in zip(("bias%", "rms%", "max%", "rms_per_cell%"), values):
            add(f"{name}_{'-'.join(key)}", value)
    for key, value in sorted(ringing.items()):
        add(f"ringing_rms%_fixed_{'-'.join(key)}", value)
    best = min((value[1], key) for key, value in table.items())[1]
    print("best:", *best)
    add("best_rms%", table[best][1], 0, 1.4)
    add("best_bias%", table[best][0], -0.25, 0.25)
    add("default_rms%", table["trt", "cli", "grad", "yes"][1], 0, 1.8)
    with open("results.txt", "w") as file:
        file.write("\n".join(results) + "\n")
    print("\n".join(results))


if __name__ == "__main__":
    check(sys.argv[1] if len(sys.argv) > 1 else "quick")
