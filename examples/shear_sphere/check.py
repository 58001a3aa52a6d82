#!/usr/bin/env python3
"""python3 check.py [quick|full]: spin of a free sphere in shear, into results.txt

Reads shear_sphere.dat as in.shear_sphere writes it: r and box in cells, Re, hold, collision, link, tau,
omega/shear, torque/(4 pi mu r^3 shear).
"""
import sys
from reference import coefficient


def main(size):
    with open("shear_sphere.dat") as file:
        runs = [(float(r[0]), int(r[1]), float(r[2]), r[3], *(float(x) for x in r[7:])) for r in map(str.split, file)]
    c = coefficient()
    base = {(r, box): spin for r, box, Re, hold, spin, torque in runs if Re == 0.01 and hold == "no"}
    with open("results.txt", "w") as out:
        for r, box, Re, hold, spin, torque in runs:
            name = f"r{r:g}_box{box}_Re{Re:g}"
            if hold == "yes":
                print(f"held_torque_{name} {torque:.5f} - -", file=out)
            elif Re == 0.01:
                exact = 0.5 - c * (r / box) ** 3
                print(f"omega_over_shear_{name} {spin:.5f} - -", file=out)
                print(f"omega_error_%_{name} {100 * (spin / exact - 1):.3f} -0.5 0.5", file=out)
                print(f"torque_on_free_sphere_{name} {torque:.1e} -1e-4 1e-4", file=out)
            else:
                loss = base[r, box] - spin
                print(f"omega_lost_to_inertia_{name} {loss:.5f} - -", file=out)
                print(f"omega_lost_over_unbounded_{name} {loss / (0.0540 * Re ** 1.5):.3f} - -", file=out)
    print(open("results.txt").read(), end="")


main(sys.argv[1] if len(sys.argv) > 1 else "quick")
