"""One page of a quicksand run: NAME.html, with its pictures inside; called by plot.py.

Needs NAME.dat and NAME-profile.dat as in.quicksand writes them, and the pictures that plot.py made.
"""
import base64
import os

import numpy as np
import matplotlib.pyplot as plt

STEP = 1.2e-6    # of in.quicksand, seconds


def blocks(name):
    """(time, rows) of every block that fix ave/time wrote"""
    found = []
    with open(name) as file:
        lines = [line.split() for line in file if line[0] != "#"]
    at = 0
    while at < len(lines):
        step, n = int(lines[at][0]), int(lines[at][1])
        found.append((STEP * step, np.array([[float(x) for x in row[1:]] for row in lines[at + 1:at + 1 + n]])))
        at += 1 + n
    return found


def profiles(name):
    """porosity, pressure, i(z)/i_c and effective stress in steady seepage, at the onset, and at the end"""
    table = np.loadtxt(f"{name}.dat")
    time, ratio, rise = table[:, 0], table[:, 1], table[:, 2]
    all_of_them = blocks(f"{name}-profile.dat")
    moments = [("steady seepage", 0.07)]
    if rise.max() >= 0.05:
        moments.append(("onset", time[np.argmax(rise >= 0.05)]))
    moments.append(("end", time[-1]))
    figure, axes = plt.subplots(1, 4, figsize=(12, 4.6), sharey=True)
    for label, when in moments:
        t, rows = min(all_of_them, key=lambda block: abs(block[0] - when))
        z, porosity, pressure, _, i, _, _, stress = rows.T
        bed = porosity < 0.9    # layers that hold more than tips of grains
        label = f"{label}: {t:.3f} s, $i/i_c$ = {np.interp(t, time, ratio):.3f}"
        axes[0].plot(porosity, 1e3 * z, "o-", ms=3, label=label)
        axes[1].plot(pressure, 1e3 * z, "o-", ms=3)
        axes[2].plot(i[bed], 1e3 * z[bed], "o-", ms=3)
        axes[3].plot(stress, 1e3 * z, "o-", ms=3)
    axes[2].axvline(1.0, color="0.6", lw=0.8)
    axes[3].axvline(0.0, color="0.6", lw=0.8)
    for axis, what in zip(axes, ("porosity", "gauge pressure (Pa)", "$i(z)/i_c$ in the bed", "effective stress (Pa)")):
        axis.set_xlabel(what)
    axes[0].set_ylabel("z (mm)")
    figure.legend(loc="upper center", ncol=3, fontsize=9)
    figure.tight_layout(rect=(0, 0, 1, 0.93))
    figure.savefig(f"{name}-profiles.png", dpi=110)
    plt.close(figure)


def onset(name):
    """rise and height of the bed against the gradient"""
    _, ratio, rise, _, height, *_ = np.loadtxt(f"{name}.dat", unpack=True)
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.8))
    axes[0].plot(ratio, rise, lw=1)
    axes[0].axhline(0.05, color="0.6", lw=0.8)
    axes[0].set_ylabel("mean rise / mean diameter")
    axes[0].set_yscale("symlog", linthresh=0.05)
    axes[1].plot(ratio, height, lw=1)
    axes[1].set_ylabel("height of the bed (mm)")
    for axis in axes:
        axis.set_xlabel("$i/i_c$")
    figure.tight_layout()
    figure.savefig(f"{name}-onset.png", dpi=110)
    plt.close(figure)


def page(name):
    onset(name)
    profiles(name)
    table = np.loadtxt(f"{name}.dat")
    lifted = table[:, 2] >= 0.05
    verdict = (f"The mean rise reached 0.05 mean diameters at i/i<sub>c</sub> = {table[np.argmax(lifted), 1]:.3f}, "
               f"{table[np.argmax(lifted), 0]:.3f} s." if lifted.any() else "The bed did not lift.")
    text = [f"<!doctype html><meta charset=utf-8><title>{name}</title>",
            "<style>body{font-family:sans-serif;max-width:70em;margin:2em auto}img{max-width:100%}</style>",
            f"<h1>{name}</h1><p>{verdict} i<sub>c</sub> is the gradient at which the water carries the bed's submerged "
            "weight.</p>"]
    for kind, title in (("-onset", "Onset: rise and height against the gradient"),
                        ("", "Gradient, rise and flux against time"),
                        ("-profiles", "Profiles: porosity, pressure, gradient, what the grains still carry"),
                        ("-before", "In steady seepage"), ("-after", "At the end")):
        if os.path.exists(f"{name}{kind}.png"):
            with open(f"{name}{kind}.png", "rb") as file:
                data = base64.b64encode(file.read()).decode()
            text.append(f"<h2>{title}</h2><img alt='{title}' src='data:image/png;base64,{data}'>")
    with open(f"{name}.html", "w") as out:
        out.write("\n".join(text))
    print(f"page of plots: {os.path.abspath(name + '.html')}")
