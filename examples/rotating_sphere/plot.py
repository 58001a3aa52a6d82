#!/usr/bin/env python3
"""Torque on a spinning sphere against resolution, box and tau: rotating_sphere.png"""
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

runs = np.loadtxt("rotating_sphere.dat", dtype=str)
r, box, tau, mean, spread, phi = (runs[:, c].astype(float) for c in (0, 1, 4, 5, 6, 8))
rule = np.array([f"{a} {b}" for a, b in runs[:, 2:4]])
main = (rule == "trt cli") & (tau == 2.0)
figure, axes = plt.subplots(1, 3, figsize=(13, 4))
take = main & (np.abs(box / r - 6) < 0.3)
order = np.argsort(r[take])
axes[0].errorbar(r[take][order], 100 * (mean[take] - 1)[order], 100 * spread[take][order], marker="o", capsize=3)
axes[0].axhline(0, color="0.6", lw=0.8)
axes[0].set_xlabel("radius (cells)")
axes[0].set_ylabel("error of the torque (%), bars: spread over places")
take = main & (r == 4)
x = np.linspace(0, max(phi) * 1.05, 50)
axes[1].plot(x, 1 / (1 - x), "k-", lw=1, label=r"$1/(1-\phi)$")
axes[1].plot(phi[take], mean[take] / (1 - phi[take]), "o", mfc="none", label="ours, r = 4 cells")
axes[1].set_xlabel(r"solid fraction $\phi$ of the periodic box")
axes[1].set_ylabel(r"$T / 8\pi\mu r^3\omega$")
axes[1].legend()
for name in np.unique(rule):
    take = (rule == name) & (r == 4) & (box == 24)
    order = np.argsort(tau[take])
    axes[2].plot(tau[take][order], 100 * (mean[take] - 1)[order], "o-", ms=4, label=name)
axes[2].axhline(0, color="0.6", lw=0.8)
axes[2].set_xlabel(r"relaxation time $\tau$")
axes[2].set_ylabel("error of the torque (%), r = 4 cells")
axes[2].legend()
figure.tight_layout()
figure.savefig("rotating_sphere.png", dpi=100)
