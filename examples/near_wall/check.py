#!/usr/bin/env python3
"""python3 check.py: resistance near a wall against theory, into results.txt

A line of near_wall.dat: slides, film, links, radius and gap in cells, resistance over 6 pi mu r U.
"""
from math import acosh, log, sinh


def approach(gap):
    """Brenner, Chem. Eng. Sci. 16, 242 (1961); gap over radius"""
    a, total = acosh(1 + gap), 0.0
    for n in range(1, 10000):
        m = 2 * n + 1
        if m * a > 60:
            break
        above = 2 * sinh(m * a) + m * sinh(2 * a)
        below = 4 * sinh(0.5 * m * a)**2 - (m * sinh(a))**2
        total += n * (n + 1) / ((m - 2) * (m + 2)) * (above / below - 1)
    return 4 / 3 * sinh(a) * total


def slide(gap):
    """for thin gaps: Goldman, Cox & Brenner, Chem. Eng. Sci. 22, 637 (1967)"""
    return 0.9588 - 8 / 15 * log(gap)


def read():
    with open("near_wall.dat") as table:
        lines = [line.split() for line in table if line.strip()]
    return [(w[0] == "yes", w[1] == "yes", w[2], *map(float, w[3:])) for w in lines]


def main():
    runs = read()
    with open("results.txt", "w") as out:
        for kind in sorted({(r[2], r[3], r[1]) for r in runs if not r[0]}, key=lambda k: (not k[2], k)):
            curve = [(r[4], r[5]) for r in runs if not r[0] and (r[2], r[3], r[1]) == kind]
            for gap in (1.0, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05):
                here, value = min(curve, key=lambda p: abs(p[0] - gap))
                name = f"approach_{kind[0]}_r{kind[1]:g}_{'film' if kind[2] else 'lattice_alone'}_gap{gap:g}"
                gates = "- -"
                if kind[2] and kind[0] == "cli":    # at .5 what the lattice does hangs on its place
                    gates = "0.93 1.25" if gap == 0.5 else "0.94 1.04"
                print(name, f"{value / approach(here / kind[1]):.3f}", gates, file=out)
        for _, film, link, r, gap, value in (r for r in runs if r[0]):
            gates = "0.96 1.04" if film else "- -"
            print(f"slide_{link}_r{r:g}_{'film' if film else 'lattice_alone'}_gap{gap:g}",
                  f"{value / slide(gap / r):.3f}", gates, file=out)
    print(open("results.txt").read(), end="")


if __name__ == "__main__":
    main()
