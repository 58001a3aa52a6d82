#!/usr/bin/env python3
"""Pictures of the runs that figure.sh made: snapshots as in figures 13-15 of the article, the rise of
the bed, and profiles of porosity and local gradient. The article has no scales or numbers to draw
beside them but those of its text, which are marked."""
import os
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.collections import EllipseCollection
import tables

RUNS = [("i110", "13"), ("i100", "14"), ("low", "15"), ("i090", "")]
WIDTH, HEIGHT, FLOOR, LID, DELTA = 14.4, 17.28, 0.288, 16.992, 0.065    # mm, s
G_SUBMERGED = 1.6e4    # (rho_s - rho) g, N/m3


def ratio(name):
    return tables.series(name)[-1][2]


def draw_snapshots(name, figure_number):
    shots = tables.snapshots(name)
    first = {int(r[0]): r[2] for r in shots[0][1]}
    shots = shots[-8:]
    columns = 4
    rows = -(-len(shots) // columns)
    if len(shots) in (5, 6):
        columns, rows = 3, 2
    fig, axes = plt.subplots(rows, columns, figsize=(2.75 * columns, 3.6 * rows), squeeze=False)
    for axis in axes.flat:
        axis.axis("off")
    low, high = min(first.values()), max(first.values())
    dt = timestep(name)
    for axis, (step, grains) in zip(axes.flat, shots):
        g = np.array(grains)
        x, y, d = 1e3 * (g[:, 1] % (1e-3 * WIDTH)), 1e3 * g[:, 2], 2e3 * g[:, 3]
        # bands of the height at the start show how the bed deforms
        band = np.array([int(8 * (first[int(i)] - low) / (high - low + 1e-9)) for i in g[:, 0]])
        for shift in (-WIDTH, 0.0, WIDTH):
            axis.add_collection(EllipseCollection(
                d, d, np.zeros_like(d), units="xy", offsets=np.c_[x + shift, y],
                transOffset=axis.transData, facecolors=np.where(band % 2, "#8c6d31", "#e7cb94"),
                edgecolors="#4d3a10", linewidths=0.3))
        for height in FLOOR, LID:
            axis.axhline(height, color="0.3", lw=0.8)
        axis.set(xlim=(0, WIDTH), ylim=(0, HEIGHT), aspect="equal", xticks=[], yticks=[])
        axis.axis("on")
        axis.set_facecolor("#d6ebf5")
        axis.set_title(f"t = {step * dt:.3f} s = {step * dt / DELTA:.0f} $\\delta t$", fontsize=9)
    fig.suptitle(f"figure {figure_number}: i = {ratio(name):.3f} $i_c$, box {WIDTH} x {HEIGHT} mm; "
                 "bands mark the height at the start")
    fig.tight_layout()
    fig.savefig(f"figure{figure_number}.png", dpi=90)
    plt.close(fig)


def timestep(name):
    last = tables.series(name)[-1]
    before = tables.series(name)[-2]
    return (last[1] - before[1]) / (last[0] - before[0])


def draw_rise(runs):
    fig, axes = plt.subplots(1, 2, figsize=(10, 4))
    for name in runs:
        s = np.array(tables.series(name))
        axes[0].plot(s[:, 1], s[:, 3], label=f"{s[-1, 2]:.3f}")
        axes[1].plot(s[:, 1], s[:, 5], label=f"{s[-1, 2]:.3f}")
    axes[0].axhline(0.05, color="0.6", lw=0.8)
    axes[0].set(xlabel="time (s)", ylabel="mean rise / mean diameter")
    axes[0].set_yscale("symlog", linthresh=0.05)
    axes[0].legend(title="$i/i_c$")
    axes[1].set(xlabel="time (s)", ylabel="$\\Sigma F_y / \\Delta p S$", ylim=(0.9, 1.1))
    axes[1].axhline(1.00018, color="k", ls=":", lw=0.8, label="article, at 0.90: 1.00018")
    axes[1].legend(title="$i/i_c$")
    fig.tight_layout()
    fig.savefig("rise.png", dpi=110)
    plt.close(fig)


def draw_profiles(name):
    """porosity, pressure drop, local gradient and effective stress: at rest, and as the bed goes"""
    dt = timestep(name)
    s = tables.series(name)
    end = s[-1][1]
    times = [min(0.1, (tables.when(s, 3, 0.05) or 1.0) - 0.02)]
    for rise in 0.05, 0.2, 0.6, 1.5:    # mean diameters
        t = tables.when(s, 3, rise)
        if t and times[-1] + 0.02 < t < end - 0.02:
            times.append(t)
    fig, axes = plt.subplots(1, 4, figsize=(13, 5.2), sharey=True)
    colours = plt.cm.viridis(np.linspace(0, 0.9, len(times)))
    first = np.array(tables.mean_profile(name, times[0] - 0.02, times[0] + 0.02, dt))
    inside = first[:, 1] < 0.5
    critical = G_SUBMERGED * (1.0 - first[inside, 1].mean())
    for t, colour in zip(times, colours):
        p = np.array(tables.mean_profile(name, t - 0.01, t + 0.01, dt))
        y, bed = 1e3 * p[:, 0], p[:, 1] < 0.75
        style = {"marker": "o", "ms": 3, "color": colour}
        i, rise = (np.interp(t, [r[1] for r in s], [r[c] for r in s]) for c in (2, 3))
        axes[0].plot(p[:, 1], y, label=f"{t:.2f} s, i = {i:.2f}, rise {rise:.2f} d", **style)
        axes[1].plot(p[:, 3] / critical, y, **style)
        axes[2].plot(np.where(bed, p[:, 4], np.nan), y, **style)
        axes[3].plot(p[:, 7], y, **style)
    axes[0].set(xlabel="porosity", ylabel="height (mm)")
    axes[1].set(xlabel="$-dp/dy$ / critical at the start", xlim=(-0.2, 2))
    axes[2].set(xlabel="$i(y)/i_c(y)$, by the layer's own weight", xlim=(0, 2))
    axes[3].set(xlabel="effective stress (Pa)")
    for axis, x in ((axes[1], 1.0), (axes[2], 1.0), (axes[3], 0.0)):
        axis.axvline(x, color="0.6", lw=0.8)
    axes[0].legend(fontsize=7)
    fig.suptitle(f"{'slow rise to ' if name == 'low' else ''}i = {ratio(name):.3f} $i_c$, "
                 "means over 20 ms by layers of 0.576 mm")
    fig.tight_layout()
    fig.savefig(f"profile-{name}.png", dpi=100)
    plt.close(fig)


if __name__ == "__main__":
    there = [run for run in RUNS if os.path.exists(run[0] + ".dat")]
    for name, number in there:
        if number:
            draw_snapshots(name, number)
        draw_profiles(name)
    draw_rise([name for name, _ in there])
