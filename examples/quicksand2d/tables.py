"""Reads what in.quicksand2d writes: time series, profiles, grains. Standard library only."""
import os
import re


def log_line(name, pattern):
    """groups of the last line of a log that matches, or None"""
    found = None
    if os.path.exists(name):
        with open(name) as file:
            for line in file:
                found = re.match(pattern, line) or found
    return found.groups() if found else None


def series(name):
    """rows of NAME.dat: step, time, i/ic, rise/d, path/d, sumF/(dp S), height (mm), porosity, flux, k,
    top (mm)"""
    with open(name + ".dat") as file:
        return [[float(x) for x in line.split()] for line in file if line[0] != "#"]


def when(rows, column, value):
    """time at which a column first reaches a value, on the line between two rows; None if never"""
    for a, b in zip(rows, rows[1:]):
        if a[column] < value <= b[column]:
            return a[1] + (b[1] - a[1]) * (value - a[column]) / (b[column] - a[column])
    return None


def profiles(name):
    """list of (step, rows); a row: y, porosity, pressure, gradient, i/ic, flux, k, stress"""
    all = []
    with open(name + ".profile") as file:
        for line in file:
            if line[0] == "#":
                continue
            words = line.split()
            if len(words) == 2:
                all.append((int(words[0]), []))
            else:
                all[-1][1].append([float(x) for x in words[1:]])
    return all


def snapshots(name):
    """list of (step, rows); a row: id, x, y, radius, rise"""
    all = []
    with open(name + ".grains") as file:
        lines = file.read().splitlines()
    at = 0
    while at < len(lines):
        step, count = int(lines[at + 1]), int(lines[at + 3])
        rows = [[float(x) for x in line.split()] for line in lines[at + 9:at + 9 + count]]
        all.append((step, rows))
        at += 9 + count
    return all


def mean_profile(name, first, last, dt):
    """mean over the profiles between two times (s)"""
    chosen = [rows for step, rows in profiles(name) if first < step * dt <= last * (1 + 1e-9)]
    return [[sum(rows[k][c] for rows in chosen) / len(chosen) for c in range(8)]
            for k in range(len(chosen[0]))]
