#!/usr/bin/env python3
"""Drag against solid fraction, its error against resolution, and against tau: periodic_arrays.png"""
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

runs = np.atleast_2d(np.loadtxt("periodic_arrays.dat", dtype=str))
array, rules = runs[:, 0], np.array([f"{a} {b}" for a, b in runs[:, 3:5]])
phi, d, tau, K, spread = (runs[:, c].astype(float) for c in (1, 2, 5, 6, 7))
reference = np.loadtxt("reference.dat", dtype=str)
known = {(a, float(p)): float(k) for a, p, k in reference}
error = np.array([100 * (k / known[a, p] - 1) for a, p, k in zip(array, phi, K)])
main = (rules == "trt cli") & (tau == 2.0)

more = len(np.unique(d[main & (array == "sc") & (phi == 0.125)])) > 2
figure, axes = plt.subplots(1, 4 if more else 3, figsize=(17 if more else 13, 4))
sc = reference[:, 0] == "sc"
axes[0].semilogy(reference[sc, 1].astype(float), reference[sc, 2].astype(float), "k-", lw=1, label="Zick & Homsy, sc")
axes[0].semilogy(reference[~sc, 1].astype(float), reference[~sc, 2].astype(float), "kx", label="Hasimoto, bcc and fcc")
coarse = main & (d > 7.3) & (d < 8.1)
axes[0].semilogy(phi[coarse], K[coarse], "o", mfc="none", label="ours")
axes[0].set_xlabel("solid fraction")
axes[0].set_ylabel(r"$K = F / 6\pi\mu aU$")
axes[0].legend(fontsize=8)

take = main & (array == "sc")
for of, name in ((take & (d < 8.1) & ((d > 7.3)), "7.4 to 8 cells per diameter"), (take & (d > 14.8) & (d < 16.1), "15 to 16")):
    if not of.any():    # quick: coarse ones alone
        continue
    order = np.argsort(phi[of])
    axes[1].errorbar(phi[of][order], error[of][order], 100 * spread[of][order], marker="o", ms=4, capsize=2, label=name)
axes[1].axhline(0, color="0.6", lw=0.8)
axes[1].set_xlabel("solid fraction, simple cubic")
axes[1].set_ylabel("error of K (%), bars: spread over places")
axes[1].legend(fontsize=8)
eighth = take & (phi == 0.125)
if more:
    order = np.argsort(d[eighth])
    axes[3].errorbar(d[eighth][order], error[eighth][order], 100 * spread[eighth][order], marker="o", ms=4, capsize=2)
    axes[3].axhline(0, color="0.6", lw=0.8)
    axes[3].set_xlabel("cells per diameter")
    axes[3].set_ylabel("error of K (%), fraction 1/8")

for rule in np.unique(rules):
    take = (rules == rule) & (array == "sc") & (phi == 0.125) & (np.abs(d - 7.4) < 0.1)
    order = np.argsort(tau[take])
    axes[2].plot(tau[take][order], error[take][order], "o-", ms=4, label=rule)
axes[2].axhline(0, color="0.6", lw=0.8)
axes[2].set_xlabel(r"relaxation time $\tau$")
axes[2].set_ylabel("error of K (%), fraction 1/8, d = 7.4 cells")
axes[2].legend(fontsize=8)
figure.tight_layout()
figure.savefig("periodic_arrays.png", dpi=100)
