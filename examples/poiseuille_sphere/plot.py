#!/usr/bin/env python3
"""Figs 7 and 8: reads poiseuille_sphere.dat and reference.txt, makes force.png, torque.png, errors.png"""
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

import check

rows, limit = check.read_reference()
runs = [run for run in check.read_runs() if (run["sx"], run["sy"]) == (0, 0)]
everywhere = check.read_runs()
eq25, eq26 = check.wakiya()
ratios = np.geomspace(6, 45, 200)
exact = np.array([check.exact(x, rows, limit) for x in ratios])
SERIES = [("trt-cli-tau3", 5.50, "o", "C0"), ("trt-cli-tau3", 3.52, "s", "C1"), ("trt-cli-tau3", 3.08, "^", "C2"),
          ("bgk-bouzidi-tau0.7", 5.50, "o", "C3"), ("bgk-bouzidi-tau0.7", 3.08, "^", "C3")]


def select(which, r):
    return sorted((run for run in runs if check.kind(run) == which and run["r"] == r), key=lambda x: x["ratio"])


def label(which, r):
    rules = "TRT, CLI" if which.startswith("trt") else "BGK, Bouzidi, $\\tau$ = 0.7"
    return f"r = {r:.2f} cells, {rules}"


def draw(name, key, column, wakiya, equation, ylabel):
    figure, axis = plt.subplots(figsize=(7, 5))
    axis.plot(ratios, exact[:, column], color="k", lw=1, label="exact, period D")
    axis.axhline(limit[column], color="k", lw=1, ls=":", label=f"exact, one sphere: {limit[column]:.4f}")
    axis.axhline(wakiya, color="0.5", lw=1, ls="--", label=f"article's {equation}: {wakiya:.4f}")
    for which, r, marker, colour in SERIES:
        group = select(which, r)
        if not group:
            continue
        x = [run["ratio"] for run in group]
        hollow = {} if which.startswith("trt") else {"mfc": "none"}
        axis.plot(x, [run[key] for run in group], marker, color=colour, label=label(which, r), **hollow)
        if key == "F" and (which, r) in (SERIES[0][:2], SERIES[-1][:2]):
            axis.plot(x, [run["without"] for run in group], "x" if r == 5.5 else "+", color=colour,
                      label="   the same without $\\rho a_x V$")
    axis.set_xlabel("period over radius, $D/r$")
    axis.set_ylabel(ylabel)
    axis.legend(fontsize=8, loc="lower right")
    figure.tight_layout()
    figure.savefig(name, dpi=120)
    plt.close(figure)


def errors(name):
    """relative differences; bars: the range over places of the sphere against the lattice"""
    figure, axes = plt.subplots(2, 1, figsize=(7, 6.5), sharex=True)
    for k, axis in enumerate(axes):
        axis.axhline(0, color="k", lw=0.8)
        for which, r, marker, colour in SERIES:
            group = select(which, r)
            hollow = {} if which.startswith("trt") else {"mfc": "none"}
            axis.plot([run["ratio"] for run in group], [check.differences(run, rows, limit)[k] for run in group],
                      marker + "-", color=colour, lw=0.6, label=label(which, r) if group else None, **hollow)
            spread = [run for run in everywhere if check.kind(run) == which and run["r"] == r]
            places = [run for run in spread if run["sx"]]
            if places:
                ratio = places[0]["ratio"]
                d = [check.differences(run, rows, limit)[k] for run in spread if run["ratio"] == ratio]
                axis.plot([ratio, ratio], [min(d), max(d)], color=colour, lw=4, alpha=0.3)
        if k == 1:
            axis.axhline(100 * (eq26 / limit[1] - 1), color="0.5", ls="--", lw=1, label="eq. 26 against exact, one sphere")
    axes[0].set_ylabel("force: difference from exact (%)")
    axes[1].set_ylabel("torque: difference from exact (%)")
    axes[1].set_xlabel("period over radius, $D/r$")
    axes[1].set_xscale("log")
    axes[1].set_xticks([6, 8, 10, 12, 15, 20, 30, 45], [6, 8, 10, 12, 15, 20, 30, 45])
    axes[1].minorticks_off()
    axes[1].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(name, dpi=120)
    plt.close(figure)


draw("force.png", "F", 0, eq25, "eq. 25", "force, $F/(6\\pi\\mu r U_h)$")
draw("torque.png", "M", 1, eq26, "eq. 26", "torque, $M/(\\frac{8}{3}\\pi\\mu r^2 U_h\\, r/h)$")
errors("errors.png")
