#!/usr/bin/env python3
"""Pictures of a quicksand run: python3 plot.py NAME, or of all runs of figure.sh: python3 plot.py quick|full

Reads NAME.dat, NAME-grains-{before,after}.png and NAME-water-{before,after}.grid as in.quicksand
writes them. Makes NAME-{before,after}.png, grains with a vertical slice of the water beside them,
NAME.png, the rise of the bed against the gradient, and NAME.html, one page of all (page.py). Of figure.sh:
snapshots.png, onset.png.
"""
import glob
import sys
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

import page


def read_grid(name):
    """(nx, ny, nz), box lengths, and the columns of a LAMMPS grid dump as arrays [z, y, x]"""
    with open(name) as file:
        lines = file.read().splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith("ITEM: BOX BOUNDS"))
    box = np.array([[float(x) for x in line.split()] for line in lines[at + 1:at + 4]])
    at = next(i for i, line in enumerate(lines) if line.startswith("ITEM: GRID SIZE"))
    n = [int(x) for x in lines[at + 1].split()]
    at = next(i for i, line in enumerate(lines) if line.startswith("ITEM: GRID CELLS"))
    data = np.array([[float(x) for x in line.split()] for line in lines[at + 1:]])
    data = data[np.argsort(data[:, 0])][:, 1:]    # every rank writes its own block
    return n, box[:, 1] - box[:, 0], [c.reshape(n[2], n[1], n[0]) for c in data.T]


def draw(name, when):
    n, L, (w, p, solid) = read_grid(f"{name}-water-{when}.grid")
    j = n[1] // 2
    hide = solid[:, j, :] > 0
    extent = [0, 1e3 * L[0], 0, 1e3 * L[2]]
    figure, axes = plt.subplots(1, 3, figsize=(9.5, 7.2), gridspec_kw={"width_ratios": [1.25, 1, 1]})
    axes[0].imshow(plt.imread(f"{name}-grains-{when}.png"))
    axes[0].set_title("grains, speed 0 to 2 cm/s")
    axes[0].axis("off")
    for axis, field, title, colours in ((axes[1], 1e3 * w, "upward velocity (mm/s)", "viridis"),
                                        (axes[2], p, "gauge pressure (Pa)", "coolwarm")):
        image = axis.imshow(np.ma.array(field[:, j, :], mask=hide), origin="lower", extent=extent,
                            cmap=colours, interpolation="nearest")
        axis.set_facecolor("0.35")
        axis.set_title(title)
        axis.set_xlabel("x (mm)")
        figure.colorbar(image, ax=axis, shrink=0.8)
    axes[1].set_ylabel("z (mm)")
    figure.tight_layout()
    figure.savefig(f"{name}-{when}.png", dpi=110)
    plt.close(figure)


def curve(name):
    time, i, rise, carried, height, porosity, flux, k = np.loadtxt(f"{name}.dat", unpack=True)
    figure, axes = plt.subplots(3, 1, figsize=(6.5, 7.5), sharex=True)
    axes[0].plot(time, i)
    axes[0].set_ylabel("$i/i_c$")
    axes[1].plot(time, rise)
    axes[1].axhline(0.05, color="0.6", lw=0.8)
    axes[1].set_ylabel("mean rise / d")
    axes[1].set_yscale("symlog", linthresh=0.05)
    axes[2].plot(time, 1e3 * flux)
    axes[2].set_ylabel("flux (mm/s)")
    axes[2].set_xlabel("time (s)")
    figure.tight_layout()
    figure.savefig(f"{name}.png", dpi=110)


def snapshots():
    """the last run that made pictures: at rest, and in five moments up to the end (figure 12)"""
    names = sorted(glob.glob("*-snapshot-*.png"))
    run = names[-1].split("-snapshot-")[0]
    names = [name for name in names if name.startswith(run + "-snapshot-")]
    chosen = [names[round(k * (len(names) - 1) / 5)] for k in range(6)]
    figure, axes = plt.subplots(1, 6, figsize=(13, 5.0))
    for axis, name in zip(axes, chosen):
        axis.imshow(plt.imread(name))
        step = int(name.split("-")[-1].split(".")[0])
        axis.set_title(f"{1.2e-6 * step:.2f} s")
        axis.axis("off")
    figure.suptitle(f"{run}: grains by speed, blue 0, yellow 1, red 2 cm/s")
    figure.tight_layout(rect=(0, 0, 1, 0.95))
    figure.savefig("snapshots.png", dpi=110)


def onset():
    with open("onset.dat") as file:
        rows = [line.split() for line in file if not line.startswith("#")]
    figure, axis = plt.subplots(figsize=(6.5, 4.2))
    for kind, mark, label in (("bed", "o", "100 grains"), ("wide", "s", "400 grains"),
                              ("rate", "^", "shipped bed, ramp rate in 1/s")):
        mine = [row for row in rows if row[0].startswith(kind)]
        if not mine:
            continue
        x, y = [float(row[2]) for row in mine], [float(row[1]) for row in mine]
        axis.plot(x, y, mark, label=label)
        if kind == "rate":
            for row, a, b in zip(mine, x, y):
                axis.annotate(row[0].split("-")[1], (a, b), textcoords="offset points",
                              xytext=(-6, -3), ha="right")
    axis.axhline(1.0, color="0.6", lw=0.8)
    axis.axhline(0.92, color="0.6", lw=0.8, ls=":", label="article, one bed of unnamed porosity")
    axis.set_xlabel("porosity of the bed in steady seepage")
    axis.set_ylabel("onset $i/i_c$")
    axis.legend()
    figure.tight_layout()
    figure.savefig("onset.png", dpi=110)


if __name__ == "__main__":
    name = sys.argv[1] if len(sys.argv) > 1 else "quicksand"
    if name in ("quick", "full"):
        snapshots()
        onset()
        with open("figures.txt", "w") as file:
            print("snapshots.png onset.png", file=file)
    else:
        curve(name)
        for when in "before", "after":
            draw(name, when)
        page.page(name)
