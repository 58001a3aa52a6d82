#!/usr/bin/env python3
"""Resistance of a sphere near a wall against the gap: near_wall.png"""
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from check import approach, read, slide

runs = read()
figure, axes = plt.subplots(1, 2, figsize=(10, 4.2))
for r in sorted({run[3] for run in runs if not run[0] and run[2] == "cli"}):
    gaps = np.geomspace(0.03, 2.0, 100)
    axes[0].plot(gaps, [approach(g / r) for g in gaps], "k-", lw=1, label="Brenner 1961" if r == 6 else None)
    for film, style in ((True, "C0"), (False, "C3")):
        curve = np.array([run[4:6] for run in runs if not run[0] and run[1] == film and run[2] == "cli" and run[3] == r])
        if len(curve):
            label = f"{'with films' if film else 'lattice alone'}" if r == 6 else None
            axes[0].plot(curve[:, 0], curve[:, 1], style, label=label)
            axes[0].annotate(f"r = {r:g}", curve[-1], textcoords="offset points", xytext=(-6, -3), ha="right")
axes[0].set(xscale="log", yscale="log", xlabel="gap (cells)", ylabel=r"resistance / 6$\pi\mu$rU",
            title="towards the wall", xlim=(0.016, None))
gaps = np.geomspace(0.03, 0.8, 50)
axes[1].plot(gaps, [slide(g / 6) for g in gaps], "k-", lw=1, label="Goldman, Cox & Brenner 1967, thin gaps")
for film, style in ((True, "C0o"), (False, "C3s")):
    points = np.array([run[4:6] for run in runs if run[0] and run[1] == film])
    axes[1].plot(points[:, 0], points[:, 1], style, mfc="none", label="with films" if film else "lattice alone")
axes[1].set(xscale="log", xlabel="gap (cells)", title="along the wall, r = 6")
for ax in axes:
    ax.legend(fontsize=8)
figure.tight_layout()
figure.savefig("near_wall.png", dpi=110)
