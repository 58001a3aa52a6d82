#!/usr/bin/env python3
"""python3 check.py [quick|full]: predictions of lb/plan against what examples gave
python3 check.py [quick|full] times: what is to be predicted: ranks, scene, time simulated, options

Errors within a factor of 1.5, seconds within 30 %: exit status 1 if one is not. The scenes are those of
scenes.txt.
"""
import glob
import math
import re
import statistics
import sys


def loop(name):
    """steps and seconds of all runs of a log, the median of its repetitions, and the fluid step"""
    seconds = []
    for path in sorted(glob.glob(f"log.{name}.[0-9]")):
        with open(path) as file:
            log = file.read()
        runs = re.findall(r"^Loop time of (\S+) on \d+ procs for (\d+) steps", log, re.M)
        step = re.findall(r"fluid step = \d+ x timestep = ([^,]+),", log)[-1]
        seconds.append(sum(float(s) for s, _ in runs))
    return sum(int(n) for _, n in runs), statistics.median(seconds), float(step)


def rows(name):
    with open(name) as file:
        return [line.split() for line in file if not line.startswith("#")]


def main(size, times):
    scenes = ["2 bed bed", "1 array array", "1 array array-fine -var cells 32"]
    if size == "full":
        scenes.append("2 sphere sphere")
    if times:
        for words in scenes:
            ranks, name, run, *options = words.split()
            steps, _, dt = loop(run)
            print(ranks, name, steps * dt, *options)
        return
    found = [(row[0], float(row[1]), float(row[2])) for row in rows("predicted.dat")]
    predicted = [(*found[k][:2], statistics.median(row[2] for row in found[k::len(scenes)])) for k in range(len(scenes))]
    (K, spread), (fine, _) = ([float(x) for x in row[6:8]] for row in rows("array.dat")[:2])
    error = {"bed": abs(float(rows("bed.dat")[0][5]) / 7.186e-10 - 1.0),
             "array": math.hypot(K / fine - 1.0, K / fine * spread)}
    if size == "full":
        error["sphere"] = abs(max(-float(row[2]) for row in rows("sphere-E3-9.dat")) / 0.08728 - 1.0)
    bad = 0
    for words, (_, lattice, seconds) in zip(scenes, predicted):
        run = words.split()[2]
        if run in error:
            ratio = lattice / error[run]
            bad += not 1 / 1.5 <= ratio <= 1.5
            print(f"{run}: error {100 * error[run]:.3f} %, predicted {100 * lattice:.3f} %: {ratio:.2f} times")
        if run != "array":    # 1000 nodes: what is timed there is LAMMPS itself
            took = loop(run)[1]
            ratio = seconds / took
            bad += size == "full" and not 0.7 <= ratio <= 1.3
            print(f"{run}: {took:.3g} s, predicted {seconds:.3g} s: {ratio:.2f} times")
    sys.exit(bad > 0)


main(sys.argv[1] if len(sys.argv) > 1 else "quick", sys.argv[2:] == ["times"])
