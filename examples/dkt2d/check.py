#!/usr/bin/env python3
"""What the discs did against reference.dat: python3 check.py quick|full, writes results.txt

Until the discs tumble the gates are 3 % around the middle of the reference; after that the motion is
unstable, and only the order of drafting, kissing, tumbling and separation is one.
"""
import math
import sys

TOLERANCE = 0.03
R = 0.1                 # cm
CELL = 0.01             # cm: discs nearer than the article's lattice can resolve count as in contact
RUNS = {                # name: (largest Ma allowed, share of the reference allowed)
    "quick": {"coarse": (0.1, TOLERANCE), "paper": (None, TOLERANCE)},
    "full": {"dkt2d": (0.1, TOLERANCE), "fine": (0.1, TOLERANCE), "paper": (None, TOLERANCE),
             "paper-slow": (0.1, TOLERANCE)},
}


def read(name):
    """columns of NAME.dat: t, x1, y1, u1, v1, spin1, x2, y2, u2, v2, spin2, gap/2R, Ma"""
    with open(name + ".dat") as file:
        rows = [[float(x) for x in line.split()] for line in file if not line.startswith("#")]
    return list(zip(*rows))


def at(time, t, values):
    """value at a time, linear between the lines of the table"""
    k = next(k for k in range(1, len(t)) if t[k] >= time)
    s = (time - t[k - 1]) / (t[k] - t[k - 1])
    return values[k - 1] + s * (values[k] - values[k - 1])


def first(t, holds, after=0.0):
    """first time from `after` on at which holds[k]; never: nan"""
    return next((t[k] for k in range(len(t)) if t[k] >= after and holds[k]), math.nan)


def events(table):
    t, x1, y1, _, v1, s1, x2, y2, _, v2, s2, gap, ma = table
    lean = [math.degrees(math.atan2(abs(a - c), b - d)) for a, b, c, d in zip(x1, y1, x2, y2)]
    e = {"drafting_s": first(t, [a < 1.05 * b < 0.0 for a, b in zip(v1, v2)])}
    e["first_contact_s"] = first(t, [g * 2 * R < CELL for g in gap])
    e["touching_s"] = first(t, [g <= 0.0 for g in gap])
    e["tumbling_s"] = first(t, [a > 45.0 for a in lean], e["first_contact_s"])
    e["separation_s"] = first(t, [g * 2 * R > CELL for g in gap],
                              first(t, [g <= 0.0 for g in gap]))
    e["overtaking_s"] = first(t, [a > 90.0 for a in lean])
    e["lean_at_2s_deg"] = at(2.0, t, lean)
    e["peak_spin_1/s"] = max(max(map(abs, s1)), max(map(abs, s2)))
    e["overlap_cells"] = -min(gap) * 2 * R / CELL
    # then water is sucked in between them, for a sample or two
    e["largest_Ma_until_separation"] = max(m for time, m in zip(t, ma) if not time > e["separation_s"])
    e["largest_Ma"] = max(ma)
    return e


def reference():
    lines = [line.split() for line in open("reference.dat") if not line.startswith("#")]
    return [(name, time, 0.5 * (float(low) + float(high))) for name, time, low, high in lines]


def main():
    results = []
    for name, (ma_limit, share) in RUNS[sys.argv[1]].items():
        table = read(name)
        t, v = table[0], {"trailing_velocity_cm/s": table[4], "leading_velocity_cm/s": table[9]}
        e = events(table)
        for what, time, middle in reference():
            value = at(float(time), t, v[what]) if what in v else e[what]
            label = f"{name}:{what}" + (f"@{time}s" if what in v else "")
            gated = what in v or what == "first_contact_s"
            band = sorted((middle * (1 - share), middle * (1 + share)))
            results.append((label, value, *(band if gated else ("-", "-"))))
        order = [e[k] for k in ("drafting_s", "first_contact_s", "tumbling_s", "overtaking_s")]
        order_holds = all(a < b for a, b in zip(order, order[1:])) and e["separation_s"] > order[2]
        results.append((f"{name}:sequence_drafting_kissing_tumbling", float(order_holds), 1, 1))
        results.append((f"{name}:largest_Ma", e["largest_Ma"],
                        *((0, ma_limit) if ma_limit and name != "coarse" else ("-", "-"))))
        results.append((f"{name}:largest_Ma_until_separation", e["largest_Ma_until_separation"],
                        *((0, ma_limit) if ma_limit else ("-", "-"))))
        results.append((f"{name}:leading_velocity_cm/s@2.0s",
                        at(2.0, t, v["leading_velocity_cm/s"]), "-", "-"))
        for what in ("drafting_s", "touching_s", "tumbling_s", "overtaking_s", "lean_at_2s_deg",
                     "overlap_cells"):
            results.append((f"{name}:{what}", e[what], "-", "-"))
    with open("results.txt", "w") as file:
        for label, value, low, high in results:
            text = [x if isinstance(x, str) else f"{x:.5g}" for x in (value, low, high)]
            line = " ".join([label] + text)
            outside = not isinstance(low, str) and not low <= value <= high
            print(line + ("   OUTSIDE" if outside else ""))
            file.write(line + "\n")


if __name__ == "__main__":
    main()
