#!/usr/bin/env python3
"""Permeability against solid fraction, and against tau: permeability.png"""
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

runs = np.loadtxt("permeability.dat", dtype=str)
phi, cells, tau, k = (runs[:, c].astype(float) for c in (0, 1, 4, 5))
rule = np.array([f"{a} {b}" for a, b in runs[:, 2:4]])
d = 0.5e-3
figure, axes = plt.subplots(1, 2, figsize=(10, 4.2))
x = np.linspace(0.35, 0.65, 50)
total = (10 * x / (1 - x) ** 2 + (1 - x) ** 2 * (1 + 1.5 * x ** 0.5)) / (1 - x)
axes[0].semilogy(x, d ** 2 * (1 - x) ** 3 / (180 * x ** 2), "k-", label="Carman-Kozeny")
axes[0].semilogy(x, d ** 2 / (18 * x * total), "k--", label="van der Hoef et al. 2005")
for n, mark in zip(np.unique(cells), "os^x"):
    take = (rule == "trt cli") & (tau == 1.0) & (cells == n)
    axes[0].semilogy(phi[take], k[take], mark, mfc="none", label=f"ours, {n:g} cells per diameter")
axes[0].set_xlabel("solid fraction")
axes[0].set_ylabel("permeability (m$^2$), d = 0.5 mm")
axes[0].legend(fontsize=8)
reference = k[(rule == "trt cli") & (tau == 1.0) & (cells == 10) & (phi == phi.max())][0]
for name in np.unique(rule):
    take = (rule == name) & (cells == 10) & (phi == phi.max())
    order = np.argsort(tau[take])
    axes[1].plot(tau[take][order], k[take][order] / reference, "o-", ms=4, label=name)
axes[1].set_xlabel(r"relaxation time $\tau$")
axes[1].set_ylabel(r"k / k(trt cli, $\tau$ = 1), 10 cells per diameter")
axes[1].legend(fontsize=8)
figure.tight_layout()
figure.savefig("permeability.png", dpi=110)
