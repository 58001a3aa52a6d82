#!/usr/bin/env python3
"""Permeability of the beds of ensemble.dat beside Carman-Kozeny: ensemble.png"""
import numpy as np
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

seed, solid, k, carman = np.loadtxt("ensemble.dat", unpack=True)
figure, axis = plt.subplots(figsize=(6, 3.6))
axis.plot(seed, k, "o", mfc="none", label="beds")
mean, error = k.mean(), k.std(ddof=1) / np.sqrt(len(k))
axis.axhspan(mean - error, mean + error, color="0.85", label="mean and its standard error")
axis.axhline(carman.mean(), color="k", lw=0.8, label="Carman-Kozeny")
axis.set_xlabel("seed")
axis.xaxis.get_major_locator().set_params(integer=True)
axis.set_ylabel("permeability (m$^2$)")
axis.set_ylim(0, 1.3 * k.max())
axis.legend()
figure.tight_layout()
figure.savefig("ensemble.png", dpi=110)
