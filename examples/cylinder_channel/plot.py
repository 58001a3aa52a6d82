#!/usr/bin/env python3
"""Speed of 2D-1 and 2D-2, and drag and lift of 2D-2 over time: cylinder_channel.png"""
import pathlib

import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

from check import read_grid    # noqa: E402

best = 40 if pathlib.Path("steady40.grid").exists() else 20
figure, axes = plt.subplots(3, 1, figsize=(10, 7.5))
for axis, name, title in zip(axes, (f"steady{best}", "street20"), ("2D-1, Re = 20", "2D-2, Re = 100")):
    x, y, field = read_grid(f"{name}.grid")
    u, v, solid = (np.reshape(field[k], (len(y), len(x))) for k in ("velocity[1]", "velocity[2]", "solid"))
    speed = np.ma.masked_where(solid > 0, np.hypot(u, v))
    picture = axis.imshow(speed, origin="lower", extent=[x[0], x[-1], y[0], y[-1]], cmap="viridis")
    figure.colorbar(picture, ax=axis, label="speed (m/s)")
    axis.set_title(f"{title}, {name[6:]} cells per diameter")
t, drag, lift = np.loadtxt("street20.series", unpack=True)
axes[2].plot(t, drag, label="c_D")
axes[2].plot(t, lift, label="c_L")
axes[2].axhspan(3.22, 3.24, color="0.7", label="largest, Schaefer & Turek")
axes[2].axhspan(0.99, 1.01, color="0.7")
axes[2].set_ylim(-1.5, 4)
axes[2].set_xlabel("time (s)")
axes[2].legend(loc="lower left")
figure.tight_layout()
figure.savefig("cylinder_channel.png", dpi=100)
