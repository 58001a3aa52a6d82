#!/usr/bin/env python3
"""python3 check.py [quick|full]: drag of periodic arrays against the reference, into results.txt

Reads periodic_arrays.dat as in.periodic_arrays writes it, and reference.dat.
"""
import sys


def rows(name):
    with open(name) as file:
        return [line.split() for line in file if line.strip() and not line.startswith("#")]


def main(size):
    reference = {(array, float(phi)): float(K) for array, phi, K in rows("reference.dat")}
    runs = [(r[0], float(r[1]), float(r[2]), *r[3:5], *(float(x) for x in r[5:])) for r in rows("periodic_arrays.dat")]
    fine = 10.0                                    # cells per diameter that divide coarse from fine
    with open("results.txt", "w") as out:
        for array, phi, d, collision, link, tau, K, spread, balance in runs:
            if (collision, link, tau) != ("trt", "cli", 2.0):
                continue
            error = 100 * (K / reference[array, phi] - 1)
            limit = 5 if d < fine else 1           # per cent
            name = f"K_{array}_phi{phi:g}_d{d:.1f}"
            print(f"{name} {K:.5g} - -", file=out)
            print(f"{name}_error_% {error:.2f} {-limit} {limit}", file=out)
            print(f"{name}_places_% {100 * spread:.2f} - -", file=out)
        for collision, link in ("trt", "cli"), ("trt", "bouzidi"), ("bgk", "bouzidi"):
            K = [r[6] for r in sorted(runs, key=lambda r: r[5]) if r[1] == 0.125 and 7.3 < r[2] < 7.5 and r[3:5] == (collision, link)]
            gate = "0 0.01" if link == "cli" else "1 -"
            print(f"K_range_over_tau_{collision}_{link}_% {100 * (max(K) / min(K) - 1):.4f} {gate}", file=out)
        print(f"worst_force_balance {max(abs(r[8]) for r in runs):.1e} 0 1e-5", file=out)
    print(open("results.txt").read(), end="")


main(sys.argv[1] if len(sys.argv) > 1 else "quick")
