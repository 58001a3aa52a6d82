#!/usr/bin/env python3
"""check.py quick|full: reads what figure.sh's runs wrote, writes results.txt, one figure a line:
name value low high."""
import os
import sys
import tables

FLOOR, LID, DELTA, LAYER = 0.288, 16.992, 0.065, 0.576    # mm, s
RESULTS = []


def figure(name, value, low="-", high="-"):
    value = "none" if value is None else f"{value:.6g}"
    RESULTS.append(f"{name} {value} {low} {high}")


def held(name):
    """0.9 i_c: the balance of forces, and stillness"""
    balance = tables.log_line("log." + name, r"quicksand2d balance at i/ic = .*sum F_y/\(dp S\) = ([-0-9.e]+),")
    full = sys.argv[1] == "full"
    figure("sumF/dpS-1_at_0.90", float(balance[0]) - 1.0, *((-2e-4, 2e-4) if full else (-1e-3, 1e-3)))
    s = tables.series(name)
    # the loose bed of the coarse lattice first settles, with contacts that have no static friction
    figure("path_at_0.90_d", s[-1][4], 0, 0.02 if full else 0.1)
    figure("path_in_last_delta_at_0.90_d", s[-1][4] - s[-11][4], 0, 0.02)
    figure("rise_at_0.90_d", s[-1][3], -0.02, 0.01)
    figure("permeability_m2", sum(r[9] for r in s[-10:]) / 10)
    p = tables.mean_profile(name, s[-1][1] - 0.06, s[-1][1], s[-1][1] / s[-1][0])
    water = [r[5] for r in p if r[1] > 0.999]    # above the bed
    # what of the water that enters arrives: its density falls by 2.2 %
    figure("flux_out/in_at_0.90", sum(water) / len(water) / p[0][5], 0.97, 1.05)


def lifted(name, label, least):
    s = tables.series(name)
    begin = tables.when(s, 3, 0.05)
    figure(f"rise_after_3_delta_at_{label}_d", next(r[3] for r in s if r[1] > 2.9 * DELTA), least, "-")
    figure(f"begins_to_rise_at_{label}_s", begin, 0, "-")
    reached = tables.when(s, 10, LID - 0.05)
    if reached:
        figure(f"top_reaches_lid_at_{label}_delta", reached / DELTA)
    return s


def lowest(name):
    """the gradient that lifts the bed when it grows slowly, and what the profile says then"""
    found = tables.log_line("log." + name, r"quicksand2d onset i/ic = ([0-9.]+) at ([0-9.]+) s")
    figure("onset_i/ic", float(found[0]) if found else None, 0.9, 1.01)
    if not found:
        return
    s = tables.series(name)
    dt = s[-1][1] / s[-1][0]
    before = tables.mean_profile(name, 0.08, 0.14, dt)
    going = tables.when(s, 3, 0.6) or s[-1][1] - 0.02    # the bed has begun to go
    during = tables.mean_profile(name, going - 0.02, going + 0.02, dt)
    # the loosened zone: layers around the one that has gained most, with half of its gain at least;
    # the layer at the floor and those at the top of the bed are not full
    bed = [k for k, r in enumerate(before) if r[1] < 0.5][:-2]
    gain = {k: during[k][1] - before[k][1] for k in bed}
    lo = hi = max(bed, key=gain.get)
    while gain.get(lo - 1, 0.0) > 0.5 * gain[lo]:
        lo -= 1
    while gain.get(hi + 1, 0.0) > 0.5 * gain[hi]:
        hi += 1
    zone = range(lo, hi + 1)
    above = [k for k in range(hi + 1, hi + 4) if k in bed]

    def mean(rows, part, column):
        return sum(rows[k][column] for k in part) / len(part)
    figure("loosened_zone_middle/bed_height", (mean(before, zone, 0) * 1e3 - FLOOR) / s[0][6], 0, 0.5)
    figure("loosened_zone_porosity_gain", mean(during, zone, 1) - mean(before, zone, 1), 0.01, "-")
    for label, part, low, high in (("in_loosened_zone", zone, "-", 1.0), ("above_it", above, 1.0, "-")):
        figure(f"gradient_{label}_before/i_c", mean(before, part, 4))
        figure(f"gradient_growth_{label}", mean(during, part, 3) / mean(before, part, 3), low, high)


if __name__ == "__main__":
    held("i090")
    fast = lifted("i110", "1.10", 1.0)
    if sys.argv[1] == "full":
        slow = lifted("i100", "1.00", 0.05)
        figure("rise_1.10/1.00", fast[29][3] / slow[29][3], 1.0, "-")
        lowest("low")
    with open("results.txt", "w") as file:
        file.write("\n".join(RESULTS) + "\n")
    print("\n".join(RESULTS))
