#!/usr/bin/env python3
"""Flux through the plug and force on it, made of a region and of grains: porous_plug.png"""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

rows = [line.split() for line in open("porous_plug.dat") if not line.startswith("sand")]
figure, axes = plt.subplots(1, 2, figsize=(9, 3.6))
names = [f"{r[0]}\nconserve\n{r[1]}" for r in rows]
for axis, column, what in zip(axes, (2, 3), ("flux (m/s)", "force (N)")):
    axis.bar(names, [float(r[column]) for r in rows], color=["C0" if r[0] == "region" else "C1" for r in rows])
    axis.set_ylabel(what)
figure.tight_layout()
figure.savefig("porous_plug.png", dpi=100)
