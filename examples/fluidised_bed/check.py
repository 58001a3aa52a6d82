#!/usr/bin/env python3
"""python3 check.py [quick|full]: velocity of the water against Richardson-Zaki, into results.txt

Reads fluidised_bed.dat as in.fluidised_bed writes it: solid fraction, beads, seed, cells per diameter,
Reynolds number of one bead, U/U_t, drift of mass.
"""
import sys
from math import log


def exponent(Re):
    """n of Garside & Al-Dibouni, Ind. Eng. Chem. Process Des. Dev. 16, 206 (1977): (5.1 - n)/(n - 2.7) = 0.1 Re^0.9"""
    s = 0.1 * Re ** 0.9
    return (5.1 + 2.7 * s) / (1 + s)


def large(phi, count, ratio):
    """U/U_t of a large bed from that of "count" beads in a periodic box, Ladd, J. Chem. Phys. 93, 3484 (1990):
    + 1.7601 S(0) (phi/N)^(1/3) mu/mu_eff; S(0) after Carnahan & Starling, mu_eff his fit"""
    S = (1 - phi) ** 4 / ((1 + 2 * phi) ** 2 + phi ** 3 * (phi - 4))
    p = phi * (1 + phi - 0.189 * phi ** 2)
    return ratio + 1.7601 * S * (phi / count) ** (1 / 3) * (1 - p) / (1 + 1.5 * p)


def main(size):
    limit = {"quick": 0.25, "full": 0.2}[size]
    with open("fluidised_bed.dat") as file:
        runs = [[float(x) for x in line.split()] for line in file]
    with open("results.txt", "w") as out:
        x, y = [], []
        for phi in sorted({r[0] for r in runs}):
            same = [r for r in runs if r[0] == phi]
            box, n = sum(r[5] for r in same) / len(same), exponent(same[0][4])
            ratio = large(phi, same[0][1], box)
            print(f"U/U_t_in_the_box_phi{phi:.3f} {box:.4f} - -", file=out)
            print(f"U/U_t_phi{phi:.3f} {ratio:.4f} - -", file=out)
            print(f"U/U_t_phi{phi:.3f}_over_(1-phi)^n {ratio / (1 - phi) ** n:.3f} {1 - limit} {1 + limit}", file=out)
            print(f"n_phi{phi:.3f} {log(ratio) / log(1 - phi):.3f} - -", file=out)
            x.append(log(1 - phi))
            y.append(log(ratio))
        slope = sum(a * b for a, b in zip(x, y)) / sum(a * a for a in x)    # through U_t at phi = 0
        print(f"n_fitted {slope:.3f} 4.4 5.6", file=out)
        print(f"n_Garside_Al-Dibouni {n:.3f} - -", file=out)
        print(f"n_Richardson-Zaki {4.35 * same[0][4] ** -0.03:.3f} - -", file=out)
        print(f"largest_mass_drift {max(abs(r[6]) for r in runs):.1e} - -", file=out)
    print(open("results.txt").read(), end="")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "quick")
