#!/usr/bin/env python3
"""Velocity of the water in a fluidised bed against the solid fraction, and against time: fluidised_bed.png"""
import glob
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from check import exponent, large

phi, beads, seed, cells, Re, ratio, drift = np.atleast_2d(np.loadtxt("fluidised_bed.dat")).T
figure, axes = plt.subplots(1, 2, figsize=(10, 4.2))
x = np.linspace(0, 0.5, 60)
axes[0].semilogy(x, (1 - x) ** (4.35 * Re[0] ** -0.03), "k-", lw=1, label=f"Richardson & Zaki, n = {4.35 * Re[0] ** -0.03:.2f}")
axes[0].semilogy(x, (1 - x) ** exponent(Re[0]), "k--", lw=1, label=f"Garside & Al-Dibouni, n = {exponent(Re[0]):.2f}")
axes[0].semilogy(phi, ratio, "x", color="0.5", label="ours, in the periodic box")
axes[0].semilogy(phi, large(phi, beads, ratio), "o", mfc="none", label=f"ours, in a large bed; {cells[0]:g} cells per diameter")
axes[0].set_xlabel("solid fraction")
axes[0].set_ylabel(f"$U / U_t$, Re = {Re[0]:.2f}")
axes[0].legend(fontsize=8)
for name in sorted(glob.glob("fluidised_bed-*.dat")):
    fraction, start = name[:-4].split("-")[1:]
    t, r = np.loadtxt(name, unpack=True)
    axes[1].plot(t, r, color=f"C{round(10 * float(fraction)) % 10}", lw=1, label=f"{fraction}, start {start}")
axes[1].set_xlabel("time ($d/U_t$)")
axes[1].set_ylabel("$U / U_t$")
axes[1].set_ylim(0, 1.45 * axes[1].get_ylim()[1])
axes[1].legend(fontsize=7, title="solid fraction", title_fontsize=7, ncol=4, loc="upper center")
figure.tight_layout()
figure.savefig("fluidised_bed.png", dpi=110)
