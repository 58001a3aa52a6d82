#!/usr/bin/env python3
"""python3 check.py [quick|full]: torque and force on a spinning sphere, into results.txt

Reads rotating_sphere.dat as in.rotating_sphere writes it: r and box in cells, collision, link, tau, mean of
T (1 - phi)/(8 pi mu r^3 omega) over places, spread over places, largest F/(6 pi mu r^2 omega), phi.
"""
import sys

LIMIT = {3.08: 3, 4.0: 2, 5.5: 1.5, 8.0: 1, 11.0: 1}    # per cent, by cells per radius


def main(size):
    with open("rotating_sphere.dat") as file:
        runs = [(float(r[0]), int(r[1]), r[2] + "_" + r[3], *(float(x) for x in r[4:])) for r in map(str.split, file)]
    with open("results.txt", "w") as out:
        for r, box, rule, tau, mean, spread, force, phi in runs:
            name = f"r{r:g}_box{box}_{rule}_tau{tau:g}"
            limit = LIMIT[r]
            gate = f"{-limit} {limit}" if rule == "trt_cli" else "- -"
            print(f"torque_error_%_{name} {100 * (mean - 1):.3f} {gate}", file=out)
            print(f"torque_places_%_{name} {100 * spread:.3f} - -", file=out)
            print(f"force_over_6_pi_mu_r2_omega_{name} {force:.1e} {'0 0.003' if rule == 'trt_cli' else '- -'}", file=out)
    print(open("results.txt").read(), end="")


main(sys.argv[1] if len(sys.argv) > 1 else "quick")
