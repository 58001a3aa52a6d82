#!/usr/bin/env python3
"""Force and torque on the sphere against the reference: check.py quick|full

Reads poiseuille_sphere.dat and reference.txt, writes results.txt: name, value, low, high (- where there
is no limit). dF and dM are relative differences in per cent, at the D/r of the run.
"""
import math
import sys

R_OVER_H = 0.44    # r/h, distance h from the plate


def read_reference(name="reference.txt"):
    """rows (D/r, F, M) of finite period, and (F, M) of the isolated sphere"""
    with open(name) as file:
        rows = [line.split() for line in file if not line.startswith("#")]
    rows = [[float(x) for x in row] for row in rows]
    return [row for row in rows if math.isfinite(row[0])], rows[-1][1:]


def exact(ratio, rows, limit):
    """(F, M) at D/r: (limit - value) (D/r)^2 varies little; the cubic in log(D/r) through 4 rows"""
    above = next((k for k in range(len(rows)) if rows[k][0] >= ratio), len(rows) - 1)
    first = min(max(above - 2, 0), len(rows) - 4)
    used, x = rows[first:first + 4], math.log(ratio)
    value = list(limit)
    for row in used:
        share = math.prod((x - math.log(other[0])) / math.log(row[0] / other[0])
                          for other in used if other is not row)
        for k in range(2):
            value[k] -= share * (limit[k] - row[1 + k]) * (row[0] / ratio) ** 2
    return value


def wakiya():
    """force and torque of the article's eqs 25 and 26, normalised by eqs 29 and 30"""
    s = R_OVER_H
    force = (1 - s ** 2 / 9) / (1 - 0.6526 * s + 0.3160 * s ** 3 - 0.2420 * s ** 4)
    return force, 1 + 0.0758 * s + 0.0490 * s ** 2


def read_runs(name="poiseuille_sphere.dat"):
    keys = ("r", "D", "ratio", "tau", "collision", "link", "sx", "sy", "without", "F", "M", "change", "steps")
    with open(name) as file:
        runs = [dict(zip(keys, line.split())) for line in file]
    for run in runs:
        for key in keys:
            if key not in ("collision", "link"):
                run[key] = float(run[key])
    return runs


def kind(run):
    return f"{run['collision']}-{run['link']}-tau{run['tau']:g}"


def differences(run, rows, limit):
    force, torque = exact(run["ratio"], rows, limit)
    return [100 * (run["F"] / force - 1), 100 * (run["M"] / torque - 1),
            100 * (run["without"] / force - 1)]


def check(mode):
    rows, limit = read_reference()
    runs = read_runs()
    results = []

    def add(name, value, low="-", high="-"):
        results.append(f"{name} {value:.4g} {low} {high}")

    for run in runs:
        if (run["sx"], run["sy"]) != (0, 0):
            continue
        dF, dM, dF_without = differences(run, rows, limit)
        name = f"{kind(run)}_r{run['r']:.2f}_D{run['ratio']:.2f}r"
        gated = run["link"] == "cli" and run["r"] == 5.5    # coarser ones: see the places below
        add(f"dF%_{name}", dF, *([-1.0, 1.0] if gated else []))
        add(f"dM%_{name}", dM, *([-1.5, 1.5] if gated else []))
        add(f"dF%_without_gradient_{name}", dF_without)
    add("largest_change_per_half_time", max(run["change"] for run in runs), 0, 1e-4)

    # mean over places of the sphere against the lattice, and the range
    for which in sorted({(kind(run), run["r"], run["D"]) for run in runs if run["sx"]}):
        group = [run for run in runs if (kind(run), run["r"], run["D"]) == which]
        for k, letter in enumerate("FM"):
            d = [differences(run, rows, limit)[k] for run in group]
            mean = sum(d) / len(d)
            name = f"{which[0]}_r{which[1]:.2f}_D{group[0]['ratio']:.2f}r"
            gated = which[0].startswith("trt-cli") and which[1] == 5.5
            add(f"d{letter}%_mean_of_places_{name}", mean,
                *([(-1.0, 1.0), (-1.5, 1.5)][k] if gated else []))
            add(f"d{letter}%_least_of_places_{name}", min(d))
            add(f"d{letter}%_most_of_places_{name}", max(d))

    # with trt and cli the same steady flow at every tau
    for run in runs:
        if kind(run) != "trt-cli-tau0.7":
            continue
        twin = next((x for x in runs if kind(x) == "trt-cli-tau3" and (x["r"], x["D"], x["sx"], x["sy"])
                     == (run["r"], run["D"], run["sx"], run["sy"])), None)
        if twin:
            for key in "FM":
                add(f"tau_0.7_against_3%_{key}_r{run['r']:.2f}_D{run['ratio']:.2f}r",
                    100 * (run[key] / twin[key] - 1), -0.05, 0.05)

    force, torque = wakiya()
    add("eq25_against_exact%", 100 * (force / limit[0] - 1))
    add("eq26_against_exact%", 100 * (torque / limit[1] - 1))
    with open("results.txt", "w") as file:
        file.write("\n".join(results) + "\n")
    print("\n".join(results))


if __name__ == "__main__":
    check(sys.argv[1] if len(sys.argv) > 1 else "quick")
