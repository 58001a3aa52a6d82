#!/usr/bin/env python3
"""python3 check.py [quick|full]: highest speed of the sphere against the experiment, into results.txt

Reads settling-CASE-CELLS.dat as in.settling_sphere writes them, reference.dat and measured_E3.dat.
"""
import sys

# Steady speed of E1 without inertia, on the axis of a square duct of half-width l: Happel & Brenner 1965,
# drag 6 pi mu a u/(1 - 1.9033 a/l + ...); the next term as in a round tube, 2.09 (a/l)^3
STOKES_E1 = 150 * 9.81 * 0.015**2 / (18 * 0.373) * (1 - 1.9033 * 0.15 + 2.09 * 0.15**3)


def columns(name):
    """rows of a table of blank-separated columns, comments left out"""
    with open(name) as file:
        return [line.split() for line in file if line.strip() and not line.startswith("#")]


def main(size):
    cells, limit = {"quick": (9, 0.05), "full": (15, 0.02)}[size]
    with open("results.txt", "w") as out:
        for row in columns("reference.dat"):
            case, measured = row[0], float(row[5])
            if size == "quick" and case != "E4":
                continue
            run = [[float(x) for x in r] for r in columns(f"settling-{case}-{cells}.dat")]
            u = -min(r[2] for r in run)
            low, high = measured * (1 - limit), measured * (1 + limit)
            if case == "E1":                       # more than even Stokes' drag lets it have was measured
                low, high = 0.96 * STOKES_E1, STOKES_E1
            print(f"u_max_{case}_m/s {u:.5f} {low:.5f} {high:.5f}", file=out)
            print(f"u_max_{case}_deviation_% {100 * (u / measured - 1):.2f} - -", file=out)
            if case != "E3":
                continue
            print(f"landed_E3_s {run[-1][0]:.3f} - -", file=out)
            for time, v in ((float(a), float(b)) for a, b in columns("measured_E3.dat")):
                if time > run[-1][0]:              # landed before
                    continue
                after = next(i for i in range(1, len(run)) if run[i][0] >= time)
                (t0, _, v0), (t1, _, v1) = run[after - 1], run[after]
                ours = v0 + (v1 - v0) * (time - t0) / (t1 - t0)
                print(f"v_E3_at_{time:.2f}s_m/s {ours:.4f} - -", file=out)
                print(f"v_E3_at_{time:.2f}s_minus_measured_mm/s {1000 * (ours - v):.2f} - -", file=out)
    print(open("results.txt").read(), end="")


main(sys.argv[1] if len(sys.argv) > 1 else "quick")
