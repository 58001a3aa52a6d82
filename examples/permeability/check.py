#!/usr/bin/env python3
"""python3 check.py [quick|full]: permeability against Carman-Kozeny and against tau, into results.txt

Reads permeability.dat as in.permeability writes it: solid fraction, cells per diameter, collision, link,
tau, k, Carman-Kozeny's k, balance of forces, drift of mass.
"""
import sys


def hoef(phi):
    """k/d^2 from the drag of van der Hoef, Beetstra & Kuipers, J. Fluid Mech. 528, 233 (2005), at Re = 0:
    F = 10 phi/(1-phi)^2 + (1-phi)^2 (1 + 1.5 phi^(1/2)) in units of 3 pi mu d U, without the pressure gradient's part"""
    total = (10 * phi / (1 - phi) ** 2 + (1 - phi) ** 2 * (1 + 1.5 * phi ** 0.5)) / (1 - phi)
    return 1 / (18 * phi * total)


def main(size):
    with open("permeability.dat") as file:
        runs = [(float(r[0]), int(r[1]), r[2] + "_" + r[3], *(float(x) for x in r[4:])) for r in map(str.split, file)]
    with open("results.txt", "w") as out:
        for phi, cells, rule, tau, k, carman, balance, drift in sorted(runs):
            if rule != "trt_cli" or tau != 1.0:
                continue
            name = f"k_phi{phi:.3f}_d{cells}"
            print(f"{name}_m2 {k:.4e} - -", file=out)
            print(f"{name}_over_Carman-Kozeny {k / carman:.4f} 0.85 1.15", file=out)
            print(f"{name}_over_van_der_Hoef {k / (hoef(phi) * 0.5e-3 ** 2):.4f} 0.85 1.15", file=out)
        densest = max(r[0] for r in runs)
        for rule in "trt_cli", "trt_bouzidi", "bgk_bouzidi":
            k = [r[4] for r in runs if r[0] == densest and r[1] == 10 and r[2] == rule]
            if not k:
                continue
            # what is left of trt and cli is the drift of mass, below; the other rules must show that this can fail
            print(f"k_range_over_tau_{rule}_% {100 * (max(k) / min(k) - 1):.3f} {'0 0.2' if rule == 'trt_cli' else '5 -'}", file=out)
        print(f"largest_force_balance {max(abs(r[6]) for r in runs if r[2] == 'trt_cli'):.1e} 0 1e-4", file=out)
        print(f"largest_mass_drift_trt_cli {max(abs(r[7]) for r in runs if r[2] == 'trt_cli'):.1e} - -", file=out)
        print(f"largest_mass_drift_bgk_bouzidi {max(abs(r[7]) for r in runs if r[2] == 'bgk_bouzidi'):.1e} - -", file=out)
    print(open("results.txt").read(), end="")


main(sys.argv[1] if len(sys.argv) > 1 else "quick")
