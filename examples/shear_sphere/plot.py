#!/usr/bin/env python3
"""Spin of a free sphere in shear against the box, and against the Reynolds number: shear_sphere.png"""
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from reference import coefficient

runs = np.loadtxt("shear_sphere.dat", dtype=str)
r, box, Re, spin, shift = (runs[:, c].astype(float) for c in (0, 1, 2, 7, 9))
free = runs[:, 3] == "no"
inertia = free & (Re > 0.01)
figure, axes = plt.subplots(1, 2 if inertia.any() else 1, figsize=(10 if inertia.any() else 5.5, 4.2), squeeze=False)
axes = axes[0]
x = np.linspace(0, max((r / box) ** 3) * 1.05, 50)
axes[0].plot(x, 0.5 - coefficient() * x, "k-", lw=1, label="1/2 less images and walls")
for value in np.unique(r):
    take = free & (Re == 0.01) & (r == value)
    boxes = np.unique(box[take])
    of = [spin[take & (box == b)] for b in boxes]
    axes[0].errorbar((value / boxes) ** 3, [np.mean(x) for x in of], [np.ptp(x) / 2 for x in of], marker="o", ls="",
                     mfc="none", capsize=2, label=f"ours, r = {value:g} cells, range over places")
axes[0].set_xlabel("$(r/L)^3$")
axes[0].set_ylabel("spin / shear rate")
axes[0].legend(fontsize=8)
if inertia.any():
    base = spin[free & (Re == 0.01) & (r == 4) & (box == 32) & (shift == 0)][0]
    x = np.linspace(0, Re.max(), 100)
    axes[1].plot(x, 0.0540 * x ** 1.5, "k-", lw=1, label=r"$0.054\,Re^{3/2}$, unbounded (Meibohm et al. 2016)")
    axes[1].plot(Re[inertia], base - spin[inertia], "o", mfc="none", label="ours, box of 8 radii")
    axes[1].set_xlabel("Re = shear rate $r^2$ / viscosity")
    axes[1].set_ylabel("spin lost to inertia / shear rate")
    axes[1].legend(fontsize=8)
figure.tight_layout()
figure.savefig("shear_sphere.png", dpi=110)
