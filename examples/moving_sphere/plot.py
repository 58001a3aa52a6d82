#!/usr/bin/env python3
"""Fig. 9: reads force-*.dat, makes drag.png and noise.png"""
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

import check

NAME = "force-{}-{}-{}-{}-{}.dat"
SHOWN = [("bgk", "bouzidi", "equilibrium", "no", "article: BGK, Bouzidi, equilibrium"),
         ("bgk", "cli", "grad", "two", "BGK, CLI, Grad, mean of two steps"),
         ("trt", "cli", "grad", "yes", "defaults: TRT, CLI, Grad, mean of two steps")]


def pair(collision, link, refill, how):
    """drag on the moving and on the fixed sphere, the latter as the mean of two steps"""
    average = "yes" if how == "yes" else "no"
    moving = check.read(NAME.format("moving", collision, link, refill, average))
    fixed = check.read(NAME.format("fixed", collision, link, "grad", average))
    if how != "yes":
        fixed = check.two_steps(fixed)
    return np.array(check.two_steps(moving) if how == "two" else moving), np.array(fixed)


figure, axes = plt.subplots(2, 1, figsize=(7.5, 7.5), height_ratios=[1.3, 1])
for k, (*rules, label) in enumerate(SHOWN):
    moving, fixed = pair(*rules)
    t = np.arange(len(moving))
    if k != 1:
        axes[0].plot(t, fixed, color=f"C{k}", lw=2, alpha=0.45, label=f"sphere fixed, {label}")
        axes[0].plot(t, moving, color=f"C{k}", lw=0.6, label=f"sphere moves, {label}")
    axes[1].plot(t[-200:], 100 * moving[-200:] / fixed[-200:] - 100, color=f"C{k}", lw=1, zorder=3 - k, label=label)
axes[0].set_ylim(0.25, 0.8)
axes[0].set_ylabel("drag, $F/(\\rho c^2 \\Delta x^2)$")
axes[1].set_xlabel("fluid steps after the start (the last eight cells of way)")
axes[1].set_ylim(-4, 6)
axes[1].set_ylabel("moving over fixed - 1 (%)")
axes[0].set_xlabel("fluid steps after the start; dashed: begin of the window")
axes[0].axvline(check.WINDOW, color="0.7", lw=0.8, ls="--")
axes[1].axhline(0, color="k", lw=0.6)
for axis in axes:
    axis.legend(fontsize=8, loc="upper right")
figure.tight_layout()
figure.savefig("drag.png", dpi=120)
plt.close(figure)

# every combination: rms, largest and bias
table, _ = check.collect()
names = {"no": "each step", "two": "mean of two", "yes": "mean of two, by the fix"}
words = {"bgk": "BGK", "trt": "TRT", "cli": "CLI", "bouzidi": "Bouzidi", "halfway": "half-way", "grad": "Grad",
         "equilibrium": "equilibrium"}
keys = sorted(table, key=lambda key: table[key][1])
y = np.arange(len(keys))
figure, axis = plt.subplots(figsize=(8, 0.28 * len(keys) + 1.2))
axis.plot([table[k][2] for k in keys], y, "|", color="C3", ms=9, label="largest")
axis.barh(y, [table[k][1] for k in keys], color="C0", alpha=0.6, label="rms")
axis.plot([abs(table[k][0]) for k in keys], y, "o", color="k", ms=3, label="|bias|")
axis.set_yticks(y, [", ".join([*(words[w] for w in k[:3]), names[k[3]]]) for k in keys], fontsize=8)
axis.invert_yaxis()
axis.set_xscale("log")
axis.set_xlabel("difference from the fixed sphere (%)")
axis.legend(fontsize=8, loc="upper right")
figure.tight_layout()
figure.savefig("noise.png", dpi=120)
