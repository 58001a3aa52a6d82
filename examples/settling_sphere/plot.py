#!/usr/bin/env python3
"""Velocity and path of the sphere beside the measured values: settling_sphere.png"""
import glob
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

reference = {row[0]: [float(x) for x in row[1:]] for row in np.loadtxt("reference.dat", dtype=str)}
figure, axes = plt.subplots(1, 2, figsize=(10, 4.2))
for name in sorted(glob.glob("settling-E?-*.dat")):
    case, cells = name[:-4].split("-")[1:]
    time, gap, v = np.loadtxt(name, unpack=True)
    rho, mu, Re, uinf, umax = reference[case][:5]
    colour = f"C{int(case[1]) - 1}"
    axes[0].plot(time, 1000 * v, colour, label=f"{case}, Re {Re:g}, d = {cells} dx")
    axes[0].axhline(-1000 * umax, color=colour, ls=":", lw=1)
    axes[1].plot(time, gap, colour)
if glob.glob("settling-E3-*.dat"):
    t, v = np.loadtxt("measured_E3.dat", unpack=True)
    axes[0].plot(t, 1000 * v, "C2s", mfc="none", label="E3 measured")
axes[0].plot([], [], "k:", lw=1, label="measured $u_{max}$")
axes[0].set_xlabel("time (s)")
axes[0].set_ylabel("velocity of the sphere (mm/s)")
axes[0].legend(fontsize=8)
axes[1].set_xlabel("time (s)")
axes[1].set_ylabel("gap below the sphere / d")
figure.tight_layout()
figure.savefig("settling_sphere.png", dpi=110)
