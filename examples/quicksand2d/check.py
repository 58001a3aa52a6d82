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
    """the lowest gradient that, held, lifts the bed; a hundredth less does not; what the profile says"""
    for label, other, low, high in (("0.97", name, 0.05, "-"), ("0.96", "below", "-", 0.05)):
        s = tables.series(other)
        figure(f"rise_after_12_delta_at_{label}_d", s[-1][3], low, high)
    s = tables.series(name)
    begin = tables.when(s, 3, 0.05)
    figure("begins_to_rise_at_0.97_s", begin, 0, "-")


def loosens(name, label):
    """where the bed loosens while it rises from 0.1 to 0.4 mean diameters, and what the gradient does there"""
    s = tables.series(name)
    begin, first, last = (tables.when(s, 3, rise) for rise in (0.05, 0.1, 0.4))
    if not last:
        return
    dt = s[-1][1] / s[-1][0]
    before = tables.mean_profile(name, begin - 0.03, begin - 0.005, dt)
    during = tables.mean_profile(name, first, last, dt)
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
    figure(f"loosened_zone_middle/bed_height_at_{label}", (mean(before, zone, 0) * 1e3 - FLOOR) / s[0][6], 0, 0.5)
    figure(f"loosened_zone_porosity_gain_at_{label}", mean(during, zone, 1) - mean(before, zone, 1), 0.01, "-")
    for where, part, low, high in (("in_loosened_zone", zone, "-", 1.0), ("above_it", above, 1.0, "-")):
        figure(f"gradient_{where}_before/i_c_at_{label}", mean(before, part, 4))
        figure(f"gradient_growth_{where}_at_{label}", mean(during, part, 3) / mean(before, part, 3), low, high)


if __name__ == "__main__":
    held("i090")
    fast = lifted("i110", "1.10", 1.0)
    if sys.argv[1] == "full":
        slow = lifted("i100", "1.00", 0.05)
        figure("rise_1.10/1.00", fast[29][3] / slow[29][3], 1.0, "-")
        lowest("low")
        loosens("i100", "1.00")
    with open("results.txt", "w") as file:
        file.write("\n".join(RESULTS) + "\n")
    print("\n".join(RESULTS))
