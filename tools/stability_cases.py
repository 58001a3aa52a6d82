"""The sweeps of ./run stability: what is run, and what must come out of it, computed here anew.

Each check gets the numbers of the run's line "result ...", its files, and what varied, and says what is wrong.
"Factor" is the most that a result may differ from its reference, either way, and count as right.
"""
import itertools
import math

from stability_rows import rows
from stability_run import Case

PI = math.pi


def outside(name, value, expected, factor):
    """within a factor of what is expected"""
    if value / expected > 0 and 1 / factor <= value / expected <= factor:
        return ""
    return f"{name} is {value:.4g}, expected {expected:.4g}, allowed a factor of {factor}"


def first(*wrong):
    return next((w for w in wrong if w), "")


def density(v, low, high):
    if low <= v["rho_min"] and v["rho_max"] <= high:
        return ""
    return f"density between {v['rho_min']:.4g} and {v['rho_max']:.4g}, allowed {low} to {high}"


def hasimoto(phi):
    """drag of a simple cubic array over Stokes's, J. Fluid Mech. 5, 317 (1959)"""
    return 1.0 / (1.0 - 1.7601 * phi**(1 / 3) + phi - 1.5593 * phi**2)


# ---- past a fixed sphere: tau x Ma x collision

def check_flow(v, _, run):
    U, r, nu = run["Ma"] / math.sqrt(3), 4.0, (run["tau"] - 0.5) / 3
    Re = 2 * U * r / nu
    schiller_naumann = 6 * PI * nu * r * U * (1 + 0.15 * Re**0.687)
    crowding = hasimoto(4 / 3 * PI * r**3 / 20**3)
    excess = 1.5 * run["Ma"] + 36 * nu * U    # waves of the start; what drives the water through at high viscosity
    return first(outside("flux", v["flux"], U, 1.1), outside("drag", v["drag"], schiller_naumann * crowding, 2.5),
                 density(v, 1 - excess, 1 + excess))


def flow(quick):
    taus = [0.5005, 0.505, 0.51, 0.52, 0.55, 0.6, 0.8, 1.0, 2.0, 5.0]
    speeds = [0.01, 0.03, 0.1, 0.2, 0.29, 0.4]
    if quick:
        taus, speeds = [0.5005, 0.55, 1.0], [0.03, 0.2, 0.4]
    return [Case("flow", "in.sphere", {"tau": tau, "Ma": Ma, "collision": collision}, check_flow)
            for collision, Ma, tau in itertools.product(["trt"] if quick else ["bgk", "trt"], speeds, taus)]


# ---- impacts: every (and with it k_n) x steps per contact x fluid

def impact(text, r):
    """restitution, contact time in steps and largest overlap, from step, distance and relative speed"""
    lines = [[float(w) for w in line.split()] for line in text.splitlines() if line and line[0] != "#"]
    inside = list(itertools.takewhile(lambda line: line[1] < 2 * r, lines[1:]))
    if len(inside) < 2 or len(inside) == len(lines) - 1:
        return None
    return lines[1 + len(inside)][2], len(inside), 2 * r - min(line[1] for line in inside)


def check_contact(v, files, run):
    r, speed = 3.975, 0.04
    e, n, every = run.get("e", 0.9), run["contact"], run["every"]
    dry = run["rho"] < 0.1
    found = impact(files.get("impact.dat", ""), r)
    if found is None:    # water may bring them to rest in a contact that lasts many fluid steps
        return "the grains do not part after one contact" if dry or n / every < 10 else ""
    restitution, steps, overlap = found[0] / speed, found[1], found[2]
    # linear spring and dashpot: overlap at the first rest, v/w exp(-beta/w' atan(w'/beta))
    decay = -math.log(e)
    w = math.sqrt(PI**2 + decay**2) / (n / every)
    deepest = speed / w * math.exp(-decay / PI * math.atan2(PI, decay))
    M = 2.5 * 4 / 3 * PI * r**3
    wrong = first(
        f"momentum {v['p']:.3g} of {0.02 * M:.3g}" if abs(v["p"]) > 1e-6 * 0.02 else "",
        f"restitution {restitution:.4f}" if abs(restitution - e) > 0.3 * e / n + 0.005 and dry else "",
        f"restitution {restitution:.4f} in water, {e} without" if restitution > e + 0.3 * e / n + 0.005 else "",
        f"contact of {steps} steps" if dry and abs(steps - n) > 1.5 + 0.05 * n or steps > 2 * n else "",
        outside("overlap", overlap, deepest, 1.05 + 1 / n) if dry or overlap > deepest else "")
    # with that of the spring, pressed on either side
    pressed = lambda d: max(2 * r - d, d - (16 - 2 * r), 0)
    before, after = (v[ke] + 0.5 * v["k"] * pressed(v[d])**2 for ke, d in (("ke_before", "start"), ("ke", "distance")))
    if wrong or not dry:
        return wrong or ("energy grows" if after > before + 0.01 * M * 0.02**2 else "")    # some comes back
    # impact after impact: a whole number of them; without loss none
    if e == 1.0:
        drift = after / before - 1
        # energy of the Verlet scheme oscillates within a contact by (w dt)^2/4, and is kept after it
        return f"energy drifts by {drift:.2g}" if abs(drift) > max(1e-3, 0.25 * (PI / n)**2) else ""
    impacts = math.log(after / before) / (2 * math.log(e))
    return f"energy of {impacts:.3f} impacts" if every >= 100 and impacts < 0.9 else ""


def contact(quick):
    everies = [1, 100, 10000] if quick else [1, 10, 100, 1000, 10000]
    coarse = [8, 50] if quick else [8, 10, 20, 50, 200]
    return [Case("contact", "in.contact", {"every": every, "contact": n, "rho": rho, "e": e}, check_contact)
            for rho, e, n, every in itertools.product([1e-6, 1.0], [0.9, 1.0], coarse, everies)
            if not (quick and (e == 1.0) == (rho == 1.0)) and not (rho == 1.0 and e == 1.0)]


# ---- a free grain: density x radius

def check_free(v, files, run):
    r, ratio, nu, U = run["r"], run["ratio"], 0.1, 0.01
    V, L = 4 / 3 * PI * r**3, math.ceil(4 * r - 1e-9)
    phi = V / L**3
    F = 6 * PI * nu * r * hasimoto(phi) * U * (1 - phi)
    # at rest as a whole: the water moves against the grain; both masses have to be set in motion
    m, rest = (ratio + 0.5) * V, L**3 - V
    time = U / F / (1 / m + 1 / rest)
    history = [[float(w) for w in line.split()] for line in files["free.dat"].splitlines() if line[0] != "#"]
    expected = U / (1 - phi + ratio * phi) * (1 - math.exp(-history[-1][0] / time))
    late = [v for _, v in history[-max(20, len(history) // 10):]]
    mean = -sum(late) / len(late)    # downwards
    ringing = math.sqrt(sum((a - 2 * b + c)**2 for a, b, c in zip(late, late[1:], late[2:])) / len(late)) / 4
    return first(outside("speed", mean, expected, 1.3),
                 f"speed rings by {ringing / abs(mean):.2g} of itself" if ringing > 0.05 * abs(mean) else "")


def free(quick):
    ratios = [0.01, 1.001, 100] if quick else [0.01, 0.03, 0.1, 0.2, 0.4, 0.7, 0.999, 1.001, 2, 10, 100]
    radii = [2.0, 5.0] if quick else [2.0, 2.5, 3.3, 5.0, 7.0, 10.0]
    steps = lambda r: 600 if quick else 2000 if r < 6 else 1200 if r < 9 else 800
    return [Case("free", "in.free", {"ratio": ratio, "r": r, "coupling": coupling, "limit": steps(r)}, check_free)
            for coupling, r, ratio in itertools.product(["auto", "explicit"], radii, ratios)
            if coupling == "auto" or r < 6]


# ---- many free grains: density x tau x coupling

def check_crowd(v, _, run):
    r, U, nu, spacing = 2.7, v["U"], (run["tau"] - 0.5) / 3, 8
    V = 4 / 3 * PI * r**3
    # nearly a cubic array, which is denser than any that moves: found from 0.18 to 0.21 of the speed of one alone
    final = 0.21 * U
    m, rest = (run["ratio"] + 0.5) * V, spacing**3 - V
    time = final / (4.5 * nu * U / r**2 * V) / (1 / m + 1 / rest)
    expected = final * (1 - math.exp(-run["steps"] / time))
    ringing = v["Ma"] / math.sqrt(3) / U
    return first(outside("speed", v["slip"], expected, 1.6),
                 f"the water moves at {ringing:.2g} of the speed of one grain alone" if ringing > 0.6 else "")


def crowd(quick):
    ratios = [0.01, 0.5, 2.6] if quick else [0.01, 0.03, 0.1, 0.3, 0.5, 0.8, 0.95, 1.3, 2.6, 10, 100]
    taus = [0.55, 0.8] if quick else [0.505, 0.51, 0.55, 0.6, 0.8, 1.0, 1.5, 3.0]
    couplings = ["auto"] if quick else ["auto", "explicit"]
    return [Case("crowd", "in.crowd", {"ratio": ratio, "tau": tau, "coupling": coupling, "average": average,
                                       "steps": 500 if quick else 1500}, check_crowd)
            for coupling, average, tau, ratio in itertools.product(couplings, ["yes", "no"], taus, ratios)]


# ---- many free discs: density x tau x coupling and radius

def check_crowd2d(v, _, run):
    r, U, spacing, nu = run["r"], v["U"], round(8 * run["r"] / 2.7), (run["tau"] - 0.5) / 3
    A = PI * r * r
    lighter = 1 / (1 / ((run["ratio"] + 1) * A) + 1 / (spacing**2 - A))    # of disc, with added mass, and water
    expected = U * (1 - math.exp(-run["steps"] * v["drag"] * nu / lighter))
    return first(outside("speed", v["slip"], expected, 1.7),
                 f"discs move to and fro at {v['rms'] / U:.2g} times the speed of the array" if v["rms"] > 5 * U else "")


def crowd2d(quick):
    ratios = [0.1, 2.6] if quick else [0.01, 0.03, 0.1, 0.3, 0.5, 0.95, 1.3, 2.6, 5, 10, 100]
    taus = [0.52, 0.8] if quick else [0.505, 0.51, 0.52, 0.53, 0.55, 0.8, 1.5, 3.0]
    sets = [("auto", 2.7)] if quick else [("auto", 2.7), ("auto", 3.5), ("auto", 4.0), ("explicit", 3.5)]
    return [Case("crowd2d", "in.crowd2d", {"ratio": ratio, "tau": tau, "coupling": coupling, "r": r, "steps": 3000},
                 check_crowd2d)
            for (coupling, r), tau, ratio in itertools.product(sets, taus, ratios)]


# ---- pressure steps: size x tau x sudden or slow

def check_column(v, _, run):
    a, spheres, nu, excess = 4.0, 4, (run["tau"] - 0.5) / 3, run["excess"]
    force = excess / 3 * 64
    U = force / (spheres * 42.1 * 6 * PI * nu * a)    # Zick & Homsy 1982
    return first(outside("flux", v["flux"], U, 1.6), outside("force", v["force"], force, 1.1),
                 density(v, 1 - 0.1 * excess - v["Ma"]**2, 1 + 1.1 * excess))


def column(quick):
    taus = [0.55, 1.0] if quick else [0.52, 0.55, 0.6, 0.8, 1.0, 2.0]
    sizes = [0.05, 0.19, 0.21] if quick else [0.01, 0.05, 0.1, 0.15, 0.19, 0.21, 0.3]
    return [Case("column", "in.column", {"excess": excess, "tau": tau, "ramp": ramp}, check_column)
            for ramp, excess, tau in itertools.product([0, 415], sizes, taus)]


# ---- two spheres: gap x mode

def check_pair(v, _, run):
    r, nu, u, mode, gap = 4.0, 1 / 6, 0.002, run["mode"], run["gap"]
    stokes = 6 * PI * nu * r * u
    bounds = density(v, 0.9, 1.1)
    if mode == "rest":    # 3 % of rho c_s^2 on an area of pi r^2
        most = max(abs(v[name]) for name in ("fx1", "fx2", "fz1", "fz2"))
        return first(bounds, f"force {most:.2g} in fluid at rest" if most > 1e-3 * 0.01 * PI * r * r else "")
    if mode == "flow":    # what drives the fluid is carried by the spheres
        driven = 1e-6 * v["nodes"]
        return first(bounds, outside("force along x", v["fx1"] + v["fx2"], driven, 1.02),
                     outside("force along z", v["fz1"] + v["fz2"], driven, 1.02))
    if mode == "shear":   # each is held back, and both alike
        return first(bounds, outside("force", -v["fz1"], v["fz2"], 1.2) if gap > -r else "",
                     outside("force over Stokes's", v["fz2"], stokes, 6) if gap > -r else "")
    return first(bounds, outside("force", -v["fx1"], v["fx2"], 1.2) if gap > -r else "",
                 "spheres that approach attract each other" if gap >= 0 and v["fx2"] < 0.5 * stokes else "")


def pair(quick):
    gaps = [2, 1.5, 1, 0.7, 0.5, 0.3, 0.1, 0.01, 1e-6, 0, -1e-6, -0.01, -0.1, -0.5, -1, -2, -4]
    if quick:
        gaps = [1, 1e-6, -0.5]
    return [Case("pair", "in.pair", {"mode": mode, "gap": gap}, check_pair)
            for mode, gap in itertools.product(["rest", "flow", "shear", "approach"], gaps)]


# ---- fixed beds: solid fraction x resolution

def check_dense(v, _, run):
    phi, r, nu = run["phi"], v["r"], 1 / 6
    drive = v["accel"] * run["cells"]**3
    # drag over Stokes's: Carman-Kozeny, and where that is too open, the dilute array
    K = max(10 * phi / (1 - phi)**3, 1 / (1 - 1.79 * phi**(1 / 3) + phi) if phi < 0.2 else 0)
    U = drive / (4 * 6 * PI * nu * r * K)
    return first(density(v, 0.99, 1.01), outside("force", v["force"], v["accel"] * v["nodes"], 1.01),
                 outside("flux", v["flux"], U, 2.0))


def dense(quick):
    fractions = [0.3, 0.7] if quick else [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.65, 0.7, 0.74]
    cells = [8, 14] if quick else [8, 10, 12, 14, 20]
    return [Case("dense", "in.dense", {"phi": phi, "cells": n}, check_dense)
            for n, phi in itertools.product(cells, fractions)]


# ---- polydisperse suspensions

def check_mixed(v, _, run):
    # all momentum there was, added up by size: sum m |v| <= sqrt(2 ke M)
    M = 2.5 * 4 / 3 * PI * 2.2**3 * run["small"]
    p = math.sqrt(2 * v["ke0"] * M)
    return first(density(v, 0.95, 1.05), "energy grows" if v["ke"] > v["ke0"] else "",
                 f"momentum {v['p'] - v['p0']:.3g} from nowhere, grains had {p:.3g}"
                 if abs(v["p"] - v["p0"]) > 0.05 * p else "")


def mixed(quick):
    sizes = [10] if quick else [1, 2, 5, 10]
    return [Case("mixed", "in.mixed", {"size": size, "every": every, "small": small,
                                       "steps": 20 if quick else 100}, check_mixed)
            for size, (every, small) in itertools.product(sizes, [(20, 60)] if quick else [(20, 60), (1000, 20)])]


GROUPS = {"rows": rows, "flow": flow, "contact": contact, "free": free, "crowd": crowd, "crowd2d": crowd2d, "column": column, "pair": pair,
          "dense": dense, "mixed": mixed}
