#!/usr/bin/env python3
"""Figures 10 and 11 from what in.dkt2d wrote here: python3 plot.py

dkt2d-discs.png: discs with a line fixed on each, and the vorticity of the water;
dkt2d-velocity.png: settling velocities, distance and spin against time, with reference.dat.
"""
import glob
import os
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

R, L = 0.1, (2.0, 8.0)
NAMES = {"dkt2d": "10 cells per radius, Ma < 0.1", "fine": "20 cells per radius, Ma < 0.1",
         "coarse": "5 cells per radius, Ma < 0.1", "paper": "the article's rules, tau 0.75, Ma 0.27",
         "paper-slow": "the article's rules, Ma < 0.1"}


def read(name):
    table = np.loadtxt(name + ".dat", unpack=True)
    t, spin = table[0], table[[5, 10]]
    mid = 0.5 * (spin[:, 1:] + spin[:, :-1]) * np.diff(t)
    angle = np.concatenate((np.zeros((2, 1)), np.cumsum(mid, axis=1)), axis=1)
    return table, angle


def read_grid(name):
    """time, and the vorticity of the water as an array [y, x]"""
    with open(name) as file:
        lines = [next(file) for _ in range(40)]
    time = float(lines[next(i for i, s in enumerate(lines) if s.startswith("ITEM: TIME\n")) + 1])
    at = next(i for i, s in enumerate(lines) if s.startswith("ITEM: GRID SIZE"))
    nx, ny = (int(s) for s in lines[at + 1].split()[:2])
    at = next(i for i, s in enumerate(lines) if s.startswith("ITEM: GRID CELLS"))
    data = np.loadtxt(name, skiprows=at + 1)
    data = data[np.argsort(data[:, 0])]    # every rank writes its own block
    u, v, solid = (c.reshape(ny, nx) for c in data.T[1:4])
    dx = L[0] / nx
    hide = solid > 0    # and the nodes whose differences reach into a disc
    for axis in 0, 1:
        for step in 1, -1:
            hide = hide | (np.roll(solid, step, axis) > 0)
    return time, np.ma.array(np.gradient(v, dx, axis=1) - np.gradient(u, dx, axis=0), mask=hide)


def show(axis, field, discs, width):
    """discs (x, y, angle) over the vorticity, whose image is returned"""
    image = None
    if field is not None:
        image = axis.imshow(field, origin="lower", extent=[0, L[0], 0, L[1]], cmap="coolwarm",
                            vmin=-15, vmax=15)
    for (x, y, turn), colour in zip(discs, ("black", "tab:green")):
        axis.add_patch(plt.Circle((x, y), R, facecolor="white", edgecolor=colour, lw=width))
        dx, dy = R * np.cos(turn), R * np.sin(turn)
        axis.plot([x - dx, x + dx], [y - dy, y + dy], color=colour, lw=width)
    return image


def draw_discs(name):
    (t, x1, y1, _, _, _, x2, y2, *_), angle = read(name)
    grids = sorted((read_grid(f) for f in glob.glob(name + "-*.grid")), key=lambda g: g[0])
    fields = {round(g[0], 2): g[1] for g in grids}
    times = [s for s in np.arange(0.0, 4.01, 0.5) if s <= t[-1] + 0.01]
    image = None
    figure, axes = plt.subplots(1, len(times), figsize=(1.75 * len(times) + 0.8, 7.2), sharey=True,
                                layout="constrained")
    for axis, time in zip(axes, times):
        field = next((f for s, f in fields.items() if abs(s - time) < 0.01), None)
        discs = [[np.interp(time, t, c) for c in disc]
                 for disc in ((x1, y1, angle[0]), (x2, y2, angle[1]))]
        image = show(axis, field, discs, 1.2) or image
        # the pair again, enlarged, as long as it is one
        cx, cy = (np.interp(time, t, 0.5 * (a + b)) for a, b in ((x1, x2), (y1, y2)))
        if np.interp(time, t, np.hypot(x1 - x2, y1 - y2)) < 6 * R:
            inset = axis.inset_axes([0.04, 0.02 if time < 2.2 else 0.74, 0.92, 0.24])
            show(inset, field, discs, 1.5)
            inset.set(xlim=(cx - 0.35, cx + 0.35), ylim=(cy - 0.35, cy + 0.35), xticks=[], yticks=[],
                      aspect="equal")
        axis.set(xlim=(0, L[0]), ylim=(0, L[1]), aspect="equal", title=f"{time:.1f} s",
                 xlabel="x (cm)")
    axes[0].set_ylabel("y (cm)")
    if image:
        figure.colorbar(image, ax=axes, shrink=0.5, label="vorticity (1/s)")
    figure.suptitle(f"Black: the disc that trails at first. Insets: the pair, enlarged. {NAMES[name]}")
    figure.savefig("dkt2d-discs.png", dpi=110)
    plt.close(figure)


def draw_curves(names):
    figure, axes = plt.subplots(3, 1, figsize=(8, 10), sharex=True, layout="constrained")
    for k, name in enumerate(names):
        table, _ = read(name)
        t = table[0]
        colour = f"C{k}"
        axes[0].plot(t, table[4], color=colour, label=NAMES[name])
        axes[0].plot(t, table[9], "--", color=colour)
        axes[1].plot(t, table[11], color=colour)
        axes[2].plot(t, table[5], color=colour)
        axes[2].plot(t, table[10], "--", color=colour)
    label = "reference, 3 %"
    known = [line.split() for line in open("reference.dat") if not line.startswith("#")]
    for what, time, low, high in known:
        low, high = float(low), float(high)
        if time != "-":
            middle = 0.5 * (low + high)
            axes[0].errorbar(float(time), middle, yerr=0.03 * abs(middle), color="black", capsize=4,
                             marker="o", ms=4, zorder=5,
                             label=label)
            label = None
        elif what.endswith("_s"):
            axes[1].axvspan(low, high, color="0.85", zorder=0)
            axes[1].text(0.5 * (low + high), 3.1, what[:-2].replace("_", " "), ha="center", va="top",
                         rotation=90, fontsize=8)
        else:
            axes[2].axhline(low, color="black", lw=0.8)
            axes[2].text(0.02, low, "reference: peak", va="bottom", fontsize=8)
    axes[0].set_ylabel("vertical velocity (cm/s)")
    axes[0].set_title("full lines: the disc that trails at first, dashed: the leading one")
    axes[0].legend(fontsize=8)
    axes[1].set_ylabel("gap / 2R")
    axes[1].set_ylim(-0.1, 3.2)
    axes[2].set_ylabel("spin (1/s)")
    axes[2].set_xlabel("time (s)")
    axes[2].set_xlim(0, None)
    figure.savefig("dkt2d-velocity.png", dpi=110)


if __name__ == "__main__":
    there = [name for name in NAMES if os.path.exists(name + ".dat")]
    draw_discs(there[0])
    draw_curves(there)
