#!/usr/bin/env python3
"""python3 check.py [quick|full]: spin of a free sphere in shear, into results.txt

Reads shear_sphere.dat as in.shear_sphere writes it: r and box in cells, Re, hold, collision, link, tau,
omega/shear, torque/(4 pi mu r^3 shear), shift on the lattice.
"""
import sys
from reference import coefficient


def main(size):
    with open("shear_sphere.dat") as file:
        runs = [(float(r[0]), int(r[1]), float(r[2]), r[3], *(float(x) for x in r[7:])) for r in map(str.split, file)]
    c = coefficient()
    with open("results.txt", "w") as out:
        for case in dict.fromkeys(run[:4] for run in runs):
            r, box, Re, hold = case
            spin, torque, shift = zip(*(run[4:] for run in runs if run[:4] == case))
            mean = sum(spin) / len(spin)
            name = f"r{r:g}_box{box}_Re{Re:g}"
            if hold == "yes":
                print(f"held_torque_{name} {sum(torque) / len(torque):.5f} - -", file=out)
            elif Re == 0.01:
                limit = (4 / r) ** 2               # per cent: 1 at 8 cells per diameter, second order
                exact = 0.5 - c * (r / box) ** 3
                print(f"omega_over_shear_{name} {mean:.5f} - -", file=out)
                print(f"omega_error_%_{name} {100 * (mean / exact - 1):.3f} {-limit:.2f} {limit:.2f}", file=out)
                print(f"omega_places_%_{name} {50 * (max(spin) - min(spin)) / exact:.3f} - -", file=out)
                print(f"torque_on_free_sphere_{name} {max(map(abs, torque)):.1e} 0 1e-4", file=out)
            else:
                base = next(run[4] for run in runs if run[:4] == (r, box, 0.01, "no") and run[6] == shift[0])
                print(f"omega_lost_to_inertia_{name} {base - mean:.5f} - -", file=out)
                print(f"omega_lost_over_unbounded_{name} {(base - mean) / (0.0540 * Re ** 1.5):.3f} - -", file=out)
    print(open("results.txt").read(), end="")


main(sys.argv[1] if len(sys.argv) > 1 else "quick")
